// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_BISECTOR_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_BISECTOR_CURVES_2_H

#include <CGAL/Spline_constraints_d/geometry/internal/tangent_direction.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/loci/Curve_pair_locus_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Pair_of_parts.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cmath>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Loci {

/*
The center of the circle that touches two curves in given points: on the perpendicular bisector of these, and on both
normals. The normal of the first curve meets the perpendicular bisector in (a + b) / 2 + h d', with d = a - b turned by
90 degrees and h = -<a',d> / (2 a' x d); that of the second one likewise. The better one is taken.
*/
inline Double_pair center_of_tangent_circle(const Pair_of_points& pair)
{
  const auto& [first, second] = pair.tangents;
  const Double_pair& d = pair.chord;
  const double s = cross(first, d) / std::hypot(first[0], first[1]),
               t = cross(second, d) / std::hypot(second[0], second[1]);
  const double h =
      !(std::abs(s) < std::abs(t)) ? -0.5 * dot(first, d) / cross(first, d) : 0.5 * dot(second, d) / cross(second, d);
  const double x = 0.5 * (pair.points[0][0] + pair.points[1][0]), y = 0.5 * (pair.points[0][1] + pair.points[1][1]);
  return d == Double_pair{0, 0} ? Double_pair{x, y} : Double_pair{x - h * d[1], y + h * d[0]};
}

} // namespace Loci
} // namespace internal

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
\param options those of `solve_curves()`; limits hold for each two parts.
\throws Invalid_input when an option makes no sense.

Complexity: that of `solve_curves()` with one equation in two unknowns and of `solve()` with two, for each two smooth
parts. Source: \cgalCite{kes-gcps-05}, section 3.
*/
template <ParametricCurve_2 C1, ParametricCurve_2 C2>
Curve_pair_locus_2<typename C1::Kernel> bisector_curves(const C1& c1, const C2& c2,
                                                        const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal;
  using namespace internal::Loci;
  Curve_pair_locus_2<typename C1::Kernel> result(
      [](const Pair_of_points& pair, const std::vector<double>&) { return center_of_tangent_circle(pair); });
  Budgeted_solver solve(options);
  visit_pairs_of_parts(
      parts_with_tangents(Planar_map(c1)), parts_with_tangents(Planar_map(c2)),
      [&](const Pair_of_parts& parts, const Unknown& u, const Unknown& v) {
        const Vector_expression<2> d = parts.first(0, u) - parts.second(0, v), a = parts.first(1, u),
                                   b = parts.second(1, v);
        const Solution_set_d<double> at_infinity = solve({determinant(a, b) == 0, determinant(a, d) == 0}, {u, v});
        result.add(parts, {dot(a, d) * determinant(b, d) + dot(b, d) * determinant(a, d) == 0}, {u, v}, options,
                   {at_infinity.begin(), at_infinity.end()});
      });
  result.add_work(solve.total());
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_LOCI_BISECTOR_CURVES_2_H
