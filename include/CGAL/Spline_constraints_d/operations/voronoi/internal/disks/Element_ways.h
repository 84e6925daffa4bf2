// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_ELEMENT_WAYS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_ELEMENT_WAYS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The ways from an element to arcs and vertices, with a small relative error also where these are near: differences of
coordinates lose it there.
*/
template <Enclosing_number Interval = Common::Interval>
class Element_ways
{
  using Interval_pair = std::array<Interval, 2>;

  static constexpr double small = 0x1p-16;   // ranges over which rounding matters
  // the relative error of a difference of points that cannot be much smaller
  static constexpr double accurate = 0x1p-46;

  const Site_graph_2<Interval>& m_graph;

public:
  explicit Element_ways(const Site_graph_2<Interval>& graph) : m_graph(graph) {}

  // From the element to an arc; also by way of their nearer ends, or of one that both have in common, which is as
  // accurate as the ways are short.
  Interval_pair to_arc(const Element_part<Interval>& part, std::size_t arc, const Range& range,
                       const Curve_jet<Interval>& jet) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    Interval_pair result = jet[0] - part.jet.point;
    if (is_accurate(result) || (!element.is_normal_cone && element.object == arc))
      return result;
    for (const bool end : {false, true})
      if (const Arc_end other{arc, end}; m_graph.is_exact(other))
        if (const auto to_end = way_to_vertex(part, m_graph.vertex_of(other), end == (range.middle() > 0.5)))
          result = common_part(result, *to_end + m_graph.arcs()[arc].way_from_end(end, range));
    return result;
  }

  // From the element to a vertex.
  Interval_pair to_vertex(const Element_part<Interval>& part, std::size_t vertex) const
  {
    const Interval_pair result = m_graph.vertices()[vertex].point - part.jet.point;
    const auto short_way = part.range.width() < small && !is_accurate(result) && m_graph.vertices()[vertex].is_exact
        ? way_to_vertex(part, vertex, true)
        : std::nullopt;
    return short_way ? common_part(result, *short_way) : result;
  }

private:
  // From the element to the exact end of an arc in a vertex, by way of its nearer end; or of that vertex, if it is an
  // end.
  std::optional<Interval_pair> way_to_vertex(const Element_part<Interval>& part, std::size_t vertex,
                                             bool is_any_vertex) const
  {
    const Oriented_element<Interval>& element = m_graph.elements()[part.element];
    std::optional<Interval_pair> result;
    const auto add = [&](std::size_t from, const Interval_pair& way) {
      const Interval_pair whole = from == vertex ? way : m_graph.way_between(from, vertex) + way;
      result = result ? common_part(*result, whole) : whole;
    };
    const auto is_taken = [&](std::size_t from, bool is_near) {
      return from == vertex ||
          (is_any_vertex && is_near && m_graph.vertices()[from].is_exact && m_graph.vertices()[vertex].is_exact);
    };
    if (element.is_normal_cone && is_taken(element.object, true))
      add(element.object, {Interval(0), Interval(0)});
    if (!element.is_normal_cone)
      for (const bool own : {false, true})
        if (const Arc_end end{element.object, own};
            m_graph.is_exact(end) && is_taken(m_graph.vertex_of(end), own == (part.range.middle() > 0.5)))
          add(m_graph.vertex_of(end), Interval(-1) * m_graph.arcs()[element.object].way_from_end(own, part.range));
    return result;
  }

  // Whether a difference of coordinates is not much smaller than these.
  static bool is_accurate(const Interval_pair& way)
  {
    const auto width = [](const Interval& x) { return x.sup() - x.inf(); };
    const auto size = [](const Interval& x) { return (std::max)(-x.inf(), x.sup()); };
    return (std::max)(width(way[0]), width(way[1])) < accurate * (std::max)(size(way[0]), size(way[1]));
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_ELEMENT_WAYS_H
