// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Systems with infinitely many solutions: recognised early, described exactly, and no isolated solution beside them
// lost.

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/common_factor.h>

#include <algorithm>
#include <random>

namespace continua_test {

using namespace solver_test;

namespace {

using Ends = std::vector<std::vector<Rational>>;
using Solutions = SC::Solution_set_d<double>;
using Answer = Solutions::Solution;

const Polynomial x = Polynomial::variable(0);
const Polynomial y = Polynomial::variable(1);
const Polynomial z = Polynomial::variable(2);

std::vector<Answer> continua_of(const Solutions& solutions)
{
  std::vector<Answer> result;
  std::copy_if(solutions.begin(), solutions.end(), std::back_inserter(result),
               [](const Answer& a) { return a.kind() == Solution_kind::CONTINUUM; });
  return result;
}

bool is_covered(const Answer& continuum, const std::vector<Rational>& point)
{
  return std::any_of(continuum.cover().begin(), continuum.cover().end(),
                     [&](const auto& box) { return meets(box, Point(point.begin(), point.end())); });
}

// One segment with these ends, some certified roots and nothing else.
void check_segment(const System& system, const Ends& ends, std::size_t roots = 0,
                   const SC::Solver_options& options = {})
{
  const Solutions solutions = SC::solve(system, options);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.size(), roots + 1);
  const SC::Summary& summary = solutions.summary();   // of all runs together
  EXPECT_LE(summary.setup_seconds + summary.rebuild_seconds, summary.seconds);
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), roots);
  const auto continua = continua_of(solutions);
  ASSERT_EQ(continua.size(), 1u);
  EXPECT_EQ(continua[0].dimension(), 1);
  EXPECT_EQ(continua[0].ends(), ends);
  for (const Answer& answer : solutions)
    EXPECT_TRUE(verify(system, answer)) << answer.kind();
}

} // namespace

TEST(Common_factor, Planted)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> coefficient(-9, 9);
  for (int test = 0; test < 300; ++test) {
    const int n = 1 + test % 4;
    const auto make = [&](int largest) {
      Polynomial sum(coefficient(random));
      for (int term = 0; term < 8; ++term) {
        Polynomial product(fraction(coefficient(random), 1 + term % 3));
        for (int v = 0; v < n; ++v)
          product *= pow(Polynomial::variable(v), std::uniform_int_distribution<int>(0, largest)(random));
        sum += product;
      }
      return sum + pow(Polynomial::variable(test % n), largest + 1);
    };
    const Polynomial h = make(2), f = make(1) * h, g = make(3) * h;
    const auto common = SC::common_factor({f, g, Polynomial()});
    ASSERT_TRUE(common.has_value());
    EXPECT_GE(common->factor.total_degree(), h.total_degree());
    EXPECT_EQ(common->factor * common->cofactors[0], f);
    EXPECT_EQ(common->factor * common->cofactors[1], g);
    EXPECT_TRUE(common->cofactors[2].is_zero());
    EXPECT_FALSE(SC::common_factor({common->cofactors[0], common->cofactors[1]}).has_value());
  }
  EXPECT_FALSE(SC::common_factor({x - 1, y - 1}).has_value());
  EXPECT_FALSE(SC::common_factor({Polynomial(2), Polynomial(4) * x}).has_value());
  EXPECT_FALSE(SC::common_factor({Polynomial(), Polynomial()}).has_value());
}

TEST(Common_factor, SquareFreePart)
{
  const Polynomial f = SC::square_free_part(pow(x - y, 3) * (x + 1) * square(x * y - 2));
  const auto common = SC::common_factor({f, (x - y) * (x + 1) * (x * y - 2)});
  ASSERT_TRUE(common.has_value());
  EXPECT_EQ(common->factor.total_degree(), 4);
  EXPECT_TRUE(common->cofactors[0].is_constant());
  EXPECT_EQ(SC::square_free_part(x * x - 2), x * x - 2);
}

// Problem 9, whatever the tolerance: the work does not depend on it.
TEST(Continua, Overlap)
{
  const Polynomial u = 3 * x / 4, v = 3 * y / 4 + fraction(1, 4);
  const System system = with_equalities(cube(2, 0, 1), {u - v, pow(u, 3) - u - pow(v, 3) + v});
  const Ends ends{{fraction(1, 3), 0}, {1, fraction(2, 3)}};
  check_segment(system, ends);
  for (const double tolerance : {1e-2, 1e-6, 1e-10, 1e-14})
    EXPECT_LE(SC::solve(system, {.tolerance = tolerance}).summary().nodes, 150u);
  for (const auto& solution : solve_with<SC::Multiprecision_solver_traits>(system))
    EXPECT_EQ(solution.ends(), ends);
  for (const auto& solution : solve_with<SC::Exact_solver_traits>(system))
    EXPECT_EQ(solution.ends(), ends);
}

// The same curve in space: more equalities than unknowns.
TEST(Continua, OverlapInSpace)
{
  const Polynomial u = 3 * x / 4, v = 3 * y / 4 + fraction(1, 4);
  check_segment(with_equalities(cube(2, 0, 1), {u - v, pow(u, 3) - u - pow(v, 3) + v, pow(u, 2) - pow(v, 2)}),
                {{fraction(1, 3), 0}, {1, fraction(2, 3)}});
}

// A line of solutions and four roots beside it.
TEST(Continua, CommonLine)
{
  const System system =
      with_equalities(cube(2, -2, 2), {(x - y) * (x * x + y * y - 2), (x - y) * (x * y - fraction(1, 2))});
  check_segment(system, {{-2, -2}, {2, 2}}, 4);
  System half = system;
  half.add(x * x - 1, Relation::LESS);
  half.add(y, Relation::GREATER_EQUAL);
  check_segment(half, {{0, 0}, {1, 1}}, 1);
}

// Where inequalities leave one point of the line, or none.
// One of them ends on the other, which is a side of the square.
TEST(Continua, LineThatEndsOnALine)
{
  const System system = with_equalities(cube(2, 0, 1), {y * (3 * x - 1) * (x + 2), y * (3 * x - 1) * (x + y + 3)});
  const Solutions solutions = SC::solve(system);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  ASSERT_EQ(solutions.size(), 2u);
  EXPECT_EQ(solutions[0].ends(), (Ends{{0, 0}, {1, 0}}));
  EXPECT_EQ(solutions[1].ends(), (Ends{{fraction(1, 3), 0}, {fraction(1, 3), 1}}));
}

TEST(Continua, InequalitiesOnTheLine)
{
  System system = with_equalities(cube(2, -2, 2), {(x - y) * (x * x + y * y - 2), (x - y) * (x * y - fraction(1, 2))});
  System point = system;
  point.add(-square(x - fraction(1, 2)), Relation::GREATER_EQUAL);
  Solutions solutions = SC::solve(point);
  ASSERT_EQ(solutions.size(), 1u);
  EXPECT_EQ(solutions[0].kind(), Solution_kind::CLUSTER);
  EXPECT_TRUE(meets(solutions[0].box(), {fraction(1, 2), fraction(1, 2)}));
  System none = system;
  none.add(square(x - y), Relation::GREATER);
  solutions = SC::solve(none);
  EXPECT_EQ(solutions.size(), 4u);
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 4u);
  // At irrational points: a cover, which holds the segment between them.
  System irrational = system;
  irrational.add(x * x - 2, Relation::LESS);
  solutions = SC::solve(irrational);
  const auto continua = continua_of(solutions);
  ASSERT_EQ(continua.size(), 1u);
  EXPECT_TRUE(continua[0].ends().empty());
  for (int i = -14; i <= 14; ++i)
    EXPECT_TRUE(is_covered(continua[0], {fraction(i, 10), fraction(i, 10)})) << i;
}

TEST(Continua, CommonCircle)
{
  const Polynomial circle = x * x + y * y - 1;
  const System system = with_equalities(cube(2, -2, 2), {circle * (x - y), circle * (x + y - 3)});
  const Solutions solutions = SC::solve(system);
  EXPECT_TRUE(solutions.is_complete());
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 1u);
  const auto continua = continua_of(solutions);
  ASSERT_EQ(continua.size(), 1u);
  EXPECT_EQ(continua[0].dimension(), 1);
  for (int i = -20; i <= 20; ++i) {   // rational points of the circle
    const Rational t = fraction(i, 10), w = 1 + t * t;
    EXPECT_TRUE(is_covered(continua[0], {Rational((1 - t * t) / w), Rational(2 * t / w)}));
  }
  // each meets the circle: it has corners inside and outside, unless it is tiny and the circle touches it
  for (const auto& box : continua[0].cover()) {
    if (box[0].second - box[0].first < fraction(1, 100000))
      continue;
    bool is_inside = false, is_outside = false;
    for (const Rational& a : {box[0].first, box[0].second})
      for (const Rational& b : {box[1].first, box[1].second}) {
        is_inside = is_inside || a * a + b * b < 1;
        is_outside = is_outside || a * a + b * b > 1;
      }
    EXPECT_TRUE(is_inside && is_outside);
  }
}

// A common factor that is zero in one point of the domain makes no continuum.
TEST(Continua, IsolatedZeroOfTheFactor)
{
  for (const Polynomial& factor : {x + y, x * x + y * y}) {
    const Solutions solutions =
        SC::solve(with_equalities(cube(2, 0, 1), {factor * (x - fraction(1, 2)), factor * (y - fraction(1, 4))}));
    ASSERT_EQ(solutions.size(), 2u);
    EXPECT_EQ(solutions[0].kind(), Solution_kind::CERTIFIED);
    EXPECT_EQ(solutions[1].kind(), Solution_kind::CLUSTER);
    EXPECT_TRUE(meets(solutions[1].box(), {0, 0}));
  }
}

// A double root beside a line of solutions comes back once.
TEST(Continua, DoubleRootBesideALine)
{
  const Polynomial line = x - y - 1;
  const System system = with_equalities(cube(2, -2, 2), {line * (y - x * x), line * (y - 2 * x * x)});
  const Solutions solutions = SC::solve(system);
  EXPECT_TRUE(solutions.is_complete());
  ASSERT_EQ(solutions.size(), 2u);
  EXPECT_EQ(solutions[0].kind(), Solution_kind::CLUSTER);
  EXPECT_EQ(solutions[0].multiplicity(), 2);
  EXPECT_TRUE(meets(solutions[0].box(), {0, 0}));
  EXPECT_EQ(solutions[1].ends(), (Ends{{-1, -2}, {2, 1}}));
}

// A limit that ends the run leaves no part of the continuum out, and claims none that is not proved.
TEST(Continua, Limits)
{
  System system = with_equalities(cube(2, -2, 2), {(x - y) * (x * x + y * y - 2), (x - y) * (x * y - fraction(1, 2))});
  system.add((x - fraction(1, 2)) * (x + fraction(1, 3)) * (x - fraction(3, 2)), Relation::LESS_EQUAL);
  const Ends first{{-2, -2}, {fraction(-1, 3), fraction(-1, 3)}},
      second{{fraction(1, 2), fraction(1, 2)}, {fraction(3, 2), fraction(3, 2)}};
  std::size_t segments = 0;
  for (std::size_t nodes : {1, 10, 40, 60, 100, 1000}) {
    const Solutions solutions = SC::solve(system, {.node_limit = nodes});
    EXPECT_TRUE(nodes < 1000 || solutions.is_complete());
    for (const Answer& answer : solutions) {
      EXPECT_TRUE(answer.ends().empty() || answer.ends() == first || answer.ends() == second) << nodes;
      segments += !answer.ends().empty();
    }
    expect_nothing_lost({{fraction(-1, 1), fraction(-1, 1)},
                         {fraction(-1, 3), fraction(-1, 3)},
                         {1, 1},
                         {fraction(3, 2), fraction(3, 2)}},
                        solutions);
  }
  EXPECT_GE(segments, 2u);
}

TEST(Continua, ZeroEquations)
{
  Solutions solutions = SC::solve(with_equalities(cube(2, 0, 1), {Polynomial(), Polynomial()}));
  ASSERT_EQ(solutions.size(), 1u);
  EXPECT_EQ(solutions[0].kind(), Solution_kind::CONTINUUM);
  EXPECT_EQ(solutions[0].dimension(), 2);
  solutions = SC::solve(with_equalities(cube(2, -2, 2), {Polynomial(), x * x + y * y - 1}));
  ASSERT_EQ(solutions.size(), 1u);
  EXPECT_EQ(solutions[0].dimension(), 1);
}

TEST(Continua, CommonSurfaces)
{
  const Polynomial sphere = x * x + y * y + z * z - 1, plane = x - y;
  Solutions solutions = SC::solve(
      with_equalities(cube(3, -2, 2), {sphere * (x - y), sphere * (x + y - 3), sphere * (z - fraction(3, 2))}));
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 1u);
  ASSERT_EQ(continua_of(solutions).size(), 1u);
  EXPECT_EQ(continua_of(solutions)[0].dimension(), 2);
  for (const std::vector<Rational>& point : {std::vector<Rational>{1, 0, 0},
                                             {0, fraction(3, 5), fraction(-4, 5)},
                                             {fraction(2, 3), fraction(-2, 3), fraction(1, 3)}})
    EXPECT_TRUE(is_covered(continua_of(solutions)[0], point));
  solutions =
      SC::solve(with_equalities(cube(3, -2, 2), {square(plane) * (x + z), plane * (x * y - 1), plane * (x + y + z)}));
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 0u);   // x = -z, x y = 1, y = 0
  ASSERT_EQ(continua_of(solutions).size(), 1u);
  EXPECT_EQ(continua_of(solutions)[0].dimension(), 2);
}

// Curves without a common factor: not proved, but no more than one-dimensional, and soon. The work does not depend on
// the tolerance.
TEST(Continua, SuspectedCurves)
{
  const Polynomial sphere = x * x + y * y + z * z - 2, cone = x * x + y * y - z * z;
  struct Case
  {
    System system;
    std::vector<std::vector<Rational>> points;
  };
  const std::vector<Case> cases{
      {with_equalities(cube(3, -1, 1), {x - y, x * x - z, x * x * x - y * z}),
       {{0, 0, 0}, {fraction(-1, 2), fraction(-1, 2), fraction(1, 4)}, {1, 1, 1}}},
      // Rays that are reflected in a circle and come back after three times: the equilateral triangles, by the tangents
      // of half the angles.
      {with_equalities(cube(3, -3, 3),
                       {4 * square(1 + x * y) - (1 + x * x) * (1 + y * y),
                        4 * square(1 + y * z) - (1 + y * y) * (1 + z * z),
                        4 * square(1 + z * x) - (1 + z * z) * (1 + x * x)}),
       {}},
      {with_equalities(cube(3, -2, 2), {sphere, cone, sphere * x + cone * y}),
       {{1, 0, 1}, {fraction(3, 5), fraction(4, 5), -1}}}};
  for (const Case& test : cases) {
    const Solutions solutions = SC::Subdivision_solver_d<>()(test.system);
    EXPECT_GE(solutions.size(), 1u);
    EXPECT_FALSE(solutions.is_complete());
    EXPECT_EQ(solutions.summary().why_not, SC::Undecided_reason::CONTINUUM);
    for (const Answer& answer : solutions) {
      EXPECT_EQ(answer.reason(), SC::Undecided_reason::CONTINUUM);
      EXPECT_EQ(answer.dimension(), 1);
      EXPECT_FALSE(answer.cover().empty());
    }
    for (const auto& point : test.points)
      EXPECT_TRUE(std::any_of(solutions.begin(), solutions.end(),
                              [&](const Answer& answer) { return is_covered(answer, point); }));
    EXPECT_EQ(SC::Subdivision_solver_d<>({.tolerance = 1e-5})(test.system).summary().nodes, solutions.summary().nodes);
    EXPECT_LT(solutions.summary().nodes, 2000u);
  }
}

// B-spline curves that overlap with other knots: pieces of the segment in many cells become one.
TEST(Continua, SplinesOverlap)
{
  using Spline = SC::Bspline_function<Rational>;
  const auto on_variable = [](int variable, const Spline& spline) {
    return SC::Spline_function::from_bezier_pieces({variable}, {spline.breaks(0)}, spline.bezier_pieces());
  };
  const int pieces = 5;
  for (int degree : {2, 3}) {
    const auto knots = [&](const Rational& begin) {
      std::vector<Rational> result(degree + 1, begin);
      for (int i = 1; i < pieces; ++i)
        result.push_back(begin + fraction(i, pieces));
      result.insert(result.end(), degree + 1, begin + 1);
      return result;
    };
    std::vector<Rational> a{0, 1, 2, 4, 3, 5, 6, 8}, b{0, 3, -2, 1, 4, 2, -1, 0};
    a.resize(pieces + degree);
    b.resize(pieces + degree);
    const Spline first[2]{Spline({degree}, {knots(0)}, a), Spline({degree}, {knots(0)}, b)};
    const Spline second[2]{Spline({degree}, {knots(fraction(1, 4))}, a), Spline({degree}, {knots(fraction(1, 4))}, b)};
    System same(std::vector<System::Domain>{{0, 1}, {0, 1}}),
        shifted(std::vector<System::Domain>{{fraction(1, 3), 1}, {fraction(1, 4), fraction(9, 10)}});
    for (int i : {0, 1}) {
      same.add(on_variable(0, first[i]) - on_variable(1, first[i]), Relation::EQUAL);
      shifted.add(on_variable(0, first[i]) - on_variable(1, second[i]), Relation::EQUAL);
    }
    check_segment(same, {{0, 0}, {1, 1}});
    check_segment(shifted, {{fraction(1, 3), fraction(7, 12)}, {fraction(13, 20), fraction(9, 10)}});
  }
}

// Random systems h g_i = 0 with a planted h: the continuum is where h is zero, and the roots beside it are those of g =
// 0 that are not on it.
TEST(Continua, PlantedComponents)
{
  std::mt19937 random(7);
  const auto number = [&](int largest, int denominator) {
    return fraction(std::uniform_int_distribution<int>(-largest, largest)(random), denominator);
  };
  std::size_t segments = 0, covers = 0, roots = 0;
  for (int test = 0; test < 200; ++test) {
    SCOPED_TRACE(test);
    const int n = test % 5 == 4 ? 3 : 2;
    const std::vector<Polynomial> v{x, y, z};
    std::vector<Rational> on, off;   // a zero of h, and one of g
    for (int j = 0; j < n; ++j) {
      on.push_back(number(9, 10));
      off.push_back(number(9, 10));
    }
    const auto linear = [&](const std::vector<Rational>& point) {
      Polynomial sum;
      for (int j = 0; j < n; ++j)
        sum += (v[j] - point[j]) * Polynomial(number(5, 1));
      return sum;
    };
    const bool is_line = test % 2 == 0;
    Polynomial h = linear(on);
    if (!is_line)
      h += Polynomial(number(2, 1)) * square(x - on[0]) + (y - on[1]) * (y - on[1]) +
          (x - on[0]) * (y - on[1]) * Polynomial(number(2, 1));
    System system = cube(n, -1, 1), cofactors = cube(n, -1, 1);
    for (int i = 0; i < n; ++i) {
      const Polynomial g = linear(off) +
          (n == 2
               ? square(x - off[0]) * Polynomial(number(3, 1)) + (x - off[0]) * (y - off[1]) * Polynomial(number(3, 1))
               : Polynomial());
      system.add(h * g, Relation::EQUAL);
      cofactors.add(g, Relation::EQUAL);
    }
    const Solutions solutions = SC::solve(system), expected = SC::solve(cofactors);
    if (h.is_constant() || !expected.is_complete() || expected.count(Solution_kind::CERTIFIED) != expected.size())
      continue;   // the cofactors are a case of their own
    const auto continua = continua_of(solutions);
    // an ellipse that is a point, as a rule
    const bool is_singular = CGAL::is_zero(h.derivative(0)(on)) && CGAL::is_zero(h.derivative(1)(on));
    EXPECT_TRUE(is_singular ||
                std::any_of(continua.begin(), continua.end(), [&](const Answer& c) { return is_covered(c, on); }))
        << h;
    expect_nothing_lost({Point(on.begin(), on.end())}, solutions);
    std::size_t beside = 0;
    for (const Answer& root : expected) {
      std::vector<Rational> middle;
      for (const auto& [lower, upper] : root.exact_box())
        middle.push_back((lower + upper) / 2);
      if (CGAL::abs(h(middle)) < fraction(1, 1000000))
        continue;   // on the continuum, or nearly
      ++beside;
      std::size_t holders = 0;
      for (const Answer& answer : solutions)
        holders += answer.is_certified() && meets(answer.box(), Point(middle.begin(), middle.end()));
      EXPECT_EQ(holders, 1u);
    }
    EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), beside);
    expect_consistent_regions(solutions);
    for (const Answer& answer : solutions) {
      const bool is_proved_again = verify(system, answer);
      EXPECT_TRUE(is_proved_again || (!answer.is_certified() && answer.ends().empty())) << answer.kind();
    }
    for (const Answer& c : continua) {
      EXPECT_EQ(c.dimension(), n - 1);
      for (const auto& end : c.ends())
        EXPECT_TRUE(CGAL::is_zero(h(end)));
      segments += !c.ends().empty();
      covers += c.ends().empty();
    }
    roots += beside;
  }
  EXPECT_GT(segments, 60u);
  EXPECT_GT(covers, 60u);
  EXPECT_GT(roots, 60u);
}

} // namespace continua_test
