// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_EXACT_MAP_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_EXACT_MAP_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// A point, curve or surface: a rational map x/w of none, one or two parameters, in exact numbers. Operations take
// operands of all kernels as such ones.
template <int d>
struct Exact_map
{
  std::array<Bspline_function<Exact_rational>, d> numerators;
  Bspline_function<Exact_rational> weight; // the constant one, unless the map is rational
  bool is_rational;
};

template <int d, class Map>
Exact_map<d> exact_map(const Map& map)
{
  return {map.homogeneous_coordinates(), map.weight(), map.is_rational()};
}

// That of a point.
template <int d>
Exact_map<d> exact_map(const std::array<Exact_rational, d>& point)
{
  const auto constant = [](const Exact_rational& value) { return Bspline_function<Exact_rational>() + value; };
  Exact_map<d> result{{}, constant(Exact_rational(1)), false};
  for (int i = 0; i < d; ++i)
    result.numerators[i] = constant(point[i]);
  return result;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_EXACT_MAP_H
