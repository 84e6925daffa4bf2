// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Boundaries of what a tool can reach: the exact shadows of spheres, patches, walls and cylinders on a plane, spheres
// beside their surfaces along normals, hemispheres of directions.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/accessibility.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace accessibility_test {

using Curves = SC::Surface_curves_3<K>;

namespace {

constexpr double tiny = 1e-9;

const Surface plane = SC::bilinear_surface<K>(Point(-4, -4, 0), Point(-4, 4, 0), Point(4, -4, 0), Point(4, 4, 0));
const Vector up(0, 0, 1);

Surface dome()
{
  constexpr int height[] = {0, 1, 0};
  std::vector<Point> points;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      points.emplace_back(4 * i - 4, 4 * j - 4, height[i] + height[j] + height[i] * height[j]);
  return Surface({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, points);
}

Vector normal(const Surface& surface, const SC::Surface_curve_sample<K>& sample)
{
  const auto within = [&](int axis) {
    return (std::min)((std::max)(Rational(sample.parameters[axis]), surface.domain(axis).first),
                      surface.domain(axis).second);
  };
  return surface.normal(within(0), within(1));
}

template <class Check>
Curves expect_curves(const Surface& surface, const Check& check, const SC::Tool_axis<K>& axis, std::size_t closed,
                     std::size_t open, const std::string& what = "")
{
  Curves set = SC::accessibility_boundaries(surface, check, axis);
  EXPECT_TRUE(set.is_complete()) << what;
  EXPECT_EQ(set.number_of_closed_curves(), closed) << what;
  EXPECT_EQ(set.number_of_open_curves(), open) << what;
  EXPECT_TRUE(set.singular_points().empty()) << what;
  return set;
}

// The rays along the axis touch the ball.
void expect_touching(const Surface& surface, const SC::Tool_axis<K>& axis, const Point& center, double radius,
                     const Curves& set)
{
  for (const SC::Surface_curve& curve : set.curves())
    for (const auto& sample : set.polyline(curve, 1e-2)) {
      const Vector direction = axis.direction ? *axis.direction : normal(surface, sample),
                   to_center = center - sample.point;
      EXPECT_NEAR(length(CGAL::cross_product(to_center, direction)) / length(direction), radius, tiny);
      EXPECT_GT(to_center * direction, 0);
      EXPECT_GT(CGAL::to_double(direction * axis.hemisphere.value_or(direction)), -tiny);
    }
}

} // namespace

TEST(Accessibility, shadows_of_a_sphere)
{
  const Point center(1, 0, 3);
  const K::Sphere_3 ball(center, 1);
  const Surface surface = SC::sphere_surface<K>(center, 1);
  for (const Vector& direction : {up, Vector(0, 1, 2), Vector(Rational(1, 5), 0, 1), Vector(1, 2, 9)})
    for (const SC::Tool_axis<K> axis{direction, {}}; const bool is_surface : {false, true})
      expect_touching(plane, axis, center, 1,
                      is_surface ? expect_curves(plane, surface, axis, 1, 0) : expect_curves(plane, ball, axis, 1, 0));
  // Upright: a circle of the same radius.
  const Curves circle = expect_curves(plane, ball, {}, 1, 0);
  for (const auto& sample : circle.polyline(circle.curves()[0], 1e-3))
    EXPECT_NEAR(length(sample.point - Point(1, 0, 0)), 1, tiny);
  expect_curves(plane, ball, {-up, {}}, 0, 0);   // it is behind
  expect_curves(plane, surface, {-up, {}}, 0, 0);
  expect_curves(plane, K::Sphere_3(Point(4, 0, 3), 1), {}, 0, 1);   // half of it
}

TEST(Accessibility, shadows_of_edges)
{
  const Surface roof = SC::bilinear_surface<K>(Point(-1, -1, 1), Point(-1, 1, 2), Point(2, -1, 3), Point(2, 2, 1));
  const Curves outline = expect_curves(plane, roof, {up, {}}, 0, 4);
  for (const SC::Surface_curve& curve : outline.curves())
    for (const auto& sample : outline.polyline(curve, 1e-2)) {
      const Point& p = sample.point;
      const auto to_line = [&](const Vector& n, const Rational& c) {
        return std::abs(CGAL::to_double(n * (p - CGAL::ORIGIN) - c));
      };
      EXPECT_LT(
          (std::min)({to_line({1, 0, 0}, -1), to_line({1, 0, 0}, 2), to_line({0, 1, 0}, -1), to_line({-1, 3, 0}, 4)}),
          tiny);
    }
  expect_curves(plane, roof, {}, 0, 4);
  // Walls along the rays: only what is not along them counts.
  expect_curves(plane, SC::bilinear_surface<K>(Point(1, 0, 1), Point(2, 1, 1), Point(1, 0, 2), Point(2, 1, 2)),
                {up, {}}, 0, 2);
  expect_curves(plane, SC::cylinder_surface<K>(Point(0, 0, 1), 1, 1), {up, {}}, 2, 0);
  expect_curves(plane, SC::torus_surface<K>(Point(0, 0, 4), Rational(2), Rational(1)), {up, {}}, 2, 0);
  // A crease across a roof that is open below.
  const Surface gable({1, 1}, {0, 0, 1, 2, 2}, {0, 0, 1, 1},
                      {{-1, -1, 2}, {-1, 1, 2}, {0, -1, 3}, {0, 1, 3}, {1, -1, 2}, {1, 1, 2}});
  expect_curves(plane, gable, {up, {}}, 0, 7);
}

TEST(Accessibility, along_normals)
{
  const Surface surface = dome();
  const Point center(1, Rational(1, 3), 4);
  const SC::Tool_axis<K> half{{}, Vector(0, 0, 1)};
  const K::Sphere_3 ball(center, 1);
  expect_touching(surface, {}, center, 1, expect_curves(surface, ball, {}, 1, 0));
  expect_touching(surface, half, center, 1, expect_curves(surface, ball, half, 1, 0));
  const SC::Tool_axis<K> other{{}, Vector(1, -1, 0)};
  expect_touching(surface, other, center, 1, expect_curves(surface, ball, other, 0, 1));
  expect_curves(surface, ball, {{}, Vector(0, 0, -1)}, 0, 0);
  // The sphere as a surface: three equations in four unknowns.
  expect_touching(
      surface, {}, center, 1,
      expect_curves(surface,
                    SC::sphere_surface<K>(center, center + Vector(Rational(2, 7), Rational(3, 7), Rational(6, 7))), {},
                    1, 0));
}

TEST(Accessibility, fields_of_directions)
{
  // Rays from one point below the plane: the shadow of the unit ball above it is a circle of the radius 10 tan(a) with
  // sin(a) = 1/15.
  const SC::Tool_axis<K> rays{
      .field = SC::bilinear_surface<K>(Point(-4, -4, 10), Point(-4, 4, 10), Point(4, -4, 10), Point(4, 4, 10))};
  const Point center(0, 0, 5);
  const Curves circle = expect_curves(plane, K::Sphere_3(center, 1), rays, 1, 0);
  for (const auto& sample : circle.polyline(circle.curves()[0], 1e-2))
    EXPECT_NEAR(length(sample.point - Point(0, 0, 0)), 10 / std::sqrt(224.0), tiny);
  const Curves same = expect_curves(
      plane, SC::sphere_surface<K>(center, center + Vector(Rational(2, 7), Rational(3, 7), Rational(6, 7))), rays, 1,
      0);
  for (const auto& sample : same.polyline(same.curves()[0], 1e-2))
    EXPECT_NEAR(length(sample.point - Point(0, 0, 0)), 10 / std::sqrt(224.0), tiny);
  EXPECT_THROW(SC::accessibility_boundaries(dome(), K::Sphere_3(center, 1), {.direction = up, .field = rays.field}),
               SC::Invalid_input);
  EXPECT_THROW(
      SC::accessibility_boundaries(SC::cylinder_surface<K>(Point(0, 0, 1), 1, 1), K::Sphere_3(center, 1), rays),
      SC::Invalid_input);
}

TEST(Accessibility, random_balls)
{
  const Surface surface = dome();
  std::mt19937 generator(11);
  std::uniform_int_distribution<int> place(-20, 20);
  for (int round = 0; round < 10; ++round) {
    const Point center(Rational(place(generator), 10), Rational(place(generator), 10), 4);
    const Rational radius(Rational(place(generator) + 30, 30));
    const Curves set = expect_curves(surface, K::Sphere_3(center, radius * radius), {}, 1, 0, std::to_string(round));
    expect_touching(surface, {}, center, CGAL::to_double(radius), set);
  }
}

// Around the shadow, at the distance of the radius: circles around that of a sphere, also of a spline, which has
// another one inside, and around an irrational one; beside edges and around corners of a square that is at a height.
TEST(Accessibility, tools_with_a_radius)
{
  const SC::Tool_axis<K> thick{.direction = up, .radius = Rational(1) / 2};
  const auto expect_circle = [](const Curves& set, const SC::Surface_curve& curve, double x, double y, double radius) {
    for (const auto& sample : set.polyline(curve, 1e-2))
      EXPECT_NEAR(length(sample.point - Point(x, y, 0)), radius, tiny);
  };
  for (const int square : {1, 2}) {
    const Curves set = expect_curves(plane, K::Sphere_3(Point(0, 0, 3), Rational(square)), thick, 1, 0);
    expect_circle(set, set.curves()[0], 0, 0, std::sqrt(square) + 0.5);
  }
  const Surface ball = SC::sphere_surface<K>(Point(Rational(1) / 4, 0, 3), 1);
  const Curves around = expect_curves(plane, ball, thick, 2, 0);
  const auto width = [&](const SC::Surface_curve& curve) {
    return length(around.polyline(curve, 1e-2)[0].point - Point(Rational(1) / 4, 0, 0));
  };
  const std::size_t inner = width(around.curves()[0]) < 1 ? 0 : 1;
  expect_circle(around, around.curves()[inner], 0.25, 0, 0.5);
  expect_circle(around, around.curves()[1 - inner], 0.25, 0, 1.5);
  // the end of the tool: a ball of the radius 2 that touches the sphere
  const Curves ends =
      expect_curves(plane, K::Sphere_3(Point(0, 0, 2), Rational(1)), {.direction = up, .radius = Rational(2)}, 2, 0);
  const std::size_t end = length(ends.polyline(ends.curves()[0], 1e-2)[0].point - Point(0, 0, 0)) < 2.5 ? 0 : 1;
  expect_circle(ends, ends.curves()[end], 0, 0, std::sqrt(5.));
  expect_circle(ends, ends.curves()[1 - end], 0, 0, 3);
  const Surface roof = SC::bilinear_surface<K>(Point(-1, -1, 2), Point(-1, 1, 2), Point(1, -1, 2), Point(1, 1, 2));
  const Curves set = expect_curves(plane, roof, thick, 4, 8);
  for (const SC::Surface_curve& curve : set.curves())
    for (const auto& sample : set.polyline(curve, 1e-2)) {
      const double x = std::abs(CGAL::to_double(sample.point.x())), y = std::abs(CGAL::to_double(sample.point.y()));
      if (curve.is_closed)
        EXPECT_NEAR(std::hypot(x - 1, y - 1), 0.5, tiny);
      else
        EXPECT_LT((std::min)({std::abs(x - 0.5), std::abs(x - 1.5), std::abs(y - 0.5), std::abs(y - 1.5)}), tiny);
    }
}

TEST(Accessibility, bad_input)
{
  EXPECT_THROW(SC::accessibility_boundaries(plane, dome(), SC::Tool_axis<K>{.radius = Rational(-1)}),
               SC::Invalid_input);
  const K::Sphere_3 ball(Point(0, 0, 3), 1);
  EXPECT_THROW(SC::accessibility_boundaries(plane, ball, {.direction = Vector(0, 0, 0)}), SC::Invalid_input);
  EXPECT_THROW(SC::accessibility_boundaries(plane, ball, {.hemisphere = Vector(0, 0, 0)}), SC::Invalid_input);
  EXPECT_THROW(SC::accessibility_boundaries(plane, K::Sphere_3(Point(0, 0, 3), 0)), SC::Invalid_input);
  EXPECT_THROW(SC::accessibility_boundaries(plane, ball, {}, {.tolerance = -1}), SC::Invalid_input);
}

} // namespace accessibility_test
