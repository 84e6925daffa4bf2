// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams of curves with lines that touch several of them at once, in ends, in joints, and elsewhere: edges go
// to infinity there. And of arcs that begin with curvature zero.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace lines_at_infinity_2_test {

// Complete diagrams with some number of edges that go to infinity: one for each segment between curves on the boundary
// of their convex hull.
void expect_far_edges(const Curves& curves, std::size_t number, const std::vector<P>& points = {})
{
  const Diagram diagram = SC::voronoi_diagram(curves, points);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, curves, 0.05, 30);
  std::size_t far = 0;
  for (const auto& vertex : diagram.vertices())
    far += vertex.is_at_infinity ? vertex.edges.size() : 0;
  EXPECT_EQ(far, number);
}

Curve half_parabola(const P& vertex, double side)
{
  return bezier({vertex, P(vertex.x() + side / 2, vertex.y()), P(vertex.x() + side, vertex.y() - 1)});
}

// The tangent in an end passes through the end of a segment, or of an arc whose tangent it is, too.
TEST(LinesAtInfinity, TangentsInEnds)
{
  expect_far_edges({bezier({P(0, 0), P(0.5, 0), P(1, 1)}), bezier({P(0, 0), P(0, -1)})}, 2);
  expect_far_edges({half_parabola(P(0, 0), 1), bezier({P(-2, 0), P(-3, -3)})}, 2);
  expect_far_edges({half_parabola(P(0, 0), 1), half_parabola(P(-1, 0), -1)}, 2);
  expect_far_edges({half_parabola(P(0, 0), 1), half_parabola(P(3, 0), 1)}, 3);
  expect_far_edges({bezier({P(12, 16), P(-13, -9), P(12, 16), P(-6, -8)}), bezier({P(-9, -12), P(-3, -4), P(2, 11)})},
                   4);
}

// The half-plane above the axis touches an end, or a point, and two halves of a parabola where these join.
TEST(LinesAtInfinity, TangentsInJoints)
{
  const Curves parabola{half_parabola(P(0, 0), 1), half_parabola(P(0, 0), -1)};
  expect_far_edges(parabola, 3, {P(-3, 0)});
  Curves curves = parabola;
  curves.push_back(half_parabola(P(4, 0), 1));
  expect_far_edges(curves, 3);
}

// The half-plane right of a line touches an end, and two curves where these touch each other: two ellipses, one in the
// other, and chains, of which one is behind the other.
TEST(LinesAtInfinity, TangentsWhereCurvesTouch)
{
  const auto ellipse = [](double height) { return SC::ellipse_curve(P(5, 2), {1, 0}, {0, height}); };
  expect_far_edges({ellipse(3), ellipse(2), bezier({P(6, 8), P(5, 10)})}, 2);
  const auto chain = [](const P& first, double length, const P& last) {
    return Curve(2, {0, 0, 0, 1, 1, 2, 2, 2}, {first, P(8, 4 - length), P(8, 4), P(8, 4 + length), last});
  };
  const Curves chains{chain(P(5, 4), 1, P(5, 6)), chain(P(4, 8), 2, P(7, 7))};
  expect_far_edges({chains[0], chains[1], bezier({P(8, 0), P(6, 6)})}, 4);
  expect_far_edges(chains, 4, {P(8, 9)});
}

// The tangent in the end of a curve touches another one, and both are cut at parameters that are not rational.
TEST(LinesAtInfinity, TangentsOfCurvesThatCross)
{
  expect_far_edges({bezier({P(5, 4), P(5, 1), P(4, 2)}), bezier({P(4, 3), P(6, 0), P(4, 2)})}, 3);
}

// A box with corners of parabolas, on the axis.
Curves rounded_box(double x)
{
  const auto corner = [](const P& from, const P& to, const P& by) { return bezier({from, by, to}); };
  return {bezier({P(x + 0.5, 0), P(x + 1.5, 0)}), corner(P(x + 1.5, 0), P(x + 2, 0.5), P(x + 2, 0)),
          bezier({P(x + 2, 0.5), P(x + 2, 1.5)}), corner(P(x + 2, 1.5), P(x + 1.5, 2), P(x + 2, 2)),
          bezier({P(x + 1.5, 2), P(x + 0.5, 2)}), corner(P(x + 0.5, 2), P(x, 1.5), P(x, 2)),
          bezier({P(x, 1.5), P(x, 0.5)}),         corner(P(x, 0.5), P(x + 0.5, 0), P(x, 0))};
}

// Turned, and five times as large.
Curves turned(const Curves& curves)
{
  Curves result;
  for (const Curve& curve : curves) {
    std::vector<P> points;
    for (const P& p : curve.control_points())
      points.emplace_back(3 * p.x() - 4 * p.y(), 4 * p.x() + 3 * p.y());
    result.push_back(bezier(points));
  }
  return result;
}

// As drawings are: all on one line, which y = x^2 touches inside of an arc.
TEST(LinesAtInfinity, SegmentsOnTangents)
{
  const Curve parabola = bezier({P(-1, 1), P(0, -1), P(1, 1)});
  const auto segment = [](double from, double to) { return bezier({P(from, 0), P(to, 0)}); };
  const auto with = [&](const std::vector<Curves>& others) {
    Curves result{parabola};
    for (const Curves& curves : others)
      result.insert(result.end(), curves.begin(), curves.end());
    return result;
  };
  const std::vector<std::pair<Curves, std::size_t>> scenes{
    {with({{segment(3, 5)}}), 3},
    {with({{segment(3, 5), segment(6, 7), segment(-3, -2)}}), 6},
    {with({{segment(3, 5), bezier({P(5, 0), P(5, 2)}), bezier({P(5, 2), P(3, 2)}), bezier({P(3, 2), P(3, 0)})}}), 2},
    {with({{segment(3, 4), bezier({P(4, 0), P(5, 0), P(6, 1)})}}), 3},
    {with({{segment(4, 3), bezier({P(4, 0), P(5, 0), P(6, 1)}), bezier({P(8, 1), P(9, -1), P(10, 1)})}}), 6},
    {with({rounded_box(3)}), 2},
    {with({rounded_box(3), rounded_box(-5)}), 3}};
  for (const auto& [curves, number] : scenes) {
    expect_far_edges(curves, number);
    expect_far_edges(turned(curves), number);
  }
}

// The axis touches the curve y = -3 (x^2 - 2)^2 at the roots of 2, and the end of another one.
TEST(LinesAtInfinity, PointsThatAreNotRational)
{
  const Curve waves = bezier({P(-2, -12), P(-1, 36), P(0, -76), P(1, 36), P(2, -12)});
  expect_far_edges({waves}, 3);
  expect_far_edges({waves, half_parabola(P(4, 0), 1)}, 5);
}

// The curvature is zero in an end if the next two control points are in its tangent.
TEST(LinesAtInfinity, FlatEnds)
{
  expect_far_edges({bezier({P(0, 0), P(1, 0), P(2, 0), P(3, 1)})}, 1);
  expect_far_edges({bezier({P(1, 2), P(0, -2), P(0, -2), P(-2, -2)}), bezier({P(-2, -2), P(-3, -2), P(-2, 1)})}, 1);
  expect_far_edges({bezier({P(-1, -1), P(0, 2), P(-2, 1), P(0, 2)}), bezier({P(-1, -1), P(2, 0), P(1, -2), P(2, 0)})},
                   3);
}

} // namespace lines_at_infinity_2_test
