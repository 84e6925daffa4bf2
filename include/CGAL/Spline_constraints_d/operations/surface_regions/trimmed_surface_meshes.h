// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_TRIMMED_SURFACE_MESHES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_TRIMMED_SURFACE_MESHES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_mesh_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/trimmed_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_regions/internal/Cell_triangulation.h>
#endif

namespace CGAL {
namespace Spline_constraints {
/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

the faces of a trimmed surface that have a label, as triangles.

Triangles are constrained Delaunay ones in the plane of parameters, between the chords of the boundaries, and are split
until their distance to the surface is proved. Over a triangle of parameters let \f$L\f$ be the affine map to the
triangle of the mesh: Bernstein coefficients of \f$X - wL\f$, in interval arithmetic, divided by the least one of
\f$w\f$, bound \f$|X/w - L|\f$. The error is that of the triangles; how far chords are from arcs is another question.
Faces of one cell have their common vertices; along borders of cells and seams the mesh is open.

\param surface the trimmed surface.
\param label the label of the faces.
\param error the greatest distance between a point of a triangle and that of the surface with the same parameters.
\param options limits of time and nodes, a visitor; the rest of the options has no effect.
\throws Invalid_input when the error is not positive, or an option makes no sense.

Complexity: for each triangle \f$O(d^3)\f$ operations with intervals for the degree \f$d\f$.
*/
inline Trimmed_surface_mesh_3 to_surface_mesh(const Trimmed_surface_3& surface, int label, double error,
                                              const Solver_options& options = {})
{
  return internal::Surface_regions::mesh_of_label(surface, label, error, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_TRIMMED_SURFACE_MESHES_H
