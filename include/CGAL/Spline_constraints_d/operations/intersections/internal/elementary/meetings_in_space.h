// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_MEETINGS_IN_SPACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_MEETINGS_IN_SPACE_H

#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Parameter_place.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/closed_forms.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

template <Formula_number Number>
Coordinates<Number, 3> vector_product(const Coordinates<Number, 3>& a, const Coordinates<Number, 3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <Formula_number Number>
Number triple_product(const Coordinates<Number, 3>& a, const Coordinates<Number, 3>& b, const Coordinates<Number, 3>& c)
{
  return inner_product(a, vector_product(b, c));
}

// The corner and sides of a triangle.
template <Formula_number Number>
struct Triangle_frame
{
  Coordinates<Number, 3> corner, first, second;

  explicit Triangle_frame(const Elementary_operand<3>& triangle)
    : corner(coordinates_of<Number>(triangle)), first(difference(coordinates_of<Number>(triangle, 3), corner)),
      second(difference(coordinates_of<Number>(triangle, 6), corner))
  {}

  Coordinates<Number, 3> normal() const { return vector_product(first, second); }
};

// Coordinates of a point of the plane of a triangle: multiples of its sides from the corner on, and their sum.
struct Sides_of_triangle
{
  Interval first, second, sum;
};

// Where a line meets the plane of a triangle; nothing where it is not proved to meet it once.
struct Meeting_with_triangle
{
  Interval t;
  Sides_of_triangle sides;
};

template <Formula_number Number>
std::optional<Meeting_with_triangle> meeting_with_triangle(const Elementary_operand<3>& line,
                                                           const Elementary_operand<3>& triangle)
{
  const Triangle_frame<Number> frame(triangle);
  const Affine_line<Number, 3> points = affine_line<Number>(line);
  const Coordinates<Number, 3> w = difference(points.origin, frame.corner), &v = points.direction,
                               normal = frame.normal();
  const Number volume = inner_product(normal, v);
  if (known_sign(volume) == 0)
    return std::nullopt;
  const Number first = triple_product(w, frame.second, v), second = triple_product(w, v, frame.first);
  return Meeting_with_triangle{enclosure_of(Number(-inner_product(normal, w) / volume)),
                               {enclosure_of(Number(first / volume)), enclosure_of(Number(second / volume)),
                                enclosure_of(Number((first + second) / volume))}};
}

// Whether a line is in a plane at a distance from that of a triangle, which is one.
inline bool is_beside_triangle(const Elementary_operand<3>& line, const Elementary_operand<3>& triangle)
{
  const Triangle_frame<Exact_rational> frame(triangle);
  const auto points = affine_line<Exact_rational>(line);
  return squared_length(points.direction) != 0 && inner_product(frame.normal(), points.direction) == 0 &&
      inner_product(frame.normal(), difference(points.origin, frame.corner)) != 0;
}

inline Sides_of_triangle sides_of_triangle(const Elementary_operand<3>& triangle, const Coordinates<Interval, 3>& point)
{
  const Triangle_frame<Interval> frame(triangle);
  const Coordinates<Interval, 3> normal = frame.normal(), w = difference(point, frame.corner);
  const Interval square = squared_length(normal), first = triple_product(w, frame.second, normal) / square,
                 second = triple_product(w, normal, frame.first) / square;
  return {first, second, first + second};
}

// The parameters of a point of a triangle, as `to_bspline_surface()` has it: (1-u) p + u ((1-v) q + v r), so that its
// coordinates are u (1 - v) and u v. Its corner p is a pole.
inline Decided_place place_on_triangle(const Sides_of_triangle& sides)
{
  const auto& [first, second, sum] = sides;
  const Interval zero(0), one(1);
  if (first.sup() < 0 || second.sup() < 0 || sum.inf() > 1)
    return {Decided_place::State::NONE};
  const bool is_decided = (first.inf() > 0 || first.is_same(zero)) && (second.inf() > 0 || second.is_same(zero)) &&
      (sum.sup() < 1 || sum.is_same(one));
  if (!is_decided)
    return {Decided_place::State::UNDECIDED};
  if (first.is_same(zero) && second.is_same(zero))
    return {Decided_place::State::FOUND, {{zero, Interval(0, 1)}, {true, false}, true}};
  const Interval v = first.is_same(zero) ? one
      : second.is_same(zero)             ? zero
                                         : common_part(second / sum, common_part(one - first / sum, Interval(0, 1)));
  return {Decided_place::State::FOUND, {{sum, v}, {sum.is_same(one), first.is_same(zero) || second.is_same(zero)}}};
}

// What is zero where two lines are in one plane.
template <Formula_number Number>
Number volume_between_lines(const Elementary_operand<3>& first, const Elementary_operand<3>& second)
{
  const auto a = affine_line<Number>(first), b = affine_line<Number>(second);
  return triple_product(difference(b.origin, a.origin), a.direction, b.direction);
}

// Where two lines of one plane meet; nothing where they are parallel.
inline std::optional<std::array<Interval, 2>> meeting_in_plane(const Elementary_operand<3>& first,
                                                               const Elementary_operand<3>& second)
{
  const auto a = affine_line<Exact_rational>(first), b = affine_line<Exact_rational>(second);
  const auto normal = vector_product(a.direction, b.direction), between = difference(b.origin, a.origin);
  const Exact_rational square = squared_length(normal);
  if (square == 0)
    return std::nullopt;
  return std::array<Interval, 2>{enclosure_of(Exact_rational(triple_product(between, b.direction, normal) / square)),
                                 enclosure_of(Exact_rational(triple_product(between, a.direction, normal) / square))};
}

inline bool are_apart_and_parallel(const Elementary_operand<3>& first, const Elementary_operand<3>& second)
{
  const auto a = affine_line<Exact_rational>(first), b = affine_line<Exact_rational>(second);
  const auto is_parallel = [&](const Coordinates<Exact_rational, 3>& v) {
    return squared_length(vector_product(a.direction, v)) == 0;
  };
  return squared_length(a.direction) != 0 && squared_length(b.direction) != 0 && is_parallel(b.direction) &&
      !is_parallel(difference(b.origin, a.origin));
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_MEETINGS_IN_SPACE_H
