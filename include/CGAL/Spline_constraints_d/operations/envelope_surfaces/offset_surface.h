// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_OFFSET_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_OFFSET_SURFACE_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_mesh.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/offset_surfaces.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

the offset of a surface, untrimmed: with a normal \f$N\f$, not of unit length, the points
\f[ S(u,v) + \frac{r}{w}\, N(u,v), \qquad w^2 = |N|^2,\quad w > 0. \f]
It is cut along its cuspidal edges, where \f$-1/r\f$ is a principal curvature, with \f$E\f$, \f$F\f$, \f$G\f$ the first
and \f$L\f$, \f$M\f$, \f$N\f$ the second fundamental form of the normal of length \f$w\f$: \f$w^4 - r w\,(EN+GL-2FM) +
r^2 (LN-M^2) = 0\f$. Poles of spheres are no exception. It has a boundary along creases of the surface, and at tips.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param distance the distance \f$r\f$, with its sign: positive on the side of \f$S_u \times S_v\f$.
\param options the limits, for the operation as a whole, and a visitor.
\return the surface; the unknowns are \f$u, v, w\f$.
\throws Invalid_input when a piece of the surface is a curve or a point, a number is not finite, a weight is not proved
to have one sign, or an option makes no sense.

Complexity: that of `solve_surfaces()` for a system of one equation, for each smooth part of the surface.
*/
template <internal::Surface_curves::Surface_operand Surface>
Envelope_surface_3 offset_surface(const Surface& surface,
                                  const typename internal::Surface_curves::Operand_kernel<Surface>::FT& distance,
                                  const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Envelope_surfaces::offset_surface_of(internal::Common::Intersection_operand<Surface>::map(surface),
                                                        internal::converted_number<Exact_rational>(distance), options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_OFFSET_SURFACE_H
