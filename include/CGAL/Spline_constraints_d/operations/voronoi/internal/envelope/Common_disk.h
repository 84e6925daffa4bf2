// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_DISK_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_DISK_H

#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_branch.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Rational_disk.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_footpoints.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
A disk with a rational center and a rational squared radius that is a guess for one that touches an element and three
footpoints or more, as in the center of a square. That it does so is decided exactly where these are points, or lie on
lines and circles. Scaled sites are touched by the scaled disk.
*/
template <Enclosing_number Interval = Common::Interval>
class Common_disk
{
  using Interval_pair = std::array<Interval, 2>;

  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;
  Exact_pair m_center;
  Interval_pair m_enclosed_center;
  std::optional<Exact_rational> m_squared_radius;

public:
  // The center is the simplest one in an enclosure.
  Common_disk(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
              const Interval_pair& center, std::span<const Disk_branch> footpoints)
    : m_graph(graph), m_curvature(curvature)
  {
    for (std::size_t k = 0; k < 2; ++k) {
      if (!std::isfinite(center[k].inf()) || !std::isfinite(center[k].sup()))
        return;
      m_center[k] = simplest_rational_between(Exact_rational(center[k].inf()), Exact_rational(center[k].sup()));
      m_enclosed_center[k] = interval_of<Interval>(m_center[k]);
    }
    for (const Disk_branch& footpoint : footpoints)
      if (!m_squared_radius)
        m_squared_radius = footpoint.move ? squared_radius_at_end({footpoint.move->arc, footpoint.move->parameter == 1})
                                          : squared_radius(footpoint.footpoint);
  }

  // Whether it touches a part of an element, on the side of the normals.
  bool touches(const Element_part<Interval>& part) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    const Interval_pair away = m_enclosed_center - part.jet.point;
    if (!m_squared_radius || !(dot(part.jet.normal, away).inf() > 0))
      return false;
    if (!element.is_normal_cone)
      return touches_arc(m_graph.arcs()[element.object], part.range, {m_center, *m_squared_radius});
    const auto turn = [&](double u) {
      return certain_sign(dot(turned_left(m_graph.element_jet(element, {u, u}).normal), away));
    };
    return touches(m_graph.vertices()[element.object], {m_center, *m_squared_radius}) &&
        turn(part.range.begin) * turn(part.range.end) < 0;
  }

  // Whether it touches the same thing as the disks of a branch.
  bool touches(const Located_footpoint& located) const
  {
    if (!m_squared_radius)
      return false;
    const Rational_disk disk = scaled_disk(located.footpoint);
    if (located.footpoint.kind == Disk_footpoint::Kind::VERTEX)
      return touches(m_graph.vertices()[located.footpoint.index], disk);
    return located.footpoint.kind == Disk_footpoint::Kind::ARC &&
        touches_arc(m_graph.arcs()[located.footpoint.index], located.range, disk);
  }

  // Whether it touches an arc in its end: the center is on the perpendicular there.
  bool touches_end(const Arc_end& end) const
  {
    if (!m_squared_radius || !m_graph.is_exact(end))
      return false;
    const Exact_pair q = m_graph.arcs()[end.arc].at(Exact_rational(end.parameter()));
    return scaled_disk(arc_of(end)).touches(q) &&
        sign_of(exact_dot(exact_difference(m_center, q), m_graph.direction(end))) == 0;
  }

private:
  static Disk_footpoint arc_of(const Arc_end& end) { return {Disk_footpoint::Kind::ARC, end.arc}; }

  // The one that touches what a footpoint is on, if that is scaled.
  Rational_disk scaled_disk(const Disk_footpoint& footpoint) const
  {
    return {m_center, Exact_rational(*m_squared_radius * squared_factor(m_curvature, footpoint))};
  }

  static bool touches(const typename Site_graph_2<Interval>::Vertex& vertex, const Rational_disk& disk)
  {
    return vertex.is_exact && disk.touches(vertex.exact_point);
  }

  // Of the disk that touches the point in which a footpoint goes over from an arc to the next one.
  std::optional<Exact_rational> squared_radius_at_end(const Arc_end& end) const
  {
    if (!m_graph.is_exact(end))
      return std::nullopt;
    const Exact_pair q = m_graph.arcs()[end.arc].at(Exact_rational(end.parameter()));
    return Exact_rational(squared_distance_of<2>(m_center, q) / squared_factor(m_curvature, arc_of(end)));
  }

  // The squared radius of the disk that touches a footpoint, if it is known to be rational.
  std::optional<Exact_rational> squared_radius(const Disk_footpoint& footpoint) const
  {
    if (footpoint.kind == Disk_footpoint::Kind::VERTEX && m_graph.vertices()[footpoint.index].is_exact)
      return Exact_rational(squared_distance_of<2>(m_center, m_graph.vertices()[footpoint.index].exact_point) /
                            squared_factor(m_curvature, footpoint));
    if (footpoint.kind == Disk_footpoint::Kind::ARC && m_graph.arcs()[footpoint.index].is_straight())
      return Exact_rational(squared_distance_from_line(m_center, m_graph.arcs()[footpoint.index]) /
                            squared_factor(m_curvature, footpoint));
    if (footpoint.kind == Disk_footpoint::Kind::ARC && m_graph.arcs()[footpoint.index].circle())
      return squared_distance_from_circle(*m_graph.arcs()[footpoint.index].circle(),
                                          squared_factor(m_curvature, footpoint));
    return std::nullopt;
  }

  // (d - r)^2 = d^2 + r^2 - 2 d r.
  std::optional<Exact_rational> squared_distance_from_circle(const std::pair<Exact_pair, Exact_rational>& circle,
                                                             const Exact_rational& squared_factor) const
  {
    const Exact_rational square = squared_distance_of<2>(m_center, circle.first);
    const auto product = rational_square_root(Exact_rational(square * circle.second));
    return product ? std::optional(Exact_rational((square + circle.second - 2 * *product) / squared_factor))
                   : std::nullopt;
  }

  // Whether it touches the line or circle of an arc, and the distance has its minimum in a range.
  bool touches_arc(const Site_arc_2<Interval>& arc, const Range& range, const Rational_disk& disk) const
  {
    const auto approach = [&](double v) {
      const Curve_jet<Interval> y = arc.jet({v, v}, 1);
      return certain_sign(dot(m_enclosed_center - y[0], y[1]));
    };
    return disk.touches_line_or_circle(arc) && approach(range.begin) > 0 && approach(range.end) < 0;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_DISK_H
