// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_VERTEX_BOUNDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_VERTEX_BOUNDS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Disk_diagram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// What is proved of the disk of a vertex.
template <Enclosing_number Interval = Common::Interval>
struct Vertex_bounds
{
  std::array<Interval, 2> center{any_number<Interval>(), any_number<Interval>()};
  Interval radius = Interval(0, std::numeric_limits<double>::infinity());

  bool are_narrow() const
  {
    constexpr double most_error = 0x1p-30;   // of the radius
    const auto width = [](const Interval& x) { return x.sup() - x.inf(); };
    return (std::max)({width(center[0]), width(center[1]), width(radius)}) < most_error * radius.sup();
  }
};

/*
Bounds of the disk of a vertex, which is the disk of an event on each of the elements around it: it touches them between
the envelope arcs that end there. Two such points that are apart determine it: k(u,v) of one element, over that range of
u, with the range of the other one for v. In the end of an edge, where both points come together, it has the curvature
of the element, and where two elements join, the greater one of theirs.
*/
template <Enclosing_number Interval>
class Vertex_disk
{
  const Site_graph_2<Interval>& m_graph;
  const Disk_curvature<Interval>& m_curvature;

public:
  Vertex_disk(const Site_graph_2<Interval>& graph, const Disk_curvature<Interval>& curvature)
    : m_graph(graph), m_curvature(curvature)
  {}

  // Where it touches elements.
  Vertex_bounds<Interval> by_footpoints(const std::vector<Element_range>& footpoints) const
  {
    Vertex_bounds<Interval> result;
    for (const Element_range& footpoint : footpoints) {
      const Element_part<Interval> part = m_curvature.part(footpoint.element, footpoint.range);
      for (const Element_range& other : footpoints)
        if (are_apart(part, other))
          add(result, part, curvature(part, other));
    }
    return result;
  }

  // Where the elements of both sides of an edge meet; of a normal cone and an arc, in the end of that.
  Vertex_bounds<Interval> by_curvatures(const std::array<Element_range, 2>& sides) const
  {
    const Vertex_bounds<Interval> a = by_curvature(sides[0]), b = by_curvature(sides[1]);
    const auto is_normal_cone = [&](const Element_range& side) {
      return m_graph.elements()[side.element].is_normal_cone;
    };
    if (is_normal_cone(sides[0]) || is_normal_cone(sides[1]))
      return is_normal_cone(sides[0]) ? b : a;
    if (sides[0].range.is_number() && sides[1].range.is_number() &&
        (a.radius.sup() < b.radius.inf() || b.radius.sup() < a.radius.inf()))
      return a.radius.sup() < b.radius.inf() ? a : b;
    return {{hull(a.center[0], b.center[0]), hull(a.center[1], b.center[1])}, hull(a.radius, b.radius)};
  }

private:
  Vertex_bounds<Interval> by_curvature(const Element_range& side) const
  {
    Vertex_bounds<Interval> result;
    if (m_graph.elements()[side.element].is_normal_cone)
      return result;
    const Element_part<Interval> part = m_curvature.part(side.element, side.range);
    add(result, part, curvature(part, side));
    return result;
  }

  bool are_apart(const Element_part<Interval>& part, const Element_range& other) const
  {
    return squared_norm(part.jet.point - m_graph.element_jet(m_graph.elements()[other.element], other.range).point)
               .inf() > 0;
  }

  // Of the disks that touch an element, and another one, or the same one there.
  Interval curvature(const Element_part<Interval>& part, const Element_range& other) const
  {
    const auto& element = m_graph.elements()[other.element];
    return element.is_normal_cone
        ? m_curvature(part, element.object).value
        : m_curvature(part, element.object, other.range, m_graph.arcs()[element.object].jet(other.range)).value;
  }

  static void add(Vertex_bounds<Interval>& result, const Element_part<Interval>& part, const Interval& k)
  {
    result.radius = common_part(result.radius, radius_of_disk(part.jet.normal, k));
    for (std::size_t i = 0; i < 2 && k.inf() > 0; ++i)
      result.center[i] = common_part(result.center[i], part.jet.point[i] + part.jet.normal[i] / k);
  }
};

// The disk of a vertex as that of a circle that it touches everywhere, or as the point of a corner, if it is one of
// these.
inline std::optional<Vertex_bounds<>>
bounds_of_circle_or_corner(const Site_graph_2<>& graph, const Disk_diagram& diagram, const Disk_diagram::Vertex& vertex)
{
  for (const std::size_t h : vertex.outgoing)
    if (const auto arc = diagram.circle_before(h))
      return Vertex_bounds<>{graph.arcs()[*arc].center(), CGAL::sqrt(graph.arcs()[*arc].squared_radius())};
  const std::size_t first = vertex.outgoing.front(), twin = diagram.halfedges()[first].twin;
  if (vertex.outgoing.size() == 1)
    for (const auto& [halfedge, end] : {std::pair(first, false), std::pair(twin, true)})
      if (const auto corner = diagram.corner_at_end(halfedge, end))
        return Vertex_bounds<>{*corner, Interval(0)};
  return std::nullopt;
}

// Bounds of the disk of a vertex, by doubles or, where these tell too little, with numbers of higher precision; none if
// the vertex is not resolved or at infinity.
inline Vertex_bounds<> vertex_bounds(const Site_graph_2<>& graph, const Disk_diagram& diagram,
                                     const Disk_diagram::Vertex& vertex)
{
  if (vertex.is_at_infinity || !vertex.is_resolved)
    return {};
  if (const auto simple = bounds_of_circle_or_corner(graph, diagram, vertex))
    return *simple;
  std::vector<Element_range> footpoints;
  for (const std::size_t h : vertex.outgoing)
    footpoints.push_back(diagram.range_of_end(h, false));
  const std::size_t twin = diagram.halfedges()[vertex.outgoing.front()].twin;
  const auto bounds = [&](const auto& on_level) {
    return footpoints.size() == 1 ? on_level.by_curvatures({footpoints[0], diagram.range_of_end(twin, true)})
                                  : on_level.by_footpoints(footpoints);
  };
  const Disk_curvature<> curvature(graph);
  const Vertex_bounds<> result = bounds(Vertex_disk<Interval>(graph, curvature));
  if (result.are_narrow())
    return result;
  const auto fine_curvature = diagram.fine_level()->curvature();
  const auto fine = bounds(Vertex_disk<Fine_interval>(diagram.fine_level()->graph(), fine_curvature));
  const Interval_pair center = in_doubles(fine.center);
  return {{common_part(result.center[0], center[0]), common_part(result.center[1], center[1])},
          common_part(result.radius, in_doubles(fine.radius))};
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_VERTEX_BOUNDS_H
