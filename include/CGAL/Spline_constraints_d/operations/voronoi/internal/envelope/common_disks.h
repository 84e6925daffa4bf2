// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_DISKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_DISKS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_branch.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Common_disk.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Common_half_plane.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Common_line.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Mirrored_disk.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
One disk that touches an element and all of several footpoints.
*/

// About the centers of the disks over a part of an element, with one footpoint where it begins and another one where
// it ends; between, they may go a little farther than there.
template <Enclosing_number Interval>
std::array<Interval, 2> enclosed_centers(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                                         const Element_part<Interval>& part, const Located_footpoint& first,
                                         const Located_footpoint& last)
{
  const auto at = [&](double u, const Located_footpoint& footpoint) {
    const Element_part<Interval> point = curvature.part(part.element, {u, u});
    const Interval k = largest_curvature(graph, curvature, point, footpoint).curvature;
    return std::array<Interval, 2>{point.jet.point[0] + point.jet.normal[0] / k,
                                   point.jet.point[1] + point.jet.normal[1] / k};
  };
  const std::array<Interval, 2> ends = hull(at(part.range.begin, first), at(part.range.end, last));
  const double way = (std::max)(ends[0].sup() - ends[0].inf(), ends[1].sup() - ends[1].inf());
  return {ends[0] + Interval(-way, way), ends[1] + Interval(-way, way)};
}

// Whether a disk with its center in an enclosure touches a part and all footpoints: by the simplest rational numbers,
// by symmetry, or as a half-plane that touches copies, or has a rational border.
template <Enclosing_number Interval>
bool is_disk_common(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                    const Element_part<Interval>& part, const std::vector<Disk_branch>& branches,
                    const std::array<Interval, 2>& center)
{
  const Common_disk<Interval> disk(graph, curvature, center, branches);
  const auto touches = [&](const Disk_branch& branch) {
    return branch.move ? disk.touches_end({branch.move->arc, branch.move->parameter == 1}) : disk.touches(branch);
  };
  return (disk.touches(part) && std::all_of(branches.begin(), branches.end(), touches)) ||
      Mirrored_disk<Interval>(graph, curvature, part, branches).touches_all() ||
      Common_half_plane<Interval>(graph, curvature, part).touches_all(branches) ||
      Common_line<Interval>(graph, curvature, part).touches_all(branches);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_COMMON_DISKS_H
