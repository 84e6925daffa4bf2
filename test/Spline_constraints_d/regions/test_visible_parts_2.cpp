// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is seen from a point: closed forms, CGAL's visibility in polygons, rays through random curves, and invariants.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/visibility/visible_parts_2.h>

#include <CGAL/Arr_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Simple_polygon_visibility_2.h>
#include <CGAL/random_polygon_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace visible_parts_2_test {

namespace SC = CGAL::Spline_constraints;
using K = Double_cartesian;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Kind = SC::Visible_edge_kind;

const double pi = std::acos(-1.0);

Curve circle(double x, double y, double radius) { return SC::circle_curve(Point(x, y), radius); }
Curve segment(const Point& p, const Point& q) { return SC::polyline_curve(std::vector<Point>{p, q}); }
double turn(const Point& p, const Point& q, const Point& r)
{
  return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
}

// Edges follow each other; segments are on rays; parameters are narrow.
void expect_cycle(const SC::Visible_part_2<K>& visible, const Point& viewpoint)
{
  EXPECT_TRUE(visible.is_complete());
  EXPECT_EQ(count_edges(visible, Kind::UNDECIDED), 0u);
  for (std::size_t i = 0; i < visible.edges().size(); ++i) {
    const auto &edge = visible.edges()[i], &next = visible.edges()[(i + 1) % visible.edges().size()];
    EXPECT_LT(CGAL::squared_distance(visible.point(edge.target), visible.point(next.source)), 1e-18);
    EXPECT_TRUE(edge.kind != Kind::ARC || edge.source.curve == edge.target.curve);
    if (edge.kind == Kind::SEGMENT) {
      EXPECT_NEAR(turn(viewpoint, visible.point(edge.source), visible.point(edge.target)), 0, 1e-8);
    }
    for (const auto* vertex : {&edge.source, &edge.target})
      EXPECT_LE(SC::to_nearest_double(SC::Exact_rational(vertex->parameters.second - vertex->parameters.first)), 1e-9);
  }
}

void expect_area(const SC::Visible_part_2<K>& visible, double expected)
{
  const auto [lower, upper] = visible.area();
  EXPECT_LE(lower, upper);
  EXPECT_LE(SC::to_nearest_double(SC::Exact_rational(upper - lower)), 1e-8);
  EXPECT_NEAR(SC::to_nearest_double(lower), expected, 1e-8);
}

TEST(visible_parts_2, circles)
{
  for (const double r : {1.0, 2.0, 4.5}) {   // seen from outside: the nearer arc between the points of tangency
    const Point p(0, 0);
    const auto one = SC::visible_part(p, circle(3, 4, r));
    expect_cycle(one, p);
    ASSERT_EQ(count_edges(one, Kind::ARC), 1u);
    EXPECT_EQ(count_edges(one, Kind::OPEN), 1u);
    EXPECT_FALSE(one.is_bounded());
    const double tangent = std::sqrt(25 - r * r);
    for (const auto& edge : one.edges())
      EXPECT_NEAR(std::hypot(one.point(edge.source).x(), one.point(edge.source).y()), tangent, 1e-12);
    expect_area(one, r * tangent - r * r * std::acos(r / 5));
  }
  const auto inside = SC::visible_part(Point(0.25, 0.5), circle(0, 0, 2));
  expect_cycle(inside, Point(0.25, 0.5));
  ASSERT_EQ(inside.edges().size(), 1u);
  EXPECT_TRUE(inside.is_bounded());
  expect_area(inside, 4 * pi);

  // the annulus between the circles behind is missing
  const auto shadow = SC::visible_part(Point(0, 0), Curves{circle(0, 0, 10), circle(5, 0, 3)});
  expect_cycle(shadow, Point(0, 0));
  EXPECT_EQ(count_edges(shadow, Kind::ARC), 2u);
  EXPECT_EQ(count_edges(shadow, Kind::SEGMENT), 2u);
  expect_area(shadow, 100 * (pi - std::asin(0.6)) + 3 * 4 - 9 * std::acos(0.6));

  const auto on_circle = SC::visible_part(Point(2, 0), circle(0, 0, 2));
  expect_area(on_circle, 4 * pi);
  expect_invalid([] { SC::visible_part(Point(2, 0), Curves{}); }, "no curves");
}

// Directions that are the same exactly, and curves that meet.
TEST(visible_parts_2, ties)
{
  const Point p(0, 0);
  // the x-axis touches three circles, and a segment is on it
  const auto aligned = SC::visible_part(
      p,
      Curves{circle(3, 1, 1), circle(6, 1, 1), circle(6, -1, 1), segment({1, 0}, {2, 0}), segment({20, -9}, {20, 9})});
  expect_cycle(aligned, p);
  EXPECT_EQ(count_edges(aligned, Kind::OPEN), 1u);

  // ends in the same direction
  const auto corners = SC::visible_part(
      p,
      Curves{segment({1, 1}, {2, 1}), segment({2, 2}, {2, 6}), segment({4, 2}, {4, -6}), segment({4, -6}, {-9, -6})});
  expect_cycle(corners, p);
  EXPECT_EQ(count_edges(corners, Kind::ARC), 4u);
  EXPECT_EQ(count_edges(corners, Kind::SEGMENT), 2u);

  // a curve twice, and the viewpoint on one
  const auto doubled = SC::visible_part(p, Curves{circle(0, 0, 2), circle(0, 0, 2), circle(1, 0, 1)});
  EXPECT_TRUE(doubled.is_complete());
  EXPECT_TRUE(doubled.is_bounded());
  expect_area(doubled, 4 * pi / 2 + pi);

  // the nearer parts of two segments
  const auto crossing = SC::visible_part(p, Curves{segment({-1, 2}, {4, 1}), segment({-1, 1}, {4, 3})});
  expect_cycle(crossing, p);
  EXPECT_EQ(count_edges(crossing, Kind::ARC), 2u);
  EXPECT_EQ(count_edges(crossing, Kind::SEGMENT), 0u);
  EXPECT_EQ(count_edges(crossing, Kind::OPEN), 1u);
}

// What is there twice, or is a part of what is there, changes nothing, wherever rays touch it.
TEST(visible_parts_2, copies)
{
  const Point p(1.3, 1.05);
  const auto wave = SC::bezier_curve(std::vector<Point>{{0, 0}, {1, 2}, {2, -2}, {3, 0}});
  const auto behind = segment({-1, -2}, {4, -2}), beside = circle(3, 2, 0.5);
  const auto one = SC::visible_part(p, Curves{wave, behind, beside});
  expect_cycle(one, p);
  EXPECT_GE(count_edges(one, Kind::ARC), 2u);
  for (const Curves& curves :
       {Curves{wave, wave, behind, beside}, Curves{wave.reversed(), beside, wave, behind, beside.reversed()},
        Curves{wave.restricted(0.25, 0.75), wave, behind, beside}}) {
    const auto same = SC::visible_part(p, curves);
    expect_cycle(same, p);
    EXPECT_EQ(same.edges().size(), one.edges().size());
  }
}

// The same polygon as CGAL finds, exactly.
TEST(visible_parts_2, polygons)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  using E = Exact_cartesian;
  using Arrangement = CGAL::Arrangement_2<CGAL::Arr_segment_traits_2<Exact>>;
  using Visibility = CGAL::Simple_polygon_visibility_2<Arrangement, CGAL::Tag_true>;
  std::mt19937 random(5);
  const auto without_flat_corners = [](const std::vector<E::Point_2>& points) {
    std::vector<E::Point_2> result;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!CGAL::collinear(points[(i + points.size() - 1) % points.size()], points[i], points[(i + 1) % points.size()]))
        result.push_back(points[i]);
    std::rotate(result.begin(), std::min_element(result.begin(), result.end()), result.end());
    return result;
  };
  int compared = 0;
  for (int n = 0; n < 24; ++n) {
    CGAL::Random seed(n);
    std::set<std::pair<int, int>> corners;   // of a coarse grid: many directions are the same
    for (int size = 6 + n; static_cast<int>(corners.size()) < size;)
      corners.emplace(seed.get_int(-n - 4, n + 5), seed.get_int(-n - 4, n + 5));
    CGAL::Polygon_2<Exact> polygon;
    std::vector<Exact::Point_2> points;
    for (const auto& [x, y] : corners)
      points.emplace_back(x, y);
    std::shuffle(points.begin(), points.end(), random);
    CGAL::random_polygon_2(points.size(), std::back_inserter(polygon), points.begin());
    if (!polygon.is_simple())
      continue;
    Arrangement arrangement;
    std::vector<Arrangement::X_monotone_curve_2> edges;
    for (auto edge = polygon.edges_begin(); edge != polygon.edges_end(); ++edge)
      edges.emplace_back(*edge);
    CGAL::insert_non_intersecting_curves(arrangement, edges.begin(), edges.end());
    auto face = arrangement.faces_begin();
    while (face->is_unbounded())
      ++face;
    for (int k = 0; k < 40; ++k) {
      const int x = seed.get_int(-n - 4, n + 5), y = seed.get_int(-n - 4, n + 5);
      if (polygon.bounded_side({x, y}) != CGAL::ON_BOUNDED_SIDE)
        continue;
      Visibility visibility(arrangement);
      Arrangement result;
      const auto seen = visibility.compute_visibility({x, y}, face, result);
      std::vector<E::Point_2> expected, found;
      const auto exact = [](const auto& p) { return E::Point_2(E::FT(p.x().exact()), E::FT(p.y().exact())); };
      auto edge = seen->outer_ccb();
      do
        expected.push_back(exact(edge->target()->point()));
      while (++edge != seen->outer_ccb());
      std::vector<E::Point_2> boundary;
      for (auto v = polygon.vertices_begin(); v != polygon.vertices_end(); ++v)
        boundary.push_back(exact(*v));
      boundary.push_back(boundary.front());
      const auto visible = SC::visible_part(E::Point_2(x, y), SC::polyline_curve(boundary));
      ASSERT_TRUE(visible.is_complete());
      ASSERT_TRUE(visible.is_bounded());
      const auto own = visible.polygon(0.1);
      EXPECT_EQ(without_flat_corners({own.vertices_begin(), own.vertices_end()}), without_flat_corners(expected))
          << n << ' ' << x << ' ' << y;
      EXPECT_EQ(visible.area().first, visible.area().second);
      EXPECT_EQ(visible.area().first, own.area());
      ++compared;
      break;
    }
  }
  EXPECT_GE(compared, 15);
}

// The distance at which a ray meets chords between samples.
double nearest(const Point& p, double angle, const std::vector<std::vector<Point>>& chains)
{
  double result = std::numeric_limits<double>::infinity();
  const double c = std::cos(angle), s = std::sin(angle);
  for (const auto& chain : chains)
    for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
      const double h0 = c * (chain[i].y() - p.y()) - s * (chain[i].x() - p.x()),
                   h1 = c * (chain[i + 1].y() - p.y()) - s * (chain[i + 1].x() - p.x());
      if ((h0 < 0) == (h1 < 0))
        continue;
      const double t = h0 / (h0 - h1), x = chain[i].x() + t * (chain[i + 1].x() - chain[i].x()) - p.x(),
                   y = chain[i].y() + t * (chain[i + 1].y() - chain[i].y()) - p.y(), distance = c * x + s * y;
      if (distance > 0)
        result = std::min(result, distance);
    }
  return result;
}

// Rays through random curves that cross each other and themselves, around and beside the viewpoint.
TEST(visible_parts_2, random_curves)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-5, 5), angles(0, 2 * pi);
  const auto point = [&] { return Point(coordinate(random), coordinate(random)); };
  for (int scene = 0; scene < 6; ++scene) {
    Curves curves;
    for (int k = 0; k < 2 + scene % 3; ++k)
      curves.push_back(k % 2 == 0 ? Curve(3, {0, 0, 0, 0, 1, 2, 2, 2, 2}, {point(), point(), point(), point(), point()})
                                  : circle(coordinate(random), coordinate(random), 0.8));
    if (scene % 2 == 0)
      curves.push_back(circle(0, 0, 9));
    const Point p = point();
    const auto visible = SC::visible_part(p, curves);
    expect_cycle(visible, p);
    EXPECT_EQ(visible.is_bounded(), scene % 2 == 0);
    std::vector<std::vector<Point>> chains, own;
    for (const Curve& curve : curves) {
      chains.emplace_back();
      const auto [begin, end] = curve.domain();
      for (int i = 0; i <= 300; ++i)
        chains.back().push_back(curve(begin + (end - begin) * i / 300));
    }
    for (std::size_t i = 0; i < visible.edges().size(); ++i)
      if (visible.edges()[i].kind == Kind::ARC)
        own.push_back(visible.polyline(i, 1e-3));
    int compared = 0;
    for (int k = 0; k < 100; ++k) {
      const double angle = angles(random), expected = nearest(p, angle, chains), found = nearest(p, angle, own);
      const bool is_near_vertex = std::any_of(visible.edges().begin(), visible.edges().end(), [&](const auto& edge) {
        const Point q = visible.point(edge.source);
        return std::abs(std::remainder(std::atan2(q.y() - p.y(), q.x() - p.x()) - angle, 2 * pi)) < 0.01;
      });
      if (is_near_vertex)
        continue;
      ++compared;
      if (std::isinf(expected) || std::isinf(found))
        EXPECT_EQ(expected, found);
      else
        EXPECT_NEAR(expected, found, 2e-2 * (1 + expected));
    }
    EXPECT_GE(compared, 40);
  }
}

} // namespace visible_parts_2_test
