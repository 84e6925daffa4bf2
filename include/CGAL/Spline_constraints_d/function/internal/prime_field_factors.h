// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_PRIME_FIELD_FACTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_PRIME_FIELD_FACTORS_H

#include <CGAL/Spline_constraints_d/function/internal/Interruption.h>
#include <CGAL/Spline_constraints_d/function/internal/modular_common_divisor.h>

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The irreducible factors of a polynomial modulo an odd prime p that has no multiple ones, with leading coefficients one:
first those of each degree k together, which divide x^(p^k) - x, then apart, by powers of random polynomials that are 1
modulo half of them (Cantor and Zassenhaus 1981). The p-th power of a polynomial is a linear map of its coefficients.
*/
class Prime_field_factors
{
  using Polynomial = Prime_residues::Polynomial;

  Prime_residues m_field;
  Interruption& m_interruption;
  Polynomial m_polynomial;
  std::vector<Polynomial> m_powers; // 1, x^p, x^2p, ... modulo the polynomial
  std::mt19937 m_random{20230601};  // the same for all, so that answers are

public:
  // \pre The leading coefficient is one, the degree not zero.
  Prime_field_factors(const Prime_residues& field, Polynomial f, Interruption& interruption)
    : m_field(field), m_interruption(interruption), m_polynomial(std::move(f)), m_powers(1, Polynomial{1})
  {
    const Polynomial power = power_modulo(m_field.remainder({0, 1}, m_polynomial), m_field.prime());
    while (m_powers.size() + 1 < m_polynomial.size())
      m_powers.push_back(product_modulo(m_powers.back(), power));
  }

  std::vector<Polynomial> operator()()
  {
    std::vector<Polynomial> result;
    Polynomial rest = m_polynomial, power = m_field.remainder({0, 1}, m_polynomial);
    for (std::size_t degree = 1; 2 * degree < rest.size(); ++degree) {
      power = power_with_prime(power);
      Polynomial difference = power;
      m_field.add_multiple(difference, {0, 1}, m_field.prime() - 1);
      const Polynomial factors = m_field.common_divisor(rest, difference);
      if (factors.size() > 1) {
        split(factors, degree, result);
        rest = m_field.divide(rest, factors);
      }
    }
    if (rest.size() > 1)
      result.push_back(std::move(rest));
    return result;
  }

private:
  Polynomial product_modulo(const Polynomial& a, const Polynomial& b)
  {
    m_interruption.add_work(2 * m_polynomial.size() * m_polynomial.size());
    return m_field.remainder(m_field.product(a, b), m_polynomial);
  }

  Polynomial power_modulo(const Polynomial& base, Prime_residues::Number exponent)
  {
    Polynomial result{1}, square = base;
    for (; exponent != 0; exponent >>= 1) {
      if (exponent & 1)
        result = product_modulo(result, square);
      if (exponent > 1)
        square = product_modulo(square, square);
    }
    return result;
  }

  // f^p = f(x^p)
  Polynomial power_with_prime(const Polynomial& f)
  {
    m_interruption.add_work(m_polynomial.size() * m_polynomial.size());
    Polynomial result;
    for (std::size_t i = 0; i < f.size(); ++i)
      m_field.add_multiple(result, m_powers[i], f[i]);
    return result;
  }

  // A product of factors of one degree k. A random polynomial has the power (p^k - 1) / 2 = (1 + p + ... + p^(k-1))
  // (p - 1) / 2 that is 1 or -1 modulo each of them.
  void split(const Polynomial& product, std::size_t degree, std::vector<Polynomial>& result)
  {
    if (product.size() == degree + 1) {
      result.push_back(product);
      return;
    }
    for (;;) {
      Polynomial base(product.size() - 1);
      for (auto& coefficient : base)
        coefficient = m_random() % m_field.prime();
      base.back() = 1;
      Polynomial norm = base;
      for (std::size_t k = 1; k < degree; ++k) {
        base = power_with_prime(base);
        norm = product_modulo(norm, base);
      }
      Polynomial power = power_modulo(norm, m_field.prime() / 2);
      m_field.add_multiple(power, Polynomial{1}, m_field.prime() - 1);
      const Polynomial part = m_field.common_divisor(product, power);
      if (part.size() > 1 && part.size() < product.size()) {
        split(part, degree, result);
        Polynomial dividend = product;
        split(m_field.divide(dividend, part), degree, result);
        return;
      }
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_PRIME_FIELD_FACTORS_H
