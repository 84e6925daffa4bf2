// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The convex hull of the curves of a drawing: arcs of curves, and segments that touch them.
//
//   convex_hull [DRAWING.svg]
//
// Writes convex_hull.svg. Exit status: 0 when all of the boundary is proved, 3 when a part is not, 2 for bad input.
#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main(int argc, char* argv[])
{
  try {
    const auto curves = SC::IO::read_SVG_curves<K>(argc > 1 ? argv[1] : DATA_DIRECTORY "drawing.svg");
    const auto hull = SC::convex_hull(curves);

    std::ofstream file("convex_hull.svg");
    SC::SVG_writer picture(file, curves);
    SC::draw(picture, hull, 4);
    picture.layer("curves");
    for (const auto& curve : curves)
      picture.curve(curve, "black", 2);
    picture.layer("vertices");
    for (const auto& edge : hull.edges())
      picture.point(hull.point(edge.source), "black", 8);
    std::size_t arcs = 0, segments = 0;
    for (const auto& edge : hull.edges())
      ++(edge.kind == SC::Hull_edge_kind::ARC ? arcs : segments);

    std::cout << curves.size() << " curves; hull of " << arcs << " arcs and " << segments << " segments";
    if (hull.is_complete()) {
      const auto [lower, upper] = hull.area();
      std::cout << ", area " << SC::to_nearest_double(lower) << " (bounds differ by "
                << SC::to_nearest_double(SC::Exact_rational(upper - lower)) << ')';
    }
    std::cout << "; complete: " << (hull.is_complete() ? "yes" : "no") << '\n';
    return hull.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
