// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All closed paths of a ray that three circles reflect, once each, drawn into ray_traps.svg side by side.
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/ray_traps_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;

int main()
{
  const std::vector<K::Point_2> centers{{0, 0}, {5, 0}, {1, 6}};
  const std::vector<int> radii{1, 2, 1};
  std::vector<SC::Bspline_curve_2<K>> circles;
  for (std::size_t i = 0; i < centers.size(); ++i)
    circles.push_back(SC::circle_curve(centers[i], K::FT(radii[i])));

  const auto result = SC::ray_traps(circles);

  constexpr double scale = 18, cell = 200;
  std::ofstream out("ray_traps.svg");
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 800 410' width='800' height='410'>\n<style>circle { "
         "fill: #eef; stroke: #1f77b4; stroke-width: 1.5 }"
         " polygon { fill: none; stroke: #d62728; stroke-width: 1.8 } text { font: 12px sans-serif; fill: #223 "
         "}</style>\n<rect width='800' height='410' fill='white'/>\n";
  std::size_t count = 0;
  for (const auto& trap : result.traps()) {
    double length = 0;
    for (std::size_t i = 0; i < 3; ++i)
      length += std::sqrt(CGAL::to_double(CGAL::squared_distance(trap.points()[i], trap.points()[(i + 1) % 3])));
    std::cout << trap.solution().kind() << ", perimeter " << length << '\n';
    const double x = cell * static_cast<double>(count % 4) + 45, y = cell * static_cast<double>(count / 4) + 150;
    ++count;
    out << "<g transform='translate(" << x << ' ' << y << ")'>\n";
    for (std::size_t i = 0; i < centers.size(); ++i)
      out << "<circle cx='" << scale * CGAL::to_double(centers[i].x()) << "' cy='"
          << -scale * CGAL::to_double(centers[i].y()) << "' r='" << scale * radii[i] << "'/>\n";
    out << "<polygon points='";
    for (const K::Point_2& p : trap.points())
      out << scale * CGAL::to_double(p.x()) << ',' << -scale * CGAL::to_double(p.y()) << ' ';
    out << "'/>\n<text x='30' y='52'>perimeter " << std::round(length * 1000) / 1000 << "</text>\n</g>\n";
  }
  out << "</svg>\n";
  std::cout << "complete: " << (result.summary().is_complete ? "yes" : "no") << '\n';
  return result.summary().is_complete && count == 8 ? 0 : 1;
}
