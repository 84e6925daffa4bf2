// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Paths of a ball-end milling tool on a surface at constant heights: the center of the ball is on the offset of the
// surface, which is cut by planes. Each path is drawn twice, as that of the center (blue) and where the ball touches
// the surface (red), into tool_paths.svg.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Offset_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_implicit.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/locus_intersection_curves.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;

int main()
{
  const double heights[4][4] = {{0, 0, 1, 0}, {0, 4, 2, 0}, {1, 1, 3, 1}, {0, 0, 1, 0}};
  std::vector<K::Point_3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(2 * i, 2 * j, heights[i][j]);
  const Surface surface({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points);
  const double radius = 0.5;
  const SC::Offset_surface_3 centers(surface, radius);
  const K::Iso_cuboid_3 box(-2, -2, -2, 8, 8, 8);

  Scene scene;
  scene.add(surface, {200, 215, 195});
  bool is_complete = true;
  for (double height = 0.75; height < 2.25; height += 0.25) {
    const auto paths = SC::intersection_curves(centers, SC::to_implicit(K::Plane_3(0, 0, 1, -height), box));
    std::cout << "height " << height << ": " << paths << '\n';
    is_complete = is_complete && paths.is_complete();
    for (const SC::Surface_curve& path : paths.curves()) {
      std::vector<K::Point_3> of_center, of_contact;
      for (const auto& sample : paths.polyline(path, 1e-2)) {
        of_center.emplace_back(CGAL::to_double(sample.point.x()), CGAL::to_double(sample.point.y()),
                               CGAL::to_double(sample.point.z()));
        of_contact.push_back(surface(sample.parameters[0], sample.parameters[1]));
      }
      scene.add(of_contact, "#c00020", 2);
      scene.add(of_center, "#2060c0", 1.5);
    }
  }
  std::ofstream out("tool_paths.svg");
  scene.write(out);
  return is_complete ? 0 : 3;
}
