// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_MESH_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_MESH_3_H

#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

How fine the triangles of a smooth surface are, see `to_surface_mesh()`.
*/
struct Smooth_surface_fineness
{
  //! how far the surface may be from triangles, as `Smooth_surface_mesh_3::error` measures it.
  double chord_error = 1e-2;

  //! the number of times at most that the edges of the sixth parts of faces are halved.
  int most_halvings = 5;
};

/*!
\ingroup PkgSplineConstraintsDSmoothSurfaces

Triangles of a smooth surface, see `to_surface_mesh()`.
*/
class Smooth_surface_mesh_3
{
public:
  //! the mesh, in doubles.
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

  Mesh mesh; ///< the triangles, with normals that point outwards

  //! unit normals of the surface at the vertices: the property map `"v:normal"` of the mesh.
  Mesh::Property_map<Mesh::Vertex_index, CGAL::Simple_cartesian<double>::Vector_3> normals;

  //! the face that a triangle is over: the property map `"f:face"`.
  Mesh::Property_map<Mesh::Face_index, std::size_t> face;

  //! measured: the greatest distance that was found from the plane of a triangle to the point of the surface on the
  //! segment through its middle.
  double error = 0;

  std::vector<Undecided_part> undecided_parts = {}; ///< see `undecided()`
  Summary work = {};                                ///< see `summary()`

  //! no triangles.
  Smooth_surface_mesh_3() { set_maps(); }

  //! a copy, whose property maps are those of its own mesh.
  Smooth_surface_mesh_3(const Smooth_surface_mesh_3& other)
    : mesh(other.mesh), error(other.error), undecided_parts(other.undecided_parts), work(other.work)
  {
    set_maps();
  }
  Smooth_surface_mesh_3(Smooth_surface_mesh_3&&) = default;
  Smooth_surface_mesh_3& operator=(const Smooth_surface_mesh_3& other) { return *this = Smooth_surface_mesh_3(other); }
  Smooth_surface_mesh_3& operator=(Smooth_surface_mesh_3&&) = default;

  //! whether all of the surface is there, as fine as was asked for.
  bool is_complete() const { return undecided_parts.empty(); }

  //! what is undecided of the surface, and is left out of the mesh.
  const std::vector<Undecided_part>& undecided() const { return undecided_parts; }

  //! the work; a node is a vertex of the mesh.
  const Summary& summary() const { return work; }

private:
  void set_maps()
  {
    normals = mesh.add_property_map<Mesh::Vertex_index, CGAL::Simple_cartesian<double>::Vector_3>("v:normal").first;
    face = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:face").first;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SMOOTH_SURFACES_SMOOTH_SURFACE_MESH_3_H
