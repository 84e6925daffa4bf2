// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_TANGENTIAL_CROSSING_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_TANGENTIAL_CROSSING_2_H

#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Traced_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

/*
Whether two curves cross where their derivatives do not tell, as where they have the same curvature in a common tangent.
Both are graphs over a line there. If one is above the other one where their common part over the line begins, and below
it where this ends, they cross between, somehow.
*/
class Tangential_crossing_2
{
  std::array<Traced_view_2, 2> m_views;

public:
  Tangential_crossing_2(const Traced_view_2& first, const Traced_view_2& second) : m_views{first, second} {}

  // Somewhere around these ranges, which are enlarged until it is known which curve is above.
  bool is_near(std::array<Range, 2> ranges) const
  {
    constexpr double growth = 1.5, least_width = 0x1p-30;
    for (bool is_growing = true; is_growing;) {
      is_growing = false;
      for (const std::size_t k : {0, 1}) {
        const Range whole = m_views[k].curve().inner_range(), old = ranges[k];
        const double reach = growth * (std::max)(old.width(), least_width);
        ranges[k] = {(std::max)(old.begin - reach, whole.begin), (std::min)(old.end + reach, whole.end)};
        is_growing = is_growing || old.begin > ranges[k].begin || ranges[k].end > old.end;
      }
      if (const int sign = sign_of_crossing(ranges); sign != 0)
        return sign < 0;
    }
    return false;
  }

private:
  // A line, with the common part of both curves above it.
  struct Base
  {
    Interval_pair direction, normal;
    std::array<Range, 2> ranges;
    std::array<bool, 2> is_backward;   // whether a curve runs against the direction
  };

  // -1 if the order of the curves at both ends of their common part is certainly not the same, 1 if it is, and 0 if
  // this is not known.
  int sign_of_crossing(const std::array<Range, 2>& ranges) const
  {
    const std::array<Interval_pair, 2> tangents{m_views[0].direction(ranges[0]), m_views[1].direction(ranges[1])};
    const double x = tangents[0][0].inf() / 2 + tangents[0][0].sup() / 2,
                 y = tangents[0][1].inf() / 2 + tangents[0][1].sup() / 2, length = std::hypot(x, y);
    if (!(length > 0) || !std::isfinite(length))
      return 0;
    const Interval_pair direction{Interval(x / length), Interval(y / length)};
    const int sign = certain_sign(dot(direction, tangents[1]));
    if (certain_sign(dot(direction, tangents[0])) <= 0 || sign == 0)
      return 0;
    const Base base{direction, turned_left(direction), ranges, {false, sign < 0}};
    std::array<Interval, 2> places{Interval(0), Interval(0)};
    const int order = order_at(base, 0, places[0]) * order_at(base, 1, places[1]);
    return certain_sign(places[1] - places[0]) > 0 ? order : 0;
  }

  // Which curve is higher at the begin (0) or end (1) of the common part, in whose place one of the curves ends.
  int order_at(const Base& base, std::size_t side, Interval& place) const
  {
    std::array<Interval_pair, 2> ends;
    for (const std::size_t k : {0, 1}) {
      const double t = (side == 1) != base.is_backward[k] ? base.ranges[k].end : base.ranges[k].begin;
      ends[k] = m_views[k].point({t, t});
    }
    const int sign = certain_sign(dot(base.direction, ends[1] - ends[0]));
    if (sign == 0)
      return 0;
    const std::size_t nearer = (sign > 0) == (side == 0);
    place = dot(base.direction, ends[nearer]);
    const int height = certain_sign(dot(base.normal, ends[nearer] - point_over(base, 1 - nearer, place)));
    return nearer == 1 ? height : -height;
  }

  // The point of a curve over a place that it passes.
  Interval_pair point_over(const Base& base, std::size_t k, const Interval& place) const
  {
    Range t = base.ranges[k];
    for (bool is_shorter = true; is_shorter;) {
      is_shorter = false;
      for (const double part : {0.5, 0.25, 0.75}) {
        const double middle = t.begin + part * t.width();
        const int sign = certain_sign(dot(base.direction, m_views[k].point({middle, middle})) - place);
        if (!(t.begin < middle && middle < t.end) || sign == 0)
          continue;
        ((sign > 0) != base.is_backward[k] ? t.end : t.begin) = middle;
        is_shorter = true;
        break;
      }
    }
    return m_views[k].point(t);
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_TANGENTIAL_CROSSING_2_H
