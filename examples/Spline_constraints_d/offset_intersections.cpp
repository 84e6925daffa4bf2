// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The offset of a curve, with its cusps and where it meets itself and an implicit curve, drawn into
// offset_intersections.svg.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Implicit_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_arcs_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_features_2.h>
#include <CGAL/Spline_constraints_d/operations/intersections/locus_intersections.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;

void draw(SC::SVG_writer& svg, const std::string& what, const SC::Locus_intersections<2>& answers,
          const std::string& color)
{
  for (const auto& answer : answers) {
    std::cout << what << ": " << answer.kind() << " at parameter " << answer.parameter(0) << ", ("
              << answer.coordinate(0).value() << ", " << answer.coordinate(1).value() << ")\n";
    svg.point(K::Point_2(answer.coordinate(0).value(), answer.coordinate(1).value()), color, 10);
  }
}

int main()
{
  const auto curve = SC::bezier_curve(std::vector<K::Point_2>{{-3, 3}, {-2, -5}, {0, 6}, {2, -5}, {3, 3}});
  const SC::Offset_curve_2 offset(curve, K::FT(7) / 4);   // to the left
  auto [x, y] = SC::unknowns({-4, 4}, {-1, 4});
  const auto squared_height = square(y - 1.5);
  const SC::Implicit_curve_2 lemniscate(square(x*x + squared_height) == 6 * (x*x - squared_height));

  const SC::Offset_arcs_2 offset_arcs = SC::offset_arcs(offset, 1e-3);
  const auto& arcs = offset_arcs.arcs();
  const auto& cusps = offset_arcs.cusps();
  const auto nodes = SC::self_intersections(offset);
  const auto crossings = SC::intersections(offset, lemniscate);

  std::ofstream out("offset_intersections.svg");
  SC::SVG_writer svg(out, CGAL::Bbox_2(-4, -0.5, 4, 3.5));
  const K::Point_2 center(0, 1.5);
  for (const int side : {-1, 1}) {   // a loop of the lemniscate, by its points on rays from its center
    std::vector<std::array<double, 2>> loop;
    for (int i = -60; i <= 60; ++i) {
      const auto on_ray =
          SC::intersections(SC::segment_curve(center, center + K::Vector_2(4 * side, K::FT(4 * i) / 60)), lemniscate);
      const auto outermost = std::max_element(
          on_ray.begin(), on_ray.end(), [](const auto& a, const auto& b) { return a.parameter(0) < b.parameter(0); });
      loop.push_back({outermost->coordinate(0).value(), outermost->coordinate(1).value()});
    }
    svg.polyline(loop, "#2ca02c", 2);
  }
  svg.curve(curve, "black", 2.5);
  for (const SC::Offset_arc_2& arc : arcs)
    svg.polyline(arc.samples, "#1f77b4");
  svg.label(K::Point_2(K::FT(-39) / 10, 3), "curve");
  svg.label(K::Point_2(K::FT(-6) / 5, 3), "offset", "#1f77b4");
  svg.label(K::Point_2(K::FT(-39) / 10, K::FT(3) / 2), "lemniscate", "#2ca02c");
  draw(svg, "cusp", cusps, "#ff7f0e");
  draw(svg, "self-intersection", nodes, "#9467bd");
  draw(svg, "on the lemniscate", crossings, "#d62728");
  std::cout << "offset: " << cusps.summary() << "\nitself: " << nodes.summary()
            << "\nlemniscate: " << crossings.summary() << '\n';
  return cusps.is_complete() && nodes.is_complete() && crossings.is_complete() && !nodes.empty() && !crossings.empty()
      ? 0
      : 1;
}
