// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_BIG_INTEGER_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_BIG_INTEGER_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/mpq_access.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>

#include <CGAL/assertions.h>

#include <boost/multiprecision/gmp.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Integers for the exact kernels of the solver: GMP's, without expression templates, whichever type stands behind
`Exact_rational`.
*/
using Big_integer = boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

// The integer whose decimal digits a number prints: for types that do not show their GMP number, while a system is set
// up.
template <class Integer>
Big_integer integer_from_digits(const Integer& value)
{
  std::ostringstream digits;
  digits << value;
  return Big_integer(digits.str());
}

template <class Rational>
Big_integer numerator_of_rational(const Rational& value)
{
  if constexpr (Readable_as_mpq<Rational>) {
    Big_integer result;
    mpz_set(result.backend().data(), mpq_numref(mpq_of(value)));
    return result;
  } else {
    typename CGAL::Fraction_traits<Rational>::Numerator_type numerator;
    typename CGAL::Fraction_traits<Rational>::Denominator_type denominator;
    typename CGAL::Fraction_traits<Rational>::Decompose()(value, numerator, denominator);
    return integer_from_digits(numerator);
  }
}

template <class Rational>
Big_integer denominator_of_rational(const Rational& value)
{
  if constexpr (Readable_as_mpq<Rational>) {
    Big_integer result;
    mpz_set(result.backend().data(), mpq_denref(mpq_of(value)));
    return result;
  } else {
    typename CGAL::Fraction_traits<Rational>::Numerator_type numerator;
    typename CGAL::Fraction_traits<Rational>::Denominator_type denominator;
    typename CGAL::Fraction_traits<Rational>::Decompose()(value, numerator, denominator);
    return integer_from_digits(denominator);
  }
}

// Not templates, so that expression templates convert.
inline Big_integer numerator_of(const Exact_rational& value) { return numerator_of_rational(value); }
inline Big_integer denominator_of(const Exact_rational& value) { return denominator_of_rational(value); }

// Rationals that show their GMP number need no copies here.
template <class Rational>
void extend_common_denominator_of_rational(Big_integer& common, const Rational& value)
{
  if constexpr (Readable_as_mpq<Rational>) {
    mpz_srcptr denominator = mpq_denref(mpq_of(value));
    if (!mpz_divisible_p(common.backend().data(), denominator))
      mpz_lcm(common.backend().data(), common.backend().data(), denominator);
  } else
    common = lcm(common, denominator_of_rational(value));
}

template <class Rational>
Big_integer numerator_of_rational_over(const Rational& value, const Big_integer& common)
{
  if constexpr (Readable_as_mpq<Rational>) {
    Big_integer result;
    mpz_ptr target = result.backend().data();
    mpz_srcptr numerator = mpq_numref(mpq_of(value)), denominator = mpq_denref(mpq_of(value));
    if (mpz_cmp(common.backend().data(), denominator) == 0)
      mpz_set(target, numerator);
    else {
      mpz_divexact(target, common.backend().data(), denominator);
      mpz_mul(target, target, numerator);
    }
    return result;
  } else
    return numerator_of_rational(value) * (common / denominator_of_rational(value));
}

// The least common multiple of `common` and the denominator of a rational takes the place of `common`.
inline void extend_common_denominator(Big_integer& common, const Exact_rational& value)
{
  extend_common_denominator_of_rational(common, value);
}

// value * common, an integer. \pre the denominator of the rational divides `common`
inline Big_integer numerator_over(const Exact_rational& value, const Big_integer& common)
{
  return numerator_of_rational_over(value, common);
}

inline void shift_left(Big_integer& value, unsigned long bits)
{
  if (bits != 0)
    mpz_mul_2exp(value.backend().data(), value.backend().data(), bits);
}

// target = value 2^bits
inline void set_shifted(Big_integer& target, const Big_integer& value, unsigned long bits)
{
  mpz_mul_2exp(target.backend().data(), value.backend().data(), bits);
}

// sum += a b
inline void add_product(Big_integer& sum, const Big_integer& a, const Big_integer& b)
{
  mpz_addmul(sum.backend().data(), a.backend().data(), b.backend().data());
}

// Number of bits of the absolute value; 0 for 0.
inline long bit_length(const Big_integer& value)
{
  return value == 0 ? 0 : static_cast<long>(mpz_sizeinbase(value.backend().data(), 2));
}

// mantissa 2^exponent, with any exponent. \pre the mantissa is zero, or of a size in [1/2, 1)
inline double scaled_mantissa(double mantissa, long exponent)
{
  if (mantissa == 0 || exponent < -1070)
    return 0;
  return times_power_of_two(mantissa, exponent);
}

// value 2^exponent, truncated: relative error below 2^-52, whatever the rounding mode.
inline double to_scaled_double(const Big_integer& value, long exponent)
{
  long own_exponent = 0;
  const double mantissa = mpz_get_d_2exp(&own_exponent, value.backend().data());
  return scaled_mantissa(mantissa, own_exponent + exponent);
}

inline double approximate(const Big_integer& value) { return to_scaled_double(value, 0); }

// 2^exponent as a rational, by squaring.
Exact_rational power_of_two(long exponent);

// value 2^exponent, exactly.
template <class Rational = Exact_rational>
Rational scaled_rational(const Big_integer& value, long exponent)
{
  if constexpr (Writable_as_mpq<Rational>) {
    Rational result(0);
    mpq_ptr target = writable_mpq_of(result);
    mpq_set_z(target, value.backend().data());
    if (exponent > 0)
      mpq_mul_2exp(target, target, static_cast<unsigned long>(exponent));
    else
      mpq_div_2exp(target, target, static_cast<unsigned long>(-exponent));
    return result;
  } else {   // in chunks that are exact as doubles
    Big_integer rest = abs(value);
    Rational result(0), weight(1);
    const Rational chunk_weight(0x1p32);
    while (rest != 0) {
      result += weight * Rational(static_cast<double>(mpz_get_ui(rest.backend().data()) & 0xffffffffUL));
      weight *= chunk_weight;
      mpz_fdiv_q_2exp(rest.backend().data(), rest.backend().data(), 32);
    }
    return (value < 0 ? Rational(-result) : result) * power_of_two(exponent);
  }
}

// numerator / denominator, exactly. \pre denominator > 0
inline Exact_rational quotient(const Big_integer& numerator, const Big_integer& denominator)
{
  if (mpz_popcount(denominator.backend().data()) == 1)
    return scaled_rational(numerator, 1 - bit_length(denominator));
  return scaled_rational(numerator, 0) / scaled_rational(denominator, 0);
}

// A dyadic number as mantissa 2^exponent.
template <class Integer = Big_integer>
std::pair<Integer, long> to_dyadic(double value)
{
  const auto [mantissa, exponent] = integer_mantissa(value);
  if (mantissa == 0)
    return {Integer(0), 0};
  const int zeros = __builtin_ctzll(static_cast<unsigned long long>(mantissa));
  return {Integer(mantissa >> zeros), static_cast<long>(exponent) + zeros};
}

inline bool is_dyadic(const Exact_rational& value) { return mpz_popcount(denominator_of(value).backend().data()) == 1; }

// \pre the denominator is a power of two
template <class Integer = Big_integer>
std::pair<Integer, long> to_dyadic(const Exact_rational& value)
{
  const Big_integer denominator = denominator_of(value);
  CGAL_precondition(mpz_popcount(denominator.backend().data()) == 1);
  return {Integer(numerator_of(value)), 1 - bit_length(denominator)};
}

// A sum of dyadic numbers in the finest of their units.
template <class Integer>
class Dyadic_sum
{
  Integer m_sum = 0, m_shifted;
  long m_unit = 0;

public:
  void reset()
  {
    m_sum = 0;
    m_unit = 0;
  }

  // Adds value 2^exponent.
  void add(const Integer& value, long exponent)
  {
    if (exponent < m_unit) {
      shift_left(m_sum, static_cast<unsigned long>(m_unit - exponent));
      m_unit = exponent;
      m_sum += value;
    } else {
      set_shifted(m_shifted, value, static_cast<unsigned long>(exponent - m_unit));
      m_sum += m_shifted;
    }
  }

  const Integer& mantissa() const { return m_sum; }
  long exponent() const { return m_unit; }
};

// Two dyadic numbers over one power of two: lower = begin 2^exponent, upper = (begin + width) 2^exponent; exponent <=
// 0.
template <class Integer>
struct Common_dyadic
{
  Integer begin, width;
  long exponent;
};

template <class Integer = Big_integer, class Coordinate>
Common_dyadic<Integer> common_dyadic(const Coordinate& lower, const Coordinate& upper)
{
  auto [a, e] = to_dyadic<Integer>(lower);
  auto [b, f] = to_dyadic<Integer>(upper);
  const long exponent = (std::min)({e, f, 0L});
  shift_left(a, static_cast<unsigned long>(e - exponent));
  shift_left(b, static_cast<unsigned long>(f - exponent));
  return {a, Integer(b - a), exponent};
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational power_of_two(long exponent)
{
  Exact_rational result(1), square(exponent < 0 ? 0.5 : 2.0);
  for (unsigned long rest = static_cast<unsigned long>(exponent < 0 ? -exponent : exponent); rest != 0; rest >>= 1) {
    if (rest & 1)
      result *= square;
    square *= square;
  }
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_BIG_INTEGER_H
