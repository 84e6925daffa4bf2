// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Singular points of six planar curves, with a proof of how many branches end in each: cusps, a triple point, circles
// that touch. Drawn into singular_points.svg.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Point = CGAL::Simple_cartesian<double>::Point_2;

struct Curve
{
  std::string name;
  SC::Constraint equation;
  std::size_t arcs, singular_points;   // what there should be
};

// Draws the arcs between singular points and the boundary of the domain in different colours, around a centre.
void draw(SC::SVG_writer& picture, const Curve& curve, const SC::Constraint_system_d& system,
          const SC::Curve_solution_set_d& set, double u, double v)
{
  const char* const colors[] = {"#1f77b4", "#2ca02c", "#ff7f0e", "#9467bd"};
  for (std::size_t c = 0; c < set.curves().size(); ++c) {
    std::vector<std::array<double, 2>> points;
    for (const std::vector<double>& p : to_polyline(system, set, set.curves()[c], 1e-3))
      points.push_back({u + p[0], v + p[1]});
    picture.polyline(points, colors[c % 4], 2.5);
  }
  for (const std::size_t i : set.singular_points())
    picture.point(Point(u + set.vertices()[i].point()[0], v + set.vertices()[i].point()[1]), "#d62728", 9);
  picture.label(Point(u - 1.1, v - 1.45), curve.name, "black", 15);
}

int main()
{
  auto [x, y] = SC::unknowns({-1.25, 1.125}, {-1.125, 1.25});
  const SC::Expression square_of_distance = x*x + y*y;
  const std::vector<Curve> curves{
      {"trifolium: 6 branches", square(square_of_distance) == x * (x * x - 3 * y * y), 3, 1},
      {"quadrifolium: 8 branches", square_of_distance * square_of_distance * square_of_distance == 4 * x * x * y * y, 4,
       1},
      {"three circles: 6 branches",
       (square_of_distance - x) * (square_of_distance - x / 2) * (square_of_distance + x) == 0, 3, 1},
      {"astroid: 4 cusps",
       (square_of_distance - 1) * (square_of_distance - 1) * (square_of_distance - 1) + 27 * x * x * y * y == 0, 4, 4},
      {"bicuspid: 2 cusps", 4 * (x * x - 1) * square(x - 1) + square(4 * y * y - 1) == 0, 2, 2},
      {"ramphoid cusp: 2 branches", square(y - square(x + 1)) == (x + 1) * square(square(x + 1)), 2, 1}};
  std::ofstream file("singular_points.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-1.4, -4.4, 6.6, 1.2), 800);
  bool is_right = true;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const SC::Constraint_system_d system = SC::make_system(std::vector<SC::Constraint>{curves[i].equation});
    const SC::Curve_solution_set_d set = SC::solve_curves(system);
    draw(picture, curves[i], system, set, 2.7*static_cast<double>(i % 3), -2.8*static_cast<double>(i / 3));
    std::cout << curves[i].name << "; " << set << '\n';
    is_right = is_right && set.is_complete() && set.number_of_open_curves() == curves[i].arcs &&
        set.singular_points().size() == curves[i].singular_points;
  }
  return is_right ? 0 : 1;
}
