// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random Minkowski sums and swept areas: beside samples of both boundaries and areas in closed form, and after exact
// rotations and translations.
#include "random_sums_2.h"

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace random_sums_and_motions {

namespace SC = CGAL::Spline_constraints;
using random_sums::Scene;
using random_sums::Scenes;

// Points that samples prove to be inside or outside are. Areas are those of closed forms, up to the error of polygons,
// 0.00001, times the length of the boundary, which is less than 100; and the share of points up to four standard errors
// of fixed ones.
void expect_agreement(const Scene<CGAL::Simple_cartesian<double>>& scene, unsigned seed)
{
  constexpr std::size_t points = 90;
  constexpr int samples = 90;
  const auto sum = scene.result();
  EXPECT_TRUE(sum.is_complete());
  for (const auto& boundary : sum.boundaries())
    EXPECT_TRUE(boundary.is_closed);
  const auto comparison = random_sums::compare(scene, sum, points, samples, seed);
  EXPECT_GT(comparison.inside, points / 5);
  EXPECT_GT(comparison.outside, points / 5);
  EXPECT_LT(comparison.near_boundary, points / 3);
  EXPECT_EQ(comparison.wrong_in_polygons, 0U);
  EXPECT_EQ(comparison.wrong_in_sum, 0U);
  EXPECT_EQ(comparison.uncertain, 0U);
  EXPECT_NEAR(comparison.area, comparison.estimate, 4 * comparison.deviation);
  if (scene.area) {
    EXPECT_NEAR(comparison.area, *scene.area, 1e-3);
  }
}

TEST(RandomSums, SumsOfRegions)
{
  for (unsigned kind = 0; kind < 6; ++kind)
    expect_agreement(Scenes<CGAL::Simple_cartesian<double>>(200 + kind).sum(kind), kind);
}

TEST(RandomSums, SweptAreas)
{
  for (unsigned kind = 0; kind < 6; ++kind)
    expect_agreement(Scenes<CGAL::Simple_cartesian<double>>(300 + kind).sweep(kind), kind);
}

using R = SC::Exact_rational;
using Exact = CGAL::Simple_cartesian<R>;
using Motion = CGAL::Aff_transformation_2<Exact>;

Motion turned(const R& cosine, const R& sine, const R& x, const R& y) { return {cosine, R(-sine), x, sine, cosine, y}; }

Scene<Exact> moved(const Scene<Exact>& scene, const Motion& motion, const Motion& motion_of_other)
{
  Scene<Exact> result{{}, {}, scene.is_sweep};
  for (const auto& curve : scene.region)
    result.region.push_back(curve.transformed(motion));
  for (const auto& curve : scene.other)
    result.other.push_back(curve.transformed(motion_of_other));
  return result;
}

// Where a boundary is cut into arcs depends on bounds of directions, too. What does not is where it changes from one
// pair of curves, or parts of these, to another one, or one of them begins to stand still, as in a corner, or to move.
std::size_t number_of_runs(const SC::Minkowski_sum_2<Exact>::Boundary& boundary)
{
  constexpr double small = 1e-6;
  using Arc = SC::Minkowski_sum_2<Exact>::Arc;
  const auto moves = [](const Arc& arc, std::size_t k) {
    return std::abs(arc.parameters[k][1] - arc.parameters[k][0]) > small;
  };
  const auto goes_on = [&](const Arc& a, const Arc& b) {
    bool result = a.curves == b.curves;
    for (const std::size_t k : {0, 1})
      result = result && moves(a, k) == moves(b, k) && std::abs(a.parameters[k][1] - b.parameters[k][0]) < small;
    return result;
  };
  std::size_t result = 0;
  for (std::size_t i = 0; i < boundary.arcs.size(); ++i)
    result += !goes_on(boundary.arcs[i > 0 ? i - 1 : boundary.arcs.size() - 1], boundary.arcs[i]);
  return result;
}

// Of each boundary whether it is a hole, and its number of runs, in any order.
std::vector<std::pair<bool, std::size_t>> shape(const SC::Minkowski_sum_2<Exact>& sum)
{
  std::vector<std::pair<bool, std::size_t>> result;
  for (const auto& boundary : sum.boundaries())
    result.emplace_back(boundary.is_hole, number_of_runs(boundary));
  std::sort(result.begin(), result.end());
  return result;
}

struct Size
{
  double area = 0, length = 0;
};

Size size(const SC::Minkowski_sum_2<Exact>& sum, double error)
{
  Size result;
  const auto add = [&](const CGAL::Polygon_2<Exact>& polygon) {
    result.area += CGAL::to_double(polygon.area());
    for (const auto& edge : polygon.edges())
      result.length += std::sqrt(CGAL::to_double(edge.squared_length()));
  };
  for (const auto& polygon : sum.polygons_with_holes(error)) {
    add(polygon.outer_boundary());
    for (const auto& hole : polygon.holes())
      add(hole);
  }
  return result;
}

// The same boundaries, and areas up to the error of polygons along the boundary, twice.
void expect_invariance(const Scene<Exact>& scene, unsigned kind)
{
  constexpr double error = 1e-4;
  const R c(3, 5), s(4, 5);
  const auto sum = scene.result(),
             other = (kind % 2 == 0 ? moved(scene, turned(c, s, R(7, 3), R(-2)), turned(c, s, R(0), R(100, 9)))
                                    : moved(scene, turned(R(-s), c, R(0), R(0)), turned(R(-s), c, R(-1, 7), R(5))))
                         .result();
  EXPECT_TRUE(sum.is_complete());
  EXPECT_TRUE(other.is_complete());
  EXPECT_FALSE(sum.boundaries().empty());
  EXPECT_EQ(shape(other), shape(sum));
  const Size before = size(sum, error);
  EXPECT_GT(before.area, 1);
  EXPECT_NEAR(size(other, error).area, before.area, 2 * error * before.length);
}

TEST(RandomSums, SumsAfterMotions)
{
  for (unsigned kind = 0; kind < 6; ++kind)
    expect_invariance(Scenes<Exact>(400 + kind).sum(kind), kind);
}

TEST(RandomSums, SweptAreasAfterMotions)
{
  for (unsigned kind = 0; kind < 6; ++kind)
    expect_invariance(Scenes<Exact>(500 + kind).sweep(kind), kind);
}

} // namespace random_sums_and_motions
