// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTES_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Surface_curves_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/zeros_on_surface.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the silhouettes of a surface seen from a point: where its tangent planes contain the eye, with a proof of the number of
curves and of how they are connected. The surface is transparent: parts that others hide are found, too.

With \f$S = X/w\f$, the equation is \f$\det[(X,w), (X_u,w_u), (X_v,w_v), (p,1)] = 0\f$, which is \f$\langle S - p, S_u
\times S_v\rangle = 0\f$ without denominators. Factors that vanish where the surface is singular all along an edge or a
break, as at the poles of a sphere, are divided out, so that they bring no false curves. Curves along an edge, a break
or a seam are found as such (`Surface_curve::line`).

Where the tangent plane turns continuously, a curve goes on, though the parametrization may have breaks there, if the
equation changes by a constant factor, as it does on surfaces of revolution. At creases curves end: a crease may
separate what is seen from what is not, but is no silhouette here. Where a part of the surface lies in a plane through
the eye, and at singular points of higher order with irrational parameters, the answer is undecided.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param viewpoint the eye.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input when a coordinate is not finite, a weight is not proved to have one sign, or an option makes no
sense.

Complexity: that of `solve_curves()` with one equation in two unknowns, of three times the degrees of the surface at
most. Source: \cgalCite{kes-gcps-05}, section 5, for a surface that does not move.
*/
template <internal::Surface_curves::Surface_operand Surface>
Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>
silhouettes(const Surface& surface, const CGAL::Point_3<internal::Surface_curves::Operand_kernel<Surface>>& viewpoint,
            const Solver_options& options = {.tolerance = 1e-8})
{
  const auto [x, y, z] = internal::Surface_curves::exact_triple(viewpoint);
  return Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>(internal::Surface_curves::silhouettes_of(
      internal::Common::Intersection_operand<Surface>::map(surface), {x, y, z, Exact_rational(1)}, options));
}

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves
the silhouettes of a surface in a parallel view: where a direction is tangent to it. Otherwise as seen from a point.
\param surface,options as above.
\param direction the direction in which the viewer looks, of any length.
\throws Invalid_input also when the direction is zero.
*/
template <internal::Surface_curves::Surface_operand Surface>
Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>
silhouettes(const Surface& surface, const CGAL::Vector_3<internal::Surface_curves::Operand_kernel<Surface>>& direction,
            const Solver_options& options = {.tolerance = 1e-8})
{
  const auto [x, y, z] = internal::Surface_curves::exact_triple(direction);
  if (x == 0 && y == 0 && z == 0)
    throw Invalid_input("silhouettes: the direction is zero");
  return Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>(internal::Surface_curves::silhouettes_of(
      internal::Common::Intersection_operand<Surface>::map(surface), {x, y, z, Exact_rational(0)}, options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTES_H
