// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_EXPANSION_BUDGET_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_EXPANSION_BUDGET_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
How much work expansions may still cost, in units of about one small product of two terms. Exact arithmetic on data from
outside needs such a limit: `((x+y)^99)^99` is short to write.
*/
class Expansion_budget
{
  double m_left;

public:
  explicit Expansion_budget(double amount) : m_left(amount) {}

  void spend(double amount);
};

// The size of a coefficient in machine words, numerator and denominator together.
inline double size_in_words(const Exact_rational& value)
{
  return static_cast<double>(bit_length(numerator_of(value)) + bit_length(denominator_of(value))) / 64;
}

// The work of an operation on coefficients of these sizes (in words), as schoolbook arithmetic costs it.
inline double arithmetic_work(double words_a, double words_b) { return 1 + words_a * words_b / 64; }

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Expansion_budget::spend(double amount)
{
  m_left -= amount;
  if (m_left < 0)
    throw Invalid_input("Power_polynomial: the expression takes too much work to expand");
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_EXPANSION_BUDGET_H
