// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parabolic lines: of graphs by formula, circles of tori, none of spheres and saddles, projective images, inserted
// knots, flat points, developable surfaces.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/parabolic_lines.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace parabolic_lines_test {

namespace {

using Function = SC::Bspline_function<Rational>;
using Curves = SC::Surface_curves_3<K>;

// (x, y, f(x,y)) over [-1,1]^2.
Surface graph(const std::function<Function(const Function&, const Function&)>& f)
{
  const std::vector<Rational> knots{-1, -1, 1, 1};
  const Function x({1, 1}, {knots, knots}, {-1, -1, 1, 1}), y({1, 1}, {knots, knots}, {-1, 1, -1, 1});
  return Surface::from_homogeneous_coordinates({x, y, f(x, y)}, x * Rational(0) + Rational(1));
}

Curves expect_lines(const Surface& surface, std::size_t closed, std::size_t open, std::size_t singular,
                    const std::function<void(const Point&)>& check = {})
{
  Curves set = SC::parabolic_lines(surface);
  EXPECT_TRUE(set.is_complete());
  EXPECT_EQ(set.number_of_closed_curves(), closed);
  EXPECT_EQ(set.number_of_open_curves(), open);
  EXPECT_EQ(set.singular_points().size(), singular);
  for (const SC::Surface_curve& curve : set.curves())
    for (const auto& sample : set.polyline(curve, 1e-2))
      if (check)
        check(sample.point);
  return set;
}

// The same curves in space after inserting knots.
void expect_lines_with_knots(const Surface& surface, std::size_t closed, std::size_t open,
                             const std::function<void(const Point&)>& check)
{
  expect_lines(surface, closed, open, 0, check);
  expect_lines(surface.with_knot(0, Rational(1, 3)).with_knot(1, Rational(2, 5)), closed, open, 0, check);
}

} // namespace

TEST(Parabolic_lines, graphs)
{
  expect_lines_with_knots(graph([](const Function& x, const Function& y) { return x * x * x + y * y; }), 0, 1,
                          [](const Point& p) { EXPECT_NEAR(CGAL::to_double(p.x()), 0, 1e-9); });
  const Surface bump = graph([](const Function& x, const Function& y) {
    return x * x * x * x * Rational(1, 12) - x * x * Rational(1, 8) + y * y * y * y * Rational(1, 12) -
        y * y * Rational(1, 8);
  });
  // z_xx z_yy = (x^2 - 1/4) (y^2 - 1/4): four lines of three arcs each.
  const Curves lines = SC::parabolic_lines(bump);
  EXPECT_TRUE(lines.is_complete());
  EXPECT_EQ(lines.singular_points().size(), 4u);
  EXPECT_EQ(lines.number_of_open_curves(), 12u);
  EXPECT_EQ(lines.number_of_closed_curves(), 0u);
  for (const SC::Curve_vertex& vertex : lines.singular_points())
    for (const auto& [lower, upper] : vertex.box) {
      EXPECT_EQ(lower, upper);
      EXPECT_EQ(CGAL::abs(lower), Rational(1, 2));
    }
}

TEST(Parabolic_lines, closed_curve)
{
  // z = g(r) with r = x^2 + y^2: where g' (g' + 2 r g'') = 0.
  expect_lines_with_knots(graph([](const Function& x, const Function& y) {
                            const Function r = x * x + y * y;
                            return r - r * r * Rational(1, 5);
                          }),
                          1, 0, [](const Point& p) {
                            EXPECT_NEAR(std::hypot(CGAL::to_double(p.x()), CGAL::to_double(p.y())), std::sqrt(5.0 / 6),
                                        1e-9);
                          });
}

TEST(Parabolic_lines, torus)
{
  const auto is_top_or_bottom = [](const Point& p) {
    EXPECT_NEAR(std::hypot(CGAL::to_double(p.x()), CGAL::to_double(p.y())), 3, 1e-9);
    EXPECT_NEAR(std::abs(CGAL::to_double(p.z())), 1, 1e-9);
  };
  const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1);
  const Curves circles = expect_lines(torus, 2, 0, 0, is_top_or_bottom);
  for (const SC::Surface_curve& circle : circles.curves())
    EXPECT_TRUE(circle.line);   // along a break
  // A quarter turn of the upper half of a small circle that begins elsewhere.
  const Surface part =
      torus.restricted(0, Rational(1, 3), Rational(4, 3)).restricted(1, Rational(1, 4), Rational(7, 4));
  expect_lines(part, 0, 1, 0, is_top_or_bottom);
}

TEST(Parabolic_lines, none)
{
  expect_lines(SC::sphere_surface<K>(Point(1, 2, 3), 2), 0, 0, 0);
  expect_lines(graph([](const Function& x, const Function& y) { return x * x + y * y; }), 0, 0, 0);
  expect_lines(graph([](const Function& x, const Function& y) { return x * y; }), 0, 0, 0);
}

// The curvature of a monkey saddle is zero in one point.
TEST(Parabolic_lines, flat_point)
{
  const Curves set = expect_lines(
      graph([](const Function& x, const Function& y) { return x * x * x - x * y * y * Rational(3); }), 0, 0, 1);
  for (const auto& [lower, upper] : set.singular_points()[0].box)
    EXPECT_TRUE(lower == 0 && upper == 0);
}

// Projective maps keep asymptotic directions, and so parabolic lines.
TEST(Parabolic_lines, projective_image)
{
  const Surface surface = graph([](const Function& x, const Function& y) { return x * x * x + y * y + x * x * y; });
  const auto [x, y, z] = surface.homogeneous_coordinates();
  const Surface image =
      Surface::from_homogeneous_coordinates({x, y + z, z}, x * Rational(1, 4) + z * Rational(1, 8) + Rational(2));
  const Curves set = SC::parabolic_lines(surface), images = SC::parabolic_lines(image);
  EXPECT_TRUE(set.is_complete() && images.is_complete());
  EXPECT_FALSE(set.curves().empty());
  EXPECT_EQ(set.number_of_open_curves(), images.number_of_open_curves());
  EXPECT_EQ(set.number_of_closed_curves(), images.number_of_closed_curves());
  for (const SC::Surface_curve& curve : images.curves())
    for (const auto& sample : images.polyline(curve, 1e-2)) {
      const double u = sample.parameters[0], v = sample.parameters[1];
      EXPECT_NEAR((6 * u + 2 * v) * 2 - 4 * u * u, 0, 1e-9);
    }
}

TEST(Parabolic_lines, undecided)
{
  const Curves set = SC::parabolic_lines(SC::cylinder_surface<K>(Point(0, 0, 0), 1, 2));
  EXPECT_FALSE(set.is_complete());
  EXPECT_FALSE(set.undecided().empty());
  EXPECT_TRUE(set.curves().empty());
}

TEST(Parabolic_lines, bad_input)
{
  EXPECT_THROW(
      SC::parabolic_lines(graph([](const Function& x, const Function& y) { return x * y; }), {.tolerance = -1}),
      SC::Invalid_input);
}

} // namespace parabolic_lines_test
