// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Light and shadow: what of a floor, of a wall and of two balls is seen from a lamp, past the balls. Writes
// visible_regions.svg, lit parts light and shadows dark. Exit status: 0 when nothing is undecided, 3 when something is.
#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/trimmed_surface_meshes.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/visible_regions.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Surface = SC::Bspline_surface_3<K>;

int main()
{
  const K::Point_3 lamp(-4, -1, 3), big(0, 0, 1), small(SC::Exact_rational(9) / 5, -1, SC::Exact_rational(1) / 2);
  const SC::Exact_rational radius_of_small = SC::Exact_rational(1) / 2;
  const K::Sphere_3 big_ball(big, 1), small_ball(small, radius_of_small * radius_of_small);

  struct Item
  {
    const char* name;
    Surface surface;
    std::vector<K::Sphere_3> balls; // that may hide it, besides itself
    CGAL::IO::Color lit, dark;
  };
  const std::vector<Item> items{
      {"floor",
       Surface({1, 1}, {-3, -3, 4, 4}, {-3, -3, 3, 3}, {{-3, -3, 0}, {-3, 3, 0}, {4, -3, 0}, {4, 3, 0}}),
       {big_ball, small_ball},
       {240, 232, 205},
       {150, 150, 165}},
      {"big ball", SC::sphere_surface<K>(big, SC::Exact_rational(1)), {small_ball}, {250, 190, 110}, {150, 100, 60}},
      {"small ball", SC::sphere_surface<K>(small, radius_of_small), {big_ball}, {150, 205, 150}, {70, 110, 85}},
      {"wall",
       Surface({1, 1}, {-3, -3, 3, 3}, {0, 0, 2, 2}, {{4, -3, 0}, {4, -3, 2}, {4, 3, 0}, {4, 3, 2}}),
       {big_ball, small_ball},
       {170, 200, 235},
       {80, 105, 140}}};

  SC::Scene_3 scene;
  bool is_complete = true;
  for (const Item& item : items) {
    const SC::Trimmed_surface_3 regions = SC::visible_regions(item.surface, lamp, item.balls);
    for (const bool is_lit : {true, false}) {
      const int label = static_cast<int>(is_lit ? SC::Access::FREE : SC::Access::OBSTRUCTED);
      const auto part = SC::to_surface_mesh(regions, label, 0.01);
      is_complete = is_complete && part.is_complete();
      scene.add(part.mesh, {.color = is_lit ? item.lit : item.dark, .has_edges = false});
    }
    is_complete = is_complete && regions.is_complete();
    std::cout << item.name << ": " << regions.number_of_regions(static_cast<int>(SC::Access::FREE)) << " lit, "
              << regions.number_of_regions(static_cast<int>(SC::Access::OBSTRUCTED)) << " dark\n";
  }
  std::ofstream out("visible_regions.svg");
  scene.write(out);
  std::cout << "regions: complete: " << (is_complete ? "yes" : "no") << '\n';
  return is_complete ? 0 : 3;
}
