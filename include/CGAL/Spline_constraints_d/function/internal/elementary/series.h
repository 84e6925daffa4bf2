// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_SERIES_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_SERIES_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace elementary {

// Encloses while the rounding mode of the thread is upward, as everything here.
using Interval = CGAL::Interval_nt<false>;

/*
Elementary functions at doubles by their power series in interval arithmetic, some ulps wide and some ten times as fast
as those of MPFR. The argument is reduced by constants in two parts: k times the first one, which ends with zeros, is
exact. The rest of a series is bounded by its first term left out, times what its quotients allow.
*/

// The double next to a constant and those around it: the constant lies in between.
inline Interval near_double(double x) { return Interval(next_below(x), next_above(x)); }

// Encloses the sum of coefficients times powers of x, by Horner's scheme, where x is at least 0; then the rest, which
// is at most this in size.
template <std::size_t Size>
Interval sum_of_series(const std::array<Interval, Size>& coefficients, const Interval& x, double rest)
{
  Interval result = coefficients[Size - 1] + Interval(-rest, rest);
  for (std::size_t k = Size - 1; k-- > 0;)
    result = result * x + coefficients[k];
  return result;
}

// sign^k / (first + k step). Whatever the rounding mode is.
template <std::size_t Size>
std::array<Interval, Size> reciprocals(int sign, int first, int step)
{
  std::array<Interval, Size> result;
  for (std::size_t k = 0; k < Size; ++k)
    result[k] = first + static_cast<int>(k) * step == 1
        ? Interval(1)
        : near_double((k % 2 == 0 ? 1.0 : sign) / (first + static_cast<int>(k) * step));
  return result;
}

// sign^k / (first + 2 k)! with first = 0 or 1, up to 18!, which is a double. Whatever the rounding mode is.
template <std::size_t Size>
std::array<Interval, Size> reciprocals_of_factorials(int sign, int first)
{
  std::array<Interval, Size> result;
  double factorial = 1;
  for (std::size_t k = 0; k < Size; ++k) {
    const int n = first + 2 * static_cast<int>(k);
    result[k] = n <= 1 ? Interval(1) : near_double((k % 2 == 0 ? 1.0 : sign) / factorial);
    factorial *= (n + 1) * (n + 2);
  }
  return result;
}

inline constexpr double first_part_of_log_2 = 0x1.62e42feep-1; // ends with zeros
inline Interval second_part_of_log_2() { return near_double(0x1.a39ef35793c76p-33); }

// e^r by cosh r + sinh r with |r| <= 0.35: the terms left out are at most r^16 / 16! and r^17 / 17!, times 1.001.
inline std::optional<Interval> exponential_by_series(double x)
{
  if (!(std::abs(x) < 700))
    return std::nullopt;
  static const auto even = reciprocals_of_factorials<8>(1, 0), odd = reciprocals_of_factorials<8>(1, 1);
  const double k = std::floor(x * 0x1.71547652b82fep+0 + 0.5);
  const Interval r = Interval(x) - Interval(k) * Interval(first_part_of_log_2) - Interval(k) * second_part_of_log_2();
  const Interval square = CGAL::square(r);
  // of the series over square^7: what is left of it is a fraction below 2^-55 of the last coefficient kept
  const Interval cosh = sum_of_series(even, square, 2 * square.sup() * even[7].sup() / (15 * 16));
  const Interval sinh = r * sum_of_series(odd, square, 2 * square.sup() * odd[7].sup() / (16 * 17));
  const int exponent = static_cast<int>(k);
  const double half = std::ldexp(1.0, exponent / 2), other_half = std::ldexp(1.0, exponent - exponent / 2);
  return (cosh + sinh) * Interval(half) * Interval(other_half);
}

inline constexpr double first_part_of_quarter_turn = 0x1.921fb544p+0; // ends with zeros
inline Interval second_part_of_quarter_turn() { return near_double(0x1.0b4611a626331p-34); }

// sin(x + quarters pi / 2): of the reduced argument |r| <= 0.79 the sine or the cosine, with one of two signs.
inline std::optional<Interval> wave_by_series(double x, int quarters)
{
  if (!(std::abs(x) < 0x1p18))
    return std::nullopt;
  static const auto even = reciprocals_of_factorials<9>(-1, 0), odd = reciprocals_of_factorials<9>(-1, 1);
  const double k = std::floor(x * 0x1.45f306dc9c883p-1 + 0.5);
  const Interval r =
      Interval(x) - Interval(k) * Interval(first_part_of_quarter_turn) - Interval(k) * second_part_of_quarter_turn();
  const Interval square = CGAL::square(r);
  const int turn = (static_cast<int>(k) + quarters) & 3;
  const auto rest = [&](double last, int n) { return 2 * square.sup() * std::abs(last) / (n * (n + 1)); };
  const Interval value = turn % 2 == 0 ? r * sum_of_series(odd, square, rest(odd[8].sup(), 18))
                                       : sum_of_series(even, square, rest(even[8].sup(), 17));
  return turn < 2 ? value : -value;
}

// log m 2^k with 2 artanh s, s = (m - 1) / (m + 1), |s| <= 0.172: what is left is at most s^24 / 25 times 1.04.
inline std::optional<Interval> logarithm_by_series(double x)
{
  if (!(x > 0x1p-1000 && x < 0x1p1000))
    return std::nullopt;
  static const auto coefficients = reciprocals<12>(1, 1, 2);
  int exponent = 0;
  double m = std::frexp(x, &exponent);
  if (m < 0x1.6a09e667f3bcdp-1) {
    m *= 2;
    --exponent;
  }
  const Interval k(exponent), s = (Interval(m) - Interval(1)) / (Interval(m) + Interval(1));
  const Interval square = CGAL::square(s);
  const Interval series = sum_of_series(coefficients, square, 2 * square.sup() / 25);
  return k * Interval(first_part_of_log_2) + (Interval(2) * s * series + k * second_part_of_log_2());
}

inline Interval pi() { return Interval(0x1.921fb54442d18p+1, 0x1.921fb54442d19p+1); }

// arctan of numbers of at most 1 in size by two bisections of the angle, after which |t| <= 0.2: what is left is at
// most t^26 / 27.
inline Interval short_arc_tangent(const Interval& x)
{
  static const auto coefficients = reciprocals<13>(-1, 1, 2);
  const Interval one(1);
  Interval t = x;
  for (int step = 0; step < 2; ++step)
    t = t / (one + CGAL::sqrt(one + CGAL::square(t)));
  const Interval square = CGAL::square(t);
  return Interval(4) * t * sum_of_series(coefficients, square, 2 * square.sup() / 27);
}

inline Interval arc_tangent_by_series(const Interval& x)
{
  if (x.inf() >= 1 || x.sup() <= -1)
    return (x.inf() >= 1 ? pi() : -pi()) / Interval(2) - short_arc_tangent(Interval(1) / x);
  return short_arc_tangent(x);
}

// Where the root below the fraction is known well.
inline std::optional<Interval> arc_sine_by_series(double x)
{
  if (!(std::abs(x) < 0.9))
    return std::nullopt;
  const Interval one(1);
  const Interval cosine = CGAL::sqrt((one - Interval(x)) * (one + Interval(x)));
  return arc_tangent_by_series(Interval(x) / cosine);
}

} // namespace elementary
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_SERIES_H
