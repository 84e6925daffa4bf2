// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_MESH_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_MESH_H

#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/solver/Solution_surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solution_set_d.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Of the image of the unknowns in space; a null pointer stands for the first three unknowns.
Solution_surface_mesh mesh_of_solutions(const Surface_solution_set_d& set, const Vector_expression<3>* image,
                                        const Surface_mesh_options& options, const Solver_options& run);

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

triangles of surfaces of solutions, as a mesh in space, whose coordinates are the first three unknowns.

The mesh has the topology that was proved of the surfaces: each patch is triangulated over its two parameters, within
the polygon that its boundary is there, and patches share the points of their arcs. So it is a manifold, closed where
the surfaces are; with three unknowns no triangles meet but in common edges and vertices. A vertex in which surfaces
meet is there once for each fan of triangles. All vertices are solutions up to rounding, found by Newton's method, or by
the solver where that fails. Then, unless this is not wanted, triangles are made well-shaped; a mesh that would cross
itself after that is given as it was before.

\param set the solutions.
\param options how fine the triangles are.
\param run the limit of time, and a visitor. What was not done in time is undecided.
\throws Invalid_input when a bound is not positive.
*/
inline Solution_surface_mesh to_surface_mesh(const Surface_solution_set_d& set,
                                             const Surface_mesh_options& options = {}, const Solver_options& run = {})
{
  return internal::mesh_of_solutions(set, nullptr, options, run);
}

/*!
\ingroup PkgSplineConstraintsDSolver

the same of the image of surfaces of solutions, in any number of unknowns, under a map to space. Where the map is not
one to one the image may cross itself, or have edges; the mesh follows it.

\param set the solutions.
\param image the point of space as formulas of the unknowns, such as `S(u, v)` of a surface.
\param options how fine the triangles are, in space.
\param run the limit of time, and a visitor. What was not done in time is undecided.
\throws Invalid_input when a bound is not positive, or a formula has unknowns that the system does not have.
*/
inline Solution_surface_mesh to_surface_mesh(const Surface_solution_set_d& set, const Vector_expression<3>& image,
                                             const Surface_mesh_options& options = {}, const Solver_options& run = {})
{
  return internal::mesh_of_solutions(set, &image, options, run);
}

} // namespace Spline_constraints
} // namespace CGAL

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/meshing/mesh_of_solutions.h>
#endif

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SURFACE_MESH_H
