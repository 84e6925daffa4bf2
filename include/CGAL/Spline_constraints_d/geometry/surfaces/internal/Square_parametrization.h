// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_SQUARE_PARAMETRIZATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_SQUARE_PARAMETRIZATION_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/internal/Mesh_charts.h>

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Puts the vertices around a mesh where they should be: a model of the concept `Parameterizer_3` for borders.
template <class Mesh>
class Given_border
{
  using Vertex = typename Mesh::Vertex_index;
  using Place = CGAL::Simple_cartesian<double>::Point_2;

  const std::map<Vertex, Place>* m_places;

public:
  using Triangle_mesh = Mesh;
  using TriangleMesh = Mesh;

  explicit Given_border(const std::map<Vertex, Place>& places) : m_places(&places) {}

  template <class Places, class Indices, class Flags>
  Surface_mesh_parameterization::Error_code parameterize(const Mesh& mesh, typename Mesh::Halfedge_index border,
                                                         Places places, Indices, Flags is_placed) const
  {
    for (const Vertex v : mesh.vertices_around_face(border)) {
      put(places, v, m_places->at(v));
      put(is_placed, v, true);
    }
    return Surface_mesh_parameterization::OK;
  }

  bool is_border_convex() const { return true; }
};

/*
Places in the unit square of the vertices inside of a chart, whose boundary is around the square: each is in the middle
of its neighbours (Tutte's barycentric mapping). This depends on the triangles alone, so that it is the same in a space
of any dimension, and it is one to one for any of them.
*/
inline std::map<Mesh_charts::Vertex, std::array<double, 2>>
square_parametrization(const Mesh_charts& charts, std::size_t chart,
                       const std::map<Mesh_charts::Vertex, std::array<double, 2>>& boundary)
{
  namespace SMP = Surface_mesh_parameterization;
  using Mesh = Mesh_charts::Mesh;
  using Vertex = Mesh_charts::Vertex;
  using Place = CGAL::Simple_cartesian<double>::Point_2;
  Mesh mesh;
  std::map<Vertex, Vertex> own;
  std::map<Vertex, Place> border;
  for (const auto& [v, place] : boundary)
    border.emplace(own.try_emplace(v, mesh.add_vertex(charts.mesh().point(v))).first->second,
                   Place(place[0], place[1]));
  for (const Mesh_charts::Face face : charts.faces(chart)) {
    std::vector<Vertex> corners;
    for (const Vertex v : charts.mesh().vertices_around_face(charts.mesh().halfedge(face))) {
      if (own.count(v) == 0)
        own.emplace(v, mesh.add_vertex(charts.mesh().point(v)));
      corners.push_back(own.at(v));
    }
    mesh.add_face(corners);
  }
  std::map<Vertex, std::array<double, 2>> result;
  if (own.size() == boundary.size())
    return result;
  Mesh::Halfedge_index around;
  for (const Mesh::Halfedge_index h : mesh.halfedges())
    if (mesh.is_border(h))
      around = h;
  using Solver = CGAL::Eigen_solver_traits<
      Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType, Eigen::COLAMDOrdering<int>>>;
  SMP::Barycentric_mapping_parameterizer_3<Mesh, Given_border<Mesh>, Solver> parametrizer{Given_border<Mesh>(border)};
  auto places = mesh.add_property_map<Vertex, Place>("v:place").first;
  if (SMP::parameterize(mesh, parametrizer, around, places) == SMP::OK)
    for (const auto& [v, copy] : own)
      if (boundary.count(v) == 0)
        result[v] = {places[copy].x(), places[copy].y()};
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_INTERNAL_SQUARE_PARAMETRIZATION_H
