// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Envelopes of a curve that moves along another one: circles have circles, and every point has parallel tangents in the same direction.

#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/operations/envelope_curves_2.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Locus = SC::Curve_pair_locus_2<K>;

namespace {

// The tangents at all points, which are sums of points of the curves.
std::size_t check_points(const Locus& locus, const Curve& c1, const Curve& c2, bool has_same_direction)
{
  const SC::Spline_map<1, 2> maps[2] = {SC::Spline_map<1, 2>(c1), SC::Spline_map<1, 2>(c2)};
  std::size_t points = 0;
  for (const Locus::Curve& curve : locus.curves())
    for (const auto& sample : locus.polyline(curve, 1e-2, 100)) {
      ++points;
      double sum[2] = {0, 0}, tangent[2][2];
      for (const int i : {0, 1}) {
        const std::array<SC::Exact_rational, 1> t{SC::Exact_rational(sample.parameters[i])};
        const auto p = maps[i](t), d = derivative(maps[i])(t);
        const double length = std::hypot(CGAL::to_double(d[0]), CGAL::to_double(d[1]));
        for (const int k : {0, 1}) {
          sum[k] += CGAL::to_double(p[k]);
          tangent[i][k] = CGAL::to_double(d[k]) / length;
        }
      }
      EXPECT_NEAR(CGAL::to_double(sample.point.x()), sum[0], 1e-12);
      EXPECT_NEAR(CGAL::to_double(sample.point.y()), sum[1], 1e-12);
      EXPECT_NEAR(tangent[0][0] * tangent[1][1] - tangent[0][1] * tangent[1][0], 0, 1e-11);
      const double cosine = tangent[0][0] * tangent[1][0] + tangent[0][1] * tangent[1][1];
      EXPECT_NEAR(has_same_direction ? cosine : std::abs(cosine), 1, 1e-11);
    }
  return points;
}

} // namespace

TEST(Envelope_curves_2, parabolas)
{
  // y = x^2 and y = 2 x^2: the same slope at x2 = x1 / 2, the sum of the points is (3t, 6t^2), t in [-1/2, 1/2].
  const Curve one = SC::bezier_curve(std::vector<Point>{{-1, 1}, {0, -1}, {1, 1}}), two = SC::bezier_curve(std::vector<Point>{{-1, 2}, {0, -2}, {1, 2}});
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

TEST(Envelope_curves_2, circles)
{
  const Curve large = SC::to_bspline_curve(K::Circle_2(Point(0, 0), 4)), small = SC::to_bspline_curve(K::Circle_2(Point(5, 1), 1));
  const Locus sum = SC::envelope_curves(large, small), both = SC::envelope_curves(large, small, SC::Tangent_directions::ANY);
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
  std::uniform_int_distribution<int> coordinate(-8, 8);
  std::size_t curves = 0;
  for (int trial = 0; trial < 10; ++trial) {
    std::vector<Point> points[2], reversed;
    for (std::vector<Point>& p : points)
      for (int k = 0; k < 4; ++k)
        p.emplace_back(coordinate(random), coordinate(random));
    reversed.assign(points[1].rbegin(), points[1].rend());
    const Curve c1 = SC::bezier_curve(points[0]), c2 = SC::bezier_curve(points[1]), c3 = SC::bezier_curve(reversed);
    const Locus same = SC::envelope_curves(c1, c2), opposite = SC::envelope_curves(c1, c3), any = SC::envelope_curves(c1, c2, SC::Tangent_directions::ANY);
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
