// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Systems with elementary functions: equations whose solutions are known in closed form; planted solutions, which all
// are found, and as many others as change the sign of the function; postures of an arm against those that polynomials
// give; where functions are not defined; roots on faces, multiple ones, inequalities; limits and bad input.

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/function/expression_bounds.h>
#include <CGAL/Spline_constraints_d/function/expression_derivative.h>
#include <CGAL/Spline_constraints_d/function/linear_elimination.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_number.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Propagation_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#include "solver_test_checks.h"

#include <gtest/gtest.h>

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

namespace elementary_functions_test {

namespace SC = CGAL::Spline_constraints;
using namespace solver_test;
using SC::Elementary_function;
using SC::Elementary_values;
using SC::Power_polynomial;
using SC::Relation;
using SC::Undecided_reason;
using Constraints = std::vector<std::pair<Power_polynomial, Relation>>;
using Domain = std::vector<SC::Constraint_system_d::Domain>;
using Solutions = SC::Solution_set_d<double>;

namespace {

Power_polynomial unknown(int index) { return Power_polynomial::variable(index); }

Solutions solve(const Domain& domain, const Constraints& constraints, const Elementary_values& values)
{
  Solutions result = SC::Propagation_solver_d()(domain, constraints, values);
  expect_consistent_regions(result);
  return result;
}

// All solutions of an equation in one unknown, which are regular.
void expect_roots(const std::function<Power_polynomial(Elementary_values&)>& make, int lower, int upper,
                  const std::vector<double>& roots)
{
  Elementary_values values;
  const Power_polynomial function = make(values);
  const Solutions solutions = solve({{lower, upper}}, {{function, Relation::EQUAL}}, values);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  ASSERT_EQ(solutions.count(Solution_kind::CERTIFIED), roots.size());
  EXPECT_EQ(solutions.size(), roots.size());
  for (std::size_t k = 0; k < roots.size(); ++k) {
    EXPECT_LE(solutions[k][0].first, roots[k] + 1e-13 * std::abs(roots[k]));
    EXPECT_GE(solutions[k][0].second, roots[k] - 1e-13 * std::abs(roots[k]));
    EXPECT_LT(solutions[k][0].second - solutions[k][0].first, 1e-12);
    EXPECT_TRUE(SC::verify({{lower, upper}}, {{function, Relation::EQUAL}}, values, solutions[k])) << roots[k];
  }
}

} // namespace

TEST(Elementary_functions, known_roots)
{
  constexpr double pi = std::numbers::pi;
  const Power_polynomial x = unknown(0);
  const Rational half(1, 2);
  expect_roots([&](auto& v) -> Power_polynomial { return v.sin(x) - half; }, 0, 20,
               {pi / 6, 5 * pi / 6, 13 * pi / 6, 17 * pi / 6, 25 * pi / 6, 29 * pi / 6, 37 * pi / 6});
  expect_roots([&](auto& v) -> Power_polynomial { return v.cos(3 * x + 1) + half; }, 0, 3,
               {(2 * pi / 3 - 1) / 3, (4 * pi / 3 - 1) / 3, (8 * pi / 3 - 1) / 3});
  expect_roots([&](auto& v) -> Power_polynomial { return v.tan(x) - 1; }, -4, 4, {-3 * pi / 4, pi / 4, 5 * pi / 4});
  expect_roots([&](auto& v) -> Power_polynomial { return v.exp(x) - x - 2; }, -10, 10,
               {-1.8414056604369606, 1.1461932206205825});
  expect_roots([&](auto& v) -> Power_polynomial { return v.cos(x) - x; }, -100, 100, {0.7390851332151607});
  expect_roots([&](auto& v) -> Power_polynomial { return v.exp(x * v.log(x)) - 2; }, 0, 10, {1.5596104694623694});
  expect_roots([&](auto& v) -> Power_polynomial { return v.log(x) - 3; }, -5, 100, {std::exp(3.0)});
  expect_roots([&](auto& v) -> Power_polynomial { return v.sqrt(x + 1) - x; }, -10, 10, {std::numbers::phi});
  expect_roots([&](auto& v) -> Power_polynomial { return v.atan(x) - 1; }, -100, 100, {std::tan(1.0)});
  expect_roots([&](auto& v) -> Power_polynomial { return v.power(x, Rational(1, 3)) - 2; }, -10, 10, {8.0});
  expect_roots([&](auto& v) -> Power_polynomial { return v.power(x, Rational(-3, 2)) - 8; }, -10, 10, {0.25});
  expect_roots([&](auto& v) -> Power_polynomial { return v.reciprocal(x) + x - 3; }, -10, 10,
               {(3 - std::sqrt(5.0)) / 2, (3 + std::sqrt(5.0)) / 2});
  expect_roots([&](auto& v) -> Power_polynomial { return v.value(Elementary_function::HYPERBOLIC_COSINE, x) - 2; }, -10,
               10, {-std::acosh(2.0), std::acosh(2.0)});
  expect_roots([&](auto& v) -> Power_polynomial { return v.value(Elementary_function::HYPERBOLIC_SINE, x) - 2; }, -10,
               10, {std::asinh(2.0)});
  expect_roots([&](auto& v) -> Power_polynomial { return v.value(Elementary_function::HYPERBOLIC_TANGENT, x) - half; },
               -10, 10, {std::atanh(0.5)});
  expect_roots([&](auto& v) -> Power_polynomial { return v.value(Elementary_function::ABSOLUTE_VALUE, x - 1) - half; },
               -10, 10, {0.5, 1.5});
  expect_roots([&](auto& v) -> Power_polynomial { return v.value(Elementary_function::ARC_SINE, x) - half; }, -10, 10,
               {std::sin(0.5)});
  expect_roots([&](auto& v) -> Power_polynomial { return v.value(Elementary_function::ARC_COSINE, x) - 3; }, -10, 10,
               {std::cos(3.0)});
  expect_roots(
      [&](auto& v) -> Power_polynomial { return v.sin(v.pi() * x) - v.sqrt(Power_polynomial(Rational(3, 4))); }, 0, 2,
      {1.0 / 3, 2.0 / 3});
  expect_roots([&](auto& v) -> Power_polynomial { return v.exp(v.sin(x)) - v.exp(Power_polynomial(half)); }, 0, 4,
               {pi / 6, 5 * pi / 6});
}

namespace {

// A function for the test, and how doubles have it.
struct Tested_function
{
  Elementary_function function;
  double (*value)(double);
};

const std::vector<Tested_function>& functions()
{
  static const std::vector<Tested_function> result{
      {Elementary_function::EXPONENTIAL, [](double x) { return std::exp(x); }},
      {Elementary_function::SINE, [](double x) { return std::sin(x); }},
      {Elementary_function::COSINE, [](double x) { return std::cos(x); }},
      {Elementary_function::ARC_TANGENT, [](double x) { return std::atan(x); }},
      {Elementary_function::HYPERBOLIC_SINE, [](double x) { return std::sinh(x); }},
      {Elementary_function::HYPERBOLIC_COSINE, [](double x) { return std::cosh(x); }},
      {Elementary_function::HYPERBOLIC_TANGENT, [](double x) { return std::tanh(x); }},
      {Elementary_function::ABSOLUTE_VALUE, [](double x) { return std::abs(x); }}};
  return result;
}

// Sums of functions of linear forms and of products of two, less their values at a rational point.
class Planted_equation
{
  Power_polynomial m_function;
  std::vector<std::function<double(const std::vector<double>&)>> m_terms;
  double m_constant = 0;

public:
  Planted_equation(std::mt19937_64& random, const std::vector<Rational>& point, Elementary_values& values)
  {
    const auto integer = [&](int lower, int upper) { return std::uniform_int_distribution<int>(lower, upper)(random); };
    const int n = static_cast<int>(point.size());
    for (int term = 0; term < 3; ++term) {
      Power_polynomial product(1), at_point(1);
      std::vector<std::function<double(const std::vector<double>&)>> factors;
      for (int factor = 0; factor < integer(1, 2); ++factor) {
        const Tested_function f = functions()[integer(0, static_cast<int>(functions().size()) - 1)];
        const int j = integer(0, n - 1), k = integer(0, n - 1), a = integer(1, 3), b = integer(-2, 2);
        const bool has_product = integer(0, 3) == 0;
        const Power_polynomial argument =
            a * unknown(j) + b * (has_product ? unknown(j) * unknown(k) / 4 : unknown(k)) / 2;
        product *= values.value(f.function, argument);
        at_point *= values.value(f.function, Power_polynomial(argument(point)));
        factors.push_back([=](const std::vector<double>& x) {
          return f.value(a * x[j] + b * (has_product ? x[j] * x[k] / 4 : x[k]) / 2);
        });
      }
      const int weight = integer(1, 4) * (integer(0, 1) == 0 ? 1 : -1);
      m_function += weight * (product - at_point);
      m_terms.push_back([=](const std::vector<double>& x) {
        double result = weight;
        for (const auto& factor : factors)
          result *= factor(x);
        return result;
      });
    }
    std::vector<double> root;
    for (const Rational& coordinate : point)
      root.push_back(CGAL::to_double(coordinate));
    m_constant = (*this)(root);
  }

  const Power_polynomial& function() const { return m_function; }

  double operator()(const std::vector<double>& x) const
  {
    double result = -m_constant;
    for (const auto& term : m_terms)
      result += term(x);
    return result;
  }
};

std::vector<Rational> random_point(std::mt19937_64& random, int dimension)
{
  std::vector<Rational> result;
  for (int j = 0; j < dimension; ++j)
    result.emplace_back(std::uniform_int_distribution<int>(-190, 190)(random), 100);
  return result;
}

std::size_t holders(const Solutions& solutions, const std::vector<Rational>& point)
{
  std::size_t result = 0;
  for (const auto& solution : solutions) {
    bool is_inside = true;
    for (std::size_t j = 0; j < point.size(); ++j)
      is_inside = is_inside && Rational(solution[j].first) <= point[j] && point[j] <= Rational(solution[j].second);
    result += is_inside;
  }
  return result;
}

} // namespace

// Between two points of a fine grid where the function has different signs there is an answer, and the function has
// different signs at the ends of certified answers, or is as good as zero.
TEST(Elementary_functions, planted_roots_of_one_equation)
{
  std::mt19937_64 random(20261201);
  std::size_t certified = 0, changes = 0;
  for (int k = 0; k < 120; ++k) {
    SCOPED_TRACE(k);
    Elementary_values values;
    const std::vector<Rational> root = random_point(random, 1);
    const Planted_equation equation(random, root, values);
    if (equation.function().is_zero())
      continue;
    const Solutions solutions = solve({{-2, 2}}, {{equation.function(), Relation::EQUAL}}, values);
    EXPECT_GE(holders(solutions, root), 1u);
    constexpr int steps = 2000;
    for (int i = 0; i < steps; ++i) {
      const double lower = -2 + 4.0 * i / steps, upper = -2 + 4.0 * (i + 1) / steps;
      if (equation({lower}) * equation({upper}) >= 0)
        continue;
      ++changes;
      bool is_found = false;
      for (const auto& solution : solutions)
        is_found = is_found || (solution[0].second >= lower && solution[0].first <= upper);
      EXPECT_TRUE(is_found) << lower;
    }
    for (const auto& solution : solutions)
      if (solution.is_certified()) {
        ++certified;
        const double below = equation({solution[0].first - 1e-7}), above = equation({solution[0].second + 1e-7});
        EXPECT_TRUE(below * above < 0 || std::abs(below) < 1e-10) << below << ' ' << above;
      }
  }
  EXPECT_GT(certified, 150u);
  EXPECT_GT(changes, 150u);
}

TEST(Elementary_functions, planted_roots_of_systems)
{
  std::mt19937_64 random(20261202);
  std::size_t certified = 0, complete = 0;
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    const int n = 2 + k % 2;
    Elementary_values values;
    const std::vector<Rational> root = random_point(random, n);
    std::vector<Planted_equation> equations;
    Constraints constraints;
    for (int i = 0; i < n; ++i) {
      equations.emplace_back(random, root, values);
      constraints.emplace_back(equations.back().function(), Relation::EQUAL);
    }
    const SC::Solver_options options{.node_limit = 2000};
    const Domain domain(n, {-2, 2});
    const Solutions solutions = SC::Propagation_solver_d(options)(domain, constraints, values);
    EXPECT_GE(holders(solutions, root), 1u);
    complete += solutions.is_complete();
    for (const auto& solution : solutions)
      if (solution.is_certified()) {
        ++certified;
        for (const Planted_equation& equation : equations)
          EXPECT_LT(std::abs(equation(solution.point())), 1e-8);
        EXPECT_TRUE(SC::verify(domain, constraints, values, solution));
      }
  }
  EXPECT_GT(complete, 40u);
  EXPECT_GT(certified, 80u);
}

// Where the tip of an arm of two links is to be. The same with cosines and sines as unknowns.
TEST(Elementary_functions, postures_of_an_arm)
{
  const Rational x(17, 10), y(6, 10);
  Elementary_values values;
  const Power_polynomial a = unknown(0), b = unknown(1);
  const Solutions angles = solve({{-3, 3}, {-3, 3}},
                                 {{2 * values.cos(a) + values.cos(a + b) - x, Relation::EQUAL},
                                  {2 * values.sin(a) + values.sin(a + b) - y, Relation::EQUAL}},
                                 values);
  ASSERT_TRUE(angles.is_complete());
  const Power_polynomial c = unknown(0), s = unknown(1), d = unknown(2), t = unknown(3);
  const Solutions cosines = SC::solve_polynomials(Domain(4, {-1, 1}),
                                                  {{2 * c + d - x, Relation::EQUAL},
                                                   {2 * s + t - y, Relation::EQUAL},
                                                   {c * c + s * s - 1, Relation::EQUAL},
                                                   {d * d + t * t - 1, Relation::EQUAL}});
  ASSERT_TRUE(cosines.is_complete());
  EXPECT_EQ(angles.count(Solution_kind::CERTIFIED), 2u);
  ASSERT_EQ(cosines.count(Solution_kind::CERTIFIED), 2u);
  for (const auto& angle : angles) {
    std::size_t same = 0;
    for (const auto& other : cosines)
      same += std::abs(std::atan2(other.point()[1], other.point()[0]) - angle.point()[0]) < 1e-12;
    EXPECT_EQ(same, 1u);
  }
}

// h e^x in the middle of second differences (Bratu): two solutions; a hundred unknowns and as many functions.
TEST(Elementary_functions, many_unknowns)
{
  for (const int n : {10, 70}) {
    Elementary_values values;
    Constraints constraints;
    for (int i = 0; i < n; ++i) {
      Power_polynomial f = values.exp(unknown(i)) / Rational((n + 1) * (n + 1)) - 2 * unknown(i);
      if (i > 0)
        f += unknown(i - 1);
      if (i + 1 < n)
        f += unknown(i + 1);
      constraints.emplace_back(f, Relation::EQUAL);
    }
    const Solutions solutions = solve(Domain(n, {-100000000, 20}), constraints, values);
    EXPECT_TRUE(solutions.is_complete());
    EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 2u);
  }
}

TEST(Elementary_functions, nothing_where_they_are_not_defined)
{
  const Power_polynomial x = unknown(0);
  expect_roots([&](auto& v) -> Power_polynomial { return v.log(x) - v.log(-x); }, -5, 5, {});
  expect_roots([&](auto& v) -> Power_polynomial { return v.sqrt(x - 1) * x; }, -5, 0, {});
  expect_roots([&](auto& v) -> Power_polynomial { return v.value(Elementary_function::ARC_SINE, x) + 3 - x; }, -5, 5,
               {});
  expect_roots([&](auto& v) -> Power_polynomial { return v.log(v.sin(Power_polynomial(4))) + x; }, -5, 5, {});
  // a factor that is cancelled is still required
  Elementary_values values;
  const Power_polynomial logarithm = values.log(x);
  const Solutions solutions = solve({{-5, 5}}, {{x * x - 4 + logarithm - logarithm, Relation::EQUAL}}, values);
  EXPECT_TRUE(solutions.is_complete());
  ASSERT_EQ(solutions.size(), 1u);
  EXPECT_NEAR(solutions[0].point()[0], 2, 1e-12);
}

// Rational roots on faces and multiple ones are decided, others are left with their boxes and reasons.
TEST(Elementary_functions, roots_that_need_exact_signs)
{
  const Power_polynomial x = unknown(0), y = unknown(1);
  expect_roots([&](auto& v) -> Power_polynomial { return v.sin(x); }, 0, 4, {0.0, std::numbers::pi});
  expect_roots([&](auto& v) -> Power_polynomial { return v.exp(x) - 1; }, 0, 1, {0.0});

  Elementary_values w;
  const Solutions doubled = solve({{-1, 2}}, {{w.exp(x) - 1 - x, Relation::EQUAL}}, w);
  EXPECT_TRUE(doubled.is_complete());
  ASSERT_EQ(doubled.size(), 1u);
  EXPECT_EQ(doubled[0].kind(), Solution_kind::CLUSTER);
  EXPECT_LE(doubled[0][0].first, 0);
  EXPECT_GE(doubled[0][0].second, 0);
  EXPECT_LT(doubled[0][0].second - doubled[0][0].first, 1e-6);
  EXPECT_TRUE(SC::verify({{-1, 2}}, {{w.exp(x) - 1 - x, Relation::EQUAL}}, w, doubled[0]));

  Elementary_values s;
  const Solutions irrational = solve({{1, 5}}, {{s.sin(x) - 1, Relation::EQUAL}}, s);
  EXPECT_FALSE(irrational.is_complete());
  ASSERT_EQ(irrational.size(), 1u);
  EXPECT_EQ(irrational[0].reason(), Undecided_reason::TOLERANCE);
  EXPECT_NEAR(irrational[0].point()[0], std::numbers::pi / 2, 1e-6);
  EXPECT_FALSE(SC::verify({{1, 5}}, {{s.sin(x) - 1, Relation::EQUAL}}, s, irrational[0]));

  for (const Relation relation : {Relation::LESS_EQUAL, Relation::GREATER, Relation::NOT_EQUAL}) {
    Elementary_values e;
    const Solutions on_boundary = solve({{-5, 5}}, {{e.exp(x) - 2, Relation::EQUAL}, {e.exp(2 * x) - 4, relation}}, e);
    ASSERT_EQ(on_boundary.size(), 1u);
    EXPECT_EQ(on_boundary[0].reason(), Undecided_reason::INEQUALITY);
  }
  for (const bool is_less : {true, false}) {
    Elementary_values e;
    const Solutions decided = solve({{-5, 5}, {-5, 5}},
                                    {{e.exp(x) - 2, Relation::EQUAL},
                                     {y - x, Relation::EQUAL},
                                     {e.exp(y) - 3, is_less ? Relation::LESS : Relation::GREATER}},
                                    e);
    EXPECT_TRUE(decided.is_complete());
    EXPECT_EQ(decided.count(Solution_kind::CERTIFIED), is_less ? 1u : 0u);
  }
}

// Regular roots on boundaries are decided where coordinates, or sines and cosines together, are rational there, and
// where more bits tell on which side they are.
TEST(Elementary_functions, roots_on_boundaries)
{
  const auto [x, y] = SC::unknowns({-1, 7}, {0, 1});
  const std::vector<SC::Constraint> on_faces{cos(x) == y, sin(x) == 1 - y};
  const Solutions solutions = SC::solve(on_faces);
  EXPECT_TRUE(solutions.is_complete());
  ASSERT_EQ(solutions.count(Solution_kind::CERTIFIED), 3u); // 0, pi/2, 2 pi
  for (const auto& solution : solutions)
    EXPECT_TRUE(SC::verify(on_faces, solution));
  EXPECT_NEAR(solutions[1].point()[0], std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(solutions[1][1].first, 0);
  EXPECT_EQ(solutions[1][1].second, 0);

  // the double beside 2 pi is below it
  for (const bool is_above : {false, true}) {
    const double end = is_above ? std::nextafter(2 * std::numbers::pi, 7) : 2 * std::numbers::pi;
    const auto [u] = SC::unknowns({-1, end});
    const Solutions zeros = SC::solve(sin(u) == 0);
    EXPECT_TRUE(zeros.is_complete());
    EXPECT_EQ(zeros.size(), is_above ? 3u : 2u);
  }

  // ends of domains that are log(q), rounded down and up to 150 bits
  std::mt19937_64 random(20261204);
  for (int k = 0; k < 20; ++k) {
    const Rational q(std::uniform_int_distribution<int>(2, 99)(random), 100 + k);
    SC::internal::Mpfr_number number(200), logarithm(150);
    SC::internal::set_from_rational(number.get(), q, MPFR_RNDN);
    for (const bool is_above : {false, true}) {
      mpfr_log(logarithm.get(), number.get(), is_above ? MPFR_RNDU : MPFR_RNDD);
      const auto [v] = SC::unknowns({-7, SC::internal::rational_of_mpfr<Rational>(logarithm.get())});
      const Solutions at_end = SC::solve(exp(v) == q);
      EXPECT_TRUE(at_end.is_complete());
      EXPECT_EQ(at_end.count(Solution_kind::CERTIFIED), is_above ? 1u : 0u) << q;
    }
  }

  const auto [a, b] = SC::unknowns({0, 2}, {0, 2});
  const Rational three(3, 5), four(4, 5);
  const Solutions both = SC::solve(sin(a + b) == three, b == a, cos(a + b) <= four, sin(2 * a) >= three);
  EXPECT_TRUE(both.is_complete());
  EXPECT_EQ(both.count(Solution_kind::CERTIFIED), 2u);
  const Solutions the_other = SC::solve(sin(a + b) == three, b == a, cos(a + b) < four);
  EXPECT_TRUE(the_other.is_complete());
  ASSERT_EQ(the_other.count(Solution_kind::CERTIFIED), 1u);
  EXPECT_NEAR(the_other[0].point()[0], (std::numbers::pi - std::asin(0.6)) / 2, 1e-12);
  // a number in the way that cancels
  const SC::Expression e = exp(SC::Expression(1));
  const Solutions at_one = SC::solve(exp(a) == e, b * b == exp(a) / e + 1, a <= 1);
  EXPECT_TRUE(at_one.is_complete());
  ASSERT_EQ(at_one.count(Solution_kind::CERTIFIED), 1u);
  EXPECT_NEAR(at_one[0].point()[1], std::sqrt(2.0), 1e-12);
  // one that is not found to be rational
  const Solutions open = SC::solve(exp(a) == 2, b == 1, exp(2 * a) <= 4);
  ASSERT_EQ(open.size(), 1u);
  EXPECT_EQ(open[0].reason(), Undecided_reason::INEQUALITY);
}

// Where powers of values are no doubles any more.
TEST(Elementary_functions, huge_values)
{
  const Power_polynomial x = unknown(0);
  const double log_2 = std::log(2.0);
  expect_roots([&](auto& v) -> Power_polynomial { return pow(v.exp(x), 3) - 8; }, -500, 500, {log_2});
  expect_roots([&](auto& v) -> Power_polynomial { return v.exp(200 * x) - v.exp(Power_polynomial(300)); }, -9, 9,
               {1.5});
  expect_roots([&](auto& v) -> Power_polynomial { return pow(v.reciprocal(x), 5) - 32; }, -1, 1, {0.5});
}

TEST(Elementary_functions, limits_and_bad_input)
{
  const Power_polynomial x = unknown(0);
  Elementary_values v;
  const Constraints constraints{{v.sin(50 * x) - x / 10, Relation::EQUAL}};
  const Solutions limited = SC::Propagation_solver_d({.node_limit = 5})({{-9, 9}}, constraints, v);
  EXPECT_FALSE(limited.is_complete());
  EXPECT_EQ(limited.summary().why_not, Undecided_reason::NODES);

  const SC::Propagation_solver_d solver;
  EXPECT_THROW(solver({{-9, 9}}, constraints, Elementary_values()), SC::Invalid_input);
  EXPECT_THROW(solver({{-9, 9}}, constraints), SC::Invalid_input);
  EXPECT_THROW(solver({{-9, 9}, {0, 1}}, constraints, v), SC::Invalid_input);
  EXPECT_THROW(SC::solve_polynomials({{-9, 9}}, constraints), SC::Invalid_input);
  Elementary_values other;
  const Constraints of_other{{other.sin(unknown(1)) - x, Relation::EQUAL}};
  EXPECT_THROW(solver({{-9, 9}}, of_other, other), SC::Invalid_input);

  EXPECT_THROW(v.value(Elementary_function::POWER, x), SC::Invalid_input);
  EXPECT_THROW(v.reciprocal(Power_polynomial()), SC::Invalid_input);
  EXPECT_THROW(v.log(Power_polynomial(-1)), SC::Invalid_input);
  EXPECT_THROW(v.sqrt(Power_polynomial(-1)), SC::Invalid_input);
  EXPECT_THROW(v.power(Power_polynomial(0), Rational(-1, 3)), SC::Invalid_input);
  EXPECT_THROW(v.power(x, Rational(1000000000)), SC::Invalid_input);
  const std::vector<std::string> no_names;
  EXPECT_THROW(v.text(x, no_names), SC::Invalid_input);
}

// What verify() refuses: answers of other systems, boxes beside the root, other domains and inequalities.
TEST(Elementary_functions, wrong_answers_are_not_verified)
{
  const Power_polynomial x = unknown(0);
  Elementary_values v;
  const Constraints constraints{{v.exp(x) - 2, Relation::EQUAL}};
  const Solutions solutions = solve({{-5, 5}}, constraints, v);
  ASSERT_EQ(solutions.size(), 1u);
  EXPECT_TRUE(SC::verify({{-5, 5}}, constraints, v, solutions[0]));
  EXPECT_FALSE(SC::verify({{1, 5}}, constraints, v, solutions[0]));
  EXPECT_FALSE(SC::verify({{-5, 5}, {0, 1}}, constraints, v, solutions[0]));
  EXPECT_FALSE(SC::verify({{-5, 5}}, {{v.exp(x) - 3, Relation::EQUAL}}, v, solutions[0]));
  for (const bool is_less : {true, false}) {
    const Constraints with_inequality{constraints[0], {x - 1, is_less ? Relation::LESS : Relation::GREATER}};
    EXPECT_EQ(SC::verify({{-5, 5}}, with_inequality, v, solutions[0]), is_less);
  }
  const auto answer = [](double lower, double upper) {
    return SC::Solution_d<double>(Solution_kind::CERTIFIED, {{lower, upper}}, {{lower, upper}}, "made by hand",
                                  Undecided_reason::NONE, 1);
  };
  EXPECT_TRUE(SC::verify({{-5, 5}}, constraints, v, answer(0.5, 0.75)));
  EXPECT_FALSE(SC::verify({{-5, 5}}, constraints, v, answer(0.5, std::nextafter(std::log(2.0), 0))));
  EXPECT_FALSE(SC::verify({{-5, 5}}, constraints, v, answer(0.75, 1)));
  // of two roots, a box with both, and with one on its end
  const Constraints waves{{v.sin(x), Relation::EQUAL}};
  EXPECT_FALSE(SC::verify({{-5, 5}}, waves, v, answer(-0.5, 3.5)));
  EXPECT_TRUE(SC::verify({{-5, 5}}, waves, v, answer(0, 0.25)));
}

namespace {

void expect_points(const Solutions& solutions, const std::vector<SC::Constraint>& constraints,
                   const std::vector<std::vector<double>>& points)
{
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  ASSERT_EQ(solutions.count(Solution_kind::CERTIFIED), points.size());
  EXPECT_EQ(solutions.size(), points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    for (std::size_t j = 0; j < points[k].size(); ++j)
      EXPECT_NEAR(solutions[k].point()[j], points[k][j], 1e-12) << k;
    EXPECT_TRUE(SC::verify(constraints, solutions[k])) << k;
  }
}

void expect_points(const std::vector<SC::Constraint>& constraints, const std::vector<std::vector<double>>& points)
{
  expect_points(SC::solve(constraints), constraints, points);
}

} // namespace

TEST(Functions_in_formulas, known_points)
{
  constexpr double pi = std::numbers::pi;
  const auto [x, y] = SC::unknowns({-4, 4}, {-4, 4});
  const Rational half(1, 2);
  const double log_2 = std::log(2.0);
  const std::vector<std::vector<double>> sines{{-7 * pi / 6, log_2}, {pi / 6, log_2}, {5 * pi / 6, log_2}};
  expect_points({sin(x) == half, exp(y) == 2}, sines);
  expect_points({x * exp(x) == 1, y == log(x)}, {{0.5671432904097838, -0.5671432904097838}}); // W(1)
  expect_points({x - sin(x) / 2 == 1, y == tan(x / 2)},
                {{1.4987011335178483, std::tan(1.4987011335178483 / 2)}}); // Kepler
  expect_points({atan(x / y) == SC::Expression::pi() / 4, x + y == 3}, {{1.5, 1.5}});
  expect_points({sqrt(x + y) == 2, sqrt(x - y) == 1}, {{2.5, 1.5}});
  expect_points({pow(x, 1.5) == 8, abs(y) == 2, y < x - 3}, {{4, -2}});
  expect_points({pow(x, Rational(1, 3)) == y, pow(y, -2) == 1, cosh(x) > 1}, {{1, 1}});
  expect_points({asin(x) == acos(y), x == y}, {{std::sqrt(0.5), std::sqrt(0.5)}});
  expect_points({sinh(x) == 1, tanh(y) == half}, {{std::asinh(1.0), std::atanh(0.5)}});
  // numbers before and after unknowns
  expect_points({sqrt(SC::Expression(2)) * x == exp(SC::Expression(1)), y / log(SC::Expression(2)) == cos(x)},
                {{std::exp(1.0) / std::sqrt(2.0), std::log(2.0) * std::cos(std::exp(1.0) / std::sqrt(2.0))}});
  const Solutions of_pack = solve(sin(x) == half, exp(y) == 2);
  expect_points(of_pack, {sin(x) == half, exp(y) == 2}, sines);
}

// Where a value or a quotient is not defined is no solution, whatever is multiplied out; what cancels is not asked for.
TEST(Functions_in_formulas, where_they_are_defined)
{
  const auto [x] = SC::unknowns({-4, 4});
  expect_points({x * log(x + 1) / log(x + 1) == 0}, {{0}});
  expect_points({(x * x - 1) / log(x) == 0}, {});
  expect_points({(x * x - 4) / log(x) == 0}, {{2}});
  expect_points({(x * x - 4) / exp(log(x)) == 0}, {{2}});
  expect_points({(x * x - 4) * exp(sqrt(x)) == 0}, {{2}});
  expect_points({sin(1 / x) * (x * x - 9) == sin(1 / x) * 0 + x * x - 9, x > 2}, {{3}});
  expect_points({x * x == 4, 1 / sin(x) < 0}, {{-2}});
  expect_points({x * x == 4, 1 / exp(x) < 1}, {{2}});
}

// Among the templates of these names that CGAL has, and the functions of <cmath>.
TEST(Functions_in_formulas, are_found_beside_others)
{
  using namespace CGAL;
  using namespace std;
  const auto [x] = SC::unknowns({1, 4});
  EXPECT_EQ((sqrt(x) + abs(x) + square(x) + sqrt(1 + square(x + 3)) * 0)(std::vector<Rational>{4}), 22);
  EXPECT_EQ(sqrt(4.0) + abs(-1.0) + square(3.0), 12);
  EXPECT_EQ(pow(x, 2)(std::vector<Rational>{4}), pow(x, 2.0)(std::vector<Rational>{4}));
  EXPECT_EQ(pow(x, -0.5)(std::vector<Rational>{4}), Rational(1, 2));
}

TEST(Functions_in_formulas, exact_values_and_derivatives)
{
  const auto [x, y] = SC::unknowns({-4, 4}, {-4, 4});
  const std::vector<Rational> zero{0, 0}, point{Rational(9, 4), 1};
  const SC::Expression f = exp(x) * cos(y) + sqrt(x + 4) - abs(y - 3);
  EXPECT_EQ(f(zero), 0);
  EXPECT_EQ((sqrt(x) + log(y))(point), Rational(3, 2));
  EXPECT_THROW(f(point), SC::Invalid_input);
  EXPECT_THROW(log(x)(zero), SC::Invalid_input);
  EXPECT_EQ(exp(SC::Expression(0))({}), 1);
  EXPECT_EQ(sqrt(SC::Expression(Rational(9, 4)))({}), Rational(3, 2));
  EXPECT_FALSE(f.is_polynomial());
  EXPECT_TRUE((f - f + x).is_polynomial());
  EXPECT_EQ(SC::Expression::pi().domains(), nullptr);
  EXPECT_EQ((SC::Expression::pi() * x).domains(), x.domains());

  const auto is_zero = [](const SC::Expression& e) { return e.numerator().is_zero(); };
  EXPECT_TRUE(is_zero(derivative(sin(x * y), x) - y * cos(x * y)));
  EXPECT_TRUE(is_zero(derivative(log(x), x) * x - 1));
  EXPECT_TRUE(is_zero(derivative(exp(sin(x)), x) - cos(x) * exp(sin(x))));
  EXPECT_TRUE(is_zero(derivative(pow(x, 2.5), x) - Rational(5, 2) * pow(x, 1.5)));
  EXPECT_TRUE(is_zero(derivative(atan(x), x) - 1 / (1 + x * x)));
  EXPECT_TRUE(is_zero(derivative(SC::Expression::pi(), x)));
  EXPECT_TRUE(is_zero(derivative(sin(y), x)));

  std::ostringstream text;
  text << (sin(x * y) + 2 * exp(-x) / pow(y, Rational(1, 3)) == 1);
  EXPECT_EQ(text.str(), "sin(x0*x1)*((x1)^(1/3)) - ((x1)^(1/3)) + 2*exp(-x0) = 0, ((x1)^(1/3)) != 0");

  // against differences, of all functions
  const std::vector<SC::Expression> all{exp(x),    log(x),  sqrt(x), sin(x),  cos(x),  tan(x), asin(x),
                                        acos(x),   atan(x), sinh(x), cosh(x), tanh(x), abs(x), pow(x, Rational(1, 3)),
                                        1 / sin(x)};
  for (const SC::Expression& g : all) {
    // values and derivatives as solutions of equations
    SCOPED_TRACE(testing::PrintToString(&g - all.data()));
    const auto value_at = [&](const SC::Expression& e, double place) {
      const auto solutions = SC::solve(std::vector<SC::Constraint>{x == place, y == e});
      return solutions.size() == 1 ? solutions[0].point()[1] : std::nan("");
    };
    const double h = 0x1p-12, middle = value_at(derivative(g, x), 0.5);
    EXPECT_NEAR((value_at(g, 0.5 + h) - value_at(g, 0.5 - h)) / (2 * h), middle, 1e-5);
  }
}

TEST(Functions_in_formulas, bad_input)
{
  const auto [x, y] = SC::unknowns({-4, 4}, {-4, 4});
  const auto [other] = SC::unknowns({-4, 4});
  const auto message = [](const auto& call) {
    try {
      call();
    } catch (const SC::Invalid_input& error) {
      return std::string(error.what());
    }
    return std::string("no exception");
  };
  const auto has = [](const std::string& text, const std::string& part) { return text.find(part) != text.npos; };
  EXPECT_TRUE(has(message([] { log(SC::Expression(-1)); }), "the function ln is not defined for -1"));
  EXPECT_TRUE(has(message([] { sqrt(SC::Expression(-1)); }), "sqrt"));
  EXPECT_TRUE(has(message([&] { pow(x, Rational(1000000000)); }), "exponent"));
  EXPECT_TRUE(has(message([&] { sin(x) + other; }), "different calls"));
  EXPECT_THROW(SC::Expression::function_of(Elementary_function::POWER, x), SC::Invalid_input);
  EXPECT_THROW(1 / sin(x - x), SC::Invalid_input);
  // where only polynomials are possible
  const std::vector<SC::Constraint> constraints{x * sin(y) == 1};
  EXPECT_TRUE(has(message([&] { SC::make_system(constraints); }), "the function sin"));
  EXPECT_TRUE(has(message([&] { SC::solve_curves(constraints[0]); }), "the function sin"));
  EXPECT_TRUE(has(message([&] { SC::solve(constraints); }), "equalities"));
  EXPECT_TRUE(has(message([&] { SC::bounds(exp(x), {{0, 1}, {0, 1}}); }), "the function exp"));
  EXPECT_THROW((x + sin(y)).polynomial(), SC::Invalid_input);
  EXPECT_TRUE(has(message([&] { divided_exactly(sin(x) * (x - y), x - y); }), "the function sin"));
  EXPECT_TRUE(has(message([&] { substituted(sin(x + y), x, y); }), "the function sin"));
  const SC::Vector_expression<2> point(x, y), values(sin(x), y);
  EXPECT_TRUE(has(message([&] { SC::solve_linear<2>({x + sin(exp(x)) == 1, y == 2}, point); }), "the function exp"));
  EXPECT_TRUE(has(message([&] { SC::solve_linear<2>({2 * sin(x) == 1, y == 2}, values); }), "not an unknown"));
}

namespace {

SC::Feasibility_d feasibility(const std::vector<SC::Constraint>& constraints, std::size_t node_limit = 3000)
{
  return SC::Feasibility_solver_d({.tolerance = 1e-6, .node_limit = node_limit})(
      std::span<const SC::Constraint>(constraints));
}

// Whether parts without solutions cover a box: every point of a grid, moved a little, lies in one.
bool is_covered(const SC::Feasibility_d& answer, double lower, double upper)
{
  constexpr int steps = 40;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const double x = lower + (i + 0.37) / steps * (upper - lower), y = lower + (k + 0.41) / steps * (upper - lower);
      if (std::ranges::none_of(answer.excluded(), [&](const auto& part) {
            return part.place[0].first <= x && x <= part.place[0].second && part.place[1].first <= y &&
                y <= part.place[1].second;
          }))
        return false;
    }
  return true;
}

} // namespace

TEST(Feasibility_with_functions, points)
{
  const auto [x, y] = SC::unknowns({-4, 4}, {-4, 4});
  const SC::Feasibility_d high = feasibility({sin(x) + cos(y) > 1.999, x != y});
  ASSERT_TRUE(high.is_feasible());
  ASSERT_TRUE(high.has_point());
  EXPECT_GT(std::sin(CGAL::to_double(high.point()[0])) + std::cos(CGAL::to_double(high.point()[1])), 1.999 - 1e-15);
  const SC::Feasibility_d too_high = feasibility({sin(x) + cos(y) > 2.001});
  EXPECT_TRUE(too_high.is_infeasible());
  EXPECT_TRUE(is_covered(too_high, -4, 4));

  // on a curve, the values of one unknown being chosen
  for (const double bound : {3.0, 2.0, 0.5}) {
    const SC::Feasibility_d on_curve = feasibility({exp(x * y) == 2, x + y < -bound, log(-x) < 0.5});
    ASSERT_TRUE(on_curve.is_feasible()) << bound;
    const double a = CGAL::to_double(on_curve.box()[0].first), b = CGAL::to_double(on_curve.box()[1].first);
    EXPECT_NEAR(a * b, std::log(2.0), 1e-12);
    EXPECT_LT(a + b, -bound);
    EXPECT_TRUE(on_curve.box()[0].first == on_curve.box()[0].second ||
                on_curve.box()[1].first == on_curve.box()[1].second);
    // the box holds one: the equality has different signs at the ends of the unknown that was not chosen
    const int other = on_curve.box()[0].first == on_curve.box()[0].second;
    EXPECT_LT(on_curve.box()[other].first, on_curve.box()[other].second);
  }
  EXPECT_TRUE(feasibility({exp(x) + exp(y) == Rational(1, 100), x + y > -8}).is_infeasible());
  const SC::Feasibility_d none = feasibility({exp(x) + y * y == 1, sin(x) > Rational(1, 100), x > -3});
  EXPECT_TRUE(none.is_infeasible());
  EXPECT_TRUE(is_covered(none, -4, 4));
  // where a function is not defined anywhere, or only beside the solutions
  EXPECT_TRUE(feasibility({log(-2 - x * x) < 5 * y}).is_infeasible());
  EXPECT_TRUE(feasibility({sqrt(x - 1) < 2, x * x < Rational(9, 10)}).is_infeasible());
  EXPECT_TRUE(feasibility({1 / sin(x) > 1000}).is_feasible());
  // more equalities than unknowns, and sets that touch
  EXPECT_TRUE(feasibility({sin(x) == 0, cos(x) == 1, exp(y) == 1}).has_point());
  EXPECT_TRUE(feasibility({sin(x) == 0, cos(x) == Rational(1, 2), exp(y) == 1}).is_infeasible());
  const SC::Feasibility_d touching = feasibility({sin(x) >= 1, y * y <= 1}, 200);
  EXPECT_EQ(touching.status(), SC::Feasibility::UNDECIDED);
  EXPECT_FALSE(touching.undecided().empty());
  EXPECT_THROW(feasibility({sin(x) == 0, y == 1}), SC::Invalid_input);
}

// Systems with a planted solution are never infeasible; for most it, or another one, is found.
TEST(Feasibility_with_functions, planted_solutions)
{
  std::mt19937_64 random(20261203);
  std::size_t feasible = 0, infeasible = 0;
  constexpr int cases = 15;
  for (int k = 0; k < cases; ++k) {
    SCOPED_TRACE(k);
    const int n = 2 + k % 3, equalities = k % n;
    Elementary_values values;
    const std::vector<Rational> root = random_point(random, n);
    Constraints constraints;
    std::vector<Planted_equation> planted;
    for (int i = 0; i < n; ++i) {
      planted.emplace_back(random, root, values);
      const Power_polynomial& f = planted.back().function();
      constraints.emplace_back(i < equalities ? f : f - Rational(1, 10),
                               i < equalities ? Relation::EQUAL : Relation::LESS);
    }
    const Domain domain(n, {-2, 2});
    const SC::Feasibility_solver_d solver({.tolerance = 1e-6, .node_limit = 80});
    const SC::Feasibility_d answer = solver(domain, constraints, values);
    EXPECT_FALSE(answer.is_infeasible());
    feasible += answer.is_feasible();
    if (answer.is_feasible()) {
      std::vector<double> point;
      for (const auto& [lower, upper] : answer.box())
        point.push_back(CGAL::to_double(lower));
      for (int i = 0; i < n; ++i)
        EXPECT_LT(i < equalities ? std::abs(planted[i](point)) : planted[i](point) - 0.1, 1e-8);
    }
    // the first function cannot have two values
    constraints.emplace_back(planted[0].function() - 1, Relation::GREATER);
    const SC::Feasibility_d contradiction = solver(domain, constraints, values);
    EXPECT_FALSE(contradiction.is_feasible());
    infeasible += contradiction.is_infeasible();
  }
  EXPECT_GT(feasible, std::size_t(cases * 9 / 10));
  EXPECT_GT(infeasible, 2u);
}

} // namespace elementary_functions_test
