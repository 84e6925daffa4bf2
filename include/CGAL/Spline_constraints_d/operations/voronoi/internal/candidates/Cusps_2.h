// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_CUSPS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_CUSPS_2_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Located_footpoint.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Scaled_sites.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Where an element ends in a cusp: what is settled, or else given up; and the footpoint of all disks there.
struct Cusp_side
{
  Range range;
  std::optional<Located_footpoint> footpoint;
  // which the disks touch, if no other element has disks that touch this one there
  std::optional<std::size_t> other_element;
};

/*
What is known next to vertices with more than two arcs, or with cusps. Around such a vertex there is a circle which each
of its arcs leaves once, going away from the vertex. Within, an arc and the next one around the vertex are a wall, and
no disk that touches the arc on that side has a footpoint with a third one. And what is settled in a cusp is touched in
it by the disks of the two elements there only: by others it is touched from behind. A scaled disk has the point inside
in which the disk touches its element, and no scaled arcs, of which two are a wall if no other is between.
*/
class Cusps_2
{
  struct Circle
  {
    double squared_radius = 0;
    bool has_one_direction = false;   // in which all arcs leave the vertex
    bool has_normal_cone = false;             // so that disks touch the vertex not only where they are tangent to arcs
  };

  const Site_graph_2<>& m_graph;
  const Scaled_sites<>* m_scaled;                                    // none, or some sites
  std::vector<std::array<std::optional<Cusp_side>, 2>> m_sides;    // of each element; none if there are no cusps
  bool m_has_cusps = false;
  std::vector<Circle> m_circles;                                   // around each vertex; none if there are no walls
  std::vector<std::array<double, 2>> m_reaches;                    // how far the ends of arcs go away from these

public:
  // Knows the walls, and no sides.
  explicit Cusps_2(const Site_graph_2<>& graph, const Scaled_sites<>* scaled = nullptr)
    : m_graph(graph), m_scaled(scaled)
  {
    const Upward_rounding_guard guard;
    const auto is_cusp = [&](const Arc_end& a, const Arc_end& b) {
      return are_same_directions(graph.direction(a), graph.direction(b));
    };
    for (std::size_t v = 0; v < graph.vertices().size(); ++v)
      if (const std::vector<Arc_end>& ends = graph.vertices()[v].ends; ends.size() > 1) {
        const bool has_cusp = std::adjacent_find(ends.begin(), ends.end(), is_cusp) != ends.end();
        m_has_cusps = m_has_cusps || has_cusp;
        if (has_cusp || ends.size() > 2)
          add_circle(v);
      }
    for (const Oriented_element<>& element : graph.elements())
      if (element.is_normal_cone && !m_circles.empty())
        m_circles[element.object].has_normal_cone = true;
  }

  // Whether arcs leave any vertex in the same direction.
  bool has_cusps() const { return m_has_cusps; }

  void set_side(std::size_t element, bool end, Cusp_side side)
  {
    m_sides.resize(m_graph.elements().size());
    m_sides[element][end] = std::move(side);
  }

  const std::optional<Cusp_side>& side(std::size_t element, bool end) const
  {
    static const std::optional<Cusp_side> none;
    return m_sides.empty() ? none : m_sides[element][end];
  }

  // Whether no disk that touches a part of an element, and has some curvature, touches a range of an arc, for the
  // reasons above.
  bool hide(const Element_part<>& part, std::size_t arc, const Range& range, const Curve_jet<>& jet,
            const Interval& curvature) const
  {
    // away from corners, curvatures tell
    if (m_circles.empty() || (!m_has_cusps && 0 < part.range.begin && part.range.end < 1))
      return false;
    for (const bool end : {false, true})
      if (is_behind_wall(part, {arc, end}, range, jet[0]) ||
          (!m_sides.empty() && is_in_front_of(part, {arc, end}, range, jet, curvature)))
        return true;
    return false;
  }

private:
  // Where the derivative of an arc turns by less than a right angle, the distance from any of its points grows.
  void add_circle(std::size_t vertex)
  {
    constexpr double least_reach = 0x1p-30;
    m_circles.resize(m_graph.vertices().size());
    m_reaches.resize(m_graph.arcs().size());
    const std::vector<Arc_end>& ends = m_graph.vertices()[vertex].ends;
    double squared_radius = std::numeric_limits<double>::infinity();
    for (const Arc_end& end : ends) {
      double& reach = m_reaches[end.arc][end.is_end] = 1;
      const auto goes_away = [&] {
        return turns_by_less_than_right_angle(m_graph.arcs()[end.arc].direction_over(range_at(end, reach)));
      };
      while (reach > least_reach && !goes_away())
        reach /= 2;
      const double last = end.is_end ? 1 - reach : reach;
      squared_radius = (std::min)(
          squared_radius,
          squared_norm(m_graph.arcs()[end.arc].point({last, last}) - m_graph.vertices()[vertex].point).inf());
      if (!goes_away())
        squared_radius = 0;
    }
    m_circles[vertex] = {squared_radius,
                         are_same_directions(m_graph.direction(ends.front()), m_graph.direction(ends.back()))};
  }

  bool is_in_circle(const Arc_end& end, const Range& range, const Interval_pair& points) const
  {
    const std::size_t vertex = m_graph.vertex_of(end);
    const Range reach = range_at(end, m_reaches[end.arc][end.is_end]);
    const double squared_radius = m_circles[vertex].squared_radius;
    return squared_radius > 0 && reach.begin <= range.begin && range.end <= reach.end &&
        squared_norm(points - m_graph.vertices()[vertex].point).sup() < squared_radius;
  }

  bool is_behind_wall(const Element_part<>& part, const Arc_end& end, const Range& range,
                      const Interval_pair& points) const
  {
    const Oriented_element<>& element = m_graph.elements()[part.element];
    const std::size_t vertex = m_graph.vertex_of(end);
    if (element.is_normal_cone) {
      if (element.object != vertex || is_scaled(end) || !is_in_circle(end, range, points))
        return false;
      const auto [first, second] = m_graph.ends_beside_normal_cone(part.element);
      return end != first && end != second;
    }
    const auto is_behind = [&](const Arc_end& own) {
      return is_scaled(end)
          ? !is_next_scaled(own, end)
          : end != own && (end != m_graph.next_around_vertex(element, own) || is_around_vertex(element, own));
    };
    for (const bool is_end : {false, true})
      if (const Arc_end own{element.object, is_end}; m_graph.vertex_of(own) == vertex &&
          is_in_circle(end, range, points) && is_in_circle(own, part.range, part.jet.point) && is_behind(own))
        return true;
    return false;
  }

  bool is_scaled(const Arc_end& end) const { return m_scaled != nullptr && m_scaled->arcs[end.arc]; }

  // Whether an end is the next one around a vertex, on either side, of those that are scaled.
  bool is_next_scaled(const Arc_end& own, const Arc_end& end) const
  {
    const std::vector<Arc_end>& ends = m_graph.vertices()[m_graph.vertex_of(own)].ends;
    const std::size_t n = ends.size(),
                      first = static_cast<std::size_t>(std::find(ends.begin(), ends.end(), own) - ends.begin());
    const auto is_next = [&](std::size_t step) {
      std::size_t i = (first + step) % n;
      while (!is_scaled(ends[i]))
        i = (i + step) % n;
      return ends[i] == end;
    };
    return is_next(1) || is_next(n - 1);
  }

  // Whether the next arc leaves in the same direction on the other side of all others: chords do not lead there.
  bool is_around_vertex(const Oriented_element<>& element, const Arc_end& own) const
  {
    const std::size_t vertex = m_graph.vertex_of(own);
    return m_circles[vertex].has_one_direction && m_graph.is_last_around_vertex(element, own);
  }

  // Whether the disks would be on that side of an arc on which this is settled.
  bool is_in_front_of(const Element_part<>& part, const Arc_end& end, const Range& range, const Curve_jet<>& jet,
                      const Interval& curvature) const
  {
    for (const bool is_right : {false, true})
      if (const std::size_t own = 2 * end.arc + is_right; part.element != own)
        if (const auto& settled = m_sides[own][end.is_end]; settled && settled->footpoint && settled->other_element &&
            *settled->other_element != part.element && settled->range.begin <= range.begin &&
            range.end <= settled->range.end)
          if (const Interval side(is_right ? -1 : 1); (side * height(part, end, range, jet)).inf() >= 0 ||
              (is_touched_as_arc(end, range) && (side * normal(part, end, range, jet, curvature)).inf() > 0))
            return true;
    return false;
  }

  // Whether disks that touch a range of an arc are tangent to it: where it ends in a vertex with a normal cone, it may
  // stand for the vertex.
  bool is_touched_as_arc(const Arc_end& end, const Range& range) const
  {
    return !range.meets({end.parameter(), end.parameter()}) || !m_circles[m_graph.vertex_of(end)].has_normal_cone;
  }

  // The sign of the normal of a disk, where it touches an arc: towards its left or its right. It is known also where
  // the element is on a tangent of the arc.
  Interval normal(const Element_part<>& part, const Arc_end& end, const Range& range, const Curve_jet<>& jet,
                  const Interval& curvature) const
  {
    const Interval_pair way = jet[0] - part.jet.point;
    return dot(turned_left(tangent(end, range, jet)),
               part.jet.normal - Interval_pair{curvature * way[0], curvature * way[1]});
  }

  // The sign of that of an element over the tangents of an arc: in the end of the arc itself it is that of the
  // curvature.
  Interval height(const Element_part<>& part, const Arc_end& end, const Range& range, const Curve_jet<>& jet) const
  {
    const Oriented_element<>& element = m_graph.elements()[part.element];
    const Site_arc_2<>& arc = m_graph.arcs()[end.arc];
    if (element.is_normal_cone && element.object == m_graph.vertex_of(end)) {
      const auto [tangent, change] = arc.tangent_jet(united(range, {end.parameter(), end.parameter()}));
      return dot(turned_left(tangent), change);
    }
    return dot(turned_left(tangent(end, range, jet)), part.jet.point - jet[0]);
  }

  Interval_pair tangent(const Arc_end& end, const Range& range, const Curve_jet<>& jet) const
  {
    const Site_arc_2<>& arc = m_graph.arcs()[end.arc];
    return arc.has_singular_end() ? arc.direction_over(range) : jet[1];
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_CANDIDATES_CUSPS_2_H
