// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <gtest/gtest.h>

#include "test_number_utilities.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

namespace number_enclosure_test {

namespace {

using namespace CGAL::Spline_constraints;
using namespace number_testing;

using Double_pair = std::pair<double, double>;

// Any finite double, all exponents alike.
double random_double(Random& random)
{
  for (;;) {
    const double x = std::bit_cast<double>(static_cast<std::uint64_t>(random()));
    if (std::isfinite(x))
      return x;
  }
}

double random_denormal(Random& random)
{
  return std::bit_cast<double>(static_cast<std::uint64_t>(random()) & 0x800fffffffffffffULL);
}

// The value from the bits of the double alone.
Exact_rational value_of_bits(double x)
{
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  const std::uint64_t fraction = bits & 0xfffffffffffffULL;
  const std::uint64_t mantissa = biased == 0 ? fraction : fraction | 1ULL << 52;
  Exact_rational result = Exact_rational(static_cast<double>(mantissa >> 32)) * power_of_two_by_products(32) +
                          Exact_rational(static_cast<double>(mantissa & 0xffffffffULL));
  result *= power_of_two_by_products((biased == 0 ? 1 : biased) - 1075);
  if (bits >> 63)
    result = -result;
  return result;
}

void expect_tightest(const Exact_rational& x, const Double_pair& bounds)
{
  const auto [lower, upper] = bounds;
  if (lower == upper) {
    EXPECT_TRUE(to_rational(lower) == x);
    return;
  }
  EXPECT_EQ(std::nextafter(lower, infinity), upper);
  EXPECT_TRUE(lower == -infinity || to_rational(lower) < x);
  EXPECT_TRUE(upper == infinity || x < to_rational(upper));
}

TEST(to_rational, is_exact_in_every_rounding_mode)
{
  Random random(101);
  for (int i = 0; i < 60; ++i) {
    for (const double x : {random_double(random), random_denormal(random), std::ldexp(1.0 + i, -i)}) {
      const Exact_rational expected = value_of_bits(x);
      in_each_rounding_mode([&]() { EXPECT_TRUE(to_rational(x) == expected) << x; });
    }
  }
  for (const double x : {0.0, -0.0, 1.0, largest, -largest, denormal, -denormal, (std::numeric_limits<double>::min)()})
    in_each_rounding_mode([&]() { EXPECT_TRUE(to_rational(x) == value_of_bits(x)) << x; });
}

TEST(to_rational, rejects_what_is_not_finite)
{
  EXPECT_THROW(to_rational(infinity), Invalid_input);
  EXPECT_THROW(to_rational(-infinity), Invalid_input);
  EXPECT_THROW(to_rational(std::numeric_limits<double>::quiet_NaN()), Invalid_input);
}

TEST(to_double_interval, is_a_point_for_doubles)
{
  Random random(102);
  for (int i = 0; i < 300; ++i) {
    for (const double x : {random_double(random), random_denormal(random)}) {
      const Exact_rational exact = to_rational(x);
      in_each_rounding_mode([&]() { EXPECT_EQ(to_double_interval(exact), Double_pair(x, x)); });
    }
  }
}

TEST(to_double_interval, is_tightest_in_every_rounding_mode)
{
  Random random(103);
  int proper = 0;
  for (int i = 0; i < 200; ++i) {
    const Exact_rational x = random_wide_rational(random, 1120);
    in_each_rounding_mode([&]() {
      const Double_pair bounds = to_double_interval(x);
      expect_tightest(x, bounds);
      EXPECT_EQ(bounds, internal::search_double_interval(x));
      proper += bounds.first < bounds.second;
    });
  }
  EXPECT_GT(proper, 400);
}

TEST(to_double_interval, at_the_ends_of_the_range)
{
  const Exact_rational tiny = power_of_two_by_products(-1200);
  const Exact_rational top = to_rational(largest);
  in_each_rounding_mode([&]() {
    EXPECT_EQ(to_double_interval(Exact_rational(0)), Double_pair(0, 0));
    EXPECT_EQ(to_double_interval(tiny), Double_pair(0, denormal));
    EXPECT_EQ(to_double_interval(-tiny), Double_pair(-denormal, 0));
    EXPECT_EQ(to_double_interval(to_rational(denormal) + tiny), Double_pair(denormal, 2 * denormal));
    EXPECT_EQ(to_double_interval(top), Double_pair(largest, largest));
    EXPECT_EQ(to_double_interval(top + tiny), Double_pair(largest, infinity));
    EXPECT_EQ(to_double_interval(-top - tiny), Double_pair(-infinity, -largest));
    EXPECT_EQ(to_double_interval(top - tiny), Double_pair(std::nextafter(largest, 0), largest));
    EXPECT_EQ(to_double_interval(power_of_two_by_products(1024)), Double_pair(largest, infinity));
    EXPECT_EQ(to_double_interval(power_of_two_by_products(5000)), Double_pair(largest, infinity));
    EXPECT_EQ(to_double_interval(-power_of_two_by_products(5000)), Double_pair(-infinity, -largest));
    EXPECT_EQ(to_double_interval(Exact_rational(1) + tiny), Double_pair(1, 0x1.0000000000001p0));
    EXPECT_EQ(to_double_interval(Exact_rational(1) - tiny), Double_pair(0x1.fffffffffffffp-1, 1));
  });
}

TEST(to_nearest_double, is_nearest_in_every_rounding_mode)
{
  Random random(104);
  for (int i = 0; i < 200; ++i) {
    const Exact_rational x = random_wide_rational(random, 900);
    const Double_pair bounds = to_double_interval(x);
    in_each_rounding_mode([&]() {
      const double nearest = to_nearest_double(x);
      EXPECT_TRUE(nearest == bounds.first || nearest == bounds.second);
      const Exact_rational error = absolute(to_rational(nearest) - x);
      EXPECT_TRUE(error <= absolute(to_rational(bounds.first) - x));
      EXPECT_TRUE(error <= absolute(to_rational(bounds.second) - x));
    });
  }
  EXPECT_EQ(to_nearest_double(power_of_two_by_products(1025)), infinity);
  EXPECT_EQ(to_nearest_double(-power_of_two_by_products(1025)), -infinity);
  EXPECT_EQ(to_nearest_double(power_of_two_by_products(-1075)), 0); // halfway: the lower one
}

// The number with the smallest denominator by trying them in turn.
std::pair<long long, long long> simplest_by_trial(long long a, long long b, long long c, long long d) // in [a/b, c/d]
{
  for (long long q = 1;; ++q) {
    const auto floor_div = [](long long n, long long m) { return n / m - (n % m != 0 && n < 0); };
    const long long first = -floor_div(-a * q, b);
    const long long last = floor_div(c * q, d);
    if (first > last)
      continue;
    return {first <= 0 && last >= 0 ? 0 : std::abs(first) < std::abs(last) ? first : last, q};
  }
}

TEST(simplest_rational_between, agrees_with_trial_of_all_denominators)
{
  Random random(105);
  int tried = 0;
  while (tried < 3000) {
    const long long limit = 1LL << uniform(random, 1, 12);
    const long long b = uniform(random, 1, limit), d = uniform(random, 1, limit);
    const long long a = uniform(random, -4 * limit, 4 * limit);
    const long long c =
        tried % 2 == 0 ? uniform(random, -4 * limit, 4 * limit) : a * d / b + uniform(random, 0, 1); // a/b ~ c/d
    if (a * d > c * b)
      continue;
    const auto [p, q] = simplest_by_trial(a, b, c, d);
    EXPECT_TRUE(simplest_rational_between(ratio(a, b), ratio(c, d)) == ratio(p, q))
        << a << '/' << b << ' ' << c << '/' << d;
    ++tried;
  }
}

TEST(simplest_rational_between, recovers_a_planted_rational)
{
  Random random(106);
  for (int i = 0; i < 300; ++i) {
    const long long q = uniform(random, 1, 1LL << 40);
    const Exact_rational planted = ratio(uniform(random, -(1LL << 45), 1LL << 45), q);
    // Two rationals with denominators up to q are at least 1/q^2 apart.
    const Exact_rational radius = ratio(1, q) * ratio(1, 3 * q);
    const Exact_rational below = radius * ratio(uniform(random, 0, 1000), 1000);
    const Exact_rational above = radius * ratio(uniform(random, 0, 1000), 1000);
    EXPECT_TRUE(simplest_rational_between(planted - below, planted + above) == planted);
  }
}

TEST(simplest_rational_between, special_intervals)
{
  const auto between = [](const Exact_rational& a, const Exact_rational& b) { return simplest_rational_between(a, b); };
  EXPECT_TRUE(between(Exact_rational(0), Exact_rational(0)) == Exact_rational(0));
  EXPECT_TRUE(between(ratio(-1, 7), ratio(1, 5)) == Exact_rational(0));
  EXPECT_TRUE(between(Exact_rational(0), ratio(1, 5)) == Exact_rational(0));
  EXPECT_TRUE(between(ratio(-1, 5), Exact_rational(0)) == Exact_rational(0));
  EXPECT_TRUE(between(ratio(22, 7), ratio(22, 7)) == ratio(22, 7));
  EXPECT_TRUE(between(ratio(5, 2), ratio(9, 2)) == Exact_rational(3));
  EXPECT_TRUE(between(ratio(-9, 2), ratio(-5, 2)) == Exact_rational(-3));
  EXPECT_TRUE(between(ratio(314, 100), ratio(315, 100)) == ratio(22, 7));
  EXPECT_THROW(between(Exact_rational(1), Exact_rational(0)), Invalid_input);
}

// Whether x = m 2^e with an integer |m| <= 2^bits.
bool is_dyadic_with(const Exact_rational& x, int bits)
{
  internal::Rational_parts parts = internal::parts_of(x);
  // Not all types reduce: x is dyadic iff some 2^k x is an integer.
  Exact_integer n = CGAL::sign(parts.numerator) == CGAL::NEGATIVE ? Exact_integer(-parts.numerator) : parts.numerator;
  const Exact_integer two(2);
  for (int i = 0; i < 3000; ++i) {
    const Exact_integer quotient = CGAL::div(n, parts.denominator);
    if (quotient * parts.denominator == n) {
      Exact_integer m = quotient;
      while (m != Exact_integer(0) && CGAL::div(m, two) * two == m)
        m = CGAL::div(m, two);
      return !(internal::integer_power_of_two(bits) < m);
    }
    n *= two;
  }
  return false;
}

TEST(round_to_dyadic, keeps_to_the_bits_and_the_error_bound)
{
  Random random(107);
  for (int i = 0; i < 200; ++i) {
    const Exact_rational x = random_wide_rational(random, 300);
    const int bits = static_cast<int>(uniform(random, 1, 80));
    const Exact_rational rounded = round_to_dyadic(x, bits);
    EXPECT_TRUE(is_dyadic_with(rounded, bits));
    EXPECT_TRUE(absolute(rounded - x) <= absolute(x) * power_of_two_by_products(-bits));
    EXPECT_TRUE(round_to_dyadic(rounded, bits) == rounded);
    EXPECT_TRUE(round_to_dyadic(-x, bits) == -rounded);
    const Exact_rational larger = x + absolute(x) * ratio(uniform(random, 0, 1000), 4000);
    EXPECT_TRUE(rounded <= round_to_dyadic(larger, bits));
  }
}

TEST(round_to_dyadic, known_values)
{
  EXPECT_TRUE(round_to_dyadic(ratio(1, 3), 3) == ratio(5, 16));
  EXPECT_TRUE(round_to_dyadic(ratio(-1, 3), 3) == ratio(-5, 16));
  EXPECT_TRUE(round_to_dyadic(Exact_rational(7), 2) == Exact_rational(8)); // halfway, away from zero
  EXPECT_TRUE(round_to_dyadic(Exact_rational(3), 1) == Exact_rational(4));
  EXPECT_TRUE(round_to_dyadic(Exact_rational(1), 1) == Exact_rational(1));
  EXPECT_TRUE(round_to_dyadic(Exact_rational(0), 5) == Exact_rational(0));
  EXPECT_TRUE(round_to_dyadic(ratio(1, 3), 53) == to_rational(1.0 / 3.0));
  EXPECT_THROW(round_to_dyadic(Exact_rational(1), 0), Invalid_input);
}

TEST(integer_bit_length, agrees_with_the_powers_of_two)
{
  for (const int n : {1, 2, 3, 31, 32, 33, 64, 100, 1023, 3000}) {
    const Exact_integer power = internal::integer_power_of_two(n);
    const Exact_integer below = power - Exact_integer(1);
    EXPECT_EQ(internal::integer_bit_length(power), n + 1);
    EXPECT_EQ(internal::integer_bit_length(below), n);
  }
  EXPECT_EQ(internal::integer_bit_length(Exact_integer(1)), 1);
}

TEST(next_above, agrees_with_the_library)
{
  constexpr double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();
  const auto check = [&](double x) {
    EXPECT_EQ(internal::next_above(x), std::nextafter(x, infinity)) << x;
    EXPECT_EQ(internal::next_below(x), std::nextafter(x, -infinity)) << x;
  };
  for (const double x : {0.0, 0x1p-1074, 0x1p-1022, 0.5, 1.0, largest, infinity}) {
    check(x);
    check(-x);
  }
  Random random(1);
  for (int i = 0; i < 1000; ++i)
    check(random_double(random));
  EXPECT_TRUE(std::isnan(internal::next_above(std::numeric_limits<double>::quiet_NaN())));
}

} // namespace

} // namespace number_enclosure_test
