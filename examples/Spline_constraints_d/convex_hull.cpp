// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The convex hull of the curves of a drawing: arcs of curves, and segments that touch them.
//
//   convex_hull [DRAWING.svg] [--time-limit S]
//
// Writes convex_hull.svg. Exit status: 0 when all of the boundary is proved, 3 when a part is not, 2 for bad input.
#include "arguments.h"
#include "printed_numbers.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <map>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options options;
    const auto arguments = arguments_and_time_limit(argc, argv, options);
    const auto curves = SC::IO::read_SVG_curves<K>(arguments.empty() ? DATA_DIRECTORY "drawing.svg" : arguments[0]);
    const auto hull = SC::convex_hull(curves, {}, options);

    std::ofstream file("convex_hull.svg");
    SC::SVG_writer picture(file, curves);
    if (!hull.edges().empty())
      SC::draw(picture, hull, 4);
    picture.layer("curves");
    for (const auto& curve : curves)
      picture.curve(curve, "black", 2);
    picture.layer("vertices");
    for (const auto& edge : hull.edges())
      picture.point(hull.point(edge.source), "black", 8);
    std::map<SC::Hull_edge_kind, std::size_t> count;
    for (const auto& edge : hull.edges())
      ++count[edge.kind];

    for (const auto& part : hull.undecided())
      std::cout << part << '\n';
    std::cout << curves.size() << " curves; hull of " << (hull.is_complete() ? "" : "at least ")
              << count[SC::Hull_edge_kind::ARC] << " arcs and " << count[SC::Hull_edge_kind::SEGMENT] << " segments";
    if (hull.is_complete())
      std::cout << ", area " << number_within(hull.area()) << " (" << difference_of(hull.area()) << ')';
    else
      std::cout << ", area unknown, " << hull.undecided().size() << " undecided parts";
    std::cout << "; complete: " << (hull.is_complete() ? "yes" : "no") << '\n';
    return hull.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
