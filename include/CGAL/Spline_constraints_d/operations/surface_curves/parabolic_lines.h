// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_PARABOLIC_LINES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_PARABOLIC_LINES_H

#include <CGAL/Spline_constraints_d/operations/surface_curves/Surface_curves_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/zeros_on_surface.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the parabolic lines of a surface, where its Gaussian curvature is zero, with a proof of their number and of how they are
connected: on regular surfaces they separate regions that are curved like an egg from those that are curved like a
saddle.

The equation is \f$\langle S_{uu},n\rangle \langle S_{vv},n\rangle - \langle S_{uv},n\rangle^2 = 0\f$ with \f$n = S_u
\times S_v\f$. For \f$S = X/w\f$ the inner products are those of the second derivatives of \f$(X,w)\f$ and the vector of
the tangent plane, without denominators. Factors that vanish all along an edge or a break, as at the poles of a sphere,
are divided out. Curves along an edge, a break or a seam are found as such (`Surface_curve::line`). Points where only
the parametrization is singular, \f$n = 0\f$, satisfy the equation, too.

Curves go on across breaks where the equation changes by a constant factor, as it does where second derivatives are
continuous, and on surfaces of revolution. At other breaks, where the curvature jumps, they end; that it may change its
sign there is no parabolic line here. An isolated solution, as the flat point of a monkey saddle, is a singular point.
Pieces of planes, cylinders, cones and other developable surfaces, which satisfy the equation everywhere, are undecided.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input when a coordinate is not finite, a weight is not proved to have one sign, or an option makes no
sense.

Complexity: that of `solve_curves()` with one equation in two unknowns, of degrees \f$6d-4\f$ for polynomial surfaces of
degrees \f$d\f$, at most \f$8d-4\f$ for rational ones. Source: \cgalCite{pm-sicad-02}.
*/
template <internal::Surface_curves::Surface_operand Surface>
Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>
parabolic_lines(const Surface& surface, const Solver_options& options = {.tolerance = 1e-8})
{
  return Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>(
      internal::Surface_curves::parabolic_lines_of(internal::Common::Intersection_operand<Surface>::map(surface),
                                                   options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_PARABOLIC_LINES_H
