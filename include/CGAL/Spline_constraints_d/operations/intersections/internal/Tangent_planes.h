// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_TANGENT_PLANES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_TANGENT_PLANES_H

#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Cell_functions.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

inline Vector_function<3> derivative_of_numerators(const Spline_patch<3>& patch, int axis)
{
  Vector_of_functions<3> result;
  for (int i = 0; i < 3; ++i)
    result[i] = patch.numerators()[i].derivative(axis);
  return Vector_function<3>(result);
}

// The tangent planes n0 x + n1 y + n2 z + n3 = 0 of a polynomial piece X/w of a surface: n is the vector at right
// angles to (X, w) and to its two derivatives, which is a positive multiple of the normal and without denominators.
inline std::array<Exact_function, 4> tangent_plane(const Spline_patch<3>& cell)
{
  const Vector_function<3> x(cell.numerators()), along_u = derivative_of_numerators(cell, 0),
                                                 along_v = derivative_of_numerators(cell, 1),
                                                 across = cross(along_u, along_v);
  Vector_function<3> normal = across;
  if (cell.is_rational()) {
    const Scalar_function w = cell.weight(), w_u = cell.weight().derivative(0), w_v = cell.weight().derivative(1);
    normal = across * w + cross(along_v, x) * w_u + cross(x, along_u) * w_v;
  }
  const Vector_of_functions<3> n = normal.functions();
  return {n[0], n[1], n[2], -dot(x, across).function()};
}

// Positive multiples of <S_uu,n>, <S_uv,n>, <S_vv,n> for a polynomial piece S = X/w with the normal n. With the tangent
// plane p, <p,(X,w)_uu> = w <S_uu,n>, and so on, as p is orthogonal to (X,w) and its first derivatives.
inline std::array<Exact_function, 3> second_form(const Spline_patch<3>& cell)
{
  const std::array<Exact_function, 4> plane = tangent_plane(cell);
  const auto& [x, y, z] = cell.numerators();
  const std::array<Exact_function, 4> point{x, y, z, cell.weight()};
  const auto curvature = [&](int axis, int other) {
    Exact_function sum = plane[0] * point[0].derivative(axis).derivative(other);
    for (std::size_t i = 1; i < (cell.is_rational() ? 4 : 3); ++i)
      sum = sum + plane[i] * point[i].derivative(axis).derivative(other);
    return sum;
  };
  return {curvature(0, 0), curvature(0, 1), curvature(1, 1)};
}

// The tangent planes of a surface, divided by factors that vanish along edges of the cells, as at a pole of a sphere.
// Before each cell `check()` may end the work by an exception.
inline std::vector<Continuous_part<4>> tangent_planes(const Spline_patch<3>& patch, const std::function<void()>& check)
{
  const auto checked_plane = [&](const Spline_patch<3>& cell) {
    check();
    return tangent_plane(cell);
  };
  return continuous_parts(Cell_functions<4>(patch, checked_plane), true);
}

// A positive multiple of the derivative of a polynomial piece of a surface by a parameter.
inline Vector_of_functions<3> tangent_direction(const Spline_patch<3>& cell, int axis)
{
  const Vector_function<3> slope = derivative_of_numerators(cell, axis);
  return cell.is_rational()
      ? (slope * cell.weight() - Vector_function<3>(cell.numerators()) * cell.weight().derivative(axis)).functions()
      : slope.functions();
}

// The directions of the derivative of a surface by a parameter.
inline std::vector<Continuous_part<3>> tangent_directions(const Spline_patch<3>& patch, int axis,
                                                          const std::function<void()>& check)
{
  const auto checked_direction = [&](const Spline_patch<3>& cell) {
    check();
    return tangent_direction(cell, axis);
  };
  return continuous_parts(Cell_functions<3>(patch, checked_direction), true);
}

// A part of a surface with continuous fields of normals and tangents, of any length.
struct Oriented_patch
{
  Spline_patch<3> patch;
  Cell_functions<4> planes;
  Vector_of_functions<3> normal;
  std::array<Vector_of_functions<3>, 2> tangents;
  std::array<bool, 2> is_seam;   // per axis: both ends are the same points with the same normals
  bool is_degenerate;            // there are no normals
};

// The parts of a surface, cut where a normal or tangent jumps.
inline std::vector<Oriented_patch> oriented_patches(const Spline_patch<3>& patch, const std::function<void()>& check)
{
  const std::vector<Continuous_part<4>> planes = tangent_planes(patch, check);
  const std::array<std::vector<Continuous_part<3>>, 2> tangents{tangent_directions(patch, 0, check),
                                                                tangent_directions(patch, 1, check)};
  std::vector<Oriented_patch> result;
  const auto is_cut = [&](const auto& parts) {
    for (std::size_t i = 0; parts.size() > 1 && i < parts.size(); ++i) {
      std::vector<Oriented_patch> part =
          oriented_patches(patch.part({parts[i].functions.domain(0), parts[i].functions.domain(1)}), check);
      std::move(part.begin(), part.end(), std::back_inserter(result));
    }
    return parts.size() > 1;
  };
  if (is_cut(planes) || is_cut(tangents[0]) || is_cut(tangents[1]))
    return result;
  const Cell_functions<4>& own = planes.front().functions;
  const auto is_seam = [&](int axis) {
    const auto ratio = own.ratio(axis, own.size(axis) - 1, 0);
    return patch.is_closed(axis) && ratio && *ratio > 0;
  };
  const auto [x, y, z, offset] = own.splines();
  return {{patch,
           own,
           {x, y, z},
           {tangents[0].front().functions.splines(), tangents[1].front().functions.splines()},
           {is_seam(0), is_seam(1)},
           own.is_zero()}};
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_TANGENT_PLANES_H
