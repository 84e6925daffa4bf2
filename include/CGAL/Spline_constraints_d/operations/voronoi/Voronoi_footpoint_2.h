// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_FOOTPOINT_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_FOOTPOINT_2_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

Where the disk of a vertex of a Voronoi diagram touches a site.
*/
struct Voronoi_footpoint_2
{
  std::size_t site;                  ///< the site
  std::optional<double> parameter;   ///< of the curve; none, if the site is a point
  /// of the exact parameter, proved if the vertex is resolved; none, if the site is a point
  std::optional<std::array<double, 2>> parameter_bounds;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_VORONOI_FOOTPOINT_2_H
