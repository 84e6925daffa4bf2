// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bisectors of two curves: known conics, numbers of curves and poles, and every point at the same distance along both
// normals.

#include "pair_locus_test_tools.h"

#include <CGAL/Spline_constraints_d/function/linear_elimination.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/loci/bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace bisector_curves_2_test {

namespace {

using Rational = SC::Exact_rational;

Curve cubic(const std::vector<Point>& points) { return SC::bezier_curve(points); }

// Calls check(x, y) for points of all curves, which are at the same distance from both curves along their normals.
template <class Check>
void check_points(const Locus& locus, const Curve& c1, const Curve& c2, const Check& check)
{
  visit_points(locus, c1, c2, [&](const Vector& p, const std::array<Foot, 2>& feet) {
    EXPECT_NEAR(checked_distance(p, feet[0]), checked_distance(p, feet[1]), 1e-12 * (1 + p[0] * p[0] + p[1] * p[1]));
    check(p[0], p[1]);
  });
}

void check_points(const Locus& locus, const Curve& c1, const Curve& c2)
{
  check_points(locus, c1, c2, [](double, double) {});
}

} // namespace

TEST(Bisector_curves_2, two_cubics)
{
  const Curve c1 = cubic({{0, 0}, {1, 2}, {2, -2}, {3, 0}}), c2 = cubic({{0, 3}, {1, 5}, {2, 2}, {3, 4}});
  const Locus locus = SC::bisector_curves(c1, c2);
  expect_numbers(locus, 0, 4, 0, 1);
  check_points(locus, c1, c2);
  std::size_t ends = 0;
  for (const Locus::Curve& curve : locus.curves())
    ends += locus.ends_at_infinity(curve, 0) + locus.ends_at_infinity(curve, 1);
  EXPECT_EQ(ends, 2u);
}

// Of the line y = 0 and a circle around (0,2) with the radius 1: parabolas, 6y = x^2 + 3 outside of it and 2y = x^2 + 3
// through it, with the signed curvatures a / (1 + (a x)^2)^(3/2) with a = 1/3 and a = 1.
TEST(Bisector_curves_2, curvature_of_parabolas)
{
  const Curve line = SC::polyline_curve(std::vector<Point>{{-3, 0}, {3, 0}}),
              circle = SC::circle_curve(Point(0, 2), Rational(1));
  const Locus locus = SC::bisector_curves(line, circle);
  ASSERT_TRUE(locus.is_complete());
  const SC::Spline_map<1, 2> c1(line), c2(circle);
  const auto [u, v] = SC::parameters(c1, c2);
  const SC::Vector_expression<2> point = SC::meet(SC::normal_line(c1, u), SC::equidistant_hyperplane(c1(u), c2(v)));
  std::array<std::size_t, 2> points{};
  for (const Locus::Curve& curve : locus.curves())
    for (const Locus::Arc& arc : curve.arcs)
      for (const std::size_t i : locus.solutions(arc.part).curves()[arc.index].vertices()) {
        const SC::Curve_vertex& vertex = locus.solutions(arc.part).vertices()[i];
        const auto at = SC::curve_differentials(locus.system(arc.part), vertex);
        if (!at)
          continue;
        const auto in_plane = at->image(point);
        const auto p = in_plane.point();
        const double px = CGAL::to_double(p[0].midpoint()), py = CGAL::to_double(p[1].midpoint());
        if (!(std::abs(px) < 4))
          continue;
        const bool is_outer = std::abs(6 * py - px * px - 3) < 1e-6;
        EXPECT_TRUE(is_outer || std::abs(2 * py - px * px - 3) < 1e-6) << px << ' ' << py;
        const double a = is_outer ? 1.0 / 3 : 1, expected = a / std::pow(1 + a * px * a * px, 1.5);
        const auto curvature = in_plane.curvature();
        EXPECT_LE(curvature.inf(), expected + 1e-9);
        EXPECT_GE(curvature.sup(), expected - 1e-9);
        EXPECT_LT(curvature.sup() - curvature.inf(), 1e-3);
        ++points[is_outer];
      }
  EXPECT_GT(points[0], 0u);
  EXPECT_GT(points[1], 0u);
}

TEST(Bisector_curves_2, lines)
{
  const Curve c1 = SC::polyline_curve(std::vector<Point>{{-1, 0}, {1, 0}});
  const Curve crossing = SC::polyline_curve(std::vector<Point>{{SC::Exact_rational(-3, 5), SC::Exact_rational(-4, 5)},
                                                               {SC::Exact_rational(3, 5), SC::Exact_rational(4, 5)}});
  const Locus lines = SC::bisector_curves(c1, crossing);
  expect_numbers(lines, 0, 4, 1, 0);   // two lines from (0,0) on both sides
  check_points(lines, c1, crossing, [](double x, double y) { EXPECT_NEAR((2 * y - x) * (y + 2 * x), 0, 1e-13); });

  const Curve parallel = SC::polyline_curve(std::vector<Point>{{-2, 1}, {2, 1}});
  const Locus line = SC::bisector_curves(c1, parallel);
  expect_numbers(line, 0, 1, 0, 0);
  check_points(line, c1, parallel, [](double, double y) { EXPECT_NEAR(y, 0.5, 1e-14); });
}

TEST(Bisector_curves_2, circle_and_line_have_two_parabolas)
{
  const Curve circle = SC::to_bspline_curve(K::Circle_2(Point(0, 3), 1)),
              line = SC::polyline_curve(std::vector<Point>{{-4, 0}, {4, 0}});
  const Locus locus = SC::bisector_curves(circle, line);
  EXPECT_TRUE(locus.is_complete()) << locus;
  check_points(locus, circle, line, [](double x, double y) {   // |P - c| = |y| + 1 or | |y| - 1 |
    const double distance = std::hypot(x, y - 3);
    EXPECT_NEAR((distance - std::abs(y) - 1) * (distance - std::abs(std::abs(y) - 1)), 0, 1e-11 * (1 + x * x + y * y));
  });
}

TEST(Bisector_curves_2, circles_have_ellipses_or_hyperbolas)
{
  const Curve large = SC::to_bspline_curve(K::Circle_2(Point(0, 0), 16)),
              inner = SC::to_bspline_curve(K::Circle_2(Point(1, 0), 1)),
              outer = SC::to_bspline_curve(K::Circle_2(Point(7, 0), 1));
  const Locus ellipses = SC::bisector_curves(large, inner);
  expect_numbers(ellipses, 2, 0, 0, 0);   // across the seams
  check_points(ellipses, large, inner, [](double x, double y) {
    const double sum = std::hypot(x, y) + std::hypot(x - 1, y);
    EXPECT_NEAR((sum - 5) * (sum - 3), 0, 1e-10);
  });
  const Locus hyperbolas = SC::bisector_curves(large, outer);
  expect_numbers(hyperbolas, 0, 4, 0, 4);   // the four lines that touch both circles: two asymptotes of each hyperbola
  check_points(hyperbolas, large, outer, [](double x, double y) {
    const double difference = std::abs(std::hypot(x, y) - std::hypot(x - 7, y));
    EXPECT_NEAR((difference - 5) * (difference - 3), 0, 1e-10 * (1 + x * x + y * y));
  });
}

// Rational rigid motions change no numbers; random cubics all have certified bisectors.
TEST(Bisector_curves_2, random_cubics_and_motions)
{
  std::mt19937 random(12);
  std::uniform_int_distribution<int> coordinate(-8, 8), parameter(1, 9);
  std::size_t curves = 0;
  for (int trial = 0; trial < 8; ++trial) {
    std::vector<Point> points[2], moved[2];
    const SC::Exact_rational t(parameter(random), 10), cosine((1 - t * t) / (1 + t * t)), sine(2 * t / (1 + t * t));
    for (const int i : {0, 1})
      for (int k = 0; k < 4; ++k) {
        const Point p(3 * k, coordinate(random) + 20 * i);
        points[i].push_back(p);
        moved[i].emplace_back(cosine * p.x() - sine * p.y() + 2, sine * p.x() + cosine * p.y() - 1);
      }
    const Curve c1 = cubic(points[0]), c2 = cubic(points[1]);
    const Locus locus = SC::bisector_curves(c1, c2), after = SC::bisector_curves(cubic(moved[0]), cubic(moved[1]));
    EXPECT_TRUE(locus.is_complete()) << locus;
    expect_numbers(after, locus.number_of_closed_curves(), locus.number_of_open_curves(),
                   locus.singular_points().size(), locus.number_of_poles());
    curves += locus.curves().size();
    check_points(locus, c1, c2);
  }
  EXPECT_GT(curves, 8u);
}

// (a t^2, a t^3) with a cusp inside, at an irrational parameter in the second case, and the line x = -1: no point of it
// but the one below the cusp has a circle that touches the curve there.
TEST(Bisector_curves_2, cusps)
{
  const auto expect_no_pencil = [](const Curve& cusp, const Curve& line, double parameter) {
    const Locus locus = SC::bisector_curves(cusp, line);
    EXPECT_TRUE(locus.is_complete()) << locus;
    EXPECT_FALSE(locus.curves().empty());
    std::size_t near_cusp = 0;
    for (const Locus::Curve& curve : locus.curves())
      for (const auto& sample : locus.polyline(curve, 1e-3, 10)) {
        const double x = CGAL::to_double(sample.point.x()), y = CGAL::to_double(sample.point.y());
        const Vector foot = rounded(SC::Spline_map<1, 2>(cusp)(std::array{SC::Exact_rational(sample.parameters[0])}));
        // as far from the line
        EXPECT_NEAR(std::hypot(x - foot[0], y - foot[1]), std::abs(x + 1), 1e-9 * (1 + x * x + y * y));
        near_cusp += std::abs(sample.parameters[0] - parameter) < 1e-2;
      }
    EXPECT_LT(near_cusp, 20u);
  };
  const Curve line = SC::polyline_curve(std::vector<Point>{{-1, -2}, {-1, 2}});
  // ((2t-1)^2, (2t-1)^3)
  expect_no_pencil(cubic({{1, -1}, {Rational(-1, 3), 1}, {Rational(-1, 3), -1}, {1, 1}}), line, 0.5);
  // C' = (t^2 - 1/2) (1, t): the coordinates t^3/3 - t/2 and t^4/4 - t^2/4
  const Curve quartic = cubic({{0, 0},
                               {Rational(-1, 8), 0},
                               {Rational(-1, 4), Rational(-1, 24)},
                               {Rational(-7, 24), Rational(-1, 8)},
                               {Rational(-1, 6), 0}});
  expect_no_pencil(quartic, line, std::sqrt(0.5));
}

// The circles intersect at the seam of the first one, where two branches of the bisector cross: they are found with
// that, or what is not proved there is listed.
TEST(Bisector_curves_2, crossing_on_a_seam)
{
  const Curve first = SC::to_bspline_curve(K::Circle_2(Point(0, 0), 1)),
              second = SC::to_bspline_curve(K::Circle_2(Point(1, -1), 1));
  ASSERT_EQ(first.source(), Point(1, 0));
  const Locus locus = SC::bisector_curves(first, second, {.tolerance = 1e-3});
  EXPECT_EQ(locus.is_complete(), locus.undecided().empty());
  double on_line = 0, on_ellipse = 0;
  for (const Locus::Curve& curve : locus.curves())
    for (const auto& sample : locus.polyline(curve, 1e-2, 10)) {
      const double x = CGAL::to_double(sample.point.x()), y = CGAL::to_double(sample.point.y()), a = std::hypot(x, y),
                   b = std::hypot(x - 1, y + 1);
      const bool is_on_line = std::abs(a - b) < 1e-6 * (1 + a), is_on_ellipse = std::abs(a + b - 2) < 1e-6;
      EXPECT_TRUE(is_on_line || is_on_ellipse) << x << ' ' << y;
      on_line += is_on_line;
      on_ellipse += is_on_ellipse;
    }
  EXPECT_GT(on_line, 0);
  EXPECT_GT(on_ellipse, 0);
}

TEST(Bisector_curves_2, bad_input)
{
  const Curve c = SC::polyline_curve(std::vector<Point>{{-1, 0}, {1, 0}}),
              d = SC::polyline_curve(std::vector<Point>{{-1, 1}, {1, 1}});
  EXPECT_THROW(SC::bisector_curves(c, d, {.tolerance = -1}), SC::Invalid_input);
  const Locus locus = SC::bisector_curves(c, d);
  EXPECT_THROW(locus.polyline(locus.curves()[0], 0, 1), SC::Invalid_input);
  EXPECT_THROW(locus.polyline(locus.curves()[0], 1, 0), SC::Invalid_input);
}

} // namespace bisector_curves_2_test
