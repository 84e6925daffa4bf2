// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_MESH_CHARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_MESH_CHARTS_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Surface_projection.h>
#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Divides the triangles of surfaces into charts, which are disks, each with one simple loop of edges around it. A surface,
or a part of one between curves that it is cut along, is one chart if it is a disk. Otherwise triangles belong to the
nearest of some that are seeds, along the surface, and more seeds are added until all charts are disks; then they are
moved into their middles.
*/
class Mesh_charts
{
public:
  using Mesh = Solution_surface_mesh::Mesh;
  using Vertex = Mesh::Vertex_index;
  using Halfedge = Mesh::Halfedge_index;
  using Face = Mesh::Face_index;
  using Coordinates = Surface_projection::Coordinates;

private:
  const Solution_surface_mesh& m_result;
  const Mesh& m_mesh;
  const Surface_projection& m_projection;
  std::vector<Coordinates> m_points, m_centres; // of vertices and faces
  std::vector<std::vector<Face>> m_pieces, m_seeds;
  std::vector<std::size_t> m_piece_of_chart;
  std::vector<std::vector<Face>> m_faces; // of charts
  std::vector<std::size_t> m_chart_of;    // faces
  std::vector<double> m_distance;         // of faces from their seed

public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  Mesh_charts(const Solution_surface_mesh& surfaces, const Surface_projection& projection)
    : m_result(surfaces), m_mesh(surfaces.mesh), m_projection(projection)
  {
    for (const Vertex v : m_mesh.vertices())
      m_points.push_back(projection.point_of(surfaces, v));
    for (const Face face : m_mesh.faces()) {
      Coordinates sum = Coordinates::Zero(static_cast<Eigen::Index>(projection.coordinates()));
      for (const Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(face)))
        sum += m_points[v];
      m_centres.push_back(sum / 3);
    }
    find_pieces();
    for (const std::vector<Face>& piece : m_pieces)
      m_seeds.push_back({piece.front()});
    divide();
  }

  const Mesh& mesh() const { return m_mesh; }
  const std::vector<Coordinates>& points() const { return m_points; }
  std::size_t size() const { return m_faces.size(); }
  const std::vector<Face>& faces(std::size_t chart) const { return m_faces[chart]; }
  std::size_t surface(std::size_t chart) const { return m_result.surface[m_faces[chart].front()]; }

  std::vector<Coordinates> points_of(std::size_t chart) const
  {
    std::vector<Coordinates> result;
    for (const Face face : m_faces[chart])
      for (const Vertex v : m_mesh.vertices_around_face(m_mesh.halfedge(face)))
        result.push_back(m_points[v]);
    return result;
  }

  // The chart on the side of a halfedge; none on the boundary.
  std::size_t chart_beside(Halfedge h) const { return m_mesh.is_border(h) ? none : m_chart_of[m_mesh.face(h)]; }

  // Whether a halfedge of a chart is on its boundary.
  bool is_cut(Halfedge h) const { return chart_beside(h) != chart_beside(m_mesh.opposite(h)); }

  // Whether a halfedge is on a boundary or a feature.
  bool is_feature(Halfedge h) const { return m_result.is_feature[m_mesh.edge(h)]; }

  // Divides these charts further; false if one of them is a single triangle.
  bool refine(const std::set<std::size_t>& charts)
  {
    for (const std::size_t chart : charts)
      if (!add_seed(chart))
        return false;
    divide();
    return true;
  }

  // The halfedges around a chart, in order; empty unless they are one loop that meets no vertex twice.
  std::vector<Halfedge> loop_around(std::size_t chart) const
  {
    std::size_t count = 0;
    Halfedge first = Mesh::null_halfedge();
    for (const Face face : m_faces[chart])
      for (const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(face)))
        if (is_cut(h)) {
          first = h;
          ++count;
        }
    std::vector<Halfedge> result;
    std::set<Vertex> met;
    if (count == 0)
      return result;
    Halfedge h = first;
    do {
      if (!met.insert(m_mesh.target(h)).second)
        return {};
      result.push_back(h);
      h = m_mesh.next(h);
      while (!is_cut(h))
        h = m_mesh.next(m_mesh.opposite(h));
    } while (h != first);
    return result.size() == count ? result : std::vector<Halfedge>();
  }

private:
  // Triangles of one surface that are connected without crossing a feature.
  void find_pieces()
  {
    std::vector<bool> is_met(m_mesh.number_of_faces(), false);
    for (const Face start : m_mesh.faces()) {
      if (is_met[start])
        continue;
      is_met[start] = true;
      std::vector<Face> piece{start};
      for (std::size_t k = 0; k < piece.size(); ++k)
        for (const Face next : neighbours(piece[k]))
          if (!is_met[next]) {
            is_met[next] = true;
            piece.push_back(next);
          }
      m_pieces.push_back(std::move(piece));
    }
  }

  std::vector<Face> neighbours(Face face) const
  {
    std::vector<Face> result;
    for (const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(face)))
      if (const Halfedge other = m_mesh.opposite(h); !m_mesh.is_border(other) && !m_result.is_feature[m_mesh.edge(h)])
        result.push_back(m_mesh.face(other));
    return result;
  }

  void divide()
  {
    while (!are_disks())
      for (std::size_t chart = 0; chart < m_faces.size(); ++chart)
        if (!is_disk(chart))
          add_seed(chart); // one triangle is a disk
    move_seeds_to_middles();
  }

  // Moves all seeds to the middles of their charts, and charts with them, as long as these are disks (Lloyd's method).
  void move_seeds_to_middles()
  {
    constexpr int rounds = 4;
    for (int round = 0; round < rounds; ++round) {
      const std::vector<std::vector<Face>> before = m_seeds;
      std::size_t chart = 0;
      for (std::vector<Face>& seeds : m_seeds)
        for (Face& seed : seeds)
          seed = middle_of(chart++);
      if (!are_disks()) {
        m_seeds = before;
        assign_faces();
        return;
      }
    }
  }

  Face middle_of(std::size_t chart) const
  {
    Coordinates sum = Coordinates::Zero(static_cast<Eigen::Index>(m_projection.coordinates()));
    for (const Face face : m_faces[chart])
      sum += m_centres[face];
    sum /= static_cast<double>(m_faces[chart].size());
    return *std::min_element(m_faces[chart].begin(), m_faces[chart].end(), [&](Face a, Face b) {
      return m_projection.distance(m_centres[a], sum) < m_projection.distance(m_centres[b], sum);
    });
  }

  bool are_disks()
  {
    assign_faces();
    for (std::size_t chart = 0; chart < m_faces.size(); ++chart)
      if (!is_disk(chart))
        return false;
    return true;
  }

  // The triangle of a chart that is farthest from its seed becomes one; false if there is no other.
  bool add_seed(std::size_t chart)
  {
    if (m_faces[chart].size() == 1)
      return false;
    const Face farthest = *std::max_element(m_faces[chart].begin() + 1, m_faces[chart].end(),
                                            [&](Face a, Face b) { return m_distance[a] < m_distance[b]; });
    m_seeds[m_piece_of_chart[chart]].push_back(farthest);
    return true;
  }

  // Each triangle to the chart of the nearest seed (Dijkstra's algorithm).
  void assign_faces()
  {
    m_chart_of.assign(m_mesh.number_of_faces(), none);
    m_distance.assign(m_mesh.number_of_faces(), std::numeric_limits<double>::infinity());
    m_faces.clear();
    m_piece_of_chart.clear();
    using Entry = std::pair<double, std::pair<std::size_t, Face>>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> open;
    for (std::size_t piece = 0; piece < m_pieces.size(); ++piece)
      for (const Face seed : m_seeds[piece]) {
        open.push({0, {m_faces.size(), seed}});
        m_faces.emplace_back();
        m_piece_of_chart.push_back(piece);
      }
    while (!open.empty()) {
      const auto [distance, entry] = open.top();
      const auto [chart, face] = entry;
      open.pop();
      if (m_chart_of[face] != none)
        continue;
      m_chart_of[face] = chart;
      m_distance[face] = distance;
      m_faces[chart].push_back(face);
      for (const Face next : neighbours(face))
        if (m_chart_of[next] == none)
          open.push({distance + m_projection.distance(m_centres[face], m_centres[next]), {chart, next}});
    }
  }

  bool is_disk(std::size_t chart) const
  {
    std::set<Vertex> vertices;
    std::set<Mesh::Edge_index> edges;
    for (const Face face : m_faces[chart])
      for (const Halfedge h : m_mesh.halfedges_around_face(m_mesh.halfedge(face))) {
        vertices.insert(m_mesh.target(h));
        edges.insert(m_mesh.edge(h));
      }
    return vertices.size() + m_faces[chart].size() == edges.size() + 1 && !loop_around(chart).empty();
  }
};

// A curve between two charts, or beside one: vertices of the mesh, in order, and the unknowns that are fixed on it;
// whether it is a boundary or a feature, or may be somewhere else.
struct Chart_edge
{
  std::vector<Mesh_charts::Vertex> vertices;
  std::vector<int> fixed;
  bool is_feature;
};

// An edge of a chart, and whether it is followed backwards.
struct Chart_edge_use
{
  std::size_t edge;
  bool is_reversed;
};

/*
The curves between charts. They end where more than two of them meet, where the boundary of a surface turns from one
plane to another, and so often that each chart has four at least.
*/
class Chart_network
{
  using Mesh = Mesh_charts::Mesh;
  using Vertex = Mesh_charts::Vertex;
  using Halfedge = Mesh_charts::Halfedge;

  const Mesh_charts& m_charts;
  const Mesh& m_mesh;
  std::function<std::vector<int>(Halfedge)> m_fixed;
  std::set<Vertex> m_nodes;
  std::vector<Chart_edge> m_edges;
  std::map<Halfedge, Chart_edge_use> m_use_of; // of the first halfedge of an edge, and of that of its way back
  std::vector<std::vector<Chart_edge_use>> m_loops;

public:
  // `fixed`: the unknowns that are fixed along a halfedge on a boundary or a feature.
  Chart_network(const Mesh_charts& charts, std::function<std::vector<int>(Halfedge)> fixed)
    : m_charts(charts), m_mesh(charts.mesh()), m_fixed(std::move(fixed))
  {
    std::vector<std::vector<Halfedge>> loops;
    for (std::size_t chart = 0; chart < charts.size(); ++chart)
      loops.push_back(charts.loop_around(chart));
    for (const std::vector<Halfedge>& loop : loops)
      for (std::size_t k = 0; k < loop.size(); ++k)
        if (is_node(loop[k], loop[(k + 1) % loop.size()]))
          m_nodes.insert(m_mesh.target(loop[k]));
    for (const std::vector<Halfedge>& loop : loops)
      add_nodes(loop);
    for (const std::vector<Halfedge>& loop : loops)
      add_edges(loop);
  }

  const std::vector<Chart_edge>& edges() const { return m_edges; }

  // The edges around a chart, counterclockwise. There are less than four if the chart has too few vertices.
  const std::vector<Chart_edge_use>& loop(std::size_t chart) const { return m_loops[chart]; }

private:
  std::pair<std::size_t, std::size_t> beside(Halfedge h) const
  {
    return std::minmax(m_charts.chart_beside(h), m_charts.chart_beside(m_mesh.opposite(h)));
  }

  bool is_node(Halfedge in, Halfedge out) const { return beside(in) != beside(out) || m_fixed(in) != m_fixed(out); }

  double length(Halfedge h) const
  {
    return (m_charts.points()[m_mesh.source(h)] - m_charts.points()[m_mesh.target(h)]).norm();
  }

  // As long as there are less than four: one in the middle of the longest part of the loop between two.
  void add_nodes(const std::vector<Halfedge>& loop)
  {
    constexpr std::size_t least = 4;
    const auto is_at_end = [&](Halfedge h) { return m_nodes.count(m_mesh.target(h)) > 0; };
    auto count = static_cast<std::size_t>(std::count_if(loop.begin(), loop.end(), is_at_end));
    if (count == 0 && !loop.empty()) {
      m_nodes.insert(m_mesh.target(loop.front()));
      ++count;
    }
    for (; count < least && count < loop.size(); ++count) {
      const std::size_t first =
          static_cast<std::size_t>(std::find_if(loop.begin(), loop.end(), is_at_end) - loop.begin()) + 1;
      std::vector<Halfedge> part, longest;
      double own = 0, greatest = 0;
      for (std::size_t k = 0; k < loop.size(); ++k) {
        part.push_back(loop[(first + k) % loop.size()]);
        own += length(part.back());
        if (is_at_end(part.back())) {
          if (part.size() > 1 && own > greatest) {
            longest = part;
            greatest = own;
          }
          part.clear();
          own = 0;
        }
      }
      m_nodes.insert(m_mesh.target(middle_of(longest, greatest)));
    }
  }

  Halfedge middle_of(const std::vector<Halfedge>& part, double total) const
  {
    double sum = 0;
    for (std::size_t k = 0; k + 2 < part.size(); ++k) {
      const double next = length(part[k]);
      if (sum + next + 0.5 * length(part[k + 1]) >= 0.5 * total)
        return part[k];
      sum += next;
    }
    return part[part.size() - 2];
  }

  void add_edges(const std::vector<Halfedge>& loop)
  {
    m_loops.emplace_back();
    std::size_t first = 0;
    while (first < loop.size() && m_nodes.count(m_mesh.source(loop[first])) == 0)
      ++first;
    for (std::size_t k = 0; k < loop.size();) {
      std::vector<Halfedge> part;
      do
        part.push_back(loop[(first + k++) % loop.size()]);
      while (m_nodes.count(m_mesh.target(part.back())) == 0);
      const auto [place, is_new] = m_use_of.try_emplace(part.front(), Chart_edge_use{m_edges.size(), false});
      if (is_new) {
        Chart_edge edge{{m_mesh.source(part.front())}, m_fixed(part.front()), m_charts.is_feature(part.front())};
        for (const Halfedge h : part)
          edge.vertices.push_back(m_mesh.target(h));
        m_use_of.emplace(m_mesh.opposite(part.back()), Chart_edge_use{m_edges.size(), true});
        m_edges.push_back(std::move(edge));
      }
      m_loops.back().push_back(place->second);
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_MESH_CHARTS_H
