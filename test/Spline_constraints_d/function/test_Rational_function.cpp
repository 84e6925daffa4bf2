// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "random_tensors.h"

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/Rational_function.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>

#include <CGAL/Interval_nt.h>

#include <gtest/gtest.h>

namespace Rational_function_test {

namespace {

using CGAL::Spline_constraints::Invalid_input;
using CGAL::Spline_constraints::Rational_function;
using FT = CGAL::Spline_constraints::Exact_rational;
using Tensor = CGAL::Spline_constraints::Bernstein_tensor<FT>;
using Double_tensor = CGAL::Spline_constraints::Bernstein_tensor<double>;
using Spline = CGAL::Spline_constraints::Bspline_function<FT>;
using Double_spline = CGAL::Spline_constraints::Bspline_function<double>;
using Rational = Rational_function<Tensor>;

Rational random_rational_function(Random_source& random, int dimension)
{
  Tensor weight = random.tensor(random.degrees(dimension, 3));
  weight += FT(1) - weight.bounds().first;
  return Rational(random.tensor(random.degrees(dimension, 3)), weight);
}

TEST(Rational_function, arithmetic_is_pointwise)
{
  Random_source random(1);
  for (int n = 0; n <= 3; ++n)
    for (int i = 0; i < 10; ++i) {
      const Rational f = random_rational_function(random, n), g = random_rational_function(random, n);
      const std::vector<FT> u = random.point(n);
      const FT a = f.numerator()(u) / f.weight()(u), b = g.numerator()(u) / g.weight()(u);
      EXPECT_EQ(f(u), a);
      EXPECT_EQ((f + g)(u), FT(a + b));
      EXPECT_EQ((f - g)(u), FT(a - b));
      EXPECT_EQ((f * g)(u), FT(a * b));
      EXPECT_EQ((-f)(u), FT(-a));
      if (b != FT(0)) {
        EXPECT_EQ((f / g)(u), FT(a / b));
      }
      // The same weight is kept: degrees do not grow.
      EXPECT_EQ((f + f).weight(), f.weight());
      EXPECT_EQ((f + f)(u), FT(a + a));
    }
}

TEST(Rational_function, derivative_gradient_restriction_and_bounds_agree)
{
  Random_source random(2);
  for (int n = 1; n <= 3; ++n)
    for (int i = 0; i < 8; ++i) {
      const Rational f = random_rational_function(random, n);
      const std::vector<FT> u = random.point(n);
      const auto [value, gradient] = f.value_and_gradient(u);
      EXPECT_EQ(value, f(u));
      const auto [low, high] = f.bounds();
      EXPECT_TRUE(low <= value && value <= high);
      for (int axis = 0; axis < n; ++axis) {
        // The quotient rule, by values: f w = n, so f' w + f w' = n'.
        EXPECT_EQ(FT(gradient[axis] * f.weight()(u) + value * f.weight().derivative(axis)(u)),
                  f.numerator().derivative(axis)(u));
        EXPECT_EQ(f.derivative(axis)(u), gradient[axis]);
        const auto [least, greatest] = f.derivative_bounds(axis);
        EXPECT_TRUE(least <= gradient[axis] && gradient[axis] <= greatest);
        std::vector<FT> v = u;
        v[axis] = u[axis] / FT(3);
        EXPECT_EQ(f.split(axis, FT(1) / FT(3)).first(u), f(v));
        EXPECT_EQ(f.restricted(axis, FT(0), FT(1) / FT(3))(u), f(v));
      }
    }
}

TEST(Rational_function, circle_from_its_rational_quadratic)
{
  // The quarter circle (1-t^2, 2t) / (1+t^2).
  const Rational x(Tensor({2}, {1, 1, 0}), Tensor({2}, {1, 1, 2})), y(Tensor({2}, {0, 1, 2}), Tensor({2}, {1, 1, 2}));
  const Rational one = x * x + y * y;
  EXPECT_EQ(one.numerator(), one.weight());
  EXPECT_EQ(x.bounds(), (std::pair<FT, FT>(FT(0), FT(1))));
}

TEST(Rational_function, works_on_splines)
{
  Random_source random(3);
  const std::vector<std::vector<FT>> knots{{0, 0, 0, 0, FT(1) / FT(3), 1, 1, 1, 1}};
  const std::vector<std::vector<FT>> other_knots{{0, 0, 0, FT(1) / FT(2), 1, 1, 1}};
  const Spline numerator({3}, knots, random.numbers(5));
  Rational_function<Spline> f(numerator, Spline({2}, other_knots, {1, 2, 1, 3})), g(numerator, numerator);
  f.certify_positive_weight();
  for (int i = 0; i <= 12; ++i) {
    const std::vector<FT> u{FT(i) / FT(12)};
    EXPECT_EQ(f(u), FT(numerator(u) / f.weight()(u)));
    EXPECT_EQ((f * f)(u), FT(f(u) * f(u)));
    EXPECT_EQ(f.derivative(0)(u), f.value_and_gradient(u).gradient[0]);
    EXPECT_TRUE(f.bounds().first <= f(u) && f(u) <= f.bounds().second);
  }
  const auto halves = f.split(0, FT(1) / FT(2));
  EXPECT_EQ(halves.second.domain(0).first, FT(1) / FT(2));
}

template <class Function>
std::string message_of_certification(const Function& weight)
{
  try {
    Rational_function<Function> f(weight, weight);
    f.certify_positive_weight();
  } catch (const Invalid_input& error) {
    return error.what();
  }
  return "certified";
}

TEST(Rational_function, certification_proves_or_rejects)
{
  EXPECT_EQ(message_of_certification(Tensor({2}, {1, 2, 3})), "certified");
  // 1 - 4u(1-u)(1-1/100) > 0 has a negative coefficient: only halving proves it.
  EXPECT_EQ(message_of_certification(Tensor({2}, {1, FT(-49) / FT(50), 1})), "certified");
  EXPECT_EQ(message_of_certification(Double_tensor({2}, {1, -0.98, 1})), "certified");
  // (1-2u)^2 vanishes at one half, a split point; (1-3u)^2 at one third, which no halving meets.
  EXPECT_NE(message_of_certification(Tensor({2}, {1, -1, 1})).find("zero at a point"), std::string::npos);
  EXPECT_NE(message_of_certification(Tensor({2}, {1, -2, 4})).find("could not be proved"), std::string::npos);
  EXPECT_NE(message_of_certification(Tensor({1}, {1, -2})).find("both signs"), std::string::npos);
  EXPECT_NE(message_of_certification(Tensor({2}, {1, -5, 1})).find("both signs"), std::string::npos);
  EXPECT_NE(message_of_certification(Tensor({1}, {0, 2})).find("zero at a point"), std::string::npos);
  EXPECT_NE(message_of_certification(Tensor({1, 1}, {1, 1, 1, 0})).find("zero at a point"), std::string::npos);
  EXPECT_NE(message_of_certification(Tensor({}, {0})).find("zero everywhere"), std::string::npos);
  // Of one sign in each piece, but not of the same.
  EXPECT_NE(message_of_certification(Double_spline({1}, {{0, 0, 1, 2, 2}}, {1, 1, -1})).find("both signs"),
            std::string::npos);
  // In several variables: x^2 + y^2 + 1/1000 on [-1,1]^2, and without the constant.
  const std::vector<std::pair<FT, FT>> box(2, {FT(-1), FT(1)});
  const std::vector<FT> sum_of_squares{FT(1) / FT(1000), 0, 1, 0, 0, 0, 1, 0, 0};
  const Tensor positive = Tensor::from_power_on_box({2, 2}, sum_of_squares, box);
  EXPECT_LT(positive.bounds().first, FT(0));
  EXPECT_EQ(message_of_certification(positive), "certified");
  EXPECT_NE(message_of_certification(positive - FT(1) / FT(1000)).find("zero at a point"), std::string::npos);
}

TEST(Rational_function, certification_makes_the_weight_positive)
{
  Rational f(Tensor({1}, {3, 4}), Tensor({2}, {-1, FT(49) / FT(50), -1}));
  const std::vector<FT> u{FT(1) / FT(2)};
  const FT value = f(u);
  f.certify_positive_weight();
  EXPECT_GT(f.weight()(u), FT(0));
  EXPECT_EQ(f.numerator().coefficients(), (std::vector<FT>{-3, -4}));
  EXPECT_EQ(f(u), value);
}

TEST(Rational_function, certifies_intervals)
{
  using Interval = CGAL::Interval_nt<false>;
  using Interval_tensor = CGAL::Spline_constraints::Bernstein_tensor<Interval>;
  CGAL::Interval_nt<false>::Protector protector;
  EXPECT_EQ(message_of_certification(Interval_tensor({2}, {Interval(1), Interval(-0.99, -0.5), Interval(1)})),
            "certified");
  EXPECT_NE(message_of_certification(Interval_tensor({1}, {Interval(1), Interval(-1, 1)})).find("could not be proved"),
            std::string::npos);
}

TEST(Rational_function, certifies_multiprecision_intervals)
{
  using Interval = CGAL::Spline_constraints::Mpfr_interval;
  using Interval_tensor = CGAL::Spline_constraints::Bernstein_tensor<Interval>;
  const Interval wide(FT(-99) / FT(100), FT(-1) / FT(2));
  const Interval_tensor weight({2}, {Interval(1), wide, Interval(1)});
  EXPECT_EQ(message_of_certification(weight), "certified");
  EXPECT_TRUE(weight.bounds().first.contains(FT(-99) / FT(100)));
  EXPECT_TRUE(weight.bounds().second.contains(FT(1)));
  EXPECT_NE(message_of_certification(Interval_tensor({1}, {Interval(1), Interval(FT(-1), FT(1))}))
                .find("could not be proved"),
            std::string::npos);
  EXPECT_THROW(Interval_tensor({0}, {Interval::entire_line()}), Invalid_input);
}

TEST(Rational_function, limits_are_kept)
{
  // A near miss: proved with the default limits, not with few halvings.
  const Tensor weight({2}, {1, FT(-49) / FT(50), 1});
  Rational f(weight, weight);
  EXPECT_THROW(f.certify_positive_weight({.maximal_depth = 0}), Invalid_input);
  EXPECT_THROW(f.certify_positive_weight({.maximal_parts = 0}), Invalid_input);
  EXPECT_NO_THROW(f.certify_positive_weight());
}

TEST(Rational_function, rejects_bad_input)
{
  EXPECT_THROW(Rational(Tensor({1}, {1, 2}), Tensor({1}, {0, 0})), Invalid_input);
  EXPECT_THROW(Rational(Tensor({1}, {1, 2}), Tensor({1, 1}, {1, 1, 1, 1})), Invalid_input);
  EXPECT_THROW(Rational_function<Double_spline>(Double_spline({1}, {{0, 0, 1, 1}}, {1, 2}),
                                                Double_spline({1}, {{0, 0, 2, 2}}, {1, 2})),
               Invalid_input);
  const Rational zero(Tensor({1}, {0, 0}), Tensor({1}, {1, 1})), one(Tensor({1}, {1, 1}), Tensor({1}, {1, 2}));
  EXPECT_THROW(one / zero, Invalid_input);
  const std::vector<FT> u{FT(1) / FT(2)};
  EXPECT_THROW(Rational(Tensor({1}, {1, 1}), Tensor({1}, {1, -1}))(u), Invalid_input);
  EXPECT_THROW(Rational(Tensor({1}, {1, 1}), Tensor({1}, {1, -1})).bounds(), Invalid_input);
}

} // namespace

} // namespace Rational_function_test
