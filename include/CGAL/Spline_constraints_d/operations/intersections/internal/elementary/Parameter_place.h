// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_PARAMETER_PLACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_PARAMETER_PLACE_H

#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/closed_forms.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Where on an operand a point is: enclosures of its parameters, and which are exactly at an end.
struct Parameter_place
{
  std::array<Interval, 2> parameters = {Interval(0), Interval(0)};
  std::array<bool, 2> is_at_end = {false, false};
  bool is_pole = false;
};

// The answer to a question that not all closed forms answer: a place, that there is none, or that it is not decided.
struct Decided_place
{
  enum class State { FOUND, NONE, UNDECIDED } state;
  Parameter_place place = {};
};

// A parameter on a line, in units of its direction, that has to be in a range of the unit.
inline Decided_place place_on_line(Elementary_kind kind, const Interval& t)
{
  const bool has_begin = kind == Elementary_kind::RAY || kind == Elementary_kind::SEGMENT,
             has_end = kind == Elementary_kind::SEGMENT;
  if ((has_begin && t.sup() < 0) || (has_end && t.inf() > 1))
    return {Decided_place::State::NONE};
  if ((!has_begin || t.inf() > 0) && (!has_end || t.sup() < 1))
    return {Decided_place::State::FOUND, {{t, Interval(0)}}};
  if ((has_begin && t.is_same(Interval(0))) || (has_end && t.is_same(Interval(1))))
    return {Decided_place::State::FOUND, {{t, Interval(0)}, {true, false}}};
  return {Decided_place::State::UNDECIDED};
}

// The parameter on a line of the plane of a point that is on it.
inline Interval parameter_on_line(const Elementary_operand<2>& line, const Coordinates<Interval, 2>& point)
{
  const Affine_line<Interval, 2> form = affine_line<Interval>(line);
  const Coordinates<Interval, 2>& v = form.direction;
  const Interval square = squared_length(v);
  if (line.kind == Elementary_kind::EQUATION_LINE)   // its origin is at a right angle
    return inner_product(point, v) / square;
  const Interval t = inner_product(difference(point, form.origin), v) / square;
  if (line.kind != Elementary_kind::SEGMENT)
    return t;
  const Coordinates<Interval, 2> target = coordinates_of<Interval>(line, 2);
  return common_part(t, Interval(1) + inner_product(difference(point, target), v) / square);
}

/*
The parameter of a turn over [0,4] in four quarters, from the cosine and sine of its angle, both times the same r: where
the cosine is positive, tan(angle/2) = sin / (1 + cos) from the seam on, and to it; elsewhere 2 - sin / (1 - cos).
*/
inline std::optional<Interval> turn_parameter(const Interval& cosine, const Interval& sine, const Interval& r)
{
  if (sine.is_same(Interval(0)) && cosine.inf() > 0)
    return Interval(0);
  if (cosine.sup() >= 0 && known_sign(sine) == 0)
    return std::nullopt;
  std::optional<Interval> result;
  if (cosine.inf() < 0)
    result = Interval(2) - sine / (r - cosine);
  if (cosine.sup() >= 0) {
    const Interval half = sine / (r + cosine), turn = known_sign(sine) < 0 ? Interval(4) + half : half;
    result = result ? hull(*result, turn) : turn;
  }
  return common_part(*result, Interval(0, 4));
}

inline Decided_place place_on_turn(const std::optional<Interval>& turn, bool is_clockwise)
{
  if (!turn)
    return {Decided_place::State::UNDECIDED};
  const bool is_at_seam = turn->is_same(Interval(0));
  const Interval u = is_clockwise && !is_at_seam ? Interval(4) - *turn : *turn;
  return {Decided_place::State::FOUND, {{u, Interval(0)}, {is_at_seam, false}}};
}

// Of a point of a circle, by the vector from its center, as `to_bspline_curve()` has it.
inline Decided_place place_on_sphere(const Elementary_operand<2>& circle, const Coordinates<Interval, 2>& arm)
{
  const Interval radius = CGAL::sqrt(Interval(circle.numbers[2]));
  const std::optional<Interval> turn = turn_parameter(arm[0], circle.is_clockwise ? -arm[1] : arm[1], radius);
  return place_on_turn(turn, false);
}

// Of a point of a sphere, as `to_bspline_surface()` has it: axis 0 turns around the axis of z, from the direction of y
// on, and axis 1 leads from the lower pole to the upper one.
inline Decided_place place_on_sphere(const Elementary_operand<3>& sphere, const Coordinates<Interval, 3>& arm)
{
  const auto& [x, y, z] = arm;
  if (x.is_same(Interval(0)) && y.is_same(Interval(0)))
    return {known_sign(z) == 0 ? Decided_place::State::UNDECIDED : Decided_place::State::FOUND,
            {{Interval(0, 4), Interval(z.inf() < 0 ? 0 : 2)}, {false, true}, true}};
  const Interval radius = CGAL::sqrt(Interval(sphere.numbers[3])),
                 distance = CGAL::sqrt(Interval(CGAL::square(x) + CGAL::square(y)));
  Decided_place result = place_on_turn(turn_parameter(y, -x, distance), sphere.is_clockwise);
  // the half turn over [0,2]
  const std::optional<Interval> height = turn_parameter(-z, distance, radius);
  if (!height || !(distance.inf() > 0))
    return {Decided_place::State::UNDECIDED};
  result.place.parameters[1] = common_part(*height, Interval(0, 2));
  return result;
}

// The parameters of a point of a plane, in the cut of it with a box around the other operand that
// `to_bspline_surface()` makes: there they are the fractions of the ranges of two coordinates.
inline Decided_place place_on_plane(const Elementary_operand<3>& plane, const Elementary_operand<3>& other,
                                    const Coordinates<Interval, 3>& point)
{
  std::array<Interval, 3> bounds;
  Interval margin(1);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [least, greatest] = std::minmax_element(other.coefficients[i].begin(), other.coefficients[i].end());
    bounds[i] = Interval(*least, *greatest);
    margin += Interval(*greatest) - Interval(*least);
  }
  std::size_t k = 0;
  for (std::size_t axis = 1; axis < 3; ++axis)
    if (CGAL::abs(plane.numbers[k]) < CGAL::abs(plane.numbers[axis]))
      k = axis;
  const auto fraction = [&](std::size_t i) {
    const Interval low = Interval(bounds[i].inf()) - margin, high = Interval(bounds[i].sup()) + margin;
    return Interval((point[i] - low) / (high - low));
  };
  Decided_place result{Decided_place::State::FOUND, {{fraction((k + 1) % 3), fraction((k + 2) % 3)}}};
  if (plane.numbers[k] < 0)
    std::swap(result.place.parameters[0], result.place.parameters[1]);
  return result;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_PARAMETER_PLACE_H
