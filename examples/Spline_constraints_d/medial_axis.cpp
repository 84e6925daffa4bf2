// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The medial axis of the region between the closed curves of a drawing.
//
//   medial_axis [DRAWING.svg] [--time-limit S]
//
// Writes medial_axis.svg, with the axis and some of the disks around its points that touch the boundary twice. Exit
// status: 0 when all of the axis is proved, 3 when a part is not, as after S seconds; 2 for bad input.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
// of drawings: decimals are read exactly, and what is symmetric stays so
using K = CGAL::Simple_cartesian<SC::Exact_rational>;

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options options;
    const auto files = arguments_and_time_limit(argc, argv, options);
    const auto curves = SC::IO::read_SVG_curves<K>(files.empty() ? DATA_DIRECTORY "letters.svg" : files[0]);
    const auto axis = SC::medial_axis(SC::planar_region(curves), options);

    std::ofstream file("medial_axis.svg");
    SC::SVG_writer picture(file, curves);
    picture.layer("disks");
    for (std::size_t e = 0; e < axis.edges().size(); ++e) {
      auto last = *axis.vertices()[axis.edges()[e].vertices[0]].point;
      for (const auto& sample : axis.polyline(e, picture.pixel() / 8))
        if (CGAL::squared_distance(sample.point, last) > CGAL::square(picture.extent() / 20) && sample.radius > 0) {
          picture.circle(sample.point, sample.radius, "#9ecae1", 1);
          last = sample.point;
        }
    }
    SC::draw(picture, axis);
    picture.layer("curves");
    for (const auto& curve : curves)
      picture.curve(curve, "black", 3);

    // others may be parts of one edge
    const auto edges = std::count_if(axis.edges().begin(), axis.edges().end(), [&](const auto& edge) {
      return axis.vertices()[edge.vertices[0]].is_resolved && axis.vertices()[edge.vertices[1]].is_resolved;
    });
    const auto proved = std::count_if(axis.vertices().begin(), axis.vertices().end(),
                                      [](const auto& vertex) { return vertex.is_resolved; });
    const auto branching = std::count_if(axis.vertices().begin(), axis.vertices().end(), [](const auto& vertex) {
      return vertex.is_resolved && vertex.edges.size() > 2;
    });
    const char* const least = axis.is_complete() ? "" : "at least ";
    if (!axis.sites().empty())
      std::cout << "boundaries: " << axis.number_of_regions() << "; ";
    std::cout << "edges: " << least << edges << "; vertices: " << least << proved << ", " << least
              << branching << " of degree three or more; ";
    if (!axis.is_complete())
      std::cout << axis.undecided().size() << " undecided; ";
    std::cout << "complete: " << (axis.is_complete() ? "yes" : "no") << '\n';
    return axis.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
