// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams of curves that cross each other or themselves, end on another one, touch, or have pieces in common:
// circles that cross in irrational points against the ellipse and the line their bisector consists of, segments in
// closed form; random cubics, where every disk is empty and Euler's formula holds.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Crossing_refinement.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusp_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Graph_of_crossing_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Maximal_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Separate_faces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace crossing_curves_2_test {

namespace {
namespace crossing_curves {

// Complete, planar, of empty disks; the parts of each curve follow each other.
void expect_right(const Diagram& diagram, const Curves& curves, std::size_t regions)
{
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.number_of_regions(), regions);
  EXPECT_GT(diagram.edges().size(), 0U);
  expect_euler(diagram);
  expect_empty_disks(diagram, curves, 0.2, 20);
  std::vector<double> ends(curves.size(), 0);
  for (const auto& site : diagram.sites())
    if (!site.is_point) {
      EXPECT_EQ(site.parameters[0], ends[*site.curve]);
      EXPECT_LT(site.parameters[0], site.parameters[1]);
      ends[*site.curve] = site.parameters[1];
    }
  for (std::size_t i = 0; i < curves.size(); ++i)
    EXPECT_EQ(ends[i], curves[i].domain(0).second);
}

std::size_t number_of_parts(const Diagram& diagram)
{
  return static_cast<std::size_t>(
      std::count_if(diagram.sites().begin(), diagram.sites().end(), [](const auto& site) { return !site.is_point; }));
}

TEST(CrossingCurves, Circles)
{
  // Radii 5 around (-2, 0) and (2, 0): they cross in (0, +-sqrt(21)). Within both or outside of both the bisector is
  // the y-axis; within one of them the ellipse whose foci are the centers.
  const Curves circles{SC::ellipse_curve(P(-2, 0), K::Vector_2(3, 4), K::Vector_2(-4, 3)),
                       SC::ellipse_curve(P(2, 0), K::Vector_2(4, 3), K::Vector_2(-3, 4))};
  const Diagram diagram = SC::voronoi_diagram(circles);
  expect_right(diagram, circles, 1);
  EXPECT_EQ(number_of_parts(diagram), 12U);
  std::size_t on_axis = 0, on_ellipse = 0, tips = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    for (const auto& sample : diagram.polyline(e, 0.05, 20)) {
      const double x = sample.point.x(), y = sample.point.y(), outside = x * x / 25 + y * y / 21 - 1;
      const bool is_axis = std::abs(x) < 1e-9, is_ellipse = std::abs(outside) < 1e-9;
      EXPECT_TRUE(is_axis || is_ellipse) << x << ' ' << y;
      on_axis += is_axis;
      on_ellipse += is_ellipse;
    }
  EXPECT_GT(on_axis, 10U);
  EXPECT_GT(on_ellipse, 10U);
  for (const auto& vertex : diagram.vertices())
    if (!vertex.is_at_infinity && vertex.edges.size() == 1) {   // the crossings, one from each of four sides
      EXPECT_NEAR(std::abs(vertex.point->y()), std::sqrt(21.0), 1e-9);
      EXPECT_NEAR(*vertex.radius, 0, 1e-9);
      ++tips;
    }
  EXPECT_EQ(tips, 8U);
}

TEST(CrossingCurves, Segments)
{
  const Curves segments{bezier({P(0, 0), P(4, 1)}), bezier({P(1, 3), P(2, -2)})};
  const Diagram diagram = SC::voronoi_diagram(segments);
  expect_right(diagram, segments, 1);
  EXPECT_EQ(number_of_parts(diagram), 4U);
}

// A segment that ends on another one: the footpoints of the disks on its sides run up to the end of the other one, and
// beyond.
TEST(CrossingCurves, EndOnASegment)
{
  const Curves segments{bezier({P(0, 0), P(4, 0)}), bezier({P(2, 0), P(2, 3)})};
  const Diagram diagram = SC::voronoi_diagram(segments);
  expect_right(diagram, segments, 1);
  EXPECT_EQ(number_of_parts(diagram), 3U);
  const bool has_event = std::any_of(diagram.vertices().begin(), diagram.vertices().end(), [](const auto& v) {
    return !v.is_at_infinity && distance(*v.point, P(0, 2)) < 1e-9;
  });
  EXPECT_TRUE(has_event);
}

// The point is (1, 1), and its parameter on the other segment (sqrt(5) - 1) / 2.
TEST(CrossingCurves, EndAtAnIrrationalParameter)
{
  const Curves segments{bezier({P(0, 0), P(0.5, 0.5), P(2, 2)}), bezier({P(1, 1), P(1, -2)})};
  const Diagram diagram = SC::voronoi_diagram(segments);
  expect_right(diagram, segments, 1);
  EXPECT_EQ(number_of_parts(diagram), 3U);
  EXPECT_NEAR(diagram.sites()[0].parameters[1], (std::sqrt(5.0) - 1) / 2, 1e-15);
}

// Three segments through (1/3, 1/3), which no doubles are.
TEST(CrossingCurves, ThreeSegmentsThroughAPoint)
{
  const Curves segments{bezier({P(0, 0), P(1, 1)}), bezier({P(-0.25, 1.5), P(0.75, -0.5)}),
                        bezier({P(-1, 1), P(1.5, -0.25)})};
  const Diagram diagram = SC::voronoi_diagram(segments);
  expect_right(diagram, segments, 1);
  EXPECT_EQ(number_of_parts(diagram), 6U);
}

TEST(CrossingCurves, Loop)
{
  const Curves loop{bezier({P(0, 0), P(6, 4), P(-2, 4.2), P(4.1, 0.3)})};
  const Diagram diagram = SC::voronoi_diagram(loop);
  expect_right(diagram, loop, 1);
  EXPECT_EQ(number_of_parts(diagram), 3U);
}

TEST(CrossingCurves, ThinLoops)
{
  // Loops 100 to 10,000 times as long as wide, with ends that nearly have one tangent.
  for (const Curve& curve :
       {bezier({P(0.84184, 0.64739), P(0.43936, 0.55308), P(0.27198, 0.22562), P(0.76865, 0.77604)}),
        bezier({P(0.75899, 0.19133), P(0.12291, 0.87313), P(0.85652, 0.21591), P(0.22085, 0.74730)})}) {
    const Diagram diagram = SC::voronoi_diagram(Curves{curve});
    expect_right(diagram, {curve}, 1);
    EXPECT_EQ(number_of_parts(diagram), 3U);
  }
}

// Cuts where curves touch at rational parameters, not where they do at irrational ones, which is known, or three of
// them pass through an irrational point.
TEST(CrossingCurves, Cuts)
{
  const auto graph = [](const Curves& curves) {
    return SC::internal::Voronoi::graph_of_crossing_curves<CGAL::Sequential_tag>(
        SC::internal::Voronoi::planar_operands(curves, std::vector<P>()));
  };
  const auto number_of_arcs = [&](const Curves& curves) { return graph(curves)->arcs().size(); };
  const Curve parabola = bezier({P(-2, 4), P(0, -4), P(2, 4)});   // y = x^2
  EXPECT_EQ(number_of_arcs({parabola, bezier({P(-1, 0), P(1, 0)})}), 4U);
  EXPECT_TRUE(graph({parabola, bezier({P(-1, 0), P(1, 0)})})->is_proved());
  // 12 (x^2/2 - 1)^2 touches 0 at an irrational x
  EXPECT_FALSE(graph({bezier({P(0, 12), P(0.5, 12), P(1, 4), P(1.5, -12), P(2, 12)}), bezier({P(-1, 0), P(3, 0)})})
                   ->is_proved());
  EXPECT_EQ(number_of_arcs({parabola, bezier({P(-2, 2), P(2, 2)})}), 6U);
  // y = 2, y = 4 - x^2
  EXPECT_EQ(number_of_arcs({parabola, bezier({P(-2, 2), P(2, 2)}), bezier({P(-2, 0), P(0, 8), P(2, 0)})}), 3U);
}

// A circle within another one, which it touches: the bisector is an ellipse.
TEST(CrossingCurves, TouchingCircles)
{
  const auto circle = [](double x, double r) {
    return SC::ellipse_curve(P(x, 0), K::Vector_2(r, 0), K::Vector_2(0, r));
  };
  const Curves circles{circle(0, 2), circle(1, 1)};
  const Diagram diagram = SC::voronoi_diagram(circles);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, circles, 0.2, 6);
  std::size_t edges = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
    const auto& [a, b] = diagram.edges()[e].sites;
    if (diagram.sites()[a].is_point || diagram.sites()[b].is_point ||
        diagram.sites()[a].curve == diagram.sites()[b].curve)
      continue;
    ++edges;
    for (const auto& sample : diagram.polyline(e, 0.2, 6))
      EXPECT_NEAR(distance(sample.point, P(0, 0)) + distance(sample.point, P(1, 0)), 3, 1e-9);
  }
  EXPECT_GE(edges, 2U);
}

// A circle on a line, which ends elsewhere on both sides; a parabola on its tangent, which has a tip of the diagram
// over the footpoint; a rounded corner that leaves a segment; ends with one tangent, on one side of it or on both, also
// with the same curvature, where the third derivatives differ.
TEST(CrossingCurves, TouchingArcs)
{
  const Curve line = bezier({P(-1, 0), P(1, 0)}), fillet = bezier({P(0, 0), P(0.5, 0), P(0.5, 0.5)});
  const Curves scenes[] = {{bezier({P(-2, 1), P(3, 1)}), SC::circle_curve(P(0.25, 1.75), 0.75)},
                           {line, bezier({P(-1, 1), P(0, -1), P(1, 1)})},
                           {line, fillet},
                           {bezier({P(-1, 0), P(0, 0)}), bezier({P(0, 0), P(1, 0)}), fillet},
                           {bezier({P(0, 0), P(1, 0)}), bezier({P(0, 0), P(2, 0), P(3, 2), P(4, 2.5)})},
                           {bezier({P(0, 0), P(1, 0), P(2, 1), P(2.5, 2)}), bezier({P(3, -2), P(2, 0), P(0, 0)})},
                           {bezier({P(0, 0), P(1, 0), P(2, 1)}), bezier({P(0, 0), P(1, 0), P(2, 0.75), P(3, 8)})}};
  for (const Curves& scene : scenes)
    expect_right(SC::voronoi_diagram(scene), scene, 1);
}

// Three arcs that begin in one point, of which the middle one hides the others from each other: at angles of 7 and 16
// degrees, or with one tangent, as chains that touch each other in a joint, with a segment or another chain.
TEST(CrossingCurves, ThreeArcsFromAPoint)
{
  const auto chain = [](const P& first, const P& joint, const CGAL::Vector_2<K>& tangent, const P& last) {
    return Curve(2, {0, 0, 0, 1, 1, 2, 2, 2}, {first, joint - tangent, joint, joint + tangent, last});
  };
  const P p(5, 8);
  const Curves corner{bezier({P(5, 4), P(6, 0), P(3, 4), P(0, 6)}), bezier({P(0, 6), P(7, 0)}),
                      bezier({P(0, 6), P(5.5, 4.25), P(3.75, 3.5), P(4, 3)})};
  const Curves touching{chain(P(1, 8), p, {1, 1}, P(0, 3)), chain(P(1, 3), p, {2, 2}, P(4, 5)), bezier({p, P(7, 5)})};
  const Curves three{chain(P(1, 4), p, {1, 0}, P(9, 4)), chain(P(1, 6), p, {1, 0}, P(9, 6)),
                     chain(P(1, 7), p, {1, 0}, P(9, 7))};
  // two of the arcs have the curvature zero there
  const Curves flat{bezier({P(-2, 0), P(3, 0)}), bezier({P(-2, 0), P(-1, 0), P(-3, 0), P(1, 1)}),
                    bezier({P(-2, 0), P(-1, 0), P(4, 3)})};
  for (const Curves& scene : {corner, touching, three, flat}) {
    const Diagram diagram = SC::voronoi_diagram(scene);
    EXPECT_TRUE(diagram.is_complete());
    expect_euler(diagram);
    expect_empty_disks(diagram, scene, 0.2, 20);
  }
}

// Curves that leave others in points of these with the same tangent: each of them goes on as two arcs, and disks touch
// the one on their side.
TEST(CrossingCurves, Forks)
{
  const auto circle = SC::circle_curve(P(3, 4), 1.5);
  const Curves line{bezier({P(0, 0), P(8, 0)}), bezier({P(6.2, 0), P(5.7, 0), P(4.515625, 0.625)})},
      two{bezier({P(0, 0), P(10, 0)}), bezier({P(3, 0), P(5, 0), P(7, 2)}), bezier({P(5, 0), P(6, 0), P(4, 2)})};
  const Curves quarter{bezier({P(0, 0), P(10, 0)}), bezier({P(7, 0), P(5.8954, 0), P(5, -0.8954), P(5, -2)})},
      round{circle, bezier({P(3, 2.5), P(4, 2.5), P(5, 2)}), bezier({P(4.5, 4), P(4.5, 5)}),
            bezier({P(1.5, 4), P(1.5, 4.5), P(2, 5)})};
  const Curves parabola{bezier({P(-2, 4), P(0, -4), P(2, 4)}), bezier({P(0, 0), P(1, 0), P(2, 3)}),
                        bezier({P(0, 0), P(-1, 0)}), bezier({P(1, 1), P(0.5, 0), P(0, 3)})};
  for (const Curves& scene : {line, two, quarter, round, parabola})
    expect_right(SC::voronoi_diagram(scene), scene, 1);
  // The disks of the line that touch the curve, too, end with the circle of its curvature, 5/4.
  const Diagram diagram = SC::voronoi_diagram(line);
  EXPECT_EQ(std::count_if(
                diagram.vertices().begin(), diagram.vertices().end(),
                [](const auto& v) {
                  return v.radius && std::abs(*v.radius - 0.8) < 1e-9 && distance(*v.point, P(6.2, 0.8)) < 1e-9;
                }),
            1);
}

// A curve that leaves a circle of more curvature, and soon crosses it again: the lens between is thinner than 10^-5,
// and decided in parts much longer than that.
TEST(CrossingCurves, ThinLens)
{
  const Curves curves{SC::circle_curve(P(0.5625, 6.71875), 0.5),
                      bezier({P(1.0625, 6.71875), P(1.0625, 7.21875), P(0.15625, 0.328125)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  expect_right(diagram, curves, 1);
  EXPECT_EQ(number_of_parts(diagram), 9U);
}

std::shared_ptr<const SC::internal::Voronoi::Site_graph_2<>> graph_of(const Curves& curves)
{
  return SC::internal::Voronoi::graph_of_crossing_curves<CGAL::Sequential_tag>(
      SC::internal::Voronoi::planar_operands(curves, std::vector<P>()));
}

// What rounding makes of a curve that leaves the begin of a segment with its tangent: the curve crosses the segment
// again, so soon that the lens between is thinner than the last place of coordinates. Both of its sides touch each
// other all along, and so do, up to the end of the segment, the sides of the wedge behind the crossing.
TEST(CrossingCurves, LensBelowTheLastPlace)
{
  const K::Vector_2 d(1.1, 0.3), n(-0.3, 1.1);
  const P o(3.1, 2.7);
  const auto graph = graph_of({bezier({o, o + 4 * d}), bezier({o, o + 2 * d - 1e-8 * n, o + 4 * d + n})});
  ASSERT_EQ(graph->arcs().size(), 4U);
  const SC::Upward_rounding_guard guard;
  const SC::internal::Voronoi::Site_tree_2 tree(*graph);
  const SC::internal::Voronoi::Cusps_2 cusps = SC::internal::Voronoi::Cusp_finder_2(*graph, tree)();
  const SC::internal::Voronoi::Fine_level fine(*graph);
  // the right side of the segment in the lens, and the left one behind it
  for (const auto& [element, touched] : {std::pair<std::size_t, std::size_t>{1, 2}, {2, 3}}) {
    const auto envelope_arcs = SC::internal::Voronoi::Maximal_disks<>(*graph, tree, cusps, &fine)(element);
    ASSERT_EQ(envelope_arcs.size(), 1U);
    EXPECT_EQ(envelope_arcs[0].footpoint.index, touched);
    EXPECT_TRUE(envelope_arcs[0].range.begin == 0 && envelope_arcs[0].range.end == 1);
    EXPECT_EQ(envelope_arcs[0].events,
              (std::array{SC::internal::Voronoi::Disk_event::NONE, SC::internal::Voronoi::Disk_event::NONE}));
  }
}

// Whether a number is between the squares of two others.
bool is_square_within(const SC::internal::Common::Parameter_range& range, const SC::Exact_rational& square)
{
  return range.first * range.first < square && square < range.second * range.second;
}

// The parabola and lines in irrational points: the ranges hold the roots, and are as narrow as they are to be, beside
// the ends of pieces as well; and a circle, in homogeneous coordinates.
TEST(CrossingCurves, RangesOfCrossings)
{
  using SC::Exact_rational;
  const auto half_width = [](const SC::internal::Common::Parameter_range& range) {
    return CGAL::to_double(Exact_rational((range.second - range.first) / 2));
  };
  const auto piece_of = [](const Curve& curve) {
    return SC::internal::Voronoi::Site_curve_2(SC::internal::Voronoi::Operand_curve_2(curve)).pieces[0];
  };
  const auto around = [](double t) {
    return SC::internal::Common::Parameter_range(Exact_rational(t * (1 - 0x1p-40)), Exact_rational(t * (1 + 0x1p-40)));
  };
  const SC::internal::Common::Homogeneous_piece parabola = piece_of(bezier({P(0, 0), P(0.5, 0), P(1, 1)}));
  for (const double height : {0.5, 0x1p-41, 0x1p-81}) {
    const double t = std::sqrt(height);
    const auto [on_parabola, on_line] = SC::internal::Voronoi::Crossing_refinement(
        parabola, piece_of(bezier({P(0, height), P(1, height)})))({around(t), around(t)});
    EXPECT_TRUE(is_square_within(on_parabola, height) && is_square_within(on_line, height));
    EXPECT_LT(half_width(on_parabola), 0x1p-119 * t);
    EXPECT_GT(half_width(on_parabola), 0x1p-130 * t);   // not longer numbers than need be
    EXPECT_LT(half_width(on_line), 0x1p-119 * t);
  }
  // begins next to the parabola, whose end is far away
  const SC::internal::Common::Homogeneous_piece line =
      piece_of(bezier({P(0.5 - 0x1p-30, 0.25), P(1.5, 0.25 + 0x1p-10)}));
  const auto at_its_begin = SC::internal::Voronoi::Crossing_refinement(parabola, line)(
      {around(0.5), SC::internal::Common::Parameter_range(Exact_rational(0x1p-31), Exact_rational(0x1p-29))});
  EXPECT_LT(half_width(at_its_begin[0]), 0x1p-119);
  EXPECT_LT(half_width(at_its_begin[1]), 0x1p-148);
  const Curve circle = SC::circle_curve(P(0, 0), 1);
  double before = circle.domain(0).first, behind = before + (circle.domain(0).second - before) / 4;   // of the diagonal
  while (behind - before > 0x1p-40)
    (circle((before + behind) / 2).x() > circle((before + behind) / 2).y() ? before : behind) = (before + behind) / 2;
  const auto [on_circle, on_line] =
      SC::internal::Voronoi::Crossing_refinement(piece_of(circle), piece_of(bezier({P(0, 0), P(1, 1)})))(
          {SC::internal::Common::Parameter_range(before, behind), around(std::sqrt(0.5))});
  EXPECT_TRUE(is_square_within(on_line, Exact_rational(1) / 2));
  EXPECT_LT(half_width(on_line), 0x1p-118);
  EXPECT_LT(half_width(on_circle), 0x1p-110);
}

// Two rooms with a wall between them, and a curve that dips below a segment: arcs are left out that are seen from a
// side where another face is, and no others.
TEST(CrossingCurves, FacesBehindArcs)
{
  const SC::Upward_rounding_guard guard;
  const auto candidate = [](const SC::internal::Voronoi::Site_graph_2<>& graph, std::size_t arc,
                            const SC::internal::Common::Range& range) {
    return SC::internal::Voronoi::Disk_candidate<>{SC::internal::Voronoi::Candidate_kind::ARC, arc, range,
                                                   graph.arcs()[arc].jet(range)};
  };
  const auto rooms = graph_of({bezier({P(0, 0), P(4, 0)}), bezier({P(4, 0), P(4, 4)}), bezier({P(4, 4), P(0, 4)}),
                               bezier({P(0, 4), P(0, 0)}), bezier({P(4, 0), P(8, 0)}), bezier({P(8, 0), P(8, 4)}),
                               bezier({P(8, 4), P(4, 4)}), bezier({P(10, 1), P(10, 3)})});
  const SC::internal::Voronoi::Separate_faces<> faces(*rooms, false);
  for (std::size_t arc = 0; arc < 8; ++arc) {
    // from inside of the first room: the walls of the other one; a curve apart is not known to be outside
    EXPECT_EQ(faces.hold(0, arc), 4 <= arc && arc < 7) << arc;
    EXPECT_EQ(faces.hold(1, arc), arc == 1) << arc;              // from outside: the wall between
  }
  // arcs 0 and 2 around the lens, from (0,0) to (8/3,0)
  const auto lens = graph_of({bezier({P(0, 0), P(4, 0)}), bezier({P(0, 0), P(2, -1), P(4, 1)})});
  const SC::internal::Voronoi::Separate_faces<> beside_lens(*lens, false);
  const SC::internal::Voronoi::Disk_curvature<> curvature(*lens);
  const auto is_left_out = [&](std::size_t element, const SC::internal::Common::Range& part, std::size_t arc,
                               const SC::internal::Common::Range& range) {
    return beside_lens.hold(curvature.part(element, part),
                            curvature.part(element, {part.middle(), part.middle()}), candidate(*lens, arc, range));
  };
  for (const SC::internal::Common::Range& range :
       {SC::internal::Common::Range{0, 0.25}, {0.25, 0.5}, {0.5, 0.75}, {0.96875, 1}}) {
    EXPECT_TRUE(is_left_out(6, {0.3, 0.31}, 2, range)) << range.begin;   // from above, behind the segment
    EXPECT_FALSE(is_left_out(6, {0.3, 0.31}, 0, range));                 // the segment before
    EXPECT_FALSE(is_left_out(1, {0.3, 0.31}, 2, range));                 // from the lens
    EXPECT_FALSE(is_left_out(3, {0.3, 0.31}, 0, range));                 // on the line of the element: not certain
  }
  EXPECT_FALSE(is_left_out(3, {0.3, 0.31}, 2, {0.5, 0.75}));   // from below
}

// A parabola that ends with a tangent parallel to a segment, so near to it that doubles hardly tell the gap: disks that
// touch it near its vertex are nearly those of its curvature, and touch the segment or the vertex.
TEST(CrossingCurves, ThinGap)
{
  const Curves curves{bezier({P(0, 0), P(8, 0)}), bezier({P(4, 1e-13), P(5, 1e-13), P(6, 1)})};
  const Diagram diagram = SC::voronoi_diagram(curves);
  expect_right(diagram, curves, 2);
  EXPECT_EQ(number_of_parts(diagram), 2U);
  EXPECT_EQ(std::count_if(diagram.vertices().begin(), diagram.vertices().end(),
                          [](const auto& v) { return v.is_resolved && v.radius && *v.radius < 1e-12; }),
            1);
}

// Common axes of curves that cross at parameters which are not rational: a disk with its center on one touches two arcs
// that end there, and a third one.
TEST(CrossingCurves, SymmetricCurves)
{
  const auto ellipse = [](double y, double a, double b) { return SC::ellipse_curve(P(0, y), {a, 0}, {0, b}); };
  const Curves ellipses{ellipse(0, 1, 3), ellipse(0, 3, 1)};
  const Diagram four = SC::voronoi_diagram(ellipses);
  expect_right(four, ellipses, 1);
  // The disk around (x, 0) that touches the second one in two points has r^2 = 1 - x^2/8, and r = x - 1 if it touches
  // the first one, too.
  EXPECT_EQ(std::count_if(four.vertices().begin(), four.vertices().end(),
                          [](const auto& v) {
                            return v.edges.size() == 3 && v.radius && std::abs(*v.radius - 7. / 9) < 1e-9 &&
                                std::abs(distance(*v.point, P(0, 0)) - 16. / 9) < 1e-9;
                          }),
            4);
  // Joints on the axis, of a circle and of two segments; the tangent there is perpendicular to it, or not.
  const Curves round{ellipse(0, 1, 3), ellipse(4, 2, 2)},
      straight{ellipse(0, 1, 3), bezier({P(-2, 2), P(0, 2)}), bezier({P(0, 2), P(2, 2)})};
  const Curves bent{ellipse(0, 1, 3), bezier({P(-2, 4), P(0, 2)}), bezier({P(0, 2), P(2, 4)})},
      parabolas{bezier({P(-2, 4), P(0, -4), P(2, 4)}), bezier({P(-2, 0), P(0, 6), P(2, 0)})};
  for (const Curves& scene : {round, straight, bent, parabolas}) {
    const Diagram diagram = SC::voronoi_diagram(scene);
    expect_right(diagram, scene, 1);
    EXPECT_TRUE(std::any_of(diagram.vertices().begin(), diagram.vertices().end(), [](const auto& v) {
      return v.is_resolved && v.edges.size() > 2 && v.point && std::abs(v.point->x()) < 1e-9;
    }));
  }
}

// One site for the points that curves have in common: the second curve adds nothing.
void expect_coincident(const Curves& curves, std::size_t parts, const Curves& without)
{
  const Diagram diagram = SC::voronoi_diagram(curves), simple = SC::voronoi_diagram(without);
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(diagram.coincident_parts().size(), parts);
  EXPECT_EQ(diagram.sites().size(), simple.sites().size());
  EXPECT_EQ(counts(diagram), counts(simple));
  EXPECT_TRUE(simple.coincident_parts().empty());
  expect_euler(diagram);
  for (const auto& coincidence : diagram.coincident_parts())
    for (std::size_t end : {0, 1}) {
      const P p = curves[coincidence.curves[0]](coincidence.parameters[0][end]),
              q = curves[coincidence.curves[1]](coincidence.parameters[1][coincidence.is_reversed ? 1 - end : end]);
      EXPECT_NEAR(distance(p, q), 0, 1e-14);
    }
}

TEST(CrossingCurves, CurvesThatAreGivenTwice)
{
  const Curve cubic = bezier({P(0, 0), P(1, 2), P(2, -2), P(3, 0)}),
              backward = bezier({P(3, 0), P(2, -2), P(1, 2), P(0, 0)}), segment = bezier({P(1, -1), P(0.5, 2)});
  expect_coincident({cubic, cubic}, 1, {cubic});
  expect_coincident({cubic, backward, cubic}, 3, {cubic});
  expect_coincident({cubic, segment, backward, segment}, 2, {cubic, segment});   // they cross at irrational parameters
  // The same parabola with its degree elevated.
  expect_coincident({bezier({P(0, 0), P(3, 6), P(6, 0)}), bezier({P(0, 0), P(2, 4), P(4, 4), P(6, 0)})}, 1,
                    {bezier({P(0, 0), P(3, 6), P(6, 0)})});
}

// A piece of y = x^2 / 36 at another speed, forward and backward.
TEST(CrossingCurves, PiecesInCommonAtOtherSpeeds)
{
  const Curve parabola = bezier({P(-6, 1), P(12, -5), P(30, 25)}),
              piece = bezier({P(6, 1), P(9, 2), P(13, 4), P(18, 8), P(24, 16)}),
              backward = bezier({P(24, 16), P(18, 8), P(13, 4), P(9, 2), P(6, 1)});
  const Curves parts{bezier({P(-6, 1), P(0, -1), P(6, 1)}), bezier({P(6, 1), P(15, 4), P(24, 16)}),
                     bezier({P(24, 16), P(27, 20), P(30, 25)})};
  expect_coincident({parabola, piece}, 1, parts);
  expect_coincident({backward, parabola}, 1, parts);
}

TEST(CrossingCurves, PiecesInCommon)
{
  const Curve cubic = bezier({P(0, 0), P(1, 2), P(2, -2), P(3, 0)}),
              half = bezier({P(0, 0), P(0.5, 1), P(1, 0.5), P(1.5, 0)}),
              other_half = bezier({P(1.5, 0), P(2, -0.5), P(2.5, -1), P(3, 0)});
  expect_coincident({cubic, half}, 1, {half, other_half});
  expect_coincident({half, cubic}, 1, {half, other_half});
  const Curves segments{bezier({P(0, 0), P(1, 0)}), bezier({P(1, 0), P(2, 0)}), bezier({P(2, 0), P(3, 0)})};
  expect_coincident({bezier({P(0, 0), P(2, 0)}), bezier({P(1, 0), P(3, 0)})}, 1, segments);
  expect_coincident({bezier({P(0, 0), P(2, 0)}), bezier({P(3, 0), P(1, 0)})}, 1, segments);
  // Walls of two rooms, whose corners are not the same points.
  const Curve room = SC::polyline_curve(std::vector<P>{P(0, 0), P(4, 0), P(4, 4), P(0, 4), P(0, 0)}),
              next_room = SC::polyline_curve(std::vector<P>{P(4, 1), P(8, 1), P(8, 5), P(4, 5), P(4, 1)});
  const Diagram rooms = SC::voronoi_diagram(Curves{room, next_room});
  EXPECT_TRUE(rooms.is_complete());
  expect_euler(rooms);
  ASSERT_EQ(rooms.coincident_parts().size(), 1U);
  EXPECT_EQ(rooms.coincident_parts()[0].parameters[0], (std::array<double, 2>{1.25, 2}));
  EXPECT_EQ(rooms.coincident_parts()[0].parameters[1], (std::array<double, 2>{3.25, 4}));
  EXPECT_TRUE(rooms.coincident_parts()[0].is_reversed);
  expect_empty_disks(rooms, {room, next_room}, 0.2, 20);
  // A curve that turns back.
  const Diagram back =
      SC::voronoi_diagram(Curves{SC::polyline_curve(std::vector<P>{P(0, 0), P(2, 0), P(2, 2), P(2, 0), P(3, 0)})});
  EXPECT_TRUE(back.is_complete());
  EXPECT_EQ(back.coincident_parts().size(), 1U);
  EXPECT_EQ(number_of_parts(back), 3U);
}

// The seam of the second circle is in an irrational point, or one at other parameters, of the first one.
TEST(CrossingCurves, CirclesInCommon)
{
  const auto circle = [](double x, double y) {
    return SC::ellipse_curve(P(0, 0), K::Vector_2(x, y), K::Vector_2(-y, x));
  };
  expect_coincident({circle(5, 0), circle(5, 0)}, 4, {circle(5, 0)});
  expect_coincident({circle(5, 0), circle(0, -5)}, 4, {circle(5, 0)});
  const Diagram turned = SC::voronoi_diagram(Curves{circle(5, 0), circle(3, 4)});
  EXPECT_TRUE(turned.is_complete());
  EXPECT_EQ(turned.coincident_parts().size(), 8U);
  EXPECT_EQ(number_of_parts(turned), 8U);
  expect_euler(turned);
}

// Points that lie on curves are ends of their parts, also at irrational parameters.
TEST(CrossingCurves, PointsOnCurves)
{
  const Curves segments{bezier({P(0, 0), P(4, 1)}), bezier({P(0, 2), P(0.5, 2.5), P(2, 4)})};
  const Diagram diagram = SC::voronoi_diagram(segments, {P(2, 0.5), P(1, 3), P(0, 0)});
  EXPECT_TRUE(diagram.is_complete());
  EXPECT_EQ(number_of_parts(diagram), 4U);
  EXPECT_EQ(diagram.sites().size(), 10U);
  EXPECT_EQ(diagram.number_of_regions(), 2U);
  expect_euler(diagram);
  expect_empty_disks(diagram, segments, 0.2, 20);
}

TEST(CrossingCurves, RandomCubics)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(0, 10);
  std::size_t crossings = 0;
  for (int run = 0; run < 2; ++run) {
    Curves curves;
    for (int i = 0; i < 2 + run; ++i) {
      std::vector<P> points;
      for (int k = 0; k < 4; ++k) {
        const double x = coordinate(random);
        points.emplace_back(x, coordinate(random));
      }
      curves.push_back(bezier(points));
    }
    const Diagram diagram = SC::voronoi_diagram(curves);
    crossings += number_of_parts(diagram) - curves.size();
    expect_right(diagram, curves, diagram.number_of_regions());
  }
  EXPECT_GT(crossings, 3U);
}

} // namespace crossing_curves
} // namespace

} // namespace crossing_curves_2_test
