// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Queries that doubles decide allocate nothing but their answers, once a thread has asked its first one: all
// allocations are counted, so this is a program of its own.

#include "uniform_knots.h"

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/Curve_locator.h>
#include <CGAL/Spline_constraints_d/operations/distances/Surface_locator_3.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <random>
#include <vector>

namespace {

std::size_t allocations = 0;

} // namespace

// Not inline: compilers warn of pairs that do not match.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  ++allocations;
  if (void* result = std::malloc(size))
    return result;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept { std::free(p); }
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace query_allocations_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

// Calls query(random) once before, and many times while allocations are counted.
template <class Query>
std::size_t allocations_of(const Query& query)
{
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i)
    query(random);
  const std::size_t before = allocations;
  for (int i = 0; i < 1000; ++i)
    query(random);
  return allocations - before;
}

TEST(Query_allocations, NoneOfLocators)
{
  std::uniform_real_distribution<> wave(-1, 1), place(0, 8);
  std::mt19937 random(2);
  std::vector<K::Point_3> curve_points, surface_points;
  for (int i = 0; i < 11; ++i) {
    curve_points.emplace_back(i, wave(random), wave(random));
    for (int j = 0; j < 11; ++j)
      surface_points.emplace_back(i, j, wave(random));
  }
  const SC::Curve_locator curve(SC::Bspline_curve_3<K>(3, uniform_cubic_knots(8), curve_points));
  const SC::Surface_locator_3 surface(
      SC::Bspline_surface_3<K>({3, 3}, uniform_cubic_knots(8), uniform_cubic_knots(8), surface_points));
  ASSERT_GT(allocations, 0u);
  std::size_t unique = 0, hits = 0;
  EXPECT_EQ(allocations_of([&](std::mt19937& next) {
              unique += curve.closest_point(K::Point_3(place(next), 3 * wave(next), 3 * wave(next))).is_unique();
            }),
            0u);
  EXPECT_EQ(allocations_of([&](std::mt19937& next) {
              unique += surface.closest_point(K::Point_3(place(next), place(next), 3 * wave(next))).is_unique();
            }),
            0u);
  EXPECT_EQ(unique, 4000u);
  EXPECT_EQ(allocations_of([&](std::mt19937& next) {
              const K::Point_3 from(place(next), place(next), 5), to(place(next), place(next), 0);
              hits += surface.first_intersection(K::Ray_3(from, to)).has_value();
            }),
            0u);
  EXPECT_GT(hits, 500u);
}

using Points_2 = std::vector<K::Point_2>;
using Points_3 = std::vector<K::Point_3>;

// A set of distances is one block of memory.
TEST(Query_allocations, OfDistancesOnlyAnswers)
{
  const auto parabola = SC::bezier_curve(Points_3{{-1, 1, 0}, {0, -1, 0}, {1, 1, 0}}),
             wide = SC::bezier_curve(Points_3{{-2, 4, 0}, {0, -4, 0}, {2, 4, 0}}),
             arch = SC::bezier_curve(Points_3{{-2, -2, 1}, {0, 6, 1}, {2, -2, 1}});
  Points_3 paraboloid; // z = x^2 + 2 y^2
  for (const int i : {-1, 0, 1})
    for (const int j : {-1, 0, 1})
      paraboloid.emplace_back(i, j, (i == 0 ? -1 : 1) + 2 * (j == 0 ? -1 : 1));
  const std::vector<double> knots{0, 0, 0, 1, 1, 1};
  const SC::Bspline_surface_3<K> surface({2, 2}, knots, knots, paraboloid);
  const SC::Curve_locator locator(wide), other_locator(arch);
  std::size_t answers = 0;
  const auto count = [&](const auto& closest) {
    ASSERT_TRUE(closest.is_complete());
    answers += closest.size();
  };
  std::uniform_real_distribution<> place(-1, 1);
  const auto point = [&](std::mt19937& next) { return K::Point_3(place(next), place(next), 2 + place(next)); };
  EXPECT_EQ(allocations_of([&](std::mt19937& next) { count(SC::closest_points(point(next), parabola)); }), 1000u);
  EXPECT_EQ(allocations_of([&](std::mt19937& next) { count(SC::closest_points(point(next), surface)); }), 1000u);
  EXPECT_EQ(allocations_of([&](std::mt19937&) { count(SC::closest_points(wide, arch)); }), 1000u);
  EXPECT_EQ(allocations_of([&](std::mt19937&) { count(SC::closest_points(locator, other_locator)); }), 1000u);
  EXPECT_GE(answers, 8000u);
}

// A set of intersections is one block of memory, or none; in it, a crossing of two curves has two boxes as its proof.
TEST(Query_allocations, OfIntersectionsOnlyAnswers)
{
  std::size_t answers = 0;
  const auto expect = [&](const auto& query, std::size_t boxes) {
    std::vector<std::size_t> sizes;
    sizes.reserve(2000);
    const std::size_t counted = allocations_of([&](std::mt19937& next) {
      const auto found = query(next);
      ASSERT_TRUE(found.is_complete());
      sizes.push_back(found.size());
    });
    std::size_t expected = 0;
    for (std::size_t i = 1000; i < 2000; ++i) { // those that are counted
      expected += sizes[i] == 0 ? 0 : 1 + boxes * sizes[i];
      answers += sizes[i];
    }
    EXPECT_EQ(counted, expected);
  };
  std::uniform_real_distribution<> place(-1, 1);
  const auto point = [&](std::mt19937& next) { return K::Point_2(place(next), place(next)); };
  const auto point_in_space = [&](std::mt19937& next) { return K::Point_3(place(next), place(next), place(next)); };
  const auto cubic = SC::bezier_curve(Points_2{{0, 0}, {1, 2}, {2, -2}, {3, 0}}),
             steep = SC::bezier_curve(Points_2{{-3, -3}, {-1, 15}, {1, -15}, {3, 3}}),
             flat = SC::bezier_curve(Points_2{{-3, -3}, {15, -1}, {-15, 1}, {3, 3}});
  const K::Sphere_3 sphere(K::Point_3(0, 0, 0), 1);
  expect(
      [&](auto& next) {
        return SC::intersections(K::Segment_2(point(next), point(next)), K::Segment_2(point(next), point(next)));
      },
      0);
  expect([&](auto& next) { return SC::intersections(K::Line_3(point_in_space(next), point_in_space(next)), sphere); },
         0);
  expect([&](auto& next) { return SC::intersections(cubic, K::Segment_2(point(next), K::Point_2(3, place(next)))); },
         0);
  expect([&](auto& next) { return SC::intersections(K::Circle_2(point(next), 1), K::Circle_2(point(next), 1)); }, 0);
  expect([&](auto&) { return SC::intersections(steep, flat); }, 2);
  EXPECT_GT(answers, 12000u); // nine of the last ones each time
}

} // namespace query_allocations_test
