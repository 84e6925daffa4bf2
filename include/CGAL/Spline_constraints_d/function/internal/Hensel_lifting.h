// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_HENSEL_LIFTING_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_HENSEL_LIFTING_H

#include <CGAL/Spline_constraints_d/function/internal/Integer_coefficients.h>
#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/modular_common_divisor.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Factors of a polynomial modulo a prime as such ones modulo a power of it: the polynomial is cut into two factors, again
and again, and each two are lifted together with the coefficients of Bezout's identity, so that each step squares the
modulus (Zassenhaus 1969; von zur Gathen and Gerhard, Modern Computer Algebra, 15.4 and 15.5).
*/
class Hensel_lifting
{
  using Polynomial = Prime_residues::Polynomial;

  Prime_residues m_field;
  Interruption& m_interruption;
  std::vector<Big_integer> m_moduli; // the prime and its powers, each the square of the one before

public:
  Hensel_lifting(const Prime_residues& field, const Big_integer& least_modulus, Interruption& interruption)
    : m_field(field), m_interruption(interruption), m_moduli(1, Big_integer(field.prime()))
  {
    while (m_moduli.back() < least_modulus)
      m_moduli.push_back(m_moduli.back() * m_moduli.back());
  }

  const Big_integer& modulus() const { return m_moduli.back(); }

  // With the leading coefficients one, in the order of the given ones, whose product is a multiple of the polynomial.
  std::vector<Integer_coefficients> operator()(const Integer_coefficients& f, std::span<const Polynomial> factors) const
  {
    std::vector<Integer_coefficients> result;
    lift(f, factors, result);
    return result;
  }

private:
  void lift(const Integer_coefficients& f, std::span<const Polynomial> factors,
            std::vector<Integer_coefficients>& result) const
  {
    if (factors.size() == 1) {
      Big_integer inverse;
      mpz_invert(inverse.backend().data(), f.back().backend().data(), modulus().backend().data());
      Integer_coefficients monic;
      add_multiple(monic, f, inverse);
      result.push_back(reduced(std::move(monic), modulus()));
      return;
    }
    const auto first = factors.first(factors.size() / 2), second = factors.subspan(factors.size() / 2);
    const auto [g, h] = lifted_pair(f, product_of_all(first), product_of_all(second));
    lift(g, first, result);
    lift(h, second, result);
  }

  // f = g h, where h has the leading coefficient one.
  std::pair<Integer_coefficients, Integer_coefficients> lifted_pair(const Integer_coefficients& f, Polynomial first,
                                                                    const Polynomial& second) const
  {
    const Prime_residues::Number leading = m_field.of(f.back());
    for (Prime_residues::Number& x : first)
      x = x * leading % m_field.prime();
    const auto [u, v] = bezout(first, second);
    Integer_coefficients g = of(first), h = of(second), s = of(u), t = of(v);
    for (std::size_t k = 1; k < m_moduli.size(); ++k) {
      const Big_integer& modulus = m_moduli[k];
      m_interruption.add_work(16 * f.size() * f.size() * (1 + static_cast<std::size_t>(bit_length(modulus)) / 64));
      Integer_coefficients error = f; // f - g h
      add_signed_product(error, g, h, -1);
      error = reduced(std::move(error), modulus);
      Integer_coefficients rest = reduced(product_of(s, error), modulus);
      const Integer_coefficients quotient = divide(rest, h, modulus);
      add_signed_product(g, t, error, 1);
      add_signed_product(g, quotient, Integer_coefficients(g), 1);
      g = reduced(std::move(g), modulus);
      add_multiple(h, rest, Big_integer(1));
      h = reduced(std::move(h), modulus);

      Integer_coefficients excess(1, Big_integer(-1)); // s g + t h - 1
      add_signed_product(excess, s, g, 1);
      add_signed_product(excess, t, h, 1);
      excess = reduced(std::move(excess), modulus);
      rest = reduced(product_of(s, excess), modulus);
      const Integer_coefficients multiple = divide(rest, h, modulus);
      add_multiple(s, rest, Big_integer(-1));
      s = reduced(std::move(s), modulus);
      add_signed_product(t, Integer_coefficients(t), excess, -1);
      add_signed_product(t, multiple, g, -1);
      t = reduced(std::move(t), modulus);
    }
    return {std::move(g), std::move(h)};
  }

  Polynomial product_of_all(std::span<const Polynomial> factors) const
  {
    Polynomial result{1};
    for (const Polynomial& f : factors)
      result = m_field.product(result, f);
    return result;
  }

  // s and t with s a + t b = 1. \pre a and b have no common divisor.
  std::pair<Polynomial, Polynomial> bezout(Polynomial a, Polynomial b) const
  {
    Polynomial s0{1}, s1, t0, t1{1};
    while (!b.empty()) {
      const Polynomial quotient = m_field.divide(a, b);
      m_field.add_multiple(s0, m_field.product(quotient, s1), m_field.prime() - 1);
      m_field.add_multiple(t0, m_field.product(quotient, t1), m_field.prime() - 1);
      std::swap(a, b);
      std::swap(s0, s1);
      std::swap(t0, t1);
    }
    const Prime_residues::Number factor = m_field.inverse(a.back());
    for (Polynomial* const f : {&s0, &t0})
      for (Prime_residues::Number& x : *f)
        x = x * factor % m_field.prime();
    return {std::move(s0), std::move(t0)};
  }

  static Integer_coefficients of(const Polynomial& f) { return Integer_coefficients(f.begin(), f.end()); }

  static Integer_coefficients reduced(Integer_coefficients f, const Big_integer& modulus)
  {
    for (Big_integer& x : f)
      mpz_fdiv_r(x.backend().data(), x.backend().data(), modulus.backend().data());
    return trimmed(std::move(f));
  }

  // The quotient; what remains takes the place of the dividend. \pre The divisor has the leading coefficient one.
  static Integer_coefficients divide(Integer_coefficients& a, const Integer_coefficients& divisor,
                                     const Big_integer& modulus)
  {
    const std::size_t size = divisor.size();
    Integer_coefficients quotient(a.size() < size ? 0 : a.size() + 1 - size);
    for (std::size_t k = quotient.size(); k-- > 0;) {
      Big_integer& leading = a[k + size - 1];
      mpz_fdiv_r(leading.backend().data(), leading.backend().data(), modulus.backend().data());
      quotient[k] = leading;
      for (std::size_t j = 0; j < size; ++j)
        mpz_submul(a[k + j].backend().data(), quotient[k].backend().data(), divisor[j].backend().data());
    }
    a = reduced(std::move(a), modulus);
    return quotient;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_HENSEL_LIFTING_H
