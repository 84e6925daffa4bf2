// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The parabolic lines of a bicubic B-spline surface, between what is curved like an egg and what is curved like a
// saddle. Drawn into parabolic_lines.svg, thin where the surface hides them.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/operations/surface_curves/parabolic_lines.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

// A dome with a hill and a hollow.
SC::Bspline_surface_3<K> landscape()
{
  std::vector<K::Point_3> points;
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) {
      const double dome = -0.09 * ((i - 4) * (i - 4) + (j - 4) * (j - 4)), hill = i == 2 && j == 2 ? 2.5 : 0,
                   hollow = i == 5 && j == 5 ? -2.5 : 0;
      points.emplace_back(i, j, dome + hill + hollow);
    }
  const std::vector<double> knots{0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6};
  return {{3, 3}, knots, knots, points};
}

int main()
{
  const auto surface = landscape();
  const auto set = SC::parabolic_lines(surface);

  Scene scene;
  scene.add(surface, {190, 210, 235});
  for (const SC::Surface_curve& curve : set.curves()) {
    std::vector<K::Point_3> points;
    for (const auto& sample : set.polyline(curve, 1e-3))
      points.push_back(sample.point);
    scene.add(points, "#c00020", 3, true);
    std::cout << (curve.is_closed ? "closed, " : "open, ") << points.size() << " points\n";
  }
  std::ofstream out("parabolic_lines.svg");
  scene.write(out);
  std::cout << set << '\n';
  return set.is_complete() ? 0 : 3;
}
