// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed offsets at the radius of curvature of a vertex of a curve, at distances far greater than the curves, and what
// they and alpha-sectors tell where they are not decided.
#include "polygon_area.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_offsets_2.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace offset_limits_2_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using P = K::Point_2;
using V = K::Vector_2;
using Curves = std::vector<SC::Bspline_curve_2<K>>;
using Offset = SC::Trimmed_offset_2<K>;

constexpr double pi = 3.14159265358979323846;
constexpr double error = 1e-3;

SC::Bspline_curve_2<K> bezier(const std::vector<P>& points) { return SC::bezier_curve(points); }

// Sums of a periodic function over equal steps converge faster than any power of these.
double length_of_ellipse(double a, double b)
{
  constexpr int steps = 1000;
  double result = 0;
  for (int i = 0; i < steps; ++i)
    result += std::hypot(a * std::sin(2 * pi * i / steps), b * std::cos(2 * pi * i / steps));
  return result * 2 * pi / steps;
}

bool hold(const std::vector<SC::Undecided_part>& parts, std::size_t curve, double t)
{
  return std::any_of(parts.begin(), parts.end(), [&](const SC::Undecided_part& part) {
    const auto& [operand, ranges] = part.parameters.at(0);
    return operand == curve && ranges.at(0).first <= t && t <= ranges.at(0).second;
  });
}

// The inner offset of an ellipse at the least radius of curvature, b^2 / a, is a curve with two tips, in the centers of
// the circles there. All disks are free, as they are at smaller distances: so the area is that of the ellipse, less the
// distance times its length, and a disk.
TEST(OffsetLimits, LeastRadiusOfCurvatureOfAnEllipse)
{
  const double r = 0.5, length = length_of_ellipse(2, 1);
  const Offset offset = SC::trimmed_offset(SC::planar_region(SC::ellipse_curve(P(0, 0), V(2, 0), V(0, 1))), -r);
  EXPECT_TRUE(offset.is_complete());
  EXPECT_TRUE(offset.undecided().empty());
  ASSERT_EQ(offset.boundaries().size(), 1U);
  EXPECT_TRUE(offset.boundaries()[0].is_closed);
  EXPECT_FALSE(offset.boundaries()[0].is_hole);
  EXPECT_EQ(offset.arcs().size(), 1U);
  EXPECT_NEAR(total_area(offset.polygons_with_holes(error)), 2 * pi - r * length + pi * r * r, error * length);
}

// The vertex of y = x^2 at one third of the parabola from x = -1 to 2, with a radius of curvature of 1/2: the offset
// goes on there.
TEST(OffsetLimits, VertexWithinAnArc)
{
  const auto region = SC::planar_region(Curves{bezier({P(-1, 1), P(0.5, -2), P(2, 4)}), bezier({P(2, 4), P(-1, 1)})});
  const auto area = [&](double distance) {
    const Offset offset = SC::trimmed_offset(region, distance);
    EXPECT_TRUE(offset.is_complete()) << distance;
    EXPECT_EQ(offset.arcs().size(), 2U) << distance;
    EXPECT_TRUE(std::any_of(offset.arcs().begin(), offset.arcs().end(), [](const Offset::Arc& arc) {
      return arc.curve == 0 && arc.parameters[0] < 1.0 / 3 && 1.0 / 3 < arc.parameters[1];
    })) << distance;
    return total_area(offset.polygons_with_holes(1e-6));
  };
  const double smaller = area(-0.4921875), at_vertex = area(-0.5);
  EXPECT_GT(at_vertex, 0.1);
  EXPECT_GT(smaller, at_vertex);
  EXPECT_LT(smaller, at_vertex + 0.0078125 * 8);   // times more than the length of the boundary
}

// Where a disk at the vertex touches another curve, too, the place is not decided, and told.
TEST(OffsetLimits, VertexAndOppositeSegment)
{
  const auto region = SC::planar_region(Curves{bezier({P(-1, 1), P(0, -1), P(1, 1)}), bezier({P(1, 1), P(-1, 1)})});
  const Offset offset = SC::trimmed_offset(region, -0.5);
  EXPECT_FALSE(offset.is_complete());
  EXPECT_TRUE(hold(offset.undecided(), 0, 0.5));
  EXPECT_TRUE(hold(offset.undecided(), 1, 0.5));
}

// From far away, a curve is nearly a point.
TEST(OffsetLimits, LargeDistances)
{
  const Curves curve{bezier({P(0, 0), P(1, 2), P(2, -1), P(3, 1)})};
  for (const double distance : {1e8, 1e12}) {
    const Offset offset = SC::trimmed_offset(curve, distance);
    EXPECT_TRUE(offset.is_complete());
    EXPECT_TRUE(offset.undecided().empty());
    ASSERT_EQ(offset.boundaries().size(), 1U);
    EXPECT_TRUE(offset.boundaries()[0].is_closed);
    EXPECT_GE(std::count_if(offset.arcs().begin(), offset.arcs().end(),
                            [](const Offset::Arc& arc) { return arc.is_circular; }),
              2);
    const auto polygons = offset.polygons_with_holes(distance * 1e-6);
    ASSERT_EQ(polygons.size(), 1U);
    EXPECT_NEAR(polygons[0].outer_boundary().area() / (distance * distance), pi, 1e-5);
    for (const P& p : polygons[0].outer_boundary())
      EXPECT_NEAR(std::hypot(p.x(), p.y()) / distance, 1, 1e-7);
  }
}

// y = x^2 and y = x^4 + 1/4 touch where x^2 = 1/2, at parameters that are not rational: the sector is not resolved next
// to that.
TEST(OffsetLimits, SectorOfCurvesThatTouch)
{
  const auto parabola = bezier({P(-1, 1), P(0, -1), P(1, 1)}),
             quartic = bezier({P(-1, 1.25), P(-0.5, -0.75), P(0, 1.25), P(0.5, -0.75), P(1, 1.25)});
  const auto sector = SC::trimmed_alpha_sector(parabola, quartic, 0.25),
             exchanged = SC::trimmed_alpha_sector(quartic, parabola, 0.75),
             apart = SC::trimmed_alpha_sector(parabola, P(0.25, -1), 0.25);
  EXPECT_FALSE(sector.is_complete());
  EXPECT_FALSE(exchanged.is_complete());
  for (const double x : {-std::sqrt(0.5), std::sqrt(0.5)}) {
    EXPECT_TRUE(hold(sector.undecided(), 0, (1 + x) / 2));
    EXPECT_TRUE(hold(exchanged.undecided(), 1, (1 + x) / 2));
  }
  EXPECT_TRUE(apart.is_complete());
  EXPECT_TRUE(apart.undecided().empty());
}

// What bounds in doubles can tell: coordinates of 10^75 and 10^-75 are decided, others refused, but not coordinates
// that are small beside others.
TEST(OffsetLimits, Magnitudes)
{
  const auto cubic = [](double size) {
    return bezier({P(0, 0), P(size, 2 * size), P(2 * size, -size), P(3 * size, size)});
  };
  for (const double size : {1e75 / 3, 1e-75}) {
    EXPECT_TRUE(SC::trimmed_offset(Curves{cubic(size)}, size).is_complete());
    EXPECT_TRUE(SC::trimmed_alpha_sector(cubic(size), P(size, 5 * size), 0.25).is_complete());
  }
  for (const double size : {1e-300, 1e-100, 1e100, 1e300}) {
    EXPECT_THROW(SC::trimmed_offset(Curves{cubic(size)}, size), SC::Invalid_input);
    EXPECT_THROW(SC::trimmed_alpha_sector(cubic(size), P(0, 5 * size), 0.25), SC::Invalid_input);
  }
  const Offset offset = SC::trimmed_offset(Curves{bezier({P(0, 1e-300), P(1, 0)})}, 1);
  EXPECT_TRUE(offset.is_complete());
  EXPECT_EQ(offset.arcs().size(), 4U);
  EXPECT_TRUE(SC::trimmed_offset(Curves(), 1, {P(0, 0)}).is_complete());
}

} // namespace offset_limits_2_test
