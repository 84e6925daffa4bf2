// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Feet on implicit curves and surfaces: known ones on conics and quadrics, singular points, edges of the box, and
// random points against samples.

#include <CGAL/Spline_constraints_d/geometry/curves/Implicit_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/distances/implicit_distances.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace implicit_distances_test {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Rational>;

namespace {

SC::Implicit_curve_2 ellipse() // x^2 / 4 + y^2 = 1
{
  auto [x, y] = SC::unknowns({-3, 3}, {-3, 3});
  return SC::Implicit_curve_2(x * x / 4 + y * y == 1);
}

template <class Feet>
std::size_t number_inside(const Feet& feet)
{
  std::size_t result = 0;
  for (const auto& foot : feet.feet())
    result += foot.is_inside && foot.kind == SC::Solution_kind::CERTIFIED;
  return result;
}

void expect_distance(const std::optional<std::pair<double, double>>& range, double distance)
{
  ASSERT_TRUE(range);
  EXPECT_LE(range->first, distance + 1e-14);
  EXPECT_GE(range->second, distance - 1e-14);
  EXPECT_LT(range->second - range->first, 1e-9);
}

} // namespace

// From (a,0) the feet are (2,0), (-2,0), and those with x = 4a/3 if this is less than 2.
TEST(Implicit_distances, ellipse)
{
  const auto far = SC::implicit_feet(K::Point_2(Rational(9, 4), 0), ellipse());
  EXPECT_TRUE(far.is_complete());
  EXPECT_EQ(number_inside(far), 2u);
  EXPECT_LE(far.squared_distance_range()->first, Rational(1, 16));
  EXPECT_GE(far.squared_distance_range()->second, Rational(1, 16));
  expect_distance(far.distance_range(), 0.25);
  const auto near = SC::implicit_feet(K::Point_2(Rational(3, 4), 0), ellipse());
  EXPECT_TRUE(near.is_complete());
  EXPECT_EQ(number_inside(near), 4u);
  for (const std::size_t i : {0, 1}) {
    EXPECT_NEAR(CGAL::to_double(near.feet()[i].point.x()), 1, 1e-12);
    EXPECT_NEAR(std::abs(CGAL::to_double(near.feet()[i].point.y())), std::sqrt(0.75), 1e-12);
  }
  expect_distance(near.distance_range(), std::sqrt(0.75 + 1.0 / 16));
  // at the center of curvature (3/2,0) of the vertex, three feet are one
  const auto evolute = SC::implicit_feet(K::Point_2(Rational(3, 2), 0), ellipse());
  EXPECT_TRUE(evolute.is_complete());
  ASSERT_FALSE(evolute.feet().empty());
  EXPECT_EQ(evolute.feet()[0].kind, SC::Solution_kind::CLUSTER);
  EXPECT_LE(evolute.distance_range()->first, 0.5);
  EXPECT_GE(evolute.distance_range()->second, 0.5);
}

TEST(Implicit_distances, edges_singular_points_and_continua)
{
  auto [x, y] = SC::unknowns({0, 3}, {-3, 3});
  const SC::Implicit_curve_2 half(x * x / 4 + y * y == 1), node(x * x * x + x * x == y * y);
  // the nearest point is on the edge x = 0 of the box
  expect_distance(SC::implicit_feet(K::Point_2(-1, 2), half).distance_range(), std::sqrt(2.0));
  // the node, from which the curve goes into the box at 45 degrees
  const auto of_node = SC::implicit_feet(K::Point_2(-1, 0), node);
  ASSERT_TRUE(of_node.distance_range());
  EXPECT_LE(of_node.distance_range()->first, 1);
  EXPECT_GE(of_node.distance_range()->second, 1);
  // nothing in the box
  const SC::Implicit_curve_2 none(x * x + y * y == -1);
  const auto of_nothing = SC::implicit_feet(K::Point_2(1, 1), none);
  EXPECT_TRUE(of_nothing.is_complete());
  EXPECT_TRUE(of_nothing.feet().empty());
  EXPECT_FALSE(of_nothing.distance_range());
  // a circle and its center
  auto [u, v] = SC::unknowns({-3, 3}, {-3, 3});
  const auto center = SC::implicit_feet(K::Point_2(0, 0), SC::Implicit_curve_2(u * u + v * v == 4));
  if (center.distance_range()) {
    EXPECT_LE(center.distance_range()->first, 2);
    EXPECT_GE(center.distance_range()->second, 2);
  } else
    EXPECT_FALSE(center.is_complete());
}

TEST(Implicit_distances, quadrics)
{
  auto [x, y, z] = SC::unknowns({-4, 4}, {-4, 4}, {-4, 4});
  const SC::Implicit_surface_3 sphere(x * x + y * y + z * z == 9), ellipsoid(x * x / 9 + y * y / 4 + z * z == 1);
  const auto two = SC::implicit_feet(K::Point_3(1, 2, 2), sphere);
  EXPECT_TRUE(two.is_complete());
  EXPECT_EQ(number_inside(two), 2u);
  expect_distance(two.distance_range(), 0);
  expect_distance(SC::implicit_feet(K::Point_3(2, 0, 0), sphere).distance_range(), 1);
  // near the center there are six feet
  const auto six = SC::implicit_feet(K::Point_3(Rational(1, 10), Rational(1, 11), Rational(1, 12)), ellipsoid);
  EXPECT_TRUE(six.is_complete());
  EXPECT_EQ(number_inside(six), 6u);
  for (const auto& foot : six.feet()) { // offset and gradient are parallel
    const auto offset = foot.point - K::Point_3(Rational(1, 10), Rational(1, 11), Rational(1, 12));
    const K::Vector_3 gradient(foot.point.x() / 9, foot.point.y() / 4, foot.point.z());
    EXPECT_NEAR(std::sqrt(CGAL::to_double(CGAL::cross_product(offset, gradient).squared_length())), 0, 1e-9);
  }
  // the tip of a surface that is singular there
  const auto tip = SC::implicit_feet(K::Point_3(0, 0, -1), SC::Implicit_surface_3(x * x + y * y == z * z * z));
  ASSERT_TRUE(tip.distance_range());
  EXPECT_LE(tip.distance_range()->first, 1);
  EXPECT_GE(tip.distance_range()->second, 1);
}

TEST(Implicit_distances, random_points)
{
  auto [x, y] = SC::unknowns({-2, 2}, {-2, 2});
  const SC::Implicit_curve_2 curve(x * x * x * x + y * y * y * y - 2 * x * x * y == 1);
  std::mt19937 random(3);
  std::uniform_int_distribution<int> tenths(-15, 15);
  for (int round = 0; round < 20; ++round) {
    const K::Point_2 p(Rational(tenths(random), 10), Rational(tenths(random), 10));
    const auto feet = SC::implicit_feet(p, curve);
    ASSERT_TRUE(feet.is_complete());
    ASSERT_TRUE(feet.distance_range());
    // circles that are a little smaller have one sign, and those that are a little larger have two
    const double distance = feet.distance_range()->first;
    const auto number_of_signs = [&](double radius) {
      bool has_positive = false, has_negative = false;
      for (int i = 0; i < 2000; ++i) {
        const double a = i * 3.14159265358979 / 1000, u = CGAL::to_double(p.x()) + radius * std::cos(a),
                     v = CGAL::to_double(p.y()) + radius * std::sin(a);
        const double value = u * u * u * u + v * v * v * v - 2 * u * u * v - 1;
        (value > 0 ? has_positive : has_negative) = true;
      }
      return has_positive + has_negative;
    };
    if (distance > 0.05) {
      EXPECT_EQ(number_of_signs(0.999 * distance), 1) << round;
      EXPECT_EQ(number_of_signs(1.02 * distance), 2) << round;
    }
    if (distance < 0.1) {
      const auto first_order = SC::first_order_distance(p, curve);
      ASSERT_TRUE(first_order);
      EXPECT_NEAR(*first_order, distance, 0.05);
    }
  }
  EXPECT_FALSE(SC::first_order_distance(K::Point_2(0, 0), ellipse()));
  EXPECT_DOUBLE_EQ(*SC::first_order_distance(K::Point_2(4, 0), ellipse()), 1.5); // 3 / 2
}

TEST(Implicit_distances, limits_and_bad_input)
{
  EXPECT_THROW(SC::implicit_feet(K::Point_2(0, 0), ellipse(), {.tolerance = -1}), SC::Invalid_input);
  const auto stopped = SC::implicit_feet(K::Point_2(1, Rational(1, 3)), ellipse(), {.node_limit = 1});
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_FALSE(stopped.undecided().empty());
}

// A circle of the radius 1 in the plane z = 1, from points beside and on its axis; its half in a box; a node.
TEST(Implicit_distances, curves_in_space)
{
  auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const SC::Implicit_surface_3 sphere(x * x + y * y + z * z == 2), level(z == 1), tube(x * x + y * y == 1);
  const auto beside = SC::implicit_feet(K::Point_3(3, 0, 0), sphere, level);
  EXPECT_TRUE(beside.is_complete());
  ASSERT_EQ(number_inside(beside), 2u);
  expect_distance(beside.distance_range(), std::sqrt(5.));
  EXPECT_NEAR(CGAL::to_double(beside.feet()[0].point.x()), 1, 1e-12);
  EXPECT_NEAR(CGAL::to_double(beside.feet()[1].point.x()), -1, 1e-12);
  // the circles z = 1 and z = -1, with four feet
  const auto both = SC::implicit_feet(K::Point_3(0, Rational(5, 2), Rational(1, 2)), sphere, tube);
  EXPECT_TRUE(both.is_complete());
  EXPECT_EQ(number_inside(both), 4u);
  expect_distance(both.distance_range(), std::sqrt(2.25 + 0.25));
  // a half, whose ends are the nearest points
  auto [u, v, w] = SC::unknowns({-3, 0}, {-3, 3}, {-3, 3});
  const SC::Implicit_surface_3 half(u * u + v * v == 1);
  const auto ends = SC::implicit_feet(K::Point_3(3, 0, 1), half, level);
  EXPECT_TRUE(ends.is_complete());
  EXPECT_EQ(number_inside(ends), 1u);
  expect_distance(ends.distance_range(), std::sqrt(10.));
  EXPECT_FALSE(ends.feet()[0].is_inside);
  // two lines that cross in the origin: a foot on each, and the node
  const SC::Implicit_surface_3 saddle(x * y == z), floor(z == 0);
  const auto node = SC::implicit_feet(K::Point_3(1, 2, 1), saddle, floor);
  EXPECT_TRUE(node.is_complete());
  EXPECT_EQ(std::count_if(node.feet().begin(), node.feet().end(), [](const auto& foot) { return foot.is_inside; }), 3);
  expect_distance(node.distance_range(), std::sqrt(2.));
  const SC::Implicit_surface_3 far(SC::Power_polynomial::variable(0), {{{5, 6}, {5, 6}, {5, 6}}});
  EXPECT_TRUE(SC::implicit_feet(K::Point_3(1, 2, 1), saddle, far).feet().empty());
  // bad input, also where nothing has to be found; and a limit
  EXPECT_THROW(SC::implicit_feet(K::Point_3(1, 2, 1), saddle, floor, {.tolerance = -1}), SC::Invalid_input);
  EXPECT_THROW(SC::implicit_feet(K::Point_3(1, 2, 1), saddle, far, {.time_limit = -1}), SC::Invalid_input);
  using Double_point = CGAL::Simple_cartesian<double>::Point_3;
  EXPECT_THROW(SC::implicit_feet(Double_point(std::nan(""), 0, 0), saddle, floor), SC::Invalid_input);
  const auto stopped = SC::implicit_feet(K::Point_3(1, 2, Rational(1, 3)), sphere, tube, {.node_limit = 1});
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_FALSE(stopped.undecided().empty());
}

} // namespace implicit_distances_test
