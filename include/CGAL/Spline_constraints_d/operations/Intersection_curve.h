// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTION_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTION_CURVE_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDOperations

A part of an intersection curve without seams inside of it.
*/
struct Intersection_arc
{
  //! the index of the curve in `Surface_intersection::solutions(part)`.
  std::size_t index;

  //! whether it is passed from its end to its begin.
  bool is_reversed;

  //! the index of the solutions, where an operation solves several systems.
  std::size_t part = 0;
};

/*!
\ingroup PkgSplineConstraintsDOperations

A connected curve that two surfaces have in common.
*/
struct Intersection_curve
{
  //! its arcs, in order; each begins in the point where the one before ends.
  std::vector<Intersection_arc> arcs;

  //! whether the last arc ends where the first one begins.
  bool is_closed;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTION_CURVE_H
