// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bisector of two surfaces: the centers of all spheres that touch both.
//
//   surface_bisector [A B] [--radius R] [--trim] [--output FILE.off|.ply|.stl|.vtp|.svg] [--time-limit S]
//
// With --trim it is trimmed: what is kept has no point of a surface that is nearer. Without files that of a plane and a
// trough is drawn then, where centers on both sides of the trough come nearer to the other side.
//
// Files of .g2 or .itd, of which the first surfaces are taken; spheres have at most the radius R, or the size of both
// surfaces. Without files the bisector of two bicubic surfaces is drawn between them into surface_bisector.svg, that of
// a plane and a biquadratic surface into surface_plane_bisector.svg.
// Exit status: 0, 3 when something is undecided, or 2 for bad input.
#include "arguments.h"
#include "envelope_output.h"

#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/surface_bisector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/trimmed_surface_bisectors.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <fstream>
#include <vector>

namespace SC = CGAL::Spline_constraints;

double size_of(const Surface_operand& a, const Surface_operand& b)
{
  CGAL::Bbox_3 box;
  for (const Surface_operand* surface : {&a, &b}) {
    const auto grid = grid_on(*surface);
    for (const auto& p : grid.points())
      box += p.bbox();
  }
  return std::max({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
}

// As in figure 4 of Elber and Kim (2001), and figure 3 of Kim, Elber and Seong (2005). Exit status: 0, or 3.
int draw_plane_bisector(const SC::Solver_options& options)
{
  using Point = Kernel_of_operands::Point_3;
  std::vector<Point> net;
  const std::array<double, 9> heights{1.75, 1.25, 1.75, 1.5, 2.5, 1.25, 1.75, 1.25, 1.75};
  for (std::size_t i = 0; i < 9; ++i)
    net.emplace_back(2 * static_cast<double>(i / 3), 2 * static_cast<double>(i % 3), heights[i]);
  const Surface_operand surface({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, net);
  const Surface_operand plane({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1},
                              {Point(-0.6, -0.6, 0), Point(-0.6, 4.6, 0), Point(4.6, -0.6, 0), Point(4.6, 4.6, 0)});
  const SC::Touched_sides between{SC::Touched_side::POSITIVE, SC::Touched_side::NEGATIVE};
  const auto bisector = SC::surface_bisector(plane, surface, 2, between, options);
  std::ofstream picture("surface_plane_bisector.svg");
  draw_between(picture, plane, surface, {bisector.mesh({.chord_error = 0.01, .angle = 10})});
  return print_envelope(bisector);
}

// Exit status: 0, or 3.
int trim(const Surface_operand& first, const Surface_operand& second, double radius, const SC::Touched_sides& sides,
         const std::string& output, const Options_of_program& rest)
{
  const auto trimmed = SC::trimmed_surface_bisector(first, second, radius, sides, rest());
  const SC::Surface_mesh_options fine{.chord_error = 0.01, .angle = 10};
  const auto mesh = trimmed.mesh(fine, rest());
  if (output.ends_with(".svg")) {
    std::ofstream picture(output);
    draw_between(picture, first, second, {mesh}, 0.1);
  } else
    SC::IO::write_surface_mesh(output, mesh);
  return print_trimmed(trimmed, mesh, trimmed.untrimmed().mesh(fine, rest()));
}

// A plane and a trough: spheres that touch it near its bottom have other points of it inside.
int trim_own(const Options_of_program& rest)
{
  using Point = Kernel_of_operands::Point_3;
  const Surface_operand plane({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1},
                              {Point(-3, -3, 0), Point(-3, 3, 0), Point(3, -3, 0), Point(3, 3, 0)});
  const Surface_operand trough({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1},
                               {Point(-2, -2, 2), Point(-2, 0, 2.5), Point(-2, 2, 2), Point(0, -2, 5.5),
                                Point(0, 0, 6.5), Point(0, 2, 5), Point(2, -2, 2), Point(2, 0, 2.25), Point(2, 2, 2)});
  return trim(plane, trough, 8, {SC::Touched_side::POSITIVE, SC::Touched_side::NEGATIVE},
              "trimmed_surface_bisector.svg", rest);
}

int main(int argc, char** argv)
try {
  SC::Solver_options options{.tolerance = 1e-8};
  const std::vector<std::string> words = arguments_and_time_limit(argc, argv, options);
  std::vector<std::string> files;
  std::string output = "surface_bisector.svg";
  double radius = 0;
  bool is_trimmed = false;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == "--radius" && i + 1 < words.size())
      radius = number_of<double>(words[++i]);
    else if (words[i] == "--output" && i + 1 < words.size())
      output = words[++i];
    else if (words[i] == "--trim")
      is_trimmed = true;
    else
      files.push_back(words[i]);
  if ((!files.empty() && files.size() != 2) ||
      std::any_of(files.begin(), files.end(), [](const std::string& file) { return file.starts_with("--"); }))
    throw SC::Invalid_input("usage: surface_bisector [A B] [--radius R] [--trim] "
                            "[--output FILE.off|.ply|.stl|.vtp|.svg] [--time-limit S]");
  const Options_of_program rest(options);
  if (is_trimmed && files.empty())
    return trim_own(rest);
  const Surface_operand first = files.empty()
      ? surface_of_heights({4, 4.75, 4, 4, 3.25, 4, 5.5, 4, 4, 3.25, 2.5, 4.75, 4, 4, 4.75, 4})
      : surface_in(files[0]);
  const Surface_operand second = files.empty()
      ? surface_of_heights({0, -0.75, 0, 0.75, 0, 2.25, -0.75, 0, 0, 0, 2.25, 0, 0.75, 0, -0.75, 0})
      : surface_in(files[1]);
  if (radius == 0)
    radius = size_of(first, second);
  if (is_trimmed)
    return trim(first, second, radius, {}, output, rest);
  const auto bisector = SC::surface_bisector(first, second, radius, {}, rest());
  const auto mesh = bisector.mesh({.chord_error = 0.01, .angle = 10}, rest());
  if (output.ends_with(".svg")) {
    std::ofstream picture(output);
    draw_between(picture, first, second, {mesh});
  } else
    SC::IO::write_surface_mesh(output, mesh);
  const int status = files.empty() ? draw_plane_bisector(options) : 0;
  return std::max(status, print_envelope(bisector));
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
