// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_CONE_POINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_CONE_POINT_H

#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_polynomials.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Interval_polynomial.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A singular point p of a surface f = 0 in space, and a function that grows with the distance from it: phi is the sum of
u_j^k_j, where u = L (x - p) and the exponents are even. In the region p is the only point of the surface at which the
gradients of f and phi are linearly dependent: so no other point is singular, and phi has no critical point on the
surface but p.
*/
struct Cone_point
{
  Exact_ranges point;               // that p lies in
  Exact_point middle;               // a point that differences are taken from
  Interval_polynomial equation;     // f, in these
  std::array<Interval_box, 3> rows; // L
  std::array<int, 3> exponents;
  Exact_ranges region;

  bool is_quadratic() const { return exponents == std::array<int, 3>{2, 2, 2}; }

  Interval_box difference(const Exact_ranges& box) const
  {
    Interval_box result;
    for (std::size_t j = 0; j < 3; ++j)
      result[j] = Interval(to_double_interval(Exact_rational(box[j].first - middle[j])).first,
                           to_double_interval(Exact_rational(box[j].second - middle[j])).second);
    return result;
  }

  // The gradient of phi.
  Interval_box slope(const Interval_box& difference_from_middle) const
  {
    const Interval_box own = difference(point);
    Interval_box result{Interval(0), Interval(0), Interval(0)};
    for (std::size_t j = 0; j < 3; ++j) {
      Interval u(0);
      for (std::size_t i = 0; i < 3; ++i)
        u += rows[j][i] * (difference_from_middle[i] - own[i]);
      Interval factor = Interval(exponents[j]) * u;
      for (int e = 2; e < exponents[j]; e += 2)
        factor *= CGAL::square(u);
      for (std::size_t i = 0; i < 3; ++i)
        result[i] += rows[j][i] * factor;
    }
    return result;
  }
};

// A box around a point.
inline Exact_ranges box_around(const Exact_point& point, const Exact_point& distances)
{
  Exact_ranges result;
  for (std::size_t j = 0; j < point.size(); ++j)
    result.emplace_back(point[j] - distances[j], point[j] + distances[j]);
  return result;
}

// For exact elimination: zero only for zero.
inline double size_of_pivot(const Exact_rational& x)
{
  return CGAL::is_zero(x) ? 0 : (std::max)(std::abs(CGAL::to_double(x)), 1e-300);
}

// The inverse of a matrix by rows; zero if there is none.
inline std::array<Exact_point, 3> inverse_of(const std::array<Exact_point, 3>& rows)
{
  std::vector<Exact_rational> matrix; // (rows | I)
  for (std::size_t i = 0; i < 3; ++i) {
    matrix.insert(matrix.end(), rows[i].begin(), rows[i].end());
    for (std::size_t k = 0; k < 3; ++k)
      matrix.emplace_back(k == i ? 1 : 0);
  }
  const std::vector<int> row_of = gauss_jordan(matrix, 6, 3, 3, size_of_pivot);
  std::array<Exact_point, 3> result;
  for (std::size_t j = 0; j < 3; ++j)
    if (row_of.empty())
      result[j].assign(3, Exact_rational(0));
    else
      result[j].assign(matrix.begin() + 6 * row_of[j] + 3, matrix.begin() + 6 * row_of[j] + 6);
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_CONE_POINT_H
