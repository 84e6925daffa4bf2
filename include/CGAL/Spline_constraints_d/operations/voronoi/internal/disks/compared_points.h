// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_COMPARED_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_COMPARED_POINTS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The difference of the curvatures of the disks that pass through two points P and Q. With D = P - X and E = Q - P,

  k_P - k_Q = 2 F / (|D|^2 |D + E|^2),  F = <N, W>,  W = (2 <D, E> + |E|^2) D - |D|^2 E:

where the points are next to each other, it is known as well as E is, and as F changes.
*/
template <Enclosing_number Interval>
struct Compared_points
{
  using Interval_pair = std::array<Interval, 2>;

  Interval_pair p, way;   // P and E

  int sign(const Element_part<Interval>& x) const { return certain_sign(f(x)); }

  Interval difference(const Element_part<Interval>& x) const { return Interval(2) * f(x) / weight(x); }

  // The derivative of the difference by the parameter of the element, where both points stay.
  Interval slope(const Element_part<Interval>& x) const
  {
    const Interval two(2);
    const Interval_pair d = p - x.jet.point, &xu = x.jet.point_derivative;
    const Interval_pair wu =
        (-two * dot(xu, way)) * d - (two * dot(d, way) + squared_norm(way)) * xu + (two * dot(d, xu)) * way;
    const Interval fu = dot(x.jet.normal_derivative, w(d)) + dot(x.jet.normal, wu),
                   change_of_weight = -two * (dot(d, xu) / squared_norm(d) + dot(d + way, xu) / squared_norm(d + way));
    return two * (fu - f(x) * change_of_weight) / weight(x);
  }

private:
  Interval_pair w(const Interval_pair& d) const
  {
    return (Interval(2) * dot(d, way) + squared_norm(way)) * d - squared_norm(d) * way;
  }

  Interval f(const Element_part<Interval>& x) const { return dot(x.jet.normal, w(p - x.jet.point)); }

  Interval weight(const Element_part<Interval>& x) const
  {
    const Interval_pair d = p - x.jet.point;
    return squared_norm(d) * squared_norm(d + way);
  }
};

// A point of an arc, and those of a range.
template <Enclosing_number Interval>
Compared_points<Interval> compared_points(const Site_arc_2<Interval>& arc, const Range& p, const Range& q)
{
  const bool end = p.middle() + q.middle() > 1;
  return {arc.point(p), arc.way_from_end(end, q) - arc.way_from_end(end, p)};
}

/*
The difference of the curvatures of two footpoints over a part of an element, where both are vertices that are known
exactly, or on the same arc, one of them at an end or both inside; nothing is known of others, nor of scaled ones.
*/
template <Enclosing_number Interval>
Curvature_expansion<Interval>
difference_of_points(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                     const Element_part<Interval>& part, const Located_footpoint& a, const Located_footpoint& b)
{
  using Kind = Disk_footpoint::Kind;
  // as a vertex may be, where an arc ends that is not
  if (is_scaled(curvature, a.footpoint) || is_scaled(curvature, b.footpoint))
    return {};
  const auto is_exact_point = [&](const Disk_footpoint& c) {
    return c.kind == Kind::VERTEX && graph.vertices()[c.index].is_exact;
  };
  const double u = part.range.middle();
  const Element_part<Interval> middle = curvature.part(part.element, {u, u});
  const auto expansion = [&](const Compared_points<Interval>& there, const Compared_points<Interval>& throughout) {
    return Curvature_expansion<Interval>{there.difference(middle), there.slope(middle), throughout.slope(part),
                                         any_number<Interval>()};
  };
  if (is_exact_point(a.footpoint) && is_exact_point(b.footpoint)) {
    const Compared_points<Interval> points{graph.vertices()[a.footpoint.index].point,
                                           graph.way_between(a.footpoint.index, b.footpoint.index)};
    return expansion(points, points);
  }
  const Oriented_element<Interval>& element = graph.elements()[part.element];
  const std::size_t arc = (a.footpoint.kind == Kind::ARC ? a : b).footpoint.index;
  if ((a.footpoint.kind != Kind::ARC && b.footpoint.kind != Kind::ARC) ||
      (!element.is_normal_cone && element.object == arc))
    return {};
  // Where the footpoint is: over the part, and in its middle.
  const auto range = [&](const Located_footpoint& c, bool is_throughout) -> std::optional<Range> {
    for (const bool end : {false, true})
      if (c.footpoint.kind == Kind::VERTEX && graph.vertex_of({arc, end}) == c.footpoint.index &&
          graph.is_exact({arc, end}))
        return Range{end ? 1.0 : 0.0, end ? 1.0 : 0.0};
    if (c.footpoint.kind != Kind::ARC || c.footpoint.index != arc)
      return std::nullopt;
    if (is_throughout)
      return c.range;
    const auto greatest = largest_curvature(graph, curvature, middle, c);
    return greatest.is_attained ? std::optional(greatest.range) : std::nullopt;
  };
  const auto p = range(a, true), q = range(b, true), p_there = p && q ? range(a, false) : std::nullopt,
             q_there = p && q ? range(b, false) : std::nullopt;
  return p_there && q_there
      ? expansion(compared_points(graph.arcs()[arc], *p_there, *q_there), compared_points(graph.arcs()[arc], *p, *q))
      : Curvature_expansion<Interval>();
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_COMPARED_POINTS_H
