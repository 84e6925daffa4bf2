// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The alpha-sector of two surfaces: points whose distances from both have the ratio alpha : 1 - alpha.
//
//   alpha_sector_surface [A B ALPHA] [--trim] [--output FILE.off|.ply|.stl|.vtp|.svg] [--time-limit S]
//
// Files of .g2 or .itd, of which the first surfaces are taken, and a number between 0 and 1, but not 1/2. With --trim
// only points are kept for which no point of a surface is nearer than the foot on it. Without files
// four sectors between two bicubic surfaces are drawn into alpha_sector_surface.svg. Exit status: 0, 3 when something
// is undecided, or 2 for bad input.
#include "arguments.h"
#include "envelope_output.h"

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/alpha_sector_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/trimmed_surface_bisectors.h>

#include <algorithm>
#include <exception>
#include <fstream>

namespace SC = CGAL::Spline_constraints;

// Between both surfaces alone: above the first one and below the second one.
int own_example(const Options_of_program& rest)
{
  const Surface_operand below = surface_of_heights({0, -0.5, 0, 0.5, 0, 1.25, -0.5, 0, 0, 0, 1.25, 0, 0.5, 0, -0.5, 0}),
                        above = surface_of_heights({5, 5.5, 5, 5, 4.5, 5, 5.75, 5, 5, 4.5, 4, 5.5, 5, 5, 5.5, 5});
  std::vector<SC::Solution_surface_mesh> meshes;
  int status = 0;
  for (const double alpha : {0.2, 0.4, 0.6, 0.8}) {
    const auto sector =
        SC::alpha_sector_surface(below, above, alpha, {SC::Touched_side::POSITIVE, SC::Touched_side::NEGATIVE}, rest());
    meshes.push_back(sector.mesh({.chord_error = 0.02, .angle = 10}, rest()));
    status = std::max(status, print_envelope(sector));
  }
  std::ofstream picture("alpha_sector_surface.svg");
  draw_between(picture, below, above, meshes);
  return status;
}

int main(int argc, char** argv)
try {
  SC::Solver_options options{.tolerance = 1e-8};
  std::vector<std::string> words = arguments_and_time_limit(argc, argv, options);
  const Options_of_program rest(options);
  if (words.empty())
    return own_example(rest);
  std::string output = "alpha_sector_surface.vtp";
  const bool is_trimmed = std::erase(words, "--trim") > 0;
  if (words.size() == 5 && words[3] == "--output") {
    output = words[4];
    words.resize(3);
  }
  if (words.size() != 3)
    throw SC::Invalid_input("usage: alpha_sector_surface [A B ALPHA] [--trim] "
                            "[--output FILE.off|.ply|.stl|.vtp|.svg] [--time-limit S]");
  const Surface_operand first = surface_in(words[0]), second = surface_in(words[1]);
  const double alpha = number_of<double>(words[2]);
  const auto write = [&](const SC::Solution_surface_mesh& mesh) {
    if (output.ends_with(".svg")) {
      std::ofstream picture(output);
      draw_between(picture, first, second, {mesh});
    } else
      SC::IO::write_surface_mesh(output, mesh);
  };
  if (is_trimmed) {
    const auto trimmed = SC::trimmed_alpha_sector_surface(first, second, alpha, {}, rest());
    const auto mesh = trimmed.mesh({}, rest());
    write(mesh);
    return print_trimmed(trimmed, mesh, trimmed.untrimmed().mesh({}, rest()));
  }
  const auto sector = SC::alpha_sector_surface(first, second, alpha, {}, rest());
  write(sector.mesh({}, rest()));
  return print_envelope(sector);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
