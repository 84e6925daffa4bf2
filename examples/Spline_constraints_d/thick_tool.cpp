// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which parts of a wavy sheet a tool reaches from above, past a pyramid of four triangles: without and with a radius.
// Writes thick_tool.svg. Exit status: 0 when nothing is undecided, else 3.
#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/accessible_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/trimmed_surface_meshes.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

int main()
{
  const double heights[4][4] = {{0, 0.5, -0.5, 0}, {0.5, -1, 1, -0.25}, {-0.5, 1, -1, 0.5}, {0, -0.25, 0.5, 0}};
  SC::Scene_3 scene({.to_viewer = {-0.5, -1.2, 1}});
  bool is_complete = true;
  for (const double radius : {0., 0.375}) {
    const double left = radius > 0 ? 5 : 0;
    std::vector<K::Point_3> points;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        points.emplace_back(left + i * 1.25, j * 1.25, heights[i][j]);
    const SC::Bspline_surface_3<K> sheet({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points);
    const K::Point_3 apex(left + 1.75, 1.75, 2.25);
    const std::vector<K::Point_3> base{K::Point_3(left + 1, 1, 1.5), K::Point_3(left + 2.75, 1.25, 1.5),
                                       K::Point_3(left + 2.5, 2.75, 1.5), K::Point_3(left + 0.75, 2.5, 1.5)};
    SC::Tool_obstacles_3<K> obstacles;
    CGAL::Surface_mesh<K::Point_3> pyramid;
    for (std::size_t i = 0; i < base.size(); ++i) {
      obstacles.triangles.emplace_back(base[i], base[(i + 1) % base.size()], apex);
      pyramid.add_face(pyramid.add_vertex(base[i]), pyramid.add_vertex(base[(i + 1) % base.size()]),
                       pyramid.add_vertex(apex));
    }
    const auto regions =
        SC::accessible_regions(sheet, obstacles, {.direction = K::Vector_3(0.25, 0.125, 1), .radius = radius});
    is_complete = is_complete && regions.is_complete();
    std::cout << "radius " << radius << ":";
    for (const bool is_free : {true, false}) {
      const int label = static_cast<int>(is_free ? SC::Access::FREE : SC::Access::OBSTRUCTED);
      const auto part = SC::to_surface_mesh(regions, label, 0.02);
      scene.add(
          part.mesh,
          {.color = is_free ? CGAL::IO::Color(160, 215, 160) : CGAL::IO::Color(245, 170, 90), .has_edges = false});
      std::cout << (is_free ? " reached " : ", not reached ") << part.area();
    }
    std::cout << '\n';
    scene.add(pyramid, {.color = CGAL::IO::Color(170, 190, 225)});
  }
  std::ofstream out("thick_tool.svg");
  scene.write(out);
  std::cout << "complete: " << (is_complete ? "yes" : "no") << '\n';
  return is_complete ? 0 : 3;
}
