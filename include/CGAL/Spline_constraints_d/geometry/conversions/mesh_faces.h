// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_MESH_FACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_MESH_FACES_H

#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_surface.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The vertices of a triangle or of a quadrangle, planar or not, in the order of `to_bspline_surfaces()`, if this is the
// patch of one.
template <class Kernel>
std::vector<CGAL::Point_3<Kernel>> vertices_of_patch(const Bspline_surface_3<Kernel>& surface)
{
  const auto [u, end_of_u] = surface.domain(0);
  const auto [v, end_of_v] = surface.domain(1);
  const std::array<CGAL::Point_3<Kernel>, 4> p{surface(u, v), surface(end_of_u, v), surface(end_of_u, end_of_v),
                                               surface(u, end_of_v)};
  if (!(bilinear_surface<Kernel>(p[0], p[3], p[1], p[2]).with_domain(0, u, end_of_u).with_domain(1, v, end_of_v) ==
        surface))
    return {};
  std::vector<CGAL::Point_3<Kernel>> result(p.begin(), p.end());
  if (p[3] == p[0])
    result.pop_back();
  return result;
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the faces of a mesh, in the order of `mesh.faces()`, each with its descriptor: a triangle as the conversion of
`Triangle_3` has it, a face with four vertices
\f$p_0, \dots, p_3\f$, planar or not, as the bilinear patch with \f$S(0,0) = p_0\f$, \f$S(1,0) = p_1\f$, \f$S(1,1) =
p_2\f$, \f$S(0,1) = p_3\f$. Normals are on the side from which the mesh shows its vertices counterclockwise. Exact in
every kernel.
\throws Invalid_input when a face has more than four vertices; the message names it.
*/
template <SplineKernel Kernel>
auto to_bspline_surfaces(const CGAL::Surface_mesh<CGAL::Point_3<Kernel>>& mesh)
{
  using Mesh = CGAL::Surface_mesh<CGAL::Point_3<Kernel>>;
  std::vector<std::pair<typename Mesh::Face_index, Bspline_surface_3<Kernel>>> result;
  for (const auto face : mesh.faces()) {
    std::vector<CGAL::Point_3<Kernel>> p;
    for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
      p.push_back(mesh.point(vertex));
    if (p.size() == 3)
      result.emplace_back(face, to_bspline_surface(CGAL::Triangle_3<Kernel>(p[0], p[1], p[2])));
    else if (p.size() == 4)
      result.emplace_back(face, bilinear_surface<Kernel>(p[0], p[3], p[1], p[2]));
    else
      throw Invalid_input("to_bspline_surfaces: face " + std::to_string(static_cast<std::size_t>(face)) +
                          " of the mesh has " + std::to_string(p.size()) + " vertices; triangulate it first");
  }
  return result;
}

//! the triangle that the surface is a patch of, as the conversion of `Triangle_3` makes it, over any domain; see
//! `to_bspline_surface()`. Decided exactly in every kernel.
template <SplineKernel Kernel>
std::optional<CGAL::Triangle_3<Kernel>> to_triangle(const Bspline_surface_3<Kernel>& surface)
{
  const auto p = internal::vertices_of_patch(surface);
  if (p.size() != 3)
    return std::nullopt;
  return CGAL::Triangle_3<Kernel>(p[0], p[1], p[2]);
}

//! the cuboid whose faces the surfaces are, in any order, as the conversion of `Iso_cuboid_3` makes them, if there is
//! one. Decided exactly in every kernel.
template <std::ranges::forward_range Surfaces>
auto to_iso_cuboid(const Surfaces& surfaces)
{
  using Kernel = typename std::ranges::range_value_t<Surfaces>::Kernel;
  std::optional<CGAL::Iso_cuboid_3<Kernel>> result;
  std::vector<CGAL::Point_3<Kernel>> corners;
  for (const auto& surface : surfaces)
    for (const auto& p : internal::vertices_of_patch(surface))
      corners.push_back(p);
  if (corners.empty())
    return result;
  const CGAL::Iso_cuboid_3<Kernel> cuboid = CGAL::bounding_box(corners.begin(), corners.end());
  const auto faces = to_bspline_surfaces(cuboid);
  if (std::ranges::is_permutation(surfaces, faces, [](const auto& a, const auto& b) { return a == b; }))
    result = cuboid;
  return result;
}

/*!
the mesh whose faces the surfaces are, in their order, if there is one: each is a triangle or a bilinear patch as
`to_bspline_surfaces()` makes them, over any domain; equal corners are one vertex, and no edge has more than two faces,
nor two that run along it the same way. Decided exactly in every kernel.
\param surfaces a range of `Bspline_surface_3` over one kernel.
\throws Invalid_input when a surface is no such patch, or does not fit to those before it; the message tells its place
in the range.
*/
template <std::ranges::input_range Surfaces>
auto to_surface_mesh(const Surfaces& surfaces)
{
  using Point = typename std::ranges::range_value_t<Surfaces>::Point;
  using Mesh = CGAL::Surface_mesh<Point>;
  Mesh result;
  std::map<Point, typename Mesh::Vertex_index> vertex_at;
  std::size_t place = 0;
  for (const auto& surface : surfaces) {
    const auto refuse = [&](const char* reason) {
      throw Invalid_input("to_surface_mesh: surface " + std::to_string(place) + reason);
    };
    std::vector<typename Mesh::Vertex_index> vertices;
    for (const Point& p : internal::vertices_of_patch(surface)) {
      const auto [known, is_new] = vertex_at.try_emplace(p);
      if (is_new)
        known->second = result.add_vertex(p);
      if (std::find(vertices.begin(), vertices.end(), known->second) != vertices.end())
        refuse(" has a corner twice");
      vertices.push_back(known->second);
    }
    if (vertices.empty())
      refuse(" is no triangle and no bilinear patch");
    if (result.add_face(vertices) == Mesh::null_face())
      refuse(" has an edge that is taken, or makes a vertex that is not manifold");
    ++place;
  }
  return result;
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_MESH_FACES_H
