// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets of drawings on a grid with cubics for round corners, at distances at which disks touch two walls, a wall and
// a corner, or both ends of a round corner exactly.
#include "polygon_area.h"

#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace round_offset_distances_2_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using P = K::Point_2;
using V = K::Vector_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Offset = SC::Trimmed_offset_2<K>;

constexpr double pi = 3.14159265358979323846;
// of cubics instead of quarters of a circle, as drawings have them: they are up to 0.00028 outside of it, and meet it
// in both ends
constexpr double handle = 0.5523;

// A polygon with a round corner of a given radius, or 0, in each point. All sides are parallel to the axes.
void append_rounded_polygon(Curves& curves, const std::vector<P>& corners, const std::vector<double>& radii)
{
  const std::size_t n = corners.size();
  const auto way = [&](std::size_t i, std::size_t j) {
    const V v = corners[j % n] - corners[i % n];
    return v / std::sqrt(v.squared_length());
  };
  for (std::size_t i = 0; i < n; ++i) {
    const P &a = corners[i], &b = corners[(i + 1) % n];
    const V in = way(i, i + 1), out = way(i + 1, i + 2);
    const double r = radii[(i + 1) % n];
    const P last = b - r * in, next = b + r * out, first = a + radii[i] * in;
    if (first != last)
      curves.push_back(SC::bezier_curve(std::vector<P>{first, last}));
    if (r > 0)
      curves.push_back(SC::bezier_curve(std::vector<P>{last, last + handle * r * in, next - handle * r * out, next}));
  }
}

Curves rounded_polygon(const std::vector<P>& corners, double radius)
{
  Curves result;
  append_rounded_polygon(result, corners, std::vector<double>(corners.size(), radius));
  return result;
}

std::vector<P> square(double half) { return {P(-half, -half), P(half, -half), P(half, half), P(-half, half)}; }

std::size_t number_of_components(const Offset& offset)
{
  EXPECT_TRUE(offset.is_complete());
  return static_cast<std::size_t>(std::count_if(offset.boundaries().begin(), offset.boundaries().end(),
                                                [](const auto& boundary) { return !boundary.is_hole; }));
}

// Whether points are in an offset is told by their distances from points of the boundary. Returns how many of those
// that were asked are in it.
int expect_points_of_offset(const Curves& curves, const SC::Planar_region_2<K>& region, double r, std::mt19937& random)
{
  const Offset offset = SC::trimmed_offset(region, r);
  EXPECT_TRUE(offset.is_complete()) << r;
  const auto polygons = offset.polygons_with_holes(1e-4);
  std::vector<P> boundary;
  CGAL::Bbox_2 box;
  for (const Curve& curve : curves)
    for (int i = 0; i <= 100; ++i) {
      boundary.push_back(curve(i / 100.0));
      box += boundary.back().bbox();
    }
  std::uniform_real_distribution<double> x(box.xmin() - 1, box.xmax() + 1), y(box.ymin() - 1, box.ymax() + 1);
  int inside = 0;
  for (int i = 0; i < 60; ++i) {
    const P p(x(random), y(random));
    double square = std::numeric_limits<double>::infinity();
    for (const P& q : boundary)
      square = (std::min)(square, CGAL::squared_distance(p, q));
    const double distance = (region.bounded_side(p) == CGAL::ON_BOUNDED_SIDE ? -1 : 1) * std::sqrt(square);
    if (std::abs(distance - r) < 0.01)
      continue;
    const auto holds = [&](const auto& polygon) { return polygon.bounded_side(p) == CGAL::ON_BOUNDED_SIDE; };
    const bool is_in = std::any_of(polygons.begin(), polygons.end(), [&](const auto& polygon) {
      return holds(polygon.outer_boundary()) && std::none_of(polygon.holes_begin(), polygon.holes_end(), holds);
    });
    EXPECT_EQ(is_in, distance < r) << p << ' ' << r;
    inside += is_in;
  }
  return inside;
}

// The disk in a round corner touches both its ends, and those of the sides begin there: what is left is the rectangle
// of the centers.
TEST(RoundOffsetDistances, RoundedRectangleBecomesSharp)
{
  Curves curves;
  append_rounded_polygon(curves, {P(0, 0), P(6, 0), P(6, 4), P(0, 4)}, {1, 0, 0, 0});
  const auto region = SC::planar_region(curves);
  const Offset offset = SC::trimmed_offset(region, -1);
  EXPECT_EQ(number_of_components(offset), 1U);
  EXPECT_EQ(offset.arcs().size(), 4U);
  const auto polygons = offset.polygons_with_holes(1e-4);
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_NEAR(total_area(polygons), 8, 1e-9);
}

// Walls at twice the distance, and a cap whose disks stay between these.
TEST(RoundOffsetDistances, NothingIsLeftOfAStroke)
{
  Curves curves;
  append_rounded_polygon(curves, {P(0, 0), P(6, 0), P(6, 2), P(0, 2)}, {1, 0, 0, 1});
  EXPECT_EQ(number_of_components(SC::trimmed_offset(SC::planar_region(curves), -1)), 0U);
}

// A ring that is 2 wide in the directions of the axes, and between up to 0.0006 more: the four parts in which there are
// disks of radius 1 touch there.
TEST(RoundOffsetDistances, RingBetweenCubics)
{
  Curves curves = rounded_polygon(square(3), 3);
  append_rounded_polygon(curves, square(1), {1, 1, 1, 1});
  const auto region = SC::planar_region(curves);
  const Offset offset = SC::trimmed_offset(region, -1);
  EXPECT_EQ(number_of_components(offset), 4U);
  EXPECT_GT(total_area(offset.polygons_with_holes(1e-7)), 1e-4);
  EXPECT_LT(total_area(offset.polygons_with_holes(1e-7)), 4 * pi * 0.0006);
}

// A wall opposite to the end of a quarter of a circle, at twice the distance. As a line touches a circle, curves are
// cut where they cross, at irrational parameters of both.
TEST(RoundOffsetDistances, OppositePartsOfCurvesThatCross)
{
  const Curves curves{SC::bezier_curve(std::vector<P>{P(60, 22), P(100, 22)}),
                      SC::circle_curve(P(85, 46), 20),
                      SC::circle_curve(P(40, 40), 25),
                      SC::bezier_curve(std::vector<P>{P(5, 15), P(75, 15)}),
                      SC::bezier_curve(std::vector<P>{P(5, 50), P(20, -10), P(40, 90), P(60, 40)}),
                      SC::bezier_curve(std::vector<P>{P(60, 40), P(80, -10), P(95, 10), P(115, 40)})};
  const Offset offset = SC::trimmed_offset(curves, 2), larger = SC::trimmed_offset(curves, 2 + 0x1p-20),
               smaller = SC::trimmed_offset(curves, 2 - 0x1p-20);
  EXPECT_EQ(number_of_components(offset), 1U);
  EXPECT_EQ(number_of_components(larger), 1U);
  EXPECT_EQ(offset.boundaries().size(), larger.boundaries().size());
  EXPECT_EQ(smaller.boundaries().size() + 1, larger.boundaries().size());   // one hole less, below the wall
  EXPECT_NEAR(total_area(offset.polygons_with_holes(1e-4)), total_area(larger.polygons_with_holes(1e-4)), 0.01);
}

// Columns of different heights, some corners of which are round.
TEST(RoundOffsetDistances, RandomDrawingOnAGrid)
{
  std::mt19937 random(7);
  const auto number = [&](int least, int most) { return std::uniform_int_distribution<int>(least, most)(random); };
  int inside = 0;
  std::vector<P> corners{P(0, 0)};
  int x = 0, last = 0;
  for (int k = 0; k < 4; ++k) {
    const int height = last == 0 ? number(1, 6) : (last + number(1, 5)) % 6 + 1;
    if (height == last)
      continue;
    if (k > 0)
      corners.push_back(P(x, last));
    corners.push_back(P(x, height));
    x += number(1, 3);
    last = height;
  }
  corners.push_back(P(x, last));
  corners.push_back(P(x, 0));
  std::reverse(corners.begin(), corners.end());
  std::vector<double> radii;
  for (std::size_t i = 0; i < corners.size(); ++i)
    radii.push_back(number(0, 2) > 0 ? 0.5 : 0);
  Curves curves;
  append_rounded_polygon(curves, corners, radii);
  const auto region = SC::planar_region(curves);
  for (const double r : {-1.0, 0.5})
    inside += expect_points_of_offset(curves, region, r, random);
  EXPECT_GT(inside, 20);
}

// A hook with a round tip. Inside of its bend, the derivative of a cubic is zero where the tip begins: disks in the
// stroke touch the tip there, and the other side.
TEST(RoundOffsetDistances, HookWithZeroDerivatives)
{
  Curves curves;
  P last(5, 1);
  const auto append = [&](std::vector<P> points) {
    points.insert(points.begin(), last);
    last = points.back();
    curves.push_back(SC::bezier_curve(points));
  };
  append({P(5, 4)});
  append({P(1, 4)});
  append({P(0, 4), P(0, 3), P(0, 3)});
  append({P(0, 2.45), P(-0.45, 2), P(-1, 2)});
  append({P(-1.55, 2), P(-2, 2.45), P(-2, 3)});
  append({P(-2, 4.25), P(-1.25, 5.25), P(-0.5, 5.625)});
  append({P(0.25, 6), P(1, 6), P(1, 6)});
  append({P(7, 6)});
  append({P(7, 1)});
  append({P(5, 1)});
  const auto region = SC::planar_region(curves);
  std::mt19937 random(3);
  int inside = 0;
  for (const double r : {-0.5, -0.3})
    inside += expect_points_of_offset(curves, region, r, random);
  EXPECT_GT(inside, 10);
}

} // namespace round_offset_distances_2_test
