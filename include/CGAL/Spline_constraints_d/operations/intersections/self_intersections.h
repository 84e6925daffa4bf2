// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SELF_INTERSECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SELF_INTERSECTIONS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_operand.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finders.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/intersections_at.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

where a curve meets itself: all pairs of parameters \f$u < v\f$ with \f$C(u) = C(v)\f$, in the plane or in space. Both
operands of the answers are the curve; the parameter on operand 0 is the lower one.

Each pair comes once, also on knots. Where the curve passes through a point three times, there are three pairs. The
common end of a closed curve is none; if the curve passes through it once more, this is one pair, with the lower end of
the domain.

The curve is cut into arcs that are proved not to meet themselves, since the curve goes on along some direction, and so
that successive arcs are proved to meet only in their common end. All others are intersected as by `intersections()`, if
their boxes meet, and what is said there of kinds holds here as well. In addition, a common point that is a corner of
the curve is `TANGENT`, whether the branches cross there or not. An `OVERLAP` is a piece of the curve that another piece
runs over, in either direction, in parts between cuts, whose ends may be reported once more; or a piece on which the
curve rests in one point, with this piece as both ranges. If the curve runs over itself, `Intersection_set::remarks()`
says how often, and `proper_reparametrization()` makes one of it that does not.

A cusp \f$C'(t) = 0\f$ is no self-intersection. This is proved for ordinary cusps (\f$C''\f$ and \f$C'''\f$ linearly
independent) inside of polynomial pieces; others, and a point where the curve turns back, are left as a short piece that
is `UNDECIDED`, with this piece as both ranges, or, at a break, as a pair of parameters that may be equal.

\tparam Curve a model of `ParametricCurve_2` or `ParametricCurve_3`.
\param curve the curve.
\param options those of the solver; limits hold for the operation as a whole, and a tolerance concerns only what remains
undecided.
\returns an `Intersections` with the kernel and dimension of the curve.
\throws Invalid_input when the weight of the curve is not proved to have one sign, or an option makes no sense.

Complexity: \f$O(n \log^d n)\f$ for \f$n\f$ arcs, most often not many more than there are polynomial pieces, and a
system in two unknowns, or one on lines, for each pair of arcs whose boxes meet, successive ones left out.
*/
template <internal::Common::Parametric_curve Curve>
auto self_intersections(const Curve& curve, const Solver_options& options = {})
{
  using Operand = internal::Common::Spline_operand<Curve>;
  constexpr int d = Operand::dimension;
  internal::Common::Budgeted_solver solve(options);
  const internal::Common::Patch_pair<d> operands(Operand::patch(curve), Operand::patch(curve));
  std::vector<internal::Common::Common_point> points =
      internal::Intersections::self_common_points<d>(operands[0], solve);
  return internal::Intersections::intersections_at<typename Operand::Kernel, d>(std::move(points), operands,
                                                                                solve.total(), {0, 0});
}

/*!
\ingroup PkgSplineConstraintsDIntersections

the same, written to an output iterator, one after the other: also those that are undecided.
\param curve,options as above.
\param output takes objects of type `Intersection` with the kernel and dimension of the curve.
\returns the output iterator behind the last one.
\throws Invalid_input as the function above.
*/
template <internal::Common::Parametric_curve Curve, class Output>
requires std::output_iterator<Output, typename decltype(self_intersections(std::declval<const Curve&>()))::Answer>
    Output self_intersections(const Curve& curve, Output output, const Solver_options& options = {})
{
  const auto found = self_intersections(curve, options);
  return std::copy(found.begin(), found.end(), output);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SELF_INTERSECTIONS_H
