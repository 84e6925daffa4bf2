// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed bisectors: of points, segments and circles in closed form; of cubics, all samples are as far from both
// curves, and no point of them is nearer; a line across the bisector changes sides there.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_bisectors_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace trimmed_bisectors_2_test {

using Bisector = SC::Trimmed_bisector_2<K>;
using Samples = std::vector<SC::Voronoi_sample_2<K>>;

constexpr double error = 0.01, most_radius = 20;

Curve circle(const P& center, double radius)
{
  return SC::ellipse_curve(center, K::Vector_2(radius, 0), K::Vector_2(0, radius));
}

Samples samples(const Bisector& bisector, const Bisector::Chain& chain)
{
  Samples result;
  for (const auto& polyline : bisector.polylines(chain, error, most_radius))
    result.insert(result.end(), polyline.begin(), polyline.end());
  return result;
}

Samples samples(const Bisector& bisector)
{
  Samples result;
  for (const auto& chain : bisector.chains())
    for (const auto& sample : samples(bisector, chain))
      result.push_back(sample);
  return result;
}

bool ends_at_infinity(const Bisector& bisector, const Bisector::Chain& chain)
{
  return bisector.diagram().vertices()[chain.vertices[0]].is_at_infinity &&
      bisector.diagram().vertices()[chain.vertices[1]].is_at_infinity;
}

// Positive on the left of a polyline.
double side_of(const Samples& polyline, const P& p)
{
  std::size_t nearest = 1;
  for (std::size_t i = 1; i < polyline.size(); ++i)
    if (distance(polyline[i].point, p) < distance(polyline[nearest].point, p))
      nearest = i;
  return CGAL::to_double(
      CGAL::determinant(polyline[nearest].point - polyline[nearest - 1].point, p - polyline[nearest - 1].point));
}

TEST(TrimmedBisectors, TwoPoints)
{
  const P a(-1, 0), b(3, 2);
  const Bisector bisector = SC::trimmed_bisector(a, b);
  EXPECT_TRUE(bisector.is_complete());
  ASSERT_EQ(bisector.chains().size(), 1U);
  EXPECT_TRUE(ends_at_infinity(bisector, bisector.chains()[0]));
  const auto polylines = bisector.polylines(bisector.chains()[0], error, most_radius);
  ASSERT_EQ(polylines.size(), 1U);
  EXPECT_GT(polylines[0].front().radius, 0.99 * most_radius);
  EXPECT_GT(polylines[0].back().radius, 0.99 * most_radius);
  EXPECT_LT(side_of(polylines[0], a), 0);
  for (const auto& sample : polylines[0]) {
    EXPECT_NEAR(2 * sample.point.x() + sample.point.y(), 3, 1e-10 * most_radius);
    EXPECT_NEAR(distance(sample.point, a), sample.radius, 1e-10 * most_radius);
  }
}

// y = 0 and y = 2, both for -1 <= x <= 1: the line y = 1, also where the ends are nearest.
TEST(TrimmedBisectors, ParallelSegments)
{
  const Bisector bisector = SC::trimmed_bisector(bezier({P(-1, 2), P(1, 2)}), bezier({P(-1, 0), P(1, 0)}));
  EXPECT_TRUE(bisector.is_complete());
  ASSERT_EQ(bisector.chains().size(), 1U);
  EXPECT_EQ(bisector.chains()[0].arcs.size(), 3U);
  EXPECT_TRUE(ends_at_infinity(bisector, bisector.chains()[0]));
  const Samples all = samples(bisector);
  ASSERT_GT(all.size(), 10U);
  EXPECT_LT(side_of(all, P(0, 2)), 0);
  for (const auto& sample : all) {
    EXPECT_NEAR(sample.point.y(), 1, 1e-10);
    EXPECT_NEAR(sample.radius, std::hypot(1, (std::max)(0.0, std::abs(sample.point.x()) - 1)), 1e-9);
    if (std::abs(sample.point.x()) < 0.99) {
      EXPECT_NEAR(*sample.parameters[0], sample.point.x() / 2 + 0.5, 1e-9);
      EXPECT_NEAR(*sample.parameters[1], sample.point.x() / 2 + 0.5, 1e-9);
    }
  }
}

// A point below a segment: a parabola, and lines where the ends are nearest.
TEST(TrimmedBisectors, SegmentAndPoint)
{
  const Curve segment = bezier({P(-4, 0), P(4, 0)});
  for (const bool is_first : {true, false}) {
    const Bisector bisector =
        is_first ? SC::trimmed_bisector(P(0, -2), segment) : SC::trimmed_bisector(segment, P(0, -2));
    EXPECT_TRUE(bisector.is_complete());
    ASSERT_EQ(bisector.chains().size(), 1U);
    EXPECT_EQ(bisector.chains()[0].arcs.size(), 3U);
    const Samples all = samples(bisector);
    EXPECT_EQ(side_of(all, P(0, -2)) < 0, is_first);
    std::size_t on_parabola = 0;
    for (const auto& sample : all) {
      const double x = sample.point.x(), y = sample.point.y();
      if (std::abs(x) < 4) {
        ++on_parabola;
        EXPECT_NEAR(y, -1 - x * x / 4, 1e-9);
      }
      EXPECT_NEAR(sample.radius, std::hypot(x, y + 2), 1e-9);
      EXPECT_NEAR(sample.radius, std::hypot((std::max)(0.0, std::abs(x) - 4), y), 1e-9);
      EXPECT_TRUE(!sample.parameters[is_first ? 0 : 1]);
    }
    EXPECT_GT(on_parabola, 5U);
    EXPECT_GT(all.size(), on_parabola + 5);
  }
}

// Of circles with radii 1 and 2, one is nearer by 1 from its center on a branch of a hyperbola; within the other
// circle, the sum of both is the sum or difference of radii.
TEST(TrimmedBisectors, Circles)
{
  const P c(-3, 0), d(3.25, 1.375);
  const Bisector hyperbola = SC::trimmed_bisector(circle(c, 1), circle(d, 2));
  EXPECT_TRUE(hyperbola.is_complete());
  ASSERT_EQ(hyperbola.chains().size(), 1U);
  EXPECT_TRUE(ends_at_infinity(hyperbola, hyperbola.chains()[0]));
  EXPECT_GT(samples(hyperbola).size(), 10U);
  for (const auto& sample : samples(hyperbola)) {
    EXPECT_NEAR(distance(sample.point, c) - 1, sample.radius, 1e-9);
    EXPECT_NEAR(distance(sample.point, d) - 2, sample.radius, 1e-9);
  }
  const Bisector ellipse = SC::trimmed_bisector(circle(P(0, 0), 5), circle(P(1, 1), 2));
  EXPECT_TRUE(ellipse.is_complete());
  ASSERT_EQ(ellipse.chains().size(), 1U);
  EXPECT_TRUE(ellipse.chains()[0].is_closed);
  EXPECT_GT(samples(ellipse).size(), 10U);
  EXPECT_GT(side_of(samples(ellipse), P(1, 1)), 0);   // counterclockwise: what is outside is on the right
  for (const auto& sample : samples(ellipse)) {
    EXPECT_NEAR(5 - distance(sample.point, P(0, 0)), sample.radius, 1e-9);
    EXPECT_NEAR(distance(sample.point, P(1, 1)) - 2, sample.radius, 1e-9);
  }
  const Bisector around = SC::trimmed_bisector(circle(P(0, 0), 5), P(1, 2));
  ASSERT_EQ(around.chains().size(), 1U);
  EXPECT_TRUE(around.chains()[0].is_closed);
  for (const auto& sample : samples(around))
    EXPECT_NEAR(distance(sample.point, P(0, 0)) + distance(sample.point, P(1, 2)), 5, 1e-9);
}

// Segments that share the end (0,0), with a right angle between them; the first curve goes around the corner, where
// points are as far from the common end as from it.
TEST(TrimmedBisectors, CommonEnd)
{
  const Curve a = SC::polyline_curve(std::vector<P>{P(0, 0), P(4, 0), P(4, -4), P(-6, -4)}),
              b = bezier({P(0, 0), P(0, 4)});
  const Bisector bisector = SC::trimmed_bisector(a, b);
  EXPECT_TRUE(bisector.is_complete());
  ASSERT_EQ(bisector.chains().size(), 2U);
  const auto& vertices = bisector.diagram().vertices();
  std::size_t diagonals = 0;
  for (const auto& chain : bisector.chains()) {
    const auto& [first, last] = chain.vertices;
    EXPECT_TRUE(vertices[first].is_at_infinity != vertices[last].is_at_infinity);
    const auto polylines = bisector.polylines(chain, error, most_radius);
    ASSERT_EQ(polylines.size(), 1U);
    if (vertices[last].is_at_infinity && chain.arcs.size() == 2) {   // with the first curve on the right
      ++diagonals;
      EXPECT_NEAR(*vertices[first].radius, 0, 1e-12);
      for (const auto& sample : polylines[0])
        EXPECT_NEAR(sample.point.x(), sample.point.y(), 1e-9);
    } else {
      EXPECT_EQ(chain.arcs.size(), 4U);
      EXPECT_NEAR(distance(*vertices[last].point, P(0, -2)), 0, 1e-9);
      EXPECT_NEAR(*vertices[last].radius, 2, 1e-9);
      for (const auto& sample : polylines[0])
        if (sample.point.x() > -6) {
          EXPECT_NEAR(sample.point.y(), sample.radius - 4, 1e-9);
          EXPECT_NEAR(sample.radius, sample.point.y() < 0 ? distance(sample.point, P(0, 0)) : -sample.point.x(), 1e-9);
        }
    }
  }
  EXPECT_EQ(diagonals, 1U);
}

// Samples are proved to be at their distance from both curves, which they touch where the parameters say.
void expect_trimmed(const Bisector& bisector, const std::vector<Curve>& curves)
{
  const Samples all = samples(bisector);
  ASSERT_GT(all.size(), 20U);
  for (std::size_t i = 0; i < all.size(); i += 1 + all.size() / 8)
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_NEAR(SC::distance_range(all[i].point, curves[k]).first, all[i].radius, 1e-8 * (1 + all[i].radius))
          << "sample " << i;
      if (all[i].parameters[k]) {
        EXPECT_NEAR(distance(curves[k](*all[i].parameters[k]), all[i].point), all[i].radius,
                    1e-8 * (1 + all[i].radius));
      }
    }
}

TEST(TrimmedBisectors, TwoCubics)
{
  const std::vector<Curve> curves{bezier({P(0, 0), P(1, 2), P(2, -2), P(3, 0)}),
                                  bezier({P(0, 3), P(1, 5), P(2, 2), P(3, 4)})};
  const Bisector bisector = SC::trimmed_bisector(curves[0], curves[1]);
  EXPECT_TRUE(bisector.is_complete());
  ASSERT_EQ(bisector.chains().size(), 1U);
  EXPECT_TRUE(ends_at_infinity(bisector, bisector.chains()[0]));
  expect_trimmed(bisector, curves);
}

// The segments (0,0)-(4,0) and (1,-2)-(3,2), which cross in (2,0): lines through that point next to it, one chain in
// each angle; where an end is nearest, other curves go on to infinity.
TEST(TrimmedBisectors, CrossingSegments)
{
  const std::vector<Curve> segments{bezier({P(0, 0), P(4, 0)}), bezier({P(1, -2), P(3, 2)})};
  const Bisector bisector = SC::trimmed_bisector(segments[0], segments[1]);
  EXPECT_TRUE(bisector.is_complete());
  ASSERT_EQ(bisector.chains().size(), 4U);
  const double s = std::sqrt(5.0);
  std::size_t near = 0;
  for (const auto& chain : bisector.chains()) {
    const auto& ends = bisector.diagram().vertices();
    EXPECT_NE(ends[chain.vertices[0]].is_at_infinity, ends[chain.vertices[1]].is_at_infinity);
    const std::size_t crossing = chain.vertices[ends[chain.vertices[0]].is_at_infinity];
    EXPECT_NEAR(distance(*ends[crossing].point, P(2, 0)), 0, 1e-12);
    EXPECT_EQ(ends[crossing].radius, 0);
    for (const auto& sample : samples(bisector, chain)) {
      EXPECT_NEAR(SC::distance_range(sample.point, segments[0]).first, sample.radius, 1e-9 * (1 + sample.radius));
      EXPECT_NEAR(SC::distance_range(sample.point, segments[1]).first, sample.radius, 1e-9 * (1 + sample.radius));
      const double x = sample.point.x() - 2, y = sample.point.y();
      if (sample.parameters[0] && sample.parameters[1] && sample.radius > 0) {
        ++near;
        EXPECT_NEAR(*sample.parameters[0], (2 + x) / 4, 1e-9);
        EXPECT_NEAR(*sample.parameters[1], 0.5 + (x + 2 * y) / 10, 1e-9);
        EXPECT_NEAR((std::min)(std::abs(2 * x - y - s * y), std::abs(2 * x - y + s * y)), 0, 1e-9);
      }
    }
  }
  EXPECT_GE(near, 4U);
}

// Radii 5 around (-2,0) and (2,0): outside of both, or within both, the y-axis; within one of them, the ellipse whose
// foci are the centers.
TEST(TrimmedBisectors, CrossingCircles)
{
  const Bisector bisector = SC::trimmed_bisector(SC::ellipse_curve(P(-2, 0), K::Vector_2(3, 4), K::Vector_2(-4, 3)),
                                                 SC::ellipse_curve(P(2, 0), K::Vector_2(4, 3), K::Vector_2(-3, 4)));
  EXPECT_TRUE(bisector.is_complete());
  std::size_t on_axis = 0, on_ellipse = 0, inner = 0;
  for (const auto& chain : bisector.chains()) {
    const Samples all = samples(bisector, chain);
    const bool is_axis =
        std::all_of(all.begin(), all.end(), [](const auto& sample) { return std::abs(sample.point.x()) < 1e-9; });
    const bool is_ellipse = std::all_of(all.begin(), all.end(), [](const auto& sample) {
      return std::abs(sample.point.x() * sample.point.x() / 25 + sample.point.y() * sample.point.y() / 21 - 1) < 1e-9;
    });
    EXPECT_NE(is_axis, is_ellipse);
    const auto& ends = bisector.diagram().vertices();
    inner += is_axis && !ends[chain.vertices[0]].is_at_infinity && !ends[chain.vertices[1]].is_at_infinity;
    on_axis += is_axis;
    on_ellipse += is_ellipse;
  }
  EXPECT_EQ(on_axis, 3U);
  EXPECT_EQ(on_ellipse, 2U);
  EXPECT_EQ(inner, 1U);
}

// The bisector of a circle and its tangent is a parabola, in two chains that begin in the contact; the common normal
// there is no part of it.
TEST(TrimmedBisectors, CircleAndTangent)
{
  const Bisector bisector = SC::trimmed_bisector(SC::bezier_curve(std::vector<P>{P(-8, 0), P(8, 0)}),
                                                 SC::ellipse_curve(P(0, 1), K::Vector_2(1, 0), K::Vector_2(0, 1)));
  EXPECT_TRUE(bisector.is_complete());
  std::size_t inner = 0;
  for (const auto& chain : bisector.chains())
    for (const auto& sample : samples(bisector, chain))
      if (std::abs(sample.point.x()) < 8) {
        ++inner;
        EXPECT_NEAR(sample.point.x() * sample.point.x(), 4 * sample.point.y(), 1e-9);
      }
  EXPECT_EQ(bisector.chains().size(), 2U);
  EXPECT_GT(inner, 4U);
}

double least_distance(const P& p, const std::vector<P>& points)
{
  double result = std::numeric_limits<double>::infinity();
  for (const P& q : points)
    result = (std::min)(result, distance(p, q));
  return result;
}

// A segment crosses the bisector an odd number of times if another curve is nearer at its end than at its begin.
TEST(TrimmedBisectors, SeparatesWhatIsNearer)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> coordinate(0, 9);
  int segments = 0;
  for (int run = 0; run < 2; ++run) {
    std::vector<Curve> curves;
    for (const double corner : {0.0, 10.0}) {
      std::vector<double> x(4);
      std::generate(x.begin(), x.end(), [&] { return coordinate(random); });
      std::sort(x.begin(), x.end());
      std::vector<P> points;
      for (const double t : x)
        points.emplace_back(t, corner + coordinate(random));
      curves.push_back(bezier(points));
    }
    const Bisector bisector = SC::trimmed_bisector(curves[0], curves[1]);
    EXPECT_TRUE(bisector.is_complete());
    ASSERT_EQ(bisector.chains().size(), 1U);
    expect_trimmed(bisector, curves);
    const auto polylines = bisector.polylines(bisector.chains()[0], error, 50);
    ASSERT_EQ(polylines.size(), 1U);
    std::array<std::vector<P>, 2> points;
    for (std::size_t k = 0; k < 2; ++k)
      for (int i = 0; i <= 200; ++i)
        points[k].push_back(curves[k](i / 200.0));
    for (int i = 0; i < 50; ++i) {
      const K::Segment_2 segment(P(coordinate(random), 2 * coordinate(random)),
                                 P(coordinate(random), 2 * coordinate(random)));
      const double before = least_distance(segment.source(), points[0]) - least_distance(segment.source(), points[1]);
      const double after = least_distance(segment.target(), points[0]) - least_distance(segment.target(), points[1]);
      if (std::abs(before) < 0.1 || std::abs(after) < 0.1)
        continue;
      int crossings = 0;
      for (std::size_t k = 1; k < polylines[0].size(); ++k)
        crossings += CGAL::do_intersect(segment, K::Segment_2(polylines[0][k - 1].point, polylines[0][k].point));
      EXPECT_EQ(crossings % 2 == 1, before * after < 0);
      EXPECT_EQ(side_of(polylines[0], segment.source()) < 0, before < 0);
      ++segments;
    }
  }
  EXPECT_GT(segments, 50);
}

// Random cubics that cross: samples are as far from both, and no point is nearer; on a segment, the nearer curve
// changes with each crossing of the bisector.
TEST(TrimmedBisectors, CrossingCubics)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(0, 10);
  int segments = 0, crossing_chains = 0;
  for (int run = 0; run < 3; ++run) {
    std::vector<Curve> curves;
    std::array<std::vector<P>, 2> points;
    for (std::size_t k = 0; k < 2; ++k) {
      std::vector<P> control_points;
      for (int i = 0; i < 4; ++i)
        control_points.push_back(k == 0 ? P(4 + coordinate(random) / 5, 10. / 3 * i)
                                        : P(10. / 3 * i, coordinate(random)));
      curves.push_back(bezier(control_points));
      for (int i = 0; i <= 400; ++i)
        points[k].push_back(curves[k](i / 400.0));
    }
    const Bisector bisector = SC::trimmed_bisector(curves[0], curves[1]);
    EXPECT_TRUE(bisector.is_complete());
    ASSERT_GE(bisector.chains().size(), 4U);
    expect_trimmed(bisector, curves);
    std::vector<K::Segment_2> chords;
    for (const auto& chain : bisector.chains()) {
      crossing_chains += bisector.diagram().vertices()[chain.vertices[0]].radius == 0 ||
          bisector.diagram().vertices()[chain.vertices[1]].radius == 0;
      for (const auto& polyline : bisector.polylines(chain, error, 50))
        for (std::size_t i = 1; i < polyline.size(); ++i)
          chords.emplace_back(polyline[i - 1].point, polyline[i].point);
    }
    for (int i = 0; i < 50; ++i) {
      const K::Segment_2 segment(P(coordinate(random), coordinate(random)), P(coordinate(random), coordinate(random)));
      const double before = least_distance(segment.source(), points[0]) - least_distance(segment.source(), points[1]);
      const double after = least_distance(segment.target(), points[0]) - least_distance(segment.target(), points[1]);
      if (std::abs(before) < 0.1 || std::abs(after) < 0.1)
        continue;
      const auto crossings = std::count_if(
          chords.begin(), chords.end(), [&](const K::Segment_2& chord) { return CGAL::do_intersect(segment, chord); });
      EXPECT_EQ(crossings % 2 == 1, before * after < 0);
      ++segments;
    }
  }
  EXPECT_GT(segments, 75);
  EXPECT_GE(crossing_chains, 12);
}

// A loop: disks touch it from within and from both sides of the crossing.
TEST(TrimmedBisectors, SelfBisectorOfALoop)
{
  const Curve loop = bezier({P(0, 0), P(6, 4), P(-2, 4.2), P(4.1, 0.3)});
  const Bisector bisector = SC::trimmed_self_bisector(loop);
  EXPECT_TRUE(bisector.is_complete());
  EXPECT_EQ(bisector.chains().size(), 4U);
  const auto& vertices = bisector.diagram().vertices();
  EXPECT_EQ(std::count_if(vertices.begin(), vertices.end(), [](const auto& v) { return v.radius == 0; }), 4);
  expect_trimmed(bisector, {loop, loop});
}

// A point, whose normals are a circle, beside curves with cusps between them.
TEST(TrimmedBisectors, PointBesideACurveThatTouchesItself)
{
  const Curve curve(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                    std::vector<P>{P(-1, 1), P(0, -1), P(1, 1), P(2.5, 0), P(1, -1), P(0, 1), P(-1, -1)});
  const P point(0.25, 2.5);
  const Bisector bisector = SC::trimmed_bisector(curve, point);
  EXPECT_TRUE(bisector.is_complete());
  ASSERT_EQ(bisector.chains().size(), 1U);
  EXPECT_TRUE(ends_at_infinity(bisector, bisector.chains()[0]));
  const Samples all = samples(bisector);
  ASSERT_GT(all.size(), 20U);
  for (const auto& sample : all) {
    EXPECT_NEAR(SC::distance_range(sample.point, curve).first, sample.radius, 1e-8 * (1 + sample.radius));
    EXPECT_NEAR(distance(sample.point, point), sample.radius, 1e-8 * (1 + sample.radius));
  }
}

// A segment with a part of itself, and with a point on it: an area is as far from both.
TEST(TrimmedBisectors, CoincidentOperands)
{
  const Curve segment = bezier({P(0, 0), P(4, 0)});
  EXPECT_TRUE(SC::trimmed_bisector(segment, segment).chains().empty());
  EXPECT_EQ(SC::trimmed_bisector(segment, segment).diagram().coincident_parts().size(), 1U);
  const Bisector part = SC::trimmed_bisector(segment, bezier({P(3, 0), P(1, 0)}));
  EXPECT_TRUE(part.is_complete());
  EXPECT_EQ(part.diagram().sites().size(), 7U);
  EXPECT_TRUE(SC::trimmed_bisector(segment, P(1, 0)).is_complete());
}

// A part of y = x^2: the line above its center of curvature (0, 1/2), where arcs are nearest up to the normals of the
// ends, which meet in (0, 9/2).
TEST(TrimmedBisectors, SelfBisectorOfAParabola)
{
  const Bisector bisector = SC::trimmed_self_bisector(bezier({P(-2, 4), P(0, -4), P(2, 4)}));
  EXPECT_TRUE(bisector.is_complete());
  ASSERT_EQ(bisector.chains().size(), 1U);
  EXPECT_EQ(bisector.chains()[0].arcs.size(), 2U);
  const Samples all = samples(bisector);
  ASSERT_GT(all.size(), 5U);
  const bool is_upward = all.front().radius < all.back().radius;
  EXPECT_NEAR(distance((is_upward ? all.front() : all.back()).point, P(0, 0.5)), 0, 1e-9);
  for (const auto& sample : all) {
    EXPECT_NEAR(sample.point.x(), 0, 1e-9);
    EXPECT_NEAR(sample.radius,
                sample.point.y() < 4.5 ? std::sqrt(sample.point.y() - 0.25) : std::hypot(2, sample.point.y() - 4),
                1e-9);
  }
}

// A closed chain that is too far away in the middle comes in parts.
TEST(TrimmedBisectors, ChainsAreCut)
{
  const Bisector bisector = SC::trimmed_bisector(circle(P(0, 0), 5), P(3, 0));   // an ellipse with radii from 1 to 4
  ASSERT_EQ(bisector.chains().size(), 1U);
  const auto polylines = bisector.polylines(bisector.chains()[0], error, 2);
  ASSERT_FALSE(polylines.empty());
  for (const auto& polyline : polylines)
    for (const auto& sample : polyline)
      EXPECT_LE(sample.radius, 2 + 1e-9);
  EXPECT_TRUE(bisector.polylines(bisector.chains()[0], error, 0.5).empty());
}

TEST(TrimmedBisectors, BadInput)
{
  const Curve segment = bezier({P(0, 0), P(1, 0)});
  EXPECT_THROW(SC::trimmed_bisector(P(1, 2), P(1, 2)), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_bisector(segment, bezier({P(1, 1), P(1, 1)})), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_self_bisector(bezier({P(1, 1), P(1, 1)})), SC::Invalid_input);
  const Bisector bisector = SC::trimmed_bisector(P(0, 0), P(1, 0));
  ASSERT_EQ(bisector.chains().size(), 1U);
  EXPECT_THROW(bisector.polylines(bisector.chains()[0], 0, 1), SC::Invalid_input);
  EXPECT_THROW(bisector.polylines(bisector.chains()[0], 1, 0), SC::Invalid_input);
  EXPECT_THROW(bisector.polylines(bisector.chains()[0], 1, std::numeric_limits<double>::infinity()), SC::Invalid_input);
}

} // namespace trimmed_bisectors_2_test
