// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Square systems with solutions that are not regular: nothing is lost, nothing is certified that is not, and rational
// ones come as clusters.

#include "solver_test_checks.h"

#include <type_traits>

namespace degenerate_problems_test {

using namespace solver_test;

template <class Policies>
class Degenerate_problems : public testing::Test
{};

using All_traits = testing::Types<SC::Certified_solver_traits, SC::Multiprecision_solver_traits>;
TYPED_TEST_SUITE(Degenerate_problems, All_traits);

static const Polynomial x = Polynomial::variable(0);
static const Polynomial y = Polynomial::variable(1);
static const Polynomial z = Polynomial::variable(2);

struct Expected_cluster
{
  Point point;
  int multiplicity;
};

// Exactly these clusters and certified solutions, and nothing else.
template <class Traits>
void check_clusters(const System& system, const std::vector<Expected_cluster>& clusters,
                    const std::vector<Point>& regular = {})
{
  const auto solutions = solve_with<Traits>(system);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.size(), clusters.size() + regular.size());
  std::size_t found = 0;
  for (const auto& solution : solutions) {
    EXPECT_TRUE(verify(system, solution)) << solution.kind();
    for (const auto& [point, multiplicity] : clusters)
      if (meets(solution.box(), point)) {
        ++found;
        EXPECT_EQ(solution.kind(), Solution_kind::CLUSTER) << text_of(point);
        EXPECT_EQ(solution.multiplicity(), multiplicity) << text_of(point);
        const auto region = solution.exact_uniqueness_region();   // the annulus around it is empty
        EXPECT_TRUE(contains(region, solution.exact_box()));
        for (const auto& [other, other_multiplicity] : clusters)
          EXPECT_EQ(meets(region, other), meets(solution.box(), other));
      }
    for (const Point& point : regular)
      if (meets(solution.box(), point)) {
        ++found;
        EXPECT_EQ(solution.kind(), Solution_kind::CERTIFIED) << text_of(point);
      }
  }
  EXPECT_EQ(found, clusters.size() + regular.size());
}

TYPED_TEST(Degenerate_problems, OneUnknown)
{
  System system = cube(1, -1, 2);
  system.add(square(3 * x - 1) * pow(x, 3) * (x - 1), Relation::EQUAL);
  check_clusters<TypeParam>(system, {{{fraction(1, 3)}, 2}, {{0}, 3}}, {{1}});
}

TYPED_TEST(Degenerate_problems, TangentEllipses)   // problem 4
{
  const double h = 2 * std::sqrt(2) / 3;
  check_clusters<TypeParam>(with_equalities(cube(2, -3, 3), {x * x / 4 + y * y - 1, square(x - 1) + y * y - 1}),
                            {{{2, 0}, 2}},
                            {{fraction(2, 3), Coordinate::near(h)}, {fraction(2, 3), Coordinate::near(-h)}});
}

TYPED_TEST(Degenerate_problems, CircleAndHyperbola)   // problem 5
{
  check_clusters<TypeParam>(with_equalities(cube(2, -2, 2), {x * x + y * y - 2, x * y - 1}),
                            {{{1, 1}, 2}, {{-1, -1}, 2}});
}

TYPED_TEST(Degenerate_problems, OriginAlone)   // problem 6
{
  check_clusters<TypeParam>(with_equalities(cube(2, -2, 3), {29 * pow(x, 3) / 16 - 2 * x * y, y - x * x}),
                            {{{0, 0}, 3}});
  check_clusters<TypeParam>(with_equalities(cube(2, -1, 2), {x * x - y * y, x * y}), {{{0, 0}, 4}});
}

TYPED_TEST(Degenerate_problems, OnTheBoundary)
{
  check_clusters<TypeParam>(with_equalities(cube(2, 0, 2), {x * x - y * y, x * y}), {{{0, 0}, 4}});
  check_clusters<TypeParam>(with_equalities(cube(2, 0, 1), {x * x + y * y - 2, x * y - 1}), {{{1, 1}, 2}});
  System half = with_equalities(cube(2, -2, 2), {x * x + y * y - 2, x * y - 1});
  half.add(x + y - 2, Relation::GREATER_EQUAL);
  check_clusters<TypeParam>(half, {{{1, 1}, 2}});
}

// Curves that touch in (1/3, 1/9) to the order k, their equations mixed.
TEST(Degenerate_contacts, HighOrder)
{
  for (int k = 2; k <= 8; ++k) {
    SCOPED_TRACE(k);
    const Polynomial f = y - x * x, g = (2 + x) * f + pow(3 * x - 1, k);
    check_clusters<SC::Certified_solver_traits>(with_equalities(cube(2, -1, 2), {f + g, f - 2 * g}),
                                                {{{fraction(1, 3), fraction(1, 9)}, k}});
  }
  const Polynomial touching = (z - x * x * x) + pow(3 * x - 1, 3) + (y - x * x) * x;
  check_clusters<SC::Certified_solver_traits>(with_equalities(cube(3, -1, 2), {y - x * x, z - x * y, touching}),
                                              {{{fraction(1, 3), fraction(1, 9), fraction(1, 27)}, 3}});
}

// A root whose Jacobian is zero, on the curved boundary of an inequality.
TEST(Degenerate_contacts, NoRegularRow)
{
  System system({{fraction(1, 2), fraction(11, 5)}, {-5, fraction(-15, 14)}, {fraction(-13, 4), fraction(-29, 14)}});
  system.add(fraction(19, 90) * square(y + fraction(3, 2)), Relation::EQUAL);
  system.add(fraction(49, 3) * square(z + fraction(5, 2)), Relation::EQUAL);
  system.add(fraction(152, 153) * pow(x - 1, 3), Relation::EQUAL);
  for (const Relation relation : {Relation::GREATER_EQUAL, Relation::LESS_EQUAL}) {
    System clipped = system;
    clipped.add(-fraction(697, 20) - fraction(89, 10) * x * x - 85 * y * y - 94 * z, relation);
    expect_nothing_lost({{1, fraction(-3, 2), fraction(-5, 2)}}, solve_with<SC::Certified_solver_traits>(clipped));
  }
}

// More equalities than unknowns, and Jacobians of corank 2 and 3.
TEST(Degenerate_contacts, OverdeterminedAndHigherCorank)
{
  using Traits = SC::Certified_solver_traits;
  const Polynomial a = 3 * x - 1, b = 2 * y - 1, c = 5 * z - 2;
  const Point point{fraction(1, 3), fraction(1, 2)};
  check_clusters<Traits>(with_equalities(cube(2, 0, 1), {a * a, b * b, a * b}), {{point, 3}});
  check_clusters<Traits>(
      with_equalities(cube(2, 0, 2), {(a - b * b) * (x - 1), (a * a + b * b) * (y - x), a * b * (x + y - 2)}),
      {{point, 2}}, {{1, 1}});
  check_clusters<Traits>(with_equalities(cube(2, 0, 1), {a * a - b * b * b, a * b + b * b * b}), {{point, 5}},
                         {{0, 1}});
  check_clusters<Traits>(with_equalities(cube(3, 0, 1), {a * a - b * b + c, a * b + c * c, c + a * a * b}),
                         {{{point[0], point[1], fraction(2, 5)}, 4}});
  check_clusters<Traits>(with_equalities(cube(3, 0, 1), {a * a - b * b, a * b + c * c, c * a + 2 * b * b}),
                         {{{point[0], point[1], fraction(2, 5)}, 8}});
}

// Problem 14 with r^2 = 9/4 for the directions (1,y,z): the other two of the six are at infinity.
TYPED_TEST(Degenerate_problems, DoubleTangentLines)
{
  const Polynomial length = 1 + x * x + y * y;
  check_clusters<TypeParam>(
      with_equalities(cube(2, -2, 3), {x * y, x * x * y * y + x * x + y * y - square(length) / 4}),
      {{{0, 1}, 2}, {{0, -1}, 2}, {{1, 0}, 2}, {{-1, 0}, 2}});
}

// All six for unit directions, each of which is there with its opposite: irrational. They are proved on the precision
// ladder, which only doubles climb; without it, it is not decided how many there are, but none is lost.
TYPED_TEST(Degenerate_problems, IrrationalDoubleLines)
{
  const double h = std::sqrt(0.5);
  std::vector<Point> known;
  for (double a : {h, -h})
    for (double b : {h, -h}) {
      known.push_back({0, Coordinate::near(a), Coordinate::near(b)});
      known.push_back({Coordinate::near(a), 0, Coordinate::near(b)});
      known.push_back({Coordinate::near(a), Coordinate::near(b), 0});
    }
  const System system = with_equalities(
      cube(3, -1, 1),
      {x * y * z, x * x * y * y + y * y * z * z + z * z * x * x - fraction(1, 4), x * x + y * y + z * z - 1});
  if constexpr (std::is_same_v<TypeParam, SC::Certified_solver_traits>) {
    std::vector<Expected_cluster> clusters;
    for (const Point& point : known)
      clusters.push_back({point, 2});
    check_clusters<TypeParam>(system, clusters);
  } else {
    const auto solutions = solve_with<TypeParam>(system);
    expect_nothing_lost(known, solutions);
    EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 0u);
    for (const auto& solution : solutions) {
      std::size_t held = 0;
      for (const Point& point : known)
        held += meets(solution.box(), point);
      EXPECT_EQ(held, 1u) << "the boxes are small, and there are no others";
      EXPECT_EQ(solutions.is_complete(), solutions.count(Solution_kind::UNDECIDED) == 0);
    }
  }
}

// Pieces of one curve that meet in (1,0) and in an irrational point (problem 10).
TYPED_TEST(Degenerate_problems, PiecesOfOneCurve)
{
  const System system = curve_intersection(
      {{0, 2}, {fraction(-1, 2), 1}, {fraction(-1, 4), fraction(3, 4)}, {fraction(-3, 32), fraction(53, 64)}},
      {{fraction(-3, 32), fraction(53, 64)},
       {fraction(1, 16), fraction(29, 32)},
       {fraction(1, 8), fraction(21, 16)},
       {fraction(-3, 4), fraction(13, 8)}});
  const double third = std::sqrt(5) / 3;
  const auto solutions = solve_with<TypeParam>(system);
  expect_nothing_lost({{1, 0}, {Coordinate::near(1 - third), Coordinate::near(third)}}, solutions);
  EXPECT_EQ(solutions.size(), 2u);
  for (const auto& solution : solutions)
    EXPECT_EQ(solution.is_certified(), meets(solution.box(), {Coordinate::near(1 - third), Coordinate::near(third)}));
}

// A kink that touches zero from one side, and one beside it that does not reach it.
TYPED_TEST(Degenerate_problems, TouchingKink)
{
  System system(std::vector<System::Domain>{{0, 4}});
  system.add(polygon(0, {2, 0, 3, fraction(1, 1000000), 1}), Relation::EQUAL);
  const auto solutions = solve_with<TypeParam>(system);
  ASSERT_EQ(solutions.size(), 1u);
  EXPECT_TRUE(meets(solutions[0].box(), {1}));
  EXPECT_FALSE(solutions[0].is_certified());
}

// The segment of solutions of two overlapping cubics (problem 9), from (1/3,0) to (1,2/3): no part of it is lost.
TYPED_TEST(Degenerate_problems, Overlap)
{
  const Polynomial u = 3 * x / 4, v = 3 * y / 4 + fraction(1, 4);
  const System system = with_equalities(cube(2, 0, 1), {u - v, pow(u, 3) - u - pow(v, 3) + v});
  const auto solutions = solve_with<TypeParam>(system, {.tolerance = 1e-3});
  std::vector<Point> known;
  for (int i = 0; i <= 600; ++i)
    known.push_back({fraction(1, 3) + fraction(i, 900), fraction(i, 900)});
  expect_nothing_lost(known, solutions);
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 0u);
  EXPECT_EQ(solutions.count(Solution_kind::CLUSTER), 0u);
}

} // namespace degenerate_problems_test
