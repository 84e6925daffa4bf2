// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SWEEP_SILHOUETTES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SWEEP_SILHOUETTES_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Surface_curves_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/silhouettes_of_sweep.h>
#endif

#include <ranges>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

An affine motion: at the time \f$t\f$ it takes the point \f$(x,y,z)\f$ to \f$C(t) + x\,a_0(t) + y\,a_1(t) +
z\,a_2(t)\f$.
*/
template <SplineKernel Kernel>
struct Affine_motion
{
  //! the path \f$C\f$ of the origin; its parameter is the time.
  Bspline_curve_3<Kernel> path;

  //! the images \f$a_0, a_1, a_2\f$ of the unit vectors, points standing for the vectors from the origin to them, with
  //! the same domain; none for a translation.
  std::vector<Bspline_curve_3<Kernel>> axes{};
};

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the silhouettes of the envelope of a moving surface, seen from points: where a moved surface and the envelope of all of
them have the same tangent plane, which contains the eye. With a matrix \f$A(t)\f$, the columns of which are the axes,
the moved surface is \f$T = C + A S\f$, its normal that of the surface times the matrix of cofactors of \f$A\f$, and
\f[ \langle C' + A' S,\ \mathrm{cof}(A)\,(S_u \times S_v)\rangle = 0, \qquad \langle T - p,\ \mathrm{cof}(A)\,(S_u
\times S_v)\rangle = 0. \f] The unknowns are the two parameters of the surface and the time; the topology of the curves
is proved. Both are transparent, and neither the surface in its first and last position nor what of the envelope is
inside of the swept volume is looked at.

In the source the normal is multiplied by \f$A\f$ itself, which holds for rotations and uniform scalings only.

Curves end at the first and last time, and where the normal of the surface or a velocity jumps. Where the surface moves
along itself, where it stands still, and along a break or seam of it the answer is undecided. Curves through poles are
not joined.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param motion the motion.
\param viewpoints the eyes, a range of points.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\return the curves for each viewpoint, in their order. Points are those of the moved surface.
\throws Invalid_input when there are axes, but not three, the domains of path and axes differ, a coordinate is not
finite, a weight is not proved to have one sign, or an option makes no sense.

Complexity: that of `solve_curves()` with two equations in three unknowns. Source: \cgalCite{kes-gcps-05}, section 5,
equation (33).
*/
template <internal::Surface_curves::Surface_operand Surface, std::ranges::input_range Viewpoints>
std::vector<Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>>
sweep_silhouettes(const Surface& surface,
                  const Affine_motion<internal::Surface_curves::Operand_kernel<Surface>>& motion,
                  Viewpoints&& viewpoints, const Solver_options& options = {.tolerance = 1e-8})
{
  using Kernel = internal::Surface_curves::Operand_kernel<Surface>;
  if (!motion.axes.empty() && motion.axes.size() != 3)
    throw Invalid_input("sweep_silhouettes: a motion has three axes or none");
  std::vector<internal::Common::Exact_map<3>> axes;
  for (const Bspline_curve_3<Kernel>& axis : motion.axes)
    axes.push_back(internal::Common::exact_map<3>(axis));
  std::vector<internal::Surface_curves::Exact_triple> eyes;
  for (const CGAL::Point_3<Kernel>& eye : viewpoints)
    eyes.push_back(internal::Surface_curves::exact_triple(eye));
  std::vector<Surface_curves_3<Kernel>> result;
  for (auto& found :
       internal::Surface_curves::sweep_silhouettes_of(internal::Common::Intersection_operand<Surface>::map(surface),
                                                      internal::Common::exact_map<3>(motion.path), axes, eyes, options))
    result.emplace_back(std::move(found));
  return result;
}

//! \ingroup PkgSplineConstraintsDSurfaceCurves
//! the same, with the viewpoints in a list. \throws Invalid_input as the function above.
template <internal::Surface_curves::Surface_operand Surface>
std::vector<Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>>
sweep_silhouettes(const Surface& surface,
                  const Affine_motion<internal::Surface_curves::Operand_kernel<Surface>>& motion,
                  const std::vector<CGAL::Point_3<internal::Surface_curves::Operand_kernel<Surface>>>& viewpoints,
                  const Solver_options& options = {.tolerance = 1e-8})
{
  return sweep_silhouettes<Surface, decltype(viewpoints)>(surface, motion, viewpoints, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SWEEP_SILHOUETTES_H
