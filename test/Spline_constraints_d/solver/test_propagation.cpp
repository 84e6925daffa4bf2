// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The solver by constraint propagation: planted rational solutions, on faces and close together; multiple ones, and
// some on faces at irrational places; systems whose tensors would be too large, and of hundreds of unknowns, with
// known numbers of solutions; chains, by windows that grow, with planted solutions that none of their boxes loses; a
// common part as an unknown of its own; inequalities; limits and bad input. Its parts: slices of boxes, ranges of
// polynomials against their values, and sparse elimination against the matrix it is given.

#include <CGAL/Spline_constraints_d/solver/Propagation_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Box_shaving.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Chain_order.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Growing_windows.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_elimination.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Univariate_interval_polynomial.h>

#include "counterflow_system.h"
#include "planted_simple_roots.h"
#include "solver_test_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace propagation_test {

namespace SC = CGAL::Spline_constraints;
using namespace solver_test;
using SC::Power_polynomial;
using SC::Relation;
using Constraints = std::vector<std::pair<Power_polynomial, Relation>>;
using Domain = std::vector<SC::Constraint_system_d::Domain>;

namespace {

Constraints equalities(const std::vector<Power_polynomial>& polynomials)
{
  Constraints result;
  for (const Power_polynomial& polynomial : polynomials)
    result.emplace_back(polynomial, Relation::EQUAL);
  return result;
}

Domain domain_of_problem(const Problem& problem)
{
  Domain result;
  for (int j = 0; j < problem.system.dimension(); ++j)
    result.push_back(problem.system.domain(j));
  return result;
}

Domain everywhere(int dimension, int size) { return Domain(dimension, {Rational(-size), Rational(size)}); }

// Unknowns of a system with one before the first and one after the last, which are zero.
Power_polynomial neighbour(int index, int dimension)
{
  return index < 0 || index >= dimension ? Power_polynomial() : Power_polynomial::variable(index);
}

// Broyden: f_i = (3 - 2 x_i) x_i - x_{i-1} - 2 x_{i+1} + 1.
Constraints tridiagonal(int n)
{
  std::vector<Power_polynomial> result;
  for (int i = 0; i < n; ++i) {
    const Power_polynomial x = neighbour(i, n);
    result.push_back((3 - 2 * x) * x - neighbour(i - 1, n) - 2 * neighbour(i + 1, n) + 1);
  }
  return equalities(result);
}

// Broyden: f_i = x_i (2 + 5 x_i^2) + 1 - sum of x_j (1 + x_j) over i - 5 <= j <= i + 1, j != i.
Constraints banded(int n)
{
  std::vector<Power_polynomial> result;
  for (int i = 0; i < n; ++i) {
    const Power_polynomial x = neighbour(i, n);
    Power_polynomial f = x * (2 + 5 * x * x) + 1;
    for (int j = i - 5; j <= i + 1; ++j)
      if (j != i)
        f -= neighbour(j, n) * (1 + neighbour(j, n));
    result.push_back(f);
  }
  return equalities(result);
}

// Brown: x_i + (sum of all) = n + 1 for i < n - 1, and the product of all is 1.
Constraints almost_linear(int n)
{
  Power_polynomial sum, product(1);
  for (int i = 0; i < n; ++i) {
    sum += Power_polynomial::variable(i);
    product *= Power_polynomial::variable(i);
  }
  std::vector<Power_polynomial> result;
  for (int i = 0; i + 1 < n; ++i)
    result.push_back(Power_polynomial::variable(i) + sum - (n + 1));
  result.push_back(product - 1);
  return equalities(result);
}

// Yamamura: 2.5 x_i^3 - 10.5 x_i^2 + 11.8 x_i + (sum of all) = i.
Constraints coupled_cubics(int n)
{
  Power_polynomial sum;
  for (int i = 0; i < n; ++i)
    sum += Power_polynomial::variable(i);
  std::vector<Power_polynomial> result;
  for (int i = 0; i < n; ++i) {
    const Power_polynomial x = Power_polynomial::variable(i);
    result.push_back((5 * pow(x, 3) - 21 * pow(x, 2)) / 2 + 59 * x / 5 + sum - (i + 1));
  }
  return equalities(result);
}

SC::Solution_set_d<double> complete(const Domain& domain, const Constraints& constraints, std::size_t certified,
                                    std::size_t clusters = 0)
{
  auto result = SC::Propagation_solver_d()(domain, constraints);
  EXPECT_TRUE(result.is_complete()) << result.summary();
  EXPECT_EQ(result.count(SC::Solution_kind::CERTIFIED), certified);
  EXPECT_EQ(result.count(SC::Solution_kind::CLUSTER), clusters);
  EXPECT_EQ(result.size(), certified + clusters);
  expect_consistent_regions(result);
  return result;
}

} // namespace

TEST(Propagation, finds_planted_solutions)
{
  Planted_simple_roots planted(20261129);
  std::size_t found = 0;
  for (int k = 0; k < 80; ++k) {
    const auto [problem, polynomials] = planted.make_polynomials(1 + k % 5);
    SCOPED_TRACE(k);
    const auto solutions = complete(domain_of_problem(problem), equalities(polynomials), problem.count);
    for (const Point& point : problem.known) {
      std::size_t holders = 0;
      for (const auto& solution : solutions)
        holders += meets(solution.exact_box(), point);
      EXPECT_EQ(holders, 1u) << text_of(point);
    }
    found += problem.count;
  }
  EXPECT_GT(found, 300u);
  EXPECT_GT(planted.on_faces, 10u);
  EXPECT_GT(planted.in_corners, 2u);
  EXPECT_GT(planted.close_pairs, 10u);
}

// With the solver that has tensors: the same solutions, each in the region of the other one.
TEST(Propagation, agrees_with_subdivision)
{
  for (const Constraints& constraints : {tridiagonal(8), almost_linear(7), coupled_cubics(8)}) {
    const int n = static_cast<int>(constraints.size());
    const Domain domain = everywhere(n, 100);
    System system(domain);
    for (const auto& [polynomial, relation] : constraints)
      system.add(polynomial, relation);
    const auto expected = SC::solve(system);
    ASSERT_TRUE(expected.is_complete());
    ASSERT_GE(expected.size(), 2u);
    for (const auto& solution : complete(domain, constraints, expected.size())) {
      EXPECT_TRUE(verify(system, solution));
      std::size_t same = 0;
      for (const auto& other : expected)
        same += contains(other.exact_uniqueness_region(), solution.exact_box());
      EXPECT_EQ(same, 1u);
    }
  }
}

// Tensors would have 2^30 coefficients, or the systems hundreds of unknowns.
TEST(Propagation, large_systems)
{
  for (const int n : {19, 30}) {
    const auto solutions = complete(everywhere(n, 100), almost_linear(n), n % 2 == 0 ? 2 : 3);
    std::size_t ones = 0;
    for (const auto& solution : solutions) {
      bool is_one = true;
      for (const auto& [lower, upper] : solution.box())
        is_one = is_one && lower <= 1 && 1 <= upper;
      ones += is_one;
    }
    EXPECT_EQ(ones, 1u);
  }
  complete(everywhere(100, 100), tridiagonal(100), 2);
  complete(everywhere(300, 100), banded(300), 1);
  complete(everywhere(40, 100000000), coupled_cubics(40), 9);
  complete(everywhere(200, 100000000), coupled_cubics(200), 13);
}

// Unknowns with a function of another one each as their value: those whose range says no more are replaced, others cut
// off solutions.
TEST(Propagation, explicit_unknowns)
{
  Planted_simple_roots planted(20261130);
  std::size_t found = 0, cut_off = 0;
  for (int k = 0; k < 40; ++k) {
    const auto [problem, polynomials] = planted.make_polynomials(1 + k % 3);
    SCOPED_TRACE(k);
    const int n = problem.system.dimension();
    const auto value_of = []<class T>(const T& x) { return T(x * x * x / 3 - 2 * x); };
    std::vector<Power_polynomial> named = polynomials;
    for (int j = 0; j < n; ++j) {
      const Power_polynomial difference = value_of(Power_polynomial::variable(j)) - Power_polynomial::variable(n + j);
      named.push_back(difference / 7);
      for (int i = 0; i < n; ++i)
        named[i] += (i + j + 1) * difference;
    }
    for (const bool is_cut : {false, true}) {
      Domain domain = domain_of_problem(problem);
      const Rational far(1000000000);
      for (int j = 0; j < n; ++j)
        domain.emplace_back(is_cut && j == k % n ? Rational(0) : Rational(-far), far);
      std::vector<Point> expected;
      for (Point point : problem.known) {
        for (int j = 0; j < n; ++j)
          point.push_back(value_of(point[j].lower));
        if (point[n + k % n].lower >= domain[n + k % n].first)
          expected.push_back(point);
        else
          ++cut_off;
      }
      const auto solutions = complete(domain, equalities(named), expected.size());
      for (const Point& point : expected) {
        std::size_t holders = 0;
        for (const auto& solution : solutions)
          holders += meets(solution.exact_box(), point);
        EXPECT_EQ(holders, 1u) << text_of(point);
      }
      found += expected.size();
    }
  }
  EXPECT_GT(found, 150u);
  EXPECT_GT(cut_off, 20u);
}

TEST(Propagation, multiple_solutions_and_faces)
{
  const Power_polynomial x = Power_polynomial::variable(0), y = Power_polynomial::variable(1);
  // a double one at (1/3, 1/3), simple ones at (1/3 + 2, ...)
  const auto touching = complete(everywhere(2, 5), equalities({y - x, pow(3 * x - 1, 2) * (x - 2)}), 1, 1);
  EXPECT_EQ(touching[1].multiplicity(), 2);
  // sqrt(2) is no rational number, the other coordinate is on a face
  complete({{Rational(0), Rational(5)}, {Rational(0), Rational(5)}}, equalities({x * x - 2, x * y}), 1);
  complete({{Rational(-5), Rational(0)}, {Rational(-5), Rational(0)}}, equalities({x * x - 2, x * y}), 1);
  complete({{Rational(2), Rational(5)}, {Rational(0), Rational(5)}}, equalities({x * x - 2, x * y}), 0);
}

TEST(Propagation, inequalities)
{
  const Power_polynomial x = Power_polynomial::variable(0), y = Power_polynomial::variable(1);
  const Constraints circle_and_line = equalities({x * x + y * y - 25, 4 * x - 3 * y});
  const auto with = [&](const Power_polynomial& polynomial, Relation relation) {
    Constraints result = circle_and_line;
    result.emplace_back(polynomial, relation);
    return result;
  };
  complete(everywhere(2, 10), circle_and_line, 2);
  complete(everywhere(2, 10), with(x, Relation::GREATER), 1);
  complete(everywhere(2, 10), with(x - 3, Relation::GREATER_EQUAL), 1);
  complete(everywhere(2, 10), with(x - 3, Relation::GREATER), 0);
  complete(everywhere(2, 10), with(x - 3, Relation::NOT_EQUAL), 1);
  complete(everywhere(2, 10), with(x - 3, Relation::LESS), 1);
  complete(everywhere(2, 10), with(x + y, Relation::LESS_EQUAL), 1);
}

// The one that is faster is chosen; answers are the same.
TEST(Propagation, choice_of_solver)
{
  for (const Constraints& constraints : {tridiagonal(12), almost_linear(22), coupled_cubics(20)}) {
    const int n = static_cast<int>(constraints.size());
    const auto propagation = SC::Propagation_solver_d()(everywhere(n, 100), constraints);
    const auto solutions = SC::solve_polynomials(everywhere(n, 100), constraints);
    EXPECT_TRUE(solutions.is_complete());
    EXPECT_EQ(solutions.size(), propagation.size());
    EXPECT_GE(solutions.size(), 2u);
  }
}

TEST(Propagation, chains)
{
  // the numbers are those that the search finds without windows
  for (const auto& [stages, solutions] : std::vector<std::pair<int, std::size_t>>{{4, 14}, {5, 18}, {8, 26}}) {
    const auto found = SC::Propagation_solver_d()(everywhere(2 * stages, 100000), counterflow(stages));
    EXPECT_TRUE(found.is_complete()) << stages;
    EXPECT_EQ(found.size(), solutions) << stages;
  }
}

TEST(Propagation, windows_lose_no_solution)
{
  std::mt19937 engine(561);
  std::uniform_int_distribution<int> eighths(-8, 8);
  for (int round = 0; round < 10; ++round) {
    const int stages = 4 + round % 3;
    std::vector<Rational> solution;
    for (int j = 0; j < 2 * stages; ++j)
      solution.push_back(Rational(eighths(engine)) / 8);
    const Constraints constraints = counterflow(stages, solution);
    const SC::internal::Chain_order order(constraints, 2 * stages);
    EXPECT_EQ(order.largest_frontier(), 4u);
    Constraints chain;
    for (const int i : order.order())
      chain.push_back(constraints[i]);
    const SC::Upward_rounding_guard guard;
    const SC::internal::Box_of_ranges domain(2 * stages, SC::internal::Interval(-1000, 1000));
    SC::internal::Growing_windows windows(
        chain, domain, [] {}, SC::internal::Parallel_loop::of<CGAL::Sequential_tag>());
    while (!windows.is_done())
      windows.advance();
    const auto boxes = windows.boxes(domain);
    EXPECT_LT(boxes.size(), 1000u);
    EXPECT_TRUE(std::ranges::any_of(boxes, [&](const SC::internal::Box_of_ranges& box) {
      for (std::size_t j = 0; j < box.size(); ++j)
        if (solution[j] < Rational(box[j].inf()) || solution[j] > Rational(box[j].sup()))
          return false;
      return true;
    })) << round;
  }
}

// Of x = y = -x propagation alone says nothing; slices leave the one beside zero on each side. Planted solutions stay.
TEST(Propagation, slices_of_boxes)
{
  using SC::internal::Interval;
  const SC::Upward_rounding_guard guard;
  const std::function<void()> check = [] {};
  const auto narrow = [&](const Constraints& constraints, int unknown, SC::internal::Box_of_ranges& box) {
    const SC::internal::Sparse_system system(static_cast<int>(box.size()), constraints, check);
    SC::internal::Constraint_propagation propagation(system);
    return SC::internal::Box_shaving(propagation, check)(unknown, box);
  };
  const Power_polynomial x = Power_polynomial::variable(0), y = Power_polynomial::variable(1);
  SC::internal::Box_of_ranges square(2, Interval(-1, 1));
  EXPECT_TRUE(narrow(equalities({x - y, x + y}), 0, square));
  for (const Interval& range : square) {
    EXPECT_LE(range.sup(), 0.21);
    EXPECT_GE(range.inf(), -0.21);
  }
  square.assign(2, Interval(0.5, 1));
  EXPECT_FALSE(narrow(equalities({x - y, x + y}), 1, square));

  std::mt19937 engine(563);
  std::uniform_int_distribution<int> eighths(-8, 8);
  for (int round = 0; round < 50; ++round) {
    std::vector<Rational> solution;
    SC::internal::Box_of_ranges box;
    for (int j = 0; j < 8; ++j) {
      solution.push_back(Rational(eighths(engine)) / 8);
      const double at = CGAL::to_double(solution.back());
      box.emplace_back(at - 0.125 * (8 + eighths(engine)), at + 0.125 * (8 + eighths(engine)));
    }
    for (int j = 0; j < 8; ++j)
      ASSERT_TRUE(narrow(counterflow(4, solution), j, box));
    for (int j = 0; j < 8; ++j)
      EXPECT_TRUE(solution[j] >= Rational(box[j].inf()) && solution[j] <= Rational(box[j].sup())) << round;
  }
}

TEST(Propagation, chain_order)
{
  // a chain whose constraints are shuffled, and a system that is none
  Constraints chain = counterflow(10);
  std::shuffle(chain.begin(), chain.end(), std::mt19937(562));
  const SC::internal::Chain_order order(chain, 20);
  EXPECT_LE(order.largest_frontier(), 6u);
  std::vector<int> places = order.order();
  std::ranges::sort(places);
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(places[i], i);
  Power_polynomial sum;
  for (int j = 0; j < 12; ++j)
    sum += Power_polynomial::variable(j);
  EXPECT_EQ(SC::internal::Chain_order(equalities(std::vector<Power_polynomial>(12, sum)), 12).largest_frontier(), 12u);
}

TEST(Propagation, limits)
{
  const Constraints constraints = coupled_cubics(16);
  const auto few = SC::Propagation_solver_d({.node_limit = 5})(everywhere(16, 100), constraints);
  EXPECT_FALSE(few.is_complete());
  EXPECT_EQ(few.summary().why_not, SC::Undecided_reason::NODES);
  EXPECT_LE(few.summary().nodes, 5u);

  struct Stopping
  {
    int asked = 0;
    void on_progress(double) {}
    bool stop() { return ++asked > 3; }
  } stopping;
  const auto stopped = SC::Propagation_solver_d({.visitor = stopping})(everywhere(16, 100), constraints);
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_EQ(stopped.summary().why_not, SC::Undecided_reason::STOPPED);
  const auto late = SC::solve_polynomials(everywhere(16, 100), constraints, {.time_limit = 1e-6});
  EXPECT_FALSE(late.is_complete());
  EXPECT_EQ(late.summary().why_not, SC::Undecided_reason::TIME);
}

TEST(Propagation, bad_input)
{
  const Power_polynomial x = Power_polynomial::variable(0), y = Power_polynomial::variable(1);
  const auto message = [](const Domain& domain, const Constraints& constraints) -> std::string {
    try {
      SC::Propagation_solver_d()(domain, constraints);
    } catch (const SC::Invalid_input& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message(everywhere(2, 1), equalities({x})).find("1 equalities for 2 unknowns"), std::string::npos);
  EXPECT_NE(message(everywhere(1, 1), equalities({x - y})).find("unknown 1 of a polynomial has no range"),
            std::string::npos);
  EXPECT_NE(message({{Rational(1), Rational(0)}}, equalities({x})).find("domain of unknown 0 is empty"),
            std::string::npos);
  EXPECT_NE(message({}, {}).find("no unknowns"), std::string::npos);
  EXPECT_THROW(SC::Propagation_solver_d({.tolerance = 0}), SC::Invalid_input);
}

TEST(Propagation, ranges_of_polynomials)
{
  const SC::Upward_rounding_guard guard;
  Random_numbers random(5);
  for (int k = 0; k < 2000; ++k) {
    const int degree = random.integer(1, 6);
    SC::internal::Univariate_interval_polynomial polynomial;
    polynomial.reset(degree);
    std::vector<double> coefficients;
    for (int e = 0; e <= degree; ++e) {
      coefficients.push_back(random.integer(-8, 8));
      polynomial[e] = SC::internal::Interval(coefficients.back());
    }
    const double lower = random.integer(-40, 40) / 8.0, upper = lower + random.integer(0, 40) / 8.0;
    const SC::internal::Interval range = polynomial.range({lower, upper}),
                                 parts = polynomial.range_by_parts({lower, upper});
    SC::internal::Interval left(lower, upper);
    const bool is_left = polynomial.cut(left);
    for (int s = 0; s <= 16; ++s) {
      const double at = lower + (upper - lower) * s / 16; // exact, and so are the values
      double value = 0;
      for (int e = degree; e >= 0; --e)
        value = value * at + coefficients[e];
      EXPECT_TRUE(range.inf() <= value && value <= range.sup());
      EXPECT_TRUE(parts.inf() <= value && value <= parts.sup());
      EXPECT_TRUE(value != 0 || (is_left && left.inf() <= at && at <= left.sup()));
    }
  }
}

// Without radii the multipliers are the inverse, but for what is dropped.
TEST(Propagation, sparse_elimination_inverts)
{
  Random_numbers random(7);
  const int n = 40;
  SC::internal::Sparse_elimination elimination(n);
  for (int k = 0; k < 20; ++k) {
    std::vector<std::vector<double>> matrix(n, std::vector<double>(n, 0.0));
    elimination.begin(n);
    for (int i = 0; i < n; ++i)
      for (int j = (std::max)(0, i - 3); j < (std::min)(n, i + 4); ++j) {
        matrix[i][j] = i == j ? 9 : random.integer(-3, 3) / 2.0;
        elimination.add_entry(i, j, matrix[i][j]);
      }
    for (int i = 0; i < n; ++i)
      elimination.set_radius(i, 0);
    elimination.run([] {});
    std::vector<bool> is_solved(n, false);
    for (int i = 0; i < n; ++i) {
      const int unknown = elimination.pivot(i);
      ASSERT_GE(unknown, 0);
      EXPECT_FALSE(is_solved[unknown]);
      is_solved[unknown] = true;
      std::vector<double> row(n, 0.0);
      for (const auto& [equation, factor] : elimination.multipliers(i))
        for (int j = 0; j < n; ++j)
          row[j] += factor * matrix[equation][j];
      for (int j = 0; j < n; ++j)
        EXPECT_NEAR(row[j], j == unknown ? 1 : 0, 1e-12);
    }
  }
}

// An arrow is not filled in: rows that are sums of many are left in others, which have only unknowns of later pivots
// besides their own one.
TEST(Propagation, sparse_elimination_of_arrows)
{
  Random_numbers random(11);
  const int n = 300;
  SC::internal::Sparse_elimination elimination(n);
  std::vector<std::vector<double>> matrix(n, std::vector<double>(n, 0.0));
  const auto add = [&](int i, int j, double value) {
    matrix[i][j] = value;
    elimination.add_entry(i, j, value);
  };
  elimination.begin(n);
  for (int i = 0; i + 1 < n; ++i) {
    add(i, i, random.integer(5, 9));
    add(i, n - 1, 1);
    add(n - 1, i, 1);
  }
  add(n - 1, n - 1, -1);
  for (int i = 0; i < n; ++i)
    elimination.set_radius(i, 0);
  elimination.run([] {});
  ASSERT_EQ(elimination.solved_rows().size(), static_cast<std::size_t>(n));
  std::vector<int> step(n, -1);
  for (int k = 0; k < n; ++k)
    step[elimination.pivot(elimination.solved_rows()[k])] = k;
  std::size_t size = 0;
  for (int i = 0; i < n; ++i) {
    std::vector<double> row(n, 0.0);
    size += elimination.multipliers(i).size();
    for (const auto& [equation, factor] : elimination.multipliers(i))
      for (int j = 0; j < n; ++j)
        row[j] += factor * matrix[equation][j];
    const int unknown = elimination.pivot(i);
    EXPECT_NEAR(row[unknown], 1, 1e-12);
    for (int j = 0; j < n; ++j)
      EXPECT_TRUE(step[j] > step[unknown] || j == unknown || std::abs(row[j]) < 1e-12) << i << ' ' << j;
  }
  EXPECT_LT(size, static_cast<std::size_t>(4 * n));
}

} // namespace propagation_test
