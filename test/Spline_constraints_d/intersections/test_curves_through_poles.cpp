// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of two surfaces through poles, edges of a surface that are one point: closed curves through both poles of a
// sphere, singular points at poles and at the apex of a cone, rigid motions.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>

#include <gtest/gtest.h>

#include <CGAL/Aff_transformation_3.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace curves_through_poles {

using Motion = CGAL::Aff_transformation_3<K>;

struct Counts
{
  std::size_t closed, open, singular, points = 0, contacts = 0;
};

template <class A, class B>
SC::Surface_intersection<K> expect_counts(const A& a, const B& b, const Counts& counts)
{
  SC::Surface_intersection<K> set = SC::intersection_curves(a, b);
  EXPECT_TRUE(set.is_complete());
  EXPECT_EQ(set.number_of_closed_curves(), counts.closed);
  EXPECT_EQ(set.number_of_open_curves(), counts.open);
  EXPECT_EQ(set.singular_points().size(), counts.singular);
  EXPECT_EQ(set.points().size(), counts.points);
  EXPECT_EQ(set.number_of_contact_curves(), counts.contacts);
  return set;
}

// The length of a curve, as a polyline with an error of 0.001.
double length_of(const SC::Surface_intersection<K>& set, const SC::Intersection_curve& curve)
{
  double result = 0;
  const std::vector<Point> points = set.polyline(curve, 1e-3);
  for (std::size_t i = 1; i < points.size(); ++i)
    result += length(points[i] - points[i - 1]);
  return result;
}

const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), 5),
              cone = SC::cone_surface<K>(Point(0, 0, 3), Vector(0, 0, -1), Point(2, 0, 0));

} // namespace curves_through_poles

using namespace curves_through_poles;

// Great circles through both poles, along the seam or a break too; a circle through one pole.
TEST(Curves_through_poles, sphere_and_planes)
{
  for (const auto& plane : {K::Plane_3(3, 4, 0, 0), K::Plane_3(0, 1, 0, 0), K::Plane_3(1, 0, 0, 0)}) {
    const auto set = expect_counts(sphere, plane, {1, 0, 0});
    ASSERT_EQ(set.curves().size(), 1u);
    EXPECT_EQ(set.curves()[0].arcs.size(), 2u);
    EXPECT_NEAR(length_of(set, set.curves()[0]), 10 * M_PI, 1e-2);
  }
  const auto circle = expect_counts(sphere, K::Plane_3(1, 2, 2, -10), {1, 0, 0});
  ASSERT_EQ(circle.curves().size(), 1u);
  EXPECT_NEAR(length_of(circle, circle.curves()[0]), 2 * M_PI * std::sqrt(25 - 100.0 / 9), 1e-2);
  const auto touching = expect_counts(sphere, K::Plane_3(0, 0, 1, -5), {0, 0, 1});
  ASSERT_EQ(touching.singular_points().size(), 1u);
  EXPECT_EQ(touching.singular_points()[0].point(), Point(0, 0, 5));
  EXPECT_EQ(touching.singular_points()[0].kind(), SC::Intersection_kind::TANGENT);
}

TEST(Curves_through_poles, sphere_and_implicit_surfaces)
{
  auto [x, y, z] = SC::unknowns({-9, 9}, {-9, 9}, {-9, 9});
  expect_counts(sphere, K::Sphere_3(Point(3, 1, 0), 35), {1, 0, 0});
  expect_counts(sphere, K::Sphere_3(Point(3, 0, 4), 10), {1, 0, 0});
  expect_counts(sphere, K::Sphere_3(Point(0, 0, 3), 4), {0, 0, 1});
  expect_counts(sphere, SC::Implicit_surface_3(square(x - 1) + y * y == 1), {2, 0, 0});
  expect_counts(sphere, SC::Implicit_surface_3((x + y * 2) * (x * 3 - y) == 0), {0, 4, 2});
  // a cone, four branches at the apex
  expect_counts(sphere, SC::Implicit_surface_3(x * x + square(z - 5) * 3 == y * y), {0, 2, 1});
  expect_counts(sphere, SC::Implicit_surface_3(square(x * 3 - y * 4) + square(z * 5) == 625), {1, 0, 0, 0, 1});
}

TEST(Curves_through_poles, apex_of_a_cone)
{
  expect_counts(cone, K::Plane_3(1, 2, 0, 0), {0, 2, 1});
  expect_counts(cone, K::Plane_3(0, 0, 1, -3), {0, 0, 1});
  expect_counts(cone, K::Plane_3(3, 0, 2, -6), {0, 1, 1, 0, 1});   // touches it along a line
  expect_counts(cone, K::Sphere_3(Point(0, 1, 0), 10), {0, 0, 1});
}

// A piece that does not go around the pole, which is a corner of it.
TEST(Curves_through_poles, quarter_of_a_sphere)
{
  const Surface quarter = sphere.restricted(0, 0, 1);
  expect_counts(quarter, K::Plane_3(1, 1, 0, 0), {0, 1, 0});
  expect_counts(quarter, K::Plane_3(1, -1, 0, 0), {0, 0, 0, 2});
  expect_counts(quarter, K::Plane_3(0, 0, 1, -5), {0, 0, 0, 1});
}

// Two parametric surfaces: a board through both poles, along the seam, that touches at the pole, and that ends there.
TEST(Curves_through_poles, sphere_and_boards)
{
  const auto board = [](const Point& a, const Point& b, const Point& c, const Point& d) {
    return Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Point>{a, b, c, d});
  };
  const auto circle = expect_counts(
      sphere, board(Point(-28, 21, -7), Point(-28, 21, 7), Point(28, -21, -7), Point(28, -21, 7)), {1, 0, 0});
  ASSERT_EQ(circle.curves().size(), 1u);
  EXPECT_NEAR(length_of(circle, circle.curves()[0]), 10 * M_PI, 1e-2);
  expect_counts(sphere, board(Point(-8, 0, -8), Point(8, 0, -8), Point(-8, 0, 8), Point(8, 0, 8)), {1, 0, 0});
  expect_counts(sphere, board(Point(-8, -8, 5), Point(8, -8, 5), Point(-8, 8, 5), Point(8, 8, 5)), {0, 0, 1});
  expect_counts(sphere, board(Point(0, 0, -7), Point(0, 0, 7), Point(28, -21, -7), Point(28, -21, 7)), {0, 1, 0});
  expect_counts(cone, board(Point(-9, -4, -5), Point(9, 4, -5), Point(-9, -4, 5), Point(9, 4, 5)), {0, 2, 1});
}

// Spheres that touch in a pole of both; a sphere through the apex of a cone.
TEST(Curves_through_poles, contacts)
{
  expect_counts(sphere, SC::sphere_surface<K>(Point(0, 0, 2), Point(0, 0, 5)), {0, 0, 1});
  expect_counts(cone, SC::sphere_surface<K>(Point(0, 0, 0), 3), {0, 0, 1});
}

TEST(Curves_through_poles, spheres)
{
  const auto circle = expect_counts(sphere, SC::sphere_surface<K>(Point(3, 1, 5), Point(4, 1, 8)), {1, 0, 0});
  ASSERT_EQ(circle.curves().size(), 1u);
  // in the plane 3 x + y + 5 z = 25
  EXPECT_NEAR(length_of(circle, circle.curves()[0]), 2 * M_PI * std::sqrt(25 - 25.0 * 25 / 35), 1e-2);
}

TEST(Curves_through_poles, rigid_motions_change_nothing)
{
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> integer(-4, 4);
  for (int round = 0; round < 6; ++round) {
    const Rational a(5), b(integer(generator)), c(integer(generator)), d(integer(generator)),
        n(a * a + b * b + c * c + d * d);
    const Motion turn(a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c), 2 * (b * c + a * d),
                      a * a - b * b + c * c - d * d, 2 * (c * d - a * b), 2 * (b * d - a * c), 2 * (c * d + a * b),
                      a * a - b * b - c * c + d * d, n);
    const auto moved = [&](const Surface& surface) { return surface.transformed(turn); };
    for (const auto& plane : {K::Plane_3(3, 4, 0, 0), K::Plane_3(1, 2, 2, -10)})
      expect_counts(moved(sphere), plane.transform(turn), {1, 0, 0});
    expect_counts(moved(sphere), K::Plane_3(0, 0, 1, -5).transform(turn), {0, 0, 1});
    expect_counts(moved(cone), K::Plane_3(1, 2, 0, 0).transform(turn), {0, 2, 1});
  }
}
