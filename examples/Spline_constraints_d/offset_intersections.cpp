// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The offset of a curve, with its cusps and where it meets itself and an implicit curve, drawn into offset_intersections.svg.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/Implicit_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/locus_intersections.h>
#include <CGAL/Spline_constraints_d/operations/offset_features_2.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;

// Rounded to 1/1024, for a drawing.
K::Point_2 rounded(double x, double y) { return {std::round(1024 * x) / 1024, std::round(1024 * y) / 1024}; }

void draw(SC::SVG_writer& svg, const std::string& what, const SC::Locus_intersections<2>& answers, const std::string& color)
{
  for (const auto& answer : answers) {
    std::cout << what << ": " << answer.kind() << " at parameter " << answer.parameter(0) << ", (" << answer.coordinate(0) << ", " << answer.coordinate(1) << ")\n";
    svg.point(rounded(answer.coordinate(0), answer.coordinate(1)), color, 10);
  }
}

int main()
{
  const auto curve = SC::bezier_curve(std::vector<K::Point_2>{{-3, 3}, {-2, -5}, {0, 6}, {2, -5}, {3, 3}});
  const SC::Offset_curve_2 offset(curve, 1);   // to the left
  auto [x, y] = SC::unknowns({-4, 4}, {-1, 4});
  const SC::Implicit_curve_2 lemniscate(square(x*x + y*y/4) == 6*x*x - y*y);

  const auto cusps = SC::cusps(offset);
  const auto nodes = SC::self_intersections(offset);
  const auto crossings = SC::intersections(offset, lemniscate);

  std::ofstream out("offset_intersections.svg");
  SC::SVG_writer svg(out, CGAL::Bbox_2(-4, -1.5, 4, 4));
  for (int i = 0; i <= 400; ++i) {   // the implicit curve, by its points on lines in two directions
    const K::FT s = K::FT(i) / 50 - 4;
    for (const auto& line : {SC::segment_curve(K::Point_2(s, -1), K::Point_2(s, 4)), SC::segment_curve(K::Point_2(-4, s), K::Point_2(4, s))})
      for (const auto& point : SC::intersections(line, lemniscate))
        svg.point(rounded(point.coordinate(0), point.coordinate(1)), "#2ca02c", 1.5);
  }
  std::vector<K::Point_2> points;
  for (int i = 0; i <= 600; ++i) {
    const auto p = offset(K::FT(i) / 600);
    points.push_back(rounded(p[0], p[1]));
  }
  svg.curve(curve, "black", 2.5);
  svg.curve(SC::polyline_curve(points), "#1f77b4", 1.5);
  draw(svg, "cusp", cusps, "#ff7f0e");
  draw(svg, "self-intersection", nodes, "#9467bd");
  draw(svg, "on the lemniscate", crossings, "#d62728");
  std::cout << "offset: " << cusps.summary() << "\nitself: " << nodes.summary() << "\nlemniscate: " << crossings.summary() << '\n';
  return cusps.is_complete() && nodes.is_complete() && crossings.is_complete() && !nodes.empty() && !crossings.empty() ? 0 : 1;
}
