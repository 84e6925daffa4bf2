// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Kernels of regions: polygons against intersections of half-planes, closed forms, tangents on a grid, and invariants.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/visibility/region_kernels_2.h>

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

// The polygon turns left; points a little inside of it are on the left of all tangents, and points a little outside are
// not. The curve is counterclockwise.
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
      const E::FT s = line.a() * p.x() + line.b() * p.y() + line.c(),
                  r = line.a() * q.x() + line.b() * q.y() + line.c();
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
      points.emplace_back(int(std::round(10 * r * std::cos(angle))) + (n % 3 == 0 && i % 2 == 0 ? 60 : 0),
                          int(std::round(10 * r * std::sin(angle))));
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
  const auto arc = [](const Point& p, const Point& q, const Point& r) {
    return Curve(2, {0, 0, 0, 1, 1, 1}, {p, q, r});
  };
  const auto line = [](const Point& p, const Point& q) { return SC::polyline_curve(std::vector<Point>{p, q}); };
  const Curves smooth{line({0, 0}, {5, 0}), arc({5, 0}, {6, 0}, {6, 1}),   arc({6, 1}, {6, 2}, {5, 2}),
                      line({5, 2}, {0, 2}), arc({0, 2}, {-1, 2}, {-1, 1}), arc({-1, 1}, {-1, 0}, {0, 0})};
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
  const auto arc = [](const Point& p, const Point& q, const Point& r) {
    return Curve(2, {0, 0, 0, 1, 1, 1}, {p, q, r});
  };
  const auto line = [](const Point& p, const Point& q) { return SC::polyline_curve(std::vector<Point>{p, q}); };
  const Curves region{arc({-1, 0}, {0, 2}, {1, 0}), line({1, 0}, {4, 0}),   line({4, 0}, {4, 8}),
                      line({4, 8}, {-4, 8}),        line({-4, 8}, {-4, 0}), line({-4, 0}, {-1, 0})};
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
    const auto shifted =
        SC::region_kernel(curve.transformed(K::Aff_transformation_2(CGAL::TRANSLATION, K::Vector_2(16, -8))));
    EXPECT_EQ(shifted.edges().size(), kernel.edges().size());
    expect_area(shifted, SC::to_nearest_double(kernel.area().first));
  }
  EXPECT_GE(with_arcs, 2);
}

// Four parabolas that turn left, with a reflex corner at (0,27): the tangent of each arc there bounds the kernel on the
// side of the other one. Each meets that arc, beside (0,27), where 70 t = 39, and where 415 t = 186.
TEST(region_kernels_2, reflex_corner_between_arcs)
{
  const auto arc = [](const Point& p, const Point& q, const Point& r) {
    return Curve(2, {0, 0, 0, 1, 1, 1}, {p, q, r});
  };
  const Curves curves{arc({36, 0}, {33, 33}, {0, 27}), arc({0, 27}, {-30, 30}, {-34, 0}),
                      arc({-34, 0}, {-18, -18}, {0, -32}), arc({0, -32}, {19, -19}, {36, 0})};
  const auto region = SC::planar_region(curves);
  const auto kernel = SC::region_kernel(region);
  EXPECT_TRUE(kernel.is_complete());
  const SC::Exact_rational t0(SC::Exact_rational(39) / 70), t1(SC::Exact_rational(186) / 415);
  struct Expected
  {
    Kind kind;
    std::size_t curve;
    SC::Exact_rational begin, end;
  };
  const std::vector<Expected> expected{{Kind::ARC, 0, 0, t0}, {Kind::SEGMENT, 1, 0, 0}, {Kind::SEGMENT, 0, 1, 1},
                                       {Kind::ARC, 1, t1, 1}, {Kind::ARC, 2, 0, 1},     {Kind::ARC, 3, 0, 1}};
  const auto& edges = kernel.edges();
  ASSERT_EQ(edges.size(), expected.size());
  const auto first =
      std::find_if(edges.begin(), edges.end(),
                   [](const SC::Kernel_edge_2& edge) { return edge.kind == Kind::ARC && edge.curve == 0; }) -
      edges.begin();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const SC::Kernel_edge_2& edge = edges[(static_cast<std::size_t>(first) + i) % edges.size()];
    EXPECT_EQ(edge.kind, expected[i].kind) << i;
    EXPECT_EQ(edge.curve, expected[i].curve) << i;
    for (const int end : {0, 1}) {
      const auto& [lower, upper] = edge.parameters[end];
      const SC::Exact_rational& t = end == 0 ? expected[i].begin : expected[i].end;
      EXPECT_TRUE(lower <= t && t <= upper) << i;
      EXPECT_LE(SC::to_nearest_double(SC::Exact_rational(upper - lower)), 1e-12) << i;
    }
  }
  const auto corner = kernel.source_ranges((static_cast<std::size_t>(first) + 2) % edges.size());
  EXPECT_TRUE(corner[0].first == 0 && corner[0].second == 0 && corner[1].first == 27 && corner[1].second == 27);
  // Without what these tangents cut off: of an arc of width h, 2/3 h^3 of the triangle of the control points.
  const SC::Exact_rational h(1 - t0), area(region.area().first - 369 * h * h * h - 304 * t1 * t1 * t1);
  EXPECT_EQ(region.area().first, region.area().second);
  EXPECT_TRUE(kernel.area().first <= area && area <= kernel.area().second);
  expect_area(kernel, SC::to_nearest_double(area));
}

// The tangent x = 4 at the begin of a parabola passes through the end (4,-6) of another one, where three tangents meet:
// at a convex corner, and at a reflex one.
TEST(region_kernels_2, tangent_through_end)
{
  const auto region = [](const Point& control) {
    return Curves{SC::bezier_curve(std::vector<Point>{{4, 0}, {4, 4}, {0, 4}}),
                  SC::bezier_curve(std::vector<Point>{{0, 4}, {-4, 4}, {-4, 0}}),
                  SC::bezier_curve(std::vector<Point>{{-4, 0}, control, {4, -6}}),
                  SC::polyline_curve(std::vector<Point>{{4, -6}, {6, -6}, {4, 0}})};
  };
  const auto expect_end = [](const SC::Region_kernel_2<K>& kernel) {
    const auto& edges = kernel.edges();
    const auto tangent = std::find_if(edges.begin(), edges.end(), [](const SC::Kernel_edge_2& edge) {
      return edge.kind == Kind::SEGMENT && edge.curve == 0;
    });
    ASSERT_NE(tangent, edges.end());
    const auto ranges = kernel.source_ranges(static_cast<std::size_t>(tangent - edges.begin()));
    EXPECT_TRUE(ranges[0].first == 4 && ranges[0].second == 4 && ranges[1].first == -6 && ranges[1].second == -6);
  };
  // Corners (4,0), (3,3), (0,4), (-4,0), (4,-6), between which arcs add 2/3, 16/3 and 8/3.
  const auto convex = SC::region_kernel(region({0, -4}));
  EXPECT_TRUE(convex.is_complete());
  EXPECT_EQ(count_edges(convex, Kind::ARC), 3u);
  EXPECT_EQ(count_edges(convex, Kind::SEGMENT), 2u);
  expect_end(convex);
  expect_area(convex, 158.0 / 3);
  // The straight part on y = -6 is on the boundary from (4/5,-6) on; arcs add 2/3, 16/3 and 72/25.
  const auto reflex = SC::region_kernel(region({0, -8}));
  EXPECT_TRUE(reflex.is_complete());
  EXPECT_EQ(count_edges(reflex, Kind::ARC), 3u);
  EXPECT_EQ(count_edges(reflex, Kind::SEGMENT), 3u);
  expect_end(reflex);
  expect_area(reflex, 62.48);
}

// Whether each corner of a polygon is seen from a point: no edge crosses the segment between them.
bool sees_all(const std::vector<Point>& polygon, const Point& p)
{
  const auto side = [](const Point& a, const Point& b, const Point& c) {
    return CGAL::sign(CGAL::determinant(b - a, c - a));
  };
  const std::size_t n = polygon.size();
  for (const Point& q : polygon)
    for (std::size_t i = 0; i < n; ++i) {
      const Point &a = polygon[i], &b = polygon[(i + 1) % n];
      if (a != q && b != q && side(p, q, a) * side(p, q, b) < 0 && side(a, b, p) * side(a, b, q) < 0)
        return false;
    }
  return true;
}

// Four pieces around the origin: straight ones, parabolas and cubics, with corners between them.
Curves random_pieces(std::mt19937& random)
{
  std::uniform_int_distribution<int> degree(1, 3), radius(25, 50);
  const auto at = [&](double angle) {
    const int r = radius(random);
    return Point(std::round(r * std::cos(angle)), std::round(r * std::sin(angle)));
  };
  std::vector<Point> corners;
  for (int i = 0; i < 4; ++i)
    corners.push_back(at(pi * i / 2));
  Curves result;
  for (std::size_t i = 0; i < 4; ++i) {
    const int n = degree(random);
    std::vector<Point> points{corners[i]};
    for (int k = 1; k < n; ++k)
      points.push_back(at(pi * (static_cast<double>(i) + static_cast<double>(k) / n) / 2));
    points.push_back(corners[(i + 1) % 4]);
    result.push_back(SC::bezier_curve(points));
  }
  return result;
}

// A point is in the kernel if and only if it sees all of the boundary. The chords of a boundary are seen from where it
// is. In scene 8, a ray of the search passes exactly through a corner.
TEST(region_kernels_2, random_pieces)
{
  int reflex_corners = 0;
  for (unsigned scene = 0; scene < 12; ++scene) {
    std::mt19937 random(scene);
    const Curves curves = random_pieces(random);
    const auto kernel = SC::region_kernel(curves);
    ASSERT_TRUE(kernel.has_interior()) << scene;
    EXPECT_TRUE(kernel.is_complete()) << scene;
    std::vector<Point> boundary;
    for (const Curve& curve : curves)
      for (int i = 0; i < 32; ++i)
        boundary.push_back(curve(i / 32.0));
    const auto polygon = kernel.polygon(0.05);
    const Point o = kernel.centre();
    for (const Point& p : polygon.container()) {
      EXPECT_TRUE(sees_all(boundary, o + 0.999 * (p - o))) << scene << ": " << p;
      EXPECT_FALSE(sees_all(boundary, o + 1.1 * (p - o))) << scene << ": " << p;
    }
    for (std::size_t i = 0; i < kernel.edges().size(); ++i) {
      const auto &edge = kernel.edges()[i], &next = kernel.edges()[(i + 1) % kernel.edges().size()];
      const auto& [lower, upper] = next.parameters[0];
      reflex_corners += edge.kind == Kind::SEGMENT && next.kind == Kind::SEGMENT && lower == upper && lower == 1 &&
          edge.curve == (next.curve + 1) % 4 && kernel.source((i + 1) % kernel.edges().size()) == curves[next.curve](1);
    }
  }
  EXPECT_GE(reflex_corners, 4);
}

TEST(region_kernels_2, no_interior)
{
  const auto annulus =
      SC::region_kernel(Curves{SC::circle_curve(Point(0, 0), 2.0), SC::circle_curve(Point(0, 0), 1.0)});
  EXPECT_TRUE(annulus.is_complete());
  EXPECT_TRUE(CGAL::certainly(annulus.is_empty()));
  const auto spiral = SC::region_kernel(
      closed(std::vector<Point>{{0, 0}, {6, 0}, {6, 6}, {1, 6}, {1, 3}, {2, 3}, {2, 5}, {5, 5}, {5, 1}, {0, 1}}));
  EXPECT_TRUE(CGAL::certainly(spiral.is_empty()));
  EXPECT_TRUE(spiral.edges().empty());
  EXPECT_TRUE(spiral.polygon(1).is_empty());
  // Four blades, whose straight parts are on the axes: only the origin sees all of them.
  const auto blades = SC::region_kernel(closed(std::vector<Point>{
      {1, 0}, {4, 0}, {4, 3}, {0, 1}, {0, 4}, {-3, 4}, {-1, 0}, {-4, 0}, {-4, -3}, {0, -1}, {0, -4}, {3, -4}}));
  EXPECT_TRUE(blades.is_complete());
  EXPECT_FALSE(blades.has_interior());
  EXPECT_TRUE(CGAL::certainly_not(blades.is_empty()));
  EXPECT_EQ(blades.flat_part(), std::vector<Point>{Point(0, 0)});
  // Two squares see all of each other from their common corner only; those that do not touch, from nowhere.
  const auto squares =
      SC::region_kernel(closed(std::vector<Point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}, {-1, 0}, {-1, -1}, {0, -1}}));
  EXPECT_TRUE(CGAL::certainly_not(squares.is_empty()));
  EXPECT_EQ(squares.flat_part(), std::vector<Point>{Point(0, 0)});
  const auto bent = SC::region_kernel(
      closed(std::vector<Point>{{0, 0}, {2, 0}, {2, 2}, {1, 2}, {1, 1}, {0, 1}, {0, 0}, {-1, 0}, {-1, -1}, {0, -1}}));
  EXPECT_TRUE(CGAL::certainly(bent.is_empty()));
  expect_invalid([&] { annulus.polygon(0); }, "error must be positive");
  expect_invalid(
      [] {
        SC::region_kernel(closed(std::vector<Point>{{0, 0}, {4, 0}, {0, 4}, {4, 4}}));
      },
      "curve 0 at parameter 1.5 and curve 0 at parameter 3.5 cross");
}

} // namespace region_kernels_2_test
