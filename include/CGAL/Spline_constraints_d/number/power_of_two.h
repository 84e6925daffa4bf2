// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_POWER_OF_TWO_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_POWER_OF_TWO_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/mpq_access.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// 2^exponent for -1022 <= exponent <= 1023, put together from its bits: no library call and no rounding.
constexpr double double_power_of_two(int exponent)
{
  return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// x 2^exponent, as std::ldexp(), with no library call where the power is a normal double.
inline double times_power_of_two(double x, long exponent)
{
  return -1022 <= exponent && exponent <= 1023 ? x * double_power_of_two(static_cast<int>(exponent))
                                               : std::ldexp(x, static_cast<int>(std::clamp(exponent, -3000L, 3000L)));
}

// A finite double as mantissa 2^exponent, with a mantissa of at most 53 bits.
inline std::pair<std::int64_t, int> integer_mantissa(double x)
{
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x), fraction = bits & 0xfffffffffffff;
  const int exponent = static_cast<int>(bits >> 52 & 0x7ff);
  const std::int64_t size = static_cast<std::int64_t>(exponent == 0 ? fraction : fraction | 0x10000000000000);
  return {bits >> 63 ? -size : size, (std::max)(exponent, 1) - 1075};
}

// Calls multiply(2^s) with normal doubles 2^s whose product is 2^exponent. `limit` bounds |exponent|.
template <typename Multiply>
void for_each_double_factor(int exponent, int limit, Multiply multiply)
{
  exponent = std::clamp(exponent, -limit, limit);
  while (exponent != 0) {
    const int step = std::clamp(exponent, -1000, 1000);
    multiply(double_power_of_two(step));
    exponent -= step;
  }
}

// No double survives a scaling by more than this: all further factors change nothing.
inline constexpr int double_scaling_limit = 3000;

template <typename Rational>
void scale_any_rational(Rational& x, int exponent)
{
  if (exponent == 0)
    return;
  if constexpr (Writable_as_mpq<Rational>) {
    const mpq_ptr q = writable_mpq_of(x);
    // The magnitude is formed in unsigned arithmetic: -INT_MIN does not fit an int.
    if (exponent > 0)
      mpq_mul_2exp(q, q, static_cast<mp_bitcnt_t>(exponent));
    else
      mpq_div_2exp(q, q, -static_cast<mp_bitcnt_t>(exponent));
  } else {
    while (exponent != 0) {
      const int step = std::clamp(exponent, -1000, 1000);
      x *= Rational(double_power_of_two(step));
      exponent -= step;
    }
  }
}

// x *= 2^exponent.
inline void scale_rational(Exact_rational& x, int exponent) { scale_any_rational(x, exponent); }

// 2^exponent as an integer, exponent >= 0.
inline Exact_integer integer_power_of_two(int exponent)
{
  CGAL_precondition(exponent >= 0);
  Exact_integer result(1);
  while (exponent > 0) {
    const int step = (std::min)(exponent, 1000);
    result *= Exact_integer(double_power_of_two(step));
    exponent -= step;
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_POWER_OF_TWO_H
