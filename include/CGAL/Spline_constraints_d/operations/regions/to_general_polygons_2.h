// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_TO_GENERAL_POLYGONS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_TO_GENERAL_POLYGONS_2_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>

#include <CGAL/iterator.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDRegions

a region as general polygons with holes of CGAL, one for each part, whose arcs are exactly those of the region: for its
Boolean operations, and for arrangements.

Circles and segments are curves of `Gps_circle_segment_traits_2`, polynomial curves those of
`Gps_traits_2<Arr_Bezier_curve_traits_2>`:

\code
auto polygons = to_general_polygons<Traits>(region, [](const auto& piece) { return
to_circle_segment_traits_curves<Traits::Curve_2>(piece); }); auto polygons = to_general_polygons<Traits>(region,
[](const auto& piece) { return to_bezier_traits_curves<Traits::Curve_2>(piece); });
\endcode

\tparam Traits a model of `GeneralPolygonSetTraits_2` whose polygons are made of a range of arcs.
\param region the region.
\param curves_of what makes a `std::optional` range of `Traits::Curve_2` of a curve, a model of `ParametricCurve_2` of
one polynomial or rational piece, in the direction of that; nothing, if it is no such curve.
\param traits the traits class.
\throws Invalid_input when a piece is no curve of the traits class (the message names the curve), or the region is not
complete.
*/
template <class Traits, SplineKernel Kernel, class Curves_of>
std::vector<typename Traits::Polygon_with_holes_2>
to_general_polygons(const Planar_region_2<Kernel>& region, const Curves_of& curves_of, const Traits& traits = Traits())
{
  using Arc = typename Traits::X_monotone_curve_2;
  return internal::Regions::polygons_of_parts<typename Traits::Polygon_with_holes_2>(
      region.boundaries(), [&](std::size_t boundary) {
        std::vector<Arc> arcs;
        for (const internal::Regions::Boundary_piece& piece : region.loops()[boundary].pieces()) {
          const auto curves = curves_of(internal::Regions::Boundary_loop_2({piece}).curve());
          if (!curves)
            throw Invalid_input("to_general_polygons: curve " + std::to_string(piece.curve) +
                                " is no curve of the traits class next to the parameter " +
                                internal::shortest_text(to_nearest_double(piece.parameters[0])));
          for (const auto& curve : *curves)
            traits.make_x_monotone_2_object()(curve,
                                              CGAL::dispatch_output<typename Traits::Point_2, Arc>(
                                                  CGAL::Emptyset_iterator(), std::back_inserter(arcs)));
        }
        return typename Traits::Polygon_2(arcs.begin(), arcs.end());
      });
}

//! \ingroup PkgSplineConstraintsDRegions
//! puts these general polygons to an output iterator.
//! \throws Invalid_input as above.
template <class Traits, SplineKernel Kernel, class Curves_of,
          std::output_iterator<typename Traits::Polygon_with_holes_2> OutputIterator>
OutputIterator to_general_polygons(const Planar_region_2<Kernel>& region, const Curves_of& curves_of,
                                   OutputIterator out, const Traits& traits = Traits())
{
  return std::ranges::copy(to_general_polygons<Traits>(region, curves_of, traits), out).out;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_TO_GENERAL_POLYGONS_2_H
