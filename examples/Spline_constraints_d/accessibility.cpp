// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a straight tool, upright on a surface as in 5-axis milling, touches a ball: between what it reaches and what it
// does not. Writes accessibility.svg with all directions, and accessibility_hemisphere.svg with only those to one side.
// Exit status: 0 when nothing is undecided, 3 when something is.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/accessibility.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;

// A biquadratic landscape with ridges and valleys.
Surface landscape()
{
  constexpr int height[6][6] = {{0, 0, 1, 1, 0, 0},  {0, 3, 0, 0, 3, 0}, {1, 0, -2, 4, 0, 1},
                                {1, 0, 4, -2, 0, 1}, {0, 3, 0, 0, 3, 0}, {0, 0, 1, 1, 0, 0}};
  std::vector<K::Point_3> points;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      points.emplace_back(2 * i - 5, 2 * j - 5, 0.75 * height[i][j]);
  const std::vector<double> knots{0, 0, 0, 1, 2, 3, 4, 4, 4};
  return Surface({2, 2}, knots, knots, points);
}

bool draw(const std::string& path, const Surface& surface, const K::Sphere_3& ball, const SC::Tool_axis<K>& axis)
{
  const auto boundaries = SC::accessibility_boundaries(surface, ball, axis);
  std::cout << boundaries << '\n';
  Scene scene;
  scene.add(surface, {190, 215, 190});
  scene.add(SC::sphere_surface<K>(ball.center(), std::sqrt(ball.squared_radius())), {240, 200, 150});
  for (const SC::Surface_curve& curve : boundaries.curves()) {
    std::vector<K::Point_3> points;
    for (const auto& sample : boundaries.polyline(curve, 1e-3)) {
      if (points.size() % 6 == 0) {   // the tool, as far as it touches the ball
        const K::Vector_3 normal = surface.normal(sample.parameters[0], sample.parameters[1]),
                          to_center = ball.center() - sample.point;
        scene.add({sample.point, sample.point + normal * (to_center * normal / normal.squared_length())}, "#555", 0.7);
      }
      points.push_back(sample.point);
    }
    scene.add(points, "#c00020");
  }
  std::ofstream out(path);
  scene.write(out);
  return boundaries.is_complete();
}

int main()
{
  const Surface surface = landscape();
  const K::Sphere_3 ball(K::Point_3(0.25, -0.5, 3.5), 1);
  const bool is_complete = draw("accessibility.svg", surface, ball, {}) &&
      draw("accessibility_hemisphere.svg", surface, ball, {.hemisphere = K::Vector_3(1, 0, 0)});
  return is_complete ? 0 : 3;
}
