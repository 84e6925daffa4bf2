// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Square systems with known solutions, in exact rationals.

#include "solver_test_checks.h"

namespace square_problems_exact_test {

using namespace solver_test;
using Traits = SC::Exact_solver_traits;

TEST(Square_problems_exact, Chebyshev)
{
  for (const auto& [n, degree] : {std::pair(1, 7), {2, 2}, {2, 3}, {2, 5}, {3, 2}, {3, 3}, {4, 2}})
    check<Traits>(cyclic_chebyshev(n, degree));
  for (const auto& [n, degree] : {std::pair(2, 2), {2, 3}, {3, 2}})
    check<Traits>(mixed_chebyshev(n, degree));
}

TEST(Square_problems_exact, PlaneCurves)
{
  check<Traits>(circle_and_ellipse());
  check<Traits>(curves_of_degree_six());
  check<Traits>(bezier_cubics());
  check<Traits>(wiggly_beziers());
}

TEST(Square_problems_exact, Tangency)
{
  check<Traits>(apollonius());
  check<Traits>(bitangents());
  check<Traits>(tritangent_planes());
  check<Traits>(lines_tangent_to_spheres());
}

TEST(Square_problems_exact, Equations)
{
  check<Traits>(brown(3, 10));
  check<Traits>(brown(5, 10));
  for (int n = 3; n <= 6; ++n)
    check<Traits>(broyden_tridiagonal(n));
  check<Traits>(katsura_2());
}

TEST(Square_problems_exact, Splines)
{
  for (int degree : {2, 3, 5})
    check<Traits>(cyclic_chebyshev_in_pieces(degree));
  check<Traits>(zigzag());
}

} // namespace square_problems_exact_test
