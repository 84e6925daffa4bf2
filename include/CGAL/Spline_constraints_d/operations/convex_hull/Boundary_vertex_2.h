// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_BOUNDARY_VERTEX_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_BOUNDARY_VERTEX_2_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDConvexHulls

A vertex of a boundary that consists of arcs of curves and of segments between points of them, as those of a convex hull
and of what is seen from a point.
*/
struct Boundary_vertex_2
{
  //! the index of the curve; those of isolated points follow on those of the curves.
  std::size_t curve;

  //! a range that is proved to have the parameter in it: one number at the ends of curves and in other points that are
  //! known exactly.
  std::pair<Exact_rational, Exact_rational> parameters;

  //! the middle of the range.
  Exact_rational parameter() const { return Exact_rational((parameters.first + parameters.second) / 2); }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_BOUNDARY_VERTEX_2_H
