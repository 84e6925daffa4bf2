// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is seen from a point between the curves of a drawing, in a frame.
//
//   visible_part [DRAWING.svg X Y]
//
// Writes visible_part.svg. Exit status: 0 when all is proved, 3 when a part is not, 2 for bad input.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_2;

int main(int argc, char* argv[])
{
  try {
    auto curves = SC::IO::read_SVG_curves<K>(argc > 1 ? argv[1] : DATA_DIRECTORY "drawing.svg");
    CGAL::Bbox_2 box;
    for (const auto& curve : curves)
      box += curve.bbox();
    const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()), margin = size / 20;
    const Point low(box.xmin() - margin, box.ymin() - margin), high(box.xmax() + margin, box.ymax() + margin);
    curves.push_back(SC::polyline_curve(std::vector<Point>{low, {high.x(), low.y()}, high, {low.x(), high.y()}, low}));
    const Point viewpoint = argc > 3 ? Point(number_of<double>(argv[2]), number_of<double>(argv[3])) : Point(5, -30);
    const auto visible = SC::visible_part(viewpoint, curves);

    std::ofstream file("visible_part.svg");
    SC::SVG_writer picture(file, low.bbox() + high.bbox(), 600);
    SC::draw(picture, visible, 5);
    picture.layer("curves");
    for (const auto& curve : curves)
      picture.curve(curve, "black", 2);
    picture.layer("viewpoint");
    picture.point(viewpoint, "black", 9);
    std::size_t arcs = 0, segments = 0;
    for (const auto& edge : visible.edges())
      ++(edge.kind == SC::Visible_edge_kind::ARC ? arcs : segments);

    std::cout << curves.size() << " curves; seen are " << arcs << " arcs, with " << segments
              << " segments of rays between them";
    if (visible.is_complete()) {
      const auto [lower, upper] = visible.area();
      std::cout << ", area " << SC::to_nearest_double(lower) << " (bounds differ by "
                << SC::to_nearest_double(SC::Exact_rational(upper - lower)) << ')';
    }
    std::cout << "; complete: " << (visible.is_complete() ? "yes" : "no") << '\n';
    return visible.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
