// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_MIRRORED_CONTACT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_MIRRORED_CONTACT_H

#include <CGAL/Spline_constraints_d/operations/internal/Located_contact.h>
#include <CGAL/Spline_constraints_d/operations/internal/Reflection_2.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A point that a disk touches: a vertex, or one in a range of an arc.
struct Touched_point
{
  Disk_contact contact;
  Range range;
};

inline bool is_exact_arc(const Site_graph_2& graph, const Disk_contact& contact) { return contact.kind == Disk_contact::Kind::ARC && graph.is_exact({contact.index, false}) && graph.is_exact({contact.index, true}); }

inline bool is_exact_vertex(const Site_graph_2& graph, const Disk_contact& contact) { return contact.kind == Disk_contact::Kind::VERTEX && graph.vertices()[contact.index].is_exact; }

// The reflections that map a contact to another one.
inline std::vector<Reflection_2> reflections(const Site_graph_2& graph, const Disk_contact& from, const Disk_contact& to)
{
  std::vector<Reflection_2> result;
  const auto append = [&](const std::optional<Reflection_2>& reflection) {
    if (reflection)
      result.push_back(*reflection);
  };
  if (is_exact_vertex(graph, from) && is_exact_vertex(graph, to))
    append(Reflection_2::of_points(graph.vertices()[from.index].exact_point, graph.vertices()[to.index].exact_point));
  if (is_exact_arc(graph, from) && is_exact_arc(graph, to))
    for (const bool is_reversed : {false, true})
      append(Reflection_2::of_arcs(graph.arcs()[from.index], graph.arcs()[to.index], is_reversed));
  return result;
}

// The image of a point if it is on another contact.
inline std::optional<Touched_point> mirrored(const Site_graph_2& graph, const Reflection_2& mirror, const Touched_point& point, const Disk_contact& contact)
{
  if (is_exact_vertex(graph, point.contact) && is_exact_vertex(graph, contact))
    return mirror(graph.vertices()[point.contact.index].exact_point) == graph.vertices()[contact.index].exact_point ? std::optional(Touched_point{contact, {}}) : std::nullopt;
  if (is_exact_arc(graph, point.contact) && is_exact_arc(graph, contact))
    for (const bool is_reversed : {false, true})
      if (mirror.maps(graph.arcs()[point.contact.index], graph.arcs()[contact.index], is_reversed))
        return Touched_point{contact, is_reversed ? Range{(Interval(1) - Interval(point.range.end)).inf(), (Interval(1) - Interval(point.range.begin)).sup()} : point.range};
  return std::nullopt;
}

// Whether a point in which the curvature of disks through an arc is stationary is that of a contact: its range holds it, and the curvature is concave there.
inline bool is_only_maximum(const Site_graph_2& graph, const Disk_curvature& curvature, const Front_part& part, const Touched_point& point, const Located_contact& located)
{
  if (located.contact.kind != Disk_contact::Kind::ARC)
    return true;
  const auto& [begin, end] = located.range;
  return begin <= point.range.begin && point.range.end <= end && curvature(part, located.contact.index, located.range, graph.arcs()[located.contact.index].jet(located.range)).dvv.sup() < 0;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_MIRRORED_CONTACT_H
