// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_COMMON_FACTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_COMMON_FACTORS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_simplex.h>
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

using Edge_form = Bernstein_simplex<Exact_rational, 1>;

// A line in no special place.
inline std::array<Form::Barycentric, 2> some_line()
{
  const auto point = [](int a, int b, int c) {
    return Form::Barycentric{Exact_rational(a), Exact_rational(b), Exact_rational(c), Exact_rational(1 - a - b - c)};
  };
  return {point(2, -1, 3), point(-3, 5, 1)};
}

// Whether it is certain that two functions have no common factor, from their restrictions to a line: if the first one
// keeps its degree there, its factors do, too, and a common one would be common to the restrictions.
inline bool have_no_common_factor(const Edge_form& f, const Edge_form& g)
{
  auto first = power_coefficients(f.coefficients()), second = power_coefficients(g.coefficients());
  if (first.size() != f.coefficients().size())
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
