// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_MIRRORED_CONTACT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_MIRRORED_CONTACT_H

#include <CGAL/Spline_constraints_d/operations/internal/Located_contact.h>
#include <CGAL/Spline_constraints_d/operations/internal/Reflection_2.h>

#include <cstddef>
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

template <Enclosing_number Interval>
bool is_exact_arc(const Basic_site_graph_2<Interval>& graph, const Disk_contact& contact)
{
  return contact.kind == Disk_contact::Kind::ARC && graph.is_exact({contact.index, false}) && graph.is_exact({contact.index, true});
}

template <Enclosing_number Interval>
bool is_exact_vertex(const Basic_site_graph_2<Interval>& graph, const Disk_contact& contact)
{
  return contact.kind == Disk_contact::Kind::VERTEX && graph.vertices()[contact.index].is_exact;
}

// Whether the ends of two arcs are certain to be at different distances: no reflection maps one to the other then.
template <Enclosing_number Interval>
bool have_different_chords(const Basic_site_graph_2<Interval>& graph, std::size_t a, std::size_t b)
{
  const auto chord = [&](std::size_t arc) { return squared_norm(graph.vertices()[graph.vertex_of({arc, true})].point - graph.vertices()[graph.vertex_of({arc, false})].point); };
  return certain_sign(chord(a) - chord(b)) != 0;
}

// The reflections that map a contact to another one.
template <Enclosing_number Interval>
std::vector<Reflection_2> reflections(const Basic_site_graph_2<Interval>& graph, const Disk_contact& from, const Disk_contact& to)
{
  std::vector<Reflection_2> result;
  const auto append = [&](const std::optional<Reflection_2>& reflection) {
    if (reflection)
      result.push_back(*reflection);
  };
  if (is_exact_vertex(graph, from) && is_exact_vertex(graph, to))
    append(Reflection_2::of_points(graph.vertices()[from.index].exact_point, graph.vertices()[to.index].exact_point));
  if (!is_exact_arc(graph, from) || !is_exact_arc(graph, to))
    return result;
  const Exact_arc_2 &a = graph.arcs()[from.index], &b = graph.arcs()[to.index];
  if (a.is_segment() && b.is_segment())
    return Reflection_2::of_lines(a, b);
  if (have_different_chords(graph, from.index, to.index))
    return result;
  for (const bool is_reversed : {false, true})
    append(Reflection_2::of_arcs(a, b, is_reversed));
  return result;
}

// The range of the parameter of an arc that is the image of one of another arc; of segments as much as on their lines.
inline std::optional<Range> mirrored_range(const Reflection_2& mirror, const Exact_arc_2& from, const Range& range, const Exact_arc_2& to)
{
  if (from.is_segment() && to.is_segment()) {
    const Exact_pair p = mirror(from.at(0)), q = mirror(from.at(1)), c = to.at(0), d = to.at(1), along{Exact_rational(d[0] - c[0]), Exact_rational(d[1] - c[1])};
    if (!to.is_on_line_or_circle(p) || !to.is_on_line_or_circle(q))
      return std::nullopt;
    const auto place = [&](const Exact_pair& x) { return Exact_rational(exact_dot(along, Exact_pair{Exact_rational(x[0] - c[0]), Exact_rational(x[1] - c[1])}) / exact_dot(along, along)); };
    const Interval image = interval_of(place(p)) + interval_of<Interval>(Exact_rational(place(q) - place(p))) * range.interval();
    return Range{image.inf(), image.sup()};
  }
  if (mirror.maps(from, to, false))
    return range;
  const Interval reversed = Interval(1) - range.interval();
  return mirror.maps(from, to, true) ? std::optional(Range{reversed.inf(), reversed.sup()}) : std::nullopt;
}

// The image of a point if it is on another contact.
template <Enclosing_number Interval>
std::optional<Touched_point> mirrored(const Basic_site_graph_2<Interval>& graph, const Reflection_2& mirror, const Touched_point& point, const Disk_contact& contact)
{
  if (is_exact_vertex(graph, point.contact) && is_exact_vertex(graph, contact) && mirror(graph.vertices()[point.contact.index].exact_point) == graph.vertices()[contact.index].exact_point)
    return Touched_point{contact, {}};
  if (is_exact_arc(graph, point.contact) && is_exact_arc(graph, contact))
    if (const auto range = mirrored_range(mirror, graph.arcs()[point.contact.index], point.range, graph.arcs()[contact.index]))
      return Touched_point{contact, *range};
  return std::nullopt;
}

// Whether a point in which the curvature of disks through an arc is stationary is that of a contact: its range holds it, and the curvature is concave there.
template <Enclosing_number Interval>
bool is_only_maximum(const Basic_site_graph_2<Interval>& graph, const Basic_disk_curvature<Interval>& curvature, const Basic_front_part<Interval>& part, const Touched_point& point, const Located_contact& located)
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
