// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed offsets: areas in closed form, events at known radii and parameters; of curves that cross each other, every
// point has the distance, the area is that found by random points, and motions do not change anything.
#include "polygon_area.h"
#include "region_of_a_drawing.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace trimmed_offsets_2_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using P = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Offset = SC::Trimmed_offset_2<K>;

constexpr double pi = 3.14159265358979323846;
constexpr double tolerance = 0.02;   // of areas: chords miss two thirds of 0.0001 times the length

Curve bezier(const std::vector<P>& points) { return SC::bezier_curve(points); }

Curves polygon_sides(const std::vector<P>& corners)
{
  Curves sides;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sides.push_back(bezier({corners[i], corners[(i + 1) % corners.size()]}));
  return sides;
}

double area(const Offset& offset) { return total_area(offset.polygons_with_holes(1e-4)); }

struct Counts
{
  std::size_t components = 0, holes = 0, arcs = 0;
  bool operator==(const Counts&) const = default;
};

Counts counts(const Offset& offset)
{
  EXPECT_TRUE(offset.is_complete());
  Counts result{0, 0, offset.arcs().size()};
  for (const auto& boundary : offset.boundaries())
    ++(boundary.is_hole ? result.holes : result.components);
  return result;
}

// Arcs around an end, a corner and a joint within a curve tell which one that is.
TEST(TrimmedOffsets, ArcsKnowTheirOrigin)
{
  const Curves curves{bezier({P(0, 4), P(0, 0)}), SC::polyline_curve(std::vector<P>{P(0, 0), P(4, 0), P(4, 4)})};
  const Offset offset = SC::trimmed_offset(curves, 1, {P(9, 9)});
  EXPECT_TRUE(offset.is_complete());
  std::size_t around_vertices = 0, around_points = 0;
  for (const Offset::Arc& arc : offset.arcs())
    if (arc.is_circular && arc.curve) {
      ++around_vertices;
      EXPECT_EQ(arc.parameters[0], arc.parameters[1]);
      EXPECT_EQ(curves[*arc.curve](arc.parameters[0]), arc.center);
      EXPECT_EQ(arc.curve, arc.center->x() < 4 ? 0U : 1U);   // in the common end, the lower index
    } else if (arc.is_circular) {
      ++around_points;
      EXPECT_EQ(arc.center, P(9, 9));
    }
  EXPECT_EQ(around_vertices, 4U);
  EXPECT_EQ(around_points, 1U);
}

TEST(TrimmedOffsets, Points)
{
  const Offset one = SC::trimmed_offset(Curves(), 2, {P(1, 3)});
  EXPECT_EQ(counts(one), (Counts{1, 0, 1}));
  EXPECT_TRUE(one.arcs()[0].is_circular);
  EXPECT_EQ(one.arcs()[0].center, P(1, 3));
  EXPECT_NEAR(area(one), 4 * pi, tolerance);

  const std::vector<P> points{P(0, 0), P(2, 0)};
  EXPECT_EQ(counts(SC::trimmed_offset(Curves(), 0.999, points)), (Counts{2, 0, 2}));
  const Offset touching = SC::trimmed_offset(Curves(), 1, points);   // one boundary that passes the point twice
  EXPECT_EQ(counts(touching).components, 1U);
  EXPECT_NEAR(area(touching), 2 * pi, tolerance);
  const Offset merged = SC::trimmed_offset(Curves(), 2, points);
  EXPECT_EQ(counts(merged), (Counts{1, 0, 2}));
  EXPECT_NEAR(area(merged), 16 * pi / 3 + 2 * std::sqrt(3.0), tolerance);   // each disk loses a segment of 120 degrees
}

TEST(TrimmedOffsets, SegmentHasRoundEnds)
{
  const Offset offset = SC::trimmed_offset(Curves{bezier({P(1, 1), P(4, 5)})}, 2);
  EXPECT_EQ(counts(offset), (Counts{1, 0, 4}));
  EXPECT_EQ(std::count_if(offset.arcs().begin(), offset.arcs().end(), [](const auto& arc) { return arc.is_circular; }),
            2);
  EXPECT_NEAR(area(offset), 20 + 4 * pi, tolerance);
}

// Duplicates and pieces in common are offset once.
TEST(TrimmedOffsets, CurvesThatOverlap)
{
  const Offset segments = SC::trimmed_offset(Curves{bezier({P(0, 0), P(2, 0)}), bezier({P(3, 0), P(1, 0)})}, 1);
  EXPECT_TRUE(segments.is_complete());
  EXPECT_EQ(counts(segments).components, 1U);
  EXPECT_NEAR(area(segments), 6 + pi, tolerance);
  const Curve cubic = bezier({P(0, 0), P(1, 2), P(2, -2), P(3, 0)}),
              backward = bezier({P(3, 0), P(2, -2), P(1, 2), P(0, 0)}), segment = bezier({P(1, -1), P(0.5, 2)});
  const Offset twice = SC::trimmed_offset(Curves{cubic, backward, segment, segment}, 0.25),
               once = SC::trimmed_offset(Curves{cubic, segment}, 0.25);
  EXPECT_TRUE(twice.is_complete());
  EXPECT_EQ(counts(twice), counts(once));
  EXPECT_EQ(area(twice), area(once));
}

TEST(TrimmedOffsets, CircleOfFourArcs)
{
  const Curves circle{SC::ellipse_curve(P(1, 2), K::Vector_2(3, 0), K::Vector_2(0, 3))};
  const Offset ring = SC::trimmed_offset(circle, 1);
  EXPECT_EQ(counts(ring), (Counts{1, 1, 2}));
  EXPECT_NEAR(area(ring), 12 * pi, tolerance);
  const Offset disk = SC::trimmed_offset(circle, 4);
  EXPECT_EQ(counts(disk), (Counts{1, 0, 1}));
  EXPECT_NEAR(area(disk), 49 * pi, tolerance);
  EXPECT_EQ(counts(SC::trimmed_offset(circle, 3)), (Counts{1, 0, 1}));   // the inner offset is a point
}

// Sides 3, 4, 5, and an inscribed circle of radius 1: inside, a similar triangle is left.
TEST(TrimmedOffsets, Triangle)
{
  const Curves sides = polygon_sides({P(0, 0), P(4, 0), P(0, 3)});
  for (const double r : {0.25, 0.5, 0.875}) {
    const Offset offset = SC::trimmed_offset(sides, r);
    EXPECT_EQ(counts(offset), (Counts{1, 1, 9}));
    EXPECT_NEAR(area(offset), 6 + 12 * r + pi * r * r - 6 * (1 - r) * (1 - r), tolerance);
  }
  EXPECT_EQ(counts(SC::trimmed_offset(sides, 1.125)), (Counts{1, 0, 6}));
}

// Two rooms and a corridor that is two units wide.
TEST(TrimmedOffsets, InnerOffsetFallsIntoParts)
{
  const Curves walls = polygon_sides(
      {P(0, 0), P(5, 0), P(5, 2), P(9, 2), P(9, 0), P(14, 0), P(14, 6), P(9, 6), P(9, 4), P(5, 4), P(5, 6), P(0, 6)});
  EXPECT_EQ(counts(SC::trimmed_offset(walls, 0.75)).holes, 1U);
  EXPECT_EQ(counts(SC::trimmed_offset(walls, 1.25)).holes, 2U);
  EXPECT_EQ(counts(SC::trimmed_offset(walls, 3)).holes, 0U);
}

// Two rooms and a corridor, as a region that shrinks, and grows with round corners; area and perimeter are 68 and 48,
// there are eight convex corners and four reflex ones.
TEST(TrimmedOffsets, RegionShrinksAndGrows)
{
  const auto rooms = SC::planar_region(polygon_sides(
      {P(0, 0), P(5, 0), P(5, 2), P(9, 2), P(9, 0), P(14, 0), P(14, 6), P(9, 6), P(9, 4), P(5, 4), P(5, 6), P(0, 6)}));
  const Offset grown = SC::trimmed_offset(rooms, 0.5);
  EXPECT_EQ(counts(grown), (Counts{1, 0, 20}));
  EXPECT_NEAR(area(grown), 68 + 48 * 0.5 + 8 * pi / 16 - 4 * 0.25, tolerance);
  const Offset shrunk = SC::trimmed_offset(rooms, -0.5);
  EXPECT_EQ(counts(shrunk), (Counts{1, 0, 16}));
  EXPECT_NEAR(area(shrunk), 68 - 48 * 0.5 - 4 * pi / 16 + 8 * 0.25, tolerance);
  const Offset parts = SC::trimmed_offset(rooms, -1.25);
  EXPECT_EQ(counts(parts).components, 2U);
  EXPECT_EQ(parts.polygons_with_holes(0.01).size(), 2U);
  EXPECT_EQ(counts(SC::trimmed_offset(rooms, -3)), Counts());   // nothing is left
}

// A square with a round hole, which shrinks to a thin frame, and grows until the hole is closed.
TEST(TrimmedOffsets, RegionWithAHole)
{
  Curves curves = polygon_sides({P(-4, -4), P(4, -4), P(4, 4), P(-4, 4)});
  curves.push_back(SC::ellipse_curve(P(0, 0), K::Vector_2(2, 0), K::Vector_2(0, 2)));
  const auto frame = SC::planar_region(curves);
  const Offset thin = SC::trimmed_offset(frame, -0.75);
  EXPECT_EQ(counts(thin), (Counts{1, 1, 5}));
  EXPECT_NEAR(area(thin), 6.5 * 6.5 - 2.75 * 2.75 * pi, tolerance);
  EXPECT_EQ(counts(SC::trimmed_offset(frame, -1.25)).components, 4U);   // one in each corner
  const Offset thick = SC::trimmed_offset(frame, 1);
  EXPECT_EQ(counts(thick), (Counts{1, 1, 9}));
  EXPECT_NEAR(area(thick), 64 + 32 + pi - pi, tolerance);
  EXPECT_EQ(counts(SC::trimmed_offset(frame, 2.5)), (Counts{1, 0, 8}));
  EXPECT_THROW(SC::trimmed_offset(frame, 0), SC::Invalid_input);
}

// Two squares with a corner in common, as one outline; and a frame whose outline leads to the hole and back.
TEST(TrimmedOffsets, OutlinesThatTouch)
{
  const auto outline = [](const std::vector<P>& corners) { return SC::planar_region(SC::polyline_curve(corners)); };
  const auto squares = outline({P(0, 0), P(1, 0), P(1, 1), P(0, 1), P(0, 0), P(-1, 0), P(-1, -1), P(0, -1), P(0, 0)});
  const Offset grown = SC::trimmed_offset(squares, 0.25), shrunk = SC::trimmed_offset(squares, -0.25);
  EXPECT_EQ(counts(grown), (Counts{1, 0, 14}));
  EXPECT_NEAR(area(grown), 2 + 8 * 0.25 + (1.5 * pi - 2) / 16, tolerance);
  EXPECT_EQ(counts(shrunk), (Counts{2, 0, 8}));
  EXPECT_NEAR(area(shrunk), 0.5, tolerance);
  const auto frame =
      outline({P(0, 0), P(6, 0), P(6, 6), P(0, 6), P(0, 0), P(2, 2), P(2, 4), P(4, 4), P(4, 2), P(2, 2), P(0, 0)});
  const Offset thin = SC::trimmed_offset(frame, -0.5);
  EXPECT_EQ(counts(thin), (Counts{1, 1, 12}));
  EXPECT_NEAR(area(thin), 25 - 4 - 4 - pi / 4, tolerance);
}

// The area that two disks have in common whose centers have the distance 1 or more.
double area_of_lens(double r, double s, double d)
{
  const auto segment = [](double radius, double height) {
    return radius * radius * std::acos(height / radius) - height * std::sqrt(radius * radius - height * height);
  };
  const double x = (d * d + r * r - s * s) / (2 * d);
  return segment(r, x) + segment(s, d - x);
}

// A hole that touches the boundary from inside, two disks that touch, and curves: two circles and a line through one
// point, with one tangent there, and a segment that crosses one of them.
TEST(TrimmedOffsets, CurvesThatTouch)
{
  const auto circle = [](double x, double r) { return SC::circle_curve(P(x, 0), r); };
  const auto crescent = SC::planar_region(Curves{circle(0, 2), circle(1, 1)}),
             eight = SC::planar_region(Curves{circle(-1, 1), circle(1, 1)});
  const Offset thin = SC::trimmed_offset(crescent, -0.25), thick = SC::trimmed_offset(crescent, 0.25),
               greater = SC::trimmed_offset(eight, 0.25);
  EXPECT_EQ(counts(thin), (Counts{1, 0, counts(thin).arcs}));
  EXPECT_NEAR(area(thin), pi * 1.75 * 1.75 - area_of_lens(1.75, 1.25, 1), tolerance);
  EXPECT_EQ(counts(thick), (Counts{1, 1, counts(thick).arcs}));
  EXPECT_NEAR(area(thick), pi * (2.25 * 2.25 - 0.75 * 0.75), tolerance);
  EXPECT_EQ(counts(greater), (Counts{1, 0, counts(greater).arcs}));
  EXPECT_NEAR(area(greater), 2 * pi * 1.25 * 1.25 - area_of_lens(1.25, 1.25, 2), tolerance);

  const Offset curves = SC::trimmed_offset(
      Curves{circle(1, 1), circle(-1, 1), bezier({P(0, -3), P(0, 3)}), bezier({P(1, 0), P(3, 0)})}, 0.25);
  EXPECT_EQ(counts(curves), (Counts{1, 2, counts(curves).arcs}));
}

// Segments point to where their offset crosses that of a circle: to a disk that touches their ends in the middle of the
// half circle around these, and the circle at a rational parameter.
TEST(TrimmedOffsets, CrossingsAheadOfEnds)
{
  const Offset offset = SC::trimmed_offset(
      Curves{SC::circle_curve(P(0, 0), 4), bezier({P(1, 4), P(2, 4)}), bezier({P(1, -4), P(2, -4)})}, 1);
  EXPECT_EQ(counts(offset), (Counts{1, 1, counts(offset).arcs}));
  for (const double y : {4.0, -4.0}) {
    bool is_end_of_arc = false;
    for (std::size_t arc = 0; arc < offset.arcs().size(); ++arc)
      is_end_of_arc = is_end_of_arc || CGAL::squared_distance(offset.polyline(arc, 1e-3).back(), P(3, y)) < 1e-24;
    EXPECT_TRUE(is_end_of_arc);
  }

  // Around the upper segment from (3,4) on, as far as (1,4) + (cos a, sin a) on the circle of radius 5; twice, and two
  // parts of that circle.
  const double a = std::atan2(4, 1) + std::acos(3.5 / std::sqrt(17.0)),
               end = std::atan2(4 + std::sin(a), 1 + std::cos(a)), begin = std::atan2(4, 3);
  const auto around = [](double x, double y, double from, double to) {
    return (to - from + x * (std::sin(to) - std::sin(from)) - y * (std::cos(to) - std::cos(from))) / 2;
  };
  const double upper = around(2, 4, 0, pi / 2) + 5. / 2 + around(1, 4, pi / 2, a);
  EXPECT_NEAR(area(offset), 2 * upper + 25. / 2 * (2 * (pi - end) + 2 * begin) - 9 * pi, tolerance);
}

// The least and greatest distance from curves of points on the boundary of an offset.
std::array<double, 2> distances(const Offset& offset, const Curves& curves)
{
  constexpr int samples = 1000;
  std::vector<P> points;
  for (const Curve& curve : curves)
    for (int k = 0; k <= samples; ++k)
      points.push_back(curve(curve.domain(0).first + (curve.domain(0).second - curve.domain(0).first) * k / samples));
  std::array<double, 2> result{std::numeric_limits<double>::infinity(), 0};
  for (std::size_t arc = 0; arc < offset.arcs().size(); ++arc)
    for (const P& p : offset.polyline(arc, 1e-3)) {
      double least = std::numeric_limits<double>::infinity();
      for (const P& q : points)
        least = (std::min)(least, CGAL::squared_distance(p, q));
      result = {(std::min)(result[0], std::sqrt(least)), (std::max)(result[1], std::sqrt(least))};
    }
  return result;
}

// A curve that begins in the inside of a segment, at a parameter that no double is, nearly in its direction: disks
// around the begin hold the segment, which is on a line through it.
TEST(TrimmedOffsets, BeginInSegment)
{
  const Curves curves{bezier({P(2.6, 0.4), P(2.5, 1.1)}),
                      bezier({P(2.54, 0.8200000000000001), P(2.59, 0.47), P(5.2, 6.9)})};
  const Offset offset = SC::trimmed_offset(curves, 0.3);
  EXPECT_GE(offset.arcs().size(), 8U);   // the sides and ends of both curves, but for where they are covered
  const auto [least, greatest] = distances(offset, curves);
  EXPECT_GT(least, 0.3 - 1e-9);   // points of chords are farther away
  EXPECT_LT(greatest, 0.3 + 1e-3);
}

// A tangent of two circles, with ends that are rounded: it misses the circles by 10^-16, or ends inside of them.
TEST(TrimmedOffsets, TangentWithRoundedEnds)
{
  const Curves curves{SC::circle_curve(P(0.3, 0.2), 1.5), SC::circle_curve(P(8.6, 0.2), 2.5),
                      bezier({P(0.11927710843373496, 1.6890732810926157), P(8.2987951807228928, 2.6817888018210261)})};
  const Offset offset = SC::trimmed_offset(curves, 0.5);
  const Counts found = counts(offset);
  EXPECT_EQ(found, (Counts{1, 2, found.arcs}));   // both circles inside, and all around
  const auto [least, greatest] = distances(offset, curves);
  EXPECT_GT(least, 0.5 - 1e-9);
  EXPECT_LT(greatest, 0.5 + 1e-3);
}

// A curve that leaves the begin of a segment on one side, and crosses it to the other one, where disks that touch the
// segment touch it.
TEST(TrimmedOffsets, CurvesThatCrossAgain)
{
  const Curves curves{bezier({P(0, 0), P(4, 0)}), bezier({P(0, 0), P(2, -1), P(4, 1)})};
  for (const double distance : {0.05, 0.2}) {
    const Offset offset = SC::trimmed_offset(curves, distance);
    EXPECT_EQ(counts(offset).components, 1U);
    const auto [least, greatest] = distances(offset, curves);
    EXPECT_GT(least, distance - 1e-9);
    EXPECT_LT(greatest, distance + 1e-3);
  }
}

// Walls on a grid, at twice the distance: offsets coincide, or touch in points. Each outline is followed by distances,
// areas, and the numbers of components and holes.
TEST(TrimmedOffsets, RoundDistances)
{
  struct Expected
  {
    double distance, area;
    std::size_t components, holes;
  };
  const auto check = [](const Curves& curves, const std::vector<Expected>& all) {
    const auto region = SC::planar_region(curves);
    for (const Expected& expected : all) {
      const Offset offset = SC::trimmed_offset(region, expected.distance);
      EXPECT_EQ(counts(offset), (Counts{expected.components, expected.holes, offset.arcs().size()}))
          << expected.distance;
      EXPECT_NEAR(area(offset), expected.area, tolerance) << expected.distance;
    }
  };
  const auto squares = [](const std::vector<std::array<double, 3>>& all) {   // corner and side
    Curves result;
    for (const auto& [x, y, side] : all)
      for (const Curve& curve : polygon_sides({P(x, y), P(x + side, y), P(x + side, y + side), P(x, y + side)}))
        result.push_back(curve);
    return result;
  };
  const double corner = 1 - pi / 4;   // between a square and a quarter of a disk
  check(squares({{0, 0, 2}, {4, 0, 2}}), {{1, 24 + 2 * pi, 1, 0}, {-1, 0, 0, 0}});
  check(squares({{0, 0, 3}, {6, 7, 3}}), {{2.5, 78 + 12.5 * pi, 1, 0}});   // corners 3 and 4 apart touch
  check(squares({{0, 0, 6}, {2, 2, 2}}), {{1, 60 + pi, 1, 0}, {-1, 4 * corner, 4, 0}});   // a frame
  check(polygon_sides({P(0, 0), P(10, 0), P(10, 2), P(0, 2)}), {{-1, 0, 0, 0}});
  // U
  check(polygon_sides({P(0, 0), P(6, 0), P(6, 6), P(4, 6), P(4, 2), P(2, 2), P(2, 6), P(0, 6)}),
        {{1, 60 + pi - 2 * corner, 1, 0}, {-1, 2 * corner, 2, 0}});
  check(polygon_sides({P(0, 0), P(4, 0), P(4, 2), P(2, 2), P(2, 4), P(0, 4)}), {{-1, corner, 1, 0}});   // L
  // the rooms, and the corridor is closed
  check(polygon_sides({P(0, 0), P(5, 0), P(5, 2), P(9, 2), P(9, 0), P(14, 0), P(14, 6), P(9, 6), P(9, 4), P(5, 4),
                       P(5, 6), P(0, 6)}),
        {{-1, 24 + 4 * corner, 2, 0}});
  check(polygon_sides({P(0, 0), P(4, 0), P(0, 3)}), {{-1, 0, 0, 0}});   // the inscribed circle
  const auto circle = [](double x, double r) { return SC::circle_curve(P(x, 0), r); };
  check({circle(0, 1), circle(4, 1)}, {{1, 8 * pi, 1, 0}, {-1, 0, 0, 0}});
  check({circle(0, 3), circle(0, 1)}, {{1, 16 * pi, 1, 0}, {-1, 0, 0, 0}});   // a ring
  const auto quarter = [](double x, double y, const P& from, const P& to) {
    return SC::circular_arc_curve(P(x, y), from, to);
  };
  check({bezier({P(1, 0), P(5, 0)}), quarter(5, 1, P(5, 0), P(6, 1)), bezier({P(6, 1), P(6, 3)}),
         quarter(5, 3, P(6, 3), P(5, 4)), bezier({P(5, 4), P(1, 4)}), quarter(1, 3, P(1, 4), P(0, 3)),
         bezier({P(0, 3), P(0, 1)}), quarter(1, 1, P(0, 1), P(1, 0))},
        {{-1, 8, 1, 0}}); // round corners that become sharp
}

TEST(TrimmedOffsets, RegionOfADrawing)
{
  const auto region = region_of_a_drawing<K>();
  for (const double distance : {-0.25, 0.25}) {
    const Offset offset = SC::trimmed_offset(region, distance);
    EXPECT_EQ(counts(offset).components, 1U);
    EXPECT_EQ(counts(offset).holes, 1U);
    EXPECT_NEAR(area(offset),
                12 * (2 + distance) + pi * ((2 + distance) * (2 + distance) - (1 - distance) * (1 - distance)),
                tolerance);
  }
}

// A disk within a ring: an offset has two components, one of them in the hole of the other one.
TEST(TrimmedOffsets, ComponentInAHole)
{
  const auto circle = [](double r) { return SC::ellipse_curve(P(0, 0), K::Vector_2(r, 0), K::Vector_2(0, r)); };
  const Offset offset = SC::trimmed_offset(Curves{circle(8), circle(4)}, 1, {P(1, 0)});
  EXPECT_EQ(counts(offset), (Counts{3, 2, 5}));
  EXPECT_NEAR(area(offset), pi * (81 - 49 + 25 - 9 + 1), tolerance);
  const auto polygons = offset.polygons_with_holes(0.01);
  ASSERT_EQ(polygons.size(), 3U);
  for (const auto& polygon : polygons) {
    const double size = polygon.outer_boundary().bbox().xmax();
    EXPECT_EQ(polygon.number_of_holes(), size > 3 ? 1U : 0U);
    if (size > 3) {
      EXPECT_NEAR(polygon.holes_begin()->bbox().xmax(), size - 2, 0.02);
    }
  }
}

// The inner offset of y = x^2 at distance 1 crosses itself at x = +- sqrt(3) / 2.
TEST(TrimmedOffsets, ParabolaIsCutWhereItsOffsetCrossesItself)
{
  const Offset offset = SC::trimmed_offset(Curves{bezier({P(-2, 4), P(0, -4), P(2, 4)})}, 1);
  EXPECT_EQ(counts(offset), (Counts{1, 0, 5}));
  std::vector<double> cuts;
  for (const auto& arc : offset.arcs())
    for (const double t : arc.parameters)
      if (!arc.is_circular && t > 0 && t < 1)
        cuts.push_back(4 * t - 2);
  std::sort(cuts.begin(), cuts.end());
  ASSERT_EQ(cuts.size(), 2U);
  EXPECT_NEAR(cuts[0], -std::sqrt(3.0) / 2, 1e-12);
  EXPECT_NEAR(cuts[1], std::sqrt(3.0) / 2, 1e-12);
}

Curves random_cubics(std::mt19937& random, int number)
{
  std::uniform_real_distribution<double> coordinate(0, 10);
  Curves curves;
  for (int i = 0; i < number; ++i) {
    std::vector<P> points;
    for (int k = 0; k < 4; ++k)
      points.emplace_back(coordinate(random), coordinate(random));
    curves.push_back(bezier(points));
  }
  return curves;
}

std::vector<P> points_of(const Curves& curves)
{
  constexpr int steps = 200;
  std::vector<P> points;
  for (const Curve& curve : curves)
    for (int i = 0; i <= steps; ++i)
      points.push_back(curve(static_cast<double>(i) / steps));
  return points;
}

double distance(const P& p, const std::vector<P>& points)
{
  double least = std::numeric_limits<double>::infinity();
  for (const P& q : points)
    least = (std::min)(least, CGAL::squared_distance(p, q));
  return std::sqrt(least);
}

// Where the first or last two control points of a cubic coincide, as in many drawings, its derivative is zero and its
// curvature infinite. Convex regions grow by their length times the distance, and a disk; what is left of them inside
// has the distance.
TEST(TrimmedOffsets, CoincidentControlPoints)
{
  const P a(4, 0), b(6, 0), c(6, 2);
  int asked = 0;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 6);
  for (const Curve& rounded :
       {bezier({a, a, b, c}), bezier({c, b, a, a}), bezier({a, b, c, c}), bezier({a, a, P(6, 1), P(6, 3)}),
        bezier({a, a, c, c}), SC::bezier_curve<K>({a, a, b, c}, {1, 2, 1, 3})}) {
    Curves curves{rounded};
    const P end = rounded(0) == a ? rounded(1) : rounded(0);
    const std::vector<P> corners{end, P(6, 6), P(0, 6), P(0, 0), a};
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
      curves.push_back(bezier({corners[i], corners[i + 1]}));
    std::vector<P> boundary;
    double length = 0;
    for (const Curve& curve : curves)
      for (int i = 0; i <= 400; ++i) {
        boundary.push_back(curve(i / 400.0));
        if (i > 0)
          length += std::sqrt(CGAL::squared_distance(boundary.back(), boundary[boundary.size() - 2]));
      }
    const auto region = SC::planar_region(curves);
    const double r = 0.3;
    const Offset grown = SC::trimmed_offset(region, r), shrunk = SC::trimmed_offset(region, -r);
    EXPECT_EQ(counts(grown).components, 1U);
    EXPECT_NEAR(area(grown), SC::to_nearest_double(region.area().first) + r * length + pi * r * r, tolerance);
    EXPECT_EQ(counts(shrunk).components, 1U);
    const auto polygons = shrunk.polygons_with_holes(1e-4);
    ASSERT_EQ(polygons.size(), 1U);
    for (const P& p : polygons[0].outer_boundary())
      EXPECT_NEAR(distance(p, boundary), r, 1e-3);
    for (int i = 0; i < 40; ++i) {
      const double x = coordinate(random), y = coordinate(random);
      if (const double d = distance(P(x, y), boundary); std::abs(d - r) > 0.01) {
        EXPECT_EQ(polygons[0].outer_boundary().bounded_side(P(x, y)) == CGAL::ON_BOUNDED_SIDE,
                  d > r && region.bounded_side(P(x, y)) == CGAL::ON_BOUNDED_SIDE);
        ++asked;
      }
    }
  }
  EXPECT_GT(asked, 150);
}

// Each arc begins and ends at the distance from the points of its curve with its parameters, which for an arc around a
// point are this one.
void expect_distances_at_ends(const Offset& offset, const Curves& curves, double r)
{
  std::size_t arcs_of_curves = 0;
  for (std::size_t i = 0; i < offset.arcs().size(); ++i) {
    const Offset::Arc& arc = offset.arcs()[i];
    const auto samples = offset.polyline(i, 0.02);
    ASSERT_GT(samples.size(), 1U);
    ASSERT_TRUE(arc.curve && *arc.curve < curves.size());
    arcs_of_curves += !arc.is_circular;
    for (const bool is_end : {false, true}) {
      const P foot = curves[*arc.curve](arc.parameters[is_end]);
      EXPECT_NEAR(std::sqrt(CGAL::squared_distance(is_end ? samples.back() : samples.front(), foot)), r, 1e-9)
          << "arc " << i;
    }
  }
  EXPECT_GT(arcs_of_curves, 0U);
}

TEST(TrimmedOffsets, RandomScenes)
{
  std::mt19937 random(5);
  const K::Aff_transformation_2 motion(0.6, -0.8, 3, 0.8, 0.6, -5);
  for (const double r : {0.25, 0.75}) {
    const Curves curves = random_cubics(random, 3);
    const Offset offset = SC::trimmed_offset(curves, r);
    const Counts found = counts(offset);
    EXPECT_GE(found.components, 1U);

    const std::vector<P> points = points_of(curves);
    for (std::size_t arc = 0; arc < offset.arcs().size(); ++arc)
      for (const P& p : offset.polyline(arc, 0.02))
        EXPECT_NEAR(distance(p, points), r, 0.02);
    expect_distances_at_ends(offset, curves, r);

    constexpr int samples = 2000;
    constexpr double low = -2, high = 12, square = (high - low) * (high - low);
    std::uniform_real_distribution<double> coordinate(low, high);
    int inside = 0;
    for (int i = 0; i < samples; ++i)
      inside += distance(P(coordinate(random), coordinate(random)), points) < r;
    const double share = area(offset) / square;
    EXPECT_NEAR(static_cast<double>(inside) / samples, share, 5 * std::sqrt(share * (1 - share) / samples));

    if (r < 0.5)
      continue;
    Curves moved;
    for (const Curve& curve : curves)
      moved.push_back(curve.transformed(motion));
    const Offset offset_of_moved = SC::trimmed_offset(moved, r);
    EXPECT_EQ(counts(offset_of_moved), found);
    EXPECT_NEAR(area(offset_of_moved), area(offset), tolerance);
  }
}

TEST(TrimmedOffsets, BadInput)
{
  const Curves segment{bezier({P(0, 0), P(1, 0)})};
  for (const double r : {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(SC::trimmed_offset(segment, r), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_offset(Curves{bezier({P(1, 1), P(1, 1)})}, 1), SC::Invalid_input);
  const Offset offset = SC::trimmed_offset(segment, 1);
  EXPECT_THROW(offset.polyline(0, 0), SC::Invalid_input);
  EXPECT_THROW(offset.polygons_with_holes(-1), SC::Invalid_input);
  EXPECT_TRUE(SC::trimmed_offset(Curves(), 1).boundaries().empty());
}

} // namespace trimmed_offsets_2_test
