// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Voronoi diagram of a drawing whose curves nearly meet, as it is drawn and where they meet exactly.
//
//   exact_joints [DRAWING.svg [MOST_DISTANCE [MOST_ANGLE]]] [--time-limit S]
//
// Ends that are at most MOST_DISTANCE away from another curve, 0.5 if none is given, are moved onto it, with its
// tangent if the angle is at most MOST_ANGLE degrees, 3 if none is given. Writes exact_joints.svg, with both diagrams.
// Exit status: 0 when all of them is proved, 3 when a part is not, 2 for bad input.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/operations/joints/exact_joints_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options options;
    const auto arguments = arguments_and_time_limit(argc, argv, options);
    const auto curves = SC::IO::read_SVG_curves<K>(arguments.empty() ? DATA_DIRECTORY "walls.svg" : arguments[0]);
    const double most_distance = arguments.size() > 1 ? number_of<double>(arguments[1]) : 0.5,
                 most_angle = (arguments.size() > 2 ? number_of<double>(arguments[2]) : 3) * CGAL_PI / 180;
    const auto joined = SC::with_exact_joints<K>(curves, most_distance, most_angle, options);
    if (!joined.is_complete()) {
      std::cout << joined.undecided().front() << "\njoints: undecided; complete: no\n";
      return 3;
    }

    options = after(joined.summary().seconds, options);
    const auto drawn = SC::voronoi_diagram(curves, {}, options);
    const auto exact = SC::voronoi_diagram(joined.curves, {}, after(drawn.summary().seconds, options));
    std::ofstream file("exact_joints.svg");
    SC::SVG_writer picture(file, curves);
    auto layers = SC::planar_layers(drawn, picture.pixel() / 8, picture.extent());
    for (auto& layer : layers)
      layer.color = "#9ecae1";
    SC::draw(picture, layers, 6);
    SC::draw(picture, exact);
    picture.layer("curves");
    for (const auto& curve : joined.curves)
      picture.curve(curve, "black", 3);

    const bool is_complete = drawn.is_complete() && exact.is_complete();
    std::cout << "joints: " << joined.joints << ", and " << joined.left << " left, by " << joined.displacement
              << " at most; connected sets of curves: ";
    if (is_complete)
      std::cout << drawn.number_of_regions() << ", then " << exact.number_of_regions() << "; complete: yes\n";
    else
      std::cout << "unknown; " << drawn.undecided().size() + exact.undecided().size() << " undecided; complete: no\n";
    return is_complete ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
