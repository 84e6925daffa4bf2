// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_SELF_BISECTOR_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_SELF_BISECTOR_CURVES_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_locus_2.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/loci/internal/self_bisector.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDLoci

the bisector of a curve with itself, untrimmed: all centers of circles that touch it at two parameters \f$u < v\f$,
which its medial axis is a part of. The topology of the curves is proved.

The equation is that of `bisector_curves()`. On one polynomial piece it has the factor \f$(v-u)^4\f$, which is divided
out exactly; what remains of it at \f$u = v\f$ is \f$|C'|^5\f$ times the derivative of the curvature, up to a constant.
So curves end on the diagonal at the vertices of the curve, certified, and their points there are the centers of
curvature. The pair of both ends of a piece, and the common end of two successive pieces, are blown up in the same way,
whether the curve is smooth there or not.

The curve is taken apart at all of its breaks, and each two of its pieces are solved for alone, those of neighbours in
two triangles and a rectangle. The arcs are joined where \f$u\f$ or \f$v\f$ passes a break or the seam of a closed
curve, if the curve has no corner there: both sides have the same solutions, all of which are known, so if the enclosure
of one meets that of just one other, they are the same point; else it is undecided. Where both parameters are at a
break, curves end. The unknowns of `Curve_pair_locus_2::solutions()` are \f$s, h \in [0,1]\f$; on one piece \f$[a,b]\f$,
\f$u = a + (b-a)(1-h)s\f$ and \f$v = u + (b-a)h\f$. Pieces on the same circle satisfy the equation everywhere and are
undecided, those on the same line have no circles. A vertex at a break, or where another curve of the answer ends, may
be undecided.

\tparam C a model of `ParametricCurve_2`; points of the result are those of its kernel.
\param c the curve.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input when the derivative of the curve vanishes, or nearly so, or an option makes no sense.

Complexity: that of `solve_curves()` with one equation in two unknowns and of `solve()` with two, for each two pieces,
three or four times for neighbours. Source: \cgalCite{kes-gcps-05}, section 3 and figure 2b.
*/
template <ParametricCurve_2 C>
Curve_pair_locus_2<typename C::Kernel> self_bisector_curves(const C& c,
                                                            const Solver_options& options = {.tolerance = 1e-8})
{
  return Curve_pair_locus_2<typename C::Kernel>(
      internal::Loci::self_bisector_of(internal::Common::exact_map<2>(c), options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_SELF_BISECTOR_CURVES_2_H
