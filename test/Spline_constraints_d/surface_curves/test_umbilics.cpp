// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Umbilics: of a triaxial ellipsoid and of paraboloids by formula, flat points, none on saddles and tori; rigid motions
// and inserted knots change nothing.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/umbilics.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace umbilics_test {

using Function = SC::Bspline_function<Rational>;
using Umbilics = SC::Umbilics_3<K>;

// A surface with the homogeneous coordinates f(u,v) over [-h,h]^2.
Surface surface_of(int h, const std::function<std::array<Function, 4>(const Function&, const Function&)>& f)
{
  const std::vector<Rational> knots{-h, -h, h, h};
  const Function u({1, 1}, {knots, knots}, {-h, -h, h, h}), v({1, 1}, {knots, knots}, {-h, h, -h, h});
  const auto [x, y, z, w] = f(u, v);
  return Surface::from_homogeneous_coordinates({x, y, z}, w);
}

// (x, y, f(x,y)) over [-1,1]^2.
Surface graph(const std::function<Function(const Function&, const Function&)>& f)
{
  return surface_of(1, [&](const Function& x, const Function& y) {
    return std::array<Function, 4>{x, y, f(x, y), x * Rational(0) + Rational(1)};
  });
}

// Umbilics at these points and no others.
void expect_umbilics(const Surface& surface, const std::vector<std::array<double, 3>>& points)
{
  const Umbilics found = SC::umbilics(surface);
  EXPECT_TRUE(found.is_complete());
  ASSERT_EQ(found.points().size(), points.size());
  for (const Umbilics::Umbilic& umbilic : found.points())
    EXPECT_TRUE(umbilic.parameters.is_certified());
  for (const auto& [x, y, z] : points) {
    std::size_t count = 0;
    for (const Umbilics::Umbilic& umbilic : found.points())
      count += std::hypot(CGAL::to_double(umbilic.point.x()) - x, CGAL::to_double(umbilic.point.y()) - y,
                          CGAL::to_double(umbilic.point.z()) - z) < 1e-12;
    EXPECT_EQ(count, 1u) << x << ' ' << y << ' ' << z;
  }
}

void expect_umbilics_with_knots(const Surface& surface, const std::vector<std::array<double, 3>>& points)
{
  expect_umbilics(surface, points);
  expect_umbilics(surface.with_knot(0, 0).with_knot(1, Rational(1, 3)), points);
}

// x^2/9 + y^2/4 + z^2 = 1 has four, in the plane y = 0: x^2 = 9 (9 - 4) / (9 - 1), z^2 = (4 - 1) / (9 - 1).
TEST(Umbilics, triaxial_ellipsoid)
{
  const Surface ellipsoid = surface_of(2, [](const Function& u, const Function& v) {
    const Function w = u * u + v * v + Rational(1);
    return std::array<Function, 4>{u * Rational(6), (w - Rational(2)) * Rational(2), v * Rational(2), w};
  });
  const double x = 3 * std::sqrt(5.0 / 8), z = std::sqrt(3.0 / 8);
  expect_umbilics(ellipsoid, {{x, 0, z}, {x, 0, -z}, {-x, 0, z}, {-x, 0, -z}});
}

// z = a x^2 + b y^2 with b > a > 0: x = 0, y^2 = (b - a) / (4 a b^2).
TEST(Umbilics, paraboloids)
{
  const auto paraboloid = [](const Rational& a, const Rational& b) {
    return graph([&](const Function& x, const Function& y) { return x * x * a + y * y * b; });
  };
  expect_umbilics_with_knots(paraboloid(Rational(1, 2), 1), {{0, 0.5, 0.25}, {0, -0.5, 0.25}});
  std::mt19937 random(3);
  std::uniform_int_distribution<int> tenths(5, 20);
  for (int round = 0; round < 10; ++round) {
    const Rational a(tenths(random), 10), b = a + Rational(tenths(random), 10);
    const double y = std::sqrt(CGAL::to_double(Rational((b - a) / (4 * a * b * b)))),
                 z = CGAL::to_double(Rational((b - a) / (4 * a * b)));
    expect_umbilics_with_knots(paraboloid(a, b),
                               y < 1 ? std::vector<std::array<double, 3>>{{0, y, z}, {0, -y, z}}
                                     : std::vector<std::array<double, 3>>{});
  }
  // at the vertex, where both equations have terms of the second order only
  const Umbilics round = SC::umbilics(paraboloid(1, 1));
  EXPECT_TRUE(round.is_complete());
  ASSERT_EQ(round.points().size(), 1u);
  EXPECT_EQ(round.points()[0].parameters.kind(), SC::Solution_kind::CLUSTER);
  for (const auto& [lower, upper] : round.points()[0].parameters.exact_box())
    EXPECT_TRUE(lower <= 0 && 0 <= upper);
}

TEST(Umbilics, none_and_flat_points)
{
  expect_umbilics_with_knots(graph([](const Function& x, const Function& y) { return x * x - y * y * Rational(2); }),
                             {});
  expect_umbilics(graph([](const Function& x, const Function& y) { return x * x * x - x * y * y * Rational(3); }),
                  {{0, 0, 0}});
  expect_umbilics(SC::torus_surface<K>(Point(0, 0, 0), 3, 1), {});
}

// Turned by angles of Pythagorean triangles about two axes: as many, at the same parameters.
TEST(Umbilics, rigid_motions)
{
  const K::Aff_transformation_3 about_z(Rational(3, 5), Rational(-4, 5), 0, 1, Rational(4, 5), Rational(3, 5), 0, 2, 0,
                                        0, 1, 3),
      about_x(1, 0, 0, 0, 0, Rational(5, 13), Rational(-12, 13), 0, 0, Rational(12, 13), Rational(5, 13), 0);
  const K::Aff_transformation_3 turn = about_x * about_z;
  const Surface surface = graph([](const Function& x, const Function& y) {
    return x * x * Rational(1, 2) + y * y + x * y * y * Rational(1, 4) + x * x * x * Rational(1, 8);
  });
  const Umbilics before = SC::umbilics(surface), after = SC::umbilics(surface.transformed(turn));
  EXPECT_TRUE(before.is_complete() && after.is_complete());
  ASSERT_FALSE(before.points().empty());
  ASSERT_EQ(before.points().size(), after.points().size());
  for (std::size_t i = 0; i < before.points().size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(before.points()[i].parameters.point()[k], after.points()[i].parameters.point()[k], 1e-13);
}

TEST(Umbilics, undecided)
{
  for (const Surface& surface :
       {SC::sphere_surface<K>(Point(0, 0, 0), 1), graph([](const Function&x, const Function&y) { return x + y; })}) {
    const Umbilics found = SC::umbilics(surface);
    EXPECT_FALSE(found.is_complete());
    EXPECT_TRUE(found.points().empty());
  }
}

TEST(Umbilics, bad_input)
{
  EXPECT_THROW(SC::umbilics(graph([](const Function& x, const Function& y) { return x * y; }), {.tolerance = -1}),
               SC::Invalid_input);
}

} // namespace umbilics_test
