// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of solutions: systems of polynomials, and what must hold for the cells of each answer.

#ifndef SPLINE_CONSTRAINTS_TEST_SURFACE_TEST_CHECKS_H
#define SPLINE_CONSTRAINTS_TEST_SURFACE_TEST_CHECKS_H

#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

namespace surface_test_checks {

namespace SC = CGAL::Spline_constraints;
using SC::Power_polynomial;
using SC::Relation;
using Rational = SC::Exact_rational;
using Counts = std::vector<std::pair<int, std::size_t>>; // Euler characteristic and loops, of each surface

inline Power_polynomial variable(int i) { return Power_polynomial::variable(i); }
inline Power_polynomial number(const Rational& value) { return Power_polynomial(value); }
inline Power_polynomial square(const Power_polynomial& p) { return p * p; }

inline SC::Constraint_system_d system(const std::vector<std::pair<Rational, Rational>>& domain,
                                      const std::vector<Power_polynomial>& equalities)
{
  SC::Constraint_system_d result(domain);
  for (const Power_polynomial& equality : equalities)
    result.add(equality, Relation::EQUAL);
  return result;
}

inline std::vector<std::pair<Rational, Rational>> cube(const Rational& size, std::size_t dimension = 3)
{
  return std::vector<std::pair<Rational, Rational>>(dimension, {Rational(-size), size});
}

// Each arc has one patch or two, boundaries are loops of arcs, and the numbers of cells give the characteristic.
inline void check_complex(const SC::Surface_solution_set_d& set)
{
  std::vector<int> patches(set.arcs().size(), 0);
  for (const SC::Surface_patch& patch : set.patches()) {
    EXPECT_EQ(std::abs(patch.orientation), patch.apex ? 0 : 1);
    if (patch.apex) {
      EXPECT_TRUE(set.vertices()[*patch.apex].is_singular);
      EXPECT_EQ(std::count(set.singular_points().begin(), set.singular_points().end(), *patch.apex), 1);
    }
    ASSERT_FALSE(patch.boundary.empty());
    for (std::size_t k = 0; k < patch.boundary.size(); ++k) {
      const SC::Surface_patch::Side side = patch.boundary[k], next = patch.boundary[(k + 1) % patch.boundary.size()];
      ++patches[side.arc];
      EXPECT_EQ(set.arcs()[side.arc].ends[side.is_reversed ? 0 : 1],
                set.arcs()[next.arc].ends[next.is_reversed ? 1 : 0]);
    }
  }
  std::size_t boundary = 0, on_loops = 0;
  for (std::size_t a = 0; a < patches.size(); ++a) {
    EXPECT_EQ(patches[a], set.arcs()[a].patches);
    EXPECT_TRUE(patches[a] == 1 || patches[a] == 2);
    boundary += patches[a] == 1 ? 1 : 0;
  }
  for (const SC::Solution_surface& surface : set.surfaces())
    for (const std::vector<std::size_t>& loop : surface.boundary)
      on_loops += loop.size();
  EXPECT_EQ(boundary, on_loops);
  if (set.singular_points().empty()) {
    EXPECT_EQ(set.euler_characteristic(),
              static_cast<int>(set.vertices().size() - set.points().size()) - static_cast<int>(set.arcs().size()) +
                  static_cast<int>(set.patches().size()));
  }
}

inline Counts counts_of(const SC::Surface_solution_set_d& set)
{
  Counts result;
  for (const SC::Solution_surface& surface : set.surfaces())
    result.emplace_back(surface.euler_characteristic, surface.boundary.size());
  std::sort(result.begin(), result.end());
  return result;
}

// Of a complete answer.
inline Counts counts(const SC::Constraint_system_d& system)
{
  const SC::Surface_solution_set_d set = SC::solve_surfaces(system);
  EXPECT_TRUE(set.is_complete()) << set;
  check_complex(set);
  return counts_of(set);
}

// The images of the unknowns under a rotation by a random quaternion with small integers.
inline std::array<Power_polynomial, 3> rotated(std::mt19937& random)
{
  std::uniform_int_distribution<int> any(-4, 4);
  const int a = any(random), b = any(random), c = any(random), d = any(random) + 9;
  const Rational s = Rational(1) / (a * a + b * b + c * c + d * d);
  const auto row = [&](int p, int q, int r) {
    return number(Rational(p * s)) * variable(0) + number(Rational(q * s)) * variable(1) +
        number(Rational(r * s)) * variable(2);
  };
  return {row(a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)),
          row(2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)),
          row(2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d)};
}

} // namespace surface_test_checks

#endif // SPLINE_CONSTRAINTS_TEST_SURFACE_TEST_CHECKS_H
