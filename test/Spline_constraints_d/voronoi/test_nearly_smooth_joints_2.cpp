// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams and offsets of curves with joints that are smooth but for rounding: as complete as those of exactly
// smooth ones, with the same areas, and with the bisector of each corner.
#include "polygon_area.h"
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/smooth_joints.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace nearly_smooth_joints_2_test {

using Exact = CGAL::Simple_cartesian<SC::Exact_rational>;
using Exact_curves = std::vector<SC::Bspline_curve_2<Exact>>;

// Closed chains of cubics; those that meet have the same tangent, up to what rounding makes of it.
Curves closed_chain(unsigned seed, double angle, double grid)
{
  std::mt19937 random(seed);
  const int n = 4 + static_cast<int>(seed % 4);
  const auto place = [&](double x, double y) {
    return P(std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y);
  };
  const auto on_grid = [&](double x) { return std::round(x * grid) / grid; };
  std::vector<std::pair<double, double>> points, tangents;
  for (int i = 0; i < n; ++i) {
    const double direction = 2 * CGAL_PI * i / n, radius = 3 + std::uniform_real_distribution<double>(0, 4)(random);
    points.emplace_back(on_grid(radius * std::cos(direction)), on_grid(radius * std::sin(direction)));
  }
  for (int i = 0; i < n; ++i) {
    const auto &a = points[(i + n - 1) % n], &b = points[(i + 1) % n];
    const double length = std::uniform_real_distribution<double>(0.12, 0.22)(random);
    tangents.emplace_back(on_grid(length * (b.first - a.first)), on_grid(length * (b.second - a.second)));
  }
  Curves result;
  for (int i = 0; i < n; ++i) {
    const int j = (i + 1) % n;
    result.push_back(bezier({place(points[i].first, points[i].second),
                             place(points[i].first + tangents[i].first, points[i].second + tangents[i].second),
                             place(points[j].first - tangents[j].first, points[j].second - tangents[j].second),
                             place(points[j].first, points[j].second)}));
  }
  return result;
}

// Decimal numbers, as in most drawings, and any numbers.
TEST(NearlySmoothJoints, DiagramsAreComplete)
{
  for (const unsigned seed : {0U, 2U, 3U, 4U, 5U, 7U}) {
    const Curves curves = closed_chain(seed, seed % 2 == 0 ? 0 : 0.3, 1000);
    const Diagram diagram = SC::voronoi_diagram(curves);
    EXPECT_TRUE(diagram.is_complete()) << "seed " << seed;
    EXPECT_GT(diagram.edges().size(), 0U);
    expect_euler(diagram);
    if (seed == 2 || seed == 3)
      expect_empty_disks(diagram, curves);
  }
}

// A kink of 2^-25 between segments of different lengths: the disks of the longer one touch the end of the other one,
// not its inside, where they are farther from the kink than that is.
TEST(NearlySmoothJoints, KinkBetweenSegments)
{
  const double e = 0x1p-25;
  const Diagram diagram =
      SC::voronoi_diagram(Curves{bezier({P(0, 0), P(0, 1 - e)}), bezier({P(0, 1 - e), P(-e, 1.5 - 2 * e)})});
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  std::size_t of_arcs = 0, of_arc_and_end = 0;
  for (const auto& edge : diagram.edges()) {
    const auto& [a, b] = edge.sites;
    const std::size_t points = diagram.sites()[a].is_point + diagram.sites()[b].is_point;
    of_arcs += points == 0;
    if (points == 1) {
      ++of_arc_and_end;
      const std::size_t arc = diagram.sites()[a].is_point ? b : a, end = arc == a ? b : a;
      EXPECT_EQ(arc, 0U);
      EXPECT_EQ(diagram.sites()[end].point, P(-e, 1.5 - 2 * e));
    }
  }
  EXPECT_EQ(of_arcs, 1U);
  EXPECT_EQ(of_arc_and_end, 1U);
}

// Kinks of 2^-29 between curves: on one side of a corner disks are too small for bounds, on the other side they are
// not.
TEST(NearlySmoothJoints, CornersWithOneSideToldByBounds)
{
  const Curves curves{bezier({P(3, 4), P(1073741825 * 0x1p-28, 1342177281 * 0x1p-28), P(-3, 1), P(2, -1)}),
                      bezier({P(2, -1), P(3758096385 * 0x1p-29, -805306369 * 0x1p-29), P(3, -1)}),
                      bezier({P(3, -1), P(1073741825 * 0x1p-30, 3 * 0x1p-29)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_GT(diagram.edges().size(), 5U);
  expect_euler(diagram);
}

// A rounded drop: three quarters of a circle as cubics, one of them with a larger error, whose disks nearly touch
// everything in the middle, and a kink that is not small.
TEST(NearlySmoothJoints, RoundedDrop)
{
  const Curves curves{bezier({P(500, 0), P(500, 275), P(276, 502), P(0, 500)}), bezier({P(0, 500), P(-500, 500)}),
                      bezier({P(-500, 500), P(-500, 0)}),
                      bezier({P(-500, 0), P(-500, -277), P(-276, -500), P(0, -500)}),
                      bezier({P(0, -500), P(277, -500), P(500, -276), P(500, 0)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.edges().size(), 13U);
  expect_euler(diagram);
}

// Where two pieces meet at an angle of less than 180 degrees, an edge begins in the corner: with a radius of zero,
// perpendicular to the curve.
TEST(NearlySmoothJoints, EdgesBeginInCorners)
{
  const Curves curves{bezier({P(-1, 1), P(-0.5, 0.25), P(0, 0)}), bezier({P(0, 0), P(1.5, -0.75 + 0x1p-50), P(2, 1)}),
                      bezier({P(-1, 3), P(2, 3)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  std::size_t corners = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
    const auto line = diagram.polyline(e, 0.01, 100);
    for (const auto& [end, next] : {std::pair(line.front(), line[1]), std::pair(line.back(), line[line.size() - 2])})
      if (end.radius == 0 && end.point == P(0, 0)) {
        ++corners;
        EXPECT_NEAR(next.point.x() / next.point.y(), 0.5, 1e-9);
        EXPECT_NEAR(distance(end.point, next.point), next.radius, 1e-9);
      }
  }
  EXPECT_EQ(corners, 1U);
}

// An angle of 2^-16, and small pieces far from the origin: disks that touch both sides of it are told apart by ways
// that are short, not by coordinates.
TEST(NearlySmoothJoints, SmallPiecesFarFromTheOrigin)
{
  const auto at = [](double x, double y) { return P(1024 + x, 1024 + y); };
  const Curves curves{bezier({at(0, 0), at(0x1p-6, 0)}), bezier({at(0x1p-6, 0), at(0x1p-5, 0x1p-22)}),
                      bezier({at(0, 0x1p-5), at(0x1p-7, 3 * 0x1p-7), at(0x1p-6, 3 * 0x1p-7), at(0x1p-5, 0x1p-5)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(counts(diagram).tips, 2U);   // the corner, and a center of curvature above the cubic
  EXPECT_TRUE(std::any_of(diagram.vertices().begin(), diagram.vertices().end(), [&](const auto& v) {
    return v.edges.size() == 1 && v.point && distance(*v.point, at(0x1p-6, 0)) < 1e-9;
  }));
  expect_euler(diagram);
}

// Of closed chains, whose end points are the same numbers: on one side of each joint that is not exactly smooth there
// is an angle of less than 180 degrees, and a vertex in it.
void expect_vertices_in_corners(const Diagram& diagram, const Curves& curves)
{
  const auto exact = [](const P& p) { return Exact::Point_2(p.x(), p.y()); };
  std::size_t corners = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto &first = curves[i].control_points(), &second = curves[(i + 1) % curves.size()].control_points();
    const P& joint = second[0];
    if (CGAL::orientation(exact(first[first.size() - 2]), exact(joint), exact(second[1])) == CGAL::COLLINEAR)
      continue;
    ++corners;
    EXPECT_TRUE(std::any_of(diagram.vertices().begin(), diagram.vertices().end(),
                            [&](const auto& v) {
                              return v.edges.size() == 1 && v.point == joint && v.radius == 0 &&
                                  v.box.xmax() - v.box.xmin() < 1e-14 && v.box.ymax() - v.box.ymin() < 1e-14;
                            }))
        << "joint " << i;
  }
  EXPECT_GT(corners, 0U);
  EXPECT_EQ(static_cast<std::size_t>(std::count_if(diagram.vertices().begin(), diagram.vertices().end(),
                                                   [](const auto& v) { return v.radius == 0; })),
            corners);
}

TEST(NearlySmoothJoints, VerticesInCorners)
{
  for (const unsigned seed : {3U, 5U, 7U}) {
    SCOPED_TRACE(seed);
    const Curves curves = closed_chain(seed, 0.3, 1000);
    expect_vertices_in_corners(SC::voronoi_diagram(curves), curves);
  }
}

// An ellipse of four cubics, which has disks that touch it in three points, one of them at the end of its long axis;
// rotated, these three events are nearer to each other than 2^-48 of the parameter.
TEST(NearlySmoothJoints, RotatedEllipse)
{
  constexpr double quarter = 0.5522847498;
  const auto at = [](double x, double y) {
    return P(std::cos(0.3) * x - std::sin(0.3) * y, std::sin(0.3) * x + std::cos(0.3) * y);
  };
  const Curves curves{bezier({at(2, 0), at(2, quarter), at(2 * quarter, 1), at(0, 1)}),
                      bezier({at(0, 1), at(-2 * quarter, 1), at(-2, quarter), at(-2, 0)}),
                      bezier({at(-2, 0), at(-2, -quarter), at(-2 * quarter, -1), at(0, -1)}),
                      bezier({at(0, -1), at(2 * quarter, -1), at(2, -quarter), at(2, 0)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_vertices_in_corners(diagram, curves);
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// A segment and a cubic with a small kink: where the cubic turns parallel to the segment, the contact of the largest
// disks runs along all of that while they hardly move; and those of the kink nearly osculate the cubic.
TEST(NearlySmoothJoints, KinkBesideASegment)
{
  for (const double kink : {0x1p-14, 0x1p-16}) {
    const Curves curves{bezier({P(-4, 0), P(0, 0)}), bezier({P(0, 0), P(1, kink), P(2, -1), P(2, -2)})};
    const Diagram diagram = SC::voronoi_diagram(curves);
    EXPECT_TRUE(diagram.is_complete()) << kink;
    EXPECT_EQ(diagram.edges().size(), 7U);
    expect_euler(diagram);
    expect_empty_disks(diagram, curves);
  }
}

// How many joints of a closed chain are exactly smooth.
std::size_t smooth_joints(const Exact_curves& curves)
{
  std::size_t result = 0;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const auto first = curves[i].control_points(), second = curves[(i + 1) % curves.size()].control_points();
    EXPECT_EQ(first.back(), second.front());
    result += CGAL::orientation(first[first.size() - 2], first.back(), second[1]) == CGAL::COLLINEAR &&
        (first.back() - first[first.size() - 2]) * (second[1] - second[0]) > 0;
  }
  return result;
}

TEST(SmoothJoints, MovedControlPoints)
{
  for (const unsigned seed : {1U, 2U, 3U, 4U}) {
    const Curves curves = closed_chain(seed, 0.3, 1000);
    const auto result = SC::with_smooth_joints<Exact>(curves, 1e-12);
    EXPECT_EQ(result.left, 0U);
    EXPECT_GT(result.joints, 0U);
    EXPECT_GT(result.displacement, 0);
    EXPECT_LT(result.displacement, 1e-14);
    EXPECT_EQ(smooth_joints(result.curves), curves.size());
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const SC::Bspline_curve_2<Exact> given(curves[i]);
      EXPECT_EQ(result.curves[i].source(), given.source());
      EXPECT_EQ(result.curves[i].target(), given.target());
      EXPECT_EQ(result.curves[i].knots(), given.knots());
    }
    const auto again = SC::with_smooth_joints<Exact>(result.curves, 1e-12);
    EXPECT_EQ(again.joints, 0U);
    EXPECT_EQ(again.displacement, 0);
  }
}

// A segment keeps its tangent, as does a quadratic; two of these are left, and so is what is no joint of two ends, or
// has a larger angle.
TEST(SmoothJoints, WhatIsKept)
{
  const auto segment = bezier({P(0, 0), P(1, 0)}), cubic = bezier({P(1, 0), P(2, 1e-6), P(3, 1), P(3, 2)}),
             quadratic = bezier({P(3, 2), P(3 + 1e-6, 3), P(2, 4)}), other = bezier({P(-1, 1e-6), P(0, 0)});
  const auto points = [](const SC::Smooth_joints_2<Exact>& result, std::size_t i) {
    return result.curves[i].control_points();
  };
  const auto result = SC::with_smooth_joints<Exact>(Curves{segment, cubic, quadratic, other}, 1e-5);
  EXPECT_EQ(result.joints, 2U);
  EXPECT_EQ(result.left, 1U);
  EXPECT_NEAR(result.displacement, 1e-6, 1e-9);
  EXPECT_EQ(points(result, 0), SC::Bspline_curve_2<Exact>(segment).control_points());
  EXPECT_EQ(points(result, 2), SC::Bspline_curve_2<Exact>(quadratic).control_points());
  EXPECT_EQ(points(result, 1)[1], Exact::Point_2(2, 0));
  EXPECT_TRUE(CGAL::collinear(points(result, 1)[2], points(result, 1)[3], points(result, 2)[1]));
  EXPECT_EQ(SC::with_smooth_joints<Exact>(Curves{segment, cubic}, 1e-7).joints, 0U);
  EXPECT_EQ(SC::with_smooth_joints<Exact>(Curves{segment, cubic, bezier({P(1, 0), P(1, 5)})}, 1e-5).joints, 0U);
  EXPECT_EQ(SC::with_smooth_joints<Exact>(Curves{bezier({P(0, 0), P(1, 0), P(1, 1), P(0, 0)})}, 1e-5).joints, 0U);
  EXPECT_THROW(SC::with_smooth_joints<Exact>(Curves{}, -1), SC::Invalid_input);
  EXPECT_THROW(SC::with_smooth_joints<Exact>(Curves{}, 1), SC::Invalid_input);
  EXPECT_THROW(SC::with_smooth_joints<Exact>(Curves{}, std::nan("")), SC::Invalid_input);
}

// A cubic with two control points in an end has the third one for the directions at both ends: it is kept, what is
// smooth there stays so, and the kink at its other end is taken from the next cubic.
TEST(SmoothJoints, TwoControlPointsInAnEnd)
{
  const auto line = bezier({P(0, 3), P(0, 0)}), drop = bezier({P(0, 0), P(0, 0), P(0, -1), P(1, -2)}),
             next = bezier({P(1, -2), P(2, -3 + 1e-6), P(3, -3), P(4, -3)});
  for (const bool reversed : {false, true}) {
    const auto result = SC::with_smooth_joints<Exact>(Curves{line, reversed ? drop.reversed() : drop, next}, 1e-5);
    EXPECT_EQ(result.joints, 1U);
    EXPECT_EQ(result.left, 0U);
    EXPECT_EQ(result.curves[1].control_points(),
              SC::Bspline_curve_2<Exact>(reversed ? drop.reversed() : drop).control_points());
    EXPECT_TRUE(CGAL::collinear(Exact::Point_2(0, -1), Exact::Point_2(1, -2), result.curves[2].control_points()[1]));
  }
  const auto kink = SC::with_smooth_joints<Exact>(Curves{bezier({P(1e-6, 3), P(0, 0)}), drop}, 1e-5);
  EXPECT_EQ(kink.joints, 0U);
  EXPECT_EQ(kink.left, 1U);
  EXPECT_EQ(kink.displacement, 0);
}

// Within a curve, where knots are as many as the degree: a straight piece keeps all of its control points.
TEST(SmoothJoints, JointsWithinACurve)
{
  const auto smoothed = [](const std::vector<P>& points) {
    return SC::with_smooth_joints<Exact>(Curves{SC::Bspline_curve_2<K>(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2}, points)},
                                         1e-5);
  };
  const std::vector<P> points{P(0, 1), P(1, 1), P(2, 1e-6), P(3, 0), P(5, 0), P(6, 1), P(6, 2)};
  const auto result = smoothed(points);
  EXPECT_EQ(result.joints, 1U);
  EXPECT_GT(result.displacement, 0);
  EXPECT_LT(result.displacement, 1e-6);
  const auto moved = result.curves[0].control_points();
  EXPECT_TRUE(CGAL::collinear(moved[2], moved[3], moved[4]));
  for (const std::size_t i : {0, 1, 3, 5, 6})
    EXPECT_EQ(moved[i], Exact::Point_2(points[i].x(), points[i].y()));
  const auto straight = smoothed({P(0, 0), P(1, 0), P(2, 0), P(3, 0), P(4, 1e-6), P(5, 1), P(5, 2)});
  EXPECT_EQ(straight.joints, 1U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_EQ(straight.curves[0].control_points()[i], Exact::Point_2(static_cast<int>(i), 0));
  const auto both = smoothed({P(0, 0), P(1, 0), P(2, 0), P(3, 0), P(4, 0x1p-20), P(5, 0x2p-20), P(6, 0x3p-20)});
  EXPECT_EQ(both.joints, 0U);
  EXPECT_EQ(both.left, 1U);
  const auto closed = smoothed({P(0, 0), P(1, 1e-6), P(2, 1), P(2, 2), P(0, 2), P(-1, 0), P(0, 0)});
  EXPECT_EQ(closed.joints, 1U);
}

// Rotated, it has kinks of 10^-16 between sides and arcs; without these, its diagram has a centre line, four branches
// and an edge for each half of an arc.
TEST(SmoothJoints, RotatedRoundedRectangle)
{
  constexpr double quarter = 0.5522847498, a = 1.5, b = 1, r = 0.5, t = quarter * r;
  Curves curves;
  const auto add = [&](std::initializer_list<std::pair<double, double>> points) {
    std::vector<P> rotated;
    for (const auto& [x, y] : points)
      rotated.push_back(P(std::cos(0.3) * x - std::sin(0.3) * y, std::sin(0.3) * x + std::cos(0.3) * y));
    curves.push_back(SC::bezier_curve(rotated));
  };
  add({{r - a, -b}, {a - r, -b}});
  add({{a - r, -b}, {a - r + t, -b}, {a, r - b - t}, {a, r - b}});
  add({{a, r - b}, {a, b - r}});
  add({{a, b - r}, {a, b - r + t}, {a - r + t, b}, {a - r, b}});
  add({{a - r, b}, {r - a, b}});
  add({{r - a, b}, {r - a - t, b}, {-a, b - r + t}, {-a, b - r}});
  add({{-a, b - r}, {-a, r - b}});
  add({{-a, r - b}, {-a, r - b - t}, {r - a - t, -b}, {r - a, -b}});
  const auto result = SC::with_smooth_joints<Exact>(curves, 1e-12);
  EXPECT_EQ(result.left, 0U);
  EXPECT_LT(result.displacement, 1e-15);
  EXPECT_EQ(smooth_joints(result.curves), 8U);
  const auto diagram = SC::voronoi_diagram(result.curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.edges().size(), 21U);
  expect_euler(diagram);
}

// A toe of an icon: where its first joint is made smooth, curvatures differ by 0.4 percent, and the greater one is the
// greatest there. The axis ends in its center.
TEST(SmoothJoints, CurvaturesThatDifferByLittle)
{
  const Curves curves{
      bezier({P(2.855469, 3.878906), P(2.726562, 3.878906), P(2.585938, 3.917969), P(2.433594, 4.023438)}),
      bezier({P(2.433594, 4.023438), P(1.230469, 4.855469), P(2.839844, 6.863281), P(3.546875, 6.554688)}),
      bezier({P(3.546875, 6.554688), P(4.167969, 6.28125), P(3.769531, 3.910156), P(2.855469, 3.878906)})};
  const auto result = SC::with_smooth_joints<Exact>(curves, 2 * CGAL_PI / 180);
  EXPECT_EQ(result.joints, 3U);
  const auto diagram = SC::voronoi_diagram(result.curves);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.edges().size(), 4U);
  expect_euler(diagram);
  const auto points = result.curves[0].control_points();
  const auto along = points[1] - points[0], across = points[2] - points[0];
  const double length = std::sqrt(CGAL::to_double(along.squared_length())),
               radius = 1.5 * std::pow(length, 3) / std::abs(CGAL::to_double(CGAL::determinant(along, across)));
  EXPECT_EQ(std::count_if(diagram.vertices().begin(), diagram.vertices().end(),
                          [&](const auto& vertex) {
                            return vertex.edges.size() == 1 && vertex.radius &&
                                std::abs(*vertex.radius - radius) < 1e-9;
                          }),
            1);
}

double area(const Curves& curves, double radius)
{
  const SC::Trimmed_offset_2<K> offset = SC::trimmed_offset(curves, radius);
  EXPECT_TRUE(offset.is_complete());
  return total_area(offset.polygons_with_holes(1e-5));
}

// On a grid the joints are exactly smooth, turned they are not.
TEST(NearlySmoothJoints, OffsetsAreThoseOfSmoothOnes)
{
  for (const unsigned seed : {1U, 2U, 3U})
    for (const double radius : {0.25, 1.0}) {
      const double exact = area(closed_chain(seed, 0, 64), radius);
      EXPECT_GT(exact, radius);
      EXPECT_NEAR(area(closed_chain(seed, 0.3, 64), radius), exact, 1e-3);
    }
}

} // namespace nearly_smooth_joints_2_test
