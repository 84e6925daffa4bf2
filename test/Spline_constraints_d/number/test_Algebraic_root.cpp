// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What only exact signs at irrational points decide: double roots, roots closer than any precision, common points of
// more equalities than unknowns, boundaries of inequalities.

#include <CGAL/Spline_constraints_d/solver/internal/exact/Algebraic_root.h>

#include "random_systems.h"
#include "solver_test_checks.h"

#include <cmath>
#include <string>
#include <vector>

namespace Algebraic_root_test {

using namespace solver_test;
using SC::internal::Algebraic_equations;
using SC::internal::Algebraic_root;
using SC::internal::Exact_box;

namespace {

const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1), z = Polynomial::variable(2);

Rational tenth_to(int exponent)
{
  Rational result(1);
  for (int i = 0; i < exponent; ++i)
    result /= Rational(10);
  return result;
}

Algebraic_root root_near(const std::vector<Polynomial>& equations, const std::vector<double>& point,
                         bool ends_with_determinant = false)
{
  Exact_box box;
  for (double p : point)
    box.emplace_back(Rational(p - 0x1p-10), Rational(p + 0x1p-10));
  auto root = Algebraic_root::in(Algebraic_equations(equations, ends_with_determinant), box);
  EXPECT_TRUE(root);
  return *root;
}

TEST(Algebraic_root, Signs)
{
  Algebraic_root root = root_near({x * x - 2, y - x * x * x}, {std::sqrt(2.0), std::sqrt(8.0)});   // (sqrt 2, 2 sqrt 2)
  EXPECT_EQ(root.sign_of(y - 2 * x), CGAL::ZERO);
  EXPECT_EQ(root.sign_of(x * y - 4), CGAL::ZERO);
  EXPECT_EQ(root.sign_of(x * y - 4 + Polynomial(tenth_to(500))), CGAL::POSITIVE);
  EXPECT_EQ(root.sign_of(y - 2 * x - x * Polynomial(tenth_to(500))), CGAL::NEGATIVE);
  EXPECT_EQ(root.sign_of(Polynomial(-3)), CGAL::NEGATIVE);
  EXPECT_EQ(root.sign_of(Polynomial(0)), CGAL::ZERO);
  EXPECT_TRUE(root.refine(1000));
  for (const auto& [lower, upper] : root.box())
    EXPECT_LT(Rational(upper - lower), tenth_to(300));
}

TEST(Algebraic_root, WithTheDeterminantOfTheJacobian)
{
  // A circle and a hyperbola that touch in x = y = sqrt(3/2): there the gradients are parallel.
  Algebraic_root root = root_near({2 * x * y - 3, x * x + y * y - 3}, {std::sqrt(1.5), std::sqrt(1.5)}, true);
  EXPECT_EQ(root.sign_of(x * x + y * y - 3), CGAL::ZERO);
  EXPECT_EQ(root.sign_of(x - y), CGAL::ZERO);
  EXPECT_EQ(root.sign_of(2 * x * x - 3), CGAL::ZERO);
}

TEST(Algebraic_root, IsNotProvedWhereThereIsNone)
{
  const Exact_box box{{Rational(1), Rational(2)}, {Rational(0), Rational(1)}};
  EXPECT_FALSE(Algebraic_root::in(Algebraic_equations({x * x - 5, y - x}, false), box));
  EXPECT_FALSE(Algebraic_root::in(Algebraic_equations({(x - y) * (x - y), y - x}, false), box));
}

// Unions of curves that touch at the roots of a random polynomial p, irrational as a rule, and do not meet elsewhere.
class Planted_contacts
  : public ::testing::TestWithParam<int>
{
protected:
  static inline const Rational side = fraction(33, 16);   // where p has no root
  Polynomial p, first, second;
  std::vector<Point> points;   // where p = 0 and first = 0, in the domain

  void SetUp() override
  {
    Random_numbers random(static_cast<std::uint64_t>(GetParam()));
    const Polynomial r = Polynomial(random.ratio(-2, 2, 5)) + Polynomial(random.ratio(-1, 1, 5)) * x +
        Polynomial(random.ratio(-1, 1, 5)) * x * x;
    SC::Solution_set_d<double> roots;
    do {   // until all roots are simple, and there are some
      p = Polynomial(random.integer(-6, 6)) + random.integer(-6, 6) * x + random.integer(-3, 3) * x * x +
          random.integer(1, 3) * x * x * x;
      System line({{-side, side}});
      line.add(p, Relation::EQUAL);
      roots = solve(line);
    } while (roots.size() == 0 || roots.count(Solution_kind::CERTIFIED) < roots.size());
    first = y - r;
    second = first + p * p * Polynomial(random.ratio(1, 3, 4));
    for (const auto& root : roots) {
      const auto [lower, upper] = root.exact_box()[0];
      const Rational middle((lower + upper) / 2), value = Rational(-first(std::vector<Rational>{middle, Rational(0)})),
                                                  room(1e-9);
      points.push_back({Coordinate::between(Rational(lower - room), Rational(upper + room)),
                        Coordinate::between(Rational(value - room), Rational(value + room))});
    }
  }

  static System system_of(const std::vector<Polynomial>& equalities)
  {
    System result({{-side, side}, {Rational(-9), Rational(9)}});
    for (const Polynomial& f : equalities)
      result.add(f, Relation::EQUAL);
    return result;
  }
};

TEST_P(Planted_contacts, AreDoubleRoots)
{
  const System system = system_of({2 * first + second, first - 3 * second});
  const auto solutions = solve(system);
  EXPECT_TRUE(solutions.is_complete()) << p;
  EXPECT_EQ(solutions.size(), points.size()) << p;
  expect_nothing_lost(points, solutions);
  for (const auto& solution : solutions) {
    EXPECT_EQ(solution.kind(), Solution_kind::CLUSTER);
    EXPECT_EQ(solution.multiplicity(), 2);
    EXPECT_TRUE(verify(system, solution));
  }
}

// Closer than the ladder reaches.
TEST_P(Planted_contacts, BecomeTwoRootsOrNone)
{
  const Polynomial gap(tenth_to(200));
  EXPECT_EQ(solve(system_of({first, second + gap})).size(), 0u) << p;
  EXPECT_TRUE(solve(system_of({first, second + gap})).is_complete()) << p;
  const System system = system_of({first, second - gap});
  const auto solutions = solve(system);
  EXPECT_TRUE(solutions.is_complete()) << p;
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 2 * points.size()) << p;
  expect_nothing_lost(points, solutions);
  expect_consistent_regions(solutions);
  for (const auto& solution : solutions)
    EXPECT_TRUE(verify(system, solution));
}

TEST_P(Planted_contacts, SatisfyMoreEqualities)
{
  const Polynomial third = first * (1 + x * x) + p * (3 - y);
  const System system = system_of({first + p, first - p * x, third});
  const auto solutions = solve(system);
  EXPECT_TRUE(solutions.is_complete()) << p;
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), points.size()) << p;
  expect_nothing_lost(points, solutions);
  for (const auto& solution : solutions)
    EXPECT_TRUE(verify(system, solution));
  const auto none = solve(system_of({first + p, first - p * x, third + Polynomial(tenth_to(60))}));
  EXPECT_TRUE(none.is_complete()) << p;
  EXPECT_EQ(none.size(), 0u) << p;
}

TEST_P(Planted_contacts, LieOnTheBoundaryOfAnInequality)
{
  for (const Relation relation : {Relation::LESS, Relation::LESS_EQUAL}) {
    System system = system_of({first, p});
    system.add(first * x - p * y, relation);
    const auto solutions = solve(system);
    EXPECT_TRUE(solutions.is_complete()) << p;
    EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), relation == Relation::LESS ? 0u : points.size()) << p;
    for (const auto& solution : solutions)
      EXPECT_TRUE(verify(system, solution));
  }
}

INSTANTIATE_TEST_SUITE_P(Random, Planted_contacts, ::testing::Range(7, 19));

TEST(Irrational_double_roots, InSpace)
{
  System system({{Rational(-2), Rational(2)}, {Rational(-2), Rational(2)}, {Rational(-2), Rational(2)}});
  for (const Polynomial& f : {x * x + y * y - 3, 2 * x * y - 3, z * z * z - x - 2 * z})
    system.add(f, Relation::EQUAL);
  const auto solutions = solve(system);
  EXPECT_TRUE(solutions.is_complete());
  ASSERT_EQ(solutions.size(), 2u);
  for (const auto& solution : solutions) {
    EXPECT_EQ(solution.multiplicity(), 2);
    EXPECT_NEAR(std::abs(solution.point()[0]), std::sqrt(1.5), 1e-12);
    EXPECT_TRUE(verify(system, solution));
  }
}

} // namespace

} // namespace Algebraic_root_test
