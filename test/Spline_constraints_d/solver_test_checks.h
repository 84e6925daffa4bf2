// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_TEST_SOLVER_TEST_CHECKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_TEST_SOLVER_TEST_CHECKS_H

#include "solver_test_systems.h"

#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

// What must hold of the answers to systems whose solutions are known.
namespace solver_test {

using SC::Solution_kind;

// The point may lie in the box.
template <class C>
bool meets(const std::vector<std::pair<C, C>>& box, const Point& point)
{
  for (std::size_t j = 0; j < box.size(); ++j)
    if (Rational(box[j].second) < point[j].lower || point[j].upper < Rational(box[j].first))
      return false;
  return box.size() == point.size();
}

template <class C>
bool contains(const std::vector<std::pair<C, C>>& outer, const std::vector<std::pair<C, C>>& inner)
{
  for (std::size_t j = 0; j < inner.size(); ++j)
    if (inner[j].first < outer[j].first || outer[j].second < inner[j].second)
      return false;
  return outer.size() == inner.size();
}

inline std::string text_of(const Point& point)
{
  std::string result;
  for (const Coordinate& c : point)
    result += (result.empty() ? "" : ", ") + std::to_string(CGAL::to_double(c.lower));
  return '(' + result + ')';
}

// Every known solution lies in an answer.
template <class Solutions>
void expect_nothing_lost(const std::vector<Point>& known, const Solutions& solutions)
{
  for (const Point& point : known) {
    std::size_t holders = 0;
    for (const auto& solution : solutions)
      holders += meets(solution.exact_box(), point);
    EXPECT_GE(holders, 1u) << text_of(point) << " is lost";
  }
}

// No certified answer lies in the region in which another one is the only solution, and all answers have a region.
template <class Solutions>
void expect_consistent_regions(const Solutions& solutions)
{
  for (const auto& a : solutions)
    if (a.is_certified()) {
      const auto box = a.exact_box(), region = a.exact_uniqueness_region();
      ASSERT_EQ(region.size(), box.size());
      for (std::size_t j = 0; j < box.size(); ++j) {
        EXPECT_LT(region[j].first, box[j].second);
        EXPECT_LT(box[j].first, region[j].second);
        EXPECT_LE(Rational(a[j].first), box[j].first);
        EXPECT_LE(box[j].second, Rational(a[j].second));
      }
      for (const auto& b : solutions)
        EXPECT_TRUE(&a == &b || !b.is_certified() || !contains(region, b.exact_box()));
    }
}

// Exactly the solutions of the problem, each certified once and proved again.
template <class Solutions>
void expect_solved(const Problem& problem, const Solutions& solutions)
{
  SCOPED_TRACE(problem.name);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.size(), problem.count);
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), problem.count);
  for (const Point& point : problem.known) {
    std::size_t holders = 0;
    for (const auto& solution : solutions)
      holders += meets(solution.exact_box(), point);
    EXPECT_EQ(holders, 1u) << text_of(point);
  }
  for (const auto& solution : solutions) {
    std::size_t held = 0;
    for (const Point& point : problem.known)
      held += meets(solution.exact_box(), point);
    EXPECT_LE(held, 1u);
    EXPECT_TRUE(verify(problem.system, solution));
    EXPECT_EQ(solution.multiplicity(), 1);
  }
  expect_consistent_regions(solutions);
}

template <class Traits>
auto solve_with(const System& system, const SC::Solver_options& options = {})
{
  return SC::Subdivision_solver_d<Traits>(options)(system);
}

template <class Traits>
void check(const Problem& problem, const SC::Solver_options& options = {})
{
  expect_solved(problem, solve_with<Traits>(problem.system, options));
}

} // namespace solver_test

#endif // CGAL_SPLINE_CONSTRAINTS_D_TEST_SOLVER_TEST_CHECKS_H
