// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/clipped_lines.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

namespace clipped_lines_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Epeck;
using I = CGAL::Epick;

TEST(Clipped_lines, end_on_the_rectangle)
{
  const K::Iso_rectangle_2 rectangle({0, 0}, {4, 2});
  const auto slanted = SC::to_bspline_curve(K::Line_2(K::Point_2(1, 0), K::Point_2(2, 3)), rectangle);
  ASSERT_TRUE(slanted);
  EXPECT_EQ(slanted->source(), K::Point_2(1, 0));
  EXPECT_EQ(slanted->target(), K::Point_2(K::FT(5) / 3, 2));
  const auto upright = SC::to_bspline_curve(K::Line_2(K::Point_2(3, 7), K::Point_2(3, 5)), rectangle);
  ASSERT_TRUE(upright);
  EXPECT_EQ(upright->source(), K::Point_2(3, 2));
  EXPECT_EQ(upright->target(), K::Point_2(3, 0));
  const auto corner = SC::to_bspline_curve(K::Line_2(K::Point_2(3, 3), K::Point_2(5, 1)), rectangle);
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->source(), K::Point_2(4, 2));
  EXPECT_EQ(corner->target(), K::Point_2(4, 2));
  EXPECT_FALSE(SC::to_bspline_curve(K::Line_2(K::Point_2(3, 3.001), K::Point_2(5, 1)), rectangle));
  EXPECT_FALSE(SC::to_bspline_curve(K::Line_2(K::Point_2(-1, 0), K::Point_2(-1, 1)), rectangle));
  expect_invalid([&] { SC::to_bspline_curve(K::Line_2(0, 0, 1), rectangle); }, "degenerate");
}

TEST(Clipped_lines, of_rays_begin_at_their_source)
{
  const K::Iso_rectangle_2 rectangle({0, 0}, {4, 2});
  const auto inside = SC::to_bspline_curve(K::Ray_2(K::Point_2(1, 1), K::Point_2(2, 1)), rectangle);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->source(), K::Point_2(1, 1));
  EXPECT_EQ(inside->target(), K::Point_2(4, 1));
  EXPECT_FALSE(SC::to_bspline_curve(K::Ray_2(K::Point_2(5, 1), K::Point_2(6, 1)), rectangle));
  EXPECT_TRUE(SC::to_bspline_curve(K::Ray_2(K::Point_2(5, 1), K::Point_2(4, 1)), rectangle));
  // A ray that misses the corner by less than doubles of its line could tell.
  const I::Iso_rectangle_2 unit({0, 0}, {1, 1});
  EXPECT_TRUE(SC::to_bspline_curve(I::Ray_2(I::Point_2(2, 0x1p-60), I::Point_2(1, 1)), unit));
  EXPECT_FALSE(SC::to_bspline_curve(I::Ray_2(I::Point_2(2, 0x1p-60), I::Point_2(1, 1 + 0x1p-52)), unit));
}

TEST(Clipped_lines, in_space_are_the_points_in_the_cuboid)
{
  const Exact_cartesian::Iso_cuboid_3 cuboid({-1, -1, -1}, {1, 2, 3});
  Random_source random(7);
  int hits = 0, misses = 0;
  for (int i = 0; i < 100; ++i) {
    const auto point = [&] {
      return Exact_cartesian::Point_3(random.integer(-4, 4), random.integer(-4, 4), random.integer(-4, 4));
    };
    const auto p = point(), q = point();
    if (p == q)
      continue;
    const Exact_cartesian::Ray_3 ray(p, q);
    const auto curve = SC::to_bspline_curve(ray, cuboid),
               whole = SC::to_bspline_curve(Exact_cartesian::Line_3(p, q), cuboid);
    EXPECT_EQ(curve.has_value(), CGAL::do_intersect(ray, CGAL::Bbox_3(-1, -1, -1, 1, 2, 3)));
    if (curve) {
      ++hits;
      for (const auto& end : {curve->source(), curve->target()})
        EXPECT_TRUE(ray.has_on(end) && !cuboid.has_on_unbounded_side(end));
      EXPECT_TRUE(curve->source() == p || cuboid.has_on_boundary(curve->source()));
      EXPECT_TRUE(cuboid.has_on_boundary(curve->target()));
      ASSERT_TRUE(whole);
      EXPECT_EQ(whole->target(), curve->target());
    }
    else
      ++misses;
  }
  EXPECT_GT(hits, 20);
  EXPECT_GT(misses, 20);
}

} // namespace

} // namespace clipped_lines_test
