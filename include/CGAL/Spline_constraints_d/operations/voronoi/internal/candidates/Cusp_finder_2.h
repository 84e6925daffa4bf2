// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_CUSP_FINDER_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_CUSP_FINDER_2_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusp_width.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusps_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Disk_candidates.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Whether an arc turns by less than a right angle, and its curvature as seen from an element is below some number.
inline bool is_bent_less(const Site_graph_2<>& graph, const Element_part<>& part, std::size_t arc, double curvature)
{
  const Site_arc_2<>& x = graph.arcs()[arc];
  const auto [tangent, change] = x.tangent_jet(part.range);
  const Interval square = squared_norm(tangent), turn = dot(part.jet.normal, change),
                 speed = x.has_singular_end() ? x.tangent_factor(part.range) : Interval(1);
  return turns_by_less_than_right_angle(tangent) &&
      (turn.sup() <= 0 ||
       (square.inf() > 0 && speed.inf() > 0 && (turn / (speed * square * CGAL::sqrt(square))).sup() < curvature));
}

/*
Settles the cusps between arcs that leave a vertex p in the same direction, as curves do that touch in p: these are too
thin for any subdivision.

Let the largest disks of a small range of the element of an arc touch the other arc only; one of them in X and Y. With
the arcs up to X and Y its chord bounds a pocket. If no vertex but p is in that, nothing is. Chords of empty disks do
not cross, so that a disk that touches the element before X touches nothing but the two arcs there. If these turn by
less than a right angle, and have less curvature than all of these disks, they are outside of each of them but for one
point. So each touches the other arc, in one point which is not p, and the element up to X is one envelope arc.
*/
class Cusp_finder_2
{
  static constexpr double least_width = 0x1p-16, given_up_width = 0x1p-6;       // of an element
  // of the range with the disk, in the width settled, and in that of the cusp
  static constexpr double part_share = 0x1p-4, gap_share = 0x1p-2;

  const Site_graph_2<>& m_graph;
  Disk_curvature<> m_curvature;
  Cusps_2 m_walls;
  Disk_candidates<> m_candidates;   // not behind walls

public:
  Cusp_finder_2(const Site_graph_2<>& graph, const Site_tree_2& tree, Search_control* control = nullptr)
    : m_graph(graph), m_curvature(graph), m_walls(graph), m_candidates(graph, tree, m_curvature, &m_walls, control)
  {}
  Cusp_finder_2(const Cusp_finder_2&) = delete;   // candidates know the walls of this one

  Cusps_2 operator()() const
  {
    const Upward_rounding_guard guard;
    Cusps_2 result = m_walls;
    for (std::size_t f = 0; result.has_cusps() && f < m_graph.elements().size(); ++f)
      for (const bool end : {false, true})
        if (const Arc_end own{m_graph.elements()[f].object, end};
            !m_graph.elements()[f].is_normal_cone && m_graph.across_cusp(m_graph.elements()[f], own))
          result.set_side(f, end, side(f, own));
    return result;
  }

  // That of an element which has a cusp at an end.
  Cusp_side side(std::size_t element, const Arc_end& own) const
  {
    const Arc_end other = *m_graph.across_cusp(m_graph.elements()[element], own);
    const std::size_t other_element = m_graph.element_across(m_graph.elements()[element], own);
    for (double width = 0.5; width >= least_width; width /= 2)
      if (const auto footpoint = settled(element, own, other, other_element, width))
        return {range_at(own, width), footpoint, other_element};
    return {range_at(own, given_up_width), std::nullopt, other_element};
  }

private:
  // The footpoint of all disks that touch the element nearer to the vertex than some width, if that is proved.
  std::optional<Located_footpoint> settled(std::size_t element, const Arc_end& own, const Arc_end& other,
                                           std::size_t other_element, double width) const
  {
    const Element_part<> all = m_curvature.part(element, range_at(own, width));
    const auto cusp = Cusp_width::of(m_graph, own, other, m_graph.elements()[element].is_reversed == own.is_end, width);
    if (!cusp)
      return std::nullopt;
    const Corner_of_disks corner{own.parameter(), cusp->curvature, cusp->power};
    const double least = corner.least_curvature(own.is_end ? 1 - width : width);   // of all disks
    const Interval flat = Interval(least) / CGAL::sqrt(squared_norm(all.jet.normal));
    const auto range =
        footpoint_range(element, own, other, width, (std::min)(part_share * width, gap_share * cusp->gap));
    if (!range || !is_bent_less(m_graph, all, own.arc, flat.inf()) ||
        !is_bent_less(m_graph, m_curvature.part(other_element, *range), other.arc, flat.inf()) ||
        !is_empty(own, all.jet.point, m_graph.arcs()[other.arc].point(*range)))
      return std::nullopt;
    const int way = own.arc != other.arc ? 0 : own.is_end ? -1 : 1;
    return Located_footpoint{{Disk_footpoint::Kind::ARC, other.arc, way}, *range, least, corner};
  }

  // The range of the other arc that holds all footpoints, if the disks at the end of the element's range touch nothing
  // else.
  std::optional<Range> footpoint_range(std::size_t element, const Arc_end& own, const Arc_end& other, double width,
                                       double part_width) const
  {
    const Range last = own.is_end ? Range{1 - width, 1 - width + part_width} : Range{width - part_width, width};
    std::vector<Disk_candidate<>> candidates = m_candidates.all();
    m_candidates.prune(m_curvature.part(element, last), candidates);
    Range result{other.parameter(), other.parameter()};
    for (const Disk_candidate<>& candidate : candidates) {
      if (candidate.kind != Disk_candidate<>::Kind::ARC || candidate.index != other.arc ||
          (own.arc == other.arc && candidate.range.meets(range_at(own, width))))
        return std::nullopt;
      result = united(result, candidate.range);
    }
    return candidates.empty() ? std::nullopt : std::optional(result);
  }

  // Whether the pocket between two arcs holds no vertex.
  bool is_empty(const Arc_end& own, const Interval_pair& a, const Interval_pair& b) const
  {
    const Interval_pair pocket = hull(a, b);
    for (std::size_t v = 0; v < m_graph.vertices().size(); ++v)
      if (const Interval_pair d = m_graph.vertices()[v].point - pocket;
          v != m_graph.vertex_of(own) && certain_sign(d[0]) == 0 && certain_sign(d[1]) == 0)
        return false;
    return true;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_CUSP_FINDER_2_H
