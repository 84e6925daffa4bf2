// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The offset of a surface: offset_surface SURFACE DISTANCE, a file of .g2 or .itd; it is written into
// offset_surface.vtp. Without arguments that of a trough towards its inside, which has cuspidal edges and crosses
// itself; it is drawn into offset_surface.svg with the trough. Exit status: 0, or 3 when something is undecided.
#include "envelope_output.h"

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/offset_surface.h>

#include <exception>
#include <fstream>

namespace SC = CGAL::Spline_constraints;

int own_example()
{
  const Surface_operand trough(
      {2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1},
      {{-2, -3, 4}, {-2.5, 0, 5}, {-2, 3, 4}, {0, -3, -4}, {0, 0, -3}, {0, 3, -4}, {2, -3, 4}, {2.5, 0, 5}, {2, 3, 4}});
  const auto offset = SC::offset_surface(trough, 1.);
  SC::Scene_3 scene({.to_viewer = {-0.15, -1, 0.35}, .most_splits = 20000});
  scene.add(grid_on(trough), {.color = CGAL::IO::Color(215, 215, 215)});
  add_envelope(scene, offset.mesh({.chord_error = 0.03}));
  std::ofstream picture("offset_surface.svg");
  scene.write(picture);
  return print_envelope(offset);
}

int main(int argc, char** argv)
try {
  if (argc == 1)
    return own_example();
  if (argc != 3)
    throw SC::Invalid_input("usage: offset_surface SURFACE DISTANCE");
  const auto offset = SC::offset_surface(surface_in(argv[1]), std::stod(argv[2]));
  SC::IO::write_surface_mesh("offset_surface.vtp", offset.mesh());
  return print_envelope(offset);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
