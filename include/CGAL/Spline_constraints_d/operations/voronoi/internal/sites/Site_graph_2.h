// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_GRAPH_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_GRAPH_2_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Coincident_parts_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Continuation_finder.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Order_around_vertex.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Oriented_element_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_vertex_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/number_cycles.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/normals_between.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
Curves as a planar graph of polynomial arcs and their ends: the arcs around each vertex are in order, so that each arc
has a next one on each of its sides.

Where curves cross, their arcs may end in points that are not known exactly. The curves pass through such a vertex, so
that it has no normal cones; in its place, and in those of the ends of its arcs, there are exact points next to them.
*/
template <Enclosing_number Interval = Common::Interval>
class Site_graph_2
{
  using Interval_pair = std::array<Interval, 2>;

public:
  using Vertex = Site_vertex<Interval>;

  // The vertex in which an arc ends, and a bound of the distance of the end from that of its piece, in the parameter of
  // that.
  struct Place_of_end
  {
    std::size_t vertex;
    Exact_rational error;
  };

private:
  std::vector<Site_arc_2<Interval>> m_arcs;
  std::vector<std::size_t> m_curve_of_arc;
  std::vector<std::array<std::size_t, 2>> m_vertices_of_arc;
  std::vector<std::array<bool, 2>> m_is_end_exact;
  std::vector<std::array<Exact_pair, 2>> m_directions;   // of the ends of arcs, outgoing
  std::vector<std::array<Arc_continuations<Interval>, 2>> m_continuations;
  std::vector<Vertex> m_vertices;
  std::vector<Oriented_element<Interval>> m_elements;   // the sides of arc i are 2 i and 2 i + 1, then normal cones
  std::map<Exact_pair, std::size_t> m_vertex_at;
  std::vector<Coincident_parts_2> m_coincident_parts;
  bool m_is_proved = true, m_is_planar = true;

  template <Enclosing_number Other>
  friend class Site_graph_2;

public:
  Site_graph_2() = default;

  // The same graph with enclosures of another precision.
  template <Enclosing_number Other>
  explicit Site_graph_2(const Site_graph_2<Other>& other)
    : m_curve_of_arc(other.m_curve_of_arc), m_vertices_of_arc(other.m_vertices_of_arc),
      m_is_end_exact(other.m_is_end_exact), m_directions(other.m_directions), m_continuations(other.m_arcs.size()),
      m_vertex_at(other.m_vertex_at), m_coincident_parts(other.m_coincident_parts), m_is_proved(other.m_is_proved),
      m_is_planar(other.m_is_planar)
  {
    for (const Exact_arc_2& arc : other.m_arcs)
      m_arcs.emplace_back(arc);
    for (const auto& [exact_point, point, ends, normal_cones, is_exact, rest] : other.m_vertices) {
      Vertex& vertex = m_vertices.emplace_back(
          Vertex{exact_point, {any_number<Interval>(), any_number<Interval>()}, ends, normal_cones, is_exact});
      vertex.enclose();
      for (const Arc_end& end : ends)
        vertex.enclose_by_end(m_arcs[end.arc], end.is_end);
    }
    for (const auto& [is_normal_cone, object, is_reversed, exact_normals, normals, perpendicular_ends, next, cycle,
                      component] : other.m_elements)
      m_elements.push_back(
          {is_normal_cone,
           object,
           is_reversed,
           exact_normals,
           {interval_pair_of<Interval>(exact_normals[0]), interval_pair_of<Interval>(exact_normals[1])},
           perpendicular_ends,
           next,
           cycle,
           component});
    for (const Vertex& vertex : m_vertices)
      find_continuations(vertex);
  }

  // The vertex with given coordinates.
  std::size_t add_point(const Exact_pair& point)
  {
    const auto [position, is_new] = m_vertex_at.emplace(point, m_vertices.size());
    if (is_new)
      m_vertices.emplace_back(Vertex{point}).enclose();
    return position->second;
  }

  // A vertex next to a point, which is known by the arcs that end there.
  std::size_t add_crossing(const Exact_pair& near)
  {
    m_vertices.emplace_back(Vertex{near}).is_exact = false;
    return m_vertices.size() - 1;
  }

  // Ends that have no place given are those of the piece.
  void add_arc(Homogeneous_piece piece, std::size_t curve,
               const std::array<std::optional<Place_of_end>, 2>& places = {})
  {
    const auto error = [&](bool is_end) { return places[is_end] ? places[is_end]->error : Exact_rational(0); };
    Site_arc_2<Interval> arc(std::move(piece), (std::max)(error(false), error(true)));
    const Exact_pair a = arc.at(0), b = arc.at(1);
    check_is_no_point(arc.piece().coordinates, arc.piece().domain, curve, "");
    m_directions.push_back({outgoing_direction(arc, false), outgoing_direction(arc, true)});
    m_curve_of_arc.push_back(curve);
    m_is_end_exact.push_back({sign_of(error(false)) == 0, sign_of(error(true)) == 0});
    const std::array<std::size_t, 2> vertices{places[0] ? places[0]->vertex : add_point(a),
                                              places[1] ? places[1]->vertex : add_point(b)};
    m_vertices_of_arc.push_back(vertices);
    for (const bool is_end : {false, true}) {
      m_vertices[vertices[is_end]].ends.push_back({m_arcs.size(), is_end});
      m_vertices[vertices[is_end]].enclose_by_end(arc, is_end);
    }
    m_arcs.push_back(std::move(arc));
  }

  // For parts that other curves have, too, and only one of which has been added.
  void add_coincident_parts(const Coincident_parts_2& parts) { m_coincident_parts.push_back(parts); }

  // Orders the arcs around the vertices, and makes the elements. Where some may overlap, the graph is not proved; where
  // some may cross, it is not planar.
  void close(bool are_arcs_disjoint = true, bool are_crossings_cut = true, Search_control* control = nullptr)
  {
    Regular_check check(control, 16);
    m_is_proved = are_arcs_disjoint;
    m_is_planar = are_crossings_cut;
    for (std::size_t i = 0; i < m_arcs.size(); ++i) {
      m_elements.push_back({false, i, false});
      m_elements.push_back({false, i, true});
    }
    m_continuations.resize(m_arcs.size());
    const Order_around_vertex<Interval, Site_graph_2> order(*this);
    for (std::size_t v = 0; v < m_vertices.size(); ++v) {
      check();
      const bool is_ordered = order.sort(m_vertices[v].ends);
      m_is_proved = m_is_proved && is_ordered && order.is_proved(m_vertices[v].ends);
      find_continuations(m_vertices[v]);
      connect_elements(v);
    }
    number_cycles(m_elements);
  }

  const std::vector<Site_arc_2<Interval>>& arcs() const { return m_arcs; }
  const std::vector<Vertex>& vertices() const { return m_vertices; }
  const std::vector<Oriented_element<Interval>>& elements() const { return m_elements; }
  std::size_t curve_of_arc(std::size_t arc) const { return m_curve_of_arc[arc]; }
  const std::vector<Coincident_parts_2>& coincident_parts() const { return m_coincident_parts; }

  // Whether an arc is a part of a curve, its own or one that overlaps it there.
  bool is_part_of(std::size_t arc, std::size_t curve) const
  {
    return m_curve_of_arc[arc] == curve ||
        std::any_of(m_coincident_parts.begin(), m_coincident_parts.end(), [&](const Coincident_parts_2& parts) {
             return parts.curves[1] == curve && parts.hold(0, m_curve_of_arc[arc], m_arcs[arc].piece().domain);
           });
  }

  // The parameter of a point of an arc, of its curve.
  double curve_parameter(std::size_t arc, double u) const
  {
    const auto& [first, last] = m_arcs[arc].piece().domain;
    const double begin = to_nearest_double(first), end = to_nearest_double(last);
    return u == 1 ? end : std::clamp(begin + u * (end - begin), begin, end);
  }

  // From one vertex to another one, both known exactly, with a small relative error.
  Interval_pair way_between(std::size_t from, std::size_t to) const
  {
    const Vertex &p = m_vertices[from], &q = m_vertices[to];
    const auto way = [&](std::size_t k) {
      return Interval(q.point[k].inf()) - Interval(p.point[k].inf()) + (q.rest[k] - p.rest[k]);
    };
    return {way(0), way(1)};
  }

  std::size_t vertex_of(const Arc_end& end) const { return m_vertices_of_arc[end.arc][end.is_end]; }

  // Whether an arc ends where its piece does.
  bool is_exact(const Arc_end& end) const { return m_is_end_exact[end.arc][end.is_end]; }
  bool are_ends_exact(std::size_t arc) const { return is_exact({arc, false}) && is_exact({arc, true}); }

  // Whether the derivative of an arc is not zero in an end, as far as that is known.
  bool is_regular(const Arc_end& end) const { return m_arcs[end.arc].zeros_of_derivative(end.is_end) == 0; }

  // Whether the order of the arcs around all vertices is proved, and no arcs are known to overlap.
  bool is_proved() const { return m_is_proved; }

  // Whether, besides, arcs meet in their ends only.
  bool is_planar() const { return m_is_proved && m_is_planar; }

  const Arc_continuations<Interval>& continuations(const Arc_end& end) const
  {
    return m_continuations[end.arc][end.is_end];
  }
  const std::optional<Smooth_continuation<Interval>>& continuation(const Arc_end& end) const
  {
    return continuations(end).only;
  }
  const std::optional<Nearly_smooth_continuation<Interval>>& nearly_smooth_continuation(const Arc_end& end) const
  {
    return continuations(end).nearly_smooth;
  }

  // The arc that leaves a vertex in the direction in which another one arrives, if it is the next one on a side of
  // that, as for disks that touch both there.
  std::optional<Arc_end> continuation_beside(const Arc_end& end, bool is_left) const
  {
    const Arc_end& next = next_around_vertex({false, end.arc, is_left != end.is_end}, end);
    const Exact_pair &p = direction(end), &q = direction(next);
    return sign_of(exact_dot(p, q)) < 0 && sign_of(exact_cross(p, q)) == 0 ? std::optional(next) : std::nullopt;
  }

  // Whether an element ends where its arc joins another one nearly smoothly, at an angle of less than 180 degrees.
  bool is_pocket(const Oriented_element<Interval>& element, const Arc_end& end) const
  {
    const auto& next = nearly_smooth_continuation(end);
    // on the left of the way to the corner
    return next && (end.is_end != element.is_reversed) != next->is_left_reflex;
  }

  // The end of the arc on the other side of the cusp in which an element ends: that arc leaves the vertex in the same
  // direction, and nothing is between.
  std::optional<Arc_end> across_cusp(const Oriented_element<Interval>& element, const Arc_end& end) const
  {
    const Arc_end& next = next_around_vertex(element, end);
    return !is_last_around_vertex(element, end) && are_same_directions(direction(end), direction(next))
        ? std::optional(next)
        : std::nullopt;
  }

  // Whether the next arc around the vertex is on the other side of all others, if all leave in one direction.
  bool is_last_around_vertex(const Oriented_element<Interval>& element, const Arc_end& end) const
  {
    const std::vector<Arc_end>& ends = m_vertices[vertex_of(end)].ends;
    return end == (is_left_of_way_to(element, end) ? ends.front() : ends.back());
  }

  // That of the next arc around the vertex in which an element ends, on the side of the element; and the element on the
  // other side of the angle between them.
  const Arc_end& next_around_vertex(const Oriented_element<Interval>& element, const Arc_end& end) const
  {
    const std::vector<Arc_end>& ends = m_vertices[vertex_of(end)].ends;
    const std::size_t i = static_cast<std::size_t>(std::find(ends.begin(), ends.end(), end) - ends.begin()),
                      n = ends.size();
    return ends[(i + (is_left_of_way_to(element, end) ? n - 1 : 1)) % n];
  }

  std::size_t element_across(const Oriented_element<Interval>& element, const Arc_end& end) const
  {
    return is_left_of_way_to(element, end) ? departing(next_around_vertex(element, end))
                                           : arriving(next_around_vertex(element, end));
  }

  // Those of the arcs on both sides of a normal cone.
  std::pair<Arc_end, Arc_end> ends_beside_normal_cone(std::size_t normal_cone) const
  {
    std::size_t f = normal_cone;
    while (m_elements[f].is_normal_cone)
      f = m_elements[f].next;
    const Arc_end last{m_elements[f].object, m_elements[f].is_reversed};   // where the traversal departs
    return {last, next_around_vertex(m_elements[f], last)};
  }

  // Whether an element is a normal cone between arcs that join nearly smoothly.
  bool is_in_nearly_smooth_joint(const Oriented_element<Interval>& element) const
  {
    return element.is_normal_cone && !m_vertices[element.object].ends.empty() &&
        nearly_smooth_continuation(m_vertices[element.object].ends.front()).has_value();
  }

  // The outgoing direction of an arc in one of its ends, also where its derivative is zero.
  const Exact_pair& direction(const Arc_end& end) const { return m_directions[end.arc][end.is_end]; }

  Element_jet<Interval> element_jet(const Oriented_element<Interval>& element, const Range& range) const
  {
    if (element.is_normal_cone) {
      const Interval u = interval_of<Interval>(range);
      const Interval_pair difference = element.normals[1] - element.normals[0];
      return {m_vertices[element.object].point,
              {Interval(0), Interval(0)},
              {element.normals[0][0] + u * difference[0], element.normals[0][1] + u * difference[1]},
              difference};
    }
    const Site_arc_2<Interval>& arc = m_arcs[element.object];
    const Curve_jet<Interval> jet = arc.jet(range, 2);
    const Interval side(element.is_reversed ? -1 : 1);
    const auto [tangent, change] = arc.has_singular_end() ? arc.tangent_jet(range) : std::array{jet[1], jet[2]};
    return {jet[0], jet[1], side * turned_left(tangent), side * turned_left(change)};
  }

  // Whether a vertex lies on the line or circle of the arc of an element: the disks through it then are half-planes, or
  // have the curvature of the circle.
  bool is_vertex_on_line_or_circle_of(std::size_t element, std::size_t vertex) const
  {
    if (m_elements[element].is_normal_cone)
      return false;
    const Site_arc_2<Interval>& arc = m_arcs[m_elements[element].object];
    if (!arc.is_straight() && !arc.circle())
      return false;
    if (arc.is_straight()) {
      const auto& [a, b] = m_vertices_of_arc[m_elements[element].object];
      const Interval_pair& q = m_vertices[vertex].point;
      if (certain_sign(dot(turned_left(m_vertices[a].point - q), m_vertices[b].point - q)) != 0)
        return false;
    } else if (certain_sign(squared_norm(m_vertices[vertex].point - arc.center()) - arc.squared_radius()) != 0)
      return false;
    if (m_vertices[vertex].is_exact)
      return arc.is_on_line_or_circle(m_vertices[vertex].exact_point);
    return std::any_of(m_vertices[vertex].ends.begin(), m_vertices[vertex].ends.end(),
                       [&](const Arc_end& end) { return is_on_line_or_circle_of(element, end.arc); });
  }

  // A point of an element, of an arc by the parameter of its piece, and the normal there.
  Exact_pair exact_point_at(const Oriented_element<Interval>& element, const Exact_rational& u) const
  {
    return element.is_normal_cone ? m_vertices[element.object].exact_point : m_arcs[element.object].at(u);
  }
  Exact_pair exact_normal(const Oriented_element<Interval>& element, const Exact_rational& u) const
  {
    if (element.is_normal_cone) {
      const auto& [from, to] = element.exact_normals;
      return {Exact_rational(from[0] + u * (to[0] - from[0])), Exact_rational(from[1] + u * (to[1] - from[1]))};
    }
    const Exact_pair tangent = m_arcs[element.object].tangent_at(u);
    return element.is_reversed ? Exact_pair{tangent[1], Exact_rational(-tangent[0])}
                               : Exact_pair{Exact_rational(-tangent[1]), tangent[0]};
  }

  // Whether the first or last normal of a normal cone is perpendicular to an arc there.
  static bool is_perpendicular(const Oriented_element<Interval>& normal_cone, bool normal, const Arc_end& end)
  {
    const std::vector<Arc_end>& ends = normal_cone.perpendicular_ends[normal];
    return std::find(ends.begin(), ends.end(), end) != ends.end();
  }

  const Exact_pair& exact_point(const Oriented_element<Interval>& element, bool end) const
  {
    return m_vertices[element.is_normal_cone ? element.object : vertex_of({element.object, end})].exact_point;
  }

  // Whether an arc lies on the line or circle of the arc of an element.
  bool is_on_line_or_circle_of(std::size_t element, std::size_t arc) const
  {
    if (m_elements[element].is_normal_cone)
      return false;
    const Site_arc_2<Interval> &own = m_arcs[m_elements[element].object], &other = m_arcs[arc];
    if (own.is_straight())
      return other.is_straight() && own.is_on_line_or_circle(other.at(0)) && own.is_on_line_or_circle(other.at(1));
    return own.circle() && own.circle() == other.circle();
  }

  // Whether no disk that touches an element touches an arc elsewhere: it lies on the line or circle of the element; or
  // it is a segment that ends in the vertex of the element, or is behind one.
  bool is_never_touched(std::size_t element, std::size_t arc) const
  {
    if (!m_elements[element].is_normal_cone)
      return is_on_line_or_circle_of(element, arc);
    const auto& ends = m_vertices[m_elements[element].object].ends;
    return m_arcs[arc].is_straight() &&
        std::any_of(ends.begin(), ends.end(), [&](const Arc_end& end) { return is_on_ray_of(m_arcs[arc], end); });
  }

private:
  // Whether a straight arc lies on the line of another one, on the same side of an end of that.
  bool is_on_ray_of(const Site_arc_2<Interval>& arc, const Arc_end& end) const
  {
    const Site_arc_2<Interval>& segment = m_arcs[end.arc];
    if (!segment.is_straight() || !segment.is_on_line_or_circle(arc.at(0)) || !segment.is_on_line_or_circle(arc.at(1)))
      return false;
    const Exact_pair p = segment.at(end.is_end), q = arc.at(Exact_rational(1) / 2);
    return sign_of(exact_dot(direction(end), Exact_pair{Exact_rational(q[0] - p[0]), Exact_rational(q[1] - p[1])})) > 0;
  }

  void find_continuations(const Vertex& vertex)
  {
    Continuation_finder<Interval, Site_graph_2>(*this).append(vertex, m_continuations);
  }

  static bool is_left_of_way_to(const Oriented_element<Interval>& element, const Arc_end& end)
  {
    return end.is_end != element.is_reversed;
  }

  // The element that is traversed away from an end of an arc, or toward it.
  static std::size_t departing(const Arc_end& end) { return 2 * end.arc + end.is_end; }
  static std::size_t arriving(const Arc_end& end) { return 2 * end.arc + !end.is_end; }

  // Between the arcs a and b around a vertex, b clockwise from a, the traversal arrives along a and departs along b.
  void connect_elements(std::size_t v)
  {
    const Vertex& vertex = m_vertices[v];
    const std::size_t n = vertex.ends.size();
    if (n == 0) {
      const std::array<Exact_pair, 4> axes{{{1, 0}, {0, -1}, {-1, 0}, {0, 1}}};
      const std::size_t first = m_elements.size();
      for (std::size_t k = 0; k < 4; ++k)
        add_normal_cone(v, axes[k], axes[(k + 1) % 4]);
      for (std::size_t k = 0; k < 4; ++k)
        m_elements[first + k].next = first + (k + 1) % 4;
      return;
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Arc_end &a = vertex.ends[i], &b = vertex.ends[(i + n - 1) % n];
      std::size_t last = arriving(a);
      for (const auto& [first_normal, last_normal] : normals_between(direction(a), direction(b), n == 1, i == 0))
        last = m_elements[last].next = add_normal_cone(v, first_normal, last_normal);
      m_elements[last].next = departing(b);
    }
  }

  std::size_t add_normal_cone(std::size_t vertex, const Exact_pair& from, const Exact_pair& to)
  {
    Oriented_element<Interval> normal_cone{
        true, vertex, false, {from, to}, {interval_pair_of<Interval>(from), interval_pair_of<Interval>(to)}};
    for (const Arc_end& end : m_vertices[vertex].ends)
      for (std::size_t k = 0; k < 2; ++k)
        if (sign_of(exact_dot(normal_cone.exact_normals[k], direction(end))) == 0)
          normal_cone.perpendicular_ends[k].push_back(end);
    m_elements.push_back(std::move(normal_cone));
    m_vertices[vertex].normal_cones.push_back(m_elements.size() - 1);
    return m_elements.size() - 1;
  }
};

inline std::vector<std::size_t> all_elements(const Site_graph_2<>& graph)
{
  std::vector<std::size_t> result(graph.elements().size());
  std::iota(result.begin(), result.end(), 0);
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_GRAPH_2_H
