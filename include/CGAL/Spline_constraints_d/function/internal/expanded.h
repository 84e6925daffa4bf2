// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_EXPANDED_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_EXPANDED_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/function/internal/Formula_expansion.h>
#include <CGAL/Spline_constraints_d/function/internal/Symbol_table.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <functional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// As a function of the unknowns: exact when no spline occurs, else times a positive integer.
CGAL_SPLINE_CONSTRAINTS_INLINE Spline_function expanded(const Symbol_table* symbols, const Power_polynomial& polynomial,
                                                        const std::function<void()>& check)
{
  if (symbols == nullptr)
    return polynomial;
  symbols->require_no_values(polynomial, "Constraint");
  const Power_polynomial without_formulas = symbols->without_formulas(polynomial);
  if (symbols->has_only_unknowns(without_formulas))
    return without_formulas;
  return Formula_expansion(*symbols, without_formulas, check).scaled_function();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_EXPANDED_H
