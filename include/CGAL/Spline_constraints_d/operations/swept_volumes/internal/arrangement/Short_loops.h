// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_SHORT_LOOPS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_SHORT_LOOPS_H

#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Boundary_of_cells.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

/*
Short loops of edges of a closed mesh that do not cut a part of it into two: each runs around a handle, or through it.
From a base, shortest ways to vertices are a tree; each other edge closes a loop. Faces are joined across edges, those
that close no short loop first, then long loops before short ones. An edge between faces that are joined already closes
a loop that does not separate its sides (Erickson, Whittlesey: Greedy optimal homotopy and homology generators, 2005).
*/
class Short_loops
{
public:
  using Mesh = Boundary_of_cells::Mesh;

  struct Loop
  {
    std::vector<Mesh::Halfedge_index> halfedges; // one after the other, from the base
    double length;
  };

private:
  const Mesh& m_mesh;
  double m_longest;
  Mesh::Vertex_index m_base;
  std::vector<double> m_distance;          // of vertices from the base; infinite, if it is more than half of a loop
  std::vector<Mesh::Halfedge_index> m_way; // to vertices: the last one
  std::vector<Mesh::Vertex_index> m_reached;

public:
  Short_loops(const Mesh& mesh, double longest)
    : m_mesh(mesh), m_longest(longest), m_distance(mesh.number_of_vertices(), m_infinite),
      m_way(mesh.number_of_vertices())
  {}

  // The shortest ones first. They are found from all of their vertices, and taken at the first one.
  std::vector<Loop> operator()()
  {
    std::vector<Loop> result;
    for (const auto base : m_mesh.vertices()) {
      find_ways(base);
      for (const auto edge : edges_around_handles())
        if (Loop loop = loop_over(edge); is_first_base(loop))
          result.push_back(std::move(loop));
      for (const auto vertex : m_reached)
        m_distance[vertex] = m_infinite;
    }
    std::sort(result.begin(), result.end(), [](const Loop& a, const Loop& b) { return a.length < b.length; });
    return result;
  }

private:
  static constexpr double m_infinite = std::numeric_limits<double>::infinity();

  double length(Mesh::Edge_index edge) const
  {
    const auto &p = m_mesh.point(m_mesh.vertex(edge, 0)), &q = m_mesh.point(m_mesh.vertex(edge, 1));
    return std::sqrt(CGAL::squared_distance(p, q));
  }

  double length_of_loop(Mesh::Edge_index edge) const
  {
    return m_distance[m_mesh.vertex(edge, 0)] + m_distance[m_mesh.vertex(edge, 1)] + length(edge);
  }

  bool is_short(Mesh::Edge_index edge) const { return is_on_way(edge) || length_of_loop(edge) <= m_longest; }

  bool is_on_way(Mesh::Edge_index edge) const
  {
    const auto is_last = [&](Mesh::Halfedge_index halfedge) {
      const auto end = m_mesh.target(halfedge);
      return end != m_base && m_distance[end] < m_infinite && m_way[end] == halfedge;
    };
    return is_last(m_mesh.halfedge(edge, 0)) || is_last(m_mesh.halfedge(edge, 1));
  }

  void find_ways(Mesh::Vertex_index base)
  {
    using Step = std::pair<double, Mesh::Vertex_index>;
    std::priority_queue<Step, std::vector<Step>, std::greater<Step>> next;
    m_base = base;
    m_reached.assign(1, base);
    m_distance[base] = 0;
    next.emplace(0, base);
    while (!next.empty()) {
      const auto [distance, vertex] = next.top();
      next.pop();
      if (distance > m_distance[vertex])
        continue;
      for (const auto in : m_mesh.halfedges_around_target(m_mesh.halfedge(vertex))) {
        const auto out = m_mesh.opposite(in);
        const auto end = m_mesh.target(out);
        const double longer = distance + length(m_mesh.edge(out));
        if (2 * longer > m_longest || longer >= m_distance[end])
          continue;
        if (m_distance[end] == m_infinite)
          m_reached.push_back(end);
        m_distance[end] = longer;
        m_way[end] = out;
        next.emplace(longer, end);
      }
    }
  }

  std::vector<Mesh::Edge_index> edges_around_handles() const
  {
    std::vector<std::pair<double, Mesh::Edge_index>> closing;
    std::size_t corners = 0; // of faces between short edges
    for (const auto vertex : m_reached)
      for (const auto halfedge : m_mesh.halfedges_around_target(m_mesh.halfedge(vertex))) {
        const auto edge = m_mesh.edge(halfedge);
        if (m_mesh.halfedge(edge, 0) == halfedge && is_short(edge) && !is_on_way(edge))
          closing.emplace_back(length_of_loop(edge), edge);
        corners += is_short(edge) && is_short(m_mesh.edge(m_mesh.next(halfedge))) &&
            is_short(m_mesh.edge(m_mesh.prev(halfedge)));
      }
    if (3 * closing.size() <= corners)
      return {}; // these faces are a disk, or all of a sphere
    boost::disjoint_sets_with_storage<> joined(m_mesh.number_of_faces());
    const auto join = [&](Mesh::Edge_index edge) {
      const auto set_beside = [&](unsigned side) -> std::size_t {
        const std::size_t face = m_mesh.face(m_mesh.halfedge(edge, side));
        return joined.find_set(face);
      };
      const std::size_t one = set_beside(0), other = set_beside(1);
      if (one != other)
        joined.link(one, other);
      return one != other;
    };
    for (const auto edge : m_mesh.edges())
      if (!is_short(edge))
        join(edge);
    std::sort(closing.begin(), closing.end(), std::greater<>());
    std::vector<Mesh::Edge_index> result;
    for (const auto& [length, edge] : closing)
      if (!join(edge))
        result.push_back(edge);
    return result;
  }

  Loop loop_over(Mesh::Edge_index edge) const
  {
    Loop result{way_to(m_mesh.vertex(edge, 1)), length_of_loop(edge)};
    result.halfedges.push_back(m_mesh.halfedge(edge, 0));
    const std::vector<Mesh::Halfedge_index> back = way_to(m_mesh.vertex(edge, 0));
    for (auto halfedge = back.rbegin(); halfedge != back.rend(); ++halfedge)
      result.halfedges.push_back(m_mesh.opposite(*halfedge));
    return result;
  }

  std::vector<Mesh::Halfedge_index> way_to(Mesh::Vertex_index vertex) const
  {
    std::vector<Mesh::Halfedge_index> result;
    for (; vertex != m_base; vertex = m_mesh.source(result.back()))
      result.push_back(m_way[vertex]);
    std::reverse(result.begin(), result.end());
    return result;
  }

  // Of a loop that does not return on a part of its way.
  bool is_first_base(const Loop& loop) const
  {
    return loop.halfedges.front() != m_mesh.opposite(loop.halfedges.back()) &&
        std::all_of(loop.halfedges.begin(), loop.halfedges.end(),
                    [&](Mesh::Halfedge_index halfedge) { return !(m_mesh.target(halfedge) < m_base); });
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_SHORT_LOOPS_H
