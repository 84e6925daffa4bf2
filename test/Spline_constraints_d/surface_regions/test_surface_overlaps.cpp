// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Regions that two surfaces have in common: areas in closed form, equal on both, random points, and what is undecided.

#include "../surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/surface_overlaps.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/trimmed_surface_meshes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace surface_overlaps_test {

constexpr int own = static_cast<int>(SC::Overlap::OWN), common = static_cast<int>(SC::Overlap::COMMON);
const double pi = std::acos(-1.);

Surface parallelogram(const Point& p, const Vector& x, const Vector& y)
{
  return Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {p, p + y, p + x, p + x + y});
}

// On both surfaces.
void expect_common(const Surface& a, const Surface& b, std::size_t count, double area, double error)
{
  const auto overlap = SC::surface_overlap(a, b);
  EXPECT_TRUE(overlap.is_complete());
  for (const std::size_t i : {0, 1}) {
    EXPECT_EQ(overlap.number_of_common_regions(i), count);
    EXPECT_NEAR(SC::to_surface_mesh(overlap.surface(i), common, 1e-2).area(), area, error);
  }
}

TEST(SurfaceOverlaps, PlanarFaces)
{
  const Surface rectangle = parallelogram(Point(0, 0, 0), Vector(3, 0, 0), Vector(0, 2, 0));
  expect_common(rectangle, parallelogram(Point(1, 1, 0), Vector(2, 0, 0), Vector(0, 3, 0)), 1, 2, 1e-9);
  expect_common(rectangle, parallelogram(Point(1, 1, 0), Vector(2, 1, 0), Vector(-1, 3, 0)), 1, 7. / 6, 1e-9);
  expect_common(rectangle, rectangle.transposed(), 1, 6, 1e-9);
  // a bar across: two own regions are left of the rectangle
  const Surface bar = parallelogram(Point(1, -1, 0), Vector(1, 0, 0), Vector(0, 4, 0));
  expect_common(rectangle, bar, 1, 2, 1e-9);
  EXPECT_EQ(SC::surface_overlap(rectangle, bar).surface(0).number_of_regions(own), 2u);
  // between two parabolas, x^2 - 2 x + 2 < y: the integral of 2 - y over [1 - 1, 1 + 1] is 4/3
  const Surface below({2, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1},
                      {{0, 2, 0}, {0, 3, 0}, {1, 0, 0}, {1, 3, 0}, {2, 2, 0}, {2, 3, 0}});
  expect_common(rectangle, below, 1, 4. / 3, 2e-2);
  // in one plane, but apart; with a common edge; in other planes
  for (const Surface& other : {parallelogram(Point(4, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)),
                               parallelogram(Point(3, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0)),
                               parallelogram(Point(1, 1, -1), Vector(1, 0, 0), Vector(0, 0, 2))})
    expect_common(rectangle, other, 0, 0, 1e-9);
}

// A strip that turns back on itself ends in a fold, which is no edge: undecided in one piece, decided at a break.
TEST(SurfaceOverlaps, FoldedStrips)
{
  const Surface rectangle = parallelogram(Point(0, 0, 0), Vector(3, 0, 0), Vector(0, 1, 0));
  const auto strip = [](const std::vector<Rational>& knots, const std::vector<Rational>& xs) {
    std::vector<Point> points;
    for (const Rational& x : xs)
      for (const int y : {0, 1})
        points.emplace_back(x, y, 0);
    return Surface({static_cast<int>(knots.size() - xs.size()) - 1, 1}, knots, {0, 0, 1, 1}, points);
  };
  EXPECT_FALSE(SC::surface_overlap(rectangle, strip({0, 0, 0, 1, 1, 1}, {1, 3, 1})).surface(0).is_complete());
  const auto creased = SC::surface_overlap(rectangle, strip({0, 0, 1, 2, 2}, {1, 2, Rational(3) / 2}));
  EXPECT_TRUE(creased.is_complete());
  EXPECT_NEAR(SC::to_surface_mesh(creased.surface(0), common, 1e-2).area(), 1, 1e-9);
  EXPECT_NEAR(SC::to_surface_mesh(creased.surface(1), common, 1e-2).area(), 1.5, 1e-9);
}

TEST(SurfaceOverlaps, QuadricsAndTori)
{
  const auto tube = [](const Rational& z) { return SC::cylinder_surface<K>(Point(0, 0, z), 2, 3); };
  expect_common(tube(0), tube(1), 1, 2 * pi * 2 * 2, 0.1);
  expect_common(tube(0), tube(3), 0, 0, 1e-9);
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), 1),
                turned = SC::sphere_surface<K>(Point(0, 0, 0), Point(Rational(3) / 5, 0, Rational(4) / 5));
  expect_common(ball, turned, 1, 4 * pi, 0.1);
  // two halves whose planes are at an angle: lunes
  const Surface half = ball.restricted(0, 0, 2), quarter = ball.restricted(0, 1, 3);
  expect_common(half, quarter, 1, pi, 0.05);
  const Surface ring = SC::torus_surface<K>(Point(0, 0, 0), 3, 1);
  const auto rings =
      SC::surface_overlap(ring, SC::torus_surface<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(0, 3, 0), Rational(1) / 3));
  EXPECT_TRUE(rings.is_complete());
  for (const std::size_t i : {0, 1}) {
    EXPECT_EQ(rings.number_of_common_regions(i), 1u);
    EXPECT_EQ(rings.surface(i).number_of_regions(own), 0u);
  }
}

// With oblique edges: the same area on both.
TEST(SurfaceOverlaps, TurnedPatches)
{
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), 1),
                turned = SC::sphere_surface<K>(Point(0, 0, 0), Point(Rational(3) / 5, 0, Rational(4) / 5));
  const auto overlap = SC::surface_overlap(ball.restricted(0, 2, 4),
                                           turned.restricted(0, Rational(3) / 2, 4).restricted(1, Rational(1) / 2, 2));
  ASSERT_TRUE(overlap.is_complete());
  const double first = SC::to_surface_mesh(overlap.surface(0), common, 1e-2).area(),
               second = SC::to_surface_mesh(overlap.surface(1), common, 1e-2).area();
  EXPECT_NEAR(first, second, 5e-2);
  EXPECT_GT(first, 0.5);
}

// The pieces of cubics have no equation of degree four: they are compared as maps, also with other parameters.
TEST(SurfaceOverlaps, PartsOfOneSpline)
{
  std::mt19937 generator(1);
  std::uniform_int_distribution<int> offset(-3, 3);
  std::vector<Point> points;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      points.emplace_back(i + Rational(offset(generator)) / 10, j + Rational(offset(generator)) / 10,
                          Rational(offset(generator)) / 4);
  const std::vector<Rational> knots{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
  const Surface surface({3, 3}, knots, knots, points);
  expect_common(surface, surface, 1,
                SC::to_surface_mesh(SC::surface_overlap(surface, surface).surface(0), common, 1e-2).area(), 1e-6);
  const Surface left = surface.restricted(0, 0, 2),
                part = surface.restricted(0, Rational(1) / 2, 3).restricted(1, 1, 2).transposed().reversed(0);
  const auto overlap = SC::surface_overlap(left, part.with_domain(0, 0, 1).elevated({4, 3}));
  EXPECT_FALSE(overlap.is_complete()); // beside the common rectangle
  EXPECT_EQ(overlap.number_of_common_regions(0), 1u);
  const auto rectangle = SC::surface_overlap(left, surface.restricted(0, Rational(1) / 2, 2).restricted(1, 1, 2));
  const double area = SC::to_surface_mesh(rectangle.surface(1), common, 1e-2).area();
  EXPECT_GT(area, 1);
  for (const std::size_t i : {0, 1})
    EXPECT_NEAR(SC::to_surface_mesh(overlap.surface(i), common, 1e-2).area(), area, 1e-2);
  // z = x^2 + y^2 on two rectangles, with exchanged parameters: no product of highest powers
  const auto bowl = [](int begin, int end) {
    const Rational a = begin, b = end;
    std::vector<Point> net;
    for (const auto& [x, square_x] : {std::pair<Rational, Rational>(a, a * a), {(a + b) / 2, a * b}, {b, b * b}})
      for (const auto& [y, square_y] : {std::pair<Rational, Rational>(0, 0), {1, 0}, {2, 4}})
        net.emplace_back(x, y, square_x + square_y);
    return Surface({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, net);
  };
  const auto bowls = SC::surface_overlap(bowl(0, 3), bowl(1, 5).transposed());
  EXPECT_TRUE(bowls.is_complete()); // a quadric
  EXPECT_EQ(bowls.number_of_common_regions(0), 1u);
}

TEST(SurfaceOverlaps, LimitsAndBadInput)
{
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), 1);
  const auto ended = SC::surface_overlap(ball, ball, {.tolerance = 1e-8, .time_limit = 1e-9});
  EXPECT_FALSE(ended.is_complete());
  EXPECT_FALSE(ended.surface(1).undecided().empty());
  EXPECT_THROW(SC::surface_overlap(ball, ball, {.time_limit = -1}), SC::Invalid_input);
}

} // namespace surface_overlaps_test
