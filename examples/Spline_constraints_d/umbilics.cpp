// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The umbilics of a bicubic B-spline surface, where its curvature is the same in all directions. Drawn into
// umbilics.svg as circles, thin where the surface hides them.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/operations/surface_curves/umbilics.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

// A dome with a hill.
SC::Bspline_surface_3<K> landscape()
{
  std::vector<K::Point_3> points;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 7; ++j) {
      const double dome = -0.07 * (i - 3) * (i - 3) - 0.1 * (j - 3) * (j - 3), hill = i == 2 && j == 3 ? 1.5 : 0;
      points.emplace_back(i, j, dome + hill);
    }
  const std::vector<double> knots{0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4};
  return {{3, 3}, knots, knots, points};
}

int main()
{
  const auto surface = landscape();
  const auto set = SC::umbilics(surface);

  Scene scene;
  scene.add(surface, {190, 210, 235});
  for (const auto& umbilic : set.points()) {
    const std::vector<double> place = umbilic.parameters.point();
    std::cout << "umbilic at (" << umbilic.point << "), " << umbilic.parameters.kind() << '\n';
    constexpr int steps = 24;
    constexpr double radius = 0.06;
    std::vector<K::Point_3> circle;
    for (int k = 0; k <= steps; ++k) {
      const double angle = 2 * CGAL_PI * k / steps;
      circle.push_back(surface(std::clamp(place[0] + radius * std::cos(angle), 0.0, 4.0),
                               std::clamp(place[1] + radius * std::sin(angle), 0.0, 4.0)));
    }
    scene.add(circle, "#c00020", 3, true);
  }
  std::ofstream out("umbilics.svg");
  scene.write(out);
  std::cout << "umbilics: " << (set.is_complete() ? "" : "at least ") << set.points().size() << ", "
            << set.undecided().size() << " undecided; complete: " << (set.is_complete() ? "yes" : "no") << '\n';
  return set.is_complete() ? 0 : 3;
}
