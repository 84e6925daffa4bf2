// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RELATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RELATION_H

#include <CGAL/enum.h>

#include <ostream>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

How a function compares with zero in a constraint `function relation 0`.
*/
enum class Relation {
  EQUAL,           //!< \f$f = 0\f$
  LESS,            //!< \f$f < 0\f$
  LESS_EQUAL,      //!< \f$f \le 0\f$
  GREATER_EQUAL,   //!< \f$f \ge 0\f$
  GREATER,         //!< \f$f > 0\f$
  NOT_EQUAL        //!< \f$f \neq 0\f$
};

/*!
\ingroup PkgSplineConstraintsDFunctions

tells whether a function whose value has the sign `sign` satisfies `function relation 0`.
*/
inline bool is_satisfied(Relation relation, CGAL::Sign sign)
{
  switch (relation) {
  case Relation::EQUAL: return sign == CGAL::ZERO;
  case Relation::LESS: return sign == CGAL::NEGATIVE;
  case Relation::LESS_EQUAL: return sign != CGAL::POSITIVE;
  case Relation::GREATER_EQUAL: return sign != CGAL::NEGATIVE;
  case Relation::NOT_EQUAL: return sign != CGAL::ZERO;
  case Relation::GREATER: break;
  }
  return sign == CGAL::POSITIVE;
}

/*!
\ingroup PkgSplineConstraintsDFunctions

the relation as it is written in a formula: `=`, `<`, `<=`, `>=`, `>` or `!=`.
*/
inline const char* symbol(Relation relation)
{
  switch (relation) {
  case Relation::EQUAL: return "=";
  case Relation::LESS: return "<";
  case Relation::LESS_EQUAL: return "<=";
  case Relation::GREATER_EQUAL: return ">=";
  case Relation::NOT_EQUAL: return "!=";
  case Relation::GREATER: break;
  }
  return ">";
}

/*!
\ingroup PkgSplineConstraintsDFunctions

writes `symbol(relation)`.
*/
inline std::ostream& operator<<(std::ostream& out, Relation relation) { return out << symbol(relation); }

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_RELATION_H
