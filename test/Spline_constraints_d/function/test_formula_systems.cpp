// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formula_test_curves.h"

#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/function/linear_elimination.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/multiplicity.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace formula_systems_test {

namespace {

using namespace formula_test;
using SC::Constraint;
using SC::Expression;
using SC::Solution_kind;
using SC::Spline_map;
using SC::Vector_expression;
using Point = std::vector<Rational>;

Point middle(const SC::Solution_d<double>& solution)
{
  Point result;
  for (const auto& [lower, upper] : solution.exact_box())
    result.push_back((lower + upper) / 2);
  return result;
}

bool holds(const SC::Solution_d<double>& solution, const Point& point)
{
  const auto& box = solution.exact_box();
  for (std::size_t j = 0; j < point.size(); ++j)
    if (point[j] < box[j].first || box[j].second < point[j])
      return false;
  return box.size() == point.size();
}

// The solutions of the constraints are these points, certified, and no others; each is a solution in exact arithmetic.
void expect_solutions(const std::vector<Constraint>& constraints, const std::vector<Point>& points)
{
  const SC::Constraint_system_d system = SC::make_system(constraints);
  const auto solutions = SC::solve(system);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.size(), points.size());
  for (const auto& solution : solutions) {
    EXPECT_EQ(solution.kind(), Solution_kind::CERTIFIED);
    EXPECT_TRUE(SC::verify(system, solution));
  }
  for (const Point& point : points) {
    EXPECT_TRUE(SC::satisfies(system, point));
    EXPECT_EQ(
        std::count_if(solutions.begin(), solutions.end(), [&](const auto& solution) { return holds(solution, point); }),
        1);
  }
}

// Seed 000, section 3.2: circles that touch three circles. These have equal radii, and the centers (0,0), (6,0), (0,8).
TEST(Formula_systems, all_circles_of_Apollonius)
{
  const std::array<Circle, 3> circles{Circle{Rational(0), Rational(0), Rational(1)},
                                      Circle{Rational(6), Rational(0), Rational(1)},
                                      Circle{Rational(0), Rational(8), Rational(1)}};
  const Spline_map<1, 2> c1 = circles[0].map(), c2 = circles[1].map(), c3 = circles[2].map();
  auto [u, v, w] = SC::parameters(c1, c2, c3);
  // equations 12 and 13
  const Vector_expression<2> p = meet(equidistant_hyperplane(c1(u), c2(v)), equidistant_hyperplane(c1(u), c3(w)));
  const std::vector<Constraint> constraints{dot(p - c1(u), derivative(c1)(u)) == 0,
                                            dot(p - c2(v), derivative(c2)(v)) == 0,
                                            dot(p - c3(w), derivative(c3)(w)) == 0};
  for (const Constraint& constraint : constraints) {
    EXPECT_EQ(constraint.conditions, constraints[0].conditions);
    EXPECT_EQ(constraint.conditions.size(), 1u);
  }
  const SC::Constraint_system_d system = SC::make_system(constraints);
  EXPECT_EQ(system.inequalities().size(), 1u);
  const auto solutions = SC::solve(system);
  EXPECT_TRUE(solutions.is_complete());
  ASSERT_EQ(solutions.size(), 8u);
  // One for each choice of the side on which a circle is touched.
  std::set<std::vector<bool>> sides;
  for (const auto& solution : solutions) {
    EXPECT_EQ(solution.kind(), Solution_kind::CERTIFIED);
    EXPECT_TRUE(SC::verify(system, solution));
    const Point at = middle(solution);
    const auto center = p(at);
    std::vector<bool> is_outside;
    for (int i = 0; i < 3; ++i) {
      const Spline_map<1, 2>& c = i == 0 ? c1 : i == 1 ? c2 : c3;
      const auto contact = c(Point{at[i]});
      is_outside.push_back((center[0] - contact[0]) * (contact[0] - circles[i].x) +
                               (center[1] - contact[1]) * (contact[1] - circles[i].y) >
                           0);
    }
    sides.insert(is_outside);
  }
  EXPECT_EQ(sides.size(), 8u);
  // The two around the center (3,4), with the radii 4 and 6.
  for (const Point& contact :
       {Point{ratio(1, 2), ratio(3, 2), ratio(7, 2)}, Point{ratio(5, 2), ratio(7, 2), ratio(3, 2)}}) {
    EXPECT_EQ(p(contact), (std::array<Rational, 2>{Rational(3), Rational(4)}));
    EXPECT_TRUE(SC::satisfies(system, contact));
    EXPECT_EQ(std::count_if(solutions.begin(), solutions.end(),
                            [&](const auto& solution) { return holds(solution, contact); }),
              1);
  }
}

// Equations 7 to 11, with the center as two more unknowns. Circles that meet do not disturb them.
TEST(Formula_systems, circles_of_Apollonius_with_unknown_centers)
{
  const auto count = [](const std::array<Circle, 3>& circles) {
    const Spline_map<1, 2> c1 = circles[0].map(), c2 = circles[1].map(), c3 = circles[2].map();
    auto [x, y, u, v, w] = SC::unknowns({-20, 20}, {-20, 20}, {0, 4}, {0, 4}, {0, 4});
    const Vector_expression p(x, y);
    const auto system = SC::make_system(std::vector<Constraint>{
        squared_norm(p - c1(u)) == squared_norm(p - c2(v)), squared_norm(p - c1(u)) == squared_norm(p - c3(w)),
        dot(p - c1(u), derivative(c1)(u)) == 0, dot(p - c2(v), derivative(c2)(v)) == 0,
        dot(p - c3(w), derivative(c3)(w)) == 0});
    const auto solutions = SC::solve(system);
    EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
    for (const auto& solution : solutions) {
      EXPECT_EQ(solution.kind(), Solution_kind::CERTIFIED);
      EXPECT_TRUE(SC::verify(system, solution));
    }
    return solutions.size();
  };
  EXPECT_EQ(count({Circle{Rational(0), Rational(0), Rational(1)}, Circle{Rational(6), Rational(0), Rational(1)},
                   Circle{Rational(0), Rational(8), Rational(1)}}),
            8u);
  EXPECT_EQ(count({Circle{Rational(0), Rational(0), Rational(2)}, Circle{Rational(3), Rational(0), Rational(2)},
                   Circle{Rational(0), ratio(7, 2), Rational(2)}}),
            4u);
}

// Seed 001, equations 20 to 22.
Constraint bisector(const Spline_map<1, 2>& c1, const Spline_map<1, 2>& c2, const SC::Unknown& u, const SC::Unknown& v)
{
  const Vector_expression<2> a = c1(u), b = c2(v), p = meet(normal_line(c1, u), normal_line(c2, v));
  return dot(p - midpoint(a, b), a - b) == 0;
}

TEST(Formula_systems, bisector_of_lines)
{
  const Spline_map<1, 2> x_axis = polynomial_curve({0, 1}, {0, 0}, -5, 5),
                         y_axis = polynomial_curve({0, 0}, {0, 1}, -5, 5);
  auto [u, v] = SC::parameters(x_axis, y_axis);
  const Constraint constraint = bisector(x_axis, y_axis, u, v);
  EXPECT_TRUE(constraint.conditions.empty());   // the normals are parallel nowhere: the determinant is constant
  std::mt19937 random(11);
  for (int i = 0; i < 10; ++i) {
    const Point point = random_point(random, *u.domains());
    // half of this, in integers
    EXPECT_EQ(value(constraint.spline_function(), point), point[0] * point[0] - point[1] * point[1]);
  }
}

TEST(Formula_systems, bisector_of_circles)
{
  const Spline_map<1, 2> c1 = Circle{Rational(0), Rational(0), Rational(1)}.map(),
                         c2 = Circle{Rational(6), Rational(0), Rational(2)}.map();
  auto [u, v] = SC::parameters(c1, c2);
  // On the normal of c1 with the direction (3,4)/5, the points at equal distance are 175/46 and 45/2 away from the
  // origin.
  expect_solutions({bisector(c1, c2, u, v), u == ratio(1, 2)},
                   {{ratio(1, 2), ratio(23, 14)}, {ratio(1, 2), ratio(8, 3)}});
}

TEST(Formula_systems, self_bisector_of_a_parabola)
{
  const Spline_map<1, 2> c = polynomial_curve({0, 1}, {0, 0, 1}, -2, 2);
  auto [u, v] = SC::parameters(c, c);
  const Vector_expression<2> a = c(u), b = c(v), p = meet(normal_line(c, u), normal_line(c, v));
  // It is its axis, u + v = 0.
  const Expression reduced = SC::divided_exactly(dot(p - midpoint(a, b), a - b), u - v, 3);
  EXPECT_EQ(reduced(Point{Rational(1), ratio(1, 2)}), ratio(3, 4));
  expect_solutions({reduced == 0, u == ratio(1, 3)}, {{ratio(1, 3), ratio(-1, 3)}});
}

TEST(Formula_systems, self_intersection)
{
  const Spline_map<1, 2> c = polynomial_curve({0, 0, 1}, {0, -1, 0, 1}, -2, 2);   // (t^2, t^3 - t) is at (1,0) twice
  auto [u, v] = SC::parameters(c, c);
  const Vector_expression<2> chord = SC::divided_exactly(c(u) - c(v), u - v);
  expect_solutions({chord[0] == 0, chord[1] == 0, u < v}, {{Rational(-1), Rational(1)}});
}

// Seed 000, section 3.1: the pedal triangle of a triangle with the sides 13, 14 and 15 is its only ray-trap.
TEST(Formula_systems, ray_trap_of_a_triangle)
{
  const std::array<Spline_map<1, 2>, 3> sides{bezier_curve({{0, 0}, {14, 0}}), bezier_curve({{14, 0}, {5, 12}}),
                                              bezier_curve({{5, 12}, {0, 0}})};
  const auto t = SC::unknowns(3, {0.125, 0.875});   // without the corners, where a trap of two points may end
  std::vector<Constraint> constraints;
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3, after = (i + 1) % 3;
    const Vector_expression<2> n = normal(sides[i], t[i]), in = sides[before](t[before]) - sides[i](t[i]),
                               out = sides[after](t[after]) - sides[i](t[i]);
    // equation 6, squared
    constraints.push_back(square(dot(in, n)) * squared_norm(out) == square(dot(out, n)) * squared_norm(in));
    constraints.push_back(dot(in, n) > 0);
    constraints.push_back(dot(out, n) > 0);
  }
  expect_solutions(constraints, {{ratio(5, 14), ratio(14, 25), ratio(99, 169)}});
}

// Of three circles (Figure 2): the triangles whose perimeter is stationary. The perimeter is a function on a torus of
// dimension three, so there are at least 8 if it is not degenerate.
TEST(Formula_systems, ray_traps_of_circles)
{
  const std::array<Spline_map<1, 2>, 3> circles{Circle{Rational(0), Rational(0), Rational(1)}.map(),
                                                Circle{Rational(5), Rational(0), Rational(2)}.map(),
                                                Circle{Rational(1), Rational(6), Rational(1)}.map()};
  const auto t = SC::parameters(circles[0], circles[1], circles[2]);
  std::vector<Constraint> constraints;
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3, after = (i + 1) % 3;
    const Vector_expression<2> n = normal(circles[i], t[i]), in = circles[before](t[before]) - circles[i](t[i]),
                               out = circles[after](t[after]) - circles[i](t[i]);
    constraints.push_back(square(dot(in, n)) * squared_norm(out) == square(dot(out, n)) * squared_norm(in));
    constraints.push_back(dot(in, n) * dot(out, n) > 0);   // reflected, not passed on
  }
  const SC::Constraint_system_d system = SC::make_system(constraints);
  const auto solutions = SC::solve(system);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.size(), 8u);
  for (const auto& solution : solutions) {
    EXPECT_EQ(solution.kind(), Solution_kind::CERTIFIED);
    EXPECT_TRUE(SC::verify(system, solution));
  }
}

TEST(Formula_systems, zeros_of_divisors_are_no_solutions)
{
  auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  expect_solutions({(x * x - y) / (x - 1) == 0, y == 1}, {{Rational(-1), Rational(1)}});
  expect_solutions({(x * x - y) / (x - y) == 0, x == y}, {});
  expect_solutions({1 / x == 2, y / (x - y) == -2}, {{ratio(1, 2), Rational(1)}});
  expect_solutions({x * x == 1, y * y == 1, x != y}, {{Rational(1), Rational(-1)}, {Rational(-1), Rational(1)}});
  expect_solutions({x * x == 1, y == x, 1 / x > 0}, {{Rational(1), Rational(1)}});
}

TEST(Formula_systems, systems_take_formulas)
{
  auto [x, y] = SC::unknowns({-2, 2}, {1, 3});
  SC::Constraint_system_d system({{Rational(-1), Rational(1)}, {Rational(1), Rational(2)}});   // a part of the ranges
  system.add(x / y == ratio(1, 2));
  system.add((y - 1) / (x - ratio(1, 2)) == 0);
  system.add(y / (2 * x - 1) < 7);
  EXPECT_EQ(system.equalities().size(), 2u);
  EXPECT_EQ(system.inequalities().size(), 2u);   // one condition
  EXPECT_TRUE(SC::solve(system).is_complete());
  EXPECT_EQ(SC::solve(system).size(), 0u);
  SC::Constraint_system_d larger({{Rational(-1), Rational(1)}, {Rational(0), Rational(2)}});
  EXPECT_THROW(larger.add(x / y == 1), SC::Invalid_input);
  SC::Constraint_system_d smaller({{Rational(-1), Rational(1)}});
  EXPECT_THROW(smaller.add(x == y), SC::Invalid_input);
  const Spline_map<1, 2> c = Circle{Rational(0), Rational(0), Rational(1)}.map();
  EXPECT_THROW(SC::solve(c(x)[0] == 1, y == 1), SC::Invalid_input);
}

TEST(Formula_systems, one_unknown)
{
  auto [t] = SC::unknowns({-3, 3});
  expect_solutions({(t * t - 1) / (t - 1) == 0}, {{Rational(-1)}});
  expect_solutions({t * t * t == t, t != 1}, {{Rational(-1)}, {Rational(0)}});
  const Spline_map<1, 2> c = Circle{Rational(0), Rational(0), Rational(1)}.map();
  auto [u] = SC::parameters(c);
  expect_solutions({c(u)[1] / c(u)[0] == ratio(4, 3), c(u)[0] > 0}, {{ratio(1, 2)}});
}

} // namespace

} // namespace formula_systems_test
