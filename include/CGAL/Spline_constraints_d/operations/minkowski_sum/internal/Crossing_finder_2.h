// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CROSSING_FINDER_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CROSSING_FINDER_2_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Traced_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

// Ranges of the parameters of two curves: with exactly one common point, where they cross; or not decided, with any
// number of them.
struct Crossing_2
{
  std::array<Range, 2> ranges;
  bool is_certain;
};

// A point in which both of two curves begin (0) or end (1).
struct Common_end
{
  std::array<int, 2> ends;
  bool is_tangential;   // whether the directions there are proved to be parallel or opposite
};

/*
Where two curves cross, by subdivision of both. Parts are discarded if a line separates them. The derivatives of two
parts that have no common direction have one common point at most, and Newton's method with intervals finds it, or
proves that there is none. The number type is that of the points.
*/
template <Enclosing_number Number = Interval>
class Crossing_finder_2
{
  using Point = std::array<Number, 2>;
  using Part = Traced_curve_2::Part;
  using Pair = std::array<const Part*, 2>;
  // more are next to each other only where curves touch
  static constexpr std::size_t most_steps = 4000, most_pairs = 2048;
  static constexpr double least_width = std::same_as<Number, Interval> ? 0x1p-44 : 0x1p-50;

  std::array<Traced_view_2, 2> m_views;
  std::vector<Common_end> m_common_ends;
  bool m_is_first_enough;
  std::vector<Crossing_2> m_crossings;

public:
  Crossing_finder_2(const Traced_view_2& first, const Traced_view_2& second, std::vector<Common_end> common_ends = {},
                    bool is_first_enough = false)
    : m_views{first, second}, m_common_ends(std::move(common_ends)), m_is_first_enough(is_first_enough)
  {}

  // All crossings other than common ends; or, on request, a certain one alone, if one is found. Undecided ones that are
  // next to each other are one.
  // \throws Run_stopped
  std::vector<Crossing_2> operator()(Run_of_steps& control)
  {
    constexpr std::size_t steps_between_checks = 64;
    // large parts first: what is certain is found before what has to be cut again and again
    std::deque<Pair> todo{{&m_views[0].curve().whole(), &m_views[1].curve().whole()}};
    for (std::size_t steps = 0; !todo.empty() && todo.size() <= most_pairs && steps <= most_steps && !is_done();
         ++steps) {
      if (steps % steps_between_checks == 0)
        control.check();
      const Pair parts = todo.front();
      todo.pop_front();
      if (!are_separated(parts) && !are_joined(parts) && !solve_by_newton(parts))
        cut(parts, todo);
    }
    if (!is_done())
      for (const Pair& parts : todo)
        add_undecided({parts[0]->range(), parts[1]->range()});
    return m_crossings;
  }

  // Whether a part of a curve is proved not to meet a box, by axes and lines along the curve.
  static bool is_apart(const Traced_curve_2& curve, const Part& part, const Interval_pair& box)
  {
    constexpr double enough = 0x1p-20;
    if (!may_meet(part.box(), box) || is_beside(curve, part, box))
      return true;
    if (part.range().width() <= enough)
      return false;
    const auto& halves = curve.halves(part);
    return is_apart(curve, halves[0], box) && is_apart(curve, halves[1], box);
  }

  // Whether a line about tangential to a part of a curve separates it from a box; see below.
  static bool is_beside(const Traced_curve_2& curve, const Part& part, const Interval_pair& box)
  {
    const Range &range = part.range(), &inner = curve.inner_range();
    if (!(inner.begin <= range.middle() && range.middle() <= inner.end))
      return false;
    const Interval_pair normal = turned_left(middle_of(part.direction()));
    return certain_sign(dot(normal, box - part.middle_point()) -
                        part.speed() * dot(normal, part.direction()) * (range.interval() - Interval(range.middle()))) !=
        0;
  }

private:
  bool is_done() const { return m_is_first_enough && !m_crossings.empty() && m_crossings.back().is_certain; }

  // Into halves of the larger part, or an undecided crossing where both are tiny.
  void cut(const Pair& parts, std::deque<Pair>& todo)
  {
    const auto is_tiny = [&](std::size_t k) { return parts[k]->range().width() <= least_width; };
    if (is_tiny(0) && is_tiny(1)) {
      add_undecided({parts[0]->range(), parts[1]->range()});
      return;
    }
    const std::size_t k = is_tiny(0) || (!is_tiny(1) && extent(*parts[0]) < extent(*parts[1]));
    for (const Part& half : m_views[k].curve().halves(*parts[k])) {
      todo.push_back(parts);
      todo.back()[k] = &half;
    }
  }

  static double extent(const Part& part)
  {
    return (std::max)(part.box()[0].sup() - part.box()[0].inf(), part.box()[1].sup() - part.box()[1].inf());
  }
  // Some vector within bounds; zero where these are not finite.
  static Interval_pair middle_of(const Interval_pair& v)
  {
    const double x = v[0].inf() / 2 + v[0].sup() / 2, y = v[1].inf() / 2 + v[1].sup() / 2;
    return std::isfinite(x) && std::isfinite(y) ? Interval_pair{Interval(x), Interval(y)}
                                                : Interval_pair{Interval(0), Interval(0)};
  }

  Point middle_point(std::size_t k, const Part& part) const { return m_views[k].template middle_point<Number>(part); }

  // Whether the middle of a range is proved to be on the curve.
  bool has_middle(std::size_t k, const Range& range) const
  {
    const Range& inner = m_views[k].curve().inner_range();
    return inner.begin <= range.middle() && range.middle() <= inner.end;
  }

  // Nearly.
  static Interval_pair unit_vector(const Interval_pair& v)
  {
    const double x = v[0].inf(), y = v[1].inf(), length = std::hypot(x, y);
    return length > 0 ? Interval_pair{Interval(x / length), Interval(y / length)} : v;
  }

  // By a line parallel to an axis or about tangential to one of the curves, whose points are middle + derivative * s by
  // the mean value theorem.
  bool are_separated(const Pair& parts) const
  {
    if (!may_meet(m_views[0].box(*parts[0]), m_views[1].box(*parts[1])))
      return true;
    const std::array<Interval_pair, 2> directions{m_views[0].direction(*parts[0]), m_views[1].direction(*parts[1])};
    if (!has_middle(0, parts[0]->range()) || !has_middle(1, parts[1]->range()))
      return false;
    const Interval_pair between = in_doubles(middle_point(0, *parts[0]) - middle_point(1, *parts[1]));
    const auto step = [&](std::size_t k) {
      return parts[k]->speed() * (parts[k]->range().interval() - Interval(parts[k]->range().middle()));
    };
    return std::any_of(directions.begin(), directions.end(), [&](const Interval_pair& direction) {
      const Interval_pair normal = turned_left(middle_of(direction));
      return certain_sign(dot(normal, between) + dot(normal, directions[0]) * step(0) -
                          dot(normal, directions[1]) * step(1)) != 0;
    });
  }

  void add_undecided(std::array<Range, 2> ranges)
  {
    for (std::size_t i = 0; i < m_crossings.size();)
      if (const Crossing_2& other = m_crossings[i];
          !other.is_certain && other.ranges[0].meets(ranges[0]) && other.ranges[1].meets(ranges[1])) {
        for (const std::size_t k : {0, 1})
          ranges[k] = united(ranges[k], other.ranges[k]);
        m_crossings.erase(m_crossings.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
      } else
        ++i;
    m_crossings.push_back({ranges, false});
  }

  // Whether the parts are next to a common end, which is all that they have in common.
  bool are_joined(const Pair& parts) const
  {
    return std::any_of(m_common_ends.begin(), m_common_ends.end(), [&](const Common_end& end) {
      return is_at_end(0, end.ends[0], parts) && is_at_end(1, end.ends[1], parts) && meet_nowhere_else(end, parts);
    });
  }

  bool is_at_end(std::size_t k, int end, const Pair& parts) const
  {
    const Range &part = parts[k]->range(), &whole = m_views[k].curve().range();
    return end == 0 ? part.begin == whole.begin : part.end == whole.end;
  }

  /*
  Two parts have one common point at most if they have no common directions; if they leave it to different sides of a
  line; or if they are tangential there and leave it to the same side, and the curvature of one is larger than that of
  the other one everywhere: as graphs over a line, the sine of the angle of the direction is the integral of the
  curvature.
  */
  bool meet_nowhere_else(const Common_end& end, const Pair& parts) const
  {
    std::array<Interval_pair, 2> directions;   // from the end
    std::array<Interval, 2> curvatures;
    for (const std::size_t k : {0, 1}) {
      const Interval_pair direction = m_views[k].direction(*parts[k]);
      const Interval& curvature = parts[k]->curvature();
      directions[k] = end.ends[k] == 0 ? direction : Interval_pair{-direction[0], -direction[1]};
      curvatures[k] = end.ends[k] == 0 ? curvature : -curvature;
    }
    if (certain_sign(cross(directions[0], directions[1])) != 0)
      return true;
    const std::array<Interval_pair, 2> units{unit_vector(middle_of(directions[0])),
                                             unit_vector(middle_of(directions[1]))};
    const auto are_on_sides = [&](const Interval_pair& normal, int sign) {
      return certain_sign(dot(normal, directions[0])) == 1 && certain_sign(dot(normal, directions[1])) == sign;
    };
    return are_on_sides(units[0] - units[1], -1) ||
        (end.is_tangential && are_on_sides(units[0] + units[1], 1) && certain_sign(curvatures[0] - curvatures[1]) != 0);
  }

  // Returns whether it is decided if the parts cross.
  bool solve_by_newton(const Pair& parts)
  {
    constexpr double enough = 0.75;
    std::array<Range, 2> ranges{parts[0]->range(), parts[1]->range()};
    std::array<Interval_pair, 2> directions{m_views[0].direction(*parts[0]), m_views[1].direction(*parts[1])};
    std::array<Point, 2> middles{middle_point(0, *parts[0]), middle_point(1, *parts[1])};
    std::array<Interval, 2> speeds{parts[0]->speed(), parts[1]->speed()};
    for (bool is_certain = false;;) {
      const Interval determinant = cross(directions[0], directions[1]);
      if (certain_sign(determinant) == 0 || certain_sign(speeds[0]) == 0 || certain_sign(speeds[1]) == 0 ||
          !has_middle(0, ranges[0]) || !has_middle(1, ranges[1]))
        return false;
      const Interval_pair between = in_doubles(middles[1] - middles[0]);
      const std::array<Interval, 2> steps{cross(between, directions[1]) / (determinant * speeds[0]),
                                          cross(between, directions[0]) / (determinant * speeds[1])};
      bool is_inside = true, is_shorter = false;
      std::array<Range, 2> next;
      for (std::size_t k = 0; k < 2; ++k) {
        const Interval image = Interval(ranges[k].middle()) + steps[k];
        const Range& inner = m_views[k].curve().inner_range();
        is_inside = is_inside && ranges[k].begin < image.inf() && image.sup() < ranges[k].end &&
            inner.begin <= ranges[k].begin && ranges[k].end <= inner.end;
        next[k] = {(std::max)(image.inf(), ranges[k].begin), (std::min)(image.sup(), ranges[k].end)};
        if (next[k].begin > next[k].end)
          return true;
        is_shorter = is_shorter || next[k].width() < enough * ranges[k].width();
      }
      is_certain = is_certain || is_inside;
      if (!is_shorter) {
        if (is_certain)
          m_crossings.push_back({next, true});
        return is_certain;
      }
      ranges = next;
      for (std::size_t k = 0; k < 2; ++k) {
        const Part part = m_views[k].curve().part(ranges[k]);
        directions[k] = m_views[k].direction(part);
        speeds[k] = part.speed();
        middles[k] = middle_point(k, part);
      }
    }
  }
};

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CROSSING_FINDER_2_H
