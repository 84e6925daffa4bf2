// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_QUADRATIC_FORMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_QUADRATIC_FORMS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

using Exact_vector = std::vector<Exact_rational>;
using Exact_matrix = std::vector<Exact_vector>;

// A vector x with x^T A x < 0; none exactly if the symmetric matrix A is positive semidefinite. By elimination: x^T A x
// is a (x_0 + m^T y / a)^2 + y^T S y with the first entry a, the rest m of its row, and S = A' - m m^T / a.
inline std::optional<Exact_vector> negative_direction(const Exact_matrix& A)
{
  const std::size_t n = A.size();
  if (n == 0)
    return std::nullopt;
  const Exact_rational& a = A[0][0];
  if (CGAL::sign(a) == CGAL::NEGATIVE) {
    Exact_vector result(n, Exact_rational(0));
    result[0] = Exact_rational(1);
    return result;
  }
  const bool is_zero = CGAL::is_zero(a);
  Exact_matrix rest;
  for (std::size_t i = 1; i < n; ++i) {
    if (is_zero && !CGAL::is_zero(A[0][i])) { // 2 t A_0i + A_ii = -1
      Exact_vector result(n, Exact_rational(0));
      result[0] = Exact_rational(Exact_rational(-1) - A[i][i]) / Exact_rational(2 * A[0][i]);
      result[i] = Exact_rational(1);
      return result;
    }
    Exact_vector& row = rest.emplace_back(A[i].begin() + 1, A[i].end());
    for (std::size_t j = 1; j < n && !is_zero; ++j)
      row[j - 1] -= Exact_rational(A[0][i] * A[0][j]) / a;
  }
  const std::optional<Exact_vector> y = negative_direction(rest);
  if (!y)
    return std::nullopt;
  Exact_vector result{Exact_rational(0)};
  for (std::size_t i = 1; i < n; ++i) {
    if (!is_zero)
      result[0] -= Exact_rational(A[0][i] * (*y)[i - 1]) / a;
    result.push_back((*y)[i - 1]);
  }
  return result;
}

inline Exact_matrix negated(Exact_matrix A)
{
  for (Exact_vector& row : A)
    for (Exact_rational& x : row)
      x = -x;
  return A;
}

// Of a matrix of three rows, by its leading minors.
inline Exact_rational determinant_of_three(const Exact_matrix& A)
{
  const auto minor = [&](std::size_t i, std::size_t j) {
    return Exact_rational(A[1][i] * A[2][j] - A[1][j] * A[2][i]);
  };
  return Exact_rational(A[0][0] * minor(1, 2) - A[0][1] * minor(0, 2) + A[0][2] * minor(0, 1));
}

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_QUADRATIC_FORMS_H
