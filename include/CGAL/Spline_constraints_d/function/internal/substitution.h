// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SUBSTITUTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SUBSTITUTION_H

#include <CGAL/Spline_constraints_d/function/Expression.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A polynomial at values that are formulas: `values[i]` for the unknown i.
template <class Values>
Expression substituted(const Power_polynomial& polynomial, const Values& values)
{
  Expression result = 0;
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    Expression term = coefficient;
    for (const auto& [unknown, exponent] : monomial.powers)
      term *= pow(values[unknown], exponent);
    result += term;
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SUBSTITUTION_H
