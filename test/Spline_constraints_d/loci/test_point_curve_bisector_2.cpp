// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bisectors of a point and a curve: exactly parabolas, ellipses and hyperbolas; exact distances and perpendiculars
// everywhere; poles.

#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/loci/point_curve_bisector_2.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace point_curve_bisector_2_test {

namespace SC = CGAL::Spline_constraints;
using K = SC::Point_curve_bisector_2::Kernel;
using Number = SC::Exact_rational;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;

namespace {

// Exactly: the center of a circle through the point that touches the curve at the same parameter. Calls check(center)
// for some of them.
template <class Check>
void check_centers(const SC::Point_curve_bisector_2& bisector, const Point& point, const Curve& curve,
                   const Check& check)
{
  EXPECT_TRUE(bisector.summary().is_complete);
  EXPECT_TRUE(bisector.undecided().empty());
  for (const Curve& piece : bisector.curves())
    for (int k = 0; k <= 7; ++k) {
      const auto [begin, end] = piece.domain();
      const Number t(begin + (end - begin) * k / 7);
      const Point center = piece(t), foot = curve(t);
      EXPECT_EQ(CGAL::squared_distance(center, point), CGAL::squared_distance(center, foot));
      EXPECT_EQ((center - foot) * curve.tangent(t), 0);
      check(center);
    }
}

// Whether the sum or the difference of the distances from two foci is a given number, exactly.
bool is_on_conic(const Point& p, const Point& a, const Point& b, const Number& sum)
{
  const Number difference(sum * sum + CGAL::squared_distance(p, a) - CGAL::squared_distance(p, b));
  return 4 * sum * sum * CGAL::squared_distance(p, a) == difference * difference;
}

} // namespace

TEST(Point_curve_bisector_2, point_and_line_have_a_parabola)
{
  const Point focus(1, 2);
  const Curve line = SC::polyline_curve(std::vector<Point>{{-3, 0}, {4, 0}});
  const auto bisector = SC::point_curve_bisector(focus, line);
  ASSERT_EQ(bisector.curves().size(), 1u);
  EXPECT_TRUE(bisector.poles().empty());
  EXPECT_EQ(bisector.curves()[0].degree(), 2);
  check_centers(bisector, focus, line, [](const Point& p) { EXPECT_EQ(4 * p.y(), (p.x() - 1) * (p.x() - 1) + 4); });
}

TEST(Point_curve_bisector_2, point_and_circle_have_an_ellipse_or_a_hyperbola)
{
  const Point center(1, 1), inside(2, Number(1, 3));
  const Curve circle = SC::to_bspline_curve(K::Circle_2(center, 9));
  const auto ellipse = SC::point_curve_bisector(inside, circle);
  EXPECT_TRUE(ellipse.poles().empty());
  EXPECT_EQ(ellipse.curves().size(), circle.breaks().size() - 1);
  check_centers(ellipse, inside, circle, [&](const Point& p) { EXPECT_TRUE(is_on_conic(p, inside, center, 3)); });
  for (std::size_t i = 0; i < ellipse.curves().size(); ++i)
    EXPECT_EQ(ellipse.curves()[i].target(), ellipse.curves()[(i + 1) % ellipse.curves().size()].source());

  // Two tangents go through a point outside; one of those through the second point at a break.
  for (const auto& [outside, number_of_curves] : {std::pair(Point(7, 3), 6u), std::pair(Point(6, 4), 5u)}) {
    const auto hyperbola = SC::point_curve_bisector(outside, circle);
    EXPECT_EQ(hyperbola.poles().size(), 2u);
    EXPECT_EQ(hyperbola.curves().size(), number_of_curves);
    check_centers(hyperbola, outside, circle,
                  [&outside = outside, &center](const Point& p) { EXPECT_TRUE(is_on_conic(p, outside, center, 3)); });
  }
}

// A line through the point has no curve; where a curve goes through it, the limit is the center of curvature.
TEST(Point_curve_bisector_2, point_on_the_curve)
{
  const auto none = SC::point_curve_bisector(Point(1, 0), SC::polyline_curve(std::vector<Point>{{-3, 0}, {4, 0}}));
  EXPECT_TRUE(none.curves().empty());
  EXPECT_EQ(none.poles().size(), 1u);
  const Curve parabola = SC::bezier_curve(std::vector<Point>{{-1, 1}, {0, -1}, {1, 1}});
  const auto bisector = SC::point_curve_bisector(Point(0, 0), parabola);
  EXPECT_EQ(bisector.curves().size(), 2u);
  ASSERT_EQ(bisector.poles().size(), 1u);
  EXPECT_EQ(bisector.poles()[0].first, Number(1, 2));
  check_centers(bisector, Point(0, 0), parabola, [](const Point&) {});
  EXPECT_NEAR(CGAL::to_double(bisector.curves()[0].target().y()), 0.5, 1e-5);
}

// Each pole separates two curves, which have ends in opposite directions, far away.
TEST(Point_curve_bisector_2, random_cubics)
{
  std::mt19937 random(8);
  std::uniform_int_distribution<int> coordinate(-9, 9);
  std::size_t poles = 0;
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Point> points;
    for (int k = 0; k < 5; ++k) {
      const int x = coordinate(random), y = coordinate(random);
      points.emplace_back(x, y);
    }
    const Point point = points.back();
    points.pop_back();
    const Curve curve = SC::bezier_curve(points);
    const auto bisector = SC::point_curve_bisector(point, curve, 0x1p-20);
    check_centers(bisector, point, curve, [](const Point&) {});
    ASSERT_EQ(bisector.curves().size(), bisector.poles().size() + 1);
    for (std::size_t i = 1; i < bisector.curves().size(); ++i) {
      const K::Vector_2 before = bisector.curves()[i - 1].target() - point,
                        after = bisector.curves()[i].source() - point;
      EXPECT_GT(before.squared_length(), 10000);
      EXPECT_GT(after.squared_length(), 10000);
      EXPECT_LT(before * after, 0);
    }
    poles += bisector.poles().size();
  }
  EXPECT_GT(poles, 10u);
}

TEST(Point_curve_bisector_2, bad_input)
{
  const Curve line = SC::polyline_curve(std::vector<Point>{{-3, 0}, {4, 0}});
  for (const double margin : {-1.0, 0.0, 0.5, std::nan("")})
    EXPECT_THROW(SC::point_curve_bisector(Point(0, 1), line, margin), SC::Invalid_input);
  EXPECT_THROW(SC::point_curve_bisector(Point(0, 1), line, 0.1, {.tolerance = -1}), SC::Invalid_input);
}

} // namespace point_curve_bisector_2_test
