// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The medial axis of a region whose outline is smooth but for rounded coordinates, as it is drawn and with smooth
// joints.
//
//   smooth_joints [DRAWING.svg [MOST_ANGLE]]
//
// Joints with an angle of at most MOST_ANGLE degrees, 2 if none is given, are made smooth. Writes smooth_joints.svg,
// with both axes. Exit status: 0 when all of them is proved, 3 when a part is not, 2 for bad input.
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
    const auto curves = SC::IO::read_SVG_curves<K>(argc > 1 ? argv[1] : DATA_DIRECTORY "guitar.svg");
    const double most_angle = (argc > 2 ? number_of<double>(argv[2]) : 2) * CGAL_PI / 180;
    const auto smooth = SC::with_smooth_joints<K>(curves, most_angle);

    const auto axis = SC::medial_axis(SC::planar_region(curves)),
               smooth_axis = SC::medial_axis(SC::planar_region(smooth.curves));
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
              << " at most; edges: " << axis.edges().size() << ", then " << smooth_axis.edges().size()
              << "; complete: " << (is_complete ? "yes" : "no") << '\n';
    return is_complete ? 0 : 3;
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
