// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAMS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAMS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_diagram_of_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Graph_of_crossing_curves_2.h>

#include <memory>
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
\param curves the curves; there may be none.
\param points the points.
\throws Invalid_input when the greatest absolute value of a coordinate is neither 0 nor between \f$2^{-250}\f$ and
\f$2^{250}\f$, a piece of a curve is a point, or the weight of a curve is not proved to have one sign.

Complexity: that of `pairwise_intersections()`; and for each side of a piece, that of the subdivision of its
neighbourhood; what is farther away is left out by a tree of boxes. Source: \cgalCite{hmek-pvce-05} has the idea of the
envelope.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, std::ranges::input_range Range>
  requires ParametricCurve_2<std::ranges::range_value_t<Range>>
  auto voronoi_diagram(const Range& curves,
                       const std::vector<typename std::ranges::range_value_t<Range>::Kernel::Point_2>& points = {})
  {
    using Kernel = typename std::ranges::range_value_t<Range>::Kernel;
    const auto graph = internal::Voronoi::graph_of_crossing_curves<Concurrency_tag, Kernel>(
        internal::Voronoi::site_curves(curves), points);
    auto diagram = std::make_shared<internal::Voronoi::Disk_diagram>(internal::Voronoi::disk_diagram<Concurrency_tag>(
        *graph, internal::Voronoi::all_elements(*graph), "voronoi_diagram"));
    return Voronoi_diagram_of_curves_2<Kernel>(graph, diagram);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_DIAGRAMS_2_H
