// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces with singular points: a cone, a cubic with four nodes, two spheres that touch. Each point is proved, with
// the disks that end in it; the singular line of Whitney's umbrella is one undecided region.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>

namespace SC = CGAL::Spline_constraints;

static void print(const char* name, const SC::Surface_solution_set_d& set)
{
  std::cout << name << ": " << set << "\n";
  for (const std::size_t i : set.singular_points()) {
    const auto ends_there = [i](const SC::Surface_patch& patch) { return patch.apex == i; };
    std::cout << "  disks that end in (";
    for (const double x : set.vertices()[i].point())
      std::cout << " " << std::round(1e6 * x) / 1e6;
    std::cout << " ): " << std::count_if(set.patches().begin(), set.patches().end(), ends_there) << "\n";
  }
}

int main()
{
  const auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const auto sphere = [&](int center) { return square(x - center) + square(y) + square(z) - 1; };
  print("cone", SC::solve_surfaces(square(x) + square(y) == square(z)));
  print("cubic of Cayley", SC::solve_surfaces(square(x) + square(y) - square(x) * z + square(y) * z + square(z) == 1));
  print("spheres", SC::solve_surfaces(sphere(-1) * sphere(1) == 0));
  print("umbrella", SC::solve_surfaces(square(x) == square(y) * z));
}
