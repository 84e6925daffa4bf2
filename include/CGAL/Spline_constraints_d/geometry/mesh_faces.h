// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_MESH_FACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_MESH_FACES_H

#include <CGAL/Spline_constraints_d/geometry/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/geometry/to_bspline_surface.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDConstructions

the faces of a mesh, in the order of `mesh.faces()`, each with its descriptor: a triangle as the conversion of `Triangle_3` has it, a face with four vertices
\f$p_0, \dots, p_3\f$, planar or not, as the bilinear patch with \f$S(0,0) = p_0\f$, \f$S(1,0) = p_1\f$, \f$S(1,1) = p_2\f$, \f$S(0,1) = p_3\f$. Normals are on the
side from which the mesh shows its vertices counterclockwise. Exact in every kernel.
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
      throw Invalid_input("to_bspline_surfaces: face " + std::to_string(static_cast<std::size_t>(face)) + " of the mesh has " + std::to_string(p.size()) +
                          " vertices; triangulate it first");
  }
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_MESH_FACES_H
