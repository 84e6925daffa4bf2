// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which hole of a Minkowski sum belongs to which part: of circles within circles, also random ones with walls that are
// much thinner than the error of polygons; and that no hole is left out in silence where this is not decided.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/IO/write_WKT.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace parts_of_minkowski_sums_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = Double_cartesian;
using Point = K::Point_2;
using Curve = SC::Bspline_curve_2<K>;
using Curves = std::vector<Curve>;
using Region = SC::Planar_region_2<K>;
using Sum = SC::Minkowski_sum_2<K>;

// A boundary of a region, within another one; outer ones and holes in turn.
struct Nested_circle
{
  Point center;
  double radius;
  std::optional<std::size_t> parent;
  std::size_t depth = 0;

  bool is_hole() const { return depth % 2 == 1; }
  double radius_of_sum(double r) const { return is_hole() ? radius - r : radius + r; }
};

Region region_of(const std::vector<Nested_circle>& circles)
{
  Curves curves;
  for (const Nested_circle& c : circles)
    curves.push_back(SC::circle_curve(c.center, c.radius));
  return SC::planar_region(curves);
}

// Which circle a boundary of the sum with a disk is: all of its points have one distance from the center of that.
std::size_t circle_of(const Sum& sum, std::size_t boundary, const std::vector<Nested_circle>& circles, double r)
{
  std::set<std::size_t> result;
  for (std::size_t c = 0; c < circles.size(); ++c) {
    bool is_same = circles[c].is_hole() == sum.boundaries()[boundary].is_hole;
    for (std::size_t arc = 0; is_same && arc < sum.boundaries()[boundary].arcs.size(); ++arc)
      for (const auto& sample : sum.polyline(boundary, arc, 0.1))
        is_same = is_same &&
            std::abs(std::sqrt(CGAL::squared_distance(sample.point, circles[c].center)) - circles[c].radius_of_sum(r)) <
                1e-12;
    if (is_same)
      result.insert(c);
  }
  EXPECT_EQ(result.size(), 1U);
  return result.empty() ? circles.size() : *result.begin();
}

// Each hole belongs to the circle around it, whatever the error of the polygons is.
void expect_parts(const Sum& sum, const std::vector<Nested_circle>& circles, double r)
{
  EXPECT_TRUE(sum.is_complete());
  ASSERT_EQ(sum.boundaries().size(), circles.size());
  std::vector<std::size_t> circle;
  for (std::size_t b = 0; b < circles.size(); ++b)
    circle.push_back(circle_of(sum, b, circles, r));
  EXPECT_EQ(std::set<std::size_t>(circle.begin(), circle.end()).size(), circles.size());
  std::vector<std::size_t> holes;
  for (std::size_t b = 0; b < circles.size(); ++b) {
    const auto& boundary = sum.boundaries()[b];
    ASSERT_TRUE(boundary.outer);
    ASSERT_LT(*boundary.outer, circles.size());
    EXPECT_EQ(circle[*boundary.outer], boundary.is_hole ? *circles[circle[b]].parent : circle[b]);
    if (!boundary.is_hole)
      holes.push_back(
          static_cast<std::size_t>(std::count_if(circles.begin(), circles.end(), [&](const Nested_circle& c) {
            return c.is_hole() && *c.parent == circle[b];
          })));
  }
  for (const double error : {1e-3, 1.0}) {
    const auto polygons = sum.polygons_with_holes(error);
    ASSERT_EQ(polygons.size(), holes.size());
    for (std::size_t i = 0; i < holes.size(); ++i)
      EXPECT_EQ(polygons[i].number_of_holes(), holes[i]);
    std::ostringstream text;
    SC::IO::write_WKT(text, polygons);
    const std::string written = text.str();
    // one for each ring, each polygon, and all of them
    EXPECT_EQ(std::count(written.begin(), written.end(), '('),
              static_cast<std::ptrdiff_t>(circles.size() + (holes.size() > 1 ? holes.size() + 1 : 1)));
  }
}

TEST(parts_of_minkowski_sums_2, islands)
{
  const double r = 0.25;
  const std::vector<Nested_circle> circles{
      {Point(0, 0), 16, {}, 0},    {Point(-7, 0), 6, 0, 1},     {Point(8, 1), 5, 0, 1}, {Point(-8, 0), 4, 1, 2},
      {Point(-8.5, 0.5), 2, 3, 3}, {Point(-8.5, 0.5), 1, 4, 4}, {Point(9, 2), 2, 2, 2}, {Point(7, -2), 1, 2, 2},
      {Point(40, 3), 4, {}, 0},    {Point(41, 3), 2, 8, 1}};
  expect_parts(SC::minkowski_sum(region_of(circles), SC::planar_region(SC::circle_curve(Point(0, 0), r))), circles, r);
}

// Rings with walls that are thinner than the error of polygons, so that vertices of the hole are outside of the polygon
// around it.
TEST(parts_of_minkowski_sums_2, thin_rings)
{
  for (const double wall : {0x1p-8, 0x1p-11, 0x1p-14}) {
    const double share = 1 - wall;
    const Region ring(Curves{
        SC::circle_curve(Point(0, 0), 13),
        SC::ellipse_curve(Point(0, 0), K::Vector_2(-12 * share, -5 * share), K::Vector_2(5 * share, -12 * share))});
    const Sum sum = SC::minkowski_sum(ring, SC::planar_region(SC::circle_curve(Point(0, 0), wall)));
    EXPECT_TRUE(sum.is_complete());
    ASSERT_EQ(sum.boundaries().size(), 2U);
    const std::size_t outer = sum.boundaries()[0].is_hole ? 1 : 0;
    for (const auto& boundary : sum.boundaries())
      EXPECT_EQ(boundary.outer, outer);
    EXPECT_TRUE(sum.boundaries()[1 - outer].is_hole);
    const auto polygons = sum.polygons_with_holes(1);
    ASSERT_EQ(polygons.size(), 1U);
    EXPECT_EQ(polygons[0].number_of_holes(), 1U);
  }
}

// What is not certain is not guessed: a hole that may be in a boundary belongs to none, and is told.
TEST(parts_of_minkowski_sums_2, holes_that_are_not_decided)
{
  struct Boundary
  {
    bool is_hole;
    std::optional<std::size_t> outer;
  };
  const std::optional<std::size_t> none;
  const CGAL::Uncertain<bool> yes(true), no(false), perhaps = CGAL::Uncertain<bool>::indeterminate();
  std::vector<Boundary> boundaries{{false, 0}, {true, none}, {false, 2}, {true, none}, {true, none}, {true, none}};
  // the island 2 in the hole 1 has the hole 3, and perhaps 4; 5 is in none
  const std::vector<std::vector<CGAL::Uncertain<bool>>> around{
      {no, yes, yes, yes, yes, no}, {no, no, no, no, no, no}, {no, no, no, yes, perhaps, no}};
  const std::vector<std::size_t> undecided = SC::internal::Regions::find_outer_boundaries(
      boundaries, [&](std::size_t b, std::size_t c) { return around[b][c]; });
  EXPECT_EQ(undecided, (std::vector<std::size_t>{4, 5}));
  EXPECT_EQ(boundaries[1].outer, 0U);
  EXPECT_EQ(boundaries[3].outer, 2U);
  EXPECT_EQ(boundaries[4].outer, none);
  EXPECT_EQ(boundaries[5].outer, none);
}

// Within each circle there are one or two others, as near to it as a wall, some of these with others, and so on.
void add_circles_within(std::vector<Nested_circle>& circles, std::size_t parent, double wall, std::mt19937& random)
{
  constexpr std::size_t most_depth = 3, trials = 6;
  std::uniform_real_distribution<double> angle(0, 2 * CGAL_PI), share(0.2, 0.6);
  const Nested_circle around = circles[parent];
  std::vector<std::size_t> children;
  for (std::size_t k = 0; k < trials && around.depth < most_depth && children.size() < 2; ++k) {
    const double radius = around.radius * share(random), a = angle(random), way = around.radius - radius - wall;
    const Nested_circle next{Point(around.center.x() + way * std::cos(a), around.center.y() + way * std::sin(a)),
                             radius, parent, around.depth + 1};
    if (std::any_of(children.begin(), children.end(), [&](std::size_t c) {
          return std::sqrt(CGAL::squared_distance(circles[c].center, next.center)) <
              circles[c].radius + radius + 0.5 * wall;
        }))
      continue;
    children.push_back(circles.size());
    circles.push_back(next);
  }
  for (const std::size_t c : children)
    add_circles_within(circles, c, wall, random);
}

// Circles come as near to those around them as 1e-4.
TEST(parts_of_minkowski_sums_2, thin_walls)
{
  constexpr double wall = 1e-4;
  std::mt19937 random(7);
  std::vector<Nested_circle> circles{{Point(0, 0), 16, {}, 0}};
  add_circles_within(circles, 0, wall, random);
  EXPECT_GT(circles.size(), 6U);
  expect_parts(SC::minkowski_sum(region_of(circles), SC::planar_region(SC::circle_curve(Point(0, 0), wall / 4))),
               circles, wall / 4);
}

} // namespace

} // namespace parts_of_minkowski_sums_2_test
