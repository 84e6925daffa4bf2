// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Many systems in one call: the answers of single calls, in the same order.

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/batch.h>

#include <algorithm>
#include <deque>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace batch_test {

using namespace solver_test;

static std::vector<Problem> problems()
{
  return {cyclic_chebyshev(2, 3), broyden_tridiagonal(4),        cyclic_chebyshev(1, 5),
          circle_and_ellipse(),   cyclic_chebyshev_in_pieces(3), zigzag()};
}

static std::vector<System> systems_of(const std::vector<Problem>& problems)
{
  std::vector<System> systems;
  for (const Problem& problem : problems)
    systems.push_back(problem.system);
  return systems;
}

TEST(Batch, AnswersOfSingleCalls)
{
  const std::vector<Problem> all = problems();
  const std::vector<System> systems = systems_of(all);
  const auto results = solve(systems);
  ASSERT_EQ(results.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    expect_solved(all[i], results[i]);
    const auto single = solve(systems[i]);
    EXPECT_EQ(results[i].summary().nodes, single.summary().nodes);
    ASSERT_EQ(results[i].size(), single.size());
    for (std::size_t k = 0; k < single.size(); ++k)
      EXPECT_EQ(results[i][k].box(), single[k].box());
  }
}

TEST(Batch, Ranges)
{
  const std::vector<Problem> all = problems();
  std::deque<System> systems;
  for (const Problem& problem : all)
    systems.push_back(problem.system);
  EXPECT_EQ(solve(systems).size(), all.size());
  std::reverse(systems.begin(), systems.end());
  const auto reversed = solve(std::as_const(systems));
  ASSERT_EQ(reversed.size(), all.size());
  expect_solved(all.back(), reversed.front());
  expect_solved(all.front(), reversed.back());
  EXPECT_EQ(solve(std::span<const System>(&systems[1], 1), {.tolerance = 1e-12}).size(), 1u);
  EXPECT_TRUE(solve(std::vector<System>()).empty());
}

TEST(Batch, LimitsOfEach)
{
  const System system = cyclic_chebyshev(3, 4).system;
  const std::size_t needed = solve(system).summary().nodes;
  for (const auto& solutions : solve(std::vector<System>(5, system), {.node_limit = needed + 1}))
    EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 64u);
  for (const auto& solutions : solve(std::vector<System>(5, system), {.node_limit = needed / 2}))
    EXPECT_EQ(solutions.summary().why_not, SC::Undecided_reason::NODES);
}

TEST(Batch, InvalidInputNamesTheSystem)
{
  std::vector<System> systems = systems_of(problems());
  systems.insert(systems.begin() + 2, 2, cube(2, 0, 1));
  try {
    solve(systems);
    ADD_FAILURE() << "no exception";
  } catch (const SC::Invalid_input& error) {
    EXPECT_NE(std::string(error.what()).find("system 2 "), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("0 equalities for 2 unknowns"), std::string::npos) << error.what();
  }
  EXPECT_THROW(solve(systems, {.tolerance = -1}), SC::Invalid_input);
}

} // namespace batch_test
