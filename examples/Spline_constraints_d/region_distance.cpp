// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How far a part can be moved before it collides: the distance of two regions, with the points where they are nearest,
// for several positions.
//
//   region_distance
//
// Writes region_distance.svg: an obstacle (gray), and a part in five positions, each with its nearest points; red where
// it collides. Exit status: 0 when all is proved, 3 when something is not.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/distances/region_distances_2.h>

#include <CGAL/Simple_cartesian.h>

#include <fstream>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Curve = SC::Bspline_curve_2<K>;

int main()
{
  const std::vector<Curve> boundary{SC::bezier_curve(std::vector<K::Point_2>{{0, 0}, {12, 0}}),
                                    SC::bezier_curve(std::vector<K::Point_2>{{12, 0}, {12, 2}, {9, 1}, {8, 3}}),
                                    SC::bezier_curve(std::vector<K::Point_2>{{8, 3}, {7, 5}, {4, 0}, {3, 4}}),
                                    SC::bezier_curve(std::vector<K::Point_2>{{3, 4}, {2, 7}, {0, 4}, {0, 0}})};
  const auto obstacle = SC::planar_region(boundary);
  std::ofstream file("region_distance.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-0.5, -0.5, 12.5, 6.5), 700);
  picture.layer("obstacle");
  for (const auto& polygon : obstacle.polygons_with_holes(0.001))
    picture.polygon(std::vector<K::Point_2>(polygon.outer_boundary().begin(), polygon.outer_boundary().end()),
                    "#dddddd");
  for (const Curve& curve : boundary)
    picture.curve(curve, "black", 3);

  bool is_complete = true;
  for (const auto& [x, y] :
       {std::pair(4.5, 5.0), std::pair(5.25, 3.75), std::pair(6.75, 5.0), std::pair(8.75, 4.0), std::pair(10.5, 2.0)}) {
    const Curve part =
        Curve::from_periodic(3, {0, 1, 2, 3, 4, 5},
                             {K::Point_2(x, y + 1), K::Point_2(x - 1, y + 0.25), K::Point_2(x - 0.5, y - 1),
                              K::Point_2(x + 0.5, y - 1), K::Point_2(x + 1, y + 0.25)});
    const auto distance = SC::region_distance(obstacle, SC::planar_region(part));
    is_complete = is_complete && distance.is_complete();
    picture.layer("part at " + std::to_string(x));
    picture.curve(part, CGAL::possibly(distance.do_meet()) ? "#d62728" : "#1f77b4", 3);
    if (CGAL::certainly(!distance.do_meet()))
      for (const auto& pair : distance.pairs()) {
        picture.curve(SC::segment_curve<K>(pair.points.point(0), pair.points.point(1)), "#2ca02c", 3);
        for (const std::size_t side : {0, 1})
          picture.point(pair.points.point(side), "#2ca02c", 5);
      }
    const auto [lower, upper] = distance.distance_range();
    std::cout << "part at (" << x << ", " << y << "): " << (CGAL::possibly(distance.do_meet()) ? "collides" : "is free")
              << ", distance " << lower << ", error at most " << upper - lower << '\n';
  }
  return is_complete ? 0 : 3;
}
