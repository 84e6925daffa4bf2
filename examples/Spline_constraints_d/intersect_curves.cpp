// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Intersects a circle with three other curves, in exact numbers, and draws them into intersect_curves.svg: a cubic that
// crosses it, a line that touches it, and an arc that lies on a piece of it.
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;

constexpr double scale = 60;

// The points of a curve between two parameters as an SVG path.
void write_path(std::ostream& out, const Curve& curve, const K::FT& begin, const K::FT& end, const char* style)
{
  constexpr int steps = 120;
  out << "<path class='" << style << "' d='";
  for (int i = 0; i <= steps; ++i) {
    const K::Point_2 p = curve(begin + (end - begin) * i / steps);
    out << (i == 0 ? 'M' : 'L') << scale * CGAL::to_double(p.x()) << ' ' << -scale * CGAL::to_double(p.y()) << ' ';
  }
  out << "'/>\n";
}

int main()
{
  const Curve circle = SC::circle_curve(K::Point_2(0, 0), K::FT(2));
  const std::vector<Curve> others{
    SC::bezier_curve(std::vector<K::Point_2>{{-3, 1}, {-1, -6}, {1, 6}, {3, -1}}),            // crosses
    SC::segment_curve(K::Point_2(0, K::FT(5) / 2), K::Point_2(-3, K::FT(1) / 4)),             // touches at (-6/5,8/5)
    SC::circle_curve(K::Point_2(0, 0), K::FT(2)).restricted(K::FT(5) / 2, K::FT(7) / 2)};     // overlaps

  std::ofstream out("intersect_curves.svg");
  out << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='-200 -200 400 340' width='600' height='510'>\n<style>"
         "path { fill: none; stroke-width: 2 } .circle { stroke: #1f77b4 } .other { stroke: #777 } .overlap { stroke: "
         "#d62728; stroke-width: 8; stroke-opacity: 0.45 }"
         " circle { stroke: white; stroke-width: 1 } text { font: 12px sans-serif; fill: #223 }</style>\n<rect "
         "x='-200' y='-200' width='400' height='340' fill='white'/>\n";
  write_path(out, circle, 0, 4, "circle");
  bool is_complete = true;
  std::size_t crossings = 0, contacts = 0, overlaps = 0;
  for (const Curve& other : others) {
    const auto [begin, end] = other.domain(0);
    write_path(out, other, begin, end, "other");
    const auto intersections = SC::intersections(circle, other);
    is_complete = is_complete && intersections.is_complete();
    for (const auto& x : intersections) {
      std::cout << x.kind() << " at " << x.parameter(0) << " and " << x.parameter(1);
      if (x.kind() == SC::Intersection_kind::OVERLAP) {
        std::cout << ", a piece of the circle from " << x.parameter_range(0).first << " to "
                  << x.parameter_range(0).second << '\n';
        write_path(out, circle, K::FT(x.parameter_range(0).first), K::FT(x.parameter_range(0).second), "overlap");
        ++overlaps;
        continue;
      }
      std::cout << ", counts " << x.multiplicity() << ", near (" << x.point() << ")\n";
      const bool is_tangent = x.kind() == SC::Intersection_kind::TANGENT;
      is_tangent ? ++contacts : ++crossings;
      const double px = scale * CGAL::to_double(x.point().x()), py = -scale * CGAL::to_double(x.point().y());
      out << "<circle cx='" << px << "' cy='" << py << "' r='5' fill='" << (is_tangent ? "#d62728" : "#2ca02c")
          << "'/>\n<text x='" << px + 8 << "' y='" << py - 6 << "'>" << x.kind() << "</text>\n";
    }
  }
  out << "<text x='-190' y='-182'>" << crossings << " crossings, " << contacts << " contact, " << overlaps
      << " overlap; complete: " << (is_complete ? "yes" : "no") << "</text>\n</svg>\n";
  std::cout << "complete: " << (is_complete ? "yes" : "no") << '\n';
  return is_complete && crossings == 2 && contacts == 1 && overlaps == 1 ? 0 : 1;
}
