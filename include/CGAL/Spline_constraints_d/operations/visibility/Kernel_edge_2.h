// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_KERNEL_EDGE_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_KERNEL_EDGE_2_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVisibility

What a part of the boundary of the kernel of a region is.
*/
enum class Kernel_edge_kind {
  ARC,       ///< an arc of a curve of the region
  /// a segment of a tangent of a curve: of an inflection, or at an end; it may be a straight part of a curve
  SEGMENT,
  UNDECIDED  ///< it is not decided what the boundary is between two points
};

//! \ingroup PkgSplineConstraintsDVisibility
//! writes `arc`, `segment` or `undecided`.
inline std::ostream& operator<<(std::ostream& out, Kernel_edge_kind kind)
{
  static const char* const names[] = {"arc", "segment", "undecided"};
  return out << names[static_cast<int>(kind)];
}

/*!
\ingroup PkgSplineConstraintsDVisibility

A part of the boundary of the kernel of a region, with the kernel on its left.
*/
struct Kernel_edge_2
{
  Kernel_edge_kind kind;   ///< what it is
  std::size_t curve;       ///< the index of the curve

  //! ranges that are proved to have the parameters of an arc at its source and its target in them; that of the point
  //! where a segment is on the tangent, twice. They are one number each where the parameter is known exactly.
  std::array<std::pair<Exact_rational, Exact_rational>, 2> parameters;

  //! the middle of a range: of the source (0) or the target (1).
  Exact_rational parameter(int end) const
  {
    return Exact_rational((parameters[end].first + parameters[end].second) / 2);
  }

  //! whether parameters decrease along an arc.
  bool is_reversed() const { return kind == Kernel_edge_kind::ARC && parameters[1] < parameters[0]; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_KERNEL_EDGE_2_H
