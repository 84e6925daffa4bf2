// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets of surfaces and envelopes of two surfaces: closed forms, the points and normals that define them, cuspidal
// edges, orientations, bad input.

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/envelope_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/offset_surface.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace offset_and_envelope_surface_test {

namespace SC = CGAL::Spline_constraints;
namespace PMP = CGAL::Polygon_mesh_processing;
using Rational = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Rational>;
using Point = K::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Surface = SC::Bspline_surface_3<K>;

namespace {

// z = a x^2 + b y^2 over [-1, 1]^2, x = 2u - 1.
Surface paraboloid(const Rational& a, const Rational& b, bool is_transposed = false)
{
  std::vector<Point> points;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int k = is_transposed ? j : i, l = is_transposed ? i : j;
      points.emplace_back(k - 1, l - 1, (k == 1 ? -a : a) + (l == 1 ? -b : b));
    }
  return Surface({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, points);
}

Vector normal_of_paraboloid(double a, double b, double u, double v)
{
  const Vector n(-2 * a * (2 * u - 1), -2 * b * (2 * v - 1), 1);
  return n / std::sqrt(n.squared_length());
}

Surface bicubic(std::mt19937& random)
{
  std::uniform_int_distribution<int> height(-8, 8);
  std::vector<Point> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(i, j, Rational(height(random)) / 10);
  return Surface({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points);
}

} // namespace

TEST(Offset_surface, sphere_and_torus)
{
  const SC::Envelope_surface_3 sphere =
      SC::offset_surface(SC::sphere_surface<K>(Point(0, 0, 0), Rational(1)), Rational(1) / 2);
  ASSERT_TRUE(sphere.is_complete()) << sphere;
  EXPECT_EQ(sphere.euler_characteristic(), 2); // its poles are points
  const SC::Solution_surface_mesh round = sphere.mesh({.chord_error = 0.05});
  EXPECT_TRUE(round.is_complete());
  EXPECT_TRUE(CGAL::is_closed(round.mesh));
  EXPECT_NEAR(PMP::volume(round.mesh), 4.5 * CGAL_PI, 0.3);
  for (const auto& p : round.mesh.points())
    EXPECT_NEAR(std::hypot(p.x(), p.y(), p.z()), 1.5, 1e-12);

  const SC::Envelope_surface_3 torus =
      SC::offset_surface(SC::torus_surface<K>(Point(0, 0, 0), Rational(2), Rational(1) / 2), Rational(1) / 2);
  ASSERT_TRUE(torus.is_complete()) << torus;
  EXPECT_EQ(torus.euler_characteristic(), 0);
  const SC::Solution_surface_mesh ring = torus.mesh({.chord_error = 0.05});
  EXPECT_TRUE(CGAL::is_closed(ring.mesh));
  EXPECT_NEAR(std::abs(PMP::volume(ring.mesh)), 4 * CGAL_PI * CGAL_PI, 1);
  for (const auto& p : ring.mesh.points())
    EXPECT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - 2, p.z()), 1, 1e-12);
}

// Upwards, towards the foci: there are cuspidal edges at a distance beyond 1/2.
TEST(Offset_surface, paraboloid)
{
  const Surface surface = paraboloid(1, 1);
  for (const Rational& r : std::vector<Rational>{Rational(1) / 4, Rational(-1), Rational(3) / 4}) {
    const SC::Envelope_surface_3 offset = SC::offset_surface(surface, r);
    ASSERT_TRUE(offset.is_complete()) << offset;
    ASSERT_EQ(offset.parts().size(), 1u);
    EXPECT_EQ(offset.parts()[0].cusps->vertices().empty(), r < Rational(1) / 2);
    const SC::Solution_surface_mesh mesh = offset.mesh({.chord_error = 0.05});
    ASSERT_GT(mesh.mesh.number_of_faces(), 20u);
    for (const auto vertex : mesh.mesh.vertices()) {
      const double u = mesh.unknowns[vertex][0], v = mesh.unknowns[vertex][1], x = 2 * u - 1, y = 2 * v - 1;
      const Vector difference = mesh.mesh.point(vertex) - CGAL::ORIGIN - Vector(x, y, x * x + y * y) -
          CGAL::to_double(r) * normal_of_paraboloid(1, 1, u, v);
      EXPECT_LE(difference.squared_length(), 1e-24) << r;
    }
  }
}

TEST(Envelope_surface, paraboloids)
{
  const SC::Envelope_surface_3 sum = SC::envelope_surface(paraboloid(1, 2), paraboloid(2, 1));
  ASSERT_TRUE(sum.is_complete()) << sum;
  EXPECT_EQ(sum.euler_characteristic(), 1);
  const SC::Solution_surface_mesh mesh = sum.mesh({.chord_error = 0.01});
  EXPECT_TRUE(mesh.is_complete());
  ASSERT_GT(mesh.mesh.number_of_faces(), 20u);
  for (const auto& p : mesh.mesh.points())
    EXPECT_NEAR(p.z(), 2. / 3 * (p.x() * p.x() + p.y() * p.y()), 1e-12);
  // with the other orientation of one of them no normals have the same direction
  const SC::Envelope_surface_3 none = SC::envelope_surface(paraboloid(1, 2), paraboloid(2, 1, true));
  EXPECT_TRUE(none.is_complete()) << none;
  EXPECT_TRUE(none.parts()[0].solutions.surfaces().empty());
  EXPECT_EQ(none.mesh().mesh.number_of_faces(), 0u);
}

TEST(Envelope_surface, bicubic_surfaces)
{
  std::mt19937 random(54);
  for (int round = 0; round < 2; ++round) {
    const Surface first = bicubic(random), second = bicubic(random);
    const SC::Envelope_surface_3 sum = SC::envelope_surface(first, second, {.tolerance = 1e-8, .time_limit = 20});
    ASSERT_TRUE(sum.is_complete()) << sum;
    const SC::Solution_surface_mesh mesh = sum.mesh({.chord_error = 0.05});
    ASSERT_GT(mesh.mesh.number_of_faces(), 20u);
    std::size_t count = 0;
    for (const auto vertex : mesh.mesh.vertices()) {
      if (count++ % 20 != 0)
        continue;
      const std::vector<double>& x = mesh.unknowns[vertex];
      const auto tangent = [](const Surface& surface, double u, double v, int axis) {
        const auto d = surface.derivative(Rational(u), Rational(v), axis == 0 ? 1 : 0, axis == 1 ? 1 : 0);
        return Vector(CGAL::to_double(d.x()), CGAL::to_double(d.y()), CGAL::to_double(d.z()));
      };
      const Vector n = CGAL::cross_product(tangent(first, x[0], x[1], 0), tangent(first, x[0], x[1], 1)),
                   m = CGAL::cross_product(tangent(second, x[2], x[3], 0), tangent(second, x[2], x[3], 1));
      EXPECT_GT(n * m, 0);
      EXPECT_LE(CGAL::cross_product(n, m).squared_length(), 1e-20 * n.squared_length() * m.squared_length());
    }
  }
}

TEST(Envelope_surface, bad_input_and_limits)
{
  const Surface surface = paraboloid(1, 1),
                point({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, std::vector<Point>(4, Point(1, 2, 3)));
  EXPECT_THROW(SC::offset_surface(point, Rational(1)), SC::Invalid_input);
  EXPECT_THROW(SC::envelope_surface(surface, point), SC::Invalid_input);
  EXPECT_FALSE(SC::envelope_surface(surface, surface, {.time_limit = 1e-9}).is_complete());
  EXPECT_FALSE(SC::offset_surface(surface, Rational(1), {.time_limit = 1e-9}).is_complete());
}

} // namespace offset_and_envelope_surface_test
