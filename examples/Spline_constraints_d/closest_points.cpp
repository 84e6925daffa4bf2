// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All feet of the perpendiculars from three points to an ellipse, and the closest points of two cubic curves, in exact numbers; drawn into closest_points.svg.
#include <CGAL/Spline_constraints_d/geometry/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/closest_points.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;

constexpr double scale = 60;

double x_of(const K::Point_2& p) { return scale * CGAL::to_double(p.x()); }
double y_of(const K::Point_2& p) { return -scale * CGAL::to_double(p.y()); }

void write_curve(std::ostream& out, const Curve& curve)
{
  constexpr int steps = 120;
  const auto [begin, end] = curve.domain();
  out << "<polyline points='";
  for (int i = 0; i <= steps; ++i) {
    const K::Point_2 p = curve(begin + (end - begin) * i / steps);
    out << x_of(p) << ',' << y_of(p) << ' ';
  }
  out << "'/>\n";
}

void write_segment(std::ostream& out, const K::Point_2& p, const K::Point_2& q, const char* style)
{
  out << "<line class='" << style << "' x1='" << x_of(p) << "' y1='" << y_of(p) << "' x2='" << x_of(q) << "' y2='" << y_of(q) << "'/>\n";
}

void write_point(std::ostream& out, const K::Point_2& p, const char* style)
{
  out << "<circle class='" << style << "' cx='" << x_of(p) << "' cy='" << y_of(p) << "' r='4'/>\n";
}

int main()
{
  const Curve ellipse = SC::ellipse_curve(K::Point_2(0, 0), K::Vector_2(3, 0), K::Vector_2(0, 2));
  const std::vector<K::Point_2> points{{K::FT(1) / 2, K::FT(1) / 4}, {-3, 2}, {K::FT(5) / 2, -2}};
  const Curve first = SC::bezier_curve(std::vector<K::Point_2>{{4, 2}, {5, -3}, {6, 5}, {8, -1}}), second = SC::bezier_curve(std::vector<K::Point_2>{{5, -2}, {6, 2}, {8, -5}, {9, 1}});

  std::ofstream out("closest_points.svg");
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-215 -175 775 345' width='775' height='345'>\n<style>polyline { fill: none; stroke: #1f77b4; stroke-width: 2 }"
         " .foot { stroke: #999; stroke-width: 1.2; stroke-dasharray: 4 3 } .closest { stroke: #d62728; stroke-width: 2.5 } circle.foot { fill: #666; stroke: none } circle.closest { fill: #d62728; stroke: none }"
         " circle.point { fill: #2ca02c; stroke: none } text { font: 12px sans-serif; fill: #223 }</style>\n<rect x='-215' y='-175' width='775' height='345' fill='white'/>\n";
  for (const Curve& curve : {ellipse, first, second})
    write_curve(out, curve);

  std::vector<std::size_t> counts;
  bool is_complete = true;
  for (const K::Point_2& point : points) {
    const auto projections = SC::projections(point, ellipse);   // the nearest first
    is_complete = is_complete && projections.summary.is_complete;
    counts.push_back(projections.feet.size());
    for (std::size_t i = 0; i < projections.feet.size(); ++i) {
      const char* style = i == 0 ? "closest" : "foot";
      write_segment(out, point, projections.feet[i].point(1), style);
      write_point(out, projections.feet[i].point(1), style);
    }
    write_point(out, point, "point");
    std::cout << "(" << point << ") has " << counts.back() << " feet, the nearest at the parameter " << projections.feet.front().parameter(1) << '\n';
  }

  const auto closest = SC::closest_points(first, second);
  for (const auto& pair : closest) {
    write_segment(out, pair.point(0), pair.point(1), "closest");
    write_point(out, pair.point(0), "closest");
    write_point(out, pair.point(1), "closest");
  }
  const auto [lower, upper] = closest.distance_range();
  out << "<text x='-205' y='-158'>feet of the perpendiculars from three points</text>\n<text x='240' y='-158'>closest points of two curves, distance " << lower << "</text>\n</svg>\n";
  std::cout.precision(17);
  std::cout << "distance of the cubic curves between " << lower << " and " << upper << (closest.is_unique() ? ", attained once\n" : "\n");
  return is_complete && counts == std::vector<std::size_t>{4, 2, 2} && closest.is_unique() && upper - lower < 1e-12 ? 0 : 1;
}
