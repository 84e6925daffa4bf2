// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_CONVEX_HULLS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_CONVEX_HULLS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/Convex_hull_2.h>

#include <array>
#include <ranges>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/// \addtogroup PkgSplineConstraintsDConvexHulls
/// @{

/*!
the convex hull of planar curves and points: all that a rubber band around them encloses. Its boundary consists of arcs
of curves, and of segments that touch curves, or end in their ends, corners, or points.

A polygon within the hull grows until, with exact comparisons, it is proved which parts of the boundary are arcs, and
that a segment touches two curves, whose contacts are solutions of a system in two unknowns. Collinear points, straight
pieces, arcs that begin where a segment ends, duplicates, points on arcs, curves that touch an arc from within, and
three that touch a line with rational slope are decided exactly. Where something else is not told apart after 64
halvings, or until a limit is reached, edges are `Hull_edge_kind::UNDECIDED`; nothing depends on a tolerance.

\tparam Range a range of curves that are models of `ParametricCurve_2`.
\param curves the curves, open or closed; they may cross, touch, and be in any direction.
\param points a range of points of the same kernel.
\param options those of the solver; limits hold for the operation as a whole.
\throws Invalid_input when there are neither curves nor points, a coordinate is not finite, a weight is not proved to
have one sign, or an option makes no sense.

Complexity: rounds of the number of pieces that are not in the polygon times the number of its vertices; one system for
each segment. Source: \cgalCite{kes-gcps-05}, which names the problem, for the equations of the contacts.
*/
template <std::ranges::input_range Range, std::ranges::input_range Points =
                                              std::vector<typename std::ranges::range_value_t<Range>::Kernel::Point_2>>
  requires ParametricCurve_2<std::ranges::range_value_t<Range>>
auto convex_hull(const Range& curves, const Points& points = {}, const Solver_options& options = {})
{
  std::vector<Bspline_curve_2<typename std::ranges::range_value_t<Range>::Kernel>> splines;
  for (const auto& curve : curves)
    splines.push_back(to_bspline_curve(curve));
  return Convex_hull_2<typename std::ranges::range_value_t<Range>::Kernel>(splines, points, options);
}

//! the convex hull of one curve.
//! \throws Invalid_input as above.
template <ParametricCurve_2 Curve>
Convex_hull_2<typename Curve::Kernel> convex_hull(const Curve& curve, const Solver_options& options = {})
{
  return convex_hull(std::array<Curve, 1>{curve}, {}, options);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_CONVEX_HULLS_2_H
