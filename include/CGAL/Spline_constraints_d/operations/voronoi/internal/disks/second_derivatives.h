// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_SECOND_DERIVATIVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_SECOND_DERIVATIVES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>

#include <array>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Of the point of an element, and of its normal, over a part; of a normal cone they are zero.
template <Enclosing_number Interval>
std::array<std::array<Interval, 2>, 2> second_derivatives(const Site_graph_2<Interval>& graph,
                                                          const Element_part<Interval>& part)
{
  const Oriented_element<Interval>& element = graph.elements()[part.element];
  if (element.is_normal_cone) {
    const std::array<Interval, 2> zero{Interval(0), Interval(0)};
    return {zero, zero};
  }
  const Site_arc_2<Interval>& arc = graph.arcs()[element.object];
  const Curve_jet<Interval> jet = arc.jet(part.range, 3);
  return {jet[2],
          Interval(element.is_reversed ? -1 : 1) *
              turned_left(arc.has_singular_end() ? arc.second_derivative_of_tangent(part.range) : jet[3])};
}

// Of the curvature of disks by the parameter of the element, for points in a box that is not scaled, where the
// curvature and its first derivative are enclosed.
template <Enclosing_number Interval>
Interval second_derivative_of_curvature(const Site_graph_2<Interval>& graph, const Element_part<Interval>& part,
                                        const std::array<Interval, 2>& box, const Curvature_bounds<Interval>& k)
{
  const auto& [x, xu, n, nu] = part.jet;
  const auto [xuu, nuu] = second_derivatives(graph, part);
  const Interval two(2);
  const std::array<Interval, 2> d = box - x;
  const Interval q = squared_norm(d), qu = -two * dot(d, xu), quu = two * (squared_norm(xu) - dot(d, xuu)),
                 fuu = two * (dot(nuu, d) - dot(nu, xu));
  return q.inf() > 0 ? (fuu - k.value * quu - two * k.du * qu) / q : any_number<Interval>();
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_SECOND_DERIVATIVES_H
