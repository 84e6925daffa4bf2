// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SWEEP_SILHOUETTE_EVENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SWEEP_SILHOUETTE_EVENTS_H

#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouette_events.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/sweep_silhouettes.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Sweep_event_finder.h>
#endif

#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the times at which the silhouettes of the envelope of a moving surface change their topology while the eye moves along a
path, with what happens there: those of `sweep_silhouettes()`, as `silhouette_events()` has them for a surface that
stands still. The parameters of an event are those of the surface, and the time of the motion.

With the two equations \f$F = G = 0\f$ of the silhouettes, of which only the second one depends on the eye, events are
where the gradients of both by the parameters and the time of the motion are parallel, five equations in as many
unknowns; where they are on a face of the domain, such as the first and last time of the motion; and where a curve
passes an edge of the domain. The second derivatives of \f$G\f$ on the surface \f$F = 0\f$, or the slopes there, tell
the kind.

Events on breaks of the surface or of the motion, and where more than one curve passes a pole, are found, but mostly
not told (`DEGENERATE`). Undecided is the answer where the surface moves along itself or stands still, and where the
envelope is developable, as that of a sphere that moves along a line, and the eye passes one of its tangent planes as
it appears.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param motion the motion.
\param path the path of the eye; its parameter is the time of the events.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input as `sweep_silhouettes()`.

Complexity: that of five equations in five unknowns for each pair of a cell of the surface and a piece of the motion,
twice. Source: \cgalCite{kes-gcps-05}, section 5, where the events are seen in a picture.
*/
template <internal::Surface_curves::Surface_operand Surface>
Silhouette_events_3<internal::Surface_curves::Operand_kernel<Surface>> sweep_silhouette_events(
    const Surface& surface, const Affine_motion<internal::Surface_curves::Operand_kernel<Surface>>& motion,
    const Bspline_curve_3<internal::Surface_curves::Operand_kernel<Surface>>& path, const Solver_options& options = {})
{
  using Kernel = internal::Surface_curves::Operand_kernel<Surface>;
  if (!motion.axes.empty() && motion.axes.size() != 3)
    throw Invalid_input("sweep_silhouette_events: a motion has three axes or none");
  std::vector<internal::Common::Exact_map<3>> axes;
  for (const Bspline_curve_3<Kernel>& axis : motion.axes)
    axes.push_back(internal::Common::exact_map<3>(axis));
  return Silhouette_events_3<Kernel>(internal::Surface_curves::sweep_silhouette_events_of(
      internal::Common::Intersection_operand<Surface>::map(surface), internal::Common::exact_map<3>(motion.path), axes,
      internal::Common::exact_map<3>(path), options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SWEEP_SILHOUETTE_EVENTS_H
