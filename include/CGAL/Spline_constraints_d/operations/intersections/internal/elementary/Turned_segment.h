// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_TURNED_SEGMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_TURNED_SEGMENT_H

#include <CGAL/Spline_constraints_d/internal/scratch_memory.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Parameter_place.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/closed_forms.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
A cylinder, cone or frustum: a segment that is turned around an axis. At the ends v = 0 and 1 of the segment there are a
center of the turn and the arms from it to the points of the surface at u = 0 and u = 1, a quarter of the turn later.
*/
template <Formula_number Number>
struct Turned_segment
{
  using Vector = Coordinates<Number, 3>;

  std::array<Vector, 2> center, arm, quarter_arm;
  Vector axis, widening;   // of the center and of the arm from one end to the other one
  Number squared_length_of_axis;

  // \pre The operand is seen to be one.
  explicit Turned_segment(const Elementary_operand<3>& surface)
  {
    const Number half = number_of<Number>(0.5);
    for (const std::size_t end : {0, 1})
      for (std::size_t i = 0; i < 3; ++i) {
        const auto numerator = [&](std::size_t k) { return number_of<Number>(surface.coefficients[i][2 * k + end]); };
        const Number first = numerator(0), opposite = numerator(4);
        center[end][i] = half * (first + opposite);
        arm[end][i] = half * (first - opposite);
        quarter_arm[end][i] = half * numerator(2) - center[end][i];
      }
    axis = difference(center[1], center[0]);
    widening = difference(arm[1], arm[0]);
    squared_length_of_axis = squared_length(axis);
  }

  // The parameter v of a point, and of a vector, and the arm there, not turned.
  Number height(const Vector& from_center) const { return inner_product(from_center, axis) / squared_length_of_axis; }

  Vector arm_at(const Number& v) const { return sum(arm[0], v, widening); }

  // What is zero on the surface, as a polar form: squared distances from the axis and of the arm.
  Number polar(const Vector& x, const Vector& y) const
  {
    const Vector from_x = difference(x, center[0]), from_y = difference(y, center[0]);
    const Number v = height(from_x), other_v = height(from_y);
    return inner_product(from_x, from_y) - squared_length_of_axis * v * other_v -
        inner_product(arm_at(v), arm_at(other_v));
  }
};

// What is zero on the points of a line: a t^2 + 2 b t + c.
template <Formula_number Number>
std::array<Number, 3> equation_on_line(const Turned_segment<Number>& surface, const Affine_line<Number, 3>& line)
{
  const Coordinates<Number, 3> from_center = difference(line.origin, surface.center[0]);
  const Number begin = surface.height(from_center), speed = surface.height(line.direction);
  const Coordinates<Number, 3> arm = surface.arm_at(begin);
  Coordinates<Number, 3> change;
  for (std::size_t i = 0; i < 3; ++i)
    change[i] = speed * surface.widening[i];
  const auto along_axis = [&](const Number& x, const Number& y) -> Number {
    return surface.squared_length_of_axis * x * y;
  };
  return {squared_length(line.direction) - along_axis(speed, speed) - squared_length(change),
          inner_product(from_center, line.direction) - along_axis(begin, speed) - inner_product(arm, change),
          squared_length(from_center) - along_axis(begin, begin) - squared_length(arm)};
}

/*
Whether control points are those of a segment that is turned: w center + cos arm + sin quarter_arm in the control points
of the half round with weight one, which a turn by quarters is made of, with arms of the same length at right angles to
each other and to the axis, in the same directions at both ends.
*/
inline bool is_turned_segment(const Elementary_operand<3>& surface)
{
  constexpr std::array<double, 9> weights{1, 1, 2, 1, 1, 1, 2, 1, 1}, cosines{1, 1, 0, -1, -1, -1, 0, 1, 1},
      sines{0, 1, 2, 1, 0, -1, -2, -1, 0};
  for (std::size_t k = 0; k < 9; ++k)
    if (surface.weights[2 * k] != weights[k] || surface.weights[2 * k + 1] != weights[k])
      return false;
  // all are zero: intervals tell in most cases, also where they are exact
  const auto residuals = [&]<class Number>(const Number&) {
    const Turned_segment<Number> form(surface);
    Scratch_vector<Number> result;
    for (const std::size_t end : {0, 1}) {
      const auto &m = form.center[end], &e = form.arm[end], &f = form.quarter_arm[end];
      for (std::size_t k = 0; k < 9; ++k)
        for (std::size_t i = 0; i < 3; ++i)
          result.push_back(number_of<Number>(weights[k]) * m[i] + number_of<Number>(cosines[k]) * e[i] +
                           number_of<Number>(sines[k]) * f[i] -
                           number_of<Number>(surface.coefficients[i][2 * k + end]));
      result.push_back(inner_product(e, f));
      result.push_back(inner_product(e, form.axis));
      result.push_back(inner_product(f, form.axis));
      result.push_back(squared_length(e) - squared_length(f));
    }
    result.push_back(inner_product(form.arm[0], form.quarter_arm[1]));
    result.push_back(inner_product(form.arm[1], form.quarter_arm[0]));
    return result;
  };
  const Scratch_vector<Interval> bounds = residuals(Interval());
  Scratch_vector<Exact_rational> values;
  for (std::size_t k = 0; k < bounds.size(); ++k) {
    if (known_sign(bounds[k]) != 0)
      return false;
    if (bounds[k].is_same(Interval(0)))
      continue;
    if (values.empty())
      values = residuals(Exact_rational());
    if (values[k] != 0)
      return false;
  }
  const Turned_segment<Interval> form(surface);
  const auto is_less = [](const Interval& x) { return x.sup() < 0; };
  const Interval arms = inner_product(form.arm[0], form.arm[1]),
                 quarters = inner_product(form.quarter_arm[0], form.quarter_arm[1]);
  return known_sign(form.squared_length_of_axis) > 0 && !is_less(arms) && !is_less(quarters) &&
      (known_sign(arms) > 0) == (known_sign(quarters) > 0) &&
      (known_sign(squared_length(form.arm[0])) > 0 || known_sign(squared_length(form.arm[1])) > 0);
}

// The parameters of a point that is on the surface, or on the other points of its cylinder or cone.
inline Decided_place place_on_turned_segment(const Turned_segment<Interval>& surface,
                                             const Coordinates<Interval, 3>& point)
{
  const Coordinates<Interval, 3> from_center = difference(point, surface.center[0]);
  const Interval v = surface.height(from_center);
  if (v.sup() < 0 || v.inf() > 1)
    return {Decided_place::State::NONE};
  if (!(v.inf() > 0 && v.sup() < 1))
    return {Decided_place::State::UNDECIDED};
  // the turn is measured by the arms of the end where these are longer
  const std::size_t end =
      squared_length(surface.arm[0]).inf() > squared_length(surface.arm[1]).inf() ? 0 : 1;
  const Interval r = CGAL::sqrt(Interval(squared_length(surface.arm[end]) * squared_length(surface.arm_at(v))));
  const auto turn = turn_parameter(inner_product(from_center, surface.arm[end]),
                                   inner_product(from_center, surface.quarter_arm[end]), r);
  Decided_place result = place_on_turn(turn, false);
  result.place.parameters[1] = v;
  return result;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_TURNED_SEGMENT_H
