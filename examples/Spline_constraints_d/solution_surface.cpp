// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All positions of a linkage of five bars in the plane, one of which is fixed: four equations in six unknowns, whose
// solutions are a surface. Its genus depends on the lengths of the bars; with equal ones it is 4. Draws the surface
// with the place of the middle joint as a map, and the difference of the heights of the other two upwards.

#include "surface_output.h"

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;

int main()
{
  const auto [ax, ay, bx, by, cx, cy] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3}, {-3, 3}, {-3, 3}, {-3, 3});
  const auto squared_length = [](const SC::Expression& x, const SC::Expression& y) { return square(x) + square(y); };
  for (const int bar : {1, 2}) { // length of the first moving bar, in halves of the others
    const SC::Exact_rational length = SC::Exact_rational(bar) / 2;
    const SC::Surface_solution_set_d positions =
        SC::solve_surfaces(squared_length(ax, ay) == length * length, squared_length(bx - ax, by - ay) == 1,
                           squared_length(cx - bx, cy - by) == 1, squared_length(cx - 1, cy) == 1);
    std::cout << "first bar " << length << ": " << positions << '\n';
    for (const SC::Solution_surface& surface : positions.surfaces())
      std::cout << "  genus " << surface.genus() << '\n';
    if (bar == 1)
      continue;
    const SC::Solution_surface_mesh mesh =
        SC::to_surface_mesh(positions, SC::Vector_expression<3>(bx, by, ay - cy), {.chord_error = 0.1});
    std::cout << "  " << mesh.mesh.number_of_vertices() << " vertices, " << mesh.mesh.number_of_faces()
              << " triangles\n";
    std::ofstream picture("solution_surface.svg");
    draw_surfaces(picture, mesh, {.most_splits = 8000}); // it crosses itself
  }
}
