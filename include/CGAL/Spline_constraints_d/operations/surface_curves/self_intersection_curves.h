// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SELF_INTERSECTION_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SELF_INTERSECTION_CURVES_H

#include <CGAL/Spline_constraints_d/operations/intersections/Surface_intersection.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/self_intersections_of_surface.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

all curves in which a surface meets itself: the pairs of parameters \f$(u,v) \neq (s,t)\f$ with \f$S(u,v) = S(s,t)\f$,
with a proof of their number and of how they are connected. No closed curve is lost, however small, and nothing is
joined by distance. Both surfaces of the result are the given one. Each pair comes once, in one of its orders: a curve
in space that two sheets pass is one curve of the result.

With \f$(u-s,\,v-t) = h\,d\f$ and a direction \f$d\f$, \f$S(u,v) - S(s,t) = h\,(d_0 A + d_1 B)\f$ with polynomials
\f$A\f$ and \f$B\f$, by exact division. So the diagonal \f$(u,v) = (s,t)\f$ satisfies what is left only where \f$S_u\f$
and \f$S_v\f$ are dependent. Where this is a single point inside of the surface, it is a *pinch point* as that of the
Whitney umbrella, a certified end of a curve: one of the `Surface_intersection::singular_points()`, and \link
Surface_intersection::end() the end\endlink is `TANGENT`.

A surface of several pieces is cut at its breaks, and a closed one anywhere. Pairs within one piece are found as above.
Pairs in two pieces with a common edge or corner, also across the seam of a closed surface, are taken apart into pairs
of smaller cells, until two cells have no common points of the domain, where the plain equations \f$S(u,v) = S(s,t)\f$
are solved, or the surface is proved to be one-to-one on the rectangle around both: if \f$\det(n, a, b) > 0\f$ for some
\f$n\f$ and all \f$a\f$ and \f$b\f$ in the convex cones that the coefficients of \f$S_u\f$ and \f$S_v\f$ generate. The
same test, and boxes around the pieces, leave out pairs before anything is solved. Curves are joined where one of their
points passes a break, a seam or another cut: all solutions there are known on both sides, so if there is just one on
the other side that may be the same point, it is. Such a point comes once.

The unknowns of `Surface_intersection::solutions()` of a part are \f$u, v, s, t\f$ and, of a piece with itself, a
parameter in \f$[-1,1]\f$ of the direction. Curves end on the edges of the surface. Where three sheets meet in a point,
three curves pass it, each of two sheets.

Undecided are: points where two sheets touch; cuspidal edges, pieces that the surface covers twice, curves along a
break, what is near an edge that is one point (a pole), and pinch points on an edge or a break.

\tparam Surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param surface the surface.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input when a coordinate is not finite, a weight is not proved to have one sign, or an option makes no
sense.

Complexity: that of `solve_curves()` with four equations in five unknowns for each piece, and with three in four for
each two cells that are left; \f$O(n^2)\f$ pairs of \f$n\f$ pieces are compared by their boxes. Source:
\cgalCite{egk-ssi-09} removes the diagonal from the equations in another way.
*/
template <internal::Surface_curves::Surface_operand Surface>
Surface_intersection<internal::Surface_curves::Operand_kernel<Surface>>
self_intersection_curves(const Surface& surface, const Solver_options& options = {.tolerance = 1e-8})
{
  return Surface_intersection<internal::Surface_curves::Operand_kernel<Surface>>(
      internal::Surface_curves::self_intersection_of(internal::Common::Intersection_operand<Surface>::map(surface),
                                                     options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_SELF_INTERSECTION_CURVES_H
