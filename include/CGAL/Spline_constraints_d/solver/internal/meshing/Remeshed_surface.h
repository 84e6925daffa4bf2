// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_REMESHED_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_REMESHED_SURFACE_H

#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/internal/meshing/Mesh_points.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What is known of the vertices of a mesh besides their unknowns.
struct Remeshed_vertex
{
  std::size_t patch;           // whose polynomials are used there
  std::vector<int> fixed = {}; // the unknowns that the features at the vertex fix
  bool is_corner = false;      // features end or turn there, so that it stays
  bool is_singular = false;    // the surface has no normal there; a corner, too
  double length = 0;           // that edges should have
  double longest = 0;          // that they may have while the mesh is coarser than it should be
  Surface_differentials_3::Vector normal{0, 0, 0};
};

using Remeshed_vertices =
    Solution_surface_mesh::Mesh::Property_map<Solution_surface_mesh::Mesh::Vertex_index, Remeshed_vertex>;

// A mesh of a surface that changes: how long its edges should be, points of the surface beside its edges and triangles,
// and edges that are split there.
class Remeshed_surface
{
protected:
  using Mesh = Solution_surface_mesh::Mesh;
  using Vertex = Mesh::Vertex_index;
  using Halfedge = Mesh::Halfedge_index;
  using Edge = Mesh::Edge_index;
  using Face = Mesh::Face_index;
  using Point = Surface_image::Point;
  using Vector = Surface_image::Vector;
  using Unknowns = Surface_points::Point;

  struct Sample
  {
    Unknowns unknowns;
    Point image;
    std::size_t patch;
  };

  Solution_surface_mesh& m_result;
  Mesh& m_mesh;
  Mesh_points& m_points;
  Remeshed_vertices m_vertices;
  double m_coarseness = 1; // how many times as long as they should be edges are for now
  Sample m_middle;         // see find_middle()

  // How far find_middle() goes, as a share of lengths of edges: what is left is less than this share of the distance
  // where edges turn by 1 at most. With 0 it goes on up to rounding.
  double m_enough = 0.01;

  // Distances from the surface that were measured, of edges and faces by their indices.
  struct Measured
  {
    double distance = 0;
    bool is_fine = true, is_known = false;
  };
  std::vector<Measured> m_edges, m_faces;

private:
  double m_longest;

protected:
  Remeshed_surface(Solution_surface_mesh& result, Mesh_points& points, Remeshed_vertices vertices)
    : m_result(result), m_mesh(result.mesh), m_points(points), m_vertices(vertices)
  {
    CGAL::Bbox_3 box;
    for (const Vertex v : m_mesh.vertices())
      box += m_mesh.point(v).bbox();
    constexpr double share = 0.25; // of the extent, for edges of a plane
    m_longest = share * (std::max)({box.x_span(), box.y_span(), box.z_span()});
  }

  Remeshed_vertex& data(Vertex v) { return m_vertices[v]; }
  const Unknowns& unknowns(Vertex v) const { return m_result.unknowns[v]; }
  bool is_feature(Edge e) const { return m_result.is_feature[e]; }

  void describe(Vertex v)
  {
    describe(v,
             data(v).is_singular ? Surface_image::no_differentials()
                                 : m_points.image().differentials(data(v).patch, unknowns(v)));
  }

  void describe(Vertex v, const Surface_differentials_3& own)
  {
    const Surface_mesh_options& options = m_points.options();
    const auto [least, greatest] = own.curvatures;
    const double curvature = (std::max)(std::abs(least), std::abs(greatest));
    // the middle of an edge is l^2 / 8 times the curvature away, that of an equilateral triangle l^2 / 6 times the mean
    // one; few edges are much longer than they should be, and split in the end
    const double distance = (std::max)(curvature / 8, std::abs(least + greatest) / 12);
    constexpr double margin = 0.95, share = 4; // see Mesh_points::is_fine()
    constexpr double greatest_angle = 0.6;     // of edges while the mesh is coarser
    double length = (std::min)(options.edge_length, m_longest);
    data(v).longest = m_longest;
    if (curvature > 0) {
      const double of_error = margin * std::sqrt(options.chord_error / distance);
      length = (std::min)({length, of_error, (std::max)(margin * options.angle / curvature, of_error / share)});
      data(v).longest = (std::min)(m_longest, greatest_angle / curvature);
    }
    // edges shorter than the error need not become shorter still, such as those beside singular points
    data(v).length = (std::max)(length, (std::min)(options.edge_length, 0.5 * options.chord_error));
    data(v).normal = own.normal;
    m_result.differentials[v] = own;
  }

  double length_of(Edge e) const
  {
    const Halfedge h = m_mesh.halfedge(e);
    return std::sqrt(CGAL::squared_distance(m_mesh.point(m_mesh.source(h)), m_mesh.point(m_mesh.target(h))));
  }

  double aim(Vertex v)
  {
    const Remeshed_vertex& own = data(v);
    return (std::max)(own.length, (std::min)(m_coarseness * own.length, own.longest));
  }
  double aim(Vertex a, Vertex b) { return (std::min)(aim(a), aim(b)); }

  // Sets m_middle to the point of the surface beside the middle of some vertices, up to a small part of its distance
  // from there; that of a feature, on it. False if it is far away.
  bool find_middle(std::span<const Vertex> vertices, std::span<const int> fixed)
  {
    const double share = 1 / static_cast<double>(vertices.size());
    const Unknowns &first = unknowns(vertices[0]), &second = unknowns(vertices[1]);
    m_middle.unknowns.assign(first.size(), 0);
    Vector sum(0, 0, 0);
    for (const Vertex v : vertices) {
      for (std::size_t j = 0; j < first.size(); ++j)
        m_middle.unknowns[j] += unknowns(v)[j] * share;
      sum = sum + (m_mesh.point(v) - CGAL::ORIGIN);
    }
    for (const int j : fixed)
      m_middle.unknowns[static_cast<std::size_t>(j)] = first[static_cast<std::size_t>(j)];
    m_middle.patch = data(vertices[0]).patch;
    for (const Vertex v : vertices)
      m_middle.patch = m_points.surface().nearer(m_middle.patch, data(v).patch, m_middle.unknowns);
    m_middle.patch = m_points.surface().in_cell(m_middle.patch, m_middle.unknowns);
    double extent = 0;
    for (std::size_t j = 0; j < first.size(); ++j)
      extent = (std::max)(extent, std::abs(first[j] - second[j]));
    if (!m_points.surface().move_to_surface(m_middle.patch, fixed, m_middle.unknowns, m_enough * extent))
      return false;
    m_middle.image = m_points.image()(m_middle.patch, m_middle.unknowns);
    return CGAL::squared_distance(m_middle.image, CGAL::ORIGIN + share * sum) <
        0.25 * CGAL::squared_distance(m_mesh.point(vertices[0]), m_mesh.point(vertices[1]));
  }

  bool find_middle(Edge e)
  {
    const Halfedge h = m_mesh.halfedge(e);
    return find_middle(std::array{m_mesh.source(h), m_mesh.target(h)}, fixed_along(e));
  }

  // The unknowns that are fixed along a feature: those at both ends.
  std::vector<int> fixed_along(Edge e)
  {
    std::vector<int> result;
    if (!is_feature(e))
      return result;
    const Halfedge h = m_mesh.halfedge(e);
    const Vertex a = m_mesh.source(h), b = m_mesh.target(h);
    for (const int j : data(a).fixed)
      if (const auto& others = data(b).fixed; std::find(others.begin(), others.end(), j) != others.end() &&
          unknowns(a)[static_cast<std::size_t>(j)] == unknowns(b)[static_cast<std::size_t>(j)])
        result.push_back(j);
    return result;
  }

  // Whether an edge is near enough to the surface, and short enough; or m_middle is not found.
  bool is_fine(Edge e) { return !find_middle(e) || is_fine_with_middle(e); }

  bool is_fine_with_middle(Edge e) const
  {
    const Halfedge h = m_mesh.halfedge(e);
    return m_points.is_fine(m_mesh.point(m_mesh.source(h)), m_middle.image, m_mesh.point(m_mesh.target(h)));
  }

  // The edge and the triangles beside it change.
  void forget(Edge e)
  {
    if (m_edges.empty())
      return;
    m_edges[e] = {};
    for (const Halfedge h : {m_mesh.halfedge(e), m_mesh.opposite(m_mesh.halfedge(e))})
      if (!m_mesh.is_border(h))
        m_faces[m_mesh.face(h)] = {};
  }

  // At m_middle.
  Vertex split(Edge e)
  {
    forget(e);
    const bool is_on_feature = is_feature(e);
    const Halfedge h = m_mesh.halfedge(e);
    Remeshed_vertex own{m_middle.patch, fixed_along(e)};
    const Halfedge first = CGAL::Euler::split_edge(h, m_mesh); // to the new vertex, before h
    const Vertex vertex = m_mesh.target(first);
    data(vertex) = std::move(own);
    place(vertex, m_middle);
    describe(vertex);
    m_result.is_feature[m_mesh.edge(first)] = m_result.is_feature[m_mesh.edge(h)] = is_on_feature;
    for (const Halfedge in : {first, m_mesh.opposite(h)})
      if (const Face face = m_mesh.face(in); face != Mesh::null_face()) {
        const Halfedge diagonal = CGAL::Euler::split_face(in, m_mesh.next(m_mesh.next(in)), m_mesh);
        m_result.is_feature[m_mesh.edge(diagonal)] = false;
        for (const Halfedge side : {diagonal, m_mesh.opposite(diagonal)})
          m_result.surface[m_mesh.face(side)] = m_result.surface[face];
      }
    if (!m_edges.empty()) {
      m_edges.resize(m_mesh.num_edges());
      m_faces.resize(m_mesh.num_faces());
    }
    return vertex;
  }

  void place(Vertex v, const Sample& sample)
  {
    m_mesh.point(v) = sample.image;
    m_result.unknowns[v] = sample.unknowns;
    data(v).patch = sample.patch;
  }

  std::array<Vertex, 3> corners_of(Face face) const
  {
    const Halfedge h = m_mesh.halfedge(face);
    return {m_mesh.source(h), m_mesh.target(h), m_mesh.target(m_mesh.next(h))};
  }

  // Of m_middle from an edge.
  double distance_of_middle(Edge e) const
  {
    const Halfedge h = m_mesh.halfedge(e);
    return Mesh_points::distance_from_chord(m_mesh.point(m_mesh.source(h)), m_middle.image,
                                            m_mesh.point(m_mesh.target(h)));
  }

  // Of the middle of a triangle from the surface; 0 where that is not found.
  double distance_at_middle(Face face)
  {
    const std::array<Vertex, 3> corners = corners_of(face);
    const Point middle = CGAL::centroid(m_mesh.point(corners[0]), m_mesh.point(corners[1]), m_mesh.point(corners[2]));
    return find_middle(corners, {}) ? std::sqrt(CGAL::squared_distance(m_middle.image, middle)) : 0;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_MESHING_REMESHED_SURFACE_H
