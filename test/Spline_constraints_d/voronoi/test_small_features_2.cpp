// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams of what is small beside the rest: narrow gaps, small curves, points next to each other; and of disks
// that nearly fill a circle.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_arrangement_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace small_features_2_test {

void expect_complete(const Curves& curves)
{
  const auto diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// The middle line of a gap, and both its ends.
TEST(SmallFeatures, GapBetweenSegments)
{
  for (const double gap : {1e-4, 1e-6, 1e-9, 1e-12}) {
    SCOPED_TRACE(gap);
    const auto diagram = SC::voronoi_diagram(Curves{bezier({{0, 0}, {4, 0}}), bezier({{0, gap}, {4, gap}})});
    EXPECT_TRUE(diagram.is_complete());
    EXPECT_EQ(counts(diagram), (Counts{0, 2, 0, 2, 3}));
    for (const auto& vertex : diagram.vertices())
      if (!vertex.is_at_infinity) {
        EXPECT_NEAR(*vertex.radius, gap / 2, 1e-15);
        EXPECT_LT(std::min(distance(*vertex.point, P(0, gap / 2)), distance(*vertex.point, P(4, gap / 2))), 1e-15);
      }
  }
}

// Segments of which one ends next to the other one, or next to its end.
TEST(SmallFeatures, EndsNextToSegments)
{
  for (const double gap : {1e-4, 1e-6, 1e-9}) {
    SCOPED_TRACE(gap);
    expect_complete({bezier({{0, 0}, {4, 0}}), bezier({{4 + gap, 0}, {6, 3}})});
    expect_complete({bezier({{0, 0}, {4, 0}}), bezier({{3, gap}, {5, 3}})});
    expect_complete({bezier({{0, 0}, {4, 0}}), bezier({{4 - gap, -1}, {4 - gap, 1}})});
  }
}

// A wall, and two squares in front of it: the disk in the middle touches the corners of both, in which its contacts go
// over to their sides, and is the largest one there.
TEST(SmallFeatures, DiskBetweenCornersOfSquares)
{
  const auto square = [](double x, double y, double size) {
    return SC::polyline_curve(std::vector<P>{P(x, y), P(x + size, y), P(x + size, y + size), P(x, y + size), P(x, y)});
  };
  const Curves curves{SC::polyline_curve(std::vector<P>{P(-1, 0), P(9, 0)}), square(1, 1, 2), square(5, 1, 2)};
  const auto diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

// What is between two circles is nearest to both on an ellipse, with the centers as foci.
TEST(SmallFeatures, CircleInACircle)
{
  for (const double radius : {1e-2, 1e-4, 1e-8}) {
    SCOPED_TRACE(radius);
    const P center(0.5, 0.25), origin(0, 0);
    const auto diagram = SC::voronoi_diagram(Curves{SC::circle_curve(origin, 2.), SC::circle_curve(center, radius)});
    EXPECT_TRUE(diagram.is_complete());
    std::size_t samples = 0;
    for (std::size_t e = 0; e < diagram.edges().size(); ++e)
      for (const auto& sample : diagram.polyline(e, 0.01, 10)) {
        EXPECT_NEAR(distance(sample.point, origin) + distance(sample.point, center), 2 + radius, 1e-12);
        ++samples;
      }
    EXPECT_GT(samples, 16U);
  }
}

TEST(SmallFeatures, CubicBesideASegment)
{
  for (const double size : {1e-2, 1e-3, 1e-4}) {
    SCOPED_TRACE(size);
    expect_complete({bezier({{0, 0}, {4, 0}}),
                     bezier({{1, 1}, {1 + size, 1 + size}, {1 + 2 * size, 1}, {1 + 3 * size, 1 + size}})});
  }
}

// Whether an edge belongs to a curve, not only to an end of the first one.
bool is_of(const Diagram& diagram, std::size_t edge, std::size_t curve)
{
  const auto& sites = diagram.edges()[edge].sites;
  return std::any_of(sites.begin(), sites.end(), [&](std::size_t s) {
    return diagram.sites()[s].curve == curve && (curve > 0 || !diagram.sites()[s].is_point);
  });
}

// The diagram does not depend on how small a curve is; disks that are large beside it are those of a point.
TEST(SmallFeatures, SmallCurvesBesideASegment)
{
  const std::vector<std::vector<P>> shapes{{P(0, 0), P(1, 1), P(2, 1)},
                                           {P(0, 0), P(1, -1), P(2, -1)},
                                           {P(0, 0), P(1, 1), P(2, 1), P(3, 0)},
                                           {P(0, 0), P(2, 0), P(4, 2), P(6, 3)},
                                           {P(0, 0), P(3, 0), P(0, 3), P(3, 3)}};
  for (const auto& shape : shapes) {
    SCOPED_TRACE(&shape - shapes.data());
    std::optional<Counts> first;
    for (const double size : {0x1p-10, 0x1p-20, 0x1p-30}) {
      SCOPED_TRACE(size);
      std::vector<P> points;
      for (const P& p : shape)
        points.emplace_back(50 + size * p.x(), 10 + size * p.y());
      const Curves curves{bezier({{0, 0}, {100, 0}}), bezier(points)};
      const auto diagram = SC::voronoi_diagram(curves);
      EXPECT_TRUE(diagram.is_complete());
      expect_euler(diagram);
      expect_empty_disks(diagram, curves);
      EXPECT_EQ(counts(diagram), *(first ? first : first = counts(diagram)));
      std::size_t samples = 0;
      for (std::size_t e = 0; e < diagram.edges().size(); ++e)
        if (is_of(diagram, e, 0) && is_of(diagram, e, 1))
          for (const auto& sample : diagram.polyline(e, 0.01, 10)) {
            EXPECT_NEAR(distance(sample.point, P(50, 10)), sample.point.y(), 8 * size);
            ++samples;
          }
      EXPECT_GT(samples, 16U);
    }
  }
}

// The cubic leaves the circle with nearly the same curvature: disks between both have nearly that of the circle, and
// the contact runs along all of it.
TEST(SmallFeatures, DisksNearlyConcentricWithAnArc)
{
  expect_complete({SC::circular_arc_curve(P(0, 5), P(-5, 5), P(0, 0)),
                   bezier({{0, 0}, {1.75, 0}, {5.5, 1}, {9.25, -2}}), bezier({{-6.75, -6.25}, {3.5, -5.5}}),
                   bezier({{0.5, -2.75}, {0.875, -4.5}})});
}

// The edge between two points next to each other is a line that doubles cannot follow by its direction: it passes the
// whole box.
TEST(SmallFeatures, PointsNextToEachOther)
{
  for (const double gap : {1e-9, 1e-11}) {
    SCOPED_TRACE(gap);
    const std::vector<P> points{P(1, 2), P(1 + gap, 2), P(3, 4)};
    const auto diagram = SC::voronoi_diagram(Curves(), points);
    EXPECT_TRUE(diagram.is_complete());
    const auto result = SC::to_arrangement(diagram, 0.01, CGAL::Bbox_2(-2, -1, 6, 7));
    EXPECT_TRUE(result.has_same_topology);
    EXPECT_EQ(result.arrangement.number_of_faces(), 4U);
    for (std::size_t region = 0; region < 3; ++region)
      EXPECT_EQ(SC::region_polygons(result, region).size(), 1U);
  }
}

} // namespace small_features_2_test
