// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Prepared curves and surfaces: nearest points against samples and the unprepared answers, first points of rays against
// all intersections.

#include "uniform_knots.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/distances/Curve_locator.h>
#include <CGAL/Spline_constraints_d/operations/distances/Surface_locator_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace locators_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

class Random
{
  std::mt19937 m_generator;

public:
  explicit Random(unsigned seed) : m_generator(seed) {}
  double operator()(double low, double high) { return std::uniform_real_distribution<>(low, high)(m_generator); }

  // Along the first axis, with waves.
  template <class Curve>
  Curve curve(int pieces)
  {
    std::vector<typename Curve::Point> points;
    for (int i = 0; i < pieces + 3; ++i) {
      const double y = (*this)(-2, 2), z = (*this)(-2, 2);
      if constexpr (std::is_same_v<typename Curve::Point, typename Curve::Kernel::Point_2>)
        points.emplace_back(0.5 * i, y);
      else
        points.emplace_back(0.5 * i, y, z);
    }
    const std::vector<double> all = uniform_cubic_knots(pieces);
    return Curve(3, {all.begin(), all.end()}, points);
  }

  SC::Bspline_surface_3<K> surface(int pieces)
  {
    std::vector<K::Point_3> points;
    for (int i = 0; i < pieces + 3; ++i)
      for (int j = 0; j < pieces + 3; ++j)
        points.emplace_back(i, j, (*this)(-1, 1));
    return {{3, 3}, uniform_cubic_knots(pieces), uniform_cubic_knots(pieces), points};
  }
};

// The range of the distance holds those of near points, and there is no sample below it.
template <class Located>
void expect_as_near(const Located& located, double distance_at_parameter, double least_sample)
{
  const auto [lower, upper] = located.distance_range();
  EXPECT_LE(upper - lower, 5e-13 * (1 + upper));
  EXPECT_LE(lower, least_sample + 1e-12);
  EXPECT_NEAR(distance_at_parameter, upper, 1e-12);
  EXPECT_TRUE(located.is_unique());
}

TEST(Curve_locator, AgainstSamples)
{
  Random random(1);
  const auto curve = random.curve<SC::Bspline_curve_3<K>>(20);
  const SC::Curve_locator locator(curve);
  std::vector<K::Point_3> samples;
  for (int i = 0; i <= 400; ++i)
    samples.push_back(curve(20.0 * i / 400));
  for (int round = 0; round < 300; ++round) {
    const K::Point_3 p(random(-1, 12), random(-3, 3), random(-3, 3));
    const auto located = locator.closest_point(p);
    double least = std::numeric_limits<double>::infinity();
    for (const K::Point_3& q : samples)
      least = std::fmin(least, std::sqrt(CGAL::squared_distance(p, q)));
    expect_as_near(located, std::sqrt(CGAL::squared_distance(p, curve(located.parameter()))), least);
    EXPECT_NEAR(std::sqrt(CGAL::squared_distance(curve(located.parameter()), located.point())), 0, 1e-12);
    EXPECT_LE(located.parameter_range().first, located.parameter());
    EXPECT_LE(located.parameter(), located.parameter_range().second);
  }
}

TEST(Surface_locator, AgainstSamples)
{
  Random random(2);
  const auto surface = random.surface(4);
  const SC::Surface_locator_3 locator(surface);
  std::vector<K::Point_3> samples;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j)
      samples.push_back(surface(i / 10.0, j / 10.0));
  for (int round = 0; round < 200; ++round) {
    const K::Point_3 p(random(-1, 8), random(-1, 8), random(-4, 4));
    const auto located = locator.closest_point(p);
    double least = std::numeric_limits<double>::infinity();
    for (const K::Point_3& q : samples)
      least = std::fmin(least, std::sqrt(CGAL::squared_distance(p, q)));
    expect_as_near(located, std::sqrt(CGAL::squared_distance(p, surface(located.parameter(0), located.parameter(1)))),
                   least);
  }
}

// A locator stands for its curve or surface.
TEST(Locators, AreOperands)
{
  Random random(3);
  const auto first = random.curve<SC::Bspline_curve_3<K>>(5), second = random.curve<SC::Bspline_curve_3<K>>(7);
  const auto surface = random.surface(2);
  const SC::Curve_locator a(first), b(second);
  const SC::Surface_locator_3 s(surface);
  const K::Point_3 p(1, 2, 3);
  const auto expect_same = [](const auto& x, const auto& y) {
    ASSERT_EQ(x.size(), y.size());
    ASSERT_GT(x.size(), 0u);
    for (std::size_t i = 0; i < x.size(); ++i) {
      EXPECT_EQ(x[i].squared_distance_range(), y[i].squared_distance_range());
      EXPECT_EQ(x[i].parameter(1), y[i].parameter(1));
    }
  };
  expect_same(SC::closest_points(p, a), SC::closest_points(p, first));
  expect_same(SC::closest_points(a, b), SC::closest_points(first, second));
  expect_same(SC::closest_points(p, s), SC::closest_points(p, surface));
  expect_same(SC::projections(p, a), SC::projections(p, first));
  expect_same(SC::projections(p, s), SC::projections(p, surface));
  EXPECT_EQ(SC::distance_range(p, a), SC::distance_range(p, first));
}

// Points of which doubles tell the distance, but not where it is: the centre of a circle, and one on the curve.
TEST(Curve_locator, ManyNearestPoints)
{
  const auto circle = SC::circle_curve(K::Point_2(1, 1), 2.0);
  const SC::Curve_locator locator(circle);
  const auto at_centre = locator.closest_point(K::Point_2(1, 1));
  EXPECT_FALSE(at_centre.is_unique());
  EXPECT_LE(at_centre.distance_range().first, 2);
  EXPECT_GE(at_centre.distance_range().second, 2);
  EXPECT_LE(at_centre.distance_range().second - at_centre.distance_range().first, 1e-12);
  const auto on_circle = locator.closest_point(K::Point_2(3, 1));
  EXPECT_EQ(on_circle.distance_range().first, 0);
  EXPECT_LE(on_circle.distance_range().second, 1e-7);
  EXPECT_NEAR(on_circle.point().x(), 3, 1e-7);
}

TEST(Curve_locator, ExactKernel)
{
  using Exact = CGAL::Exact_predicates_exact_constructions_kernel;
  Random random(4);
  const auto curve = random.curve<SC::Bspline_curve_2<Exact>>(6);
  const SC::Curve_locator locator(curve);
  for (int round = 0; round < 20; ++round) {
    const Exact::Point_2 p(Exact::FT(round) / 3, Exact::FT(2 * round - 20) / 7);
    const auto located = locator.closest_point(p);
    const auto all = SC::closest_points(p, curve);
    EXPECT_LE(located.distance_range().first, all.distance_range().second);
    EXPECT_LE(all.distance_range().first, located.distance_range().second);
    EXPECT_TRUE(located.is_unique());
  }
}

TEST(Locators, BadInput)
{
  Random random(5);
  const SC::Curve_locator locator(random.curve<SC::Bspline_curve_3<K>>(3));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(locator.closest_point(K::Point_3(nan, 0, 0)), SC::Invalid_input);
  EXPECT_THROW(locator.closest_point(K::Point_3(0, infinity, 0)), SC::Invalid_input);
}

// The first one of all intersections, which are ordered along the ray.
template <class Ray, class Locator, class Spline>
bool compare_first(const Ray& ray, const Locator& locator, const Spline& spline)
{
  const auto all = SC::intersections(ray, spline);
  const auto first = locator.first_intersection(ray);
  EXPECT_EQ(first.has_value(), !all.empty());
  if (!first || all.empty())
    return false;
  const auto meet = [](const auto& a, const std::pair<double, double>& b) {
    return a.first <= SC::Exact_rational(b.second) && SC::Exact_rational(b.first) <= a.second;
  };
  EXPECT_TRUE(meet(all[0].parameter_range(0), first->ray_range()));
  EXPECT_TRUE(meet(all[0].parameter_range(1), first->parameter_range()));
  EXPECT_NEAR(std::sqrt(CGAL::to_double(CGAL::squared_distance(first->point(), all[0].point()))), 0, 1e-10);
  EXPECT_EQ(first->kind(), SC::Intersection_kind::TRANSVERSAL);
  return true;
}

TEST(Locators, FirstIntersections)
{
  Random random(6);
  const auto curve = random.curve<SC::Bspline_curve_2<K>>(8);
  const SC::Curve_locator plane(curve);
  int hits = 0;
  for (int round = 0; round < 100; ++round) {
    const K::Point_2 p(random(-1, 6), random(-3, 3)), q(random(-1, 6), random(-3, 3));
    hits += compare_first(K::Ray_2(p, q), plane, curve);
  }
  EXPECT_GT(hits, 40);
  const auto surface = random.surface(3);
  const SC::Surface_locator_3 space(surface);
  int surface_hits = 0;
  for (int round = 0; round < 60; ++round) {
    const K::Point_3 p(random(0, 5), random(0, 5), random(-3, 3)), q(random(0, 5), random(0, 5), random(-1, 1));
    surface_hits += compare_first(K::Ray_3(p, q), space, surface);
  }
  EXPECT_GT(surface_hits, 20);
}

// A ray through a corner of four pieces, one that touches, and one along an axis.
TEST(Locators, SpecialRays)
{
  const SC::Bspline_surface_3<K> tent(
      {1, 1}, {0, 0, 1, 2, 2}, {0, 0, 1, 2, 2},
      {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 1}, {1, 2, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}});
  const SC::Surface_locator_3 locator(tent);
  const auto at_top = locator.first_intersection(K::Ray_3({1, 1, 3}, K::Point_3(1, 1, 0)));
  ASSERT_TRUE(at_top);
  EXPECT_NEAR(at_top->point().z(), 1, 1e-12);
  EXPECT_FALSE(locator.first_intersection(K::Ray_3({1, 1, 3}, K::Point_3(1, 1, 4))));
  const SC::Bspline_curve_2<K> parabola(2, {0, 0, 0, 1, 1, 1}, {{-1, 1}, {0, -1}, {1, 1}});
  const SC::Curve_locator curve(parabola);
  const auto touch = curve.first_intersection(K::Ray_2({-2, 0}, K::Point_2(-1, 0)));
  ASSERT_TRUE(touch);
  EXPECT_EQ(touch->kind(), SC::Intersection_kind::TANGENT);
  EXPECT_EQ(touch->point(), K::Point_2(0, 0));
  const auto axis = curve.first_intersection(K::Ray_2({0.25, -3}, K::Point_2(0.25, -2)));
  ASSERT_TRUE(axis);
  EXPECT_NEAR(axis->ray_range().first, 3.0625, 1e-12);
}

} // namespace locators_test
