// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A curve that weaves through a surface, and a ray through both of them, in exact numbers; drawn into
// intersect_surfaces.svg. Then lines and planes with a sphere.
#include <CGAL/Spline_constraints_d/IO/write_SVG.h>
#include <CGAL/Spline_constraints_d/operations/intersections/contact_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <fstream>
#include <iostream>
#include <string>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = K::Point_3;

// Parallel projection onto the plane of the picture.
K::Point_2 projected(const Point& p) { return {p.x() - p.y() * 3 / 5, p.z() + (p.x() + p.y()) / 5}; }

SC::Bspline_curve_2<K> projected(const SC::Bspline_curve_3<K>& curve)
{
  std::vector<K::Point_2> points;
  for (const Point& p : curve.control_points())
    points.push_back(projected(p));
  return {curve.degree(), curve.knots(), points};
}

int main()
{
  std::vector<Point> net;   // of a bicubic patch over a square
  const int heights[] = {0, 1, 1, 0, 1, 3, 2, 1, 1, 2, 3, 1, 0, 1, 1, 0};
  for (int i = 0; i < 16; ++i)
    net.emplace_back(2 * (i / 4), 2 * (i % 4), heights[i]);
  const SC::Bspline_surface_3<K> surface({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, net);
  const auto curve = SC::bezier_curve(
      std::vector<Point>{{0.5, 5, 2.5}, {1.5, 5, -10.5}, {2.5, 4, 26}, {3.5, 2, -21}, {4.5, 1, 12.5}, {5.5, 1, -1.5}});
  const K::Ray_3 ray(Point(-1, 4, 0.5), Point(0, 3.75, 0.75));

  std::ofstream file("intersect_surfaces.svg");
  SC::SVG_writer picture(file, CGAL::Bbox_2(-5, -1, 7.5, 6.5), 640);
  for (int k = 0; k <= 12; ++k)
    for (const int axis : {0, 1})
      picture.curve(projected(surface.iso_curve(axis, K::FT(k) / 12)), k % 12 == 0 ? "#555" : "#b8c4d0",
                    k % 12 == 0 ? 1.5 : 0.8);
  picture.curve(projected(SC::segment_curve(ray.source(), ray.point(8))), "#ff7f0e", 2);

  // in order along the curve and the ray
  const auto crossings = SC::intersections(curve, surface), hits = SC::intersections(ray, surface);
  double begin = 0;
  const char* color = "#1f77b4";   // dark above the surface, light below
  for (const auto& x : crossings) {
    picture.curve(projected(curve.restricted(begin, x.parameter(0))), color, 2.5);
    color = color[1] == '1' ? "#a9d0ea" : "#1f77b4";
    begin = x.parameter(0);
    std::cout << "The curve at " << x.parameter(0) << " passes the surface at (" << x.parameter(1, 0) << ", "
              << x.parameter(1, 1) << ").\n";
  }
  picture.curve(projected(curve.restricted(begin, 1)), color, 2.5);
  for (const auto& x : crossings)
    picture.point(projected(x.point()), "#d62728");
  for (const auto& x : hits)
    picture.point(projected(x.point()), "#2ca02c");
  picture.label(K::Point_2(-4.8, 6.1),
                std::to_string(crossings.size()) + " points of the curve (red), " + std::to_string(hits.size()) +
                    " of the ray (green)");

  // The axis of the sphere passes its poles; a line touches it, and so does a plane.
  const K::Sphere_3 sphere(Point(0, 0, 0), 9);
  const auto axis = SC::intersections(K::Line_3(Point(0, 0, 0), K::Vector_3(0, 0, 1)), sphere);
  const auto touching = SC::intersections(K::Line_3(Point(2, 1, 2), K::Vector_3(1, -2, 0)), sphere);
  const auto contact = SC::contact_points(sphere, K::Plane_3(2, 1, 2, -9));
  std::cout << "The axis meets the sphere in " << axis.size() << " points; the line: " << touching[0].kind()
            << "; the plane: " << contact[0].kind() << ".\n";
  const bool is_complete = crossings.is_complete() && hits.is_complete() && axis.is_complete() &&
      touching.is_complete() && contact.is_complete();
  return is_complete && crossings.size() == 5 && axis.size() == 2 && touching.size() == 1 && contact.size() == 1 ? 0
                                                                                                                 : 1;
}
