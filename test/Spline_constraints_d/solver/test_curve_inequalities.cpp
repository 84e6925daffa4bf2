// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of solutions that inequalities cut: where they end, and how many arcs are left.

#include "curve_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace curve_inequalities_test {

using Rational = SC::Exact_rational;
using SC::unknowns;

namespace {

// The ends of the open curves, all of them zeros of inequalities, sorted.
std::vector<std::vector<double>> ends_at_inequalities(const SC::Curve_solution_set_d& set)
{
  std::vector<std::vector<double>> result;
  for (const SC::Solution_curve& curve : set.curves())
    if (!curve.is_closed)
      for (const std::size_t i : {curve.pieces.front().ends[0], curve.pieces.back().ends[1]}) {
        EXPECT_TRUE(set.vertices()[i].is_on_inequality);
        result.push_back(set.vertices()[i].point());
      }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_numbers(const SC::Curve_solution_set_d& set, std::size_t closed, std::size_t open, std::size_t points = 0)
{
  check_chains(set);
  EXPECT_TRUE(set.is_complete()) << set;
  EXPECT_EQ(set.number_of_closed_curves(), closed) << set;
  EXPECT_EQ(set.number_of_open_curves(), open) << set;
  EXPECT_EQ(set.points().size(), points) << set;
}

} // namespace

TEST(Curve_inequalities, sphere_and_cylinder_above_a_plane)
{
  auto [x, y, z] = unknowns({-3, 6}, {-3, 3}, {-3, 3});
  const auto set = SC::solve_curves(x * x + y * y + z * z == 4, square(x - 2) + y * y == 1, z >= 0);
  expect_numbers(set, 0, 1);
  const auto ends = ends_at_inequalities(set);
  ASSERT_EQ(ends.size(), 2u);
  const double height = std::sqrt(15.0) / 4;
  for (std::size_t i : {0, 1}) {
    EXPECT_NEAR(ends[i][0], 1.75, 1e-14);
    EXPECT_NEAR(ends[i][1], i == 0 ? -height : height, 1e-14);
    EXPECT_NEAR(ends[i][2], 0, 1e-14);
  }
}

TEST(Curve_inequalities, circle)
{
  auto [x, y] = unknowns({-2, 2}, {-2, 2});
  const auto circle = x * x + y * y == 1;
  expect_numbers(SC::solve_curves(circle, x > 0), 0, 1);
  expect_numbers(SC::solve_curves(circle, 3 * x < 5 * y), 0, 1);
  expect_numbers(SC::solve_curves(circle, x * y > 0), 0, 2);
  expect_numbers(SC::solve_curves(circle, x * y != 0), 0, 4);
  expect_numbers(SC::solve_curves(circle, 3 * x != 5 * y, x <= 2), 0, 2);
  expect_numbers(SC::solve_curves(circle, x != 2), 1, 0);
  expect_numbers(SC::solve_curves(circle, x <= 2), 1, 0);
  expect_numbers(SC::solve_curves(circle, x > Rational(3, 2)), 0, 0);
  expect_numbers(SC::solve_curves(circle, x > Rational(-1, 2), x < Rational(1, 2)), 0, 2);
  expect_numbers(SC::solve_curves(circle, x > Rational(1, 2), x < Rational(-1, 2)), 0, 0);
  const auto ends = ends_at_inequalities(SC::solve_curves(circle, x >= Rational(3, 5)));
  ASSERT_EQ(ends.size(), 2u);
  EXPECT_NEAR(ends[0][1], -0.8, 1e-15);
  EXPECT_NEAR(ends[1][1], 0.8, 1e-15);
}

TEST(Curve_inequalities, contacts)
{
  auto [x, y] = unknowns({-2, 2}, {-2, 2});
  const auto circle = x * x + y * y == 1;
  expect_numbers(SC::solve_curves(circle, x <= 1), 1, 0);      // touches the line from inside
  expect_numbers(SC::solve_curves(circle, x < 1), 0, 1);       // without the point
  expect_numbers(SC::solve_curves(circle, x < 1, y < 1), 0, 2);
  expect_numbers(SC::solve_curves(circle, 3 * x + 4 * y != 5), 0, 1);
  expect_numbers(SC::solve_curves(circle, x >= 1), 0, 0, 1);   // and from outside
  expect_numbers(SC::solve_curves(circle, x > 1), 0, 0, 0);
  const auto point = SC::solve_curves(circle, 3 * x + 4 * y >= 5);
  expect_numbers(point, 0, 0, 1);
  expect_point(point.vertices()[point.points()[0]].box, std::vector<Rational>{Rational(3, 5), Rational(4, 5)});
}

TEST(Curve_inequalities, zeros_on_the_boundary_of_the_domain)
{
  auto [x, y] = unknowns({0, 2}, {-2, 2});
  const auto circle = x * x + y * y == 1;
  expect_numbers(SC::solve_curves(circle, y <= 1), 0, 1);
  expect_numbers(SC::solve_curves(circle, y >= 1), 0, 0, 1);
  expect_numbers(SC::solve_curves(circle, x >= 0), 0, 1);      // the inequality and the domain have the same boundary
  expect_numbers(SC::solve_curves(circle, x + y >= 1), 0, 1);  // from a corner of both
  expect_numbers(SC::solve_curves(circle, x - y >= 1), 0, 1);
  expect_numbers(SC::solve_curves(circle, x <= 0), 0, 0, 2);
}

TEST(Curve_inequalities, zero_on_all_of_a_curve_is_not_decided)
{
  auto [x, y] = unknowns({-2, 2}, {-2, 2});
  const auto set = SC::solve_curves(x * x + y * y == 1, (x * x + y * y - 1) * (x + 3) >= 0);
  EXPECT_FALSE(set.is_complete());
  EXPECT_FALSE(set.undecided().empty());
  EXPECT_LT(set.summary().nodes, 5000u);
}

TEST(Curve_inequalities, singular_points_that_are_cut_off)
{
  auto [x, y] = unknowns({-2, 2}, {-2, 2});
  const auto folium = x * x * x + y * y * y == 3 * x * y;   // a loop with its node at the origin
  const auto all = SC::solve_curves(folium);
  EXPECT_EQ(all.singular_points().size(), 1u);
  const auto tip = SC::solve_curves(folium, x + y > 1);
  expect_numbers(tip, 0, 1);
  EXPECT_TRUE(tip.singular_points().empty());
  const auto cusp = SC::solve_curves(x * x * x == y * y, x > Rational(1, 4));   // the cusp alone would be undecided
  expect_numbers(cusp, 0, 2);
}

// The arcs of a circle of the plane between half-planes, counted by their ends.
TEST(Curve_inequalities, random_half_planes)
{
  std::mt19937 random(51);
  std::uniform_int_distribution<int> coefficient(-9, 9), number(1, 3);
  std::size_t arcs = 0, trials = 0;
  for (int trial = 0; trial < 60; ++trial) {
    auto [x, y] = unknowns({-2, 2}, {-2, 2});
    std::vector<SC::Constraint> constraints{x * x + y * y == 1};
    struct Half_plane
    {
      int a, b, c;
      double operator()(double angle) const { return a * std::cos(angle) + b * std::sin(angle) + 0.1 * c; }
    };
    std::vector<Half_plane> half_planes;
    for (int k = number(random); k > 0; --k) {
      const Half_plane h{coefficient(random), coefficient(random), coefficient(random)};
      if (100 * (h.a * h.a + h.b * h.b) == h.c * h.c || (h.a == 0 && h.b == 0))
        continue;
      half_planes.push_back(h);
      constraints.push_back(h.a * x + h.b * y + Rational(h.c, 10) > 0);
    }
    const auto is_kept = [&](double angle) {
      return std::all_of(half_planes.begin(), half_planes.end(), [&](const Half_plane& h) { return h(angle) > 0; });
    };
    std::vector<double> zeros;
    for (const Half_plane& h : half_planes) {
      const double size = std::hypot(h.a, h.b), cosine = -0.1 * h.c / size;
      if (std::abs(cosine) < 1)
        for (const double sign : {-1.0, 1.0})
          zeros.push_back(std::remainder(std::atan2(h.b, h.a) + sign * std::acos(cosine), 2 * std::numbers::pi));
    }
    std::sort(zeros.begin(), zeros.end());
    bool is_general = true;
    for (std::size_t k = 1; k < zeros.size(); ++k)
      is_general = is_general && zeros[k] - zeros[k - 1] > 1e-9;
    if (!is_general)
      continue;
    ++trials;
    std::size_t open = 0;   // the arcs that begin
    for (const double zero : zeros)
      open += is_kept(zero + 1e-10) && !is_kept(zero - 1e-10);
    const auto set = SC::solve_curves(SC::make_system(constraints));
    expect_numbers(set, open == 0 && is_kept(0) ? 1 : 0, open);
    arcs += open;
    const auto ends = ends_at_inequalities(set);
    EXPECT_EQ(ends.size(), 2 * open);
    for (const auto& end : ends) {
      const double angle = std::atan2(end[1], end[0]);
      EXPECT_TRUE(std::any_of(zeros.begin(), zeros.end(), [&](double zero) {
        return std::abs(std::remainder(zero - angle, 2 * std::numbers::pi)) < 1e-13;
      }));
    }
  }
  EXPECT_GT(arcs, 30u);
  EXPECT_GT(trials, 50u);
}

// Random curves in two and three unknowns: what lies on both sides of a quadric g = 0 is what != leaves, and it is cut
// exactly at the solutions of f = g = 0, which the point solver finds.
TEST(Curve_inequalities, both_sides_of_random_quadrics)
{
  const auto cuts = [](const SC::Curve_solution_set_d& set) {
    std::size_t result = 0;
    for (const SC::Solution_curve& curve : set.curves())
      if (!curve.is_closed)
        result += set.vertices()[curve.pieces.front().ends[0]].is_on_inequality +
            set.vertices()[curve.pieces.back().ends[1]].is_on_inequality;
    return result;
  };
  std::mt19937 random(8);
  std::uniform_int_distribution<int> coefficient(-50, 50);
  std::size_t points = 0, complete = 0;
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t n = 2 + static_cast<std::size_t>(trial % 2);
    const auto x = unknowns(std::vector<std::array<SC::Bound, 2>>(n, {SC::Bound(-1), SC::Bound(1)}));
    const auto polynomial = [&](bool is_cubic) {
      SC::Expression sum(coefficient(random));
      for (std::size_t i = 0; i < n; ++i) {
        sum = sum + coefficient(random) * x[i];
        for (std::size_t j = i; j < n; ++j)
          sum = sum + coefficient(random) * x[i] * x[j] +
              (is_cubic ? coefficient(random) : 0) * x[i] * x[j] * x[(i + j) % n];
      }
      return sum;
    };
    std::vector<SC::Constraint> equations{polynomial(n == 2) == 0};
    if (n == 3)
      equations.push_back(polynomial(false) == 0);
    const SC::Expression g = polynomial(false);
    const auto system = [&](const SC::Constraint& last) {
      SC::Constraint_system_d result(std::vector<SC::Constraint_system_d::Domain>(n, {-1, 1}));
      for (const SC::Constraint& equation : equations)
        result.add(equation);
      result.add(last);
      return result;
    };
    const auto zeros = SC::solve(system(g == 0));
    const auto above = SC::solve_curves(system(g > 0)), below = SC::solve_curves(system(g < 0)),
               both = SC::solve_curves(system(g != 0));
    if (!zeros.is_complete() || !above.is_complete() || !below.is_complete() || !both.is_complete())
      continue;
    ++complete;
    points += zeros.size();
    EXPECT_EQ(cuts(above), zeros.size()) << trial;
    EXPECT_EQ(cuts(below), zeros.size()) << trial;
    EXPECT_EQ(cuts(both), 2 * zeros.size()) << trial;
    EXPECT_EQ(above.number_of_open_curves() + below.number_of_open_curves(), both.number_of_open_curves()) << trial;
    EXPECT_EQ(above.number_of_closed_curves() + below.number_of_closed_curves(), both.number_of_closed_curves())
        << trial;
  }
  EXPECT_GE(complete, 58u);
  EXPECT_GT(points, 20u);
}

// A spline with a corner as inequality, y > 1/4 - |x|, whose break cuts the domain too.
TEST(Curve_inequalities, splines)
{
  SC::Constraint_system_d system = SC::Constraint_system_d::on_box({{-2, 2}, {-2, 2}});
  const auto x = SC::Power_polynomial::variable(0), y = SC::Power_polynomial::variable(1);
  system.add(x * x + SC::Power_polynomial(Rational(4)) * y * y - SC::Power_polynomial(Rational(1)),
             SC::Relation::EQUAL);
  SC::Spline_function above = y;
  above += SC::Spline_function(SC::Spline_term{{0}, {1}, {{-2, 0, 2}}, {{Rational(-1, 4), -1}, {Rational(-1, 4), 1}}});
  system.add(above, SC::Relation::GREATER);
  const auto set = SC::solve_curves(system);
  expect_numbers(set, 0, 1);
  const auto ends = ends_at_inequalities(set);
  ASSERT_EQ(ends.size(), 2u);
  const double x_end = (2 + std::sqrt(19.0)) / 10;
  EXPECT_NEAR(ends[0][0], -x_end, 1e-15);
  EXPECT_NEAR(ends[1][0], x_end, 1e-15);
  EXPECT_NEAR(ends[1][1], 0.25 - x_end, 1e-15);
}

// Points of the polyline satisfy the inequality.
TEST(Curve_inequalities, polylines_end_where_the_inequality_is_zero)
{
  auto [x, y, z] = unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const std::vector<SC::Constraint> constraints{x * x + y * y + z * z == 4, x + 2 * y == z, x * x < 1};
  const SC::Constraint_system_d system = SC::make_system(constraints);
  const auto set = SC::solve_curves(system);
  expect_numbers(set, 0, 2);
  for (const SC::Solution_curve& curve : set.curves()) {
    const auto points = SC::to_polyline(system, set, curve, 1e-3);
    EXPECT_GT(points.size(), 10u);
    for (const auto& point : points) {
      EXPECT_LE(std::abs(point[0]), 1 + 1e-14);
      EXPECT_NEAR(point[0] + 2 * point[1], point[2], 1e-13);
    }
    EXPECT_NEAR(std::abs(points.front()[0] - points.back()[0]), 2, 1e-13);
  }
}

} // namespace curve_inequalities_test
