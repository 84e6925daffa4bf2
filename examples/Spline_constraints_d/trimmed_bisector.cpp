// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The trimmed bisector of two planar curves: all points that are as far from the nearest point of one as from that of the other.
//
//   trimmed_bisector
//
// Writes trimmed_bisector.svg, with the trimmed bisector (red), the untrimmed one (gray), and some of the empty disks around its points that touch both curves (blue). Exit status: 0 when all of the bisector is proved, 3 when a part is not.
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/trimmed_bisectors_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main()
{
  const auto a = SC::bezier_curve(std::vector<K::Point_2>{{-3, 3}, {-1, -5}, {1, 5}, {3, -1}});
  const auto b = SC::bezier_curve(std::vector<K::Point_2>{{-3, -3}, {0, -1}, {1, -5}, {4, -3}});
  std::ofstream file("trimmed_bisector.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-6, -4.5, 6, 4), 700);

  const auto untrimmed = SC::bisector_curves(a, b);
  picture.layer("untrimmed");
  for (const auto& curve : untrimmed.curves())
    picture.polyline(untrimmed.polyline(curve, 0.005, 15), "#cccccc", 2);

  const auto bisector = SC::trimmed_bisector(a, b);
  picture.layer("disks");
  const auto& sites = bisector.diagram().sites();
  for (const auto& chain : bisector.chains()) {
    std::cout << "chain of " << chain.arcs.size() << " arcs:";
    for (const auto& arc : chain.arcs) {
      const auto& edge = bisector.diagram().edges()[arc.edge];
      const auto kind = [&](std::size_t side) { return sites[edge.sites[arc.is_reversed ? 1 - side : side]].is_point ? "end" : "curve"; };
      std::cout << ' ' << kind(0) << '/' << kind(1);
    }
    std::cout << '\n';
    for (const auto& polyline : bisector.polylines(chain, 0.001, 15))
      for (std::size_t i = 4; i < polyline.size(); i += 8)
        if (polyline[i].radius < 3)
          picture.circle(polyline[i].point, polyline[i].radius, "#9ecae1", 1);
  }
  SC::draw(picture, bisector, 3);
  picture.layer("curves");
  picture.curve(a, "black", 4);
  picture.curve(b, "black", 4);
  std::cout << "complete: " << (bisector.is_complete() ? "yes" : "no") << '\n';
  return bisector.is_complete() ? 0 : 3;
}
