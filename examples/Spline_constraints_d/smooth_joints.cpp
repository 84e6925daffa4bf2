// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The medial axis of a region whose outline is smooth but for rounded coordinates, as it is drawn and with smooth
// joints.
//
//   smooth_joints [DRAWING.svg [MOST_ANGLE]] [--time-limit S]
//
// Joints with an angle of at most MOST_ANGLE degrees, 2 if none is given, are made smooth. Writes smooth_joints.svg,
// with both axes, for which the time limit is. Exit status: 0 when all of them is proved, 3 when a part is not, 2 for
// bad input.
#include "arguments.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>
#include <CGAL/Spline_constraints_d/IO/write_planar_layers_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/smooth_joints.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;

int main(int argc, char* argv[])
{
  try {
    SC::Solver_options options;
    const auto words = arguments_and_time_limit(argc, argv, options);
    const auto curves = SC::IO::read_SVG_curves<K>(words.empty() ? DATA_DIRECTORY "guitar.svg" : words[0]);
    const double most_angle = (words.size() > 1 ? number_of<double>(words[1]) : 2) * CGAL_PI / 180;
    const auto smooth = SC::with_smooth_joints<K>(curves, most_angle);

    const auto axis = SC::medial_axis(SC::planar_region(curves), options);
    const auto smooth_axis =
        SC::medial_axis(SC::planar_region(smooth.curves), after(axis.summary().seconds, options));
    std::ofstream file("smooth_joints.svg");
    SC::SVG_writer picture(file, curves);
    auto layers = SC::planar_layers(axis, picture.pixel() / 8, picture.extent());
    for (auto& layer : layers)
      layer.color = "#9ecae1";
    SC::draw(picture, layers, 6);
    SC::draw(picture, smooth_axis);
    picture.layer("curves");
    for (const auto& curve : curves)
      picture.curve(curve, "black", 3);

    const bool is_complete = axis.is_complete() && smooth_axis.is_complete();
    std::cout << "joints made smooth: " << smooth.joints << ", by " << smooth.displacement
              << " at most; ";
    if (is_complete)
      std::cout << "edges: " << axis.edges().size() << ", then " << smooth_axis.edges().size() << "; complete: yes\n";
    else
      std::cout << "edges: unknown; " << axis.undecided().size() + smooth_axis.undecided().size()
                << " undecided; complete: no\n";
    return is_complete ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
