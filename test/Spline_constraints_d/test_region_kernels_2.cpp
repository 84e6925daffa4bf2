// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Kernels of regions: polygons against intersections of half-planes, closed forms, tangents on a grid, and invariants.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/region_kernels_2.h>

#include <CGAL/Polygon_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace region_kernels_2_test {

namespace SC = CGAL::Spline_constraints;
using K = Double_cartesian;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Kind = SC::Kernel_edge_kind;

const double pi = std::acos(-1.0);

template <class Point>
auto closed(std::vector<Point> corners)
{
  corners.push_back(corners.front());
  return SC::polyline_curve(corners);
}

void expect_area(const SC::Region_kernel_2<K>& kernel, double expected)
{
  const auto [lower, upper] = kernel.area();
  EXPECT_LE(lower, upper);
  EXPECT_LE(SC::to_nearest_double(SC::Exact_rational(upper - lower)), 1e-10);
  EXPECT_NEAR(SC::to_nearest_double(lower), expected, 1e-10);
}

// A point of a curve, and the derivative there, of length one.
struct Tangent
{
  Point point;
  K::Vector_2 direction;
};

std::vector<Tangent> tangents_of(const Curve& curve, int samples)
{
  std::vector<Tangent> result;
  const auto [begin, end] = curve.domain();
  for (int i = 0; i < samples; ++i) {
    const double u = begin + (end - begin) * (i + 0.5) / samples;
    const auto v = curve.derivative(u);
    result.push_back({curve(u), v / std::hypot(v.x(), v.y())});
  }
  return result;
}

// The least of the heights of a point above tangents.
double least_height(const std::vector<Tangent>& tangents, const Point& p)
{
  double result = std::numeric_limits<double>::infinity();
  for (const auto& [q, v] : tangents)
    result = std::min(result, v.x() * (p.y() - q.y()) - v.y() * (p.x() - q.x()));
  return result;
}

// The polygon turns left; points a little inside of it are on the left of all tangents, and points a little outside are not. The curve is counterclockwise.
void expect_kernel(const Curve& curve, const SC::Region_kernel_2<K>& kernel)
{
  const std::vector<Tangent> tangents = tangents_of(curve, 400);
  ASSERT_TRUE(kernel.has_interior());
  EXPECT_TRUE(kernel.is_complete());
  EXPECT_TRUE(CGAL::certainly_not(kernel.is_empty()));
  for (std::size_t i = 0; i < kernel.edges().size(); ++i)
    for (const auto& [lower, upper] : kernel.source_ranges(i))
      EXPECT_LE(SC::to_nearest_double(SC::Exact_rational(upper - lower)), 1e-12);
  const Point o = kernel.centre();
  EXPECT_GT(least_height(tangents, o), 0);
  const auto polygon = kernel.polygon(0.05);
  ASSERT_GE(polygon.size(), 3u);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()], &r = polygon[(i + 2) % polygon.size()];
    EXPECT_GT((q.x() - p.x()) * (r.y() - q.y()) - (q.y() - p.y()) * (r.x() - q.x()), -1e-10);
    const Point inside = o + 0.999 * (q - o), outside = o + 1.01 * (q - o);
    EXPECT_GT(least_height(tangents, inside), 0);
    EXPECT_LT(least_height(tangents, outside), 0);
  }
}

using E = Exact_cartesian;

// The part of a convex polygon on the left of a line.
std::vector<E::Point_2> cut(const std::vector<E::Point_2>& polygon, const E::Line_2& line)
{
  std::vector<E::Point_2> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const E::Point_2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    if (!line.has_on_negative_side(p))
      result.push_back(p);
    if (line.oriented_side(p) * line.oriented_side(q) < 0) {
      const E::FT s = line.a() * p.x() + line.b() * p.y() + line.c(), r = line.a() * q.x() + line.b() * q.y() + line.c();
      result.push_back(p + s / (s - r) * (q - p));
    }
  }
  return result;
}

std::vector<E::Point_2> without_flat_corners(std::vector<E::Point_2> points)
{
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (points.size() > 1 && points.front() == points.back())
    points.pop_back();
  std::vector<E::Point_2> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!CGAL::collinear(points[(i + points.size() - 1) % points.size()], points[i], points[(i + 1) % points.size()]))
      result.push_back(points[i]);
  std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
  return result;
}

TEST(region_kernels_2, polygons)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> radius(3, 9), size(4, 9);
  int full = 0, empty = 0;
  for (int n = 0; n < 40; ++n) {
    const int corners = size(random);
    std::vector<E::Point_2> points;
    for (int i = 0; i < corners; ++i) {   // around the origin, or a point at the side so that the kernel is often empty
      const double angle = 2 * pi * i / corners;
      const int r = radius(random);
      points.emplace_back(int(std::round(10 * r * std::cos(angle))) + (n % 3 == 0 && i % 2 == 0 ? 60 : 0), int(std::round(10 * r * std::sin(angle))));
    }
    const CGAL::Polygon_2<E> polygon(points.begin(), points.end());
    if (!polygon.is_simple() || polygon.orientation() != CGAL::COUNTERCLOCKWISE)
      continue;
    std::vector<E::Point_2> expected{{-200, -200}, {200, -200}, {200, 200}, {-200, 200}};
    for (int i = 0; i < corners; ++i)
      expected = cut(expected, E::Line_2(points[i], points[(i + 1) % corners]));
    const auto kernel = SC::region_kernel(closed(points));
    EXPECT_TRUE(kernel.is_complete());
    if (CGAL::Polygon_2<E>(expected.begin(), expected.end()).area() <= 0) {
      EXPECT_FALSE(kernel.has_interior());
      ++empty;
      continue;
    }
    ASSERT_TRUE(kernel.has_interior());
    std::vector<E::Point_2> found;
    for (std::size_t i = 0; i < kernel.edges().size(); ++i) {
      EXPECT_EQ(kernel.edges()[i].kind, Kind::SEGMENT);
      found.push_back(kernel.source(i));
    }
    EXPECT_EQ(without_flat_corners(found), without_flat_corners(expected)) << n;
    EXPECT_EQ(kernel.area().first, kernel.area().second);
    ++full;
  }
  EXPECT_GE(full, 10);
  EXPECT_GE(empty, 3);
}

TEST(region_kernels_2, convex_regions)
{
  const auto disk = SC::region_kernel(SC::circle_curve(Point(3, 1), 2.0));
  ASSERT_EQ(disk.edges().size(), 1u);
  EXPECT_EQ(disk.edges()[0].kind, Kind::ARC);
  EXPECT_EQ(disk.edges()[0].parameters[1].first, 4);
  expect_area(disk, 4 * pi);

  // Straight parts and arcs of parabolas, smoothly joined: all of the region.
  const auto arc = [](const Point& p, const Point& q, const Point& r) { return Curve(2, {0, 0, 0, 1, 1, 1}, {p, q, r}); };
  const auto line = [](const Point& p, const Point& q) { return SC::polyline_curve(std::vector<Point>{p, q}); };
  const Curves smooth{line({0, 0}, {5, 0}), arc({5, 0}, {6, 0}, {6, 1}), arc({6, 1}, {6, 2}, {5, 2}), line({5, 2}, {0, 2}), arc({0, 2}, {-1, 2}, {-1, 1}), arc({-1, 1}, {-1, 0}, {0, 0})};
  const auto region = SC::planar_region(smooth);
  const auto all = SC::region_kernel(region);
  EXPECT_TRUE(all.is_complete());
  EXPECT_EQ(count_edges(all, Kind::ARC), 4u);
  EXPECT_EQ(count_edges(all, Kind::SEGMENT), 2u);
  EXPECT_EQ(all.area(), region.area());
}

// A square with a parabola that bulges inwards: of its tangents, those at its ends bound the kernel.
TEST(region_kernels_2, reflex_arcs)
{
  const auto arc = [](const Point& p, const Point& q, const Point& r) { return Curve(2, {0, 0, 0, 1, 1, 1}, {p, q, r}); };
  const auto line = [](const Point& p, const Point& q) { return SC::polyline_curve(std::vector<Point>{p, q}); };
  const Curves region{arc({-1, 0}, {0, 2}, {1, 0}), line({1, 0}, {4, 0}), line({4, 0}, {4, 8}), line({4, 8}, {-4, 8}), line({-4, 8}, {-4, 0}), line({-4, 0}, {-1, 0})};
  const auto kernel = SC::region_kernel(region);
  EXPECT_TRUE(kernel.is_complete());
  EXPECT_EQ(kernel.edges().size(), 3u);
  EXPECT_EQ(count_edges(kernel, Kind::SEGMENT), 3u);
  // y >= 2 + 2x and y >= 2 - 2x in the square |x| <= 4, y <= 8: the corners are (0,2), (3,8), (-3,8)
  EXPECT_EQ(kernel.area().first, 18);
  EXPECT_EQ(kernel.area().second, 18);
}

// Smooth closed curves around a centre, with inflections.
TEST(region_kernels_2, random_curves)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(3, 6);
  int with_arcs = 0;
  for (int scene = 0; scene < 5; ++scene) {
    const int n = 7 + scene % 4;
    std::vector<double> breaks;
    std::vector<Point> points;
    for (int i = 0; i <= n; ++i)
      breaks.push_back(i);
    for (int i = 0; i < n; ++i) {
      const double r = radius(random), angle = 2 * pi * i / n;
      points.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
    const Curve curve = Curve::from_periodic(3, breaks, points);
    const auto kernel = SC::region_kernel(curve);
    expect_kernel(curve, kernel);
    with_arcs += count_edges(kernel, Kind::ARC) > 0;
    const auto shifted = SC::region_kernel(curve.transformed(K::Aff_transformation_2(CGAL::TRANSLATION, K::Vector_2(16, -8))));
    EXPECT_EQ(shifted.edges().size(), kernel.edges().size());
    expect_area(shifted, SC::to_nearest_double(kernel.area().first));
  }
  EXPECT_GE(with_arcs, 2);
}

TEST(region_kernels_2, no_interior)
{
  const auto annulus = SC::region_kernel(Curves{SC::circle_curve(Point(0, 0), 2.0), SC::circle_curve(Point(0, 0), 1.0)});
  EXPECT_TRUE(annulus.is_complete());
  EXPECT_TRUE(CGAL::certainly(annulus.is_empty()));
  const auto spiral = SC::region_kernel(closed(std::vector<Point>{{0, 0}, {6, 0}, {6, 6}, {1, 6}, {1, 3}, {2, 3}, {2, 5}, {5, 5}, {5, 1}, {0, 1}}));
  EXPECT_TRUE(CGAL::certainly(spiral.is_empty()));
  EXPECT_TRUE(spiral.edges().empty());
  EXPECT_TRUE(spiral.polygon(1).is_empty());
  // Four blades, whose straight parts are on the axes: only the origin sees all of them.
  const auto blades = SC::region_kernel(closed(std::vector<Point>{{1, 0}, {4, 0}, {4, 3}, {0, 1}, {0, 4}, {-3, 4}, {-1, 0}, {-4, 0}, {-4, -3}, {0, -1}, {0, -4}, {3, -4}}));
  EXPECT_TRUE(blades.is_complete());
  EXPECT_FALSE(blades.has_interior());
  EXPECT_TRUE(CGAL::certainly_not(blades.is_empty()));
  EXPECT_EQ(blades.flat_part(), std::vector<Point>{Point(0, 0)});
  // Two squares see all of each other from their common corner only; those that do not touch, from nowhere.
  const auto squares = SC::region_kernel(closed(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {-1, 0}, {-1, -1}, {0, -1}}));
  EXPECT_TRUE(CGAL::certainly_not(squares.is_empty()));
  EXPECT_EQ(squares.flat_part(), std::vector<Point>{Point(0, 0)});
  const auto bent = SC::region_kernel(closed(std::vector<Point>{{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}, {0, 0}, {-1, 0}, {-1, -1}, {0, -1}}));
  EXPECT_TRUE(CGAL::certainly(bent.is_empty()));
  expect_invalid([&] { annulus.polygon(0); }, "error must be positive");
  expect_invalid([] { SC::region_kernel(closed(std::vector<Point>{{0, 0}, {4, 0}, {0, 4}, {4, 4}})); }, "curve 0 at parameter 1.500000 and curve 0 at parameter 3.500000 cross");
}

} // namespace region_kernels_2_test
