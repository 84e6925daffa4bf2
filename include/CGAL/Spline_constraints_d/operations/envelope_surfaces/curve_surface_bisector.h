// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_CURVE_SURFACE_BISECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_CURVE_SURFACE_BISECTOR_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/curve_surface_bisectors.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_mesh.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

the bisector of a curve and a surface, untrimmed: the centers of all spheres up to a radius \f$r\f$ that touch both.
With the normal \f$N\f$ of the surface and \f$d = S - C\f$ it is
\f[ B = S - \frac{|d|^2}{2\langle d, N\rangle} N, \qquad \langle |d|^2 N - 2 \langle d, N\rangle\, d,\ C'\rangle = 0,
\qquad |B - S| \leq r. \f]
The radius keeps away from points at infinity, where \f$\langle d, N\rangle = 0\f$. The bisector ends at creases of the
surface, kinks of the curve and ends of both, which are no operands. Where the curve meets the surface it may be
undecided.

\param curve a model of `ParametricCurve_3`.
\param surface a model of `ParametricSurface_3`, of the same kernel.
\param radius the greatest radius.
\param options the limits, for the operation as a whole, and a visitor.
\return the surface; the unknowns are \f$u, v, t\f$, those of the surface first.
\throws Invalid_input when a piece of the surface is a curve or a point, the radius is not positive, a number is not
finite, a weight is not proved to have one sign, or an option makes no sense.

Complexity: that of `solve_surfaces()` for a system of one equation and an inequality, for each pair of smooth parts.
Source: \cgalCite{ek-gcs-01}, section 3.3.
*/
template <ParametricCurve_3 Curve, ParametricSurface_3 Surface>
Envelope_surface_3 curve_surface_bisector(const Curve& curve, const Surface& surface,
                                          const typename Surface::Kernel::FT& radius,
                                          const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Envelope_surfaces::curve_surface_bisector_of(
      internal::Common::exact_map<3>(curve), internal::Common::exact_map<3>(surface),
      internal::converted_number<Exact_rational>(radius), options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_CURVE_SURFACE_BISECTOR_H
