// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves and surfaces of solutions with all traits, and a visitor that stops the solver.

#include "curve_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/own_traits.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <type_traits>

namespace curve_traits_test {

using Rational = SC::Exact_rational;
using SC::unknowns;

// x^2 + y^2 + z^2 = 4 and (x - c)^2 + y^2 = 1.
SC::Constraint_system_d sphere_and_cylinder(const Rational& c)
{
  auto [x, y, z] = unknowns({-3, 6}, {-3, 3}, {-3, 3});
  return SC::make_system(std::array{x * x + y * y + z * z == 4, square(x - c) + y * y == 1});
}

// Stops after a number of questions.
struct Stopping_visitor
{
  int questions = 0;

  void on_progress(double) {}
  bool stop() { return ++questions > 2; }
};

template <class Traits>
class Curve_solver_traits : public ::testing::Test
{};

using All_traits = ::testing::Types<SC::Fast_solver_traits, SC::Certified_solver_traits, SC::Interval_solver_traits,
                                    SC::Multiprecision_solver_traits, SC::Exact_solver_traits>;
TYPED_TEST_SUITE(Curve_solver_traits, All_traits);

TYPED_TEST(Curve_solver_traits, sphere_and_cylinder)
{
  const SC::Curve_solver_d<TypeParam> solver;
  expect_curves(solver(sphere_and_cylinder(Rational(1, 2))), 2, 0);
  expect_curves(solver(sphere_and_cylinder(2)), 1, 0);
  expect_curves(solver(sphere_and_cylinder(4)), 0, 0);
}

TYPED_TEST(Curve_solver_traits, figure_eight)
{
  const SC::Curve_solution_set_d set = SC::Curve_solver_d<TypeParam>()(sphere_and_cylinder(1));
  check_chains(set);
  EXPECT_TRUE(set.is_complete());
  EXPECT_EQ(set.number_of_open_curves(), 2u);
  ASSERT_EQ(set.singular_points().size(), 1u);
  expect_point(set.vertices()[set.singular_points()[0]].box, {2, 0, 0});
}

TYPED_TEST(Curve_solver_traits, domains_that_are_no_doubles)
{
  auto [x, y] = unknowns({Rational(-1, 3), Rational(2, 3)}, {Rational(-1, 3), Rational(2, 3)});
  // through (1/3, 1/3), it ends at (-1/3, 1/3) and (1/3, -1/3)
  expect_curves(SC::Curve_solver_d<TypeParam>()(SC::make_system(std::array{9 * x * x + 9 * y * y == 2})), 0, 1);
}

TYPED_TEST(Curve_solver_traits, surfaces)
{
  auto [x, y, z] = unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const SC::Surface_solver_d<TypeParam> solver;
  const SC::Surface_solution_set_d sphere = solver(SC::make_system(std::array{x * x + y * y + z * z == 1})),
                                   cap = solver(SC::make_system(std::array{x * x + y * y + z * z == 1, z >= x}));
  EXPECT_TRUE(sphere.is_complete() && cap.is_complete());
  ASSERT_EQ(sphere.surfaces().size(), 1u);
  EXPECT_EQ(sphere.surfaces()[0].euler_characteristic, 2);
  ASSERT_EQ(cap.surfaces().size(), 1u);
  EXPECT_EQ(cap.surfaces()[0].euler_characteristic, 1);
  EXPECT_EQ(cap.surfaces()[0].boundary.size(), 1u);
}

TEST(Surface_solver, is_stopped_by_a_visitor)
{
  auto [x, y, z] = unknowns({-2, 2}, {-2, 2}, {-2, 2});
  Stopping_visitor visitor;
  const SC::Surface_solution_set_d set =
      SC::Surface_solver_d<>()(SC::make_system(std::array{x * x + y * y + z * z == 1}), visitor);
  EXPECT_FALSE(set.is_complete());
  ASSERT_FALSE(set.undecided_regions().empty());
  EXPECT_EQ(set.undecided_regions()[0].reason, SC::Undecided_reason::STOPPED);
}

TEST(Curve_solver, is_stopped_by_a_visitor)
{
  auto [x, y] = unknowns({-1, 1}, {-1, 1});
  const auto t8 = [](const auto& t) { return 2 * square(8 * t * t * t * t - 8 * t * t + 1) - 1; };
  const SC::Constraint_system_d system = SC::make_system(std::array{t8(x) * t8(y) == Rational(1, 2)});
  Stopping_visitor visitor;
  const SC::Curve_solution_set_d set = SC::Curve_solver_d<>()(system, visitor);
  EXPECT_FALSE(set.is_complete());
  EXPECT_EQ(set.summary().why_not, SC::Undecided_reason::STOPPED);
  EXPECT_FALSE(set.undecided().empty());
  EXPECT_TRUE(SC::Curve_solver_d<>()(system).is_complete());
}

} // namespace curve_traits_test
