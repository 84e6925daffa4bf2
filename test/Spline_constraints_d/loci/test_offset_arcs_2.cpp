// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets as polylines: circles, a parabola with two cusps on one side and none on the other, gaps at corners, and the
// exact distance of every point.

#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_arcs_2.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace offset_arcs_2_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<SC::Exact_rational>;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;

namespace {

// Every point lies on the left normal of the curve at the given distance, and the middle of the curve between two of
// them next to their chord.
void check_arcs(const SC::Offset_arcs_2& arcs, const Curve& curve, double distance, double error)
{
  EXPECT_TRUE(arcs.cusps().is_complete());
  for (const SC::Offset_arc_2& arc : arcs.arcs()) {
    ASSERT_GE(arc.samples.size(), 4u);
    for (std::size_t i = 0; i < arc.samples.size(); ++i) {
      const auto& [p, t] = arc.samples[i];
      if (i > 0) {
        EXPECT_LT(arc.samples[i - 1].parameter, t);
        EXPECT_LE(std::hypot(p[0] - arc.samples[i - 1].point[0], p[1] - arc.samples[i - 1].point[1]),
                  8 * std::sqrt(error));
      }
      if (i == 0 || i + 1 == arc.samples.size())
        continue;   // corners have two tangents
      const Point foot = curve(t);
      const K::Vector_2 tangent = curve.tangent(t);
      const double dx = p[0] - CGAL::to_double(foot.x()), dy = p[1] - CGAL::to_double(foot.y()),
                   tx = CGAL::to_double(tangent.x()), ty = CGAL::to_double(tangent.y());
      EXPECT_NEAR((tx * dy - ty * dx) / std::hypot(tx, ty), distance, 1e-12);
      EXPECT_NEAR((tx * dx + ty * dy) / std::hypot(tx, ty), 0, 1e-12);
    }
  }
}

} // namespace

TEST(Offset_arcs_2, circle)
{
  const Curve circle = SC::to_bspline_curve(K::Circle_2(Point(1, 2), 9));
  for (const int distance : {-2, 1}) {
    const auto offset = SC::offset_arcs(SC::Offset_curve_2(circle, distance), 1e-3);
    ASSERT_EQ(offset.arcs().size(), 1u);
    check_arcs(offset, circle, distance, 1e-3);
    for (const SC::Offset_sample_2& sample : offset.arcs()[0].samples)
      EXPECT_NEAR(std::hypot(sample.point[0] - 1, sample.point[1] - 2), 3 - distance, 1e-13);
  }
}

// The radius of curvature of y = x^2 is (1 + 4 x^2)^(3/2) / 2: for r^2 = 2 the offset to the left has cusps at x =
// +-1/2, up to the rounding of r.
TEST(Offset_arcs_2, parabola)
{
  const Curve parabola = SC::bezier_curve(std::vector<Point>{{-1, 1}, {0, -1}, {1, 1}});
  const SC::Exact_rational r(std::sqrt(2.0));
  const auto left = SC::offset_arcs(SC::Offset_curve_2(parabola, r), 1e-3),
             right = SC::offset_arcs(SC::Offset_curve_2(parabola, SC::Exact_rational(-r)), 1e-3);
  ASSERT_EQ(left.arcs().size(), 3u);
  check_arcs(left, parabola, std::sqrt(2.0), 1e-3);
  for (std::size_t i = 0; i < 3; ++i) {
    const SC::Offset_arc_2& arc = left.arcs()[i];
    EXPECT_EQ(arc.is_at_cusp[0], i > 0);
    EXPECT_EQ(arc.is_at_cusp[1], i < 2);
    if (i > 0) {
      EXPECT_EQ(left.arcs()[i - 1].samples.back().point, arc.samples.front().point);
      EXPECT_NEAR(2 * arc.samples.front().parameter - 1, i == 1 ? -0.5 : 0.5, 1e-12);
    }
  }
  ASSERT_EQ(right.arcs().size(), 1u);
  EXPECT_TRUE(right.cusps().empty());
  check_arcs(right, parabola, -std::sqrt(2.0), 1e-3);
}

TEST(Offset_arcs_2, gaps_at_corners)
{
  const Curve angle = SC::polyline_curve(std::vector<Point>{{0, 0}, {4, 0}, {4, 3}});
  const auto offset = SC::offset_arcs(SC::Offset_curve_2(angle, -1), 0.5);
  ASSERT_EQ(offset.arcs().size(), 2u);
  EXPECT_EQ(offset.arcs()[0].samples.back().point, (std::array<double, 2>{4, -1}));
  EXPECT_EQ(offset.arcs()[1].samples.front().point, (std::array<double, 2>{5, 0}));
}

TEST(Offset_arcs_2, bad_input)
{
  const SC::Offset_curve_2 offset(SC::polyline_curve(std::vector<Point>{{0, 0}, {4, 0}}), 1);
  EXPECT_THROW(SC::offset_arcs(offset, 0), SC::Invalid_input);
  EXPECT_THROW(SC::offset_arcs(offset, 1, {.tolerance = -1}), SC::Invalid_input);
}

} // namespace offset_arcs_2_test
