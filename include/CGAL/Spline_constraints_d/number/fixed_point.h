// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_FIXED_POINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_FIXED_POINT_H

#include <CGAL/Spline_constraints_d/number/Short_integer.h>
#include <CGAL/Spline_constraints_d/number/two_words.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Fixed-point arithmetic in two machine words, for sums and products whose errors are counted in units. Values are
integers of up to `fixed_point_bits` bits, with room for a difference; factors in [0,1] are multiples of 2^-127.
*/
using Fixed_point = Two_words;
using Unsigned_fixed_point = Unsigned_two_words;

constexpr long fixed_point_bits = 124;
constexpr Unsigned_fixed_point fixed_point_one = Unsigned_fixed_point(1) << 127;

// The upper half of the product, too small by less than 3.
constexpr Unsigned_fixed_point upper_half(Unsigned_fixed_point a, Unsigned_fixed_point b)
{
  const std::uint64_t a0 = static_cast<std::uint64_t>(a), a1 = static_cast<std::uint64_t>(a >> 64);
  const std::uint64_t b0 = static_cast<std::uint64_t>(b), b1 = static_cast<std::uint64_t>(b >> 64);
  return Unsigned_fixed_point(a1) * b1 + ((Unsigned_fixed_point(a1) * b0) >> 64) +
      ((Unsigned_fixed_point(a0) * b1) >> 64);
}

// The product of two factors, too small by less than 6 units.
constexpr Unsigned_fixed_point unsigned_product(Unsigned_fixed_point a, Unsigned_fixed_point b)
{
  return upper_half(a, b) << 1;
}

// The product of a value and a factor, too small by less than 6 units.
constexpr Fixed_point multiplied(Fixed_point value, Unsigned_fixed_point factor)
{
  const Unsigned_fixed_point upper = upper_half(static_cast<Unsigned_fixed_point>(value), factor);
  return static_cast<Fixed_point>((value < 0 ? upper - factor : upper) << 1);
}

// The quotient of two integers times 2^shift, truncated. \pre denominator > 0, and the quotient has at most 127 bits
inline Fixed_point fixed_point_quotient(const Short_integer& numerator, long shift, const Short_integer& denominator)
{
  const Fixed_point quotient = static_cast<Fixed_point>(scaled_quotient(numerator, shift, denominator));
  return numerator.sign() < 0 ? -quotient : quotient;
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
    const auto range = common_dyadic<Short_integer>(lower, upper);
    m_is_power = is_power_of_two(range.width);
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
    auto [begin, width, exponent] = common_dyadic<Short_integer>(m_lower, m_upper);
    auto [place, own_exponent] = to_dyadic<Short_integer>(x);
    shift_left(begin, static_cast<unsigned long>((std::max)(exponent - own_exponent, 0L)));
    shift_left(width, static_cast<unsigned long>((std::max)(exponent - own_exponent, 0L)));
    shift_left(place, static_cast<unsigned long>((std::max)(own_exponent - exponent, 0L)));
    return scaled_quotient(place - begin, 127, width);
  }

private:
  // x / width in units of 2^-127, rounded down, modulo 2^128.
  Unsigned_fixed_point scaled(double x) const
  {
    const auto [mantissa, exponent] = integer_mantissa(x);
    const long shift = exponent + 127 - m_log_width;
    if (shift >= 128)
      return 0;
    return shift >= 0 ? static_cast<Unsigned_fixed_point>(mantissa) << shift
                      : static_cast<Unsigned_fixed_point>(mantissa >> (std::min)(-shift, 63L));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_FIXED_POINT_H
