// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Enclosures of elementary functions at many places: values against MPFR, ranges and derivatives against values inside,
// what inverse functions leave; values that are rational; values of polynomials as text.

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/inverse_ranges.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/point_values.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_number.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>

#include <gtest/gtest.h>

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace elementary_enclosures_test {

namespace SC = CGAL::Spline_constraints;
namespace elementary = SC::internal::elementary;
using elementary::Interval;
using elementary::Operation;
using SC::Elementary_function;
using SC::Elementary_values;
using SC::Exact_rational;
using SC::Power_polynomial;

namespace {

using Mpfr_function = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

struct Tested_function
{
  Operation operation;
  Mpfr_function function; // null: none
  double lower, upper;    // of arguments
};

std::vector<Tested_function> functions()
{
  using F = Elementary_function;
  const auto third = Interval(1) / Interval(3);
  return {{{F::EXPONENTIAL}, mpfr_exp, -710, 710},
          {{F::LOGARITHM}, mpfr_log, 0, 1e3},
          {{F::SINE}, mpfr_sin, -3e5, 3e5},
          {{F::SINE}, mpfr_sin, -7, 7},
          {{F::COSINE}, mpfr_cos, -3e5, 3e5},
          {{F::COSINE}, mpfr_cos, -7, 7},
          {{F::TANGENT}, mpfr_tan, -7, 7},
          {{F::ARC_SINE}, mpfr_asin, -1, 1},
          {{F::ARC_COSINE}, mpfr_acos, -1, 1},
          {{F::ARC_TANGENT}, mpfr_atan, -9, 9},
          {{F::HYPERBOLIC_SINE}, mpfr_sinh, -9, 9},
          {{F::HYPERBOLIC_COSINE}, mpfr_cosh, -9, 9},
          {{F::HYPERBOLIC_TANGENT}, mpfr_tanh, -9, 9},
          {{F::SQUARE_ROOT}, mpfr_sqrt, 0, 9},
          {{F::ABSOLUTE_VALUE}, mpfr_abs, -9, 9},
          {{F::RECIPROCAL}, nullptr, -9, 9},
          {{F::POWER, third}, mpfr_cbrt, 0, 9},
          {{F::POWER, -third}, nullptr, 0, 9},
          {{F::POWER, Interval(2.5)}, nullptr, 0, 9}};
}

// At random, and near multiples of an eighth of a turn and near small numbers.
double argument(const Tested_function& f, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> any(f.lower, f.upper), some(0, 1);
  double x = any(random);
  if (const double place = some(random); place < 0.2) {
    constexpr double eighth = 0.78539816339744831;
    x = std::floor(x / eighth) * eighth + (place < 0.1 ? 1e-14 : 0);
  } else if (place < 0.4)
    x *= std::pow(10, -17 * some(random));
  else if (place < 0.45)
    x = std::floor(x);
  return std::clamp(x, f.lower, f.upper);
}

} // namespace

TEST(Elementary_enclosures, values)
{
  const SC::Upward_rounding_guard guard;
  std::mt19937_64 random(20261203);
  SC::internal::Mpfr_number x(53), value(200);
  for (const Tested_function& f : functions())
    for (int k = 0; f.function != nullptr && k < 4000; ++k) {
      const double place = argument(f, random);
      if (!elementary::is_in_domain(f.operation, Interval(place)))
        continue;
      const Interval enclosure = elementary::value_at(f.operation, place);
      mpfr_set_d(x.get(), place, MPFR_RNDN);
      f.function(value.get(), x.get(), MPFR_RNDN);
      // 200 bits are enough to tell both sides apart from the double
      EXPECT_LE(mpfr_cmp_d(value.get(), enclosure.sup()), 0) << place;
      EXPECT_GE(mpfr_cmp_d(value.get(), enclosure.inf()), 0) << place;
      // near poles of the tangent by as much more as it is steep
      const double size = std::abs(enclosure.sup());
      const double steepness = f.operation.function == Elementary_function::TANGENT ? 1 + size : 1;
      EXPECT_LE(enclosure.sup() - enclosure.inf(),
                1e-14 * steepness * (std::max)(size, (std::min)(std::abs(place), 1.0)))
          << place << ' ' << static_cast<int>(f.operation.function);
    }
}

// Numbers of a range have their values in the range of values, stay when what holds their values is carried back, and
// differ as the derivative says; between two of them the function is below or above the chord.
TEST(Elementary_enclosures, ranges)
{
  const SC::Upward_rounding_guard guard;
  std::mt19937_64 random(20261204);
  std::uniform_real_distribution<double> some(0, 1);
  std::size_t inside = 0, convex = 0, narrowed_ranges = 0;
  for (const Tested_function& f : functions())
    for (int k = 0; k < 4000; ++k) {
      const double a = argument(f, random);
      const double reach = (f.upper - f.lower) * std::pow(10, -8 * some(random));
      const Interval range((std::max)(a - reach * some(random), f.lower), (std::max)(a + reach * some(random), a));
      const double b = std::clamp(a + reach * some(random), range.inf(), range.sup());
      const double c = std::clamp(0.5 * a + 0.5 * b, a, b);
      const auto is_defined = [&](double x) { return elementary::is_in_domain(f.operation, Interval(x)); };
      if (!is_defined(a) || !is_defined(b) || !is_defined(c))
        continue;
      ++inside;
      const Interval values = elementary::range_of_values(f.operation, range);
      const Interval at_a = elementary::value_at(f.operation, a), at_b = elementary::value_at(f.operation, b);
      for (const Interval& value : {at_a, at_b, elementary::value_at(f.operation, c)}) {
        EXPECT_LE(values.inf(), value.sup());
        EXPECT_GE(values.sup(), value.inf());
      }
      Interval narrowed = range;
      EXPECT_TRUE(elementary::narrow_argument(f.operation, at_a, narrowed)) << a;
      EXPECT_LE(narrowed.inf(), a) << static_cast<int>(f.operation.function);
      EXPECT_GE(narrowed.sup(), a) << static_cast<int>(f.operation.function);
      narrowed_ranges += narrowed.sup() - narrowed.inf() < 0.5 * (range.sup() - range.inf());
      if (a == b)
        continue;
      const Interval slope = (at_b - at_a) / (Interval(b) - Interval(a));
      const Interval derivative = elementary::range_of_derivative(f.operation, range, values);
      EXPECT_LE(derivative.inf(), slope.sup());
      EXPECT_GE(derivative.sup(), slope.inf());
      const int sign = elementary::convexity(f.operation, range, values);
      if (sign == 0)
        continue;
      ++convex;
      const Interval at_c = elementary::value_at(f.operation, c);
      const Interval chord = at_a + slope * (Interval(c) - Interval(a));
      EXPECT_GE(sign > 0 ? chord.sup() - at_c.inf() : at_c.sup() - chord.inf(), 0);
    }
  EXPECT_GT(inside, 50000u);
  EXPECT_GT(convex, 20000u);
  EXPECT_GT(narrowed_ranges, 20000u);
}

TEST(Elementary_enclosures, infinite_and_empty_ranges)
{
  const SC::Upward_rounding_guard guard;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const Tested_function& f : functions()) {
    Interval all = elementary::entire_line();
    const Interval values = elementary::range_of_values(f.operation, all);
    EXPECT_LE(values.inf(), values.sup());
    EXPECT_TRUE(elementary::narrow_argument(f.operation, elementary::entire_line(), all));
    EXPECT_TRUE(elementary::restrict_to_domain(f.operation, all));
  }
  const auto is_empty = [](Elementary_function function, const Interval& values, Interval x) {
    return !elementary::narrow_argument({function}, values, x);
  };
  EXPECT_TRUE(is_empty(Elementary_function::EXPONENTIAL, Interval(-2, 0), Interval(-9, 9)));
  EXPECT_TRUE(is_empty(Elementary_function::LOGARITHM, Interval(-2, 9), Interval(-9, 0)));
  EXPECT_TRUE(is_empty(Elementary_function::SINE, Interval(1.5, 9), Interval(-9, 9)));
  EXPECT_TRUE(is_empty(Elementary_function::SINE, Interval(0.9, 1), Interval(3, 7)));
  EXPECT_TRUE(is_empty(Elementary_function::COSINE, Interval(0.1, 1), Interval(1.6, 4.7)));
  EXPECT_TRUE(is_empty(Elementary_function::TANGENT, Interval(0.1, 1), Interval(1, 3)));
  EXPECT_TRUE(is_empty(Elementary_function::RECIPROCAL, Interval(0), elementary::entire_line()));
  EXPECT_TRUE(is_empty(Elementary_function::RECIPROCAL, Interval(-1, 1), Interval(-0.5, 0.5)));
  EXPECT_TRUE(is_empty(Elementary_function::ABSOLUTE_VALUE, Interval(-2, -1), Interval(-9, 9)));
  EXPECT_TRUE(is_empty(Elementary_function::HYPERBOLIC_COSINE, Interval(-2, 0.9), Interval(-9, 9)));
  EXPECT_TRUE(is_empty(Elementary_function::HYPERBOLIC_TANGENT, Interval(1, 2), elementary::entire_line()));
  EXPECT_TRUE(is_empty(Elementary_function::ARC_SINE, Interval(-9, 9), Interval(1.1, infinity)));
}

TEST(Elementary_values, rational_values)
{
  Elementary_values values;
  const Power_polynomial x = Power_polynomial::variable(0);
  EXPECT_EQ(values.exp(Power_polynomial(0)), Power_polynomial(1));
  EXPECT_EQ(values.log(Power_polynomial(1)), Power_polynomial(0));
  EXPECT_EQ(values.sqrt(Power_polynomial(Exact_rational(9, 4))), Power_polynomial(Exact_rational(3, 2)));
  EXPECT_EQ(values.power(x, 3), pow(x, 3));
  EXPECT_EQ(values.value(Elementary_function::ABSOLUTE_VALUE, Power_polynomial(-3)), Power_polynomial(3));
  EXPECT_TRUE(values.all().empty());
  EXPECT_EQ(values.sin(2 * x), values.sin(x + x));
  EXPECT_NE(values.sin(2 * x), values.cos(2 * x));
  EXPECT_EQ(values.power(x, Exact_rational(3, 2)), pow(values.sqrt(x), 3));
  EXPECT_EQ(values.reciprocal(2 * x * x), pow(values.reciprocal(x), 2) / 2);
  EXPECT_EQ(values.all().size(), 4u);

  Elementary_values others;
  const Power_polynomial function = others.exp(x) + others.sqrt(x + 4) * others.reciprocal(x - 2);
  const auto at_0 = others.rational_values({0});
  ASSERT_TRUE(at_0);
  EXPECT_EQ(others.rational_value(function, {0}, *at_0), Exact_rational(0));
  EXPECT_FALSE(others.rational_values({1}));
  EXPECT_FALSE(others.rational_values({2}));
  const std::vector<std::string> names{"t"};
  EXPECT_EQ(others.text(others.sqrt(x + 4) * others.reciprocal(x - 2), names), "(1/(-2 + t))*sqrt(4 + t)");
}

} // namespace elementary_enclosures_test
