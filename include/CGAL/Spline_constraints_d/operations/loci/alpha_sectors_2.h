// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_ALPHA_SECTORS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_ALPHA_SECTORS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_locus_2.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/loci/internal/pair_loci.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDLoci

the \f$\alpha\f$-sector of two curves, untrimmed: all points \f$P\f$ on normals of both curves whose distances from the
two points there have the ratio \f$\alpha : 1 - \alpha\f$,
\f$(1-\alpha)\,|P - C_1(u)| = \alpha\,|P - C_2(v)|\f$, with these parameters. Other points of the curves may be nearer.
The topology of the curves is proved.

The normals meet in \f$P = C_1 + t\,N_1\f$ with \f$t = -\langle d, C_2'\rangle / (C_1' \times C_2')\f$ and the chord
\f$d = C_1(u) - C_2(v)\f$, and it is the same denominator for the other curve. So (23) to (25) of \cgalCite{kes-gcps-05}
are one equation without denominators,
\f[ (1-\alpha)^2\, |C_1'|^2\, \langle d, C_2'\rangle^2 = \alpha^2\, |C_2'|^2\, \langle d, C_1'\rangle^2. \f]
For \f$\alpha = 1/2\f$ it has the factor \f$C_1' \times C_2'\f$, and `bisector_curves()` is called. For others, all
points are at a finite distance. Where both normals lie along the chord, or \f$d = 0\f$, two branches cross in the plane
of the parameters, but not in the plane itself: with the signed ratio
\f$q\f$ of the speeds as a third unknown,
\f[ (1-\alpha)\, q\, \langle d, C_2'\rangle = \alpha\, \langle d, C_1'\rangle, \quad q^2\, |C_2'|^2 = |C_1'|^2, \f]
they have different signs of \f$q\f$, and no solution is singular there. These are the unknowns of
`Curve_pair_locus_2::solutions()`. At a common normal, the point of one branch lies between the two feet and that of the
other one beyond one of them.

The curves are taken apart as by `bisector_curves()`. They go on across the seam of a closed curve if the derivative is
the same on both sides. Parallel lines and concentric arcs, with common normals everywhere, are nothing special.

\tparam C1,C2 models of `ParametricCurve_2`; points of the result are those of the kernel of `C1`.
\param c1 the first curve.
\param c2 the second curve.
\param alpha the share of the distance from the first curve, exactly; between 0 and 1, where the first and the second
curve themselves would be the answer.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input when \f$\alpha\f$ is not inside of (0,1), the derivative of a curve vanishes, or nearly so, or an
option makes no sense.

Complexity: that of `solve_curves()` with two equations in three unknowns, for each two smooth parts. Source:
\cgalCite{kes-gcps-05}, section 3.
*/
template <ParametricCurve_2 C1, ParametricCurve_2 C2>
Curve_pair_locus_2<typename C1::Kernel> alpha_sectors(const C1& c1, const C2& c2, const typename C1::Kernel::FT& alpha,
                                                      const Solver_options& options = {.tolerance = 1e-8})
{
  const Exact_rational share = internal::converted_number<Exact_rational>(alpha);
  if (!(share > 0 && share < 1))
    throw Invalid_input("alpha_sectors: alpha is not between 0 and 1");
  return Curve_pair_locus_2<typename C1::Kernel>(internal::Loci::alpha_sector_of(
      internal::Common::exact_map<2>(c1), internal::Common::exact_map<2>(c2), share, options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_ALPHA_SECTORS_2_H
