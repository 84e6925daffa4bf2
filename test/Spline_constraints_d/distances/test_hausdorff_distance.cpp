// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Hausdorff distances with known answers, and against samples.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/hausdorff_distance.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace hausdorff_distance_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;
using Points = std::vector<K::Point_2>;
using Points_3 = std::vector<K::Point_3>;

template <int d>
void expect_within(const SC::Hausdorff_distance<K, d>& distance, double expected, double tolerance)
{
  const auto [lower, upper] = distance.distance_range();
  EXPECT_LE(lower, expected + 1e-15);
  EXPECT_GE(upper, expected - 1e-15);
  EXPECT_LE(upper - lower, tolerance * (1 + 1e-9));
}

TEST(Hausdorff_distance, Segments)
{
  const Curve a = SC::segment_curve(K::Point_2(0, 0), K::Point_2(4, 0)),
              b = SC::segment_curve(K::Point_2(1, 1), K::Point_2(9, 1));
  expect_within(SC::one_sided_hausdorff_distance(a, b, 1e-9), std::sqrt(2.0), 1e-9);
  const auto distance = SC::hausdorff_distance(a, b, 1e-9);
  expect_within(distance, std::sqrt(26.0), 1e-9);
  EXPECT_EQ(distance.curve(), 1u);
  EXPECT_NEAR(CGAL::to_double(distance.point(1).x()), 9, 1e-8);
  EXPECT_NEAR(CGAL::to_double(distance.point(0).x()), 4, 1e-4);
  EXPECT_EQ(SC::hausdorff_distance(b, a, 1e-9).curve(), 0u);
}

TEST(Hausdorff_distance, Circles)
{
  const Curve circle = SC::circle_curve(K::Point_2(0, 0), K::FT(2));
  // everywhere
  expect_within(SC::hausdorff_distance(circle, SC::circle_curve(K::Point_2(0, 0), K::FT(3)), 1e-4), 1, 1e-4);
  expect_within(SC::hausdorff_distance(circle, SC::circle_curve(K::Point_2(1, 1), K::FT(3)), 1e-8), 1 + std::sqrt(2.0),
                1e-8);
  // as far as doubles go
  expect_within(SC::hausdorff_distance(circle, SC::circle_curve(K::Point_2(1, 1), K::FT(3)), 1e-300),
                1 + std::sqrt(2.0), 1e-12);
  expect_within(SC::hausdorff_distance(SC::circle_curve(K::Point_2(0, 0), K::FT(1)),
                                       SC::circle_curve(K::Point_2(3, 0), K::FT(2)), 1e-8),
                4, 1e-8);
}

// Curves that are the same, in parts or with other parameters, and one that is nearly the same.
TEST(Hausdorff_distance, Coincident)
{
  const Curve arc = SC::circle_curve(K::Point_2(0, 0), K::FT(2)).restricted(0, 1);
  expect_within(SC::hausdorff_distance(arc, arc.reversed(), 1e-5), 0, 1e-5);
  expect_within(SC::one_sided_hausdorff_distance(arc.restricted(K::FT(1) / 3, K::FT(1) / 2), arc, 1e-5), 0, 1e-5);
  const Curve cubic = SC::bezier_curve(Points{{0, 0}, {1, 2}, {3, -2}, {4, 0}}),
              moved = cubic.transformed(K::Aff_transformation_2(CGAL::TRANSLATION, K::Vector_2(0, K::FT(1) / 1024)));
  const auto near = SC::hausdorff_distance(cubic, moved, 1e-7);
  EXPECT_LE(near.distance_range().second, 1.0 / 1024 + 1e-7);
  EXPECT_GT(near.distance_range().first, 0.5 / 1024);
}

// The largest distance of a point of a polyline from segments is at a vertex, or where two segments are equally far:
// sampled densely, it is a lower bound.
double sampled(const Curve& a, const Curve& b, int steps)
{
  const auto points = [&](const Curve& curve) {
    std::vector<std::pair<double, double>> result;
    const auto [begin, end] = curve.domain();
    for (int i = 0; i <= steps; ++i) {
      const K::Point_2 p = curve(begin + (end - begin) * i / steps);
      result.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
    }
    return result;
  };
  const auto of_a = points(a), of_b = points(b);
  double farthest = 0;
  for (const auto& p : of_a) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& q : of_b)
      nearest = (std::min)(nearest, std::hypot(p.first - q.first, p.second - q.second));
    farthest = (std::max)(farthest, nearest);
  }
  return farthest;
}

TEST(Hausdorff_distance, AgainstSamples)
{
  std::mt19937 random(23);
  const auto points = [&](int count) {
    Points result;
    for (int i = 0; i < count; ++i) {
      const int x = static_cast<int>(random() % 21), y = static_cast<int>(random() % 21);
      result.emplace_back(x, y);
    }
    return result;
  };
  for (int round = 0; round < 6; ++round) {
    const bool is_polygonal = round % 2 == 0;
    const Points p = points(4), q = points(4);
    const Curve a = is_polygonal ? SC::polyline_curve(p) : SC::bezier_curve(p),
                b = is_polygonal ? SC::polyline_curve(q) : SC::bezier_curve(q);
    constexpr int steps = 300;
    const double expected = sampled(a, b, steps), error = 60.0 / steps;   // |A'|, |B'| <= 90 over the domain
    const auto distance = SC::one_sided_hausdorff_distance(a, b, 1e-7);
    EXPECT_LE(distance.distance_range().second - distance.distance_range().first, 1e-7 * (1 + 1e-9));
    EXPECT_NEAR(distance.distance_range().first, expected, error) << round;
    const auto both = SC::hausdorff_distance(a, b, 1e-7), swapped = SC::hausdorff_distance(b, a, 1e-7);
    EXPECT_GE(both.distance_range().second, distance.distance_range().first);
    EXPECT_TRUE(both.distance_range().first <= swapped.distance_range().second &&
                swapped.distance_range().first <= both.distance_range().second);
    // The point that is reported is that far from the samples.
    const std::size_t far = both.curve();
    EXPECT_GE(std::sqrt(CGAL::to_double(CGAL::squared_distance(both.point(far), both.point(1 - far)))),
              both.distance_range().first - 1e-7);
  }
}

// The farthest point of the segment is equally far from two corners.
TEST(Hausdorff_distance, EquidistantPoint)
{
  const Curve segment = SC::segment_curve(K::Point_2(-5, 0), K::Point_2(5, 0)),
              tent = SC::polyline_curve(Points{{-5, 0}, {-3, 0}, {0, 50}, {3, 0}, {5, 0}});
  const auto distance = SC::one_sided_hausdorff_distance(segment, tent, 1e-9);
  expect_within(distance, 150 / std::sqrt(2509.0), 1e-9);   // of (0,0) from the line 50 x + 3 y = 150
  EXPECT_NEAR(CGAL::to_double(distance.parameter(0)), 0.5, 1e-6);
}

TEST(Hausdorff_distance, SegmentsInSpace)
{
  const auto a = SC::segment_curve(K::Point_3(0, 0, 0), K::Point_3(4, 0, 0)),
             b = SC::segment_curve(K::Point_3(1, 1, 1), K::Point_3(9, 1, 1));
  expect_within(SC::one_sided_hausdorff_distance(a, b, 1e-9), std::sqrt(3.0), 1e-9);
  const auto distance = SC::hausdorff_distance(a, b, 1e-9);
  expect_within(distance, std::sqrt(27.0), 1e-9);
  EXPECT_EQ(distance.curve(), 1u);
  EXPECT_NEAR(CGAL::to_double(distance.point(1).x()), 9, 1e-8);
  // their common perpendicular is at x = 2
  const auto skew = SC::segment_curve(K::Point_3(2, -5, 3), K::Point_3(2, 5, 3));
  expect_within(SC::one_sided_hausdorff_distance(a, skew, 1e-9), std::sqrt(13.0), 1e-9);
  expect_within(SC::hausdorff_distance(a, skew, 1e-9), std::sqrt(34.0), 1e-9);
}

TEST(Hausdorff_distance, CirclesInSpace)
{
  const K::Vector_3 up(0, 0, 1);
  const auto circle = [&](int height, int radius) {
    return SC::circle_curve(K::Point_3(0, 0, height), up, K::Point_3(radius, 0, height));
  };
  expect_within(SC::hausdorff_distance(circle(0, 2), circle(3, 2), 1e-3), 3, 1e-3);   // everywhere
  expect_within(SC::hausdorff_distance(circle(0, 2), circle(4, 5), 1e-3), 5, 1e-3);
  const auto axis = SC::segment_curve(K::Point_3(0, 0, -4), K::Point_3(0, 0, 4));
  expect_within(SC::one_sided_hausdorff_distance(circle(0, 3), axis, 1e-3), 3, 1e-3);
  // its ends have all points of the circle as nearest ones
  expect_within(SC::one_sided_hausdorff_distance(axis, circle(0, 3), 1e-3), 5, 1e-3);
  // Linked circles: all points of both are at the distance 2 from the other one.
  const auto linked = SC::circle_curve(K::Point_3(2, 0, 0), K::Vector_3(0, 1, 0), K::Point_3(4, 0, 0));
  expect_within(SC::hausdorff_distance(linked, circle(0, 2), 1e-3), 2, 1e-3);
}

// The same answer for planar curves that are embedded in space by a rotation with rational entries.
TEST(Hausdorff_distance, RotatedPlanes)
{
  std::mt19937 random(29);
  const auto number = [&](int range) { return static_cast<int>(random() % (2 * range + 1)) - range; };
  for (int round = 0; round < 6; ++round) {
    // Of the quaternion q, with columns of length 1.
    const K::FT q0(number(5)), q1(number(5)), q2(number(5)), q3(1 + number(2) * 2),
        n = q0 * q0 + q1 * q1 + q2 * q2 + q3 * q3;
    const K::Vector_3 e(K::FT((q0 * q0 + q1 * q1 - q2 * q2 - q3 * q3) / n), K::FT(2 * (q1 * q2 + q0 * q3) / n),
                        K::FT(2 * (q1 * q3 - q0 * q2) / n));
    const K::Vector_3 f(K::FT(2 * (q1 * q2 - q0 * q3) / n), K::FT((q0 * q0 - q1 * q1 + q2 * q2 - q3 * q3) / n),
                        K::FT(2 * (q2 * q3 + q0 * q1) / n));
    ASSERT_TRUE(e * e == 1 && f * f == 1 && e * f == 0);
    std::array<Points, 2> flat;
    std::array<Points_3, 2> embedded;
    std::array<std::vector<K::FT>, 2> weights;
    for (std::size_t i = 0; i < 2; ++i)
      for (int k = 0; k < 4; ++k) {
        const int x = number(10), y = number(10);
        flat[i].emplace_back(x, y);
        embedded[i].push_back(K::Point_3(1, -2, 3) + K::FT(x) * e + K::FT(y) * f);
        weights[i].push_back(1 + round % 2 * k);
      }
    const auto in_plane =
        SC::hausdorff_distance(SC::bezier_curve(flat[0], weights[0]), SC::bezier_curve(flat[1], weights[1]), 1e-7);
    const auto in_space = SC::hausdorff_distance(SC::bezier_curve(embedded[0], weights[0]),
                                                 SC::bezier_curve(embedded[1], weights[1]), 1e-7);
    EXPECT_GT(in_plane.distance_range().first, 0);
    EXPECT_LE(in_space.distance_range().second - in_space.distance_range().first, 1e-7 * (1 + 1e-9));
    EXPECT_TRUE(in_plane.distance_range().first <= in_space.distance_range().second &&
                in_space.distance_range().first <= in_plane.distance_range().second)
        << round;
    EXPECT_EQ(in_plane.curve(), in_space.curve()) << round;
  }
}

TEST(Hausdorff_distance, BadInput)
{
  const Curve segment = SC::segment_curve(K::Point_2(0, 0), K::Point_2(1, 0));
  for (const double tolerance : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(SC::hausdorff_distance(segment, segment, tolerance), SC::Invalid_input);
}

} // namespace

} // namespace hausdorff_distance_test
