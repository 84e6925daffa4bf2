// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Cells that hold a planted solution are visited; those that the bounds exclude are not.

#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Cell_pyramid.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/System_layout.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace Cell_pyramid_test {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using SC::internal::Cell;
using Tensor = SC::Bernstein_tensor<Rational>;

namespace {

std::vector<Cell> possible_cells(const SC::Constraint_system_d& system)
{
  const SC::internal::System_layout layout(system);
  const SC::internal::Exact_source source(system, layout);
  std::vector<Cell> cells;
  SC::internal::Cell_pyramid(system, source.breaks()).visit_possible_cells([&](const Cell& cell) {
    cells.push_back(cell);
  });
  std::sort(cells.begin(), cells.end());
  return cells;
}

// Over the breaks 0, 1, ..., and linear between them.
SC::Spline_function polyline(int unknown, const std::vector<int>& values)
{
  std::vector<Rational> breaks;
  std::vector<Tensor> pieces;
  for (std::size_t k = 0; k < values.size(); ++k)
    breaks.emplace_back(static_cast<int>(k));
  for (std::size_t k = 0; k + 1 < values.size(); ++k)
    pieces.emplace_back(std::vector<int>{1}, std::vector<Rational>{values[k], values[k + 1]});
  return SC::Spline_function::from_bezier_pieces({unknown}, {breaks}, pieces);
}

SC::Constraint_system_d system_on(const std::vector<int>& ends)
{
  std::vector<SC::Constraint_system_d::Domain> domain;
  for (int end : ends)
    domain.emplace_back(0, end);
  return SC::Constraint_system_d(domain);
}

Rational value(const SC::Spline_function& function, const std::vector<Rational>& point)
{
  Rational result(0);
  for (const SC::Spline_term& term : function.terms()) {
    std::size_t piece = 0;
    for (std::size_t j = 0; j < term.variables.size(); ++j) {
      std::size_t cell = 0;
      while (cell + 1 < term.cells(j) && term.breaks[j][cell + 1] < point[term.variables[j]])
        ++cell;
      piece = piece * term.cells(j) + cell;
    }
    auto coefficient = term.pieces[piece].begin();
    SC::internal::for_each_index(term.degrees, [&](const std::vector<int>& powers) {
      Rational product = *coefficient++;
      for (std::size_t j = 0; j < powers.size(); ++j)
        for (int k = 0; k < powers[j]; ++k)
          product *= point[term.variables[j]];
      result += product;
    });
  }
  return result;
}

} // namespace

TEST(Cell_pyramid, identical_staircases_meet_on_the_diagonal)
{
  std::vector<int> steps(101);
  for (int k = 0; k <= 100; ++k)
    steps[k] = k;
  SC::Constraint_system_d system = system_on({100, 100});
  system.add(polyline(0, steps) - polyline(1, steps), SC::Relation::EQUAL);
  const std::vector<Cell> cells = possible_cells(system);
  EXPECT_EQ(cells.size(), 298u);   // the diagonal and its neighbours, which share a corner with it
  for (const Cell& cell : cells)
    EXPECT_LE(std::abs(cell[0] - cell[1]), 1);
}

TEST(Cell_pyramid, inequalities_and_unknowns_without_breaks)
{
  SC::Constraint_system_d system = system_on({7, 2, 5});
  system.add(polyline(0, {0, 1, 2, 3, 4, 5, 6, 7}), SC::Relation::GREATER);
  system.add(polyline(0, {0, 1, 2, 3, 4, 5, 6, 7}) - polyline(2, {3, 3, 3, 3, 5, 5}), SC::Relation::EQUAL);
  system.add(SC::Power_polynomial::variable(1) - Rational(1), SC::Relation::EQUAL);
  std::vector<Cell> expected;
  for (int k = 0; k < 3; ++k) {   // y = 3 has x in [2,3] and [3,4]
    expected.push_back({2, 0, k});
    expected.push_back({3, 0, k});
  }
  for (int x : {2, 3, 4, 5})
    expected.push_back({x, 0, 3});
  expected.push_back({4, 0, 4});
  expected.push_back({5, 0, 4});
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(possible_cells(system), expected);

  system.add(polyline(0, {1, 2, 3, 4, 5, 6, 7, 8}), SC::Relation::LESS);
  EXPECT_TRUE(possible_cells(system).empty());
}

TEST(Cell_pyramid, keeps_the_cells_of_planted_solutions)
{
  std::mt19937 generator(3);
  std::uniform_int_distribution<int> coefficient(-9, 9);
  std::size_t visited = 0, all = 0;
  for (int round = 0; round < 60; ++round) {
    const std::vector<int> cells{2 + round % 7, 1 + round % 3, 3 + round % 5};
    SC::Constraint_system_d system = system_on(cells);
    std::vector<Rational> point;
    Cell home;
    for (int size : cells) {
      home.push_back(std::uniform_int_distribution<int>(0, size - 1)(generator));
      point.push_back(Rational(home.back()) + Rational(1 + std::abs(coefficient(generator)), 11));
    }
    const auto spline = [&](int a, int b) {   // of degree (2, 1); neighbouring pieces need not fit for this test
      std::vector<std::vector<Rational>> breaks(2);
      for (int k = 0; k <= cells[a]; ++k)
        breaks[0].emplace_back(k);
      for (int k = 0; k <= cells[b]; ++k)
        breaks[1].emplace_back(k);
      std::vector<Tensor> pieces;
      for (int k = 0; k < cells[a] * cells[b]; ++k) {
        std::vector<Rational> coefficients;
        for (int i = 0; i < 6; ++i)
          coefficients.emplace_back(coefficient(generator));
        pieces.emplace_back(std::vector<int>{2, 1}, coefficients);
      }
      return SC::Spline_function::from_bezier_pieces({a, b}, breaks, pieces);
    };
    for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)}) {
      SC::Spline_function function = spline(a, b);
      const Rational at_point = value(function, point);
      function += SC::Spline_function(SC::Power_polynomial(Rational(-at_point)));
      system.add(std::move(function), SC::Relation::EQUAL);
    }
    const std::vector<Cell> possible = possible_cells(system);
    EXPECT_TRUE(std::binary_search(possible.begin(), possible.end(), home)) << "round " << round;
    visited += possible.size();
    all += static_cast<std::size_t>(cells[0] * cells[1] * cells[2]);
  }
  EXPECT_LT(visited, all);
}

TEST(Cell_pyramid, numbers_beyond_doubles_exclude_nothing_wrongly)
{
  SC::Constraint_system_d system = system_on({2});
  SC::Spline_function function = polyline(0, {-1, 1, 2});
  Rational huge(1);
  for (int k = 0; k < 1100; ++k)
    huge *= 2;
  function *= huge;
  system.add(function, SC::Relation::EQUAL);
  const std::vector<Cell> cells = possible_cells(system);
  EXPECT_TRUE(std::binary_search(cells.begin(), cells.end(), Cell{0}));
}

} // namespace Cell_pyramid_test
