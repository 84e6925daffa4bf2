// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points of curves and surfaces by ranges of parameters, and which maps are closed.

#include <CGAL/Spline_constraints_d/geometry/curves/Point_on_spline.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <array>

namespace Point_on_spline_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using K = CGAL::Exact_predicates_exact_constructions_kernel;

TEST(Point_on_spline, RangesAreCutAtTheEndsOfTheDomain)
{
  const SC::Spline_map<1, 2> map(SC::segment_curve(K::Point_2(1, 2), K::Point_2(5, 10)));   // on [0,1]
  const SC::Point_on_spline<K, 1, 2> inside(map, {{{Exact_rational(1) / 4, Exact_rational(1) / 2}}});
  EXPECT_EQ(inside.parameter(), 0.375);
  EXPECT_EQ(inside.point(), K::Point_2(1 + K::FT(3) / 2, 5));
  const SC::Point_on_spline<K, 1, 2> end(map, {{{Exact_rational(1), Exact_rational(7)}}});
  EXPECT_EQ(end.parameter_range().second, Exact_rational(1));
  EXPECT_EQ(end.point(), K::Point_2(5, 10));
}

TEST(Point_on_spline, OfASurface)
{
  const auto sphere = SC::sphere_surface(K::Point_3(0, 0, 0), K::FT(3));
  const SC::Spline_map<2, 3> map(sphere);
  const auto [u, v] = std::array{map.domain(0), map.domain(1)};
  const SC::Point_on_spline<K, 2, 3> point(map, {{{u.first, u.first}, {v.first, v.second}}});
  EXPECT_EQ(point.parameter(0), CGAL::to_double(u.first));
  EXPECT_EQ(point.parameter(1), CGAL::to_double(Exact_rational((v.first + v.second) / 2)));
  EXPECT_EQ(CGAL::squared_distance(point.point(), K::Point_3(0, 0, 0)), K::FT(9));
}

// As the curves and surfaces themselves say, which multiply Bernstein forms instead of integers.
TEST(Spline_map, ClosedAxes)
{
  const auto circle = SC::circle_curve(K::Point_2(1, 2), K::FT(4));
  EXPECT_TRUE((SC::Spline_map<1, 2>(circle).is_closed()));
  EXPECT_FALSE((SC::Spline_map<1, 2>(circle.restricted(0, 3)).is_closed()));
  EXPECT_TRUE(derivative(SC::Spline_map<1, 2>(circle)).is_closed());   // of one circle with a smooth seam

  const auto torus = SC::torus_surface(K::Point_3(0, 0, 0), K::FT(3), K::FT(1));
  const auto cylinder = SC::cylinder_surface(K::Point_3(0, 0, 0), K::FT(1), K::FT(2));
  for (const auto& surface : {torus, cylinder}) {
    const SC::Spline_map<2, 3> map(surface);
    for (int axis = 0; axis < 2; ++axis)
      EXPECT_EQ(map.is_closed(axis), surface.is_closed(axis)) << axis;
  }
  EXPECT_TRUE((SC::Spline_map<2, 3>(torus).is_closed(0) && SC::Spline_map<2, 3>(torus).is_closed(1)));
  EXPECT_TRUE((SC::Spline_map<2, 3>(cylinder).is_closed(0) != SC::Spline_map<2, 3>(cylinder).is_closed(1)));
}

} // namespace

} // namespace Point_on_spline_test
