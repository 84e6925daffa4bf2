// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Regions as polygons and as well-known text: exact texts of polygons and circular arcs, holes of the right parts,
// distances of corners from curves.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/IO/write_WKT.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace write_WKT_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using Kernel = Exact_cartesian;
using Point = Kernel::Point_2;
using Curve = SC::Bspline_curve_2<Kernel>;
using Polygon = CGAL::Polygon_2<Kernel>;
using Polygons = std::vector<CGAL::Polygon_with_holes_2<Kernel>>;

template <class... Arguments>
std::string written(const Arguments&... arguments)
{
  std::ostringstream out;
  SC::IO::write_WKT(out, arguments...);
  return out.str();
}

Curve polygon(std::vector<Point> points)
{
  points.push_back(Point(points.front()));
  return SC::polyline_curve<Kernel>(points);
}

Curve square(int x, int y, int size)
{
  return polygon({Point(x, y), Point(x + size, y), Point(x + size, y + size), Point(x, y + size)});
}

TEST(Write_WKT, polygons)
{
  EXPECT_EQ(written(Polygons()), "MULTIPOLYGON EMPTY\n");
  const std::vector<Point> corners{Point(0, 0), Point(Exact_rational(1) / 2, 0), Point(0, Exact_rational(1) / 3)};
  const Polygon triangle(corners.begin(), corners.end());
  EXPECT_EQ(written(Polygons{CGAL::Polygon_with_holes_2<Kernel>(triangle)}),
            "POLYGON ((0 0, 0.5 0, 0 0.3333333333333333, 0 0))\n");
  expect_invalid([] { written(Polygons(1)); }, "less than three corners");
}

// A square in the hole of another one, and one beside them: three parts, one with a hole.
TEST(Write_WKT, parts_with_holes)
{
  const auto region =
      SC::planar_region(std::vector<Curve>{square(2, 2, 1), square(1, 1, 4), square(0, 0, 6), square(7, 0, 1)});
  const auto polygons = region.polygons_with_holes(1);
  ASSERT_EQ(polygons.size(), 3u);
  EXPECT_EQ(polygons[0].number_of_holes(), 0u);
  EXPECT_EQ(polygons[1].number_of_holes(), 1u);
  Exact_rational area(0);
  for (const auto& part : polygons) {
    area += part.outer_boundary().area();
    for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole)
      area += hole->area();
  }
  EXPECT_EQ(area, 1 + 36 - 16 + 1);
  const std::string text = "MULTIPOLYGON (((2 2, 3 2, 3 3, 2 3, 2 2)), ((0 0, 6 0, 6 6, 0 6, 0 0), (1 1, 1 5, 5 5, 5 "
                           "1, 1 1)), ((7 0, 8 0, 8 1, 7 1, 7 0)))\n";
  EXPECT_EQ(written(region, 1.0), text);
  EXPECT_EQ(written(polygons), text);
}

TEST(Write_WKT, circular_arcs)
{
  const Curve disk = SC::circle_curve(Point(0, 0), Exact_rational(5));
  EXPECT_TRUE(written(SC::planar_region(disk), 1.0).starts_with("CURVEPOLYGON (CIRCULARSTRING (5 0, "));
  // A half disk: an arc with its middle, and a diameter.
  const auto half = SC::planar_region(std::vector<Curve>{SC::circular_arc_curve(Point(0, 0), Point(5, 0), Point(-5, 0)),
                                                         SC::segment_curve<Kernel>(Point(-5, 0), Point(5, 0))});
  EXPECT_EQ(written(half, 1.0),
            "CURVEPOLYGON (COMPOUNDCURVE (CIRCULARSTRING (5 0, 3 4, 0 5, -3 4, -5 0), (-5 0, 5 0)))\n");
  const auto both = SC::planar_region(std::vector<Curve>{disk, square(10, 0, 1)});
  EXPECT_TRUE(written(both, 1.0).starts_with("MULTISURFACE (CURVEPOLYGON (CIRCULARSTRING (5 0, "));
  EXPECT_TRUE(written(both, 1.0).ends_with(", ((10 0, 11 0, 11 1, 10 1, 10 0)))\n"));
}

// Between y = x^2 and y = 1.
TEST(Write_WKT, other_curves_are_chords)
{
  const auto region = SC::planar_region(
      std::vector<Curve>{SC::bezier_curve(std::vector<Point>{Point(-1, 1), Point(0, -1), Point(1, 1)}),
                         SC::segment_curve<Kernel>(Point(1, 1), Point(-1, 1))});
  for (const double error : {0.1, 0.001}) {
    const auto polygons = region.polygons_with_holes(error);
    ASSERT_EQ(polygons.size(), 1u);
    const Polygon& polygon = polygons[0].outer_boundary();
    EXPECT_TRUE(polygon.is_simple());
    for (std::size_t i = 0; i + 1 < polygon.size(); ++i) {
      const double x = CGAL::to_double(polygon[i].x()), y = CGAL::to_double(polygon[i].y()),
                   next = CGAL::to_double(polygon[i + 1].x());
      EXPECT_NEAR(y, x * x, 1e-15);
      // the height of the chord over the arc is this, but for its slope
      EXPECT_LE((next - x) * (next - x) / 4, error * std::hypot(1, x + next) * 1.0001);
    }
    EXPECT_EQ(written(region, error), written(polygons));
    EXPECT_NEAR(CGAL::to_double(polygon.area()), 4.0 / 3, 2 * error);
  }
  expect_invalid([&] { region.polygons_with_holes(0); }, "error must be positive");
  expect_invalid([&] { written(region, 0.0); }, "error must be positive");
}

} // namespace

} // namespace write_WKT_test
