// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_CLUSTERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_CLUSTERS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Disk_candidates.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_slope.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Cluster_slopes.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Connected_maximum.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Corner_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_cluster.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The ranges of arcs that disks may touch over a part of an element, by what is left when candidates have been pruned; and
whether the curvature of the disks through a range is known to have one maximum there, or at one of its ends.
*/
template <Enclosing_number Interval = Common::Interval>
class Disk_clusters
{
  using Interval_pair = std::array<Interval, 2>;

public:
  using Cluster = Disk_cluster<Interval>;
  using End_state = Cluster::End_state;

private:
  static constexpr double most_reach = 64;   // of a cluster at a corner, in units of the length of the part

  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  const Element_part<Interval>& m_part;
  const Oriented_element<Interval>& m_element;
  Cluster_slopes<Interval> m_cluster_slopes;
  Connected_maximum<Interval> m_maximum;
  std::vector<Cluster> m_clusters;
  bool m_are_known = true, m_is_one_part = false;   // the latter: all that is left is one range of one arc

public:
  Disk_clusters(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature, Disk_slopes& slopes,
                const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates,
                double least)
    : m_graph(graph), m_curvature(curvature), m_part(part), m_element(graph.elements()[part.element]),
      m_cluster_slopes(graph, curvature, slopes, part, least), m_maximum(graph, curvature, part, least)
  {
    collect(candidates);
    if (!(least > 0))
      std::erase_if(m_clusters, [&](const Cluster& cluster) { return m_cluster_slopes.is_below_element(cluster); });
    merge_at_common_vertices();
    if (!m_element.is_normal_cone)
      for (const bool end : {false, true})
        for (const Arc_end& next : graph.vertices()[graph.vertex_of({m_element.object, end})].ends)
          if (graph.continuations({m_element.object, end}).hold(next))
            merge_at_joint(next);
    for (Cluster& cluster : m_clusters)
      m_are_known = m_are_known && has_one_maximum(cluster);
    if (!m_are_known)
      return;
    std::erase_if(m_clusters, [](const Cluster& cluster) { return cluster.is_too_low; });
    settle_joints();
  }

  // Whether each has one maximum.
  bool are_known() const { return m_are_known; }

  std::vector<Cluster>::const_iterator begin() const { return m_clusters.begin(); }
  std::vector<Cluster>::const_iterator end() const { return m_clusters.end(); }

  // The cluster that touches an end of an arc.
  const Cluster* cluster_at(const Arc_end& end) const
  {
    const auto cluster = std::find_if(m_clusters.begin(), m_clusters.end(),
                                      [&](const Cluster& c) { return c.arc == end.arc && c.touches(end.is_end); });
    return cluster == m_clusters.end() ? nullptr : &*cluster;
  }

private:
  // Neighbouring candidates form one cluster, as do all of a segment.
  void collect(const std::vector<Disk_candidate<Interval>>& candidates)
  {
    for (const Disk_candidate<Interval>& candidate : candidates)
      if (candidate.kind == Disk_candidate<Interval>::Kind::ARC)
        m_clusters.push_back({candidate.index, candidate.range, candidate.bounds});
      else if (candidate.kind == Disk_candidate<Interval>::Kind::NODE)
        m_are_known = false;
    std::sort(m_clusters.begin(), m_clusters.end(), [](const Cluster& a, const Cluster& b) {
      return std::pair(a.arc, a.range.begin) < std::pair(b.arc, b.range.begin);
    });
    std::vector<Cluster> merged;
    for (const Cluster& cluster : m_clusters)
      if (!merged.empty() && merged.back().arc == cluster.arc &&
          (cluster.range.begin <= merged.back().range.end ||
           (m_maximum.are_connected(cluster.arc) && m_graph.arcs()[cluster.arc].is_straight()))) {
        merged.back().range.end = cluster.range.end;
        merged.back().bounds = hull(merged.back().bounds, cluster.bounds);
      } else
        merged.push_back(cluster);
    m_clusters = std::move(merged);
    m_is_one_part = m_clusters.size() == 1 &&
        std::all_of(candidates.begin(), candidates.end(), [](const Disk_candidate<Interval>& candidate) {
                      return candidate.kind == Disk_candidate<Interval>::Kind::ARC;
                    });
  }

  // Also finds out about maxima in the ends.
  bool has_one_maximum(Cluster& cluster) const
  {
    if (cluster.is_known)
      return true;
    if (const auto nearest = nearest_end_on_line_through_normal_cone(cluster.arc)) {
      cluster.ends[*nearest] = End_state::MAXIMUM;
      return true;
    }
    const int slope = certain_sign(cluster.bounds.dv);
    if (slope != 0) {
      cluster.ends[slope > 0] = End_state::MAXIMUM;
      return true;
    }
    const bool is_concave = cluster.bounds.dvv.sup() < 0;
    if (is_concave && rises_to_others(cluster)) {
      cluster.is_too_low = true;
      return true;
    }
    if (is_concave) {
      bool are_ends_known = true;
      for (const bool end : {false, true})
        if (cluster.touches(end)) {
          const int sign = certain_sign(m_curvature(m_part, Arc_end{cluster.arc, end}).dv) * (end ? 1 : -1);
          cluster.ends[end] = sign > 0 ? End_state::MAXIMUM : sign < 0 ? End_state::NOT_A_MAXIMUM : End_state::UNKNOWN;
          are_ends_known = are_ends_known && sign != 0;
        }
      if (are_ends_known)
        return true;
    }
    // The last only where there is nothing else: events are known better by smaller parts.
    return m_cluster_slopes.has_known_slopes(cluster) || is_concave ||
        (clusters_of(cluster.arc) == 1 && m_maximum.is_on_line_or_circle(cluster)) ||
        (m_is_one_part && m_maximum.is_on_flat_arc(cluster));
  }

  std::ptrdiff_t clusters_of(std::size_t arc) const
  {
    return std::count_if(m_clusters.begin(), m_clusters.end(), [&](const Cluster& c) { return c.arc == arc; });
  }

  // Whether one of several parts of an arc where the curvature is concave is lower than what is beyond one of its ends.
  bool rises_to_others(const Cluster& cluster) const
  {
    if (clusters_of(cluster.arc) < 2)
      return false;
    const auto slope_at = [&](double v) { return certain_sign(m_curvature(m_part, cluster.arc, {v, v}).dv); };
    return (!cluster.touches(false) && slope_at(cluster.range.begin) < 0) ||
        (!cluster.touches(true) && slope_at(cluster.range.end) > 0);
  }

  // The end of a segment that is nearest to the vertex of a normal cone, if that is on its line, and not in the
  // segment: disks through the segment are the smaller, the nearer to the vertex they pass through it.
  std::optional<bool> nearest_end_on_line_through_normal_cone(std::size_t arc) const
  {
    const Site_arc_2<Interval>& segment = m_graph.arcs()[arc];
    if (!m_element.is_normal_cone || !segment.is_straight() || segment.turns_back() || m_curvature.is_arc_scaled(arc) ||
        !m_graph.vertices()[m_element.object].is_exact)
      return std::nullopt;
    const std::size_t begin = m_graph.vertex_of({arc, false}), end = m_graph.vertex_of({arc, true});
    const typename Site_graph_2<Interval>::Vertex& normal_cone = m_graph.vertices()[m_element.object];
    const Interval_pair to_begin = m_graph.vertices()[begin].point - normal_cone.point,
                        to_end = m_graph.vertices()[end].point - normal_cone.point;
    if (begin == m_element.object || end == m_element.object || certain_sign(dot(to_begin, to_end)) <= 0 ||
        certain_sign(dot(turned_left(to_begin), to_end)) != 0 || !segment.is_on_line_or_circle(normal_cone.exact_point))
      return std::nullopt;
    const int order = certain_sign(squared_norm(to_begin) - squared_norm(to_end));
    return order == 0 ? std::nullopt : std::optional(order > 0);
  }

  // Where arcs join smoothly, the curvature grows in the end of one of them if it does so in the end of the other one.
  // In tangents of the circle of the element it may do so on both sides.
  void settle_joints()
  {
    for (Cluster& cluster : m_clusters)
      for (const bool end : {false, true}) {
        const auto continuation = m_curvature.continuation(m_part, {cluster.arc, end});
        const Cluster* next = continuation ? cluster_at(*continuation) : nullptr;
        if (cluster.ends[end] != End_state::UNKNOWN || next == nullptr ||
            m_graph.is_vertex_on_line_or_circle_of(m_part.element, m_graph.vertex_of({cluster.arc, end})))
          continue;
        const End_state state = next->ends[continuation->is_end];
        cluster.ends[end] = state == End_state::MAXIMUM ? End_state::NOT_A_MAXIMUM
            : state == End_state::NOT_A_MAXIMUM         ? End_state::MAXIMUM
                                                        : End_state::UNKNOWN;
      }
  }

  // What is left of an arc next to a vertex that it has in common with the element is one cluster, if it is known to
  // have one maximum.
  void merge_at_common_vertices()
  {
    if (m_element.is_normal_cone) {
      for (const Arc_end& end : m_graph.vertices()[m_element.object].ends)
        merge_at_normal_cone(end);
      return;
    }
    for (const bool end : {false, true})
      if (end ? m_part.range.end == 1 : m_part.range.begin == 0)
        merge_at_corners({m_element.object, end});
  }

  void merge_at_normal_cone(const Arc_end& other)
  {
    const auto is_part = [&](const Cluster& cluster) { return cluster.arc == other.arc; };
    if (auto all = united_at(other, is_part); all && has_one_maximum_at_normal_cone(*all, other))
      replace(is_part, *all);
  }

  // The curvature of disks in the corners between an arc and others is inversely proportional to their distance,
  // nearly; what is lower than in one of them is left out.
  void merge_at_corners(const Arc_end& own)
  {
    const std::vector<Arc_end>& ends = m_graph.vertices()[m_graph.vertex_of(own)].ends;
    double greatest = 0;
    for (const Arc_end& other : ends)
      if (other != own)
        greatest = (std::max)(greatest, merge_at_corner(own, other));
    if (!(greatest > 0))
      return;
    const Interval width(m_part.range.width());
    std::erase_if(m_clusters, [&](const Cluster& cluster) {
      return cluster.bounds.value.sup() < (Interval(greatest) / width).inf();
    });
    for (const Arc_end& other : ends)
      std::erase_if(m_clusters, [&](const Cluster& cluster) {
        return other != own && cluster.arc == other.arc && cluster.touches(other.is_end) &&
            cluster.corner.least < greatest &&
            Corner_disks<Interval>(m_graph, m_curvature, m_part, own, other, cluster.range).are_all_lower(greatest);
      });
  }

  // Only what is near. Returns a curvature that is exceeded at unit distance, or 0.
  double merge_at_corner(const Arc_end& own, const Arc_end& other)
  {
    const auto speed = [&](const Arc_end& end) {
      return std::sqrt(squared_norm(m_graph.arcs()[end.arc].jet({end.parameter(), end.parameter()}, 1)[1]).sup());
    };
    const double reach = most_reach * m_part.range.width() * speed(own) / speed(other);
    const auto is_part = [&](const Cluster& cluster) {
      return cluster.arc == other.arc && (other.is_end ? 1 - cluster.range.end : cluster.range.begin) <= reach;
    };
    const Cluster* first = cluster_at(other);
    auto all = first != nullptr && is_part(*first) ? united_at(other, is_part) : std::nullopt;
    const auto maximum = all
        ? Corner_disks<Interval>(m_graph, m_curvature, m_part, own, other, all->range).only_maximum()
        : std::nullopt;
    if (!maximum)
      return 0;
    all->least = maximum->least_curvature;
    all->bounds.value = Interval(all->least, std::numeric_limits<double>::infinity());
    all->corner = {own.parameter(), (Interval(all->least) * Interval(m_part.range.width())).inf()};
    if (maximum->is_in_vertex)
      all->ends[other.is_end] = End_state::MAXIMUM;
    replace(is_part, *all);
    return all->corner.least;
  }

  // Clusters of an arc with an end in the vertex as one; nothing if there are none, or they reach the other end, and
  // the curvature may rise up to there.
  template <class Is_part>
  std::optional<Cluster> united_at(const Arc_end& end, const Is_part& is_part) const
  {
    std::optional<Cluster> all;
    for (const Cluster& cluster : m_clusters)
      if (is_part(cluster))
        all = all ? Cluster{end.arc, united(all->range, cluster.range), hull(all->bounds, cluster.bounds)} : cluster;
    const double far = 1 - end.parameter();
    if (all && all->touches(!end.is_end) &&
        certain_sign(m_curvature(m_part, end.arc, {far, far}).dv) != (end.is_end ? 1 : -1))
      return std::nullopt;
    return all;
  }

  template <class Is_part>
  void replace(const Is_part& is_part, Cluster cluster)
  {
    cluster.is_known = true;
    std::erase_if(m_clusters, is_part);
    m_clusters.push_back(cluster);
  }

  // The same for an arc that goes on where that of the element ends, if its clusters one by one are not known.
  void merge_at_joint(const Arc_end& other)
  {
    std::optional<Cluster> all;
    bool are_known = true;
    for (Cluster& cluster : m_clusters)
      if (cluster.arc == other.arc) {
        are_known = has_one_maximum(cluster) && are_known;
        all = all ? Cluster{other.arc, united(all->range, cluster.range), hull(all->bounds, cluster.bounds)} : cluster;
      }
    if (are_known)
      return;
    all->range = united(all->range, {other.parameter(), other.parameter()});
    if (!m_cluster_slopes.has_known_slopes(*all))
      return;
    all->is_known = true;
    std::erase_if(m_clusters, [&](const Cluster& cluster) { return cluster.arc == other.arc; });
    m_clusters.push_back(*all);
  }

  // Where the normal cone is perpendicular to the arc.
  bool has_one_maximum_at_normal_cone(const Cluster& cluster, const Arc_end& other) const
  {
    for (const bool normal : {false, true})
      if (m_graph.is_perpendicular(m_element, normal, other) &&
          Normal_cone_disks<Interval>(m_graph, m_part, normal, other, cluster.range).has_one_maximum())
        return true;
    return false;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_DISK_CLUSTERS_H
