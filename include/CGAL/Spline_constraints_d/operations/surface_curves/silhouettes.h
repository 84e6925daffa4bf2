// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTES_H

#include <CGAL/Spline_constraints_d/operations/intersections/internal/Tangent_planes.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_zeros.h>

#include <array>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Surface_curves {

// Where the tangent planes of a surface contain a point with the homogeneous coordinates of the eye.
template <SplineKernel Kernel>
Surface_curves_3<Kernel> silhouettes(const Spline_patch<3>& surface, const std::array<Exact_rational, 4>& eye,
                                     const Solver_options& options)
{
  Surface_zeros<Kernel> zeros(surface, options);
  for (const Continuous_part<4>& part : tangent_planes(surface))
    zeros.add(combined(part.functions, eye));
  return zeros.curves();
}

} // namespace Surface_curves
} // namespace internal

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
\param options those of `solve_curves()`; limits hold for each smooth part.
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
  const auto p = internal::exact_object(viewpoint);
  return internal::Surface_curves::silhouettes<internal::Surface_curves::Operand_kernel<Surface>>(
      internal::Common::Intersection_operand<Surface>::patch(surface), {p.x(), p.y(), p.z(), 1}, options);
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
  const auto v = internal::exact_object(direction);
  if (v == CGAL::NULL_VECTOR)
    throw Invalid_input("silhouettes: the direction is zero");
  return internal::Surface_curves::silhouettes<internal::Surface_curves::Operand_kernel<Surface>>(
      internal::Common::Intersection_operand<Surface>::patch(surface), {v.x(), v.y(), v.z(), 0}, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SILHOUETTES_H
