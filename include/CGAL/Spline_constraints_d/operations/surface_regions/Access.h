// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_ACCESS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_ACCESS_H

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceRegions

What the rays from the points of a region have in their way; the labels of `accessible_regions()` and
`visible_regions()`.
*/
enum class Access
{
  OBSTRUCTED,  //!< an obstacle
  FREE,        //!< nothing
  NOT_ADMITTED //!< the direction is not one of those that are allowed, or comes from behind the surface
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_REGIONS_ACCESS_H
