// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_PLANAR_REGIONS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_PLANAR_REGIONS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/operations/Planar_region_2.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <array>
#include <ranges>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/// \addtogroup PkgSplineConstraintsDOperations
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
Planar_region_2<Kernel> planar_region(const CGAL::Polygon_2<Kernel, Container>& polygon)
{
  return planar_region(to_bspline_curve(polygon));
}

//! the region inside a polygon with holes; its curves are the outer boundary and those of the holes.
//! \throws Invalid_input when the polygon is unbounded, or boundaries are empty or cross.
template <SplineKernel Kernel, class Container>
Planar_region_2<Kernel> planar_region(const CGAL::Polygon_with_holes_2<Kernel, Container>& polygon)
{
  if (polygon.is_unbounded())
    throw Invalid_input("planar_region: the polygon is unbounded");
  return planar_region(to_bspline_curves(polygon));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_PLANAR_REGIONS_2_H
