// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_FORM_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_FORM_H

#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Expansion_budget.h>
#include <CGAL/Spline_constraints_d/function/internal/Polynomial_terms.h>
#include <CGAL/Spline_constraints_d/function/internal/expansion_limits.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A polynomial over one denominator, with integer coefficients.
struct Integer_form
{
  Big_integer denominator = 1;
  std::vector<const Monomial*> monomials;
  std::vector<Big_integer> coefficients;
  double words = 0;   // of the largest coefficient

  Integer_form(const Polynomial_terms& terms, Expansion_budget& budget);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Integer_form::Integer_form(const Polynomial_terms& terms, Expansion_budget& budget)
{
  for (const auto& [monomial, coefficient] : terms) {
    const Big_integer d = denominator_of(coefficient);
    if (d == 1)
      continue;
    budget.spend(arithmetic_work(bit_length(denominator) / 64.0, bit_length(d) / 64.0));
    denominator = lcm(denominator, d);
    check_coefficient_bits(bit_length(denominator));
  }
  budget.spend(static_cast<double>(terms.size()) * (1 + bit_length(denominator) / 64.0));
  for (const auto& [monomial, coefficient] : terms) {
    monomials.push_back(&monomial);
    coefficients.push_back(numerator_of(coefficient) * (denominator / denominator_of(coefficient)));
    words = (std::max)(words, bit_length(coefficients.back()) / 64.0);
  }
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_FORM_H
