// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Ray-traps with known answers.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/ray_traps_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ray_traps_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;

double length(const std::vector<K::Point_2>& points)
{
  double result = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    result += std::sqrt(CGAL::to_double(CGAL::squared_distance(points[i], points[(i + 1) % points.size()])));
  return result;
}

// The pedal triangle is the only one; its perimeter is twice the area over the circumradius: 2 * 84 / (65/8).
TEST(Ray_traps_2, PedalTriangle)
{
  const std::vector<K::Point_2> corners{{0, 0}, {14, 0}, {5, 12}};
  std::vector<Curve> sides;
  for (int i = 0; i < 3; ++i)   // without the corners, where two points are one
    sides.push_back(SC::segment_curve(corners[i], corners[(i + 1) % 3]).restricted(K::FT(1) / 8, K::FT(7) / 8));
  const auto result = SC::ray_traps(sides);
  EXPECT_TRUE(result.summary().is_complete);
  ASSERT_EQ(result.traps().size(), 1u);
  EXPECT_TRUE(result.traps()[0].solution().is_certified());
  EXPECT_NEAR(length(result.traps()[0].points()), 2 * 84 / (65.0 / 8), 1e-12);
}

// The line of centers meets each circle twice; one of the points is the seam of the first circle.
TEST(Ray_traps_2, CommonNormalsOfCircles)
{
  const std::vector<Curve> circles{SC::circle_curve(K::Point_2(0, 0), K::FT(1)),
                                   SC::circle_curve(K::Point_2(5, 0), K::Point_2(5, 2))};
  const auto result = SC::ray_traps(circles);
  EXPECT_TRUE(result.summary().is_complete) << result.summary();
  ASSERT_EQ(result.size(), 4u);
  std::vector<double> lengths;
  for (const auto& trap : result) {
    EXPECT_TRUE(trap.solution().is_certified());
    lengths.push_back(std::round(length(trap.points()) * 1e9) / 1e9);
  }
  std::sort(lengths.begin(), lengths.end());
  EXPECT_EQ(lengths, (std::vector<double>{4, 8, 12, 16}));
}

// Seed 000, Figure 2.
TEST(Ray_traps_2, ThreeCircles)
{
  const std::vector<Curve> circles{SC::circle_curve(K::Point_2(0, 0), K::FT(1)),
                                   SC::circle_curve(K::Point_2(5, 0), K::FT(2)),
                                   SC::circle_curve(K::Point_2(1, 6), K::FT(1))};
  const auto result = SC::ray_traps(circles);
  EXPECT_TRUE(result.summary().is_complete) << result.summary();
  EXPECT_EQ(result.traps().size(), 8u);
  const K::Point_2 centers[] = {{0, 0}, {5, 0}, {1, 6}};
  for (const auto& trap : result.traps()) {
    EXPECT_TRUE(trap.solution().is_certified());
    for (int i = 0; i < 3; ++i) {   // equal angles with the normal, on the same side
      const K::Vector_2 normal = trap.points()[i] - centers[i], in = trap.points()[(i + 2) % 3] - trap.points()[i],
                        out = trap.points()[(i + 1) % 3] - trap.points()[i];
      const auto cosine = [&](const K::Vector_2& v) {
        return CGAL::to_double(v * normal) / std::sqrt(CGAL::to_double(v.squared_length()));
      };
      EXPECT_NEAR(cosine(in), cosine(out), 1e-12);
    }
  }
}

// The pedal triangle again, with two sides as one polyline.
TEST(Ray_traps_2, BetweenCorners)
{
  const K::Point_2 a(0, 0), b(14, 0), c(5, 12);
  const auto part = [](const K::Point_2& p, const K::Point_2& q, int begin) {
    return SC::segment_curve(p, q).restricted(K::FT(begin) / 8, K::FT(7) / 8);
  };
  const Curve two_sides = SC::polyline_curve(std::vector<K::Point_2>{a + (b - a) / 8, b, b + (c - b) / 4});
  const auto result = SC::ray_traps(std::vector<Curve>{two_sides, part(b, c, 3), part(c, a, 1)});
  EXPECT_TRUE(result.summary().is_complete) << result.summary();
  ASSERT_EQ(result.traps().size(), 1u);
  EXPECT_NEAR(length(result.traps()[0].points()), 2 * 84 / (65.0 / 8), 1e-12);
}

// Normals of a circle that meet the two legs of a right angle at right angles; of the one to its corner there is no
// law.
TEST(Ray_traps_2, NoLawAtACorner)
{
  const Curve angle = SC::polyline_curve(std::vector<K::Point_2>{{-4, 4}, {0, 0}, {4, 4}});
  const auto traps_with_circle_around = [&](const K::Point_2& center) {
    return SC::ray_traps(std::vector<Curve>{angle, SC::circle_curve(center, K::FT(1))});
  };
  const auto inside = traps_with_circle_around({0, 3});
  EXPECT_TRUE(inside.summary().is_complete) << inside.summary();
  ASSERT_EQ(inside.traps().size(), 4u);
  for (const auto& trap : inside.traps())
    EXPECT_NEAR(std::abs(CGAL::to_double(trap.points()[0].x())), 1.5, 1e-12);
  const auto at_corner = traps_with_circle_around({3, -3});
  EXPECT_TRUE(at_corner.summary().is_complete) << at_corner.summary();
  EXPECT_TRUE(at_corner.traps().empty());
}

TEST(Ray_traps_2, BadInput)
{
  EXPECT_THROW(SC::ray_traps(std::vector<Curve>{}), SC::Invalid_input);
  EXPECT_THROW(SC::ray_traps(std::vector<Curve>{SC::segment_curve(K::Point_2(0, 0), K::Point_2(1, 0))}),
               SC::Invalid_input);
}

} // namespace

} // namespace ray_traps_2_test
