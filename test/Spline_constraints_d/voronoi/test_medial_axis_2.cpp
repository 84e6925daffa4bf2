// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Medial axes: of a segment of a parabola, a triangle and an L in closed form; of regions with holes, every disk is
// inside and touches the boundary twice, and there is one cycle for each hole.
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace medial_axis_2_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using P = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Axis = SC::Voronoi_diagram_of_curves_2<K>;

Curve bezier(const std::vector<P>& points) { return SC::bezier_curve(points); }

SC::Planar_region_2<K> polygon(const std::vector<P>& corners)
{
  Curves sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back(bezier({corners[i], corners[(i + 1) % corners.size()]}));
  return SC::planar_region(sides);
}

double distance(const P& p, const P& q) { return std::sqrt(CGAL::squared_distance(p, q)); }

std::size_t number_of_vertices(const Axis& axis, std::size_t degree)
{
  return static_cast<std::size_t>(std::count_if(axis.vertices().begin(), axis.vertices().end(),
                                                [&](const auto& v) { return v.edges.size() == degree; }));
}

bool has_vertex(const Axis& axis, const P& p, double radius)
{
  return std::any_of(axis.vertices().begin(), axis.vertices().end(),
                     [&](const auto& v) {
                       return v.radius && distance(*v.point, p) < 1e-9 && std::abs(*v.radius - radius) < 1e-9;
                     });
}

// Between y = x^2 and y = 4: it begins in the center of curvature (0, 1/2), and branches in (0, 5/2).
TEST(MedialAxis, SegmentOfAParabola)
{
  const Axis axis =
      SC::medial_axis(SC::planar_region(Curves{bezier({P(-2, 4), P(0, -4), P(2, 4)}), bezier({P(-2, 4), P(2, 4)})}));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.number_of_regions(), 1U);
  EXPECT_EQ(axis.edges().size(), 3U);
  EXPECT_EQ(axis.vertices().size(), 4U);
  EXPECT_TRUE(has_vertex(axis, P(0, 0.5), 0.5));
  EXPECT_TRUE(has_vertex(axis, P(0, 2.5), 1.5));
  EXPECT_TRUE(has_vertex(axis, P(-2, 4), 0));
  EXPECT_TRUE(has_vertex(axis, P(2, 4), 0));
  for (std::size_t e = 0; e < axis.edges().size(); ++e)
    for (const auto& sample : axis.polyline(e, 0.01))
      if (axis.edges()[e].sites[0] == axis.edges()[e].sites[1]) {
        EXPECT_NEAR(sample.point.x(), 0, 1e-9);
        EXPECT_NEAR(sample.radius, std::sqrt(sample.point.y() - 0.25), 1e-9);
      } else
        EXPECT_NEAR(sample.radius, 4 - sample.point.y(), 1e-9);
}

// Between the centers of its greatest curvatures.
TEST(MedialAxis, SegmentOfAnEllipse)
{
  const Axis axis =
      SC::medial_axis(SC::planar_region(Curves{SC::ellipse_curve(P(0, 0), K::Vector_2(2, 0), K::Vector_2(0, 1))}));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(number_of_vertices(axis, 1), 2U);
  EXPECT_TRUE(has_vertex(axis, P(-1.5, 0), 0.5));
  EXPECT_TRUE(has_vertex(axis, P(1.5, 0), 0.5));
  double length = 0;
  for (std::size_t e = 0; e < axis.edges().size(); ++e) {
    const auto polyline = axis.polyline(e, 0.01);
    for (const auto& sample : polyline)
      EXPECT_NEAR(sample.point.y(), 0, 1e-12);
    length += distance(polyline.front().point, polyline.back().point);
  }
  EXPECT_NEAR(length, 3, 1e-9);
}

// A piece of a side of a rectangle is so short that the disks at the other side may touch it and both of its
// neighbours.
TEST(MedialAxis, ShortPiecesOnOneOfTwoParallelLines)
{
  for (const double at : {1.0, 2.5, 2.75, 4.0})
    for (const double length : {0.3, 0.1, 0.01, 0.0001}) {
      const Axis axis = SC::medial_axis(polygon({P(0, 0), P(at, 0), P(at + length, 0), P(6, 0), P(6, 4), P(0, 4)}));
      EXPECT_TRUE(axis.is_complete()) << at << ' ' << length;
      EXPECT_EQ(number_of_vertices(axis, 3), 2U);
      EXPECT_TRUE(has_vertex(axis, P(2, 2), 2));
      EXPECT_TRUE(has_vertex(axis, P(4, 2), 2));
    }
}

// Four corners on a circle, a symmetric trapezoid: the centers of the disks at one of them turn back where these touch
// the others.
TEST(MedialAxis, Asterisk)
{
  const Axis axis =
      SC::medial_axis(polygon({P(963, 1247), P(604, 1053), P(963, 858), P(905, 760), P(569, 963), P(569, 586),
                               P(455, 586), P(455, 963), P(119, 760), P(61, 858), P(420, 1053), P(61, 1247),
                               P(119, 1346), P(455, 1143), P(455, 1520), P(569, 1520), P(569, 1143), P(905, 1346)}));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(number_of_vertices(axis, 4), 2U);
  // of the point on the axis of symmetry with the same distance from (455, 963) and (420, 1053)
  const double height = 186655. / 180;
  EXPECT_TRUE(has_vertex(axis, P(512, height), std::hypot(57, height - 963)));
}

// Sides 3, 4, 5: a tree with the center of the inscribed circle and the corners.
TEST(MedialAxis, Triangle)
{
  const Axis axis = SC::medial_axis(polygon({P(0, 0), P(4, 0), P(0, 3)}));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.edges().size(), 3U);
  EXPECT_EQ(number_of_vertices(axis, 1), 3U);
  EXPECT_EQ(number_of_vertices(axis, 3), 1U);
  EXPECT_TRUE(has_vertex(axis, P(1, 1), 1));
  for (const P& corner : {P(0, 0), P(4, 0), P(0, 3)})
    EXPECT_TRUE(has_vertex(axis, corner, 0));
}

// An L with arms of widths 2 and 3: no edge ends in the reflex corner, which is a site of edges between. The disk at
// the end of an arm touches three sides.
TEST(MedialAxis, ReflexCorner)
{
  const Axis axis = SC::medial_axis(polygon({P(0, 0), P(10, 0), P(10, 2), P(3, 2), P(3, 9), P(0, 9)}));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.edges().size(), axis.vertices().size() - 1);
  EXPECT_EQ(number_of_vertices(axis, 1), 5U);
  EXPECT_TRUE(has_vertex(axis, P(9, 1), 1));
  EXPECT_TRUE(has_vertex(axis, P(1.5, 7.5), 1.5));
  EXPECT_FALSE(has_vertex(axis, P(3, 2), 0));
  EXPECT_TRUE(std::any_of(axis.edges().begin(), axis.edges().end(), [&](const auto& edge) {
    return std::any_of(edge.sites.begin(), edge.sites.end(), [&](std::size_t site) {
      return axis.sites()[site].is_point && axis.sites()[site].point == P(3, 2);
    });
  }));
}

// The outline and the holes are closed curves: the axis is connected, and has a cycle for each hole.
TEST(MedialAxis, RegionWithHoles)
{
  const Curves curves{bezier({P(0, 0), P(12, -6), P(16, 4), P(12, 10)}),
                      bezier({P(12, 10), P(2, 14), P(-4, 6), P(0, 0)}), bezier({P(3, 3), P(6, 2), P(4, 6), P(3, 3)}),
                      bezier({P(8, 5), P(11, 3), P(10, 9), P(8, 5)})};
  const auto region = SC::planar_region(curves);
  ASSERT_EQ(region.number_of_holes(), 2U);
  const Axis axis = SC::medial_axis(region);
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.number_of_regions(), 3U);
  EXPECT_EQ(axis.edges().size(), axis.vertices().size() + 1);

  std::vector<P> boundary;
  for (const Curve& curve : curves)
    for (int i = 0; i <= 100; ++i)
      boundary.push_back(curve(i / 100.0));
  std::size_t samples = 0;
  for (std::size_t e = 0; e < axis.edges().size(); ++e) {
    const auto polyline = axis.polyline(e, 0.05);
    EXPECT_EQ(region.bounded_side(polyline[polyline.size() / 2].point), CGAL::ON_BOUNDED_SIDE);
    for (const auto& sample : polyline) {
      ++samples;
      for (std::size_t side = 0; side < 2; ++side) {
        const auto& site = axis.sites()[axis.edges()[e].sites[side]];
        EXPECT_NEAR(distance(sample.point, site.is_point ? site.point : curves[*site.curve](*sample.parameters[side])),
                    sample.radius, 1e-8);
      }
      for (const P& p : boundary)
        EXPECT_GT(distance(sample.point, p), sample.radius - 1e-8);
    }
  }
  EXPECT_GT(samples, 2 * axis.edges().size());
}

// Two squares with a corner in common, as one outline: each has its diagonals. A frame whose outline leads to the hole
// and back has one cycle.
TEST(MedialAxis, OutlinesThatTouch)
{
  const auto outline = [](const std::vector<P>& corners) { return SC::planar_region(SC::polyline_curve(corners)); };
  const Axis squares =
      SC::medial_axis(outline({P(0, 0), P(2, 0), P(2, 2), P(0, 2), P(0, 0), P(-2, 0), P(-2, -2), P(0, -2), P(0, 0)}));
  EXPECT_TRUE(squares.is_complete());
  EXPECT_EQ(squares.edges().size(), 8U);
  EXPECT_EQ(number_of_vertices(squares, 4), 2U);
  EXPECT_TRUE(has_vertex(squares, P(1, 1), 1));
  EXPECT_TRUE(has_vertex(squares, P(-1, -1), 1));
  const Axis frame = SC::medial_axis(
      outline({P(0, 0), P(6, 0), P(6, 6), P(0, 6), P(0, 0), P(2, 2), P(2, 4), P(4, 4), P(4, 2), P(2, 2), P(0, 0)}));
  EXPECT_TRUE(frame.is_complete());
  EXPECT_EQ(frame.edges().size(), frame.vertices().size());
  EXPECT_EQ(number_of_vertices(frame, 1), 4U);
}

// Holes that touch the boundary: the axis of a crescent is an ellipse without its point on the boundary. Between two
// holes and the boundary are disks of radius 9/8.
TEST(MedialAxis, CirclesThatTouch)
{
  const auto circle = [](double x, double r) { return SC::circle_curve(P(x, 0), r); };
  const Axis crescent = SC::medial_axis(SC::planar_region(Curves{circle(0, 2), circle(1, 1)}));
  EXPECT_TRUE(crescent.is_complete());
  EXPECT_EQ(crescent.edges().size() + 1, crescent.vertices().size());
  for (std::size_t e = 0; e < crescent.edges().size(); ++e)
    for (const auto& sample : crescent.polyline(e, 0.01))
      EXPECT_NEAR(distance(sample.point, P(0, 0)) + distance(sample.point, P(1, 0)), 3, 1e-9);
  EXPECT_TRUE(has_vertex(crescent, P(-1, 0), 1));
  const Axis holes = SC::medial_axis(SC::planar_region(Curves{circle(0, 3), circle(1, 1), circle(-1, 1)}));
  EXPECT_TRUE(holes.is_complete());
  EXPECT_EQ(number_of_vertices(holes, 3), 2U);
  EXPECT_TRUE(has_vertex(holes, P(0, 1.875), 1.125));
  EXPECT_TRUE(has_vertex(holes, P(0, -1.875), 1.125));
}

// Four quadratic pieces that join smoothly, nearly a circle: the disk around the center touches all four joints, whose
// normals are the axes of symmetry.
TEST(MedialAxis, FourQuadraticPieces)
{
  const Axis axis = SC::medial_axis(
      SC::planar_region(Curves{bezier({P(1, 0), P(1, 1), P(0, 1)}), bezier({P(0, 1), P(-1, 1), P(-1, 0)}),
                               bezier({P(-1, 0), P(-1, -1), P(0, -1)}), bezier({P(0, -1), P(1, -1), P(1, 0)})}));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.edges().size(), 4U);
  EXPECT_EQ(number_of_vertices(axis, 1), 4U);
  EXPECT_EQ(number_of_vertices(axis, 4), 1U);
  EXPECT_TRUE(has_vertex(axis, P(0, 0), 1));
}

// A stadium, with three segments on one line and arcs that join them tangentially: the axis is the segment between the
// centers of the arcs.
TEST(MedialAxis, PiecesOnOneLine)
{
  const auto arc = [](double x, const P& p, const P& q) { return SC::circular_arc_curve(P(x, 2), p, q); };
  const Axis axis = SC::medial_axis(SC::planar_region(Curves{
      bezier({P(0, 0), P(2, 0)}), bezier({P(2, 0), P(2.5, 0)}), bezier({P(2.5, 0), P(6, 0)}), arc(6, P(6, 0), P(8, 2)),
      arc(6, P(8, 2), P(6, 4)), bezier({P(6, 4), P(0, 4)}), arc(0, P(0, 4), P(-2, 2)), arc(0, P(-2, 2), P(0, 0))}));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.edges().size() + 1, axis.vertices().size());
  EXPECT_EQ(number_of_vertices(axis, 1), 2U);
  EXPECT_TRUE(has_vertex(axis, P(0, 2), 2));
  EXPECT_TRUE(has_vertex(axis, P(6, 2), 2));
}

} // namespace medial_axis_2_test
