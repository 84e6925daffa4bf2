// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Hausdorff distances of a B-spline curve and its control polygon, both one-sided ones and the larger of them,
// drawn into distance.svg.
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/hausdorff_distance.h>

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

void write_curve(std::ostream& out, const Curve& curve, const char* style)
{
  constexpr int steps = 240;
  const auto [begin, end] = curve.domain();
  out << "<polyline class='" << style << "' points='";
  for (int i = 0; i <= steps; ++i) {
    const K::Point_2 p = curve(begin + (end - begin) * i / steps);
    out << x_of(p) << ',' << y_of(p) << ' ';
  }
  out << "'/>\n";
}

// The far point and the nearest one on the other curve, with the circle around it that the other curve does not enter.
void write_distance(std::ostream& out, const SC::Hausdorff_distance<K, 2>& distance, const char* style)
{
  const K::Point_2 &far = distance.point(distance.curve()), &near = distance.point(1 - distance.curve());
  out << "<circle class='" << style << " disk' cx='" << x_of(far) << "' cy='" << y_of(far) << "' r='"
      << scale * distance.distance_range().first << "'/>\n"
      << "<line class='" << style << "' x1='" << x_of(far) << "' y1='" << y_of(far) << "' x2='" << x_of(near)
      << "' y2='" << y_of(near) << "'/>\n"
      << "<circle class='" << style << " point' cx='" << x_of(far) << "' cy='" << y_of(far) << "' r='4'/>\n";
}

int main()
{
  const std::vector<K::Point_2> points{{0, 0}, {1, 3}, {4, 3}, {5, 0}, {7, -1}, {9, 1}, {8, 3}};
  const Curve curve(3, {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}, points), polygon = SC::polyline_curve(points);

  const auto of_curve = SC::one_sided_hausdorff_distance(curve, polygon),
             of_polygon = SC::one_sided_hausdorff_distance(polygon, curve),
             both = SC::hausdorff_distance(curve, polygon);
  std::cout.precision(9);
  const auto print = [](const char* what, const auto& distance) {
    std::cout << what << " between " << distance.distance_range().first << " and " << distance.distance_range().second
              << '\n';
  };
  print("largest distance of a point of the curve from the polygon", of_curve);
  print("largest distance of a point of the polygon from the curve", of_polygon);
  print("Hausdorff distance", both);

  std::ofstream out("distance.svg");
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-40 -290 660 380' width='660' "
         "height='380'>\n<style>polyline { fill: none; stroke-width: 2 } .curve { stroke: #1f77b4 } .polygon { stroke: "
         "#777 }"
         " .first { stroke: #2ca02c; stroke-width: 2 } .second { stroke: #d62728; stroke-width: 2 } .disk { fill: "
         "none; stroke-width: 1; stroke-dasharray: 4 3 } circle.first.point { fill: #2ca02c } circle.second.point { "
         "fill: #d62728 }"
         " text { font: 13px sans-serif } text.first { fill: #2ca02c; stroke: none } text.second { fill: #d62728; "
         "stroke: none }</style>\n<rect x='-40' y='-290' width='660' height='380' fill='white'/>\n";
  write_curve(out, polygon, "polygon");
  write_curve(out, curve, "curve");
  write_distance(out, of_curve, "first");
  write_distance(out, of_polygon, "second");
  out << "<text class='first' x='-25' y='-268'>the point of the curve that is farthest from the polygon: "
      << of_curve.distance_range().first << "</text>\n"
      << "<text class='second' x='-25' y='-248'>the point of the polygon that is farthest from the curve: "
      << of_polygon.distance_range().first << "</text>\n</svg>\n";

  const auto width = [](const auto& distance) {
    return distance.distance_range().second - distance.distance_range().first;
  };
  const bool agrees = both.curve() == 1 &&
      both.squared_distance_range().first <= of_polygon.squared_distance_range().second &&
      of_polygon.squared_distance_range().first <= both.squared_distance_range().second;
  return agrees && width(of_curve) < 1.1e-6 && width(of_polygon) < 1.1e-6 && width(both) < 1.1e-6 ? 0 : 1;
}
