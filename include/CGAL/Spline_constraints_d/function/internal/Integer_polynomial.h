// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/function/internal/modular_common_divisor.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/Polynomial.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

inline CGAL::Sign sign_of(const Big_integer& value) { return static_cast<CGAL::Sign>(value.sign()); }

/*
A polynomial in one unknown with integer coefficients, for the exact questions about its roots: signs at points,
Bernstein coefficients on an interval with dyadic ends, common divisors and square-free factors.
*/
class Integer_polynomial
{
  using Polynomial = CGAL::Polynomial<Exact_integer>;

  std::vector<Big_integer> m_coefficients; // in power form; the last one is not zero
  std::vector<Big_integer> m_weights;      // lcm_i C(d,i) / C(d,k)
  Big_integer m_denominator = 1;           // lcm_i C(d,i)

public:
  // The zero polynomial.
  Integer_polynomial() = default;

  explicit Integer_polynomial(std::vector<Big_integer> coefficients);

  bool is_zero() const { return m_coefficients.empty(); }

  // -1 for the zero polynomial.
  int degree() const { return static_cast<int>(m_coefficients.size()) - 1; }

  // In powers of the unknown, the constant one first; none of zero.
  const std::vector<Big_integer>& coefficients() const { return m_coefficients; }

  // \pre not zero
  const Big_integer& leading_coefficient() const { return m_coefficients.back(); }

  friend bool operator==(const Integer_polynomial& a, const Integer_polynomial& b)
  {
    return a.m_coefficients == b.m_coefficients;
  }

  friend Integer_polynomial operator*(const Integer_polynomial& a, const Integer_polynomial& b);

  Integer_polynomial derivative() const;

  // The value at a double, without error: an integer times a power of two. With what is needed on the way, so that one
  // can serve many calls.
  struct Value
  {
    Big_integer value;
    long exponent = 0;
    Big_integer mantissa, shifted;
  };

  const Value& at(double x, Value& result) const;

  CGAL::Sign sign_at(double x) const
  {
    Value value;
    return sign_of(at(x, value).value);
  }

  CGAL::Sign sign_at(const Exact_rational& x) const { return sign_of(numerator_at(x)); }

  // The value at p/q, times q^d.
  Big_integer numerator_at(const Exact_rational& x) const;

  // Divides by the greatest power of x - root, up to a positive constant factor; returns its exponent. \pre not zero
  int remove_root(const Exact_rational& root);

  // Bernstein coefficients: integers that are to be divided by `denominator` and multiplied by 2^exponent.
  struct Bernstein
  {
    std::vector<Big_integer> values;
    long exponent;
  };

  // On an interval with dyadic ends, without error.
  template <class Coordinate>
  Bernstein bernstein(const Coordinate& lower, const Coordinate& upper) const
  {
    const auto [begin, width, exponent] = common_dyadic(lower, upper);
    std::vector<Big_integer> a = m_coefficients;
    const int d = degree();
    for (int k = 0; k < d; ++k)
      shift_left(a[k], static_cast<unsigned long>(-exponent) * (d - k));
    for (int r = 0; r < d; ++r) // x = begin + width t: Taylor's shift,
      for (int k = d - 1; k >= r; --k)
        add_product(a[k], begin, a[k + 1]);
    Big_integer power(1);
    for (int k = 0; k <= d; ++k) { // powers of the width, and binomial weights,
      a[k] *= m_weights[k] * power;
      power *= width;
    }
    for (int r = 1; r <= d; ++r) // and their sums
      for (int k = d; k >= r; --k)
        a[k] += a[k - 1];
    return {std::move(a), exponent * d};
  }

  // What the integers of `bernstein()` are to be divided by.
  const Big_integer& denominator() const { return m_denominator; }

  // The greatest common divisor, up to a constant factor. That with zero is the other one.
  friend Integer_polynomial common_divisor(const Integer_polynomial& a, const Integer_polynomial& b)
  {
    if (a.is_zero() || b.is_zero())
      return a.is_zero() ? b : a;
    if (auto divisor = modular_common_divisor(a.m_coefficients, b.m_coefficients))
      return Integer_polynomial(std::move(*divisor));
    return Integer_polynomial(primitive_part(from_cgal(CGAL::gcd(a.to_cgal(), b.to_cgal())).m_coefficients));
  }

  // Coprime polynomials without multiple roots, each with an exponent: their product with these exponents is this one,
  // up to a constant factor (Yun 1976). \pre not zero
  std::vector<std::pair<Integer_polynomial, int>> square_free_factors() const;

private:
  friend Integer_polynomial operator-(const Integer_polynomial& a, const Integer_polynomial& b);

  // \pre A primitive divisor: the quotient has integer coefficients (Gauss).
  Integer_polynomial quotient_by(const Integer_polynomial& divisor) const
  {
    return Integer_polynomial(exact_quotient(m_coefficients, divisor.m_coefficients).value());
  }

  Polynomial to_cgal() const;

  static Integer_polynomial from_cgal(const Polynomial& polynomial);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Integer_polynomial::Integer_polynomial(std::vector<Big_integer> coefficients)
  : m_coefficients(std::move(coefficients))
{
  while (!m_coefficients.empty() && m_coefficients.back() == 0)
    m_coefficients.pop_back();
  std::vector<Big_integer> binomials(1, Big_integer(1));
  for (int i = 1; i <= degree(); ++i) {
    binomials.push_back(Big_integer(binomials.back() * (degree() - i + 1) / i));
    m_denominator = lcm(m_denominator, binomials.back());
  }
  for (const Big_integer& binomial : binomials)
    m_weights.push_back(m_denominator / binomial);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_polynomial operator*(const Integer_polynomial& a, const Integer_polynomial& b)
{
  if (a.is_zero() || b.is_zero())
    return {};
  std::vector<Big_integer> product(a.m_coefficients.size() + b.m_coefficients.size() - 1, Big_integer(0));
  for (std::size_t i = 0; i < a.m_coefficients.size(); ++i)
    for (std::size_t k = 0; k < b.m_coefficients.size(); ++k)
      add_product(product[i + k], a.m_coefficients[i], b.m_coefficients[k]);
  return Integer_polynomial(std::move(product));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_polynomial Integer_polynomial::derivative() const
{
  std::vector<Big_integer> result;
  for (int k = 1; k <= degree(); ++k)
    result.push_back(m_coefficients[k] * k);
  return Integer_polynomial(std::move(result));
}

CGAL_SPLINE_CONSTRAINTS_INLINE const Integer_polynomial::Value& Integer_polynomial::at(double x, Value& result) const
{
  auto& [sum, exponent, mantissa, shifted] = result;
  int binary_exponent = 0;
  mpz_set_d(mantissa.backend().data(), std::ldexp(std::frexp(x, &binary_exponent), 53));
  exponent = binary_exponent - 53;
  const long zeros = mantissa == 0
      ? exponent
      : (std::min)(static_cast<long>(mpz_scan1(mantissa.backend().data(), 0)), (std::max)(-exponent, 0L));
  if (mantissa == 0)
    exponent = 0;
  else {
    mpz_tdiv_q_2exp(mantissa.backend().data(), mantissa.backend().data(), static_cast<mp_bitcnt_t>(zeros));
    exponent += zeros;
    if (exponent > 0)
      shift_left(mantissa, static_cast<unsigned long>(std::exchange(exponent, 0)));
  }
  sum = 0;
  for (int k = degree(); k >= 0; --k) {
    sum *= mantissa;
    if (m_coefficients[k] != 0) {
      mpz_mul_2exp(shifted.backend().data(), m_coefficients[k].backend().data(),
                   static_cast<mp_bitcnt_t>(-exponent) * (degree() - k));
      sum += shifted;
    }
  }
  exponent *= (std::max)(degree(), 0);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Big_integer Integer_polynomial::numerator_at(const Exact_rational& x) const
{
  if (is_zero())
    return Big_integer(0);
  const Big_integer numerator = numerator_of(x), denominator = denominator_of(x);
  Big_integer sum = m_coefficients.back(), power(1);
  for (int k = degree() - 1; k >= 0; --k) {
    power *= denominator;
    sum *= numerator;
    add_product(sum, m_coefficients[k], power);
  }
  return sum;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Integer_polynomial::remove_root(const Exact_rational& root)
{
  const Big_integer p = numerator_of(root), q = denominator_of(root);
  int multiplicity = 0;
  // by q x - p: the quotient has integer coefficients (Gauss)
  for (; degree() > 0 && sign_at(root) == CGAL::ZERO; ++multiplicity) {
    std::vector<Big_integer> quotient(m_coefficients.size() - 1);
    Big_integer carry(0);
    for (int k = degree(); k > 0; --k) {
      carry = (m_coefficients[k] + p * carry) / q;
      quotient[k - 1] = carry;
    }
    *this = Integer_polynomial(std::move(quotient));
  }
  return multiplicity;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::pair<Integer_polynomial, int>>
Integer_polynomial::square_free_factors() const
{
  std::vector<std::pair<Integer_polynomial, int>> result;
  const Integer_polynomial divisor = common_divisor(*this, derivative());
  Integer_polynomial rest = quotient_by(divisor), slope = derivative().quotient_by(divisor) - rest.derivative();
  for (int exponent = 1; rest.degree() > 0; ++exponent) {
    const Integer_polynomial factor = common_divisor(rest, slope);
    rest = rest.quotient_by(factor);
    slope = slope.quotient_by(factor) - rest.derivative();
    if (factor.degree() > 0)
      result.emplace_back(factor, exponent);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_polynomial operator-(const Integer_polynomial& a, const Integer_polynomial& b)
{
  std::vector<Big_integer> result = a.m_coefficients;
  result.resize((std::max)(result.size(), b.m_coefficients.size()), Big_integer(0));
  for (std::size_t k = 0; k < b.m_coefficients.size(); ++k)
    result[k] -= b.m_coefficients[k];
  return Integer_polynomial(std::move(result));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_polynomial::Polynomial Integer_polynomial::to_cgal() const
{
  std::vector<Exact_integer> coefficients;
  for (const Big_integer& c : m_coefficients)
    coefficients.push_back(parts_of(scaled_rational(c, 0)).numerator);
  return Polynomial(coefficients.begin(), coefficients.end());
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_polynomial Integer_polynomial::from_cgal(const Polynomial& polynomial)
{
  std::vector<Big_integer> coefficients;
  for (const Exact_integer& c : polynomial)
    coefficients.push_back(numerator_of(compose(c, Exact_integer(1))));
  return Integer_polynomial(std::move(coefficients));
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_POLYNOMIAL_H
