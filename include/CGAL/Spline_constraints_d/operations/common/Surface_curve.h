// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_SURFACE_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_SURFACE_CURVE_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_curve.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

A line in the domain of a surface, on which one of the parameters is constant.
*/
struct Constant_parameter
{
  int axis;               ///< that of the parameter
  Exact_rational value;   ///< its value

  friend bool operator==(const Constant_parameter&, const Constant_parameter&) = default;
};

/*!
\ingroup PkgSplineConstraintsDIntersections

A connected curve on a surface.
*/
struct Surface_curve
{
  std::size_t part;                          ///< the index of the part of the domain that it lies in
  /// between seams and poles; indices are those of curves in `Surface_curves_3::solutions(part)`
  std::vector<Intersection_arc> arcs;
  bool is_closed;                            ///< whether the last arc ends where the first one begins
  /// of a curve along a break, a seam or an edge of the surface, which has no arcs and is not joined with other curves
  std::optional<Constant_parameter> line{};
  /// how often its points count in the equations, see `Curve_piece::multiplicity`; 0 if this is not known
  int multiplicity = 1;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_SURFACE_CURVE_H
