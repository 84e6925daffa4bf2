// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Equalities that are products: factors in several unknowns, surfaces of each factor with the curves where they cross,
// faces of the domain on which an equality is zero.

#include <CGAL/Spline_constraints_d/function/internal/factors_in_several_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/surface_mesh.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#include "surface_test_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace surface_factors_test {

namespace SC = CGAL::Spline_constraints;
using SC::Power_polynomial;
using SC::Relation;
using Rational = SC::Exact_rational;
using surface_test_checks::check_complex, surface_test_checks::Counts, surface_test_checks::counts_of,
    surface_test_checks::cube, surface_test_checks::number, surface_test_checks::rotated, surface_test_checks::square,
    surface_test_checks::system, surface_test_checks::variable;

namespace {

const Power_polynomial x = variable(0), y = variable(1), z = variable(2), w = variable(3);

Power_polynomial sphere(const Rational& cx, const Rational& cy, const Rational& cz, const Rational& squared_radius)
{
  return square(x - number(cx)) + square(y - number(cy)) + square(z - number(cz)) - number(squared_radius);
}

// Numbers of closed and open curves, and of single points, of each crossing.
using Crossings = std::vector<std::array<std::size_t, 3>>;

Crossings crossings_of(const SC::Surface_solution_set_d& set)
{
  Crossings result;
  for (const SC::Surface_crossing& crossing : set.crossings()) {
    EXPECT_LT(crossing.systems[0], crossing.systems[1]);
    EXPECT_LT(crossing.systems[1], set.systems().size());
    const SC::Curve_solution_set_d& curves = crossing.curves;
    result.push_back({curves.number_of_closed_curves(), curves.number_of_open_curves(),
                      curves.points().size() + curves.singular_points().size()});
  }
  std::sort(result.begin(), result.end());
  return result;
}

void expect_solved(const SC::Constraint_system_d& problem, const Counts& surfaces, const Crossings& crossings)
{
  const SC::Surface_solution_set_d set = SC::solve_surfaces(problem);
  EXPECT_TRUE(set.is_complete()) << set;
  check_complex(set);
  EXPECT_EQ(counts_of(set), surfaces);
  EXPECT_EQ(crossings_of(set), crossings);
  EXPECT_EQ(counts_of(SC::Surface_solver_d<>()(problem)), surfaces);
  // each patch is zero in the system that it is said to solve
  for (std::size_t p = 0; p < set.patches().size(); ++p)
    EXPECT_EQ(&set.system_of_patch(p), set.systems()[set.surfaces()[set.patches()[p].surface].system].get());
}

SC::Constraint_system_d with_inequality(SC::Constraint_system_d system, const Power_polynomial& polynomial,
                                        Relation relation)
{
  system.add(polynomial, relation);
  return system;
}

} // namespace

TEST(Surface_factors, factors_in_several_unknowns)
{
  std::mt19937 random(7);
  std::uniform_int_distribution<int> any(-5, 5);
  for (int round = 0; round < 20; ++round) {
    const auto [a, b, c] = rotated(random);
    const Power_polynomial ellipsoid = square(a) + number(2) * square(b) + number(3) * square(c) - number(1 + round),
                           plane = a + number(any(random)) * b + number(any(random)) * c + number(any(random)),
                           cubic = a * square(a) - b * c + number(any(random)) * a + number(2);
    for (const std::vector<Power_polynomial>& expected :
         {std::vector{ellipsoid}, {ellipsoid, plane}, {ellipsoid, plane, cubic}, {cubic, x, y - z}}) {
      Power_polynomial product = expected[0];
      for (std::size_t i = 0; i < expected.size(); ++i)
        product *= expected[i]; // the first one twice
      const std::vector<Power_polynomial> found = SC::internal::different_factors(product);
      ASSERT_EQ(found.size(), expected.size());
      for (const Power_polynomial& factor : expected)
        EXPECT_EQ(
            std::count(found.begin(), found.end(), factor * number(Rational(1 / factor.terms().rbegin()->second))), 1);
    }
  }
  EXPECT_EQ(SC::internal::different_factors(square(square(x)) - number(2) * square(square(y))).size(), 1u);
  EXPECT_EQ(SC::internal::different_factors(square(square(x)) - number(4) * square(square(y))).size(), 2u);
}

TEST(Surface_factors, components_that_cross)
{
  const Power_polynomial unit = sphere(0, 0, 0, 1), other = sphere(1, 0, 0, 1);
  const std::vector<std::pair<Rational, Rational>> box{{-2, 3}, {-2, 2}, {-2, 2}};
  expect_solved(system(box, {unit * other}), {{2, 0}, {2, 0}}, {{1, 0, 0}});
  expect_solved(system(box, {unit * other * square(other)}), {{2, 0}, {2, 0}}, {{1, 0, 0}});
  expect_solved(system(box, {unit * (z - number(Rational(1) / 2))}), {{1, 1}, {2, 0}}, {{1, 0, 0}});
  expect_solved(system(box, {unit * other * (y - number(Rational(1) / 7))}), {{1, 1}, {2, 0}, {2, 0}},
                {{1, 0, 0}, {1, 0, 0}, {1, 0, 0}});
  expect_solved(system(box, {(y - z + number(Rational(1) / 3)) * (number(2) * y + z)}), {{1, 1}, {1, 1}}, {{0, 1, 0}});
  expect_solved(system(box, {unit * sphere(2, 1, 0, Rational(1) / 4)}), {{2, 0}, {2, 0}}, {}); // apart
  expect_solved(with_inequality(system(box, {unit * other}), z - number(Rational(1) / 3), Relation::GREATER_EQUAL),
                {{1, 1}, {1, 1}}, {{0, 1, 0}});
  expect_solved(system({{-2, 2}, {-2, 2}, {-2, 2}, {-5, 5}}, {unit * (y - z + number(Rational(1) / 3)), w - x * y}),
                {{1, 1}, {2, 0}}, {{1, 0, 0}});
}

TEST(Surface_factors, components_that_cross_rotated)
{
  std::mt19937 random(11);
  for (int round = 0; round < 6; ++round) {
    const auto [a, b, c] = rotated(random);
    const Power_polynomial ring = square(a) + square(b),
                           torus = square(ring + square(c) + number(Rational(91) / 100)) - number(4) * ring;
    expect_solved(system(cube(3), {torus * (square(a) + square(b) + square(c) - number(1))}), {{0, 0}, {2, 0}},
                  {{2, 0, 0}});
  }
}

// From inside: the curves that the spheres are nearly the same along need no boxes.
TEST(Surface_factors, spheres_that_touch_from_inside)
{
  for (const SC::Constraint_system_d& problem :
       {system(cube(2), {sphere(0, 0, 0, 1) * sphere(Rational(1) / 2, 0, 0, Rational(1) / 4)}),
        system(cube(2),
               {sphere(0, 0, 0, 1) * sphere(Rational(1) / 6, Rational(1) / 3, Rational(1) / 3, Rational(1) / 4)})}) {
    const SC::Surface_solution_set_d set = SC::solve_surfaces(problem);
    EXPECT_TRUE(set.is_complete()) << set;
    EXPECT_EQ(counts_of(set), (Counts{{2, 0}, {2, 0}}));
    ASSERT_EQ(set.singular_points().size(), 1u);
    Rational squares(0);
    for (const auto& [lower, upper] : set.vertices()[set.singular_points()[0]].box) {
      EXPECT_EQ(lower, upper);
      squares += lower * lower;
    }
    EXPECT_EQ(squares, Rational(1)); // on the sphere
    EXPECT_LT(set.summary().nodes, 100000u);
  }
}

TEST(Surface_factors, faces_of_the_domain)
{
  const Power_polynomial unit = sphere(0, 0, 0, 1), third = number(Rational(1) / 3);
  const std::vector<std::pair<Rational, Rational>> box{{0, 2}, {-2, 2}, {-2, 2}};
  expect_solved(system(box, {x}), {{1, 1}}, {});
  expect_solved(system(box, {x * unit}), {{1, 1}, {1, 1}}, {{1, 0, 0}});
  expect_solved(system(box, {square(x) * unit}), {{1, 1}, {1, 1}}, {{1, 0, 0}});
  expect_solved(system(box, {(x - number(2)) * unit}), {{1, 1}, {1, 1}}, {});
  expect_solved(system(box, {x * (x - number(2))}), {{1, 1}, {1, 1}}, {});
  expect_solved(system(box, {x * (y - third) * unit}), {{1, 1}, {1, 1}, {1, 1}}, {{0, 1, 0}, {0, 1, 0}, {1, 0, 0}});
  expect_solved(system({{0, 2}, {0, 2}, {-2, 2}}, {x * y * unit}), {{1, 1}, {1, 1}, {1, 1}},
                {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}});
  expect_solved(with_inequality(system(box, {x * unit}), y - third, Relation::GREATER_EQUAL), {{1, 1}, {1, 1}},
                {{0, 1, 0}});
  expect_solved(with_inequality(system(box, {x * unit}), x, Relation::GREATER), {{1, 1}}, {}); // not the face
  expect_solved(system({{0, 2}, {-2, 2}, {-2, 2}, {-5, 5}}, {x * unit, w - x - y * z}), {{1, 1}, {1, 1}}, {{1, 0, 0}});
  // a plane of breaks: |x| (x^2 + y^2 + z^2 - 1)
  SC::Spline_term absolute{{0}, {1}, {{Rational(-2), Rational(0), Rational(2)}}, {{0, -1}, {0, 1}}};
  SC::Constraint_system_d broken(cube(2));
  broken.add(SC::Spline_function(absolute), Relation::EQUAL);
  expect_solved(broken, {{1, 1}}, {});
}

TEST(Surface_factors, meshes_and_proofs)
{
  const SC::Surface_solution_set_d set = SC::solve_surfaces(
      system({{0, 2}, {-2, 2}, {-2, 2}}, {x * sphere(0, 0, 0, 1) * (z - y + number(Rational(1) / 3))}));
  EXPECT_TRUE(set.is_complete()) << set;
  EXPECT_EQ(set.surfaces().size(), 3u);
  EXPECT_TRUE(SC::verify(set));
  const SC::Solution_surface_mesh mesh = SC::to_surface_mesh(set, {.chord_error = 0.02});
  EXPECT_TRUE(mesh.undecided_parts.empty());
  EXPECT_LT(mesh.error, 0.0201);
  EXPECT_GT(mesh.mesh.number_of_vertices(), 50u);
  for (const auto v : mesh.mesh.vertices()) {
    const auto& p = mesh.mesh.point(v);
    const double on_face = p.x(), on_sphere = p.x() * p.x() + p.y() * p.y() + p.z() * p.z() - 1,
                 on_plane = p.z() - p.y() + 1.0 / 3;
    EXPECT_LT((std::min)({std::abs(on_face), std::abs(on_sphere), std::abs(on_plane)}), 1e-12);
  }
}

} // namespace surface_factors_test
