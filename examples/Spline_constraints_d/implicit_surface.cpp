// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles of implicit surfaces, all components of them: the tangle cube as a CGAL::Polynomial, and a torus with a
// ball in its middle that is too small to be found by rays. Writes the tangle cube with its properties, and a picture.

#include "surface_output.h"

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/implicit_surface_mesh.h>

#include <CGAL/CORE_BigInt.h>
#include <CGAL/Polynomial.h>
#include <CGAL/Polynomial_type_generator.h>
#include <CGAL/boost/graph/helpers.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;

int main()
{
  using Polynomial = CGAL::Polynomial_type_generator<int, 3>::Type;
  const auto variable = [](int i) { return CGAL::shift(Polynomial(1), 1, i); };
  Polynomial tangle_cube(59);
  for (int i = 0; i < 3; ++i) {
    const Polynomial square = variable(i) * variable(i);
    tangle_cube += 5 * square * square - 25 * square;
  }
  const SC::Solution_surface_mesh tangle =
      SC::to_surface_mesh(tangle_cube, {{{-3, 3}, {-3, 3}, {-3, 3}}}, {.chord_error = 0.04});
  std::cout << "tangle cube: " << tangle.mesh.number_of_vertices() << " vertices, " << tangle.mesh.number_of_faces()
            << " triangles, " << (CGAL::is_closed(tangle.mesh) ? "closed" : "not closed")
            << ", complete: " << (tangle.is_complete() ? "yes" : "no") << '\n';
  std::ofstream file("tangle_cube.vtp");
  SC::IO::write_VTP(file, tangle);
  std::ofstream picture("implicit_surface.svg");
  draw_surfaces(picture, tangle);

  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto ring = square(x) + square(y);
  const auto torus = square(ring + square(z) + SC::Exact_rational(91) / 100) - 4 * ring;
  const auto ball = ring + square(z) - SC::Exact_rational(1) / 1000000;
  const SC::Implicit_surface_3 both(torus * ball == 0);
  std::cout << "torus and a ball of radius 1/1000: " << SC::solve_surfaces(both) << '\n';
}
