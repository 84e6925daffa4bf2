// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Crossings of planar Bezier curves in doubles beside those that exact splines give: the same ones, in ranges that hold
// them, and nothing where curves touch or overlap.

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/doubles/Crossing_search.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace crossings_in_doubles {

namespace SC = CGAL::Spline_constraints;
namespace Internal = SC::internal::Intersections;
using K = CGAL::Simple_cartesian<double>;
using Kind = SC::Intersection_kind;
using Points = std::vector<K::Point_2>;

using Solutions = std::optional<std::vector<SC::Solution_d<double>>>;

Solutions crossings(const Points& first, const Points& second, std::size_t most_nodes = 4000)
{
  std::array<std::array<std::vector<double>, 2>, 2> numbers;
  const std::array<const Points*, 2> curves{&first, &second};
  std::array<std::array<std::span<const double>, 2>, 2> coordinates;
  for (const std::size_t k : {0, 1}) {
    for (const K::Point_2& p : *curves[k]) {
      numbers[k][0].push_back(p.x());
      numbers[k][1].push_back(p.y());
    }
    coordinates[k] = {numbers[k][0], numbers[k][1]};
    if (!Internal::Crossing_search::can_search(coordinates[k]))
      return std::nullopt;
  }
  const auto found = Internal::Crossing_search(coordinates[0], coordinates[1])(most_nodes);
  return found ? std::optional(std::vector(found->begin(), found->end())) : std::nullopt;
}

auto exact_intersections(const Points& first, const Points& second)
{
  return Internal::general_intersections<K, 2>(SC::bezier_curve(first), SC::bezier_curve(second),
                                               Internal::Budgeted_solver(SC::Solver_options{}));
}

bool is_inside(const SC::Solution_d<double>& solution)
{
  return std::all_of(solution.box().begin(), solution.box().end(),
                     [](const auto& range) { return 0 < range.first && range.second < 1; });
}

// The number of points inside of both curves.
std::size_t compare(const Points& first, const Points& second, const std::vector<SC::Solution_d<double>>& solutions)
{
  const auto expected = exact_intersections(first, second);
  EXPECT_TRUE(expected.is_complete());
  EXPECT_GE(solutions.size(), expected.size()); // one at an end may be beyond it
  std::size_t result = 0;
  for (const auto& point : expected) {
    EXPECT_EQ(point.multiplicity(), 1);
    const auto holds = [&](const auto& solution) {
      const auto meets = [&](std::size_t k) {
        const auto range = point.parameter_range(k);
        return range.first <= solution[k].second && solution[k].first <= range.second;
      };
      return meets(0) && meets(1);
    };
    EXPECT_EQ(std::count_if(solutions.begin(), solutions.end(), holds), 1);
  }
  for (const auto& solution : solutions) {
    EXPECT_TRUE(solution.is_certified());
    for (const std::size_t k : {0, 1}) {
      EXPECT_LT(solution[k].second - solution[k].first, 1e-12);
      EXPECT_LE(solution.uniqueness_region()[k].first, solution[k].first);
      EXPECT_GE(solution.uniqueness_region()[k].second, solution[k].second);
    }
    result += is_inside(solution);
  }
  const auto is_transversal = [](const auto& point) { return point.kind() == Kind::TRANSVERSAL; };
  EXPECT_EQ(result, static_cast<std::size_t>(std::count_if(expected.begin(), expected.end(), is_transversal)));
  return result;
}

TEST(Crossings_in_doubles, random_curves)
{
  std::mt19937 generator(51);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_int_distribution<int> degree(1, 9);
  std::size_t decided = 0, points = 0;
  constexpr int pairs = 300;
  for (int i = 0; i < pairs; ++i) {
    // at the origin, or a thousand times their size away; and very small or large
    const double place = i % 3 == 0 ? 1000 : 0, size = i % 3 == 1 ? std::ldexp(1.0, 10 * (i % 40) - 200) : 1;
    std::array<Points, 2> curves;
    for (Points& curve : curves)
      for (int k = 0, n = degree(generator); k <= n; ++k) {
        const double x = size * coordinate(generator), y = size * coordinate(generator);
        curve.emplace_back(place + x, y - place);
      }
    if (const Solutions found = crossings(curves[0], curves[1])) {
      ++decided;
      points += compare(curves[0], curves[1], *found);
    }
  }
  EXPECT_GT(decided, pairs * 9 / 10);
  EXPECT_GT(points, 250u);
}

// Common points at binary fractions, which are the ends of many parts.
TEST(Crossings_in_doubles, borders_of_parts)
{
  const Points parabola{{0, 0}, {1, 2}, {2, 0}}, steep{{0.25, -1}, {1.75, 1}, {0.5, 3}};
  std::size_t points = 0;
  for (int k = 1; k < 64; ++k) {
    const double t = k / 64.0, x = 2 * t, y = 4 * t * (1 - t);
    // a cubic through the point of the parabola, in its middle
    const Points cubic{{x - 1, y - 1}, {x - 0.5, y + 0.25}, {x + 0.5, y - 0.25}, {x + 1, y + 1}};
    const Solutions found = crossings(parabola, cubic);
    ASSERT_EQ(found.has_value(), k != 24);   // there the curves have one tangent
    if (!found)
      continue;
    points += compare(parabola, cubic, *found);
    EXPECT_TRUE(std::any_of(found->begin(), found->end(), [&](const auto& solution) {
      return solution[0].first <= t && t <= solution[0].second && solution[1].first <= 0.5 && 0.5 <= solution[1].second;
    }));
  }
  EXPECT_GE(points, 62u);
  ASSERT_TRUE(crossings(parabola, steep));
}

// By however little.
TEST(Crossings_in_doubles, near_contacts)
{
  for (int k = 4; k <= 30; k += 2) {
    const double e = std::ldexp(1.0, -k);
    const Points parabola{{-1, 1}, {0, -1}, {1, 1}};
    const auto arch = [](double height) { return Points{{-1, height - 1}, {0, height + 1}, {1, height - 1}}; };
    for (const double height : {e, -e})
      if (const Solutions found = crossings(parabola, arch(height))) {
        EXPECT_EQ(found->size(), height > 0 ? 2u : 0u);
        compare(parabola, arch(height), *found);
      } else
        EXPECT_GT(k, 20);
  }
}

TEST(Crossings_in_doubles, what_is_not_told)
{
  const Points parabola{{-1, 1}, {0, -1}, {1, 1}}, arch{{-1, -1}, {0, 1}, {1, -1}};
  EXPECT_FALSE(crossings(parabola, arch));                           // a contact
  EXPECT_FALSE(crossings(parabola, parabola));                       // an overlap
  EXPECT_FALSE(crossings(parabola, Points{{0, 0}, {0, 0}, {0, 0}})); // a point
  EXPECT_FALSE(crossings(Points(3, K::Point_2(0, 0)), Points(3, K::Point_2(0, 0))));
  EXPECT_FALSE(crossings({{-1, 0}, {HUGE_VAL, 1}, {1, 0}}, parabola));
  EXPECT_FALSE(crossings({{-1e301, 0}, {0, 1}, {1, 0}}, parabola));
  EXPECT_FALSE(crossings(parabola, {{-1, 0.5}, {0, 0.25}, {1, 0.75}}, 3)); // too many pairs of parts
  EXPECT_FALSE(crossings({{0, 0}}, parabola));
}

} // namespace crossings_in_doubles
