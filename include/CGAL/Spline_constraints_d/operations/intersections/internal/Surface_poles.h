// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_POLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_POLES_H

#include <CGAL/Spline_constraints_d/geometry/internal/Exact_vector.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// An edge of one of two surfaces that is one point in space.
struct Surface_pole
{
  std::size_t surface;    // its index
  int axis, side;         // the parameter that is constant, and the end of its range
  std::size_t unknown;    // that this parameter is
  Exact_rational value;
};

inline bool are_orthogonal(const Exact_vector<3>& a, const Exact_vector<3>& b) { return exact_dot(a, b) == 0; }

// The derivatives across an edge (axis, side), times a positive function.
Vector_of_functions<3> tangents_across(const Spline_patch<3>& surface, int axis, int side);

// Two vectors that span what the derivatives across a pole span, if that is a plane.
std::optional<std::array<Exact_vector<3>, 2>> tangents_at_pole(const Spline_patch<3>& surface, int axis, int side);

// Bounds of the derivatives across a pole, at the parameters in a range along it.
Vector_bounds<3> directions_at_pole(const Spline_patch<3>& surface, int axis, int side, const Parameter_range& range);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Vector_of_functions<3> tangents_across(const Spline_patch<3>& surface, int axis,
                                                                      int side)
{
  const std::vector<Exact_rational> breaks = surface.breaks(axis);
  return surface.one_sided_tangent(axis,
                                   side == 0 ? Parameter_range(breaks[0], breaks[1])
                                             : Parameter_range(breaks[breaks.size() - 2], breaks.back()),
                                   side);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<std::array<Exact_vector<3>, 2>>
tangents_at_pole(const Spline_patch<3>& surface, int axis, int side)
{
  const Vector_of_functions<3> tangent = tangents_across(surface, axis, side);
  const std::vector<Exact_rational> along = surface.breaks(1 - axis);
  int degree = 0;
  for (const Exact_function& f : tangent)
    degree = (std::max)(degree, f.degree(0));
  std::vector<Exact_vector<3>> values;   // as many as determine a polynomial on each piece
  for (std::size_t i = 1; i < along.size(); ++i)
    for (int k = 0; k <= degree; ++k) {
      const std::array<Exact_rational, 1> u{
          Exact_rational(along[i - 1] + (along[i] - along[i - 1]) * (2 * k + 1) / (2 * degree + 2))};
      values.push_back({tangent[0](u), tangent[1](u), tangent[2](u)});
    }
  for (const Exact_vector<3>& other : values)
    if (const Exact_vector<3> normal = exact_cross(values[0], other); normal != Exact_vector<3>{}) {
      const bool is_plane = std::all_of(values.begin(), values.end(),
                                        [&](const Exact_vector<3>& x) { return are_orthogonal(normal, x); });
      return is_plane ? std::optional(std::array<Exact_vector<3>, 2>{values[0], other}) : std::nullopt;
    }
  return std::nullopt;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Vector_bounds<3> directions_at_pole(const Spline_patch<3>& surface, int axis, int side,
                                                                   const Parameter_range& range)
{
  const Vector_of_functions<3> tangent = tangents_across(surface, axis, side);
  Vector_bounds<3> result;
  for (std::size_t i = 0; i < 3; ++i)
    if (range.first == range.second)
      result[i] = Rational_interval(tangent[i](std::array{range.first}));
    else
      result[i] =
          Rational_interval(least_and_greatest(tangent[i].restricted(0, range.first, range.second).coefficients()));
  return result;
}
#endif

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SURFACE_POLES_H
