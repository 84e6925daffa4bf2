// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_IO_MINIBEX_SYSTEM_H
#define CGAL_SPLINE_CONSTRAINTS_D_IO_MINIBEX_SYSTEM_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Relation.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIO

One constraint of a Minibex file: `function relation 0`, with the line of the file it begins on (0 when it comes from
elsewhere).
*/
struct Minibex_constraint
{
  Power_polynomial function;
  Relation relation = Relation::EQUAL;
  int line = 0;
};

/*!
\ingroup PkgSplineConstraintsDIO

What is read of Minibex.
*/
enum class Minibex_subset
{
  POLYNOMIAL, //!< polynomials; all else is an error
  ELEMENTARY  //!< elementary functions, quotients and all powers, too
};

/*!
\ingroup PkgSplineConstraintsDIO

The system of a Minibex file. `names[i]` and `domains[i]` belong to the unknown of index `i` in the functions; the
elements of an array `x[3]` are the unknowns `x(1)`, `x(2)`, `x(3)`. If there are elementary functions, the constraints
are polynomials in unknowns and `values`.
*/
struct Minibex_system
{
  std::vector<std::string> names;
  std::vector<std::pair<Exact_rational, Exact_rational>> domains;
  std::vector<Minibex_constraint> constraints;
  Elementary_values values = {};
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_IO_MINIBEX_SYSTEM_H
