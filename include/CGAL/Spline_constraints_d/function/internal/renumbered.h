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
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A multiple of a monomial.
Power_polynomial polynomial_of_term(const Monomial& monomial, const Exact_rational& coefficient);

// A polynomial with the unknowns numbered by their places in an increasing list, which has all that occur.
Power_polynomial renumbered(const Power_polynomial& polynomial, const std::vector<int>& unknowns);

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
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_RENUMBERED_H
