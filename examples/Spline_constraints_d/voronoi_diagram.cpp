// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Voronoi diagram of the curves of a drawing: which of them is nearest.
//
//   voronoi_diagram [DRAWING.svg]
//
// Writes voronoi_diagram.svg, with the cells of each curve in one color. Exit status: 0 when all of the diagram is
// proved, 3 when a part is not, 2 for bad input.
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
    const auto curves = SC::IO::read_SVG_curves<K>(argc > 1 ? argv[1] : DATA_DIRECTORY "garden.svg");
    const auto diagram = SC::voronoi_diagram(curves);

    std::ofstream file("voronoi_diagram.svg");
    SC::IO::write_SVG(file, curves, diagram);

    const auto branching = std::count_if(diagram.vertices().begin(), diagram.vertices().end(), [](const auto& vertex) {
      return !vertex.is_at_infinity && vertex.edges.size() > 2;
    });
    std::cout << "sites: " << diagram.sites().size() << "; edges: " << diagram.edges().size()
              << "; vertices: " << diagram.vertices().size() << ", " << branching
              << " of degree three or more; regions: " << diagram.number_of_regions()
              << "; complete: " << (diagram.is_complete() ? "yes" : "no") << '\n';
    return diagram.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
