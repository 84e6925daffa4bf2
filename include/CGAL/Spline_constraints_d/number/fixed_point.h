// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_FIXED_POINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_FIXED_POINT_H

#include <CGAL/Spline_constraints_d/number/Big_integer.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Fixed-point arithmetic in two machine words, for sums and products whose errors are counted in units. Values are integers of up to `fixed_point_bits` bits, with room for a
difference; factors in [0,1] are multiples of 2^-127.
*/
__extension__ typedef __int128 Fixed_point;
__extension__ typedef unsigned __int128 Unsigned_fixed_point;

constexpr long fixed_point_bits = 124;
constexpr Unsigned_fixed_point fixed_point_one = Unsigned_fixed_point(1) << 127;

// The upper half of the product, too small by less than 3.
constexpr Unsigned_fixed_point upper_half(Unsigned_fixed_point a, Unsigned_fixed_point b)
{
  const std::uint64_t a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64);
  const std::uint64_t b0 = static_cast<std::uint64_t>(b), b1 = static_cast<std::uint64_t>(b >> 64);
  return Unsigned_fixed_point(a1) * b1 + ((Unsigned_fixed_point(a1) * b0) >> 64) + ((Unsigned_fixed_point(a0) * b1) >> 64);
}

// The product of two factors, too small by less than 6 units.
constexpr Unsigned_fixed_point unsigned_product(Unsigned_fixed_point a, Unsigned_fixed_point b) { return upper_half(a, b) << 1; }

// The product of a value and a factor, too small by less than 6 units.
constexpr Fixed_point multiplied(Fixed_point value, Unsigned_fixed_point factor)
{
  const Unsigned_fixed_point upper = upper_half(static_cast<Unsigned_fixed_point>(value), factor);
  return static_cast<Fixed_point>((value < 0 ? upper - factor : upper) << 1);
}

constexpr Unsigned_fixed_point magnitude(Fixed_point value)
{
  return value < 0 ? -static_cast<Unsigned_fixed_point>(value) : static_cast<Unsigned_fixed_point>(value);
}

constexpr int bit_length(Unsigned_fixed_point value)
{
  const std::uint64_t upper = static_cast<std::uint64_t>(value >> 64);
  return upper != 0 ? 64 + static_cast<int>(std::bit_width(upper)) : static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value)));
}

// With a relative error below 2^-52, whatever the rounding mode: the leading 64 bits are converted, which are all that they fill.
inline double approximate(Unsigned_fixed_point value)
{
  const int bits = bit_length(value), shift = bits > 64 ? bits - 64 : 0;
  return std::ldexp(static_cast<double>(static_cast<std::uint64_t>(value >> shift)), shift);
}

inline double approximate(Fixed_point value) { return value < 0 ? -approximate(magnitude(value)) : approximate(magnitude(value)); }

// The quotient of two integers, truncated. \pre denominator > 0, and the quotient has at most 127 bits
inline Unsigned_fixed_point unsigned_quotient(const Big_integer& numerator, const Big_integer& denominator)
{
  static_assert(sizeof(mp_limb_t) == sizeof(std::uint64_t));
  Big_integer quotient;
  if (mpz_popcount(denominator.backend().data()) == 1)
    mpz_tdiv_q_2exp(quotient.backend().data(), numerator.backend().data(), static_cast<unsigned long>(bit_length(denominator) - 1));
  else
    mpz_tdiv_q(quotient.backend().data(), numerator.backend().data(), denominator.backend().data());
  CGAL_assertion(bit_length(quotient) <= 128);
  return Unsigned_fixed_point(mpz_getlimbn(quotient.backend().data(), 0)) | Unsigned_fixed_point(mpz_getlimbn(quotient.backend().data(), 1)) << 64;
}

inline Fixed_point fixed_point_quotient(const Big_integer& numerator, const Big_integer& denominator)
{
  const Fixed_point quotient = static_cast<Fixed_point>(unsigned_quotient(numerator, denominator));
  return numerator < 0 ? -quotient : quotient;
}

// A range [lower, upper] of doubles that is mapped to factors.
class Fixed_point_range
{
  double m_lower = 0, m_upper = 1;
  long m_log_width = 0;   // where the width is a power of two
  bool m_is_power = true;
  Unsigned_fixed_point m_begin = 0;

public:
  Fixed_point_range() = default;

  // \pre lower < upper
  Fixed_point_range(double lower, double upper) : m_lower(lower), m_upper(upper)
  {
    const Common_dyadic range = common_dyadic(lower, upper);
    m_is_power = mpz_popcount(range.width.backend().data()) == 1;
    if (m_is_power) {
      m_log_width = bit_length(range.width) - 1 + range.exponent;
      m_begin = scaled(lower);
    }
  }

  // (x - lower) / (upper - lower) as a factor, off by less than a unit. \pre lower <= x <= upper
  Unsigned_fixed_point operator()(double x) const
  {
    if (x == m_lower || x == m_upper)
      return x == m_lower ? 0 : fixed_point_one;
    if (m_is_power)
      return scaled(x) - m_begin;
    auto [begin, b] = to_dyadic(m_lower);
    auto [end, e] = to_dyadic(m_upper);
    auto [place, p] = to_dyadic(x);
    const long exponent = (std::min)({b, e, p});
    shift_left(begin, static_cast<unsigned long>(b - exponent));
    shift_left(end, static_cast<unsigned long>(e - exponent));
    shift_left(place, static_cast<unsigned long>(p - exponent));
    place -= begin;
    end -= begin;
    shift_left(place, 127);
    return unsigned_quotient(place, end);
  }

private:
  // x / width in units of 2^-127, rounded down, modulo 2^128.
  Unsigned_fixed_point scaled(double x) const
  {
    int exponent = 0;
    const Fixed_point mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    const long shift = exponent - 53 + 127 - m_log_width;
    if (shift >= 128)
      return 0;
    return shift >= 0 ? static_cast<Unsigned_fixed_point>(mantissa) << shift : static_cast<Unsigned_fixed_point>(mantissa >> (std::min)(-shift, 127L));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_FIXED_POINT_H
