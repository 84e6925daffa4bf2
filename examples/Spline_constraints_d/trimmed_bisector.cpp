// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The trimmed bisector of two curves of a drawing: all points that are as far from the nearest point of one as from
// that of the other.
//
//   trimmed_bisector [DRAWING.svg [CURVE OTHER_CURVE]] [--time-limit S]
//
// Curves are named by their numbers, in the order of the drawing. Writes trimmed_bisector.svg, with the trimmed
// bisector (red), the untrimmed one (gray), and some of the empty disks around its points that touch both curves
// (blue). Exit status: 0 when all of the bisector is proved, 3 when a part is not, as after S seconds; 2 for bad input.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <fstream>
#include <iostream>
#include <string>

namespace SC = CGAL::Spline_constraints;
// of drawings: decimals are read exactly, and what is symmetric stays so
using K = CGAL::Simple_cartesian<SC::Exact_rational>;

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options options;
    const auto words = arguments_and_time_limit(argc, argv, options);
    const auto curves = SC::IO::read_SVG_curves<K>(words.empty() ? DATA_DIRECTORY "waves.svg" : words[0]);
    const std::size_t first = words.size() > 2 ? number_of<std::size_t>(words[1]) : 0,
                      second = words.size() > 2 ? number_of<std::size_t>(words[2]) : 1;
    if (std::max(first, second) >= curves.size())
      throw SC::Invalid_input("the drawing has no more than " + std::to_string(curves.size()) + " curves");
    const auto &a = curves[first], &b = curves[second];
    std::ofstream file("trimmed_bisector.svg");
    const CGAL::Bbox_2 box = a.bbox() + b.bbox();
    const double margin = (box.xmax() - box.xmin() + box.ymax() - box.ymin()) / 12;
    SC::SVG_writer picture(
        file, CGAL::Bbox_2(box.xmin() - margin, box.ymin() - margin, box.xmax() + margin, box.ymax() + margin), 700);

    const auto untrimmed = SC::bisector_curves(a, b);
    picture.layer("untrimmed");
    for (const auto& curve : untrimmed.curves())
      picture.polyline(untrimmed.polyline(curve, margin / 1000, 20 * margin), "#cccccc", 2);

    const auto bisector = SC::trimmed_bisector(a, b, options);
    picture.layer("disks");
    const auto& sites = bisector.diagram().sites();
    for (const auto& chain : bisector.chains()) {
      std::cout << (bisector.is_complete() ? "chain of " : "part of a chain, ") << chain.arcs.size() << " arcs:";
      for (const auto& arc : chain.arcs) {
        const auto& edge = bisector.diagram().edges()[arc.edge];
        const auto kind = [&](std::size_t side) {
          return sites[edge.sites[arc.is_reversed ? 1 - side : side]].is_point ? "end" : "curve";
        };
        std::cout << ' ' << kind(0) << '/' << kind(1);
      }
      std::cout << '\n';
      for (const auto& polyline : bisector.polylines(chain, margin / 1000, 20 * margin))
        for (std::size_t i = 4; i < polyline.size(); i += 8)
          if (polyline[i].radius < 3 * margin)
            picture.circle(polyline[i].point, polyline[i].radius, "#9ecae1", 1);
    }
    SC::draw(picture, bisector, 3);
    picture.layer("curves");
    picture.curve(a, "black", 4);
    picture.curve(b, "black", 4);
    if (!bisector.is_complete())
      std::cout << bisector.undecided().size() << " undecided; ";
    std::cout << "complete: " << (bisector.is_complete() ? "yes" : "no") << '\n';
    return bisector.is_complete() ? 0 : 3;
  } catch (const std::exception& error) {   // also for what is no number
    std::cerr << error.what() << '\n';
    return 2;
  }
}
