// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_RENUMBERED_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_RENUMBERED_H

#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A multiple of a monomial.
Power_polynomial polynomial_of_term(const Monomial& monomial, const Exact_rational& coefficient);

// A polynomial with the unknowns numbered by their places in an increasing list, which has all that occur.
Power_polynomial renumbered(const Power_polynomial& polynomial, const std::vector<int>& unknowns);

Monomial least_common_multiple(const Monomial& a, const Monomial& b);

// \pre b divides a
Monomial quotient(const Monomial& a, const Monomial& b);

// The largest monomial that divides all terms; 1 for the zero polynomial.
Monomial monomial_content(const Power_polynomial& polynomial);

Power_polynomial polynomial_of(const Monomial& monomial);

// \pre the monomial divides all terms
Power_polynomial divided(const Power_polynomial& polynomial, const Monomial& monomial);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial polynomial_of_term(const Monomial& monomial,
                                                                   const Exact_rational& coefficient)
{
  Power_polynomial result(coefficient);
  for (const auto& [unknown, exponent] : monomial.powers)
    result *= pow(Power_polynomial::variable(unknown), exponent);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial renumbered(const Power_polynomial& polynomial,
                                                           const std::vector<int>& unknowns)
{
  Power_polynomial result;
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    Monomial own;
    for (const auto& [unknown, exponent] : monomial.powers) {
      const auto place = std::lower_bound(unknowns.begin(), unknowns.end(), unknown) - unknowns.begin();
      own.powers.emplace_back(static_cast<int>(place), exponent);
    }
    result += polynomial_of_term(own, coefficient);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Monomial least_common_multiple(const Monomial& a, const Monomial& b)
{
  Monomial result = a;
  for (const auto& [symbol, exponent] : b.powers)
    result = result.with_exponent(symbol, (std::max)(exponent, result.exponent(symbol)));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Monomial quotient(const Monomial& a, const Monomial& b)
{
  Monomial result = a;
  for (const auto& [symbol, exponent] : b.powers)
    result = result.with_exponent(symbol, result.exponent(symbol) - exponent);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Monomial monomial_content(const Power_polynomial& polynomial)
{
  Monomial result;
  bool is_first = true;
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    if (is_first)
      result = monomial;
    is_first = false;
    Monomial common;
    for (const auto& [symbol, exponent] : result.powers)
      if (const int least = (std::min)(exponent, monomial.exponent(symbol)); least > 0)
        common.powers.emplace_back(symbol, least);
    result = std::move(common);
    if (result.powers.empty())
      break;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial polynomial_of(const Monomial& monomial)
{
  Power_polynomial result(1);
  for (const auto& [symbol, exponent] : monomial.powers)
    result *= pow(Power_polynomial::variable(symbol), exponent);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial divided(const Power_polynomial& polynomial, const Monomial& monomial)
{
  if (monomial.powers.empty())
    return polynomial;
  Power_polynomial result;
  for (const auto& [own, coefficient] : polynomial.terms())
    result += Power_polynomial(coefficient) * polynomial_of(quotient(own, monomial));
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_RENUMBERED_H
