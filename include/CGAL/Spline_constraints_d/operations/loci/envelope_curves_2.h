// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_ENVELOPE_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_ENVELOPE_CURVES_2_H

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
which parallel tangents of two curves count.
*/
enum class Tangent_directions {
  SAME,   ///< the same direction only: the convolution of the curves
  ANY     ///< opposite directions too
};

/*!
\ingroup PkgSplineConstraintsDLoci

the envelope of a curve that is moved along another one, untrimmed: all points \f$C_1(u) + C_2(v)\f$ with parallel
tangents,
\f[ C_1'(u) \times C_2'(v) = 0, \quad \langle C_1'(u), C_2'(v)\rangle > 0. \f]
With the inequality it is the convolution of the curves, to which the boundary of the Minkowski sum of two regions with
these as boundaries, in the same orientation, belongs. The topology of the curves is proved.

The curves are taken apart where their derivatives jump, and each two smooth parts have curves of their own; corners and
ends, which have many tangents, add translated pieces of the other curve, which are not part of the result. Where a
derivative is zero, and where parts of both curves are straight and parallel, the answer is undecided; two inflections
with parallel tangents are a singular point.

\tparam C1,C2 models of `ParametricCurve_2`; points of the result are those of the kernel of `C1`.
\param c1 the first curve.
\param c2 the second curve.
\param directions whether the tangents may have opposite directions.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: that of `solve_curves()` with one equation in two unknowns, for each two smooth parts. Source:
\cgalCite{kes-gcps-05}, section 2, equations (1) to (3).
*/
template <ParametricCurve_2 C1, ParametricCurve_2 C2>
Curve_pair_locus_2<typename C1::Kernel> envelope_curves(const C1& c1, const C2& c2,
                                                        Tangent_directions directions = Tangent_directions::SAME,
                                                        const Solver_options& options = {.tolerance = 1e-8})
{
  return Curve_pair_locus_2<typename C1::Kernel>(
      internal::Loci::envelope_of(internal::Common::exact_map<2>(c1), internal::Common::exact_map<2>(c2),
                                  directions == Tangent_directions::SAME, options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_ENVELOPE_CURVES_2_H
