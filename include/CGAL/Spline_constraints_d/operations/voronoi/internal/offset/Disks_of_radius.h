// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_DISKS_OF_RADIUS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_DISKS_OF_RADIUS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_candidate.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Disk_reach.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The disks of a radius r that touch an element: their curvature T(u) = |N(u)| / r in units of the normal N(u), beside the
largest curvature K(u) of the disks that touch something else.
*/
template <Enclosing_number Interval = Common::Interval>
class Disks_of_radius
{
  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  Exact_rational m_exact_radius;
  Interval m_radius;

public:
  Disks_of_radius(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                  const Exact_rational& radius)
    : m_graph(graph), m_curvature(curvature), m_exact_radius(radius), m_radius(interval_of<Interval>(radius))
  {}

  const Exact_rational& exact_radius() const { return m_exact_radius; }
  const Interval& radius() const { return m_radius; }

  // T(u), and its derivative.
  Interval curvature(const Element_part<Interval>& part) const
  {
    return CGAL::sqrt(squared_norm(part.jet.normal)) / m_radius;
  }

  Interval slope(const Element_part<Interval>& part) const
  {
    return dot(part.jet.normal, part.jet.normal_derivative) / (CGAL::sqrt(squared_norm(part.jet.normal)) * m_radius);
  }

  // The sign of K - T if only the circle is known that an element is on the inner side of, by its exact radius; -1 for
  // other elements.
  int sign_in_own_circle(std::size_t element) const
  {
    if (!m_curvature.of_own_circle(m_curvature.part(element, {0.5, 0.5})))
      return -1;
    return sign_of(Exact_rational(m_exact_radius * m_exact_radius -
                                  m_graph.arcs()[m_graph.elements()[element].object].circle()->second));
  }

  // The sign of K - T in a point, if K belongs to a footpoint.
  int sign_at(std::size_t element, const Located_footpoint& located, double u) const
  {
    const Element_part<Interval> point = m_curvature.part(element, {u, u});
    return certain_sign(largest_curvature(m_graph, m_curvature, point, located).curvature - curvature(point));
  }

  // Whether K - T, which belongs to a footpoint, has one zero at most: where K' - T' has a sign, or, where disks and
  // elements are nearly parallel, by expansions of second order.
  bool is_touched_once(const Element_part<Interval>& part, const Located_footpoint& located) const
  {
    if (certain_sign(slope_of_largest_curvature(m_graph, m_curvature, part, located) - slope(part)) != 0)
      return true;
    const Disk_reach<Interval> reach(m_graph, m_graph.elements()[part.element], m_radius, part.range);
    const auto& [kind, index, side] = located.footpoint;
    return kind == Disk_footpoint::Kind::VERTEX
        ? reach.growth_where_vertex_is_touched(index) != 0
        : kind == Disk_footpoint::Kind::ARC && reach.growth_where_arc_is_touched(index, located.range) != 0;
  }

  // Whether the disks of a part hold points near the one that the smallest disk touches in the middle of what has been
  // divided: before candidates are bounded.
  bool hold_nearest(const Element_part<Interval>& part, const std::vector<Disk_candidate<Interval>>& candidates) const
  {
    const auto height = [](const Disk_candidate<Interval>& c) {
      return c.kind == Candidate_kind::ARC ? c.at_middle.inf() : -std::numeric_limits<double>::infinity();
    };
    const auto nearest = std::max_element(
        candidates.begin(), candidates.end(),
        [&](const Disk_candidate<Interval>& a, const Disk_candidate<Interval>& b) { return height(a) < height(b); });
    return nearest != candidates.end() && height(*nearest) > 0 &&
        Disk_reach<Interval>(m_graph, m_graph.elements()[part.element], m_radius, part.range)
            .hold_point_near(nearest->index, nearest->range.middle());
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_DISKS_OF_RADIUS_H
