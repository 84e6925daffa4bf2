// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of offset surfaces: planes moved along their normal, the offset of a paraboloid in a plane, with a surface and with another offset; circles of known size, points at known distances.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/Offset_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/to_implicit.h>
#include <CGAL/Spline_constraints_d/operations/locus_intersection_curves.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

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
      check(CGAL::to_double(sample.point.x()), CGAL::to_double(sample.point.y()), CGAL::to_double(sample.point.z()), sample.parameters);
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
  check_points(SC::intersection_curves(ball, SC::Offset_surface_3(square_patch(Rational(3, 2)), Rational(-1, 2))), 1, 0, on_circle);
  const auto apart = SC::intersection_curves(SC::Offset_surface_3(square_patch(0), 3), ball);
  EXPECT_TRUE(apart.is_complete());
  EXPECT_TRUE(apart.curves().empty());
}

// The offset of a gutter lies on a plane along a line, which is not proved.
TEST(Locus_intersection_curves, contact_curves_are_undecided)
{
  std::vector<Point> points;
  for (const int u : {-1, 0, 1})
    for (const int v : {-1, 1})
      points.emplace_back(u, v, u == 0 ? -1 : 1);
  const Surface gutter({2, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}, points);
  auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto contact = SC::intersection_curves(SC::Offset_surface_3(gutter, Rational(-1, 2)), SC::Implicit_surface_3(z == Rational(-1, 2)), {.tolerance = 1e-2});
  EXPECT_FALSE(contact.is_complete());
  EXPECT_FALSE(contact.undecided().empty());
}

TEST(Locus_intersection_curves, offset_of_a_paraboloid)
{
  const SC::Offset_surface_3 offset(paraboloid(), Rational(1, 2));
  const auto is_at_distance = [](double x, double y, double z, const std::vector<double>& u) {   // from the foot (2 u - 1, 2 v - 1)
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
  const SC::Offset_surface_3 pipe(SC::cylinder_surface<K>(Point(0, 0, 0), Rational(1), Rational(2)), 1);   // of radius 2 then, or 0 on the other side
  const auto level = SC::to_implicit(K::Plane_3(0, 0, 1, -1), K::Iso_cuboid_3(-3, -3, -3, 3, 3, 3));
  check_points(SC::intersection_curves(pipe, level), 1, 0, [](double x, double y, double z, const std::vector<double>&) {
    EXPECT_NEAR(z, 1, 1e-12);
    EXPECT_NEAR(x * x + y * y, 4, 1e-11);
  });
}

TEST(Locus_intersection_curves, two_offsets)
{
  check_points(SC::intersection_curves(SC::Offset_surface_3(square_patch(0), 1), SC::Offset_surface_3(paraboloid(), Rational(1, 2))), 1, 0,
               [](double, double, double z, const std::vector<double>&) { EXPECT_NEAR(z, 1, 1e-11); });
}

TEST(Locus_intersection_curves, what_coincides_is_undecided)
{
  const auto same = SC::intersection_curves(SC::Offset_surface_3(square_patch(0), 1), square_patch(1), {.tolerance = 1e-3, .node_limit = 3000});
  EXPECT_FALSE(same.is_complete());
  EXPECT_FALSE(same.undecided().empty());
}
