// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_EDGE_CURVES_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_EDGE_CURVES_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/loci/point_curve_bisector_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_diagram_of_curves_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <ranges>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

the rational curve that an edge between a point and a piece of a curve is a part of, with exact coefficients; see
`point_curve_bisector()`. Its parameter is that of the given curve, and increases: it begins where the edge begins or
where it ends. Only its ends are rounded, to the parameters of the edge.

In a kernel whose numbers are not exact, joints of pieces are rounded, and so is a site that is one.

\tparam Range a range of curves that are models of `ParametricCurve_2`.
\param diagram the diagram or medial axis.
\param edge the index of the edge.
\param curves what the diagram was made from, or those of the region.
\param margin the share of the parameters that is left out at an end at infinity, where the curve has a pole; between 0
and 1/2.
\return nothing if the sites are two points or two pieces, or the parameters at both ends are the same number.
\throws Invalid_input when the margin is not inside of (0, 1/2).

Complexity: products of polynomials of one parameter.
*/
template <SplineKernel Kernel, std::ranges::input_range Range>
  requires ParametricCurve_2<std::ranges::range_value_t<Range>>
std::optional<Bspline_curve_2<Point_curve_bisector_2::Kernel>>
exact_edge_curve(const Voronoi_diagram_of_curves_2<Kernel>& diagram, std::size_t edge, Range&& curves,
                 double margin = 0x1p-10)
{
  if (!(0 < margin && margin < 0.5))
    throw Invalid_input("exact_edge_curve: the margin is not between 0 and 1/2");
  const auto& [sites, vertices, parameters] = diagram.edges()[edge];
  const std::array<bool, 2> is_point{diagram.sites()[sites[0]].is_point, diagram.sites()[sites[1]].is_point};
  if (is_point[0] == is_point[1])
    return std::nullopt;
  const std::size_t side = is_point[0] ? 1 : 0;
  const auto& piece = diagram.sites()[sites[side]];
  const auto& point = diagram.sites()[sites[1 - side]].point;
  std::array<Exact_rational, 2> ends{to_rational((*parameters[side])[0]), to_rational((*parameters[side])[1])};
  const Exact_rational left_out = Exact_rational(to_rational(margin) * (ends[1] - ends[0]));
  if (diagram.vertices()[vertices[0]].is_at_infinity)
    ends[0] += left_out;
  if (diagram.vertices()[vertices[1]].is_at_infinity)
    ends[1] -= left_out;
  const internal::Loci::Point_curve_bisector bisector(
      {internal::converted_number<Exact_rational>(point.x()), internal::converted_number<Exact_rational>(point.y())},
      *std::ranges::next(std::ranges::begin(curves), static_cast<std::ptrdiff_t>(*piece.curve)));
  const std::vector<Exact_rational> breaks = bisector.breaks();   // ends of pieces may have been rounded beyond
  const auto last = std::upper_bound(breaks.begin() + 1, breaks.end() - 1, Exact_rational((ends[0] + ends[1]) / 2));
  for (Exact_rational& end : ends)
    end = std::clamp(end, *(last - 1), *last);
  if (ends[1] < ends[0])
    std::swap(ends[0], ends[1]);
  return ends[0] < ends[1] ? std::optional(bisector(ends[0], ends[1])) : std::nullopt;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_EDGE_CURVES_2_H
