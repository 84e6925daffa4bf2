// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_OFFSET_FEATURES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_OFFSET_FEATURES_2_H

#include <CGAL/Spline_constraints_d/geometry/curves/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/internal/curve_pieces.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Locus_system.h>
#include <CGAL/Spline_constraints_d/operations/intersections/Locus_intersection.h>
#include <CGAL/Spline_constraints_d/operations/loci/internal/Offset_self_intersection.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
/*!
\addtogroup PkgSplineConstraintsDCurveFeatures
@{
*/

/*!
the cusps of an offset: where \f$1 - r\kappa = 0\f$ with the signed curvature \f$\kappa\f$ of the curve, so that the
derivative of the offset vanishes. There it meets the evolute of the curve, with the same parameter, and that is how
answers are to be read: a `TRANSVERSAL` one, or one of odd multiplicity, is a cusp; where the multiplicity is even, \f$1
- r\kappa\f$ does not change its sign, and the offset goes on; an `OVERLAP` is an arc whose offset is its center. At
breaks where the curvature jumps an offset may turn back without a zero; this is not reported.

\param offset the offset; operand 0 of the answers.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: one system in one unknown per polynomial piece, \f$r^2 (C' \times C'')^2 = |C'|^6\f$ with \f$r\,(C' \times
C'') > 0\f$. Nothing is undecided unless a limit is reached.
*/
Locus_intersections<2> cusps(const Offset_curve_2& offset, const Solver_options& options = {});

/*!
where an offset meets itself: all pairs of parameters \f$u < v\f$ with the same point. The parameters are those of
operands 0 and 1 of the answers, which both are the offset.

The solutions \f$u = v\f$ are removed exactly. On one polynomial piece this is done by division, and cusps go with them:
what remains of the equations there is \f$1 - r\kappa = 0\f$ and the derivative of the curvature. Two pieces that join
smoothly have a solution in their common end, which a blow-up removes: the unknowns of `Locus_intersection::solution()`
then are the ratio of the distances from that end, the larger distance, and \f$|C'(u)|\f$. A cusp at a break stays
undecided, as does the seam of a closed curve of one or two pieces.

\param offset the offset.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when an option makes no sense.

Complexity: a system of three equations in three unknowns, \f$u, v\f$ and \f$|C'(u)|\f$, for each pair of polynomial
pieces, two for neighbours. Source: \cgalCite{p-cgl-03}.
*/
Locus_intersections<2> self_intersections(const Offset_curve_2& offset, const Solver_options& options = {});

/*!
@}
*/

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Locus_intersections<2> cusps(const Offset_curve_2& offset, const Solver_options& options)
{
  internal::Common::Budgeted_solver solve(options);
  const Exact_rational& r = offset.distance();
  const auto pieces = internal::polynomial_pieces(offset.curve(), 2);
  const bool is_closed = offset.curve().is_closed();
  const auto is_cusp_at_begin = [&](const internal::Differentiated_map& piece) {
    const internal::Exact_pair tangent = piece.at(1, piece.begin());
    const Exact_rational turn(r * internal::exact_cross(tangent, piece.at(2, piece.begin()))),
        square = internal::exact_dot(tangent, tangent);
    return turn > 0 && turn * turn == square * square * square;
  };
  std::vector<Locus_intersection<2>> result;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (solve.must_stop()) {
      result.push_back(internal::Intersections::undecided_locus_intersection<2>(
          {{{pieces[i].begin(), offset.domain().second}}}, solve.reason()));
      break;
    }
    const auto [u] = parameters(pieces[i].map());
    const Vector_expression<2> tangent = pieces[i](1, u);
    const Expression turn = r * determinant(tangent, pieces[i](2, u));
    if (turn.numerator().is_zero())
      continue;   // a segment
    std::vector<Constraint> constraints{turn * turn == pow(squared_norm(tangent), 3), turn > 0};
    if ((i + 1 < pieces.size() || is_closed) && is_cusp_at_begin(pieces[(i + 1) % pieces.size()]))
      constraints.push_back(u < pieces[i].end());   // it is found there
    const Vector_expression<2> center = pieces[i](0, u) + perpendicular(tangent) * (r * squared_norm(tangent) / turn);
    for (const Solution_d<double>& solution : solve(constraints)) {
      const auto box = solution.exact_box();
      result.push_back({internal::Intersections::intersection_kind(solution.kind()),
                        internal::Common::coordinate_ranges<2>(center, {u}, box),
                        {{{box[0], offset.domain()}}},
                        solution});
    }
  }
  return internal::Intersections::ordered_by_kind(std::move(result), solve.total());
}

CGAL_SPLINE_CONSTRAINTS_INLINE Locus_intersections<2> self_intersections(const Offset_curve_2& offset,
                                                                         const Solver_options& options)
{
  internal::Common::Budgeted_solver solve(options);
  const std::vector<internal::Differentiated_map> curves = internal::polynomial_pieces(offset.curve(), 1);
  std::vector<internal::Loci::Offset_piece> pieces;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const bool has_next = i + 1 < curves.size() || offset.curve().is_closed();
    pieces.push_back(
        {curves[i], !(has_next && internal::have_common_tangent(curves[i], curves[(i + 1) % curves.size()]))});
  }
  std::vector<Locus_intersection<2>> result;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    for (std::size_t j = i; j < pieces.size(); ++j) {
      if (solve.must_stop()) { // one answer stands for all pairs that follow
        result.push_back(internal::Intersections::undecided_locus_intersection<2>(
            {{offset.domain()}, {offset.domain()}}, solve.reason()));
        return internal::Intersections::ordered_by_kind(std::move(result), solve.total());
      }
      for (Locus_intersection<2>& answer :
           internal::Loci::Offset_self_intersection(offset.distance(), pieces[i], pieces[j], offset.domain())
               .solutions(solve))
        result.push_back(std::move(answer));
    }
  return internal::Intersections::ordered_by_kind(std::move(result), solve.total());
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CURVE_FEATURES_OFFSET_FEATURES_2_H
