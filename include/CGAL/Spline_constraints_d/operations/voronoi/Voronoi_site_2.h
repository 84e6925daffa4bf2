// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_SITE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_SITE_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

What cells of a Voronoi diagram belong to: a polynomial piece of a curve, without its ends, or a point: an end of such a
piece, or an isolated one.
*/
template <SplineKernel Kernel>
struct Voronoi_site_2
{
  bool is_point;                    ///< whether it is a point
  typename Kernel::Point_2 point;   ///< the point; of a piece, the point where it begins
  /// the index of the curve; of a point, the lowest index of a curve that ends or is cut there; none, if no curve does
  std::optional<std::size_t> curve;
  /// the piece begins and ends with these parameters of the curve; a point of a curve has twice its own one
  std::array<double, 2> parameters;
  /// the index of the connected set of curves and points that it belongs to, and of the region of the plane nearest to
  /// that
  std::size_t region;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_SITE_2_H
