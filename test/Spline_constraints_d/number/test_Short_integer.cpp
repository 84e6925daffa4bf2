// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Integers of two words and longer ones against those of GMP: every operation, around the lengths where one becomes the
// other.

#include <CGAL/Spline_constraints_d/number/Short_integer.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace Short_integer_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::internal::Big_integer;
using SC::internal::Short_integer;
using SC::internal::Unsigned_two_words;
using Engine = std::mt19937_64;

// Of up to 150 bits, and often next to a power of two.
Big_integer random_integer(Engine& engine)
{
  const unsigned bits = engine() % 150;
  Big_integer value = Big_integer(1) << bits;
  if (engine() % 2 == 0)
    value += static_cast<long>(engine() % 5) - 2;
  else
    value += ((Big_integer(engine()) << 128) + (Big_integer(engine()) << 64) + Big_integer(engine())) % value;
  return engine() % 2 == 0 ? value : Big_integer(-value);
}

// Sometimes in memory although two words would do.
Short_integer short_of(const Big_integer& value, Engine& engine)
{
  Short_integer result(value);
  if (engine() % 4 == 0) {
    const Short_integer detour = Short_integer(Big_integer(Big_integer(1) << 140));
    result += detour;
    result -= detour;
  }
  return result;
}

TEST(Short_integer, AgreesWithGmp)
{
  Engine engine(1);
  int long_ones = 0;
  for (int i = 0; i < 20000; ++i) {
    const Big_integer a = random_integer(engine), b = random_integer(engine), c = random_integer(engine);
    const Short_integer x = short_of(a, engine), y = short_of(b, engine), z = short_of(c, engine);
    ASSERT_EQ(x.to_big_integer(), a);
    EXPECT_EQ((x + y).to_big_integer(), Big_integer(a + b));
    EXPECT_EQ((x - y).to_big_integer(), Big_integer(a - b));
    EXPECT_EQ((x * y).to_big_integer(), Big_integer(a * b));
    EXPECT_EQ((-x).to_big_integer(), Big_integer(-a));
    if (b != 0) {
      EXPECT_EQ((x / y).to_big_integer(), Big_integer(a / b));
      EXPECT_EQ((x % y).to_big_integer(), Big_integer(a % b));
    }
    EXPECT_EQ(gcd(x, y).to_big_integer(), Big_integer(gcd(a, b)));
    Short_integer sum = z;
    add_product(sum, x, y);
    EXPECT_EQ(sum.to_big_integer(), Big_integer(c + a * b));
    Short_integer square = x;
    square *= square;
    EXPECT_EQ(square.to_big_integer(), Big_integer(a * a));
    const unsigned long shift = engine() % 140;
    Short_integer shifted;
    set_shifted(shifted, x, shift);
    EXPECT_EQ(shifted.to_big_integer(), Big_integer(a << shift));
    shift_left(shifted, 3);
    EXPECT_EQ(shifted.to_big_integer(), Big_integer(a << (shift + 3)));
    EXPECT_EQ(x == y, a == b);
    EXPECT_EQ(x < y, a < b);
    EXPECT_EQ(x.sign(), a.sign());
    EXPECT_EQ(bit_length(x), SC::internal::bit_length(a));
    EXPECT_EQ(is_power_of_two(x), a > 0 && mpz_popcount(a.backend().data()) == 1);
    EXPECT_EQ(to_scaled_double(x, -20), SC::internal::to_scaled_double(a, -20));
    long_ones += bit_length(x) > 127;
  }
  EXPECT_GT(long_ones, 1000);
}

TEST(Short_integer, IsCopiedAndMoved)
{
  const Big_integer big = Big_integer(1) << 200;
  std::vector<Short_integer> values{Short_integer(7), Short_integer(big), Short_integer(-7)};
  std::vector<Short_integer> copies = values;
  values[0] = values[1];
  values[1] = Short_integer(-3);
  copies.insert(copies.begin(), std::move(values[0]));
  copies[3] = std::move(copies[2]);
  EXPECT_EQ(copies[0].to_big_integer(), big);
  EXPECT_EQ(copies[1], 7);
  EXPECT_EQ(copies[3].to_big_integer(), big);
  EXPECT_EQ(values[1], -3);
}

TEST(Short_integer, QuotientsAreTruncated)
{
  Engine engine(2);
  for (int i = 0; i < 5000; ++i) {
    const Big_integer numerator = random_integer(engine), denominator = abs(random_integer(engine)) + 1;
    const long most = 127 - SC::internal::bit_length(numerator) + SC::internal::bit_length(denominator) - 1,
               shift = most - static_cast<long>(engine() % 100);
    const Big_integer size = abs(numerator);
    const Big_integer expected = shift >= 0 ? Big_integer((size << static_cast<unsigned>(shift)) / denominator)
                                            : Big_integer((size >> static_cast<unsigned>(-shift)) / denominator);
    const Unsigned_two_words found = scaled_quotient(short_of(numerator, engine), shift, short_of(denominator, engine));
    EXPECT_EQ((Big_integer(static_cast<unsigned long>(found >> 64)) << 64) + static_cast<unsigned long>(found),
              expected)
        << numerator << ' ' << denominator << ' ' << shift;
  }
}

TEST(Short_integer, HoldsRationalsOverCommonDenominators)
{
  Engine engine(3);
  for (int i = 0; i < 2000; ++i) {
    const Exact_rational a =
        SC::internal::quotient(random_integer(engine), Big_integer(abs(random_integer(engine)) + 1));
    const Exact_rational b =
        SC::internal::quotient(random_integer(engine), Big_integer(1) << static_cast<unsigned>(engine() % 140));
    Short_integer common(1);
    extend_common_denominator(common, a);
    extend_common_denominator(common, b);
    EXPECT_EQ(common.to_big_integer(),
              Big_integer(lcm(SC::internal::denominator_of(a), SC::internal::denominator_of(b))));
    for (const Exact_rational& x : {a, b}) {
      Exact_rational back(5);
      set_quotient(back, numerator_over(x, common), common);
      EXPECT_EQ(back, x);
    }
  }
}

TEST(Short_integer, DoublesAreTaken)
{
  for (const double x : {0.0, 1.0, -0.1, 1e300, -3e-300}) {
    const auto [mantissa, exponent] = SC::internal::to_dyadic<Short_integer>(x);
    EXPECT_EQ(SC::internal::scaled_rational(mantissa.to_big_integer(), exponent), Exact_rational(x));
    EXPECT_EQ(to_scaled_double(mantissa, exponent), x);
  }
}

} // namespace

} // namespace Short_integer_test
