// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_BRANCHES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_BRANCHES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_branch.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_clusters.h>

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
The branches of footpoints over a part of an element, from the clusters of candidates with one maximum each: footpoints
in an arc or a vertex, and those that go over from one to the other.
*/
template <Enclosing_number Interval = Common::Interval>
class Disk_branches
{
  using Cluster = Disk_clusters<Interval>::Cluster;
  using End_state = Disk_clusters<Interval>::End_state;

  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  const Element_part<Interval>& m_part;
  const Oriented_element<Interval>& m_element;
  Disk_clusters<Interval> m_clusters;
  std::vector<Disk_branch> m_branches;
  bool m_are_known;

public:
  Disk_branches(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature, Disk_slopes& slopes,
                const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates,
                double least)
    : m_graph(graph), m_curvature(curvature), m_part(part), m_element(graph.elements()[part.element]),
      m_clusters(graph, curvature, slopes, part, candidates, least), m_are_known(m_clusters.are_known())
  {
    if (!m_are_known)
      return;
    for (const Disk_candidate<Interval>& candidate : candidates)
      if (candidate.kind == Disk_candidate<Interval>::Kind::VERTEX)
        m_branches.push_back(branch_to(Disk_footpoint::Kind::VERTEX, candidate.index));
    for (const Cluster& cluster : m_clusters)
      if (!add_nearly_smooth_joint(cluster))
        add_branches(cluster);
    if (!(least > 0))
      m_branches.push_back(Disk_branch());
    const auto is_inside = [&](const Disk_candidate<Interval>& c) {
      return curvature.side_of_own_circle(
                 part,
                 c.kind == Disk_candidate<Interval>::Kind::VERTEX
                     ? graph.vertices()[c.index].point
                     : graph.arcs()[c.index].point(Range{c.range.middle(), c.range.middle()})) < 0;
    };
    if (const auto circle = curvature.of_own_circle(part);
        circle && circle->value.sup() >= least && std::none_of(candidates.begin(), candidates.end(), is_inside))
      m_branches.push_back(branch_to(Disk_footpoint::Kind::CIRCLE, m_element.object));
  }

  // Whether each branch is a function.
  bool are_known() const { return m_are_known; }

  const std::vector<Disk_branch>& all() const { return m_branches; }

private:
  // Disks that may touch two arcs that join nearly smoothly: the footpoint goes over from one to the other. Returns
  // whether a cluster belongs to such a pair.
  bool add_nearly_smooth_joint(const Cluster& cluster)
  {
    for (const bool end : {false, true}) {
      const Arc_end own{cluster.arc, end};
      const auto& next = m_graph.nearly_smooth_continuation(own);
      const Cluster* other = next && cluster.touches(end) &&
              m_curvature.is_arc_scaled(cluster.arc) == m_curvature.is_arc_scaled(next->end.arc)
          ? m_clusters.cluster_at(next->end)
          : nullptr;
      if (other == nullptr || cluster.arc == other->arc || cluster.ends[end] != End_state::UNKNOWN ||
          other->ends[next->end.is_end] != End_state::UNKNOWN)
        continue;
      m_are_known = m_are_known && !is_part_at(m_graph.vertex_of(own)) && cluster.ends[!end] != End_state::UNKNOWN &&
          other->ends[!next->end.is_end] != End_state::UNKNOWN;
      if (cluster.arc < other->arc)
        add_nearly_smooth_joint(cluster, *other, own, *next);
      return true;
    }
    return false;
  }

  void add_nearly_smooth_joint(const Cluster& cluster, const Cluster& other, const Arc_end& own,
                               const Nearly_smooth_continuation<Interval>& next)
  {
    const int side = side_of_disks(cluster, own, false), other_side = side_of_disks(other, next.end, true);
    m_are_known = m_are_known && side != 0 && side == other_side;
    const bool is_vertex_touched = (side > 0) == next.is_left_reflex;
    Disk_branch branch;
    static_cast<Located_footpoint&>(branch) = footpoint_with(cluster);
    branch.move = {is_vertex_touched ? Disk_event::JOINT : Disk_event::CROSSING,
                   own.arc,
                   own.parameter(),
                   footpoint_with(other),
                   footpoint_with(cluster),
                   std::array{own, next.end}};
    if (is_vertex_touched)
      branch.move->between = Located_footpoint{{Disk_footpoint::Kind::VERTEX, m_graph.vertex_of(own)}};
    m_branches.push_back(branch);
  }

  // Whether the part ends in a vertex.
  bool is_part_at(std::size_t vertex) const
  {
    if (m_element.is_normal_cone)
      return m_element.object == vertex;
    return (m_part.range.begin == 0 && m_graph.vertex_of({m_element.object, false}) == vertex) ||
        (m_part.range.end == 1 && m_graph.vertex_of({m_element.object, true}) == vertex);
  }

  // The side on which the disks are that touch an arc, seen on the way to one of its ends, or away from it: 1 left, -1
  // right; 0 if that is not certain. It is that of the point in which they touch the element.
  int side_of_disks(const Cluster& cluster, const Arc_end& end, bool is_away) const
  {
    const Curve_jet<Interval> y = m_graph.arcs()[cluster.arc].jet(cluster.range, 1);
    return certain_sign(dot(turned_left(y[1]), m_part.jet.point - y[0])) * (end.is_end != is_away ? 1 : -1);
  }

  void add_branches(const Cluster& cluster)
  {
    if (cluster.has_inner_maximum())
      add_inner_maximum(cluster);
    else
      for (const bool end : {false, true})
        if (cluster.ends[end] == End_state::MAXIMUM && cluster.touches(end))
          add_vertex({cluster.arc, end});
  }

  static Disk_branch branch_to(Disk_footpoint::Kind kind, std::size_t index)
  {
    Disk_branch result;
    result.footpoint = {kind, index};
    return result;
  }

  Located_footpoint footpoint_with(const Cluster& cluster) const
  {
    const bool is_own = !m_element.is_normal_cone && m_element.object == cluster.arc;
    return {{Disk_footpoint::Kind::ARC, cluster.arc,
             !is_own                                       ? 0
                 : cluster.range.begin >= m_part.range.end ? 1
                 : cluster.range.end <= m_part.range.begin ? -1
                                                           : 0},
            cluster.range,
            cluster.least,
            cluster.corner};
  }

  void add_inner_maximum(const Cluster& cluster)
  {
    Disk_branch branch;
    static_cast<Located_footpoint&>(branch) = footpoint_with(cluster);
    bool is_added_there = false;
    for (const bool end : {false, true})
      if (cluster.ends[end] == End_state::UNKNOWN) {
        const auto beyond = footpoint_beyond({cluster.arc, end});
        if (!beyond)
          continue;
        m_are_known = m_are_known && !branch.move;
        branch.move = {Disk_event::JOINT, cluster.arc, end ? 1.0 : 0.0, end ? *beyond : branch, end ? branch : *beyond};
        is_added_there = is_added_there ||
            (beyond->footpoint.kind == Disk_footpoint::Kind::ARC && is_before(beyond->footpoint.index, cluster.arc));
      }
    if (is_added_there)   // not before both ends have been looked at: the footpoint may go over in only one of them
      return;
    const bool is_own = !m_element.is_normal_cone && m_element.object == cluster.arc;
    if (is_own && branch.footpoint.side == 0) {
      m_are_known = m_are_known && !branch.move;
      const int sign = certain_sign(m_curvature(m_part, cluster.arc, m_part.range).dv);
      const Located_footpoint after{
          {Disk_footpoint::Kind::ARC, cluster.arc, 1}, cluster.range, cluster.least, cluster.corner},
          before{{Disk_footpoint::Kind::ARC, cluster.arc, -1}, cluster.range, cluster.least, cluster.corner};
      if (sign != 0)
        branch.footpoint.side = sign;
      else
        branch.move = {Disk_event::TIP, cluster.arc, 0, after, before};
    }
    m_branches.push_back(branch);
  }

  // Joints belong to one of their arcs: if possible to that of the element, for which bounds are tight.
  bool is_before(std::size_t a, std::size_t b) const
  {
    const auto is_other = [&](std::size_t arc) { return m_element.is_normal_cone || arc != m_element.object; };
    return std::pair(is_other(a), a) < std::pair(is_other(b), b);
  }

  // What disks touch if the maximum is not in the arc, but beyond its end; nothing if the maximum cannot be there.
  std::optional<Located_footpoint> footpoint_beyond(const Arc_end& end)
  {
    const auto continuation = m_curvature.continuation(m_part, end);
    const std::size_t vertex = m_graph.vertex_of(end);
    if (!continuation)
      return Located_footpoint{{Disk_footpoint::Kind::VERTEX, vertex}};
    const Cluster* next = m_clusters.cluster_at(*continuation);
    if (next == nullptr || next->ends[continuation->is_end] == End_state::MAXIMUM ||
        next->ends[continuation->is_end] == End_state::TOO_LOW)
      return std::nullopt;
    if (next->ends[continuation->is_end] == End_state::NOT_A_MAXIMUM)
      m_are_known = false;
    return footpoint_with(*next);
  }

  void add_vertex(const Arc_end& end)
  {
    const std::size_t vertex = m_graph.vertex_of(end);
    for (const Arc_end& other : m_graph.vertices()[vertex].ends) {
      if (m_curvature.is_arc_scaled(other.arc) != m_curvature.is_arc_scaled(end.arc))
        continue;
      const Cluster* cluster = m_clusters.cluster_at(other);
      if (cluster != nullptr ? cluster->ends[other.is_end] != End_state::MAXIMUM
                             : certain_sign(m_curvature(m_part, other).dv) * (other.is_end ? -1 : 1) > 0)
        return;   // the maximum is in the other arc, or it has the vertex as a possible move
    }
    if (const auto continuation = m_curvature.continuation(m_part, end);
        continuation && m_clusters.cluster_at(*continuation) == nullptr)
      return;   // it is too low there
    if (m_element.is_normal_cone && m_element.object == vertex) {
      m_are_known = false;
      return;
    }
    const Disk_branch branch = branch_to(Disk_footpoint::Kind::VERTEX, vertex);
    const bool is_known = std::any_of(m_branches.begin(), m_branches.end(),
                                      [&](const Disk_branch& b) { return b.footpoint == branch.footpoint; });
    if (!is_known &&
        (m_curvature.is_vertex_scaled(vertex) || !m_graph.is_vertex_on_line_or_circle_of(m_part.element, vertex)))
      m_branches.push_back(branch);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_BRANCHES_H
