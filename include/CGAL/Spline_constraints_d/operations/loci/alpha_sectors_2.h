// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_ALPHA_SECTORS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_ALPHA_SECTORS_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_locus_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_of_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

// The point P = C1 + t N1 = C2 + ratio t N2 with normals of different lengths |N1| and |ratio N2|: one solution t by
// least squares even where they are parallel.
inline Double_pair point_of_alpha_sector(double ratio, const Pair_of_points& pair)
{
  const Double_pair &a = pair.tangents[0], &b = pair.tangents[1], difference{ratio * b[1] - a[1], a[0] - ratio * b[0]};
  const double t = -dot(pair.chord, difference) / dot(difference, difference);
  return {pair.points[0][0] - t * a[1], pair.points[0][1] + t * a[0]};
}

} // namespace Loci
} // namespace internal

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
\param options those of `solve_curves()`; limits hold for each two parts.
\throws Invalid_input when \f$\alpha\f$ is not inside of (0,1), the derivative of a curve vanishes, or nearly so, or an
option makes no sense.

Complexity: that of `solve_curves()` with two equations in three unknowns, for each two smooth parts. Source:
\cgalCite{kes-gcps-05}, section 3.
*/
template <ParametricCurve_2 C1, ParametricCurve_2 C2>
Curve_pair_locus_2<typename C1::Kernel> alpha_sectors(const C1& c1, const C2& c2, const typename C1::Kernel::FT& alpha,
                                                      const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal;
  using namespace internal::Loci;
  const Exact_rational share = converted_number<Exact_rational>(alpha), rest(1 - share);
  if (!(share > 0 && rest > 0))
    throw Invalid_input("alpha_sectors: alpha is not between 0 and 1");
  if (share == rest)
    return bisector_curves(c1, c2, options);
  const double factor = to_nearest_double(Exact_rational(rest / share));
  Curve_pair_locus_2<typename C1::Kernel> result(
      [factor](const Pair_of_points& pair, const std::vector<double>& unknowns) {
        return point_of_alpha_sector(factor * unknowns[2], pair);
      });
  visit_pairs_of_smooth_parts(Planar_map(c1), Planar_map(c2), [&](Pair_of_parts parts, const Unknown&, const Unknown&) {
    std::erase_if(parts.closed_unknowns, [&](std::size_t k) {
      return !has_same_derivative(k == 0 ? parts.first : parts.second, k == 0 ? parts.first : parts.second);
    });
    const Exact_rational bound =
        2 * speed_range(parts.first, "alpha_sectors").second / speed_range(parts.second, "alpha_sectors").first;
    const std::vector<Unknown> unknowns =
        unknowns_in({parts.first.map().domain(0), parts.second.map().domain(0), {Exact_rational(-bound), bound}});
    const Unknown &u = unknowns[0], &v = unknowns[1], &q = unknowns[2];
    const Vector_expression<2> d = parts.first(0, u) - parts.second(0, v), a = parts.first(1, u),
                               b = parts.second(1, v);
    result.add(parts, {rest * q * dot(d, b) == share * dot(d, a), q * q * squared_norm(b) == squared_norm(a)}, unknowns,
               options);
  });
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_ALPHA_SECTORS_2_H
