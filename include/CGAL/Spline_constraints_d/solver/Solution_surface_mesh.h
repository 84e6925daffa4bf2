// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLUTION_SURFACE_MESH_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLUTION_SURFACE_MESH_H

#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

How fine the triangles of a surface of solutions are, see `to_surface_mesh()`. Lengths are those of the image in space.
*/
struct Surface_mesh_options
{
  //! how far triangles may be from the surface, as `Solution_surface_mesh::error` measures it.
  double chord_error = 1e-2;

  //! how much an edge may turn from one end to the other, in radians, as long as the surface is farther from it than a
  //! sixteenth of the chord error.
  double angle = 0.5;

  //! how long edges may be.
  double edge_length = std::numeric_limits<double>::infinity();

  //! whether triangles are made well-shaped: edges are split, collapsed and flipped, and vertices move on the surface.
  //! Without it vertices are where patches have them, many angles are small, and only edges keep to the chord error.
  bool is_remeshed = true;
};

/*!
\ingroup PkgSplineConstraintsDSolver

First and second order properties of a surface in space at a point, in doubles.
*/
struct Surface_differentials_3
{
  using Vector = CGAL::Simple_cartesian<double>::Vector_3;

  std::array<Vector, 2> tangents;    ///< of unit length, perpendicular to each other
  Vector normal;                     ///< their cross product
  std::array<double, 3> second_form; ///< \f$L, M, N\f$ with respect to these tangents
  std::array<double, 2> curvatures;  ///< the principal curvatures, the smaller one first
  std::array<Vector, 2> directions;  ///< the principal directions, of unit length

  //! the product of the principal curvatures.
  double gaussian_curvature() const { return curvatures[0] * curvatures[1]; }

  //! the mean of the principal curvatures; positive where the surface bends to the side of its normal.
  double mean_curvature() const { return 0.5 * (curvatures[0] + curvatures[1]); }
};

/*!
\ingroup PkgSplineConstraintsDSolver

Triangles of surfaces of solutions, see `to_surface_mesh()`. Callers add further property maps of the mesh from the
unknowns of its vertices.
*/
class Solution_surface_mesh
{
public:
  //! the mesh, in doubles.
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

  Mesh mesh; ///< all surfaces, oriented by the gradients of the equalities

  //! all unknowns at the vertices, those of inequalities at the end: the property map `"v:unknowns"` of the mesh.
  Mesh::Property_map<Mesh::Vertex_index, std::vector<double>> unknowns;

  //! normals, curvatures and principal directions at the vertices: the property map `"v:differentials"`.
  Mesh::Property_map<Mesh::Vertex_index, Surface_differentials_3> differentials;

  //! index of the surface that a triangle is a part of: the property map `"f:surface"`.
  Mesh::Property_map<Mesh::Face_index, std::size_t> surface;

  //! whether an edge lies on the boundary of a surface, or on a curve that surfaces are cut along, such as breaks of
  //! splines: the property map `"e:is_feature"`.
  Mesh::Property_map<Mesh::Edge_index, bool> is_feature;

  //! measured: the greatest distance found of the middle of a triangle from the surface, and of a point of the surface
  //! beside the middle of an edge from this edge.
  double error = 0;

  std::vector<Undecided_part> undecided_parts = {}; ///< see `undecided()`
  Summary work = {};                                ///< see `summary()`

  //! no triangles.
  Solution_surface_mesh() { set_maps(); }

  //! a copy, whose property maps are those of its own mesh.
  Solution_surface_mesh(const Solution_surface_mesh& other)
    : mesh(other.mesh), error(other.error), undecided_parts(other.undecided_parts), work(other.work)
  {
    set_maps();
  }
  Solution_surface_mesh(Solution_surface_mesh&&) = default;
  Solution_surface_mesh& operator=(const Solution_surface_mesh& other) { return *this = Solution_surface_mesh(other); }
  Solution_surface_mesh& operator=(Solution_surface_mesh&&) = default;

  //! whether all surfaces are there, as fine as was asked for.
  bool is_complete() const { return undecided_parts.empty(); }

  //! what is undecided of the surfaces, and patches that could not be triangulated.
  const std::vector<Undecided_part>& undecided() const { return undecided_parts; }

  //! the work; a node is a point of the surface that was looked at.
  const Summary& summary() const { return work; }

private:
  // Those of the mesh with these names.
  void set_maps()
  {
    unknowns = mesh.add_property_map<Mesh::Vertex_index, std::vector<double>>("v:unknowns").first;
    differentials = mesh.add_property_map<Mesh::Vertex_index, Surface_differentials_3>("v:differentials").first;
    surface = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:surface").first;
    is_feature = mesh.add_property_map<Mesh::Edge_index, bool>("e:is_feature", false).first;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLUTION_SURFACE_MESH_H
