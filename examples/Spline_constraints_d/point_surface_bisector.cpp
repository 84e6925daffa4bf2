// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The bisector of a point and a surface.
//
//   point_surface_bisector [SURFACE.g2 X Y Z] [--reach R] [--error E] [--output FILE.off|.vtp|.svg] [--time-limit S]
//
// With a surface and a point: the bisector within a ball of radius R around both, trimmed; its mesh, or a picture, goes
// into a file. Without: those of a point with a plane, a bicubic surface, a sphere from inside and outside, a cone, a
// cylinder and a torus, untrimmed, are drawn into point_surface_bisector.svg. Exit status: 0 when nothing is undecided,
// 3 when something is, 2 for bad input.
#include "trimmed_bisector_program.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>

Surface landscape()
{
  const double height[4][4] = {{0, 0.2, -0.3, 0}, {0.2, -0.6, 0.6, 0}, {0, 0.9, -0.6, 0}, {0.1, -0.1, 0.1, 0.2}};
  std::vector<K::Point_3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(i - 1.5 + 0.25 * height[j][i], j - 1.5 + 0.25 * height[3 - i][j], height[i][j]);
  const std::vector<double> knots{0, 0, 0, 0, 1, 1, 1, 1};
  return Surface({3, 3}, knots, knots, points);
}

void draw()
{
  Scene scene;
  const auto add = [&](const std::string& name, const Surface& surface, const std::vector<Surface>& shown,
                       const K::Point_3& point, double reach, double x, double y) {
    Group group(scene, Group::place(x, y));
    for (const Surface& part : shown)
      group.add(part);
    group.add(point);
    group.add(show(name, SC::point_surface_bisector(point, surface), K::Sphere_3(point, reach * reach)));
  };
  const K::Point_3 origin(0, 0, 0);
  const Surface plane = SC::plane_patch<K>(K::Point_3(-1.5, -1.5, 0), K::Vector_3(3, 0, 0), K::Vector_3(0, 3, 0)),
                sphere = SC::sphere_surface<K>(origin, 1),
                cone = SC::cone_surface<K>(origin, K::Vector_3(0, 0, 1), K::Point_3(1.5, 0, 2)),
                cylinder = SC::cylinder_surface<K>(origin, 1, 3), torus = SC::torus_surface<K>(origin, 1.5, 0.5);
  // Of surfaces around the point, what is behind.
  const auto behind = [](const Surface& surface) {
    return std::vector{surface.restricted(0, 0, 1), surface.restricted(0, 3, 4)};
  };
  add("plane", plane, {plane}, K::Point_3(0, 0, 1), 2, -6, 3);
  add("bicubic surface", landscape(), {landscape()}, K::Point_3(0, 0, 2), 4, -2, 3);
  add("inside of a sphere", sphere, behind(sphere), K::Point_3(0.25, -0.25, 0.5), 2, 2, 3.5);
  add("outside of a sphere", sphere, {sphere}, K::Point_3(0, 0, 2), 1.6, 6, 2.5);
  add("outside of a cone", cone, {cone}, K::Point_3(2.5, 0, 0.5), 1.8, -6, -3);
  add("inside of a cylinder", cylinder, behind(cylinder), K::Point_3(0.25, 0, 1.5), 3, -2, -3.5);
  add("center of a torus", torus, {torus}, origin, 1.5, 2, -2.5);
  add("inside of a torus", torus, behind(torus), K::Point_3(0, 1.6, 0.1), 0.9, 6, -2.5);
  std::ofstream file("point_surface_bisector.svg");
  scene.write(file);
}

int main(int argc, char* argv[])
{
  try {
    const Bisector_arguments arguments(argc, argv);
    if (arguments.words.empty()) {
      draw();
      return 0;
    }
    if (arguments.words.size() != 4)
      throw SC::Invalid_input("usage: point_surface_bisector [SURFACE.g2 X Y Z] [--reach R] [--error E] [--output "
                              "FILE.off|.vtp|.svg] [--time-limit S]");
    return of_file(arguments, [&](const K::Point_3& center, const Surface& surface, const K::Sphere_3& reach) {
      return SC::trimmed_point_surface_bisector(center, surface, reach, arguments.options);
    });
  } catch (const SC::Invalid_input& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
}
