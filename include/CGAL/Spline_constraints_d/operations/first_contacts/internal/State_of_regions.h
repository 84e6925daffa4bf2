// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_STATE_OF_REGIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_STATE_OF_REGIONS_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/Rational_motion_2.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/Contact_2.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finders.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Region_boundaries_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace First_contacts {

// The boundaries at a time, with the region on the left.
inline std::vector<Boundary_loop_2> moved(const std::vector<Boundary_loop_2>& loops, const Rational_motion_2& motion,
                                          const Exact_rational& time)
{
  const auto map = motion(time);
  std::vector<Boundary_loop_2> result;
  for (const Boundary_loop_2& loop : loops) {
    std::vector<Boundary_piece> pieces = loop.pieces();
    for (Boundary_piece& piece : pieces) {
      auto& [x, y, w] = piece.coordinates;
      const auto image = [&, &x = x, &y = y, &w = w](int i) {
        return x * map.m(i, 0) + y * map.m(i, 1) + w * map.m(i, 2);
      };
      auto moved_x = image(0), moved_y = image(1);
      x = std::move(moved_x);
      y = std::move(moved_y);
    }
    result.emplace_back(std::move(pieces));
    if (!motion.keeps_orientation())
      result.back().reverse();
  }
  return result;
}

/*
How two regions lie to each other that do not move.

They overlap if a point of one boundary is inside of the other region, if boundaries cross, or if they have a part in
common and run through it in the same direction. Or else, with all common points known, each boundary is outside of the
other region or touches it.
*/
class State_of_regions
{
  std::array<const std::vector<Boundary_loop_2>*, 2> m_regions;
  Budgeted_solver& m_solve;

  std::array<std::vector<std::pair<double, double>>, 2> m_boxes;

  // Of both regions, of each boundary, where it is known to meet one of the other region.
  std::array<std::vector<std::vector<Parameter_range>>, 2> m_common;

public:
  State_of_regions(const std::vector<Boundary_loop_2>& a, const std::vector<Boundary_loop_2>& b, Budgeted_solver& solve)
    : m_regions{&a, &b}, m_solve(solve)
  {
    for (const std::size_t k : {0, 1})
      for (const Boundary_loop_2& loop : *m_regions[k])
        for (const Boundary_piece& piece : loop.pieces())
          m_boxes[k] = united_box(std::move(m_boxes[k]), piece.box());
  }

  Contact_state operator()()
  {
    if (overlap_at_some_points())
      return Contact_state::OVERLAPPING;
    bool is_decided = true, do_touch = false;
    const bool do_cross = is_any_common_point([&](const Common_point& point, const auto& a, const auto& b) {
      const std::optional<bool> do_overlap = overlap_at(point, a, b);
      is_decided = is_decided && do_overlap;
      do_touch = do_touch || point.kind != Intersection_kind::UNDECIDED;
      return do_overlap && *do_overlap;
    });
    if (do_cross)
      return Contact_state::OVERLAPPING;
    for (const std::size_t k : {0, 1})
      for (const Exact_pair& point : points_between_common_points(k))
        if (is_inside(point, 1 - k))
          return Contact_state::OVERLAPPING;
    if (m_solve.has_ended() || !is_decided)
      return Contact_state::UNDECIDED;
    return do_touch ? Contact_state::TOUCHING : Contact_state::APART;
  }

  // Some points of a region, on its boundary or within, that are inside of the other one.
  std::vector<Exact_pair> inner_points(std::size_t region)
  {
    constexpr std::size_t enough = 8, tries = 64;
    std::vector<Exact_pair> candidates, result;
    for (const Boundary_loop_2& loop : *m_regions[region])
      for (const Boundary_piece& piece : loop.pieces())
        for (const Exact_rational& t : {Exact_rational(0), Exact_rational(Exact_rational(1) / 2)})
          if (candidates.size() < tries)
            candidates.push_back(piece.at(t));
    const std::size_t number_on_boundary = candidates.size();
    for (std::size_t i = 0; i < number_on_boundary; ++i)
      for (std::size_t k = 0; k < i && candidates.size() < 2 * tries; ++k)
        candidates.push_back({Exact_rational((candidates[i][0] + candidates[k][0]) / 2),
                              Exact_rational((candidates[i][1] + candidates[k][1]) / 2)});
    for (std::size_t i = 0; i < candidates.size() && result.size() < enough && !m_solve.has_ended(); ++i)
      if (is_inside(candidates[i], 1 - region) && (i < number_on_boundary || is_inside(candidates[i], region)))
        result.push_back(candidates[i]);
    if (!result.empty())
      return result;
    is_any_common_point([](const auto&...) { return false; });
    for (const Exact_pair& point : points_between_common_points(region))
      if (is_inside(point, 1 - region))
        result.push_back(point);
    return result;
  }

private:
  bool is_inside(const Exact_pair& point, std::size_t region) const
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (const auto [lower, upper] = to_double_interval(point[axis]);
          upper < m_boxes[region][axis].first || m_boxes[region][axis].second < lower)
        return false;
    return bounded_side(*m_regions[region], point) == CGAL::ON_BOUNDED_SIDE;
  }

  // Where boundaries do not meet, the first point tells on which side of the other ones each is. Some more find most
  // overlaps without the common points.
  bool overlap_at_some_points() const
  {
    constexpr std::size_t enough = 16;
    for (const std::size_t k : {0, 1})
      for (const Boundary_loop_2& loop : *m_regions[k])
        for (std::size_t i = 0; i < loop.pieces().size(); i += 1 + loop.pieces().size() / enough)
          if (!m_solve.has_ended() && is_inside(loop.pieces()[i].at(Exact_rational(0)), 1 - k))
            return true;
    return false;
  }

  static std::vector<std::pair<double, double>> box_of(const Boundary_loop_2& loop)
  {
    std::vector<std::pair<double, double>> result;
    for (const Boundary_piece& piece : loop.pieces())
      result = united_box(std::move(result), piece.box());
    return result;
  }

  static bool have_meeting_boxes(const Boundary_loop_2& a, const Boundary_loop_2& b)
  {
    const auto first = box_of(a), second = box_of(b);
    for (std::size_t axis = 0; axis < 2; ++axis)
      if (first[axis].second < second[axis].first || second[axis].second < first[axis].first)
        return false;
    return true;
  }

  // Whether the regions overlap next to a common point or part for certain, or what is between common points tells;
  // nothing, where that is not decided.
  static std::optional<bool> overlap_at(const Common_point& point, const Boundary_loop_2& a, const Boundary_loop_2& b)
  {
    if (point.kind == Intersection_kind::OVERLAP)
      return run_through_alike(point.parameters, a, b);
    if (point.passage && *point.passage != Passage::TOUCHES_OR_CROSSES)
      return *point.passage == Passage::CROSSES;
    if (!point.passage && point.kind == Intersection_kind::TRANSVERSAL)
      return true;
    const bool is_one_point = (point.solution && point.solution->is_certified()) ||
        (point.kind != Intersection_kind::UNDECIDED &&
         std::ranges::all_of(point.parameters, [](const auto& range) { return range.first == range.second; }));
    return is_one_point ? std::optional(false) : std::nullopt;
  }

  // Whether boundaries run through a common part in the same direction, by its ends.
  static std::optional<bool> run_through_alike(const Parameter_box& ranges, const Boundary_loop_2& a,
                                               const Boundary_loop_2& b)
  {
    const Exact_pair begin = a.at(ranges[0].first), end = a.at(ranges[0].second), other_begin = b.at(ranges[1].first),
                     other_end = b.at(ranges[1].second);
    if (begin == end) // all of both boundaries
      return a.is_counterclockwise() == b.is_counterclockwise();
    if (begin == other_begin && end == other_end)
      return true;
    return begin == other_end && end == other_begin ? std::optional(false) : std::nullopt;
  }

  // Whether a function is true of a common point of two boundaries; it is asked of no more then. The points are kept.
  template <class Function>
  bool is_any_common_point(const Function& function)
  {
    for (std::size_t k : {0, 1})
      m_common[k].assign(m_regions[k]->size(), {});
    for (std::size_t i = 0; i < m_regions[0]->size(); ++i)
      for (std::size_t k = 0; k < m_regions[1]->size(); ++k) {
        const Boundary_loop_2 &a = (*m_regions[0])[i], &b = (*m_regions[1])[k];
        if (m_solve.has_ended() || !have_meeting_boxes(a, b))
          continue;
        const Spline_patch<2> first(a.curve()), second(b.curve());
        for (const Common_point& point : common_points<2>(Patch_pair<2>(first, second), m_solve)) {
          m_common[0][i].push_back(point.parameters[0]);
          m_common[1][k].push_back(point.parameters[1]);
          if (function(point, a, b))
            return true;
        }
      }
    return false;
  }

  // Points of boundaries of a region, one between each two common points; none of a boundary without common points.
  std::vector<Exact_pair> points_between_common_points(std::size_t region) const
  {
    std::vector<Exact_pair> result;
    for (std::size_t i = 0; i < m_regions[region]->size(); ++i) {
      const Boundary_loop_2& loop = (*m_regions[region])[i];
      std::vector<Parameter_range> ranges = m_common[region][i];
      if (ranges.empty())
        continue;
      const Exact_rational end(static_cast<unsigned long>(loop.pieces().size()));
      ranges.emplace_back(end, end);
      std::sort(ranges.begin(), ranges.end());
      Exact_rational last(0);
      for (const auto& [first, second] : ranges) {
        if (last < first)
          result.push_back(loop.at(Exact_rational((last + first) / 2)));
        last = (std::max)(last, second);
      }
    }
    return result;
  }
};

} // namespace First_contacts
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_FIRST_CONTACTS_INTERNAL_STATE_OF_REGIONS_H
