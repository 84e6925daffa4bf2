// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances of points to an implicit curve with a node, with all feet of perpendiculars: thin lines, thick ones to the
// nearest point. The circle around a point shows that the curve is nowhere nearer. For each point the distance to first
// order is printed, too.
//
// Writes implicit_distance.svg. Exit status: 0 when nothing is undecided, else 3.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Implicit_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/distances/implicit_distances.h>
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
  auto [x, y] = SC::unknowns({-2, 3}, {-2, 2});
  const SC::Constraint equation = square(x * x + y * y - 2 * x) == x * x + y * y / 2; // like a limacon
  const SC::Implicit_curve_2 curve(equation);

  std::ofstream file("implicit_distance.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-1.7, -2, 4.3, 2.1), 700);
  const SC::Constraint_system_d system = make_system(std::vector<SC::Constraint>{equation});
  const SC::Curve_solution_set_d solutions = SC::solve_curves(system);
  bool is_complete = solutions.is_complete();
  for (const SC::Solution_curve& part : solutions.curves())
    picture.polyline(SC::to_polyline(system, solutions, part, 1e-3), "#1f77b4", 3);

  for (const K::Point_2& p : {K::Point_2(1.75, 0.5), K::Point_2(3.4, 1.25), K::Point_2(-0.75, -1)}) {
    const auto feet = SC::implicit_feet(p, curve);
    is_complete = is_complete && feet.is_complete();
    for (std::size_t i = feet.feet().size(); i-- > 0;)
      if (feet.feet()[i].is_inside) {
        picture.polyline(std::vector<K::Point_2>{p, feet.feet()[i].point}, i == 0 ? "#d62728" : "#aaa", i == 0 ? 3 : 1);
        picture.point(feet.feet()[i].point, i == 0 ? "#d62728" : "#777", 6);
      }
    picture.point(p, "black", 8);
    if (const auto range = feet.distance_range()) {
      picture.circle(p, range->first, "#e9a0a0", 1.5);
      std::cout << "point (" << p << "): " << feet.feet().size() << " feet, distance in [" << range->first << ", "
                << range->second << "], to first order " << SC::first_order_distance(p, curve).value_or(0) << '\n';
    }
    for (const SC::Undecided_part& part : feet.undecided())
      std::cout << part << '\n';
  }
  return is_complete ? 0 : 3;
}
