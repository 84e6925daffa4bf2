// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEEP_MEMBERSHIP_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEEP_MEMBERSHIP_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/internal/offset_piece.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_site.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_boundary.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/solid/Solid_membership.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// Tells, with proof, when a point lies in a moving solid: its path, seen from the solid, enters and leaves through the
// boundary, where a moved patch T(u, v, t) is the point.
class Sweep_membership
{
  using Point = std::array<Exact_rational, 3>;
  using Point_3 = Rational_motion_3::Kernel::Point_3;
  using Range = std::pair<Exact_rational, Exact_rational>;
  using Times = std::vector<Range>;

  using Passage = Solid_membership::Passage;

  const Solid_boundary& m_boundary;
  const Rational_motion_3& m_motion;
  Common::Operation_budget& m_budget;
  Solid_membership m_solid;

public:
  Sweep_membership(const Solid_boundary& boundary, const Rational_motion_3& motion, Common::Operation_budget& budget)
    : m_boundary(boundary), m_motion(motion), m_budget(budget), m_solid(boundary, budget)
  {}

  bool must_stop() { return m_budget.must_stop(); }

  // Whether the solid has one boundary, so that what it sweeps is connected.
  bool is_connected() const
  {
    for (std::size_t patch = 0; patch < m_boundary.size(); ++patch)
      if (m_boundary.component(patch) != m_boundary.component(0))
        return false;
    return true;
  }

  // See Solid_membership.
  std::optional<std::vector<bool>> has_outer_normals(bool has_positive_maps)
  {
    return m_solid.has_outer_normals(has_positive_maps);
  }

  // Whether it does so at any time; nothing, where that was not decided. One proved passage of the boundary is enough.
  std::optional<bool> operator()(const Point& point)
  {
    bool is_decided = true;
    for (const Solid_boundary::Patch& patch : m_boundary.patches()) {
      const std::optional<std::vector<Passage>> passages = m_solid.passages_through(passage_system(patch, point));
      if (passages && !passages->empty())
        return true;
      is_decided = is_decided && passages;
    }
    return is_decided ? is_inside_at(m_motion.domain().first, point) : std::nullopt;
  }

  // Whether it is proved of all points of a segment that they are swept, or that they are not.
  // \pre It is so at its ends.
  bool is_swept_along(const Point& from, const Point& to, bool is_inside)
  {
    return is_inside ? is_covered(from, to) : is_free(from, to);
  }

  // The intervals of time at which it does, by enclosures of their ends; nothing, where they were not decided.
  std::optional<Times> intervals(const Point& point)
  {
    const std::optional<Times> times = times_on_boundary(point);
    if (!times)
      return std::nullopt;
    const auto [begin, end] = m_motion.domain();
    const std::optional<bool> is_inside = is_inside_at(begin, point);
    if (!is_inside)
      return std::nullopt;
    Times result;
    std::vector<Exact_rational> ends;
    if (*is_inside)
      ends.push_back(begin);
    for (const auto& time : *times)
      ends.push_back(Exact_rational((time.first + time.second) / 2));
    if (ends.size() % 2 == 1)
      ends.push_back(end);
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
      result.emplace_back(ends[i], ends[i + 1]);
    return result;
  }

private:
  // Whether the solid covers the segment at a time in the middle of those at which it covers the first point.
  bool is_covered(const Point& from, const Point& to)
  {
    const std::optional<Times> times = intervals(from);
    if (!times)
      return false;
    return std::any_of(times->begin(), times->end(), [&](const Range& time) {
      const auto map = m_motion.inverse(Exact_rational((time.first + time.second) / 2));
      const auto seen = [&](const Point& p) { return map.transform(Point_3(p[0], p[1], p[2])); };
      const Point_3 first = seen(from);
      return m_solid.is_inside(first) == true &&
          m_solid.hits_on_ray(first, seen(to) - first, Exact_rational(1)) == std::size_t(0);
    });
  }

  // Whether no position of the boundary meets the segment.
  bool is_free(const Point& from, const Point& to)
  {
    constexpr std::size_t most_nodes = 20000;
    return std::all_of(m_boundary.patches().begin(), m_boundary.patches().end(), [&](const auto& patch) {
      if (m_budget.must_stop())
        return false;
      Solver_options options = m_budget.remaining();
      if (options.node_limit == 0 || options.node_limit > most_nodes)
        options.node_limit = most_nodes;
      const Exact_ranges box{
          patch.domain(0), patch.domain(1), m_motion.domain(), {Exact_rational(0), Exact_rational(1)}};
      Constraint_system_d system(box);
      const std::vector<Unknown> x = unknowns_in(box);
      const Vector_expression<3> moved = image(patch, x);
      for (std::size_t i = 0; i < 3; ++i)
        system.add(moved[i] - x[3] * Exact_rational(to[i] - from[i]) == from[i]);
      const Curve_solution_set_d meetings = Curve_solver_d(options)(system);
      m_budget.add(meetings.summary());
      return meetings.is_complete() && meetings.curves().empty();
    });
  }

  // When the boundary passes the point, one time after the other; nothing, unless it surely goes through each time: in
  // one patch alone, or in an edge, where two passages at one time are one, and the solid is on one side of it.
  std::optional<Times> times_on_boundary(const Point& point)
  {
    std::vector<Passage> passages;
    for (const Solid_boundary::Patch& patch : m_boundary.patches()) {
      const auto own = m_solid.passages_through(passage_system(patch, point));
      if (!own)
        return std::nullopt;
      passages.insert(passages.end(), own->begin(), own->end());
    }
    std::sort(passages.begin(), passages.end(), [](const auto& a, const auto& b) { return a.range < b.range; });
    const auto [begin, end] = m_motion.domain();
    Times result;
    for (std::size_t i = 0; i < passages.size();) {
      std::size_t next = i + 1;
      Range range = passages[i].range;
      for (; next < passages.size() && passages[next].range.first <= range.second; ++next)
        range.second = (std::max)(range.second, passages[next].range.second);
      if (next > i + 2 || (next == i + 1 && !passages[i].is_inside_of_patch) || range.first <= begin ||
          range.second >= end)
        return std::nullopt;
      if (next == i + 2) {
        const std::optional<bool> before = is_inside_between(result.empty() ? nullptr : &result.back(), &range, point);
        const std::optional<bool> after =
            is_inside_between(&range, next < passages.size() ? &passages[next].range : nullptr, point);
        if (!before || !after || *before == *after)
          return std::nullopt;
      }
      result.push_back(range);
      i = next;
    }
    return result;
  }

  // Between two passages, or an end of all times; nothing too if there is no time between them.
  std::optional<bool> is_inside_between(const Range* before, const Range* after, const Point& point)
  {
    const auto [begin, end] = m_motion.domain();
    const Exact_rational first = before ? before->second : begin, last = after ? after->first : end;
    if (!(first < last))
      return std::nullopt;
    return is_inside_at(Exact_rational((first + last) / 2), point);
  }

  Constraint_system_d passage_system(const Solid_boundary::Patch& patch, const Point& point) const
  {
    const Exact_ranges box{patch.domain(0), patch.domain(1), m_motion.domain()};
    Constraint_system_d system(box);
    const std::vector<Unknown> x = unknowns_in(box);
    const Vector_expression<3> moved = image(patch, x);
    for (std::size_t i = 0; i < 3; ++i)
      system.add(moved[i] == point[i]);
    return system;
  }

  std::optional<bool> is_inside_at(const Exact_rational& time, const Point& point)
  {
    return m_solid.is_inside(m_motion.inverse(time).transform(Point_3(point[0], point[1], point[2])));
  }

  Vector_expression<3> image(const Solid_boundary::Patch& patch, const std::vector<Unknown>& x) const
  {
    const Vector_expression<3> point = Common::Parametric_vector<3>(patch)(std::span(x).first(2));
    const auto column = [&](std::size_t k) { return Spline_map<1, 3>(m_motion.columns()[k], m_motion.weight())(x[2]); };
    return column(0) * point[0] + column(1) * point[1] + column(2) * point[2] + column(3);
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_SWEEP_MEMBERSHIP_H
