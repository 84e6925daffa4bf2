// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEWTON_STEPS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEWTON_STEPS_H

#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Part_function.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Piece_point.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Solutions so near to the edges of a part are not looked for in it.
constexpr double part_margin = 0x1p-16;

// The solution of H step = -gradient, for the parameters of a part that are not fixed.
template <class Number>
std::array<Number, 2> newton_step(const Bernstein_part& part, const Second_jet<Number>& f,
                                  const std::array<Number, 2>& gradient)
{
  if (part.sides[0] >= 0 || part.sides[1] >= 0) {
    std::array<Number, 2> result{Number(0), Number(0)};
    for (const int axis : {0, 1})
      if (part.sides[axis] < 0)
        result[axis] = -gradient[axis] / f.second[axis];
    return result;
  }
  const Number determinant = f.second[0] * f.second[1] - f.mixed * f.mixed;
  return {(f.mixed * gradient[1] - f.second[1] * gradient[0]) / determinant,
          (f.mixed * gradient[0] - f.second[0] * gradient[1]) / determinant};
}

// A point inside of a part where the gradient is nearly zero, with its place and the derivatives by that, and the
// squared distance with a gradient that has all digits.
template <int d>
struct Stationary_point
{
  std::array<double, 2> place;
  Second_jet<double> jet;
  std::array<double, 2> parameters;
  Distance_jet<d> distance;

  // The gradient by the place in a part.
  std::array<Interval, 2> gradient(const Bernstein_part& part) const
  {
    std::array<Interval, 2> result{Interval(0), Interval(0)};
    for (const int axis : {0, 1})
      if (part.sides[axis] < 0)
        result[axis] = Interval(2 * part.width(axis)) * distance.half_gradient[axis];
    return result;
  }
};

// By Newton's method; none if it goes to an edge of the part.
template <int d>
std::optional<Stationary_point<d>> stationary_point(const Part_function& f, const Bernstein_part& part,
                                                    const Rounded_piece<d>& a, const Rounded_piece<d>& b)
{
  std::array<double, 2> place{part.sides[0] >= 0 ? 0 : 0.5, part.sides[1] >= 0 ? 0 : 0.5};
  Second_jet<double> jet;
  for (int i = 0; i < 8; ++i) {
    jet = f.jet(place);
    const std::array<double, 2> step = newton_step<double>(part, jet, {jet.first[0], jet.first[1]});
    double length = 0;
    for (const int axis : {0, 1}) {
      if (part.sides[axis] >= 0)
        continue;
      length = (std::max)(length, std::abs(step[axis]));
      place[axis] += step[axis];
      if (!(place[axis] > -0.5 && place[axis] < 1.5))
        return std::nullopt;
      place[axis] = (std::min)((std::max)(place[axis], 0.0), 1.0);
    }
    if (length < 0x1p-20)
      break;
  }
  std::array<double, 2> x;
  for (const int axis : {0, 1}) {
    if (part.sides[axis] < 0 && !(place[axis] > part_margin && place[axis] < 1 - part_margin))
      return std::nullopt;
    x[axis] = part.begin[axis] + place[axis] * part.width(axis);
  }
  Stationary_point<d> result{place, jet, x, Distance_jet<d>(a, b, x)};
  // One more step with all digits, if it is long enough.
  std::array<double, 2> gradient;
  const auto exact_gradient = result.gradient(part);
  for (const int axis : {0, 1})
    gradient[axis] = exact_gradient[axis].inf() / 2 + exact_gradient[axis].sup() / 2;
  const std::array<double, 2> step = newton_step(part, jet, gradient);
  bool is_better = false;
  for (const int axis : {0, 1}) {
    x[axis] += step[axis] * part.width(axis);
    is_better = is_better || std::abs(step[axis] * part.width(axis)) > unit;
  }
  if (is_better)
    result = {place, jet, x, Distance_jet<d>(a, b, x)};
  return result;
}

// The place of ranges of parameters in a part.
inline std::array<Interval, 2> place_of(const std::array<Double_range, 2>& ranges, const Bernstein_part& part)
{
  std::array<Interval, 2> result{Interval(0), Interval(0)};
  for (const int axis : {0, 1})
    if (part.sides[axis] < 0)
      result[axis] =
          (Interval(ranges[axis].lower, ranges[axis].upper) - Interval(part.begin[axis])) / Interval(part.width(axis));
  return result;
}

// The ranges in which Newton's method in intervals puts the parameters, with bounds of the second derivatives.
template <int d>
std::array<Double_range, 2> newton_ranges(const Stationary_point<d>& point, const Bernstein_part& part,
                                          const Second_jet<Interval>& second)
{
  const std::array<Interval, 2> step = newton_step(part, second, point.gradient(part));
  std::array<Double_range, 2> result;
  for (const int axis : {0, 1}) {
    const Interval x = Interval(point.parameters[axis]) + step[axis] * Interval(part.width(axis));
    result[axis] = part.sides[axis] < 0 ? Double_range{x.inf(), x.sup()}
                                        : Double_range{point.parameters[axis], point.parameters[axis]};
  }
  return result;
}

// How much the squared distance at parameters differs from that at the critical point in ranges around them: the
// gradient is zero there, so half the second derivative tells.
inline double deviation(const Bernstein_part& part, const std::array<Double_range, 2>& ranges,
                        const std::array<double, 2>& parameters, const Second_jet<Interval>& second)
{
  std::array<Interval, 2> step{Interval(0), Interval(0)};
  for (const int axis : {0, 1})
    if (part.sides[axis] < 0)
      step[axis] =
          (Interval(ranges[axis].lower, ranges[axis].upper) - Interval(parameters[axis])) / Interval(part.width(axis));
  const Interval result =
      (second.second[0] * CGAL::square(step[0]) + second.second[1] * CGAL::square(step[1])) / Interval(2) +
      second.mixed * step[0] * step[1];
  return (std::max)(-result.inf(), result.sup());
}

// Narrows the ranges of a candidate by the second derivatives on them, which are better than those on all of the part,
// and moves its parameters into them. Returns these derivatives.
template <class Candidate, int d>
Second_jet<Interval> narrow_ranges(Candidate& candidate, const Part_function& f, const Stationary_point<d>& point,
                                   const Bernstein_part& part)
{
  const Second_jet<Interval> jet = f.jet(place_of(candidate.ranges, part));
  const std::array<Double_range, 2> better = newton_ranges(point, part, jet);
  for (const int axis : {0, 1})
    if (part.sides[axis] < 0) {
      Double_range& range = candidate.ranges[axis];
      range = {better[axis].lower > range.lower ? better[axis].lower : range.lower,
               better[axis].upper < range.upper ? better[axis].upper : range.upper};
      candidate.parameters[axis] = (std::min)((std::max)(candidate.parameters[axis], range.lower), range.upper);
    }
  candidate.deviation = deviation(part, candidate.ranges, candidate.parameters, jet);
  return jet;
}

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_NEWTON_STEPS_H
