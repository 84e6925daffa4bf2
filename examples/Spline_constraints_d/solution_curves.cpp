// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of solutions with a proved topology: T4(x) T4(y) = 1/2 in the square, 5 closed curves and 8 open ones, drawn
// into solution_curves.svg; a circle of radius 0.0005 that nobody pointed at; and a sphere that meets a cylinder in two
// loops.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main()
{
  auto [x, y] = SC::unknowns({-1, 1}, {-1, 1});
  const auto t4 = [](const SC::Expression& t) { return 8*square(square(t)) - 8*square(t) + 1; };
  const std::vector<SC::Constraint> constraints{t4(x)*t4(y) == SC::Exact_rational(1, 2)};
  const SC::Constraint_system_d system = make_system(constraints);
  const SC::Curve_solution_set_d contours = SC::solve_curves(system);

  std::ofstream file("solution_curves.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-1.15, -1.15, 1.15, 1.3), 600);
  picture.polyline(std::vector<K::Point_2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, "#99a", 1);
  for (const SC::Solution_curve& curve : contours.curves())
    picture.polyline(SC::to_polyline(system, contours, curve, 1e-3), curve.is_closed ? "#2ca02c" : "#1f77b4", 2);
  for (const SC::Curve_vertex& vertex : contours.vertices())
    picture.point(K::Point_2(vertex.point()[0], vertex.point()[1]), vertex.is_on_boundary ? "#d62728" : "#777",
                  vertex.is_on_boundary ? 7 : 4);
  picture.label(K::Point_2(-1.1, 1.18), "T4(x) T4(y) = 1/2: 5 closed curves (green), 8 open ones with 16 ends (red)",
                "black", 15);
  std::cout << contours << '\n';

  const auto loop = SC::solve_curves(square(x - SC::Exact_rational(1, 3)) + square(y + SC::Exact_rational(2, 7)) ==
                                     SC::Exact_rational(1, 4000000));
  std::cout << loop << '\n';

  auto [u, v, w] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const auto loops = SC::solve_curves(u*u + v*v + w*w == 4, square(u - SC::Exact_rational(1, 2)) + v*v == 1);
  std::cout << loops << '\n';
  const bool is_right = contours.number_of_closed_curves() == 5 && contours.number_of_open_curves() == 8 &&
      loop.number_of_closed_curves() == 1 && loops.number_of_closed_curves() == 2;
  return is_right && contours.is_complete() && loop.is_complete() && loops.is_complete() ? 0 : 1;
}
