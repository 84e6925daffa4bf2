// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Voronoi diagram of the curves of a drawing: which of them is nearest.
//
//   voronoi_diagram [DRAWING.svg]
//
// Writes voronoi_diagram.svg, with the cells of each curve in one color. Exit status: 0 when all of the diagram is proved, 3 when a part is not, 2 for bad input.
#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi_diagrams_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main(int argc, char* argv[])
{
  try {
    std::vector<SC::Bspline_curve_2<K>> curves;
    for (const auto& element : SC::IO::read_SVG<K>(argc > 1 ? argv[1] : DATA_DIRECTORY "garden.svg"))
      curves.push_back(element.curve);
    const auto diagram = SC::voronoi_diagram(curves);

    CGAL::Bbox_2 box = curves.front().bbox();
    for (const auto& curve : curves)
      box += curve.bbox();
    const double size = (std::max)(box.xmax() - box.xmin(), box.ymax() - box.ymin()), margin = size / 30;
    std::ofstream file("voronoi_diagram.svg");
    SC::SVG_writer picture(file, CGAL::Bbox_2(box.xmin() - margin, box.ymin() - margin, box.xmax() + margin, box.ymax() + margin), 700);
    const char* const colors[] = {"#eeeeee", "#aec7e8", "#ffbb78", "#98df8a", "#ff9896", "#c5b0d5", "#f7d7a0"};
    std::vector<std::vector<K::Point_2>> edges;
    picture.layer("cells");
    for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
      const auto samples = diagram.polyline(e, size / 2000, size);
      edges.emplace_back();
      for (const auto& sample : samples)
        edges.back().push_back(sample.point);
      for (std::size_t side = 0; side < 2; ++side) {   // a cell consists of what lies between its edges and the feet of their points
        const auto& site = diagram.sites()[diagram.edges()[e].sites[side]];
        std::vector<K::Point_2> cell = edges.back();
        for (auto sample = samples.rbegin(); sample != samples.rend(); ++sample)
          cell.push_back(site.is_point ? site.point : curves[site.curve](sample->parameters[side]));
        if (!samples.empty())
          picture.polygon(cell, colors[site.curve % 7]);
      }
    }
    picture.layer("edges");
    for (const auto& edge : edges)
      if (edge.size() > 1)
        picture.curve(SC::polyline_curve(edge), "#d62728", 1.5);
    picture.layer("sites");
    for (const auto& curve : curves)
      picture.curve(curve, "black", 3);

    picture.layer("vertices");
    std::size_t branching = 0;
    for (const auto& vertex : diagram.vertices())
      if (!vertex.is_at_infinity && vertex.edges.size() > 2) {
        ++branching;
        picture.point(vertex.point, "#d62728", 6);
      }
    std::cout << "sites: " << diagram.sites().size() << "; edges: " << diagram.edges().size() << "; vertices: " << diagram.vertices().size() << ", " << branching << " of degree three or more; regions: " << diagram.number_of_regions()
              << "; complete: " << (diagram.is_complete() ? "yes" : "no") << '\n';
    return diagram.is_complete() ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
