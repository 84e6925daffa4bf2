// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_TOUCHED_ELEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_TOUCHED_ELEMENT_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_footpoints.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// An element that a disk touches, and a range with the parameter of the footpoint there.
struct Touched_element
{
  std::size_t element;
  Range range;
};

// Whether the disks of a footpoint may touch an element.
template <Enclosing_number Interval>
bool is_footpoint_with(const Disk_footpoint& footpoint, const Oriented_element<Interval>& element)
{
  return footpoint.index == element.object &&
      footpoint.kind == (element.is_normal_cone ? Disk_footpoint::Kind::VERTEX : Disk_footpoint::Kind::ARC);
}

// The element of a footpoint: the side of the arc on which the center of the disk is, or the only normal cone of the
// vertex that may have the normal towards it; nothing if that is not certain. The range is that of the parameter of an
// arc.
template <Enclosing_number Interval>
std::optional<Touched_element> touched_element(const Site_graph_2<Interval>& graph, const Disk_footpoint& footpoint,
                                               const Range& range, const std::array<Interval, 2>& center)
{
  if (footpoint.kind == Disk_footpoint::Kind::ARC) {
    const Site_arc_2<Interval>& arc = graph.arcs()[footpoint.index];
    const int side = certain_sign(dot(turned_left(arc.direction_over(range)), center - arc.point(range)));
    return side == 0 ? std::nullopt : std::optional(Touched_element{2 * footpoint.index + (side < 0), range});
  }
  const auto& vertex = graph.vertices()[footpoint.index];
  const std::array<Interval, 2> way = center - vertex.point;
  std::optional<Touched_element> result;
  for (const std::size_t normal_cone : vertex.normal_cones) {
    const auto& [from, to] = graph.elements()[normal_cone].normals;
    const Interval a = dot(turned_left(way), from), b = dot(turned_left(to), way);   // way x from, to x way
    if (a.sup() < 0 || b.sup() < 0 || (dot(way, from).sup() < 0 && dot(way, to).sup() < 0))
      continue;
    if (result)
      return std::nullopt;
    const Interval u = a.inf() > 0 && b.inf() > 0 ? a / (a + b) : Interval(0, 1);
    result = Touched_element{normal_cone, {(std::max)(u.inf(), 0.0), (std::min)(u.sup(), 1.0)}};
  }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_TOUCHED_ELEMENT_H
