// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Turning points and extremes of curvature of curves of solutions: exact ones of circles, ellipses and Viviani's curve,
// as many maxima as minima on closed curves.

#include <CGAL/Spline_constraints_d/solver/curve_extremes.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace curve_extremes_test {

namespace SC = CGAL::Spline_constraints;
using Kind = SC::Curve_extreme_kind;
using Rational = SC::Exact_rational;

namespace {

std::size_t count(const SC::Curve_extremes_d& set, Kind kind)
{
  return static_cast<std::size_t>(std::count_if(set.extremes.begin(), set.extremes.end(),
                                                [=](const auto& extreme) { return extreme.kind == kind; }));
}

// Whether a point is among them, with this kind.
bool has(const SC::Curve_extremes_d& set, Kind kind, const std::vector<double>& point)
{
  return std::any_of(set.extremes.begin(), set.extremes.end(), [&](const auto& extreme) {
    bool is_near = extreme.kind == kind;
    for (std::size_t j = 0; j < point.size(); ++j)
      is_near = is_near && std::abs(extreme.solution.point()[j] - point[j]) < 1e-9;
    return is_near;
  });
}

void expect_counts(const SC::Curve_extremes_d& set, std::size_t maxima, std::size_t minima, std::size_t undecided)
{
  EXPECT_TRUE(set.summary.is_complete);
  EXPECT_EQ(count(set, Kind::MAXIMUM), maxima);
  EXPECT_EQ(count(set, Kind::MINIMUM), minima);
  EXPECT_EQ(count(set, Kind::UNDECIDED), undecided);
}

} // namespace

TEST(Curve_extremes, turning_points_of_a_circle)
{
  auto [x, y] = SC::unknowns({-3, 3}, {-3, 3});
  const auto set = SC::turning_points(std::vector<SC::Constraint>{square(x) + square(y) == 4}, x);
  expect_counts(set, 1, 1, 0);
  EXPECT_TRUE(has(set, Kind::MAXIMUM, {2, 0}));
  EXPECT_TRUE(has(set, Kind::MINIMUM, {-2, 0}));
  const auto half = SC::turning_points(std::vector<SC::Constraint>{square(x) + square(y) == 4, x > 0}, x);
  expect_counts(half, 1, 0, 0);
}

TEST(Curve_extremes, turning_points_of_Viviani)
{
  auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const std::vector<SC::Constraint> viviani{x * x + y * y + z * z == 4, square(x - 1) + y * y == 1};
  const auto in_y = SC::turning_points(viviani, y);   // sin t, with cos t = 0 four times; and the node
  expect_counts(in_y, 2, 2, 1);
  for (const double side : {-std::sqrt(2.0), std::sqrt(2.0)}) {
    EXPECT_TRUE(has(in_y, Kind::MAXIMUM, {1, 1, side}));
    EXPECT_TRUE(has(in_y, Kind::MINIMUM, {1, -1, side}));
  }
  EXPECT_TRUE(has(in_y, Kind::UNDECIDED, {2, 0, 0}));
  const auto in_z = SC::turning_points(viviani, z);
  expect_counts(in_z, 1, 1, 1);
  EXPECT_TRUE(has(in_z, Kind::MAXIMUM, {0, 0, 2}));
}

TEST(Curve_extremes, vertices_of_ellipses)
{
  auto [x, y] = SC::unknowns({-5, 5}, {-5, 5});
  const auto set = SC::curvature_extremes(std::vector<SC::Constraint>{x * x / 4 + y * y == 1});
  expect_counts(set, 2, 2, 0);
  for (const double sign : {-1, 1}) {
    EXPECT_TRUE(has(set, Kind::MAXIMUM, {2 * sign, 0}));
    EXPECT_TRUE(has(set, Kind::MINIMUM, {0, sign}));
  }
  // Seen from outside, curvatures are negative.
  const auto outside = SC::curvature_extremes(std::vector<SC::Constraint>{1 - x * x / 4 - y * y == 0, x > 0});
  expect_counts(outside, 0, 1, 0);

  std::mt19937 generator(3);
  std::uniform_int_distribution<int> number(-9, 9);
  for (int round = 0; round < 5; ++round) {
    const Rational a(number(generator), 10), b(number(generator), 10), shear(10 + number(generator), 10);
    const auto turned =
        SC::curvature_extremes(std::vector<SC::Constraint>{square(x - a + shear * y) + 3 * square(y - b) == 2});
    expect_counts(turned, 2, 2, 0);
  }
}

TEST(Curve_extremes, as_many_maxima_as_minima)
{
  auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  // An oval with dents: x^4 + y^4 bends least, not at all, on the axes.
  const std::vector<SC::Constraint> oval{x * x * x * x + y * y * y * y - square(x) * square(y) / 2 + x * y / 8 == 1};
  const auto set = SC::curvature_extremes(oval);
  EXPECT_TRUE(set.summary.is_complete);
  EXPECT_GE(count(set, Kind::MAXIMUM), 4u);
  EXPECT_EQ(count(set, Kind::MAXIMUM), count(set, Kind::MINIMUM));
  EXPECT_EQ(count(set, Kind::UNDECIDED), 0u);
  const auto turning = SC::turning_points(oval, y);
  EXPECT_EQ(count(turning, Kind::MAXIMUM), count(turning, Kind::MINIMUM));
  EXPECT_GE(count(turning, Kind::MAXIMUM), 1u);
}

TEST(Curve_extremes, constant_quantities_are_no_extremes)
{
  auto [x, y] = SC::unknowns({-3, 3}, {-3, 3});
  const auto circle = SC::curvature_extremes(std::vector<SC::Constraint>{square(x) + square(y) == 4});
  EXPECT_FALSE(circle.extremes.empty());
  EXPECT_EQ(count(circle, Kind::UNDECIDED), circle.extremes.size());
  const auto line = SC::turning_points(std::vector<SC::Constraint>{y == 1}, y);
  EXPECT_FALSE(line.extremes.empty());
  EXPECT_EQ(count(line, Kind::UNDECIDED), line.extremes.size());
}

// Planes cut a cylinder in ellipses with the half axes 1 and sqrt(1 + a^2): most curved at (1, 0, a) and (-1, 0, -a),
// least at (0, 1, 0) and (0, -1, 0), up to a motion along the axis.
TEST(Curve_extremes, ellipses_in_space)
{
  auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-9, 9});
  for (const Rational& a : {Rational(1), Rational(1, 2), Rational(-7, 3)}) {
    const auto set =
        SC::curvature_extremes(std::vector<SC::Constraint>{x * x + y * y == 1, z == a * x + Rational(1, 5)});
    EXPECT_TRUE(set.summary.is_complete);
    expect_counts(set, 2, 2, 0);
    for (const auto& extreme : set.extremes) {
      const std::vector<double> p = extreme.solution.point();
      EXPECT_NEAR(std::abs(p[extreme.kind == Kind::MAXIMUM ? 0 : 1]), 1, 1e-12);
      EXPECT_NEAR(p[2], CGAL::to_double(a) * p[0] + 0.2, 1e-12);
    }
  }
}

TEST(Curve_extremes, bad_input)
{
  auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  auto [u, v] = SC::unknowns({-3, 3}, {-3, 3});
  EXPECT_THROW(SC::turning_points(std::vector<SC::Constraint>{x * x + y * y == 1}, x), SC::Invalid_input);
  EXPECT_THROW(SC::turning_points(std::vector<SC::Constraint>{u * u + v * v == 1}, x), SC::Invalid_input);
  EXPECT_THROW(SC::curvature_extremes(std::vector<SC::Constraint>{x * x + y * y + z == 1}), SC::Invalid_input);
}

} // namespace curve_extremes_test
