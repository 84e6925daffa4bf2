// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Few unknowns of which all others follow by linear equations: they are found where they are planted, and not where
// there are none; where boxes are split in them first, no planted solution is lost, and few boxes are looked at.

#include <CGAL/Spline_constraints_d/solver/Propagation_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Block_order.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Determining_unknowns.h>

#include "random_systems.h"
#include "solver_test_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace determining_unknowns_test {

namespace SC = CGAL::Spline_constraints;
using namespace solver_test;
using SC::Power_polynomial;
using SC::Relation;
using Constraints = std::vector<std::pair<Power_polynomial, Relation>>;
using Domain = std::vector<SC::Constraint_system_d::Domain>;

namespace {

Power_polynomial unknown(int j) { return Power_polynomial::variable(j); }

std::vector<int> determining_unknowns(int dimension, const Constraints& constraints)
{
  const SC::internal::Sparse_system system(dimension, constraints, [] {});
  const SC::internal::Determining_unknowns determining(system, SC::internal::Block_order(system));
  std::vector<int> result;
  for (int j = 0; j < dimension; ++j)
    if (determining[j])
      result.push_back(j);
  return result;
}

// All solutions are certified, and each planted one is in one of them.
SC::Solution_set_d<double> expect_planted(const Domain& domain, const Constraints& constraints,
                                          const std::vector<Point>& planted)
{
  auto solutions = SC::Propagation_solver_d()(domain, constraints);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  expect_consistent_regions(solutions);
  for (const Point& point : planted)
    EXPECT_EQ(std::ranges::count_if(solutions, [&](const auto& s) { return meets(s.exact_box(), point); }), 1);
  return solutions;
}

// The eigenvectors x and eigenvalues t of a matrix P D P^-1, where P is a product of a lower and an upper triangular
// matrix of integers with units on the diagonals, and D has the eigenvalues; one linear equation makes vectors unique.
struct Eigenproblem
{
  Constraints constraints;
  std::vector<Point> planted; // (x, t)

  Eigenproblem(int size, Random_numbers& random)
  {
    using Matrix = std::vector<std::vector<Rational>>;
    const auto zero = Matrix(size, std::vector<Rational>(size, Rational(0)));
    const auto product = [&](const Matrix& a, const Matrix& b) {
      Matrix result = zero;
      for (int i = 0; i < size; ++i)
        for (int j = 0; j < size; ++j)
          for (int k = 0; k < size; ++k)
            result[i][j] += a[i][k] * b[k][j];
      return result;
    };
    // T and its inverse, of unit triangles with one more number in each column
    Matrix p = zero, inverse = zero, diagonal = zero;
    for (int i = 0; i < size; ++i) {
      p[i][i] = inverse[i][i] = 1;
      diagonal[i][i] = Rational(4 * (i - size / 2) + random.integer(0, 2)) / 2;
    }
    for (int step = 0; step < 3 * size; ++step) {
      const int from = random.integer(0, size - 1), to = random.integer(0, size - 1);
      const Rational factor(random.integer(-1, 1));
      if (from == to)
        continue;
      for (int k = 0; k < size; ++k)
        p[to][k] += factor * p[from][k];
      for (int k = 0; k < size; ++k)
        inverse[k][from] -= factor * inverse[k][to];
    }
    const Matrix matrix = product(product(p, diagonal), inverse);
    std::vector<Rational> normal;
    for (int j = 0; j < size; ++j)
      normal.push_back(Rational(random.integer(10, 30)) / 10);
    Power_polynomial length(Rational(-1));
    for (int i = 0; i < size; ++i) {
      Power_polynomial row = -(unknown(size) * unknown(i));
      for (int j = 0; j < size; ++j)
        row += Power_polynomial(matrix[i][j]) * unknown(j);
      constraints.emplace_back(row, Relation::EQUAL);
      length += Power_polynomial(normal[i]) * unknown(i);
    }
    constraints.emplace_back(length, Relation::EQUAL);
    for (int k = 0; k < size; ++k) {
      Rational scale(0);
      for (int i = 0; i < size; ++i)
        scale += normal[i] * p[i][k];
      if (scale == 0)
        continue;
      Point& point = planted.emplace_back();
      for (int i = 0; i < size; ++i)
        point.push_back(p[i][k] / scale);
      point.push_back(diagonal[k][k]);
    }
  }
};

// Numbers of which each is told by the two before and by one that is in all equations; the ends tell of each other.
struct Coupled_recurrence
{
  Constraints constraints;
  Point planted;

  Coupled_recurrence(int length, Random_numbers& random)
  {
    const Rational t = Rational(random.integer(-20, 20)) / 16;
    std::vector<Rational> values{t, Rational(random.integer(-16, 16)) / 16, Rational(random.integer(-16, 16)) / 16};
    for (int k = 3; k <= length; ++k) {
      values.push_back((values[k - 1] * values[k - 2] + t) / 2);
      constraints.emplace_back(2 * unknown(k) - unknown(k - 1) * unknown(k - 2) - unknown(0), Relation::EQUAL);
    }
    for (int k = 1; k <= 3; ++k) {
      const Rational end = values[length - k] + t * values[k];
      constraints.emplace_back(unknown(length - k) + unknown(0) * unknown(k) - end, Relation::EQUAL);
    }
    planted.assign(values.begin(), values.end());
  }
};

} // namespace

TEST(DeterminingUnknowns, eigenvalues)
{
  Random_numbers random(5640);
  std::size_t planted = 0, nodes = 0;
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE(round);
    const int size = 4 + round % 3;
    const Eigenproblem problem(size, random);
    EXPECT_EQ(determining_unknowns(size + 1, problem.constraints), std::vector<int>{size});
    const auto solutions =
        expect_planted(Domain(size + 1, {Rational(-10000), Rational(10000)}), problem.constraints, problem.planted);
    EXPECT_EQ(solutions.size(), problem.planted.size());
    nodes += solutions.summary().nodes;
    planted += problem.planted.size();
  }
  EXPECT_GE(planted, 24u);
  EXPECT_LT(nodes, 10000u); // 40,000 where all unknowns are alike
}

TEST(DeterminingUnknowns, recurrences)
{
  Random_numbers random(5641);
  for (int round = 0; round < 4; ++round) {
    SCOPED_TRACE(round);
    const int length = 12 + round;
    const Coupled_recurrence problem(length, random);
    const std::vector<int> determining = determining_unknowns(length + 1, problem.constraints);
    EXPECT_GE(determining.size(), 2u);
    EXPECT_LE(determining.size(), 3u);
    EXPECT_EQ(std::ranges::count(determining, 0), 1);
    const auto solutions =
        expect_planted(Domain(length + 1, {Rational(-100), Rational(100)}), problem.constraints, {problem.planted});
    EXPECT_GE(solutions.size(), 1u);
  }
}

// Where all are multiplied, and in chains, whose ends tell little of what is far away.
TEST(DeterminingUnknowns, none)
{
  constexpr int dimension = 12;
  Constraints products, chain;
  for (int i = 0; i < dimension; ++i) {
    Power_polynomial product(Rational(-1)), link = pow(unknown(i), 2) - 2;
    for (int j = 0; j < dimension; ++j)
      product += unknown(j) * unknown((i + j) % dimension);
    for (const int j : {i - 1, i + 1})
      if (j >= 0 && j < dimension)
        link += unknown(j);
    products.emplace_back(product, Relation::EQUAL);
    chain.emplace_back(link, Relation::EQUAL);
  }
  EXPECT_EQ(determining_unknowns(dimension, products), std::vector<int>());
  EXPECT_EQ(determining_unknowns(dimension, chain), std::vector<int>());
}

} // namespace determining_unknowns_test
