// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_TOUCHED_FRONT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_TOUCHED_FRONT_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Disk_contacts.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A front that a disk touches, and a range with the parameter of the contact there.
struct Touched_front
{
  std::size_t front;
  Range range;
};

// Whether the disks of a contact may touch a front.
template <Enclosing_number Interval>
bool is_contact_with(const Disk_contact& contact, const Basic_front<Interval>& front)
{
  return contact.index == front.object && contact.kind == (front.is_fan ? Disk_contact::Kind::VERTEX : Disk_contact::Kind::ARC);
}

// The front of a contact: the side of the arc on which the center of the disk is, or the only fan of the vertex that may have the normal towards it; nothing if that is not certain. The range is that of the parameter of an arc.
template <Enclosing_number Interval>
std::optional<Touched_front> touched_front(const Basic_site_graph_2<Interval>& graph, const Disk_contact& contact, const Range& range, const std::array<Interval, 2>& center)
{
  if (contact.kind == Disk_contact::Kind::ARC) {
    const Basic_site_arc_2<Interval>& arc = graph.arcs()[contact.index];
    const int side = certain_sign(dot(turned_left(arc.direction_over(range)), center - arc.point(range)));
    return side == 0 ? std::nullopt : std::optional(Touched_front{2 * contact.index + (side < 0), range});
  }
  const auto& vertex = graph.vertices()[contact.index];
  const std::array<Interval, 2> way = center - vertex.point;
  std::optional<Touched_front> result;
  for (const std::size_t fan : vertex.fans) {
    const auto& [from, to] = graph.fronts()[fan].normals;
    const Interval a = dot(turned_left(way), from), b = dot(turned_left(to), way);   // way x from, to x way
    if (a.sup() < 0 || b.sup() < 0 || (dot(way, from).sup() < 0 && dot(way, to).sup() < 0))
      continue;
    if (result)
      return std::nullopt;
    const Interval u = a.inf() > 0 && b.inf() > 0 ? a / (a + b) : Interval(0, 1);
    result = Touched_front{fan, {(std::max)(u.inf(), 0.0), (std::min)(u.sup(), 1.0)}};
  }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_TOUCHED_FRONT_H
