// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves and surfaces of solutions found after unknowns were eliminated are those of the system as it is.

#include "curve_test_checks.h"
#include "random_systems.h"

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace elimination_test {

using namespace solver_test;
using Box = SC::Curve_vertex::Exact_box;
using Curves = SC::Curve_solution_set_d;
using Surfaces = SC::Surface_solution_set_d;

// Boxes of pieces of curves.
static std::vector<Box> boxes_of(const Curves& set)
{
  std::vector<Box> result;
  for (const auto& curve : set.curves())
    for (const auto& piece : curve.pieces)
      result.push_back(piece.box);
  for (const std::size_t point : set.points())
    result.push_back(set.vertices()[point].box);
  for (const std::size_t point : set.singular_points())
    result.push_back(set.vertices()[point].box);
  return result;
}

static std::vector<Box> boxes_of(const Surfaces& set)
{
  std::vector<Box> result;
  for (const auto& patch : set.patches())
    result.push_back(patch.box);
  for (const std::size_t point : set.points())
    result.push_back(set.vertices()[point].box);
  return result;
}

template <class Set>
static void expect_vertices_covered(const Set& some, const Set& others)
{
  const std::vector<Box> boxes = boxes_of(others);
  for (const SC::Curve_vertex& vertex : some.vertices())
    EXPECT_TRUE(
        std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) { return SC::internal::touch(vertex.box, box); }));
}

static std::array<std::size_t, 5> counts(const Curves& set)
{
  return {set.number_of_closed_curves(), set.number_of_open_curves(), set.points().size(), set.singular_points().size(),
          ends_on_boundary(set)};
}

// The curves that the system has as it is; returns whether these are complete.
static bool expect_same_curves(const System& system)
{
  const Curves whole = SC::Curve_solver_d<>({.tolerance = 1e-8, .node_limit = 20000})(system);
  if (!whole.is_complete())
    return false;
  const Curves curves = SC::solve_curves(system);
  EXPECT_TRUE(curves.is_complete()) << curves;
  EXPECT_EQ(counts(whole), counts(curves)) << whole << '\n' << curves;
  check_chains(curves);
  expect_vertices_covered(whole, curves);
  expect_vertices_covered(curves, whole);
  for (const SC::Curve_vertex& vertex : curves.vertices())
    for (int j = 0; j < system.dimension(); ++j) {
      EXPECT_LE(system.domain(j).first, vertex.box[j].second);
      EXPECT_LE(vertex.box[j].first, system.domain(j).second);
    }
  for (const auto& curve : curves.curves())
    for (const auto& piece : curve.pieces) {
      EXPECT_EQ(piece.box.size(), static_cast<std::size_t>(system.dimension()));
      for (const std::size_t end : piece.ends)
        EXPECT_TRUE(SC::internal::touch(piece.box, curves.vertices()[end].box));
    }
  return true;
}

static std::vector<std::pair<int, std::size_t>> counts(const Surfaces& set)
{
  std::vector<std::pair<int, std::size_t>> result;
  for (const SC::Solution_surface& surface : set.surfaces())
    result.emplace_back(surface.euler_characteristic, surface.boundary.size());
  std::sort(result.begin(), result.end());
  return result;
}

// Where patches of both are graphs over the same unknowns and share points, they have one orientation. Returns how
// many pairs may.
static std::size_t expect_same_orientations(const Surfaces& a, const Surfaces& b)
{
  std::size_t pairs = 0;
  for (const SC::Surface_patch& p : a.patches())
    for (const SC::Surface_patch& q : b.patches())
      if (p.parameters == q.parameters)
        for (const SC::Surface_patch::Side side : p.boundary) {
          const Box& vertex = a.vertices()[a.arcs()[side.arc].ends[0]].box;
          bool is_inside = true;
          for (std::size_t j = 0; j < vertex.size(); ++j)
            is_inside = is_inside && q.box[j].first <= vertex[j].first && vertex[j].second <= q.box[j].second;
          if (is_inside) {
            ++pairs;
            EXPECT_EQ(p.orientation, q.orientation);
          }
        }
  return pairs;
}

static Polynomial random_linear(Random_numbers& random, const std::vector<Polynomial>& x)
{
  Polynomial result(random.ratio(-3, 3, 7));
  for (const Polynomial& t : x)
    result += t * random.integer(-2, 2);
  return result;
}

// Quadrics and cubics with equalities of degree one, mixed, so that these are combinations.
static System random_system(Random_numbers& random, int n, int equalities, int linear, bool is_inequality)
{
  const auto x = variables(n);
  std::vector<SC::Spline_function> rows;
  Polynomial sum(Rational(-1));
  for (const Polynomial& t : x)
    sum += square(t - random.ratio(-1, 1, 5)) * random.integer(1, 2);
  for (int i = 0; i < equalities; ++i)
    rows.emplace_back(i < linear ? random_linear(random, x)
                          : i == linear
                          ? sum + random_linear(random, x) * random.ratio(0, 1, 3)
                          : random_linear(random, x) * random_linear(random, x) + random_linear(random, x));
  std::vector<System::Domain> domain;
  for (int j = 0; j < n; ++j)
    domain.emplace_back(-random.ratio(1, 12, 5), random.ratio(1, 12, 5));
  System system = mixed_system(random, domain, rows);
  if (is_inequality)
    system.add(random_linear(random, x), Relation::GREATER_EQUAL);
  return system;
}

TEST(Elimination, RandomCurves)
{
  Random_numbers random(5);
  int eliminated = 0, complete = 0, with_curves = 0, cut = 0;
  for (int test = 0; test < 150; ++test) {
    SCOPED_TRACE(test);
    const int n = random.integer(3, 4);
    const System system = random_system(random, n, n - 1, random.integer(1, n - 2), random.chance(30));
    eliminated += SC::internal::elimination_of(system, 1).eliminated.empty() ? 0 : 1;
    if (!expect_same_curves(system))
      continue;
    ++complete;
    const Curves curves = SC::solve_curves(system);
    with_curves += curves.curves().empty() ? 0 : 1;
    cut += curves.number_of_open_curves() > 0 ? 1 : 0;
    if (testing::Test::HasFailure())
      break;
  }
  EXPECT_GT(eliminated, 120);
  EXPECT_GT(complete, 120);
  EXPECT_GT(with_curves, 60);
  EXPECT_GT(cut, 30);
}

TEST(Elimination, RandomSurfaces)
{
  Random_numbers random(6);
  int eliminated = 0, complete = 0, with_surfaces = 0;
  std::size_t pairs = 0;
  for (int test = 0; test < 40; ++test) {
    SCOPED_TRACE(test);
    const System system = random_system(random, 4, 2, 1, false);
    eliminated += SC::internal::elimination_of(system, 2).eliminated.empty() ? 0 : 1;
    const Surfaces whole = SC::Surface_solver_d<>({.tolerance = 1e-8, .node_limit = 50000})(system);
    if (!whole.is_complete())
      continue;
    ++complete;
    const Surfaces surfaces = SC::solve_surfaces(system);
    EXPECT_TRUE(surfaces.is_complete());
    EXPECT_EQ(counts(whole), counts(surfaces)) << whole << '\n' << surfaces;
    EXPECT_EQ(surfaces.dimension(), 4);
    EXPECT_EQ(surfaces.system().dimension(), 4);
    with_surfaces += surfaces.surfaces().empty() ? 0 : 1;
    expect_vertices_covered(whole, surfaces);
    expect_vertices_covered(surfaces, whole);
    pairs += expect_same_orientations(surfaces, whole);
    if (testing::Test::HasFailure())
      break;
  }
  EXPECT_GT(eliminated, 30);
  EXPECT_GT(complete, 30);
  EXPECT_GT(with_surfaces, 15);
  EXPECT_GT(pairs, 100u);
}

// Spheres of three dimensions in four meet in a sphere, without a hundred thousand nodes; and one in five, cut by two
// hyperplanes.
TEST(Elimination, SpheresInMoreDimensions)
{
  const auto x = variables(5);
  Polynomial sphere(Rational(-1)), other(Rational(-1));
  for (int j = 0; j < 4; ++j) {
    sphere += square(x[j]);
    other += square(j == 0 ? x[j] - 1 : x[j]);
  }
  const Surfaces common = SC::solve_surfaces(with_equalities(cube(4, -2, 2), {sphere, other}));
  EXPECT_TRUE(common.is_complete());
  EXPECT_EQ(counts(common), (std::vector<std::pair<int, std::size_t>>{{2, 0}}));
  EXPECT_LT(common.summary().nodes, 2000u);
  for (const SC::Curve_vertex& vertex : common.vertices())
    EXPECT_EQ(vertex.point()[0], 0.5);
  const Surfaces cut = SC::solve_surfaces(with_equalities(
      cube(5, -2, 2), {sphere + square(x[4]), x[0] - x[1] + x[3] - fraction(1, 4), x[0] * 2 - x[4] + x[3] - x[2]}));
  EXPECT_TRUE(cut.is_complete());
  EXPECT_EQ(counts(cut), (std::vector<std::pair<int, std::size_t>>{{2, 0}}));
  EXPECT_LT(cut.summary().nodes, 2000u);
}

// The tip of a cone over a plane: two patches that end in it are graphs over nothing.
TEST(Elimination, TipsOfCones)
{
  const auto x = variables(4);
  const System cone = with_equalities(System({{-2, 2}, {-2, 2}, {-1, 1}, {-9, 9}}),
                                      {square(x[0]) + square(x[1]) - square(x[2]), x[3] - x[0] - x[1] * 2});
  EXPECT_EQ(SC::internal::elimination_of(cone, 2).eliminated.size(), 1u);
  const Surfaces surfaces = SC::solve_surfaces(cone);
  EXPECT_TRUE(surfaces.is_complete()) << surfaces;
  ASSERT_EQ(surfaces.singular_points().size(), 1u);
  EXPECT_EQ(surfaces.vertices()[surfaces.singular_points()[0]].point(), (std::vector<double>{0, 0, 0, 0}));
  std::size_t tips = 0;
  for (const SC::Surface_patch& patch : surfaces.patches()) {
    EXPECT_EQ(patch.box.size(), 4u);
    EXPECT_EQ(patch.orientation == 0, patch.apex.has_value());
    EXPECT_EQ(patch.parameters[0] < 0, patch.apex.has_value());
    tips += patch.apex.has_value() ? 1 : 0;
  }
  EXPECT_EQ(tips, 2u);
}

// A bound on an eliminated unknown that cuts curves, touches them from within or without, or excludes a whole one.
TEST(Elimination, BoundsOfEliminatedUnknowns)
{
  const auto x = variables(3);
  const Polynomial circles = (square(x[0]) + square(x[1]) - 1) * (square(x[0] - 4) + square(x[1]) - 1);
  const Polynomial plane = x[2] - x[0] - x[1] * fraction(3, 4); // on the circles, x2 is in c + [-5/4, 5/4]
  const auto curves = [&](const Rational& lower, const Rational& upper) {
    const System system = with_equalities(System({{-2, 6}, {-3, 3}, {lower, upper}}), {circles, plane});
    EXPECT_EQ(SC::internal::elimination_of(system, 1).eliminated.size(), 1u);
    EXPECT_TRUE(expect_same_curves(system)) << lower << ' ' << upper;
    return SC::solve_curves(system);
  };
  expect_curves(curves(-8, 8), 2, 0);
  expect_curves(curves(-2, 2), 1, 0); // beyond 2 are points of the other one
  expect_curves(curves(3, 8), 0, 1);
  expect_curves(curves(0, 4), 0, 2);
  EXPECT_TRUE(curves(6, 9).vertices().empty());
}

// Unknowns with one other one narrow its domain; those that are constant lie in their domains, or there is nothing.
TEST(Elimination, NarrowedDomains)
{
  const auto x = variables(4);
  const Polynomial circle = square(x[0]) + square(x[1]) - 1;
  for (const auto& [upper, height] : {std::pair(fraction(1, 2), 0), {Rational(3), 0}, {fraction(1, 2), 4}}) {
    const System system = with_equalities(System({{-2, 2}, {-2, 2}, {-3, upper}, {-1, 1}}),
                                          {circle, x[2] - x[0] * 2, x[3] - height * fraction(1, 3)});
    EXPECT_TRUE(expect_same_curves(system));
    const Curves curves = SC::solve_curves(system);
    EXPECT_EQ(curves.curves().size(), height == 0 ? 1u : 0u);
    EXPECT_EQ(curves.number_of_open_curves(), height == 0 && upper == fraction(1, 2) ? 1u : 0u);
  }
}

struct Stopping_visitor
{
  int left;
  void on_progress(double) {}
  bool stop() { return --left < 0; }
};

// At a limit, what is not found is undecided.
TEST(Elimination, Limits)
{
  const auto x = variables(4);
  const std::vector<Polynomial> functions{chebyshev(5, x[0]) + chebyshev(5, x[1]) + chebyshev(4, x[2]),
                                          x[3] - x[0] - x[1]};
  const System surface = with_equalities(System({{-1, 1}, {-1, 1}, {-1, 1}, {-3, 3}}), functions);
  System curve = surface;
  curve.add(x[2] - x[0] * fraction(1, 3), Relation::EQUAL);
  for (int left = 0; left < 12; ++left) {
    Stopping_visitor visitor{left};
    const Curves curves = SC::solve_curves(curve, {.tolerance = 1e-8, .visitor = visitor});
    EXPECT_TRUE(curves.is_complete() || !curves.undecided().empty());
    Stopping_visitor other{left};
    const Surfaces surfaces = SC::solve_surfaces(surface, {.tolerance = 1e-8, .visitor = other});
    EXPECT_TRUE(surfaces.is_complete() || !surfaces.undecided_regions().empty());
    EXPECT_TRUE(left > 0 || (!curves.is_complete() && !surfaces.is_complete()));
  }
  const Curves curves = SC::solve_curves(curve, {.tolerance = 1e-8, .node_limit = 5});
  EXPECT_FALSE(curves.is_complete());
  EXPECT_EQ(curves.summary().why_not, SC::Undecided_reason::NODES);
}

} // namespace elimination_test
