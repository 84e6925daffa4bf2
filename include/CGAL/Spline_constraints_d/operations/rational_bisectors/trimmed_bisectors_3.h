// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_TRIMMED_BISECTORS_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_TRIMMED_BISECTORS_3_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Trimmed_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/bisector_parts_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/rational_bisectors_3.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/trimmed_sphere_bisector.h>
#endif

#include <CGAL/Sphere_3.h>

#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

template <class S>
Trimmed_bisector_3 trimmed(Rational_bisector_3 bisector, const typename S::Kernel::Point_3& center,
                           const Exact_rational& radius, const S& surface,
                           const CGAL::Sphere_3<typename S::Kernel>& reach, const Solver_options& options)
{
  auto surfaces = trimmed_sphere_bisector({exact_object(center), radius}, Common::exact_map<3>(surface), bisector,
                                          exact_reach(reach), rest_of(options, bisector.summary()));
  return {std::move(bisector), std::move(surfaces)};
}

} // namespace Rational_bisectors
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

the bisector of a point and a surface, trimmed: of `point_surface_bisector()`, within a sphere, the regions where no
point of the surface is nearer than the foot. They are on the boundary of the convex set of all points that are not
nearer to the surface than to the point.

Poles, the sphere, and arcs where other points of the surface are as near as the foot cut the domain into faces. In
boxes of feet either some point of the surface is certainly nearer than the foot, or none: the latter since cells of the
surface are farther away, but for a neighbourhood of the foot where the squared distance is strictly convex in a chart,
or where spheres touch the surface along lines; or the least difference of squared distances increases with a parameter,
so that there is one arc at most. Small boxes for which nothing of this is proved are undecided: those where two feet
come together, as at the ends of curves where the bisector meets itself, where a point as near is on an edge close to a
center of curvature, or where arcs leave the sphere.

\tparam S a model of `ParametricSurface_3`.
\param point the point.
\param surface the surface.
\param reach the sphere. What is outside, poles with it, is `OUT_OF_REACH`.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input as `point_surface_bisector()` and `bisector_parts()`; when the bisector was not completed because
of a limit.

Complexity: that of `bisector_parts()`, and for each box of feet, up to some 1,000 beside undecided ones, a search among
all cells of a grid. Source:
\cgalCite{ek-crb-99} trims by supporting planes of samples, without a proof of what is kept.
*/
template <ParametricSurface_3 S>
Trimmed_bisector_3 trimmed_point_surface_bisector(const typename S::Kernel::Point_3& point, const S& surface,
                                                  const CGAL::Sphere_3<typename S::Kernel>& reach,
                                                  const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Rational_bisectors::trimmed(point_surface_bisector(point, surface, options), point,
                                               Exact_rational(0), surface, reach, options);
}

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

a sheet of the bisector of a sphere and a surface, trimmed: of `sphere_surface_bisector()`, within another sphere, the
regions where the distance from the surface is that from the sphere, and no point of the surface is nearer than the
foot.

\tparam S a model of `ParametricSurface_3`.
\param center the center of the sphere.
\param radius its radius, with a sign as for `sphere_surface_bisector()`.
\param surface the surface.
\param reach the sphere that the bisector is cut at.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input as `sphere_surface_bisector()` and `bisector_parts()`; when the bisector was not completed because
of a limit.

Complexity: that of `trimmed_point_surface_bisector()`. Source: \cgalCite{ek-crb-99}.
*/
template <ParametricSurface_3 S>
Trimmed_bisector_3 trimmed_sphere_surface_bisector(const typename S::Kernel::Point_3& center,
                                                   const typename S::Kernel::FT& radius, const S& surface,
                                                   const CGAL::Sphere_3<typename S::Kernel>& reach,
                                                   const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Rational_bisectors::trimmed(sphere_surface_bisector(center, radius, surface, options), center,
                                               internal::converted_number<Exact_rational>(radius), surface, reach,
                                               options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_TRIMMED_BISECTORS_3_H
