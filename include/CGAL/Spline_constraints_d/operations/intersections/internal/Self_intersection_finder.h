// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SELF_INTERSECTION_FINDER_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SELF_INTERSECTION_FINDER_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/arc_directions.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/meeting_boxes.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Simple_arcs.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finder_declarations.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/irrational_multiple_root.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
Where a curve meets itself: the common points of each two of its simple arcs. An arc is without its end if another one
follows, so that what is in an end of arcs is found once.
*/
template <int d>
class Self_intersection_finder
{
  Parameter_range m_domain;
  Budgeted_solver& m_solve;
  Simple_arcs<d> m_arcs;

public:
  Self_intersection_finder(const Spline_patch<d>& curve, Budgeted_solver& solve)
    : m_domain(curve.domain(0)), m_solve(solve), m_arcs(curve, solve)
  {}

  std::vector<Common_point> operator()()
  {
    std::vector<Common_point> result;
    for (const Spline_patch<d>& part : m_arcs.others())
      result.push_back(all_pairs_of(part));
    const std::vector<Index_pair> pairs = pairs_that_may_meet();
    for (auto pair = pairs.begin(); pair != pairs.end(); ++pair) {
      if (m_solve.has_ended()) {
        append_rest({pair, pairs.end()}, result);
        break;
      }
      const auto& [i, j] = *pair;
      for (Common_point& point :
           Intersection_finder<d>(Patch_pair<d>(m_arcs[i], m_arcs[j], {has_next(i), has_next(j)}), m_solve)())
        if (!is_joint(point, i, j))
          result.push_back(on_whole_curve(std::move(point), {i, j}));
    }
    std::sort(result.begin(), result.end(),
              [](const Common_point& x, const Common_point& y) { return x.parameters < y.parameters; });
    remove_repetitions(result);
    return result;
  }

private:
  // What stands for pairs of arcs that are not looked at: one answer for all of those with the same lower one.
  void append_rest(std::span<const Index_pair> rest, std::vector<Common_point>& result) const
  {
    while (!rest.empty()) {
      const auto [i, first] = rest.front();
      std::size_t last = first, count = 0;
      for (; count < rest.size() && rest[count].first == i; ++count)
        last = rest[count].second;
      result.push_back(undecided_common_point(
          {m_arcs[i].domain(0), {m_arcs[first].domain(0).first, m_arcs[last].domain(0).second}}, m_solve.reason()));
      rest = rest.subspan(count);
    }
  }

  // The arcs that are not proved to be apart, the lower one first.
  std::vector<Index_pair> pairs_that_may_meet() const
  {
    std::vector<Spline_patch<d>> patches;
    std::vector<Exact_vector<d>> chords;
    for (std::size_t i = 0; i < m_arcs.size(); ++i) {
      patches.push_back(m_arcs[i]);
      chords.push_back(chord_of(m_arcs[i]));
    }
    std::vector<Index_pair> result = pairs_with_meeting_boxes(patches);
    std::erase_if(result, [&](const Index_pair& pair) {
      m_solve.budget().check();
      const auto& [i, j] = pair;
      return m_arcs.are_apart(i, j) || are_separated<d>(patches[i], patches[j], chords[i], chords[j]);
    });
    return result;
  }

  // Where arcs touch in their ends, more than one pair of arcs may have found that; or it is on an overlap, such as an
  // end of it.
  static void remove_repetitions(std::vector<Common_point>& points)
  {
    const auto are_same = [&](const Common_point& x, const Common_point& y) {
      return is_one(x) && is_one(y) && x.parameters == y.parameters && !has_extent(x.parameters);
    };
    points.erase(std::unique(points.begin(), points.end(), are_same), points.end());
    std::vector<Parameter_box> overlaps;
    for (const Common_point& point : points)
      if (point.kind == Intersection_kind::OVERLAP && point.solution && !point.solution->ends().empty())
        overlaps.push_back(point.parameters);
    std::erase_if(points, [&](const Common_point& x) {
      return is_one(x) && std::any_of(overlaps.begin(), overlaps.end(), [&](const Parameter_box& overlap) {
               return contains(overlap, x.parameters);
             });
    });
  }

  static bool is_one(const Common_point& x)
  {
    return x.kind != Intersection_kind::OVERLAP && x.kind != Intersection_kind::UNDECIDED;
  }

  bool has_next(std::size_t arc) const { return m_arcs.next(arc).has_value(); }

  // A part that is not simple. If it is a point, all pairs of its parameters stand for it.
  static Common_point all_pairs_of(const Spline_patch<d>& part)
  {
    const Intersection_kind kind = part.is_one_point() ? Intersection_kind::OVERLAP : Intersection_kind::UNDECIDED;
    return {kind, {part.domain(0), part.domain(0)}, {false, false}, std::nullopt, false};
  }

  // A common point of two arcs as one of the curve, whose ends are not those of the arcs.
  Common_point on_whole_curve(Common_point point, const std::array<std::size_t, 2>& arcs) const
  {
    bool is_corner = false;
    for (std::size_t k : {0, 1}) {
      const Exact_rational& value = point.parameters[k].first;
      is_corner = is_corner || (point.is_at_end[k] && has_corner_at_begin(arcs[k], value));
      point.is_at_end[k] = point.is_at_end[k] && (value == m_domain.first || value == m_domain.second);
    }
    if (point.kind == Intersection_kind::END_POINT && !point.is_at_end[0] && !point.is_at_end[1])
      point.kind = is_corner ? Intersection_kind::TANGENT : Intersection_kind::TRANSVERSAL;
    if (point.kind != Intersection_kind::OVERLAP && may_be_joint(point, arcs[0], arcs[1]))
      point = {Intersection_kind::UNDECIDED, point.parameters, {false, false}, point.solution, false};
    return point;
  }

  // Whether a parameter is the begin of an arc where the direction jumps.
  bool has_corner_at_begin(std::size_t arc, const Exact_rational& parameter) const
  {
    const auto [begin, end] = m_arcs[arc].domain(0);
    const std::optional<std::size_t> previous = m_arcs.previous(arc);
    if (parameter != begin || !previous)
      return false;
    const Spline_patch<d>& before = m_arcs[*previous];
    return !have_same_direction<d>(before.one_sided_tangent(0, before.domain(0), 1),
                                   m_arcs[arc].one_sided_tangent(0, {begin, end}, 0));
  }

  // Whether what was found is the end of an arc that is the begin of the other one, and nothing else.
  bool is_joint(const Common_point& point, std::size_t i, std::size_t j) const
  {
    return is_one(point) && !has_extent(point.parameters) && may_be_joint(point, i, j);
  }

  bool may_be_joint(const Common_point& point, std::size_t i, std::size_t j) const
  {
    return holds_common_end(point, i, j) || holds_common_end(point, j, i);
  }

  // Whether what was found may be the end of an arc that is the begin of the other one.
  bool holds_common_end(const Common_point& point, std::size_t first, std::size_t second) const
  {
    if (m_arcs.next(first) != second)
      return false;
    const bool is_in_order = first < second;
    const Parameter_range &at_end = point.parameters[is_in_order ? 0 : 1],
                          &at_begin = point.parameters[is_in_order ? 1 : 0];
    return at_end.second == m_arcs[first].domain(0).second && at_begin.first == m_arcs[second].domain(0).first;
  }
};

template <int d>
std::vector<Common_point> self_common_points(const Spline_patch<d>& curve, Budgeted_solver& solve)
{
  try {
    std::vector<Common_point> result = Self_intersection_finder<d>(curve, solve)();
    if constexpr (d == 2)
      decide_passages(Patch_pair<2>(curve, curve), result, solve);
    return result;
  } catch (const Run_stopped& stop) { // before there were arcs
    return {undecided_common_point({curve.domain(0), curve.domain(0)}, stop.reason)};
  }
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SELF_INTERSECTION_FINDER_H
