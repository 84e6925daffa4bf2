// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGIONS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGIONS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/operations/regions/Planar_region_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ranges>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/// \addtogroup PkgSplineConstraintsDRegions
/// @{

//! the region between curves; see the constructor of `Planar_region_2`.
//! \throws Invalid_input as that.
template <std::ranges::input_range Range>
  requires ParametricCurve_2<std::ranges::range_value_t<Range>>
auto planar_region(const Range& curves, const Solver_options& options = {})
{
  std::vector<Bspline_curve_2<typename std::ranges::range_value_t<Range>::Kernel>> splines;
  for (const auto& curve : curves)
    splines.push_back(to_bspline_curve(curve));
  return Planar_region_2<typename std::ranges::range_value_t<Range>::Kernel>(splines, options);
}

//! the region with this boundary.
//! \throws Invalid_input as the constructor of `Planar_region_2`.
template <ParametricCurve_2 Curve>
Planar_region_2<typename Curve::Kernel> planar_region(const Curve& boundary, const Solver_options& options = {})
{
  return planar_region(std::array<Curve, 1>{boundary}, options);
}

//! the region inside a polygon; its only curve is the boundary, with vertex \f$i\f$ at the parameter \f$i\f$.
//! \throws Invalid_input when the polygon is empty or crosses itself.
template <SplineKernel Kernel, class Container>
Planar_region_2<Kernel> planar_region(const CGAL::Polygon_2<Kernel, Container>& polygon,
                                      const Solver_options& options = {})
{
  return planar_region(to_bspline_curve(polygon), options);
}

#ifndef DOXYGEN_RUNNING
namespace internal {
namespace Regions {

// The sign of the area of a simple polygon.
template <class Kernel, class Container>
int exact_orientation(const CGAL::Polygon_2<Kernel, Container>& polygon)
{
  const auto x = [&](std::size_t i) { return converted_number<Exact_rational>(polygon[i].x()); };
  const auto y = [&](std::size_t i) { return converted_number<Exact_rational>(polygon[i].y()); };
  Exact_rational twice_area(0);
  for (std::size_t i = 0, last = polygon.size() - 1; i < polygon.size(); last = i++)
    twice_area += x(last) * y(i) - x(i) * y(last);
  return sign_of(twice_area);
}

// Whether a region is inside of one of its curves, a polygon, or outside, is told by the directions of its arcs.
template <SplineKernel Kernel, class Container>
bool is_inside_of(const Planar_region_2<Kernel>& region, std::size_t curve,
                  const CGAL::Polygon_2<Kernel, Container>& polygon)
{
  const bool is_clockwise = exact_orientation(polygon) < 0;
  return std::ranges::any_of(region.arcs_of_curves()[curve],
                             [&](const auto& arc) { return arc.is_reversed == is_clockwise; });
}

} // namespace Regions
} // namespace internal
#endif

//! the region inside a polygon with holes; its curves are the outer boundary and those of the holes.
//! \throws Invalid_input when the polygon is unbounded, boundaries are empty or cross, or a hole is not inside of the
//! outer boundary, or is inside of another one; the message has its index.
template <SplineKernel Kernel, class Container>
Planar_region_2<Kernel> planar_region(const CGAL::Polygon_with_holes_2<Kernel, Container>& polygon,
                                      const Solver_options& options = {})
{
  if (polygon.is_unbounded())
    throw Invalid_input("planar_region: the polygon is unbounded");
  Planar_region_2<Kernel> result = planar_region(to_bspline_curves(polygon), options);
  if (!result.is_complete())
    return result;
  std::size_t hole = 0;
  for (auto boundary = polygon.holes_begin(); boundary != polygon.holes_end(); ++boundary, ++hole)
    if (internal::Regions::is_inside_of(result, hole + 1, *boundary))
      throw Invalid_input("planar_region: hole " + std::to_string(hole) +
                          " is outside of the outer boundary, or inside of another hole");
  return result;
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_PLANAR_REGIONS_2_H
