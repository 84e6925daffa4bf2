// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed alpha-sectors of two planar curves A and B: all points whose distances from the nearest points of both have
// the ratio alpha : 1 - alpha. They lead from A (blue) over the bisector (gray) to B (red).
//
//   trimmed_alpha_sectors
//
// Writes trimmed_alpha_sectors.svg. Exit status: 0 when everything is proved, 3 when a part is not.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main()
{
  const auto a = SC::bezier_curve(std::vector<K::Point_2>{{-4, 3}, {-1, -4}, {1, 8}, {4, 1}});
  const auto b = SC::bezier_curve(std::vector<K::Point_2>{{-4, -2}, {0, -5}, {1, 1}, {3, -3}});
  std::ofstream file("trimmed_alpha_sectors.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-9, -8, 11, 8), 700);
  const char* const colours[] = {"#08306b", "#2171b5", "#6baed6", "", "#fc9272", "#de2d26", "#67000d"};
  bool is_complete = true;

  for (const int k : {1, 2, 3, 5, 6, 7}) {
    const auto sector = SC::trimmed_alpha_sector(a, b, k / 8.0);
    picture.layer("alpha = " + std::to_string(k) + "/8");
    for (const auto& chain : sector.chains()) {
      for (const std::size_t arc : chain.arcs)
        picture.polyline(sector.polyline(arc, 0.005), colours[k - 1], 2);
      std::cout << "alpha = " << k << "/8: " << (sector.is_complete() ? "" : "at least ") << chain.arcs.size()
                << " arcs" << (chain.is_closed ? ", closed\n" : "\n");
    }
    is_complete = is_complete && sector.is_complete();
  }

  const auto bisector = SC::trimmed_bisector(a, b);
  picture.layer("bisector");
  for (const auto& chain : bisector.chains())
    for (const auto& polyline : bisector.polylines(chain, 0.005, 15))
      picture.polyline(polyline, "#999999", 2);
  picture.layer("curves");
  picture.curve(a, "black", 4);
  picture.curve(b, "black", 4);
  return is_complete && bisector.is_complete() ? 0 : 3;
}
