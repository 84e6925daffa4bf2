// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_ENCLOSURE_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_ENCLOSURE_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/mpq_access.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/number_utils.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

static_assert(
    std::is_base_of_v<CGAL::Euclidean_ring_tag, CGAL::Algebraic_structure_traits<Exact_integer>::Algebraic_category>,
    "Spline_constraints_d needs GMP or Boost.Multiprecision: the numerators of CGAL::Exact_rational must be integers "
    "(they "
    "cannot be divided with a remainder)");

// A rational in its parts, denominator > 0. Not necessarily in lowest terms: not every type behind Exact_rational
// reduces.
struct Rational_parts
{
  Exact_integer numerator;
  Exact_integer denominator;
};

Rational_parts parts_of(const Exact_rational& x);

inline Exact_rational compose(const Exact_integer& numerator, const Exact_integer& denominator)
{
  return typename CGAL::Fraction_traits<Exact_rational>::Compose()(numerator, denominator);
}

// The number of binary digits of n > 0.
int integer_bit_length(Exact_integer n);

// The doubles in their order are the integers in theirs: -0 and +0 are 0, neighbours differ by 1. Unlike
// std::nextafter this needs no
// library call and no rounding mode.
inline std::int64_t key_of_double(double x)
{
  const std::int64_t bits = std::bit_cast<std::int64_t>(x);
  return bits >= 0 ? bits : (std::numeric_limits<std::int64_t>::min)() - bits;
}

inline double double_of_key(std::int64_t key)
{
  return std::bit_cast<double>(key >= 0 ? key : (std::numeric_limits<std::int64_t>::min)() - key);
}

// The next double above x or below it; infinity in this direction, and what is no number, stays.
inline double next_above(double x)
{
  return x < std::numeric_limits<double>::infinity() ? double_of_key(key_of_double(x) + 1) : x;
}
inline double next_below(double x) { return -next_above(-x); }

// The exact value of a finite double.
Exact_rational rational_of_finite(double x);

// The sign of x - bound, where bound may be infinite.
inline CGAL::Comparison_result compare_to_double(const Exact_rational& x, double bound)
{
  if (std::isinf(bound))
    return bound > 0 ? CGAL::SMALLER : CGAL::LARGER;
  return CGAL::compare(x, rational_of_finite(bound));
}

// Whether x is seen to be a double far from underflow and overflow, which is then its value: most numbers that users
// write.
template <class Rational>
bool is_small_dyadic([[maybe_unused]] const Rational& x, [[maybe_unused]] double& value)
{
  if constexpr (Readable_as_mpq<Rational>) {
    mpz_srcptr numerator = mpq_numref(mpq_of(x)), denominator = mpq_denref(mpq_of(x));
    if (mpz_sizeinbase(numerator, 2) > 53 || mpz_popcount(denominator) != 1)
      return false;
    const std::size_t exponent = mpz_sizeinbase(denominator, 2) - 1;
    if (exponent > 1000)
      return false;
    value = mpz_get_d(numerator) * double_power_of_two(-static_cast<int>(exponent));
    return true;
  } else
    return false;
}

bool is_tightest_enclosure(const std::pair<double, double>& bounds, const Exact_rational& x);

// The tightest enclosure by bisection over the doubles, with exact comparisons only: 63 of them.
std::pair<double, double> search_double_interval(const Exact_rational& x);

void require_finite(double x);

// The simplest number of [lower, upper] where 0 < lower <= upper. Continued fraction of the two ends for as long as
// they agree.
Exact_rational simplest_positive_rational_between(const Exact_rational& lower, const Exact_rational& upper);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Rational_parts parts_of(const Exact_rational& x)
{
  Rational_parts parts;
  typename CGAL::Fraction_traits<Exact_rational>::Decompose()(x, parts.numerator, parts.denominator);
  if (CGAL::sign(parts.denominator) == CGAL::NEGATIVE) {
    parts.numerator = -parts.numerator;
    parts.denominator = -parts.denominator;
  }
  return parts;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int integer_bit_length(Exact_integer n)
{
  CGAL_precondition(CGAL::sign(n) == CGAL::POSITIVE);
  // Squaring up and dividing down needs O(log log n) steps and no access to the digits.
  std::vector<Exact_integer> powers(1, Exact_integer(2)); // powers[i] = 2^(2^i)
  while (powers.back() <= n) {
    Exact_integer next = powers.back();
    next *= powers.back();
    powers.push_back(next);
  }
  int length = 1;
  for (int i = static_cast<int>(powers.size()) - 1; i >= 0; --i) {
    if (powers[i] <= n) {
      n = CGAL::div(n, powers[i]);
      length += 1 << i;
    }
  }
  return length;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational rational_of_finite(double x)
{
  // Some of CGAL's conversions form the denominator as a double, which overflows for denormals: these are scaled up
  // (exactly) first.
  if (x == 0 || std::abs(x) >= 0x1p-900)
    return Exact_rational(x);
  Exact_rational result(x * 0x1p200);
  scale_rational(result, -200);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool is_tightest_enclosure(const std::pair<double, double>& bounds,
                                                          const Exact_rational& x)
{
  if (std::isnan(bounds.first) || std::isnan(bounds.second))
    return false;
  const std::int64_t lower = key_of_double(bounds.first);
  const std::int64_t upper = key_of_double(bounds.second);
  if (lower == upper)
    return std::isfinite(bounds.first) && compare_to_double(x, bounds.first) == CGAL::EQUAL;
  return upper - 1 == lower && compare_to_double(x, bounds.first) == CGAL::LARGER &&
      compare_to_double(x, bounds.second) == CGAL::SMALLER;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<double, double> search_double_interval(const Exact_rational& x)
{
  const CGAL::Sign sign = CGAL::sign(x);
  if (sign == CGAL::ZERO)
    return {0.0, 0.0};
  const std::int64_t infinity = key_of_double(std::numeric_limits<double>::infinity());
  std::int64_t lower =
      sign == CGAL::POSITIVE ? 0 : -infinity; // double_of_key(lower) < x < double_of_key(upper) throughout
  std::int64_t upper = sign == CGAL::POSITIVE ? infinity : 0;
  while (upper - lower > 1) {
    const std::int64_t middle = lower + (upper - lower) / 2;
    const CGAL::Comparison_result order = compare_to_double(x, double_of_key(middle));
    if (order == CGAL::EQUAL)
      return {double_of_key(middle), double_of_key(middle)};
    (order == CGAL::SMALLER ? upper : lower) = middle;
  }
  return {double_of_key(lower), double_of_key(upper)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE void require_finite(double x)
{
  if (!std::isfinite(x))
    throw Invalid_input(std::isnan(x) ? "not a number (NaN) where a finite number is needed"
                            : x > 0   ? "+infinity where a finite number is needed"
                                      : "-infinity where a finite number is needed");
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational simplest_positive_rational_between(const Exact_rational& lower,
                                                                                 const Exact_rational& upper)
{
  Rational_parts low = parts_of(lower);
  Rational_parts high = parts_of(upper);
  // The convergents p/q of the terms so far, and the ones before.
  Exact_integer p(1), q(0), previous_p(0), previous_q(1);
  for (;;) {
    Exact_integer term = CGAL::div(low.numerator, low.denominator);
    const Exact_integer low_rest = low.numerator - term * low.denominator;
    bool is_last = CGAL::sign(low_rest) == CGAL::ZERO;
    if (!is_last) {
      const Exact_integer next = term + Exact_integer(1);
      if (next * high.denominator <= high.numerator) {
        term = next;
        is_last = true;
      }
    }
    const Exact_integer new_p = term * p + previous_p;
    const Exact_integer new_q = term * q + previous_q;
    if (is_last)
      return compose(new_p, new_q);
    previous_p = p;
    previous_q = q;
    p = new_p;
    q = new_q;
    // Both ends lie strictly between term and term + 1: take the term away, invert, and the ends change places.
    const Exact_integer high_rest = high.numerator - term * high.denominator;
    const Rational_parts inverted_low{high.denominator, high_rest};
    high = Rational_parts{low.denominator, low_rest};
    low = inverted_low;
  }
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDNumbers

returns the rational number that `x` is. Every finite double is one, denormals included; independent of the rounding
mode.

\throws Invalid_input if `x` is infinite or not a number.
*/
inline Exact_rational to_rational(double x)
{
  internal::require_finite(x);
  return internal::rational_of_finite(x);
}

/*!
\ingroup PkgSplineConstraintsDNumbers

returns the tightest pair of doubles `(l, u)` with \f$ l \le x \le u \f$: `l == u` iff `x` is a double, otherwise `u`
follows `l` directly, also among
the denormals. Beyond the largest double the pair is `(max, infinity)`, and the mirror image of it below the smallest.

Independent of the rounding mode. Where `Exact_rational` is made of GMP's numbers, `CGAL::to_interval()` makes a
proposal and exact comparisons check
it; otherwise, and should the check fail, a bisection over the doubles finds the pair in 63 exact comparisons.
*/
std::pair<double, double> to_double_interval(const Exact_rational& x);

/*!
\ingroup PkgSplineConstraintsDNumbers

returns the double nearest to `x`, the lower one if two are equally near, in every rounding mode. Numbers beyond the
largest double go to
\f$ \pm\infty \f$, so that what does not fit is seen and not taken for a double.
*/
double to_nearest_double(const Exact_rational& x);

/*!
\ingroup PkgSplineConstraintsDNumbers

returns the simplest number of the closed interval `[lower, upper]`: the one with the smallest denominator, and among
those (several
integers, that is) the one with the smallest absolute value; 0 if the interval contains it.

This is the descent in the Stern–Brocot tree, taken a whole continued-fraction term at a time: exact, and as many
steps as the
Euclidean algorithm makes for the ends.

\throws Invalid_input if `lower > upper`.
*/
Exact_rational simplest_rational_between(const Exact_rational& lower, const Exact_rational& upper);

/*!
\ingroup PkgSplineConstraintsDNumbers

returns \f$ m 2^e \f$ with \f$ |m| \le 2^b \f$, \f$ b \f$ = `bits`, nearest to `x` among those with the `e` of its
binade; halves go away from zero. The
result is off by at most \f$ 2^{-b} |x| \f$, it is `x` itself if `x` has at most `bits` significant bits, and \f$ x
\mapsto \f$ result is odd
and monotone.

\throws Invalid_input if `bits < 1`.
*/
Exact_rational round_to_dyadic(const Exact_rational& x, int bits);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<double, double> to_double_interval(const Exact_rational& x)
{
  // For CGAL::Quotient, CGAL::to_interval() has assertions that fail for denormals, and near overflow in some
  // rounding modes.
  if (double value = 0; internal::is_small_dyadic(x, value))
    return {value, value};
  if constexpr (internal::Readable_as_mpq<Exact_rational>) {
    const std::pair<double, double> proposal = CGAL::to_interval(x);
    if (internal::is_tightest_enclosure(proposal, x))
      return proposal;
  }
  return internal::search_double_interval(x);
}

CGAL_SPLINE_CONSTRAINTS_INLINE double to_nearest_double(const Exact_rational& x)
{
  const std::pair<double, double> bounds = to_double_interval(x);
  if (bounds.first == bounds.second || std::isinf(bounds.first))
    return bounds.first;
  if (std::isinf(bounds.second))
    return bounds.second;
  const Exact_rational sum = internal::rational_of_finite(bounds.first) + internal::rational_of_finite(bounds.second);
  const Exact_rational twice = x + x;
  return CGAL::compare(twice, sum) == CGAL::LARGER ? bounds.second : bounds.first;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational simplest_rational_between(const Exact_rational& lower,
                                                                        const Exact_rational& upper)
{
  if (CGAL::compare(lower, upper) == CGAL::LARGER)
    throw Invalid_input("simplest_rational_between: the interval is empty, its lower end is larger than its upper end");
  if (CGAL::sign(lower) == CGAL::POSITIVE)
    return internal::simplest_positive_rational_between(lower, upper);
  if (CGAL::sign(upper) == CGAL::NEGATIVE) {
    const Exact_rational mirrored_lower = -upper;
    const Exact_rational mirrored_upper = -lower;
    const Exact_rational mirrored = internal::simplest_positive_rational_between(mirrored_lower, mirrored_upper);
    return -mirrored;
  }
  return Exact_rational(0);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational round_to_dyadic(const Exact_rational& x, int bits)
{
  if (bits < 1)
    throw Invalid_input("round_to_dyadic: " + std::to_string(bits) + " significant bits asked for, at least 1 needed");
  const CGAL::Sign sign = CGAL::sign(x);
  if (sign == CGAL::ZERO)
    return Exact_rational(0);
  internal::Rational_parts parts = internal::parts_of(x);
  if (sign == CGAL::NEGATIVE)
    parts.numerator = -parts.numerator;

  // 2^exponent <= |x| < 2^(exponent + 1): the lengths give the exponent or one more.
  int exponent = internal::integer_bit_length(parts.numerator) - internal::integer_bit_length(parts.denominator);
  const auto times_power_of_two = [](const Exact_integer& n, int power) {
    Exact_integer result = n;
    if (power > 0)
      result *= internal::integer_power_of_two(power);
    return result;
  };
  if (times_power_of_two(parts.numerator, -exponent) < times_power_of_two(parts.denominator, exponent))
    --exponent;

  const int shift = bits - 1 - exponent; // m = |x| 2^shift has `bits` digits before the point
  const Exact_integer numerator = times_power_of_two(parts.numerator, shift);
  const Exact_integer denominator = times_power_of_two(parts.denominator, -shift);
  const Exact_integer twice_numerator = numerator + numerator;
  const Exact_integer twice_denominator = denominator + denominator;
  const Exact_integer rounded_numerator = twice_numerator + denominator;
  const Exact_integer mantissa = CGAL::div(rounded_numerator, twice_denominator);

  Exact_rational result = internal::compose(mantissa, Exact_integer(1));
  internal::scale_rational(result, -shift);
  if (sign == CGAL::NEGATIVE)
    result = -result;
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_ENCLOSURE_H
