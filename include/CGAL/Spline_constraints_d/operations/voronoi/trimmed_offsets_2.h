// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_OFFSETS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_OFFSETS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Trimmed_offset_2.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <CGAL/tags.h>

#include <ranges>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

template <SplineKernel Kernel>
class Planar_region_2;

/*!
\ingroup PkgSplineConstraintsDVoronoi

the trimmed offset of curves and points in the plane: the boundary of the set of all points at no more than a distance
from the nearest of them.

Open curves are offset on both sides, with round ends. Curves may cross each other, share end points, and be given twice
or have pieces in common, which are offset once, as those of the curve with the lowest index.

Along each side of each polynomial piece, and all normals of each end, those disks of the given radius are found that
have no curve inside. By subdivision with interval arithmetic, as for a `voronoi_diagram()`, in double precision, and
with 128 bits where that does not decide: it is proved where they are free, or covered; the ends between are zeros of
functions of one variable, and proved to be the only ones; and each is connected to the other curve that the disk
touches there, not by coordinates.

Where disks are touched from opposite, as between parallel walls at exactly twice the distance, or two corners, the
offset is the limit of those at greater distances: offsets that coincide bound nothing, and where two touch in a point,
both end in it. That is decided exactly if the point is an end of one of the curves, and opposite to an end or a
straight part of the other one, and for arcs of circles with one center. So a grown set of which two parts touch is one
component, the outer boundary of which passes the point twice, and a shrunk one falls into components. A vertex of a
curve with exactly that radius of curvature, in which the curvature is greatest, is decided if it is an end of a piece
or its parameter there is a simple number: disks next to it are free as far as that curve is concerned. Other offsets
that touch, other such vertices, and curves that touch each other at parameters that are not rational, on the side in
question, are not decided: `Trimmed_offset_2::is_complete()` is false, and `Trimmed_offset_2::undecided()` tells where.
The work for each side of a piece is limited; where the distance is very nearly a radius of curvature in a vertex, by
less than about \f$10^{-5}\f$ of it, the limit may be reached.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`, to hand
the sides to all cores through TBB. The answers are the same.
\tparam Range a range of curves that are models of `ParametricCurve_2`.
\tparam Points a range of points of the same kernel.
\param curves the curves; there may be none.
\param distance the distance; positive.
\param points points that are offset with the curves.
\param options limits and a visitor, as of `voronoi_diagram()`.
\throws Invalid_input when the distance is not positive or not finite, the greatest absolute value of a coordinate is
neither 0 nor between \f$2^{-250}\f$ and \f$2^{250}\f$, a piece of a curve is a point, the weight of a curve is not
proved to have one sign, or an option makes no sense.

Complexity: for each side of a piece, that of the subdivision of its neighbourhood; what is farther away is left out by
a tree of boxes.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, std::ranges::input_range Range,
          std::ranges::input_range Points =
              std::vector<typename std::ranges::range_value_t<Range>::Kernel::Point_2>>
  requires ParametricCurve_2<std::ranges::range_value_t<Range>>
  auto trimmed_offset(Range&& curves, const typename std::ranges::range_value_t<Range>::Kernel::FT& distance,
                      const Points& points = {}, const Solver_options& options = {})
  {
    return Trimmed_offset_2<typename std::ranges::range_value_t<Range>::Kernel>(
        internal::Voronoi::offset_of_curves<Concurrency_tag>(
            internal::Voronoi::planar_operands(curves, points), internal::converted_number<Exact_rational>(distance),
            options));
}

/*!
\ingroup PkgSplineConstraintsDVoronoi

the trimmed offset of a region: the boundary of the region that has grown by a distance, or, if that is negative,
shrunk. Corners become round on the side where they are reflex.

\tparam Concurrency_tag as above.
\param region the region. Parameters of arcs are those of its curves. Where it is not complete, all of them are
undecided.
\param distance the distance; not zero. The result may be empty if it is negative.
\param options as above.
\throws Invalid_input when the distance is zero or not finite, the greatest coordinate is not as above, the weight of a
curve is not proved to have one sign, or an option makes no sense.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, SplineKernel Kernel>
Trimmed_offset_2<Kernel> trimmed_offset(const Planar_region_2<Kernel>& region, const typename Kernel::FT& distance,
                                        const Solver_options& options = {})
{
  return Trimmed_offset_2<Kernel>(internal::Voronoi::offset_of_region<Concurrency_tag>(
      internal::Voronoi::region_operand(region), internal::converted_number<Exact_rational>(distance), options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_TRIMMED_OFFSETS_2_H
