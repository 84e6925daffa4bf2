// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of solutions: their numbers, Euler characteristics and loops against known ones, in the plain position and
// under random rational rotations; cells that are shared by two patches at most; faces that are touched; inequalities;
// splines with breaks; what stays undecided.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include "surface_test_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace surface_solver_test {

namespace SC = CGAL::Spline_constraints;
using SC::Power_polynomial;
using SC::Relation;
using Rational = SC::Exact_rational;
using surface_test_checks::check_complex, surface_test_checks::Counts, surface_test_checks::counts,
    surface_test_checks::counts_of, surface_test_checks::cube, surface_test_checks::number,
    surface_test_checks::rotated, surface_test_checks::square, surface_test_checks::system,
    surface_test_checks::variable;

namespace {

const Power_polynomial x = variable(0), y = variable(1), z = variable(2), w = variable(3);
const Power_polynomial sphere = square(x) + square(y) + square(z) - number(1);

// Around the third axis, with radii 1 and 3/10.
Power_polynomial torus(const Power_polynomial& a, const Power_polynomial& b, const Power_polynomial& c)
{
  const Power_polynomial ring = square(a) + square(b);
  return square(ring + square(c) + number(1) - number(Rational(9) / 100)) - number(4) * ring;
}

Power_polynomial tangle_cube(const Power_polynomial& a, const Power_polynomial& b, const Power_polynomial& c)
{
  Power_polynomial result = number(Rational(59) / 5);
  for (const Power_polynomial& t : {a, b, c})
    result += square(square(t)) - number(5) * square(t);
  return result;
}

Power_polynomial chebyshev(const Power_polynomial& t, int degree)
{
  Power_polynomial before = number(1), last = t;
  for (int k = 1; k < degree; ++k)
    before = std::exchange(last, number(2) * t * last - before);
  return last;
}

} // namespace

TEST(Surface_solver, closed_surfaces)
{
  EXPECT_EQ(counts(system(cube(2), {sphere})), (Counts{{2, 0}}));
  EXPECT_EQ(counts(system(cube(2), {torus(x, y, z)})), (Counts{{0, 0}}));
  EXPECT_EQ(counts(system(cube(3), {tangle_cube(x, y, z)})), (Counts{{-8, 0}}));
  EXPECT_EQ(counts(system(cube(Rational(6) / 5), {chebyshev(x, 6) + chebyshev(y, 6) + chebyshev(z, 6)})),
            (Counts{{-54, 0}}));
  const SC::Surface_solution_set_d genus_5 =
      SC::solve_surfaces(system(cube(Rational(6) / 5), {chebyshev(x, 4) + chebyshev(y, 4) + chebyshev(z, 4)}));
  ASSERT_EQ(genus_5.surfaces().size(), 1u);
  EXPECT_EQ(genus_5.surfaces()[0].genus(), 5);
  EXPECT_TRUE(genus_5.surfaces()[0].is_closed());
  std::ostringstream line;
  line << genus_5;
  EXPECT_EQ(line.str().rfind("surfaces: 1 components, Euler characteristic -8, 0 boundary loops, 0 singular points, 0 "
                             "undecided; complete: yes; nodes ",
                             0),
            0u)
      << line.str();
}

TEST(Surface_solver, random_rotations)
{
  std::mt19937 random(53);
  for (int k = 0; k < 4; ++k) {
    const auto [a, b, c] = rotated(random);
    EXPECT_EQ(counts(system(cube(2), {torus(a, b, c)})), (Counts{{0, 0}}));
    EXPECT_EQ(counts(system(cube(5), {tangle_cube(a, b, c)})), (Counts{{-8, 0}}));
    SC::Constraint_system_d half = system(cube(2), {torus(a, b, c)});
    half.add(c, k % 2 == 0 ? Relation::GREATER_EQUAL : Relation::LESS);
    EXPECT_EQ(counts(half), (Counts{{0, 2}}));
  }
}

TEST(Surface_solver, more_unknowns)
{
  EXPECT_EQ(counts(system(cube(2, 4), {square(x) + square(y) - number(1), square(z) + square(w) - number(1)})),
            (Counts{{0, 0}}));
  const Power_polynomial v = variable(4);
  EXPECT_EQ(counts(system(cube(2, 5),
                          {sphere + square(w) + square(v), x - y + w - number(Rational(1) / 4),
                           number(2) * x - v + w - z + number(Rational(1) / 8)})),
            (Counts{{2, 0}}));
}

TEST(Surface_solver, domain_cuts_surfaces)
{
  EXPECT_EQ(counts(system(cube(Rational(4) / 5), {sphere})), (Counts{{-4, 6}}));
  EXPECT_EQ(counts(system(cube(Rational(3) / 5), {sphere})), Counts(8, {1, 1}));
  EXPECT_EQ(counts(system(cube(1), {z - x * y})), (Counts{{1, 1}})); // through four corners
}

TEST(Surface_solver, domain_touches_surfaces)
{
  EXPECT_EQ(counts(system(cube(1), {sphere})), (Counts{{2, 0}})); // all six faces, from within
  const SC::Surface_solution_set_d outside = SC::solve_surfaces(system({{1, 3}, {-2, 2}, {-2, 2}}, {sphere})),
                                   corner = SC::solve_surfaces(system({{0, 1}, {0, 1}, {0, 1}}, {x + y + z - 3}));
  for (const SC::Surface_solution_set_d* set : {&outside, &corner}) {
    EXPECT_TRUE(set->is_complete());
    EXPECT_TRUE(set->surfaces().empty());
    ASSERT_EQ(set->points().size(), 1u);
  }
  EXPECT_EQ(outside.vertices()[outside.points()[0]].point(), (std::vector<double>{1, 0, 0}));
  EXPECT_EQ(corner.vertices()[corner.points()[0]].point(), (std::vector<double>{1, 1, 1}));
}

// Tangent planes and spheres as inequalities, at rational points, under rotations; faces in four unknowns.
TEST(Surface_solver, inequalities_touch_surfaces)
{
  std::mt19937 random(5);
  for (int k = 0; k < 4; ++k) {
    const auto [a, b, c] = rotated(random);
    const auto solved = [&](const Power_polynomial& positive, const Rational& half_size) {
      SC::Constraint_system_d result = system(cube(half_size), {sphere});
      result.add(positive, Relation::GREATER_EQUAL);
      return SC::solve_surfaces(result);
    };
    for (const Power_polynomial& holds : {number(1) - a, square(a - number(2)) + square(b) + square(c) - number(1)}) {
      const SC::Surface_solution_set_d all = solved(holds, 2), point = solved(-holds, 2);
      EXPECT_TRUE(all.is_complete() && point.is_complete());
      EXPECT_EQ(counts_of(all), (Counts{{2, 0}}));
      EXPECT_TRUE(all.points().empty() && point.surfaces().empty());
      ASSERT_EQ(point.points().size(), 1u);
      const auto& box = point.vertices()[point.points()[0]].box;
      std::vector<Rational> place;
      for (const auto& [lower, upper] : box) {
        EXPECT_EQ(lower, upper);
        place.push_back(lower);
      }
      EXPECT_EQ(a(place), 1);
    }
    EXPECT_EQ(counts_of(solved(number(Rational(1) / 2) - a - b, 1)),
              (Counts{{1, 1}})); // all faces of the cube are touched
  }
  EXPECT_EQ(counts(system({{-2, 2}, {-2, 2}, {-2, 2}, {-1, 1}}, {sphere, w - x})), (Counts{{2, 0}}));
}

TEST(Surface_solver, inequalities_cut_surfaces)
{
  SC::Constraint_system_d ring = system(cube(2), {torus(x, y, z)});
  ring.add(x, Relation::GREATER_EQUAL);
  EXPECT_EQ(counts(ring), (Counts{{0, 2}}));
  ring.add(x - number(3), Relation::LESS); // which holds everywhere
  EXPECT_EQ(SC::solve_surfaces(ring).system().dimension(), 4);
  EXPECT_EQ(counts(ring), (Counts{{0, 2}}));
  // the greatest value of the inequality is on a face of the domain that the surface crosses
  SC::Constraint_system_d cut_by_both = system(cube(Rational(4) / 5), {sphere});
  cut_by_both.add(z, Relation::GREATER_EQUAL);
  EXPECT_EQ(counts(cut_by_both), (Counts{{0, 2}}));
  SC::Constraint_system_d bands = system(cube(2), {sphere});
  bands.add(square(z) - number(Rational(1) / 9), Relation::GREATER);
  EXPECT_EQ(counts(bands), (Counts{{1, 1}, {1, 1}}));
}

TEST(Surface_solver, small_parts_are_found)
{
  const Rational tiny = Rational(1) / 1000000;
  // a ball of radius 1/1000 beside a large one
  const Power_polynomial small = square(x - number(Rational(3) / 2)) + square(y - number(Rational(7) / 5)) + square(z);
  EXPECT_EQ(counts(system(cube(2), {sphere * (small - number(tiny)) - number(tiny * tiny)})), (Counts{{2, 0}, {2, 0}}));
}

// |t|, two lines that meet at zero.
static SC::Spline_function size_of(int unknown)
{
  return SC::Spline_function(
      SC::Spline_term{{unknown}, {1}, {{Rational(-2), Rational(0), Rational(2)}}, {{0, -1}, {0, 1}}});
}

TEST(Surface_solver, splines_with_breaks)
{
  // an octahedron, whose corners lie on edges of cells
  SC::Constraint_system_d octahedron(cube(2));
  octahedron.add(size_of(0) + size_of(1) + size_of(2) + SC::Spline_function(number(-1)), Relation::EQUAL);
  EXPECT_EQ(counts(octahedron), (Counts{{2, 0}}));
}

TEST(Surface_solver, surfaces_that_meet_in_a_point)
{
  // two pyramids, with their tips in the corner of all cells
  SC::Constraint_system_d pyramids({{-2, 2}, {-2, 2}, {-1, 1}});
  pyramids.add(size_of(0) + size_of(1) - size_of(2), Relation::EQUAL);
  EXPECT_EQ(counts(pyramids), (Counts{{1, 1}, {1, 1}}));
  const SC::Surface_solution_set_d set = SC::solve_surfaces(pyramids);
  ASSERT_EQ(set.singular_points().size(), 1u);
  EXPECT_EQ(set.vertices()[set.singular_points()[0]].point(), (std::vector<double>{0, 0, 0}));
  EXPECT_TRUE(set.vertices()[set.singular_points()[0]].is_singular);
}

// Saddles on faces of the domain: boundaries meet themselves, or each other.
TEST(Surface_solver, saddles_on_faces)
{
  const SC::Surface_solution_set_d strip =
      SC::solve_surfaces(system({{Rational(7) / 10, 2}, {-2, 2}, {-2, 2}}, {torus(x, y, z)}));
  const SC::Surface_solution_set_d quarters = SC::solve_surfaces(system({{-1, 1}, {-1, 1}, {0, 1}}, {x * y - z}));
  for (const SC::Surface_solution_set_d* set : {&strip, &quarters}) {
    EXPECT_TRUE(set->is_complete()) << *set;
    check_complex(*set);
    EXPECT_EQ(set->singular_points().size(), 1u);
  }
  EXPECT_EQ(counts_of(strip), (Counts{{1, 1}}));
  EXPECT_EQ(counts_of(quarters), (Counts{{1, 1}, {1, 1}}));
}

// Three unknowns in two equalities, both of which need all: a face is touched along a curve that is not seen. Planes
// keep away from what is not known there, and what is left is right.
TEST(Surface_solver, undecided_faces)
{
  const Power_polynomial ring = square(x) + square(y);
  const SC::Surface_solution_set_d circle = SC::solve_surfaces(
      system({{-2, 2}, {-2, 2}, {0, 2}, {0, 9}}, {ring + w * z - number(1), ring * (number(1) + z) - number(1) - w}));
  EXPECT_FALSE(circle.is_complete());
  EXPECT_FALSE(circle.undecided_regions().empty());
  check_complex(circle);
}

TEST(Surface_solver, limits_and_bad_input)
{
  SC::Solver_options options{.tolerance = 1e-8};
  options.node_limit = 50;
  const SC::Surface_solution_set_d cut_short = SC::solve_surfaces(system(cube(2), {torus(x, y, z)}), options);
  EXPECT_FALSE(cut_short.is_complete());
  ASSERT_FALSE(cut_short.undecided_regions().empty());
  EXPECT_EQ(cut_short.undecided_regions()[0].reason, SC::Undecided_reason::NODES);
  EXPECT_FALSE(SC::solve_surfaces(system(cube(2), {Power_polynomial()})).is_complete());
  EXPECT_THROW(SC::solve_surfaces(system(cube(2), {sphere, x})), SC::Invalid_input);
  EXPECT_THROW(SC::solve_surfaces(system(cube(2, 2), {})), SC::Invalid_input);
  EXPECT_THROW(SC::solve_surfaces(system({{0, 1}, {0, 0}, {0, 1}}, {sphere})), SC::Invalid_input);
  SC::Constraint_system_d divided = system(cube(2), {sphere});
  divided.add(x, Relation::NOT_EQUAL);
  EXPECT_THROW(SC::solve_surfaces(divided), SC::Invalid_input);
}

} // namespace surface_solver_test
