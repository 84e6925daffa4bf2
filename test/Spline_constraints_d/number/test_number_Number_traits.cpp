// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/number/Number_traits.h>

#include <gtest/gtest.h>

#include "test_number_utilities.h"

#include <array>
#include <climits>
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace number_Number_traits_test {

namespace {

using namespace CGAL::Spline_constraints;
using namespace number_testing;
using Interval = CGAL::Interval_nt<false>;

// An arithmetic expression as a list of instructions, the operands of each being results of earlier ones.
struct Instruction
{
  enum Kind
  {
    leaf,
    sum,
    difference,
    product,
    opposite,
    quotient,
    half_sum,
    scaling
  } kind;
  int left = 0, right = 0, exponent = 0;
  Exact_rational value = Exact_rational(0); // of a leaf
};

struct Expression
{
  std::vector<Instruction> instructions;
  std::vector<Exact_rational> values; // the exact results
};

// Random, with divisors that are not zero. Now and then the same number is computed twice and subtracted, so that
// exact zeros occur.
Expression random_expression(Random& random, int size)
{
  Expression e;
  const auto append = [&e](const Instruction& instruction, const Exact_rational& value) {
    e.instructions.push_back(instruction);
    e.values.push_back(value);
    return static_cast<int>(e.values.size()) - 1;
  };
  for (int i = 0; i < 4; ++i) {
    Instruction leaf{Instruction::leaf};
    leaf.value =
        i % 2 == 0 ? random_rational(random, 10) : ratio(uniform(random, -20, 20), 1LL << uniform(random, 0, 6));
    append(leaf, leaf.value);
  }
  while (static_cast<int>(e.values.size()) < size) {
    Instruction next{static_cast<Instruction::Kind>(uniform(random, Instruction::sum, Instruction::scaling))};
    const int last = static_cast<int>(e.values.size()) - 1;
    next.left = static_cast<int>(uniform(random, 0, last));
    next.right = static_cast<int>(uniform(random, 0, last));
    next.exponent = static_cast<int>(uniform(random, -9, 9));
    const Exact_rational a = e.values[next.left], b = e.values[next.right];
    switch (next.kind) {
    case Instruction::sum:
      append(next, a + b);
      break;
    case Instruction::difference:
      append(next, a - b);
      break;
    case Instruction::product:
      append(next, a * b);
      break;
    case Instruction::opposite:
      append(next, -a);
      break;
    case Instruction::quotient:
      if (CGAL::sign(b) != CGAL::ZERO)
        append(next, a / b);
      break;
    case Instruction::half_sum:
      append(next, (a + b) / Exact_rational(2));
      break;
    default:
      append(next, a * power_of_two_by_products(next.exponent));
    }
  }
  // (x + y)(x - y) - (x x - y y): an exact zero for which inexact types have to be uncertain or exact.
  const Exact_rational x = e.values[0], y = e.values[1];
  const int s = append({Instruction::sum, 0, 1}, x + y);
  const int d = append({Instruction::difference, 0, 1}, x - y);
  const int p = append({Instruction::product, s, d}, (x + y) * (x - y));
  const int xx = append({Instruction::product, 0, 0}, x * x);
  const int yy = append({Instruction::product, 1, 1}, y * y);
  const int q = append({Instruction::difference, xx, yy}, x * x - y * y);
  append({Instruction::difference, p, q}, Exact_rational(0));
  return e;
}

template <typename NT>
std::vector<NT> evaluate(const Expression& e)
{
  using Traits = Number_traits<NT>;
  std::vector<NT> results;
  for (const Instruction& i : e.instructions) {
    switch (i.kind) {
    case Instruction::leaf:
      results.push_back(Traits::from_rational(i.value));
      break;
    case Instruction::sum:
      results.push_back(results[i.left] + results[i.right]);
      break;
    case Instruction::difference:
      results.push_back(results[i.left] - results[i.right]);
      break;
    case Instruction::product:
      results.push_back(results[i.left] * results[i.right]);
      break;
    case Instruction::opposite:
      results.push_back(-results[i.left]);
      break;
    case Instruction::quotient:
      results.push_back(results[i.left] / results[i.right]);
      break;
    case Instruction::half_sum:
      results.push_back(Traits::half_sum(results[i.left], results[i.right]));
      break;
    default: {
      NT scaled = results[i.left];
      Traits::scale_by_power_of_two(scaled, i.exponent);
      results.push_back(scaled);
    }
    }
  }
  return results;
}

// Exact bounds on |results[i] - values[i]| for doubles, from unit_roundoff and underflow_error alone. A quotient
// whose divisor is not safely away
// from 0 ends the analysis: its bound, and those from there on, are left out.
std::vector<Exact_rational> error_bounds(const Expression& e, const std::vector<double>& results)
{
  using Traits = Number_traits<double>;
  const Exact_rational u = to_rational(Traits::unit_roundoff), eta = to_rational(Traits::underflow_error);
  std::vector<Exact_rational> bounds;
  for (std::size_t i = 0; i < e.instructions.size(); ++i) {
    const Instruction& instruction = e.instructions[i];
    const bool is_leaf = instruction.kind == Instruction::leaf;
    if (!std::isfinite(results[i]))
      break;
    const Exact_rational own = u * absolute(to_rational(results[i])) + eta;
    const Exact_rational left = is_leaf ? Exact_rational(0) : bounds[instruction.left];
    const Exact_rational right = is_leaf ? Exact_rational(0) : bounds[instruction.right];
    const Exact_rational a = is_leaf ? Exact_rational(0) : absolute(to_rational(results[instruction.left]));
    const Exact_rational b = is_leaf ? Exact_rational(0) : absolute(to_rational(results[instruction.right]));
    Exact_rational bound;
    switch (instruction.kind) {
    case Instruction::leaf:
      bound = own;
      break;
    case Instruction::sum:
    case Instruction::difference:
      bound = left + right + own;
      break;
    case Instruction::opposite:
      bound = left;
      break;
    case Instruction::product:
      bound = a * right + b * left + left * right + own;
      break;
    case Instruction::quotient:
      if (b <= right)
        return bounds;
      bound = (left + a / b * right) / (b - right) + own;
      break;
    case Instruction::half_sum:
      bound = (left + right) / Exact_rational(2) + own;
      break;
    default:
      bound = left * power_of_two_by_products(instruction.exponent) + own;
    }
    bounds.push_back(bound);
  }
  return bounds;
}

bool encloses(const Interval& interval, const Exact_rational& x)
{
  return (interval.inf() == -infinity || to_rational(interval.inf()) <= x) &&
         (interval.sup() == infinity || x <= to_rational(interval.sup()));
}

template <typename NT>
class Number_traits_laws : public ::testing::Test
{};

struct Type_names
{
  template <typename NT>
  static std::string GetName(int)
  {
    return Number_traits<NT>::name;
  }
};

using All_types = ::testing::Types<double, Interval, Mpfr_interval, Exact_rational>;
TYPED_TEST_SUITE(Number_traits_laws, All_types, Type_names);

TYPED_TEST(Number_traits_laws, constants_and_types)
{
  using Traits = Number_traits<TypeParam>;
  constexpr bool is_double = std::is_same_v<TypeParam, double>;
  constexpr bool is_interval = std::is_same_v<TypeParam, Interval>;
  EXPECT_EQ(Traits::is_exact, (std::is_same_v<TypeParam, Exact_rational>));
  EXPECT_EQ(Traits::is_enclosure, is_interval || (std::is_same_v<TypeParam, Mpfr_interval>));
  EXPECT_EQ(Traits::unit_roundoff, is_double ? 0x1p-52 : 0.0);
  EXPECT_EQ(Traits::underflow_error, is_double ? denormal : 0.0);
  EXPECT_EQ((std::is_same_v<typename Traits::Coordinate, double>), is_double || is_interval);
  EXPECT_EQ((std::is_same_v<typename Traits::Coordinate, Exact_rational>), !is_double && !is_interval);
  EXPECT_EQ((std::is_same_v<typename Traits::Rounding_guard, Upward_rounding_guard>), is_interval);
}

TYPED_TEST(Number_traits_laws, expressions_keep_what_the_type_promises)
{
  using Traits = Number_traits<TypeParam>;
  Random random(201);
  int checked = 0, certain = 0, uncertain = 0;
  for (int i = 0; i < 60; ++i) {
    const Expression e = random_expression(random, 20);
    in_each_rounding_mode([&]() {
      [[maybe_unused]] const typename Traits::Rounding_guard guard;
      const std::vector<TypeParam> results = evaluate<TypeParam>(e);
      ASSERT_EQ(results.size(), e.values.size());
      if constexpr (Traits::is_exact || Traits::is_enclosure) {
        for (std::size_t k = 0; k < results.size(); ++k) {
          EXPECT_TRUE(encloses(Traits::enclosure(results[k]), e.values[k])) << k;
          if constexpr (Traits::is_exact) {
            EXPECT_TRUE(results[k] == e.values[k]) << k;
          }
          if constexpr (std::is_same_v<TypeParam, Mpfr_interval>) {
            EXPECT_TRUE(results[k].contains(e.values[k])) << k;
          }
          const CGAL::Uncertain<CGAL::Sign> sign = Traits::sign(results[k]);
          EXPECT_LE(sign.inf(), CGAL::sign(e.values[k])) << k;
          EXPECT_GE(sign.sup(), CGAL::sign(e.values[k])) << k;
          ++(sign.is_certain() ? certain : uncertain);
          ++checked;
        }
      } else {
        const std::vector<Exact_rational> bounds = error_bounds(e, results);
        for (std::size_t k = 0; k < bounds.size(); ++k) {
          EXPECT_TRUE(absolute(to_rational(results[k]) - e.values[k]) <= bounds[k]) << k;
          // The sign of a double is certain iff the double exceeds its bound.
          const bool is_certain = absolute(to_rational(results[k])) > bounds[k];
          if (is_certain) {
            EXPECT_EQ(Traits::sign(results[k]).make_certain(), CGAL::sign(e.values[k])) << k;
          }
          ++(is_certain ? certain : uncertain);
          ++checked;
        }
      }
    });
  }
  EXPECT_GT(checked, 2000);
  EXPECT_GT(certain, checked / 2);
  EXPECT_EQ(uncertain == 0, Traits::is_exact);
}

TYPED_TEST(Number_traits_laws, from_double_is_exact)
{
  using Traits = Number_traits<TypeParam>;
  Random random(202);
  for (int i = 0; i < 100; ++i) {
    const double x = std::ldexp(static_cast<double>(uniform(random, -(1LL << 53), 1LL << 53)),
                                static_cast<int>(uniform(random, -1074, 970)));
    in_each_rounding_mode([&]() {
      const Interval enclosure = Traits::enclosure(Traits::from_double(x));
      EXPECT_EQ(enclosure.inf(), x);
      EXPECT_EQ(enclosure.sup(), x);
    });
  }
  for (const double x : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(Traits::from_double(x), Invalid_input);
}

TYPED_TEST(Number_traits_laws, from_rational_is_as_near_as_the_type_allows)
{
  using Traits = Number_traits<TypeParam>;
  Random random(203);
  int inexact = 0;
  for (int i = 0; i < 150; ++i) {
    const Exact_rational x = random_wide_rational(random, 1100);
    const std::pair<double, double> tightest = to_double_interval(x);
    in_each_rounding_mode([&]() {
      const TypeParam converted = Traits::from_rational(x);
      const Interval enclosure = Traits::enclosure(converted);
      if constexpr (std::is_same_v<TypeParam, double>) {
        EXPECT_TRUE(converted == tightest.first || converted == tightest.second);
        inexact += tightest.first != tightest.second;
      } else {
        EXPECT_EQ(enclosure.inf(), tightest.first);
        EXPECT_EQ(enclosure.sup(), tightest.second);
        inexact += enclosure.inf() != enclosure.sup();
      }
    });
  }
  EXPECT_GT(inexact, 300);
}

TYPED_TEST(Number_traits_laws, scaling_is_exact)
{
  using Traits = Number_traits<TypeParam>;
  Random random(204);
  for (int i = 0; i < 100; ++i) {
    const double x = static_cast<double>(uniform(random, -(1LL << 53), 1LL << 53));
    const int exponent = static_cast<int>(uniform(random, -1074, 970));
    in_each_rounding_mode([&]() {
      [[maybe_unused]] const typename Traits::Rounding_guard guard;
      TypeParam scaled = Traits::from_double(x);
      Traits::scale_by_power_of_two(scaled, exponent);
      EXPECT_EQ(Traits::enclosure(scaled).inf(), std::ldexp(x, exponent));
      EXPECT_EQ(Traits::enclosure(scaled).sup(), std::ldexp(x, exponent));
      Traits::scale_by_power_of_two(scaled, -exponent);
      EXPECT_EQ(Traits::enclosure(scaled).inf(), x);
      EXPECT_EQ(Traits::enclosure(scaled).sup(), x);
    });
  }
}

TYPED_TEST(Number_traits_laws, scaling_out_of_the_range_of_doubles)
{
  using Traits = Number_traits<TypeParam>;
  constexpr bool has_own_range = std::is_same_v<typename Traits::Coordinate, Exact_rational>;
  in_each_rounding_mode([]() {
    [[maybe_unused]] const typename Traits::Rounding_guard guard;
    TypeParam up = Traits::from_double(3), down = up;
    Traits::scale_by_power_of_two(up, 5000);
    Traits::scale_by_power_of_two(down, -5000);
    EXPECT_EQ(Traits::enclosure(up).sup(), infinity);
    EXPECT_GE(Traits::enclosure(down).inf(), 0);
    EXPECT_LE(Traits::enclosure(down).sup(), denormal);
    if constexpr (Traits::is_enclosure || Traits::is_exact) {
      EXPECT_TRUE(encloses(Traits::enclosure(up), Exact_rational(3) * power_of_two_by_products(5000)));
      EXPECT_TRUE(encloses(Traits::enclosure(down), Exact_rational(3) * power_of_two_by_products(-5000)));
    }
    if constexpr (has_own_range) {
      EXPECT_EQ(Traits::sign(down).make_certain(), CGAL::POSITIVE);
      Traits::scale_by_power_of_two(up, -5000);
      EXPECT_EQ(Traits::enclosure(up).inf(), 3);
      EXPECT_EQ(Traits::enclosure(up).sup(), 3);
    } else {
      TypeParam extreme = Traits::from_double(1);
      Traits::scale_by_power_of_two(extreme, INT_MIN);
      EXPECT_LE(Traits::enclosure(extreme).sup(), denormal);
      extreme = Traits::from_double(1);
      Traits::scale_by_power_of_two(extreme, INT_MAX);
      EXPECT_GT(Traits::enclosure(extreme).sup(), largest);
    }
  });
}

TYPED_TEST(Number_traits_laws, half_sum_is_exact_where_doubles_are)
{
  using Traits = Number_traits<TypeParam>;
  Random random(205);
  for (int i = 0; i < 100; ++i) {
    const double a = static_cast<double>(uniform(random, -(1LL << 50), 1LL << 50));
    const double b = static_cast<double>(uniform(random, -(1LL << 50), 1LL << 50));
    in_each_rounding_mode([&]() {
      [[maybe_unused]] const typename Traits::Rounding_guard guard;
      const Interval result = Traits::enclosure(Traits::half_sum(Traits::from_double(a), Traits::from_double(b)));
      EXPECT_EQ(result.inf(), (a + b) / 2);
      EXPECT_EQ(result.sup(), (a + b) / 2);
    });
  }
}

TYPED_TEST(Number_traits_laws, sign_of_points)
{
  using Traits = Number_traits<TypeParam>;
  in_each_rounding_mode([]() {
    EXPECT_EQ(Traits::sign(Traits::from_double(denormal)).make_certain(), CGAL::POSITIVE);
    EXPECT_EQ(Traits::sign(Traits::from_double(-denormal)).make_certain(), CGAL::NEGATIVE);
    EXPECT_EQ(Traits::sign(Traits::from_double(0.0)).make_certain(), CGAL::ZERO);
    EXPECT_EQ(Traits::sign(Traits::from_double(-0.0)).make_certain(), CGAL::ZERO);
  });
}

TEST(Number_traits_double, what_overflow_leaves_says_nothing)
{
  using Traits = Number_traits<double>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(CGAL::is_indeterminate(Traits::sign(nan)));
  EXPECT_EQ(Traits::sign(infinity).make_certain(), CGAL::POSITIVE);
  for (const double x : {nan, infinity, -infinity, largest, -largest}) {
    EXPECT_EQ(Traits::enclosure(x).inf(), -infinity);
    EXPECT_EQ(Traits::enclosure(x).sup(), infinity);
  }
  EXPECT_TRUE(Traits::enclosure(std::nextafter(largest, 0)).is_point());
  EXPECT_EQ(Traits::from_rational(power_of_two_by_products(1100)), infinity);
  EXPECT_EQ(Traits::from_rational(-power_of_two_by_products(1100)), -infinity);
}

TEST(Number_traits_interval, signs_of_proper_intervals)
{
  using Traits = Number_traits<Interval>;
  const auto expect_range = [](const Interval& x, CGAL::Sign low, CGAL::Sign high) {
    EXPECT_EQ(Traits::sign(x).inf(), low);
    EXPECT_EQ(Traits::sign(x).sup(), high);
  };
  expect_range(Interval(1, 2), CGAL::POSITIVE, CGAL::POSITIVE);
  expect_range(Interval(0, 2), CGAL::ZERO, CGAL::POSITIVE);
  expect_range(Interval(-1, 0), CGAL::NEGATIVE, CGAL::ZERO);
  expect_range(Interval(-1, 1), CGAL::NEGATIVE, CGAL::POSITIVE);
  expect_range(Interval(-2, -1), CGAL::NEGATIVE, CGAL::NEGATIVE);
  expect_range(Interval::largest(), CGAL::NEGATIVE, CGAL::POSITIVE);
}

TEST(Number_traits_interval, ends_that_are_not_numbers_say_nothing)
{
  using Traits = Number_traits<Interval>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Interval& x : {Interval(nan, 1, Interval::no_check_t()), Interval(1, nan, Interval::no_check_t()),
                            Interval(nan, nan, Interval::no_check_t())}) {
    EXPECT_TRUE(CGAL::is_indeterminate(Traits::sign(x)));
    EXPECT_EQ(Traits::enclosure(x).inf(), -infinity);
    EXPECT_EQ(Traits::enclosure(x).sup(), infinity);
  }
}

TEST(Number_traits_interval, leaves_to_multiprecision_what_doubles_cannot_decide)
{
  // x^2 - 2 at an approximation of the root of 2 to 90 bits: within the reach of 256 bits, out of that of doubles.
  const Exact_rational x = round_to_dyadic(
      simplest_rational_between(ratio(141421356237LL, 100000000000LL), ratio(141421356238LL, 100000000000LL)), 60);
  Exact_rational root = x;
  for (int i = 0; i < 3; ++i)
    root = round_to_dyadic((root + Exact_rational(2) / root) / Exact_rational(2), 90);
  const auto sign_of_square_minus_two = [&root]<typename NT>(NT) {
    using Traits = Number_traits<NT>;
    [[maybe_unused]] const typename Traits::Rounding_guard guard;
    const NT r = Traits::from_rational(root);
    const NT value = r * r - Traits::from_double(2);
    return Traits::sign(value);
  };
  const CGAL::Sign exact = CGAL::sign(Exact_rational(root * root - Exact_rational(2)));
  EXPECT_NE(exact, CGAL::ZERO);
  EXPECT_TRUE(CGAL::is_indeterminate(sign_of_square_minus_two(Interval())));
  const Mpfr_precision_scope scope(256);
  EXPECT_EQ(sign_of_square_minus_two(Mpfr_interval()).make_certain(), exact);
  EXPECT_EQ(sign_of_square_minus_two(Exact_rational()).make_certain(), exact);
}

} // namespace

} // namespace number_Number_traits_test
