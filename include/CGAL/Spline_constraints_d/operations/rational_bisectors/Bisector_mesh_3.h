// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_BISECTOR_MESH_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_BISECTOR_MESH_3_H

#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_mesh_3.h>

#include <CGAL/Simple_cartesian.h>

#include <array>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

Triangles of a bisector, with the feet of their vertices.
*/
struct Bisector_mesh_3
{
  //! the mesh.
  using Mesh = Trimmed_surface_mesh_3::Mesh;
  //! a point of it.
  using Point = CGAL::Simple_cartesian<double>::Point_3;

  //! the triangles, with what is known of them.
  Trimmed_surface_mesh_3 triangles;

  //! the feet on both operands: the property maps `"v:foot_0"` and `"v:foot_1"` of the mesh.
  std::array<Mesh::Property_map<Mesh::Vertex_index, Point>, 2> feet;

  //! the distance of a vertex from its feet, rounded: the property map `"v:distance"`.
  Mesh::Property_map<Mesh::Vertex_index, double> distance;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_BISECTOR_MESH_3_H
