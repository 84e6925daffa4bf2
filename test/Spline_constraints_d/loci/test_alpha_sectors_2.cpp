// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Alpha-sectors of two curves: known conics and Cartesian ovals, the bisector among them, and the ratio of the
// distances along both normals at every point.

#include "pair_locus_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/operations/loci/alpha_sectors_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace alpha_sectors_2_test {

namespace {

using Number = SC::Exact_rational;

// Calls check(x, y) for points of all curves, whose distances from the curves along their normals have the ratio alpha
// : 1 - alpha. The number of points.
template <class Check>
std::size_t check_points(const Locus& locus, const Curve& c1, const Curve& c2, const Number& alpha, const Check& check)
{
  const double share = CGAL::to_double(alpha);
  std::size_t points = 0;
  visit_points(locus, c1, c2, [&](const Vector& p, const std::array<Foot, 2>& feet) {
    ++points;
    EXPECT_NEAR((1 - share) * checked_distance(p, feet[0]), share * checked_distance(p, feet[1]),
                1e-11 * (1 + std::hypot(p[0], p[1])));
    check(p[0], p[1]);
  });
  return points;
}

Curve segment(const Point& a, const Point& b) { return SC::polyline_curve(std::vector<Point>{a, b}); }

} // namespace

// Two lines through the crossing; two parallels.
TEST(Alpha_sectors_2, lines)
{
  const Curve c1 = segment({-1, 0}, {1, 0}), c2 = segment({Number(-3, 5), Number(-4, 5)}, {Number(3, 5), Number(4, 5)});
  const Locus locus = SC::alpha_sectors(c1, c2, Number(1, 3));
  expect_numbers(locus, 0, 2, 0, 0);
  EXPECT_GE(check_points(locus, c1, c2, Number(1, 3),
                         [](double x, double y) { EXPECT_NEAR(2 * std::abs(y), std::abs(0.8 * x - 0.6 * y), 1e-13); }),
            4u);

  const Curve parallel = segment({-2, 3}, {5, 3});
  const Locus lines = SC::alpha_sectors(c1, parallel, Number(1, 3));
  expect_numbers(lines, 0, 2, 0, 0);
  EXPECT_GE(check_points(lines, c1, parallel, Number(1, 3),
                         [](double, double y) { EXPECT_NEAR((y - 1) * (y + 3), 0, 1e-13); }),
            4u);
}

// Conics with the center as focus, of eccentricity alpha / (1 - alpha): two ellipses or hyperbolas.
TEST(Alpha_sectors_2, circle_and_line_have_conics)
{
  const Curve circle = SC::to_bspline_curve(K::Circle_2(Point(0, 5), 1)), line = segment({-16, -12}, {16, 12});
  for (const Number& alpha : {Number(1, 3), Number(2, 3)}) {
    const Locus locus = SC::alpha_sectors(circle, line, alpha);
    EXPECT_EQ(locus.number_of_closed_curves(), alpha < Number(1, 2) ? 2u : 0u);
    expect_numbers(locus, locus.number_of_closed_curves(), locus.number_of_open_curves(), 0, 0);
    const double ratio = CGAL::to_double(Number(alpha / (1 - alpha)));
    EXPECT_GT(check_points(locus, circle, line, alpha, [&](double x, double y) {
      const double from_center = std::hypot(x, y - 5), from_line = std::abs(-0.6 * x + 0.8 * y);
      EXPECT_NEAR((std::abs(from_center - 1) - ratio * from_line) * (from_center + 1 - ratio * from_line), 0, 1e-9);
    }), 40u);
  }
}

// Cartesian ovals: two for either sign.
TEST(Alpha_sectors_2, circles_have_Cartesian_ovals)
{
  const Curve large = SC::to_bspline_curve(K::Circle_2(Point(0, 0), 16)),
              small = SC::to_bspline_curve(K::Circle_2(Point(Number(21, 5), Number(28, 5)), 1));
  const Locus locus = SC::alpha_sectors(large, small, Number(1, 4));
  expect_numbers(locus, 4, 0, 0, 0);
  EXPECT_GT(check_points(locus, large, small, Number(1, 4), [](double x, double y) {
    const double r = std::hypot(x, y), s = std::hypot(x - 4.2, y - 5.6);
    double nearest = 1e9;
    for (const double from_large : {std::abs(r - 4), r + 4})
      for (const double from_small : {std::abs(s - 1), s + 1})
        nearest = (std::min)(nearest, std::abs(3 * from_large - from_small));
    EXPECT_NEAR(nearest, 0, 1e-10);
  }), 80u);
}

TEST(Alpha_sectors_2, one_half_is_the_bisector)
{
  const Curve c1 = SC::bezier_curve(std::vector<Point>{{0, 0}, {1, 2}, {2, -2}, {3, 0}}),
              c2 = SC::bezier_curve(std::vector<Point>{{0, 3}, {1, 5}, {2, 2}, {3, 4}});
  const Locus locus = SC::alpha_sectors(c1, c2, Number(1, 2));
  expect_numbers(locus, 0, 4, 0, 1);
  EXPECT_GT(check_points(locus, c1, c2, Number(1, 2), [](double, double) {}), 20u);
}

// Exchanging the curves and alpha with 1 - alpha, and rational rigid motions, change no numbers. In every other trial,
// the curves intersect.
TEST(Alpha_sectors_2, random_cubics)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(-4, 4);
  std::size_t points = 0;
  const K::Aff_transformation_2 motion(Number(3, 5), Number(-4, 5), 2, Number(4, 5), Number(3, 5), -1);
  for (int trial = 0; trial < 4; ++trial) {
    std::vector<Point> control_points[2];
    for (const int i : {0, 1})
      for (int k = 0; k < 4; ++k) {
        const int y = coordinate(random);
        control_points[i].emplace_back(3 * k, y + i * (trial % 2 == 0 ? 10 : 4 * k - 6));
      }
    const Curve c1 = SC::bezier_curve(control_points[0]), c2 = SC::bezier_curve(control_points[1]);
    const Number alpha(2 + trial, 11);
    const Locus locus = SC::alpha_sectors(c1, c2, alpha), exchanged = SC::alpha_sectors(c2, c1, Number(1 - alpha)),
                moved = SC::alpha_sectors(c1.transformed(motion), c2.transformed(motion), alpha);
    EXPECT_FALSE(locus.curves().empty());
    for (const Locus* other : {&locus, &exchanged, &moved})
      expect_numbers(*other, locus.number_of_closed_curves(), locus.number_of_open_curves(), 0, 0);
    points += check_points(locus, c1, c2, alpha, [](double, double) {});
  }
  EXPECT_GT(points, 40u);
}

TEST(Alpha_sectors_2, bad_input)
{
  const Curve c = segment({-1, 0}, {1, 0}), d = segment({-1, 1}, {1, 2});
  for (const int alpha : {-1, 0, 1, 2})
    EXPECT_THROW(SC::alpha_sectors(c, d, alpha), SC::Invalid_input);
  EXPECT_THROW(SC::alpha_sectors(c, d, Number(1, 3), {.tolerance = -1}), SC::Invalid_input);
}

} // namespace alpha_sectors_2_test
