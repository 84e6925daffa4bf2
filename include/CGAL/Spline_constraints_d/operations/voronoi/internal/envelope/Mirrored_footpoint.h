// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MIRRORED_FOOTPOINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MIRRORED_FOOTPOINT_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Reflection_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Arc_parameter.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// A point that a disk touches: a vertex, or one in a range of an arc.
struct Touched_point
{
  Disk_footpoint footpoint;
  Range range;
};

template <Enclosing_number Interval>
bool is_exact_vertex(const Site_graph_2<Interval>& graph, const Disk_footpoint& footpoint)
{
  return footpoint.kind == Disk_footpoint::Kind::VERTEX && graph.vertices()[footpoint.index].is_exact;
}

// Whether two arcs, which are not cut, are certain to have their ends at different distances: no reflection maps one to
// the other then.
template <Enclosing_number Interval>
bool have_different_chords(const Site_graph_2<Interval>& graph, std::size_t a, std::size_t b)
{
  if (graph.arcs()[a].piece().whole || graph.arcs()[b].piece().whole)
    return false;
  const auto chord = [&](std::size_t arc) {
    return squared_norm(graph.vertices()[graph.vertex_of({arc, true})].point -
                        graph.vertices()[graph.vertex_of({arc, false})].point);
  };
  return certain_sign(chord(a) - chord(b)) != 0;
}

// The reflections that map a footpoint to another one.
template <Enclosing_number Interval>
std::vector<Reflection_2> reflections(const Site_graph_2<Interval>& graph, const Disk_footpoint& from,
                                      const Disk_footpoint& to)
{
  std::vector<Reflection_2> result;
  const auto append = [&](const std::optional<Reflection_2>& reflection) {
    if (reflection)
      result.push_back(*reflection);
  };
  if (is_exact_vertex(graph, from) && is_exact_vertex(graph, to))
    append(Reflection_2::of_points(graph.vertices()[from.index].exact_point, graph.vertices()[to.index].exact_point));
  if (from.kind != Disk_footpoint::Kind::ARC || to.kind != Disk_footpoint::Kind::ARC)
    return result;
  const Exact_arc_2 &a = graph.arcs()[from.index], &b = graph.arcs()[to.index];
  if (a.is_segment() && b.is_segment())
    return Reflection_2::of_lines(a, b);
  if (a.degree() != b.degree() || have_different_chords(graph, from.index, to.index))
    return result;
  for (const bool is_reversed : {false, true})
    append(Reflection_2::of_pieces(a.piece().uncut(), b.piece().uncut(), is_reversed));
  return result;
}

// The range of the parameter of an arc whose points have the parameters of those of another one in the pieces before
// they were cut, or 1 minus these.
template <Enclosing_number Number>
Range corresponding_range(const Site_graph_2<Number>& graph, std::size_t from, const Range& range, std::size_t to,
                          bool is_reversed)
{
  const Interval t = Arc_parameter(graph, from).to_uncut(range.interval()),
                 image = Arc_parameter(graph, to).from_uncut(is_reversed ? Interval(1) - t : t);
  return {image.inf(), image.sup()};
}

// The range of the parameter of an arc that is the image of one of another arc; of segments as much as on their lines.
template <Enclosing_number Number>
std::optional<Range> mirrored_range(const Site_graph_2<Number>& graph, const Reflection_2& mirror, std::size_t arc,
                                    const Range& range, std::size_t image_arc)
{
  const Exact_arc_2 &from = graph.arcs()[arc], &to = graph.arcs()[image_arc];
  if (from.is_segment() && to.is_segment()) {
    const Exact_pair p = mirror(from.at(0)), q = mirror(from.at(1));
    if (!to.is_on_line_or_circle(p) || !to.is_on_line_or_circle(q))
      return std::nullopt;
    const Exact_rational begin = to.parameter_of_foot(p), length = to.parameter_of_foot(q) - begin;
    const Interval image =
        Arc_parameter(graph, image_arc)
            .from_piece(interval_of(begin) +
                        interval_of<Interval>(length) * Arc_parameter(graph, arc).to_piece(range.interval()));
    return Range{image.inf(), image.sup()};
  }
  const Homogeneous_piece piece = from.piece().uncut(), other = to.piece().uncut();
  for (const bool is_reversed : {false, true})
    if (mirror.maps(piece, other, is_reversed))
      return corresponding_range(graph, arc, range, image_arc, is_reversed);
  return std::nullopt;
}

// The image of a point if it is on another footpoint.
template <Enclosing_number Interval>
std::optional<Touched_point> mirrored(const Site_graph_2<Interval>& graph, const Reflection_2& mirror,
                                      const Touched_point& point, const Disk_footpoint& footpoint)
{
  if (is_exact_vertex(graph, point.footpoint) && is_exact_vertex(graph, footpoint) &&
      mirror(graph.vertices()[point.footpoint.index].exact_point) == graph.vertices()[footpoint.index].exact_point)
    return Touched_point{footpoint, {}};
  if (point.footpoint.kind == Disk_footpoint::Kind::ARC && footpoint.kind == Disk_footpoint::Kind::ARC)
    if (const auto range = mirrored_range(graph, mirror, point.footpoint.index, point.range, footpoint.index))
      return Touched_point{footpoint, *range};
  return std::nullopt;
}

// Whether a point in which the curvature of disks through an arc is stationary is that of a footpoint: its range holds
// it, and the curvature is concave there.
template <Enclosing_number Interval>
bool is_only_maximum(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature,
                     const Element_part<Interval>& part, const Touched_point& point, const Located_footpoint& located)
{
  if (located.footpoint.kind != Disk_footpoint::Kind::ARC)
    return true;
  const auto& [begin, end] = located.range;
  return begin <= point.range.begin && point.range.end <= end &&
      curvature(part, located.footpoint.index, located.range, graph.arcs()[located.footpoint.index].jet(located.range))
          .dvv.sup() < 0;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_MIRRORED_FOOTPOINT_H
