// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/canal_surfaces.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/dupin_cyclides.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/rational_offset.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace surface_constructors_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using FT = Exact_rational;
using Curve_2 = SC::Bspline_curve_2<Exact_cartesian>;
using Curve_3 = SC::Bspline_curve_3<Exact_cartesian>;
using Surface = SC::Bspline_surface_3<Exact_cartesian>;
using Point = Exact_cartesian::Point_3;
using Vector = Exact_cartesian::Vector_3;
using Double_point = Double_cartesian::Point_3;

constexpr int rounds = 15;

FT square(const FT& x) { return x * x; }

std::pair<FT, FT> random_parameters(Random_geometry& random, const Surface& surface)
{
  const auto [u0, u1] = surface.domain(0);
  const auto [v0, v1] = surface.domain(1);
  return {u0 + (u1 - u0) * random.fraction(), v0 + (v1 - v0) * random.fraction()};
}

// Points at random parameters satisfy an equation exactly, and normals point to its positive side.
template <class Equation>
void check_implicit(const Surface& surface, const Equation& equation, unsigned seed)
{
  Random_geometry random(seed);
  int regular = 0;
  for (int i = 0; i < rounds; ++i) {
    const auto [u, v] = random_parameters(random, surface);
    const Point p = surface(u, v);
    EXPECT_EQ(equation(p), 0);
    const Vector n = surface.normal(u, v);
    if (n == CGAL::NULL_VECTOR)
      continue;
    ++regular;
    const FT step = FT(1) / (FT(1000000) * (abs(n.x()) + abs(n.y()) + abs(n.z())));
    EXPECT_GT(equation(p + n * step), 0);
  }
  EXPECT_GT(regular, rounds / 2);
}

TEST(Plane_patch, is_affine)
{
  const Surface plane = SC::plane_patch(Point(1, 2, 3), Vector(1, 0, 2), Vector(0, 3, 1));
  EXPECT_EQ(plane(FT(1) / 3, FT(1) / 2), Point(FT(4) / 3, FT(7) / 2, FT(25) / 6));
  EXPECT_EQ(plane.normal(0, 0), CGAL::cross_product(Vector(1, 0, 2), Vector(0, 3, 1)));
  const auto bilinear = SC::bilinear_surface(CGAL::Epick::Point_3(0, 0, 0), CGAL::Epick::Point_3(0, 1, 0),
                                             CGAL::Epick::Point_3(1, 0, 0), CGAL::Epick::Point_3(1, 1, 1));
  EXPECT_EQ(bilinear(0.5, 0.25), CGAL::Epick::Point_3(0.5, 0.25, 0.125));
}

TEST(Ruled_surface, joins_its_curves)
{
  Random_geometry random(1);
  for (int i = 0; i < rounds; ++i) {
    const Curve_3 a = random.curve<Exact_cartesian, 3>(3), b = random.curve<Exact_cartesian, 3>(3);
    const Surface ruled = SC::ruled_surface(a, b);
    EXPECT_TRUE(ruled.iso_curve(1, 0) == a);
    EXPECT_TRUE(ruled.iso_curve(1, 1) == b);
    const auto [u, v] = random_parameters(random, ruled);
    EXPECT_TRUE(CGAL::collinear(a(u), b(u), ruled(u, v)));
  }
  const Curve_3 segment = SC::segment_curve(Point(0, 0, 0), Point(1, 0, 0));
  expect_invalid([&] { SC::ruled_surface(segment, segment.with_domain(0, 2)); }, "different domains");
}

TEST(Translational_surface, adds_points)
{
  Random_geometry random(2);
  for (int i = 0; i < rounds; ++i) {
    const Curve_3 profile = random.curve<Exact_cartesian, 3>(3), path = random.curve<Exact_cartesian, 3>(2);
    const Point origin = random.points<Exact_cartesian, 3>(1)[0];
    const Surface surface = SC::translational_surface(profile, path, origin);
    const auto [u, v] = random_parameters(random, surface);
    EXPECT_EQ(surface(u, v), profile(u) + (path(v) - origin));
    EXPECT_EQ(SC::extruded_surface(profile, Vector(1, 2, 3))(u, v), profile(u) + Vector(1, 2, 3) * v);
  }
  expect_invalid([] { SC::extruded_surface(SC::segment_curve(Point(0, 0, 0), Point(1, 0, 0)), Vector(0, 0, 0)); },
                 "zero");
}

TEST(Swept_surface, moves_a_profile_with_a_frame)
{
  Random_geometry random(3);
  const auto vector = [](const Curve_3& c, const FT& t) { return c(t) - CGAL::ORIGIN; };
  for (int i = 0; i < rounds / 2; ++i) {
    const Curve_2 profile = random.curve<Exact_cartesian, 2>(2);
    const Curve_3 spine = random.curve<Exact_cartesian, 3>(2), a = random.curve<Exact_cartesian, 3>(2),
                  b = random.curve<Exact_cartesian, 3>(1);
    const Surface surface = SC::swept_surface(profile, spine, a, b);
    const auto [u, v] = random_parameters(random, surface);
    EXPECT_EQ(surface(u, v), spine(v) + vector(a, v) * profile(u).x() + vector(b, v) * profile(u).y());
  }
  // With a common weight the degrees do not add up.
  const Curve_3 circle = SC::circle_curve(Point(0, 0, 0), Vector(0, 0, 1), Point(1, 0, 0));
  const Curve_2 segment = SC::segment_curve(Exact_cartesian::Point_2(0, 0), Exact_cartesian::Point_2(1, 1));
  EXPECT_EQ(SC::swept_surface(segment, circle, circle, circle).degree(1), 2);
  expect_invalid([&] { SC::swept_surface(segment, circle, circle.with_domain(0, 1), circle); }, "different domains");
}

TEST(Surface_of_revolution, keeps_height_and_distance)
{
  Random_geometry random(4);
  for (int i = 0; i < rounds; ++i) {
    const Curve_3 profile = random.curve<Exact_cartesian, 3>(3);
    const Point center = random.points<Exact_cartesian, 3>(1)[0];
    const Vector axis(random.integer(-5, 5), random.integer(-5, 5), random.integer(1, 5));
    const Surface surface = SC::surface_of_revolution(profile, center, axis);
    EXPECT_TRUE(surface.is_closed(0));
    EXPECT_TRUE(surface.iso_curve(0, 0) == profile);
    const auto [u, v] = random_parameters(random, surface);
    EXPECT_EQ((surface(u, v) - center) * axis, (profile(v) - center) * axis);
    EXPECT_EQ(CGAL::squared_distance(surface(u, v), center), CGAL::squared_distance(profile(v), center));
    // Half a turn at the parameter 2.
    const Point middle = CGAL::midpoint(surface(2, v), profile(v));
    EXPECT_EQ(CGAL::cross_product(middle - center, axis), CGAL::NULL_VECTOR);
  }
}

TEST(Sphere_surface, satisfies_its_equation)
{
  check_implicit(
      SC::sphere_surface(Point(1, 2, 3), FT(5) / FT(2)),
      [](const Point& p) { return FT(CGAL::squared_distance(p, Point(1, 2, 3)) - FT(25) / FT(4)); }, 5);
  // The radius is the root of 14.
  const Surface sphere = SC::sphere_surface(Point(0, 0, 0), Point(1, 2, 3));
  check_implicit(
      sphere, [](const Point& p) { return FT(CGAL::squared_distance(p, Point(0, 0, 0)) - 14); }, 6);
  EXPECT_EQ(sphere.degree(0), 2);
  EXPECT_EQ(sphere.degree(1), 2);
  EXPECT_EQ(sphere(1, 2), Point(1, 2, 3));
  EXPECT_EQ(sphere(1, 0), Point(-1, -2, -3));
  EXPECT_EQ(sphere.gaussian_curvature(FT(1) / 3, FT(1) / 2), FT(1) / FT(14));
  EXPECT_EQ(sphere.squared_mean_curvature(FT(1) / 3, FT(1) / 2), FT(1) / FT(14));
  EXPECT_LT(sphere.mean_curvature(FT(1) / 3, FT(1) / 2), 0);
  expect_invalid([&] { sphere.gaussian_curvature(0, 0); }, "singular");
}

TEST(Cylinder_and_cone, satisfy_their_equations)
{
  check_implicit(
      SC::cylinder_surface(Point(1, 0, 0), FT(3), FT(4)),
      [](const Point& p) { return FT(square(p.x() - 1) + square(p.y()) - 9); }, 7);
  // Around the line through (0,0,1) along (1,1,1), at the squared distance of (2,0,1).
  const Vector axis(1, 1, 1);
  const auto squared_distance = [&](const Point& p) {
    return CGAL::cross_product(p - Point(0, 0, 1), axis).squared_length();
  };
  const FT radius = squared_distance(Point(2, 0, 1));
  const Surface cylinder = SC::cylinder_surface(Point(0, 0, 1), axis, Point(2, 0, 1));
  check_implicit(
      cylinder, [&](const Point& p) { return FT(squared_distance(p) - radius); }, 8);
  EXPECT_EQ(cylinder(0, 0), Point(2, 0, 1));
  EXPECT_EQ(cylinder(0, 1), Point(3, 1, 2));
  EXPECT_EQ(cylinder.gaussian_curvature(FT(1) / 5, FT(1) / 7), 0);

  // Apex (0,0,2), downwards, radius 1 at height 0: x^2 + y^2 = (1 - z/2)^2.
  const Surface cone = SC::cone_surface(Point(0, 0, 2), Vector(0, 0, -1), Point(1, 0, 0));
  check_implicit(
      cone, [](const Point& p) { return FT(square(p.x()) + square(p.y()) - square(FT(1) - p.z() / FT(2))); }, 9);
  EXPECT_EQ(cone(3, 0), Point(0, 0, 2));
  EXPECT_EQ(cone(2, 1), Point(-1, 0, 0));
}

TEST(Torus_surface, satisfies_its_equation)
{
  const auto torus_equation = [](const Point& p, const FT& R2, const FT& r2) {
    return FT(square(CGAL::squared_distance(p, Point(0, 0, 0)) + R2 - r2) -
              FT(4) * R2 * (square(p.x()) + square(p.y())));
  };
  const Surface torus = SC::torus_surface(Point(0, 0, 0), FT(3), FT(1));
  check_implicit(
      torus, [&](const Point& p) { return torus_equation(p, 9, 1); }, 10);
  EXPECT_EQ(torus(0, 0), Point(4, 0, 0));
  EXPECT_EQ(torus(0, 1), Point(3, 0, 1));
  EXPECT_EQ(torus(1, 2), Point(0, 2, 0));
  EXPECT_TRUE(torus.is_closed(0) && torus.is_closed(1));
  EXPECT_EQ(torus.gaussian_curvature(0, 0), FT(1) / 4);
  EXPECT_EQ(torus.gaussian_curvature(0, 2), FT(-1) / 2);
  EXPECT_EQ(torus.gaussian_curvature(FT(1) / 3, 1), 0);
  // Spine through (1,1,0): R^2 = 2, r = R / 2.
  check_implicit(
      SC::torus_surface(Point(0, 0, 0), Vector(0, 0, 2), Point(1, 1, 0), FT(1) / FT(2)),
      [&](const Point& p) { return torus_equation(p, 2, FT(1) / 2); }, 11);
}

TEST(Pipe_surface, keeps_its_distance_from_the_spine)
{
  Random_geometry random(12);
  const auto check = [&](const Surface& pipe, const Curve_3& spine, const FT& squared_radius) {
    EXPECT_TRUE(pipe.is_closed(0));
    for (int i = 0; i < rounds; ++i) {
      const auto [u, v] = random_parameters(random, pipe);
      EXPECT_EQ(CGAL::squared_distance(pipe(u, v), spine(v)), squared_radius);
      EXPECT_EQ((pipe(u, v) - spine(v)) * spine.tangent(v), 0);
      EXPECT_GT((pipe(u, v) - spine(v)) * pipe.normal(u, v), 0);
    }
  };
  // A planar cubic, a B-spline and a circle.
  const Curve_3 cubic =
      SC::bezier_curve<Exact_cartesian>({Point(0, 0, 0), Point(3, 0, 0), Point(4, 2, 0), Point(7, 7, 0)});
  check(SC::pipe_surface(cubic, Vector(0, 0, FT(1) / 4)), cubic, FT(1) / 16);
  const Curve_3 spline(2, {0, 0, 0, 1, 2, 2, 2}, {{0, 0, 0}, {4, 0, 4}, {8, 0, 0}, {16, 0, 8}});
  check(SC::pipe_surface(spline, Vector(0, -1, 0)), spline, 1);
  const Curve_3 circle = SC::circle_curve(Point(0, 0, 0), Vector(0, 0, 1), Point(5, 0, 0));
  const Surface torus = SC::pipe_surface(circle, Vector(0, 0, 1));
  check(torus, circle, 1);
  EXPECT_TRUE(torus.is_closed(1));
  // Along a line a normal may turn: the quarter of a circle.
  const Curve_3 line = SC::segment_curve(Point(0, 0, 0), Point(0, 0, 1));
  const Curve_3 normal = SC::circle_curve(Point(0, 0, 0), Vector(0, 0, 1), Point(1, 1, 0)).restricted(0, 1);
  check(SC::pipe_surface(line, normal), line, 2);

  expect_invalid([&] { SC::pipe_surface(cubic, Vector(0, 1, 1)); }, "right angle");
  expect_invalid([&] { SC::pipe_surface(cubic, Vector(0, 0, 0)); }, "zero");
  expect_invalid([&] { SC::pipe_surface(cubic, SC::segment_curve(Point(0, 0, 1), Point(0, 0, 2))); }, "not constant");
  expect_invalid([&] { SC::pipe_surface(spline, SC::segment_curve(Point(0, 0, 1), Point(0, 0, 1))); },
                 "different domains");
  const Curve_3 corner = SC::polyline_curve<Exact_cartesian>({Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0)});
  expect_invalid([&] { SC::pipe_surface(corner, Vector(0, 0, 1)); }, "continuously differentiable");
}

TEST(Canal_surface, touches_its_spheres)
{
  Random_geometry random(13);
  const auto check = [&](const Surface& canal, const Curve_3& spine, const Curve_3& arm) {
    EXPECT_TRUE(canal.is_closed(0));
    EXPECT_TRUE(canal.iso_curve(0, 0)(1) == spine(1) + (arm(1) - CGAL::ORIGIN));
    for (int i = 0; i < rounds; ++i) {
      const auto [u, v] = random_parameters(random, canal);
      const Vector radius = canal(u, v) - spine(v);
      EXPECT_EQ(radius.squared_length(), (arm(v) - CGAL::ORIGIN).squared_length());
      EXPECT_EQ(CGAL::cross_product(radius, canal.normal(u, v)), CGAL::NULL_VECTOR);
      EXPECT_NE(canal.normal(u, v), CGAL::NULL_VECTOR);
    }
  };
  // Normals (-2t, 1, 1 + t) of the parabola (t, t^2, 0) and what they leave for the spine, (3 t, t^2 - 1, -1 - t).
  const Curve_3 spine =
      SC::bezier_curve<Exact_cartesian>({Point(0, -1, -1), Point(FT(3) / 2, -1, FT(-3) / 2), Point(3, 0, -2)});
  const Curve_3 arm = SC::segment_curve(Point(0, 1, 1), Point(-2, 1, 2));
  check(SC::canal_surface(spine, arm), spine, arm);
  // Spheres that grow along a line: a cone.
  const Curve_3 line = SC::segment_curve(Point(0, 0, 5), Point(0, 0, 10)),
                growing = SC::segment_curve(Point(FT(12) / 5, 0, FT(-9) / 5), Point(FT(24) / 5, 0, FT(-18) / 5));
  const Surface cone = SC::canal_surface(line, growing);
  check(cone, line, growing);
  EXPECT_EQ(cone.gaussian_curvature(FT(1) / 3, FT(1) / 2), 0);
  expect_invalid([&] { SC::canal_surface(line, SC::segment_curve(Point(1, 0, 0), Point(2, 0, 0))); }, "right angle");
  expect_invalid([&] { SC::canal_surface(line, growing.with_domain(0, 2)); }, "different domains");
}

// The same constructions in the other kernels: rounded, or lazily exact.
template <class Kernel>
void check_in_kernel(double tolerance)
{
  using P = typename Kernel::Point_3;
  using NT = typename Kernel::FT;
  const auto torus = SC::torus_surface(P(1, 2, 3), 3, 1);
  const auto sphere = SC::sphere_surface(P(1, 2, 3), P(2, 4, 4));
  const auto cylinder = SC::cylinder_surface(P(0, 0, 0), 2, 5);
  for (int i = 0; i <= 8; ++i) {
    const NT u = 0.5 * i, v = 0.25 * i;
    const auto t = torus(u, v) - P(1, 2, 3);
    EXPECT_LE(CGAL::abs(NT(CGAL::square(t.squared_length() + 8) - 36 * (t.x() * t.x() + t.y() * t.y()))),
              NT(tolerance));
    EXPECT_LE(CGAL::abs(NT(CGAL::squared_distance(sphere(u, v), P(1, 2, 3)) - 6)), NT(tolerance));
    const P c = cylinder(u, v / 2);
    EXPECT_LE(CGAL::abs(NT(c.x() * c.x() + c.y() * c.y() - 4)), NT(tolerance));
  }
}

TEST(Surface_constructors, work_in_all_kernels)
{
  check_in_kernel<Double_cartesian>(1e-11);
  check_in_kernel<CGAL::Epick>(1e-11);
  check_in_kernel<CGAL::Epeck>(0);
}

TEST(Surface_constructors, reject_bad_input)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Point origin(0, 0, 0);
  const Vector up(0, 0, 1);
  expect_invalid([&] { SC::sphere_surface(origin, origin); }, "same point");
  expect_invalid([&] { SC::sphere_surface(origin, FT(-1)); }, "not positive");
  expect_invalid([&] { SC::sphere_surface(Double_point(0, nan, 0), 1); }, "NaN");
  expect_invalid([&] { SC::cylinder_surface(origin, FT(0), FT(1)); }, "radius");
  expect_invalid([&] { SC::cylinder_surface(origin, FT(1), FT(0)); }, "height");
  expect_invalid([&] { SC::cylinder_surface(origin, up, Point(0, 0, 3)); }, "on the axis");
  expect_invalid([&] { SC::cylinder_surface(origin, Vector(0, 0, 0), Point(0, 1, 3)); }, "zero");
  expect_invalid([&] { SC::cone_surface(origin, up, Point(0, 0, 3)); }, "on the axis");
  expect_invalid([&] { SC::torus_surface(origin, up, Point(0, 0, 3), FT(1)); }, "on the axis");
  expect_invalid([&] { SC::torus_surface(origin, up, Point(1, 0, 3), FT(1)); }, "plane");
  expect_invalid([&] { SC::torus_surface(origin, FT(1), FT(0)); }, "minor radius");
  expect_invalid([&] { SC::surface_of_revolution(SC::segment_curve(origin, Point(1, 0, 0)), origin, Vector(0, 0, 0)); },
                 "direction");
  expect_invalid(
      [&] {
        SC::bilinear_surface(Double_point(0, nan, 0), Double_point(0, 0, 0), Double_point(0, 0, 0),
                             Double_point(0, 0, 0));
      },
      "control point 0");
}

} // namespace

TEST(Surface_constructors, dupin_cyclide)
{
  for (const auto& [a, b, c, mu] :
       {std::array<FT, 4>{5, 4, 3, 4}, std::array<FT, 4>{13, 12, 5, 6}, std::array<FT, 4>{3, 3, 0, 1}}) {
    const Surface cyclide = SC::dupin_cyclide_surface<Exact_cartesian>(a, b, c, mu);
    EXPECT_EQ(cyclide.degree(0), 2);
    EXPECT_EQ(cyclide.degree(1), 2);
    EXPECT_TRUE(cyclide.is_closed(0) && cyclide.is_closed(1));
    check_implicit(
        cyclide,
        [&](const Point& p) {
          return FT(square((p - CGAL::ORIGIN).squared_length() - mu * mu + b * b) - 4 * square(a * p.x() - c * mu) -
                    4 * b * b * p.y() * p.y());
        },
        12);
  }
  EXPECT_THROW(SC::dupin_cyclide_surface<Exact_cartesian>(5, 4, 2, 4), SC::Invalid_input);
  EXPECT_THROW(SC::dupin_cyclide_surface<Double_cartesian>(5, 4, std::numeric_limits<double>::quiet_NaN(), 4),
               SC::Invalid_input);
}

TEST(Surface_constructors, rational_unit_normals)
{
  Random_geometry random(23);
  const Surface sphere = SC::sphere_surface<Exact_cartesian>(Point(1, 2, 3), FT(2)),
                cone = SC::cone_surface<Exact_cartesian>(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 0, 4)),
                cyclide = SC::dupin_cyclide_surface<Exact_cartesian>(5, 4, 3, 4);
  for (const Surface& surface : {sphere, cone, cyclide, SC::torus_surface<Exact_cartesian>(Point(0, 0, 0), 3, 1)}) {
    const auto normal = SC::rational_unit_normal(surface);
    ASSERT_TRUE(normal);
    for (int i = 0; i < rounds; ++i) {
      const auto [u, v] = random_parameters(random, surface);
      const Vector n = (*normal)(u, v) - CGAL::ORIGIN, expected = surface.normal(u, v);
      EXPECT_EQ(n.squared_length(), 1);
      EXPECT_EQ(CGAL::cross_product(n, expected), CGAL::NULL_VECTOR);
      EXPECT_GE(n * expected, 0);
    }
  }
  // Poles and tips have normals, too, and an offset of a whole sphere is one.
  EXPECT_EQ((*SC::rational_unit_normal(sphere))(1, 2), Point(0, 0, 1));
  EXPECT_EQ((*SC::rational_unit_normal(cone))(0, 0), Point(FT(4, 5), 0, FT(-3, 5)));
  EXPECT_TRUE(*SC::rational_offset(sphere, FT(3)) == SC::sphere_surface<Exact_cartesian>(Point(1, 2, 3), FT(5)));
  EXPECT_TRUE(*SC::rational_offset(cyclide, FT(1, 2)) == SC::dupin_cyclide_surface<Exact_cartesian>(5, 4, 3, FT(9, 2)));
  // An edge of a roof has none, nor has a plane whose unit normal is not rational.
  const Surface roof({1, 1}, {0, 0, 1, 2, 2}, {0, 0, 1, 1},
                     {{0, 0, 0}, {0, 1, 0}, {3, 0, 4}, {3, 1, 4}, {6, 0, 0}, {6, 1, 0}});
  EXPECT_FALSE(SC::rational_unit_normal(roof));
  EXPECT_FALSE(
      SC::rational_unit_normal(SC::plane_patch<Exact_cartesian>(Point(0, 0, 0), Vector(1, 1, 0), Vector(0, 0, 1))));
}

} // namespace surface_constructors_test
