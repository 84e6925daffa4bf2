// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The geometry of a curve of solutions: its tangents and curvature, its turning points and vertices, proved to be all,
// and a B-spline curve next to it. Draws them into curve_geometry.svg.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/spline_fitting.h>
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_extremes.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

void show(SC::SVG_writer& picture, const char* name, const SC::Curve_extremes_d& set, const char* maximum,
          const char* minimum)
{
  for (const auto& [kind, solution] : set.extremes) {
    const std::vector<double> p = solution.point();
    std::cout << name << ' ' << kind << " at (" << p[0] << ", " << p[1] << ")\n";
    picture.point(K::Point_2(p[0], p[1]), kind == SC::Curve_extreme_kind::MAXIMUM ? maximum : minimum, 10);
  }
}

int main()
{
  auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  const std::vector<SC::Constraint> constraints{square(x * x + y * y) - 2 * (x * x - y * y) + x * y / 2 - x / 4 ==
                                                SC::Exact_rational(1, 2)};
  const SC::Constraint_system_d system = make_system(constraints);
  const SC::Curve_solution_set_d set = SC::solve_curves(system);
  const SC::Solution_curve& curve = set.curves().front();

  std::ofstream file("curve_geometry.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-1.8, -1, 1.9, 1.25), 700);
  // a comb: towards the outside where the curve is convex, as long as the curvature
  for (const std::vector<double>& p : SC::to_polyline(system, set, curve, 2e-4)) {
    const std::vector<SC::Exact_rational> towards_center = SC::curve_differentials(system, p)->curvature_vector();
    const K::Point_2 foot(p[0], p[1]),
        tip(p[0] - 0.12 * CGAL::to_double(towards_center[0]), p[1] - 0.12 * CGAL::to_double(towards_center[1]));
    picture.polyline(std::vector<K::Point_2>{foot, tip}, "#9ecae1", 1);
  }
  const SC::Fitted_spline_d spline = SC::fit_spline(system, set, curve, 1e-5);
  picture.curve(spline.curve_2<K>(), "black", 2);
  for (const double t : spline.breaks)
    picture.point(K::Point_2(spline(t)[0], spline(t)[1]), "black", 5);
  std::cout << "a cubic spline with " << spline.breaks.size() - 1 << " pieces passes the curve at " << spline.error
            << '\n';

  const SC::Curve_extremes_d vertices = SC::curvature_extremes(constraints),
                             turning = SC::turning_points(constraints, y);
  show(picture, "curvature", vertices, "#d62728", "#1f77b4");
  show(picture, "y", turning, "#2ca02c", "#ff7f0e");
  picture.label(K::Point_2(-1.75, 1.13),
                "curvature (comb): maxima red, minima blue; where y is greatest green, least orange", "black", 13);
  picture.label(K::Point_2(-1.75, 1.02), "fitted cubic spline with its breaks (small dots)", "black", 13);
  const bool is_complete = set.is_complete() && vertices.summary.is_complete && turning.summary.is_complete;
  std::cout << (is_complete && set.curves().size() == 1 ? "There are no others.\n" : "There may be others.\n");
  return is_complete ? 0 : 1;
}
