// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bisector of a curve and a surface, up to a radius: curve_surface_bisector CURVE SURFACE RADIUS [--trim], files of
// .g2 or .itd; it is written into curve_surface_bisector.vtp, with --trim where no point of curve or surface is nearer
// than the feet. Without arguments that of a cubic curve above a saddle; it is
// drawn into curve_surface_bisector.svg between both. Exit status: 0, or 3 when something is undecided.
#include "envelope_output.h"

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/curve_surface_bisector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/trimmed_surface_bisectors.h>

#include <exception>
#include <fstream>
#include <string>

namespace SC = CGAL::Spline_constraints;

int own_example()
{
  const Surface_operand saddle(
      {2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1},
      {{-3, -3, 0}, {-3, 0, 1}, {-3, 3, 0}, {0, -3, -1}, {0, 0, 0}, {0, 3, -1}, {3, -3, 0}, {3, 0, 1}, {3, 3, 0}});
  const Curve_operand cubic(3, {0, 0, 0, 0, 1, 1, 1, 1}, {{-2, -2, 2.5}, {0, 2, 3}, {0, -2, 2}, {2, 2, 2.5}});
  const auto bisector = SC::curve_surface_bisector(cubic, saddle, 3.);
  SC::Scene_3 scene({.to_viewer = {-0.35, -0.9, 0.35}, .most_splits = 20000});
  scene.add(grid_on(saddle), {.color = CGAL::IO::Color(215, 215, 215)});
  add_envelope(scene, bisector.mesh({.chord_error = 0.03, .angle = 10}));
  std::vector<Kernel_of_operands::Point_3> points;
  for (int i = 0; i <= 64; ++i)
    points.push_back(cubic(i / 64.));
  scene.add_polyline(points, {.color = "#c00020", .width = 3, .hidden = SC::Hidden_line::THIN});
  std::ofstream picture("curve_surface_bisector.svg");
  scene.write(picture);
  return print_envelope(bisector);
}

int main(int argc, char** argv)
try {
  if (argc == 1)
    return own_example();
  const bool is_trimmed = argc == 5 && std::string(argv[4]) == "--trim";
  if (argc != 4 && !is_trimmed)
    throw SC::Invalid_input("usage: curve_surface_bisector CURVE SURFACE RADIUS [--trim]");
  const auto curve = curve_in(argv[1]);
  const auto surface = surface_in(argv[2]);
  const double radius = std::stod(argv[3]);
  if (is_trimmed) {
    const auto trimmed = SC::trimmed_curve_surface_bisector(curve, surface, radius);
    const auto mesh = trimmed.mesh();
    SC::IO::write_surface_mesh("curve_surface_bisector.vtp", mesh);
    return print_trimmed(trimmed, mesh, trimmed.untrimmed().mesh());
  }
  const auto bisector = SC::curve_surface_bisector(curve, surface, radius);
  SC::IO::write_surface_mesh("curve_surface_bisector.vtp", bisector.mesh());
  return print_envelope(bisector);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
