// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams where arcs join smoothly, and where disks touch four sites or more: medial axes in closed form,
// random smooth splines, and the signs of polynomials near a zero of theirs.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Blown_up_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Disk_curvature.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Graph_of_crossing_curves_2.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace smooth_joints_2_test {

using V = K::Vector_2;

// A quarter of an ellipse, exactly.
Curve quarter(const P& center, const V& from, const V& to)
{
  const P a = center + from, b = center + to, corner = center + (from + to);
  return Curve(2, {0, 0, 0, 1, 1, 1}, {a, corner, b}, {1, 1, 2});
}

// The vertices with a number of edges, by their first coordinates and radii.
std::vector<std::pair<double, double>> vertices_of_degree(const Diagram& diagram, std::size_t degree)
{
  std::vector<std::pair<double, double>> result;
  for (const auto& vertex : diagram.vertices())
    if (!vertex.is_at_infinity && vertex.edges.size() == degree)
      result.emplace_back(vertex.point->x(), *vertex.radius);
  std::sort(result.begin(), result.end());
  return result;
}

void expect_vertices(const Diagram& diagram, std::size_t degree, const std::vector<std::pair<double, double>>& expected)
{
  const auto found = vertices_of_degree(diagram, degree);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_NEAR(found[i].first, expected[i].first, 1e-9);
    EXPECT_NEAR(found[i].second, expected[i].second, 1e-9);
  }
}

// The ends of its medial axis are the centers of curvature (+-3/2, 0), where two of its pieces join.
TEST(SmoothJoints, Ellipse)
{
  const Curves curves{SC::ellipse_curve(P(0, 0), V(2, 0), V(0, 1))};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_vertices(diagram, 1, {{-1.5, 0.5}, {1.5, 0.5}});
  expect_vertices(diagram, 2, {{0, 1}});   // the pieces change
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    for (const auto& sample : diagram.polyline(e, 0.01))
      EXPECT_NEAR(sample.point.y(), 0, 1e-12);
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// Segments and quarters of circles: the axis has its tips in the centers of the circles.
TEST(SmoothJoints, RoundedRectangle)
{
  const Curves curves{bezier({P(2, 0), P(10, 0)}),  quarter(P(10, 2), V(0, -2), V(2, 0)),
                      bezier({P(12, 2), P(12, 5)}), quarter(P(10, 5), V(2, 0), V(0, 2)),
                      bezier({P(10, 7), P(2, 7)}),  quarter(P(2, 5), V(0, 2), V(-2, 0)),
                      bezier({P(0, 5), P(0, 2)}),   quarter(P(2, 2), V(-2, 0), V(0, -2))};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_vertices(diagram, 1, {{2, 2}, {2, 2}, {10, 2}, {10, 2}});
  expect_vertices(diagram, 3, {{3.5, 3.5}, {8.5, 3.5}});
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

TEST(SmoothJoints, Stadium)
{
  const Curves curves{bezier({P(0, 0), P(10, 0)}),         quarter(P(10, 2), V(0, -2), V(2, 0)),
                      quarter(P(10, 2), V(2, 0), V(0, 2)), bezier({P(10, 4), P(0, 4)}),
                      quarter(P(0, 2), V(0, 2), V(-2, 0)), quarter(P(0, 2), V(-2, 0), V(0, -2))};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.edges().size(), 1U);
  expect_vertices(diagram, 1, {{0, 2}, {10, 2}});
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// Arcs with a common tangent and any curvatures: the footpoint leaves a joint as the square root of the distance from
// it.
TEST(SmoothJoints, Drop)
{
  const Curves curves{bezier({P(0, 0), P(3, 0), P(5, 2), P(5, 4)}), bezier({P(5, 4), P(5, 6), P(3, 7), P(0, 7)}),
                      bezier({P(0, 7), P(-3, 7), P(-4, 5), P(-4, 3.5)}),
                      bezier({P(-4, 3.5), P(-4, 1), P(-2, 0), P(0, 0)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(counts(diagram).tips, counts(diagram).branching + 2);   // a tree
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// A line goes on straight, and a curve leaves it: disks on that side go over from the line to the curve.
TEST(SmoothJoints, Branch)
{
  const Curves curves{bezier({P(0, 0), P(12, 0)}), bezier({P(0, 0), P(0, -4)}), bezier({P(0, -4), P(0, -16)}),
                      bezier({P(0, -4), P(0, -8), P(1, -10), P(2, -12)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// Disks in the corner touch the segment that goes on as a curve, but in its joint only larger ones than those that
// touch the curve.
TEST(SmoothJoints, MaximumBehindTheJoint)
{
  const Curves curves{bezier({P(0, 32000), P(0, 0)}),
                      bezier({P(0, 0), P(1500, 0)}),
                      bezier({P(1500, 0), P(5500, 0), P(9000, 1800), P(12000, 2500)}),
                      bezier({P(6000, -4000), P(6000, 31000)}),
                      bezier({P(2814, -6000), P(2814, 639)}),
                      bezier({P(2814, 639), P(15500, 4029)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_GT(diagram.edges().size(), 0U);
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// Next to the end of a curve, a segment goes on: the disks through its points there have a maximum, and negative
// curvatures elsewhere, which have one, too.
TEST(SmoothJoints, EndNextToSegment)
{
  const Curves curves{quarter(P(0, 8), V(-8, 0), V(0, -8)), bezier({P(0, 0), P(0.25, 0), P(3, 0), P(5.75, -3)}),
                      bezier({P(-1, -2.5), P(8, -3.25)}), bezier({P(-1.75, -9), P(-1.125, -10.75)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_GT(diagram.edges().size(), 0U);
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// Closed splines with one and two continuous derivatives, with control points and knots on a grid: as exact as doubles
// are.
TEST(SmoothJoints, RandomClosedSplines)
{
  std::mt19937 random(5);
  for (int run = 0; run < 4; ++run) {
    const int degree = run % 2 == 0 ? 3 : 2, n = 5 + run % 3;
    std::vector<P> points;
    std::vector<double> knots{0};
    for (int i = 0; i < n; ++i) {
      const double angle = 2 * CGAL_PI * i / n, radius = 3 + std::uniform_real_distribution<double>(0, 4)(random);
      points.emplace_back(std::round(64 * radius * std::cos(angle)) / 64,
                          std::round(64 * radius * std::sin(angle)) / 64);
      knots.push_back(knots.back() + (4 + std::uniform_int_distribution<int>(0, 7)(random)) / 8.0);
    }
    const Curves curves{Curve::from_periodic(degree, knots, points)};
    const Diagram diagram = SC::voronoi_diagram(curves);
    EXPECT_TRUE(diagram.is_complete()) << "run " << run;
    EXPECT_GT(diagram.edges().size(), 0U);
    expect_euler(diagram);
    if (run == 0)
      expect_empty_disks(diagram, curves);
  }
}

Curves polygon(const std::vector<P>& points)
{
  Curves result;
  for (std::size_t i = 0; i < points.size(); ++i)
    result.push_back(bezier({points[i], points[(i + 1) % points.size()]}));
  return result;
}

TEST(CommonDisks, Square)
{
  const Curves curves = polygon({P(0, 0), P(4, 0), P(4, 4), P(0, 4)});
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_vertices(diagram, 4, {{2, 2}});
  EXPECT_EQ(diagram.edges().size(), 4U);
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// Points on one circle, whose center is the only vertex.
TEST(CommonDisks, PointsOfACircle)
{
  const std::vector<P> points{P(5, 0), P(4, 3), P(3, 4), P(0, 5), P(-3, 4), P(-5, 0), P(-4, -3), P(0, -5), P(3, -4)};
  const Diagram diagram = SC::voronoi_diagram(Curves(), points);
  EXPECT_TRUE(diagram.is_complete());
  expect_vertices(diagram, points.size(), {{0, 5}});
  EXPECT_EQ(diagram.edges().size(), points.size());
  expect_euler(diagram);
}

// Four squares: one vertex in each, and one between all of them. Footpoints change from sides to corners where the
// element ends.
TEST(CommonDisks, AlignedSquares)
{
  Curves curves;
  for (const double x : {0.0, 3.0})
    for (const double y : {0.0, 3.0})
      for (const Curve& side : polygon({P(x, y), P(x + 1, y), P(x + 1, y + 1), P(x, y + 1)}))
        curves.push_back(side);
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.number_of_regions(), 8U - 4U);
  expect_vertices(diagram, 4, {{0.5, 0.5}, {0.5, 0.5}, {2, std::sqrt(2.0)}, {3.5, 0.5}, {3.5, 0.5}});
  expect_euler(diagram);
}

// A vertex of four sites that the coordinates of doubles miss by a little is two vertices.
TEST(CommonDisks, NearlyASquare)
{
  const Diagram diagram = SC::voronoi_diagram(polygon({P(0, 0), P(4 + 1e-6, 0), P(4 + 1e-6, 4), P(0, 4)}));
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(vertices_of_degree(diagram, 3).size(), 2U);
}

// Between parallel walls, one of which goes over to a third wall in a corner that is rounder than the unit circle: the
// unit disk touches the walls where the corner begins and ends, and the other wall.
TEST(CommonDisks, TwoJointsAndAWall)
{
  const Curves curves{bezier({P(0, 1), P(-0.5625, 1), P(-1, 0.5625), P(-1, 0)}), bezier({P(3, 1), P(0, 1)}),
                      bezier({P(-1, 0), P(-1, -3)}), bezier({P(1, 0.5), P(1, -3)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, curves, 0.1, 20);
  const auto is_common = [](const auto& vertex) {
    return !vertex.is_at_infinity && vertex.edges.size() == 3 && distance(*vertex.point, P(0, 0)) < 1e-9 &&
        std::abs(*vertex.radius - 1) < 1e-9;
  };
  EXPECT_EQ(std::count_if(diagram.vertices().begin(), diagram.vertices().end(), is_common), 1);
}

SC::internal::Voronoi::Sign_pattern pattern(const SC::Power_polynomial& p, double a, double b)
{
  const SC::Upward_rounding_guard guard;
  return SC::internal::Voronoi::Blown_up_polynomial::without_common_powers(p).pattern({0, a}, {0, b});
}

// Small ranges on both sides of a joint in which the curvature jumps, the one at the square of the distance of the
// other: the bounds hold those of points, and tell the second derivative equally well at all distances.
TEST(SmoothJoints, CurvaturesBesideAJoint)
{
  namespace internal = SC::internal;
  const Curves curves{bezier({P(-3, 2), P(-2, 0), P(-1, 0), P(0, 0)}), bezier({P(0, 0), P(2, 0), P(3, 3), P(2, 5)})};
  const auto graph = internal::Voronoi::graph_of_crossing_curves<CGAL::Sequential_tag>(
      internal::Voronoi::planar_operands(curves, std::vector<P>()));
  const internal::Voronoi::Disk_curvature<> curvature(*graph);
  std::size_t compared = 0;
  std::mt19937 random(1);
  for (std::size_t f = 0; f < graph->elements().size(); ++f) {
    const internal::Voronoi::Oriented_element<>& element = graph->elements()[f];
    if (element.is_normal_cone)
      continue;
    const auto& next = graph->continuation({element.object, true});
    if (!next || next->end.is_end)
      continue;
    for (const double b : {0x1p-6, 0x1p-12, 0x1p-18}) {
      const auto number = [&](double begin, double width) {
        return std::uniform_real_distribution<double>(begin, begin + width)(random);
      };
      const double a = b * b, width_u = a / 64, width_v = std::ldexp(b, -20);
      const auto bounds = [&](const internal::Common::Range& u, const internal::Common::Range& v) {
        return curvature(curvature.part(f, u), next->end.arc, v, graph->arcs()[next->end.arc].jet(v));
      };
      const CGAL::Protect_FPU_rounding<true> guard;
      const auto k = bounds({1 - a, 1 - a + width_u}, {b, b + width_v});
      EXPECT_TRUE(std::isfinite(k.du.sup() - k.du.inf()));
      EXPECT_LT(k.dvv.sup() - k.dvv.inf(), 0.1 * std::abs(k.dvv.sup()));
      for (int i = 0; i < 100; ++i, ++compared) {
        const double u = number(1 - a, width_u), v = number(b, width_v);
        const auto at = bounds({u, u}, {v, v});
        const auto meets = [](const auto& x, const auto& y) { return x.inf() <= y.sup() && y.inf() <= x.sup(); };
        EXPECT_TRUE(meets(at.value, k.value) && meets(at.du, k.du) && meets(at.dv, k.dv) && meets(at.dvv, k.dvv) &&
                    meets(at.duv, k.duv))
            << f << " " << u << " " << v;
      }
    }
  }
  EXPECT_GT(compared, 500U);
}

TEST(BlownUpPolynomials, SignsNearAZero)
{
  using SC::internal::Voronoi::Sign_pattern;
  const SC::Power_polynomial a = SC::Power_polynomial::variable(0), b = SC::Power_polynomial::variable(1);
  EXPECT_EQ(pattern(a + b, 0.1, 0.5), Sign_pattern::POSITIVE);
  EXPECT_EQ(pattern(-a * b - b * b * b, 0.1, 0.5), Sign_pattern::NEGATIVE);
  EXPECT_EQ(pattern(a - b, 0.1, 0.5), Sign_pattern::FALLING);
  EXPECT_EQ(pattern(b - a, 0.1, 0.5), Sign_pattern::UNKNOWN);
  EXPECT_EQ(pattern(a - b * b, 0.01, 0.5), Sign_pattern::FALLING);          // a parabola: b is a square root
  EXPECT_EQ(pattern(a * a * b - b * b * b, 0.01, 0.5), Sign_pattern::FALLING);
  EXPECT_EQ(pattern(a * a + b * b - a * b, 0.1, 0.5), Sign_pattern::POSITIVE);
  EXPECT_EQ(pattern((a - b) * (a - 2 * b), 0.1, 0.5), Sign_pattern::UNKNOWN);
  EXPECT_EQ(pattern(-a * a - pow(b, 4), 0.1, 0.5), Sign_pattern::NEGATIVE);   // also where b^2 is a
  EXPECT_EQ(pattern(a * a + pow(b, 4) - a * a * b, 0.1, 0.5), Sign_pattern::POSITIVE);
  EXPECT_EQ(pattern(a * a + pow(b, 4) - 2 * a * b * b, 0.1, 0.5), Sign_pattern::UNKNOWN);
  EXPECT_EQ(pattern(SC::Power_polynomial(), 0.1, 0.5), Sign_pattern::ZERO);
}

} // namespace smooth_joints_2_test
