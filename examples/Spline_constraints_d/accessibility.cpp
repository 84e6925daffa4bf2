// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a straight tool, upright on a rounded cube as in 5-axis milling, would go past a ball in its middle. Normals
// point inwards, so it is the ball that they meet. Writes accessibility.svg with all directions, and
// accessibility_110.svg and accessibility_111.svg with those to one side only. The last line is that of the first
// picture. Exit status: 0 when nothing is undecided, 3 when something is.
#include "rounded_cuboid.h"
#include "surface_scene.h"

#include <CGAL/Spline_constraints_d/operations/surface_curves/accessibility.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/accessible_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/connected_regions.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/trimmed_surface_meshes.h>

#include <chrono>
#include <fstream>
#include <iostream>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Exact = rounded_cuboid::Kernel;
using Axis = SC::Tool_axis<Exact>;

const std::pair<SC::Access, std::array<double, 3>> colors[] = {{SC::Access::FREE, {150, 205, 150}},
                                                               {SC::Access::OBSTRUCTED, {245, 170, 90}},
                                                               {SC::Access::NOT_ADMITTED, {220, 220, 220}}};

K::Point_3 rounded(const Exact::Point_3& p)
{
  return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
}

bool draw(const char* path, const std::vector<rounded_cuboid::Surface>& cuboid, const Exact::Sphere_3& ball,
          const Axis& axis)
{
  const auto begin = std::chrono::steady_clock::now();
  std::vector<SC::Trimmed_surface_3> surfaces;
  for (const auto& surface : cuboid)
    surfaces.push_back(SC::accessible_regions(surface, std::vector{ball}, axis));
  const SC::Connected_regions_3 regions = SC::connected_regions(surfaces);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;

  Scene scene;
  bool is_complete = regions.is_complete();
  std::size_t closed = 0, open = 0;
  for (std::size_t i = 0; i < cuboid.size(); ++i) {
    for (const auto& [access, color] : colors) {
      const auto part = SC::to_surface_mesh(surfaces[i], static_cast<int>(access), 0.01);
      is_complete = is_complete && part.is_complete();
      scene.add(part.mesh, color);
    }
    const auto boundaries = SC::accessibility_boundaries(cuboid[i], ball, axis);
    closed += boundaries.number_of_closed_curves();
    open += boundaries.number_of_open_curves();
    is_complete = is_complete && boundaries.is_complete();
    for (const SC::Surface_curve& curve : boundaries.curves()) {
      std::vector<K::Point_3> points;
      for (const auto& sample : boundaries.polyline(curve, 4e-3))
        points.push_back(rounded(sample.point));
      scene.add(points, "#c00020", 2);
    }
  }
  std::ofstream out(path);
  scene.write(out);
  std::cout << "regions: " << regions.number_of_regions(static_cast<int>(SC::Access::FREE)) << " accessible, "
            << regions.number_of_regions(static_cast<int>(SC::Access::OBSTRUCTED)) << " not, " << closed
            << " closed curves, " << open << " open; complete: " << (is_complete ? "yes" : "no") << "; seconds "
            << seconds.count() << std::endl;
  return is_complete;
}

int main()
{
  const rounded_cuboid::Number size = 1, radius = rounded_cuboid::Number(2) / 5,
                               ball_radius = rounded_cuboid::Number(11) / 20;
  const auto cuboid = rounded_cuboid::surfaces(size, radius, true);
  const Exact::Sphere_3 ball(Exact::Point_3(0, 0, 0), rounded_cuboid::Number(ball_radius * ball_radius));
  const bool is_complete = draw("accessibility_110.svg", cuboid, ball, {.hemisphere = Exact::Vector_3(1, 1, 0)}) &&
      draw("accessibility_111.svg", cuboid, ball, {.hemisphere = Exact::Vector_3(1, 1, 1)}) &&
      draw("accessibility.svg", cuboid, ball, Axis{});
  return is_complete ? 0 : 3;
}
