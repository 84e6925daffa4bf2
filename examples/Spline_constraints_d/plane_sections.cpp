// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Contour lines of a saddle: below, at and above the height of its middle, where curves cross. Drawn on the surface
// into plane_sections.svg.
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/operations/surface_curves/plane_sections.h>

#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main()
{
  std::vector<K::Point_3> points;   // the saddle x^2 - y^2 on the square [-1,1]^2, by blossoms
  for (const int row : {3, -1, -1, 3})
    for (const int column : {3, -1, -1, 3})
      points.emplace_back(points.size() / 4 * 2. / 3 - 1, points.size() % 4 * 2. / 3 - 1, (row - column) / 4.);
  const SC::Bspline_surface_3<K> surface({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points);

  const std::vector<double> heights{-0.25, 0, 0.25};
  const auto sections = SC::plane_sections(surface, K::Vector_3(0, 0, 1), heights);
  Scene scene;
  scene.add(surface, {200, 215, 195});
  bool is_complete = true;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const auto& section = sections[i];
    is_complete = is_complete && section.is_complete();
    std::cout << "height " << heights[i] << ": " << section.number_of_open_curves() << " curves, "
              << section.singular_points().size() << " crossings; complete: " << (section.is_complete() ? "yes" : "no")
              << '\n';
    for (const SC::Surface_curve& curve : section.curves()) {
      std::vector<K::Point_3> line;
      for (const auto& sample : section.polyline(curve, 1e-2))
        line.push_back(sample.point);
      scene.add(line, "#c00020", 2);
    }
  }
  std::ofstream out("plane_sections.svg");
  scene.write(out);
  return is_complete ? 0 : 3;
}
