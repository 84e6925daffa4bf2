// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_COEFFICIENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_COEFFICIENTS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A polynomial in one unknown by its coefficients in powers, the constant one first. There may be zeros at the end.
using Integer_coefficients = std::vector<Big_integer>;

// sum += factor a
void add_multiple(Integer_coefficients& sum, const Integer_coefficients& a, const Big_integer& factor);

// sum += sign a b
void add_signed_product(Integer_coefficients& sum, const Integer_coefficients& a, const Integer_coefficients& b,
                        int sign);

// Without zeros at the end.
Integer_coefficients trimmed(Integer_coefficients f);

Integer_coefficients product_of(const Integer_coefficients& a, const Integer_coefficients& b);

// The first `count` powers of a polynomial.
std::vector<Integer_coefficients> powers_of(const Integer_coefficients& f, std::size_t count);

Integer_coefficients derivative_of(const Integer_coefficients& f);

// a' b - a b', the numerator of the derivative of a/b.
Integer_coefficients numerator_of_derivative(const Integer_coefficients& a, const Integer_coefficients& b);

// The value at p/q, times q^n where the degree is taken to be n: at q = 0, the coefficient of that power.
Big_integer homogeneous_value(const Integer_coefficients& f, std::size_t n, const Big_integer& p, const Big_integer& q);

// Divides polynomials by what all their coefficients have in common.
void divide_by_common_content(std::vector<Integer_coefficients>& polynomials);

// Rational polynomials in one unknown, times the least positive number that makes all coefficients integers.
std::vector<Integer_coefficients> with_integers(const std::vector<std::vector<Exact_rational>>& polynomials);

// The coefficients of a polynomial in one unknown, whichever it is. \throws Invalid_input when there are more.
std::vector<Exact_rational> coefficients_in_one_unknown(const Power_polynomial& f, const std::string& who);

// As a polynomial in this unknown.
Power_polynomial polynomial_in(int unknown, const Integer_coefficients& f);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void add_multiple(Integer_coefficients& sum, const Integer_coefficients& a,
                                                 const Big_integer& factor)
{
  if (factor == 0)
    return;
  if (sum.size() < a.size())
    sum.resize(a.size(), Big_integer(0));
  for (std::size_t i = 0; i < a.size(); ++i)
    add_product(sum[i], a[i], factor);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void add_signed_product(Integer_coefficients& sum, const Integer_coefficients& a,
                                                       const Integer_coefficients& b, int sign)
{
  if (a.empty() || b.empty())
    return;
  if (sum.size() < a.size() + b.size() - 1)
    sum.resize(a.size() + b.size() - 1, Big_integer(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Big_integer factor = sign < 0 ? Big_integer(-a[i]) : a[i];
    for (std::size_t j = 0; j < b.size(); ++j)
      add_product(sum[i + j], factor, b[j]);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_coefficients trimmed(Integer_coefficients f)
{
  while (!f.empty() && f.back() == 0)
    f.pop_back();
  return f;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_coefficients product_of(const Integer_coefficients& a,
                                                               const Integer_coefficients& b)
{
  Integer_coefficients result;
  add_signed_product(result, a, b, 1);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Integer_coefficients> powers_of(const Integer_coefficients& f,
                                                                           std::size_t count)
{
  std::vector<Integer_coefficients> result(1, Integer_coefficients(1, Big_integer(1)));
  while (result.size() < count)
    result.push_back(product_of(result.back(), f));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_coefficients derivative_of(const Integer_coefficients& f)
{
  Integer_coefficients result;
  for (std::size_t k = 1; k < f.size(); ++k)
    result.push_back(Big_integer(f[k] * static_cast<unsigned long>(k)));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_coefficients numerator_of_derivative(const Integer_coefficients& a,
                                                                            const Integer_coefficients& b)
{
  Integer_coefficients result = product_of(derivative_of(a), b);
  add_signed_product(result, a, derivative_of(b), -1);
  return trimmed(std::move(result));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Big_integer homogeneous_value(const Integer_coefficients& f, std::size_t n,
                                                             const Big_integer& p, const Big_integer& q)
{
  Big_integer sum(0), power(1);
  for (std::size_t k = n + 1; k-- > 0;) {
    sum *= p;
    if (k < f.size())
      add_product(sum, f[k], power);
    power *= q;
  }
  return sum;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void divide_by_common_content(std::vector<Integer_coefficients>& polynomials)
{
  Big_integer content(0);
  for (const Integer_coefficients& f : polynomials)
    for (const Big_integer& x : f)
      content = gcd(content, x);
  if (content > 1)
    for (Integer_coefficients& f : polynomials)
      for (Big_integer& x : f)
        mpz_divexact(x.backend().data(), x.backend().data(), content.backend().data());
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Integer_coefficients>
with_integers(const std::vector<std::vector<Exact_rational>>& polynomials)
{
  Big_integer denominator(1);
  for (const auto& f : polynomials)
    for (const Exact_rational& x : f)
      extend_common_denominator(denominator, x);
  std::vector<Integer_coefficients> result;
  for (const auto& f : polynomials) {
    Integer_coefficients& own = result.emplace_back();
    for (const Exact_rational& x : f)
      own.push_back(numerator_over(x, denominator));
    own = trimmed(std::move(own));
  }
  divide_by_common_content(result);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Exact_rational> coefficients_in_one_unknown(const Power_polynomial& f,
                                                                                       const std::string& who)
{
  const std::vector<int> unknowns = f.variables();
  if (unknowns.size() > 1)
    throw Invalid_input(who + ": a polynomial in " + std::to_string(unknowns.size()) + " unknowns, not in one");
  std::vector<Exact_rational> result(static_cast<std::size_t>(f.total_degree()) + 1, Exact_rational(0));
  for (const auto& [monomial, coefficient] : f.terms())
    result[static_cast<std::size_t>(monomial.total_degree())] = coefficient;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial polynomial_in(int unknown, const Integer_coefficients& f)
{
  Power_polynomial result;
  const Power_polynomial x = Power_polynomial::variable(unknown);
  for (std::size_t k = 0; k < f.size(); ++k)
    if (f[k] != 0)
      result += Power_polynomial(scaled_rational(f[k], 0)) * pow(x, static_cast<int>(k));
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_COEFFICIENTS_H
