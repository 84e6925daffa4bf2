// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_REGION_KERNELS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_REGION_KERNELS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/Region_kernel_2.h>

#include <ranges>

namespace CGAL {
namespace Spline_constraints {

/// \addtogroup PkgSplineConstraintsDVisibility
/// @{

/*!
the kernel of a region of the plane: the points from which all of the region is seen.

A point p sees all of a region that one closed curve C bounds, with the region on its left, if C' x (p - C) >= 0
everywhere. Tangents cut a polygon until a point is found in the interior of the kernel, or it is proved that this has
none. Seen from there, the boundary of the kernel is that tangent or arc that is the nearest one. It is found in
rational directions, with exact comparisons, and between them from the convexity of the inverse distances. Corners of
the kernel are known exactly where two straight parts meet, and in corners of the region; otherwise to 2^-60 of the
directions, about. Where more than two tangents or arcs are not told apart in one corner of the kernel, there is an edge
of the kind `Kernel_edge_kind::UNDECIDED`.

\param region the region; one with holes, or of several parts, has no kernel, other than a point where parts touch. Of
one that is not complete, the kernel is undecided.
\param options limits of time and nodes, a visitor; the rest of the options has no effect.
\throws Invalid_input when an option makes no sense.

Complexity: \f$O(nk)\f$ comparisons for \f$n\f$ parts of curves between inflections, ends and corners, and \f$k\f$
halvings of cones. Source: the definition of \cgalCite{kes-gcps-05}, which names the problem.
*/
template <SplineKernel Kernel>
Region_kernel_2<Kernel> region_kernel(const Planar_region_2<Kernel>& region, const Solver_options& options = {})
{
  return Region_kernel_2<Kernel>(region, options);
}

//! the kernel of the region between these curves; limits are for finding the region, too.
//! \throws Invalid_input as `planar_region()`.
template <std::ranges::input_range Range>
  requires ParametricCurve_2<std::ranges::range_value_t<Range>>
auto region_kernel(const Range& curves, const Solver_options& options = {})
{
  const auto region = planar_region(curves, options);
  return region_kernel(region, internal::rest_of(options, region.summary()));
}

//! the kernel of the region that a closed curve bounds.
//! \throws Invalid_input as `planar_region()`.
template <ParametricCurve_2 Curve>
Region_kernel_2<typename Curve::Kernel> region_kernel(const Curve& boundary, const Solver_options& options = {})
{
  return region_kernel(std::array<Curve, 1>{boundary}, options);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_REGION_KERNELS_2_H
