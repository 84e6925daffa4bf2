// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The boundary of what a solid sweeps along a curve, as a closed mesh.
//
//   swept_volume SOLID PATH [--turns K] [--chord-error E] [--time-limit S] [--output FILE]
//
// Files of .g2 or .itd: the surfaces that bound a solid, whose edges are seams, poles, or common to two of them, and a
// curve in space, along which it is translated; with --turns it also turns K times about the vertical line through the
// origin. FILE is one of .off, .ply or .stl, or a picture, .svg. Without arguments, a cube turns about its diagonal,
// and an ellipsoid runs along a star of five lines, which cross each other.
// Exit status: 0 when the boundary is complete, 3 when it is not, 2 for bad input.
#include "arguments.h"
#include "envelope_output.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/swept_volumes.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <numbers>
#include <optional>

namespace SC = CGAL::Spline_constraints;
using Point = Kernel_of_operands::Point_3;
using Mesh = SC::Swept_volume_3::Mesh;

// Turns about the z-axis: a quaternion runs around a regular polygon of twelve edges. Each is a sixth of a turn.
SC::Rational_motion_3 turns_about_z(int turns, const SC::Rational_motion_3& path)
{
  const auto [begin, end] = path.domain();
  const int count = 6 * turns; // edges
  std::vector<SC::Exact_rational> knots{begin}, p, q;
  for (int k = 0; k <= count; ++k) {
    knots.push_back(begin + (end - begin) * k / count);
    p.push_back(SC::Exact_rational(std::cos(k * std::numbers::pi / 6)));
    q.push_back(SC::Exact_rational(std::sin(k * std::numbers::pi / 6)));
  }
  knots.push_back(end);
  return SC::Rational_motion_3::rotation(Point(0, 0, 0), Kernel_of_operands::Vector_3(0, 0, 1),
                                         SC::Rational_motion_3::Function({1}, {knots}, p),
                                         SC::Rational_motion_3::Function({1}, {knots}, q));
}

// With the edges where parts of the boundary meet at an angle whose cosine is at most so large, in dark, but for those
// of slivers.
void add_boundary(SC::Scene_3& scene, const Mesh& mesh, double cosine = 0.8, double sliver = 1e-3)
{
  scene.add(mesh, {.color = CGAL::IO::Color(150, 195, 235), .has_edges = false});
  const auto normal = [&](const auto h) {
    const auto p = mesh.point(mesh.source(h)), q = mesh.point(mesh.target(h)),
               r = mesh.point(mesh.target(mesh.next(h)));
    return CGAL::cross_product(q - p, r - p);
  };
  for (const auto e : mesh.edges()) {
    const auto h = mesh.halfedge(e);
    const std::vector edge{mesh.point(mesh.source(h)), mesh.point(mesh.target(h))};
    const auto a = normal(h), b = normal(mesh.opposite(h));
    const double least = sliver * CGAL::squared_distance(edge[0], edge[1]);
    const double size = std::sqrt(a.squared_length()), other = std::sqrt(b.squared_length());
    if (size > least && other > least && a * b < cosine * size * other)
      scene.add_polyline(edge, {.color = "#335", .width = 1.5, .nearer = 0.02});
  }
}

void draw(std::ostream& out, const Mesh& mesh, const SC::View_3& view)
{
  SC::Scene_3 scene(view);
  add_boundary(scene, mesh);
  scene.write(out);
}

void write(const std::string& path, const Mesh& mesh)
{
  if (!path.ends_with(".svg"))
    return SC::IO::write_surface_mesh(path, mesh);
  std::ofstream out(path);
  draw(out, mesh, {});
  if (!out.flush())
    throw SC::Invalid_input("--output: " + path + " cannot be written");
}

int print(const SC::Swept_volume_3& swept)
{
  for (const auto& part : swept.undecided())
    std::cout << part << '\n';
  std::cout << swept << '\n';
  return swept.is_complete() ? 0 : 3;
}

// The unit cube, by six squares with normals that point outwards.
std::vector<Surface_operand> cube()
{
  std::vector<Surface_operand> result;
  for (int axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1}) {
      const int u = (axis + (end == 1 ? 1 : 2)) % 3;
      std::vector<Point> points;
      for (const int i : {0, 1})
        for (const int j : {0, 1}) {
          const auto coordinate = [&](int k) { return k == axis ? end : k == u ? i : j; };
          points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
        }
      result.push_back(Surface_operand({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, points));
    }
  return result;
}

// A cube about its diagonal: what its edges sweep, two cones and a hyperboloid. After a third of a turn it is the same.
void turn_a_cube()
{
  using Function = SC::Rational_motion_3::Function;
  const auto third =
      SC::Rational_motion_3::rotation(Point(0, 0, 0), Kernel_of_operands::Vector_3(1, 1, 1),
                                      Function({0}, {{0, 1}}, {1}), Function({1}, {{0, 0, 1, 1}}, {0, 1}));
  const SC::Swept_volume_3 swept = SC::swept_volume(cube(), third, {.chord_error = 0.01});
  SC::Scene_3 scene({.to_viewer = {0.1, 1, -0.55}, .up = {1, 1, 1}});
  add_boundary(scene, swept.mesh(), 0.4, 0.05);
  for (const Surface_operand& face : cube()) { // beside it
    const Surface_operand moved = face.transformed({CGAL::TRANSLATION, {1.65, -0.95, -0.7}});
    scene.add(grid_on(moved, 1), {.color = CGAL::IO::Color(240, 190, 120), .has_edges = false});
    const auto corner = [&](int u, int v) { return moved(u, v); };
    scene.add_polyline(std::vector{corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0), corner(0, 0)},
                       {.color = "#335", .width = 1.5, .nearer = 0.02});
  }
  std::ofstream picture("swept_cube.svg");
  scene.write(picture);
  std::cout << "cube: " << swept << '\n';
}

int own_example()
{
  turn_a_cube();
  const Curve_operand star(
      1, {0, 0, 1, 2, 3, 4, 5, 5},
      {{0, 3, 0}, {-1.75, -2.5, 0.25}, {2.75, 1.25, 0}, {-2.75, 1, 0.25}, {1.75, -2.5, 0}, {0, 3, 0}});
  const auto ellipsoid = SC::sphere_surface<Kernel_of_operands>(Point(0, 0, 0), 1)
                             .transformed({0.25, 0, 0, 0, 0, 0.25, 0, 0, 0, 0, 0.375, 0});
  const SC::Swept_volume_3 swept =
      SC::swept_volume(ellipsoid, SC::Rational_motion_3::along(star), {.chord_error = 0.01});
  std::ofstream picture("swept_volume.svg");
  draw(picture, swept.mesh(), {.to_viewer = {0.1, -0.6, 0.9}});
  return print(swept);
}

int main(int argc, char** argv)
try {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty())
    return own_example();
  std::vector<std::string> files;
  std::optional<std::string> output;
  SC::Solver_options options{.tolerance = 1e-8};
  double chord_error = 0.01;
  int turns = 0;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (words[i] == "--turns" && i + 1 < words.size())
      turns = number_of<int>(words[++i]);
    else if (words[i] == "--chord-error" && i + 1 < words.size())
      chord_error = number_of<double>(words[++i]);
    else if (words[i] == "--time-limit" && i + 1 < words.size())
      options.time_limit = number_of<double>(words[++i]);
    else if (words[i] == "--output" && i + 1 < words.size())
      output = words[++i];
    else
      files.push_back(words[i]);
  if (files.size() != 2 || turns < 0)
    throw SC::Invalid_input("usage: swept_volume SOLID PATH [--turns K] [--chord-error E] [--time-limit S] "
                            "[--output FILE]");
  SC::Rational_motion_3 motion = SC::Rational_motion_3::along(curve_in(files[1]));
  if (turns > 0)
    motion = motion * turns_about_z(turns, motion);
  const SC::Swept_volume_3 swept =
      SC::swept_volume(surfaces_in(files[0]), motion, {.chord_error = chord_error}, options);
  if (output)
    write(*output, swept.mesh());
  return print(swept);
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
