// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where a closed B-spline curve crosses itself, drawn into self_intersections.svg: in two colors, as the later branch
// comes from the right or from the left.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/intersections/self_intersections.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;

int main()
{
  const std::vector<K::Point_2> points{{7, 1}, {-7, 4}, {4, -6}, {-1, 8}, {-3, -8}, {6, 5}, {-8, -2}};
  std::vector<K::FT> period;
  for (std::size_t i = 0; i <= points.size(); ++i)
    period.push_back(K::FT(static_cast<int>(i)));
  const Curve curve = Curve::from_periodic(3, period, points);

  std::ofstream file("self_intersections.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-3.5, -3.9, 3, 3.2), 640);
  picture.curve(curve, "#4b6a88", 2);

  int from_right = 0;
  const auto crossings = SC::self_intersections(curve);
  for (const auto& x : crossings) {
    // Middles of tiny ranges: good enough for a color.
    const bool is_from_right = CGAL::orientation(curve.tangent(K::FT(x.parameter(0))),
                                                 curve.tangent(K::FT(x.parameter(1)))) == CGAL::LEFT_TURN;
    from_right += is_from_right ? 1 : 0;
    picture.point(x.point(), is_from_right ? "#d95f02" : "#1b9e77", 11);
    std::cout << x.kind() << " at " << x.parameter(0) << " and " << x.parameter(1) << ", near ("
              << CGAL::to_double(x.point().x()) << ", " << CGAL::to_double(x.point().y()) << ")\n";
  }

  const std::string summary = std::to_string(crossings.size()) + " crossings; at " + std::to_string(from_right) +
      " (orange) the later branch comes from the right; complete: " + (crossings.is_complete() ? "yes" : "no");
  picture.label(K::Point_2(-3.4, -3.8), summary);
  std::cout << summary << '\n';
  return crossings.is_complete() && crossings.count(SC::Intersection_kind::TRANSVERSAL) == crossings.size() ? 0 : 1;
}
