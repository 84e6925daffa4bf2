// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Silhouettes: circles of spheres, lines of cylinders and cones, those of a torus by direction, random patches against
// the signs along their edges, rotations, creases.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouettes.h>
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

namespace silhouettes_test {

using Curves = SC::Surface_curves_3<K>;

namespace {

constexpr double tiny = 1e-9;

Vector line_of_sight(const Point&, const Vector& direction) { return direction; }
Vector line_of_sight(const Point& p, const Point& eye) { return eye - p; }

// Points of the curves lie on the surface, which is tangent to the line of sight there.
template <class Eye>
void check_points(const Surface& surface, const Eye& eye, const Curves& set, const std::string& what)
{
  for (const SC::Surface_curve& curve : set.curves()) {
    const auto samples = set.polyline(curve, 1e-2);
    ASSERT_GE(samples.size(), 2u) << what;
    EXPECT_EQ(samples.front().point == samples.back().point, curve.is_closed) << what;
    for (const auto& sample : samples) {
      std::array<Rational, 2> u;
      for (int axis = 0; axis < 2; ++axis)
        u[axis] = (std::min)((std::max)(Rational(sample.parameters[axis]), surface.domain(axis).first),
                             surface.domain(axis).second);
      EXPECT_LT(length(sample.point - surface(u[0], u[1])), tiny) << what;
      const Vector normal = surface.normal(u[0], u[1]), sight = line_of_sight(sample.point, eye);
      EXPECT_LE(std::abs(CGAL::to_double(normal * sight)), tiny * length(normal) * length(sight)) << what;
    }
  }
}

template <class Eye>
Curves expect_silhouettes(const Surface& surface, const Eye& eye, std::size_t closed, std::size_t open,
                          std::size_t singular = 0, const std::string& what = "")
{
  Curves set = SC::silhouettes(surface, eye);
  EXPECT_TRUE(set.is_complete()) << what;
  EXPECT_EQ(set.number_of_closed_curves(), closed) << what;
  EXPECT_EQ(set.number_of_open_curves(), open) << what;
  EXPECT_TRUE(set.points().empty()) << what;
  EXPECT_EQ(set.singular_points().size(), singular) << what;
  check_points(surface, eye, set, what);
  return set;
}

// All points are in a plane.
void expect_in_plane(const Curves& set, const K::Plane_3& plane)
{
  for (const SC::Surface_curve& curve : set.curves())
    for (const auto& sample : set.polyline(curve, 1e-3))
      EXPECT_LT(CGAL::to_double(CGAL::squared_distance(plane, sample.point)), tiny * tiny);
}

const Point center(1, 2, 3);
const Surface sphere = SC::sphere_surface<K>(center, 2), torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1);

// x to y to z to x, and a translation
const K::Aff_transformation_3 quarter_turn(0, 0, 1, 2, 1, 0, 0, -1, 0, 1, 0, 5);

Surface random_surface(int degree, int pieces, bool is_rational, std::mt19937& generator)
{
  std::uniform_int_distribution<int> offset(-40, 40), weight(2, 5);
  std::vector<Point> points;
  std::vector<Rational> weights, knots(static_cast<std::size_t>(degree), 0);
  for (int i = 0; i < degree + pieces; ++i)
    for (int j = 0; j < degree + pieces; ++j) {
      points.emplace_back(3 * i + Rational(offset(generator), 40), 3 * j + Rational(offset(generator), 40),
                          Rational(offset(generator), 10));
      if (is_rational)
        weights.emplace_back(weight(generator));
    }
  for (int i = 0; i <= pieces; ++i)
    knots.emplace_back(i);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), pieces);
  return Surface({degree, degree}, knots, knots, points, weights);
}

} // namespace

TEST(Silhouettes, sphere)
{
  for (const Vector& direction : {Vector(1, 2, 2), Vector(0, 0, -1), Vector(3, 1, 0), Vector(-5, 1, Rational(1, 7))})
    expect_in_plane(expect_silhouettes(sphere, direction, 1, 0), K::Plane_3(center, direction));
  for (const Vector& direction : {Vector(1, 0, 0), Vector(0, 1, 0)}) {   // meridians that are breaks
    const Curves meridians = expect_silhouettes(sphere, direction, 0, 2);
    expect_in_plane(meridians, K::Plane_3(center, direction));
    EXPECT_EQ(meridians.curves()[0].line->axis, 0);
  }
  // The polar plane of the eye.
  const Vector to_eye(4, 2, 5);
  expect_in_plane(expect_silhouettes(sphere, center + to_eye, 1, 0),
                  K::Plane_3(to_eye.x(), to_eye.y(), to_eye.z(), -(to_eye * (center - CGAL::ORIGIN)) - 4));
  expect_silhouettes(sphere, center + Vector(1, 1, 1), 0, 0);   // from inside
}

// Circles by differentiation of the equation: their curvature, and no torsion, at vertices and along them.
TEST(Silhouettes, curvature_and_torsion)
{
  const SC::Spline_map<2, 3> map(sphere);
  auto [u, v] = SC::unknowns({map.domain(0).first, map.domain(0).second}, {map.domain(1).first, map.domain(1).second});
  // r = 2 at the distance 3: the circle has the squared radius 4 (1 - 4/9)
  for (const auto& [set, squared_curvature] :
       {std::pair(SC::silhouettes(sphere, Vector(1, 2, 2)), Rational(1, 4)),
        std::pair(SC::silhouettes(sphere, center + Vector(2, 1, -2)), Rational(9, 20))}) {
    std::size_t points = 0;
    for (const SC::Surface_curve& curve : set.curves()) {
      for (const auto& sample : set.polyline(curve, 1e-2)) {
        const auto at = SC::curve_differentials(set.system(curve.part), sample.parameters);
        ASSERT_TRUE(at);
        const auto in_space = at->image(map(u, v));
        EXPECT_NEAR(CGAL::to_double(in_space.squared_curvature()), CGAL::to_double(squared_curvature), 1e-9);
        EXPECT_NEAR(CGAL::to_double(*in_space.torsion()), 0, 1e-6);
        ++points;
      }
      for (const SC::Curve_vertex& vertex : set.solutions(curve.part).vertices()) {
        const auto at = SC::curve_differentials(set.system(curve.part), vertex);
        ASSERT_TRUE(at);
        const SC::Mpfr_interval curvature = at->image(map(u, v)).squared_curvature();
        EXPECT_LE(curvature.lower(), squared_curvature);
        EXPECT_GE(curvature.upper(), squared_curvature);
      }
    }
    EXPECT_GT(points, 10u);
  }
}

TEST(Silhouettes, torus)
{
  expect_silhouettes(torus, Vector(1, 2, 3), 2, 0);
  expect_silhouettes(torus, Vector(3, 2, 1), 2, 0);
  const Curves equators = expect_silhouettes(torus, Vector(0, 0, 1), 2, 0);
  expect_in_plane(equators, K::Plane_3(0, 0, 1, 0));
  // At a right angle to the axis two circles of latitude cross two small circles in four points.
  for (const Vector& direction : {Vector(1, 0, 0), Vector(3, 1, 0)})
    expect_silhouettes(torus, direction, 4, 0, 4);
  expect_silhouettes(torus, Point(10, 3, 2), 2, 0);
  expect_silhouettes(torus, Point(10, 3, 1), 2, 0, 2);            // the plane of the eye touches along a circle
  expect_silhouettes(torus, Point(0, 0, Rational(1, 2)), 2, 0);   // from the hole
}

TEST(Silhouettes, cylinders_and_cones)
{
  expect_silhouettes(SC::cylinder_surface<K>(Point(0, 0, 0), 1, 2), Vector(1, 2, 3), 0, 2);
  expect_silhouettes(SC::cylinder_surface<K>(Point(0, 0, 0), 1, 2), Point(3, 1, 7), 0, 2);
  const Surface cone = SC::cone_surface<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(1, 0, 2));
  expect_silhouettes(cone, Vector(1, 2, 0), 0, 1);   // two lines through the apex
  expect_silhouettes(cone, Vector(0, 1, 9), 0, 0);
  const Curves along_axis = SC::silhouettes(SC::cylinder_surface<K>(Point(0, 0, 0), 1, 2), Vector(0, 0, 1));
  EXPECT_FALSE(along_axis.is_complete());   // all of it
  EXPECT_FALSE(along_axis.undecided().empty());
}

TEST(Silhouettes, random_patches)
{
  std::mt19937 generator(5);
  std::size_t curves = 0;
  for (int round = 0; round < 12; ++round) {
    const int pieces = round % 4 == 3 ? 3 : 1;
    const Surface patch = random_surface(pieces == 1 ? 3 : 2, pieces, round % 2 == 1, generator);
    const Vector direction(round % 3 - 1, 2, Rational(round, 5) - 1);
    const Curves set = SC::silhouettes(patch, direction);
    ASSERT_TRUE(set.is_complete()) << round;
    check_points(patch, direction, set, std::to_string(round));
    curves += set.curves().size();
    // Each curve that is not closed has two ends on the edges, where the equation changes its sign.
    std::size_t ends = 0;
    constexpr int n = 60;
    for (const int axis : {0, 1})
      for (const int side : {0, 1}) {
        const auto sign = [&](int i) {
          const Rational end(side * pieces), t(Rational(i * pieces) / n);
          return CGAL::sign(direction * (axis == 0 ? patch.normal(end, t) : patch.normal(t, end)));
        };
        for (int i = 0; i < n; ++i)
          ends += sign(i) != sign(i + 1);
      }
    EXPECT_EQ(2 * set.number_of_open_curves(), ends) << round;
    // Nothing depends on the place and the parameters.
    const Curves turned =
        SC::silhouettes(patch.transformed(quarter_turn).transposed(), direction.transform(quarter_turn));
    EXPECT_EQ(turned.number_of_closed_curves(), set.number_of_closed_curves()) << round;
    EXPECT_EQ(turned.number_of_open_curves(), set.number_of_open_curves()) << round;
  }
  EXPECT_GT(curves, 12u);
}

TEST(Silhouettes, breaks_and_creases)
{
  std::mt19937 generator(7);
  const Surface patch = random_surface(3, 1, false, generator);
  const Vector direction(1, 2, 0);
  const Curves curves = SC::silhouettes(patch, direction),
               in_pieces = SC::silhouettes(patch.with_knot(0, Rational(1, 3)).with_knot(1, Rational(1, 2)), direction);
  EXPECT_TRUE(curves.is_complete() && in_pieces.is_complete());
  EXPECT_FALSE(curves.curves().empty());
  EXPECT_EQ(in_pieces.number_of_open_curves(), curves.number_of_open_curves());
  EXPECT_EQ(in_pieces.number_of_closed_curves(), curves.number_of_closed_curves());
  // A roof with a round top over each half: the crease cuts the domain in two.
  const Surface roofs(
      {2, 1}, {0, 0, 0, 1, 1, 2, 2, 2}, {0, 0, 1, 1},
      {{0, 0, 0}, {0, 4, 0}, {1, 0, 2}, {1, 4, 2}, {2, 0, 0}, {2, 4, 0}, {3, 0, 2}, {3, 4, 2}, {4, 0, 0}, {4, 4, 0}});
  EXPECT_EQ(expect_silhouettes(roofs, Vector(1, 0, 0), 0, 2).curves()[1].part, 1u);
}

TEST(Silhouettes, bad_input)
{
  EXPECT_THROW(SC::silhouettes(sphere, Vector(0, 0, 0)), SC::Invalid_input);
  EXPECT_THROW(SC::silhouettes(sphere, Vector(0, 0, 1), {.tolerance = -1}), SC::Invalid_input);
  const Curves set = SC::silhouettes(sphere, Vector(1, 2, 2));
  EXPECT_THROW(set.polyline(set.curves()[0], 0), SC::Invalid_input);
}

} // namespace silhouettes_test
