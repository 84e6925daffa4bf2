// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>

#include <gtest/gtest.h>

#include "test_number_utilities.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace number_Mpfr_interval_test {

namespace {

using namespace CGAL::Spline_constraints;
using namespace number_testing;

static_assert(std::is_nothrow_move_constructible_v<Mpfr_interval> && std::is_nothrow_move_assignable_v<Mpfr_interval>);
static_assert(!std::is_constructible_v<Mpfr_interval, long double>);

struct Bounds
{
  Exact_rational lower, upper;
};

// Mixed signs, points, zeros at either end.
Bounds random_bounds(Random& random, bool with_fractions)
{
  const auto number = [&]() {
    if (uniform(random, 0, 5) == 0)
      return Exact_rational(0);
    return with_fractions ? random_rational(random, 30)
                          : ratio(uniform(random, -64, 64), 1LL << uniform(random, 0, 10));
  };
  Bounds bounds{number(), number()};
  if (bounds.upper < bounds.lower)
    std::swap(bounds.lower, bounds.upper);
  if (uniform(random, 0, 9) == 0)
    bounds.upper = bounds.lower;
  return bounds;
}

Mpfr_interval interval_of(const Bounds& bounds, mpfr_prec_t precision = 53)
{
  return Mpfr_interval(bounds.lower, bounds.upper, precision);
}

// The exact result set of an operation that is monotone in each operand: the hull of its values at the ends.
template <typename Operation>
Bounds hull_of_ends(const Bounds& a, const Bounds& b, Operation operation)
{
  const std::array<Exact_rational, 4> values = {operation(a.lower, b.lower), operation(a.lower, b.upper),
                                                operation(a.upper, b.lower), operation(a.upper, b.upper)};
  return {*std::min_element(values.begin(), values.end()), *std::max_element(values.begin(), values.end())};
}

bool contains_zero(const Bounds& b) { return !(Exact_rational(0) < b.lower) && !(b.upper < Exact_rational(0)); }

// result contains `exact`, and each end is off by less than one unit in its last place: it was rounded once, in the
// right direction.
void expect_rounded_once(const Mpfr_interval& result, const Bounds& exact)
{
  const Exact_rational unit = power_of_two_by_products(1 - static_cast<int>(result.precision()));
  ASSERT_TRUE(result.is_bounded());
  EXPECT_TRUE(result.contains(exact.lower));
  EXPECT_TRUE(result.contains(exact.upper));
  EXPECT_TRUE(exact.lower - result.lower() <= absolute(exact.lower) * unit);
  EXPECT_TRUE(result.upper() - exact.upper <= absolute(exact.upper) * unit);
}

const auto plus = [](const Exact_rational& x, const Exact_rational& y) -> Exact_rational { return x + y; };
const auto minus = [](const Exact_rational& x, const Exact_rational& y) -> Exact_rational { return x - y; };
const auto times = [](const Exact_rational& x, const Exact_rational& y) -> Exact_rational { return x * y; };
const auto over = [](const Exact_rational& x, const Exact_rational& y) -> Exact_rational { return x / y; };

TEST(Mpfr_interval, operations_on_ends_that_fit_are_rounded_once)
{
  Random random(301);
  int divisions = 0;
  for (int i = 0; i < 1500; ++i) {
    const Bounds a = random_bounds(random, false), b = random_bounds(random, false);
    const mpfr_prec_t precision = uniform(random, 53, 200);
    const Mpfr_interval x = interval_of(a, precision), y = interval_of(b, 53);
    ASSERT_TRUE(x.lower() == a.lower && x.upper() == a.upper); // the operands are exact
    expect_rounded_once(x + y, hull_of_ends(a, b, plus));
    expect_rounded_once(x - y, hull_of_ends(a, b, minus));
    expect_rounded_once(x * y, hull_of_ends(a, b, times));
    expect_rounded_once(-x, {-a.upper, -a.lower});
    if (contains_zero(b)) {
      EXPECT_FALSE((x / y).is_bounded());
    } else {
      expect_rounded_once(x / y, hull_of_ends(a, b, over));
      ++divisions;
    }
    EXPECT_EQ((x * y).precision(), precision);
    EXPECT_EQ((y / x).precision(), precision);
  }
  EXPECT_GT(divisions, 300);
}

TEST(Mpfr_interval, operations_contain_in_every_rounding_mode)
{
  Random random(302);
  for (int i = 0; i < 100; ++i) {
    const Bounds a = random_bounds(random, true), b = random_bounds(random, true);
    Mpfr_interval first_sum, first_product;
    int mode = 0;
    in_each_rounding_mode([&]() {
      const Mpfr_interval x = interval_of(a), y = interval_of(b);
      const Bounds sum = hull_of_ends(a, b, plus), product = hull_of_ends(a, b, times);
      EXPECT_TRUE((x + y).contains(sum.lower) && (x + y).contains(sum.upper));
      EXPECT_TRUE((x * y).contains(product.lower) && (x * y).contains(product.upper));
      if (!contains_zero(b)) {
        const Bounds quotient = hull_of_ends(a, b, over);
        EXPECT_TRUE((x / y).contains(quotient.lower) && (x / y).contains(quotient.upper));
      }
      // Not only an enclosure in every mode: the same one.
      if (mode++ == 0) {
        first_sum = x + y;
        first_product = x * y;
      }
      EXPECT_TRUE(first_sum.is_same(x + y));
      EXPECT_TRUE(first_product.is_same(x * y));
    });
  }
}

TEST(Mpfr_interval, operations_with_doubles)
{
  Random random(303);
  for (int i = 0; i < 500; ++i) {
    const Bounds a = random_bounds(random, false);
    const double d = i % 10 == 0 ? 0.0 : static_cast<double>(uniform(random, -1000, 1000)) / 64;
    const Bounds point{to_rational(d), to_rational(d)};
    const Mpfr_interval x = interval_of(a, 80);
    expect_rounded_once(x + d, hull_of_ends(a, point, plus));
    expect_rounded_once(d + x, hull_of_ends(a, point, plus));
    expect_rounded_once(x - d, hull_of_ends(a, point, minus));
    expect_rounded_once(d - x, hull_of_ends(point, a, minus));
    expect_rounded_once(x * d, hull_of_ends(a, point, times));
    expect_rounded_once(d * x, hull_of_ends(a, point, times));
    if (d != 0)
      expect_rounded_once(x / d, hull_of_ends(a, point, over));
    else
      EXPECT_FALSE((x / d).is_bounded());
    if (!contains_zero(a))
      expect_rounded_once(d / x, hull_of_ends(point, a, over));
    else
      EXPECT_FALSE((d / x).is_bounded());
    for (const Mpfr_interval& result : {x + d, d - x, x * d, x / d, d / x})
      EXPECT_EQ(result.precision(), 80);
  }
  Mpfr_interval x(1);
  for (const double bad : {infinity, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(x += bad, Invalid_input);
    EXPECT_THROW(x -= bad, Invalid_input);
    EXPECT_THROW(x *= bad, Invalid_input);
    EXPECT_THROW(x /= bad, Invalid_input);
    EXPECT_THROW(Mpfr_interval{bad}, Invalid_input);
  }
  EXPECT_TRUE(x.is_same(Mpfr_interval(1))); // a refused operand leaves no trace
}

TEST(Mpfr_interval, operand_and_result_may_be_the_same_object)
{
  Random random(304);
  for (int i = 0; i < 200; ++i) {
    const Bounds a = random_bounds(random, true);
    const Mpfr_interval x = interval_of(a), copy = x;
    Mpfr_interval sum = x, difference = x, product = x, quotient = x;
    Mpfr_interval& sum_alias = sum;
    Mpfr_interval& difference_alias = difference;
    Mpfr_interval& product_alias = product;
    Mpfr_interval& quotient_alias = quotient;
    sum += sum_alias;
    difference -= difference_alias;
    product *= product_alias;
    quotient /= quotient_alias;
    EXPECT_TRUE(sum.is_same(x + copy));
    EXPECT_TRUE(difference.is_same(x - copy));
    EXPECT_TRUE(product.is_same(x * copy));
    EXPECT_TRUE(quotient.is_same(x / copy));
    Mpfr_interval assigned = x;
    Mpfr_interval& assigned_alias = assigned;
    assigned = assigned_alias;
    EXPECT_TRUE(assigned.is_same(x));
  }
}

TEST(Mpfr_interval, conversion_from_rationals_is_tightest)
{
  Random random(305);
  for (int i = 0; i < 200; ++i) {
    const Exact_rational x = random_wide_rational(random, 1500);
    const mpfr_prec_t precision = uniform(random, 53, 300);
    const Mpfr_interval interval(x, precision);
    EXPECT_EQ(interval.precision(), precision);
    expect_rounded_once(interval, {x, x});
    // The ends are the same or neighbours.
    if (!interval.is_point()) {
      internal::Mpfr_number next(precision);
      mpfr_set(next.get(), interval.lower_mpfr(), MPFR_RNDN);
      mpfr_nextabove(next.get());
      EXPECT_TRUE(mpfr_equal_p(next.get(), interval.upper_mpfr()));
      EXPECT_FALSE(interval.lower() == x || interval.upper() == x);
    }
  }
  EXPECT_TRUE(Mpfr_interval(Exact_rational(0)).is_point());
  EXPECT_TRUE(Mpfr_interval(ratio(3, 8)).is_point());
  EXPECT_FALSE(Mpfr_interval(ratio(1, 3)).is_point());
  EXPECT_THROW(Mpfr_interval(Exact_rational(1), Exact_rational(0)), Invalid_input);
}

TEST(Mpfr_interval, ways_that_know_the_type_of_the_rational_agree_with_those_that_do_not)
{
  Random random(306);
  for (int i = 0; i < 300; ++i) {
    const Exact_rational x = i == 0 ? Exact_rational(0) : random_wide_rational(random, 300);
    internal::Mpfr_number fast(150), general(150);
    for (const mpfr_rnd_t direction : {MPFR_RNDD, MPFR_RNDU}) {
      internal::set_from_rational(fast.get(), x, direction);
      internal::set_from_parts(general.get(), x, direction);
      EXPECT_TRUE(mpfr_equal_p(fast.get(), general.get()));
    }
    const Exact_rational back = internal::rational_of_mpfr<Exact_rational>(general.get());
    EXPECT_TRUE(back == internal::rational_from_digits(general.get()));
    EXPECT_EQ(internal::compare_mpfr(general.get(), back), 0);
    EXPECT_GT(internal::compare_mpfr(general.get(), Exact_rational(back - ratio(1, 7))), 0);
    EXPECT_LT(internal::compare_mpfr(general.get(), Exact_rational(back + ratio(1, 7))), 0);
  }
}

TEST(Mpfr_interval, precision_narrows_the_result)
{
  // 1/3 summed a hundred times: the width is proportional to 2^-precision.
  double former = infinity;
  for (const mpfr_prec_t precision : {53, 106, 212, 424, 848}) {
    const Mpfr_interval third(ratio(1, 3), precision);
    Mpfr_interval sum(Exact_rational(0), precision);
    for (int i = 0; i < 100; ++i)
      sum += third;
    EXPECT_TRUE(sum.contains(ratio(100, 3)));
    EXPECT_GT(sum.width(), 0);
    EXPECT_LT(sum.width(), former * 1e-15);
    former = sum.width();
  }
  EXPECT_LT(former, 1e-250);
}

TEST(Mpfr_interval, result_has_the_larger_precision)
{
  Mpfr_interval low(ratio(1, 3), 60);
  const Mpfr_interval high(ratio(1, 7), 500);
  EXPECT_EQ((low + high).precision(), 500);
  EXPECT_EQ((high - low).precision(), 500);
  EXPECT_EQ((low * 0.5).precision(), 60);
  const Mpfr_interval before = low;
  low += high;
  EXPECT_EQ(low.precision(), 500);
  EXPECT_TRUE(low.contains(ratio(10, 21)));
  low = before;
  EXPECT_EQ(low.precision(), 60);
  EXPECT_TRUE(low.is_same(before));
  EXPECT_EQ(Mpfr_interval::half_sum(low, high).precision(), 500);
}

TEST(Mpfr_interval, precision_scope_nests_and_restores)
{
  const mpfr_prec_t before = Mpfr_interval::default_precision();
  EXPECT_EQ(before, 128);
  {
    const Mpfr_precision_scope outer(200);
    EXPECT_EQ(Mpfr_interval().precision(), 200);
    {
      const Mpfr_precision_scope inner(64);
      EXPECT_EQ(Mpfr_interval(0.5).precision(), 64);
    }
    EXPECT_EQ(Mpfr_interval(ratio(1, 3)).precision(), 200);
    EXPECT_THROW(Mpfr_precision_scope{52}, Invalid_input);
    EXPECT_THROW(Mpfr_precision_scope{Mpfr_interval::maximum_precision + 1}, Invalid_input);
    EXPECT_EQ(Mpfr_interval::default_precision(), 200);
    EXPECT_THROW(
        {
          const Mpfr_precision_scope scope(300);
          throw std::runtime_error("through the scope");
        },
        std::runtime_error);
    EXPECT_EQ(Mpfr_interval::default_precision(), 200);
  }
  EXPECT_EQ(Mpfr_interval::default_precision(), before);
  EXPECT_THROW(Mpfr_interval(ratio(1, 3), 0), Invalid_input);
  EXPECT_THROW(Mpfr_interval(ratio(1, 3), -5), Invalid_input);
  EXPECT_THROW(Mpfr_interval::entire_line(1), Invalid_input);
}

TEST(Mpfr_interval, threads_have_their_own_precision_and_agree_on_results)
{
  ASSERT_TRUE(mpfr_buildopt_tls_p());
  const Mpfr_precision_scope scope(99);
  std::array<mpfr_prec_t, 4> initial{}, own{};
  std::array<bool, 4> contained{};
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&, t]() {
      initial[t] = Mpfr_interval::default_precision();
      const Mpfr_precision_scope thread_scope(100 + 50 * t);
      Exact_rational exact(1);
      Mpfr_interval product(1);
      for (int i = 1; i <= 200; ++i) {
        exact *= ratio(i + t, 2 * i + 1);
        product *= Mpfr_interval(ratio(i + t, 2 * i + 1));
      }
      own[t] = product.precision();
      contained[t] = product.contains(exact) && !product.contains(Exact_rational(0));
    });
  for (std::thread& thread : threads)
    thread.join();
  for (int t = 0; t < 4; ++t) {
    EXPECT_EQ(initial[t], 128);
    EXPECT_EQ(own[t], 100 + 50 * t);
    EXPECT_TRUE(contained[t]);
  }
  EXPECT_EQ(Mpfr_interval::default_precision(), 99);
}

TEST(Mpfr_interval, integers_are_converted_exactly)
{
  const auto is_integer = [](const Mpfr_interval& x, const Exact_rational& value) {
    return x.is_point() && x.lower() == value;
  };
  EXPECT_TRUE(is_integer(Mpfr_interval(), Exact_rational(0)));
  EXPECT_TRUE(is_integer(Mpfr_interval(0), Exact_rational(0)));
  EXPECT_TRUE(is_integer(Mpfr_interval(-7), Exact_rational(-7)));
  EXPECT_TRUE(is_integer(Mpfr_interval(7u), Exact_rational(7)));
  EXPECT_TRUE(is_integer(Mpfr_interval(std::int8_t(-3)), Exact_rational(-3)));
  in_each_rounding_mode([&]() {
    const Exact_rational half_range = power_of_two_by_products(63), one(1);
    EXPECT_TRUE(is_integer(Mpfr_interval((std::numeric_limits<std::int64_t>::max)()), half_range - one));
    EXPECT_TRUE(is_integer(Mpfr_interval((std::numeric_limits<std::int64_t>::min)()), -half_range));
    EXPECT_TRUE(is_integer(Mpfr_interval((std::numeric_limits<std::uint64_t>::max)()), half_range + half_range - one));
    EXPECT_TRUE(is_integer(Mpfr_interval((std::int64_t(1) << 53) + 1), power_of_two_by_products(53) + one));
    EXPECT_TRUE(is_integer(Mpfr_interval(-(std::int64_t(1) << 53) - 1), -power_of_two_by_products(53) - one));
    // An integral operand is not rounded on its way through double.
    EXPECT_TRUE(is_integer(Mpfr_interval(1) * ((std::int64_t(1) << 53) + 1), power_of_two_by_products(53) + one));
  });
  const Mpfr_precision_scope scope(53);
  const Mpfr_interval rounded((std::int64_t(1) << 53) + 1);
  EXPECT_FALSE(rounded.is_point());
  EXPECT_TRUE(rounded.contains(power_of_two_by_products(53) + Exact_rational(1)));
}

TEST(Mpfr_interval, unbounded_intervals_never_turn_into_nonsense)
{
  const Mpfr_interval line = Mpfr_interval::entire_line(), zero(0), one(1);
  const Mpfr_interval positive =
      Mpfr_interval(Exact_rational(1), Exact_rational(2)) / Mpfr_interval(Exact_rational(0), Exact_rational(1));
  EXPECT_FALSE(line.is_bounded());
  EXPECT_FALSE(positive.is_bounded());
  EXPECT_TRUE((zero * line).is_same(zero));
  EXPECT_TRUE((line * zero).is_same(zero));
  EXPECT_TRUE((line * 0.0).is_same(zero));
  EXPECT_TRUE((zero / line).is_same(line)); // 0/0 is among the quotients
  for (const Mpfr_interval& x : {line + line, line - line, line * line, line / line, -line, line + one, one / zero,
                                 zero / zero, line * one, line * -2.0, line / 3.0, Mpfr_interval::half_sum(line, one)})
    EXPECT_TRUE(x.is_same(line));
  EXPECT_TRUE(line.contains(power_of_two_by_products(5000)));
  EXPECT_TRUE(line.contains(one));
  EXPECT_FALSE(one.contains(line));
  EXPECT_TRUE(CGAL::is_indeterminate(line.sign()));
  EXPECT_EQ(line.width(), infinity);
  EXPECT_EQ(line.to_double_interval(), std::make_pair(-infinity, infinity));
  EXPECT_THROW(line.lower(), Invalid_input);
  EXPECT_THROW(line.upper(), Invalid_input);
  EXPECT_THROW(line.midpoint(), Invalid_input);
}

TEST(Mpfr_interval, half_unbounded_intervals)
{
  // Squaring leaves MPFR's range of exponents: the upper end is infinite, the lower one stays finite.
  Mpfr_interval huge(1);
  huge.scale_by_power_of_two(1 << 29);
  huge *= 2.0;
  Mpfr_interval ray = huge;
  for (int i = 0; i < 40; ++i)
    ray *= ray;
  ASSERT_FALSE(ray.is_bounded());
  EXPECT_EQ(ray.sign().make_certain(), CGAL::POSITIVE);
  const Mpfr_interval below_one = Mpfr_interval(1) / ray; // [0, small]
  EXPECT_TRUE(below_one.is_bounded());
  EXPECT_EQ(below_one.sign().inf(), CGAL::ZERO);
  EXPECT_EQ(below_one.sign().sup(), CGAL::POSITIVE);
  const Mpfr_interval quotient = ray / ray;
  EXPECT_TRUE(quotient.contains(Exact_rational(1)));
  EXPECT_TRUE((-ray / ray).contains(Exact_rational(-1)));
  EXPECT_TRUE((ray - ray).contains(Exact_rational(0)));
  EXPECT_TRUE((ray * below_one).contains(Exact_rational(1)));
}

TEST(Mpfr_interval, signs)
{
  const auto expect_range = [](int low, int high, CGAL::Sign sign_low, CGAL::Sign sign_high) {
    const Mpfr_interval x{Exact_rational(low), Exact_rational(high)};
    EXPECT_EQ(x.sign().inf(), sign_low);
    EXPECT_EQ(x.sign().sup(), sign_high);
  };
  expect_range(1, 2, CGAL::POSITIVE, CGAL::POSITIVE);
  expect_range(0, 2, CGAL::ZERO, CGAL::POSITIVE);
  expect_range(0, 0, CGAL::ZERO, CGAL::ZERO);
  expect_range(-1, 0, CGAL::NEGATIVE, CGAL::ZERO);
  expect_range(-1, 1, CGAL::NEGATIVE, CGAL::POSITIVE);
  expect_range(-2, -1, CGAL::NEGATIVE, CGAL::NEGATIVE);
}

TEST(Mpfr_interval, midpoint_width_and_containment)
{
  Random random(307);
  for (int i = 0; i < 200; ++i) {
    const Bounds a = random_bounds(random, true);
    const Mpfr_interval x = interval_of(a);
    EXPECT_TRUE(x.midpoint() == (x.lower() + x.upper()) / Exact_rational(2));
    EXPECT_TRUE(x.contains(x.midpoint()));
    EXPECT_TRUE(x.contains(x));
    in_each_rounding_mode([&]() {
      const Exact_rational width = x.upper() - x.lower();
      EXPECT_TRUE(width <= to_rational(x.width()));
      EXPECT_TRUE(to_rational(x.width()) <= width * (Exact_rational(1) + power_of_two_by_products(-50)));
      const auto [low, high] = x.to_double_interval();
      EXPECT_EQ(low, to_double_interval(x.lower()).first);
      EXPECT_EQ(high, to_double_interval(x.upper()).second);
    });
    if (!x.is_point()) {
      const Mpfr_interval inner(x.midpoint(), 400);
      EXPECT_TRUE(x.contains(inner));
      EXPECT_FALSE(inner.contains(x));
    }
    EXPECT_FALSE(x.contains(x.upper() + ratio(1, 1000000)));
    EXPECT_FALSE(x.contains(x.lower() - ratio(1, 1000000)));
  }
}

TEST(Mpfr_interval, doubles_at_the_ends_of_their_range)
{
  Mpfr_interval tiny(1), huge(1);
  tiny.scale_by_power_of_two(-3000);
  huge.scale_by_power_of_two(3000);
  in_each_rounding_mode([&]() {
    EXPECT_EQ(tiny.to_double_interval(), std::make_pair(0.0, denormal));
    EXPECT_EQ((-tiny).to_double_interval(), std::make_pair(-denormal, 0.0));
    EXPECT_EQ(huge.to_double_interval(), std::make_pair(largest, infinity));
    EXPECT_EQ((-huge).to_double_interval(), std::make_pair(-infinity, -largest));
    EXPECT_EQ((tiny + denormal).to_double_interval(), std::make_pair(denormal, 2 * denormal));
  });
}

TEST(Mpfr_interval, scaling_and_half_sum_are_exact)
{
  Random random(308);
  for (int i = 0; i < 200; ++i) {
    const Bounds a = random_bounds(random, false), b = random_bounds(random, false);
    const int exponent = static_cast<int>(uniform(random, -3000, 3000));
    Mpfr_interval x = interval_of(a);
    x.scale_by_power_of_two(exponent);
    EXPECT_TRUE(x.lower() == a.lower * power_of_two_by_products(exponent));
    EXPECT_TRUE(x.upper() == a.upper * power_of_two_by_products(exponent));
    const Mpfr_interval middle = Mpfr_interval::half_sum(interval_of(a), interval_of(b));
    EXPECT_TRUE(middle.lower() == (a.lower + b.lower) / Exact_rational(2));
    EXPECT_TRUE(middle.upper() == (a.upper + b.upper) / Exact_rational(2));
  }
}

TEST(Mpfr_interval, values_copy_move_and_swap)
{
  const Mpfr_interval third(ratio(1, 3), 90), seventh(ratio(1, 7), 300);
  Mpfr_interval a = third, b = seventh;
  a += b;
  EXPECT_TRUE(b.is_same(seventh)); // copies share nothing
  a = third;
  swap(a, b);
  EXPECT_TRUE(a.is_same(seventh) && b.is_same(third));
  EXPECT_EQ(a.precision(), 300);
  Mpfr_interval c = std::move(a);
  EXPECT_TRUE(c.is_same(seventh));
  a = third; // what was moved from can be assigned to
  EXPECT_TRUE(a.is_same(third));
  Mpfr_interval d = std::move(a);
  a = std::move(c);
  EXPECT_TRUE(a.is_same(seventh) && d.is_same(third));

  Random random(309);
  std::vector<std::pair<Exact_rational, Mpfr_interval>> entries;
  for (int i = 0; i < 300; ++i) {
    const Exact_rational x = random_rational(random);
    entries.emplace_back(x, Mpfr_interval(x, uniform(random, 53, 200)));
  }
  std::sort(entries.begin(), entries.end(), [](const auto& x, const auto& y) { return x.first < y.first; });
  for (const auto& [x, interval] : entries)
    EXPECT_TRUE(interval.contains(x));
}

TEST(Mpfr_interval, output_is_rounded_outward)
{
  const auto text = [](const Mpfr_interval& x, int digits) {
    std::ostringstream stream;
    stream.precision(digits);
    stream << x;
    return stream.str();
  };
  EXPECT_EQ(text(Mpfr_interval(ratio(1, 3)), 4), "[3.3333e-01;3.3334e-01]");
  EXPECT_EQ(text(Mpfr_interval(ratio(-1, 3)), 4), "[-3.3334e-01;-3.3333e-01]");
  EXPECT_EQ(text(Mpfr_interval(2), 2), "[2.00e+00;2.00e+00]");
  EXPECT_EQ(text(Mpfr_interval::entire_line(), 3), "[-inf;inf]");
}

TEST(Mpfr_interval, OfEnds)
{
  const Mpfr_interval a(ratio(1, 3), ratio(1, 2), 60), b(ratio(2, 3), ratio(3, 4), 200);
  const Mpfr_interval hull = Mpfr_interval::of_ends(a.lower_mpfr(), b.upper_mpfr());
  EXPECT_EQ(hull.precision(), 200);
  EXPECT_EQ(hull.lower(), a.lower());
  EXPECT_EQ(hull.upper(), b.upper());
  EXPECT_TRUE(Mpfr_interval::of_ends(Mpfr_interval::entire_line().lower_mpfr(), a.lower_mpfr()).contains(ratio(-7, 2)));
  EXPECT_THROW(Mpfr_interval::of_ends(b.lower_mpfr(), a.upper_mpfr()), Invalid_input);
  internal::Mpfr_number nan(53);
  mpfr_set_nan(nan.get());
  EXPECT_THROW(Mpfr_interval::of_ends(nan.get(), a.upper_mpfr()), Invalid_input);
}

// Numbers of up to 128 bits hold their digits, others do not: both are moved, copied, exchanged and widened.
TEST(Mpfr_interval, DigitsInsideAndOutside)
{
  const std::array<mpfr_prec_t, 4> precisions{53, 128, 129, 300};
  for (const mpfr_prec_t p : precisions)
    for (const mpfr_prec_t q : precisions) {
      const Mpfr_interval third(ratio(1, 3), p), fifth(ratio(1, 5), q);
      Mpfr_interval a(third), b(fifth);
      swap(a, b);
      EXPECT_TRUE(a.is_same(fifth) && b.is_same(third));
      a = b;
      EXPECT_TRUE(a.is_same(third) && b.is_same(third));
      a = std::move(b);
      b = fifth;
      EXPECT_TRUE(a.is_same(third) && b.is_same(fifth));
      std::vector<Mpfr_interval> grown;
      for (int i = 0; i < 20; ++i) {
        grown.push_back(third);
        grown.push_back(fifth);
      }
      EXPECT_TRUE(grown[0].is_same(third) && grown[38].is_same(third) && grown[39].is_same(fifth));
      a += b;
      EXPECT_EQ(a.precision(), (std::max)(p, q));
      EXPECT_TRUE(a.contains(ratio(8, 15)));
      EXPECT_LT(a.width(), 4 * (third.width() + fifth.width()));
      EXPECT_TRUE(b.is_same(fifth));
    }
}

} // namespace

} // namespace number_Mpfr_interval_test
