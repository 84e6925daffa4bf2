// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_ORIENTED_MESH_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_ORIENTED_MESH_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Union_find.h>
#include <CGAL/Vector_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

enum Side
{
  OUTER,
  INNER
};

/*
A closed oriented surface of triangles, with gradients at its vertices. Vertices and facets have the numbers of the mesh
that they come from as names.
*/
struct Oriented_mesh
{
  using Point = Exact_kernel::Point_3;
  using Vector = Exact_kernel::Vector_3;

  // The first of the facets has the ends in this order.
  struct Edge
  {
    std::array<std::size_t, 2> ends, facets;
  };

  std::vector<Point> points;
  std::vector<Vector> gradients;
  std::vector<std::array<std::size_t, 3>> facets;
  std::vector<std::size_t> vertex_names, facet_names;

  // Made from these by prepare_mesh().
  std::vector<Vector> normals; // of facets, twice as long as their area
  std::vector<Edge> edges;
  std::vector<std::array<std::size_t, 3>> edges_of_facets; // edge i is between the corners i and i + 1

  std::size_t number_of_components() const;

  std::string name_of_vertex(std::size_t v) const { return "vertex " + std::to_string(vertex_names[v]); }
  std::string name_of_facet(std::size_t f) const { return "face " + std::to_string(facet_names[f]); }
};

[[noreturn]] inline void refuse_mesh(const std::string& reason) { throw Invalid_input("smooth_surface: " + reason); }

void find_edges(Oriented_mesh& mesh);

// Whether the facets at each vertex are one fan.
void check_vertices(const Oriented_mesh& mesh);

// Also whether apexes exist, see Neighborhood.
void check_gradients(const Oriented_mesh& mesh);

// Fills in what follows from points and facets. \throws Invalid_input when the mesh is not as it must be.
void prepare_mesh(Oriented_mesh& mesh);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE std::size_t Oriented_mesh::number_of_components() const
{
  CGAL::Union_find<std::size_t> sets;
  std::vector<CGAL::Union_find<std::size_t>::handle> handles;
  for (std::size_t f = 0; f < facets.size(); ++f)
    handles.push_back(sets.make_set(f));
  for (const Edge& edge : edges)
    sets.unify_sets(handles[edge.facets[0]], handles[edge.facets[1]]);
  return sets.number_of_sets();
}

CGAL_SPLINE_CONSTRAINTS_INLINE void find_edges(Oriented_mesh& mesh)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> facet_of; // by source and target
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const std::size_t p = mesh.facets[f][i], q = mesh.facets[f][(i + 1) % 3];
      if (p == q)
        refuse_mesh(mesh.name_of_facet(f) + " has " + mesh.name_of_vertex(p) + " twice");
      if (const auto [known, is_new] = facet_of.try_emplace({p, q}, f); !is_new)
        refuse_mesh("the edge from " + mesh.name_of_vertex(p) + " to " + mesh.name_of_vertex(q) +
                    " is run through in this direction by " + mesh.name_of_facet(known->second) + " and by " +
                    mesh.name_of_facet(f) + ": the mesh is not manifold, or not oriented");
    }
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> edge_of;
  mesh.edges.clear();
  mesh.edges_of_facets.assign(mesh.facets.size(), {});
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
    for (int i = 0; i < 3; ++i) {
      const std::size_t p = mesh.facets[f][i], q = mesh.facets[f][(i + 1) % 3];
      const auto opposite = facet_of.find({q, p});
      if (opposite == facet_of.end())
        refuse_mesh("the mesh is not closed: its edge from " + mesh.name_of_vertex(p) + " to " +
                    mesh.name_of_vertex(q) + " has " + mesh.name_of_facet(f) + " only");
      const auto [place, is_new] = edge_of.try_emplace(std::minmax(p, q), mesh.edges.size());
      if (is_new)
        mesh.edges.push_back({{p, q}, {f, opposite->second}});
      mesh.edges_of_facets[f][i] = place->second;
    }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void check_vertices(const Oriented_mesh& mesh)
{
  std::vector<std::size_t> facet_at(mesh.points.size(), mesh.facets.size()), valence(mesh.points.size(), 0);
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
    for (const std::size_t v : mesh.facets[f]) {
      facet_at[v] = f;
      ++valence[v];
    }
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    if (valence[v] == 0)
      refuse_mesh(mesh.name_of_vertex(v) + " has no face");
    std::size_t f = facet_at[v], count = 0;
    do {
      int i = 0;
      while (mesh.facets[f][i] != v)
        ++i;
      const auto& edge = mesh.edges[mesh.edges_of_facets[f][i]];
      f = edge.facets[edge.facets[0] == f ? 1 : 0];
      ++count;
    } while (f != facet_at[v]);
    if (count != valence[v])
      refuse_mesh("the mesh is not manifold: the faces at " + mesh.name_of_vertex(v) + " are several fans");
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void check_gradients(const Oriented_mesh& mesh)
{
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    if (mesh.gradients[v] == CGAL::NULL_VECTOR)
      refuse_mesh("the normal at " + mesh.name_of_vertex(v) + " is zero");
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
    for (const std::size_t v : mesh.facets[f])
      if (!(mesh.gradients[v] * mesh.normals[f] > 0))
        refuse_mesh("the normal at " + mesh.name_of_vertex(v) + " does not point to the outer side of " +
                    mesh.name_of_facet(f));
}

CGAL_SPLINE_CONSTRAINTS_INLINE void prepare_mesh(Oriented_mesh& mesh)
{
  if (mesh.facets.empty())
    refuse_mesh("the mesh has no faces");
  find_edges(mesh);
  check_vertices(mesh);
  mesh.normals.clear();
  for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
    const auto& [p, q, r] = mesh.facets[f];
    mesh.normals.push_back(CGAL::cross_product(mesh.points[q] - mesh.points[p], mesh.points[r] - mesh.points[p]));
    if (mesh.normals.back() == CGAL::NULL_VECTOR)
      refuse_mesh("the corners of " + mesh.name_of_facet(f) + " are on a line");
  }
}
#endif

} // namespace Smooth_surfaces
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_INTERNAL_ORIENTED_MESH_H
