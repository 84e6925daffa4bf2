// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves that nearly meet, made to meet exactly: planted ends, tangents, what stays as it is, and complete diagrams of
// forks whose points are rounded.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/joints/exact_joints_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace exact_joints_2_test {

using V = K::Vector_2;
using Exact = CGAL::Simple_cartesian<SC::Exact_rational>;
using Exact_curve = SC::Bspline_curve_2<Exact>;
using Joined = SC::Exact_joints_2<Exact>;

constexpr double rounding = 1e-12;

SC::Exact_rational part(int numerator, int denominator) { return SC::Exact_rational(numerator) / denominator; }

Joined joined(const Curves& curves, double most_distance = rounding, double most_angle = rounding)
{
  return SC::with_exact_joints<Exact>(curves, most_distance, most_angle);
}

Exact_curve exact(const Curve& curve) { return Exact_curve(curve); }

bool is_tangential(const Exact_curve& curve, const Exact::Vector_2& tangent)
{
  return CGAL::determinant(curve.tangent(curve.domain().first), tangent) == 0;
}

void expect_joined(const Joined& result, std::size_t joints, std::size_t left)
{
  EXPECT_EQ(result.joints, joints);
  EXPECT_EQ(result.left, left);
}

// Nothing is left to do.
void expect_settled(const Joined& result)
{
  const Joined again = SC::with_exact_joints<Exact>(result.curves, rounding, rounding);
  EXPECT_EQ(again.joints, 0U);
  EXPECT_EQ(again.displacement, 0);
  for (std::size_t i = 0; i < result.curves.size(); ++i)
    EXPECT_EQ(again.curves[i].control_points(), result.curves[i].control_points());
}

// Ends that are on curves at k/16 or k/10, but for rounding, are put there, with the tangent of the curve or without
// it.
TEST(ExactJoints, PlantedForks)
{
  std::mt19937 random(1);
  const auto coordinate = [&] { return std::round(std::uniform_real_distribution<double>(0, 100)(random)) * 0.1; };
  const auto point = [&] {
    const double x = coordinate(), y = coordinate();
    return P(x, y);
  };
  for (int i = 0; i < 200; ++i) {
    std::vector<P> points(2 + static_cast<std::size_t>(i % 3));
    for (P& p : points)
      p = point();
    const Curve trunk = bezier(points);
    const int denominator = i % 2 == 0 ? 16 : 10, numerator = 1 + static_cast<int>(random() % (denominator - 1));
    const double t = static_cast<double>(numerator) / denominator;
    const bool is_fork = i % 4 < 2;
    const P begin = trunk(t), next = is_fork ? begin + 0.3 * trunk.tangent(t) : point();
    const Joined result = joined({trunk, bezier({begin, next, point(), point()})});
    SCOPED_TRACE(i);
    EXPECT_EQ(result.left, 0U);
    EXPECT_LT(result.displacement, 1e-13);
    EXPECT_EQ(result.curves[0].control_points(), exact(trunk).control_points());
    EXPECT_EQ(result.curves[1](0), result.curves[0](part(numerator, denominator)));
    EXPECT_EQ(is_tangential(result.curves[1], result.curves[0].tangent(part(numerator, denominator))), is_fork);
    expect_settled(result);
  }
}

// Of curves that leave a slanted segment or a circle, also as a segment does, or without curvature, and in a point
// where two pieces of the circle join.
TEST(ExactJoints, DiagramsOfForksAreComplete)
{
  const P a(0.1, 0.3), b(7.3, 2.6), c(3.2, 1.7);
  const V way = b - a;
  const P in_segment = a + 0.3 * way, on_circle = c + 0.7 * V(std::cos(1.1), std::sin(1.1)), in_joint = c + V(0, 0.7);
  const V tangent(-std::sin(1.1), std::cos(1.1));
  const Curve segment = bezier({a, b}), circle = SC::circle_curve(c, 0.7);
  for (const Curves& curves :
       {Curves{segment, bezier({in_segment, in_segment + 0.2 * way, P(3.1, 5.2), P(4.1, 4.7)})},
        Curves{segment, bezier({in_segment, in_segment - 0.2 * way, in_segment - 0.4 * way, P(4.1, 4.7)})},
        Curves{circle, bezier({on_circle, on_circle + tangent, P(0.1, 4.7)})},
        Curves{circle, bezier({on_circle, on_circle + tangent})},
        Curves{circle, bezier({in_joint, in_joint + V(0.5, 0)})}}) {
    const Joined result = joined(curves);
    EXPECT_GT(result.joints, 0U);
    EXPECT_EQ(result.left, 0U);
    EXPECT_LT(result.displacement, 1e-14);
    const auto diagram = SC::voronoi_diagram(result.curves);
    EXPECT_TRUE(diagram.is_complete());
    EXPECT_EQ(diagram.number_of_regions(), 1U);
    EXPECT_GT(diagram.edges().size(), 0U);
    expect_euler(diagram);
  }
}

// Ends within the distance become one point, that of the first curve. Their pieces keep their directions, and straight
// ones stay straight; a piece shorter than the distance stays.
TEST(ExactJoints, EndsBecomeOnePoint)
{
  const double e = 0x1p-10;
  const Curves curves{bezier({P(0, 0), P(4, 0)}), bezier({P(4, e), P(5, 1 + e), P(7, 3), P(8, 0)}),
                      bezier({P(4 + e, 0), P(5, -1), P(6 - e, -2)}), bezier({P(8, 0), P(8 + e, 0)}),
                      bezier({P(8 + e, 0), P(9, 4)})};
  const Joined result = joined(curves, 2 * e, 0);
  expect_joined(result, 2, 0);
  EXPECT_EQ(result.displacement, e);
  const auto first = result.curves[1].control_points(), straight = result.curves[2].control_points();
  EXPECT_EQ(first[0], Exact::Point_2(4, 0));
  EXPECT_EQ(first[1], Exact::Point_2(5, 1));
  EXPECT_EQ(first[2], Exact::Point_2(7, 3));
  EXPECT_EQ(straight[0], Exact::Point_2(4, 0));
  EXPECT_TRUE(CGAL::collinear(straight[0], straight[1], straight[2]));
  EXPECT_NE(straight[1], exact(curves[2]).control_points()[1]);
  EXPECT_EQ(result.curves[3].control_points(), exact(curves[3]).control_points());
}

// Curves end on others that end on others; a curve ends on itself; a polygon has a corner on the edge of another one;
// and closed curves stay closed.
TEST(ExactJoints, OneAfterTheOther)
{
  const double e = 0x1p-30;
  // each on the next one
  const Curves curves{bezier({P(1 - 2 * e, 2 + e), P(0, 3)}), bezier({P(0, e), P(2, 4)}), bezier({P(-1, -1), P(1, 1)}),
                      // on its own first piece
                      Curve(1, {0, 0, 1, 2, 3, 4, 4}, {P(10, 0), P(14, 0), P(14, 3), P(12, 3), P(12, e)}),
                      // polygons
                      Curve(1, {0, 0, 1, 2, 3, 3}, {P(20, 0), P(23, 0), P(20, 3), P(20, 0)}),
                      Curve(1, {0, 0, 1, 2, 3, 3}, {P(21, -2), P(22, -2), P(21.5, -e), P(21, -2)})};
  const Joined result = joined(curves, 4 * e, 0);
  EXPECT_EQ(result.left, 0U);
  EXPECT_EQ(result.curves[2].control_points(), exact(curves[2]).control_points());
  EXPECT_EQ(result.curves[1](0), Exact::Point_2(0, 0));
  EXPECT_EQ(result.curves[0](0), Exact::Point_2(1, 2));
  EXPECT_EQ(result.curves[3](4), Exact::Point_2(12, 0));
  EXPECT_EQ(result.curves[5](2).y(), 0);
  EXPECT_EQ(result.curves[5](0), result.curves[5](3));
  expect_settled(result);
}

// A corner nearly as straight as a line, where one of the sides can be moved, and one where none can; a curve between
// two forks with one control point for both.
TEST(ExactJoints, Tangents)
{
  const double e = 0x1p-40;
  const Curve line = bezier({P(0, 0), P(4, 0)}), curve = bezier({P(4, 0), P(6, e), P(7, 2), P(7, 3)});
  const Joined turned = joined({line, curve});
  expect_joined(turned, 1, 0);
  EXPECT_EQ(turned.curves[1].control_points()[1], Exact::Point_2(6, 0));
  expect_joined(joined({line, bezier({P(4, 0), P(8, e)}), bezier({P(8, e), P(9, 3)})}), 0, 1);
  const Joined fork = joined({line, bezier({P(8, -4), P(8, 4)}), bezier({P(2, 0), P(8 + e, e), P(8, 2)})});
  expect_joined(fork, 1, 1);
  EXPECT_TRUE(is_tangential(fork.curves[2], Exact::Vector_2(1, 0)));
}

// What is smooth already stays as it is, also where it is as flat as the distance; and what is flat in a fork stays
// flat.
TEST(ExactJoints, ShapesStay)
{
  const Curves smooth{bezier({P(0, 0), P(1, 0.125), P(2, 0.25), P(3, 0.25)}),
                      bezier({P(3, 0.25), P(4, 0.25), P(5, 0.125), P(6, 0)}), SC::circle_curve(P(10, 0), 0.25)};
  const Joined same = joined(smooth, 0.25, 0.1);
  expect_joined(same, 0, 0);
  for (std::size_t i = 0; i < smooth.size(); ++i)
    EXPECT_EQ(same.curves[i].control_points(), exact(smooth[i]).control_points());
  const Joined fork =
      joined({bezier({P(0, 0), P(8, 4)}), bezier({P(2, 1.25), P(3, 1.75), P(4, 2.25), P(4, 7)})}, 0.5, 0.1);
  expect_joined(fork, 1, 0);
  const auto points = fork.curves[1].control_points();
  for (const std::size_t i : {0U, 1U, 2U})
    EXPECT_EQ(points[i].x(), 2 * points[i].y());
  EXPECT_EQ(points[3], Exact::Point_2(4, 7));
}

// A tangent of two circles touches one of them at most; a point beside a crossing is on one curve at most; and of three
// segments each of which ends on the next one, one stays. Copies of a curve are one.
TEST(ExactJoints, WhatIsLeft)
{
  const P a(0.3, 0.2), b(8.6, 0.2);
  const double angle = std::acos((1.5 - 2.5) / 8.3);
  const V normal(std::cos(angle), std::sin(angle));
  const Joined belt =
      joined({SC::circle_curve(a, 1.5), SC::circle_curve(b, 2.5), bezier({a + 1.5 * normal, b + 2.5 * normal})});
  expect_joined(belt, 2, 2);
  const double e = 0x1p-45;
  expect_joined(joined({bezier({P(0, 0), P(4, 4)}), bezier({P(0, 4), P(4, 0)}), bezier({P(2, 2 + e), P(3, 9)})}), 0, 1);
  expect_joined(
      joined({bezier({P(-1, 0), P(2 + e, 0)}), bezier({P(2, -1), P(2, 3 + e)}), bezier({P(2.5, 4.5), P(1, e)})}), 2, 1);
  const Curve wall = bezier({P(0, 0), P(3, 1), P(6, 0)});
  const Joined copies = joined({wall, bezier({P(6, 0), P(3, 1), P(0, 0)}), bezier({P(3, 0.5 + e), P(3, 4)})});
  expect_joined(copies, 1, 0);
  EXPECT_EQ(copies.curves[2](0), Exact::Point_2(3, part(1, 2)));
}

// Splines that go on smoothly do so afterwards, and ends of curves without clamped knots stay where they are.
TEST(ExactJoints, Splines)
{
  const double e = 0x1p-30;
  const Curve spline(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2},
                     {P(0, 0), P(1, 1), P(2, 1 + e), P(3, 1 + e), P(4, 1 + e), P(5, 0), P(6, 0)});
  const Joined result = joined({bezier({P(0, 1), P(9, 1)}), spline}, 4 * e, 1e-3);
  EXPECT_EQ(result.left, 0U);
  const auto points = result.curves[1].control_points();
  for (const std::size_t i : {2U, 3U, 4U})
    EXPECT_EQ(points[i].y(), 1) << i;
  EXPECT_EQ(points[0], Exact::Point_2(0, 0));
  const Curve free(2, {0, 1, 2, 3, 4, 5}, {P(1, 2), P(3, 1 + e), P(5, 2)});
  const Joined untouched = joined({bezier({P(0, 1), P(9, 1)}), free}, 4 * e, 1e-3);
  expect_joined(untouched, 0, 0);
  EXPECT_EQ(untouched.curves[1].control_points(), exact(free).control_points());
}

TEST(ExactJoints, Exceptions)
{
  const Curves curves{bezier({P(0, 0), P(1, 0)})};
  EXPECT_THROW(joined(curves, -1, 0), SC::Invalid_input);
  EXPECT_THROW(joined(curves, std::numeric_limits<double>::infinity(), 0), SC::Invalid_input);
  EXPECT_THROW(joined(curves, std::numeric_limits<double>::quiet_NaN(), 0), SC::Invalid_input);
  EXPECT_THROW(joined(curves, 0, -1), SC::Invalid_input);
  EXPECT_THROW(joined(curves, 0, 1), SC::Invalid_input);
  EXPECT_EQ(joined({}, 0, 0).curves.size(), 0U);
}

} // namespace exact_joints_2_test
