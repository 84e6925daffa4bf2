// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_FOOTPOINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_FOOTPOINTS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_branch.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/compared_points.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_branches.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Exact_end_disks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The branches of footpoints over a part of an element that are left when candidates have been pruned, compared with each
other by the curvatures of their disks.
*/
template <Enclosing_number Interval = Common::Interval>
class Disk_footpoints
{
  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  const Element_part<Interval>& m_part;
  const Disk_branches<Interval> m_branches;

public:
  Disk_footpoints(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature, Disk_slopes& slopes,
                  const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates,
                  double least)
    : m_graph(graph), m_curvature(curvature), m_part(part),
      m_branches(graph, curvature, slopes, part, candidates, least)
  {}

  // Whether each branch is a function.
  bool are_known() const { return m_branches.are_known(); }

  // The branches, but for those that are below another one throughout the part. Those that move are the greater one of
  // two footpoints.
  std::vector<Disk_branch> highest() const
  {
    if (m_branches.all().size() < 2)
      return m_branches.all();
    std::vector<std::pair<Disk_branch, std::vector<Curvature_expansion<Interval>>>> highest;
    for (const Disk_branch& branch : m_branches.all()) {
      const std::pair next(branch,
                           branch.move ? std::vector{expansion(branch.move->positive), expansion(branch.move->negative)}
                                       : std::vector{expansion(branch)});
      bool is_below = false;
      for (auto other = highest.begin(); other != highest.end() && !is_below;) {
        const int order = order_over_part(next, *other);
        is_below = order < 0;
        other = order > 0 ? highest.erase(other) : other + 1;
      }
      if (!is_below)
        highest.push_back(next);
    }
    std::vector<Disk_branch> result;
    for (const auto& [branch, curvatures] : highest)
      result.push_back(branch);
    return result;
  }

  int sign_of_move(const Disk_branch& branch, double u) const
  {
    const Element_part<Interval> point = m_curvature.part(m_part.element, {u, u});
    if (branch.move->joined_ends)
      return common_sign(*branch.move->joined_ends, [&](const Arc_end& end) { return m_curvature(point, end).dv; });
    const double v = branch.move->event == Disk_event::TIP ? u : branch.move->parameter;
    return certain_sign(m_curvature(point, branch.move->arc, {v, v}).dv);
  }

  bool is_sign_of_move_monotone(const Disk_branch& branch) const
  {
    if (branch.move->joined_ends)
      return are_footpoints_monotone(branch);
    if (branch.move->event != Disk_event::TIP)
      return certain_sign(
                 m_curvature(m_part, branch.move->arc, {branch.move->parameter, branch.move->parameter}).duv) != 0;
    const Curvature_bounds<Interval> k = m_curvature(m_part, branch.move->arc, m_part.range);
    return certain_sign(k.duv + k.dvv) != 0;
  }

  // Whether the footpoint moves into the end of its arc at the begin or end of the element.
  bool is_move_at_end(const Disk_branch& branch, bool end) const { return exact_end_disks().is_move(branch, end); }

  // Whether two branches have the same curvature at the begin or end of the element, by exact computation. They do not
  // move, or there.
  bool are_equal_at_end(const Disk_branch& a, const Disk_branch& b, bool end) const
  {
    return exact_end_disks().are_equal(a, b, end);
  }

  // Whether the footpoint stays what it is, or goes over into the end of an arc, or into the next arc, at most once in
  // the part.
  bool moves_once(const Disk_branch& branch) const
  {
    return !branch.move ||
        (branch.move->event == Disk_event::JOINT && !branch.move->joined_ends && is_sign_of_move_monotone(branch));
  }

  // What is touched in a point of the part, if that is certain.
  std::optional<Located_footpoint> footpoint_at(const Disk_branch& branch, double u) const
  {
    if (!branch.move)
      return branch;
    const int sign = sign_of_move(branch, u);
    return sign == 0 ? std::nullopt : std::optional(sign > 0 ? branch.move->positive : branch.move->negative);
  }

  // The sign of the difference of the curvatures of two branches.
  int compare(const Disk_branch& a, const Disk_branch& b, double u) const
  {
    const Element_part<Interval> part = m_curvature.part(m_part.element, {u, u});
    const auto x = footpoint_at(a, u), y = footpoint_at(b, u);
    if (!x || !y)
      return 0;
    const auto sign_in = [](const Curvature_expansion<Interval>& difference) {
      return certain_sign(difference.at_middle);
    };
    if (const int order_of_points = sign_in(difference_of_points(m_graph, m_curvature, part, *x, *y));
        order_of_points != 0)
      return order_of_points;
    const int order = certain_sign(maximum(part, *x) - maximum(part, *y));
    return order != 0 ? order : sign_by_tangent_disks(m_graph, m_curvature, part, *x, *y, sign_in);
  }

  // The footpoints that disks have before and after one that touches all of them: their curvature there grows least and
  // most.
  std::optional<std::pair<Disk_branch, Disk_branch>>
  before_and_after_common_disk(const std::vector<Disk_branch>& branches) const
  {
    std::vector<Interval> slopes;
    for (const Disk_branch& branch : branches)
      slopes.push_back(slope(branch));
    const auto first_of = [&](const auto& is_less) {
      for (std::size_t i = 0; i < branches.size(); ++i) {
        std::size_t greater = 0;
        for (std::size_t j = 0; j < branches.size(); ++j)
          greater += i != j && is_less(slopes[i], slopes[j]);
        if (greater + 1 == branches.size())
          return i;
      }
      return branches.size();
    };
    const std::size_t before = first_of([](const Interval&a, const Interval&b) { return a.sup() < b.inf(); }),
                      after = first_of([](const Interval&a, const Interval&b) { return a.inf() > b.sup(); });
    if (before == branches.size() || after == branches.size())
      return std::nullopt;
    return std::pair(branches[before], branches[after]);
  }

  // By the first derivatives, and where these are nearly the same, as for points next to each other, by the second
  // ones.
  bool is_difference_monotone(const Disk_branch& a, const Disk_branch& b) const
  {
    if (!a.move && !b.move && certain_sign(difference_of_points(m_graph, m_curvature, m_part, a, b).slope) != 0)
      return true;
    const auto sign_in = [shift = shift_from_middle()](const Curvature_expansion<Interval>& difference) {
      return certain_sign(difference.derivative(shift));
    };
    return certain_sign(slope(a) - slope(b)) != 0 ||
        (!a.move && !b.move &&
         (sign_in(expansion(a) - expansion(b)) != 0 ||
          sign_by_tangent_disks(m_graph, m_curvature, m_part, a, b, sign_in) != 0));
  }

private:
  Exact_end_disks<Interval> exact_end_disks() const { return {m_graph, m_curvature, m_part.element}; }

  // Which of two branches has the greater curvature throughout the part, 0 if that is not certain.
  int order_over_part(const std::pair<Disk_branch, std::vector<Curvature_expansion<Interval>>>& a,
                      const std::pair<Disk_branch, std::vector<Curvature_expansion<Interval>>>& b) const
  {
    const auto sign_in = [shift = shift_from_middle()](const Curvature_expansion<Interval>& difference) {
      return difference.sign(shift);
    };
    const bool do_move = a.first.move || b.first.move;
    if (const int order = do_move ? 0 : sign_in(difference_of_points(m_graph, m_curvature, m_part, a.first, b.first));
        order != 0)
      return order;
    const auto is_below = [&](const auto& lower, const auto& upper) {
      return std::all_of(lower.begin(), lower.end(), [&](const auto& x) {
        return std::any_of(upper.begin(), upper.end(), [&](const auto& y) { return sign_in(x - y) < 0; });
      });
    };
    if (is_below(a.second, b.second))
      return -1;
    if (is_below(b.second, a.second))
      return 1;
    return do_move ? 0 : sign_by_tangent_disks(m_graph, m_curvature, m_part, a.first, b.first, sign_in);
  }

  // The sign of numbers that belong to two ends, on the way from the arc of the first to that of the second one, if it
  // is the same.
  template <class Number_at>
  static int common_sign(const std::array<Arc_end, 2>& ends, const Number_at& number_at)
  {
    const int first = certain_sign(number_at(ends[0])) * (ends[0].is_end ? 1 : -1),
              second = certain_sign(number_at(ends[1])) * (ends[1].is_end ? -1 : 1);
    return first == second ? first : 0;
  }

  // Whether k_uv has one sign on both arcs: the point where k is greatest moves along them in one direction.
  bool are_footpoints_monotone(const Disk_branch& branch) const
  {
    const auto& [event, arc, parameter, positive, negative, ends, between] = *branch.move;
    return common_sign(*ends, [&, &ends = ends, &negative = negative, &positive = positive](const Arc_end& end) {
      const Range& range = (end == (*ends)[0] ? negative : positive).range;
      return m_curvature(m_part, end.arc, range).duv;
    }) != 0;
  }

  Interval slope(const Disk_branch& branch) const
  {
    const auto slope_with = [&](const Located_footpoint& footpoint) {
      return slope_of_largest_curvature(m_graph, m_curvature, m_part, footpoint);
    };
    return branch.move ? hull(slope_with(branch.move->negative), slope_with(branch.move->positive))
                       : slope_with(branch);
  }

  Interval maximum(const Element_part<Interval>& part, const Located_footpoint& footpoint) const
  {
    return largest_curvature(m_graph, m_curvature, part, footpoint).curvature;
  }

  Interval shift_from_middle() const { return interval_of<Interval>(m_part.range) - Interval(m_part.range.middle()); }

  Curvature_expansion<Interval> expansion(const Located_footpoint& footpoint) const
  {
    return curvature_expansion(m_graph, m_curvature, m_part, footpoint);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_FOOTPOINTS_H
