// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Arrangements of curves of solutions: faces by Euler's formula, nodes, nested circles at any precision of chords,
// isolated points, labels.

#include <CGAL/Spline_constraints_d/operations/regions/to_arrangement_2.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace to_arrangement_2_test {

namespace SC = CGAL::Spline_constraints;
using Point = CGAL::Exact_predicates_exact_constructions_kernel::Point_2;
using Rational = SC::Exact_rational;

namespace {

std::size_t vertices_of_degree(const SC::Polyline_arrangement_2& arrangement, std::size_t degree)
{
  std::size_t result = 0;
  for (auto v = arrangement.vertices_begin(); v != arrangement.vertices_end(); ++v)
    result += v->is_isolated() ? degree == 0 : v->degree() == degree;
  return result;
}

// Euler: V - E + F = 1 + C; and every edge has a label that is right.
void expect_arrangement(const SC::Solution_arrangement_2& result, std::size_t faces, std::size_t components,
                        std::size_t nodes)
{
  const SC::Polyline_arrangement_2& a = result.arrangement;
  EXPECT_TRUE(result.is_crossing_free);
  EXPECT_EQ(a.number_of_faces(), faces);
  EXPECT_EQ(a.number_of_vertices() + a.number_of_faces(), a.number_of_edges() + 1 + components);
  EXPECT_EQ(vertices_of_degree(a, 4), nodes);
  for (auto e = a.edges_begin(); e != a.edges_end(); ++e) {
    ASSERT_EQ(e->curve().data().size(), 1u);
    const SC::Chord_label label = *e->curve().data().begin();
    const Point &from = result.polylines[label.curve][label.chord],
                &to = result.polylines[label.curve][label.chord + 1];
    EXPECT_TRUE((e->source()->point() == from && e->target()->point() == to) ||
                (e->source()->point() == to && e->target()->point() == from));
  }
}

SC::Solution_arrangement_2 arrangement_of(const SC::Constraint& equation, double error)
{
  const std::vector<SC::Constraint> constraints{equation};
  const SC::Constraint_system_d system = make_system(constraints);
  const auto set = SC::solve_curves(system);
  EXPECT_TRUE(set.is_complete());
  return SC::to_arrangement(system, set, error);
}

} // namespace

TEST(To_arrangement_2, figure_eight_and_crossing_circles)
{
  auto [x, y] = SC::unknowns({-3, 3}, {-3, 3});
  expect_arrangement(arrangement_of(square(x*x + y*y) == 4 * (x*x - y*y), 1e-2), 3, 1, 1);
  expect_arrangement(arrangement_of((x*x + y*y - 1) * (square(x - 1) + y*y - 1) == 0, 1e-2), 4, 1, 2);
}

TEST(To_arrangement_2, faces_do_not_depend_on_the_chords)
{
  auto [x, y] = SC::unknowns({-3, 3}, {-3, 3});
  // the third one is 0.01 wide, at 0.02 from the second
  const auto rings = (x * x + y * y - 4) * (x * x + y * y - Rational(39, 10)) *
          (square(x - Rational(7, 5)) + square(y - Rational(27, 20)) - Rational(1, 10000)) ==
      0;
  for (const double error : {1e9, 1e-2}) {
    const auto result = arrangement_of(rings, error);
    expect_arrangement(result, 4, 3, 0);
    std::size_t faces_with_a_hole = 0;   // nested, not side by side
    for (auto f = result.arrangement.faces_begin(); f != result.arrangement.faces_end(); ++f)
      faces_with_a_hole += f->number_of_holes() == 1;
    EXPECT_EQ(faces_with_a_hole, 3u);
  }
}

TEST(To_arrangement_2, isolated_points)
{
  auto [x, y] = SC::unknowns({-3, 3}, {-3, 3});
  const auto result = arrangement_of((x*x + y*y - 4) * (square(x - Rational(1, 3)) + y*y) == 0, 1e-2);
  expect_arrangement(result, 2, 2, 0);
  EXPECT_EQ(result.arrangement.number_of_isolated_vertices(), 1u);
}

TEST(To_arrangement_2, polylines)
{
  const std::vector<std::vector<Point>> cross{{{-1, 0}, {1, 0}}, {{0, -1}, {0, 1}, {1, 1}}, {{5, 5}}, {}};
  const SC::Polyline_arrangement_2 arrangement = SC::to_arrangement(cross);
  EXPECT_EQ(arrangement.number_of_vertices(), 7u);
  EXPECT_EQ(arrangement.number_of_edges(), 5u);
  EXPECT_EQ(arrangement.number_of_faces(), 1u);
  EXPECT_EQ(vertices_of_degree(arrangement, 4), 1u);
  EXPECT_EQ(vertices_of_degree(arrangement, 0), 1u);

  const std::vector<std::vector<CGAL::Simple_cartesian<double>::Point_2>> overlap{{{0, 0}, {2, 0}}, {{1, 0}, {3, 0}}},
      bad{{{0, 0}, {1e308 * 10, 0}}};
  const SC::Polyline_arrangement_2 shared = SC::to_arrangement(overlap);
  std::size_t both = 0;
  for (auto e = shared.edges_begin(); e != shared.edges_end(); ++e)
    both += e->curve().data().size() == 2;
  EXPECT_EQ(both, 1u);
  EXPECT_THROW(SC::to_arrangement(bad), SC::Invalid_input);
}

TEST(To_arrangement_2, bad_input)
{
  auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const std::vector<SC::Constraint> constraints{x == y, y == z};
  const SC::Constraint_system_d system = make_system(constraints);
  EXPECT_THROW(SC::to_arrangement(system, SC::solve_curves(system), 0.1), SC::Invalid_input);
}

} // namespace to_arrangement_2_test
