// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Common normals of two surfaces: distances in closed form, invariants of random surfaces, creases, contacts, limits.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/distances/common_normals.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace common_normals_test {

template <class Normals>
void expect_distances(const Normals& normals, std::vector<double> distances)
{
  EXPECT_TRUE(normals.is_complete());
  ASSERT_EQ(normals.size(), distances.size());
  std::sort(distances.begin(), distances.end());
  for (std::size_t i = 0; i < distances.size(); ++i) {
    EXPECT_EQ(normals[i].kind(), SC::Solution_kind::CERTIFIED);
    const auto [least, greatest] = normals[i].squared_distance_range();
    EXPECT_LE(CGAL::to_double(least), distances[i] * distances[i] + 1e-12);
    EXPECT_GE(CGAL::to_double(greatest), distances[i] * distances[i] - 1e-12);
    EXPECT_LT(CGAL::to_double(greatest - least), 1e-9);
  }
}

// The line through both centers meets each sphere twice.
TEST(CommonNormals, TwoSpheres)
{
  const double distance = std::sqrt(14.);
  expect_distances(
      SC::common_normals(K::Sphere_3(Point(0, 0, 0), Rational(1)), K::Sphere_3(Point(3, 1, 2), Rational(4))),
      {distance - 3, distance - 1, distance + 1, distance + 3});
}

// Through the center of a sphere go four normals of a torus, in the plane through the axis.
TEST(CommonNormals, SphereAndTorus)
{
  const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1), sphere = SC::sphere_surface<K>(Point(4, 3, 2), 1);
  std::vector<double> distances;
  for (const double side : {1., -1.}) {
    const double to_circle = std::hypot(5 - side * 3, 2); // from the center to that of a section
    for (const double foot : {to_circle - 1, to_circle + 1}) {
      distances.push_back(std::abs(foot - 1));
      distances.push_back(foot + 1);
    }
  }
  expect_distances(SC::common_normals(torus, sphere), distances);
  expect_distances(SC::common_normals(sphere, torus), distances);
}

// z = 0 and z = 1 + x^2 + y^2 about a corner: one normal; shifted beyond the edge: none. Spheres that touch: length 0.
TEST(CommonNormals, PlanesParaboloidsContacts)
{
  const auto paraboloid = [](const Rational& x, const Rational& y) { // its apex
    std::vector<Point> points;
    for (const int i : {-1, 0, 1})
      for (const int j : {-1, 0, 1})
        points.emplace_back(x + i, y + j, 1 + (i == 0 ? -1 : 1) + (j == 0 ? -1 : 1));
    return Surface({2, 2}, {-1, -1, -1, 1, 1, 1}, {-1, -1, -1, 1, 1, 1}, points);
  };
  const Surface plane({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 4, 0}, {4, 0, 0}, {4, 4, 0}});
  const auto one = SC::common_normals(plane, paraboloid(2, Rational(5) / 3));
  expect_distances(one, {1});
  EXPECT_NEAR(CGAL::to_double(one[0].point(0).y()), 5. / 3, 1e-12);
  EXPECT_NEAR(CGAL::to_double(one[0].point(1).x()), 2, 1e-12);
  expect_distances(SC::common_normals(plane, paraboloid(Rational(9) / 2, 2)), {});
  // where they cross, the distance is critical, but there is no normal
  expect_distances(SC::common_normals(plane, paraboloid(2, 2).transformed({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -2})), {1});
  const auto touching = SC::common_normals(K::Sphere_3(Point(0, 0, 0), Rational(1)),
                                           K::Sphere_3(Point(Rational(6) / 5, Rational(8) / 5, 0), Rational(1)));
  expect_distances(touching, {0, 2, 2, 4});
}

// Vectors between the points are orthogonal to both surfaces; the nearest pair is no farther than samples are.
TEST(CommonNormals, RandomSurfaces)
{
  std::mt19937 random(5);
  const auto number = [&](int range) -> Rational {
    return Rational(std::uniform_int_distribution(-range, range)(random)) / 32;
  };
  std::size_t count = 0;
  for (int repetition = 0; repetition < 6; ++repetition) {
    const auto patch = [&](int n, const Rational& height) {
      std::vector<Rational> knots(static_cast<std::size_t>(n) + 1, 0);
      knots.insert(knots.end(), static_cast<std::size_t>(n) + 1, 1);
      std::vector<Point> points;
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j)
          points.emplace_back(Rational(i) / n + number(2), Rational(j) / n + number(2), height + number(12));
      return Surface({n, n}, knots, knots, points);
    };
    const Surface a = patch(2, 0), b = patch(3, Rational(repetition) / 2);
    const auto normals = SC::common_normals(a, b, {.time_limit = 20});
    EXPECT_TRUE(normals.is_complete());
    for (const auto& pair : normals) {
      const Vector across = pair.point(1) - pair.point(0);
      const Vector normal_of_a = a.normal(pair.parameter_range(0, 0).first, pair.parameter_range(0, 1).first),
                   normal_of_b = b.normal(pair.parameter_range(1, 0).first, pair.parameter_range(1, 1).first);
      EXPECT_NEAR(length(CGAL::cross_product(normal_of_a, across)), 0, 1e-6);
      EXPECT_NEAR(length(CGAL::cross_product(normal_of_a, normal_of_b)), 0, 1e-6);
      ++count;
    }
  }
  EXPECT_GT(count, 3u);
}

// What a motion moves along both surfaces is recognized: without a limit of time there is an answer soon. Spheres about
// one axis have normals along it only, which are found unless they go through poles.
TEST(CommonNormals, CoaxialSurfaces)
{
  const auto sphere = [](const Point& center, const Rational& radius) { return SC::sphere_surface<K>(center, radius); };
  const auto along_axis = SC::common_normals(sphere(Point(0, 0, 0), 1), sphere(Point(3, 1, 2), 1));
  EXPECT_TRUE(along_axis.is_complete());
  EXPECT_EQ(along_axis.size(), 4u); // between points of both that are near or far
  const auto coaxial = SC::common_normals(sphere(Point(0, 0, 0), 1), sphere(Point(0, 0, 5), 1));
  EXPECT_FALSE(coaxial.is_complete());
  ASSERT_FALSE(coaxial.undecided().empty());
  EXPECT_EQ(coaxial.undecided().front().reason, "continuum suspected");
  EXPECT_LT(coaxial.summary().nodes, 2000u);
}

// Of coaxial surfaces infinitely many normals are on a circle: not complete, and in time.
TEST(CommonNormals, BadInputAndLimits)
{
  const auto limited = SC::common_normals(SC::torus_surface<K>(Point(0, 0, 0), 3, 1),
                                          K::Sphere_3(Point(0, 0, 2), Rational(1)), {.time_limit = 0.2});
  EXPECT_FALSE(limited.is_complete());
  EXPECT_FALSE(limited.undecided().empty());
  const Surface line({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}});
  EXPECT_FALSE(SC::common_normals(line, K::Sphere_3(Point(0, 0, 2), Rational(1))).is_complete());
  EXPECT_THROW(SC::common_normals(line, line, {.time_limit = -1}), SC::Invalid_input);
}

} // namespace common_normals_test
