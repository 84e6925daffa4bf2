// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whether constraints can be satisfied: sets that are apart, meet, touch, at rational and at irrational points; strict
// inequalities and inequations; equalities; splines with breaks; random constraints of which it is known; convex ones
// in many unknowns; steps of the relaxation in closed form; limits and bad input.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Relaxation.h>

#include "planted_feasibility.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace feasibility_test {

namespace SC = CGAL::Spline_constraints;
using SC::Power_polynomial;
using SC::Relation;
using Rational = SC::Exact_rational;
using Conditions = std::vector<std::pair<Power_polynomial, Relation>>;
using Domain = std::vector<SC::Constraint_system_d::Domain>;
using Point = std::vector<Rational>;

namespace {

Power_polynomial variable(int index) { return Power_polynomial::variable(index); }
const Power_polynomial x = variable(0), y = variable(1), z = variable(2);
const Domain square{{-3, 5}, {-3, 4}};
constexpr Relation at_most = Relation::LESS_EQUAL, less = Relation::LESS, at_least = Relation::GREATER_EQUAL,
                   equal = Relation::EQUAL, not_equal = Relation::NOT_EQUAL;

Power_polynomial fraction(int numerator, int denominator)
{
  return Power_polynomial(Rational(Rational(numerator) / Rational(denominator)));
}

Power_polynomial disk(const Power_polynomial& a, const Power_polynomial& b)
{
  return (x - a) * (x - a) + (y - b) * (y - b) - 1;
}

SC::Feasibility_d decided(const Domain& domain, const Conditions& conditions)
{
  const SC::Feasibility_d answer = SC::Feasibility_solver_d()(domain, conditions);
  EXPECT_TRUE(answer.is_complete()) << answer << (answer.undecided().empty() ? "" : answer.undecided()[0].reason);
  planted_feasibility::Generator generator(1);
  const planted_feasibility::Problem problem{domain, conditions, answer.is_feasible()};
  if (answer.has_point()) {
    EXPECT_EQ(planted_feasibility::error_of_solution(problem, answer), "");
  }
  if (answer.is_infeasible()) {
    EXPECT_EQ(planted_feasibility::error_of_proof(problem, answer, generator), "");
  }
  return answer;
}

bool is_feasible(const Domain& domain, const Conditions& conditions)
{
  return decided(domain, conditions).is_feasible();
}

bool holds(const SC::Feasibility_d::Box& box, std::size_t unknown, double value)
{
  return box[unknown].first <= Rational(value + 1e-9) && Rational(value - 1e-9) <= box[unknown].second &&
      Rational(box[unknown].second - box[unknown].first) < Rational(1e-9);
}

} // namespace

TEST(Feasibility, disks_apart_meet_and_touch)
{
  const auto disks = [](const Power_polynomial& c, Relation relation) {
    return decided(square, {{disk(0, 0), relation}, {disk(c, 0), relation}});
  };
  EXPECT_TRUE(disks(3, at_most).is_infeasible());
  EXPECT_TRUE(disks(3, less).is_infeasible());
  EXPECT_EQ(disks(3, at_most).excluded().size(), 1u);
  EXPECT_TRUE(disks(fraction(19, 10), at_most).has_point());
  EXPECT_TRUE(disks(fraction(19, 10), less).has_point());
  const SC::Feasibility_d touching = disks(2, at_most);
  ASSERT_TRUE(touching.has_point());
  EXPECT_EQ(touching.point(), (Point{Rational(1), Rational(0)}));
  EXPECT_TRUE(disks(2, less).is_infeasible());
  // the other way: outside of a disk and inside of a half-plane that touches it
  EXPECT_TRUE(is_feasible({{-1, 1}, {-1, 1}}, {{disk(0, 0), at_least}, {x - 1, at_least}}));
  EXPECT_FALSE(is_feasible({{-1, 1}, {-1, 1}}, {{x * x + y * y - 2, Relation::GREATER}}));
  EXPECT_TRUE(is_feasible({{-1, 1}, {-1, 1}}, {{x * x + y * y - 2, at_least}}));
}

// Three unit disks around the corners of a triangle with equal sides s and height h.
TEST(Feasibility, three_disks_meet_up_to_an_irrational_side)
{
  const Domain domain{{-3, 3}, {-3, 3}, {0, 3}, {0, 3}};
  const Power_polynomial s = variable(2), h = variable(3);
  const auto disks = [&](const Power_polynomial& square_of_side, Relation relation) {
    return decided(domain,
                   {{4 * h * h - 3 * s * s, equal},
                    {s * s - square_of_side, at_least},
                    {disk(0, 0), relation},
                    {disk(s, 0), relation},
                    {disk(fraction(1, 2) * s, h), relation}});
  };
  const Power_polynomial little = Power_polynomial(Rational(Rational(1) / Rational(1000000)));
  EXPECT_TRUE(disks(3 - little, at_most).is_feasible());
  EXPECT_TRUE(disks(3 + little, at_most).is_infeasible());
  EXPECT_TRUE(disks(3, less).is_infeasible());
  const SC::Feasibility_d touching = disks(3, at_most);
  ASSERT_TRUE(touching.is_feasible());
  EXPECT_TRUE(holds(touching.box(), 0, std::sqrt(0.75)));
  EXPECT_TRUE(holds(touching.box(), 1, 0.5));
  // In coordinates in which the sides are rational.
  const auto ellipse = [](const Power_polynomial& a, const Power_polynomial& b) {
    return 3 * (x - a) * (x - a) + (y - b) * (y - b) - 1;
  };
  Conditions ellipses{
      {ellipse(0, 0), at_most}, {ellipse(1, 0), at_most}, {ellipse(fraction(1, 2), fraction(3, 2)), at_most}};
  EXPECT_EQ(decided(square, ellipses).point(), Point(2, Rational(Rational(1) / Rational(2))));
  ellipses[1].second = less;
  EXPECT_FALSE(is_feasible(square, ellipses));
}

TEST(Feasibility, thin_annulus)
{
  const Power_polynomial radius = x * x + y * y,
                         width = Power_polynomial(Rational(Rational(1) / Rational(1000000) / Rational(1000000)));
  EXPECT_TRUE(is_feasible(square, {{radius - 1, at_least}, {radius - 1 - width, at_most}}));
  EXPECT_FALSE(is_feasible(square, {{radius - 1 - width, at_least}, {radius - 1, at_most}}));
  const SC::Feasibility_d circle = decided(square, {{radius - 2, at_least}, {radius - 2, at_most}});
  ASSERT_TRUE(circle.is_feasible()); // one unknown is chosen
  EXPECT_TRUE(circle.box()[0].first == circle.box()[0].second || circle.box()[1].first == circle.box()[1].second);
  EXPECT_FALSE(is_feasible(square, {{radius - 1, at_least}, {radius - 1, less}}));
  // an equality in two parts, the first of which alone violates the half-plane
  EXPECT_FALSE(is_feasible(square, {{3 * radius - 6, at_least}, {5 * radius - 10, at_most}, {x + y - 3, at_least}}));
  EXPECT_FALSE(is_feasible(square, {{10 - 5 * radius, at_least}, {6 - 3 * radius, at_most}, {x + y - 3, at_least}}));
}

TEST(Feasibility, equalities_fewer_than_unknowns)
{
  EXPECT_TRUE(is_feasible({{-1, 1}, {-1, 1}}, {{x * y, equal}}));
  EXPECT_TRUE(is_feasible({{-1, 1}, {-1, 1}}, {{x * y, equal}, {x + y - 1, at_least}}));
  EXPECT_FALSE(is_feasible({{-1, 1}, {-1, 1}}, {{x * y, equal}, {x + y - 1, Relation::GREATER}}));
  const SC::Feasibility_d point = decided(square, {{x * x + y * y, equal}});
  ASSERT_TRUE(point.has_point()); // where the gradient is zero
  EXPECT_EQ(point.point(), Point(2, Rational(0)));
  EXPECT_FALSE(is_feasible(square, {{x * x + y * y + fraction(1, 1000000), equal}}));
  const Domain five(5, {-2, 2});
  const Power_polynomial u = variable(3), v = variable(4);
  const Conditions spheres{{x * x + y * y + z * z - 2, equal}, {z * u + v - 1, equal}, {x + v - 1, at_least}};
  EXPECT_TRUE(is_feasible(five, spheres));
  Conditions none = spheres;
  none.emplace_back(u * u + v * v - fraction(1, 9), at_most); // z u + v < 1 there
  none.emplace_back(z * z - 1, at_most);
  EXPECT_FALSE(is_feasible(five, none));
}

// Touching points with coordinates that are not rational, and inequalities that are not convex.
TEST(Feasibility, critical_points_decide_touching_sets)
{
  const Power_polynomial double_roots = (x * x - 2) * (x * x - 2);
  const auto between = [&](Relation relation) {
    return decided({{-3, 3}, {-3, 3}}, {{double_roots - y, relation}, {double_roots + y, relation}});
  };
  const SC::Feasibility_d touching = between(at_most);
  ASSERT_TRUE(touching.is_feasible());
  EXPECT_TRUE(holds(touching.box(), 0, std::sqrt(2.)) || holds(touching.box(), 0, -std::sqrt(2.)));
  EXPECT_TRUE(between(less).is_infeasible());
}

// Functions that are nowhere negative: Motzkin's, which is no sum of squares and zero at (+-1, +-1), and one with
// irrational zeros.
TEST(Feasibility, least_values_that_are_zero)
{
  const Domain domain{{-3, 3}, {-3, 3}};
  const Power_polynomial motzkin = x * x * y * y * (x * x + y * y - 3) + 1;
  EXPECT_FALSE(is_feasible(domain, {{motzkin, less}}));
  const SC::Feasibility_d corner = decided(domain, {{motzkin, at_most}});
  ASSERT_TRUE(corner.has_point());
  EXPECT_EQ(corner.point()[0] * corner.point()[0], Rational(1));
  const Power_polynomial squares = (x * x - 2) * (x * x - 2) + (y * y * y - 2) * (y * y * y - 2);
  const SC::Feasibility_d zero = decided(domain, {{squares, at_most}});
  ASSERT_TRUE(zero.is_feasible());
  EXPECT_TRUE(holds(zero.box(), 1, std::cbrt(2.)));
  EXPECT_FALSE(is_feasible(domain, {{squares, less}}));
  EXPECT_FALSE(is_feasible(domain, {{squares + fraction(1, 1000000000), at_most}}));
}

TEST(Feasibility, inequations)
{
  const Domain domain{{-1, 1}, {-1, 1}};
  EXPECT_TRUE(is_feasible(domain, {{x, not_equal}, {y, not_equal}}));
  EXPECT_TRUE(is_feasible(domain, {{x * y, equal}, {x, not_equal}}));
  EXPECT_FALSE(is_feasible(domain, {{x * x + y * y, at_most}, {x, not_equal}}));
  EXPECT_FALSE(is_feasible(domain, {{x - x, not_equal}}));
  EXPECT_FALSE(is_feasible({{2, 2}, {-1, 1}}, {{x - 2, not_equal}})); // an unknown that is one number
  EXPECT_TRUE(is_feasible({{Rational(Rational(1) / Rational(3)), Rational(Rational(1) / Rational(3))}, {-1, 1}},
                          {{3 * x - 1, at_least}, {x - y, at_most}}));
}

TEST(Feasibility, splines_with_breaks)
{
  // 2, 0, 2, then 2, -1, 2 as control values over [0,1], [1,2]: at least 1 and 1/2
  const auto spline = SC::Spline_function::from_bezier_pieces(
      {0}, {{0, 1, 2}}, std::vector<SC::Bernstein_tensor<double>>{{{2}, {2., 0., 2.}}, {{2}, {2., -1., 2.}}});
  for (const auto& [bound, expected] : {std::pair(0.25, false), std::pair(0.5, true), std::pair(0.75, true)}) {
    SC::Constraint_system_d system = SC::Constraint_system_d::on_box({{0, 2}, {0, 1}});
    system.add(spline - SC::Spline_function(Power_polynomial(bound)), at_most);
    system.add(variable(1) - variable(0), at_most);
    const SC::Feasibility_d answer = SC::find_feasible_point(system);
    EXPECT_TRUE(answer.is_complete());
    EXPECT_EQ(answer.is_feasible(), expected) << bound;
    if (expected && bound == 0.5) {
      EXPECT_EQ(answer.box()[0].first, Rational(Rational(3) / Rational(2)));
    }
  }
}

TEST(Feasibility, formulas)
{
  const auto [a, b] = SC::unknowns({-2, 2}, {-2, 2});
  EXPECT_TRUE(SC::find_feasible_point(a * a + b * b <= 1, a + b > 1).is_feasible());
  EXPECT_TRUE(SC::find_feasible_point(a * a + b * b < 1, a + b >= 2).is_infeasible());
  EXPECT_TRUE(SC::find_feasible_point(1 / (a * a + 1) >= 2).is_infeasible());
  std::ostringstream out;
  out << SC::find_feasible_point(a * a + b * b < 1, a + b >= 2);
  EXPECT_TRUE(out.str().starts_with("feasibility: infeasible; complete: yes; nodes 1; seconds ")) << out.str();
}

TEST(Feasibility, planted_problems)
{
  using namespace planted_feasibility;
  int feasible = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    Generator generator(seed);
    const int kind = static_cast<int>(seed % 5), degree = generator.integer(2, 3);
    const int dimension = generator.integer(2, kind == 1 || kind == 3 ? 3 : 5);
    const int equalities = kind == 2 || kind == 3 ? generator.integer(1, dimension - 1) : 0;
    const int inequalities = generator.integer(kind == 1 ? 2 : 1, 5);
    const Problem problem = kind == 4 ? generator.touching_balls(dimension, seed % 2 == 0)
        : kind % 2 == 0               ? generator.with_solutions(dimension, inequalities, equalities, degree)
                                      : generator.without_solutions(dimension, inequalities, equalities, degree);
    const SC::Feasibility_d answer =
        SC::Feasibility_solver_d({.tolerance = 1e-6, .node_limit = 20000})(problem.domain, problem.conditions);
    ASSERT_TRUE(answer.is_complete()) << seed << ' ' << answer;
    ASSERT_EQ(answer.is_feasible(), problem.is_feasible) << seed;
    EXPECT_EQ(answer.is_feasible() ? error_of_solution(problem, answer) : error_of_proof(problem, answer, generator),
              "")
        << seed;
    feasible += answer.is_feasible();
  }
  EXPECT_EQ(feasible, 80 + 80 + 40);
}

// One box is enough for convex inequalities, in any number of unknowns.
TEST(Feasibility, balls_in_many_unknowns)
{
  for (const int n : {2, 5, 8, 12}) {
    // around the unit points: the least r with a common point of all balls is that of the centre, 1 - 1/n
    for (const int sign : {1, -1}) {
      Conditions balls;
      for (int k = 0; k < n; ++k) {
        Power_polynomial ball = fraction(1 - n, n) - sign * fraction(1, 1000);
        for (int j = 0; j < n; ++j)
          ball += (variable(j) - (j == k ? 1 : 0)) * (variable(j) - (j == k ? 1 : 0));
        balls.emplace_back(ball, at_most);
      }
      const SC::Feasibility_d answer = decided(Domain(n, {-4, 4}), balls);
      EXPECT_EQ(answer.is_feasible(), sign > 0) << n;
      EXPECT_EQ(answer.summary().nodes, 1u) << n;
    }
  }
}

TEST(Feasibility, steps_of_relaxation)
{
  using namespace SC::internal;
  const auto path = [](const std::vector<Power_polynomial>& functions, std::vector<double> point, double factor,
                       double offset, int steps) {
    Polynomial_family<double> family(functions, 2);
    const std::vector<Relation> relations(functions.size(), at_most);
    const Double_box box{{-9, -9}, {9, 9}};
    Relaxation relaxation(family, relations, factor, offset);
    std::vector<std::vector<double>> result{point};
    for (int k = 0; k < steps && relaxation.step(point, box); ++k)
      result.push_back(point);
    return result;
  };
  const auto radius = [](const std::vector<double>& point) { return std::hypot(point[0], point[1]); };
  // r <- (r^2 + 1) / (2 r), never inside
  const auto outside = path({disk(0, 0)}, {3, 4}, 1, 0, 5);
  ASSERT_EQ(outside.size(), 6u);
  double r = 5;
  for (const auto& point : outside) {
    EXPECT_NEAR(radius(point), r, 1e-12);
    EXPECT_GT(radius(point), 1);
    r = (r * r + 1) / (2 * r);
  }
  EXPECT_NEAR(radius(outside[1]), 2.6, 1e-12);
  EXPECT_LE(radius(path({disk(0, 0)}, {3, 4}, 1, 0.1, 9).back()), 1);
  // half-planes: a step to each; beyond them, as far, with the factor two
  EXPECT_EQ(path({1 - x, 1 - y}, {0, 0}, 1, 0, 9), (std::vector<std::vector<double>>{{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(path({1 - x, 1 - y}, {0, 0}, 2, 0, 9), (std::vector<std::vector<double>>{{0, 0}, {2, 0}, {2, 2}}));
}

TEST(Feasibility, limits)
{
  // far from convex, and without solutions
  Conditions hard;
  Power_polynomial sum = fraction(-1, 100);
  for (int j = 0; j < 6; ++j) {
    const Power_polynomial t = variable(j), next = variable((j + 1) % 6);
    sum += t * t * next * next - t * t * t * next * fraction(1, 3) - t * next * fraction(1, 7);
  }
  hard.emplace_back(sum * sum + fraction(1, 1000), at_most);
  hard.emplace_back(sum, at_least);
  const Domain domain(6, {-2, 2});
  const SC::Feasibility_d few = SC::Feasibility_solver_d({.tolerance = 1e-6, .node_limit = 5})(domain, hard);
  EXPECT_EQ(few.status(), SC::Feasibility::UNDECIDED);
  EXPECT_EQ(few.summary().why_not, SC::Undecided_reason::NODES);
  ASSERT_FALSE(few.undecided().empty());
  EXPECT_EQ(few.undecided()[0].reason, "node limit");
  EXPECT_EQ(few.undecided()[0].place.size(), 6u);
  const auto start = std::chrono::steady_clock::now();
  const SC::Feasibility_d soon = SC::Feasibility_solver_d({.tolerance = 1e-6, .time_limit = 0.05})(domain, hard);
  EXPECT_FALSE(soon.is_complete());
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 0.35);
  struct Stopping
  {
    int asked = 0;
    void on_progress(double) {}
    bool stop() { return ++asked > 3; }
  } visitor;
  SC::Constraint_system_d system(domain);
  for (const auto& [function, relation] : hard)
    system.add(function, relation);
  const SC::Feasibility_d stopped = SC::Feasibility_solver_d()(system, visitor);
  EXPECT_EQ(stopped.summary().why_not, SC::Undecided_reason::STOPPED);
}

TEST(Feasibility, bad_input)
{
  const auto message = [](const Domain& domain, const Conditions& conditions) {
    try {
      SC::Feasibility_solver_d()(domain, conditions);
    } catch (const SC::Invalid_input& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_EQ(message(square, {}), "Feasibility_solver_d: no constraint");
  EXPECT_EQ(message({{1, 0}}, {{x, at_most}}), "Constraint_system_d: the domain of unknown 0 is empty");
  EXPECT_EQ(message(square, {{z, at_most}}), "Feasibility_solver_d: unknown 2 of a constraint has no range");
  EXPECT_NE(message(square, {{x, equal}, {y, equal}}).find("for all solutions see solve()"), std::string::npos);
  EXPECT_THROW(SC::Feasibility_solver_d({.tolerance = -1}), SC::Invalid_input);
  const auto [a, b, c] = SC::unknowns({0, 1}, {0, 1}, {0, 1});
  try {
    SC::solve(a + b + c == 1);
    FAIL();
  } catch (const SC::Invalid_input& error) {
    EXPECT_NE(std::string(error.what()).find("find_feasible_point()"), std::string::npos);
  }
}

} // namespace feasibility_test
