// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAMS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAMS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_diagram_of_curves_2.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <CGAL/tags.h>

#include <ranges>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

the Voronoi diagram of curves and points in the plane: which of them is nearest, for each point of the plane. Its edges
are trimmed bisectors; the part within a closed curve is the medial axis there.

The sites are the polynomial pieces of the curves, cut where curves cross each other or themselves, touch, or end on
another one, or where their derivative is zero, and once between such a place and a crossing that is not rational, all
ends of these parts, and the points. A curve that is given twice, forward or backward, is one site, and so is a piece
that curves have in common: then `Voronoi_diagram_of_curves_2::coincident_parts()` tells which. Where curves touch at
parameters that are not rational, where three of them pass through a point of irrational parameters, and where a
derivative is zero at such a parameter, the diagram is not resolved, and `Voronoi_diagram_of_curves_2::is_complete()` is
false.

For each side of each piece, and all normals of each end, the curvatures of the empty disks that touch it are computed
as the upper envelope of functions of one variable, by subdivision with interval arithmetic in double precision; its
pieces and the events between them are proved. Where curves join smoothly exact polynomials decide, and vertices of four
sites or more are decided exactly if the sites are points, lines and circles and the center is rational. All are
connected by their footpoints, not by coordinates.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`, to hand
the sides to all cores through TBB. The answers are the same.
\tparam Range a range of curves that are models of `ParametricCurve_2`.
\tparam Points a range of points of the same kernel.
\param curves the curves; there may be none.
\param points the points.
\param options limits and a visitor, which is told the share of the sides that is done. What has been found when they
end the search is the answer, and the rest is undecided; all is, if it was ended before the sites are known. Nodes are
the ranges of curves and of normals in their ends that are looked at. With a ladder's precision below 128 bits, what
doubles do not decide is undecided. The tolerance and the other precisions have no effect.
\throws Invalid_input when the greatest absolute value of a coordinate is neither 0 nor between \f$2^{-250}\f$ and
\f$2^{250}\f$, a piece of a curve is a point, the weight of a curve is not proved to have one sign, or an option makes
no sense.

Complexity: that of `pairwise_intersections()`; and for each side of a piece, that of the subdivision of its
neighbourhood; what is farther away is left out by a tree of boxes. Source: \cgalCite{hmek-pvce-05} has the idea of the
envelope.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, std::ranges::input_range Range,
          std::ranges::input_range Points =
              std::vector<typename std::ranges::range_value_t<Range>::Kernel::Point_2>>
  requires ParametricCurve_2<std::ranges::range_value_t<Range>>
  auto voronoi_diagram(Range&& curves, const Points& points = {}, const Solver_options& options = {})
  {
    return Voronoi_diagram_of_curves_2<typename std::ranges::range_value_t<Range>::Kernel>(
        internal::Voronoi::diagram_of_curves<Concurrency_tag>(internal::Voronoi::planar_operands(curves, points),
                                                              options, "voronoi_diagram"));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAMS_2_H
