// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Values and derivatives in doubles are as close to the exact ones as they say, and tell regular roots from others.

#include "random_systems.h"

#include <CGAL/Spline_constraints_d/solver/internal/certification/Multiple_root.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/point_values.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace point_values_test {

using namespace solver_test;
using SC::internal::Rounded_number;
using SC::internal::Rounded_values;

std::vector<Rational> random_point(Random_numbers& random, int n)
{
  std::vector<Rational> point;
  for (int j = 0; j < n; ++j)
    point.push_back(random.ratio(-9, 9, 7));
  return point;
}

Polynomial random_polynomial(Random_numbers& random, const std::vector<Polynomial>& x)
{
  Polynomial result(random.ratio(-9, 9, 9));
  for (int terms = random.integer(1, 4); terms > 0; --terms) {
    Polynomial product(random.ratio(-9, 9, 9));
    for (int factors = random.integer(1, 5); factors > 0; --factors)
      product = product * x[random.integer(0, static_cast<int>(x.size()) - 1)];
    result = result + product;
  }
  return result;
}

Rational exact_derivative(const SC::Spline_function& function, const std::vector<Rational>& point, int axis)
{
  SC::internal::Taylor_terms terms;
  EXPECT_TRUE(SC::internal::taylor_expansion(function, point, 1, terms));
  std::vector<int> exponents(point.size(), 0);
  exponents[axis] = 1;
  return terms[exponents];
}

// `is_usual`: no number is far too large or too small for doubles.
void expect_close(const Rounded_number& rounded, const Rational& exact, bool is_usual)
{
  if (is_usual) {
    EXPECT_EQ(rounded.is_certainly_not_zero(), exact != 0);
  }
  if (rounded.error < HUGE_VAL) {
    const Rational difference = Rational(rounded.value) - exact;
    EXPECT_LE(CGAL::abs(difference), Rational(rounded.error));
  }
  if (rounded.is_certainly_not_zero()) {
    EXPECT_EQ(CGAL::sign(exact), CGAL::sign(rounded.value));
  }
}

TEST(Point_values, AreAsCloseAsTheySay)
{
  Random_numbers random(1);
  const auto x = variables(3);
  for (int round = 0; round < 300; ++round) {
    // Numbers that cannot be doubles, or only some on the way, too.
    const Rational large(0x1p1000),
        scale = round % 5 == 0 ? large * large
        : round % 5 == 1       ? 1 / large
        : round % 5 == 2       ? 1 / (large * large)
                               : Rational(1);
    const SC::Spline_function function(random_polynomial(random, x) * scale);
    std::vector<Rational> point = random_point(random, 3);
    if (round % 7 == 0)   // zero for a double
      point[0] /= large * large;
    const Rounded_values values(point);
    const bool is_usual = round % 5 > 2 && round % 7 > 0;
    expect_close(values.value(function), SC::internal::evaluate_exactly(function, point), is_usual);
    EXPECT_EQ(SC::internal::vanishes_at(function, point), SC::internal::evaluate_exactly(function, point) == 0);
    const auto gradient = values.gradient(function);
    ASSERT_EQ(gradient.size(), 3u);
    for (int j = 0; j < 3; ++j)
      expect_close(gradient[j], exact_derivative(function, point, j), is_usual);
  }
}

TEST(Point_values, OfPiecesOfSplines)
{
  const auto x = variables(1);
  const SC::Spline_function function = piecewise(0, {0, 1, 2}, {x[0] * x[0], x[0]});
  const std::vector<Rational> left{fraction(1, 3)}, right{fraction(4, 3)};
  expect_close(Rounded_values(left).value(function), fraction(1, 9), true);
  expect_close(Rounded_values(right).value(function), fraction(4, 3), true);
  expect_close(Rounded_values(left).gradient(function)[0], fraction(2, 3), true);
  expect_close(Rounded_values(right).gradient(function)[0], 1, true);
}

// A (x - p) and terms of higher order: regular when A is.
TEST(Point_values, TellRegularRootsFromMultipleOnes)
{
  Random_numbers random(2);
  for (int round = 0; round < 120; ++round) {
    const int n = random.integer(2, 5);
    const auto x = variables(n);
    const std::vector<Rational> root = random_point(random, n);
    std::vector<std::vector<Rational>> matrix(n, std::vector<Rational>(n));   // diagonally dominant
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        matrix[i][j] = i == j ? Rational(20) : random.ratio(-4, 4, 3);
    const bool is_regular = round % 2 == 0;
    if (!is_regular)
      for (int j = 0; j < n; ++j)
        matrix[0][j] = matrix[1][j] / Rational(3) + (n > 2 ? matrix[n - 1][j] / Rational(7) : Rational(0));
    std::vector<Polynomial> functions;
    for (int i = 0; i < n; ++i) {
      Polynomial f(Rational(0));
      for (int j = 0; j < n; ++j)
        f = f + matrix[i][j] * (x[j] - root[j]) +
            random.ratio(-3, 3, 5) * (x[j] - root[j]) * (x[random.integer(0, n - 1)] - root[j]) * (x[j] - root[j]);
      functions.push_back(f);
    }
    const System system = with_equalities(cube(n, -10, 10), functions);
    EXPECT_EQ(SC::internal::is_certainly_not_multiple(system, root), is_regular);
    std::vector<Rational> beside = root;
    beside[n - 1] += fraction(1, 1000000);
    EXPECT_TRUE(SC::internal::is_certainly_not_multiple(system, beside));
  }
}

} // namespace point_values_test
