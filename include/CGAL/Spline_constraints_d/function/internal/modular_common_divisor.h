// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_MODULAR_COMMON_DIVISOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_MODULAR_COMMON_DIVISOR_H

#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The integers modulo a prime below 2^31, and polynomials over them: their coefficients, the constant one first, and no
// zeros at the end.
class Prime_residues
{
public:
  using Number = std::uint64_t;
  using Polynomial = std::vector<Number>;

private:
  Number m_prime;

public:
  explicit Prime_residues(Number prime) : m_prime(prime) {}

  // The greatest prime below an odd number: the test of Miller and Rabin with these bases errs nowhere below 2^31.
  static Number prime_below(Number n)
  {
    const auto is_prime = [](Number candidate) {
      const Prime_residues residues(candidate);
      Number odd = candidate - 1;
      int twos = 0;
      for (; odd % 2 == 0; odd /= 2)
        ++twos;
      for (const Number base : {2, 3, 5, 7}) {
        Number x = residues.power(base, odd);
        bool is_witness = x != 1 && x != candidate - 1;
        for (int i = 1; i < twos && is_witness; ++i) {
          x = x * x % candidate;
          is_witness = x != candidate - 1;
        }
        if (is_witness)
          return false;
      }
      return true;
    };
    do
      n -= 2;
    while (!is_prime(n));
    return n;
  }

  Number prime() const { return m_prime; }

  Number power(Number a, Number exponent) const
  {
    Number result = 1;
    for (a %= m_prime; exponent != 0; exponent >>= 1, a = a * a % m_prime)
      if (exponent & 1)
        result = result * a % m_prime;
    return result;
  }

  Number inverse(Number a) const { return power(a, m_prime - 2); }
  Number of(const Big_integer& x) const { return mpz_fdiv_ui(x.backend().data(), m_prime); }

  Polynomial of(const std::vector<Big_integer>& coefficients) const
  {
    Polynomial result;
    for (const Big_integer& c : coefficients)
      result.push_back(of(c));
    return trimmed(std::move(result));
  }

  Polynomial product(const Polynomial& a, const Polynomial& b) const
  {
    Polynomial result(a.empty() || b.empty() ? 0 : a.size() + b.size() - 1, 0);
    for (std::size_t i = 0; i < a.size(); ++i) {
      add_row(result.data() + i, b, a[i]);
      if (!is_short())
        reduce(result.data() + i, b.size());
    }
    if (is_short())
      reduce(result.data(), result.size());
    return result;
  }

  // sum += factor a
  void add_multiple(Polynomial& sum, const Polynomial& a, Number factor) const
  {
    sum.resize((std::max)(sum.size(), a.size()), 0);
    for (std::size_t i = 0; i < a.size(); ++i)
      sum[i] = (sum[i] + a[i] * factor) % m_prime;
    sum = trimmed(std::move(sum));
  }

  // The quotient; what remains takes the place of the dividend. \pre The divisor is not zero.
  Polynomial divide(Polynomial& a, const Polynomial& divisor) const
  {
    const std::size_t size = divisor.size();
    const Number factor = inverse(divisor.back());
    Polynomial quotient(a.size() < size ? 0 : a.size() + 1 - size);
    for (std::size_t k = quotient.size(); k-- > 0;) {
      quotient[k] = a[k + size - 1] % m_prime * factor % m_prime;
      add_row(a.data() + k, divisor, m_prime - quotient[k]);
      if (!is_short())
        reduce(a.data() + k, size);
    }
    if (is_short())
      reduce(a.data(), a.size());
    a = trimmed(std::move(a));
    return quotient;
  }

  Polynomial remainder(Polynomial a, const Polynomial& divisor) const
  {
    divide(a, divisor);
    return a;
  }

  Polynomial derivative(const Polynomial& f) const
  {
    Polynomial result;
    for (std::size_t k = 1; k < f.size(); ++k)
      result.push_back(f[k] * k % m_prime);
    return trimmed(std::move(result));
  }

  // With the leading coefficient one, by Euclid's algorithm. \pre One of them is not zero.
  Polynomial common_divisor(Polynomial a, Polynomial b) const
  {
    while (!b.empty()) {
      divide(a, b);
      std::swap(a, b);
    }
    return monic(std::move(a));
  }

  // \pre not zero
  Polynomial monic(Polynomial f) const
  {
    const Number factor = inverse(f.back());
    for (Number& x : f)
      x = x * factor % m_prime;
    return f;
  }

private:
  // Whether sums of very many products stay below 2^64.
  bool is_short() const { return m_prime < (Number(1) << 16); }

  // sum += factor a, not reduced
  static void add_row(Number* sum, const Polynomial& a, Number factor)
  {
    for (std::size_t j = 0; j < a.size(); ++j)
      sum[j] += a[j] * factor;
  }

  void reduce(Number* numbers, std::size_t size) const
  {
    for (std::size_t j = 0; j < size; ++j)
      numbers[j] %= m_prime;
  }

  static Polynomial trimmed(Polynomial f)
  {
    while (!f.empty() && f.back() == 0)
      f.pop_back();
    return f;
  }
};

// The fraction n/d with |n|, |d| below the root of half the modulus that is a residue, if there is one, as (n, d): a
// step of Euclid's algorithm (Wang 1981).
inline std::optional<std::pair<Big_integer, Big_integer>> fraction_of_residue(const Big_integer& residue,
                                                                              const Big_integer& modulus)
{
  Big_integer bound;
  mpz_sqrt(bound.backend().data(), Big_integer(modulus / 2).backend().data());
  Big_integer r0 = modulus, r1 = residue, t0(0), t1(1);
  while (r1 > bound) {
    const Big_integer q = r0 / r1;
    r0 = std::exchange(r1, Big_integer(r0 - q * r1));
    t0 = std::exchange(t1, Big_integer(t0 - q * t1));
  }
  if (t1 == 0 || abs(t1) > bound)
    return std::nullopt;
  return t1 < 0 ? std::pair(Big_integer(-r1), Big_integer(-t1)) : std::pair(r1, t1);
}

// The quotient of two polynomials, if it has integer coefficients. \pre The divisor is not zero.
inline std::optional<std::vector<Big_integer>> exact_quotient(std::vector<Big_integer> a,
                                                              const std::vector<Big_integer>& divisor)
{
  const std::size_t size = divisor.size();
  if (a.size() < size)
    return std::all_of(a.begin(), a.end(), [](const Big_integer& x) { return x == 0; })
        ? std::optional(std::vector<Big_integer>())
        : std::nullopt;
  std::vector<Big_integer> result(a.size() - size + 1);
  for (std::size_t k = result.size(); k-- > 0;) {
    Big_integer& leading = a[k + size - 1];
    if (!mpz_divisible_p(leading.backend().data(), divisor.back().backend().data()))
      return std::nullopt;
    mpz_divexact(result[k].backend().data(), leading.backend().data(), divisor.back().backend().data());
    for (std::size_t j = 0; j < size; ++j)
      mpz_submul(a[k + j].backend().data(), result[k].backend().data(), divisor[j].backend().data());
  }
  if (std::any_of(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(size - 1),
                  [](const Big_integer& x) { return x != 0; }))
    return std::nullopt;
  return result;
}

// Without the common divisor of the coefficients.
inline std::vector<Big_integer> primitive_part(std::vector<Big_integer> f)
{
  Big_integer content(0);
  for (const Big_integer& x : f)
    content = gcd(content, x);
  if (content > 1)
    for (Big_integer& x : f)
      mpz_divexact(x.backend().data(), x.backend().data(), content.backend().data());
  return f;
}

/*
The primitive greatest common divisor of two polynomials that are not zero, from those modulo primes: its degree is at
most theirs, where the prime does not divide the leading coefficients, and a common divisor of the least such degree is
the greatest one. It takes as many primes as its own coefficients need, however long those of the polynomials are;
nothing if these are too many.
*/
inline std::optional<std::vector<Big_integer>> modular_common_divisor(const std::vector<Big_integer>& a,
                                                                      const std::vector<Big_integer>& b)
{
  constexpr std::size_t most_primes = 256;
  std::vector<Big_integer> residues; // of the divisor with the leading coefficient one
  Big_integer modulus(1);
  Prime_residues::Number prime = 0x7fffffff;
  for (std::size_t count = 0; count < most_primes; prime = Prime_residues::prime_below(prime)) {
    const Prime_residues field(prime);
    if (field.of(a.back()) == 0 || field.of(b.back()) == 0)
      continue;
    const Prime_residues::Polynomial divisor = field.common_divisor(field.of(a), field.of(b));
    if (divisor.size() == 1)
      return std::vector<Big_integer>(1, Big_integer(1));
    if (count != 0 && divisor.size() > residues.size())
      continue;
    if (divisor.size() < residues.size())
      count = 0;
    if (count == 0) {
      residues.assign(divisor.size(), Big_integer(0));
      modulus = 1;
    }
    const Prime_residues::Number inverse = field.inverse(field.of(modulus));
    for (std::size_t i = 0; i < divisor.size(); ++i) // the Chinese remainder theorem
      residues[i] += modulus * Big_integer((divisor[i] + prime - field.of(residues[i])) * inverse % prime);
    modulus *= prime;
    if (++count; (count & (count - 1)) != 0) // 1, 2, 4, ...
      continue;
    std::vector<std::pair<Big_integer, Big_integer>> fractions;
    Big_integer denominator(1);
    for (const Big_integer& residue : residues) { // most have the denominator of those before them
      const auto fraction = fraction_of_residue(Big_integer(residue * denominator % modulus), modulus);
      if (!fraction)
        break;
      denominator *= fraction->second;
      fractions.emplace_back(fraction->first, denominator);
    }
    if (fractions.size() < residues.size())
      continue;
    std::vector<Big_integer> candidate;
    for (const auto& [n, d] : fractions)
      candidate.push_back(Big_integer(n * (denominator / d)));
    candidate = primitive_part(std::move(candidate));
    if (exact_quotient(a, candidate) && exact_quotient(b, candidate))
      return candidate;
  }
  return std::nullopt;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_MODULAR_COMMON_DIVISOR_H
