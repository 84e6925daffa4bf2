// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CROSSING_FINDER_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CROSSING_FINDER_2_H

#include <CGAL/Spline_constraints_d/operations/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/Traced_curve_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline bool may_meet(const Interval& a, const Interval& b) { return a.inf() <= b.sup() && b.inf() <= a.sup(); }
inline bool may_meet(const Interval_pair& a, const Interval_pair& b) { return may_meet(a[0], b[0]) && may_meet(a[1], b[1]); }

// Ranges of the parameters of two curves: with exactly one common point, where they cross; or not decided.
struct Crossing_2
{
  std::array<Range, 2> ranges;
  bool is_certain;
};

/*
Where two curves cross, by subdivision of both. Parts are discarded if a line separates them. The derivatives of two parts that have no common direction have one common point at most, and Newton's
method with intervals finds it, or proves that there is none.
*/
class Crossing_finder_2
{
  using Part = Traced_curve_2::Part;
  using Pair = std::array<const Part*, 2>;
  static constexpr std::size_t most_steps = 4000, most_undecided = 64;
  static constexpr double least_width = 0x1p-44;

  std::array<Traced_view_2, 2> m_views;
  std::optional<std::array<int, 2>> m_common_end;   // one curve goes on as the other one: which ends (0 or 1) are the same
  bool m_is_first_enough;
  std::vector<Crossing_2> m_crossings;

public:
  Crossing_finder_2(const Traced_view_2& first, const Traced_view_2& second, std::optional<std::array<int, 2>> common_end = std::nullopt, bool is_first_enough = false)
    : m_views{first, second}, m_common_end(common_end), m_is_first_enough(is_first_enough)
  {}

  // All crossings; or, on request, a certain one alone, if one is found. Where there are too many steps, one undecided crossing for all.
  std::vector<Crossing_2> operator()()
  {
    const Pair whole{&m_views[0].curve().whole(), &m_views[1].curve().whole()};
    std::deque<Pair> todo{whole};   // large parts first: what is certain is found before what has to be cut again and again
    for (std::size_t steps = 0; !todo.empty() && !is_done(); ++steps) {
      if (steps > most_steps || m_crossings.size() > most_undecided)
        return {{{whole[0]->range(), whole[1]->range()}, false}};
      const Pair parts = todo.front();
      todo.pop_front();
      if (!are_separated(parts) && !are_joined(parts) && !solve_by_newton(parts))
        cut(parts, todo);
    }
    return m_crossings;
  }

private:
  bool is_done() const { return m_is_first_enough && !m_crossings.empty() && m_crossings.back().is_certain; }

  // Into halves of the larger part, or an undecided crossing where both are tiny.
  void cut(const Pair& parts, std::deque<Pair>& todo)
  {
    const auto is_tiny = [&](std::size_t k) { return parts[k]->range().width() <= least_width; };
    if (is_tiny(0) && is_tiny(1)) {
      m_crossings.push_back({{parts[0]->range(), parts[1]->range()}, false});
      return;
    }
    const std::size_t k = is_tiny(0) || (!is_tiny(1) && extent(*parts[0]) < extent(*parts[1]));
    for (const Part& half : m_views[k].curve().halves(*parts[k])) {
      todo.push_back(parts);
      todo.back()[k] = &half;
    }
  }

  static double extent(const Part& part) { return (std::max)(part.box()[0].sup() - part.box()[0].inf(), part.box()[1].sup() - part.box()[1].inf()); }
  // Some vector within bounds; zero where these are not finite.
  static Interval_pair middle_of(const Interval_pair& v)
  {
    const double x = v[0].inf() / 2 + v[0].sup() / 2, y = v[1].inf() / 2 + v[1].sup() / 2;
    return std::isfinite(x) && std::isfinite(y) ? Interval_pair{Interval(x), Interval(y)} : Interval_pair{Interval(0), Interval(0)};
  }

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

  // By a line parallel to an axis or about tangential to one of the curves, whose points are middle + tangent * s by the mean value theorem.
  bool are_separated(const Pair& parts) const
  {
    if (!may_meet(m_views[0].box(*parts[0]), m_views[1].box(*parts[1])))
      return true;
    const std::array<Interval_pair, 2> tangents{m_views[0].tangent(*parts[0]), m_views[1].tangent(*parts[1])};
    if (!has_middle(0, parts[0]->range()) || !has_middle(1, parts[1]->range()))
      return false;
    const Interval_pair between = m_views[0].middle_point(*parts[0]) - m_views[1].middle_point(*parts[1]);
    const auto step = [&](std::size_t k) { return parts[k]->range().interval() - Interval(parts[k]->range().middle()); };
    return std::any_of(tangents.begin(), tangents.end(), [&](const Interval_pair& tangent) {
      const Interval_pair normal = turned_left(middle_of(tangent));
      return certain_sign(dot(normal, between) + dot(normal, tangents[0]) * step(0) - dot(normal, tangents[1]) * step(1)) != 0;
    });
  }

  // Whether the parts are next to a common end, and go on along a common direction there.
  bool are_joined(const Pair& parts) const
  {
    if (!m_common_end)
      return false;
    for (std::size_t k = 0; k < 2; ++k)
      if (const Range &part = parts[k]->range(), &whole = m_views[k].curve().range(); (*m_common_end)[k] == 0 ? part.begin != whole.begin : part.end != whole.end)
        return false;
    const Interval_pair first = m_views[0].tangent(*parts[0]), second = m_views[1].tangent(*parts[1]), direction = unit_vector(middle_of(first)) + unit_vector(middle_of(second));
    return certain_sign(dot(direction, first)) > 0 && certain_sign(dot(direction, second)) > 0;
  }

  // Returns whether it is decided if the parts cross.
  bool solve_by_newton(const Pair& parts)
  {
    constexpr double enough = 0.75;
    std::array<Range, 2> ranges{parts[0]->range(), parts[1]->range()};
    std::array<Interval_pair, 2> tangents{m_views[0].tangent(*parts[0]), m_views[1].tangent(*parts[1])}, middles{m_views[0].middle_point(*parts[0]), m_views[1].middle_point(*parts[1])};
    for (bool is_certain = false;;) {
      const Interval determinant = cross(tangents[0], tangents[1]);
      if (certain_sign(determinant) == 0 || !has_middle(0, ranges[0]) || !has_middle(1, ranges[1]))
        return false;
      const Interval_pair between = middles[1] - middles[0];
      const std::array<Interval, 2> steps{cross(between, tangents[1]) / determinant, cross(between, tangents[0]) / determinant};
      bool is_inside = true, is_shorter = false;
      std::array<Range, 2> next;
      for (std::size_t k = 0; k < 2; ++k) {
        const Interval image = Interval(ranges[k].middle()) + steps[k];
        const Range& inner = m_views[k].curve().inner_range();
        is_inside = is_inside && ranges[k].begin < image.inf() && image.sup() < ranges[k].end && inner.begin <= ranges[k].begin && ranges[k].end <= inner.end;
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
        tangents[k] = m_views[k].tangent(part);
        middles[k] = m_views[k].middle_point(part);
      }
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CROSSING_FINDER_2_H
