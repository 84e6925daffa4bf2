// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All lines that are perpendicular to two surfaces, here a sheet and a ball above it, from the points of one surface to
// those of the other one: the shortest one in red.
//
// Writes common_normals.svg. Exit status: 0 when nothing is undecided, else 3.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/distances/common_normals.h>

#include <cstddef>
#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;

int main()
{
  const double heights[4][4] = {{2, 4, -3, 2}, {4, -6, 5, -3}, {-3, 5, -7, 4}, {2, -3, 4, 2}};
  std::vector<K::Point_3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(2 * i, 2 * j, heights[i][j]);
  const Surface sheet({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points),
      ball = SC::sphere_surface<K>(K::Point_3(3, 3, 3), 0.625);
  const auto normals = SC::common_normals(sheet, ball);

  Scene scene;
  scene.add(sheet, {190, 210, 235});
  scene.add(ball, {240, 215, 170});
  for (std::size_t i = normals.size(); i-- > 0;) {
    const K::Point_3 &p = normals[i].point(0), &q = normals[i].point(1);
    const std::string color = i == 0 ? "#c00020" : "#555";
    scene.add({p, q}, color, i == 0 ? 3 : 1.5, true);
    scene.mark(p, color);
  }
  std::ofstream out("common_normals.svg");
  scene.write(out);
  for (const auto& pair : normals) {
    const auto [least, greatest] = pair.squared_distance_range();
    std::cout << "distance " << std::sqrt(CGAL::to_double(least)) << " between (" << pair.point(0) << ") and ("
              << pair.point(1) << ")\n";
  }
  std::cout << "common normals: " << normals.size() << ", " << normals.undecided().size()
            << " undecided; complete: " << (normals.is_complete() ? "yes" : "no") << '\n';
  return normals.is_complete() ? 0 : 3;
}
