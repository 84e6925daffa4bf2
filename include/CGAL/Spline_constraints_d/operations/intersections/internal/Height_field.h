// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_HEIGHT_FIELD_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_HEIGHT_FIELD_H

#include <CGAL/Spline_constraints_d/geometry/internal/spline_axes.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// factor * (one of several unknowns) + offset, where the factor is not zero.
struct Affine_function
{
  std::size_t unknown;
  Exact_rational factor, offset;
  double rounded_factor = CGAL::to_double(factor), rounded_offset = CGAL::to_double(offset);

  Exact_rational of(const Exact_rational& x) const { return Exact_rational(factor * x + offset); }
  Parameter_range of(const Parameter_range& range) const { return std::minmax(of(range.first), of(range.second)); }
  Exact_rational operator()(std::span<const Exact_rational> x) const { return of(x[unknown]); }
  double operator()(std::span<const double> x) const { return rounded_factor * x[unknown] + rounded_offset; }
};

// Whether a function is the one that is affine along an axis, with a slope and the value where that begins: its control
// points are those values at the means of as many knots as the degree says.
bool has_control_points_of(const Exact_function& f, int axis, const Exact_rational& slope, const Exact_rational& value);

// A coordinate of a surface as an affine function of one parameter, if it is that.
std::optional<Affine_function> as_affine_function(const Exact_function& coordinate);

// Two surfaces over the same two coordinates, both in the parameters of the first one, where they are both over the
// same rectangle.
struct Height_difference
{
  Exact_function difference;
  Parameter_box domain;
  std::array<std::array<Affine_function, 2>, 2> parameters; // of both surfaces

  std::vector<Constraint> equations(std::span<const Unknown> u) const;
};

/*
Of two height fields over the coordinates i and j, if they are that: x_i of each is an affine function of one parameter,
x_j of the other parameter. Then the parameters of the second one are affine functions of those of the first one each,
and the difference of the third coordinates is a function of these. None if their rectangles have no interior in common.
*/
std::optional<Height_difference> height_difference(const Spline_patch<3>& a, const Spline_patch<3>& b, int i, int j);

// Over any two coordinates.
std::optional<Height_difference> height_difference(const Spline_patch<3>& a, const Spline_patch<3>& b);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE bool has_control_points_of(const Exact_function& f, int axis,
                                                          const Exact_rational& slope, const Exact_rational& value)
{
  if (f.degree(axis) == 0)
    return false;
  const std::size_t size = f.size(axis), inner = axis == 0 ? f.size(1) : 1;
  std::vector<Exact_rational> expected;
  for (std::size_t k = 0; k < size; ++k) {
    Exact_rational sum(0);
    for (int i = 1; i <= f.degree(axis); ++i)
      sum += f.knots(axis)[k + static_cast<std::size_t>(i)];
    expected.emplace_back(value + slope * (sum / f.degree(axis) - f.domain(axis).first));
  }
  for (std::size_t k = 0; k < f.coefficients().size(); ++k)
    if (f.coefficients()[k] != expected[k / inner % size])
      return false;
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Affine_function> as_affine_function(const Exact_function& coordinate)
{
  const auto [u0, u1] = coordinate.domain(0);
  const auto [v0, v1] = coordinate.domain(1);
  const auto value = [&](const Exact_rational& u, const Exact_rational& v) { return coordinate(std::array{u, v}); };
  const std::vector<Exact_rational> corners{value(u0, v0), value(u0, v1), value(u1, v0), value(u1, v1)};
  const bool is_along_u = corners[0] == corners[1], is_along_v = corners[0] == corners[2];
  if (is_along_u == is_along_v)
    return std::nullopt;
  const Exact_rational slope(is_along_u ? (corners[2] - corners[0]) / (u1 - u0)
                                        : (corners[1] - corners[0]) / (v1 - v0));
  if (!has_control_points_of(coordinate, is_along_u ? 0 : 1, slope, corners[0]))
    return std::nullopt;
  return Affine_function{is_along_u ? 0u : 1u, slope, Exact_rational(corners[0] - slope * (is_along_u ? u0 : v0))};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Constraint> Height_difference::equations(std::span<const Unknown> u) const
{
  const Exact_function zero({0, 0}, {{domain[0].first, domain[0].second}, {domain[1].first, domain[1].second}},
                            {Exact_rational(0)});
  return {Parametric_vector<3>(Vector_of_functions<3>{difference, zero, zero})(u)[0] == 0};
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Height_difference>
height_difference(const Spline_patch<3>& a, const Spline_patch<3>& b, int i, int j)
{
  std::array<std::array<Affine_function, 2>, 2> of_parameters; // per surface, per coordinate i and j
  for (std::size_t surface = 0; surface < 2; ++surface) {
    const Spline_patch<3>& patch = surface == 0 ? a : b;
    const std::optional<Affine_function> x = as_affine_function(patch.numerators()[i]),
                                         y = as_affine_function(patch.numerators()[j]);
    if (!x || !y || x->unknown == y->unknown)
      return std::nullopt;
    of_parameters[surface] = {*x, *y};
  }
  Exact_function height = b.numerators()[3 - i - j];
  if (of_parameters[0][0].unknown != of_parameters[1][0].unknown)
    height = transposed(height);
  Height_difference result{a.numerators()[3 - i - j], Parameter_box(2), {}};
  result.parameters[0] = {Affine_function{0, 1, 0}, Affine_function{1, 1, 0}};
  for (std::size_t k = 0; k < 2; ++k) {
    // equal: the parameter of b is a function of that of a, and the other way round
    const Affine_function &x = of_parameters[0][k], &y = of_parameters[1][k];
    const Affine_function of_first{x.unknown, Exact_rational(x.factor / y.factor),
                                   Exact_rational((x.offset - y.offset) / y.factor)};
    const Affine_function of_second{y.unknown, Exact_rational(1 / of_first.factor),
                                    Exact_rational(-of_first.offset / of_first.factor)};
    const int axis = static_cast<int>(x.unknown);
    const Parameter_range own = a.domain(axis), other = of_second.of(b.domain(static_cast<int>(y.unknown)));
    result.parameters[1][y.unknown] = of_first;
    result.domain[x.unknown] = {(std::max)(own.first, other.first), (std::min)(own.second, other.second)};
    if (!(result.domain[x.unknown].first < result.domain[x.unknown].second))
      return std::nullopt;
    height =
        internal::with_domain(of_first.factor < 0 ? reversed(height, axis) : height, axis, other.first, other.second);
  }
  for (int axis = 0; axis < 2; ++axis) {
    height = part_of(height, axis, result.domain[axis]);
    result.difference = part_of(result.difference, axis, result.domain[axis]);
  }
  result.difference = result.difference - height;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Height_difference> height_difference(const Spline_patch<3>& a,
                                                                                  const Spline_patch<3>& b)
{
  for (const auto& [i, j] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
    if (!a.is_rational() && !b.is_rational())
      if (auto result = height_difference(a, b, i, j))
        return result;
  return std::nullopt;
}
#endif

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_HEIGHT_FIELD_H
