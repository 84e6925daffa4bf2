// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_NUMBER_UTILITIES_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_NUMBER_UTILITIES_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <CGAL/FPU.h>

#include <limits>
#include <random>

// Helpers of the tests of floor 0. No test here prints an Exact_rational: the stream operators of some of the types
// behind it need a
// library of their own.
namespace number_testing {

using CGAL::Spline_constraints::Exact_integer;
using CGAL::Spline_constraints::Exact_rational;
using Random = std::mt19937_64;

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double largest = (std::numeric_limits<double>::max)();
inline constexpr double denormal = std::numeric_limits<double>::denorm_min();

inline constexpr CGAL::FPU_CW_t rounding_modes[] = {CGAL_FE_TONEAREST, CGAL_FE_UPWARD, CGAL_FE_DOWNWARD,
                                                    CGAL_FE_TOWARDZERO};

// Calls f() once in each of the four rounding modes.
template <typename Function>
void in_each_rounding_mode(Function f)
{
  for (const CGAL::FPU_CW_t mode : rounding_modes) {
    const CGAL::Protect_FPU_rounding<true> protection(mode);
    f();
  }
}

inline Exact_rational ratio(long long numerator, long long denominator)
{
  // long long is not a constructor argument of all types in question; the doubles are exact for what the tests use.
  return Exact_rational(static_cast<double>(numerator)) / Exact_rational(static_cast<double>(denominator));
}

inline long long uniform(Random& random, long long low, long long high)
{
  return std::uniform_int_distribution<long long>(low, high)(random);
}

// 2^exponent by repeated products of 2 and 1/2: slow, and sharing nothing with what is tested.
inline Exact_rational power_of_two_by_products(int exponent)
{
  Exact_rational result(1);
  const Exact_rational factor = exponent >= 0 ? Exact_rational(2) : ratio(1, 2);
  for (int i = 0; i != exponent; i += exponent > 0 ? 1 : -1)
    result *= factor;
  return result;
}

// A rational of either sign with up to `bits` (<= 40) bits in each part; zero now and then.
inline Exact_rational random_rational(Random& random, int bits = 20)
{
  const long long limit = 1LL << uniform(random, 1, bits);
  return ratio(uniform(random, -limit, limit), uniform(random, 1, limit));
}

// The same over a wide range of magnitudes.
inline Exact_rational random_wide_rational(Random& random, int largest_exponent)
{
  return random_rational(random) *
         power_of_two_by_products(static_cast<int>(uniform(random, -largest_exponent, largest_exponent)));
}

inline Exact_rational absolute(const Exact_rational& x)
{
  if (x < Exact_rational(0))
    return -x;
  return x;
}

} // namespace number_testing

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_NUMBER_UTILITIES_H
