// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Queries of locators that doubles decide allocate nothing, once a thread has asked its first one: all allocations are
// counted, so this is a program of its own.

#include "uniform_knots.h"

#include <CGAL/Spline_constraints_d/operations/distances/Curve_locator.h>
#include <CGAL/Spline_constraints_d/operations/distances/Surface_locator_3.h>

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

namespace locator_allocations_test {

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

TEST(Locator_allocations, NoneOfQueries)
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

} // namespace locator_allocations_test
