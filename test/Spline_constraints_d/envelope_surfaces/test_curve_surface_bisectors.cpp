// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bisectors of curves and surfaces: a parabolic cylinder, a cone, equal distances from a cubic and a plane, bad input.

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/curve_surface_bisector.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace curve_surface_bisector_test {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Rational>;
using Point = K::Point_3;
using Surface = SC::Bspline_surface_3<K>;
using Curve = SC::Bspline_curve_3<K>;

namespace {

// z = 0
Surface plane()
{
  return Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{-2, -2, 0}, {-2, 2, 0}, {2, -2, 0}, {2, 2, 0}});
}

SC::Solution_surface_mesh checked_mesh(const SC::Envelope_surface_3& bisector)
{
  EXPECT_TRUE(bisector.is_complete()) << bisector;
  SC::Solution_surface_mesh result = bisector.mesh({.chord_error = 0.1, .angle = 10});
  EXPECT_GT(result.mesh.number_of_faces(), 10u);
  return result;
}

} // namespace

TEST(Curve_surface_bisector, parabolic_cylinder)
{
  const Curve line(1, {0, 0, 1, 1}, {Point(-1, 0, 1), Point(1, 0, 1)});
  const SC::Solution_surface_mesh mesh = checked_mesh(SC::curve_surface_bisector(line, plane(), 4));
  for (const auto& p : mesh.mesh.points())
    EXPECT_NEAR(p.z(), (p.y() * p.y() + 1) / 2, 1e-12);
}

TEST(Curve_surface_bisector, cone)
{
  const Curve axis(1, {0, 0, 1, 1}, {Point(0, 0, Rational(1) / 2), Point(0, 0, 2)});
  const SC::Envelope_surface_3 cone = SC::curve_surface_bisector(axis, plane(), 4);
  EXPECT_EQ(cone.euler_characteristic(), 0);
  const SC::Solution_surface_mesh mesh = checked_mesh(cone);
  for (const auto& p : mesh.mesh.points())
    EXPECT_NEAR(p.z(), std::hypot(p.x(), p.y()), 1e-12);
}

// The distances from both feet are the same, and at most the radius.
TEST(Curve_surface_bisector, cubic)
{
  const Curve cubic(3, {0, 0, 0, 0, 1, 1, 1, 1},
                    {Point(-1, -1, 1), Point(0, 1, 2), Point(0, -1, Rational(1) / 2), Point(1, 1, 1)});
  const SC::Solution_surface_mesh mesh = checked_mesh(SC::curve_surface_bisector(cubic, plane(), 2));
  for (const auto v : mesh.mesh.vertices()) {
    const auto& p = mesh.mesh.point(v);
    const auto c = cubic(Rational(mesh.unknowns[v][2]));
    const double x = p.x() - CGAL::to_double(c.x()), y = p.y() - CGAL::to_double(c.y()),
                 z = p.z() - CGAL::to_double(c.z());
    EXPECT_NEAR(std::sqrt(x * x + y * y + z * z), p.z(), 1e-11);
    EXPECT_LE(p.z(), 2 + 1e-9);
  }
}

TEST(Curve_surface_bisector, bad_input_and_limits)
{
  const Curve line(1, {0, 0, 1, 1}, {Point(-1, 0, 1), Point(1, 0, 1)});
  EXPECT_THROW(SC::curve_surface_bisector(line, plane(), 0), SC::Invalid_input);
  const Surface point({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Point>(4, Point(1, 2, 3)));
  EXPECT_THROW(SC::curve_surface_bisector(line, point, 1), SC::Invalid_input);
  EXPECT_FALSE(SC::curve_surface_bisector(line, plane(), 4, {.time_limit = 1e-9}).is_complete());
}

} // namespace curve_surface_bisector_test
