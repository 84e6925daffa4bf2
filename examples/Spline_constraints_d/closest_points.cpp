// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All feet of the perpendiculars from three points to an ellipse, and the closest points of two cubic curves, in exact
// numbers; drawn into closest_points.svg.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;

// The segment from a point to another one, where there is a dot.
void draw_pair(SC::SVG_writer& picture, const K::Point_2& p, const K::Point_2& q, const std::string& color)
{
  picture.curve(SC::segment_curve(p, q), color, 1.5);
  picture.point(q, color);
}

int main()
{
  const Curve ellipse = SC::ellipse_curve(K::Point_2(0, 0), K::Vector_2(3, 0), K::Vector_2(0, 2));
  const std::vector<K::Point_2> points{{K::FT(1) / 2, K::FT(1) / 4}, {-3, 2}, {K::FT(5) / 2, -2}};
  const Curve first = SC::bezier_curve(std::vector<K::Point_2>{{4, 2}, {5, -3}, {6, 5}, {8, -1}}),
              second = SC::bezier_curve(std::vector<K::Point_2>{{5, -2}, {6, 2}, {8, -5}, {9, 1}});

  std::ofstream out("closest_points.svg");
  SC::SVG_writer picture(out, CGAL::Bbox_2(-3.6, -2.8, 9.4, 2.9), 780);
  for (const Curve& curve : {ellipse, first, second})
    picture.curve(curve, "#1f77b4", 2);

  std::vector<std::size_t> counts;
  bool is_complete = true;
  for (const K::Point_2& point : points) {
    const auto projections = SC::projections(point, ellipse); // the nearest first
    is_complete = is_complete && projections.summary().is_complete;
    counts.push_back(projections.feet().size());
    for (const auto& foot : projections.feet())
      draw_pair(picture, point, foot.point(1), &foot == &projections.feet().front() ? "#d62728" : "#999");
    picture.point(point, "#2ca02c");
    std::cout << "(" << point << ") has " << (projections.is_complete() ? "" : "at least ") << counts.back()
              << " feet, the nearest at the parameter " << projections.feet().front().parameter(1) << '\n';
  }

  const auto closest = SC::closest_points(first, second);
  for (const auto& pair : closest) {
    draw_pair(picture, pair.point(0), pair.point(1), "#d62728");
    picture.point(pair.point(0), "#d62728");
  }
  const auto [lower, upper] = closest.distance_range();
  picture.label(K::Point_2(-3.4, 2.6), "feet of the perpendiculars from three points");
  picture.label(K::Point_2(4, 2.6), "closest points, distance " + std::to_string(lower));
  std::cout.precision(17);
  std::cout << "distance of the cubic curves between " << lower << " and " << upper
            << (closest.is_unique() ? ", attained once\n" : "\n");
  return is_complete && counts == std::vector<std::size_t>{4, 2, 2} && closest.is_unique() && upper - lower < 1e-12 ? 0
                                                                                                                    : 1;
}
