// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Voronoi diagram of the curves of a drawing: which of them is nearest.
//
//   voronoi_diagram [DRAWING.svg] [--time-limit S]
//
// Writes voronoi_diagram.svg, with the cells of each curve in one color. Exit status: 0 when all of the diagram is
// proved, 3 when a part is not, as after S seconds; 2 for bad input.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG_voronoi_diagram_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

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
    const auto curves = SC::IO::read_SVG_curves<K>(files.empty() ? DATA_DIRECTORY "garden.svg" : files[0]);
    const auto diagram = SC::voronoi_diagram(curves, {}, options);

    std::ofstream file("voronoi_diagram.svg");
    SC::IO::write_SVG(file, curves, diagram);

    // others may be parts of one edge
    const auto edges = std::count_if(diagram.edges().begin(), diagram.edges().end(), [&](const auto& edge) {
      return diagram.vertices()[edge.vertices[0]].is_resolved && diagram.vertices()[edge.vertices[1]].is_resolved;
    });
    const auto proved = std::count_if(diagram.vertices().begin(), diagram.vertices().end(),
                                      [](const auto& vertex) { return vertex.is_resolved; });
    const auto branching = std::count_if(diagram.vertices().begin(), diagram.vertices().end(), [](const auto& vertex) {
      return vertex.is_resolved && !vertex.is_at_infinity && vertex.edges.size() > 2;
    });
    const char* const least = diagram.is_complete() ? "" : "at least ";
    if (!diagram.sites().empty())
      std::cout << "sites: " << diagram.sites().size() << "; ";
    std::cout << "edges: " << least << edges << "; vertices: " << least << proved << ", " << least
              << branching << " of degree three or more; ";
    if (diagram.is_complete())
      std::cout << "regions: " << diagram.number_of_regions();
    else
      std::cout << diagram.undecided().size() << " undecided";
    std::cout << "; complete: " << (diagram.is_complete() ? "yes" : "no") << '\n';
    return diagram.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
