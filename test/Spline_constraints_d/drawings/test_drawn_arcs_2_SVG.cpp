// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams of circular arcs as drawings have them: with irrational centers, and with ends or other curves so
// near to the circle that disks in it nearly touch all of it.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/IO/read_SVG.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

namespace drawn_arcs_test {

using Exact = CGAL::Simple_cartesian<SC::Exact_rational>;
using Exact_curves = std::vector<SC::Bspline_curve_2<Exact>>;

// The y axis points up in what is read.
Exact_curves drawn(const std::string& path)
{
  std::istringstream in("<svg xmlns='http://www.w3.org/2000/svg'><path d='" + path + "'/></svg>");
  Exact_curves result;
  for (const auto& element : SC::IO::read_SVG<Exact>(in, "drawn"))
    result.push_back(element.curve);
  return result;
}

// The centers of disks on all edges.
std::vector<P> centers(const SC::Voronoi_diagram_of_curves_2<Exact>& diagram)
{
  std::vector<P> result;
  for (std::size_t e = 0; e < diagram.edges().size(); ++e)
    for (const auto& sample : diagram.polyline(e, 0.01, 200))
      result.push_back(rounded(sample.point));
  return result;
}

// Disks that touch its ends are in the middle between both; the edge between these begins in the center of the circle.
TEST(DrawnArcs, OpenArcsAboveAHalfCircle)
{
  for (const double gap : {5.0, 0.25, 1e-3, 1e-6})
    for (const char* side : {"0", "1"}) {
      std::ostringstream path;
      path << std::setprecision(9) << "M50 30 A20 20 0 1 " << side << ' ' << 50 + gap << " 30";
      SCOPED_TRACE(path.str());
      const auto diagram = SC::voronoi_diagram(drawn(path.str()));
      EXPECT_TRUE(diagram.is_complete());
      EXPECT_EQ(counts(diagram), (Counts{1, 0, 0, 1, 1}));
      for (const auto& vertex : diagram.vertices())
        if (!vertex.is_at_infinity) {
          EXPECT_NEAR(*vertex.radius, 20, 1e-9);
          EXPECT_NEAR(std::abs(rounded(*vertex.point).y() + 30), std::sqrt(400 - gap * gap / 4), 1e-9);
        }
      const std::vector<P> points = centers(diagram);
      EXPECT_GT(points.size(), 2U);
      for (const P& p : points)
        EXPECT_NEAR(p.x(), 50 + gap / 2, 1e-9);
    }
}

// What is as far from a circle as from a chord is on a parabola around the center; where the chord is short, all disks
// but those next to it nearly touch all of the circle.
TEST(DrawnArcs, ArcsClosedByShortChords)
{
  constexpr double radius = 40;
  for (const double length : {1.0, 0.01})
    for (const bool is_reversed : {false, true}) {
      std::ostringstream path;
      path << "M50 10 A40 40 0 1 " << is_reversed << ' ' << 50 - length << " 10 Z";
      SCOPED_TRACE(path.str());
      const auto curves = drawn(path.str());
      const auto diagram = SC::voronoi_diagram(curves);
      EXPECT_TRUE(diagram.is_complete());
      EXPECT_EQ(counts(diagram), (Counts{2, 1, 0, 0, 2}));
      expect_euler(diagram);
      expect_empty_disks(diagram, curves);
      const double height = std::sqrt(radius * radius - length * length / 4);
      const P center(50 - length / 2, is_reversed ? -10 - height : -10 + height);
      const std::vector<P> points = centers(diagram);
      EXPECT_GT(points.size(), 4U);
      for (const P& p : points)
        EXPECT_NEAR(distance(p, center) + std::abs(p.y() + 10), radius, 1e-8);
    }
}

// The arcs join with an angle of 0.3 degrees, and cross each other 0.2 from there: what is between both is 2.5e-4 wide,
// as far into one of the circles, and turned by so little that contacts run along all of that.
TEST(DrawnArcs, NearlyTangentCircles)
{
  const auto curves = drawn("M89.67 37.68 A40.35 40.35 0 0 1 43 93.64 A58.8 58.8 0 1 1 1.15 98.7");
  const auto diagram = SC::voronoi_diagram(curves);
  EXPECT_TRUE(diagram.is_complete());
  expect_euler(diagram);
  expect_empty_disks(diagram, curves);
}

TEST(DrawnArcs, PathsOfArcsAndSegments)
{
  for (const char* path :
       {"M50 30 A20 20 0 1 0 55 30 L60 20", "M50 30 A20 20 0 1 0 55 30 M40 60 L60 65",
        "M20 20 A30 30 0 1 1 60 20 A27.5 27.5 0 1 0 20 20", "M50 50 L80 45 A30 30 0 1 1 45 78.5 Z",
        "M30 20 l15 20 a10.01 10.01 0 0 1 -16 12 l-15 -20", "M10 10 A25 25 0 0 1 40 20 A31 31 0 1 0 70 25"}) {
    SCOPED_TRACE(path);
    const auto curves = drawn(path);
    const auto diagram = SC::voronoi_diagram(curves);
    EXPECT_TRUE(diagram.is_complete());
    expect_euler(diagram);
    expect_empty_disks(diagram, curves);
  }
}

} // namespace drawn_arcs_test
