// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of solutions: numbers of components, open and closed ones, where they end and cross; known curves, planted
// circles in 2, 3 and 4 unknowns, splines with breaks in awkward places.

#include "curve_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace curve_solver_test {

using Rational = SC::Exact_rational;
using SC::Power_polynomial;
using SC::unknowns;

namespace {

struct Circle
{
  Rational x, y, r;
};

// The product of the equations of circles that do not meet.
template <class T>
T circles(const std::vector<Circle>& all, const T& x, const T& y)
{
  T result = T(Rational(1));
  for (const Circle& c : all)
    result = result * (square(x - c.x) + square(y - c.y) - Rational(c.r * c.r));
  return result;
}

} // namespace

TEST(Curve_solver, sphere_and_cylinder)
{
  const auto family = [](const Rational& c) {
    auto [x, y, z] = unknowns({-3, 6}, {-3, 3}, {-3, 3});
    return SC::solve_curves(x * x + y * y + z * z == 4, square(x - c) + y * y == 1);
  };
  expect_curves(family(Rational(1, 2)), 2, 0);
  expect_curves(family(2), 1, 0);
  const auto empty = family(4);
  expect_curves(empty, 0, 0);
  EXPECT_TRUE(empty.points().empty());

  const auto figure_eight = family(1);   // crosses itself at (2,0,0)
  check_chains(figure_eight);
  EXPECT_TRUE(figure_eight.is_complete());
  EXPECT_EQ(figure_eight.number_of_closed_curves(), 0u);
  EXPECT_EQ(figure_eight.number_of_open_curves(), 2u);
  ASSERT_EQ(figure_eight.singular_points().size(), 1u);
  expect_point(figure_eight.vertices()[figure_eight.singular_points()[0]].box, {2, 0, 0});
  for (const SC::Solution_curve& loop : figure_eight.curves()) {
    EXPECT_EQ(loop.vertices().front(), figure_eight.singular_points()[0]);
    EXPECT_EQ(loop.vertices().back(), figure_eight.singular_points()[0]);
  }

  const auto point = family(3);   // touches at (2,0,0)
  EXPECT_TRUE(point.is_complete());
  EXPECT_TRUE(point.curves().empty());
  ASSERT_EQ(point.singular_points().size(), 1u);
  expect_point(point.vertices()[point.singular_points()[0]].box, {2, 0, 0});
}

TEST(Curve_solver, ends_on_the_boundary_of_the_domain)
{
  auto [x, y, z] = unknowns({-3, 3}, {-3, 3}, {0, 3});
  const auto arc = SC::solve_curves(x * x + y * y + z * z == 4, square(x - 2) + y * y == 1);
  expect_curves(arc, 0, 1);
  std::vector<double> heights;
  for (const std::size_t i : {arc.curves()[0].pieces.front().ends[0], arc.curves()[0].pieces.back().ends[1]}) {
    const std::vector<double> end = arc.vertices()[i].point();
    EXPECT_NEAR(end[0], 1.75, 1e-14);
    EXPECT_EQ(end[2], 0);
    heights.push_back(end[1]);
  }
  std::sort(heights.begin(), heights.end());
  EXPECT_NEAR(heights[0], -std::sqrt(15) / 4, 1e-14);
  EXPECT_NEAR(heights[1], std::sqrt(15) / 4, 1e-14);
}

TEST(Curve_solver, product_of_Chebyshev_polynomials)
{
  auto [x, y] = unknowns({-1, 1}, {-1, 1});
  const auto t4 = [](const auto& t) { return 8 * t * t * t * t - 8 * t * t + 1; };
  const auto set = SC::solve_curves(t4(x) * t4(y) == Rational(1, 2));
  expect_curves(set, 5, 8);
  std::multiset<std::string> sides;
  for (const SC::Curve_vertex& vertex : set.vertices())
    if (vertex.is_on_boundary) {
      const std::vector<double> p = vertex.point();
      const int axis = std::abs(p[0]) == 1 ? 0 : 1;
      EXPECT_NEAR(t4(p[1 - axis]), 0.5, 1e-13);
      sides.insert(std::string(1, static_cast<char>('x' + axis)) + (p[axis] > 0 ? "+" : "-"));
    }
  for (const char* side : {"x-", "x+", "y-", "y+"})
    EXPECT_EQ(sides.count(side), 4u) << side;
}

TEST(Curve_solver, products_of_Chebyshev_polynomials_of_high_degree)
{
  // A closed curve around each extreme inside where the product is 1 (or -1), an open one around each of those on the
  // boundary.
  auto [x, y] = unknowns({-1, 1}, {-1, 1});
  const auto twice = [](const SC::Expression& t) { return 2 * square(t) - 1; };   // T_2(T_d) = T_2d
  const auto t8 = [&](const SC::Expression& t) { return twice(twice(twice(t))); };
  expect_curves(SC::solve_curves(t8(x) * t8(y) == Rational(1, 2)), 25, 16);
  expect_curves(SC::solve_curves(twice(t8(x)) * twice(t8(y)) == Rational(1, 2)), 113, 32);
  expect_curves(SC::solve_curves(t8(x) * t8(y) == Rational(-1, 2)), 24, 16);
}

TEST(Curve_solver, curves_cross_at_rational_and_irrational_points)
{
  auto [x, y] = unknowns({-1, 1}, {-1, 1});
  // T3(x) = T4(y): nodes (-1/2, 0), (1/2, +-1/sqrt 2)
  const auto set = SC::solve_curves(4 * x * x * x - 3 * x == 8 * square(square(y)) - 8 * square(y) + 1);
  check_chains(set);
  EXPECT_TRUE(set.is_complete());
  EXPECT_EQ(set.number_of_closed_curves(), 0u);
  EXPECT_EQ(set.number_of_open_curves(), 7u);
  ASSERT_EQ(set.singular_points().size(), 3u);
  for (const std::size_t node : set.singular_points()) {
    const double px = set.vertices()[node].point()[0], py = set.vertices()[node].point()[1];
    EXPECT_NEAR(std::abs(px), 0.5, 1e-14);
    EXPECT_NEAR(std::abs(py), px < 0 ? 0 : std::sqrt(0.5), 1e-14);
  }
}

TEST(Curve_solver, lines_cross_each_other)
{
  std::mt19937 generator(3);
  std::uniform_int_distribution<int> coefficient(-9, 9);
  for (int round = 0; round < 20; ++round) {
    auto [x, y] = unknowns({-40, 41}, {-43, 42});
    // Slopes 1, 2, 3, ... and small offsets: any two cross inside of the domain; no three in a point.
    const int count = 2 + round % 3;
    std::vector<int> offsets;
    SC::Expression product(1);
    for (int i = 0; i < count; ++i) {
      offsets.push_back(coefficient(generator));
      product *= y - (i + 1) * x - offsets[i];
    }
    std::set<Rational> places;
    for (int i = 0; i < count; ++i)
      for (int j = i + 1; j < count; ++j)
        places.insert(Rational(offsets[i] - offsets[j], j - i));
    const std::size_t crossings = static_cast<std::size_t>(count * (count - 1) / 2);
    if (places.size() < crossings)
      continue;
    const auto set = SC::solve_curves(product == 0);
    check_chains(set);
    EXPECT_TRUE(set.is_complete());
    EXPECT_EQ(set.singular_points().size(), crossings);
    EXPECT_EQ(set.number_of_open_curves(), static_cast<std::size_t>(count * count));
    EXPECT_EQ(set.number_of_closed_curves(), 0u);
  }
}

TEST(Curve_solver, circles_cross_and_points_are_isolated)
{
  auto [x, y] = unknowns({-3, 4}, {-3, 3});
  // at (1/2, +-sqrt 7 / 2)
  const auto crossing = SC::solve_curves((square(x) + square(y) - 2) * (square(x - 1) + square(y) - 2) == 0);
  EXPECT_TRUE(crossing.is_complete());
  EXPECT_EQ(crossing.singular_points().size(), 2u);
  EXPECT_EQ(crossing.number_of_open_curves(), 4u);

  const auto folium = SC::solve_curves(x * x * x + y * y * y == 3 * x * y);
  EXPECT_TRUE(folium.is_complete());
  EXPECT_EQ(folium.singular_points().size(), 1u);
  EXPECT_EQ(folium.number_of_open_curves(), 3u);   // the loop and two arms

  const auto isolated = SC::solve_curves(square(x) + square(y) == x * x * x);   // an acnode at the origin
  EXPECT_TRUE(isolated.is_complete());
  ASSERT_EQ(isolated.singular_points().size(), 1u);
  expect_point(isolated.vertices()[isolated.singular_points()[0]].box, {0, 0});
  EXPECT_EQ(isolated.number_of_open_curves(), 1u);
}

TEST(Curve_solver, a_curve_that_touches_the_domain_from_outside)
{
  auto [x, y] = unknowns({-1, 1}, {0, 2});
  const SC::Curve_solution_set_d set = SC::solve_curves(y + x * x == 0);
  ASSERT_EQ(set.points().size(), 1u);
  expect_point(set.vertices()[set.points()[0]].box, {0, 0});
  std::ostringstream line;
  line << set;
  EXPECT_TRUE(
      line.str().starts_with("curves: 0 closed, 0 open, 1 points, 0 singular points, 0 undecided; complete: yes"))
      << line.str();
}

TEST(Curve_solver, corners_and_contacts_with_the_domain)
{
  auto [x, y] = unknowns({-1, 1}, {-1, 1});
  expect_curves(SC::solve_curves(x == y), 0, 1, "diagonal");
  expect_curves(SC::solve_curves(y + 1 == x * x), 0, 1, "parabola that touches the lower side from inside");
  expect_curves(SC::solve_curves(square(x) + square(y) == 1), 1, 0, "circle that touches all sides");
  expect_curves(SC::solve_curves(square(x) + square(y) == 2), 0, 0, "circle through the corners");
  EXPECT_EQ(SC::solve_curves(square(x) + square(y) == 2).points().size(), 4u);
  expect_curves(SC::solve_curves(square(x + 2) + square(y) == 1), 0, 0, "circle that touches a side from outside");
  EXPECT_EQ(SC::solve_curves(square(x + 2) + square(y) == 1).points().size(), 1u);
  expect_curves(SC::solve_curves(x + y == 2), 0, 0, "line through a corner");
  expect_curves(SC::solve_curves(square(x + 1) + square(y + 1) == 4), 0, 1,
                "quarter of a circle from corner to corner");
}

TEST(Curve_solver, small_loops_are_found)
{
  std::mt19937 generator(11);
  std::uniform_int_distribution<int> place(-900, 900);
  for (const Rational& r : {Rational(1, 200), Rational(1, 2000), Rational(1, 2000000)})
    for (int round = 0; round < 10; ++round) {
      auto [x, y] = unknowns({-1, 1}, {-1, 1});
      const Circle circle{Rational(place(generator), 1000), Rational(place(generator), 1000), r};
      expect_curves(SC::solve_curves(circles<SC::Expression>({circle}, x, y) == 0), 1, 0);
    }
  auto [x, y] = unknowns({-2, 2}, {-2, 2});
  expect_curves(SC::solve_curves(circles<SC::Expression>({{0, 0, 1}, {0, 0, Rational(101, 100)}}, x, y) == 0), 2, 0,
                "circles that are nearly one");
}

TEST(Curve_solver, planted_circles)
{
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> coefficient(-4, 4), radius(20, 45);
  std::size_t closed_total = 0, open_total = 0;
  for (int round = 0; round < 60; ++round) {
    // At most one circle in each square of a 3 x 3 grid over [-1.5, 1.5]^2; those in the outer columns may reach over
    // the left or right side at +-1.2, in one arc.
    std::vector<Circle> planted;
    std::size_t closed = 0, open = 0;
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        if (generator() % 4 == 0) {
          planted.push_back({i, j, Rational(radius(generator), 100)});
          const bool reaches_over = i != 0 && planted.back().r > Rational(1, 5);
          closed += !reaches_over;
          open += reaches_over;
        }
    if (planted.empty() || planted.size() > 3)
      continue;
    closed_total += closed;
    open_total += open;
    const std::string what = "round " + std::to_string(round);
    const auto range = std::array<SC::Bound, 2>{SC::Bound(Rational(-6, 5)), SC::Bound(Rational(6, 5))};
    const std::array<SC::Bound, 2> high{SC::Bound(-2), SC::Bound(2)}, wide{SC::Bound(-50), SC::Bound(50)};
    {
      const auto u = unknowns(std::vector{range, high});
      expect_curves(SC::solve_curves(circles<SC::Expression>(planted, u[0], u[1]) == 0), closed, open, what);
    }
    {
      const auto u = unknowns(std::vector{range, high, wide});
      const auto surface =
          coefficient(generator) * u[0] * u[1] + coefficient(generator) * square(u[0]) + coefficient(generator);
      expect_curves(
          SC::solve_curves(circles<SC::Expression>(planted, u[0], u[1]) + (u[2] - surface) == 0, u[2] == surface),
          closed, open, what + " in space");
    }
    if (round % 6 == 0) {
      const auto u = unknowns(std::vector{range, high, wide, wide});
      const auto surface = coefficient(generator) * u[0] * u[1] + coefficient(generator);
      expect_curves(
          SC::solve_curves(circles<SC::Expression>(planted, u[0], u[1]) == 0, u[2] == surface, u[3] + u[2] == u[0]),
          closed, open, what + " in four unknowns");
    }
  }
  EXPECT_GT(closed_total, 10u);
  EXPECT_GT(open_total, 10u);
}

TEST(Curve_solver, breaks_through_any_points_of_a_curve)
{
  // x^2 + y^2 = 1 as a spline whose breaks touch the circle, cross it in its extreme points, and meet in a point of it,
  // (3/5, 4/5).
  const std::vector<Rational> x_breaks{-2, -1, 0, Rational(3, 5), 2},
      y_breaks{-2, Rational(-1, 3), Rational(4, 5), 1, 2};
  SC::Spline_term term{{0, 1}, {2, 2}, {x_breaks, y_breaks}, {}};
  for (std::size_t c = 0; c < 16; ++c)
    term.pieces.push_back({-1, 0, 1, 0, 0, 0, 1, 0, 0});
  SC::Constraint_system_d system({{-2, 2}, {-2, 2}});
  system.add(SC::Spline_function(term), SC::Relation::EQUAL);
  const auto set = SC::solve_curves(system);
  expect_curves(set, 1, 0);
  const auto is_vertex = [&](const Rational& x, const Rational& y) {
    return std::any_of(set.vertices().begin(), set.vertices().end(), [&](const SC::Curve_vertex& v) {
      return v.box[0] == std::pair(x, x) && v.box[1] == std::pair(y, y);
    });
  };
  EXPECT_TRUE(is_vertex(Rational(3, 5), Rational(4, 5)));
  EXPECT_TRUE(is_vertex(0, 1));
}

TEST(Curve_solver, what_is_not_proved_on_a_face_is_not_forgotten)
{
  // The lower side is a line of solutions, from corner to corner: nothing that is said of the corners may stand for all
  // of it.
  auto [x, y] = unknowns({0, 1}, {0, 1});
  const auto set = SC::solve_curves(y * (square(x - Rational(1, 2)) + square(y) + 1) == 0);
  check_chains(set);
  std::size_t pieces_on_side = 0;
  for (const SC::Solution_curve& curve : set.curves())
    pieces_on_side += curve.pieces.size();
  EXPECT_TRUE(!set.is_complete() || pieces_on_side > 0);
  EXPECT_TRUE(!set.curves().empty() || !set.undecided().empty());
}

// On a circle the chords at a point between the ends of a chord differ by half of the arc, wherever it is; those at a
// vertex of the polyline by half of both arcs.
TEST(Curve_solver, polylines_turn_by_small_angles)
{
  auto [x, y] = unknowns({-2, 2}, {-2, 2});
  const std::vector<SC::Constraint> constraints{square(x) + square(y) == 1};
  const SC::Constraint_system_d system = SC::make_system(constraints);
  const auto set = SC::solve_curves(system);
  ASSERT_EQ(set.curves().size(), 1u);
  const std::size_t few = SC::to_polyline(system, set, set.curves()[0], 1).size();
  for (const double angle : {0.1, 0.01}) {
    const auto points = SC::to_polyline(system, set, set.curves()[0], 1, angle);
    EXPECT_GT(points.size(), few);
    EXPECT_GE(points.size(), 1 + 3.14 / angle);   // arcs of no more than twice the angle
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const double ax = points[i][0] - points[i - 1][0], ay = points[i][1] - points[i - 1][1],
                   bx = points[i + 1][0] - points[i][0], by = points[i + 1][1] - points[i][1];
      EXPECT_LE(std::abs(std::atan2(ax * by - ay * bx, ax * bx + ay * by)), 2 * angle * (1 + 1e-9));
    }
  }
  EXPECT_THROW(SC::to_polyline(system, set, set.curves()[0], 1, 0), SC::Invalid_input);
}

TEST(Curve_solver, bad_input)
{
  auto [x, y] = unknowns({-1, 1}, {-1, 1});
  EXPECT_THROW(SC::solve_curves(x * y == 1, x == y), SC::Invalid_input);
  EXPECT_THROW(SC::solve_curves(SC::make_system(std::vector<SC::Constraint>{x == y}), {.tolerance = -1}),
               SC::Invalid_input);
  auto [u, v] = unknowns({0, 0}, {-1, 1});
  EXPECT_THROW(SC::solve_curves(u == v), SC::Invalid_input);
}

TEST(Curve_solver, limits_leave_regions_undecided)
{
  auto [x, y] = unknowns({-2, 2}, {-2, 2});
  const std::vector<SC::Constraint> constraints{x * x + y * y == 1};
  const auto set = SC::solve_curves(SC::make_system(constraints), {.tolerance = 1e-6, .node_limit = 3});
  EXPECT_FALSE(set.is_complete());
  EXPECT_FALSE(set.undecided().empty());
  EXPECT_EQ(set.undecided_regions()[0].reason, SC::Undecided_reason::NODES);
}

} // namespace curve_solver_test
