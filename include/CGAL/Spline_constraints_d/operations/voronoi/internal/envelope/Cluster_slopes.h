// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CLUSTER_SLOPES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CLUSTER_SLOPES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_slope.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_cluster.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
What polynomials tell of the curvature of the disks through a cluster, near the ends of the element and of the arc,
where intervals do not tell it (see Disk_slope).
*/
template <Enclosing_number Interval = Common::Interval>
class Cluster_slopes
{
  using Cluster = Disk_cluster<Interval>;
  using End_state = Cluster::End_state;

  // between an end of the element and a part that is near it, in widths of the part
  static constexpr double most_gap = 4;

  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  Disk_slopes& m_slopes;
  const Element_part<Interval>& m_part;
  const Oriented_element<Interval>& m_element;
  double m_least;   // curvature of all maximal disks

public:
  Cluster_slopes(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature, Disk_slopes& slopes,
                 const Element_part<Interval>& part, double least)
    : m_graph(graph), m_curvature(curvature), m_slopes(slopes), m_part(part), m_element(graph.elements()[part.element]),
      m_least(least)
  {}

  // Whether a cluster has one maximum, or is too low; also finds out about maxima in the ends.
  bool has_known_slopes(Cluster& cluster) const
  {
    return is_any_end(
        cluster, [&](const Disk_slope& slope, bool element_end, const Range& a, bool end, const Range& b) {
          const Path_signs signs = slope.slopes(a, b, m_least);
          if (signs.pattern == Sign_pattern::UNKNOWN || signs.pattern == Sign_pattern::ZERO)
            return false;
          cluster.is_too_low = signs.pattern == Sign_pattern::NONE;
          cluster.least = m_least;
          if (const double share = slope.share_of_largest(a); share > 0)
            cluster.corner = {element_end ? 1.0 : 0.0, share, slope.power_of_share(), slope.is_share_of_root()};
          const auto state = [&](bool is_maximum, bool is_irrelevant) {
            return is_maximum ? End_state::MAXIMUM : is_irrelevant ? End_state::TOO_LOW : End_state::NOT_A_MAXIMUM;
          };
          cluster.ends[end] = signs.pattern == Sign_pattern::FALLING_OR_NEGATIVE
              ? End_state::UNKNOWN
              : state(signs.pattern == Sign_pattern::NEGATIVE, signs.begin_irrelevant);
          cluster.ends[!end] = state(signs.pattern == Sign_pattern::POSITIVE, signs.end_irrelevant);
          return true;
        });
  }

  // Whether all disks through a cluster are half-planes or larger.
  bool is_below_element(const Cluster& cluster) const
  {
    return is_any_end(cluster, [](const Disk_slope& slope, bool, const Range& a, bool, const Range& b) {
      return slope.is_value_negative(a, b);
    });
  }

private:
  // Calls visit(slope, end of the element, range of the distance from that, end of the arc, range of the distance from
  // that) for the ends that the part and a cluster reach, until that returns true.
  template <class Visit>
  bool is_any_end(const Cluster& cluster, const Visit& visit) const
  {
    const auto from = [](const Range& range, bool end) { return end ? Range{1 - range.end, 1 - range.begin} : range; };
    for (const bool element_end : {false, true})
      for (const bool end : {false, true}) {
        const Range a = from(m_part.range, element_end);
        if (!cluster.touches(end) || !is_decided_by_polynomials(a, element_end, {cluster.arc, end}))
          continue;
        const Disk_slope& slope = m_slopes(element_end, {cluster.arc, end});
        if (visit(slope, element_end, a, end, from(cluster.range, end)) ||
            (slope.has_powers() &&
             visit(m_slopes(element_end, {cluster.arc, end}, false), element_end, a, end, from(cluster.range, end))))
          return true;
      }
    return false;
  }

  // Whether intervals cannot decide in an end of an arc, at a distance from an end of the element: where both join;
  // where the derivative is zero, or the curvature or its derivative; on the circle of the element, in tangents of it;
  // and near a tie.
  bool is_decided_by_polynomials(const Range& distance, bool element_end, const Arc_end& end) const
  {
    if (m_curvature.is_arc_scaled(end.arc) || !m_graph.is_exact(end) ||
        (!m_element.is_normal_cone && !m_graph.is_exact({m_element.object, element_end})))
      return false;
    const bool is_near = distance.begin <= most_gap * distance.width(),
               is_flat = m_graph.arcs()[end.arc].is_curvature_stationary(end.is_end) ||
        m_graph.arcs()[end.arc].is_curvature_zero(end.is_end);
    const std::size_t vertex = m_graph.vertex_of(end);
    if (m_element.is_normal_cone)
      return is_near &&
          (vertex == m_element.object ? m_graph.arcs()[end.arc].circle().has_value() || !m_graph.is_regular(end) ||
                   is_flat || m_graph.nearly_smooth_continuation(end).has_value()
                                      : is_tie(element_end, end));
    const Arc_end own{m_element.object, element_end};
    if (own == end)
      return is_near && (!m_graph.is_regular(end) || is_flat);
    if (m_graph.continuations(own).hold(end))
      return true;
    if (m_graph.arcs()[m_element.object].circle() && m_graph.is_vertex_on_line_or_circle_of(m_part.element, vertex))
      return true;
    return is_near && (vertex == m_graph.vertex_of(own) || is_tie(element_end, end));
  }

  // Whether the disk that touches the element in its end and passes through the end of an arc may be a half-plane, or
  // touch the arc there.
  bool is_tie(bool element_end, const Arc_end& end) const
  {
    const double u = element_end ? 1 : 0, v = end.parameter();
    const Curvature_bounds<Interval> k = m_curvature(m_curvature.part(m_part.element, {u, u}), end.arc, {v, v});
    return certain_sign(k.value) == 0 || certain_sign(k.dv) == 0;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CLUSTER_SLOPES_H
