// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_EXPANSION_LIMITS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_EXPANSION_LIMITS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What a Power_polynomial may hold: see there.
constexpr std::size_t maximal_number_of_terms = std::size_t(1) << 20;
constexpr int maximal_degree = 10000;
constexpr long maximal_coefficient_bits = 1L << 16;

void check_number_of_terms(std::size_t size);

void check_degree(long long degree);

void check_coefficient_bits(long bits);

void check_coefficient(const Exact_rational& value);

// A power, by repeated squaring, with every number on the way within the limits.
Exact_rational power_of_number(Exact_rational base, int exponent);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void check_number_of_terms(std::size_t size)
{
  if (size > maximal_number_of_terms)
    throw Invalid_input("Power_polynomial: more than " + std::to_string(maximal_number_of_terms) + " terms");
}

CGAL_SPLINE_CONSTRAINTS_INLINE void check_degree(long long degree)
{
  if (degree > maximal_degree)
    throw Invalid_input("Power_polynomial: the total degree exceeds " + std::to_string(maximal_degree));
}

CGAL_SPLINE_CONSTRAINTS_INLINE void check_coefficient_bits(long bits)
{
  if (bits > maximal_coefficient_bits)
    throw Invalid_input("Power_polynomial: a coefficient of more than " + std::to_string(maximal_coefficient_bits) +
                        " bits");
}

CGAL_SPLINE_CONSTRAINTS_INLINE void check_coefficient(const Exact_rational& value)
{
  check_coefficient_bits(bit_length(numerator_of(value)));
  check_coefficient_bits(bit_length(denominator_of(value)));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational power_of_number(Exact_rational base, int exponent)
{
  Exact_rational result(1);
  for (; exponent > 0; exponent >>= 1) {
    if (exponent & 1) {
      result *= base;
      check_coefficient(result);
    }
    if (exponent > 1) {
      base *= base;
      check_coefficient(base);
    }
  }
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_EXPANSION_LIMITS_H
