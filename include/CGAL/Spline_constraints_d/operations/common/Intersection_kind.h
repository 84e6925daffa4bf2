// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERSECTION_KIND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERSECTION_KIND_H

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

What is known of an intersection of two operands.
*/
enum class Intersection_kind {
  /// one common point that counts once, where no parameter is at an end: curves cross, a curve passes through a
  /// surface, a point lies on a curve or surface
  TRANSVERSAL,
  /// a common point that counts several times: the operands touch, or one of them is singular there; or one on a knot
  /// that is not proved to count once, as a corner where planar curves touch. A multiplicity of one is that of a knot
  TANGENT,
  /// one common point that counts once, at an end of a curve, on an edge of a surface, on the seam of a closed operand,
  /// or at the pole of a surface
  END_POINT,
  OVERLAP,       ///< a piece of one operand lies on the other
  UNDECIDED      ///< nothing is proved: there may be common points with these parameters
};

//! \ingroup PkgSplineConstraintsDIntersections
//! writes `transversal`, `tangent`, `end point`, `overlap` or `undecided`.
inline std::ostream& operator<<(std::ostream& out, Intersection_kind kind)
{
  static const char* const names[] = {"transversal", "tangent", "end point", "overlap", "undecided"};
  return out << names[static_cast<int>(kind)];
}

/*!
\ingroup PkgSplineConstraintsDIntersections

How two planar curves pass through a common point where both go on, be it a corner of one of them or of both.
*/
enum class Passage {
  CROSSES,              ///< each curve goes from one side of the other one to the other side
  TOUCHES,              ///< each curve stays on one side of the other one
  TOUCHES_OR_CROSSES    ///< it is not decided which of these
};

//! \ingroup PkgSplineConstraintsDIntersections
//! writes `crosses`, `touches` or `touches or crosses`.
inline std::ostream& operator<<(std::ostream& out, Passage passage)
{
  static const char* const names[] = {"crosses", "touches", "touches or crosses"};
  return out << names[static_cast<int>(passage)];
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERSECTION_KIND_H
