// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_PARTS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_PARTS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Visible_part_2.h>

#include <array>
#include <ranges>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/// \addtogroup PkgSplineConstraintsDVisibility
/// @{

/*!
what is seen from a point between curves in the plane: the parts of the curves that no other part hides, and the region
that they and rays bound.

Curves are cut where the ray from the viewpoint touches them, and where it is parallel to an axis: these parameters are
roots of polynomials in one unknown. Between the directions of these roots, of ends of curves and of their crossings,
which all are told apart, or proved to be the same, one arc is the nearest one: it is found in one rational direction,
with exact comparisons. Curves may be open or closed, cross, touch and overlap; the viewpoint may be on them, and sees
both sides then. Parts of lines through the viewpoint hide nothing. Where it is not proved that several directions are
one, and what is seen depends on it, there is an edge of the kind `Visible_edge_kind::UNDECIDED`.

\tparam Range a range of curves that are models of `ParametricCurve_2`.
\param viewpoint the point.
\param curves the curves.
\param options those of the solver that looks for crossings of curves.
\throws Invalid_input when there are no curves, a coordinate is not finite, a weight is not proved to have one sign, an
option makes no sense, or the viewpoint is on a curve at a parameter that is not rational.

Complexity: \f$O(nk)\f$ comparisons of distances for \f$n\f$ arcs and \f$k\f$ directions, and `pairwise_intersections()`
of the curves.
*/
template <std::ranges::input_range Range>
  requires ParametricCurve_2<std::ranges::range_value_t<Range>>
  auto visible_part(const typename std::ranges::range_value_t<Range>::Kernel::Point_2& viewpoint, const Range& curves,
                    const Solver_options& options = {})
  {
    std::vector<Bspline_curve_2<typename std::ranges::range_value_t<Range>::Kernel>> splines;
    for (const auto& curve : curves)
      splines.push_back(to_bspline_curve(curve));
    return Visible_part_2<typename std::ranges::range_value_t<Range>::Kernel>(viewpoint, splines, options);
}

//! what is seen from a point of one curve.
//! \throws Invalid_input as above.
template <ParametricCurve_2 Curve>
Visible_part_2<typename Curve::Kernel> visible_part(const typename Curve::Kernel::Point_2& viewpoint,
                                                    const Curve& curve, const Solver_options& options = {})
{
  return visible_part(viewpoint, std::array<Curve, 1>{curve}, options);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_PARTS_2_H
