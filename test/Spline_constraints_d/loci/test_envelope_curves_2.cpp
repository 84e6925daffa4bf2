// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Envelopes of a curve that moves along another one: circles have circles, and every point has parallel tangents in the
// same direction.

#include "pair_locus_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/loci/envelope_curves_2.h>
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace envelope_curves_2_test {

namespace {

// All points are sums of points of the curves, which have parallel tangents. The number of points.
std::size_t check_points(const Locus& locus, const Curve& c1, const Curve& c2, bool has_same_direction)
{
  std::size_t points = 0;
  visit_points(
      locus, c1, c2,
      [&](const Vector& p, const std::array<Foot, 2>& feet) {
    ++points;
    const Vector &a = feet[0].direction, &b = feet[1].direction;
    for (const int k : {0, 1})
      EXPECT_NEAR(p[k], feet[0].point[k] + feet[1].point[k], 1e-12);
    EXPECT_NEAR(a[0] * b[1] - a[1] * b[0], 0, 1e-11);
    const double cosine = a[0] * b[0] + a[1] * b[1];
    EXPECT_NEAR(has_same_direction ? cosine : std::abs(cosine), 1, 1e-11);
      },
      1e-2, 100);
  return points;
}

} // namespace

TEST(Envelope_curves_2, parabolas)
{
  // y = x^2 and y = 2 x^2: the same slope at x2 = x1 / 2, the sum of the points is (3t, 6t^2), t in [-1/2, 1/2].
  const Curve one = SC::bezier_curve(std::vector<Point>{{-1, 1}, {0, -1}, {1, 1}}),
              two = SC::bezier_curve(std::vector<Point>{{-1, 2}, {0, -2}, {1, 2}});
  const Locus locus = SC::envelope_curves(one, two);
  EXPECT_TRUE(locus.is_complete()) << locus;
  ASSERT_EQ(locus.curves().size(), 1u);
  EXPECT_EQ(locus.number_of_open_curves(), 1u);
  EXPECT_GT(check_points(locus, one, two, true), 10u);
  for (const auto& sample : locus.polyline(locus.curves()[0], 1e-3, 10)) {
    const double x = CGAL::to_double(sample.point.x());
    EXPECT_NEAR(CGAL::to_double(sample.point.y()), 2 * x * x / 3, 1e-13);
    EXPECT_LE(std::abs(x), 1.5 + 1e-13);
  }
}

// The slope of y = x^2 is that of y = x + x^3 where u = (1 + 3 v^2) / 2, so that du/dv = 3v and d^2u/dv^2 = 3; and the
// sums of circles have the curvature of one with the sum of the radii.
TEST(Envelope_curves_2, derivatives)
{
  using Rational = SC::Exact_rational;
  const Curve one = SC::bezier_curve(std::vector<Point>{{-2, 4}, {0, -4}, {2, 4}}),
              two = SC::bezier_curve(std::vector<Point>{
                  {0, 0}, {Rational(1, 3), Rational(1, 3)}, {Rational(2, 3), Rational(2, 3)}, {1, 2}});
  const Locus locus = SC::envelope_curves(one, two);
  ASSERT_EQ(locus.curves().size(), 1u);
  for (const auto& sample : locus.polyline(locus.curves()[0], 1e-2, 10)) {
    const auto at = SC::curve_differentials(locus.system(0), {sample.parameters[0], sample.parameters[1]}, 1);
    ASSERT_TRUE(at);
    const double v = sample.parameters[1]; // the first curve has the abscissa 4 u - 2
    EXPECT_NEAR(CGAL::to_double(at->first_derivative()[0]), 3 * v / 4, 1e-12);
    EXPECT_NEAR(CGAL::to_double(at->second_derivative()[0]), 3.0 / 4, 1e-12);
  }
  const Curve small = SC::circle_curve(Point(1, 2), Rational(1, 2)),
              large = SC::circle_curve(Point(0, 0), Rational(3, 2));
  const Locus sum = SC::envelope_curves(small, large);
  ASSERT_EQ(sum.curves().size(), 1u);
  const SC::Spline_map<1, 2> c1(small), c2(large);
  const auto [u, v] = SC::parameters(c1, c2);
  std::size_t points = 0;
  for (const Locus::Arc& arc : sum.curves()[0].arcs)
    for (const std::size_t i : sum.solutions(arc.part).curves()[arc.index].vertices()) {
      const auto at = SC::curve_differentials(sum.system(arc.part), sum.solutions(arc.part).vertices()[i]);
      ASSERT_TRUE(at);
      const auto curvature = at->image(c1(u) + c2(v)).squared_curvature();
      EXPECT_LE(curvature.lower(), Rational(1, 4));
      EXPECT_GE(curvature.upper(), Rational(1, 4));
      EXPECT_LT(Rational(curvature.upper() - curvature.lower()), Rational(1, 1000));
      ++points;
    }
  EXPECT_GT(points, 1u);
}

// y = x^2 on [0,1] and y = -x^3/3 on [-1,1] are parallel where 2 x1 = -x2^2: in one point, on the edge of the domain.
TEST(Envelope_curves_2, a_point_on_the_edge)
{
  const Curve parabola = SC::bezier_curve(std::vector<Point>{{0, 0}, {SC::Exact_rational(1, 2), 0}, {1, 1}});
  const SC::Exact_rational third(1, 3);
  const Curve cubic = SC::bezier_curve(std::vector<Point>{{-1, third}, {-third, -third}, {third, third}, {1, -third}});
  for (const auto& directions : {SC::Tangent_directions::SAME, SC::Tangent_directions::ANY}) {
    const Locus locus = SC::envelope_curves(parabola, cubic, directions);
    EXPECT_TRUE(locus.is_complete()) << locus;
    EXPECT_TRUE(locus.curves().empty() && locus.singular_points().empty()) << locus;
    ASSERT_EQ(locus.points().size(), 1u) << locus;
    EXPECT_EQ(locus.points()[0].point(), (std::vector<double>{0, 0.5}));
  }
}

TEST(Envelope_curves_2, circles)
{
  const Curve large = SC::to_bspline_curve(K::Circle_2(Point(0, 0), 4)),
              small = SC::to_bspline_curve(K::Circle_2(Point(5, 1), 1));
  const Locus sum = SC::envelope_curves(large, small),
              both = SC::envelope_curves(large, small, SC::Tangent_directions::ANY);
  for (const Locus* locus : {&sum, &both}) {
    EXPECT_TRUE(locus->is_complete()) << *locus;
    EXPECT_EQ(locus->number_of_open_curves(), 0u);
    EXPECT_EQ(locus->number_of_closed_curves(), locus == &sum ? 1u : 2u);
  }
  EXPECT_GT(check_points(sum, large, small, true), 20u);
  EXPECT_GT(check_points(both, large, small, false), 40u);
  for (const Locus* locus : {&sum, &both})
    for (const Locus::Curve& curve : locus->curves())
      for (const auto& sample : locus->polyline(curve, 1e-2, 100)) {
        const double radius = std::hypot(CGAL::to_double(sample.point.x()) - 5, CGAL::to_double(sample.point.y()) - 1);
        EXPECT_NEAR(locus == &sum ? radius - 3 : (radius - 3) * (radius - 1), 0, 1e-12);
      }
}

// Both directions together have all curves of one direction and of the other one.
TEST(Envelope_curves_2, random_cubics)
{
  std::mt19937 random(5);
  std::size_t curves = 0;
  for (int trial = 0; trial < 10; ++trial) {
    const Curve c1 = SC::bezier_curve(random_points(random, 8)), c2 = SC::bezier_curve(random_points(random, 8)),
                c3 = c2.reversed();
    const Locus same = SC::envelope_curves(c1, c2), opposite = SC::envelope_curves(c1, c3),
                any = SC::envelope_curves(c1, c2, SC::Tangent_directions::ANY);
    for (const Locus* locus : {&same, &opposite, &any})
      EXPECT_TRUE(locus->is_complete()) << *locus;
    EXPECT_EQ(any.curves().size(), same.curves().size() + opposite.curves().size());
    check_points(same, c1, c2, true);
    check_points(any, c1, c2, false);
    curves += any.curves().size();
  }
  EXPECT_GT(curves, 5u);
}

TEST(Envelope_curves_2, bad_input)
{
  const Curve c = SC::bezier_curve(std::vector<Point>{{-1, 1}, {0, -1}, {1, 1}});
  EXPECT_THROW(SC::envelope_curves(c, c, SC::Tangent_directions::SAME, {.tolerance = 0}), SC::Invalid_input);
}

} // namespace envelope_curves_2_test
