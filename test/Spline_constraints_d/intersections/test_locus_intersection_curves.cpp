// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of offset surfaces: planes moved along their normal, the offset of a paraboloid in a plane, with a surface and
// with another offset; circles of known size, points at known distances. Offsets that are rational, exactly, and their
// contact curves.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Offset_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/rational_offset.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_implicit.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/locus_intersection_curves.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace locus_intersection_curves_test {

namespace {

// z = height, above the square [-2,2]^2.
Surface square_patch(const Rational& height)
{
  const std::vector<Point> corners{{-2, -2, height}, {-2, 2, height}, {2, -2, height}, {2, 2, height}};
  return Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, corners);
}

// z = x^2 + y^2, above the square [-1,1]^2.
Surface paraboloid()
{
  std::vector<Point> points;
  for (const int u : {-1, 0, 1})
    for (const int v : {-1, 0, 1})
      points.emplace_back(u, v, (u == 0 ? -1 : 1) + (v == 0 ? -1 : 1));
  return Surface({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, points);
}

// Each point of the curves satisfies check(x, y, z, unknowns).
template <class Curves, class Check>
void check_points(const Curves& set, std::size_t closed, std::size_t open, const Check& check)
{
  EXPECT_TRUE(set.is_complete());
  EXPECT_EQ(set.number_of_closed_curves(), closed);
  EXPECT_EQ(set.number_of_open_curves(), open);
  for (const SC::Surface_curve& curve : set.curves()) {
    const auto samples = set.polyline(curve, 1e-2);
    EXPECT_GE(samples.size(), 8u);
    for (const auto& sample : samples)
      check(CGAL::to_double(sample.point.x()), CGAL::to_double(sample.point.y()), CGAL::to_double(sample.point.z()),
            sample.parameters);
  }
}

const auto ball = SC::to_implicit(K::Sphere_3(Point(0, 0, 0), Rational(4)));   // of radius 2

} // namespace

TEST(Locus_intersection_curves, moved_plane_and_sphere)
{
  const auto on_circle = [](double x, double y, double z, const std::vector<double>&) {
    EXPECT_NEAR(z, 1, 1e-12);
    EXPECT_NEAR(x * x + y * y, 3, 1e-11);
  };
  check_points(SC::intersection_curves(SC::Offset_surface_3(square_patch(0), 1), ball), 1, 0, on_circle);
  check_points(SC::intersection_curves(ball, SC::Offset_surface_3(square_patch(Rational(3, 2)), Rational(-1, 2))), 1, 0,
               on_circle);
  const auto apart = SC::intersection_curves(SC::Offset_surface_3(square_patch(0), 3), ball);
  EXPECT_TRUE(apart.is_complete());
  EXPECT_TRUE(apart.curves().empty());
}

// z = x^2, above the square [-1,1]^2.
static Surface gutter()
{
  std::vector<Point> points;
  for (const int u : {-1, 0, 1})
    for (const int v : {-1, 1})
      points.emplace_back(u, v, u == 0 ? -1 : 1);
  return Surface({2, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}, points);
}

// The offset of a gutter lies on a plane along a line, which is not proved, as the offset is not rational.
TEST(Locus_intersection_curves, contact_curves_are_undecided)
{
  const SC::Offset_surface_3 offset(gutter(), Rational(-1, 2));
  EXPECT_FALSE(SC::rational_offset(offset));
  auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto contact =
      SC::intersection_curves(offset, SC::Implicit_surface_3(z == Rational(-1, 2)), {.tolerance = 1e-2});
  EXPECT_FALSE(contact.is_complete());
  EXPECT_FALSE(contact.undecided().empty());
}

// All points along one curve, where the surfaces touch, satisfy check(x, y, z, unknowns).
template <class Curves, class Check>
void check_contact(const Curves& set, bool is_closed, const Check& check)
{
  EXPECT_TRUE(set.is_complete());
  EXPECT_TRUE(set.singular_points().empty() && set.points().empty());
  ASSERT_EQ(set.curves().size(), 1u);
  EXPECT_EQ(set.curves()[0].is_closed, is_closed);
  EXPECT_EQ(set.curves()[0].multiplicity, 2);
  const auto samples = set.polyline(set.curves()[0], 1e-2);
  EXPECT_GE(samples.size(), 2u);
  for (const auto& sample : samples)
    check(CGAL::to_double(sample.point.x()), CGAL::to_double(sample.point.y()), CGAL::to_double(sample.point.z()),
          sample.parameters);
}

// Offsets are exactly what their name says, on the side of the normal.
TEST(Locus_intersection_curves, rational_offsets)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), Rational(1)),
                pipe = SC::cylinder_surface<K>(Point(0, 0, 0), Rational(1), Rational(2)),
                torus = SC::torus_surface<K>(Point(1, 0, 2), Rational(3), Rational(1)),
                zone = sphere.restricted(1, Rational(1, 2), Rational(3, 2)),
                cone = SC::cone_surface<K>(Point(0, 0, 0), Vector(0, 0, 1), Point(3, 0, 4))
                           .restricted(1, Rational(1, 2), 1);
  // Enneper's minimal surface (3u - u^3 + 3uv^2, 3v - v^3 + 3u^2v, 3u^2 - 3v^2) on [0,1]^2; its normal has the length 9
  // (1 + u^2 + v^2)^2.
  const SC::Bspline_function<Rational> u({1, 0}, {{0, 0, 1, 1}, {0, 1}}, {0, 1}),
      v({0, 1}, {{0, 1}, {0, 0, 1, 1}}, {0, 1}), one({0, 0}, {{0, 1}, {0, 1}}, {1});
  const Rational three(3);
  const Surface enneper =
      Surface::from_homogeneous_coordinates({u * three - u * u * u + u * v * v * three,
                                             v * three - v * v * v + u * u * v * three, u * u * three - v * v * three},
                                            one);
  for (const Surface& surface :
       {square_patch(1), pipe, zone, torus, cone, enneper, enneper.with_knot(0, Rational(1, 3))})
    for (const Rational& distance : {Rational(2), Rational(-1, 3)}) {
      const auto offset = SC::rational_offset(SC::Offset_surface_3(surface, distance));
      ASSERT_TRUE(offset);
      EXPECT_EQ(offset->domain(0), surface.domain(0));
      EXPECT_EQ(offset->domain(1), surface.domain(1));
      for (const int i : {1, 3, 6})
        for (const int j : {0, 2, 7}) {
          const auto at = [&](int axis, int k) {
            return Rational(surface.domain(axis).first +
                            (surface.domain(axis).second - surface.domain(axis).first) * k / 7);
          };
          const Vector step = (*offset)(at(0, i), at(1, j)) - surface(at(0, i), at(1, j)),
                       normal = surface.normal(at(0, i), at(1, j));
          EXPECT_EQ(step.squared_length(), Rational(distance * distance));
          EXPECT_EQ(CGAL::cross_product(step, normal), Vector(0, 0, 0));
          EXPECT_GT(Rational(distance * (step * normal)), 0);
        }
    }
  EXPECT_TRUE(*SC::rational_offset(SC::Offset_surface_3(zone, 2)) ==
              SC::sphere_surface<K>(Point(0, 0, 0), Rational(3)).restricted(1, Rational(1, 2), Rational(3, 2)));
  EXPECT_TRUE(*SC::rational_offset(SC::Offset_surface_3(torus, 1)) ==
              SC::torus_surface<K>(Point(1, 0, 2), Rational(3), Rational(2)));
  EXPECT_EQ(SC::rational_offset(SC::Offset_surface_3(torus, 1))->degree(1), 2);
  // A plane whose unit normal is not rational, and a surface whose normal has no polynomial length.
  EXPECT_FALSE(SC::rational_offset(
      SC::Offset_surface_3(SC::plane_patch<K>(Point(0, 0, 0), Vector(1, 1, 0), Vector(0, 0, 1)), 1)));
  EXPECT_FALSE(SC::rational_offset(SC::Offset_surface_3(paraboloid(), 1)));
}

TEST(Locus_intersection_curves, contact_curves_of_rational_offsets)
{
  // of radius 2
  const SC::Offset_surface_3 pipe(SC::cylinder_surface<K>(Point(0, 0, 0), Rational(1), Rational(2)), 1);
  check_contact(SC::intersection_curves(SC::to_implicit(K::Sphere_3(Point(0, 0, 1), Rational(4))), pipe), true,
                [](double x, double y, double z, const std::vector<double>& u) {
                  EXPECT_NEAR(x * x + y * y, 4, 1e-11);
                  EXPECT_NEAR(z, 1, 1e-12);
                  EXPECT_NEAR(u[1], 0.5, 1e-12);
                });
  const auto on_line = [](double x, double y, double, const std::vector<double>& u) {
    EXPECT_NEAR(x, 1.6, 1e-12);
    EXPECT_NEAR(y, 1.2, 1e-12);
    EXPECT_NEAR(u[0], 1 / 3., 1e-12);
  };
  auto [x, y, z] = SC::unknowns({-9, 9}, {-9, 9}, {-9, 9});
  check_contact(SC::intersection_curves(pipe, SC::Implicit_surface_3(4 * x + 3 * y == 10)), false, on_line);
  // One pipe with the radius 3 next to the other one.
  check_contact(SC::intersection_curves(
                    pipe, SC::Offset_surface_3(SC::cylinder_surface<K>(Point(4, 3, 0), Rational(2), Rational(3)), 1)),
                false, on_line);
  // Along a break of a torus.
  const SC::Offset_surface_3 torus(SC::torus_surface<K>(Point(0, 0, 0), Rational(3), Rational(1)), Rational(1, 2));
  check_contact(SC::intersection_curves(torus, SC::Implicit_surface_3(2 * z == 3)), true,
                [](double x, double y, double z, const std::vector<double>&) {
                  EXPECT_NEAR(x * x + y * y, 9, 1e-11);
                  EXPECT_NEAR(z, 1.5, 1e-12);
                });
  // A plane under the gutter: all four parameters are unknowns.
  check_contact(SC::intersection_curves(SC::Offset_surface_3(square_patch(-1), 1), gutter()), false,
                [](double x, double, double z, const std::vector<double>& u) {
                  ASSERT_EQ(u.size(), 4u);
                  EXPECT_NEAR(x, 0, 1e-12);
                  EXPECT_NEAR(z, 0, 1e-12);
                  EXPECT_NEAR(u[2], 0.5, 1e-12);
                });
}

TEST(Locus_intersection_curves, offset_of_a_paraboloid)
{
  const SC::Offset_surface_3 offset(paraboloid(), Rational(1, 2));
  // from the foot (2 u - 1, 2 v - 1)
  const auto is_at_distance = [](double x, double y, double z, const std::vector<double>& u) {
    const double fx = 2 * u[0] - 1, fy = 2 * u[1] - 1, dx = x - fx, dy = y - fy, dz = z - fx * fx - fy * fy;
    EXPECT_NEAR(dx * dx + dy * dy + dz * dz, 0.25, 1e-11);
    EXPECT_NEAR(dx + 2 * fx * dz, 0, 1e-11);
    EXPECT_NEAR(dy + 2 * fy * dz, 0, 1e-11);
  };
  // At height 1, above a circle of radius r with r^2 + 1 / (2 sqrt(1 + 4 r^2)) = 1: one closed curve of feet.
  const auto in_plane = SC::intersection_curves(square_patch(1), offset);
  check_points(in_plane, 1, 0, [&](double x, double y, double z, const std::vector<double>& u) {
    EXPECT_NEAR(z, 1, 1e-12);
    is_at_distance(x, y, z, {u[2], u[3]});
  });
}

TEST(Locus_intersection_curves, across_the_seam)
{
  // of radius 2 then, or 0 on the other side
  const SC::Offset_surface_3 pipe(SC::cylinder_surface<K>(Point(0, 0, 0), Rational(1), Rational(2)), 1);
  const auto level = SC::to_implicit(K::Plane_3(0, 0, 1, -1), K::Iso_cuboid_3(-3, -3, -3, 3, 3, 3));
  check_points(SC::intersection_curves(pipe, level), 1, 0,
               [](double x, double y, double z, const std::vector<double>&) {
                 EXPECT_NEAR(z, 1, 1e-12);
                 EXPECT_NEAR(x * x + y * y, 4, 1e-11);
               });
}

TEST(Locus_intersection_curves, two_offsets)
{
  check_points(SC::intersection_curves(SC::Offset_surface_3(square_patch(0), 1),
                                       SC::Offset_surface_3(paraboloid(), Rational(1, 2))),
               1, 0, [](double, double, double z, const std::vector<double>&) { EXPECT_NEAR(z, 1, 1e-11); });
}

TEST(Locus_intersection_curves, what_coincides_is_undecided)
{
  const auto same = SC::intersection_curves(SC::Offset_surface_3(square_patch(0), 1), square_patch(1),
                                            {.tolerance = 1e-3, .node_limit = 3000});
  EXPECT_FALSE(same.is_complete());
  EXPECT_FALSE(same.undecided().empty());
}

} // namespace locus_intersection_curves_test
