// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Singular points of curves of solutions: how many branches end in cusps, tacnodes, multiple points, in the plane and
// in space, on boundaries, breaks and inequalities; what stays undecided.

#include "curve_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Isolated_zero_test.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace singular_points_test {

using Rational = SC::Exact_rational;
using P = SC::Power_polynomial;
using Point = std::vector<Rational>;
using SC::unknowns;

namespace {

const P x = P::variable(0), y = P::variable(1), z = P::variable(2);

struct Singular_curve
{
  std::string name;
  P equation;
  std::size_t branches;   // that end in 0
};

std::vector<Singular_curve> singular_curves()
{
  return {{"node", x * y, 4},
          {"cusp", y * y - x * x * x, 2},
          {"tacnode", y * y - pow(x, 4), 4},
          {"tacnode of which nothing is real", y * y + pow(x, 4), 0},
          {"cusp of fifth order", y * y - pow(x, 5), 2},
          {"three lines", pow(x, 3) - 3 * x * y * y, 6},
          {"line and isolated point", x * (x * x + y * y), 2},
          {"line through a cusp", x * (y * y - x * x * x), 4},
          {"one branch of order three", pow(x, 3) - pow(y, 4), 2},
          {"one branch of order three, bent more", pow(x, 3) - pow(y, 5), 2},
          {"ramphoid cusp", pow(y - x * x, 2) - pow(x, 5), 2},
          {"four lines", x * y * (x - y) * (x + 2 * y), 8}};
}

P moved(const P& f, const Rational& cosine, const Rational& sine, const Point& origin)
{
  const P u = P::variable(2), v = P::variable(3), dx = x - P(origin[0]), dy = y - P(origin[1]);
  return f.substituted(0, u)
      .substituted(1, v)
      .substituted(2, P(cosine) * dx - P(sine) * dy)
      .substituted(3, P(sine) * dx + P(cosine) * dy);
}

SC::Curve_solution_set_d solved(const std::vector<P>& equations,
                                const std::vector<SC::Constraint_system_d::Domain>& domain)
{
  SC::Constraint_system_d system(domain);
  for (const P& equation : equations)
    system.add(equation, SC::Relation::EQUAL);
  return SC::solve_curves(system, {.tolerance = 1e-8, .node_limit = 100000});
}

// The number of branches that end in a singular point, which is known exactly; -1 if there is none.
int branches_at(const SC::Curve_solution_set_d& set, const Point& point)
{
  for (const std::size_t i : set.singular_points()) {
    bool is_equal = true;
    for (std::size_t j = 0; j < point.size(); ++j)
      is_equal = is_equal && set.vertices()[i].box[j] == std::pair(point[j], point[j]);
    if (is_equal)
      return static_cast<int>(number_of_ends_at(set, i));
  }
  return -1;
}

void expect_star(const SC::Curve_solution_set_d& set, const Point& point, std::size_t branches, const std::string& what)
{
  check_chains(set);
  EXPECT_TRUE(set.is_complete()) << what;
  EXPECT_EQ(set.singular_points().size(), 1u) << what;
  EXPECT_EQ(branches_at(set, point), static_cast<int>(branches)) << what;
  EXPECT_EQ(set.number_of_closed_curves(), 0u) << what;
  EXPECT_EQ(set.number_of_open_curves(), branches) << what;
}

} // namespace

TEST(Isolated_zero_test, radii)
{
  const auto is_alone = [](const std::vector<P>& polynomials, const Rational& distance) {
    return SC::internal::Isolated_zero_test(polynomials, 2).is_alone_in({distance, distance});
  };
  EXPECT_TRUE(is_alone({x * x, y * y * y}, 1000));
  EXPECT_TRUE(is_alone({x * x - y * y * y, x * y}, 10));
  EXPECT_TRUE(is_alone({x * x - x, y}, Rational(99, 100)));   // the next zero is (1, 0)
  EXPECT_FALSE(is_alone({x * x - x, y}, 1));
  EXPECT_TRUE(is_alone({y - x * x, y - x * x * x}, Rational(1, 3)));   // (1, 1)
  EXPECT_FALSE(is_alone({y - x * x, y - x * x * x}, 1));
  EXPECT_FALSE(is_alone({x * y, x * x}, Rational(1, 1000)));   // a line
  EXPECT_FALSE(is_alone({x * x + y * y}, Rational(1, 1000)));   // not among complex zeros
}

TEST(Singular_points, branches_of_known_singularities)
{
  for (const Singular_curve& curve : singular_curves())
    expect_star(solved({curve.equation}, {{-1, Rational(9, 8)}, {Rational(-7, 8), 1}}), {0, 0}, curve.branches,
                curve.name);
}

TEST(Singular_points, rotated_and_moved_to_rational_points)
{
  std::mt19937 generator(3);
  std::uniform_int_distribution<int> numerator(-50, 50), denominator(101, 199);
  for (const Singular_curve& curve : singular_curves()) {
    const Point origin{Rational(numerator(generator)) / denominator(generator),
                       Rational(numerator(generator)) / denominator(generator)};
    const bool is_first = generator() % 2 == 0;
    const P equation = moved(curve.equation, is_first ? Rational(3, 5) : Rational(5, 13),
                             is_first ? Rational(4, 5) : Rational(12, 13), origin);
    const auto set = solved({equation}, {{-1, Rational(9, 8)}, {Rational(-7, 8), 1}});
    check_chains(set);
    EXPECT_TRUE(set.is_complete()) << curve.name;
    EXPECT_EQ(branches_at(set, origin), static_cast<int>(curve.branches)) << curve.name;
  }
}

TEST(Singular_points, closed_curves_with_cusps_and_triple_points)
{
  const std::vector<SC::Constraint_system_d::Domain> square{{-3, Rational(13, 4)}, {-3, Rational(25, 8)}};
  const auto trifolium = solved({pow(x * x + y * y, 2) - x * (x * x - 3 * y * y)}, square);
  EXPECT_TRUE(trifolium.is_complete());
  EXPECT_EQ(trifolium.number_of_open_curves(), 3u);   // the leaves
  EXPECT_EQ(branches_at(trifolium, {0, 0}), 6);

  const auto astroid = solved({pow(x * x + y * y - 4, 3) + 108 * x * x * y * y}, square);
  EXPECT_TRUE(astroid.is_complete());
  EXPECT_EQ(astroid.number_of_open_curves(), 4u);
  EXPECT_EQ(astroid.singular_points().size(), 4u);
  for (const Point& cusp : {Point{2, 0}, Point{-2, 0}, Point{0, 2}, Point{0, -2}})
    EXPECT_EQ(branches_at(astroid, cusp), 2);

  const auto bicuspid = solved({(x * x - 1) * pow(x - 1, 2) + pow(y * y - 1, 2)}, square);
  EXPECT_TRUE(bicuspid.is_complete());
  EXPECT_EQ(bicuspid.singular_points().size(), 2u);
  EXPECT_EQ(branches_at(bicuspid, {1, 1}), 2);
  EXPECT_EQ(branches_at(bicuspid, {1, -1}), 2);

  const auto circles = solved({(x * x + y * y - y) * (x * x + y * y + 2 * y)}, square);   // touch each other
  EXPECT_TRUE(circles.is_complete());
  EXPECT_EQ(circles.number_of_open_curves(), 2u);
  EXPECT_EQ(branches_at(circles, {0, 0}), 4);
}

TEST(Singular_points, lines_and_circles_through_one_point)
{
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> number(-9, 9);
  for (int round = 0; round < 6; ++round) {
    const Point origin{Rational(number(generator)) / 31, Rational(number(generator)) / 37};
    const P dx = x - P(origin[0]), dy = y - P(origin[1]);
    P product(1);
    std::vector<std::pair<int, int>> normals;
    while (normals.size() < 3u + static_cast<std::size_t>(round % 2)) {
      const std::pair<int, int> normal(number(generator), number(generator));
      if (std::any_of(normals.begin(), normals.end(),
                      [&](const auto& other) { return other.first * normal.second == other.second * normal.first; }) ||
          normal == std::pair(0, 0))
        continue;
      // a circle, and lines
      product *= P(normal.first) * dx + P(normal.second) * dy + (normals.empty() ? dx * dx + dy * dy : P(0));
      normals.push_back(normal);
    }
    const auto set = solved({product}, {{-20, 21}, {-22, 23}});
    const std::string what = "round " + std::to_string(round);
    check_chains(set);
    EXPECT_TRUE(set.is_complete()) << what;
    EXPECT_EQ(branches_at(set, origin), static_cast<int>(2 * normals.size())) << what;
    EXPECT_EQ(set.singular_points().size(), normals.size()) << what;   // each line meets the circle again
  }
}

TEST(Singular_points, in_space)
{
  const std::vector<SC::Constraint_system_d::Domain> cube{
      {-1, Rational(9, 8)}, {-1, Rational(17, 16)}, {Rational(-15, 16), 1}};
  const P paraboloid = z - x * x - 2 * y * y;
  for (const Singular_curve& curve : singular_curves())
    if (curve.equation.total_degree() <= 3)
      expect_star(solved({paraboloid + curve.equation, 2 * paraboloid - curve.equation}, cube), {0, 0, 0},
                  curve.branches, curve.name);
  expect_star(solved({x * x + y * y - z * z, 5 * x * x - y * y - z * z}, cube), {0, 0, 0}, 8,
              "cones with the same apex");
}

TEST(Singular_points, on_the_boundary_of_the_domain)
{
  const std::vector<SC::Constraint_system_d::Domain> right{{0, 1}, {-1, Rational(9, 8)}},
      upper{{-1, Rational(9, 8)}, {0, 1}};
  const P cusp = y * y - x * x * x, lines = pow(x, 3) - 3 * x * y * y;
  expect_star(solved({cusp}, right), {0, 0}, 2, "cusp, its two branches inside");
  expect_star(solved({cusp}, upper), {0, 0}, 1, "cusp, one branch inside");
  expect_star(solved({y * y - pow(x, 4)}, right), {0, 0}, 2, "tacnode");
  expect_star(solved({lines}, upper), {0, 0}, 3, "three lines");
  expect_star(solved({x * x - y * y}, right), {0, 0}, 2, "node");
  EXPECT_TRUE(solved({cusp}, right).vertices()[solved({cusp}, right).singular_points()[0]].is_on_boundary);
}

TEST(Singular_points, on_breaks)
{
  // y^2 = x^3 where x > 0, y^2 = x^2 elsewhere.
  SC::Spline_term term{{0, 1}, {3, 2}, {{-1, 0, 1}, {-1, 1}}, {}};
  term.pieces.push_back({0, 0, 1, 0, 0, 0, -1, 0, 0, 0, 0, 0});
  term.pieces.push_back({0, 0, 1, 0, 0, 0, 0, 0, 0, -1, 0, 0});
  SC::Constraint_system_d system({{-1, 1}, {-1, 1}});
  system.add(SC::Spline_function(term), SC::Relation::EQUAL);
  expect_star(SC::solve_curves(system), {0, 0}, 4, "cusp and node");
}

TEST(Singular_points, on_inequalities)
{
  auto [u, v] = unknowns({-1, 1}, {-1, 1});
  const auto lines = u * u * u == 3 * u * v * v;   // at 30, 90, 150, ... degrees
  expect_star(SC::solve_curves(lines, v >= 0), {0, 0}, 3, "closed half plane");
  expect_star(SC::solve_curves(lines, v >= 0, u >= -v), {0, 0}, 2, "closed sector");

  const auto open = SC::solve_curves(lines, v > 0);   // the point does not belong to it
  EXPECT_TRUE(open.is_complete());
  EXPECT_EQ(open.number_of_open_curves(), 3u);
  EXPECT_TRUE(open.singular_points().empty());
  EXPECT_TRUE(open.points().empty());

  const auto cusp = SC::solve_curves(v * v == u * u * u, u <= 0);   // only the point is left
  EXPECT_TRUE(cusp.is_complete());
  EXPECT_TRUE(cusp.curves().empty());
  EXPECT_EQ(branches_at(cusp, {0, 0}), 0);
}

TEST(Singular_points, what_stays_undecided)
{
  // cusps at irrational points
  const auto set = solved({y * y - pow(x * x - 2, 3)}, {{-2, Rational(33, 16)}, {-2, 2}});
  check_chains(set);
  EXPECT_FALSE(set.is_complete());
  EXPECT_TRUE(set.singular_points().empty());
  EXPECT_FALSE(set.undecided().empty());
}

// Curves that are there several times are found once, and what is singular on them as it is on simple ones.
TEST(Singular_points, repeated_factors)
{
  const P circle = x * x + y * y - 1, line = x - y - Rational(1, 4);
  const auto expect = [](const P& equation, std::size_t closed, std::size_t open, std::size_t nodes) {
    const auto set = solved({equation}, {{-2, Rational(33, 16)}, {-2, 2}});
    check_chains(set);
    EXPECT_TRUE(set.is_complete());
    EXPECT_EQ(set.number_of_closed_curves(), closed);
    EXPECT_EQ(set.number_of_open_curves(), open);
    ASSERT_EQ(set.singular_points().size(), nodes);
    for (const std::size_t i : set.singular_points())
      EXPECT_EQ(number_of_ends_at(set, i), 4u);
  };
  expect(x * x * (1 + y * y), 0, 1, 0);
  expect(pow(circle, 3), 1, 0, 0);
  expect(circle * circle * line, 0, 5, 2);   // nodes at irrational points
  expect(circle * circle * pow(line, 3), 0, 5, 2);
  std::mt19937 random(7);
  std::uniform_int_distribution<int> place(-8, 8);
  for (int round = 0; round < 10; ++round) {
    const P moved = pow(x - Rational(place(random), 10), 2) + pow(y - Rational(place(random), 10), 2) - Rational(1, 4);
    expect(moved * moved * (Rational(20) + x * y), 1, 0, 0);
  }
}

} // namespace singular_points_test
