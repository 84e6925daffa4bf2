// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_BOUNDARY_OF_CELLS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_BOUNDARY_OF_CELLS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/internal/arrangement/Triangle_shells.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Swept_volumes {

// The triangles between cells that are inside of a solid and cells that are not, as closed surfaces whose normals point
// outwards. Where more than two of them meet in an edge or in a vertex, those are joined that the inside is between,
// and the edge or vertex is there several times.
class Boundary_of_cells
{
public:
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

private:
  const Triangle_complex& m_complex;
  const Triangle_shells& m_shells;
  const std::vector<bool>& m_is_inside; // of the cell of a shell

public:
  Boundary_of_cells(const Triangle_complex& complex, const Triangle_shells& shells, const std::vector<bool>& is_inside)
    : m_complex(complex), m_shells(shells), m_is_inside(is_inside)
  {}

  // Of all surfaces together.
  struct Topology
  {
    std::size_t parts = 0;  // connected ones
    int characteristic = 0; // of Euler

    // The sum of the Betti numbers.
    int complexity() const { return 4 * static_cast<int>(parts) - characteristic; }

    friend bool operator==(const Topology&, const Topology&) = default;
  };

  // That of the mesh, which is not made.
  Topology topology() const
  {
    const std::vector<std::size_t> class_of = classes_of_corners();
    boost::disjoint_sets_with_storage<> parts(class_of.size());
    std::vector<bool> is_vertex(class_of.size(), false);
    Topology result;
    int faces = 0, vertices = 0;
    for (std::size_t triangle = 0; triangle < m_complex.triangles.size(); ++triangle) {
      if (!is_kept(triangle))
        continue;
      ++faces;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t vertex = class_of[3 * triangle + k];
        vertices += !is_vertex[vertex];
        is_vertex[vertex] = true;
        parts.union_set(class_of[3 * triangle], vertex);
      }
    }
    for (std::size_t vertex = 0; vertex < is_vertex.size(); ++vertex)
      result.parts += is_vertex[vertex] && parts.find_set(vertex) == vertex;
    result.characteristic = vertices - faces / 2; // each triangle has three halves of edges
    return result;
  }

  Mesh operator()() const
  {
    const std::vector<std::size_t> class_of = classes_of_corners();
    Mesh result;
    std::unordered_map<std::size_t, Mesh::Vertex_index> vertices; // of classes
    const std::unordered_map<std::size_t, Mesh::Vertex_index> middles = middles_of_sides(result);
    for (std::size_t triangle = 0; triangle < m_complex.triangles.size(); ++triangle) {
      if (!is_kept(triangle))
        continue;
      std::vector<Mesh::Vertex_index> around;
      int divided = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [vertex, is_new] = vertices.try_emplace(class_of[3 * triangle + k]);
        if (is_new)
          vertex->second = result.add_vertex(rounded(m_complex.triangles[triangle][k]));
        around.push_back(vertex->second);
        if (const auto middle = middles.find(3 * triangle + k); middle != middles.end()) {
          around.push_back(middle->second);
          ++divided;
        }
      }
      if (is_inside(triangle, 0))
        std::reverse(around.begin(), around.end());
      add_polygon(result, around, divided);
    }
    return result;
  }

private:
  using Leaf = Triangle_shells::Leaf;

  bool is_inside(std::size_t triangle, int side) const { return m_is_inside[m_shells.shell_of(triangle, side)]; }
  bool is_kept(std::size_t triangle) const { return is_inside(triangle, 0) != is_inside(triangle, 1); }

  Mesh::Point rounded(std::size_t index) const
  {
    const auto point = Swept_volumes::rounded(m_complex.points[index]);
    return {point.x(), point.y(), point.z()};
  }

  // The pairs of kept triangles around an edge that the inside is between.
  std::vector<std::array<Leaf, 2>> pairs_at(const Triangle_shells::Edge& edge) const
  {
    std::vector<Leaf> kept;
    for (const Leaf& leaf : edge.leaves)
      if (is_kept(leaf.triangle))
        kept.push_back(leaf);
    std::vector<std::array<Leaf, 2>> result;
    for (std::size_t i = 0; i < kept.size(); ++i)
      if (is_inside(kept[i].triangle, kept[i].next_side()))
        result.push_back({kept[i], kept[(i + 1) % kept.size()]});
    return result;
  }

  // Of each corner of a triangle, one of those that are the same vertex.
  std::vector<std::size_t> classes_of_corners() const
  {
    const std::size_t count = 3 * m_complex.triangles.size();
    std::vector<std::size_t> rank(count), parent(count);
    boost::disjoint_sets<std::size_t*, std::size_t*> vertices(rank.data(), parent.data());
    for (std::size_t i = 0; i < count; ++i)
      vertices.make_set(i);
    for (const auto& edge : m_shells.edges())
      for (const auto& [leaf, next] : pairs_at(edge))
        for (const std::size_t end : edge.ends)
          vertices.union_set(corner_at(leaf.triangle, end), corner_at(next.triangle, end));
    std::vector<std::size_t> result(count);
    for (std::size_t i = 0; i < count; ++i)
      result[i] = vertices.find_set(i);
    return result;
  }

  // Where several pairs meet at an edge, all but one get vertices of their own in its middle, as a mesh has no more
  // than one edge between two vertices. By sides of triangles.
  std::unordered_map<std::size_t, Mesh::Vertex_index> middles_of_sides(Mesh& mesh) const
  {
    std::unordered_map<std::size_t, Mesh::Vertex_index> result;
    for (const auto& edge : m_shells.edges()) {
      const std::vector<std::array<Leaf, 2>> pairs = pairs_at(edge);
      for (std::size_t i = 1; i < pairs.size(); ++i) {
        const auto middle = mesh.add_vertex(CGAL::midpoint(rounded(edge.ends[0]), rounded(edge.ends[1])));
        for (const Leaf& leaf : pairs[i])
          result[corner_at(leaf.triangle, edge.ends[leaf.has_edge ? 0 : 1])] = middle;
      }
    }
    return result;
  }

  static void add_polygon(Mesh& mesh, const std::vector<Mesh::Vertex_index>& around, int divided)
  {
    if (divided == 0) {
      mesh.add_face(around[0], around[1], around[2]);
      return;
    }
    const auto point = [&](std::size_t k) { return mesh.point(around[k % around.size()]); };
    const auto center =
        mesh.add_vertex(CGAL::centroid(point(0), point(around.size() / 3), point(2 * around.size() / 3)));
    for (std::size_t k = 0; k < around.size(); ++k)
      mesh.add_face(center, around[k], around[(k + 1) % around.size()]);
  }

  std::size_t corner_at(std::size_t triangle, std::size_t point) const
  {
    const Corners& corners = m_complex.triangles[triangle];
    return 3 * triangle + (corners[0] == point ? 0 : corners[1] == point ? 1 : 2);
  }
};

} // namespace Swept_volumes
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SWEPT_VOLUMES_INTERNAL_ARRANGEMENT_BOUNDARY_OF_CELLS_H
