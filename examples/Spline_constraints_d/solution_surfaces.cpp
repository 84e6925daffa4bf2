// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of solutions with their topology by proof: closed surfaces, one that inequalities cut, one in four
// dimensions, and one with a singular point.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <iostream>

namespace SC = CGAL::Spline_constraints;

int main()
{
  const auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const auto quartic = [](const auto& t) { return square(square(t)) - 5 * square(t); };

  const auto tangle_cube = quartic(x) + quartic(y) + quartic(z) + SC::Exact_rational(59) / 5;
  std::cout << "tangle cube: " << SC::solve_surfaces(tangle_cube == 0) << "\n";

  const auto ring = square(x) + square(y);
  const auto torus = square(ring + square(z) + SC::Exact_rational(91) / 100) - 4 * ring;
  std::cout << "half a torus: " << SC::solve_surfaces(torus == 0, x >= 0) << "\n";

  const auto [p, q, r, s] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  std::cout << "Clifford torus: " << SC::solve_surfaces(square(p) + square(q) == 1, square(r) + square(s) == 1) << "\n";

  const SC::Surface_solution_set_d cone = SC::solve_surfaces(square(x) + square(y) == square(z));
  std::cout << "cone: " << cone << "\n";
  for (const SC::Solution_surface& surface : cone.surfaces())
    std::cout << "  a part of genus " << surface.genus() << " with " << surface.boundary.size() << " loops\n";
}
