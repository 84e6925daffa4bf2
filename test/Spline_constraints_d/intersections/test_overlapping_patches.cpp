// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that have a part in common are told before any subdivision.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace test_overlapping_patches {

Surface landscape()
{
  std::mt19937 generator(1);
  std::uniform_int_distribution<int> offset(-3, 3);
  std::vector<Point> points;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      points.emplace_back(i + Rational(offset(generator)) / 10, j + Rational(offset(generator)) / 10,
                          Rational(offset(generator)) / 4);
  const std::vector<Rational> knots{0, 0, 0, 0, 1, 2, 3, 3, 3, 3};
  return Surface({3, 3}, knots, knots, points);
}

void expect_overlap(const Surface& a, const Surface& b, const std::string& what)
{
  const auto set = SC::intersection_curves(a, b, {.tolerance = 1e-8, .time_limit = 10});
  EXPECT_FALSE(set.is_complete()) << what;
  EXPECT_EQ(set.summary().nodes, 0) << what;
  ASSERT_EQ(set.undecided().size(), 1) << what;
  const SC::Undecided_part part = set.undecided().front();
  EXPECT_EQ(part.reason, "the surfaces overlap") << what;
  EXPECT_EQ(part.parameters.size(), 2) << what;
  EXPECT_TRUE(set.curves().empty() && set.points().empty()) << what;
}

TEST(OverlappingPatches, SameMaps)
{
  const Surface surface = landscape();
  expect_overlap(surface, surface, "same");
  expect_overlap(surface, surface.transposed(), "transposed");
  expect_overlap(surface.reversed(0), surface.transposed().reversed(0), "reversed");
  expect_overlap(surface, surface.with_domain(0, 0, 1), "on another domain");
  expect_overlap(surface, surface.elevated({4, 3}), "elevated");
  expect_overlap(surface, surface.restricted(0, Rational(1) / 2, 2), "a part");
  expect_overlap(surface.restricted(0, 0, 2), surface.restricted(0, 1, 3).restricted(1, 1, 2), "two parts");
}

TEST(OverlappingPatches, SameQuadricsAndTori)
{
  const Surface ball = SC::sphere_surface<K>(Point(0, 0, 0), 2),
                turned_ball = SC::sphere_surface<K>(Point(0, 0, 0), Point(2, 0, 0));
  expect_overlap(ball, turned_ball, "spheres");
  expect_overlap(ball.restricted(0, 1, 2), turned_ball, "a part of a sphere");
  const Surface tube = SC::cylinder_surface<K>(Point(0, 0, 0), 2, 3);
  expect_overlap(tube, SC::cylinder_surface<K>(Point(0, 0, 1), 2, 3), "cylinders");
  const Surface ring = SC::torus_surface<K>(Point(0, 0, 0), 3, 1);
  expect_overlap(ring, SC::torus_surface<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(0, 3, 0), Rational(1) / 3), "tori");
}

// Over the same coordinates, in one cell or in all.
TEST(OverlappingPatches, HeightFields)
{
  const auto field = [](const Rational& bend) {
    std::vector<Point> points;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j)
        points.emplace_back(std::array<Rational, 4>{0, Rational(1) / 2, Rational(3) / 2, 2}[i], j,
                            i * j + (i == 3 ? bend : Rational(0)));
    return Surface({2, 2}, {0, 0, 0, 1, 2, 2, 2}, {0, 0, 0, 2, 2, 2}, points);
  };
  expect_overlap(field(0), field(0), "same");
  expect_overlap(field(0), field(1), "in one cell");
  const auto rectangle = [](const Point& p, const Rational& width, const Rational& depth) {
    return Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1},
                   {p, p + Vector(0, depth, 0), p + Vector(width, 0, 0), p + Vector(width, depth, 0)});
  };
  expect_overlap(rectangle(Point(0, 0, 0), 3, 2), rectangle(Point(1, 1, 0), 2, 3), "planes");
  const Surface oblique({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1},
                        {Point(0, 0, 0), Point(-1, 3, 0), Point(2, 1, 0), Point(1, 4, 0)});
  expect_overlap(oblique, rectangle(Point(0, 1, 0), 3, 2), "planes, oblique");
  const auto above = SC::intersection_curves(rectangle(Point(0, 0, 0), 3, 2), rectangle(Point(1, 1, 1), 2, 3));
  EXPECT_TRUE(above.is_complete());
}

// No open part in common: neighbours, other heights of the same cylinder.
TEST(OverlappingPatches, NoOverlaps)
{
  const Surface surface = landscape(), tube = SC::cylinder_surface<K>(Point(0, 0, 0), 2, 3);
  for (const auto& [a, b] :
       {std::pair(tube, SC::cylinder_surface<K>(Point(0, 0, 4), 2, 3)),
        std::pair(surface.restricted(0, 0, 1), surface.transformed({1, 0, 0, 9, 0, 1, 0, 0, 0, 0, 1, 0})),
        std::pair(tube, SC::cylinder_surface<K>(Point(1, 0, 1), 2, 1))}) {
    const auto set = SC::intersection_curves(a, b, {.tolerance = 1e-8, .time_limit = 10});
    EXPECT_TRUE(set.is_complete());
    for (const SC::Undecided_part& part : set.undecided())
      EXPECT_NE(part.reason, "the surfaces overlap");
  }
}

} // namespace test_overlapping_patches
