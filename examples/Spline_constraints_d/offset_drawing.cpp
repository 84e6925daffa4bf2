// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed offsets of the curves of a drawing, at growing distances: where points are exactly so far from all curves.
//
//   offset_drawing [DRAWING.svg [DISTANCE [NUMBER]]] [--time-limit S]
//
// Writes offset_drawing.svg, with the offsets at NUMBER multiples of DISTANCE in graded colors. Exit status: 0 when all
// of them are proved, 3 when a part is not, as after S seconds for one of them; 2 for bad input.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

namespace SC = CGAL::Spline_constraints;
// of drawings: decimals are read exactly, and what is symmetric stays so
using K = CGAL::Simple_cartesian<SC::Exact_rational>;

// From dark blue over red to yellow.
std::string color(double share)
{
  const auto part = [](double x) {
    return static_cast<unsigned>(std::lround(225 * (std::min)(1.0, (std::max)(0.0, x))));
  };
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", part(0.1 + 1.4 * share),
                part(0.25 + 2 * std::abs(share - 0.35) * (share > 0.35)), part(0.9 - 1.8 * share));
  return text;
}

void report(double distance, const SC::Trimmed_offset_2<K>& offset)
{
  std::cout << "distance " << distance << ": ";
  const auto closed = std::count_if(offset.boundaries().begin(), offset.boundaries().end(),
                                    [](const auto& boundary) { return boundary.is_closed; });
  const auto holes = std::count_if(offset.boundaries().begin(), offset.boundaries().end(),
                                   [](const auto& boundary) { return boundary.is_hole; });
  if (offset.is_complete())
    std::cout << "arcs: " << offset.arcs().size() << "; components: " << closed - holes << "; holes: " << holes
              << "; complete: yes\n";
  else   // what is not closed may belong together, or to anything else
    std::cout << "closed boundaries: at least " << closed << "; arcs, components and holes: unknown; "
              << offset.undecided().size() << " undecided; complete: no\n";
}

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options options;
    const auto words = arguments_and_time_limit(argc, argv, options);
    const auto curves = SC::IO::read_SVG_curves<K>(words.empty() ? DATA_DIRECTORY "garden.svg" : words[0]);
    const double distance = words.size() > 1 ? number_of<double>(words[1]) : 2.1;
    const int number = words.size() > 2 ? number_of<int>(words[2]) : 6;

    CGAL::Bbox_2 box;
    for (const auto& curve : curves)
      box += curve.bbox();
    const double margin = 1.1 * distance * number;
    std::ofstream file("offset_drawing.svg");
    SC::SVG_writer picture(
        file, CGAL::Bbox_2(box.xmin() - margin, box.ymin() - margin, box.xmax() + margin, box.ymax() + margin), 700);
    bool is_complete = true;
    for (int i = number; i > 0; --i) {
      const auto offset = SC::trimmed_offset(curves, i * distance, {}, options);
      options = after(offset.summary().seconds, options);
      picture.layer("offset " + std::to_string(i));
      for (std::size_t arc = 0; arc < offset.arcs().size(); ++arc)
        picture.polyline(offset.polyline(arc, picture.pixel() / 8), color(static_cast<double>(i) / number), 2);
      report(i * distance, offset);
      is_complete = is_complete && offset.is_complete();
    }
    picture.layer("curves");
    for (const auto& curve : curves)
      picture.curve(curve, "black", 3);
    return is_complete ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
