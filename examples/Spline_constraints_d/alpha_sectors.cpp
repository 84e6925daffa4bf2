// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Alpha-sectors of two curves A and B, untrimmed: the points whose distances from the curves, along normals of both,
// have the ratio alpha : 1 - alpha. They lead from one curve (blue) over the bisector to the other one (red).
//
// Writes alpha_sectors.svg. Exit status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/loci/alpha_sectors_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main()
{
  try {
    const auto a = SC::bezier_curve(std::vector<K::Point_2>{{-4, 3}, {-1, 1}, {1, 5}, {4, 2}}),
               b = SC::bezier_curve(std::vector<K::Point_2>{{-4, -2}, {-1, -4}, {2, -1}, {4, -3}});
    std::ofstream file("alpha_sectors.svg");
    SC::SVG_writer picture(file, CGAL::Bbox_2(-5, -4.5, 5, 4.5), 700);
    const char* const colours[] = {"#08306b", "#2171b5", "#6baed6", "#333333", "#fc9272", "#de2d26", "#67000d"};
    bool is_complete = true;
    for (int k = 1; k < 8; ++k) {
      const auto sectors = SC::alpha_sectors(a, b, k / 8.0);
      for (const auto& curve : sectors.curves())
        picture.polyline(sectors.polyline(curve, 5e-3, 10), colours[k - 1], 2);
      std::cout << "alpha = " << k << "/8  " << sectors << '\n';
      is_complete = is_complete && sectors.is_complete();
    }
    picture.curve(a, "black", 4);
    picture.curve(b, "black", 4);
    return is_complete ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
