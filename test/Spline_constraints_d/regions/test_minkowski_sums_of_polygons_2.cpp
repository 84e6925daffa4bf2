// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Minkowski sums of random polygons against those of CGAL.

#include "polygon_area.h"

#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/minkowski_sum_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace minkowski_sums_of_polygons_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

// A star-shaped polygon with short coordinates.
CGAL::Polygon_2<K> star(std::mt19937& random, int n)
{
  CGAL::Polygon_2<K> result;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * CGAL_PI * (i + (random() % 512) / 1024.0) / n, length = 1 + (random() % 1024) / 256.0;
    result.push_back(K::Point_2(std::round(1024 * length * std::cos(angle)) / 1024,
                                std::round(1024 * length * std::sin(angle)) / 1024));
  }
  return result;
}

constexpr double most_error = 1e-9;   // of corners, which are rounded

double cross(const K::Vector_2& u, const K::Vector_2& v) { return u.x() * v.y() - u.y() * v.x(); }

bool are_near(const K::Point_2& p, const K::Point_2& q)
{
  return CGAL::squared_distance(p, q) < most_error * most_error;
}

// The points where a boundary turns: there may be others on its sides.
template <class Polygon>
std::vector<K::Point_2> corners(const Polygon& polygon)
{
  std::vector<K::Point_2> points, result;
  for (const auto& p : polygon)
    if (const K::Point_2 q(CGAL::to_double(p.x()), CGAL::to_double(p.y()));
        points.empty() || !are_near(points.back(), q))
      points.push_back(q);
  while (points.size() > 1 && are_near(points.front(), points.back()))
    points.pop_back();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const K::Vector_2 before = points[i] - points[(i + points.size() - 1) % points.size()],
                      after = points[(i + 1) % points.size()] - points[i];
    if (before * after <= 0 ||
        std::abs(cross(before, after)) > most_error * std::sqrt((before + after).squared_length()))
      result.push_back(points[i]);
  }
  return result;
}

// Whether two boundaries have the same corners in the same order; they may begin with different ones.
template <class Polygon, class Other>
bool have_same_corners(const Polygon& polygon, const Other& other)
{
  const auto a = corners(polygon);
  auto b = corners(other);
  if (a.size() != b.size() || a.size() < 3)
    return false;
  for (std::size_t shift = 0; shift < a.size(); ++shift, std::rotate(b.begin(), b.begin() + 1, b.end()))
    if (std::equal(a.begin(), a.end(), b.begin(), are_near))
      return true;
  return false;
}

// Compares the sum with that of CGAL, and returns this.
CGAL::Polygon_with_holes_2<Exact_kernel> expect_sum_of_CGAL(const CGAL::Polygon_2<K>& a, const CGAL::Polygon_2<K>& b)
{
  const auto exact = [](const CGAL::Polygon_2<K>& polygon) {
    CGAL::Polygon_2<Exact_kernel> result;
    for (const auto& p : polygon)
      result.push_back(Exact_kernel::Point_2(p.x(), p.y()));
    return result;
  };
  const auto expected = CGAL::minkowski_sum_2(exact(a), exact(b));
  const auto sum = SC::minkowski_sum(SC::planar_region(a), b);
  EXPECT_TRUE(sum.is_complete());
  const auto polygons = sum.polygons_with_holes(1);
  EXPECT_EQ(polygons.size(), 1u);
  if (polygons.size() == 1) {
    EXPECT_EQ(polygons[0].number_of_holes(), expected.number_of_holes());
    EXPECT_NEAR(area(polygons[0]), area(expected), 1e-9);
    EXPECT_TRUE(have_same_corners(polygons[0].outer_boundary(), expected.outer_boundary()));
    for (const auto& hole : expected.holes())
      EXPECT_EQ(std::count_if(polygons[0].holes_begin(), polygons[0].holes_end(),
                              [&](const auto& found) { return have_same_corners(found, hole); }),
                1);
  }
  return expected;
}

TEST(minkowski_sums_of_polygons_2, random_polygons)
{
  std::mt19937 random(17);
  int sums_with_reflex_corners = 0;
  for (int trial = 0; trial < 12; ++trial)
    sums_with_reflex_corners +=
        !expect_sum_of_CGAL(star(random, 5 + trial), star(random, 3 + trial / 2)).outer_boundary().is_convex();
  EXPECT_GT(sums_with_reflex_corners, 6);
}

// With small integer coordinates many sides are parallel, coincide, or end in others.
TEST(minkowski_sums_of_polygons_2, lattice_polygons)
{
  std::mt19937 random(5);
  const auto lattice_polygon = [&](int n, int size) {
    for (;;) {
      CGAL::Polygon_2<K> result;
      for (int i = 0; i < n; ++i) {
        const double angle = 2 * CGAL_PI * i / n, length = 1 + static_cast<double>(random() % 64) / 64 * size;
        result.push_back(K::Point_2(std::round(length * std::cos(angle)), std::round(length * std::sin(angle))));
      }
      if (std::adjacent_find(result.begin(), result.end()) == result.end() && *result.begin() != *(result.end() - 1) &&
          result.is_simple() && result.is_counterclockwise_oriented())
        return result;
    }
  };
  int reflex = 0;
  for (int trial = 0; trial < 24; ++trial)
    reflex += !expect_sum_of_CGAL(lattice_polygon(5 + trial % 8, 4), lattice_polygon(3 + trial % 5, 2))
                   .outer_boundary()
                   .is_convex();
  EXPECT_GT(reflex, 8);
}

// Comb-like polygons with teeth and gaps of integer width: sides of gaps become the same.
TEST(minkowski_sums_of_polygons_2, combs)
{
  std::mt19937 random(7);
  const auto comb = [&] {
    std::vector<K::Point_2> points;
    double x = 0;
    for (int i = 0; i < 3; ++i) {
      const double top = 2.0 + random() % 3, width = 1.0 + random() % 2, bottom = 1.0 - random() % 2 * 0.5;
      for (const auto& [dx, y] :
           {std::pair(0.0, bottom), std::pair(0.0, top), std::pair(1.0, top), std::pair(1.0, bottom)})
        points.emplace_back(x + dx, y);
      x += 1 + width;
    }
    points.emplace_back(points.back().x(), 0);
    points.emplace_back(0, 0);
    CGAL::Polygon_2<K> result(points.begin(), points.end());
    result.reverse_orientation();
    return result;
  };
  for (int trial = 0; trial < 10; ++trial)
    expect_sum_of_CGAL(comb(), comb());
}

TEST(minkowski_sums_of_polygons_2, hole)
{
  const std::vector<K::Point_2> letter{{0, 0}, {6, 0}, {6.25, 2.5}, {5, 2.5}, {5.125, 1}, {1, 1},
                                       {1, 5}, {5, 5}, {5, 3.5},    {6, 3.5}, {6, 6.5},   {0, 6}},
      triangle{{0, 0}, {0.5, 0.0625}, {0.3125, 1.25}};
  EXPECT_EQ(expect_sum_of_CGAL({letter.begin(), letter.end()}, {triangle.begin(), triangle.end()}).number_of_holes(),
            1u);
}

} // namespace

} // namespace minkowski_sums_of_polygons_2_test
