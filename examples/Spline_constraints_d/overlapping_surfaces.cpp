// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parts of two surfaces that lie on each other: patches of one sphere, whose poles are in different places, and two
// parts of a tube. Writes overlapping_surfaces.svg: what they have in common is red. Exit status: 0 when nothing is
// undecided, else 3.
#include <CGAL/Spline_constraints_d/IO/Scene_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/surface_overlaps.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/trimmed_surface_meshes.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Surface = SC::Bspline_surface_3<K>;

int main()
{
  const SC::Exact_rational half = SC::Exact_rational(1) / 2;
  const Surface ball = SC::sphere_surface<K>(K::Point_3(0, 0, 0), 1),
                turned_ball = SC::sphere_surface<K>(
                    K::Point_3(0, 0, 0), K::Point_3(SC::Exact_rational(3) / 5, 0, SC::Exact_rational(4) / 5)),
                tube = SC::cylinder_surface<K>(K::Point_3(3, 0, -1), SC::Exact_rational(1), SC::Exact_rational(2));
  const auto [begin, end] = tube.domain(0);
  std::vector<std::array<Surface, 2>> pairs{
      {ball.restricted(0, 2, 4), turned_ball.restricted(0, 2 - half, 4).restricted(1, half, 2)},
      {tube.restricted(0, begin, 3), tube.restricted(0, 2, end).transformed({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, half})}};

  SC::Scene_3 scene({.to_viewer = {0.3, -2, 1}});
  bool is_complete = true;
  for (const auto& [a, b] : pairs) {
    const SC::Surface_overlap_3 overlap = SC::surface_overlap(a, b);
    is_complete = is_complete && overlap.is_complete();
    for (const std::size_t i : {0, 1}) {
      constexpr double error = 0.02;
      const auto own = SC::to_surface_mesh(overlap.surface(i), static_cast<int>(SC::Overlap::OWN), error);
      scene.add(
          own.mesh,
          {.color = i == 0 ? CGAL::IO::Color(170, 200, 235) : CGAL::IO::Color(245, 205, 130), .has_edges = false});
      const auto common = SC::to_surface_mesh(overlap.surface(i), static_cast<int>(SC::Overlap::COMMON), error);
      if (i == 0)
        scene.add(common.mesh, {.color = CGAL::IO::Color(220, 90, 80), .has_edges = false});
      std::cout << "surface " << i << ": " << overlap.number_of_common_regions(i) << " common region, area "
                << common.area() << '\n';
    }
  }
  std::ofstream out("overlapping_surfaces.svg");
  scene.write(out);
  std::cout << "complete: " << (is_complete ? "yes" : "no") << '\n';
  return is_complete ? 0 : 3;
}
