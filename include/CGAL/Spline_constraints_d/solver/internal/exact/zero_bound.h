// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_ZERO_BOUND_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_ZERO_BOUND_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Bounds on the total degree of an integer polynomial and on the sum of its absolute coefficients, 2^bits.
struct Polynomial_size
{
  int degree = 0;
  double bits = 0;
};

inline Polynomial_size larger(const Polynomial_size& a, const Polynomial_size& b)
{
  return {(std::max)(a.degree, b.degree), (std::max)(a.bits, b.bits)};
}

inline Polynomial_size size_of(const Power_polynomial& polynomial)
{
  long longest = 0;
  for (const auto& term : polynomial.terms())
    longest = (std::max)(longest, bit_length(numerator_of(term.second)));
  return {polynomial.total_degree(),
          static_cast<double>(longest) + std::log2(static_cast<double>(polynomial.terms().size()) + 1)};
}

// The multiple of a polynomial by a positive number that has coprime integer coefficients; nothing when they are so
// long that polynomials refuse them, or near that.
inline std::optional<Power_polynomial> with_integer_coefficients(const Power_polynomial& polynomial)
{
  Big_integer denominator = 1, content = 0;
  long longest = 0;
  for (const auto& term : polynomial.terms()) {
    extend_common_denominator(denominator, term.second);
    longest = (std::max)(longest, bit_length(numerator_of(term.second)));
  }
  if (polynomial.is_zero() || longest + bit_length(denominator) > Power_polynomial::maximal_coefficient_bits / 2)
    return polynomial.is_zero() ? std::optional(polynomial) : std::nullopt;
  for (const auto& term : polynomial.terms())
    content = gcd(content, numerator_over(term.second, denominator));
  return polynomial * Power_polynomial(quotient(denominator, content));
}

/*
A polynomial with integer coefficients that is not zero at an isolated point of the real zeros of others is larger than
2^-bits there:
  |g| >= (2^(4 - n/2) H d^n)^(-n 2^n d^n),   H >= 2 n + 2 m,
for m polynomials in n >= 2 unknowns, all of at most the even degree d and with coefficients up to H (Jeronimo,
Perrucci, Tsigaridas, On the minimum of a polynomial function on a basic closed semialgebraic set and applications, SIAM
J. Optim. 23, 2013, Theorem 1, for the component that is the point).
*/
inline double zero_bound_bits(std::size_t dimension, const Polynomial_size& size)
{
  const double n = static_cast<double>((std::max)(dimension, std::size_t(2))),
               degree = 2 * std::ceil((std::max)(size.degree, 1) / 2.0);
  const double height = (std::max)(size.bits, std::log2(4 * n));
  return n * std::exp2(n) * std::pow(degree, n) * ((std::max)(4 - n / 2, 0.0) + height + n * std::log2(degree));
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_ZERO_BOUND_H
