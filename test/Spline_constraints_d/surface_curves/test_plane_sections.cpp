// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Plane sections and contour lines: levels of a torus and a sphere, among them those along breaks and poles, height
// fields beside `intersection_curves()`.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/plane_sections.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <random>
#include <sstream>
#include <utility>
#include <vector>

namespace plane_sections_test {

namespace {

const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1);

void expect_sections(const Surface& surface, const Vector& direction, const std::vector<Rational>& levels,
                     const std::vector<std::pair<std::size_t, std::size_t>>& closed_and_open)
{
  const auto sections = SC::plane_sections(surface, direction, levels);
  ASSERT_EQ(sections.size(), levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i) {
    EXPECT_TRUE(sections[i].is_complete()) << i;
    EXPECT_EQ(sections[i].number_of_closed_curves(), closed_and_open[i].first) << i;
    EXPECT_EQ(sections[i].number_of_open_curves(), closed_and_open[i].second) << i;
    for (const SC::Surface_curve& curve : sections[i].curves())
      for (const auto& sample : sections[i].polyline(curve, 1e-2))
        EXPECT_NEAR(CGAL::to_double(direction * (sample.point - CGAL::ORIGIN)), CGAL::to_double(levels[i]), 1e-9) << i;
  }
}

// The heights z over control points of the degrees given, x by halves or thirds of [0,1], y from one value to another.
template <class Height>
Surface height_field(const std::array<int, 2>& degrees, const Point& least, const Point& greatest, const Height& z)
{
  std::vector<Point> points;
  for (int i = 0; i <= degrees[0]; ++i)
    for (int j = 0; j <= degrees[1]; ++j) {
      const Rational s = Rational(i) / degrees[0], t = Rational(j) / degrees[1];
      points.emplace_back(least.x() + s * (greatest.x() - least.x()), least.y() + t * (greatest.y() - least.y()),
                          z(i, j));
    }
  std::array<std::vector<Rational>, 2> knots;
  for (const std::size_t axis : {0, 1})
    for (const int end : {0, 1})
      knots[axis].insert(knots[axis].end(), static_cast<std::size_t>(degrees[axis] + 1), Rational(end));
  return Surface(degrees, knots[0], knots[1], points);
}

void expect_point(const SC::Curve_vertex& vertex, const Rational& u, const Rational& v)
{
  EXPECT_EQ(vertex.box[0], std::pair(u, u));
  EXPECT_EQ(vertex.box[1], std::pair(v, v));
}

} // namespace

// z = y + x^2 on [-1,1] x [0,2] has the height 0 in one point only.
TEST(Plane_sections, a_point_on_the_edge)
{
  constexpr int square[]{1, -1, 1};   // of x, by control points
  const Surface surface =
      height_field({2, 1}, Point(-1, 0, 0), Point(1, 2, 0), [&](int i, int j) { return square[i] + 2 * j; });
  const auto section = SC::plane_sections(surface, Vector(0, 0, 1), {Rational(0)})[0];
  EXPECT_TRUE(section.curves().empty() && section.singular_points().empty());
  ASSERT_EQ(section.points().size(), 1u);
  expect_point(section.points()[0], Rational(1, 2), 0);
  std::ostringstream line;
  line << section;
  EXPECT_TRUE(
      line.str().starts_with("curves: 0 closed, 0 open, 1 points, 0 singular points, 0 undecided; complete: yes"))
      << line.str();
}

// Where edges are lines of the section, each point in which others meet them comes once.
TEST(Plane_sections, points_on_lines)
{
  constexpr int of_y[]{1, -1, 1}, of_x[]{0, 0, 1}, cube[]{0, 0, 0, 1};   // powers by control points; y is in [-1,1]
  const auto expect_one_point = [](const Surface& surface, std::size_t curves, const Rational& u, const Rational& v) {
    const auto section = SC::plane_sections(surface, Vector(0, 0, 1), {Rational(0)})[0];
    EXPECT_TRUE(section.is_complete()) << section;
    EXPECT_EQ(section.curves().size(), curves) << section;
    EXPECT_TRUE(section.points().empty()) << section;
    ASSERT_EQ(section.singular_points().size(), 1u) << section;
    expect_point(section.singular_points()[0], u, v);
  };
  const Point begin(0, -1, 0), end(1, 1, 0);
  // x (x^2 - y^2)
  const auto crossing = [&](int i, int j) -> Rational { return Rational(cube[i]) - Rational(i, 3) * of_y[j]; };
  // x (x + y^2)
  const auto contact = [&](int i, int j) -> Rational { return Rational(of_x[i]) + Rational(i, 2) * of_y[j]; };
  // x y (x + y)
  const auto corner = [&](int i, int j) -> Rational { return Rational(of_x[i] * j + i * of_x[j], 2); };
  expect_one_point(height_field({3, 2}, begin, end, crossing), 3, 0, Rational(1, 2));
  expect_one_point(height_field({2, 2}, begin, end, contact), 1, 0, Rational(1, 2));
  expect_one_point(height_field({2, 2}, Point(0, 0, 0), end, corner), 2, 0, 0);
}

TEST(Plane_sections, torus)
{
  expect_sections(torus, Vector(0, 0, 1), {2, 1, Rational(3, 5), 0, -1}, {{0, 0}, {1, 0}, {2, 0}, {2, 0}, {1, 0}});
  expect_sections(torus, Vector(1, 0, 0), {0, 1, 3, Rational(7, 2), 5}, {{2, 0}, {2, 0}, {1, 0}, {1, 0}, {0, 0}});
  // A plane that touches it at the inner equator, which is a break: a figure of eight, whose crossing is proved or
  // reported.
  const auto touching = SC::plane_sections(torus, Vector(3, 4, 0), {Rational(10)});
  EXPECT_FALSE(touching[0].curves().empty());
  EXPECT_EQ(touching[0].singular_points().size() + touching[0].undecided().size(), 1u);
  EXPECT_EQ(touching[0].is_complete(), touching[0].undecided().empty());
  const auto at_seam = SC::plane_sections(torus, Vector(1, 0, 0), {Rational(2)})[0];   // the crossing is on the seam
  EXPECT_TRUE(at_seam.is_complete()) << at_seam;
  EXPECT_EQ(at_seam.curves().size(), 2u);
  EXPECT_EQ(at_seam.singular_points().size(), 1u);
}

TEST(Plane_sections, sphere)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), 3);
  expect_sections(sphere, Vector(1, 2, 2), {0, 5, 10}, {{1, 0}, {1, 0}, {0, 0}});
  expect_sections(sphere, Vector(0, 0, 1), {0, 1}, {{1, 0}, {1, 0}});
  expect_sections(sphere, Vector(0, 1, 0), {0, 1}, {{0, 2}, {1, 0}});   // two meridians from pole to pole
  expect_sections(sphere, Vector(1, 3, 0), {0}, {{1, 0}});              // through both poles
  EXPECT_TRUE(SC::plane_sections(sphere, Vector(0, 1, 0), {Rational(0)})[0].singular_points().empty());
  const auto at_pole = SC::plane_sections(sphere, Vector(0, 0, 1), {Rational(3)});   // touches
  EXPECT_TRUE(at_pole[0].is_complete() && at_pole[0].curves().empty());
  EXPECT_EQ(at_pole[0].singular_points().size(), 1u);
}

TEST(Plane_sections, as_intersection_curves)
{
  std::mt19937 generator(3);
  std::uniform_int_distribution<int> height(-100, 100);
  std::size_t curves = 0;
  for (int round = 0; round < 6; ++round) {
    std::vector<Point> points;
    for (int i = 0; i < 16; ++i)
      points.emplace_back(i / 4, i % 4, height(generator));
    const Surface surface({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points);
    const std::vector<Rational> levels{-30, 0, Rational(41, 3)};
    const auto sections = SC::plane_sections(surface, Vector(1, 0, 1), levels);
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const auto other = SC::intersection_curves(surface, K::Plane_3(1, 0, 1, -levels[i]));
      EXPECT_TRUE(sections[i].is_complete() && other.is_complete());
      EXPECT_EQ(sections[i].number_of_closed_curves(), other.number_of_closed_curves());
      EXPECT_EQ(sections[i].number_of_open_curves(), other.number_of_open_curves());
      curves += sections[i].curves().size();
    }
  }
  EXPECT_GT(curves, 18u);
}

TEST(Plane_sections, bad_input)
{
  EXPECT_THROW(SC::plane_sections(torus, Vector(0, 0, 0), {Rational(1)}), SC::Invalid_input);
  EXPECT_THROW(SC::plane_sections(torus, Vector(0, 0, 1), {Rational(1)}, {.tolerance = -1}), SC::Invalid_input);
  EXPECT_TRUE(SC::plane_sections(torus, Vector(0, 0, 1), {}).empty());
}

} // namespace plane_sections_test
