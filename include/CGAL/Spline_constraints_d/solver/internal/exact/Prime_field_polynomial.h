// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_PRIME_FIELD_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_PRIME_FIELD_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A polynomial in one unknown over the integers modulo a prime: it tells in no time what exact numbers will find, or
// most probably not.
class Prime_field_polynomial
{
public:
  using Number = std::uint64_t;   // below the prime
  static constexpr Number prime = 0x7fffffff;

private:
  std::vector<Number> m_coefficients;   // from the constant one to the leading one, which is not zero; none: it is zero

  explicit Prime_field_polynomial(std::vector<Number> coefficients) : m_coefficients(std::move(coefficients))
  {
    while (!m_coefficients.empty() && m_coefficients.back() == 0)
      m_coefficients.pop_back();
  }

public:
  // With these values at 0, 1, 2, ...: Newton's divided differences.
  static Prime_field_polynomial interpolation(std::vector<Number> values)
  {
    const std::size_t n = values.size();
    for (std::size_t k = 1; k < n; ++k)
      for (std::size_t i = n; i-- > k;)
        values[i] = difference(values[i], values[i - 1]) * inverse(k) % prime;
    std::vector<Number> result;
    for (std::size_t i = n; i-- > 0;) {   // times x - i, plus the next one
      result.insert(result.begin(), 0);
      for (std::size_t j = 0; j + 1 < result.size(); ++j)
        result[j] = difference(result[j], result[j + 1] * i % prime);
      result.front() = (result.front() + values[i]) % prime;
    }
    return Prime_field_polynomial(std::move(result));
  }

  static Number inverse(Number a) { return power(a, prime - 2); }
  static Number difference(Number a, Number b) { return (a + prime - b) % prime; }

  static Number power(Number a, Number exponent)
  {
    Number result = 1;
    for (; exponent != 0; exponent >>= 1, a = a * a % prime)
      if (exponent & 1)
        result = result * a % prime;
    return result;
  }

  // Of a rational number whose denominator the prime does not divide.
  static Number residue(const Exact_rational& x)
  {
    return mpz_fdiv_ui(numerator_of(x).backend().data(), prime) *
        inverse(mpz_fdiv_ui(denominator_of(x).backend().data(), prime)) % prime;
  }

  bool is_zero() const { return m_coefficients.empty(); }
  std::size_t degree() const { return m_coefficients.empty() ? 0 : m_coefficients.size() - 1; }

  Prime_field_polynomial derivative() const
  {
    std::vector<Number> result;
    for (std::size_t i = 1; i < m_coefficients.size(); ++i)
      result.push_back(m_coefficients[i] * i % prime);
    return Prime_field_polynomial(std::move(result));
  }

  // By Euclid's algorithm.
  bool has_common_zero(Prime_field_polynomial other) const
  {
    Prime_field_polynomial a = *this;
    while (!other.is_zero())
      a = std::exchange(other, a.remainder(other));
    return a.degree() > 0 || a.is_zero();
  }

  Number resultant(Prime_field_polynomial other) const
  {
    Prime_field_polynomial a = *this;
    Number result = 1;
    while (!other.is_zero() && other.degree() > 0) {
      const std::size_t n = a.degree(), m = other.degree();
      const Number leading = other.m_coefficients.back();
      a = std::exchange(other, a.remainder(other));
      result = result * power(leading, n - other.degree()) % prime;
      if (n % 2 == 1 && m % 2 == 1)
        result = difference(0, result);
    }
    return other.is_zero() ? 0 : result * power(other.m_coefficients.back(), a.degree()) % prime;
  }

private:
  Prime_field_polynomial remainder(const Prime_field_polynomial& divisor) const
  {
    const Number factor = inverse(divisor.m_coefficients.back());
    const std::size_t n = divisor.degree();
    std::vector<Number> rest = m_coefficients;
    for (std::size_t k = rest.size(); k-- > n;) {
      const Number multiple = rest[k] * factor % prime;
      for (std::size_t j = 0; j <= n; ++j)
        rest[k - n + j] = difference(rest[k - n + j], divisor.m_coefficients[j] * multiple % prime);
    }
    return Prime_field_polynomial(std::move(rest));
  }
};

/*
Whether two surfaces seem to touch along a curve: then two curves in which some plane cuts them have multiple
intersections, and so the resultant of their equations has multiple zeros. Complex curves count as well. It may be wrong
about what it sees by chance, and serves to save work only. Surfaces of high degrees are not looked at.
*/
inline bool seem_to_touch_along_curves(const std::array<Power_polynomial, 2>& surfaces)
{
  using Field = Prime_field_polynomial;
  const std::size_t m = static_cast<std::size_t>(surfaces[0].total_degree()),
                    n = static_cast<std::size_t>(surfaces[1].total_degree());
  constexpr std::size_t most = 64;
  if (m * n > most)
    return false;
  // a point and two directions
  constexpr std::array<std::array<Field::Number, 3>, 3> plane{{{271, 1828, 459}, {314, 159, 2653}, {577, 2156, 649}}};
  const auto coefficient_residues = [&](const Power_polynomial& f) {
    std::vector<std::pair<Monomial, Field::Number>> result;
    for (const auto& [monomial, coefficient] : f.terms())
      result.emplace_back(monomial, Field::residue(coefficient));
    return result;
  };
  const std::array terms{coefficient_residues(surfaces[0]), coefficient_residues(surfaces[1])};
  const auto on_line = [&](std::size_t surface, std::size_t y) {
    std::vector<Field::Number> values;
    for (std::size_t x = 0; x <= (surface == 0 ? m : n); ++x) {
      Field::Number sum = 0;
      for (const auto& [monomial, coefficient] : terms[surface]) {
        Field::Number term = coefficient;
        for (const auto& [unknown, exponent] : monomial.powers)
          for (int k = 0; k < exponent; ++k)
            term = term * (plane[0][unknown] + x * plane[1][unknown] + y * plane[2][unknown]) % Field::prime;
        sum = (sum + term) % Field::prime;
      }
      values.push_back(sum);
    }
    return Field::interpolation(std::move(values));
  };
  std::vector<Field::Number> resultants;
  for (std::size_t y = 0; y <= m * n; ++y)
    resultants.push_back(on_line(0, y).resultant(on_line(1, y)));
  const Field resultant = Field::interpolation(std::move(resultants));
  return resultant.degree() > 1 && resultant.has_common_zero(resultant.derivative());
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_PRIME_FIELD_POLYNOMIAL_H
