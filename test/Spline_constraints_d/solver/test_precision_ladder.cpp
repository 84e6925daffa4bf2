// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Solutions closer to each other than doubles are: only the boxes that doubles leave open climb to more bits.

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/internal/subdivision/precision_ladder.h>

#include <cstring>
#include <utility>
#include <vector>

namespace precision_ladder_test {

using namespace solver_test;

// Not decomposed: elimination would leave equations in one unknown, which need no ladder.
static SC::Solution_set_d<double> solve(const System& system, const SC::Solver_options& options = {})
{
  return SC::Subdivision_solver_d<>(options)(system);
}

static const Polynomial x = Polynomial::variable(0);
static const Polynomial y = Polynomial::variable(1);

static Rational power_of_ten(int exponent)
{
  Rational result(1);
  for (int i = 0; i < std::abs(exponent); ++i)
    result *= 10;
  return exponent < 0 ? Rational(1 / result) : result;
}

// A parabola, bent or not, and a line that crosses it at two points `gap` apart around (u, v); at the same distance on
// the other side for a negative sign.
static Problem parabola_and_line(const Rational& u, const Rational& v, const Rational& gap, int sign)
{
  const Polynomial a = x - u, b = y - v;
  std::vector<Point> known;
  if (sign > 0)
    known = {{Rational(u - gap / 2), Rational(v + gap * gap / 4)},
             {Rational(u + gap / 2), Rational(v + gap * gap / 4)}};
  return all_known("parabola and line", with_equalities(cube(2, -2, 2), {b - a * a, b - sign * gap * gap / 4}), known);
}

TEST(Precision_ladder, GapsOnBothSides)
{
  for (int digits : {5, 10, 20, 40, 100})
    for (const auto& [u, v] :
         {std::pair<Rational, Rational>{0, 0}, {fraction(1, 3), fraction(1, 7)}, {1, fraction(-1, 2)}}) {
      SCOPED_TRACE(std::to_string(digits) + " digits");
      const Problem crossing = parabola_and_line(u, v, power_of_ten(-digits), 1);
      const SC::Solver_options options{.ladder_precision = 512};
      const auto solutions = solve(crossing.system, options);
      expect_solved(crossing, solutions);
      for (const auto& solution : solutions) {
        EXPECT_LE(solution.precision(), digits < 15 ? 0 : 128 + 14 * digits);   // four times the bits of the gap
        EXPECT_EQ(std::strcmp(solution.number_type(), solution.precision() > 0 ? "multiprecision" : "double"), 0);
        if (digits >= 20 && u != 0) {   // beside zero, doubles are fine enough
          EXPECT_GE(solution.precision(), 128);
          EXPECT_LT(solution.exact_box()[0].second - solution.exact_box()[0].first, power_of_ten(-digits - 2));
        }
      }
      const auto none = solve(parabola_and_line(u, v, power_of_ten(-digits), -1).system, options);
      EXPECT_TRUE(none.empty());
      EXPECT_TRUE(none.is_complete());
    }
}

TEST(Precision_ladder, Contact)
{
  for (const auto& [u, v] :
       {std::pair<Rational, Rational>{0, 0}, {fraction(1, 3), fraction(1, 7)}, {1, fraction(-1, 2)}}) {
    const Problem problem = parabola_and_line(u, v, 0, 0);
    const auto solutions = solve(problem.system);
    EXPECT_TRUE(solutions.is_complete());
    ASSERT_EQ(solutions.size(), 1u);
    EXPECT_EQ(solutions[0].kind(), Solution_kind::CLUSTER);
    EXPECT_EQ(solutions[0].multiplicity(), 2);
    EXPECT_TRUE(meets(solutions[0].exact_box(), {u, v}));
    EXPECT_TRUE(verify(problem.system, solutions[0]));
  }
}

// Only the box that needs it climbs: the others are decided in double.
TEST(Precision_ladder, OneOfMany)
{
  const Rational gap = power_of_ten(-30);
  const Polynomial factor = (x - fraction(1, 3)) * (x - fraction(1, 3) - gap) * (x - 1) * (x + 1);
  const Problem problem =
      all_known("one pair of many", with_equalities(cube(2, -2, 2), {factor, y * y - x - fraction(3, 2)}), {});
  const auto solutions = solve(problem.system);
  EXPECT_TRUE(solutions.is_complete());
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 8u);
  std::size_t climbed = 0;
  for (const auto& solution : solutions) {
    EXPECT_TRUE(verify(problem.system, solution));
    EXPECT_EQ(solution.precision() > 0, std::abs(solution[0].first - 1.0 / 3) < 1e-9);
    climbed += solution.precision() > 0;
  }
  EXPECT_EQ(climbed, 4u);
  expect_consistent_regions(solutions);
}

TEST(Precision_ladder, EndsWhereItIsTold)
{
  const Problem problem = parabola_and_line(fraction(1, 3), fraction(1, 7), power_of_ten(-40), 1);
  const auto solutions = solve(problem.system, {.ladder_precision = 0});
  EXPECT_FALSE(solutions.is_complete());
  expect_nothing_lost(problem.known, solutions);
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 0u);
  for (const auto& solution : solutions)
    EXPECT_EQ(solution.precision(), 0);
  expect_solved(problem, solve(problem.system));
}

// Irrational, of multiplicity three and of degree seven: no precision decides it, and the budget ends.
TEST(Precision_ladder, NothingIsLostWherePrecisionDoesNotHelp)
{
  const Coordinate root = Coordinate::near(std::pow(2.0, 1. / 7));
  const auto power = x * x * x * x * x * x * x - 2;
  const Problem problem{"triple at an irrational point",
                        with_equalities(cube(2, 0, 2), {square(power) * power, y - x}),
                        1,
                        {{root, root}}};
  const auto solutions = solve(problem.system);
  EXPECT_FALSE(solutions.is_complete());
  expect_nothing_lost(problem.known, solutions);
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 0u);
  const auto stopped = solve(problem.system, {.node_limit = 60});
  expect_nothing_lost(problem.known, stopped);
}

// The lines that touch four spheres: double roots for whose proof the zero bound asks too many bits. They are proved in
// a number field, and the boxes do not climb, since no rung would tell.
TEST(Precision_ladder, DoubleRootsBeyondTheZeroBound)
{
  const Polynomial z = Polynomial::variable(2), xx = square(x), yy = square(y), zz = square(z);
  const Coordinate plus = Coordinate::near(std::sqrt(0.5)), minus = Coordinate::near(-std::sqrt(0.5)),
                   zero = Coordinate::near(0);
  Problem problem{
      "lines that touch four spheres",
      with_equalities(cube(3, -1, 1), {x * y * z, xx * yy + yy * zz + zz * xx - fraction(1, 4), xx + yy + zz - 1}),
      12,
      {}};
  for (const Coordinate& a : {plus, minus})
    for (const Coordinate& b : {plus, minus})
      problem.known.insert(problem.known.end(), {{a, b, zero}, {b, zero, a}, {zero, a, b}});
  const auto solutions = solve(problem.system), without_ladder = solve(problem.system, {.ladder_precision = 0});
  expect_nothing_lost(problem.known, solutions);
  EXPECT_EQ(solutions.size(), 12u);
  EXPECT_EQ(solutions.count(Solution_kind::CLUSTER), 12u);
  EXPECT_TRUE(solutions.is_complete());
  EXPECT_EQ(solutions.summary().nodes, without_ladder.summary().nodes);
}

// A pair across a break, and one on the faces of the domain.
TEST(Precision_ladder, BreaksAndFaces)
{
  const Rational gap = power_of_ten(-25), third = fraction(1, 3);
  const Polynomial left = (x - third) * (x - third + gap), right = -(x - third) * (x - third - gap);
  const Problem across = all_known("triple across a break", [&] {
    System system(cube(1, -1, 1));
    system.add(piecewise(0, {-1, third, 1}, {left * -1, right * -1}), Relation::EQUAL);
    return system;
  }(), {{Rational(third - gap)}, {third}, {Rational(third + gap)}});
  expect_solved(across, solve(across.system));
  const Problem face = all_known("one on the face, the other one outside",
                                 with_equalities(System({{third, 2}}), {(x - third) * (x - third + gap)}), {{third}});
  expect_solved(face, solve(face.system));
}

// A box may lead to a root beside it: two open boxes to the same one.
TEST(Precision_ladder, RootOfTwoBoxesIsReportedOnce)
{
  namespace I = SC::internal;
  const System system = with_equalities(cube(2, 0, 2), {x * x * x + x - 1, y - x});
  const I::System_layout layout(system);
  I::Exact_source source(system, layout);
  const I::Found_roots<double> known;
  const SC::Solver_options options;
  I::Run_control control(options);
  SC::Summary summary;
  I::Precision_ladder ladder(system, layout, source, known, options, control, summary);
  std::vector<SC::Solution_d<double>> solutions;
  for (const auto& [lower, upper] :
       {std::pair(0.6823278, 0.68232781), {0.6823278038, 0.6823278039}, {0.5, 0.50000001}, {0.6823278, 0.68232781}}) {
    const I::Open_box<double> box{{lower, lower}, {upper, upper}, SC::Undecided_reason::TOLERANCE, {0, 0}};
    ladder.report(box, I::classified<double>(system, box), solutions);
  }
  ASSERT_EQ(solutions.size(), 1u);
  EXPECT_EQ(solutions[0].kind(), SC::Solution_kind::CERTIFIED);
  EXPECT_NEAR(solutions[0][0].first, 0.68232780382801933, 1e-15);
}

} // namespace precision_ladder_test
