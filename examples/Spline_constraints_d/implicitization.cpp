// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The equations of curves and surfaces. Thick lines are splines, thin ones all zeros of their equations.
//
// Writes implicitization.svg. Exit status: 0 when everything is found, else 3.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/implicitization.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Curve = SC::Bspline_curve_2<K>;

int main()
{
  const std::array<std::string, 3> names{"x", "y", "z"};
  std::ofstream file("implicitization.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-4.5, -2.5, 4.5, 2.5), 800);
  bool is_complete = true;
  const std::vector<Curve> curves{
      Curve(2, {0, 0, 0, 1, 1, 1}, {{-4, 2}, {-3, -2}, {-2, 2}}),
      Curve(3, {0, 0, 0, 0, 1, 1, 1, 1}, {{-1, -1}, {2, 2}, {-2, 2}, {1, -1}}),
      Curve(4, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, {{2, -1}, {4, 3}, {3, -4}, {2, 3}, {4, -1}})};
  for (const Curve& curve : curves) {
    const auto found = SC::implicitization(curve);
    if (!found.equation()) {
      is_complete = false;
      continue;
    }
    const SC::Power_polynomial& f = found.equation()->polynomial();
    std::cout << "degree " << found.least_degree() << ": " << f.to_string(names) << " = 0\n";
    SC::Constraint_system_d system({{found.equation()->box()[0].first - 1, found.equation()->box()[0].second + 1},
                                    {-SC::Exact_rational(5) / 2, SC::Exact_rational(5) / 2}});
    system.add(f, SC::Relation::EQUAL);
    const auto zeros = SC::solve_curves(system);
    is_complete = is_complete && zeros.is_complete();
    for (const SC::Solution_curve& part : zeros.curves())
      picture.polyline(SC::to_polyline(system, zeros, part, 1e-3), "#888", 1.2);
    picture.curve(curve, "#1f77b4", 4);
  }
  const auto torus = SC::implicitization(SC::torus_surface<K>(K::Point_3(0, 0, 0), 2, 1));
  is_complete = is_complete && torus.equation();
  if (torus.equation())
    std::cout << "torus: " << torus.equation()->polynomial().to_string(names) << " = 0\n";
  return is_complete ? 0 : 3;
}
