// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bounds of formulas: values lie between them, and they are sharp where they can be.

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/expression_bounds.h>

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <utility>
#include <vector>

namespace expression_bounds_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using Range = std::pair<Exact_rational, Exact_rational>;

Exact_rational ratio(int a, int b) { return Exact_rational(a) / b; }

TEST(Expression_bounds, Sharp)
{
  const auto [x, y] = SC::unknowns({-2, 2}, {0, 3});
  EXPECT_EQ(SC::bounds(2 * x - y, {{-1, 2}, {1, 3}}), Range(-5, 3));
  EXPECT_EQ(SC::bounds(x * y, {{-1, 2}, {1, 3}}), Range(-3, 6));
  EXPECT_EQ(SC::bounds((x + 3) / (y + 1), {{-2, 2}, {0, 3}}), Range(ratio(1, 4), 5));
  EXPECT_EQ(SC::bounds(1 / (x - 3), {{-2, 2}, {0, 3}}), Range(-1, ratio(-1, 5)));
  EXPECT_EQ(SC::bounds(x * x, {{1, 1}, {0, 3}}), Range(1, 1));
  EXPECT_EQ(SC::bounds(SC::Expression(ratio(7, 2)), {}), Range(ratio(7, 2), ratio(7, 2)));
}

TEST(Expression_bounds, Divisors)
{
  const auto [x] = SC::unknowns({-2, 2});
  EXPECT_FALSE(SC::bounds(1 / x, {{-1, 2}}));
  EXPECT_FALSE(SC::bounds(1 / x, {{0, 2}}));
  // Bernstein coefficients of x^2 + 1/10 on the whole range have both signs; those on its parts have not.
  EXPECT_FALSE(SC::bounds(1 / (x * x + ratio(1, 10)), {{-2, 2}}, 0));
  const auto range = SC::bounds(1 / (x * x + ratio(1, 10)), {{-2, 2}});
  ASSERT_TRUE(range);
  EXPECT_TRUE(range->first <= ratio(10, 41) && range->second >= 10);
  EXPECT_THROW(SC::bounds(x, {{0, 1}, {0, 1}}), SC::Invalid_input);
}

// Random rational splines with four pieces, in formulas, on random boxes.
TEST(Expression_bounds, HoldValues)
{
  std::mt19937 random(2);
  const auto number = [&](int count) { return Exact_rational(static_cast<int>(random() % count)); };
  for (int round = 0; round < 20; ++round) {
    std::array<std::vector<Exact_rational>, 3> coefficients;
    for (auto& list : coefficients)
      for (int i = 0; i < 6; ++i)
        list.push_back(1 + number(9));
    const auto spline = [&](int i) {
      return SC::Bspline_function<Exact_rational>({2}, {{0, 0, 0, 1, 2, 3, 4, 4, 4}}, coefficients[i]);
    };
    const SC::Spline_map<1, 2> map({spline(0), spline(1)}, spline(2));
    const auto [u, t] = SC::unknowns({0, 4}, {-1, 1});
    const SC::Expression formula = map(u)[0] * t - square(map(u)[1]) / (t + 3);
    const Exact_rational a = number(80) / 20, b = number(40) / 20 - 1;
    const std::vector<Range> box{{a, std::min(Exact_rational(4), Exact_rational(a + number(100) / 50))},
                                 {b, std::min(Exact_rational(1), Exact_rational(b + number(10) / 50))}};
    const auto range = SC::bounds(formula, box);
    ASSERT_TRUE(range);
    for (int i = 0; i <= 10; ++i)
      for (int j = 0; j <= 3; ++j) {
        const std::array<Exact_rational, 2> at{Exact_rational(box[0].first + (box[0].second - box[0].first) * i / 10),
                                               Exact_rational(box[1].first + (box[1].second - box[1].first) * j / 3)};
        const Exact_rational value = formula(at);
        EXPECT_TRUE(range->first <= value && value <= range->second);
      }
  }
}

} // namespace

} // namespace expression_bounds_test
