// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_CONE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_CONE_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Homogeneous_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

inline Rational_interval cross_product(const Vector_bounds<2>& a, const Vector_bounds<2>& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// The directions that point into a region from a point of its boundary: from that in which the boundary goes on,
// counterclockwise to that from which it comes.
struct Contact_cone
{
  Vector_bounds<2> on, back;
  bool is_half_plane;

  // Whether a direction points inside for certain.
  bool contains(const Vector_bounds<2>& direction) const
  {
    const bool is_left_of_on = cross_product(on, direction).lower > 0,
               is_right_of_back = cross_product(direction, back).lower > 0;
    if (is_half_plane)
      return is_left_of_on;
    const Rational_interval turn = cross_product(on, back);
    return turn.lower > 0 ? is_left_of_on && is_right_of_back : turn.upper < 0 && (is_left_of_on || is_right_of_back);
  }
};

inline Vector_bounds<2> bounds_of(const Exact_pair& vector)
{
  return {Rational_interval(vector[0]), Rational_interval(vector[1])};
}

inline Vector_bounds<2> opposite(const Vector_bounds<2>& v)
{
  return {Rational_interval(Exact_rational(-v[0].upper), Exact_rational(-v[0].lower)),
          Rational_interval(Exact_rational(-v[1].upper), Exact_rational(-v[1].lower))};
}

inline Exact_pair tangent_at_end(const Boundary_piece& piece, bool end)
{
  return Homogeneous_piece{{Exact_rational(0), Exact_rational(1)}, piece.coordinates}.tangent_at(end);
}

// Of the derivative of a piece in a range of its parameter, up to a positive factor.
inline Vector_bounds<2> bounds_of_tangent(const Boundary_piece& piece, const Parameter_range& range)
{
  const auto& [x, y, w] = piece.coordinates;
  const auto bounds = [&, &w = w](const Exact_tensor& f) {
    const Exact_tensor numerator = f.derivative(0) * w - f * w.derivative(0);
    return range.first < range.second
        ? Rational_interval(numerator.restricted(0, range.first, range.second).bounds())
        : Rational_interval(Exact_rational(numerator(std::array<Exact_rational, 1>{range.first})));
  };
  return {bounds(x), bounds(y)};
}

// In the points of a part of a piece.
inline Contact_cone cone_on_piece(const Boundary_piece& piece, const Parameter_range& range)
{
  const Vector_bounds<2> tangent = bounds_of_tangent(piece, range);
  return {tangent, opposite(tangent), true};
}

// Bounds of a linear map, by its columns.
using Linear_bounds = std::array<std::array<Rational_interval, 2>, 2>;

// The image of a cone.
inline Contact_cone moved(const Contact_cone& cone, const Linear_bounds& columns, bool keeps_orientation)
{
  const auto image = [&](const Vector_bounds<2>& v) {
    return Vector_bounds<2>{columns[0][0] * v[0] + columns[1][0] * v[1], columns[0][1] * v[0] + columns[1][1] * v[1]};
  };
  return keeps_orientation ? Contact_cone{image(cone.on), image(cone.back), cone.is_half_plane}
                           : Contact_cone{image(cone.back), image(cone.on), cone.is_half_plane};
}

// Whether one boundary goes on into the other region, so that the regions overlap.
inline bool pass_each_other(const Contact_cone& a, const Contact_cone& b)
{
  return a.contains(b.on) || a.contains(b.back) || b.contains(a.on) || b.contains(a.back);
}

// Whether smooth boundaries cannot touch from outside: their tangents are never parallel, or have the same direction.
inline bool are_never_opposite(const Contact_cone& a, const Contact_cone& b)
{
  return !has_zero(cross_product(a.on, b.on)) || (a.on[0] * b.on[0] + a.on[1] * b.on[1]).lower > 0;
}

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_CONTACT_CONE_H
