// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Convex hulls of curves: exact answers, support functions, containment of samples, and invariants.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/convex_hulls_2.h>

#include <CGAL/convex_hull_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <set>
#include <vector>

namespace convex_hulls_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = Double_cartesian;
using Point = K::Point_2;
using Vector = K::Vector_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Hull = SC::Convex_hull_2<K>;
using Kind = SC::Hull_edge_kind;

const double pi = std::acos(-1.0);

Curve circle(double x, double y, double radius) { return SC::circle_curve(Point(x, y), radius); }
Curve moved(const Curve& curve, double x, double y)
{
  return curve.transformed(K::Aff_transformation_2(CGAL::TRANSLATION, Vector(x, y)));
}
Curve kidney()
{
  return Curve::from_periodic(3, {0, 1, 2, 3, 4, 5, 6, 7}, {{0, 0}, {4, 0}, {4, 3}, {2, 1}, {2, 4}, {0, 5}, {-1, 2}});
}

// Edges follow each other, and turn left all along.
void expect_convex_cycle(const Hull& hull)
{
  for (std::size_t i = 0; i < hull.edges().size(); ++i) {
    const auto &edge = hull.edges()[i], &next = hull.edges()[(i + 1) % hull.edges().size()];
    EXPECT_LT(CGAL::squared_distance(hull.point(edge.target), hull.point(next.source)), 1e-24);
    EXPECT_TRUE(edge.kind == Kind::SEGMENT || edge.source.curve == edge.target.curve);
    for (const auto* vertex : {&edge.source, &edge.target})
      EXPECT_LE(SC::to_nearest_double(SC::Exact_rational(vertex->parameters.second - vertex->parameters.first)), 1e-9);
  }
  const auto polygon = hull.polygon(1e-3);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()], &r = polygon[(i + 2) % polygon.size()];
    EXPECT_GT((q.x() - p.x()) * (r.y() - q.y()) - (q.y() - p.y()) * (r.x() - q.x()), -1e-12);
  }
}

void expect_complete(const Hull& hull, std::size_t arcs, std::size_t segments)
{
  EXPECT_TRUE(hull.is_complete());
  EXPECT_TRUE(hull.summary().is_complete);
  EXPECT_EQ(count_edges(hull, Kind::ARC), arcs);
  EXPECT_EQ(count_edges(hull, Kind::SEGMENT), segments);
  expect_convex_cycle(hull);
}

void expect_area(const Hull& hull, double expected)
{
  const auto [lower, upper] = hull.area();
  EXPECT_LE(lower, upper);
  EXPECT_LE(SC::to_nearest_double(SC::Exact_rational(upper - lower)), 2e-12);
  EXPECT_NEAR(SC::to_nearest_double(lower), expected, 1e-11 * std::max(1.0, expected));
}

double height(const std::vector<Point>& points, const Vector& direction)
{
  double result = -std::numeric_limits<double>::infinity();
  for (const Point& p : points)
    result = std::max(result, (p - CGAL::ORIGIN) * direction);
  return result;
}

std::vector<Point> samples(const Curves& curves, int number)
{
  std::vector<Point> result;
  for (const Curve& curve : curves)
    for (int i = 0; i <= number; ++i) {
      const auto [begin, end] = curve.domain();
      result.push_back(curve(begin + (end - begin) * i / number));
    }
  return result;
}

// The support functions of the hull and of samples of the curves are the same but for the distances of samples.
void expect_same_support(const Hull& hull, const std::vector<Point>& points, double error)
{
  const auto polygon = hull.polygon(1e-4);
  const std::vector<Point> vertices(polygon.begin(), polygon.end());
  for (int i = 0; i < 90; ++i) {
    const Vector direction(std::cos(i * pi / 45), std::sin(i * pi / 45));
    EXPECT_LE(height(points, direction), height(vertices, direction) + 1.001e-4);
    EXPECT_GE(height(points, direction), height(vertices, direction) - error);
  }
}

TEST(convex_hulls_2, points)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coordinate(0, 9);
  for (int n = 1; n < 60; ++n) {
    std::vector<Point> points, expected;
    for (int i = 0; i < n; ++i)
      points.emplace_back(coordinate(random), coordinate(random) % (n < 10 ? 1 : 10));
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(expected));
    const Hull hull(Curves{}, points);
    EXPECT_TRUE(hull.is_complete());
    ASSERT_EQ(hull.edges().size(), expected.size());
    std::set<Point> vertices;
    for (const auto& edge : hull.edges()) {
      EXPECT_EQ(edge.kind, Kind::SEGMENT);
      EXPECT_EQ(hull.point(edge.source), points[edge.source.curve]);
      vertices.insert(hull.point(edge.source));
    }
    EXPECT_EQ(vertices, std::set<Point>(expected.begin(), expected.end()));
  }
}

TEST(convex_hulls_2, disks)
{
  const Hull one = SC::convex_hull(circle(1, 2, 3));
  expect_complete(one, 1, 0);
  EXPECT_EQ(one.edges()[0].source.parameters.first, 0);
  EXPECT_EQ(one.edges()[0].target.parameters.first, 4);
  expect_area(one, 9 * pi);

  const Hull stadium = SC::convex_hull(Curves{circle(0, 0, 1), circle(5, 0, 1)});
  expect_complete(stadium, 3, 2);   // one of the half circles has the seam
  expect_area(stadium, pi + 10);
  for (const auto& edge : stadium.edges())
    EXPECT_EQ(edge.source.parameters.first, edge.source.parameters.second);

  const double r = 1, R = 2, d = 6, angle = std::asin((R - r) / d);   // of the segments with the line of the centers
  const Hull belt = SC::convex_hull(Curves{circle(0, 0, r), circle(0, d, R)});
  EXPECT_TRUE(belt.is_complete());
  EXPECT_EQ(count_edges(belt, Kind::SEGMENT), 2u);
  expect_convex_cycle(belt);
  expect_area(belt, (pi / 2 + angle) * R * R + (pi / 2 - angle) * r * r + (R + r) * d * std::cos(angle));

  const Hull cap = SC::convex_hull(Curves{circle(0, 0, 3)}, {Point(5, 0), Point(1, 1), Point(3, 0)});
  EXPECT_TRUE(cap.is_complete());
  EXPECT_EQ(count_edges(cap, Kind::SEGMENT), 2u);
  expect_area(cap, 9 * (pi - std::acos(0.6)) + 12);
}

// Tangents of a cubic from its ends: at the parameters 1/4 and 3/4.
TEST(convex_hulls_2, ends_of_a_curve)
{
  const Hull hull = SC::convex_hull(SC::bezier_curve<K>({{0, 0}, {1, 2}, {2, -2}, {3, 0}}));
  expect_complete(hull, 2, 2);
  std::set<double> contacts;
  for (const auto& edge : hull.edges())
    contacts.insert({SC::to_nearest_double(edge.source.parameter()), SC::to_nearest_double(edge.target.parameter())});
  EXPECT_EQ(contacts, (std::set<double>{0, 0.25, 0.75, 1}));
  expect_area(hull, 1.8984375);   // 243/128

  const Hull cusp = SC::convex_hull(SC::bezier_curve<K>({{0, 0}, {1, 1}, {0, 1}, {1, 0}}));
  expect_complete(cusp, 0, 3);
  EXPECT_EQ(cusp.area().first, SC::Exact_rational(3) / 8);
  EXPECT_EQ(cusp.area().second, SC::Exact_rational(3) / 8);
}

// What touches the boundary from within, overlaps it, or lies on it, does not matter.
TEST(convex_hulls_2, drawings)
{
  const Curve square = SC::polyline_curve(std::vector<Point>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}),
              disk = circle(0, 0, 1);
  const Hull inscribed = SC::convex_hull(Curves{disk, square, disk, square.reversed()}, {Point(0, 1), Point(1, 1)});
  expect_complete(inscribed, 0, 4);
  EXPECT_EQ(inscribed.area().first, 4);
  EXPECT_EQ(inscribed.area().second, 4);

  for (const Curves& curves : {Curves{disk, circle(0.5, 0, 0.5)}, Curves{disk, disk.reversed(), circle(0, 0.25, 0.75)},
                               Curves{circle(0.5, 0, 0.5), disk, SC::segment_curve(Point(-1, 0), Point(0, 0))}}) {
    const Hull hull = SC::convex_hull(curves);
    EXPECT_TRUE(hull.is_complete());
    EXPECT_EQ(count_edges(hull, Kind::SEGMENT), 0u);
    expect_convex_cycle(hull);
    expect_area(hull, pi);
  }

  const Hull on_arc =
      SC::convex_hull(Curves{circle(0, 0, 5), SC::segment_curve(Point(0, 0), Point(3, 4))}, {Point(-4, 3)});
  EXPECT_TRUE(on_arc.is_complete());
  expect_convex_cycle(on_arc);
  expect_area(on_arc, 25 * pi);

  const Curve arch = SC::bezier_curve<K>({{0, 0}, {1, 2}, {2, 2}, {3, 0}});
  const Hull overlapping = SC::convex_hull(
      Curves{arch.restricted(0, 0.625), arch.restricted(0.3125, 1), arch.restricted(0.25, 0.75).reversed()});
  EXPECT_TRUE(overlapping.is_complete());
  EXPECT_EQ(count_edges(overlapping, Kind::SEGMENT), 1u);
  expect_convex_cycle(overlapping);
  EXPECT_EQ(overlapping.area().first, 3);
  EXPECT_EQ(overlapping.area().second, 3);

  const Hull wedge = SC::convex_hull(
      Curves{disk, SC::segment_curve(Point(1, -1), Point(1, 1)), SC::segment_curve(Point(3, 1), Point(-1, 1))});
  EXPECT_TRUE(wedge.is_complete());
  expect_convex_cycle(wedge);
  expect_area(wedge, 1 + pi / 4 + 1 + 2 + 1);   // three quarters around the center, and a triangle
}

// Copies of a curve in a row touch the same two lines, whose contacts are irrational.
TEST(convex_hulls_2, three_tangents_are_one)
{
  const auto [lower, upper] = SC::convex_hull(Curves{kidney(), moved(kidney(), 20, 8)}).area();
  const Hull row = SC::convex_hull(Curves{kidney(), moved(kidney(), 10, 4), moved(kidney(), 20, 8)});
  EXPECT_TRUE(row.is_complete());
  EXPECT_EQ(count_edges(row, Kind::SEGMENT), 3u);   // that of the bay, too
  expect_convex_cycle(row);
  expect_area(row, SC::to_nearest_double(SC::Exact_rational((lower + upper) / 2)));
}

// Curves that begin in a point of a circle, with the same tangent, at other speeds: inside, where they do not matter,
// and outside.
TEST(convex_hulls_2, forks)
{
  const Curve disk = circle(0, 0, 1);
  const auto fork = [](double speed, double depth, double height, int sign) {
    return SC::bezier_curve<K>({{-1, 0}, {-1, sign * speed}, {-1 + depth, sign * height}});
  };
  for (const int sign : {1, -1})
    for (const Curve& inside : {fork(0.125, 0.125, 0.25, sign), fork(0.25, 0.5, 0.25, sign),
                                fork(0.375, 0.5, 0.25, sign), fork(0.5, 1, 0.25, sign), fork(0.75, 1.5, 0, sign)}) {
      const Hull hull = SC::convex_hull(Curves{disk, inside});
      EXPECT_TRUE(hull.is_complete());
      EXPECT_EQ(count_edges(hull, Kind::SEGMENT), 0u);
      expect_convex_cycle(hull);
      expect_area(hull, pi);
    }
  // a quarter of twice the radius
  const Hull greater = SC::convex_hull(Curves{disk, SC::bezier_curve<K>({{-1, 0}, {-1, 2}, {1, 2}}, {1, 1, 2})});
  EXPECT_TRUE(greater.is_complete());
  EXPECT_EQ(count_edges(greater, Kind::SEGMENT), 1u);
  expect_convex_cycle(greater);
  expect_area(greater, 1.5 * pi);
  for (const double speed : {0.25, 1.0}) {   // the curvature is zero in the fork
    const Hull straight =
        SC::convex_hull(Curves{disk, SC::bezier_curve<K>({{-1, 0}, {-1, speed}, {-1, 2 * speed}, {0, 2 * speed}})});
    EXPECT_TRUE(straight.is_complete());
    expect_convex_cycle(straight);
    EXPECT_GT(straight.area().first, SC::Exact_rational(pi));
  }
}

TEST(convex_hulls_2, degenerate)
{
  const Hull segment = SC::convex_hull(SC::segment_curve(Point(0, 0), Point(2, 1)));
  expect_complete(segment, 0, 2);
  EXPECT_EQ(segment.area().second, 0);

  const Hull half_disk = SC::convex_hull(SC::bezier_curve<K>({{0, 0}, {1, 1}, {2, 0}}));
  expect_complete(half_disk, 1, 1);
  EXPECT_TRUE(half_disk.edges()[0].is_reversed() || half_disk.edges()[1].is_reversed());
  EXPECT_EQ(half_disk.area().first, SC::Exact_rational(2) / 3);

  const Hull point = SC::convex_hull(Curves{SC::bezier_curve<K>({{1, 1}, {1, 1}, {1, 1}})}, {Point(1, 1)});
  expect_complete(point, 0, 1);

  // It turns back at the parameter 3/5.
  const Hull back = SC::convex_hull(SC::bezier_curve<K>({{0, 0}, {3, 0}, {1, 0}}));
  expect_complete(back, 0, 2);
  EXPECT_DOUBLE_EQ(back.polygon(1).bbox().xmax(), 1.8);

  // Without time nothing is found.
  const Hull limited = SC::convex_hull(Curves{kidney()}, {Point(9, 9)}, {.time_limit = 1e-9});
  EXPECT_FALSE(limited.is_complete());
  EXPECT_FALSE(limited.summary().is_complete);
  EXPECT_FALSE(limited.undecided().empty());
  EXPECT_EQ(limited.edges().size(), count_edges(limited, Kind::UNDECIDED));

  EXPECT_THROW(SC::convex_hull(Curves{}), SC::Invalid_input);
  EXPECT_THROW(segment.polygon(0), SC::Invalid_input);
  EXPECT_THROW(segment.area(-1), SC::Invalid_input);
  EXPECT_THROW(SC::convex_hull(Curves{}, {Point(0, std::numeric_limits<double>::infinity())}), SC::Invalid_input);
}

TEST(convex_hulls_2, random_cubics)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0, 1);
  for (const int n : {1, 2, 3, 5, 8, 20, 50}) {
    Curves curves, turned;
    for (int i = 0; i < n; ++i) {
      const double x = 8 * coordinate(random), y = 8 * coordinate(random);
      std::vector<Point> points, turned_points;
      for (int k = 0; k < 4; ++k) {
        points.emplace_back(x + 4 * coordinate(random), y + 4 * coordinate(random));
        turned_points.emplace_back(-points.back().y(), points.back().x());
      }
      curves.push_back(SC::bezier_curve<K>(points));
      turned.push_back(SC::bezier_curve<K>(turned_points));
    }
    const Hull hull = SC::convex_hull(curves), turned_hull = SC::convex_hull(turned);
    EXPECT_TRUE(hull.is_complete());
    EXPECT_TRUE(turned_hull.is_complete());
    expect_convex_cycle(hull);
    expect_same_support(hull, samples(curves, 100), 1e-2);
    EXPECT_EQ(hull.edges().size(), turned_hull.edges().size());
    expect_area(hull, SC::to_nearest_double(turned_hull.area().first));
  }
}

TEST(convex_hulls_2, random_closed_curves)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(0, 1);
  for (int i = 0; i < 6; ++i) {
    Curves curves;
    for (int k = 0; k <= i; ++k) {
      const double x = 4 * coordinate(random), y = 4 * coordinate(random);
      std::vector<Point> points;
      for (int l = 0; l < 6; ++l)
        points.emplace_back(x + 3 * coordinate(random), y + 3 * coordinate(random));
      curves.push_back(Curve::from_periodic(2 + k % 2, {0, 1, 2, 3, 4, 5, 6}, points));
    }
    const Hull hull = SC::convex_hull(curves);
    EXPECT_TRUE(hull.is_complete());
    expect_convex_cycle(hull);
    expect_same_support(hull, samples(curves, 400), 1e-2);
  }
}

} // namespace

} // namespace convex_hulls_2_test
