// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACES_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACES_3_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Smooth_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Smooth_surface_mesh_3.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/Smooth_surface_shape.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/Oriented_mesh.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/smooth_surface_finders.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/mesh_of_surface.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/places_in_surface.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/smooth_surface_of.h>
#include <CGAL/Spline_constraints_d/operations/smooth_surfaces/internal/vertex_gradients.h>
#endif

#include <CGAL/Point_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Vector_3.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Smooth_surfaces {

template <class Map, class Kernel>
concept Vector_map = requires(const Map& map,
                              const typename CGAL::Surface_mesh<CGAL::Point_3<Kernel>>::Vertex_index& vertex)
{
  exact_object(get(map, vertex)) == Exact_kernel::Vector_3();
};

// In exact numbers; vertices and facets in their order, removed ones left out.
template <class Kernel, class Vector_of_vertex>
Oriented_mesh exact_mesh(const CGAL::Surface_mesh<CGAL::Point_3<Kernel>>& mesh, const Vector_of_vertex& vector)
{
  Oriented_mesh result;
  std::vector<std::size_t> place(mesh.num_vertices());
  for (const auto vertex : mesh.vertices()) {
    place[vertex] = result.points.size();
    result.vertex_names.push_back(vertex);
    result.points.push_back(exact_object(mesh.point(vertex)));
    result.gradients.push_back(vector(vertex));
  }
  for (const auto face : mesh.faces()) {
    std::vector<std::size_t> corners;
    for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      corners.push_back(place[vertex]);
    result.facet_names.push_back(face);
    if (corners.size() != 3)
      refuse_mesh(result.name_of_facet(result.facets.size()) + " has " + std::to_string(corners.size()) +
                  " corners; triangulate it first");
    result.facets.push_back({corners[0], corners[1], corners[2]});
  }
  return result;
}

// A property map of the mesh with these vectors.
template <class Kernel>
auto map_of_vectors(CGAL::Surface_mesh<CGAL::Point_3<Kernel>>& mesh, const char* name,
                    const std::vector<Exact_kernel::Vector_3>& vectors)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Point_3<Kernel>>;
  auto map = mesh.template add_property_map<typename Mesh::Vertex_index, Exact_kernel::Vector_3>(name).first;
  std::size_t i = 0;
  for (const auto vertex : mesh.vertices())
    map[vertex] = vectors[i++];
  return map;
}

} // namespace Smooth_surfaces
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

a smooth closed surface through the vertices of a mesh of triangles, with given gradients there: the zeros of a function
that is piecewise cubic, has one derivative everywhere, and is negative inside. On each side of a face there is an apex,
and between apexes of neighbours a gap point; three tetrahedra for each side of a face, and four for each edge are the
pieces. If the mesh and the gradients are those of a quadric, and so are apex values, it is the quadric.

How far apexes are from faces is found by trials: such that all tetrahedra meet in common faces only, and that the
function is proved to increase along segments from the inner to the outer side, one through each point of the mesh.
Then the surface meets each of them in one point. Pieces for which none of the trials has proved that are undecided; the
surface may still be as it should.

\param mesh the mesh: triangles, closed, each component with faces that are counterclockwise as seen from outside; it
may have any number of components.
\param gradients a property map from vertices to vectors of a kernel, which point outwards. Their lengths matter: see
`balanced_gradients()`.
\param shape values that can be chosen.
\param options the limits, and a visitor; the tolerance does not matter.
\throws Invalid_input when a face is no triangle or has corners on a line, the mesh is not closed, not manifold or
empty, a gradient is zero or not on the outer side of each face at the vertex, a coordinate is not finite, or an option
makes no sense; the message tells which vertex, edge or face.

Complexity: linear in the number of faces for each trial, and a test for each pair of tetrahedra whose boxes meet.
Source: \cgalCite{g-asgic-91}, with closed forms instead of systems of equations, and a proof of the topology by parts
of tetrahedra.
*/
template <SplineKernel Kernel, internal::Smooth_surfaces::Vector_map<Kernel> Gradients>
Smooth_surface_3 smooth_surface(const CGAL::Surface_mesh<CGAL::Point_3<Kernel>>& mesh, const Gradients& gradients,
                                const Smooth_surface_shape& shape = {}, const Solver_options& options = {})
{
  return Smooth_surface_3(internal::Smooth_surfaces::smooth_surface_of(
      internal::Smooth_surfaces::exact_mesh(
          mesh, [&](const auto& vertex) { return internal::exact_object(get(gradients, vertex)); }),
      shape, options));
}

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

gradients for `smooth_surface()` that have the directions of normals, in doubles, taken as exact. Their lengths are such
that along edges the slopes at both ends contradict each other as little as possible: those of gradients of a quadric do
not.
\param mesh the mesh.
\param normals a property map from vertices to vectors, of any lengths, which point outwards.
\return the property map `"v:gradient"` of the mesh.
\throws Invalid_input as `smooth_surface()` does.
*/
template <SplineKernel Kernel, internal::Smooth_surfaces::Vector_map<Kernel> Normals>
auto balanced_gradients(CGAL::Surface_mesh<CGAL::Point_3<Kernel>>& mesh, const Normals& normals)
{
  const auto gradients = internal::Smooth_surfaces::balanced_gradients(internal::Smooth_surfaces::exact_mesh(
      mesh, [&](const auto& vertex) { return internal::exact_object(get(normals, vertex)); }));
  return internal::Smooth_surfaces::map_of_vectors(mesh, "v:gradient", gradients);
}

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

normals at the vertices of a mesh, in doubles, taken as exact: means of those of faces, weighted with their angles,
changed until they are on the outer side of each face at the vertex, if a vector is.
\return the property map `"v:estimated_normal"` of the mesh.
\throws Invalid_input when the mesh is not as for `smooth_surface()`.
*/
template <SplineKernel Kernel>
auto estimated_normals(CGAL::Surface_mesh<CGAL::Point_3<Kernel>>& mesh)
{
  const auto normals = internal::Smooth_surfaces::estimated_normals(internal::Smooth_surfaces::exact_mesh(
      mesh, [](const auto&) { return internal::Exact_kernel::Vector_3(0, 0, 0); }));
  return internal::Smooth_surfaces::map_of_vectors(mesh, "v:estimated_normal", normals);
}

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

triangles of a smooth surface: a closed mesh with the topology that is proved of it, since it is a subdivision of the
mesh given whose points are moved along the segments of the proof. All vertices are on the surface up to rounding, with
proved enclosures; neighbours share them by name. Pieces that are not certified are left out, and undecided.
\param surface the surface.
\param fineness how fine the triangles are.
\param options the limits, and a visitor; a vertex is a node.
\throws Invalid_input when a bound is not positive.

Complexity: of all triangles four times as many for each halving; about 20 µs for each vertex.
*/
inline Smooth_surface_mesh_3 to_surface_mesh(const Smooth_surface_3& surface,
                                             const Smooth_surface_fineness& fineness = {},
                                             const Solver_options& options = {})
{
  return internal::Smooth_surfaces::mesh_of_surface(surface.data(), fineness, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACES_3_H
