// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_SPECIAL_POINT_KIND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_SPECIAL_POINT_KIND_H

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

What a special point of a curve or surface is.
*/
enum class Special_point_kind
{
  END,    ///< an end of a curve
  BREAK,  ///< where the tangent of a curve or surface may jump, by the multiplicity of a knot: also on an edge
  CORNER, ///< a corner of the domain of a surface
  SEAM,   ///< the common end of a closed curve, or a corner or break on the seam of a closed surface
  POLE    ///< an edge of a surface that is one point
};

//! \ingroup PkgSplineConstraintsDDistances
//! writes `end`, `break`, `corner`, `seam` or `pole`.
inline std::ostream& operator<<(std::ostream& out, Special_point_kind kind)
{
  static const char* const names[] = {"end", "break", "corner", "seam", "pole"};
  return out << names[static_cast<int>(kind)];
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_SPECIAL_POINT_KIND_H
