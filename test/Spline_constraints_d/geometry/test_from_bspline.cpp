// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/clipped_lines.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_surface.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <vector>

namespace from_bspline_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Epeck;
using I = CGAL::Epick;

TEST(From_bspline, gives_segments_and_polygons_back)
{
  const K::Segment_2 segment({1, 2}, {4, 6});
  const auto curve = SC::to_bspline_curve(segment);
  EXPECT_EQ(SC::to_segment(curve), segment);
  EXPECT_EQ(SC::to_segment(curve.elevated(4).with_knot(0.25)), segment);
  // The same points at another speed.
  EXPECT_FALSE(SC::to_segment(SC::bezier_curve<K>(std::vector<K::Point_2>{{1, 2}, {1, 2}, {4, 6}})));
  EXPECT_FALSE(SC::to_segment(SC::bezier_curve<K>(std::vector<K::Point_2>{{0, 0}, {1, 0}, {2, 1}})));

  const I::Segment_3 in_space({1, 2, 3}, {4, 5, 0.1});
  EXPECT_EQ(SC::to_segment(SC::to_bspline_curve(in_space)), in_space);

  CGAL::Polygon_2<K> polygon;
  for (const K::Point_2& p : {K::Point_2(0, 0), {4, 0}, {4, 4}, {1, 5}, {0, 2}})
    polygon.push_back(p);
  const auto boundary = SC::to_bspline_curve(polygon);
  EXPECT_EQ(SC::to_polygon(boundary.elevated(2)), polygon);
  EXPECT_FALSE(SC::to_segment(boundary));
  EXPECT_FALSE(SC::to_polygon(curve));
  // A vertex at which nothing changes is none.
  const auto straight = SC::to_polyline(SC::polyline_curve<K>(std::vector<K::Point_2>{{0, 0}, {1, 1}, {2, 2}, {3, 0}}));
  EXPECT_EQ(straight, (std::vector<K::Point_2>{{0, 0}, {2, 2}, {3, 0}}));
  // Its ends have the parameters 2 and 4: thirds, no doubles.
  const SC::Bspline_curve_2<I> floating(2, {0, 1, 2, 4, 5, 6}, {{0, 0}, {0.5, 1}, {1, 2}});
  EXPECT_FALSE(SC::to_segment(floating));
  EXPECT_EQ(SC::to_segment(SC::Bspline_curve_2<K>(floating)),
            K::Segment_2(K::Point_2(K::FT(1) / 6, K::FT(1) / 3), K::Point_2(K::FT(5) / 6, K::FT(5) / 3)));
}

TEST(From_bspline, gives_triangles_rectangles_and_lines_back)
{
  const K::Triangle_2 triangle({0, 0}, {4, 1}, {1, 5});
  EXPECT_EQ(SC::to_triangle(SC::to_bspline_curve(triangle).elevated(3)), triangle);
  const I::Triangle_3 in_space({0, 0, 0.1}, {4, 1, 2}, {1, 5, 7});
  EXPECT_EQ(SC::to_triangle(SC::to_bspline_curve(in_space)), in_space);
  const I::Iso_rectangle_2 rectangle({0.1, 1}, {0.3, 2});
  const auto boundary = SC::to_bspline_curve(rectangle);
  EXPECT_EQ(SC::to_iso_rectangle(boundary), rectangle);
  EXPECT_EQ(SC::to_iso_rectangle(boundary.reversed()), rectangle);
  EXPECT_FALSE(SC::to_triangle(boundary));
  EXPECT_FALSE(SC::to_iso_rectangle(boundary.restricted(0, 2)));
  EXPECT_FALSE(SC::to_iso_rectangle(SC::to_bspline_curve(triangle)));
  using Points = std::vector<K::Point_2>;
  EXPECT_TRUE(SC::to_iso_rectangle(SC::polyline_curve<K>(Points{{0, 1}, {2, 1}, {2, 0}, {0, 0}, {0, 1}})));
  EXPECT_FALSE(SC::to_iso_rectangle(SC::polyline_curve<K>(Points{{0, 1}, {2, 1}, {2, 0}, {2, 1}, {0, 1}})));
  EXPECT_FALSE(SC::to_iso_rectangle(SC::polyline_curve<K>(Points{{0, 1}, {2, 0}, {2, 1}, {0, 0}, {0, 1}})));
  EXPECT_FALSE(SC::to_iso_rectangle(SC::polyline_curve<K>(Points{{0, 1}, {2, 1}, {2, 0}, {1, 0}, {0, 1}})));

  const K::Line_2 line(K::Point_2(1, 2), K::Point_2(4, 6));
  const K::Iso_rectangle_2 window({-10, -10}, {10, 10});
  EXPECT_EQ(SC::to_line(*SC::to_bspline_curve(line, window)), line);
  EXPECT_EQ(SC::to_line(*SC::to_bspline_curve(line.opposite(), window)), line.opposite());
  const K::Ray_2 ray(K::Point_2(1, 2), K::Point_2(4, 6));
  const auto part = *SC::to_bspline_curve(ray, window);
  EXPECT_EQ(SC::to_line(part), ray.supporting_line());
  EXPECT_EQ(SC::to_segment(part)->source(), ray.source());
  EXPECT_EQ(SC::to_line(SC::bezier_curve<K>(Points{{1, 2}, {1, 2}, {4, 6}})), line);   // at another speed
  EXPECT_EQ(SC::to_line(SC::bezier_curve<K>(Points{{1, 2}, {4, 6}, {1, 2}})), line);   // and back
  EXPECT_FALSE(SC::to_line(SC::bezier_curve<K>(Points{{0, 0}, {1, 0}, {2, 1}})));
  EXPECT_FALSE(SC::to_line(SC::bezier_curve<K>(Points{{1, 1}, {1, 1}})));
  const K::Line_3 line_in_space(K::Point_3(1, 2, 3), K::Point_3(2, 0, 7));
  EXPECT_EQ(SC::to_line(*SC::to_bspline_curve(line_in_space, K::Iso_cuboid_3({0, 0, 0}, {9, 9, 9}))), line_in_space);
}

TEST(From_bspline, gives_circles_back)
{
  for (const CGAL::Orientation orientation : {CGAL::COUNTERCLOCKWISE, CGAL::CLOCKWISE}) {
    const K::Circle_2 circle({1, 2}, 5, orientation);
    const auto curve = SC::to_bspline_curve(circle);
    EXPECT_EQ(SC::to_circle(curve), circle);
    EXPECT_EQ(SC::to_circle(curve.elevated(4)), circle);
    EXPECT_EQ(SC::to_circle(curve.restricted(0.25, 1.75)), circle);
    EXPECT_EQ(SC::to_circle(curve.reversed()), circle.opposite());
  }
  EXPECT_FALSE(SC::to_circle(SC::ellipse_curve<K>(K::Point_2(0, 0), K::Vector_2(2, 0), K::Vector_2(0, 2.0000001))));
  EXPECT_FALSE(SC::to_circle(SC::to_bspline_curve(K::Segment_2({0, 0}, {1, 1}))));
  EXPECT_TRUE(SC::to_circle(SC::circle_curve<I>(I::Point_2(1, 2), 3)));
  // Doubles that are not on a circle any more.
  EXPECT_FALSE(SC::to_circle(SC::circle_curve<I>(I::Point_2(0, 0), 1).restricted(0.1, 0.7)));
}

TEST(From_bspline, gives_random_polygonal_curves_back)
{
  Random_geometry random(11);
  for (int i = 0; i < 20; ++i) {
    const auto points = random.points<Exact_cartesian, 3>(static_cast<std::size_t>(random.integer(2, 6)));
    const auto curve = SC::polyline_curve<Exact_cartesian>(points);
    EXPECT_EQ(SC::to_polyline(curve.elevated(random.integer(1, 4)).with_domain(-1, 2)), points);
    // With a control point moved it is none.
    const auto elevated = curve.elevated(2);
    auto moved = elevated.control_points();
    moved[1] = moved[1] + Exact_cartesian::Vector_3(0, 0, 1);
    EXPECT_FALSE(SC::to_polyline(SC::Bspline_curve_3<Exact_cartesian>(2, elevated.knots(), moved)));
  }
}

TEST(From_bspline, gives_circles_in_space_back)
{
  using E = Exact_cartesian;
  const E::Circle_3 circle(E::Point_3(1, 2, 3), 6, E::Vector_3(1, 1, 1));
  const auto back = SC::to_circle(SC::to_bspline_curve(circle).elevated(3));
  ASSERT_TRUE(back);
  EXPECT_TRUE(*back == circle);
  const auto lazy = SC::to_circle(SC::to_bspline_curve(K::Circle_3(K::Point_3(1, 2, 3), 6, K::Vector_3(1, 1, 1))));
  ASSERT_TRUE(lazy);
  EXPECT_EQ(lazy->center(), K::Point_3(1, 2, 3));
  EXPECT_EQ(lazy->squared_radius(), 6);
  EXPECT_FALSE(SC::to_circle(SC::bezier_curve<K>(std::vector<K::Point_3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 1}})));
}

TEST(From_bspline, gives_planes_and_spheres_back)
{
  using E = Exact_cartesian;
  const E::Sphere_3 sphere({1, 2, 3}, 3);
  const auto surface = SC::to_bspline_surface(sphere);
  EXPECT_TRUE(SC::to_sphere(surface) == sphere);
  EXPECT_FALSE(SC::to_plane(surface));
  const E::Plane_3 plane(1, 2, -3, 4);
  const auto patch = SC::to_bspline_surface(plane, E::Iso_cuboid_3({0, 0, 0}, {1, 2, 3}));
  const auto found = SC::to_plane(patch);
  ASSERT_TRUE(found);
  EXPECT_TRUE(*found == plane || found->opposite() == plane);
  EXPECT_FALSE(SC::to_sphere(patch));
  const auto saddle =
      SC::bilinear_surface<E>(E::Point_3(0, 0, 0), E::Point_3(1, 0, 0), E::Point_3(0, 1, 0), E::Point_3(1, 1, 1));
  EXPECT_FALSE(SC::to_plane(saddle));
  EXPECT_FALSE(SC::to_sphere(saddle));
}

} // namespace

} // namespace from_bspline_test
