// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Square systems with known solutions, in doubles with and without error bounds.

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/own_traits.h>

namespace square_problems_test {

using namespace solver_test;

template <class Policies>
class Square_problems : public testing::Test
{};

using Cone_traits =
    SC::Solver_traits<double, SC::Normal_cone_test, SC::Projected_polyhedron_reduction, SC::Widest_splitter>;
using All_traits = testing::Types<SC::Certified_solver_traits, Cone_traits>;
TYPED_TEST_SUITE(Square_problems, All_traits);

TYPED_TEST(Square_problems, CyclicChebyshev)
{
  for (const auto& [n, degree] :
       {std::pair(1, 7), {2, 2}, {2, 3}, {2, 5}, {2, 8}, {3, 2}, {3, 3}, {3, 4}, {4, 2}, {4, 3}, {5, 2}, {6, 2}})
    check<TypeParam>(cyclic_chebyshev(n, degree));
}

TYPED_TEST(Square_problems, MixedChebyshev)
{
  for (const auto& [n, degree] : {std::pair(2, 2), {2, 3}, {2, 5}, {3, 2}, {3, 3}, {4, 2}})
    check<TypeParam>(mixed_chebyshev(n, degree));
}

TYPED_TEST(Square_problems, PlaneCurves)
{
  check<TypeParam>(circle_and_ellipse());
  check<TypeParam>(curves_of_degree_six());
  check<TypeParam>(bezier_cubics());
  check<TypeParam>(wiggly_beziers());
}

TYPED_TEST(Square_problems, Tangency)
{
  check<TypeParam>(apollonius());
  check<TypeParam>(bitangents());
  check<TypeParam>(tritangent_planes());
  check<TypeParam>(lines_tangent_to_spheres());
}

TYPED_TEST(Square_problems, Equations)
{
  check<TypeParam>(brown(3, 10));
  for (int n = 3; n <= 5; ++n)
    check<TypeParam>(broyden_tridiagonal(n));
  check<TypeParam>(katsura_2());
}

TYPED_TEST(Square_problems, Splines)
{
  for (int degree : {2, 3, 5})
    check<TypeParam>(cyclic_chebyshev_in_pieces(degree));
  check<TypeParam>(zigzag());
}

TEST(Square_problems_certified, Larger)
{
  check<SC::Certified_solver_traits>(mixed_chebyshev(5, 2));
  check<SC::Certified_solver_traits>(cyclic_chebyshev(8, 2));
  check<SC::Certified_solver_traits>(brown(5, 10));
  check<SC::Certified_solver_traits>(brown(5, 100000000));
  for (int n = 6; n <= 10; ++n)
    check<SC::Certified_solver_traits>(broyden_tridiagonal(n));
}

// Without error bounds solutions may be missed, but what is certified is true.
TEST(Square_problems_fast, CertifiedAnswersAreRight)
{
  std::size_t found = 0, wanted = 0;
  for (const Problem& problem : {cyclic_chebyshev(2, 3), cyclic_chebyshev(4, 2), mixed_chebyshev(3, 2), bezier_cubics(),
                                 curves_of_degree_six(), apollonius(), bitangents(), katsura_2(), zigzag()}) {
    SCOPED_TRACE(problem.name);
    const auto solutions = solve_with<SC::Fast_solver_traits>(problem.system);
    wanted += problem.count;
    for (const auto& solution : solutions)
      if (solution.is_certified()) {
        ++found;
        std::size_t held = 0;
        for (const Point& point : problem.known)
          held += meets(solution.box(), point);
        EXPECT_EQ(held, 1u);
        EXPECT_TRUE(verify(problem.system, solution));
      }
    for (const Point& point : problem.known) {
      std::size_t holders = 0;
      for (const auto& solution : solutions)
        holders += solution.is_certified() && meets(solution.box(), point);
      EXPECT_LE(holders, 1u) << text_of(point) << " twice";
    }
  }
  EXPECT_LE(found, wanted);
  EXPECT_GT(2 * found, wanted);
}

} // namespace square_problems_test
