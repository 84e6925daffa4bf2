// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_SIGN_BY_TANGENT_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_SIGN_BY_TANGENT_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
A sign that a function finds in the expansion of the difference of the curvatures of two footpoints, k_a - k_b, times a
positive function, over a part of an element where the disks of one of them touch its line or circle; 0 if it finds
none.
*/
template <Enclosing_number Interval, class Sign_in>
int sign_by_tangent_disks(const Basic_site_graph_2<Interval>& graph, const Basic_disk_curvature<Interval>& curvature,
                          const Basic_element_part<Interval>& part, const Located_footpoint& a,
                          const Located_footpoint& b, const Sign_in& sign_in)
{
  const auto sign = [&](const Located_footpoint& tangent, const Located_footpoint& other) {
    const auto disks = tangent_disks(graph, curvature, part, tangent.footpoint);
    return disks ? sign_in(disks->difference(curvature_expansion(graph, curvature, part, other))) : 0;
  };
  const int first = sign(a, b);
  return first != 0 ? first : -sign(b, a);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_SIGN_BY_TANGENT_DISKS_H
