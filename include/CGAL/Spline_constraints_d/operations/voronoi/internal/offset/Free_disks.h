// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_FREE_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_FREE_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusps_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Disk_candidates.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Fine_level.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Corner_pocket.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_footpoints.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Covering_sites.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Disk_reach.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Disks_of_radius.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Element_offset.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Opposite_sites.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Rolling_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Swept_ranges.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Touching_disk.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
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
Where a disk of a given radius r that touches an element has no curve inside.

With the normal N(u) its curvature is T(u) = |N(u)| / r in units of the normal, and the disk is free where the largest
disk has a curvature K(u) <= T(u). Along the element, in ranges where K < T or K > T is certain by bounds of K from all
curves that can reach T, nothing else needs to be known. Between these, where one footpoint is left and K - T is
monotone, its signs at both ends tell whether it has its only zero there. What is close to other curves everywhere is
decided by expansions of second order, and what touches them by exact computation (see Disk_reach, Touching_disk,
Rolling_disks, Opposite_sites, Covering_sites).

What doubles cannot decide is swept once more with numbers of higher precision, and so are zeros that doubles cannot
tell well, as where offsets cross at a tiny angle. What these cannot decide is left undecided, and so is what is left
when the search is ended from outside.
*/
template <Enclosing_number Interval = Common::Interval>
class Free_disks
{
  static constexpr double split_ratio = 0.48291015625;   // no place where drawings have symmetries
  static constexpr bool is_in_doubles = std::same_as<Interval, CGAL::Interval_nt<false>>;
  static constexpr double least_width = is_in_doubles ? 0x1p-33 : 0x1p-48;
  static constexpr unsigned ranges_between_checks = is_in_doubles ? 8 : 1;
  static constexpr double width_of_ties = 0x1p-5;   // of ranges that may have to be decided exactly
  static constexpr double width_of_inner_ties = 0x1p-20;   // of those where they are decided in the inside
  // the latter where the offset is not complete anyway
  static constexpr int most_nodes = 2000, most_undecided_nodes = 200;
  static constexpr std::size_t many_candidates = 64;   // that are as much work as a node
  // of which it is tried to find out that one of them is touched: with more, that succeeds rarely
  static constexpr std::size_t most_sites = 3;

  const Site_graph_2<Interval>& m_graph;
  const Site_tree_2& m_tree;
  Disk_curvature<Interval> m_curvature;
  const Cusps_2& m_cusps;
  Disk_candidates<Interval> m_candidates;
  const Fine_level* m_fine_level;   // none on that level
  Disk_slopes* m_slopes = nullptr;             // of the element
  Opposite_sites* m_opposite_sites = nullptr;
  Rolling_disks* m_rolling_disks = nullptr;    // none on the fine level
  Disks_of_radius<Interval> m_disks;
  Search_control* m_control;                   // none: nothing ends the search
  Regular_check m_check;
  double m_begin_of_rest = 0;                  // of the element: what is behind it has not been swept
  Swept_ranges m_swept;
  int m_nodes = 0, m_most_nodes = most_nodes, m_fine_nodes = 0;
  // of parts for which the fine level is tried, as doubles have not decided smaller ones next to them
  double m_fine_width = 0;

  template <Enclosing_number Other>
  friend class Free_disks;

public:
  Free_disks(const Site_graph_2<Interval>& graph, const Site_tree_2& tree, const Cusps_2& cusps,
             const Exact_rational& radius, const Fine_level* fine_level = nullptr, Search_control* control = nullptr)
    : m_graph(graph), m_tree(tree), m_curvature(graph), m_cusps(cusps),
      m_candidates(graph, tree, m_curvature, &cusps, control), m_fine_level(fine_level),
      m_disks(graph, m_curvature, radius), m_control(control), m_check(control, ranges_between_checks)
  {}

  Free_ranges operator()(std::size_t element) requires(is_in_doubles)
  {
    Disk_slopes slopes(m_graph, element);
    Opposite_sites opposite_sites(m_graph, element, m_disks.exact_radius());
    Rolling_disks rolling_disks(m_graph, element, m_disks.exact_radius());
    m_slopes = &slopes;
    m_opposite_sites = &opposite_sites;
    m_rolling_disks = &rolling_disks;
    m_swept = {};
    m_nodes = 0;
    m_most_nodes = most_nodes;
    m_fine_nodes = 0;
    m_fine_width = 0;
    const int sign = m_disks.sign_in_own_circle(element);
    m_begin_of_rest = 0;
    try {
      if (sign < 0 && !opposite_sites.are_circles())
        sweep_between_cusps(element);
      m_begin_of_rest = 1;
    } catch (const Run_stopped&) {
      m_swept.append_undecided({m_begin_of_rest, 1});
    }
    Free_ranges result = m_swept.take();
    result.is_point = sign == 0;   // for any greater radius, all disks are covered
    opposite_sites.cut(result);
    return result;
  }

  // The parameter up to which the last element has been swept: 1, if the search was not ended from outside.
  double begin_of_rest() const { return m_begin_of_rest; }

  // Goes on with a part of an element, if all of it can be decided, and is divided no more often than some number.
  std::optional<Swept_ranges> decided(std::size_t element, const Range& range,
                                      std::vector<Disk_candidate<Interval>> candidates, Swept_ranges swept,
                                      Disk_slopes& slopes, Opposite_sites& opposite_sites, int nodes)
  {
    const std::size_t undecided = swept.ranges().undecided.size();
    m_slopes = &slopes;
    m_opposite_sites = &opposite_sites;
    m_swept = std::move(swept);
    m_most_nodes = nodes;
    sweep(element, range, std::move(candidates));
    return m_swept.ranges().undecided.size() == undecided ? std::optional(std::move(m_swept)) : std::nullopt;
  }

private:
  void sweep_between_cusps(std::size_t element)
  {
    const std::array<Range, 2> cusps{range_in_cusp(element, false), range_in_cusp(element, true)};
    append_cusp(element, false, cusps[0]);
    if (cusps[0].end < cusps[1].begin)
      sweep(element, {cusps[0].end, cusps[1].begin}, m_candidates.all());
    append_cusp(element, true, cusps[1]);
  }

  // Where the disks in a cusp are smaller, or nothing is known; one number where there is no cusp.
  Range range_in_cusp(std::size_t element, bool end) const
  {
    const auto& cusp = m_cusps.side(element, end);
    double width = cusp ? cusp->range.width() : 0;
    const auto are_smaller = [&](const Range& range) {
      return cusp->footpoint->corner.least_curvature(end ? range.begin : range.end) >
          m_disks.curvature(m_curvature.part(element, range)).sup();
    };
    while (width > least_width && cusp->footpoint && !are_smaller(range_at(end, width)))
      width /= 2;
    return range_at(end, width);
  }

  void append_cusp(std::size_t element, bool end, const Range& range)
  {
    if (const auto& cusp = m_cusps.side(element, end); cusp && !(cusp->footpoint && range.width() > least_width))
      m_swept.append_undecided(range);
    else if (cusp)
      m_swept.append_covered();
  }

  void sweep(std::size_t element, const Range& range, std::vector<Disk_candidate<Interval>> candidates)
  {
    m_begin_of_rest = range.begin;
    m_check();
    if (m_control != nullptr)
      m_control->add_node();
    if (m_opposite_sites->touch(range)) {
      m_swept.append_tie(range);
      return;
    }
    const Element_part<Interval> part = m_curvature.part(element, range);
    const auto least = m_disks.hold_nearest(part, candidates) ? std::nullopt : prune(part, candidates);
    if (!least) {
      m_swept.append_covered();
      return;
    }
    if (range.width() < width_of_ties)
      std::erase_if(candidates,
                    [&](const Disk_candidate<Interval>& candidate) { return m_opposite_sites->contain(candidate); });
    erase_below_rolling_disks(range, candidates);
    if (append_pocket(part, candidates) || append_touching(part, candidates) || append_by_reach(part, candidates) ||
        resolve(part, candidates, *least))
      return;
    m_nodes += 1 + static_cast<int>(candidates.size() / many_candidates);
    const bool is_last = range.width() < least_width || m_nodes > m_most_nodes,
               is_fine_level_tried =
                   is_last || range.width() <= m_fine_width || Fine_level::is_tried(range, split_ratio);
    if ((is_last && append_covered_exactly(part, candidates)) ||
        (is_fine_level_tried && decide_on_fine_level(element, range, candidates, is_last)))
      return;
    if (is_last) {
      append_undecided(range, candidates.size());
      return;
    }
    const double middle = range.begin + split_ratio * range.width();
    sweep(element, {range.begin, middle}, candidates);
    sweep(element, {middle, range.end}, std::move(candidates));
  }

  // The offset is not complete then: less is done for the rest of the element, and least where very many things cannot
  // be told apart.
  void append_undecided(const Range& range, std::size_t candidates)
  {
    m_most_nodes = (std::min)(
        m_most_nodes, m_nodes + (candidates > Disk_candidates<Interval>::most_candidates ? 0 : most_undecided_nodes));
    m_swept.append_undecided(range);
  }

  // Removes candidates that are outside of all disks of a part. Returns a curvature below which nothing matters;
  // nothing if all of the disks hold something.
  std::optional<double> prune(const Element_part<Interval>& part,
                              std::vector<Disk_candidate<Interval>>& candidates) const
  {
    const double u = part.range.middle();
    const Interval wanted = m_disks.curvature(part);
    const auto least = m_candidates.prune(
        part, candidates,
        {m_disks.curvature(m_curvature.part(part.element, {u, u})), m_disks.slope(part), wanted.inf()});
    return least && *least <= wanted.sup() ? least : std::nullopt;
  }

  void erase_below_rolling_disks(const Range& range, std::vector<Disk_candidate<Interval>>& candidates)
  {
    if constexpr (is_in_doubles) {
      if (range.width() < width_of_ties)
        m_rolling_disks->look_for_place_in(range);
      m_rolling_disks->erase_below(range, candidates);
    }
  }

  // Decides a part that is not divided any more, where doubles are left: whether some sites cover it all.
  bool append_covered_exactly(const Element_part<Interval>& part,
                              const std::vector<Disk_candidate<Interval>>& candidates)
  {
    if constexpr (is_in_doubles) {
      const Covering_sites sites(m_graph, part.element, m_disks.exact_radius(), candidates);
      const bool is_covered = sites.cover(part.range) ||
          sites.are_walls_around(Element_offset(m_graph, part.element, m_disks.radius()).point(part.range)) ||
          is_covered_behind_end(part, sites);
      if (is_covered)
        m_swept.append_undecided(part.range, true);
      return is_covered;
    }
    return false;
  }

  // Sweeps a range with numbers of higher precision, with what is left to touch there; without dividing it, if it is
  // not the last one.
  bool decide_on_fine_level(std::size_t element, const Range& range,
                            const std::vector<Disk_candidate<Interval>>& candidates, bool is_last)
  {
    if constexpr (is_in_doubles) {
      if (m_fine_level == nullptr || m_fine_nodes >= Fine_level::most_nodes ||
          candidates.size() > Fine_level::most_candidates)
        return false;
      Free_disks<Fine_interval> disks(m_fine_level->graph(), m_tree, m_cusps, m_disks.exact_radius(), nullptr,
                                      m_control);
      auto swept = disks.decided(element, range, m_fine_level->candidates(candidates), m_swept, *m_slopes,
                                 *m_opposite_sites, is_last ? Fine_level::most_nodes - m_fine_nodes : 0);
      m_fine_nodes += disks.m_nodes;
      m_fine_width = swept ? 4 * range.width() : 0;
      if (swept)
        m_swept = std::move(*swept);
      return swept.has_value();
    }
    return false;
  }

  // Whether the disk in an end of the element touches a vertex, and those behind it hold that.
  bool is_covered_behind_end(const Element_part<Interval>& part, const Covering_sites& sites) const
      requires(is_in_doubles)
  {
    const auto holds_behind = [&](bool end, std::size_t vertex) {
      return certain_sign(m_curvature(part, vertex).du - m_disks.slope(part)) == (end ? -1 : 1) &&
          sites.touches_at_end(end, vertex);
    };
    for (const bool end : {false, true})
      if ((end ? part.range.end == 1 : part.range.begin == 0) &&
          (m_graph.elements()[part.element].is_normal_cone ||
           m_graph.is_exact({m_graph.elements()[part.element].object, end})))
        if (std::any_of(sites.vertices().begin(), sites.vertices().end(),
                        [&](std::size_t v) { return holds_behind(end, v); }))
          return true;
    return false;
  }

  // Parts of arcs, and vertices.
  static std::size_t number_of_sites(const std::vector<Disk_candidate<Interval>>& candidates)
  {
    return Touching_disk<Interval>::parts_of_arcs(candidates).size() +
        static_cast<std::size_t>(
            std::count_if(candidates.begin(), candidates.end(),
                          [](const Disk_candidate<Interval>& c) { return c.kind != Candidate_kind::ARC; }));
  }

  // Decides a range with one footpoint that may be reached, or none.
  bool resolve(const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates,
               double least)
  {
    if (candidates.empty()) {
      m_swept.append_free(part.range);
      return true;
    }
    if (number_of_sites(candidates) > most_sites)
      return false;
    const Disk_footpoints<Interval> footpoints(m_graph, m_curvature, *m_slopes, part, candidates, least);
    if (!footpoints.are_known())
      return false;
    std::vector<Disk_branch> branches = footpoints.highest();
    // they are lower
    std::erase_if(branches, [](const Disk_branch& branch) {
      return branch.footpoint.kind == Disk_footpoint::Kind::NOTHING ||
          branch.footpoint.kind == Disk_footpoint::Kind::CIRCLE;
    });
    if (branches.empty()) {
      m_swept.append_free(part.range);
      return true;
    }
    return branches.size() == 1 && !branches[0].move && m_disks.is_touched_once(part, branches[0]) &&
        append_monotone(part, branches[0]);
  }

  // Decides a part with a pocket at its end, if disks that touch something else are larger. The radii in the pocket are
  // monotone.
  bool append_pocket(const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates)
  {
    auto pocket = Corner_pocket<Interval>::at_end_of(part, m_graph, m_curvature);
    std::vector<Disk_candidate<Interval>> others(candidates);
    if (!pocket || !pocket->take(others) || !pocket->has_growing_disks())
      return false;
    const double wanted = m_disks.curvature(part).inf();
    if (!std::all_of(others.begin(), others.end(), [&](const Disk_candidate<Interval>& c) {
          return pocket->is_outside(m_candidates.points(c)) && c.bounds.value.sup() < wanted;
        }))
      return false;
    const auto sign_at = [&](double u) {
      return u == (pocket->end() ? 1 : 0) ? 1
                                          : pocket->sign(u, m_disks.curvature(m_curvature.part(part.element, {u, u})));
    };
    return append_change(part.range, sign_at, [&](const Range& zero) { return pocket->footpoint(zero, wanted); });
  }

  // Decides a part by expansions of second order. Candidates that are not held are removed.
  bool append_by_reach(const Element_part<Interval>& part, std::vector<Disk_candidate<Interval>>& candidates)
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    if (candidates.empty())
      return false;
    const Disk_reach<Interval> reach(m_graph, element, m_disks.radius(), part.range);
    std::erase_if(candidates, [&](const Disk_candidate<Interval>& c) {
      return c.kind == Disk_candidate<Interval>::Kind::VERTEX && reach.hold_vertex(c.index) == Held::NO;
    });
    for (const auto& [arc, range] : Touching_disk<Interval>::parts_of_arcs(candidates))
      switch (reach.hold_arc(arc, range)) {
      case Held::YES: m_swept.append_covered(); return true;
      case Held::NO:
        std::erase_if(candidates, [&, &arc = arc, &range = range](const Disk_candidate<Interval>& c) {
          return c.kind == Disk_candidate<Interval>::Kind::ARC && c.index == arc && c.range.begin >= range.begin &&
              c.range.end <= range.end;
        });
      default: break;
      }
    if (candidates.empty())
      m_swept.append_free(part.range);
    return candidates.empty();
  }

  // Decides a part that holds a disk with an exact footpoint: at an end of the element, or, if the part is short, where
  // the parameter is the simplest number.
  bool append_touching(const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates)
  {
    const auto& [begin, end] = part.range;
    if (part.range.width() > width_of_ties || !Touching_disk<Interval>::is_defined(m_graph, part.element))
      return false;
    if (begin == 0 || end == 1)
      return append_touching(part, candidates, Exact_rational(begin == 0 ? 0 : 1));
    if (part.range.width() > width_of_inner_ties)
      return false;
    const std::vector<Exact_rational> parameters =
        Touching_disk<Interval>::simple_parameters(m_graph, part, m_disks.exact_radius(), candidates);
    return std::any_of(parameters.begin(), parameters.end(),
                       [&](const Exact_rational& parameter) { return append_touching(part, candidates, parameter); });
  }

  bool append_touching(const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates,
                       const Exact_rational& parameter)
  {
    Touching_disk<Interval> touching(m_graph, part.element, m_disks.exact_radius(), parameter);
    const auto sides = touching.sides(part.range, candidates);
    if (!sides)
      return false;
    const CGAL::Interval_nt<false> u = interval_of(parameter);
    const Range before{part.range.begin, u.inf()}, behind{u.sup(), part.range.end};
    const auto is_unknown = [](const Range& range, Held side) {
      return range.begin < range.end && side == Held::UNKNOWN;
    };
    if (is_unknown(before, (*sides)[0]) || is_unknown(behind, (*sides)[1]))
      return false;
    const auto append_side = [&](const Range& range, Held side) {
      if (range.begin < range.end)
        side == Held::NO ? m_swept.append_free(range) : m_swept.append_covered();
    };
    append_side(before, (*sides)[0]);
    m_swept.append_boundary({Free_end::Kind::TIE, {u.inf(), u.sup()}, {}, {}, touching.disk()});
    append_side(behind, (*sides)[1]);
    return true;
  }

  bool append_monotone(const Element_part<Interval>& part, const Located_footpoint& located)
  {
    return append_change(
        part.range, [&](double u) { return m_disks.sign_at(part.element, located, u); },
        [&](const Range& zero) {
          return Located_footpoint{
              located.footpoint,
              largest_curvature(m_graph, m_curvature, m_curvature.part(part.element, zero), located).range};
        });
  }

  // Where the sign of K - T is known at both ends of a range and has one change there at most: the disk there has the
  // footpoint that footpoint_at(zero) tells.
  template <class Sign_at, class Footpoint_at>
  bool append_change(const Range& range, const Sign_at& sign_at, const Footpoint_at& footpoint_at)
  {
    const auto& [begin, end] = range;
    const int at_begin = sign_at(begin), at_end = sign_at(end);
    if (at_begin * at_end == 0)
      return false;
    if (at_begin == at_end) {
      if (at_begin < 0)
        m_swept.append_free(range);
      else
        m_swept.append_covered();
      return true;
    }
    const Range zero = range_of_zero(range, sign_at, at_begin);
    if (m_fine_level != nullptr && zero.width() > least_width)   // it can be told more precisely
      return false;
    const Located_footpoint located = footpoint_at(zero);
    if (at_begin < 0)
      m_swept.append_free({begin, zero.begin});
    m_swept.append_boundary({Free_end::Kind::FOOTPOINT, zero, located.footpoint, located.range});
    if (at_end < 0)
      m_swept.append_free({zero.end, end});
    else
      m_swept.append_covered();
    return true;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_FREE_DISKS_H
