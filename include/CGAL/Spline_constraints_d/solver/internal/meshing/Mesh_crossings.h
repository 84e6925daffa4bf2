// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_MESH_CROSSINGS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_MESH_CROSSINGS_H

#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Box_hierarchy.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/intersections.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Whether triangles of one system meet elsewhere than in common vertices and edges, and in singular points, of which each
fan has a vertex of its own. The answer is exact. Triangles around a vertex do not cross where they are a graph over a
plane, which signs of a few determinants prove; what is left is decided by exact predicates for pairs of triangles.
*/
class Mesh_crossings
{
  using Mesh = Solution_surface_mesh::Mesh;
  using Vertex = Mesh::Vertex_index;
  using Face = Mesh::Face_index;
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

  // The points of the vertices in a kernel whose predicates are exact.
  struct Points_for_predicates
  {
    using key_type = Vertex;
    using value_type = Kernel::Point_3;
    using reference = Kernel::Point_3;
    using category = boost::readable_property_map_tag;

    const Mesh* mesh;

    friend Kernel::Point_3 get(const Points_for_predicates& map, Vertex v)
    {
      const auto& point = map.mesh->point(v);
      return {point.x(), point.y(), point.z()};
    }
  };

  struct Triangle
  {
    std::array<Vertex, 3> corners;
    std::size_t system;
  };

  const Mesh& m_mesh;
  std::vector<Triangle> m_triangles;

public:
  Mesh_crossings(const Solution_surface_mesh& surfaces, const Surface_solution_set_d& set) : m_mesh(surfaces.mesh)
  {
    m_triangles.reserve(m_mesh.number_of_faces());
    for (const Face face : m_mesh.faces())
      m_triangles.push_back({corners_of(face), set.surfaces()[surfaces.surface[face]].system});
  }

  bool exist() const
  {
    const auto vertices = m_mesh.vertices();
    return std::any_of(vertices.begin(), vertices.end(),
                       [&](Vertex v) { return !m_mesh.is_isolated(v) && !is_graph_around(v) && cross_around(v); }) ||
        cross_apart();
  }

private:
  std::array<Vertex, 3> corners_of(Face face) const
  {
    const auto h = m_mesh.halfedge(face);
    return {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))};
  }

  // Whether it is proved that the triangles around a vertex are one layer over the plane perpendicular to a direction:
  // they are counterclockwise there, and turn around the vertex no more than once.
  bool is_graph_around(Vertex v) const
  {
    Vector direction(0, 0, 0);
    auto first = m_mesh.halfedge(v);
    for (const auto h : m_mesh.halfedges_around_target(first))
      if (m_mesh.is_border(h))
        first = m_mesh.opposite(m_mesh.next(h));
      else
        direction += CGAL::cross_product(edge(v, m_mesh.target(m_mesh.next(h))), edge(v, m_mesh.source(h)));
    const Vector begin = edge(v, m_mesh.source(first));
    Vector from = begin;
    bool is_past_half = false;
    for (auto h = first; !m_mesh.is_border(h);) { // clockwise
      const Vector to = edge(v, m_mesh.target(m_mesh.next(h)));
      if (certain_sign(direction, to, from) <= 0)
        return false;
      h = m_mesh.opposite(m_mesh.next(h));
      if (h == first)
        break;
      const int side = certain_sign(direction, to, begin);
      if (side == 0 || (is_past_half && side > 0))
        return false;
      is_past_half = side < 0;
      from = to;
    }
    return true;
  }

  Vector edge(Vertex from, Vertex to) const { return m_mesh.point(to) - m_mesh.point(from); }

  // The sign of a determinant, or 0 where rounding errors may change it: differences and products are exact up to a few
  // units of the 53rd bit of the greatest product.
  static int certain_sign(const Vector& a, const Vector& b, const Vector& c)
  {
    constexpr double rounding = 0x1p-46, least = 0x1p-900; // no product is near the least number then
    const auto greatest = [](const Vector& v) {
      return (std::max)({std::abs(v.x()), std::abs(v.y()), std::abs(v.z())});
    };
    const double value = CGAL::determinant(a, b, c), bound = rounding * greatest(a) * greatest(b) * greatest(c);
    return !(bound > least) || !(std::abs(value) > bound) ? 0 : value > 0 ? 1 : -1;
  }

  bool cross_around(Vertex v) const
  {
    std::vector<Face> faces;
    for (const Face face : m_mesh.faces_around_target(m_mesh.halfedge(v)))
      if (face != Mesh::null_face())
        faces.push_back(face);
    std::vector<std::pair<Face, Face>> pairs;
    Polygon_mesh_processing::self_intersections(
        faces, m_mesh, std::back_inserter(pairs),
        CGAL::parameters::vertex_point_map(Points_for_predicates{&m_mesh}).geom_traits(Kernel()));
    return !pairs.empty();
  }

  // Whether triangles without a common vertex cross.
  bool cross_apart() const
  {
    std::vector<CGAL::Bbox_3> boxes;
    boxes.reserve(m_triangles.size());
    for (const Triangle& triangle : m_triangles) {
      const auto& [a, b, c] = triangle.corners;
      boxes.push_back(m_mesh.point(a).bbox() + m_mesh.point(b).bbox() + m_mesh.point(c).bbox());
    }
    return Box_hierarchy(boxes).any_pair(
        [&](std::size_t i, std::size_t k) { return cross_apart(m_triangles[i], m_triangles[k]); });
  }

  bool cross_apart(const Triangle& first, const Triangle& second) const
  {
    if (first.system != second.system)
      return false;
    for (const Vertex v : first.corners)
      if (std::find(second.corners.begin(), second.corners.end(), v) != second.corners.end())
        return false;
    const std::array<Kernel::Point_3, 3> p = points_of(first), q = points_of(second);
    return CGAL::do_intersect(Kernel::Triangle_3(p[0], p[1], p[2]), Kernel::Triangle_3(q[0], q[1], q[2])) &&
        !meet_in_a_corner_only(p, q);
  }

  std::array<Kernel::Point_3, 3> points_of(const Triangle& triangle) const
  {
    const Points_for_predicates points{&m_mesh};
    const auto& [a, b, c] = triangle.corners;
    return {get(points, a), get(points, b), get(points, c)};
  }

  static bool meet_in_a_corner_only(std::array<Kernel::Point_3, 3> p, std::array<Kernel::Point_3, 3> q)
  {
    for (int i = 0; i < 3; ++i, std::rotate(p.begin(), p.begin() + 1, p.end()))
      for (int k = 0; k < 3; ++k, std::rotate(q.begin(), q.begin() + 1, q.end()))
        if (p[0] == q[0]) // each opposite edge misses the other triangle
          return !CGAL::do_intersect(Kernel::Segment_3(p[1], p[2]), Kernel::Triangle_3(q[0], q[1], q[2])) &&
              !CGAL::do_intersect(Kernel::Segment_3(q[1], q[2]), Kernel::Triangle_3(p[0], p[1], p[2]));
    return false;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_MESH_CROSSINGS_H
