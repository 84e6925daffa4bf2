// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// 500 random systems with known multiple and simple roots, and others on which the solver has a limit that it may
// reach: there, nothing it says is wrong.

#include "planted_multiple_roots.h"
#include "solver_test_checks.h"

#include <algorithm>
#include <string>

namespace planted_multiple_roots_test {

using namespace solver_test;
using Solutions = SC::Solution_set_d<double>;
using Solution = Solutions::Solution;

static bool is_rational(const Planted_problem& problem)
{
  return std::all_of(problem.roots.begin(), problem.roots.end(),
                     [](const Planted_root& root) { return root.is_rational(); });
}

static std::vector<Point> points_of(const Planted_problem& problem)
{
  std::vector<Point> result;
  for (const Planted_root& root : problem.roots)
    result.push_back(root.point);
  return result;
}

// What is said of an answer that holds a root is true of the root.
static void expect_right(const Planted_root& root, const Solution& solution)
{
  EXPECT_TRUE(!solution.is_certified() || root.multiplicity == 1) << text_of(root.point) << " is certified";
  EXPECT_TRUE(solution.kind() != Solution_kind::CLUSTER || solution.multiplicity() == root.multiplicity ||
              solution.multiplicity() == 0)
      << text_of(root.point) << " has multiplicity " << root.multiplicity << " and not " << solution.multiplicity();
}

static void expect_found(const Planted_root& root, const Solution& solution)
{
  expect_right(root, solution);
  const bool is_left_open =
      solution.kind() == Solution_kind::UNDECIDED && solution.reason() == SC::Undecided_reason::TOLERANCE;
  if (root.multiplicity == 1)
    EXPECT_EQ(solution.kind(), Solution_kind::CERTIFIED) << text_of(root.point);
  else
    EXPECT_TRUE(solution.kind() == Solution_kind::CLUSTER || (!root.is_rational() && is_left_open))
        << text_of(root.point) << ": " << solution.kind() << ", " << solution.reason();
}

// The answers and the roots belong together one by one.
static void expect_all_found(const Planted_problem& problem, const Solutions& solutions)
{
  EXPECT_EQ(solutions.size(), problem.roots.size());
  EXPECT_TRUE(solutions.is_complete() || !is_rational(problem)) << solutions.summary();
  for (const Planted_root& root : problem.roots) {
    std::size_t holders = 0;
    for (const Solution& solution : solutions)
      if (meets(solution.exact_box(), root.point)) {
        ++holders;
        expect_found(root, solution);
      }
    EXPECT_EQ(holders, 1u) << text_of(root.point);
  }
  for (const Solution& solution : solutions) {
    const auto box = solution.exact_box();
    EXPECT_EQ(std::count_if(problem.roots.begin(), problem.roots.end(),
                            [&](const Planted_root& root) { return meets(box, root.point); }),
              1);
    EXPECT_EQ(verify(problem.system, solution), solution.kind() != Solution_kind::UNDECIDED) << solution.kind();
  }
  expect_consistent_regions(solutions);
}

// What was planted and how much of it was decided.
struct Counts
{
  int simple = 0, multiple = 0, high = 0, irrational = 0, on_faces = 0, on_breaks = 0, undecided = 0;

  void add(const Planted_problem& problem, const Solutions& solutions)
  {
    std::vector<System::Domain> domain;
    for (int j = 0; j < problem.system.dimension(); ++j)
      domain.push_back(problem.system.domain(j));
    for (const Planted_root& root : problem.roots) {
      ++(root.multiplicity == 1 ? simple : multiple);
      high += root.multiplicity > 4;
      irrational += root.multiplicity > 1 && !root.is_rational();
      on_faces += root.multiplicity > 1 && count_faces(domain, root.point) > 0;
      on_breaks += root.multiplicity > 1 && root.is_on_break;
      if (root.is_rational() && !root.is_on_break)
        for (const Solution& solution : solutions)
          if (meets(solution.exact_box(), root.point)) {
            undecided += solution.multiplicity() == 0;
            EXPECT_TRUE(solution.multiplicity() != 0 || root.multiplicity > 8)
                << text_of(root.point) << " of multiplicity " << root.multiplicity;
          }
    }
  }
};

static void run(int dimension)
{
  constexpr int count = 125, highest_contact = 2;
  const int every_irrational = dimension == 1 ? 12 : 30 * dimension;   // these take the most time
  Planted_multiple_roots systems(static_cast<std::uint64_t>(2000 + dimension), highest_contact);
  Counts counts;
  for (int test = 0; test < count; ++test) {
    const Planted_problem problem = systems.make(dimension, test % every_irrational == 0);
    SCOPED_TRACE(std::to_string(dimension) + " unknowns, system " + std::to_string(test) + ", " + problem.name);
    const Solutions solutions = SC::solve(problem.system);
    expect_all_found(problem, solutions);
    counts.add(problem, solutions);
    if (testing::Test::HasFailure())
      break;
  }
  EXPECT_GT(counts.simple, 8);
  EXPECT_GT(counts.multiple, 120);
  EXPECT_TRUE(dimension > 2 || counts.irrational > 3);
  EXPECT_GT(counts.on_faces, 15);
  EXPECT_GT(counts.on_breaks, 3);
  EXPECT_GT(counts.high, 5);
  EXPECT_LT(20 * counts.undecided, counts.multiple);
}

TEST(Planted_multiple_roots, OneUnknown) { run(1); }
TEST(Planted_multiple_roots, TwoUnknowns) { run(2); }
TEST(Planted_multiple_roots, ThreeUnknowns) { run(3); }
TEST(Planted_multiple_roots, FourUnknowns) { run(4); }

// Curves that touch to a high order are not told apart over long stretches in double. The answers may be many, but no
// root is lost, and none of them is wrong.
TEST(Planted_multiple_roots, HighContact)
{
  constexpr int count = 100, highest_contact = 9;
  Planted_multiple_roots systems(3000, highest_contact);
  int high = 0, incomplete = 0;
  for (int test = 0; test < count; ++test) {
    const Planted_problem problem = systems.make(2, false);
    SCOPED_TRACE("system " + std::to_string(test) + ", " + problem.name);
    const Solutions solutions = SC::solve(problem.system, {.node_limit = 20000});
    expect_nothing_lost(points_of(problem), solutions);
    expect_consistent_regions(solutions);
    for (const Planted_root& root : problem.roots) {
      high += root.multiplicity > 3;
      for (const Solution& solution : solutions)
        if (meets(solution.exact_box(), root.point))
          expect_right(root, solution);
    }
    for (const Solution& solution : solutions)
      EXPECT_EQ(verify(problem.system, solution), solution.kind() != Solution_kind::UNDECIDED) << solution.kind();
    incomplete += !solutions.is_complete();
  }
  EXPECT_GT(high, 25);
  EXPECT_LT(incomplete, 40);
}

} // namespace planted_multiple_roots_test
