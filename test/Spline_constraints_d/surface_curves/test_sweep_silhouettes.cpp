// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Silhouettes of the envelopes of moving surfaces: of spheres, which touch known tubes, along lines, an arc and a path
// with a corner, growing ones, and rotations.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/sweep_silhouettes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace sweep_silhouettes_test {

using Curve = SC::Bspline_curve_3<K>;
using Curves = SC::Surface_curves_3<K>;

namespace {

constexpr double tiny = 1e-9;

// Its poles are in no special position.
const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), Point(Rational(2, 7), Rational(3, 7), Rational(6, 7)));

Curve line(const Point& begin, const Point& end) { return Curve(1, {0, 0, 1, 1}, {begin, end}); }

// The silhouettes from one point, complete.
Curves silhouettes(const SC::Affine_motion<K>& motion, const Point& eye, std::size_t closed, std::size_t open)
{
  const auto sets = SC::sweep_silhouettes(sphere, motion, {eye});
  EXPECT_EQ(sets.size(), 1u);
  EXPECT_TRUE(sets[0].is_complete());
  EXPECT_EQ(sets[0].number_of_closed_curves(), closed);
  EXPECT_EQ(sets[0].number_of_open_curves(), open);
  return sets[0];
}

} // namespace

TEST(Sweep_silhouettes, cylinder)
{
  // The unit sphere along the z-axis: two lines of the cylinder in tangent planes through the eye.
  const Point eye(3, 0, 1);
  const Curves set = silhouettes({line(Point(0, 0, 0), Point(0, 0, 2)), {}}, eye, 0, 2);
  for (const SC::Surface_curve& curve : set.curves())
    for (const auto& sample : set.polyline(curve, 1e-2)) {
      EXPECT_NEAR(CGAL::to_double(sample.point.x()), 1.0 / 3, tiny);
      EXPECT_NEAR(std::abs(CGAL::to_double(sample.point.y())), std::sqrt(8.0) / 3, tiny);
      EXPECT_NEAR(CGAL::to_double(sample.point.z()), 2 * sample.parameters[2], tiny);
    }
  // from inside of the tube
  silhouettes({line(Point(0, 0, 0), Point(0, 0, 2)), {}}, Point(Rational(1, 3), Rational(1, 5), 9), 0, 0);
}

TEST(Sweep_silhouettes, bent_paths)
{
  // A parabola: points at a right angle to the path, and to the line of sight.
  const Curve parabola(2, {0, 0, 0, 1, 1, 1}, {Point(-3, 0, 0), Point(0, 4, 0), Point(3, 0, 0)});
  const Point eye(1, -2, 9);
  const Curves set = silhouettes({parabola, {}}, eye, 0, 2);
  for (const SC::Surface_curve& curve : set.curves())
    for (const auto& sample : set.polyline(curve, 1e-2)) {
      const Rational t(sample.parameters[2]);
      const Vector radius = sample.point - parabola(t);
      EXPECT_NEAR(length(radius), 1, tiny);
      EXPECT_NEAR(CGAL::to_double(radius * parabola.derivative(t, 1)), 0, 1e2 * tiny);
      EXPECT_NEAR(CGAL::to_double(radius * (eye - sample.point)), 0, 1e2 * tiny);
    }
  // At a corner all curves end.
  silhouettes({Curve(1, {0, 0, 1, 2, 2}, {Point(-3, 0, 0), Point(0, 3, 0), Point(3, 0, 0)}), {}}, eye, 0, 4);
}

TEST(Sweep_silhouettes, growing_and_turning)
{
  // A sphere that grows from the radius 1 to 2 while it moves by 3: a cone with the half angle of the sine 1/3.
  const auto scaled = [](int i) {
    return line(Point(i == 0, i == 1, i == 2), Point(2 * (i == 0), 2 * (i == 1), 2 * (i == 2)));
  };
  const SC::Affine_motion<K> growth{line(Point(0, 0, 0), Point(0, 0, 3)), {scaled(0), scaled(1), scaled(2)}};
  const Point eye(9, 1, 1), apex(0, 0, -3);
  const Curves cone = silhouettes(growth, eye, 0, 2);
  for (const SC::Surface_curve& curve : cone.curves())
    for (const auto& sample : cone.polyline(curve, 1e-2)) {
      const Vector from_apex = sample.point - apex;
      EXPECT_NEAR(CGAL::to_double(from_apex.z()) / length(from_apex), std::sqrt(8.0) / 3, tiny);
    }
  // Sheared, the sphere is an ellipsoid, of which the cofactors give the normals: its silhouette on the way along x is
  // in the polar plane of the eye.
  const auto fixed = [](const Point& p) { return line(p, p); };
  const SC::Affine_motion<K> shear{line(Point(0, 0, 0), Point(4, 0, 0)),
                                   {fixed(Point(1, 0, 0)), fixed(Point(0, 1, 0)), fixed(Point(0, 1, 2))}};
  const Point beside(2, 5, 3);
  const Curves tube = silhouettes(shear, beside, 0, 2);
  for (const SC::Surface_curve& curve : tube.curves())
    for (const auto& sample : tube.polyline(curve, 1e-2)) {   // on the cylinder (y - z/2)^2 + (z/2)^2 = 1
      const double y = CGAL::to_double(sample.point.y()), z = CGAL::to_double(sample.point.z());
      EXPECT_NEAR((y - z / 2) * (y - z / 2) + z * z / 4, 1, tiny);
      EXPECT_NEAR((2 * y - z) * (5 - y) + (z - y) * (3 - z), 0, 1e2 * tiny);   // tangent to the line of sight
    }
}

TEST(Sweep_silhouettes, bad_input)
{
  const Curve path = line(Point(0, 0, 0), Point(0, 0, 2)),
              other = Curve(1, {0, 0, 2, 2}, {Point(1, 0, 0), Point(1, 0, 0)});
  EXPECT_THROW(SC::sweep_silhouettes(sphere, {path, {path}}, {Point(3, 0, 0)}), SC::Invalid_input);
  EXPECT_THROW(SC::sweep_silhouettes(sphere, {path, {path, path, other}}, {Point(3, 0, 0)}), SC::Invalid_input);
  EXPECT_THROW(SC::sweep_silhouettes(sphere, {path, {}}, {Point(3, 0, 0)}, {.tolerance = -1}), SC::Invalid_input);
  EXPECT_TRUE(SC::sweep_silhouettes(sphere, {path, {}}, {}).empty());
}

} // namespace sweep_silhouettes_test
