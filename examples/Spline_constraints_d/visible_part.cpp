// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is seen from a point between the curves of a drawing, in a frame.
//
//   visible_part [DRAWING.svg X Y] [--time-limit S]
//
// Writes visible_part.svg. Exit status: 0 when all is proved, 3 when a part is not, 2 for bad input.
#include "arguments.h"
#include "printed_numbers.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Point = K::Point_2;

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options options;
    const auto arguments = arguments_and_time_limit(argc, argv, options);
    auto curves = SC::IO::read_SVG_curves<K>(arguments.empty() ? DATA_DIRECTORY "drawing.svg" : arguments[0]);
    CGAL::Bbox_2 box;
    for (const auto& curve : curves)
      box += curve.bbox();
    const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()), margin = size / 20;
    const Point low(box.xmin() - margin, box.ymin() - margin), high(box.xmax() + margin, box.ymax() + margin);
    curves.push_back(SC::polyline_curve(std::vector<Point>{low, {high.x(), low.y()}, high, {low.x(), high.y()}, low}));
    const Point viewpoint =
        arguments.size() > 2 ? Point(number_of<double>(arguments[1]), number_of<double>(arguments[2])) : Point(5, -30);
    const auto visible = SC::visible_part(viewpoint, curves, options);

    std::ofstream file("visible_part.svg");
    SC::SVG_writer picture(file, low.bbox() + high.bbox(), 600);
    if (!visible.edges().empty())
      SC::draw(picture, visible, 5);
    picture.layer("curves");
    for (const auto& curve : curves)
      picture.curve(curve, "black", 2);
    picture.layer("viewpoint");
    picture.point(viewpoint, "black", 9);
    std::map<SC::Visible_edge_kind, std::size_t> count;
    for (const auto& edge : visible.edges())
      ++count[edge.kind];

    for (const auto& part : visible.undecided())
      std::cout << part << '\n';
    std::cout << curves.size() << " curves; seen are " << (visible.is_complete() ? "" : "at least ")
              << count[SC::Visible_edge_kind::ARC] << " arcs, with " << count[SC::Visible_edge_kind::SEGMENT]
              << " segments of rays between them";
    if (visible.is_complete())
      std::cout << ", area " << number_within(visible.area()) << " (" << difference_of(visible.area()) << ')';
    else
      std::cout << ", area unknown, " << visible.undecided().size() << " undecided parts";
    std::cout << "; complete: " << (visible.is_complete() ? "yes" : "no") << '\n';
    return visible.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
