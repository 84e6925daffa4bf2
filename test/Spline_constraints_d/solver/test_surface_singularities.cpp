// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Singular points and curves of surfaces of solutions: cones, nodes, points where surfaces touch, isolated ones, with
// the disks that end in each; surfaces that nearly have such points; singular curves, which stay undecided in a short
// time.

#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include "surface_test_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace surface_singularities_test {

namespace SC = CGAL::Spline_constraints;
using SC::Power_polynomial;
using Rational = SC::Exact_rational;
using surface_test_checks::check_complex, surface_test_checks::Counts, surface_test_checks::counts,
    surface_test_checks::counts_of, surface_test_checks::cube, surface_test_checks::number,
    surface_test_checks::rotated, surface_test_checks::square, surface_test_checks::system,
    surface_test_checks::variable;

namespace {

const Power_polynomial x = variable(0), y = variable(1), z = variable(2);

Power_polynomial ratio(int p, int q) { return number(Rational(p) / q); }

// Of radius 1.
Power_polynomial sphere_at(const Power_polynomial& a, const Power_polynomial& b, const Power_polynomial& c)
{
  return square(x - a) + square(y - b) + square(z - c) - number(1);
}

// How many disks end in each singular point of a complete answer, and that they do.
std::vector<std::size_t> disks_at_points(const SC::Surface_solution_set_d& set)
{
  EXPECT_TRUE(set.is_complete()) << set;
  check_complex(set);
  std::map<std::size_t, std::size_t> disks;
  for (const std::size_t i : set.singular_points())
    disks[i] = 0;
  for (const SC::Surface_patch& patch : set.patches()) {
    if (!patch.apex)
      continue;
    ++disks.at(*patch.apex);
    for (std::size_t j = 0; j < 3; ++j) {
      const auto& [least, most] = set.vertices()[*patch.apex].box[j];
      const auto& [lower, upper] = set.system().domain(static_cast<int>(j));
      EXPECT_TRUE(patch.box[j].first < least || (least == lower && most == lower));
      EXPECT_TRUE(most < patch.box[j].second || (least == upper && most == upper));
    }
    for (const SC::Surface_patch::Side& side : patch.boundary) {
      const SC::Surface_arc& arc = set.arcs()[side.arc];
      const auto& value = arc.box[arc.plane].first;
      EXPECT_TRUE(value == patch.box[arc.plane].first || value == patch.box[arc.plane].second);
    }
  }
  std::vector<std::size_t> result;
  for (const auto& [vertex, count] : disks)
    result.push_back(count);
  return result;
}

} // namespace

TEST(Surface_singularities, cones)
{
  const SC::Surface_solution_set_d cone =
      SC::solve_surfaces(system({{-2, 2}, {-2, 2}, {-1, 1}}, {square(x) + square(y) - square(z)}));
  EXPECT_EQ(disks_at_points(cone), (std::vector<std::size_t>{2}));
  EXPECT_EQ(counts_of(cone), (Counts{{1, 1}, {1, 1}}));
  EXPECT_EQ(cone.vertices()[cone.singular_points()[0]].point(), (std::vector<double>{0, 0, 0}));
  std::mt19937 random(7);
  for (int k = 0; k < 3; ++k) {
    const auto [a, b, c] = rotated(random);
    const SC::Surface_solution_set_d set = SC::solve_surfaces(
        system(cube(2), {square(a - ratio(1, 3)) + number(2) * square(b + ratio(1, 7)) - square(c - ratio(k, 5))}));
    EXPECT_EQ(disks_at_points(set), (std::vector<std::size_t>{2}));
    EXPECT_EQ(set.surfaces().size(), 2u);
  }
}

// Each node has an irrational coordinate.
TEST(Surface_singularities, nodes_of_a_cubic)
{
  const SC::Surface_solution_set_d set = SC::solve_surfaces(
      system(cube(3), {square(x) + square(y) - square(x) * z + square(y) * z + square(z) - number(1)}));
  EXPECT_EQ(disks_at_points(set), std::vector<std::size_t>(4, 2));
  EXPECT_EQ(counts_of(set), (Counts{{1, 1}, {1, 1}, {1, 1}, {1, 1}, {2, 0}}));
  std::set<std::array<int, 3>> places; // in units of the square root of two, and of one
  for (const std::size_t i : set.singular_points()) {
    const std::vector<double> point = set.vertices()[i].point();
    std::array<int, 3> rounded;
    for (std::size_t j = 0; j < 3; ++j) {
      const double unit = j < 2 ? std::sqrt(2.0) : 1;
      rounded[j] = static_cast<int>(std::lround(point[j] / unit));
      EXPECT_NEAR(point[j], rounded[j] * unit, 1e-14);
    }
    places.insert(rounded);
  }
  EXPECT_EQ(places, (std::set<std::array<int, 3>>{{1, 0, 1}, {-1, 0, 1}, {0, 1, -1}, {0, -1, -1}}));
}

// Inequalities that hold around a singular point are further unknowns that depend on those in space there.
TEST(Surface_singularities, inequalities_that_hold_there)
{
  std::mt19937 random(11);
  for (int k = 0; k < 3; ++k) {
    const auto [a, b, c] = rotated(random);
    SC::Constraint_system_d cone = system(cube(2), {square(a) + number(2) * square(b) - square(c)});
    cone.add(number(2) - square(x) - square(y) - square(z), SC::Relation::GREATER_EQUAL);
    const SC::Surface_solution_set_d both = SC::solve_surfaces(cone);
    EXPECT_EQ(disks_at_points(both), (std::vector<std::size_t>{2}));
    EXPECT_EQ(counts_of(both), (Counts{{1, 1}, {1, 1}}));
    cone.add(c - number(1) - a * b, SC::Relation::LESS);
    EXPECT_EQ(counts_of(SC::solve_surfaces(cone)), (Counts{{1, 1}, {1, 1}}));
    cone.add(a + number(3) * c, SC::Relation::GREATER); // it is left out
    EXPECT_TRUE(SC::solve_surfaces(cone).singular_points().empty());
  }
  // two of four nodes are allowed
  SC::Constraint_system_d cubic =
      system(cube(3), {square(x) + square(y) - square(x) * z + square(y) * z + square(z) - number(1)});
  cubic.add(x - y, SC::Relation::GREATER_EQUAL);
  cubic.add(square(x) + square(y) + square(z) - number(9), SC::Relation::LESS_EQUAL);
  EXPECT_EQ(disks_at_points(SC::solve_surfaces(cubic)), std::vector<std::size_t>(2, 2));
}

// The same surface with an unknown for a part of its equality.
TEST(Surface_singularities, unknowns_that_equalities_give)
{
  const Power_polynomial w = variable(3);
  const SC::Surface_solution_set_d set = SC::solve_surfaces(
      system({{-1, 1}, {-1, 1}, {-1, 1}, {-2, 2}}, {square(x) + square(y) - square(z), w - x * y - z * square(z)}));
  EXPECT_EQ(disks_at_points(set), (std::vector<std::size_t>{2}));
  EXPECT_EQ(counts_of(set), (Counts{{1, 1}, {1, 1}}));
}

// The apex is on a face of the domain, or of an inequality, which has no other solution near it.
TEST(Surface_singularities, apex_on_a_face)
{
  const auto one_point = [](const SC::Surface_solution_set_d& set) {
    return set.is_complete() && set.surfaces().empty() && set.points().size() == 1;
  };
  const Power_polynomial cone = square(x) + square(y) - square(z), cusp = square(x) + square(y) - z * square(z);
  for (const Power_polynomial& f : {cone, cusp}) {
    const SC::Surface_solution_set_d half = SC::solve_surfaces(system({{-2, 2}, {-2, 2}, {0, 1}}, {f}));
    EXPECT_EQ(disks_at_points(half), (std::vector<std::size_t>{1}));
    EXPECT_EQ(counts_of(half), (Counts{{1, 1}}));
  }
  EXPECT_TRUE(one_point(SC::solve_surfaces(system({{-2, 2}, {-2, 2}, {-1, 0}}, {cusp}))));
  for (int k = 0; k < 3; ++k) {
    const Power_polynomial p = x - ratio(k, 3), q = y + ratio(1, 7), r = z - ratio(k, 5);
    const auto solved = [&](const Power_polynomial& positive) {
      SC::Constraint_system_d result = system(cube(2), {square(p) + number(2) * square(q) - square(r)});
      result.add(positive, SC::Relation::GREATER_EQUAL);
      return SC::solve_surfaces(result);
    };
    const SC::Surface_solution_set_d half = solved(number(3) * r - p - square(q));
    EXPECT_EQ(disks_at_points(half), (std::vector<std::size_t>{1}));
    EXPECT_EQ(counts_of(half), (Counts{{1, 1}}));
    const SC::Surface_solution_set_d apex = solved(square(r) - number(4) * (square(p) + square(q)));
    ASSERT_TRUE(one_point(apex));
    EXPECT_EQ(apex.vertices()[apex.points()[0]].box[2].first, Rational(k) / 5);
  }
}

// Faces of the domain, and of inequalities, that cross cones in lines through the apex: disks have a corner there.
TEST(Surface_singularities, faces_through_apexes)
{
  const Power_polynomial cone = square(x) + square(y) - square(z);
  const Counts two{{1, 1}, {1, 1}};
  for (const Rational& least : {Rational(0), Rational(-2)}) { // a half and a quarter, of both sides
    const SC::Surface_solution_set_d part = SC::solve_surfaces(system({{0, 2}, {least, 2}, {-1, 1}}, {cone}));
    EXPECT_EQ(disks_at_points(part), (std::vector<std::size_t>{2}));
    EXPECT_EQ(counts_of(part), two);
    ASSERT_EQ(part.singular_points().size(), 1u);
    EXPECT_EQ(part.vertices()[part.singular_points()[0]].point(), (std::vector<double>{0, 0, 0}));
  }
  const auto solved = [&](const Power_polynomial& f, const Power_polynomial& positive) {
    SC::Constraint_system_d result = system({{-2, 2}, {-2, 2}, {-1, 1}}, {f});
    result.add(positive, SC::Relation::GREATER_EQUAL);
    return SC::solve_surfaces(result);
  };
  for (const Power_polynomial& positive : {x, number(3) * x + number(2) * y, x - ratio(1, 2) * z, x - square(y)}) {
    const SC::Surface_solution_set_d part = solved(cone, positive);
    EXPECT_EQ(disks_at_points(part), (std::vector<std::size_t>{2}));
    EXPECT_EQ(counts_of(part), two);
  }
  const Power_polynomial ball = square(x) + square(y) + square(z) - x; // has a part of each side, up to the apex
  const SC::Surface_solution_set_d outside = solved(cone, ball), inside = solved(cone, -ball);
  EXPECT_EQ(disks_at_points(outside), (std::vector<std::size_t>{2}));
  EXPECT_EQ(counts_of(outside), (Counts{{0, 2}, {0, 2}}));
  EXPECT_EQ(disks_at_points(inside), (std::vector<std::size_t>{2}));
  EXPECT_EQ(counts_of(inside), two);
  std::mt19937 random(5);
  for (int k = 0; k < 3; ++k) {
    const auto [a, b, c] = rotated(random);
    const SC::Surface_solution_set_d part =
        solved(square(a) + number(2) * square(b) - square(c) + ratio(k, 5) * a * b * c, a + ratio(1, 3) * c);
    EXPECT_EQ(disks_at_points(part), (std::vector<std::size_t>{2})) << k;
  }
}

TEST(Surface_singularities, isolated_points)
{
  const SC::Surface_solution_set_d set = SC::solve_surfaces(
      system(cube(1), {square(x - ratio(1, 3)) + number(3) * square(y - ratio(1, 7)) + square(z - x * y)}));
  EXPECT_TRUE(set.is_complete());
  EXPECT_TRUE(set.surfaces().empty());
  EXPECT_TRUE(set.singular_points().empty());
  ASSERT_EQ(set.points().size(), 1u);
  EXPECT_TRUE(set.vertices()[set.points()[0]].is_singular);
  EXPECT_EQ(set.vertices()[set.points()[0]].box[0].first, Rational(1) / 3);
  EXPECT_EQ(set.vertices()[set.points()[0]].box[2].first, Rational(1) / 21);
}

TEST(Surface_singularities, touching_spheres)
{
  for (const auto& [a, b, c] :
       {std::array{number(2), number(0), number(0)}, std::array{ratio(2, 3), ratio(4, 3), ratio(4, 3)}}) {
    const SC::Surface_solution_set_d set =
        SC::solve_surfaces(system(cube(4), {sphere_at(number(0), number(0), number(0)) * sphere_at(a, b, c)}));
    EXPECT_EQ(disks_at_points(set), (std::vector<std::size_t>{2}));
    EXPECT_EQ(counts_of(set), (Counts{{2, 0}, {2, 0}}));
    const SC::Curve_vertex& vertex = set.vertices()[set.singular_points()[0]];
    for (int j = 0; j < 3; ++j)
      EXPECT_EQ(vertex.box[j].first + vertex.box[j].first, (std::array{a, b, c}[j].constant_term()));
  }
}

// Joined by a neck, or parted.
TEST(Surface_singularities, cones_that_are_hyperboloids)
{
  for (const int sign : {-1, 1}) {
    const Power_polynomial e = number(Rational(sign) / 1000000000);
    EXPECT_EQ(counts(system(cube(2), {square(x) + square(y) - square(z) + e})),
              sign < 0 ? (Counts{{0, 2}}) : (Counts{{1, 1}, {1, 1}}));
  }
}

// Second derivatives of rank 2, 1 and 0.
TEST(Surface_singularities, degenerate_points)
{
  const auto solved = [](const Power_polynomial& f) { return SC::solve_surfaces(system(cube(1), {f})); };
  const SC::Surface_solution_set_d cusp = solved(square(x) + square(y) - z * square(z)),
                                   ding_dong = solved(square(x) + square(y) - square(z) * (ratio(1, 2) - z)),
                                   tacnode = solved(square(x) + square(y) - square(square(z))),
                                   three_sectors = solved(square(x) + y * square(y) - y * square(z)),
                                   monkey_saddle = solved(z * square(z) - x * square(x) + number(3) * x * square(y) +
                                                          ratio(1, 2) * square(square(x)));
  EXPECT_EQ(disks_at_points(cusp), (std::vector<std::size_t>{1}));
  EXPECT_EQ(counts_of(cusp), (Counts{{1, 1}}));
  EXPECT_EQ(disks_at_points(ding_dong), (std::vector<std::size_t>{2}));
  EXPECT_EQ(counts_of(ding_dong), (Counts{{1, 1}, {2, 0}}));
  EXPECT_EQ(disks_at_points(tacnode), (std::vector<std::size_t>{2}));
  EXPECT_EQ(disks_at_points(three_sectors), (std::vector<std::size_t>{3}));
  EXPECT_EQ(counts_of(three_sectors), (Counts{{1, 1}, {1, 1}, {1, 1}}));
  EXPECT_EQ(disks_at_points(monkey_saddle), (std::vector<std::size_t>{1}));
}

// Surfaces that are singular everywhere.
TEST(Surface_singularities, repeated_factors)
{
  const Power_polynomial sphere = sphere_at(number(0), number(0), number(0));
  EXPECT_EQ(counts(system(cube(2), {square(sphere)})), (Counts{{2, 0}}));
  EXPECT_EQ(counts(system(cube(2), {square(sphere) * sphere * (z - number(Rational(3) / 2))})),
            (Counts{{1, 1}, {2, 0}}));
  EXPECT_EQ(counts(system(cube(2, 4), {square(sphere), variable(3) - x * y})), (Counts{{2, 0}}));
}

// In an answer that is not complete each undecided region has the arcs of surfaces that reach it.
static void expect_open_region(const SC::Surface_solution_set_d& set, std::size_t surfaces)
{
  EXPECT_FALSE(set.is_complete());
  check_complex(set);
  EXPECT_EQ(set.surfaces().size(), surfaces);
  ASSERT_EQ(set.undecided_regions().size(), 1u);
  std::set<std::size_t> open;
  for (const std::size_t a : set.undecided_regions()[0].arcs) {
    EXPECT_EQ(set.arcs()[a].patches, 1);
    open.insert(a);
  }
  for (const SC::Solution_surface& surface : set.surfaces()) {
    EXPECT_TRUE(surface.is_open_ended);
    std::size_t on_region = 0;
    for (const std::vector<std::size_t>& loop : surface.boundary)
      on_region += static_cast<std::size_t>(
          std::count_if(loop.begin(), loop.end(), [&](std::size_t a) { return open.count(a) > 0; }));
    EXPECT_GT(on_region, 0u);
  }
}

// Whitney's umbrella, whose handle is a line; a cone with a plane that it touches along a line.
TEST(Surface_singularities, singular_curves_are_undecided)
{
  expect_open_region(SC::solve_surfaces(system(cube(1), {square(x) - square(y) * z})), 2);
  SC::Constraint_system_d part = system({{-2, 2}, {-2, 2}, {-1, 1}}, {square(x) + square(y) - square(z)});
  part.add(x + z, SC::Relation::GREATER_EQUAL);
  const SC::Surface_solution_set_d set = SC::solve_surfaces(part);
  EXPECT_FALSE(set.is_complete());
  check_complex(set);
  EXPECT_FALSE(set.undecided_regions().empty());
}

} // namespace surface_singularities_test
