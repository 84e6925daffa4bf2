// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_EDGE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_EDGE_2_H

#include <CGAL/Spline_constraints_d/operations/convex_hull/Boundary_vertex_2.h>

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVisibility

What a part of the boundary of all that is seen from a point is.
*/
enum class Visible_edge_kind {
  ARC,       ///< an arc of a curve that is seen
  SEGMENT,   ///< a segment of a ray from the viewpoint, between a curve and another one behind it
  OPEN,      ///< no curve is seen between two rays
  UNDECIDED  ///< it is not decided what is seen between two points of curves
};

//! \ingroup PkgSplineConstraintsDVisibility
//! writes `arc`, `segment`, `open` or `undecided`.
inline std::ostream& operator<<(std::ostream& out, Visible_edge_kind kind)
{
  static const char* const names[] = {"arc", "segment", "open", "undecided"};
  return out << names[static_cast<int>(kind)];
}

/*!
\ingroup PkgSplineConstraintsDVisibility

A part of the boundary of all that is seen from a point, which is on its left.
*/
struct Visible_edge_2
{
  Visible_edge_kind kind;     ///< what it is
  Boundary_vertex_2 source;   ///< where it begins
  Boundary_vertex_2 target;   ///< where it ends; on the same curve if it is an arc

  //! whether parameters decrease along an arc.
  bool is_reversed() const { return kind == Visible_edge_kind::ARC && target.parameters < source.parameters; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_VISIBLE_EDGE_2_H
