// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_SAMPLE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_SAMPLE_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>

#include <array>
#include <limits>
#include <optional>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

A point of an edge of a Voronoi diagram: the center of an empty disk that touches both sites.

It is up to rounding, and the bounds of its radius are close together, but for a few places where the sites nearly
coincide: where the bounds are not, the disk touches one of the sites and has some radius between them.
*/
template <SplineKernel Kernel>
struct Voronoi_sample_2
{
  typename Kernel::Point_2 point;            ///< the center of the disk, rounded
  double radius;                             ///< the radius of the disk: the distance from both sites
  /// where the disk touches the sites of the edge: the parameter of a curve; none, if the site is a point
  std::array<std::optional<double>, 2> parameters;
  /// the exact radius of a disk that touches one of the sites there is between them, by proof
  std::array<double, 2> radius_bounds{0, std::numeric_limits<double>::infinity()};
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_SAMPLE_2_H
