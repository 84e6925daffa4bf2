// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUM_BOUNDARY_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUM_BOUNDARY_2_H

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDMinkowskiSums

An arc of a boundary of a Minkowski sum: the sums of points of a part of a curve of the first operand and a part of one
of the second operand. One of these may be a point.
*/
struct Minkowski_sum_arc_2
{
  std::array<std::size_t, 2> curves;                  ///< the indices of the curves
  std::array<std::array<double, 2>, 2> parameters;    ///< of each curve, where the arc begins and ends
};

/*!
\ingroup PkgSplineConstraintsDMinkowskiSums

A boundary of a Minkowski sum, with the region on its left. Where parts of the region touch in a point, they are apart:
each boundary is one of the region near it, and may pass through a point twice. So a hole that touches the outer
boundary is a part of this one, as in an arrangement.
*/
struct Minkowski_sum_boundary_2
{
  std::vector<Minkowski_sum_arc_2> arcs;   ///< in order; each begins where the one before ends
  /// whether the last arc ends where the first one begins; false only where something is not decided
  bool is_closed;
  bool is_hole;                            ///< whether it is clockwise, as is proved by bounds of the area
  /// the index of the outer boundary of the same part of the sum, as is proved by winding numbers, if it is known
  std::optional<std::size_t> outer;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_MINKOWSKI_SUM_BOUNDARY_2_H
