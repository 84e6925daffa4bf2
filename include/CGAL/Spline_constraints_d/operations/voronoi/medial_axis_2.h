// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_MEDIAL_AXIS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_MEDIAL_AXIS_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_diagram_of_curves_2.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Spline_constraints {

template <SplineKernel Kernel>
class Planar_region_2;

/*!
\ingroup PkgSplineConstraintsDVoronoi

the medial axis of a region: the centers of all disks inside that touch the boundary in two points or more, and the
limits of these, which are centers of curvature and convex corners. With the radii of the disks it describes the region
completely.

It is the part of the Voronoi diagram of the boundary that is inside, `voronoi_diagram()`, and computed and proved in
the same way. Its edges cut the region into as many parts as there are boundaries. A reflex corner is a site of its own.
No edge ends there: disks that touch the boundary in that corner only belong to the region of the boundary around it.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`, to hand
the pieces of the boundary to all cores through TBB. The answers are the same.
\param region the region. Parameters are those of its curves. Where it is not complete, all of them are undecided.
\param options limits and a visitor, as of `voronoi_diagram()`.
\throws Invalid_input when the greatest absolute value of a coordinate is neither 0 nor between \f$2^{-250}\f$ and
\f$2^{250}\f$, the weight of a curve is not proved to have one sign, or an option makes no sense.

Complexity: about half of that of the Voronoi diagram.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, SplineKernel Kernel>
Voronoi_diagram_of_curves_2<Kernel> medial_axis(const Planar_region_2<Kernel>& region,
                                                const Solver_options& options = {})
{
  return Voronoi_diagram_of_curves_2<Kernel>(internal::Voronoi::diagram_of_region<Concurrency_tag>(
      internal::Voronoi::region_operand(region), options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_MEDIAL_AXIS_2_H
