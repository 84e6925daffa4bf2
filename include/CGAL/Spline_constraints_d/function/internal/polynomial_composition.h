// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POLYNOMIAL_COMPOSITION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POLYNOMIAL_COMPOSITION_H

#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The numerator of a formula whose splines have one piece each, without splines: weights are positive.
Power_polynomial numerator_polynomial(const Expression& formula);

// A polynomial at polynomials: `values[i]` for the unknown i. Horner's scheme in one unknown after the other.
Power_polynomial composed(const Power_polynomial& polynomial, const std::vector<Power_polynomial>& values);

// Divided by a factor as often as there is no remainder.
Power_polynomial without_factor(Power_polynomial polynomial, const Power_polynomial& factor);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial numerator_polynomial(const Expression& formula)
{
  if (formula.numerator().is_constant())
    return formula.numerator();
  const Formula_expansion expansion(*formula.symbols(), formula.symbols()->without_formulas(formula.numerator()));
  return polynomial_of_piece(expansion.scaled_term(), 0) /
      Power_polynomial(scaled_rational(expansion.denominator(), 0));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial composed(const Power_polynomial& polynomial,
                                                         const std::vector<Power_polynomial>& values)
{
  if (polynomial.is_constant())
    return polynomial;
  const int unknown = polynomial.variables().front();
  const std::map<int, Power_polynomial> coefficients = coefficients_by_power(polynomial, unknown);
  Power_polynomial result;
  int power = coefficients.rbegin()->first;
  for (auto next = coefficients.rbegin(); next != coefficients.rend(); ++next) {
    for (; power > next->first; --power)
      result = result * values[unknown];
    result += composed(next->second, values);
  }
  for (; power > 0; --power)
    result = result * values[unknown];
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial without_factor(Power_polynomial polynomial,
                                                               const Power_polynomial& factor)
{
  const Polynomial_divisor divisor(factor);
  while (!polynomial.is_zero())
    if (std::optional<Power_polynomial> quotient = divisor.quotient(polynomial))
      polynomial = std::move(*quotient);
    else
      break;
  return polynomial;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_POLYNOMIAL_COMPOSITION_H
