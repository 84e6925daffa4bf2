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
#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The irreducible factors of a polynomial modulo an odd prime that has no multiple ones, with leading coefficients one:
first those of each degree together, which divide x^(p^k) - x, then apart, by powers of random polynomials that are 1
modulo half of them (Cantor and Zassenhaus 1981).
*/
class Prime_field_factors
{
  using Polynomial = Prime_residues::Polynomial;

  Prime_residues m_field;
  Interruption& m_interruption;
  std::mt19937 m_random{20230601}; // the same for all, so that answers are

public:
  Prime_field_factors(const Prime_residues& field, Interruption& interruption)
    : m_field(field), m_interruption(interruption)
  {}

  // \pre The leading coefficient is one.
  std::vector<Polynomial> operator()(Polynomial f)
  {
    std::vector<Polynomial> result;
    const Polynomial x{0, 1};
    Polynomial power = m_field.remainder(x, f);
    for (std::size_t degree = 1; 2 * degree < f.size(); ++degree) {
      power = power_modulo(power, Big_integer(m_field.prime()), f);
      Polynomial difference = power;
      m_field.add_multiple(difference, x, m_field.prime() - 1);
      const Polynomial factors = m_field.common_divisor(f, difference);
      if (factors.size() > 1) {
        split(factors, degree, result);
        f = m_field.divide(f, factors);
        power = m_field.remainder(std::move(power), f);
      }
    }
    if (f.size() > 1)
      result.push_back(std::move(f));
    return result;
  }

private:
  Polynomial power_modulo(const Polynomial& base, const Big_integer& exponent, const Polynomial& modulus)
  {
    Polynomial result{1};
    for (auto bit = static_cast<std::size_t>(bit_length(exponent)); bit-- > 0;) {
      result = m_field.remainder(m_field.product(result, result), modulus);
      if (mpz_tstbit(exponent.backend().data(), bit))
        result = m_field.remainder(m_field.product(result, base), modulus);
      m_interruption.add_work(4 * modulus.size() * modulus.size());
    }
    return result;
  }

  // A product of factors of one degree.
  void split(const Polynomial& product, std::size_t degree, std::vector<Polynomial>& result)
  {
    if (product.size() == degree + 1) {
      result.push_back(product);
      return;
    }
    Big_integer exponent(1);
    for (std::size_t k = 0; k < degree; ++k)
      exponent *= m_field.prime();
    exponent /= 2;
    for (;;) {
      Polynomial base(product.size() - 1);
      for (auto& coefficient : base)
        coefficient = m_random() % m_field.prime();
      base.back() = 1;
      Polynomial power = power_modulo(base, exponent, product);
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
