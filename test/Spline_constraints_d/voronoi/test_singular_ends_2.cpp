// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams, medial axes and offsets of cubics whose first or last two control points are the same, or whose
// derivative is zero inside: edges in closed form, Euler's formula, empty disks, and nearest sites by brute force.
#include "polygon_area.h"
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/operations/voronoi/medial_axis_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <vector>

namespace singular_ends_2_test {

// (t^2, t^3).
Curve semicubical_parabola() { return bezier({P(0, 0), P(0, 0), P(1. / 3, 0), P(1, 1)}); }

// A corner of a square is cut off by a cubic that arrives at its end with infinite curvature.
Curves outline(double c = 1, double s = 0)
{
  const auto at = [&](double x, double y) { return P(c * x - s * y, s * x + c * y); };
  return {bezier({at(0, 0), at(4, 0)}), bezier({at(4, 0), at(4, 2), at(6, 3), at(6, 3)}), bezier({at(6, 3), at(6, 6)}),
          bezier({at(6, 6), at(0, 6)}), bezier({at(0, 6), at(0, 0)})};
}

double distance_to(const Curves& curves, const P& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (const Curve& curve : curves)
    for (int k = 0; k <= 400; ++k)
      least = (std::min)(least, distance(p, curve(k / 400.)));
  return least;
}

void expect_valid(const Diagram& diagram, const Curves& curves)
{
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, curves, 0.02, 20);
}

std::size_t vertices_of_radius_zero(const Diagram& diagram, const P& p)
{
  return static_cast<std::size_t>(
      std::count_if(diagram.vertices().begin(), diagram.vertices().end(), [&](const auto& v) {
        return !v.is_at_infinity && *v.radius < 1e-12 && distance(*v.point, p) < 1e-12;
      }));
}

// On its inner side the largest disks touch the begin, and have the centers (-t^2/2 - 3 t^4/2, t + 2 t^3): the radius
// is zero in the begin.
TEST(SingularEnds, SemicubicalParabola)
{
  const Curves curves{semicubical_parabola()};
  const Diagram diagram = SC::voronoi_diagram(curves);
  expect_valid(diagram, curves);
  EXPECT_EQ(vertices_of_radius_zero(diagram, P(0, 0)), 1U);
  std::size_t edges = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e) {
    const auto& sites = diagram.edges()[e].sites;
    const std::size_t arc = !diagram.sites()[sites[0]].is_point ? 0 : 1;
    if (diagram.sites()[sites[arc]].is_point || !diagram.sites()[sites[1 - arc]].is_point ||
        diagram.sites()[sites[1 - arc]].point != P(0, 0))
      continue;
    ++edges;
    for (const auto& sample : diagram.polyline(e, 0.01, 100)) {
      const double t = *sample.parameters[arc];
      EXPECT_NEAR(CGAL::to_double(sample.point.x()), -t * t / 2 - 1.5 * t * t * t * t, 1e-9);
      EXPECT_NEAR(CGAL::to_double(sample.point.y()), t + 2 * t * t * t, 1e-9);
    }
  }
  EXPECT_EQ(edges, 1U);
}

// A straight line that goes on as the parabola: disks on the inner side touch both, and the edge between these begins
// in the joint.
TEST(SingularEnds, SmoothJointWithALine)
{
  const Curves curves{bezier({P(-3, 0), P(0, 0)}), semicubical_parabola()};
  const Diagram diagram = SC::voronoi_diagram(curves);
  expect_valid(diagram, curves);
  EXPECT_EQ(vertices_of_radius_zero(diagram, P(0, 0)), 1U);
  EXPECT_EQ(std::count_if(diagram.edges().begin(), diagram.edges().end(),
                          [&](const auto& edge) {
                            return !diagram.sites()[edge.sites[0]].is_point && !diagram.sites()[edge.sites[1]].is_point;
                          }),
            1);
}

// Two such ends that join: as an arch, with an inflection, and at corners.
TEST(SingularEnds, JointsOfTwo)
{
  const Curve left = bezier({P(-2, 1), P(-1, 0), P(0, 0), P(0, 0)});
  for (const Curves& curves : {Curves{left, bezier({P(0, 0), P(0, 0), P(1, 0), P(2, 1)})},
                               Curves{left, bezier({P(0, 0), P(0, 0), P(1, 0), P(2, -1)})},
                               Curves{left, bezier({P(0, 0), P(0, 0), P(0, -1), P(-2, -3)})},
                               Curves{left, bezier({P(0, 0), P(0, 0), P(0, 1), P(2, 3)})}})
    expect_valid(SC::voronoi_diagram(curves), curves);
}

// An arc that goes on with infinite curvature to the other side, and a sharp corner between two such ends.
TEST(SingularEnds, InflectionsAndSharpCorners)
{
  for (const Curves& curves :
       {Curves{bezier({P(-3, 0), P(-2, -1), P(-1, -1), P(0, 0)}), bezier({P(0, 0), P(0, 0), P(1, 1), P(2, -1)})},
        Curves{bezier({P(-3, 0), P(-2, 1), P(-1, 1), P(0, 0)}), bezier({P(0, 0), P(0, 0), P(1, -1), P(2, -3)})},
        Curves{bezier({P(-2, -1), P(-1, -1), P(0, 0), P(0, 0)}), bezier({P(0, 0), P(0, 0), P(-1, 0), P(-2, 1)})}})
    expect_valid(SC::voronoi_diagram(curves), curves);
}

// A letter Z: in the corners, the curvature of disks through the bars behind the half-plane of the normal grows to
// zero, which does not matter.
TEST(SingularEnds, CornersOfAZ)
{
  for (const Curve& stroke : {bezier({P(1, 1), P(0.703125, 0.42578125), P(0.28125, 0), P(0.28125, 0)}),
                              bezier({P(1, 1), P(1, 1), P(0.5, 0.625), P(0.28125, 0)})}) {
    const Curves curves{bezier({P(0, 1), P(1, 1)}), stroke, bezier({P(0.28125, 0), P(1.28125, 0)})};
    expect_valid(SC::voronoi_diagram(curves), curves);
  }
}

// Segments whose control points coincide at both ends have the diagram of the polygon.
TEST(SingularEnds, StraightSides)
{
  const std::vector<P> corners{P(0, 0), P(4, 0), P(5, 3), P(1, 4)};
  Curves sides, doubled;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const P &p = corners[i], &q = corners[(i + 1) % corners.size()];
    sides.push_back(bezier({p, q}));
    doubled.push_back(bezier({p, p, q, q}));
  }
  const Diagram diagram = SC::voronoi_diagram(doubled);
  expect_valid(diagram, doubled);
  EXPECT_EQ(counts(diagram), counts(SC::voronoi_diagram(sides)));
}

TEST(SingularEnds, Outline)
{
  const Curves curves = outline();
  const Diagram diagram = SC::voronoi_diagram(curves);
  expect_valid(diagram, curves);
  EXPECT_GE(vertices_of_radius_zero(diagram, P(6, 3)), 1U);
  const Curves turned = outline(-0.75, 1.25);
  const Diagram other = SC::voronoi_diagram(turned);
  EXPECT_TRUE(other.is_complete());
  EXPECT_EQ(counts(diagram), counts(other));

  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 7);
  for (int i = 0; i < 300; ++i) {
    const P p(coordinate(random), coordinate(random));
    const double least = distance_to(curves, p);
    const auto sites = diagram.nearest_sites(p);
    ASSERT_EQ(sites.size(), 1U);
    const auto& site = diagram.sites()[sites[0]];
    double nearest = distance(p, site.point);
    for (int k = 0; k <= 400 && !site.is_point; ++k)
      nearest = (std::min)(nearest, distance(p, curves[*site.curve](k / 400.)));
    EXPECT_NEAR(nearest, least, 1e-3);
  }
}

// (1/2 + 4 s^3, 3/4 - 3 s^2), s = t - 1/2, has a cusp: between its sides disks have the centers (1/2, 3/4 - 3 s^2 - 8
// s^4). In the second one a disk leaves the end of the curve for the inside of the same arc, just where the one in the
// cusp begins to matter.
TEST(SingularEnds, CuspsInside)
{
  const Curves symmetric{bezier({P(0, 0), P(1, 1), P(0, 1), P(1, 0)})};
  const Diagram diagram = SC::voronoi_diagram(symmetric);
  expect_valid(diagram, symmetric);
  std::size_t samples = 0;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    if (const auto& sites = diagram.edges()[e].sites;
        !diagram.sites()[sites[0]].is_point && !diagram.sites()[sites[1]].is_point)
      for (const auto& sample : diagram.polyline(e, 0.01, 20)) {
        const double s = *sample.parameters[0] - 0.5;
        EXPECT_NEAR(*sample.parameters[1], 1 - *sample.parameters[0], 1e-9);
        EXPECT_NEAR(CGAL::to_double(sample.point.y()), 0.75 - 3 * s * s - 8 * s * s * s * s, 1e-9);
        ++samples;
      }
  EXPECT_GT(samples, 3U);

  // Closed by a segment, it bounds a region whose axis has three branches, one of which ends in the cusp.
  const auto axis = SC::medial_axis(SC::planar_region(Curves{symmetric[0], bezier({P(1, 0), P(0, 0)})}));
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.edges().size(), 3U);
  EXPECT_EQ(axis.vertices().size(), 4U);
  EXPECT_TRUE(std::any_of(axis.vertices().begin(), axis.vertices().end(),
                          [](const auto& v) {
                            return v.radius && *v.radius < 1e-12 && distance(*v.point, P(0.5, 0.75)) < 1e-12;
                          }));

  const Curves oblique{bezier({P(-2, -2), P(-3.5, -1.25), P(-3.625, -1.75), P(-3.375, -1.5)})};
  expect_valid(SC::voronoi_diagram(oblique), oblique);
  const auto offset = SC::trimmed_offset(oblique, 0.25);
  EXPECT_TRUE(offset.is_complete());
  EXPECT_GT(offset.boundaries().size(), 0U);

  // One that a segment crosses, in a point that is not rational, between the cusp and its end.
  const Curves crossed{bezier({P(-1, 0), P(-1.25, 0), P(-1.25, 0.125), P(1, -0.625)}), bezier({P(1, 0), P(-3, -4)})};
  expect_valid(SC::voronoi_diagram(crossed), crossed);
}

// Straight curves that turn back at rational parameters have the diagrams of segments.
TEST(SingularEnds, CurvesThatTurnBack)
{
  const Curve other = bezier({P(0, 2), P(1, 3)});
  const auto expect_segments = [&](const std::vector<P>& points, const std::vector<P>& ends) {
    const Curves curves{bezier(points), other},
        segments(ends.size() == 2 ? Curves{bezier(ends), other}
                                  : Curves{bezier({ends[0], ends[1]}), bezier({ends[1], ends[2]}), other});
    const Diagram diagram = SC::voronoi_diagram(curves);
    expect_valid(diagram, curves);
    EXPECT_EQ(counts(diagram), counts(SC::voronoi_diagram(segments)));
    EXPECT_GE(diagram.coincident_parts().size(), 1U);
  };
  expect_segments({P(0, 0), P(1, 0), P(0, 0)}, {P(0, 0), P(0.5, 0)});
  expect_segments({P(0, 0), P(3, 0), P(2, 0)}, {P(0, 0), P(2, 0), P(2.25, 0)});
  expect_segments({P(0, 0), P(3, 0), P(-2, 0), P(1, 0)}, {P(0, 0), P(1, 0)});

  // Parameters that are not rational: what is not proved is named, and the rest is right.
  const Curves irrational{bezier({P(3, 1), P(0, 4), P(3, 1), P(4, 0)}), bezier({P(0, 1), P(3, 4), P(2, 3)})};
  const Diagram diagram = SC::voronoi_diagram(irrational);
  EXPECT_EQ(diagram.is_complete(), diagram.undecided().empty());
  EXPECT_GT(diagram.edges().size(), 0U);
  expect_empty_disks(diagram, irrational, 0.02, 20);
}

// The medial axis is the part of the diagram inside; all points of the offset have the distance, and its area is that
// of the region and at most, as Steiner's formula has it for convex regions, a strip along the outline and a disk.
TEST(SingularEnds, MedialAxisAndOffset)
{
  const Curves curves = outline();
  const auto region = SC::planar_region(curves);
  const auto axis = SC::medial_axis(region);
  EXPECT_TRUE(axis.is_complete());
  EXPECT_EQ(axis.vertices().size(), axis.edges().size() + 1);   // a tree
  constexpr double r = 0.3, error = 1e-4;
  const auto offset = SC::trimmed_offset(region, r);
  EXPECT_TRUE(offset.is_complete());
  ASSERT_EQ(offset.boundaries().size(), 1U);
  for (const auto& polygon : offset.polygons_with_holes(error))
    for (const auto& p : polygon.outer_boundary().vertices())
      EXPECT_NEAR(distance_to(curves, p), r, 1e-3);
  double twice_area = 0, length = 0;   // of a polygon inscribed in the outline
  for (const Curve& curve : curves)
    for (int k = 0; k < 400; ++k) {
      const P p = curve(k / 400.), q = curve((k + 1) / 400.);
      twice_area += CGAL::to_double(p.x() * q.y() - p.y() * q.x());
      length += distance(p, q);
    }
  const double grown = total_area(offset.polygons_with_holes(error));
  EXPECT_GT(grown, twice_area / 2);
  EXPECT_LT(grown, twice_area / 2 + r * length + CGAL_PI * r * r + 1e-3);
}

} // namespace singular_ends_2_test
