// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_CONSTRAINT_IDIOMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_CONSTRAINT_IDIOMS_H

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <array>

namespace CGAL {
namespace Spline_constraints {

/*!
\addtogroup PkgSplineConstraintsDFunctions
@{
*/

// The idioms of D. K. Pai, Least Constraint (ACC 1991), section 2.4. Formulas may depend on time.

//! a range for a formula, as the limits of a joint: `lower <= f` and `f <= upper`.
inline std::array<Constraint, 2> interval(const Expression& f, const Expression& lower, const Expression& upper)
{
  return {f >= lower, f <= upper};
}

//! a forbidden region \f$f < 0\f$, \f$f \le 0\f$, \f$f > 0\f$ or \f$f \ge 0\f$: the constraint that holds outside of
//! it.
//! \throws Invalid_input when the region is given by another relation.
inline Constraint obstacle(Constraint region)
{
  switch (region.relation) {
  case Relation::LESS:
    region.relation = Relation::GREATER_EQUAL;
    break;
  case Relation::LESS_EQUAL:
    region.relation = Relation::GREATER;
    break;
  case Relation::GREATER_EQUAL:
    region.relation = Relation::LESS;
    break;
  case Relation::GREATER:
    region.relation = Relation::LESS_EQUAL;
    break;
  case Relation::EQUAL:
  case Relation::NOT_EQUAL:
    throw Invalid_input("obstacle: the region is not given by an inequality");
  }
  return region;
}

//! what moves a formula down, from its value `from` at the time zero, at least so fast: \f$f \le a - v t\f$. Nothing
//! else is restricted; with a negative speed it is a lid that opens.
inline Constraint pusher(const Expression& f, const Expression& from, const Expression& speed, const Expression& time)
{
  return f <= from - speed * time;
}

//! a ball that shrinks, or moves, with time: \f$|p - c|^2 \le r^2\f$, and \f$r \ge 0\f$, since it is empty afterwards.
template <int d>
std::array<Constraint, 2> funnel(const Vector_expression<d>& point, const Vector_expression<d>& center,
                                 const Expression& radius)
{
  return {squared_norm(point - center) <= square(radius), radius >= 0};
}

//! a move along a path up to a tolerance: `point` is at most this far from `target`, a point that moves with time.
//! \throws Invalid_input when the tolerance is negative.
template <int d>
Constraint toleranced_move(const Vector_expression<d>& point, const Vector_expression<d>& target,
                           const Exact_rational& tolerance)
{
  if (tolerance < 0)
    throw Invalid_input("toleranced_move: the tolerance is negative");
  return squared_norm(point - target) <= tolerance * tolerance;
}

/*!
@}
*/

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_CONSTRAINT_IDIOMS_H
