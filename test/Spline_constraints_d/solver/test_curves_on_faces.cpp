// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of solutions that lie in faces of the domain: alone, where others meet, touch or end in them, in two and three
// unknowns, on splines, cut by inequalities; and what is not proved there.

#include "curve_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace curves_on_faces_test {

using Rational = SC::Exact_rational;
using SC::unknowns;

const Rational half(1, 2), quarter(1, 4);

// Numbers of closed and open curves, and of branches that end in each singular point, in increasing order.
void expect_all(const SC::Curve_solution_set_d& set, std::size_t closed, std::size_t open,
                const std::vector<std::size_t>& branches, const std::string& what = "")
{
  check_chains(set);
  EXPECT_TRUE(set.is_complete()) << what;
  EXPECT_EQ(set.number_of_closed_curves(), closed) << what;
  EXPECT_EQ(set.number_of_open_curves(), open) << what;
  std::vector<std::size_t> found;
  for (const std::size_t i : set.singular_points())
    found.push_back(number_of_ends_at(set, i));
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, branches) << what;
}

TEST(Curves_on_faces, sides_of_a_square)
{
  auto [x, y] = unknowns({0, 1}, {0, 1});
  expect_all(SC::solve_curves(x == 0), 0, 1, {});
  expect_all(SC::solve_curves(y == 1), 0, 1, {});
  expect_all(SC::solve_curves(square(x) * (y + 1) == 0), 0, 1, {}, "a double line");
  expect_all(SC::solve_curves(x * (1 - x) == 0), 0, 2, {});
  expect_all(SC::solve_curves(x * y == 0), 0, 2, {2}, "they meet in a corner");
  expect_all(SC::solve_curves(x * (1 - x) * y * (1 - y) == 0), 0, 4, {2, 2, 2, 2});
  expect_all(SC::solve_curves(y * (square(x - half) + square(y) + 1) == 0), 0, 1, {});
}

TEST(Curves_on_faces, other_curves_meet_them)
{
  auto [x, y] = unknowns({0, 1}, {-1, 1});
  const auto set = SC::solve_curves(x * (y - x - quarter) == 0);
  expect_all(set, 0, 3, {3});
  ASSERT_EQ(set.singular_points().size(), 1u);
  expect_point(set.vertices()[set.singular_points()[0]].box, {0, quarter});
  expect_all(SC::solve_curves(x * (x - y) * (y + half) == 0), 0, 5, {3, 3});
  expect_all(SC::solve_curves(x * (2 * square(y) - 1 + x) == 0), 0, 4, {3, 3},
             "at irrational points, the ends of one curve");
  expect_all(SC::solve_curves(x * (x - square(y - quarter)) == 0), 0, 4, {4}, "touches from inside");
  expect_all(SC::solve_curves(x * (x + square(y - quarter)) == 0), 0, 2, {2}, "touches from outside");
  expect_all(SC::solve_curves(x * (y - 1 + x) == 0), 0, 2, {2}, "in the corner (0,1)");
  expect_all(SC::solve_curves(x * (y + x - 2) * (y - x) == 0), 0, 3, {1, 3},
             "the other line touches the domain in the corner (1,1), where one ends");
}

TEST(Curves_on_faces, in_space)
{
  auto [x, y, z] = unknowns({-1, 1}, {-1, 1}, {0, 2});
  expect_all(SC::solve_curves(z == 0, square(x) + square(y) + square(z) == half), 1, 0, {});
  expect_all(SC::solve_curves(z * (x + y + z - 1) == 0, square(x) + square(y) + square(z) == Rational(5, 8)), 0, 3,
             {3, 3}, "an arc over a circle");
  expect_all(SC::solve_curves(z * (x + y + z - 1) == 0, square(x) + square(y) + square(z) == half), 0, 2, {4},
             "a circle touches another one");
  expect_all(SC::solve_curves(z * (x + y + z - 3) == 0, square(x) + square(y) == Rational(5, 4)), 0, 5, {},
             "four arcs, and one above");
  expect_all(SC::solve_curves(z == 0, square(x) == square(y)), 0, 4, {4}, "lines that cross in the face");
}

// Circles in a face, in general equations.
TEST(Curves_on_faces, random_circles)
{
  std::mt19937 generator(17);
  std::uniform_int_distribution<int> coefficient(-4, 4), radius(20, 45);
  for (int round = 0; round < 20; ++round) {
    auto [x, y, z] = unknowns({-1, 1}, {-1, 1}, {-2, 1});
    const Rational r(radius(generator), 100), s(radius(generator), 100);
    const SC::Expression circles =
        (square(x - half) + square(y) - Rational(r * r)) * (square(x + half) + square(y) - Rational(s * s));
    const SC::Expression other =
        5 + square(x) + coefficient(generator) * y + coefficient(generator) * Rational(1, 8) * z;
    const bool is_upper = round % 2 == 0;
    const SC::Expression face = is_upper ? SC::Expression(1 - z) : SC::Expression(z + 2);
    expect_all(SC::solve_curves(face * other == 0, circles + face * coefficient(generator) * (x + y * z) == 0), 2, 0,
               {}, std::to_string(round));
  }
}

// A spline that is zero on two opposite sides, but whose pieces are zero on one of them only.
TEST(Curves_on_faces, splines)
{
  SC::Spline_term hat{{0, 1}, {1, 1}, {{0, half, 1}, {}}, {}};
  hat.pieces = {{0, 0, Rational(-1, 2), 1}, {Rational(-1, 2), 1, half, -1}};   // min(x, 1 - x) (y - 1/2)
  SC::Constraint_system_d system({{0, 1}, {0, 1}});
  system.add(SC::Spline_function(hat), SC::Relation::EQUAL);
  expect_all(SC::solve_curves(system), 0, 5, {3, 3});

  SC::Constraint_system_d part({{quarter, 1}, {0, 1}});
  part.add(SC::Spline_function(hat), SC::Relation::EQUAL);
  expect_all(SC::solve_curves(part), 0, 3, {3});
}

TEST(Curves_on_faces, inequalities)
{
  auto [x, y] = unknowns({0, 1}, {-1, 1});
  const SC::Constraint equation = x * (y - x - quarter) == 0;
  expect_all(SC::solve_curves(equation, x >= 0), 0, 3, {3});
  expect_all(SC::solve_curves(equation, x >= 0, y >= quarter), 0, 2, {2}, "both begin where they meet");
  expect_all(SC::solve_curves(equation, x > 0), 0, 1, {}, "without the face");
  expect_all(SC::solve_curves(equation, y >= 0), 0, 3, {3});
  expect_all(SC::solve_curves(equation, y >= half), 0, 2, {});
  expect_all(SC::solve_curves(equation, y != half), 0, 5, {3});
  expect_all(SC::solve_curves(equation, y > quarter), 0, 2, {}, "the point where they meet is excluded");
  expect_all(SC::solve_curves(equation, y <= quarter), 0, 1, {1}, "and here the end of one curve");
  expect_all(SC::solve_curves(x == 0, 2 * square(y) > 1), 0, 2, {});
}

TEST(Curves_on_faces, polylines)
{
  auto [x, y, z] = unknowns({-1, 1}, {-1, 1}, {0, 2});
  const std::vector<SC::Constraint> constraints{z * (x + y + z - 1) == 0,
                                                square(x) + square(y) + square(z) == Rational(5, 8)};
  const SC::Constraint_system_d system = make_system(constraints);
  const auto set = SC::solve_curves(system);
  std::size_t in_face = 0;
  for (const SC::Solution_curve& curve : set.curves()) {
    const auto points = SC::to_polyline(system, set, curve, 1e-3);
    ASSERT_GT(points.size(), 10u);
    const bool is_in_face = std::all_of(points.begin(), points.end(), [](const auto& p) { return p[2] == 0; });
    in_face += is_in_face;
    for (const auto& p : points) {
      EXPECT_NEAR(p[0] * p[0] + p[1] * p[1] + p[2] * p[2], 0.625, 1e-14);
      EXPECT_NEAR(is_in_face ? 0 : p[0] + p[1] + p[2] - 1, 0, 1e-14);
    }
  }
  EXPECT_EQ(in_face, 2u);
}

// Neither equation is zero on the face, though the difference of them is: this is not proved, but found soon.
TEST(Curves_on_faces, without_a_factor)
{
  auto [x, y, z] = unknowns({-1, 1}, {-1, 1}, {0, 1});
  const SC::Expression circle = square(x) + square(y) - half;
  const auto set = SC::solve_curves(circle + z == 0, circle - z + square(z) == 0);
  check_chains(set);
  EXPECT_FALSE(set.is_complete());
  ASSERT_EQ(set.undecided_regions().size(), 1u);
  EXPECT_EQ(set.undecided_regions()[0].reason, SC::Undecided_reason::CONTINUUM);
  EXPECT_TRUE(set.curves().empty());
  EXPECT_LT(set.summary().nodes, 5000u);
}

TEST(Curves_on_faces, surfaces_are_undecided)
{
  auto [x, y, z] = unknowns({0, 1}, {0, 1}, {0, 1});
  for (const auto& set : {SC::solve_curves(z * (x - y) == 0, z * (x + y - 1) == 0),
                          SC::solve_curves(x == y, SC::Expression(0) * z == 0)}) {
    EXPECT_FALSE(set.is_complete());
    ASSERT_FALSE(set.undecided_regions().empty());
    EXPECT_EQ(set.undecided_regions()[0].reason, SC::Undecided_reason::CONTINUUM);
  }
}

// The only point that the inequality leaves is on two breaks, the plane through the second unknown's found first.
TEST(Curves_on_faces, points_on_two_planes)
{
  // y - x
  SC::Spline_term line{
      {0, 1}, {1, 1}, {{-1, 0, 1}, {-1, Rational(-1, 2), 0, 1}}, std::vector<std::vector<Rational>>(6, {0, 1, -1, 0})};
  SC::Constraint_system_d system({{-1, 1}, {-1, 1}});
  system.add(SC::Spline_function(line), SC::Relation::EQUAL);
  auto [x, y] = unknowns({-1, 1}, {-1, 1});
  system.add(square(x) + square(y) <= 0);
  const auto set = SC::solve_curves(system);
  EXPECT_TRUE(set.is_complete());
  EXPECT_TRUE(set.curves().empty());
  ASSERT_EQ(set.points().size(), 1u);
  expect_point(set.vertices()[set.points()[0]].box, {0, 0});
}

} // namespace curves_on_faces_test
