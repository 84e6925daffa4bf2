// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERSECTION_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERSECTION_CURVE_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection_kind.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

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
\ingroup PkgSplineConstraintsDIntersections

A connected curve that two surfaces have in common.
*/
struct Intersection_curve
{
  //! its arcs, in order; each begins in the point where the one before ends.
  std::vector<Intersection_arc> arcs;

  //! whether the last arc ends where the first one begins.
  bool is_closed;

  //! how often its points count in the equations that were solved, see `Curve_piece::multiplicity`; 0 if this is not
  //! known. If one of two surfaces is implicit, and not singular along the curve, they have contact of the order
  //! `multiplicity` - 1 there.
  int multiplicity = 1;

  /*!
  `TRANSVERSAL`: the surfaces cross at an angle in all points between the ends of arcs, by proof, since the equations
  are regular there. `TANGENT`: a contact curve, along which the surfaces have the same tangent planes, or one of them
  is singular, by proof, as the points count several times. `UNDECIDED`: this is not known, or arcs differ.
  */
  Intersection_kind kind() const
  {
    return multiplicity == 1 ? Intersection_kind::TRANSVERSAL
        : multiplicity > 1   ? Intersection_kind::TANGENT
                             : Intersection_kind::UNDECIDED;
  }
};

namespace internal {
namespace Common {

// How often the points of arcs count, of which each has its own multiplicity; 0 if these differ.
template <class Multiplicity>
int common_multiplicity(const std::vector<Intersection_arc>& arcs, const Multiplicity& multiplicity)
{
  const int result = multiplicity(arcs.front());
  return std::all_of(arcs.begin(), arcs.end(), [&](const Intersection_arc& arc) { return multiplicity(arc) == result; })
      ? result
      : 0;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERSECTION_CURVE_H
