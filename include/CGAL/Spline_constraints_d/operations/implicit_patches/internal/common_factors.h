// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_COMMON_FACTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_COMMON_FACTORS_H

#include <CGAL/Spline_constraints_d/function/internal/simplex/edge_zeros.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/Face_signs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

// Whether it is certain that two functions have no common factor: if f keeps its degree on a line, its factors do, too,
// and a common one would be common to the restrictions.
inline bool have_no_common_factor(const Form& f, const Form& g)
{
  const auto point = [](int a, int b, int c) {
    return Form::Barycentric{Exact_rational(a), Exact_rational(b), Exact_rational(c), Exact_rational(1 - a - b - c)};
  };
  const std::array<Form::Barycentric, 2> line{point(2, -1, 3), point(-3, 5, 1)};
  auto first = power_coefficients(f.restricted(line).coefficients());
  auto second = power_coefficients(g.restricted(line).coefficients());
  if (first.size() != static_cast<std::size_t>(f.degree()) + 1)
    return false;
  while (second.size() > 1) {
    first = remainder(std::move(first), second);
    std::swap(first, second);
  }
  return !second.empty();
}

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_COMMON_FACTORS_H
