// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Swept volumes against closed forms, as the mesh gets finer, and against exact membership; exact arrangements of
// triangles.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/swept_volumes/swept_volumes.h>

#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace swept_volume_test {

using Curve = SC::Bspline_curve_3<K>;
using Motion = SC::Rational_motion_3;
using Function = Motion::Function;

namespace {

constexpr double pi = std::numbers::pi;

Surface ball(const Rational& radius) { return SC::sphere_surface<K>(Point(0, 0, 0), radius); }

Surface ellipsoid(const Rational& a, const Rational& b, const Rational& c)
{
  return ball(1).transformed(K::Aff_transformation_3(a, 0, 0, 0, b, 0, 0, 0, c));
}

Motion along(const Point& p, const Point& q) { return Motion::along(Curve(1, {0, 0, 1, 1}, {p, q})); }

// Closed, with the right topology, and the volume and area of inscribed triangles: the errors are of second order.
void check(const Surface& surface, const Motion& motion, int euler_characteristic, double volume, double area)
{
  std::vector<double> error_of_volume, error_of_area;
  for (const double chord_error : {0.04, 0.01}) {
    const SC::Swept_volume_3 swept = SC::swept_volume(surface, motion, {.chord_error = chord_error});
    EXPECT_TRUE(swept.is_complete()) << swept;
    EXPECT_TRUE(CGAL::is_closed(swept.mesh()));
    EXPECT_TRUE(swept.mesh().is_valid());
    EXPECT_EQ(swept.number_of_components(), 1u);
    EXPECT_EQ(swept.euler_characteristic(), euler_characteristic);
    error_of_volume.push_back(volume - swept.volume());
    error_of_area.push_back(area - swept.area());
    EXPECT_LT(std::abs(volume - swept.volume()), chord_error * area);
    EXPECT_LT(std::abs(area - swept.area()), 4 * chord_error * area);
  }
  EXPECT_LT(std::abs(error_of_volume[1]), std::abs(error_of_volume[0]) / 2);
  EXPECT_LT(std::abs(error_of_area[1]), std::abs(error_of_area[0]) / 2);
}

} // namespace

TEST(Swept_volume, capsule)
{
  const double r = 0.5, length = std::sqrt(5.0);
  check(ball(Rational(1) / 2), along(Point(0, 0, 0), Point(2, 1, 0)), 2, pi * r * r * length + 4 * pi * r * r * r / 3,
        2 * pi * r * length + 4 * pi * r * r);
}

// A cone frustum between two spherical caps, which it touches at the height -r sin(beta).
TEST(Swept_volume, growing_ball)
{
  const Motion growth = Motion::scaling(Point(0, 0, 0), Function({1}, {{0, 0, 1, 1}}, {1, 2}));
  const double length = 3, first = 0.5, last = 1, sine = (last - first) / length, cosine = std::sqrt(1 - sine * sine);
  const auto cap_volume = [](double r, double height) { return pi * height * height * (3 * r - height) / 3; };
  const double height = length - (last - first) * sine, a = first * cosine, b = last * cosine;
  const double volume = pi * height * (a * a + a * b + b * b) / 3 + cap_volume(first, first - first * sine) +
      cap_volume(last, last + last * sine);
  const double area = pi * (a + b) * std::hypot(height, b - a) + 2 * pi * first * (first - first * sine) +
      2 * pi * last * (last + last * sine);
  check(ball(Rational(1) / 2), along(Point(0, 0, 0), Point(3, 0, 0)) * growth, 2, volume, area);
}

TEST(Swept_volume, turns_about_an_axis)
{
  const Motion turn = Motion::full_turn(Point(0, 0, 0), Vector(0, 0, 1));
  const double r = 0.5;
  check(ball(Rational(1) / 2).transformed(K::Aff_transformation_3(CGAL::TRANSLATION, Vector(1, 0, 0))), turn, 0,
        2 * pi * pi * r * r, 4 * pi * pi * r);
  // about its own axis a ball stays where it is
  check(ball(Rational(1) / 2), turn, 2, 4 * pi * r * r * r / 3, 4 * pi * r * r);
}

// A ball that is larger than the circle on which it runs: the envelope crosses itself in two points of the axis.
TEST(Swept_volume, apple)
{
  const SC::Swept_volume_3 swept =
      SC::swept_volume(ball(Rational(3) / 2).transformed(K::Aff_transformation_3(CGAL::TRANSLATION, Vector(1, 0, 0))),
                       Motion::full_turn(Point(0, 0, 0), Vector(0, 0, 1)), {.chord_error = 0.1});
  EXPECT_TRUE(swept.is_complete()) << swept;
  EXPECT_TRUE(CGAL::is_closed(swept.mesh()));
  EXPECT_EQ(swept.number_of_components(), 1u);
  EXPECT_EQ(swept.euler_characteristic(), 2);
  const double volume = 45.4017186, area = 64.4382997;
  EXPECT_NEAR(swept.volume(), volume, 0.1 * area);
  EXPECT_NEAR(swept.area(), area, 0.1 * area);
}

// An ellipsoid on a circle, with the least half axis along it: a ring whose section is an ellipse.
TEST(Swept_volume, ring_of_elliptic_section)
{
  const Motion turn = Motion::full_turn(Point(0, 0, 0), Vector(0, 0, 1));
  const Surface solid = ellipsoid(Rational(1) / 2, Rational(1) / 4, Rational(3) / 4)
                            .transformed(K::Aff_transformation_3(CGAL::TRANSLATION, Vector(2, 0, 0)));
  const double volume = 2 * pi * pi * 2 * 0.5 * 0.75;
  std::vector<double> errors;
  for (const double chord_error : {0.04, 0.01}) {
    const SC::Swept_volume_3 swept = SC::swept_volume(solid, turn, {.chord_error = chord_error});
    EXPECT_TRUE(swept.is_complete()) << swept;
    EXPECT_EQ(swept.number_of_components(), 1u);
    EXPECT_EQ(swept.euler_characteristic(), 0);
    errors.push_back(std::abs(volume - swept.volume()));
    EXPECT_LT(errors.back(), 25 * chord_error);
  }
  EXPECT_LT(errors[1], errors[0] / 2);
}

// A ball along a figure eight of four lines: two holes.
TEST(Swept_volume, figure_eight)
{
  const Curve path(1, {0, 0, 1, 2, 3, 4, 4},
                   {Point(-3, -2, 0), Point(3, 2, Rational(1) / 4), Point(Rational(11) / 4, -2, 0),
                    Point(-Rational(11) / 4, 2, Rational(1) / 4), Point(-3, -2, 0)});
  const SC::Swept_volume_3 swept = SC::swept_volume(ball(Rational(1) / 4), Motion::along(path), {.chord_error = 0.02});
  EXPECT_TRUE(swept.is_complete()) << swept;
  EXPECT_TRUE(CGAL::is_closed(swept.mesh()));
  EXPECT_EQ(swept.number_of_components(), 1u);
  EXPECT_EQ(swept.euler_characteristic(), -2);
}

// An ellipsoid along a line: a cylinder over its shadow, with two halves of it.
TEST(Swept_volume, ellipsoid_along_line)
{
  const double a = 1, b = 0.5, c = 0.75, length = 3, x = 1. / 3, y = 2. / 3, z = 2. / 3;
  const SC::Swept_volume_3 swept = SC::swept_volume(ellipsoid(1, Rational(1) / 2, Rational(3) / 4),
                                                    along(Point(0, 0, 0), Point(1, 2, 2)), {.chord_error = 0.002});
  EXPECT_TRUE(swept.is_complete()) << swept;
  EXPECT_NEAR(swept.volume(),
              4 * pi * a * b * c / 3 +
                  length * pi * std::sqrt(b * b * c * c * x * x + a * a * c * c * y * y + a * a * b * b * z * z),
              0.03);
}

// A ball that runs along a star, whose lines cross: five corners and a middle are holes.
TEST(Swept_volume, path_that_crosses_itself)
{
  const std::vector<Point> corners{Point(0, 3, 0),
                                   Point(-Rational(7) / 4, -Rational(5) / 2, Rational(1) / 4),
                                   Point(Rational(11) / 4, Rational(5) / 4, 0),
                                   Point(-Rational(11) / 4, 1, Rational(1) / 4),
                                   Point(Rational(7) / 4, -Rational(5) / 2, 0),
                                   Point(0, 3, 0)};
  const Motion motion = Motion::along(Curve(1, {0, 0, 1, 2, 3, 4, 5, 5}, corners));
  const Rational radius = Rational(1) / 4;
  const SC::Swept_volume_3 swept = SC::swept_volume(ball(radius), motion, {.chord_error = 0.02});
  EXPECT_TRUE(swept.is_complete()) << swept;
  EXPECT_TRUE(CGAL::is_closed(swept.mesh()));
  EXPECT_EQ(swept.number_of_components(), 1u);
  EXPECT_EQ(swept.euler_characteristic(), -10);

  // random points against their exact distances from the lines
  std::mt19937 random(1);
  std::uniform_int_distribution<int> x(-180, 180), y(-170, 200), z(-20, 32);
  int inside = 0, twice = 0;
  constexpr int count = 200;
  for (int i = 0; i < count; ++i) {
    const Point point(Rational(x(random)) / 64, Rational(y(random)) / 64, Rational(z(random)) / 64);
    const auto intervals = SC::sweep_intervals(ball(radius), motion, point);
    ASSERT_TRUE(intervals);
    bool is_near = false;
    for (std::size_t k = 1; k < corners.size(); ++k)
      is_near = is_near || CGAL::squared_distance(K::Segment_3(corners[k - 1], corners[k]), point) < radius * radius;
    EXPECT_EQ(is_near, !intervals->empty());
    for (const auto& [begin, end] : *intervals)
      EXPECT_LT(begin, end);
    inside += is_near;
    twice += intervals->size() > 1;
  }
  EXPECT_GT(inside, count / 20);
  EXPECT_GT(twice, 0);
}

// Normals of the surface may point inwards, and maps may reflect.
TEST(Swept_volume, orientations)
{
  const Motion line = along(Point(0, 0, 0), Point(2, 1, 0));
  const Function one({0}, {{0, 1}}, {1}), zero = one * Rational(0);
  const Motion mirror({{{-one, zero, zero}, {zero, one, zero}, {zero, zero, one}}}, {zero, zero, zero}, one);
  const Surface solid = ellipsoid(Rational(1) / 2, Rational(1) / 4, Rational(1) / 3);
  std::vector<double> volumes;
  for (const Surface& surface : {solid, solid.transposed()})
    for (const Motion& motion : {line, line * mirror}) {
      const SC::Swept_volume_3 swept = SC::swept_volume(surface, motion, {.chord_error = 0.01});
      EXPECT_TRUE(swept.is_complete()) << swept;
      EXPECT_EQ(swept.euler_characteristic(), 2);
      volumes.push_back(swept.volume());
    }
  for (const double volume : volumes)
    EXPECT_NEAR(volume, volumes.front(), 0.02);
  EXPECT_GT(volumes.front(), 0.5);
}

TEST(Swept_volume, bad_input)
{
  const Function zero = Function({0}, {{0, 1}}, {1}) * Rational(0), one = zero + Rational(1);
  const Motion flat({{{one, zero, zero}, {zero, one, zero}, {zero, zero, zero}}}, {zero, zero, zero}, one);
  EXPECT_THROW(SC::swept_volume(ball(1), flat), SC::Invalid_input);
  EXPECT_THROW(SC::sweep_intervals(ball(1), flat, Point(0, 0, 0)), SC::Invalid_input);
  const Surface open({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1},
                     {Point(0, 0, 0), Point(0, 1, 0), Point(1, 0, 0), Point(1, 1, 1)});
  try {
    SC::swept_volume(open, along(Point(0, 0, 0), Point(1, 0, 0)));
    FAIL() << "an open surface was taken";
  } catch (const SC::Invalid_input& error) {
    EXPECT_NE(std::string(error.what()).find("u = 0 is neither a seam nor a pole"), std::string::npos) << error.what();
  }
  EXPECT_THROW(SC::swept_volume(ball(1), along(Point(0, 0, 0), Point(1, 0, 0)), {.chord_error = -1}),
               SC::Invalid_input);
}

TEST(Swept_volume, stops)
{
  const SC::Swept_volume_3 swept =
      SC::swept_volume(ball(1), along(Point(0, 0, 0), Point(1, 2, 3)), {}, {.tolerance = 1e-8, .time_limit = 1e-3});
  EXPECT_FALSE(swept.is_complete());
  EXPECT_FALSE(swept.undecided().empty());
}

} // namespace swept_volume_test
