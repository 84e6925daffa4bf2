// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of solutions are proved once more, and changed ones are not.

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace surface_verification_test {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;

namespace {

// A copy with other cells.
template <class Change>
SC::Surface_solution_set_d changed(const SC::Surface_solution_set_d& set, const Change& change)
{
  std::vector<SC::Curve_vertex> vertices = set.vertices();
  std::vector<SC::Surface_arc> arcs = set.arcs();
  std::vector<SC::Surface_patch> patches = set.patches();
  change(vertices, arcs, patches);
  return {std::make_shared<const SC::Constraint_system_d>(set.system()),
          set.dimension(),
          std::move(vertices),
          std::move(arcs),
          std::move(patches),
          set.surfaces(),
          set.points(),
          set.singular_points(),
          set.undecided_regions(),
          set.summary()};
}

} // namespace

TEST(Surface_verification, all_cells_are_proved)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto ring = square(x) + square(y);
  const auto torus = square(ring + square(z) + Rational(91) / 100) - 4 * ring;
  const SC::Surface_solution_set_d closed = SC::solve_surfaces(torus == 0);
  ASSERT_FALSE(closed.patches().empty());
  EXPECT_TRUE(SC::verify(closed));
  EXPECT_TRUE(SC::verify(SC::solve_surfaces(ring + square(z) == 1, x + y >= Rational(1) / 4)));
  EXPECT_TRUE(SC::verify(SC::solve_surfaces(ring + square(z) == 4)));

  // one unknown depends on another one, which depends on the value of the inequality
  const auto [u, v, w] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const auto sphere = square(u) + square(v) + square(w) - 1, moved = square(u - 1) + square(v) + square(w) - 1;
  EXPECT_TRUE(SC::verify(SC::solve_surfaces(moved == 0, w >= Rational(1) / 3)));
  EXPECT_TRUE(SC::verify(SC::solve_surfaces(sphere * moved == 0, w >= Rational(1) / 3)));

  const auto [p, q, r, s] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  EXPECT_TRUE(SC::verify(SC::solve_surfaces(square(p) + square(q) == 1, square(r) + square(s) == 1)));
}

TEST(Surface_verification, changed_cells_are_not)
{
  const auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const SC::Surface_solution_set_d sphere = SC::solve_surfaces(square(x) + square(y) + square(z) == 1);
  ASSERT_TRUE(SC::verify(sphere));
  using Vertices = std::vector<SC::Curve_vertex>;
  using Arcs = std::vector<SC::Surface_arc>;
  using Patches = std::vector<SC::Surface_patch>;
  EXPECT_FALSE(SC::verify(changed(sphere, [](Vertices&, Arcs&, Patches& all) { all.back().orientation *= -1; })));
  EXPECT_FALSE(SC::verify(changed(sphere, [](Vertices&, Arcs&, Patches& all) { all.back().boundary.pop_back(); })));
  EXPECT_FALSE(SC::verify(changed(sphere, [](Vertices&, Arcs&, Patches& all) {
    for (auto& [lower, upper] : all.front().box) { // over nearly all of the domain it is no graph
      lower = (std::min)(lower, Rational(Rational(-3) / 2));
      upper = (std::max)(upper, Rational(Rational(3) / 2));
    }
  })));
  EXPECT_FALSE(SC::verify(
      changed(sphere, [](Vertices&, Arcs& all, Patches&) { std::swap(all.front().plane, all.front().parameter); })));
  EXPECT_FALSE(SC::verify(changed(sphere, [](Vertices& all, Arcs&, Patches&) {
    for (auto& [lower, upper] : all.front().box)
      if (lower != upper) { // beside the solution
        lower += Rational(1) / 1000;
        upper += Rational(1) / 1000;
      }
  })));
}

} // namespace surface_verification_test
