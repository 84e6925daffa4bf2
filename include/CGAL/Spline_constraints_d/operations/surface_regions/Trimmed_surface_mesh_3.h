// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_TRIMMED_SURFACE_MESH_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_TRIMMED_SURFACE_MESH_3_H

#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

Triangles of the regions of a surface that have one label, see `to_surface_mesh()`. Callers add further property maps of
the mesh from the parameters of its vertices.
*/
struct Trimmed_surface_mesh_3
{
  //! the mesh, in doubles.
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  //! exact parameters of a vertex.
  using Parameters = Trimmed_surface_3::Kernel::Point_2;

  Mesh mesh; ///< oriented as the plane of parameters is

  //! the parameters of the vertices: the property map `"v:parameters"` of the mesh.
  Mesh::Property_map<Mesh::Vertex_index, Parameters> parameters;

  //! the index of the face of the trimmed surface that a triangle is a part of: the property map `"f:surface_face"`.
  Mesh::Property_map<Mesh::Face_index, std::size_t> surface_face;

  //! proved: no point of a triangle is farther from the point of the surface with the same parameters.
  double error = 0;

  std::vector<Undecided_part> undecided_parts = {}; ///< see `undecided()`
  Summary work = {};                                ///< see `summary()`

  //! whether the error is as small as was asked for, and all faces of the label are there.
  bool is_complete() const { return undecided_parts.empty(); }

  //! faces that are not, or only coarsely, in the mesh, and what is undecided of the trimmed surface.
  const std::vector<Undecided_part>& undecided() const { return undecided_parts; }

  //! the work; a node is a vertex that was inserted to make triangles smaller.
  const Summary& summary() const { return work; }

  //! the sum of the areas of the triangles.
  double area() const
  {
    double result = 0;
    for (const auto face : mesh.faces()) {
      const auto h = mesh.halfedge(face);
      const auto &p = mesh.point(mesh.source(h)), &q = mesh.point(mesh.target(h)),
                 &r = mesh.point(mesh.target(mesh.next(h)));
      result += 0.5 * std::sqrt(CGAL::cross_product(q - p, r - p).squared_length());
    }
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_TRIMMED_SURFACE_MESH_3_H
