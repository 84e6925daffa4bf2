// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random cubic and quartic surfaces in a cube: their Euler characteristic beside a Morse count.

#include "morse_count.h"

#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <optional>
#include <random>

namespace random_surfaces_test {

namespace SC = CGAL::Spline_constraints;

TEST(Random_surfaces, characteristic_is_that_of_a_morse_count)
{
  std::mt19937 random(5353);
  std::size_t surfaces = 0, loops = 0;
  for (int k = 0; k < 40; ++k) {
    const morse_count::Polynomial f = morse_count::Polynomial::random(3 + k % 2, random);
    const SC::Surface_solution_set_d set = SC::solve_surfaces(morse_count::surface_in_cube(f));
    const std::optional<int> expected = morse_count::Morse_count(f)();
    ASSERT_TRUE(set.is_complete()) << k;
    ASSERT_TRUE(expected.has_value()) << k;
    EXPECT_EQ(set.euler_characteristic(), *expected) << k;
    surfaces += set.surfaces().size();
    loops += set.number_of_boundary_loops();
  }
  EXPECT_GT(surfaces, 40u);
  EXPECT_GT(loops, 80u);
}

} // namespace random_surfaces_test
