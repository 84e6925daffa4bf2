// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MAXIMAL_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MAXIMAL_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Disk_candidates.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Element_tangent.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Fine_level.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Corner_pocket.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Corner_tip.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_footpoints.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Envelope_arc.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Swept_envelope.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/common_disks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The largest disks that touch an element and have no curve inside. Where u runs along the element their curvature is the
upper envelope of max_v k(u,v) over all arcs, and 0: a function of one variable, whose pieces and the events between
these are proved as follows.

A range of u is split until little is left of the arcs that can reach the envelope, and all of it is known to have at
most one maximum in v each, for all u (k_vv < 0). If there is one, the range belongs to one envelope arc. If there are
two, and the derivative of the difference has a sign, the signs of the difference at both ends tell whether they change
places, just once. In the same way the sign of k_v at the end of an arc tells whether the maximum is in the arc or in
the end; and that at v = u, whether the disk touches the element before or after u: there is a tip of the diagram
between.

What doubles cannot decide is swept once more with numbers of higher precision, in the end over ranges of the least
width. What these cannot decide is left unresolved, and so is what is left when the search is ended from outside.
*/
template <Enclosing_number Interval = Common::Interval>
class Maximal_disks
{
  using Interval_pair = std::array<Interval, 2>;

  static constexpr double split_ratio = 0.48291015625;   // no place where drawings have vertices
  static constexpr bool is_in_doubles = std::same_as<Interval, CGAL::Interval_nt<false>>;
  // of parts; normals of a small normal cone differ by less than doubles show
  static constexpr double least_width = is_in_doubles ? 0x1p-39 : 0x1p-52,
                          least_width_in_joint = is_in_doubles ? 0x1p-6 : least_width;
  static constexpr unsigned ranges_between_checks = is_in_doubles ? 8 : 1;
  static constexpr double exact_width = 0x1p-24;         // of parts where events that coincide are decided exactly
  // of ranges that hold an event: doubles know some no better than that, but mostly those of smaller parts do
  static constexpr double widest_event = 0x1p-12;
  static constexpr double most_corner = 0x1p-30;         // of an envelope arc of which nothing is known but its ends
  // small ones, unresolved, before less is done for the rest of an element
  static constexpr int most_places = 4;
  // the latter where curves are known to touch or overlap, and that is not settled
  static constexpr int most_nodes = 50000, most_unproved_nodes = 200;
  // of candidates: what was proved in surveys needed 523,121 at most
  static constexpr std::size_t most_bounds = 1500000;

  template <Enclosing_number Other>
  friend class Maximal_disks;

  const Site_graph_2<Interval>& m_graph;
  const Site_tree_2& m_tree;
  Disk_curvature<Interval> m_curvature;
  const Cusps_2* m_cusps;
  Disk_candidates<Interval> m_candidates;
  const Fine_level* m_fine_level;   // none on that level
  Disk_slopes* m_slopes = nullptr;   // of the element
  Search_control* m_control;             // none: nothing ends the search
  Regular_check m_check;
  Swept_envelope m_swept;
  double m_begin_of_rest = 0;            // of the element: what is behind it has not been swept
  double m_size = 1;   // of the element: that of its arc, as a part of that of everything
  int m_nodes = 0, m_most_nodes = most_nodes, m_fine_nodes = 0, m_places = 0;
  std::size_t m_most_bounds = most_bounds, m_fine_bounds = 0;

public:
  Maximal_disks(const Site_graph_2<Interval>& graph, const Site_tree_2& tree, const Cusps_2& cusps,
                const Fine_level* fine_level = nullptr, Search_control* control = nullptr)
    : Maximal_disks<Interval>(graph, tree, Disk_curvature<Interval>(graph), &cusps, fine_level, control)
  {}

  // With scaled sites. Where no disk touches these, footpoints are not told apart: they are said to be with nothing.
  Maximal_disks(const Site_graph_2<Interval>& graph, const Site_tree_2& tree, const Disk_curvature<Interval>& curvature,
                const Cusps_2* cusps = nullptr, const Fine_level* fine_level = nullptr,
                Search_control* control = nullptr)
    : m_graph(graph), m_tree(tree), m_curvature(curvature), m_cusps(cusps),
      m_candidates(graph, tree, curvature, cusps, control), m_fine_level(fine_level), m_control(control),
      m_check(control, ranges_between_checks)
  {}

  // The envelope arcs of an element in order; none if nothing could be resolved.
  std::vector<Envelope_arc> operator()(std::size_t element) requires(is_in_doubles)
  {
    Disk_slopes slopes(m_graph, element);
    m_slopes = &slopes;
    m_size = m_graph.elements()[element].is_normal_cone
        ? 1
        : std::sqrt(m_tree.squared_size(m_graph.elements()[element].object) / m_tree.squared_size());
    m_swept = {};
    m_nodes = 0;
    m_most_nodes = m_graph.is_proved() ? most_nodes : most_unproved_nodes;
    m_most_bounds = m_candidates.number_of_bounds() + most_bounds;
    m_fine_nodes = 0;
    m_fine_bounds = 0;
    m_places = 0;
    Range range;
    for (const bool end : {false, true})
      if (const auto* cusp = cusp_at(element, end)) {
        (end ? range.end : range.begin) = end ? cusp->range.begin : cusp->range.end;
        m_most_nodes = cusp->footpoint ? m_most_nodes : most_unproved_nodes;
      }
    m_begin_of_rest = 0;
    try {
      append_cusp(element, false);
      if (range.begin < range.end)
        sweep(element, range, m_candidates.all());
      append_cusp(element, true);
      m_begin_of_rest = 1;
    } catch (const Run_stopped&) {
      m_swept.append_unresolved({m_begin_of_rest, 1});
    }
    return m_swept.take();
  }

  // The parameter up to which the last element has been swept: 1, if the search was not ended from outside.
  double begin_of_rest() const { return m_begin_of_rest; }

  // Sweeps a part of an element, which is divided no more often than some number, nor when more candidates have been
  // bounded than another one. Returns whether all of it is resolved.
  bool resolve_part(std::size_t element, const Range& range, std::vector<Disk_candidate<Interval>> candidates,
                    Disk_slopes& slopes, int nodes, std::size_t bounds)
  {
    m_slopes = &slopes;
    m_most_nodes = nodes;
    m_most_bounds = bounds;
    sweep(element, range, std::move(candidates));
    return m_swept.is_resolved();
  }

private:
  const Cusp_side* cusp_at(std::size_t element, bool end) const
  {
    return m_cusps != nullptr && m_cusps->side(element, end) ? &*m_cusps->side(element, end) : nullptr;
  }

  void append_cusp(std::size_t element, bool end)
  {
    const Cusp_side* cusp = cusp_at(element, end);
    if (cusp != nullptr && cusp->footpoint)
      m_swept.append(*cusp->footpoint, cusp->range);
    else if (cusp != nullptr)
      append_unresolved(cusp->range);
  }

  void sweep(std::size_t element, const Range& range, std::vector<Disk_candidate<Interval>> candidates)
  {
    m_begin_of_rest = range.begin;
    m_check();
    if (m_control != nullptr)
      m_control->add_node();
    const Element_part<Interval> part = m_curvature.part(element, range);
    if (range.width() < exact_width && m_curvature.scaled_sites() == nullptr)
      Element_tangent<Interval>(m_graph, part).replace_segments(candidates);
    const double least = m_candidates.prune(part, candidates, m_slopes->attained_curvature(range));
    const auto is_scaled = [&](const Disk_candidate<Interval>& candidate) {
      return m_candidates.may_be_scaled(candidate);
    };
    if (m_curvature.scaled_sites() != nullptr && std::none_of(candidates.begin(), candidates.end(), is_scaled)) {
      m_swept.append({}, range);
      return;
    }
    if (!(least > 0) && m_curvature.scaled_sites() == nullptr)
      Element_tangent<Interval>(m_graph, part).erase_behind(candidates);
    if (resolve(part, candidates, least))
      return;
    const bool is_in_joint = m_graph.is_in_nearly_smooth_joint(m_graph.elements()[element]),
               is_last = range.width() < (is_in_joint ? least_width_in_joint : least_width) ||
        ++m_nodes > m_most_nodes || m_candidates.number_of_bounds() > m_most_bounds;
    // with numbers that tell the normals of such a joint apart
    const bool is_divided_there = is_last || (is_in_joint && range.width() == 1);
    if ((is_divided_there || Fine_level::is_tried(range, split_ratio, m_size)) &&
        resolve_on_fine_level(element, range, candidates, is_divided_there))
      return;
    if (is_last) {
      // as in rounded circles, where disks nearly touch everything
      if (candidates.size() > Disk_candidates<Interval>::most_candidates)
        m_most_nodes = (std::min)(m_most_nodes, m_nodes);
      append_unresolved(range);
      return;
    }
    const double middle = range.begin + split_ratio * range.width();
    sweep(element, {range.begin, middle}, candidates);
    sweep(element, {middle, range.end}, std::move(candidates));
  }

  // Sweeps a range with numbers of higher precision, with what is left to touch there. Returns whether it is resolved,
  // but for smaller ranges of one that is not to be divided.
  bool resolve_on_fine_level(std::size_t element, const Range& range,
                             const std::vector<Disk_candidate<Interval>>& candidates, bool is_divided)
  {
    if constexpr (is_in_doubles) {
      if (m_fine_level == nullptr || m_fine_nodes >= Fine_level::most_nodes || m_fine_bounds >= Fine_level::most_bounds)
        return false;
      const bool are_many = candidates.size() > Fine_level::most_candidates;
      const int nodes = !is_divided ? 0
                                    : (std::min)(Fine_level::most_nodes - m_fine_nodes,
                                                 are_many ? Fine_level::most_nodes_of_many : Fine_level::most_nodes);
      Maximal_disks<Fine_interval> disks(m_fine_level->graph(), m_tree, m_fine_level->curvature(), m_cusps, nullptr,
                                         m_control);
      const bool is_resolved = disks.resolve_part(element, range, m_fine_level->candidates(candidates), *m_slopes,
                                                  nodes, Fine_level::most_bounds - m_fine_bounds);
      m_fine_nodes += disks.m_nodes + are_many;
      m_fine_bounds += disks.m_candidates.number_of_bounds() + Fine_level::bounds_of_try;
      if (!is_resolved && (!(range.width() < least_width) || disks.m_swept.arcs().empty()))
        return false;
      if (const double begin = disks.m_swept.arcs().front().range.begin; begin > range.begin)
        append_unresolved({range.begin, begin});
      m_swept.append(disks.m_swept.arcs());
      if (disks.m_swept.unresolved())
        append_unresolved(*disks.m_swept.unresolved());
      return true;
    }
    return false;
  }

  // Finds the envelope arcs within a range, if there is at most one event.
  bool resolve(const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates,
               double least)
  {
    const Disk_footpoints<Interval> footpoints(m_graph, m_curvature, *m_slopes, part, candidates, least);
    if (!footpoints.are_known())
      return append_pocket(part, candidates, least) || append_tip(part, candidates, least);
    const std::vector<Disk_branch> highest = footpoints.highest();
    if (highest.size() == 1)
      return append_branch(footpoints, part, highest[0]);
    if (highest.size() == 2 && append_crossing(footpoints, part, highest[0], highest[1]))
      return true;
    return part.range.width() < exact_width && append_common_disk(footpoints, part, highest);
  }

  /*
  One disk that touches all footpoints of a small part, those that go over from one arc to the next one in the point
  between both. As differences of curvatures are monotone, the footpoints change places in that disk only.
  */
  bool append_common_disk(const Disk_footpoints<Interval>& footpoints, const Element_part<Interval>& part,
                          const std::vector<Disk_branch>& branches)
  {
    const auto all = [&](const auto& has_property) {
      return std::all_of(branches.begin(), branches.end(), has_property);
    };
    const auto outer = all([&](const Disk_branch& branch) { return footpoints.moves_once(branch); })
        ? footpoints.before_and_after_common_disk(branches)
        : std::nullopt;
    if (!outer)
      return false;
    const auto& [before, after] = *outer;
    const auto first = footpoints.footpoint_at(before, part.range.begin),
               last = footpoints.footpoint_at(after, part.range.end);
    for (const bool end : {false, true})
      if (const auto& footpoint = end ? first : last;
          footpoint && (end ? part.range.end == 1 : part.range.begin == 0) && all([&](const Disk_branch& branch) {
            return (!branch.move || footpoints.is_move_at_end(branch, end)) &&
                footpoints.are_equal_at_end(branches[0], branch, end);
          })) {
        m_swept.append(*footpoint, part.range);
        return true;
      }
    const auto sign_at = [&, &before = before, &after = after](double u) {
      return footpoints.compare(before, after, u);
    };
    if (sign_at(part.range.begin) <= 0 || sign_at(part.range.end) >= 0)
      return false;
    // one that does not move, if there is one
    const Located_footpoint &at_begin = before.move && !after.move ? *last : *first,
                            &at_end = before.move ? *last : *first;
    const Interval_pair middle =
        enclosed_centers(m_graph, m_curvature, m_curvature.part(part.element, range_of_zero(part.range, sign_at, 1)),
                         at_begin, at_end);
    return is_disk_common(m_graph, m_curvature, part, branches, middle) &&
        append_change(part, true, sign_at, *first, *last, Disk_event::CROSSING);
  }

  /*
  A part with a pocket at its end. Where the disks do not touch its other arc, they touch one footpoint outside of it.
  */
  bool append_pocket(const Element_part<Interval>& part, std::vector<Disk_candidate<Interval>> candidates, double least)
  {
    if (m_curvature.scaled_sites() != nullptr)   // a pocket excludes sites at their distance
      return false;
    auto pocket = Corner_pocket<Interval>::at_end_of(part, m_graph, m_curvature);
    if (!pocket || !pocket->take(candidates) ||
        !std::all_of(candidates.begin(), candidates.end(),
                     [&](const Disk_candidate<Interval>& c) { return pocket->is_outside(m_candidates.points(c)); }))
      return false;
    const Disk_footpoints<Interval> footpoints(m_graph, m_curvature, *m_slopes, part, candidates, least);
    if (!footpoints.are_known())
      return false;
    const std::vector<Disk_branch> outside = footpoints.highest();
    if (!pocket->has_one_envelope_arc() || outside.size() > 1 ||
        (!outside.empty() && (outside[0].move || outside[0].footpoint.kind == Disk_footpoint::Kind::CIRCLE)))
      return false;
    const auto curvature_at = [&](double u) {
      return largest_curvature(m_graph, m_curvature, m_curvature.part(part.element, {u, u}), outside[0]).curvature;
    };
    const auto sign_at = [&](double u) {
      return outside.empty() || u == (pocket->end() ? 1 : 0) ? 1 : pocket->sign(u, curvature_at(u));
    };
    const auto& [begin, end] = part.range;
    const int far_sign = sign_at(pocket->end() ? begin : end);
    if (far_sign == 0)
      return false;
    if (far_sign > 0) {
      if (pocket->may_touch_far_end(pocket->footpoint()))
        return false;
      m_swept.append(pocket->footpoint(), part.range);
      return true;
    }
    const Range zero = range_of_zero(part.range, sign_at, sign_at(begin));
    const double event = pocket->end() ? zero.begin : zero.end;
    if (std::abs(event - (pocket->end() ? 1 : 0)) > most_corner)
      return false;
    const Interval curvature = curvature_at(event);
    const Located_footpoint inside = pocket->footpoint(pocket->end() ? Range{event, end} : Range{begin, event},
                                                       curvature.inf()),
                            other = outside[0], &first = pocket->end() ? other : inside,
                            &last = pocket->end() ? inside : other;
    if (pocket->may_touch_far_end(inside))
      return false;
    m_swept.append(first, {begin, event});
    m_swept.append_event(Disk_event::CROSSING, last, {event, end});
    Envelope_arc& corner = pocket->end() ? m_swept.arcs().back() : *(m_swept.arcs().end() - 2);
    corner.corner = Corner_end{pocket->end(), in_doubles(curvature)};
    corner.holds_events = true;
    return true;
  }

  // A part at the tip in a corner, between arcs that are not scaled.
  bool append_tip(const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates,
                  double least)
  {
    if (std::any_of(candidates.begin(), candidates.end(),
                    [&](const Disk_candidate<Interval>& candidate) { return m_candidates.may_be_scaled(candidate); }))
      return false;
    const Corner_tip<Interval> tip(m_graph, part);
    if (const auto only = tip.only_footpoint(candidates)) {
      m_swept.append(*only, part.range);
      return true;
    }
    const auto footpoints = tip.vertex_and_arc(candidates);
    const auto sign_at = [&](double u) { return tip.sign(m_curvature, *m_slopes, *footpoints, u, least); };
    return footpoints && append_change(part, true, sign_at, footpoints->vertex, footpoints->arc, Disk_event::JOINT);
  }

  bool append_branch(const Disk_footpoints<Interval>& footpoints, const Element_part<Interval>& part,
                     const Disk_branch& branch)
  {
    if (!branch.move) {
      m_swept.append(branch, part.range);
      return true;
    }
    const auto sign = [&](double u) { return footpoints.sign_of_move(branch, u); };
    const auto sign_at = [&](double u) {
      return sign_or_that_near_end(part.range, u, sign,
                                   [&](bool end) { return footpoints.is_move_at_end(branch, end); });
    };
    return append_change(part, footpoints.is_sign_of_move_monotone(branch), sign_at, branch.move->positive,
                         branch.move->negative, branch.move->event, branch.move->between);
  }

  bool append_crossing(const Disk_footpoints<Interval>& footpoints, const Element_part<Interval>& part,
                       const Disk_branch& first, const Disk_branch& second)
  {
    if (first.move || second.move)
      return false;
    const auto sign = [&](double u) { return footpoints.compare(first, second, u); };
    const auto sign_at = [&](double u) {
      return sign_or_that_near_end(part.range, u, sign,
                                   [&](bool end) { return footpoints.are_equal_at_end(first, second, end); });
    };
    return append_change(part, footpoints.is_difference_monotone(first, second), sign_at, first, second,
                         Disk_event::CROSSING);
  }

  // The sign of a monotone function, or, where it is zero at an end of the element, the sign near that.
  template <class Sign, class Is_zero_at_end>
  static int sign_or_that_near_end(const Range& range, double u, const Sign& sign, const Is_zero_at_end& is_zero_at_end)
  {
    const int result = sign(u);
    if (result != 0 || (u != 0 && u != 1) || !is_zero_at_end(u == 1))
      return result;
    const double other = u == 0 ? range.end : range.begin;
    return 0 < other && other < 1 ? sign(other) : 0;
  }

  // Where a function is positive the footpoint is the first one, where it is negative the second one; there may be
  // another one between, if only in the range where the sign is not known, which has to be small.
  template <class Sign>
  bool append_change(const Element_part<Interval>& part, bool is_monotone, const Sign& sign_at,
                     const Located_footpoint& positive, const Located_footpoint& negative, Disk_event event,
                     const std::optional<Located_footpoint>& between = std::nullopt)
  {
    if (!is_monotone)
      return false;
    const Range& range = part.range;
    const int at_begin = sign_at(range.begin), at_end = sign_at(range.end);
    if (at_begin * at_end == 0)
      return false;
    const Located_footpoint &before = at_begin > 0 ? positive : negative, &after = at_end > 0 ? positive : negative;
    if (at_begin == at_end) {
      m_swept.append(before, range);
      return true;
    }
    const Range zero = range_of_zero(range, sign_at, at_begin);
    // smaller parts tell more
    if (zero.width() > widest_event && !m_graph.is_in_nearly_smooth_joint(m_graph.elements()[part.element]))
      return false;
    m_swept.append(before, {range.begin, zero.begin});
    if (between) {
      m_swept.append_event(event, *between, zero);
      m_swept.arcs().back().holds_events = true;
    }
    m_swept.append_event(event, after, {zero.end, range.end});
    return true;
  }

  // The diagram is not complete then: less is done for the rest of the element, unless there are only some such places,
  // and small ones.
  void append_unresolved(const Range& range)
  {
    if (range.width() > least_width || ++m_places > most_places)
      m_most_nodes = (std::min)(m_most_nodes, m_nodes + most_unproved_nodes);
    m_swept.append_unresolved(range);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MAXIMAL_DISKS_H
