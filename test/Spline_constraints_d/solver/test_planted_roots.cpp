// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// 2,000 random systems with known simple roots, some of which are 1e-9 apart.

#include "planted_simple_roots.h"
#include "solver_test_checks.h"

namespace planted_roots_test {

using namespace solver_test;

static void run(int dimension, int count)
{
  Planted_simple_roots systems(static_cast<std::uint64_t>(1000 + dimension));
  std::size_t planted = 0;
  for (int test = 0; test < count; ++test) {
    const Problem problem = systems.make(dimension);
    SCOPED_TRACE(std::to_string(dimension) + " unknowns, system " + std::to_string(test));
    planted += problem.count;
    check<SC::Certified_solver_traits>(problem, {.tolerance = 1e-12});
    if (testing::Test::HasFailure())
      break;
  }
  EXPECT_GT(planted, static_cast<std::size_t>(2 * count));
  EXPECT_GT(systems.on_faces, static_cast<std::size_t>(count / 10));
  EXPECT_TRUE(dimension == 1 || systems.in_corners > static_cast<std::size_t>(count / 20));
  EXPECT_GT(systems.close_pairs, static_cast<std::size_t>(count / 10));
  EXPECT_GT(systems.splines, static_cast<std::size_t>(count / 6));
  EXPECT_GE(systems.highest_degree, dimension > 3 ? 3 : 6);
}

TEST(Planted_roots, OneUnknown) { run(1, 400); }
TEST(Planted_roots, TwoUnknowns) { run(2, 400); }
TEST(Planted_roots, ThreeUnknowns) { run(3, 400); }
TEST(Planted_roots, FourUnknowns) { run(4, 400); }
TEST(Planted_roots, FiveUnknowns) { run(5, 400); }

} // namespace planted_roots_test
