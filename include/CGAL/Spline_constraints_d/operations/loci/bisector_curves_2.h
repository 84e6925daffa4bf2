// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_BISECTOR_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_BISECTOR_CURVES_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_locus_2.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/loci/internal/pair_loci.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDLoci

the bisector of two curves, untrimmed: all centers of circles that touch both of them, with the parameters of the points
where they do. Other points of the curves may be nearer. The topology of the curves is proved.

With the chord \f$d = C_1(u) - C_2(v)\f$, both normals meet the perpendicular bisector of the two points in the same
point if
\f[ \langle C_1', d\rangle\,(C_2' \times d) + \langle C_2', d\rangle\,(C_1' \times d) = 0, \f]
which is equation (20) of \cgalCite{kes-gcps-05} with the center from (21) and (22) put in. It has no denominators.
Where \f$C_1' \times d = C_2' \times d = 0\f$ but \f$d \neq 0\f$ the line through both points touches both curves, and
the center is at infinity: these pairs are solved for and certified, and the curves are cut there.

The curves are taken apart where their derivatives jump, and each two smooth parts have curves of their own. Ends of the
curves and corners are not taken for sites here. Where two curves intersect, two branches of the bisector cross: a
singular point, if the intersection is transversal and inside of both. Where they touch or coincide, the bisector is
undecided.

At a cusp \f$C_i' = 0\f$ all points of the other curve would satisfy the equation, with centers of circles that only
pass through the cusp. So derivatives are divided by the common factor of their coordinates, exactly; what is left of
one has the direction of the tangent at a cusp as well. A polynomial piece with such a factor is a part of its own.

\tparam C1,C2 models of `ParametricCurve_2`; points of the result are those of the kernel of `C1`.
\param c1 the first curve.
\param c2 the second curve.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: that of `solve_curves()` with one equation in two unknowns and of `solve()` with two, for each two smooth
parts. Source: \cgalCite{kes-gcps-05}, section 3.
*/
template <ParametricCurve_2 C1, ParametricCurve_2 C2>
Curve_pair_locus_2<typename C1::Kernel> bisector_curves(const C1& c1, const C2& c2,
                                                        const Solver_options& options = {.tolerance = 1e-8})
{
  return Curve_pair_locus_2<typename C1::Kernel>(
      internal::Loci::bisector_of(internal::Common::exact_map<2>(c1), internal::Common::exact_map<2>(c2), options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_BISECTOR_CURVES_2_H
