// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_EDGE_STRIP_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_EDGE_STRIP_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDApproximatePolygons

The strip in which the line of an edge of a polygon is, between two lines that are parallel to this edge.
*/
struct Edge_strip_2
{
  using Point = internal::Exact_kernel::Point_2; //!< of the exact kernel.

  Point inner; ///< a point of the line that bounds it on the side of the interior
  Point outer; ///< a point of the other line that bounds it
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_EDGE_STRIP_2_H
