// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_TURN_AROUND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_TURN_AROUND_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Site_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/interval_pairs.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
How often closed paths go around a point, by proof.

A path is divided into parts, each in a half-plane that does not reach the point. Where two of them meet, the middle of
the box of what is common to both is in both half-planes, and the path may pass it as well. So the sum of the angles
between these middles is that by which the path turns, a multiple of 2 pi: sums of rounded angles tell which one.
*/

// The angle from the middle of a box to that of another one, seen from the origin, if both boxes and what is between
// them are in such a half-plane.
inline std::optional<double> angle_within(const Interval_pair& between, const Interval_pair& from,
                                          const Interval_pair& to)
{
  const auto middle = [](const Interval_pair& box) {
    return std::array<double, 2>{box[0].inf() / 2 + box[0].sup() / 2, box[1].inf() / 2 + box[1].sup() / 2};
  };
  const Interval_pair all = hull(between, hull(from, to));
  const auto normal = middle(all), a = middle(from), b = middle(to);
  if (!std::isfinite(normal[0]) || !std::isfinite(normal[1]) ||
      !(dot(all, {Interval(normal[0]), Interval(normal[1])}).inf() > 0))
    return std::nullopt;
  return std::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]);
}

// The angle along a path, enclosed over ranges of its parameter, from one number to another one; nothing if the path
// passes the point too closely to tell.
template <std::invocable<const Range&> Path>
std::optional<double> turn_around(const Interval_pair& point, const Path& path, double from, double to, int depth = 0)
{
  constexpr int most_depth = 40;
  if (const auto angle = angle_within(path(Range{(std::min)(from, to), (std::max)(from, to)}) - point,
                                      path(Range{from, from}) - point, path(Range{to, to}) - point))
    return angle;
  if (depth >= most_depth)
    return std::nullopt;
  const double middle = from / 2 + to / 2;
  const auto first = turn_around(point, path, from, middle, depth + 1);
  const auto second = first ? turn_around(point, path, middle, to, depth + 1) : std::nullopt;
  return second ? std::optional(*first + *second) : std::nullopt;
}

// The winding number of a closed path, from the sum of all angles.
inline int full_turns(double angle) { return static_cast<int>(std::round(angle / (2 * CGAL_PI))); }

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_TURN_AROUND_H
