// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets, Minkowski sums and regions as general polygons of segments and circular arcs: areas against closed forms,
// points against distances, and Boolean operations of CGAL.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/swept_areas_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_circular_polygons_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

namespace to_circular_polygons_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = Double_cartesian;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Traits = CGAL::Gps_circle_segment_traits_2<Exact_cartesian>;
using Polygons = std::vector<Traits::Polygon_with_holes_2>;
using Polygon_set = CGAL::General_polygon_set_2<Traits>;

SC::Planar_region_2<K> polygon(const std::vector<Point>& points)
{
  return SC::planar_region(CGAL::Polygon_2<K>(points.begin(), points.end()));
}

// The area between x-monotone arcs and the x-axis, with that between arcs and their chords.
double area(const Traits::Polygon_2& polygon)
{
  double result = 0;
  for (auto arc = polygon.curves_begin(); arc != polygon.curves_end(); ++arc) {
    const double x = CGAL::to_double(arc->source().x()), y = CGAL::to_double(arc->source().y()),
                 x1 = CGAL::to_double(arc->target().x()), y1 = CGAL::to_double(arc->target().y());
    result += (x * y1 - x1 * y) / 2;
    if (arc->is_circular()) {
      const double radius = std::sqrt(CGAL::to_double(arc->supporting_circle().squared_radius())),
                   angle = 2 * std::asin(std::min(1.0, std::hypot(x1 - x, y1 - y) / (2 * radius)));
      result +=
          (arc->orientation() == CGAL::COUNTERCLOCKWISE ? 1 : -1) * radius * radius * (angle - std::sin(angle)) / 2;
    }
  }
  return result;
}

double total_area_of(const Polygons& polygons)
{
  double result = 0;
  for (const auto& polygon : polygons) {
    result += area(polygon.outer_boundary());
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
      result += area(*hole);
  }
  return result;
}

Polygon_set set_of(const Polygons& polygons)
{
  Polygon_set result;
  for (const auto& polygon : polygons)
    result.join(polygon);
  return result;
}

bool is_inside(const Polygon_set& set, const Point& p)
{
  return set.oriented_side(Traits::Point_2(Exact_rational(p.x()), Exact_rational(p.y()))) == CGAL::ON_POSITIVE_SIDE;
}

// An offset of a square consists of its sides and a few arcs at each corner, with any error.
TEST(Circular_polygons, offset_of_a_square)
{
  const auto offset = SC::trimmed_offset(polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), 1);
  for (const double error : {1e-2, 1e-3, 1e-5}) {
    const Polygons polygons = SC::to_circular_polygons<Traits>(offset, error);
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_LE(polygons[0].outer_boundary().size(), 14u);
    EXPECT_NEAR(total_area_of(polygons), 16 + 16 + CGAL_PI, 20 * error);
    EXPECT_FALSE(polygons[0].has_holes());
  }
}

// The sum of a disk and a ring is a ring; without two disks that cut into it, points are where distances tell.
TEST(Circular_polygons, sum_with_a_hole_and_a_difference)
{
  const auto ring =
      SC::planar_region(std::vector<Curve>{SC::circle_curve(Point(0, 0), 5.0), SC::circle_curve(Point(0, 0), 3.0)});
  const Polygons sum = SC::to_circular_polygons<Traits>(
      SC::minkowski_sum(ring, SC::planar_region(SC::circle_curve(Point(0, 0), 1.0))), 1e-3);
  ASSERT_EQ(sum.size(), 1u);
  EXPECT_EQ(sum[0].number_of_holes(), 1u);
  EXPECT_NEAR(total_area_of(sum), 32 * CGAL_PI, 1e-4);
  Polygon_set set = set_of(sum);
  for (const double x : {-6, 6})
    for (const auto& disk :
         SC::to_circular_polygons<Traits>(SC::trimmed_offset(std::vector<Curve>(), 1.5, {Point(x, 0)}), 1e-3))
      set.difference(disk);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-7, 7);
  int inside = 0;
  for (int i = 0; i < 100; ++i) {
    const Point p(coordinate(random), coordinate(random));
    const double radius = std::hypot(p.x(), p.y()),
                 other = std::min(std::hypot(p.x() - 6, p.y()), std::hypot(p.x() + 6, p.y()));
    if (std::min({std::abs(radius - 2), std::abs(radius - 6), std::abs(other - 1.5)}) > 1e-3) {
      EXPECT_EQ(is_inside(set, p), radius > 2 && radius < 6 && other > 1.5) << p;
      inside += is_inside(set, p);
    }
  }
  EXPECT_GT(inside, 30);
}

// Free curves: all vertices have the distance of the offset from the curves, the area is that of fine chords, and arcs
// are fewer than chords.
TEST(Circular_polygons, offset_of_free_curves)
{
  const std::vector<Curve> curves{SC::bezier_curve(std::vector<Point>{{0, 0}, {2, 5}, {5, -4}, {7, 2}}),
                                  SC::bezier_curve(std::vector<Point>{{7, 2}, {4, 9}, {-3, 4}, {0, 0}})};
  const auto region = SC::planar_region(curves);
  std::vector<Point> samples;
  for (const Curve& curve : curves)
    for (int i = 0; i <= 500; ++i)
      samples.push_back(curve(i / 500.0));
  for (const double distance : {0.75, -0.25}) {
    const auto offset = SC::trimmed_offset(region, distance);
    ASSERT_TRUE(offset.is_complete());
    const double error = 1e-3;
    const Polygons polygons = SC::to_circular_polygons<Traits>(offset, error);
    ASSERT_EQ(polygons.size(), 1u);
    const auto chords = offset.polygons_with_holes(error);
    EXPECT_LT(polygons[0].outer_boundary().size(), chords[0].outer_boundary().size() / 2);
    EXPECT_NEAR(total_area_of(polygons), CGAL::to_double(offset.polygons_with_holes(1e-5)[0].outer_boundary().area()),
                20 * error);
    EXPECT_TRUE(is_inside(set_of(polygons), Point(2, 2.5)));
    for (auto arc = polygons[0].outer_boundary().curves_begin(); arc != polygons[0].outer_boundary().curves_end();
         ++arc) {
      const Point p(CGAL::to_double(arc->source().x()), CGAL::to_double(arc->source().y()));
      double nearest = 1e9;
      for (const Point& sample : samples)
        nearest = std::min(nearest, std::sqrt(CGAL::squared_distance(p, sample)));
      EXPECT_NEAR(nearest, std::abs(distance), 1.5e-3);   // samples are up to 0.02 apart
    }
  }
}

// A boundary that is thinner than the error, and a hole that chords cut: both are refined until edges meet in their
// ends only, as CGAL finds, too.
TEST(Circular_polygons, refined_until_edges_do_not_cross)
{
  const auto leaf = [](double height) {
    return SC::planar_region(std::vector<Curve>{SC::bezier_curve(std::vector<Point>{{0, 0}, {2, 2}, {4, 0}}),
                                                SC::bezier_curve(std::vector<Point>{{4, 0}, {2, height}, {0, 0}})});
  };
  const auto sweep = SC::swept_area(polygon({{-0.75, -0.5}, {-0.625, -0.75}, {0.75, 0.5}, {0.625, 0.75}}),
                                    SC::bezier_curve(std::vector<Point>{{0, 0}, {9, 7}, {-4, 7}, {5, 0}}));
  const double area_of_sweep = CGAL::to_double(sweep.polygons_with_holes(1e-4)[0].outer_boundary().area()) +
      CGAL::to_double(sweep.polygons_with_holes(1e-4)[0].holes_begin()->area());
  for (const auto& [polygons, area, error] :
       {std::tuple(SC::to_circular_polygons<Traits>(leaf(2.01), 1e-3), 4 * 0.01 / 3, 3e-3),
        std::tuple(SC::to_circular_polygons<Traits>(leaf(1.5), 1e-3), 4 * 0.5 / 3, 1e-2),
        std::tuple(SC::to_circular_polygons<Traits>(sweep, 0.1), area_of_sweep, 1.0)}) {
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_TRUE(CGAL::is_valid_polygon_with_holes(polygons[0], Traits()));
    EXPECT_NEAR(total_area_of(polygons), area, error);
  }
}

// Boundaries that touch: in corners there is a result, with a common tangent there is none.
TEST(Circular_polygons, boundaries_that_touch)
{
  const Polygons eight =
      SC::to_circular_polygons<Traits>(polygon({{0, 0}, {2, 1}, {2, -1}, {0, 0}, {-2, -1}, {-2, 1}}), 1e-3);
  EXPECT_EQ(eight.size(), 2u);
  EXPECT_EQ(total_area_of(eight), 4);
  const auto disk_with_hole =
      SC::planar_region(std::vector<Curve>{SC::circle_curve(Point(0, 0), 2.0), SC::circle_curve(Point(1, 0), 1.0)});
  expect_invalid([&] { SC::to_circular_polygons<Traits>(disk_with_hole, 1e-2); },
                 "to_circular_polygons: edges meet elsewhere");
}

// No more than the concept asks for: a square with another one in it.
struct Frame
{
  std::vector<CGAL::Polygon_with_holes_2<K>> polygons_with_holes(double) const
  {
    const auto square = [](double side) {
      return std::vector<Point>{{-side, -side}, {side, -side}, {side, side}, {-side, side}};
    };
    const auto outer = square(2), inner = square(1);
    CGAL::Polygon_2<K> hole(inner.begin(), inner.end());
    hole.reverse_orientation();
    return {CGAL::Polygon_with_holes_2<K>(CGAL::Polygon_2<K>(outer.begin(), outer.end()), &hole, &hole + 1)};
  }
};
static_assert(SC::Approximable_region_2<Frame>);

// Two squares that overlap in an area, or in a side.
struct Two_squares
{
  double distance;

  std::vector<CGAL::Polygon_with_holes_2<K>> polygons_with_holes(double) const
  {
    std::vector<CGAL::Polygon_with_holes_2<K>> result;
    for (const double x : {0.0, distance}) {
      const std::vector<Point> square{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}};
      result.emplace_back(CGAL::Polygon_2<K>(square.begin(), square.end()));
    }
    return result;
  }
};

TEST(Circular_polygons, of_a_model_of_the_concept)
{
  const Polygons polygons = SC::to_circular_polygons<Traits>(Frame(), 0.1);
  ASSERT_EQ(polygons.size(), 1u);
  EXPECT_EQ(polygons[0].number_of_holes(), 1u);
  EXPECT_EQ(polygons[0].outer_boundary().size(), 4u);
  EXPECT_EQ(total_area_of(polygons), 12);
  expect_invalid([] { SC::to_circular_polygons<Traits>(Frame(), 0); }, "to_circular_polygons");
  EXPECT_EQ(SC::to_circular_polygons<Traits>(Two_squares{2}, 0.1).size(), 2u);
  expect_invalid([] { SC::to_circular_polygons<Traits>(Two_squares{1e100}, 0.1); }, "a coordinate is not between");
  for (const double distance : {0.0, 0.5, 1.0})
    expect_invalid([&] { SC::to_circular_polygons<Traits>(Two_squares{distance}, 0.1); }, "edges meet elsewhere");
}

} // namespace

} // namespace to_circular_polygons_2_test
