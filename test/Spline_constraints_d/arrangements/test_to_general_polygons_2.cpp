// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Regions as general polygons of CGAL: points are on the same side of both, and Bezier arcs are those of the region.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/conversions/bezier_traits_curves.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/circle_segment_traits_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_general_polygons_2.h>

#include <CGAL/Arr_Bezier_curve_traits_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/Gps_traits_2.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace to_general_polygons_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using Kernel = Exact_cartesian;
using Point = Kernel::Point_2;
using Curve = SC::Bspline_curve_2<Kernel>;
using Circle_traits = CGAL::Gps_circle_segment_traits_2<Kernel>;
using Nt_traits = CGAL::CORE_algebraic_number_traits;
using Bezier_traits =
    CGAL::Gps_traits_2<CGAL::Arr_Bezier_curve_traits_2<CGAL::Cartesian<Nt_traits::Rational>,
                                                       CGAL::Cartesian<Nt_traits::Algebraic>, Nt_traits>>;

std::vector<Circle_traits::Polygon_with_holes_2> circular_polygons(const SC::Planar_region_2<Kernel>& region)
{
  return SC::to_general_polygons<Circle_traits>(
      region, [](const auto& piece) { return SC::to_circle_segment_traits_curves<Circle_traits::Curve_2>(piece); });
}

std::vector<Bezier_traits::Polygon_with_holes_2> bezier_polygons(const SC::Planar_region_2<Kernel>& region)
{
  return SC::to_general_polygons<Bezier_traits>(
      region, [](const auto& piece) { return SC::to_bezier_traits_curves<Bezier_traits::Curve_2>(piece); });
}

// A half disk with a round hole, and a disk in that.
TEST(General_polygons, circles_and_segments)
{
  const std::vector<Curve> curves{SC::circular_arc_curve(Point(0, 0), Point(10, 0), Point(-10, 0)),
                                  SC::segment_curve<Kernel>(Point(-10, 0), Point(10, 0)),
                                  SC::circle_curve(Point(0, 5), Exact_rational(3)),
                                  SC::circle_curve(Point(0, 5), Exact_rational(1))};
  const auto region = SC::planar_region(curves);
  const auto polygons = circular_polygons(region);
  ASSERT_EQ(polygons.size(), 2u);
  EXPECT_EQ(polygons[0].number_of_holes(), 1u);
  CGAL::General_polygon_set_2<Circle_traits> set;
  for (const auto& polygon : polygons)
    set.insert(polygon);
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(-12, 12);
  int inside = 0;
  for (int i = 0; i < 100; ++i) {
    const Point p(coordinate(random), Exact_rational(coordinate(random)) / 2 + 5);
    const CGAL::Bounded_side side = region.bounded_side(p);
    inside += side == CGAL::ON_BOUNDED_SIDE;
    EXPECT_EQ(static_cast<int>(set.oriented_side(Circle_traits::Point_2(p.x(), p.y()))), static_cast<int>(side)) << p;
  }
  EXPECT_GT(inside, 10);
}

// A part of y = x^2, and x = y (1 - y), which has a vertical tangent: two arcs.
TEST(General_polygons, bezier_curves)
{
  const auto parabola = SC::planar_region(
      std::vector<Curve>{SC::bezier_curve(std::vector<Point>{Point(-1, 1), Point(0, -1), Point(1, 1)}),
                         SC::segment_curve<Kernel>(Point(1, 1), Point(-1, 1))});
  const auto polygons = bezier_polygons(parabola);
  ASSERT_EQ(polygons.size(), 1u);
  const auto& outer = polygons[0].outer_boundary();
  ASSERT_EQ(outer.size(), 2u);
  EXPECT_EQ(outer.orientation(), CGAL::COUNTERCLOCKWISE);
  std::vector<SC::Bspline_curve_2<CGAL::Cartesian<Nt_traits::Rational>>> arcs;
  for (auto arc = outer.curves_begin(); arc != outer.curves_end(); ++arc)
    arcs.push_back(SC::to_bspline_curve(*arc));
  EXPECT_EQ(arcs[0].target(), arcs[1].source());
  EXPECT_EQ(arcs[1].target(), arcs[0].source());
  EXPECT_EQ(arcs[0].degree() + arcs[1].degree(), 3);
  const auto turning =
      SC::planar_region(std::vector<Curve>{SC::bezier_curve(std::vector<Point>{Point(0, 0), Point(1, 1), Point(0, 2)}),
                                           SC::segment_curve<Kernel>(Point(0, 2), Point(0, 0))});
  EXPECT_EQ(bezier_polygons(turning)[0].outer_boundary().size(), 3u);
}

// A square with a square hole, and a disk: polygons next to the sum, joined with a disk in the hole.
TEST(General_polygons, minkowski_sum)
{
  const auto outline = [](int size) {
    return SC::polyline_curve<Kernel>(
        {Point(-size, -size), Point(size, -size), Point(size, size), Point(-size, size), Point(-size, -size)});
  };
  const auto frame = SC::planar_region(std::vector<Curve>{outline(6), outline(5)});
  const auto polygons = SC::minkowski_sum(frame, SC::planar_region(SC::circle_curve(Point(0, 0), Exact_rational(1))))
                            .polygons_with_holes(0.125);
  ASSERT_EQ(polygons.size(), 1u);
  const auto general = circular_polygons(SC::planar_region(polygons.front()));
  ASSERT_EQ(general.size(), 1u);
  EXPECT_EQ(general[0].number_of_holes(), 1u);
  CGAL::General_polygon_set_2<Circle_traits> set(general[0]);
  set.join(circular_polygons(SC::planar_region(SC::circle_curve(Point(0, 0), Exact_rational(2))))[0]);
  for (const int x : {0, 1, 3, 5, 6, 8})
    EXPECT_EQ(set.oriented_side(Circle_traits::Point_2(x, 0)) == CGAL::ON_POSITIVE_SIDE, x != 3 && x != 8) << x;
}

TEST(General_polygons, other_curves_are_refused)
{
  const auto parabola = SC::planar_region(
      std::vector<Curve>{SC::segment_curve<Kernel>(Point(1, 1), Point(-1, 1)),
                         SC::bezier_curve(std::vector<Point>{Point(-1, 1), Point(0, -1), Point(1, 1)})});
  expect_invalid([&] { circular_polygons(parabola); }, "curve 1 is no curve of the traits class");
  expect_invalid([&] { bezier_polygons(SC::planar_region(SC::circle_curve(Point(0, 0), Exact_rational(1)))); },
                 "curve 0 is no curve of the traits class");
}

} // namespace

} // namespace to_general_polygons_2_test
