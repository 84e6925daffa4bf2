// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Equations of curves and surfaces: known ones up to a factor, random ones at points that were not used, and those that
// do not exist.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/implicitization.h>

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

namespace implicitization_test {

using Curve = SC::Bspline_curve_2<K>;
using Point_2 = K::Point_2;
using Polynomial = SC::Power_polynomial;

const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1), z = Polynomial::variable(2);

Polynomial constant(const Rational& c) { return Polynomial(c); }

template <class Equation>
void expect_multiple_of(const Equation& equation, const Polynomial& f)
{
  ASSERT_TRUE(equation);
  const Polynomial& own = equation->polynomial();
  const Rational factor = own.terms().begin()->second / f.terms().begin()->second;
  EXPECT_EQ(own, constant(factor) * f) << own;
}

TEST(Implicitization, KnownCurves)
{
  const auto parabola = SC::implicitization(Curve(2, {0, 0, 0, 1, 1, 1}, {{-1, 1}, {0, -1}, {1, 1}}));
  EXPECT_EQ(parabola.least_degree(), 2);
  EXPECT_TRUE(parabola.is_complete());
  expect_multiple_of(parabola.equation(), y - x * x);
  const auto circle = SC::implicitization(K::Circle_2(Point_2(1, 2), Rational(9)));
  expect_multiple_of(circle.equation(), pow(x - constant(1), 2) + pow(y - constant(2), 2) - constant(9));
  EXPECT_LE(circle.equation()->box()[0].first, -2);
  EXPECT_GE(circle.equation()->box()[0].second, 4);
  // (t^2 - 1, t^3 - t), the cubic y^2 = x^2 (x + 1) with a node, in two pieces
  const Curve node =
      Curve(3, {-2, -2, -2, -2, 2, 2, 2, 2},
            {{3, -6}, {-Rational(7) / 3, Rational(26) / 3}, {-Rational(7) / 3, -Rational(26) / 3}, {3, 6}})
          .with_knot(1);
  const auto cubic = SC::implicitization(node);
  EXPECT_EQ(cubic.least_degree(), 3);
  expect_multiple_of(cubic.equation(), y * y - x * x * (x + constant(1)));
  // a segment of degree two, and back
  const auto line = SC::implicitization(Curve(2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {3, 6}, {2, 4}}));
  EXPECT_EQ(line.least_degree(), 1);
  expect_multiple_of(line.equation(), y - constant(2) * x);
  // the sides of a triangle
  const auto sides = SC::implicitization(Curve(1, {0, 0, 1, 2, 3, 3}, {{0, 0}, {1, 0}, {0, 1}, {0, 0}}));
  EXPECT_EQ(sides.least_degree(), 3);
  expect_multiple_of(sides.equation(), x * y * (x + y - constant(1)));
}

TEST(Implicitization, KnownSurfaces)
{
  expect_multiple_of(SC::implicitization(SC::torus_surface<K>(Point(0, 0, 0), 3, 1)).equation(),
                     pow(x * x + y * y + z * z + constant(8), 2) - constant(36) * (x * x + y * y));
  expect_multiple_of(SC::implicitization(K::Sphere_3(Point(0, 0, 1), Rational(4))).equation(),
                     x * x + y * y + z * z - constant(2) * z - constant(3));
  const Surface saddle({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}});
  const auto quadric = SC::implicitization(saddle);
  EXPECT_EQ(quadric.least_degree(), 2);
  expect_multiple_of(quadric.equation(), z - x * y);
  // a plane has a box with an extent
  const auto plane =
      SC::implicitization(Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 2}, {0, 1, 2}, {1, 0, 2}, {1, 1, 2}}));
  expect_multiple_of(plane.equation(), z - constant(2));
  EXPECT_LT(plane.equation()->box()[2].first, plane.equation()->box()[2].second);
}

// Curves of degree n have an equation of degree n, generic ones no lower one; values at points beside the equations.
TEST(Implicitization, RandomSplines)
{
  std::mt19937 random(7);
  const auto number = [&] { return Rational(std::uniform_int_distribution(-9, 9)(random)); };
  for (int degree = 1; degree <= 5; ++degree) {
    std::vector<Point_2> points;
    std::vector<Rational> knots(degree + 1, 0);
    knots.insert(knots.end(), degree + 1, 1);
    for (int i = 0; i <= degree; ++i)
      points.emplace_back(number(), number());
    const Curve curve(degree, knots, points);
    const auto found = SC::implicitization(curve);
    ASSERT_TRUE(found.equation());
    EXPECT_EQ(found.least_degree(), degree);
    for (int i = 0; i < 20; ++i) {
      const Point_2 p = curve(Rational(i) / 19);
      EXPECT_EQ((*found.equation())(std::array{p.x(), p.y()}), 0);
      EXPECT_TRUE(found.equation()->has_on(p));
    }
    if (degree > 1) {
      EXPECT_EQ(SC::implicitization(curve, degree - 1).least_degree(), degree);
      EXPECT_FALSE(SC::implicitization(curve, degree - 1).equation());
    }
  }
  // of the degrees (2, 1): an equation of degree 4
  std::vector<Point> points;
  for (int i = 0; i < 6; ++i)
    points.emplace_back(number(), number(), number());
  const Surface surface({2, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}, points);
  const auto found = SC::implicitization(surface);
  ASSERT_TRUE(found.equation());
  EXPECT_EQ(found.least_degree(), 4);
  for (int i = 0; i < 10; ++i)
    EXPECT_TRUE(found.equation()->has_on(surface(Rational(i) / 9, Rational(i * i) / 81)));
}

TEST(Implicitization, NoneAndBadInput)
{
  std::mt19937 random(8);
  const auto number = [&] { return Rational(std::uniform_int_distribution(-9, 9)(random)); };
  std::vector<Point> points;
  for (int i = 0; i < 16; ++i)
    points.emplace_back(number(), number(), number());
  const std::vector<Rational> knots{0, 0, 0, 0, 1, 1, 1, 1};
  const Surface bicubic({3, 3}, knots, knots, points);
  const auto none = SC::implicitization(bicubic); // its equation has degree 18
  EXPECT_TRUE(none.is_complete());
  EXPECT_FALSE(none.equation());
  EXPECT_EQ(none.least_degree(), 7);
  const auto ended = SC::implicitization(bicubic, 20, {.time_limit = 1e-9});
  EXPECT_FALSE(ended.is_complete());
  EXPECT_FALSE(ended.equation());
  EXPECT_EQ(ended.least_degree(), 1);
  EXPECT_THROW(SC::implicitization(bicubic, 0), SC::Invalid_input);
  EXPECT_THROW(SC::implicitization(bicubic, 21), SC::Invalid_input);
  EXPECT_THROW(SC::implicitization(bicubic, 6, {.time_limit = -1}), SC::Invalid_input);
  EXPECT_THROW(SC::implicitization(Curve(1, {0, 0, 1, 1}, {{1, 1}, {1, 1}})), SC::Invalid_input);
  EXPECT_THROW(
      SC::implicitization(Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}})),
      SC::Invalid_input);
}

} // namespace implicitization_test
