// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Minkowski sums of regions with curved edges: closed forms, support functions, distances from a region, and
// invariants.

#include "geometry_test_tools.h"
#include "polygon_area.h"
#include "region_of_a_drawing.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

namespace minkowski_sums_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = Double_cartesian;
using Point = K::Point_2;
using Vector = K::Vector_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Region = SC::Planar_region_2<K>;
using Sum = SC::Minkowski_sum_2<K>;

Curve circle(double x, double y, double radius) { return SC::circle_curve(Point(x, y), radius); }
Region disk(double radius) { return SC::planar_region(circle(0, 0, radius)); }
Region polygon(const std::vector<Point>& points)
{
  return SC::planar_region(CGAL::Polygon_2<K>(points.begin(), points.end()));
}
Region smooth_region(const std::vector<Point>& points)
{
  std::vector<double> period;
  for (std::size_t i = 0; i <= points.size(); ++i)
    period.push_back(static_cast<double>(i));
  return SC::planar_region(Curve::from_periodic(3, period, points));
}
Region letter()
{
  return polygon({{0, 0},
                  {6, 0},
                  {6.25, 2.5},
                  {5, 2.5},
                  {5.125, 1},
                  {1, 1},
                  {1, 5},
                  {5, 5},
                  {5, 3.5},
                  {6, 3.5},
                  {6, 6.5},
                  {0, 6}});
}
Region kidney() { return smooth_region({{0, 0}, {4, 0}, {4, 3}, {2, 1}, {2, 4}, {0, 5}, {-1, 2}}); }
Region moon() { return smooth_region({{0, 0}, {2, 0}, {0.75, 0.75}, {2.25, 2}, {0, 1.5}}); }

std::vector<Point> samples(const Sum& sum, std::size_t boundary, double error)
{
  std::vector<Point> result;
  for (std::size_t i = 0; i < sum.boundaries()[boundary].arcs.size(); ++i)
    for (const auto& sample : sum.polyline(boundary, i, error))
      result.push_back(sample.point);
  return result;
}

double area(const Sum& sum) { return total_area(sum.polygons_with_holes(1e-5)); }

double distance(const Point& p, const std::vector<Point>& polyline)
{
  double result = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
    const Vector side = polyline[i + 1] - polyline[i], arm = p - polyline[i];
    const double t = side.squared_length() > 0 ? std::clamp(side * arm / side.squared_length(), 0.0, 1.0) : 0;
    result = std::min(result, std::sqrt((arm - t * side).squared_length()));
  }
  return result;
}

void expect_complete(const Sum& sum, std::size_t boundaries, std::size_t holes)
{
  EXPECT_TRUE(sum.is_complete());
  EXPECT_TRUE(sum.undecided().empty());
  EXPECT_EQ(sum.boundaries().size(), boundaries);
  EXPECT_EQ(std::count_if(sum.boundaries().begin(), sum.boundaries().end(), [](const auto& b) { return b.is_hole; }),
            static_cast<std::ptrdiff_t>(holes));
  for (const auto& boundary : sum.boundaries())
    EXPECT_TRUE(boundary.is_closed);
}

// Samples are sums of points of the curves at their parameters, and each arc begins where the one before ends, up to a
// gap: next to inflections parameters are known less well.
void expect_origins(const Region& a, const Region& b, const Sum& sum, double gap = 1e-8)
{
  for (std::size_t k = 0; k < sum.boundaries().size(); ++k) {
    Point last = samples(sum, k, 1e-2).back();
    for (std::size_t i = 0; i < sum.boundaries()[k].arcs.size(); ++i) {
      const auto& arc = sum.boundaries()[k].arcs[i];
      const auto polyline = sum.polyline(k, i, 1e-2);
      for (const auto& [point, parameters] : polyline) {
        const Point expected =
            a.curves()[arc.curves[0]](parameters[0]) + (b.curves()[arc.curves[1]](parameters[1]) - CGAL::ORIGIN);
        EXPECT_LT(CGAL::squared_distance(point, expected), 1e-16);
      }
      EXPECT_LT(CGAL::squared_distance(polyline.front().point, last), gap * gap);
      EXPECT_EQ(polyline.front().parameters, (std::array<double, 2>{arc.parameters[0][0], arc.parameters[1][0]}));
      last = polyline.back().point;
    }
  }
}

TEST(minkowski_sums_2, two_disks)
{
  const Region a = disk(1), b = SC::planar_region(circle(1, 2, 2));
  const Sum sum = SC::minkowski_sum(a, b);
  expect_complete(sum, 1, 0);
  expect_origins(a, b, sum);
  const std::vector<Point> points = samples(sum, 0, 1e-4);
  EXPECT_GT(points.size(), 100u);
  for (const Point& p : points)
    EXPECT_NEAR(CGAL::squared_distance(p, Point(1, 2)), 9, 1e-12);
  EXPECT_TRUE(CGAL::certainly(sum.has_in_interior(Point(1, 4.999))));
  EXPECT_TRUE(CGAL::certainly_not(sum.has_in_interior(Point(1, 5.001))));
}

TEST(minkowski_sums_2, convex_polygon_and_disk)
{
  // one side is tangential where two pieces of the circle meet
  const Region triangle = polygon({{0, 0}, {4, 0}, {1, 3}});
  for (const double r : {0.125, 1.0, 7.5}) {
    const Sum sum = SC::minkowski_sum(triangle, disk(r));
    expect_complete(sum, 1, 0);
    EXPECT_NEAR(area(sum), 6 + r * (4 + std::sqrt(18) + std::sqrt(10)) + CGAL_PI * r * r, 1e-3);
  }
}

TEST(minkowski_sums_2, polygons)
{
  const Region square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
               triangle = polygon({{0, 0}, {0.875, 0.125}, {0.5, 0.75}});
  const Sum squares = SC::minkowski_sum(square, square);   // all sides are parallel
  expect_complete(squares, 1, 0);
  EXPECT_EQ(area(squares), 4);
  const Sum sum = SC::minkowski_sum(letter(), triangle);   // a corner of the triangle fits into a reflex one
  expect_complete(sum, 1, 0);
  EXPECT_NEAR(area(sum), 37.1953125, 1e-12);
  expect_origins(letter(), triangle, sum);
}

// The support function of a sum is the sum of both.
TEST(minkowski_sums_2, convex_regions)
{
  std::mt19937 random(3);
  const auto coordinate = [&] { return (static_cast<int>(random() % 129) - 64) / 32.0; };
  for (int trial = 0; trial < 4; ++trial) {
    std::array<Vector, 2> first, second;
    for (auto* axes : {&first, &second})
      do
        *axes = {Vector(coordinate(), coordinate()), Vector(coordinate(), coordinate())};
      while (std::abs(CGAL::determinant((*axes)[0], (*axes)[1])) < 0.5);
    const Region a = SC::planar_region(SC::ellipse_curve(Point(0, 0), first[0], first[1])),
                 b = SC::planar_region(SC::ellipse_curve(Point(1, -1), second[0], second[1]));
    const Sum sum = SC::minkowski_sum(a, b);
    expect_complete(sum, 1, 0);
    expect_origins(a, b, sum);
    const std::vector<Point> points = samples(sum, 0, 1e-3);
    for (int i = 0; i < 40; ++i) {
      const Vector d(std::cos(i), std::sin(i));
      double highest = -100;
      for (const Point& p : points)
        highest = std::max(highest, (p - Point(1, -1)) * d);
      EXPECT_NEAR(highest, std::hypot(first[0] * d, first[1] * d) + std::hypot(second[0] * d, second[1] * d), 2e-3);
    }
  }
}

// The sum with a disk is what is nearer to a region than the radius: the boundary has that distance, and random points
// tell inside from outside.
TEST(minkowski_sums_2, neighbourhoods)
{
  for (const auto& [region, radius, holes] : {std::tuple(letter(), 0.75, 1), std::tuple(kidney(), 0.5, 0)}) {
    const Sum sum = SC::minkowski_sum(region, disk(radius));
    expect_complete(sum, 1 + holes, holes);
    expect_origins(region, disk(radius), sum);
    std::vector<Point> outline;
    const Curve& curve = region.curves()[0];
    const auto [begin, end] = curve.domain();
    const int n = 4800;
    for (int i = 0; i <= n; ++i)
      outline.push_back(curve(begin + (end - begin) * i / n));
    for (std::size_t k = 0; k < sum.boundaries().size(); ++k)
      for (const Point& p : samples(sum, k, 1e-2))
        EXPECT_NEAR(distance(p, outline), radius, 1e-5);
    const auto polygons = sum.polygons_with_holes(1e-4);
    ASSERT_EQ(polygons.size(), 1u);
    EXPECT_EQ(polygons[0].number_of_holes(), static_cast<std::size_t>(holes));
    std::mt19937 random(5);
    for (int i = 0; i < 60; ++i) {
      const Point p(-2 + (random() % 1024) / 100.0, -2 + (random() % 1024) / 100.0);
      const double d = distance(p, outline);
      if (std::abs(d - radius) < 1e-3)
        continue;
      const bool is_inside = d < radius || region.bounded_side(p) == CGAL::ON_BOUNDED_SIDE;
      const CGAL::Uncertain<bool> answer = sum.has_in_interior(p);
      ASSERT_TRUE(answer.is_certain());
      EXPECT_EQ(answer.make_certain(), is_inside);
      bool is_in_hole = false;
      for (const auto& hole : polygons[0].holes())
        is_in_hole = is_in_hole || hole.bounded_side(p) == CGAL::ON_BOUNDED_SIDE;
      EXPECT_EQ(polygons[0].outer_boundary().bounded_side(p) == CGAL::ON_BOUNDED_SIDE && !is_in_hole, is_inside);
    }
  }
}

TEST(minkowski_sums_2, holes)
{
  const Region ring(Curves{circle(0, 0, 5), circle(0.5, 0.25, 3)});
  const std::vector<Point> points{{0, 0}, {1, 0.25}, {0.375, 0.75}};
  const Sum small = SC::minkowski_sum(ring, disk(1)), large = SC::minkowski_sum(ring, disk(4)),
            polygonal = SC::minkowski_sum(ring, CGAL::Polygon_2<K>(points.begin(), points.end()));
  expect_complete(small, 2, 1);
  EXPECT_NEAR(area(small), (36 - 4) * CGAL_PI, 1e-3);
  expect_complete(large, 1, 0);
  EXPECT_NEAR(area(large), 81 * CGAL_PI, 1e-3);
  expect_complete(polygonal, 2, 1);
  expect_origins(ring, polygon(points), polygonal);
}

// A ring within the hole of a ring: each hole belongs to its own polygon.
TEST(minkowski_sums_2, rings_in_rings)
{
  const Sum sum = SC::minkowski_sum(
      SC::planar_region(std::vector<Curve>{circle(0, 0, 10), circle(0, 0, 8), circle(0, 0, 4), circle(0, 0, 2)}),
      disk(0.5));
  expect_complete(sum, 4, 2);
  const auto polygons = sum.polygons_with_holes(1e-3);
  ASSERT_EQ(polygons.size(), 2U);
  for (const auto& polygon : polygons) {
    ASSERT_EQ(polygon.number_of_holes(), 1U);
    const double outer = std::sqrt(polygon.outer_boundary().area() / CGAL_PI),
                 inner = std::sqrt(-polygon.holes_begin()->area() / CGAL_PI);
    EXPECT_NEAR(outer - inner, 3, 0.01);
  }
}

TEST(minkowski_sums_2, curved_regions_and_rigid_motions)
{
  const auto moved = [](const Region& region, double x, double y) {
    const CGAL::Aff_transformation_2<K> motion(0.6, -0.8, x, 0.8, 0.6, y);
    return SC::planar_region(region.curves()[0].transformed(motion));
  };
  const Sum sum = SC::minkowski_sum(kidney(), moon()),
            other = SC::minkowski_sum(moved(moon(), 1, 2), moved(kidney(), -3, 0.5));
  expect_complete(sum, 1, 0);
  expect_complete(other, 1, 0);
  expect_origins(kidney(), moon(), sum);
  EXPECT_NEAR(area(sum), area(other), 1e-3);
  const CGAL::Aff_transformation_2<K> motion(0.6, -0.8, -2, 0.8, 0.6, 2.5);
  std::vector<Point> boundary = samples(other, 0, 1e-3);
  boundary.push_back(Point(boundary.front()));
  for (const Point& p : samples(sum, 0, 1e-2))
    EXPECT_LT(distance(motion(p), boundary), 5e-3);
}

// A region with inflections, added to itself and to a copy elsewhere: pieces of the convolution end, and others begin,
// in the sums of the inflections, which are not rational. Points beside the boundary tell that it is the boundary.
TEST(minkowski_sums_2, equal_inflections)
{
  const Region region = moon();
  const CGAL::Aff_transformation_2<K> elsewhere(CGAL::TRANSLATION, Vector(0.5, -3));
  for (const Region& other : {region, SC::planar_region(region.curves()[0].transformed(elsewhere))}) {
    const Sum sum = SC::minkowski_sum(region, other);
    expect_complete(sum, 1, 0);
    expect_origins(region, other, sum, 1e-7);
    const std::vector<Point> boundary = samples(sum, 0, 1e-2);
    EXPECT_GT(boundary.size(), 50U);
    for (std::size_t i = 0; i + 1 < boundary.size(); i += 32) {
      const Vector way = boundary[i + 1] - boundary[i], left(-way.y(), way.x());
      if (way.squared_length() > 1e-4) {
        // no farther from the arc than a fifth of the length
        const Point middle = CGAL::midpoint(boundary[i], boundary[i + 1]);
        EXPECT_TRUE(CGAL::certainly(sum.has_in_interior(middle + 0.25 * left)));
        EXPECT_TRUE(CGAL::certainly_not(sum.has_in_interior(middle - 0.25 * left)));
      }
    }
  }
}

Region square(double size, double x = 0, double y = 0)
{
  return polygon({{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}});
}

Region united(const Region& a, const Region& b)
{
  Curves curves = a.curves();
  curves.insert(curves.end(), b.curves().begin(), b.curves().end());
  return SC::planar_region(curves);
}

// Slots and holes that are exactly as wide as what is moved through them close: their sides become the same.
TEST(minkowski_sums_2, slots_that_close)
{
  const Region slot = polygon({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}});
  const Sum closed = SC::minkowski_sum(slot, square(1)), open = SC::minkowski_sum(slot, square(0.5)),
            round = SC::minkowski_sum(slot, disk(0.5));
  expect_complete(closed, 1, 0);
  EXPECT_EQ(area(closed), 16);
  EXPECT_TRUE(CGAL::certainly(closed.has_in_interior(Point(1.9375, 3.5))));
  expect_complete(open, 1, 0);
  EXPECT_EQ(area(open), 3.5 * 3.5 - 1);
  expect_complete(round, 1, 0);
  // of the hull, without what is between two quarters of a disk above the slot
  EXPECT_NEAR(area(round), 9 + 12 * 0.5 + CGAL_PI / 4 - (0.5 - CGAL_PI / 8), 1e-4);
  // five times as large, and turned
  const Region turned = SC::planar_region(slot.curves()[0].transformed(CGAL::Aff_transformation_2<K>(3, -4, 4, 3)));
  const Sum also_round = SC::minkowski_sum(turned, disk(2.5));
  expect_complete(also_round, 1, 0);
  EXPECT_NEAR(area(also_round), 25 * area(round), 1e-2);
}

TEST(minkowski_sums_2, holes_that_close)
{
  const auto frame = [](double width) {
    return united(square(4), polygon({{1, 1}, {1 + width, 1}, {1 + width, 2}, {1, 2}}));
  };
  for (const double width : {1.0, 2.0}) {   // to a point, and to a segment
    const Sum sum = SC::minkowski_sum(frame(width), square(1));
    expect_complete(sum, 1, 0);
    EXPECT_EQ(area(sum), 25);
  }
  const Sum open = SC::minkowski_sum(frame(1), square(0.5));
  expect_complete(open, 2, 1);
  EXPECT_EQ(area(open), 4.5 * 4.5 - 0.25);
  const Sum round = SC::minkowski_sum(Region(Curves{circle(0, 0, 5), circle(0, 0, 2)}), disk(2));
  expect_complete(round, 1, 0);
  EXPECT_NEAR(area(round), 49 * CGAL_PI, 1e-3);
}

// Parts that touch in a point stay apart, and those that touch along a segment become one.
TEST(minkowski_sums_2, parts_that_touch)
{
  const Sum corners = SC::minkowski_sum(united(square(1), square(1, 2, 2)), square(1)),
            sides = SC::minkowski_sum(united(square(1), square(1, 2, 0.5)), square(1));
  expect_complete(corners, 2, 0);
  EXPECT_EQ(area(corners), 8);
  expect_complete(sides, 1, 0);
  EXPECT_EQ(area(sides), 8);
  for (const Point& p : {Point(10, 0), Point(6, 8)}) {   // on an axis, where arcs end, and not
    const Sum disks = SC::minkowski_sum(SC::planar_region(Curves{circle(0, 0, 4), circle(p.x(), p.y(), 4)}), disk(1));
    expect_complete(disks, 2, 0);
    EXPECT_NEAR(area(disks), 50 * CGAL_PI, 2e-3);
  }
}

// Two squares with a corner in common, as one outline; and a frame whose outline leads to the hole and back.
TEST(minkowski_sums_2, outlines_that_touch)
{
  const Region squares = SC::planar_region(
      SC::polyline_curve<K>({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {-1, 0}, {-1, -1}, {0, -1}, {0, 0}}));
  const Sum sum = SC::minkowski_sum(squares, square(1)), twice = SC::minkowski_sum(squares, squares);
  expect_complete(sum, 1, 0);
  EXPECT_EQ(area(sum), 7);
  expect_complete(twice, 1, 0);
  EXPECT_EQ(area(twice), 10);
  const Region frame = SC::planar_region(
      SC::polyline_curve<K>({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}, {0, 0}}));
  const Sum thick = SC::minkowski_sum(frame, square(1));
  expect_complete(thick, 2, 1);
  EXPECT_EQ(area(thick), 48);
}

TEST(minkowski_sums_2, region_of_a_drawing)
{
  const Sum sum = SC::minkowski_sum(region_of_a_drawing<K>(), disk(0.25)),
            shifted = SC::minkowski_sum(region_of_a_drawing<K>(), square(0.5));
  expect_complete(sum, 2, 1);
  EXPECT_NEAR(area(sum), 12 * 2.25 + CGAL_PI * (2.25 * 2.25 - 0.75 * 0.75), 1e-3);
  // The stadium grows by its extents in x and y, times the side, and the area of the square; of the hole, disks around
  // four corners have a part in common.
  const double half = 0.25, far = std::sqrt(1 - half * half);
  // of the height of a circle
  const auto integral = [](double x) { return (x * std::sqrt(1 - x * x) + std::asin(x)) / 2; };
  expect_complete(shifted, 2, 1);
  EXPECT_NEAR(area(shifted),
              24 + 4 * CGAL_PI + 0.5 * (10 + 4) + 0.25 - 4 * (integral(far) - integral(half) - half * (far - half)),
              1e-3);
}

// Regions with a common reflex part: each arc of the sum of two different points is there twice.
TEST(minkowski_sums_2, equal_regions)
{
  for (const Region& region :
       {letter(),
        polygon({{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}})}) {
    const Sum sum = SC::minkowski_sum(region, region);
    expect_complete(sum, 1, 0);
    expect_origins(region, region, sum);
  }
  EXPECT_EQ(area(SC::minkowski_sum(letter(), letter())), 152.2);
}

// Nearly straight reflex corners of the star, into which the kidney does not fit by a millionth of its size.
TEST(minkowski_sums_2, flat_corners)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0, 0.5), length(2, 4);
  std::vector<Point> star;
  for (int i = 0; i < 10; ++i) {
    const double angle = 2 * CGAL_PI * (i + part(random)) / 10, radius = length(random);
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const Sum sum = SC::minkowski_sum(kidney(), polygon(star)), other = SC::minkowski_sum(polygon(star), kidney());
  expect_complete(sum, 1, 0);
  expect_complete(other, 1, 0);
  EXPECT_NEAR(area(sum), area(other), 1e-3);
}

// The derivative of the arc (6 t^2 - 2 t^3, 3 t^2 (1 - t)) is zero in its begin. With a segment it bounds a convex
// region of the height 4/9 and the area 6/5; with a frame above it, a region that it bends into.
TEST(minkowski_sums_2, coincident_control_points)
{
  const Curve arc = SC::bezier_curve<K>({{0, 0}, {0, 0}, {2, 1}, {4, 0}});
  const Region hill(Curves{arc, SC::segment_curve<K>(Point(4, 0), Point(0, 0))}),
      arch(Curves{arc, SC::polyline_curve<K>({{4, 0}, {4, 5}, {0, 5}, {0, 0}})});
  const Sum convex = SC::minkowski_sum(hill, square(1)), other = SC::minkowski_sum(square(1), hill),
            twice = SC::minkowski_sum(hill, hill), concave = SC::minkowski_sum(arch, square(1));
  expect_complete(convex, 1, 0);
  expect_origins(hill, square(1), convex);
  EXPECT_NEAR(area(convex), 1.2 + 4 + 4 / 9.0 + 1, 1e-4);
  expect_complete(other, 1, 0);
  EXPECT_NEAR(area(other), area(convex), 1e-4);
  expect_complete(twice, 1, 0);
  EXPECT_NEAR(area(twice), 4 * 1.2, 1e-4);
  expect_complete(concave, 1, 0);
  expect_origins(arch, square(1), concave);
  const auto height = [&](double x) {
    double begin = 0, end = 1;
    while (end - begin > 1e-9)
      (arc(begin / 2 + end / 2).x() < x ? begin : end) = begin / 2 + end / 2;
    return arc(begin).y();
  };
  double below = 0;   // the sum, where the arc is above zero all over the side of the square
  constexpr int steps = 3000;
  for (int i = 0; i < steps; ++i)
    below += std::min(height(3.0 * i / steps), height(1 + 3.0 * i / steps)) * 3 / steps;
  EXPECT_NEAR(area(concave), 5 * 6 - below, 1e-3);
}

// The arc y = x^3 / 9 goes on from a segment with the curvature zero, as where the first three control points are on a
// line.
TEST(minkowski_sums_2, flat_ends)
{
  const Region region(Curves{SC::bezier_curve<K>({{0, 0}, {1, 0}, {2, 0}, {3, 3}}),
                             SC::polyline_curve<K>({{3, 3}, {-1, 3}, {-1, 0}, {0, 0}})});
  const Sum sum = SC::minkowski_sum(region, square(1)), twice = SC::minkowski_sum(region, region);
  expect_complete(sum, 1, 0);
  EXPECT_NEAR(area(sum), 9.75 + 4 + 3 + 1, 1e-4);
  expect_complete(twice, 1, 0);
  EXPECT_NEAR(area(twice), 4 * 9.75, 1e-4);
}

// Two sides, or two arcs, go on in each other but for a reflex corner that is nearly flat, next to which the boundaries
// of their sums with a disk cross. These are tiny there, and of arcs they cross at angles that doubles do not tell from
// zero.
TEST(minkowski_sums_2, joints_that_are_nearly_smooth)
{
  constexpr double radius = 0.5;
  for (const double h : {0x1p-22, 0x1p-40}) {
    const Region notched = polygon({{0, 0}, {4, 0}, {4, 3}, {2, 3 - h}, {0, 3}});
    // below y = 3 - (x - 2)^2 / 4
    const Region roof(Curves{SC::bezier_curve<K>({{4, 2}, {3, 3 + h}, {2, 3}}),
                             SC::bezier_curve<K>({{2, 3}, {1, 3 + h}, {0, 2}}),
                             SC::polyline_curve<K>({{0, 2}, {0, 0}, {4, 0}, {4, 2}})});
    for (const auto& [region, own_area, length] :
         {std::tuple(notched, 12.0, 14.0), std::tuple(roof, 32 / 3.0, 8 + 2 * (std::sqrt(2.0) + std::asinh(1.0)))}) {
      const Sum sum = SC::minkowski_sum(region, disk(radius));
      expect_complete(sum, 1, 0);
      expect_origins(region, disk(radius), sum, 1e-7);   // the crossings are known less well
      EXPECT_NEAR(area(sum), own_area + radius * length + CGAL_PI * radius * radius, 1e-4);
      EXPECT_TRUE(CGAL::certainly(sum.has_in_interior(Point(2, 3.4999))));
      EXPECT_TRUE(CGAL::certainly_not(sum.has_in_interior(Point(2, 3.5001))));
    }
  }
}

// Behind the end of a side the boundary bends to the right, so that the sum of the left corner of the square and what
// follows begins on the sum of the right corner and the side, at a parameter that is no simple number. What follows is
// a segment, or an arc, y = -x^3 / 9, with the same tangent and the curvature zero.
TEST(minkowski_sums_2, contacts_on_segments)
{
  constexpr double length = 5.585938;
  const Sum ramp =
      SC::minkowski_sum(polygon({{0, 0}, {length, 0}, {length + 2, -2}, {length + 2, 3}, {0, 3}}), square(1));
  expect_complete(ramp, 1, 0);
  EXPECT_NEAR(area(ramp), 4 * (length + 3) + 2 + 2, 1e-9);
  const Region slide(Curves{SC::bezier_curve<K>({{0, 0}, {1, 0}, {2, 0}, {3, -3}}),
                            SC::polyline_curve<K>({{3, -3}, {3, 2}, {-length, 2}, {-length, 0}, {0, 0}})});
  const Sum sum = SC::minkowski_sum(slide, square(1));
  expect_complete(sum, 1, 0);
  expect_origins(slide, square(1), sum);
  EXPECT_NEAR(area(sum), 3 * (length + 4) + 2.25 + 3, 1e-4);
}

// An ellipse in the bottom of the parabola y = x^2 / 2, which has the curvature 1; that of the ellipse is 1 + h there.
// If h > 0, it rolls through the bottom, and the sum is nearly as curved as a cusp in (0, b), where b is the half-axis
// of the ellipse. Otherwise the convolution has two cusps next to each other, and crosses above them, where the ellipse
// touches both sides of the parabola: in (0, 2 b^2 + 1/8).
template <class Kernel, class Number>
void expect_sum_of_valley_and_ellipse(const Number& h)
{
  using Exact_point = typename Kernel::Point_2;
  const auto number = [](int numerator, int denominator = 1) {
    return Number(Number(numerator) / Number(denominator));
  };
  const SC::Bspline_curve_2<Kernel> arc = SC::bezier_curve<Kernel>(
                                        {Exact_point(2, 2), Exact_point(0, -2), Exact_point(-2, 2)}),
                                    frame = SC::polyline_curve<Kernel>({Exact_point(-2, 2), Exact_point(-2, -3),
                                                                        Exact_point(2, -3), Exact_point(2, 2)});
  const Number b = (number(1) + h) / number(4);
  const auto ellipse =
      SC::ellipse_curve(Exact_point(0, 0), typename Kernel::Vector_2(number(1, 2), 0), typename Kernel::Vector_2(0, b));
  const auto sum = SC::minkowski_sum(SC::planar_region(std::vector{arc, frame}), SC::planar_region(ellipse));
  EXPECT_TRUE(sum.is_complete());
  ASSERT_EQ(sum.boundaries().size(), 1U);
  const double expected =
      SC::to_nearest_double(h > 0 ? SC::Exact_rational(b) : SC::Exact_rational(Number(2 * b * b + number(1, 8))));
  double nearest = 1, height = 0;   // of the points around x = 0
  for (std::size_t i = 0; i < sum.boundaries()[0].arcs.size(); ++i)
    for (const auto& sample : sum.polyline(0, i, 1e-5))
      if (const double x = CGAL::to_double(sample.point.x()), y = CGAL::to_double(sample.point.y());
          y > 0 && std::abs(x) < nearest) {
        nearest = std::abs(x);
        height = y;
      }
  EXPECT_LT(nearest, 1e-5);
  EXPECT_NEAR(height, expected, nearest + 1e-13);
}

TEST(minkowski_sums_2, curvatures_next_to_cusps)
{
  using Exact_kernel = CGAL::Simple_cartesian<SC::Exact_rational>;
  for (const double h : {1e-4, 1e-8, 1e-12})
    for (const double sign : {1.0, -1.0})
      expect_sum_of_valley_and_ellipse<K>(sign * h);
  for (const double h : {0x1p-60, -0x1p-30})   // 1 + h is no double, or the square is below the precision of one
    expect_sum_of_valley_and_ellipse<Exact_kernel>(SC::Exact_rational(h));
}

// A bay below the parabola y = x^2 / 2, |x| <= 2, and a dome with the same arc, reflected, which fits into it exactly:
// both curvatures add up to zero along the arc, the sums of which are one point, (0, 0). There the boundary y = 2 |x| -
// x^2 / 2 of the sum, |x| <= 4, has a corner. Below it ends at y = -5.
TEST(minkowski_sums_2, arcs_that_fit_into_each_other)
{
  const Region bay(Curves{SC::bezier_curve<K>({{2, 2}, {0, -2}, {-2, 2}}),
                          SC::polyline_curve<K>({{-2, 2}, {-2, -3}, {2, -3}, {2, 2}})}),
      dome(Curves{SC::bezier_curve<K>({{2, -2}, {0, 2}, {-2, -2}}), SC::segment_curve<K>(Point(-2, -2), Point(2, -2))});
  for (const Sum& sum : {SC::minkowski_sum(bay, dome), SC::minkowski_sum(dome, bay)}) {
    expect_complete(sum, 1, 0);
    EXPECT_NEAR(area(sum), 40 + 32 / 3.0, 1e-3);
    EXPECT_TRUE(CGAL::certainly(sum.has_in_interior(Point(0.125, 0.125))));
    EXPECT_TRUE(CGAL::certainly_not(sum.has_in_interior(Point(0, 0.125))));
  }
}

TEST(minkowski_sums_2, bad_input)
{
  const Region square = polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  // at the parameter 1/2
  const Region cusp(
      Curves{SC::bezier_curve<K>({{0, 0}, {2, 2}, {0, 2}, {2, 0}}), SC::segment_curve<K>(Point(2, 0), Point(0, 0))});
  expect_invalid([&] { SC::minkowski_sum(square, cusp); }, "the derivative of curve 0 is zero at parameter 0.5");
  expect_invalid([&] { SC::minkowski_sum(square, square).polyline(0, 0, 0); }, "the error must be positive");
  expect_invalid([&] { SC::minkowski_sum(square, square).polygons_with_holes(-1); }, "the error must be positive");
}

} // namespace

} // namespace minkowski_sums_2_test
