// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The envelope of two surfaces: envelope_surface A B, files of .g2 or .itd; it is written into envelope_surface.vtp.
// Without arguments that of a bicubic surface with a hill and a hollow and of a bowl; it is drawn into
// envelope_surface.svg above both. Exit status: 0, or 3 when something is undecided.
#include "envelope_output.h"

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/envelope_surface.h>

#include <exception>
#include <fstream>

namespace SC = CGAL::Spline_constraints;

int own_example()
{
  std::vector<Kernel_of_operands::Point_3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(2 * i - 3, 2 * j - 3, i == 1 && j == 1 ? 3 : i == 2 && j == 2 ? -3 : 0);
  const Surface_operand hills({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points);
  const Surface_operand bowl(
      {2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1},
      {{-1, -1, 1}, {-1, 0, 0}, {-1, 1, 1}, {0, -1, 0}, {0, 0, -1}, {0, 1, 0}, {1, -1, 1}, {1, 0, 0}, {1, 1, 1}});
  const auto envelope = SC::envelope_surface(hills, bowl);
  SC::Scene_3 scene({.to_viewer = {-0.5, -0.8, 0.6}, .most_splits = 20000});
  const auto at = [](const Surface_operand& surface, double x, double y, double z) {
    return grid_on(surface.transformed({1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z}));
  };
  scene.add(at(hills, 0, 0, -3), {.color = CGAL::IO::Color(215, 215, 215)});
  scene.add(at(bowl, 5.5, 0, -3), {.color = CGAL::IO::Color(230, 120, 110)});
  add_envelope(scene, envelope.mesh({.chord_error = 0.03}));
  std::ofstream picture("envelope_surface.svg");
  scene.write(picture);
  return print_envelope(envelope);
}

int main(int argc, char** argv)
try {
  if (argc == 1)
    return own_example();
  if (argc != 3)
    throw SC::Invalid_input("usage: envelope_surface A B");
  const auto envelope = SC::envelope_surface(surface_in(argv[1]), surface_in(argv[2]));
  SC::IO::write_surface_mesh("envelope_surface.vtp", envelope.mesh());
  return print_envelope(envelope);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
