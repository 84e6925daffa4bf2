// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The self-bisector of a closed curve, untrimmed: the centers of all circles that touch it twice. It ends in the
// centers of curvature at the vertices of the curve.
//
// Writes self_bisector.svg. Exit status: 0 when nothing is undecided, 3 when something is, 2 for bad input.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/operations/loci/self_bisector_curves_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Curve = SC::Bspline_curve_2<K>;

int main()
{
  try {
    const Curve curve =
        Curve::from_periodic(3, {0, 1, 2, 3, 4, 5, 6}, {{8, 1}, {1, 2}, {-4, 7}, {-3, 0}, {-5, -6}, {2, -2}});
    const auto bisector = SC::self_bisector_curves(curve);
    std::cout << bisector << '\n';

    std::ofstream file("self_bisector.svg");
    SC::SVG_writer picture(file, CGAL::Bbox_2(-6, -6, 7, 6), 700);
    std::vector<K::Point_2> ends;
    for (const auto& part : bisector.curves()) {
      const auto samples = bisector.polyline(part, 5e-3, 20);
      for (const auto* sample : {&samples.front(), &samples.back()})
        if (sample->parameters[0] == sample->parameters[1])
          ends.push_back(sample->point);
      picture.polyline(samples, "#d62728", 2);
    }
    picture.curve(curve, "black", 4);
    for (const K::Point_2& end : ends)
      picture.point(end, "#1f77b4", 9);
    return bisector.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
