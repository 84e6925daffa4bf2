// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// 102 random systems with known simple roots: one certified answer for each root with every number type that tracks its
// rounding. Doubles that do not may lose roots, those on faces first of all, but what they certify is true.

#include "planted_simple_roots.h"
#include "solver_test_checks.h"

namespace all_traits_test {

using namespace solver_test;

constexpr int number_of_systems = 102;

static Problem next(Planted_simple_roots& systems, int test) { return systems.make(1 + test % 3); }

static Planted_simple_roots make_systems() { return Planted_simple_roots(4000, fraction(1, 1000)); }

template <class Traits>
class Tracking_traits : public testing::Test
{};

using Four_traits = testing::Types<SC::Certified_solver_traits, SC::Interval_solver_traits,
                                   SC::Multiprecision_solver_traits, SC::Exact_solver_traits>;
TYPED_TEST_SUITE(Tracking_traits, Four_traits);

TYPED_TEST(Tracking_traits, CertifyTheSameRoots)
{
  Planted_simple_roots systems = make_systems();
  std::size_t planted = 0;
  for (int test = 0; test < number_of_systems; ++test) {
    const Problem problem = next(systems, test);
    SCOPED_TRACE("system " + std::to_string(test));
    planted += problem.count;
    check<TypeParam>(problem);
    if (testing::Test::HasFailure())
      break;
  }
  EXPECT_GT(planted, 300u);
}

TEST(Fast_traits, CertifyNothingElse)
{
  Planted_simple_roots systems = make_systems();
  int complete = 0;
  for (int test = 0; test < number_of_systems; ++test) {
    const Problem problem = next(systems, test);
    SCOPED_TRACE("system " + std::to_string(test));
    const auto solutions = solve_with<SC::Fast_solver_traits>(problem.system);
    std::size_t found = 0;
    for (const auto& solution : solutions)
      if (solution.is_certified()) {
        ++found;
        EXPECT_TRUE(verify(problem.system, solution));
        const auto box = solution.exact_box();
        EXPECT_EQ(std::count_if(problem.known.begin(), problem.known.end(),
                                [&](const Point& point) { return meets(box, point); }),
                  1);
      }
    expect_consistent_regions(solutions);
    complete += found == problem.count;
  }
  EXPECT_GT(complete, 70);
}

} // namespace all_traits_test
