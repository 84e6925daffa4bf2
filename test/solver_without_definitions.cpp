// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Does not compile with the compiled library: it has no solver with these traits, and own_traits.h is not included.
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>

namespace SC = CGAL::Spline_constraints;

int main()
{
  auto [x, y] = SC::unknowns({-1, 1}, {-1, 1});
  const std::array constraints{x * x == y, x == y * y};
  const SC::Subdivision_solver_d<SC::Solver_traits<double, SC::Graph_box_test, SC::No_reduction>> solver;
  return solver(SC::make_system(constraints)).size() == 2 ? 0 : 1;
}
