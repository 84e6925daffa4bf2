// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_HULL_EDGE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_HULL_EDGE_2_H

#include <CGAL/Spline_constraints_d/operations/convex_hull/Boundary_vertex_2.h>

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDConvexHulls

What a part of the boundary of a convex hull is.
*/
enum class Hull_edge_kind {
  ARC,       ///< an arc of a curve
  SEGMENT,   ///< a segment between points of curves, where it touches them; it may be a straight part of a curve
  /// the segment between two points of curves that are in the hull; it is not decided what the boundary is near it
  UNDECIDED
};

//! \ingroup PkgSplineConstraintsDConvexHulls
//! writes `arc`, `segment` or `undecided`.
inline std::ostream& operator<<(std::ostream& out, Hull_edge_kind kind)
{
  static const char* const names[] = {"arc", "segment", "undecided"};
  return out << names[static_cast<int>(kind)];
}

/*!
\ingroup PkgSplineConstraintsDConvexHulls

A part of the boundary of a convex hull, with the hull on its left.
*/
struct Hull_edge_2
{
  Hull_edge_kind kind;        ///< what it is
  Boundary_vertex_2 source;   ///< where it begins
  Boundary_vertex_2 target;   ///< where it ends; on the same curve if it is an arc

  //! whether parameters decrease along an arc.
  bool is_reversed() const { return kind == Hull_edge_kind::ARC && target.parameters < source.parameters; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_HULL_EDGE_2_H
