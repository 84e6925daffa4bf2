// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Square systems with known solutions, in doubles with and without error bounds.

#include "solver_test_checks.h"

using namespace solver_test;

template <class Traits>
class Square_problems : public testing::Test
{};

using All_traits = testing::Types<SC::Certified_solver_traits, SC::Fast_solver_traits>;
TYPED_TEST_SUITE(Square_problems, All_traits);

TYPED_TEST(Square_problems, CyclicChebyshev)
{
  for (const auto& [n, degree] : {std::pair(1, 7), {2, 2}, {2, 3}, {2, 5}, {2, 8}, {3, 2}, {3, 3}, {3, 4}, {4, 2}, {4, 3}, {5, 2}, {6, 2}})
    check<TypeParam>(cyclic_chebyshev(n, degree));
}

TYPED_TEST(Square_problems, MixedChebyshev)
{
  for (const auto& [n, degree] : {std::pair(2, 2), {2, 3}, {2, 5}, {3, 2}, {3, 3}, {4, 2}, {5, 2}})
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
  check<TypeParam>(brown(5, 10));
  for (int n = 3; n <= 8; ++n)
    check<TypeParam>(broyden_tridiagonal(n));
  check<TypeParam>(katsura_2());
}

TYPED_TEST(Square_problems, Splines)
{
  for (int degree : {2, 3, 5})
    check<TypeParam>(cyclic_chebyshev_in_pieces(degree));
  check<TypeParam>(zigzag());
}
