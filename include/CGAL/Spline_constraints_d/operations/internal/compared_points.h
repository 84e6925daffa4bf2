// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_COMPARED_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_COMPARED_POINTS_H

#include <CGAL/Spline_constraints_d/operations/internal/Located_contact.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The difference of the curvatures of the disks that pass through two points P and Q, both known exactly, times a positive number. With D = P - X and E = Q - P,

  k_P - k_Q = 2 <N, W> / (|D|^2 |D + E|^2),  W = (2 <D, E> + |E|^2) D - |D|^2 E:

where the points are next to each other, it is known as well as E is.
*/
template <Enclosing_number Interval>
Basic_curvature_expansion<Interval> scaled_difference_of_points(const Basic_site_graph_2<Interval>& graph, const Basic_disk_curvature<Interval>& curvature, const Basic_front_part<Interval>& part, std::size_t p, std::size_t q)
{
  const Interval two(2);
  const std::array<Interval, 2> e = graph.way_between(p, q);
  const auto w = [&](const Basic_front_part<Interval>& x) {
    const std::array<Interval, 2> d = graph.vertices()[p].point - x.jet.point;
    return (two * dot(d, e) + squared_norm(e)) * d - squared_norm(d) * e;
  };
  const auto slope = [&](const Basic_front_part<Interval>& x) {
    const std::array<Interval, 2> d = graph.vertices()[p].point - x.jet.point, &xu = x.jet.point_derivative;
    const std::array<Interval, 2> wu = (-two * dot(xu, e)) * d - (two * dot(d, e) + squared_norm(e)) * xu + (two * dot(d, xu)) * e;
    return dot(x.jet.normal_derivative, w(x)) + dot(x.jet.normal, wu);
  };
  const double u = part.range.middle();
  const Basic_front_part<Interval> middle = curvature.part(part.front, {u, u});
  return {dot(middle.jet.normal, w(middle)), slope(middle), slope(part), any_number<Interval>()};
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_COMPARED_POINTS_H
