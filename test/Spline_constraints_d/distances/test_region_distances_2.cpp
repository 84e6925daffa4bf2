// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances of regions: in closed form, for nested, touching and overlapping ones; and beside dense samples of random
// ones.
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>
#include <CGAL/Spline_constraints_d/operations/distances/region_distances_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace region_distances {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using P = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Region = SC::Planar_region_2<K>;
using R = CGAL::Exact_rational;

Curve polygon(std::vector<P> points)
{
  points.push_back(P(points.front()));
  return SC::polyline_curve(points);
}

Curve square(double x, double y, double side)
{
  return polygon({P(x, y), P(x + side, y), P(x + side, y + side), P(x, y + side)});
}

Region region(const std::vector<Curve>& curves) { return SC::planar_region(curves); }

void expect_distance(const Region& a, const Region& b, double distance)
{
  for (const auto& [first, second] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const auto result = SC::region_distance(*first, *second);
    EXPECT_TRUE(result.is_complete());
    const auto [lower, upper] = result.distance_range();
    EXPECT_LE(lower, distance * (1 + 1e-15));
    EXPECT_GE(upper, distance * (1 - 1e-15));
    EXPECT_LE(upper - lower, 1e-12 * (1 + distance));
  }
}

TEST(RegionDistances, Polygons)
{
  const Region a = region({square(0, 0, 1)});
  expect_distance(a, region({square(4, 5, 2)}), 5);
  expect_distance(a, region({square(3, -1, 3)}), 2);   // sides face each other
  const auto corner = SC::region_distance(a, region({square(4, 5, 2)}));
  EXPECT_EQ(corner.squared_distance_range(), (std::pair<R, R>(25, 25)));
  ASSERT_EQ(corner.pairs().size(), 1U);
  EXPECT_EQ(corner.pairs()[0].points.point(0), P(1, 1));
  EXPECT_EQ(corner.pairs()[0].points.point(1), P(4, 5));
  EXPECT_FALSE(CGAL::possibly(corner.do_meet()));
}

// The nearest points are on the line through the centers.
TEST(RegionDistances, Disks)
{
  const Region a = region({SC::circle_curve(P(0, 0), 1.0)}), b = region({SC::circle_curve(P(3, 4), 2.0)});
  expect_distance(a, b, 2);
  const auto result = SC::region_distance(a, b);
  ASSERT_EQ(result.pairs().size(), 1U);
  EXPECT_NEAR(result.pairs()[0].points.point(0).x(), 0.6, 1e-12);
  EXPECT_NEAR(result.pairs()[0].points.point(1).y(), 4 - 1.6, 1e-12);
}

// Not in dependence on the size of the regions, nor is their orientation.
TEST(RegionDistances, HugeAndTinyDisks)
{
  for (const double size : {1e-300, 1e-200, 1e-140, 1e-30, 1e30, 1e140, 1e200, 1e300}) {
    const auto result = SC::region_distance(region({SC::circle_curve(P(0, 0), size)}),
                                            region({SC::circle_curve(P(3 * size, 4 * size), 2 * size)}));
    const auto [lower, upper] = result.distance_range();
    EXPECT_NEAR(lower / size, 2, 1e-12);
    EXPECT_NEAR(upper / size, 2, 1e-12);
    EXPECT_EQ(result.pairs().size(), 1U);
  }
}

// Inside of the region, inside of its hole, and in a hole that is just as large.
TEST(RegionDistances, Nested)
{
  const Region frame = region({square(0, 0, 10), square(2, 2, 6)}), inner = region({square(4, 5, 1)});
  expect_distance(frame, inner, 2);
  const auto overlap = SC::region_distance(region({square(0, 0, 10)}), inner);
  EXPECT_TRUE(CGAL::certainly(overlap.do_meet()));
  EXPECT_TRUE(overlap.pairs().empty());
  EXPECT_EQ(overlap.squared_distance_range(), (std::pair<R, R>(0, 0)));
  EXPECT_TRUE(CGAL::certainly(SC::region_distance(frame, region({square(2, 2, 6)})).do_meet()));
}

// Boundaries cross, though no boundary begins inside of the other region; and squares that have one corner in common.
TEST(RegionDistances, Meeting)
{
  const Region wide = region({polygon({P(-4, -1), P(4, -1), P(4, 1), P(-4, 1)})}),
               high = region({polygon({P(-1, -4), P(1, -4), P(1, 4), P(-1, 4)})});
  const auto cross = SC::region_distance(wide, high);
  EXPECT_TRUE(CGAL::certainly(cross.do_meet()));
  EXPECT_GE(cross.pairs().size(), 4U);
  EXPECT_TRUE(CGAL::certainly(SC::region_distance(region({square(0, 0, 1)}), region({square(1, 1, 1)})).do_meet()));
  EXPECT_FALSE(
      CGAL::possibly(SC::region_distance(region({square(0, 0, 1)}), region({square(1 + 1e-15, 1, 1)})).do_meet()));
}

// What an outline runs along forth and back is not in the region; where it touches itself it is.
TEST(RegionDistances, OutlinesThatTouch)
{
  const Region spike = region({polygon({P(0, 0), P(4, 0), P(4, 2), P(7, 2), P(4, 2), P(4, 4), P(0, 4)})}),
               lobes = region({polygon({P(0, 0), P(2, 1), P(2, -1), P(0, 0), P(-2, -1), P(-2, 1)})});
  expect_distance(spike, region({square(9, 1, 2)}), 5);
  expect_distance(lobes, region({square(-1, 3, 2)}), std::sqrt(5));
  expect_distance(lobes, region({polygon({P(0, 1), P(0.125, 2), P(-0.125, 2)})}), 2 / std::sqrt(5));
}

// Closed quadratic splines around two centers.
TEST(RegionDistances, RandomSplines)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(1, 3);
  for (int run = 0; run < 3; ++run) {
    std::vector<Curve> curves;
    for (const double x : {0.0, 7.0}) {
      std::vector<P> points;
      std::vector<double> knots{0};
      for (int i = 0; i < 6; ++i) {
        const double angle = CGAL_PI * i / 3, r = radius(random);
        points.emplace_back(x + r * std::cos(angle), r * std::sin(angle));
        knots.push_back(i + 1);
      }
      curves.push_back(Curve::from_periodic(2, knots, points));
    }
    double sampled = std::numeric_limits<double>::infinity();
    constexpr int n = 120;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        sampled =
            (std::min)(sampled, std::sqrt(CGAL::squared_distance(curves[0](6.0 * i / n), curves[1](6.0 * j / n))));
    const auto result = SC::region_distance(region({curves[0]}), region({curves[1]}));
    EXPECT_TRUE(result.is_complete());
    ASSERT_FALSE(result.pairs().empty());
    const auto [lower, upper] = result.distance_range();
    EXPECT_LE(upper, sampled + 1e-12);
    EXPECT_GE(lower, sampled - 0.05);
    EXPECT_LE(upper - lower, 1e-9);
  }
}

} // namespace region_distances
