// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_DIAGRAM_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_DIAGRAM_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Curve_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Disk_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Edge_samples.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Nearest_sites_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Vertex_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/cell_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/diagram_sites.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/parameter_bounds.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/check_magnitude.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/components_of_vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The graph of some curves and its disks, as the sites, vertices and edges of a diagram, and what is asked of that later.
*/
class Traced_diagram
{
  using Part = Disk_diagram::Part;

  std::shared_ptr<const Site_graph_2<>> m_graph;
  Disk_diagram m_diagram;
  Site_tree_2 m_tree;
  std::vector<Curve_diagram::Vertex> m_vertices;   // those that there was time for, without their edges
  std::vector<std::size_t> m_halfedge_of_edge, m_edge_of_halfedge;
  std::vector<Undecided_range> m_undecided;
  std::vector<std::vector<std::size_t>> m_halfedges_of_site;
  std::vector<char> m_is_undecided;   // of each site: whether some of its cell is

public:
  Traced_diagram(std::shared_ptr<const Site_graph_2<>> graph, Disk_diagram diagram, Search_control& control)
    : m_graph(std::move(graph)), m_diagram(std::move(diagram)), m_tree(*m_graph),
      m_undecided(m_diagram.unresolved_parts())
  {
    const Upward_rounding_guard guard;
    for (const Disk_diagram::Vertex& vertex : m_diagram.vertices())
      if (!control.is_overdue())
        m_vertices.push_back(bounded(vertex));
      else
        break;
    number_edges(control.reason());
    sort_halfedges();
  }

  const Site_graph_2<>& graph() const { return *m_graph; }
  const std::vector<Undecided_range>& undecided() const { return m_undecided; }

  // All that there is of it, but for what is not decided.
  void describe(Curve_diagram& result) const
  {
    const Upward_rounding_guard guard;
    result.coincident_parts = coincident_parts();
    const std::vector<std::size_t> regions = components_of_vertices(*m_graph);
    result.sites = diagram_sites(*m_graph, regions);
    result.number_of_regions = regions.empty() ? 0 : *std::max_element(regions.begin(), regions.end()) + 1;
    for (std::size_t v = 0; v < m_vertices.size(); ++v)
      result.vertices.push_back(with_edges(m_vertices[v], m_diagram.vertices()[v]));
    for (const Part& part : m_diagram.lone_circles())
      result.vertices.push_back(center_of_circle(part, result));
    for (const std::size_t h : m_halfedge_of_edge)
      result.edges.push_back(described(m_diagram.halfedges()[h]));
  }

  std::vector<std::size_t> sites_of_curve(std::size_t curve) const
  {
    std::vector<std::size_t> result;
    const auto is_on_curve = [&](const Arc_end& end) { return m_graph->curve_of_arc(end.arc) == curve; };
    for (std::size_t i = 0; i < m_graph->arcs().size(); ++i)
      if (m_graph->curve_of_arc(i) == curve)
        result.push_back(i);
    for (std::size_t v = 0; v < m_graph->vertices().size(); ++v)
      if (std::ranges::any_of(m_graph->vertices()[v].ends, is_on_curve))
        result.push_back(m_graph->arcs().size() + v);
    return result;
  }

  Voronoi_cell_2 cell(const Curve_diagram& diagram, const std::vector<std::size_t>& sites) const
  {
    const std::set<std::size_t> inner(sites.begin(), sites.end());
    std::vector<std::size_t> halfedges;
    Voronoi_cell_2 result{{}, m_graph->is_proved()};
    for (const std::size_t site : inner) {
      halfedges.insert(halfedges.end(), m_halfedges_of_site[site].begin(), m_halfedges_of_site[site].end());
      result.is_complete = result.is_complete && !m_is_undecided[site];
    }
    const auto is_inside = [&](std::size_t h) {
      return inner.contains(site_of(m_diagram.element(m_diagram.halfedges()[h])));
    };
    for (const auto& [chain, is_closed] : Cell_boundaries(m_diagram, is_inside)(halfedges)) {
      result.chains.push_back({{}, is_closed});
      for (const std::size_t h : chain)
        result.chains.back().edges.push_back(boundary_edge(diagram, h));
    }
    return result;
  }

  std::vector<Disk_sample> samples(const Curve_diagram& diagram, std::size_t edge, double error,
                                   double most_radius) const
  {
    const Upward_rounding_guard guard;
    std::vector<Disk_sample> result;
    for (const Part& part : m_diagram.halfedges()[m_halfedge_of_edge[edge]].parts)
      edge_samples().append(part, error, most_radius, result);
    if (!result.empty()) {
      const auto& [first, last] = diagram.edges[edge].vertices;
      put_at_vertex(diagram.vertices[first], most_radius, result.front());
      put_at_vertex(diagram.vertices[last], most_radius, result.back());
    }
    return result;
  }

  std::vector<std::size_t> nearest(const Exact_pair& point) const
  {
    const Upward_rounding_guard guard;
    return nearest_sites(*m_graph, m_tree, *m_diagram.fine_level(), point);
  }

private:
  Edge_samples edge_samples() const { return {*m_graph, m_diagram}; }

  std::size_t site_of(const Oriented_element<>& element) const
  {
    return element.object + (element.is_normal_cone ? m_graph->arcs().size() : 0);
  }

  bool is_point(std::size_t site) const { return site >= m_graph->arcs().size(); }

  // The disk in the end of an edge is that of the vertex, which may be known better.
  static void put_at_vertex(const Curve_diagram::Vertex& vertex, double most_radius, Disk_sample& sample)
  {
    const auto width = [](const std::array<double, 2>& bounds) { return bounds[1] - bounds[0]; };
    if (vertex.radius && *vertex.radius <= most_radius &&
        width(vertex.radius_bounds) < width(sample.radius_bounds))
      sample = {*vertex.point, *vertex.radius, sample.parameters, vertex.radius_bounds};
  }

  static std::array<double, 2> ends(const Interval& x) { return {x.inf(), x.sup()}; }

  std::vector<Voronoi_coincidence_2> coincident_parts() const
  {
    std::vector<Voronoi_coincidence_2> result;
    for (const auto& [curves, overlap] : m_graph->coincident_parts()) {
      result.push_back({curves, {}, overlap.is_reversed});
      for (std::size_t k = 0; k < 2; ++k)
        result.back().parameters[k] = {to_nearest_double(overlap.parameters[k].first),
                                       to_nearest_double(overlap.parameters[k].second)};
    }
    return result;
  }

  // Edges are numbered by the first one of their halfedges. Those without both vertices are undecided.
  void number_edges(Undecided_reason why_not)
  {
    const auto& halfedges = m_diagram.halfedges();
    m_edge_of_halfedge.assign(halfedges.size(), Disk_diagram::none);
    for (std::size_t i = 0; i < halfedges.size(); ++i)
      if (const std::size_t twin = halfedges[i].twin; twin != Disk_diagram::none && twin >= i) {
        if ((std::max)(halfedges[i].source, halfedges[twin].source) < m_vertices.size()) {
          m_edge_of_halfedge[i] = m_edge_of_halfedge[twin] = m_halfedge_of_edge.size();
          m_halfedge_of_edge.push_back(i);
        } else
          for (const std::size_t h : {i, twin})
            for (const Part& part : halfedges[h].parts)
              m_undecided.push_back({part.element, m_diagram.envelope_arc(part).range, why_not});
      }
  }

  void sort_halfedges()
  {
    const std::size_t sites = m_graph->arcs().size() + m_graph->vertices().size();
    m_halfedges_of_site.resize(sites);
    for (std::size_t h = 0; h < m_diagram.halfedges().size(); ++h)
      m_halfedges_of_site[site_of(m_diagram.element(m_diagram.halfedges()[h]))].push_back(h);
    m_is_undecided.assign(sites, false);
    for (const Undecided_range& part : m_undecided)
      m_is_undecided[site_of(m_graph->elements()[part.element])] = true;
  }

  // A vertex with what is proved of it, but for its edges.
  Curve_diagram::Vertex bounded(const Disk_diagram::Vertex& vertex) const
  {
    const Vertex_bounds<> bounds = vertex_bounds(*m_graph, m_diagram, vertex);
    Curve_diagram::Vertex result{std::nullopt,
                                 std::nullopt,
                                 {},
                                 {},
                                 vertex.is_at_infinity,
                                 vertex.is_resolved,
                                 {ends(bounds.center[0]), ends(bounds.center[1])},
                                 ends(bounds.radius)};
    if (vertex.is_at_infinity)
      return result;
    const Part& part = m_diagram.halfedges()[vertex.outgoing.front()].parts.front();
    const Disk_sample at = edge_samples()(part, m_diagram.end_parameter(part, false));
    const auto within = [](const Interval& x, double value) { return std::clamp(value, x.inf(), x.sup()); };
    result.point = {within(bounds.center[0], at.center[0]), within(bounds.center[1], at.center[1])};
    result.radius = within(bounds.radius, at.radius);
    return result;
  }

  Curve_diagram::Vertex with_edges(Curve_diagram::Vertex result, const Disk_diagram::Vertex& vertex) const
  {
    for (const std::size_t h : vertex.outgoing)
      if (m_edge_of_halfedge[h] != Disk_diagram::none) {
        result.edges.push_back(m_edge_of_halfedge[h]);
        result.footpoints.push_back(footpoint(h));
      } else if (m_diagram.halfedges()[h].twin != Disk_diagram::none)   // that edge is left out
        result.is_resolved = false;
    return result;
  }

  // Where the disk at the begin of a halfedge touches its site.
  Voronoi_footpoint_2 footpoint(std::size_t halfedge) const
  {
    const Disk_diagram::Halfedge& h = m_diagram.halfedges()[halfedge];
    const std::size_t site = site_of(m_diagram.element(h));
    if (is_point(site))
      return {site, {}, {}};
    return {site, m_graph->curve_parameter(site, end_parameter(h, false)),
            parameter_bounds(m_graph->arcs()[site], m_diagram.range_of_end(halfedge, false).range)};
  }

  Curve_diagram::Vertex center_of_circle(const Part& part, const Curve_diagram& diagram) const
  {
    const Disk_sample at = edge_samples()(part, m_diagram.end_parameter(part, false));
    const std::size_t site = site_of(m_diagram.element(part));
    const Site_arc_2<>& circle = m_graph->arcs()[site];
    return {at.center,
            at.radius,
            {},
            {{site, at.parameters[0], diagram.sites[site].parameters}},
            false,
            true,
            {ends(circle.center()[0]), ends(circle.center()[1])},
            ends(CGAL::sqrt(circle.squared_radius()))};
  }

  Voronoi_edge_2 described(const Disk_diagram::Halfedge& halfedge) const
  {
    const std::array<const Disk_diagram::Halfedge*, 2> sides{&halfedge, &m_diagram.halfedges()[halfedge.twin]};
    Voronoi_edge_2 result{{site_of(m_diagram.element(*sides[0])), site_of(m_diagram.element(*sides[1]))},
                          {sides[0]->source, sides[1]->source},
                          {}};
    for (std::size_t k = 0; k < 2; ++k)
      if (const std::size_t site = result.sites[k]; !is_point(site)) {
        const auto parameter = [&](bool is_end) {
          return m_graph->curve_parameter(site, end_parameter(*sides[k], is_end == (k == 0)));
        };
        result.parameters[k] = {parameter(false), parameter(true)};
      }
    return result;
  }

  // The side of an edge on which a halfedge is.
  Voronoi_cell_2::Edge boundary_edge(const Curve_diagram& diagram, std::size_t halfedge) const
  {
    const std::size_t index = m_edge_of_halfedge[halfedge];
    const bool is_reversed = m_halfedge_of_edge[index] == halfedge;   // it has its site on the right
    Voronoi_cell_2::Edge result{diagram.edges[index], index, is_reversed};
    if (is_reversed) {
      std::swap(result.sites[0], result.sites[1]);
      std::swap(result.vertices[0], result.vertices[1]);
      std::swap(result.parameters[0], result.parameters[1]);
      for (auto& ends : result.parameters)
        if (ends)
          std::swap((*ends)[0], (*ends)[1]);
    }
    return result;
  }

  double end_parameter(const Disk_diagram::Halfedge& h, bool end) const
  {
    return m_diagram.end_parameter(end ? h.parts.back() : h.parts.front(), end);
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Disk_sample> samples_of_edge(const Curve_diagram& diagram, std::size_t edge,
                                                                        double error, double most_radius)
{
  check_error(error, "Voronoi_diagram_of_curves_2");
  if (edge >= diagram.edges.size())
    throw Invalid_input("Voronoi_diagram_of_curves_2: there is no edge " + std::to_string(edge));
  return diagram.traced->samples(diagram, edge, error, most_radius);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Voronoi_cell_2 cell_of_sites(const Curve_diagram& diagram,
                                                            const std::vector<std::size_t>& sites)
{
  for (const std::size_t site : sites)
    if (site >= diagram.sites.size())
      throw Invalid_input("Voronoi_diagram_of_curves_2: there is no site " + std::to_string(site));
  return diagram.traced == nullptr ? Voronoi_cell_2{{}, false} : diagram.traced->cell(diagram, sites);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t> sites_of_curve(const Curve_diagram& diagram, std::size_t curve)
{
  return diagram.traced == nullptr ? std::vector<std::size_t>() : diagram.traced->sites_of_curve(curve);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::size_t> nearest_sites(const Curve_diagram& diagram,
                                                                      const Exact_vector<2>& point)
{
  check_magnitude(point, "Voronoi_diagram_of_curves_2::nearest_sites");
  return diagram.traced == nullptr ? std::vector<std::size_t>() : diagram.traced->nearest(point);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_TRACED_DIAGRAM_H
