// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_IMPLICIT_SURFACE_MESH_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_IMPLICIT_SURFACE_MESH_H

#include <CGAL/Spline_constraints_d/geometry/conversions/from_cgal_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

all components of an implicit surface in its box, with their topology by proof.
\param surface the surface.
\param options as for `solve_surfaces()`.
*/
inline Surface_solution_set_d solve_surfaces(const Implicit_surface_3& surface,
                                             const Solver_options& options = {.tolerance = 1e-8})
{
  Constraint_system_d system({surface.box().begin(), surface.box().end()});
  system.add(surface.polynomial(), Relation::EQUAL);
  return solve_surfaces(system, options);
}

/*!
\ingroup PkgSplineConstraintsDGeometry

triangles of an implicit surface in its box: all components, with their topology by proof, oriented as the gradient of
the polynomial is.
\param surface the surface.
\param options how fine the triangles are.
\param run as for `solve_surfaces()`; its limit of time is that of finding the surface and of the triangles together.
\throws Invalid_input as `to_surface_mesh()` for surfaces of solutions.
*/
inline Solution_surface_mesh to_surface_mesh(const Implicit_surface_3& surface,
                                             const Surface_mesh_options& options = {},
                                             const Solver_options& run = {.tolerance = 1e-8})
{
  const Surface_solution_set_d set = solve_surfaces(surface, run);
  return to_surface_mesh(set, options, internal::rest_of(run, set.summary()));
}

/*!
\ingroup PkgSplineConstraintsDGeometry

the same of the zeros of a `CGAL::Polynomial` in three variables, within a box. Its variable \f$i\f$, counted from the
innermost, is coordinate \f$i\f$.
\throws Invalid_input also when the polynomial is constant, or a range of the box has no extent.
*/
template <class Coefficient>
Solution_surface_mesh to_surface_mesh(const CGAL::Polynomial<Coefficient>& polynomial,
                                      const Implicit_surface_3::Box& box, const Surface_mesh_options& options = {},
                                      const Solver_options& run = {.tolerance = 1e-8})
{
  return to_surface_mesh(Implicit_surface_3(from_cgal_polynomial(polynomial), box), options, run);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_IMPLICIT_SURFACE_MESH_H
