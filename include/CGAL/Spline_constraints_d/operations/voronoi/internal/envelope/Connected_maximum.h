// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CONNECTED_MAXIMUM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CONNECTED_MAXIMUM_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_cluster.h>

#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Disks over a part of an element whose points on an arc are connected, so that their curvature has one maximum there: on
lines and circles, and on arcs that are flatter than all disks.
*/
template <Enclosing_number Interval = Common::Interval>
class Connected_maximum
{
  using Cluster = Disk_cluster<Interval>;
  using End_state = Cluster::End_state;

  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  const Element_part<Interval>& m_part;
  double m_least;   // curvature of all maximal disks

public:
  Connected_maximum(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                    const Element_part<Interval>& part, double least)
    : m_graph(graph), m_curvature(curvature), m_part(part), m_least(least)
  {}

  // Disks that touch the element in one point are nested, also when they are scaled, and a line or circle meets the
  // boundary of each in two points at most, but for a circle that is the boundary of a scaled one: whether those of its
  // points through which there are disks of at least some positive curvature are connected.
  bool are_connected(std::size_t arc) const
  {
    const Site_arc_2<Interval>& y = m_graph.arcs()[arc];
    return m_least > 0 && !y.turns_back() &&
        (m_curvature.is_arc_scaled(arc) ? y.is_straight() : y.is_on_line_or_circle());
  }

  // Whether the only cluster of an arc has one maximum; also finds out about maxima in the ends, as does the next one.
  bool is_on_line_or_circle(Cluster& cluster) const
  {
    return are_connected(cluster.arc) &&
        is_only(cluster, std::numeric_limits<double>::min(), !m_graph.arcs()[cluster.arc].is_straight());
  }

  bool is_on_flat_arc(Cluster& cluster) const
  {
    return m_least > 0 && is_flat(cluster) && is_only(cluster, m_least, false);
  }

private:
  /*
  Whether an arc has less curvature than all disks, on the side on which they touch the element. Where it goes away from
  each of its points, it meets each of them in connected points: if it left a disk and came back, that would touch it
  from inside when it is moved away from the chord between.
  */
  bool is_flat(const Cluster& cluster) const
  {
    const Site_arc_2<Interval>& arc = m_graph.arcs()[cluster.arc];
    if (m_curvature.is_arc_scaled(cluster.arc) || arc.has_singular_end())
      return false;
    const Curve_jet<Interval> y = arc.jet(cluster.range, 2);
    if (!turns_by_less_than_right_angle(y[1]))
      return false;
    const Interval square = squared_norm(y[1]), turn = dot(turned_left(y[1]), y[2]),
                   least =
                       Interval(m_least) / CGAL::sqrt(squared_norm(m_part.jet.normal)) * (square * CGAL::sqrt(square));
    const int side = certain_sign(dot(turned_left(y[1]), m_part.jet.point - y[0]));
    return (side < 0 || turn.sup() < least.inf()) && (side > 0 || -turn.inf() < least.inf());
  }

  // The points through which there are disks of more than some curvature are connected, and have one maximum. If a
  // circle connects them, its rest may do so, too.
  bool is_only(Cluster& cluster, double least, bool is_round) const
  {
    std::array<End_state, 2> ends{End_state::NOT_A_MAXIMUM, End_state::NOT_A_MAXIMUM};
    int ends_among_them = 0;
    for (const bool end : {false, true})
      if (cluster.touches(end)) {
        const Curvature_bounds<Interval> k = m_curvature(m_part, Arc_end{cluster.arc, end});
        if (k.value.sup() < m_least) {   // the maximum in the next arc may still matter
          ends[end] = End_state::TOO_LOW;
          continue;
        }
        if (!(k.value.inf() >= least))   // so that it is connected with the others
          return false;
        const int sign = certain_sign(k.dv) * (end ? 1 : -1);
        ends[end] = sign > 0 ? End_state::MAXIMUM : sign < 0 ? End_state::NOT_A_MAXIMUM : End_state::UNKNOWN;
        ++ends_among_them;
      }
    if (ends_among_them == 2 && is_round)
      return false;
    cluster.ends = ends;
    cluster.least = least;
    return true;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_CONNECTED_MAXIMUM_H
