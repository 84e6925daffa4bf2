// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams of curves with lines that touch several of them at once, in ends, in joints, and elsewhere: edges go to infinity there. And of arcs that begin with curvature zero.
#include "voronoi_checks.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

// Complete diagrams with some number of edges that go to infinity: one for each segment between curves on the boundary of their convex hull.
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

Curve half_parabola(const P& vertex, double side) { return bezier({vertex, P(vertex.x() + side / 2, vertex.y()), P(vertex.x() + side, vertex.y() - 1)}); }

// The tangent in an end passes through the end of a segment, or of an arc whose tangent it is, too.
TEST(LinesAtInfinity, TangentsInEnds)
{
  expect_far_edges({bezier({P(0, 0), P(0.5, 0), P(1, 1)}), bezier({P(0, 0), P(0, -1)})}, 2);
  expect_far_edges({half_parabola(P(0, 0), 1), bezier({P(-2, 0), P(-3, -3)})}, 2);
  expect_far_edges({half_parabola(P(0, 0), 1), half_parabola(P(-1, 0), -1)}, 2);
  expect_far_edges({half_parabola(P(0, 0), 1), half_parabola(P(3, 0), 1)}, 3);
  expect_far_edges({bezier({P(12, 16), P(-13, -9), P(12, 16), P(-6, -8)}), bezier({P(-9, -12), P(-3, -4), P(2, 11)})}, 4);
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
  expect_far_edges({bezier({P(-1, -1), P(0, 2), P(-2, 1), P(0, 2)}), bezier({P(-1, -1), P(2, 0), P(1, -2), P(2, 0)})}, 3);
}
