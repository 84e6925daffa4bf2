// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Swept areas: of squares and a disk in closed form; of a star along cubics, sums of points are inside, and what no
// point of the star passes is outside; of arcs along cubics, by random points and their share.
#include "polygon_area.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/swept_areas_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace swept_areas_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using P = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Sum = SC::Minkowski_sum_2<K>;

Curve segment(const P& p, const P& q) { return SC::segment_curve(p, q); }
Curve bezier(const std::vector<P>& points) { return SC::bezier_curve(points); }
Curve circle(double radius) { return SC::ellipse_curve(P(0, 0), K::Vector_2(radius, 0), K::Vector_2(0, radius)); }
SC::Planar_region_2<K> disk(double radius) { return SC::planar_region(circle(radius)); }
SC::Planar_region_2<K> unit_square()
{
  return SC::planar_region(SC::polyline_curve(std::vector<P>{P(0, 0), P(1, 0), P(1, 1), P(0, 1), P(0, 0)}));
}

double area(const Sum& sum, double error = 1e-6) { return total_area(sum.polygons_with_holes(error)); }

void expect_area(const Sum& sum, double expected, std::size_t boundaries)
{
  EXPECT_TRUE(sum.is_complete());
  EXPECT_EQ(sum.boundaries().size(), boundaries);
  EXPECT_NEAR(area(sum), expected, 1e-4 * expected);
}

TEST(SweptAreas, OfRegionsAlongSegments)
{
  expect_area(SC::swept_area(unit_square(), segment(P(0, 0), P(3, 0))), 4, 1);
  expect_area(SC::swept_area(unit_square(), segment(P(0, 0), P(2, 1))), 4, 1);
  expect_area(SC::swept_area(disk(1), segment(P(1, 1), P(4, 5))), CGAL_PI + 10, 1);
}

// Within the ring the disks around the corners of the square, reflected, overlap.
TEST(SweptAreas, AlongACircle)
{
  const double r = 5, last = std::sqrt(r * r - 0.25);
  const auto integral = [&](double t) {
    return t / 2 * std::sqrt(r * r - t * t) + r * r / 2 * std::asin(t / r) - t / 2;
  };
  const Sum ring = SC::swept_area(unit_square(), circle(r));
  expect_area(ring, CGAL_PI * r * r + 4 * r + 1 - 4 * (integral(last) - integral(0.5)), 2);
  EXPECT_EQ(ring.boundaries()[0].is_hole + ring.boundaries()[1].is_hole, 1);
  EXPECT_TRUE(CGAL::certainly(ring.has_in_interior(P(0, 5.5))));
  EXPECT_TRUE(CGAL::certainly_not(ring.has_in_interior(P(0, 0))));
}

// Along a closed path, which leaves a hole, and around the corner of an open one, where two hexagons overlap in the
// square and a triangle.
TEST(SweptAreas, AlongPolylines)
{
  // of the sum with all that is inside of the path: its area, width and height, and the square
  const double outer = 8 + 4 + 4 + 1;
  expect_area(
      SC::swept_area(unit_square(), SC::polyline_curve(std::vector<P>{P(2, 0), P(4, 2), P(2, 4), P(0, 2), P(2, 0)})),
      outer - 2, 2);
  expect_area(SC::swept_area(unit_square(), SC::polyline_curve(std::vector<P>{P(0, 0), P(3, 1), P(1, 4)})),
              5 + 6 - 1 - 3 / 11.0, 1);
}

// Of a round hole there remains what is inside of all disks around the path. Next to its inflection this turns very
// little; where it is as curved as the hole, its envelope has a cusp.
TEST(SweptAreas, AlongAnInflection)
{
  const Curve path = bezier({P(0, 0), P(1, 2), P(2, -1), P(3, 1)});
  const SC::Planar_region_2<K> frame(std::vector<Curve>{
      SC::polyline_curve(std::vector<P>{P(-5, -5), P(5, -5), P(5, 5), P(-5, 5), P(-5, -5)}), circle(2)});
  const Sum sum = SC::swept_area(frame, path);
  EXPECT_TRUE(sum.is_complete());
  ASSERT_EQ(sum.boundaries().size(), 2u);
  int inside = 0, outside = 0;
  for (double x = -0.5; x < 3.5; x += 0.1875)
    for (double y = -1; y < 2; y += 0.1875) {
      double farthest = 0;
      for (int i = 0; i <= 64; ++i)
        farthest = std::max(farthest, CGAL::squared_distance(P(x, y), path(i / 64.0)));
      if (std::abs(std::sqrt(farthest) - 2) < 0.05)
        continue;
      // not known where the path touches the circle
      const CGAL::Uncertain<bool> answer = sum.has_in_interior(P(x, y));
      EXPECT_FALSE(CGAL::certainly(answer != (farthest > 4)));
      (farthest > 4 ? inside : outside) += answer.is_certain();
    }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 20);
}

std::vector<P> random_points(std::mt19937& random, std::size_t number)
{
  std::uniform_real_distribution<double> coordinate(0, 10);
  std::vector<P> result;
  for (std::size_t i = 0; i < number; ++i)
    result.emplace_back(coordinate(random), coordinate(random));
  return result;
}

CGAL::Polygon_2<K> star(double scale)
{
  const std::vector<P> points{P(-scale, -scale), P(scale, -0.75 * scale), P(0.25 * scale, scale), P(0, 0.125 * scale)};
  return {points.begin(), points.end()};
}

TEST(SweptAreas, AlongCubics)
{
  std::mt19937 random(2);
  int inside = 0, outside = 0;
  for (int run = 0; run < 4; ++run) {
    const Curve path = bezier(random_points(random, 4));
    const Sum sum = SC::swept_area(SC::planar_region(star(1)), path);
    EXPECT_TRUE(sum.is_complete());
    const auto polygons = sum.polygons_with_holes(1e-4);
    std::vector<P> steps;
    for (int i = 0; i <= 300; ++i)
      steps.push_back(path(i / 300.0));
    for (const P& p : random_points(random, 50)) {
      const auto is_passed_by = [&](const CGAL::Polygon_2<K>& polygon) {
        return std::any_of(steps.begin(), steps.end(), [&](const P& q) {
          return polygon.bounded_side(CGAL::ORIGIN + (p - q)) == CGAL::ON_BOUNDED_SIDE;
        });
      };
      const bool is_inside = is_passed_by(star(1));
      if (!is_inside && is_passed_by(star(1.1)))
        continue;   // near the boundary
      const bool is_in_polygons = std::any_of(polygons.begin(), polygons.end(), [&](const auto& polygon) {
        return polygon.outer_boundary().bounded_side(p) == CGAL::ON_BOUNDED_SIDE &&
            std::all_of(polygon.holes_begin(), polygon.holes_end(),
                        [&](const auto& hole) { return hole.bounded_side(p) == CGAL::ON_UNBOUNDED_SIDE; });
      });
      EXPECT_EQ(is_in_polygons, is_inside);
      EXPECT_TRUE(CGAL::certainly(sum.has_in_interior(p) == is_inside));
      ++(is_inside ? inside : outside);
    }
  }
  EXPECT_GT(inside, 20);
  EXPECT_GT(outside, 20);
}

// Two squares with a common corner, from which the path leads through both sides of what they cover: sums of this
// corner and a part of the path are there in both directions, and the part ends where the path has the direction of a
// diagonal, at no rational parameter.
TEST(SweptAreas, OfSquaresWithACommonCorner)
{
  const std::vector<P> outline{P(0, 0), P(1, 0), P(1, 1), P(0, 1), P(0, 0), P(-1, 0), P(-1, -1), P(0, -1), P(0, 0)};
  const Curve path = bezier({P(0, 0), P(1, 2), P(2, -1), P(3, 1)});
  const Sum sum = SC::swept_area(SC::planar_region(SC::polyline_curve(outline)), path);
  EXPECT_TRUE(sum.is_complete());
  ASSERT_EQ(sum.boundaries().size(), 1U);
  EXPECT_FALSE(sum.boundaries()[0].is_hole);
  const auto polygons = sum.polygons_with_holes(1e-3);
  ASSERT_EQ(polygons.size(), 1U);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-1.5, 4.5);
  constexpr int steps = 500;
  int inside = 0, outside = 0;
  for (int i = 0; i < 200; ++i) {
    const P p(place(random), place(random) / 2);
    double nearest = 10;   // the largest of the distances of x and y from the squares, negative inside
    for (int k = 0; k <= steps; ++k) {
      const K::Vector_2 way = p - path(static_cast<double>(k) / steps);
      for (const double middle : {-0.5, 0.5})
        nearest = std::min(nearest, std::max(std::abs(way.x() - middle), std::abs(way.y() - middle)) - 0.5);
    }
    if (std::abs(nearest) < 0.01)
      continue;
    const bool is_inside = nearest < 0;
    EXPECT_EQ(polygons[0].outer_boundary().bounded_side(p) == CGAL::ON_BOUNDED_SIDE, is_inside);
    ++(is_inside ? inside : outside);
  }
  EXPECT_GT(inside, 40);
  EXPECT_GT(outside, 40);
}

// A hole with a side that has exactly the direction of the path in its inflection: the sums of the side and this point
// are inside, as the path crosses the side there.
TEST(SweptAreas, OfASideAlongAnInflection)
{
  const std::vector<P> hole{P(-4, 2), P(4, -2), P(5, 4), P(-4, 4)},
      frame{P(-9, -9), P(9, -9), P(9, 9), P(-9, 9), P(-9, -9)};
  const auto closed = [](std::vector<P> points) {
    points.push_back(P(points.front()));
    return SC::polyline_curve(points);
  };
  const Curve path = bezier({P(0, 0), P(1, 2), P(2, -1), P(3, 1)});
  const Sum sum =
      SC::swept_area(SC::Planar_region_2<K>(std::vector<Curve>{SC::polyline_curve(frame), closed(hole)}), path);
  EXPECT_TRUE(sum.is_complete());
  EXPECT_EQ(sum.boundaries().size(), 2U);
  const auto polygons = sum.polygons_with_holes(1e-3);
  ASSERT_EQ(polygons.size(), 1U);
  ASSERT_EQ(polygons[0].number_of_holes(), 1U);
  const CGAL::Polygon_2<K> opening(hole.begin(), hole.end());
  int covered = 0, open = 0;
  for (double x = -4.03; x < 8; x += 0.75)
    for (double y = -2.07; y < 5; y += 0.75) {
      const auto is_open = [&](const P& p) {   // whether the hole stays around a point
        for (int k = 0; k <= 100; ++k)
          if (opening.bounded_side(CGAL::ORIGIN + (p - path(k / 100.0))) != CGAL::ON_BOUNDED_SIDE)
            return false;
        return true;
      };
      const bool is_hole = is_open(P(x, y));
      if (is_open(P(x - 0.03, y)) != is_hole || is_open(P(x + 0.03, y)) != is_hole ||
          is_open(P(x, y - 0.03)) != is_hole || is_open(P(x, y + 0.03)) != is_hole)
        continue;
      EXPECT_EQ(polygons[0].holes_begin()->bounded_side(P(x, y)) == CGAL::ON_BOUNDED_SIDE, is_hole);
      ++(is_hole ? open : covered);
    }
  EXPECT_GT(open, 15);
  EXPECT_GT(covered, 50);
}

// Sides of the parallelogram are vertical, as is the path in its inflection: a corner of it begins there with exactly
// this direction, and one ends with it. The path has x' >= 0, so that all vertical sections are connected.
TEST(SweptAreas, OfAParallelogramAlongAnInflection)
{
  constexpr int sections = 200, steps = 4000;
  const Curve path = bezier({P(0, 0), P(1, 0), P(0, 1), P(1, 1)});
  std::vector<P> places;
  for (int k = 0; k <= steps; ++k)
    places.push_back(path(static_cast<double>(k) / steps));
  for (const double scale : {1.0, 0.125}) {
    const SC::Planar_region_2<K> parallelogram = SC::planar_region(
        SC::polyline_curve(std::vector<P>{P(0, 0), P(scale, scale / 2), P(scale, 1.5 * scale), P(0, scale), P(0, 0)}));
    double expected = 0;
    for (int i = 0; i < sections; ++i) {
      const double x = (i + 0.5) / sections * (1 + scale);
      double lowest = 10, highest = -10;   // of the lower side of the parallelogram
      for (const P& p : places)
        if (p.x() <= x && x <= p.x() + scale) {
          lowest = std::min(lowest, p.y() + (x - p.x()) / 2);
          highest = std::max(highest, p.y() + (x - p.x()) / 2);
        }
      expected += (highest - lowest + scale) * (1 + scale) / sections;
    }
    const Sum sum = SC::swept_area(parallelogram, path);
    EXPECT_TRUE(sum.is_complete());
    EXPECT_EQ(sum.boundaries().size(), 1U);
    EXPECT_NEAR(area(sum), expected, 2e-3);
  }
}

TEST(SweptAreas, OfCurvesAlongCurves)
{
  expect_area(SC::swept_area(segment(P(0, 0), P(3, 1)), segment(P(0, 0), P(1, 2))), 5, 1);
  expect_area(SC::swept_area(bezier({P(0, 0), P(1, 2), P(2, 0)}), segment(P(0, 0), P(0, 1))), 2, 1);
  // of the hull of the disks in both places, without what they have in common
  expect_area(SC::swept_area(segment(P(0, 0), P(0, 1)), circle(3)),
              6 + 9 * CGAL_PI - (18 * std::acos(1 / 6.0) - 0.5 * std::sqrt(35)), 2);
  // a segment, whose derivative is zero in both ends
  expect_area(SC::swept_area(bezier({P(0, 0), P(0, 0), P(1, 2), P(1, 2)}), segment(P(0, 0), P(3, 1))), 5, 1);
  const Sum flat = SC::swept_area(segment(P(0, 0), P(1, 1)), segment(P(0, 0), P(2, 2)));
  EXPECT_TRUE(flat.is_complete());
  EXPECT_TRUE(flat.boundaries().empty());
}

// The boundary passes cusps and swallowtails of the envelope. A random point is inside just if the path crosses the arc
// that is reflected in it, whose height over the x-axis is known; near the boundary this is not asked. The area is the
// share of those points.
TEST(SweptAreas, OfArcsAlongCubics)
{
  const auto height = [](double x) {
    const double t = std::sqrt(4 + 2 * x) - 2;
    return 4 * t * (1 - t) + 0.5 * t * t;
  };
  constexpr int runs = 5, points_of_each = 1000, asked_of_each = 40, steps = 300;
  constexpr double width = 12.5;
  std::mt19937 random(3), random_queries(4);
  std::uniform_real_distribution<double> coordinate(0, 10), query(0, width);
  double areas = 0;
  int inside = 0, asked = 0;
  for (int run = 0; run < runs; ++run) {
    std::vector<P> points;
    for (int i = 0; i < 4; ++i) {
      const double x = coordinate(random), y = coordinate(random);
      points.emplace_back(x, y);
    }
    const Curve path = bezier(points), arc = bezier({P(0, 0), P(1, 2), P(2.5, 0.5)});
    const Sum sum = SC::swept_area(arc, path);
    EXPECT_TRUE(sum.is_complete());
    for (const auto& boundary : sum.boundaries())
      EXPECT_TRUE(boundary.is_closed);
    areas += area(sum, 1e-4);
    std::vector<std::array<double, 2>> along;
    for (int i = 0; i <= steps; ++i) {
      const P q = path(static_cast<double>(i) / steps);
      along.push_back({q.x(), q.y()});
    }
    const auto is_covered = [&](double x, double y) {
      double last = 0;   // above (1) or below (-1) of the arc, or beside it (0)
      for (const auto& [u, v] : along) {
        const double next = x - u < 0 || x - u > 2.5 ? 0 : y - v > height(x - u) ? 1 : -1;
        if (last * next < 0)
          return true;
        last = next;
      }
      return false;
    };
    for (int i = 0; i < points_of_each; ++i) {
      const double x = query(random_queries), y = query(random_queries), error = 0.05;
      const bool is_inside = is_covered(x, y);
      inside += is_inside;
      if (i >= asked_of_each || is_covered(x - error, y) != is_inside || is_covered(x + error, y) != is_inside ||
          is_covered(x, y - error) != is_inside || is_covered(x, y + error) != is_inside)
        continue;
      EXPECT_TRUE(CGAL::certainly(sum.has_in_interior(P(x, y)) == is_inside)) << run << ": " << x << ", " << y;
      ++asked;
    }
  }
  EXPECT_GT(asked, runs * asked_of_each / 2);
  const double share = static_cast<double>(inside) / (runs * points_of_each);
  EXPECT_GT(share, 0.02);
  EXPECT_NEAR(areas / (runs * width * width), share, 4 * std::sqrt(share * (1 - share) / (runs * points_of_each)));
}

TEST(SweptAreas, BadInput)
{
  EXPECT_THROW(SC::swept_area(disk(1), bezier({P(0, 0), P(0, 0)})), SC::Invalid_input);
  EXPECT_THROW(SC::swept_area(disk(1), bezier({P(0, 0), P(1, 1), P(0, 0)})), SC::Invalid_input);   // turns back
  // on its line
  EXPECT_THROW(SC::swept_area(disk(1), bezier({P(0, 0), P(3, 0), P(-1, 0), P(1, 0)})), SC::Invalid_input);
  // a coordinate that is small beside others
  EXPECT_TRUE(SC::swept_area(unit_square(), segment(P(0, 0), P(1e-300, 1))).is_complete());
  for (const double size : {1e-300, 1e-200, 1e-100, 1e100, 1e150, 1e200, 1e300}) {
    EXPECT_THROW(
        SC::swept_area(SC::planar_region(SC::polyline_curve(std::vector<P>{P(0, 0), P(size, 0), P(0, size), P(0, 0)})),
                       segment(P(0, 0), P(size, 3 * size))),
        SC::Invalid_input);
  }
  for (const double size : {1e100, 1e150, 1e200, 1e300})
    EXPECT_THROW(SC::swept_area(disk(1), segment(P(0, 0), P(size, 0))), SC::Invalid_input);
}

} // namespace

} // namespace swept_areas_2_test
