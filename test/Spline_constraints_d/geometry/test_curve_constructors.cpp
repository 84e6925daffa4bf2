// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/conic_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/cubic_interpolation.h>
#include <CGAL/Spline_constraints_d/geometry/curves/hermite_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace curve_constructors_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using FT = Exact_rational;
using Curve_2 = SC::Bspline_curve_2<Exact_cartesian>;
using Curve_3 = SC::Bspline_curve_3<Exact_cartesian>;
using Point_2 = Exact_cartesian::Point_2;
using Point_3 = Exact_cartesian::Point_3;
using Vector_2 = Exact_cartesian::Vector_2;
using Vector_3 = Exact_cartesian::Vector_3;
using Double_point_2 = Double_cartesian::Point_2;

constexpr int rounds = 20;

TEST(Polygonal_curves, run_through_their_points)
{
  Random_geometry random(1);
  const std::vector<Point_2> points = random.points<Exact_cartesian, 2>(5);
  const Curve_2 polyline = SC::polyline_curve(points), bezier = SC::bezier_curve(points);
  for (int i = 0; i < 5; ++i)
    EXPECT_EQ(polyline(i), points[i]);
  EXPECT_EQ(polyline(FT(5) / 2), CGAL::midpoint(points[2], points[3]));
  EXPECT_EQ(bezier.degree(), 4);
  EXPECT_EQ(bezier.control_points(), points);
  // de Casteljau at one third.
  std::vector<Point_2> row = points;
  while (row.size() > 1) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      row[i] = row[i] + (row[i + 1] - row[i]) * (FT(1) / FT(3));
    row.pop_back();
  }
  EXPECT_EQ(bezier(FT(1) / 3), row[0]);
  const auto segment = SC::segment_curve(CGAL::Epick::Point_3(1, 2, 3), CGAL::Epick::Point_3(2, 4, 7));
  EXPECT_EQ(segment(0.25), CGAL::Epick::Point_3(1.25, 2.5, 4));
  EXPECT_EQ(SC::bezier_curve<CGAL::Epeck>({{-3, 1}, {-1, -6}, {1, 6}, {3, -1}})(0.5), CGAL::Epeck::Point_2(0, 0));
  EXPECT_TRUE(SC::bezier_curve<Exact_cartesian>({Point_3(0, 0, 0), Point_3(1, 1, 1), Point_3(0, 0, 2)}, {1, 2, 1})
                  .is_rational());
}

TEST(Circle_curve, lies_on_its_circle)
{
  Random_geometry random(2);
  for (int i = 0; i < rounds; ++i) {
    const Point_2 center = random.points<Exact_cartesian, 2>(1)[0];
    const FT radius = FT(random.integer(1, 50)) / FT(random.integer(1, 9));
    const Curve_2 circle = SC::circle_curve(center, radius);
    EXPECT_EQ(circle.domain(), (std::pair<FT, FT>(0, 4)));
    EXPECT_TRUE(circle.is_closed());
    for (int k = 0; k < 5; ++k) {
      const FT t = FT(4) * random.fraction();
      EXPECT_EQ(CGAL::squared_distance(circle(t), center), radius * radius);
      EXPECT_EQ(circle.squared_curvature(t), FT(1) / (radius * radius));
      EXPECT_GT(circle.curvature(t), 0);
    }
    EXPECT_EQ(circle(0), center + Vector_2(radius, 0));
    EXPECT_EQ(circle(1), center + Vector_2(0, radius));
    EXPECT_EQ(circle(2), center - Vector_2(radius, 0));
    // Continuously differentiable between the quarters and across the seam.
    const std::vector<Curve_2> quarters = circle.bezier_pieces();
    ASSERT_EQ(quarters.size(), 4u);
    for (int q = 0; q < 4; ++q)
      EXPECT_EQ(quarters[q].tangent(FT(q + 1)), quarters[(q + 1) % 4].tangent(FT((q + 1) % 4)));

    // With an irrational radius, from any of its points.
    const Point_2 source = random.points<Exact_cartesian, 2>(1)[0];
    if (source == center)
      continue;
    const Curve_2 through = SC::circle_curve(center, source);
    EXPECT_EQ(through.source(), source);
    EXPECT_EQ(CGAL::squared_distance(through(FT(4) * random.fraction()), center),
              CGAL::squared_distance(source, center));
  }
  const auto rounded = SC::circle_curve(Double_point_2(0.1, 0.2), 0.3);
  for (int k = 0; k <= 40; ++k)
    EXPECT_NEAR(CGAL::squared_distance(rounded(0.1 * k), Double_point_2(0.1, 0.2)), 0.09, 1e-15);
  EXPECT_EQ(CGAL::squared_distance(SC::circle_curve(CGAL::Epeck::Point_2(1, 2), 3)(0.3), CGAL::Epeck::Point_2(1, 2)),
            9);
}

// Whether points of a curve of doubles have exactly one distance from a center.
bool is_exactly_circular(const SC::Bspline_curve_2<CGAL::Simple_cartesian<double>>& arc)
{
  const Curve_2 exact(arc);
  const auto at = [&](int k) {
    return exact(exact.domain().first + FT(k) / 7 * (exact.domain().second - exact.domain().first));
  };
  const Point_2 center = CGAL::circumcenter(at(0), at(3), at(5));
  bool result = true;
  for (int k = 0; k <= 7; ++k)
    result = result && CGAL::squared_distance(at(k), center) == CGAL::squared_distance(at(0), center);
  return result;
}

TEST(Circle_curve, is_a_circle_in_doubles)
{
  EXPECT_TRUE(is_exactly_circular(SC::circle_curve(Double_point_2(0.1, 0.2), 0.3)));
  EXPECT_TRUE(is_exactly_circular(SC::circle_curve(Double_point_2(-1e-3, 1e3), 1.0 / 3)));
  EXPECT_TRUE(is_exactly_circular(SC::circle_curve(Double_point_2(0.1, 0.2), Double_point_2(0.4, 0.7))));
  const auto circle = SC::circle_curve(Double_point_2(0.1, 0.2), 0.3);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(CGAL::to_double(CGAL::squared_distance(circle(double(k)), Double_point_2(0.1, 0.2))), 0.09, 1e-16);
}

// Control points that are no finite numbers are refused, and the least numbers are as good as others.
TEST(Circle_curve, at_the_ends_of_the_range_of_doubles)
{
  expect_invalid([] { SC::circle_curve(Double_point_2(1e308, 0.1), 1e308); }, "finite");
  EXPECT_EQ(SC::circle_curve(Double_point_2(0, 1e-310), 3e-310).source(), Double_point_2(3e-310, 1e-310));
}

// From one point to the opposite one, where the sum of the directions is rounding only.
TEST(Circular_arc_curve, half_circles_in_doubles)
{
  using Double_points = std::array<Double_point_2, 3>;
  for (const auto& [center, source, target] :
       {Double_points{Double_point_2(0.9, 0.3), Double_point_2(0.9, 0.1), Double_point_2(0.9, 0.5)},
        Double_points{Double_point_2(0, 0.3), Double_point_2(0, 0.1), Double_point_2(0, 0.5)},
        Double_points{Double_point_2(0.3, 0), Double_point_2(0.1, 0), Double_point_2(0.5, 0)},
        Double_points{Double_point_2(0.1, 0.3), Double_point_2(0.1, 0.5), Double_point_2(0.1, 0.1)}})
    for (const auto orientation : {CGAL::COUNTERCLOCKWISE, CGAL::CLOCKWISE}) {
      const auto arc = SC::circular_arc_curve(center, source, target, orientation);
      EXPECT_EQ(arc.domain(), std::pair(0.0, 2.0));
      EXPECT_TRUE(is_exactly_circular(arc));
      EXPECT_LT(CGAL::squared_distance(arc.source(), source), 1e-30);
      EXPECT_LT(CGAL::squared_distance(arc.target(), target), 1e-30);
      EXPECT_EQ(arc.curvature(1.0) > 0, orientation == CGAL::COUNTERCLOCKWISE);
    }
  // In any direction the target is where it should be, and the angle is nearly a half turn.
  for (int k = 0; k < 60; ++k) {
    const double angle = 0.1 * k;
    const Double_point_2 center(0.1, 0.7), source(0.1 + 0.3 * std::cos(angle), 0.7 + 0.3 * std::sin(angle)),
        target(0.1 - 0.3 * std::cos(angle), 0.7 - 0.3 * std::sin(angle));
    const auto arc = SC::circular_arc_curve(center, source, target);
    EXPECT_NEAR(arc.domain().second, 2, 1e-14);
    EXPECT_LT(CGAL::squared_distance(arc.target(), target), 1e-30);
  }
  const auto quarter =
      SC::circular_arc_curve(Double_point_2(0.1, 0.2), Double_point_2(0.4, 0.2), Double_point_2(0.1, 0.5));
  EXPECT_EQ(quarter.domain().second, 1);
  EXPECT_TRUE(is_exactly_circular(quarter));
  expect_invalid([] { SC::circular_arc_curve(Double_point_2(0, 0), Double_point_2(1, 0), Double_point_2(2, 0)); },
                 "same direction");
}

TEST(Circular_arc_curve, runs_from_source_to_target)
{
  Random_geometry random(3);
  const Curve_2 circle = SC::circle_curve(Point_2(1, 2), Point_2(2, 4));
  int turns[2] = {0, 0};
  for (int i = 0; i < 3 * rounds; ++i) {
    const Point_2 p = circle(FT(random.integer(0, 39)) / FT(10)), q = circle(FT(random.integer(0, 39)) / FT(10));
    if (p == q)
      continue;
    const bool is_clockwise = random.integer(0, 1) == 1;
    const Curve_2 arc =
        SC::circular_arc_curve(Point_2(1, 2), p, q, is_clockwise ? CGAL::CLOCKWISE : CGAL::COUNTERCLOCKWISE);
    EXPECT_EQ(arc.source(), p);
    EXPECT_EQ(arc.target(), q);
    EXPECT_LT(arc.domain().second, 4);
    for (int k = 0; k < 4; ++k) {
      const FT t = arc.domain().second * random.fraction();
      EXPECT_EQ(CGAL::squared_distance(arc(t), Point_2(1, 2)), 5);
      EXPECT_EQ(arc.curvature(t) < 0, is_clockwise);
    }
    // At most half a turn exactly if the target is not on the other side of the line from the center through the
    // source.
    const CGAL::Orientation side = CGAL::orientation(Point_2(1, 2), p, q);
    EXPECT_EQ(arc.domain().second <= 2, side == CGAL::COLLINEAR || (side == CGAL::CLOCKWISE) == is_clockwise);
    ++turns[arc.domain().second <= 2];
  }
  EXPECT_GT(turns[0], rounds / 2);
  EXPECT_GT(turns[1], rounds / 2);
  const auto rounded = SC::circular_arc_curve(Double_point_2(0, 0), Double_point_2(1, 0),
                                              Double_point_2(-std::sqrt(0.5), -std::sqrt(0.5)));
  EXPECT_NEAR(rounded.target().x(), -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(rounded.target().y(), -std::sqrt(0.5), 1e-15);
}

TEST(Ellipse_curve, satisfies_its_equation)
{
  Random_geometry random(4);
  const Curve_2 ellipse = SC::ellipse_curve(Point_2(1, -1), Vector_2(3, 1), Vector_2(-1, 1));
  const Curve_3 tilted = SC::ellipse_curve(Point_3(0, 0, 1), Vector_3(2, 1, 2), Vector_3(1, 2, -2));
  for (int i = 0; i < rounds; ++i) {
    const FT t = FT(4) * random.fraction();
    // In the coordinates of the half axes.
    const Vector_2 p = ellipse(t) - Point_2(1, -1);
    const FT c = (p.x() + p.y()) / FT(4), s = (FT(3) * p.y() - p.x()) / FT(4);
    EXPECT_EQ(c * c + s * s, 1);
    // A circle, since the half axes have length 3 and are at a right angle.
    EXPECT_EQ(CGAL::squared_distance(tilted(t), Point_3(0, 0, 1)), 9);
    EXPECT_EQ((tilted(t) - Point_3(0, 0, 1)) * Vector_3(-2, 2, 1), 0);
  }
  EXPECT_EQ(ellipse(0), Point_2(4, 0));
  EXPECT_EQ(ellipse(1), Point_2(0, 0));
}

TEST(Circle_curve, in_space_needs_no_rational_length)
{
  Random_geometry random(5);
  for (int i = 0; i < rounds; ++i) {
    const std::vector<Point_3> p = random.points<Exact_cartesian, 3>(3);
    const Vector_3 axis = p[2] - CGAL::ORIGIN;
    if (CGAL::cross_product(axis, p[1] - p[0]) == CGAL::NULL_VECTOR)
      continue;
    const Curve_3 circle = SC::circle_curve(p[0], axis, p[1]);
    EXPECT_EQ(circle(0), p[1]);
    EXPECT_TRUE(circle.is_closed());
    for (const FT& w : circle.control_weights())
      EXPECT_GT(w, 0);
    const FT t = FT(4) * random.fraction();
    EXPECT_EQ(CGAL::squared_distance(circle(t), p[0]), CGAL::squared_distance(p[1], p[0]));
    EXPECT_EQ((circle(t) - p[1]) * axis, 0);
    // Counterclockwise around the axis.
    EXPECT_GT(CGAL::cross_product(circle(t) - p[0], circle.tangent(t)) * axis, 0);
  }
}

// The conic a point lies on, as left-hand side of its equation.
using Equation = FT (*)(const FT&, const FT&);

TEST(Conic_curve, through_five_points)
{
  Random_geometry random(6);
  const auto check = [&](const std::array<Point_2, 5>& points, Equation equation, const Curve_2& curve) {
    for (const Point_2& p : points)
      ASSERT_EQ(equation(p.x(), p.y()), 0);
    for (int i = 0; i < rounds; ++i) {
      const Point_2 p =
          curve(curve.domain().first + (curve.domain().second - curve.domain().first) * random.fraction());
      EXPECT_EQ(equation(p.x(), p.y()), 0);
    }
  };
  // x^2 + x y + y^2 = 7, all of it.
  const std::array<Point_2, 5> on_ellipse{Point_2(1, 2), Point_2(2, 1), Point_2(-1, 3), Point_2(3, -1),
                                          Point_2(-1, -2)};
  const Curve_2 ellipse = SC::conic_curve(on_ellipse);
  check(on_ellipse, [](const FT& x, const FT& y) { return FT(x * x + x * y + y * y - 7); }, ellipse);
  EXPECT_TRUE(ellipse.is_closed());
  EXPECT_EQ(ellipse.source(), on_ellipse[0]);
  const CGAL::Bbox_2 box = ellipse.bbox();
  EXPECT_TRUE(box.xmin() <= -3 && box.xmax() >= 3 && box.ymin() <= -3 && box.ymax() >= 3);

  // y = x^2 - x: polynomial, between the extreme points.
  const std::array<Point_2, 5> on_parabola{Point_2(1, 0), Point_2(0, 0), Point_2(-1, 2), Point_2(3, 6), Point_2(2, 2)};
  const Curve_2 parabola = SC::conic_curve(on_parabola);
  check(on_parabola, [](const FT& x, const FT& y) { return FT(x * x - x - y); }, parabola);
  EXPECT_FALSE(parabola.is_rational());
  EXPECT_EQ((std::min)(parabola.source(), parabola.target()), Point_2(-1, 2));
  EXPECT_EQ((std::max)(parabola.source(), parabola.target()), Point_2(3, 6));

  // x y = 1, one branch, between the extreme points.
  const std::array<Point_2, 5> on_hyperbola{Point_2(1, 1), Point_2(2, FT(1) / 2), Point_2(FT(1) / 3, 3),
                                            Point_2(5, FT(1) / 5), Point_2(3, FT(1) / 3)};
  const Curve_2 hyperbola = SC::conic_curve(on_hyperbola);
  check(on_hyperbola, [](const FT& x, const FT& y) { return FT(x * y - 1); }, hyperbola);
  EXPECT_EQ((std::min)(hyperbola.source(), hyperbola.target()), on_hyperbola[2]);
  EXPECT_EQ((std::max)(hyperbola.source(), hyperbola.target()), on_hyperbola[3]);

  expect_invalid(
      [] {
        SC::conic_curve<Exact_cartesian>(
            {Point_2(1, 1), Point_2(2, FT(1) / 2), Point_2(-1, -1), Point_2(4, FT(1) / 4), Point_2(-2, -FT(1) / 2)});
      },
      "both branches");
  expect_invalid(
      [] {
        SC::conic_curve<Exact_cartesian>({Point_2(0, 0), Point_2(1, 1), Point_2(2, 2), Point_2(0, 1), Point_2(5, 1)});
      },
      "pair of lines");
  expect_invalid(
      [] {
        SC::conic_curve<Exact_cartesian>({Point_2(3, 4), Point_2(1, 1), Point_2(2, 2), Point_2(0, 0), Point_2(5, 5)});
      },
      "more than one conic");
  expect_invalid(
      [] {
        SC::conic_curve<Exact_cartesian>({Point_2(3, 4), Point_2(3, 4), Point_2(2, 2), Point_2(1, 0), Point_2(5, 5)});
      },
      "more than one conic");
  const auto rounded = SC::conic_curve<CGAL::Epick>({CGAL::Epick::Point_2(1, 0), {0, 1}, {-1, 0}, {0, -1}, {0.6, 0.8}});
  for (int i = 0; i <= 40; ++i) {
    // 0.6 and 0.8 are not on the circle: the conic is the one through the doubles.
    const auto p = rounded(0.1 * i);
    EXPECT_NEAR(p.x() * p.x() + p.y() * p.y(), 1, 1e-14);
  }
}

TEST(Cubic_interpolation, passes_through_the_points_and_is_smooth)
{
  Random_geometry random(7);
  for (std::size_t n = 2; n <= 8; ++n) {
    const std::vector<Point_2> points = random.points<Exact_cartesian, 2>(n);
    std::vector<FT> parameters;
    for (std::size_t i = 0; i < n; ++i)
      parameters.push_back(i == 0 ? FT(-1) : parameters.back() + FT(random.integer(1, 9)) / FT(4));
    const Curve_2 natural = SC::cubic_interpolation_curve(points, parameters);
    const Vector_2 begin(1, 5), end(-3, FT(1) / 2);
    const Curve_2 clamped = SC::cubic_interpolation_curve(points, parameters, begin, end);
    for (const Curve_2& curve : {natural, clamped}) {
      EXPECT_EQ(curve.breaks(), parameters);
      for (std::size_t i = 0; i < n; ++i)
        EXPECT_EQ(curve(parameters[i]), points[i]);
      // Simple knots: twice continuously differentiable.
      EXPECT_EQ(curve.size(), n + 2);
    }
    EXPECT_EQ(natural.derivative(parameters.front(), 2), CGAL::NULL_VECTOR);
    EXPECT_EQ(natural.derivative(parameters.back(), 2), CGAL::NULL_VECTOR);
    EXPECT_EQ(clamped.tangent(parameters.front()), begin);
    EXPECT_EQ(clamped.tangent(parameters.back()), end);
  }
  // A cubic is its own spline.
  const Curve_3 cubic = SC::bezier_curve(random.points<Exact_cartesian, 3>(4));
  const std::vector<FT> parameters{0, FT(1) / 4, FT(1) / 3, 1};
  std::vector<Point_3> points;
  for (const FT& t : parameters)
    points.push_back(cubic(t));
  EXPECT_TRUE(SC::cubic_interpolation_curve(points, parameters, cubic.tangent(0), cubic.tangent(1)) == cubic);
}

TEST(Cubic_interpolation, doubles_agree_with_exact_numbers)
{
  Random_geometry random(8);
  std::vector<Double_point_2> points;
  for (int i = 0; i < 30; ++i)
    points.emplace_back(random.integer(-9, 9), random.integer(-9, 9));
  const auto curve = SC::cubic_interpolation_curve(points);
  std::vector<Point_2> exact_points;
  for (const Double_point_2& p : points)
    exact_points.emplace_back(FT(p.x()), FT(p.y()));
  const Curve_2 exact = SC::cubic_interpolation_curve(exact_points);
  for (int i = 0; i <= 290; ++i) {
    const auto q = exact(FT(i) / FT(10));
    const auto p = curve(i / 10.0);
    EXPECT_NEAR(p.x(), SC::to_nearest_double(q.x()), 1e-12);
    EXPECT_NEAR(p.y(), SC::to_nearest_double(q.y()), 1e-12);
  }
}

template <class Point, class Vector>
void check_hermite_curve(const std::vector<Point>& points, const std::vector<Vector>& velocities,
                         const std::vector<Vector>& accelerations, const std::vector<FT>& parameters)
{
  const auto curve = SC::hermite_curve(points, velocities, accelerations, parameters);
  EXPECT_EQ(curve.degree(), 5);
  EXPECT_EQ(curve.breaks(), parameters);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(curve(parameters[i]), points[i]);
    EXPECT_EQ(curve.derivative(parameters[i], 1), velocities[i]);
    EXPECT_EQ(curve.derivative(parameters[i], 2), accelerations[i]);
  }
  // From the left as well; and each piece is that of its two ends.
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const auto piece = curve.restricted(parameters[i], parameters[i + 1]);
    EXPECT_EQ(piece.derivative(parameters[i + 1], 1), velocities[i + 1]);
    EXPECT_EQ(piece.derivative(parameters[i + 1], 2), accelerations[i + 1]);
    EXPECT_TRUE(piece == SC::hermite_curve(std::vector<Point>{points[i], points[i + 1]},
                                           std::vector<Vector>{velocities[i], velocities[i + 1]},
                                           std::vector<Vector>{accelerations[i], accelerations[i + 1]},
                                           {parameters[i], parameters[i + 1]}));
  }
}

template <int d, class Vector>
std::vector<Vector> random_vectors(Random_geometry& random, std::size_t count)
{
  std::vector<Vector> result;
  for (const auto& p : random.points<Exact_cartesian, d>(count))
    result.push_back(p - CGAL::ORIGIN);
  return result;
}

TEST(Hermite_curve, has_the_given_derivatives)
{
  Random_geometry random(11);
  for (int round = 0; round < rounds; ++round) {
    const std::size_t n = 2 + round % 4;
    std::vector<FT> parameters;
    for (std::size_t i = 0; i < n; ++i)
      parameters.push_back(i == 0 ? FT(-1) : parameters.back() + FT(random.integer(1, 9)) / FT(4));
    check_hermite_curve(random.points<Exact_cartesian, 2>(n), random_vectors<2, Vector_2>(random, n),
                        random_vectors<2, Vector_2>(random, n), parameters);
    check_hermite_curve(random.points<Exact_cartesian, 3>(n), random_vectors<3, Vector_3>(random, n),
                        random_vectors<3, Vector_3>(random, n), parameters);
  }
}

TEST(Hermite_curve, repeats_quintic_curves)
{
  Random_geometry random(12);
  const Curve_3 quintic = SC::bezier_curve(random.points<Exact_cartesian, 3>(6));
  const std::vector<FT> parameters{0, FT(1) / 3, FT(1) / 2, 1};
  std::vector<Point_3> points;
  std::vector<Vector_3> velocities, accelerations;
  for (const FT& t : parameters) {
    points.push_back(quintic(t));
    velocities.push_back(quintic.derivative(t, 1));
    accelerations.push_back(quintic.derivative(t, 2));
  }
  EXPECT_TRUE(SC::hermite_curve(points, velocities, accelerations, parameters) == quintic);
  // (t^5, t) from 0 to 2.
  const Curve_2 power =
      SC::hermite_curve<Exact_cartesian>({Point_2(0, 0), Point_2(32, 2)}, {Vector_2(0, 1), Vector_2(80, 1)},
                                         {Vector_2(0, 0), Vector_2(160, 0)}, {0, 2});
  for (int i = 0; i <= 14; ++i) {
    const FT t = FT(i) / FT(7);
    EXPECT_EQ(power(t), Point_2(t * t * t * t * t, t));
  }
  // Integers from 0 on, in doubles: 6 t^5 - 15 t^4 + 10 t^3 is a half at a half.
  using P = Double_point_2;
  const std::vector<Double_cartesian::Vector_2> none(2, CGAL::NULL_VECTOR);
  EXPECT_EQ(SC::hermite_curve(std::vector<P>{P(0, 0), P(2, 4)}, none, none)(0.5), P(1, 2));
}

TEST(Curve_constructors, reject_bad_input)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using P = Double_point_2;
  using V = Double_cartesian::Vector_2;
  expect_invalid([] { SC::polyline_curve(std::vector<P>{P(0, 0)}); }, "at least 2");
  expect_invalid([] { SC::bezier_curve(std::vector<P>{P(0, 0)}); }, "at least 2");
  expect_invalid([&] { SC::segment_curve(P(0, nan), P(0, 0)); }, "control point 0");
  expect_invalid([] { SC::circle_curve(P(0, 0), 0.0); }, "not positive");
  expect_invalid([&] { SC::circle_curve(P(0, 0), nan); }, "not positive");
  expect_invalid([&] { SC::circle_curve(P(0, nan), 1); }, "NaN");
  expect_invalid([] { SC::circle_curve(P(1, 1), P(1, 1)); }, "zero");
  expect_invalid([] { SC::ellipse_curve(P(1, 1), V(1, 2), V(2, 4)); }, "parallel");
  expect_invalid([] { SC::circular_arc_curve(P(0, 0), P(1, 0), P(1, 0)); }, "different points");
  expect_invalid([] { SC::circular_arc_curve(P(0, 0), P(1, 0), P(0, 1), CGAL::COLLINEAR); }, "orientation");
  expect_invalid([] { SC::circular_arc_curve(Point_2(0, 0), Point_2(1, 0), Point_2(0, 2)); }, "different distances");
  expect_invalid([] { SC::circle_curve(Point_3(0, 0, 0), Vector_3(0, 0, 1), Point_3(0, 0, 2)); }, "on the axis");
  expect_invalid([] { SC::cubic_interpolation_curve(std::vector<P>{P(0, 0)}); }, "at least 2");
  expect_invalid([] { SC::cubic_interpolation_curve(std::vector<P>{P(0, 0), P(1, 1)}, {0, 1, 2}); }, "3 where 2");
  expect_invalid(
      [] {
        SC::cubic_interpolation_curve(std::vector<P>{P(0, 0), P(1, 1), P(2, 2)}, {0, 2, 2});
      },
      "parameter 2");
  expect_invalid([&] { SC::cubic_interpolation_curve(std::vector<P>{P(0, 0), P(1, nan), P(2, 2)}); }, "control point");
  const std::vector<V> zeros(2, CGAL::NULL_VECTOR);
  expect_invalid([&] { SC::hermite_curve(std::vector<P>{P(0, 0)}, zeros, zeros); }, "at least 2");
  expect_invalid([&] { SC::hermite_curve(std::vector<P>(3, P(1, 1)), zeros, zeros); }, "velocities");
  expect_invalid([&] { SC::hermite_curve(std::vector<P>(2, P(1, 1)), zeros, {V(1, 1)}); }, "accelerations");
  expect_invalid([&] { SC::hermite_curve(std::vector<P>(2, P(1, 1)), zeros, zeros, {1, 1}); }, "parameter 1");
  expect_invalid([&] { SC::hermite_curve(std::vector<P>(2, P(1, nan)), zeros, zeros); }, "control point");
  expect_invalid([&] { SC::conic_curve<Double_cartesian>({P(0, 0), P(1, nan), P(2, 2), P(0, 1), P(5, 1)}); }, "NaN");
}

} // namespace

} // namespace curve_constructors_test
