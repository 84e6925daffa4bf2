// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Systems in one unknown: the answer is always complete, multiple roots and continua included, and every part of it is
// proved again.

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/own_traits.h>

#include <algorithm>
#include <cstring>
#include <random>

namespace univariate_test {

using namespace solver_test;

static const Polynomial x = Polynomial::variable(0);

static System on(const Rational& lower, const Rational& upper, const std::vector<SC::Spline_function>& equalities)
{
  System system({{lower, upper}});
  for (const SC::Spline_function& function : equalities)
    system.add(function, Relation::EQUAL);
  return system;
}

static System with(System system, const SC::Spline_function& function, Relation relation)
{
  system.add(function, relation);
  return system;
}

static Rational power_of_ten(int exponent)
{
  Rational result(1);
  for (int i = 0; i < std::abs(exponent); ++i)
    result *= 10;
  return exponent < 0 ? Rational(1 / result) : result;
}

struct Expected
{
  Coordinate at;
  int multiplicity = 1;   // 0: not regular, multiplicity unknown
};

// Exactly these solutions, in order, each in a narrow box of its own, and nothing else.
static SC::Solution_set_d<double> expect_solutions(const System& system, const std::vector<Expected>& expected,
                                                   const SC::Solver_options& options = {})
{
  const auto solutions = solve(system, options);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.size(), expected.size());
  for (const Expected& e : expected) {
    std::size_t holders = 0;
    for (const auto& solution : solutions)
      if (meets(solution.exact_box(), {e.at})) {
        ++holders;
        EXPECT_EQ(solution.kind(), e.multiplicity == 1 ? Solution_kind::CERTIFIED : Solution_kind::CLUSTER)
            << text_of({e.at});
        EXPECT_EQ(solution.multiplicity(), e.multiplicity) << text_of({e.at});
      }
    EXPECT_EQ(holders, 1u) << text_of({e.at});
  }
  for (const auto& solution : solutions) {
    EXPECT_TRUE(verify(system, solution)) << solution.kind() << ' ' << solution[0].first << ' ' << solution[0].second;
    EXPECT_LE(solution[0].second - solution[0].first, 0x1p-49 * std::abs(solution[0].first));
    for (const auto& other : solutions)
      EXPECT_TRUE(&solution == &other || solution.exact_box()[0].second < other.exact_box()[0].first ||
                  other.exact_box()[0].second < solution.exact_box()[0].first);
  }
  expect_consistent_regions(solutions);
  return solutions;
}

static Coordinate root_of_two(double sign) { return Coordinate::near(sign * std::sqrt(2.0), 1e-15); }

TEST(Univariate, Chebyshev)
{
  for (int n : {1, 2, 3, 4, 7, 10, 16, 20, 25, 32, 40}) {
    SCOPED_TRACE(n);
    std::vector<Expected> roots;
    for (int k = 1; k <= n; ++k)
      roots.push_back({2 * k - 1 == n ? Coordinate(0)
                                      : Coordinate::near(std::cos(std::acos(-1.0) * (2 * k - 1) / (2 * n)), 1e-15)});
    const auto solutions = expect_solutions(on(-1, 1, {chebyshev(n, x)}), roots);
    for (const auto& solution : solutions)
      EXPECT_EQ(std::strcmp(solution.number_type(), "double"), 0);
    std::vector<Expected> extrema;   // 1 - T_n^2 = (1 - x^2) U_{n-1}^2
    for (int k = 0; k <= n; ++k)
      extrema.push_back({k == 0           ? Coordinate(1)
                             : k == n     ? Coordinate(-1)
                             : 2 * k == n ? Coordinate(0)
                                          : Coordinate::near(std::cos(std::acos(-1.0) * k / n), 1e-15),
                         k == 0 || k == n ? 1 : 2});
    if (n <= 16)
      expect_solutions(on(-1, 1, {1 - square(chebyshev(n, x))}), extrema);
  }
}

TEST(Univariate, Wilkinson)
{
  Polynomial f(1);
  std::vector<Expected> roots;
  for (int i = 1; i <= 20; ++i) {
    f *= x - i;
    roots.push_back({Rational(i)});
  }
  expect_solutions(on(0, 21, {f}), roots);
  expect_solutions(on(1, 20, {f}), roots);   // two of them at the ends of the domain
  const Rational shift = fraction(1, 8388608);   // 2^-23: the roots 10 to 19 become complex
  EXPECT_EQ(solve(on(0, 22, {f - shift * pow(x, 19)})).count(Solution_kind::CERTIFIED), 10u);
}

TEST(Univariate, Mignotte)
{
  const Polynomial line = 1000000 * x - 1;
  const System system = on(-100, 100, {pow(x, 10) - 2 * square(line)});
  const auto solutions = solve(system);
  EXPECT_TRUE(solutions.is_complete());
  ASSERT_EQ(solutions.size(), 4u);
  ASSERT_EQ(solutions.count(Solution_kind::CERTIFIED), 4u);
  for (const auto& solution : solutions)
    EXPECT_TRUE(verify(system, solution));
  const auto left = solutions[1].exact_box()[0], right = solutions[2].exact_box()[0];
  EXPECT_LT(left.second, right.first);
  EXPECT_LT(left.second, power_of_ten(-6));
  EXPECT_LT(power_of_ten(-6), right.first);
  EXPECT_LT(right.second - left.first, power_of_ten(-35));
  expect_consistent_regions(solutions);
}

TEST(Univariate, MultipleRoots)
{
  expect_solutions(on(-2, 2, {square(x * x - 2) * pow(x - 1, 3)}), {{root_of_two(-1), 2}, {root_of_two(1), 2}, {1, 3}});
  expect_solutions(on(-2, 2, {pow(3 * x - 1, 5) * pow(7 * x + 2, 2) * (x - 1) * pow(x * x + 1, 3)}),
                   {{fraction(1, 3), 5}, {fraction(-2, 7), 2}, {1}});
  expect_solutions(on(-1, 1, {pow(x, 17)}), {{0, 17}});
  expect_solutions(on(0, 1, {pow(x, 4) * square(1 - x)}), {{0, 4}, {1, 2}});
  // a double root and a simple one closer to it than doubles are
  const Rational gap = power_of_ten(-40);
  expect_solutions(on(0, 1, {square(3 * x - 1) * (x - fraction(1, 3) - gap)}),
                   {{fraction(1, 3), 2}, {Rational(fraction(1, 3) + gap)}});
  // roots of different factors between the same doubles
  expect_solutions(
      on(0, 1, {square(3 * x - 1) * (3 * x - 1 - gap) * pow(3 * x - 1 + gap, 3)}),
      {{fraction(1, 3), 2}, {Rational(fraction(1, 3) + gap / 3)}, {Rational(fraction(1, 3) - gap / 3), 3}});
}

TEST(Univariate, CloseRoots)
{
  for (int digits : {5, 10, 15, 16, 17, 20, 40, 100})
    for (const Rational& middle : {Rational(0), fraction(1, 3), Rational(1), Rational(-1000000)}) {
      SCOPED_TRACE(digits);
      const Rational gap = power_of_ten(-digits);
      const System crossing = on(middle - 1, middle + 1, {square(x - middle) - gap * gap / 4});
      const auto solutions = solve(crossing);
      EXPECT_TRUE(solutions.is_complete());
      EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 2u);
      ASSERT_EQ(solutions.size(), 2u);
      for (int i : {0, 1}) {
        EXPECT_TRUE(meets(solutions[i].exact_box(), {Rational(middle + gap * (2 * i - 1) / 2)}));
        EXPECT_TRUE(verify(crossing, solutions[i]));
      }
      EXPECT_LT(solutions[0].exact_box()[0].second, solutions[1].exact_box()[0].first);
      expect_consistent_regions(solutions);
      const auto none = solve(on(middle - 1, middle + 1, {square(x - middle) + gap * gap / 4}));
      EXPECT_TRUE(none.empty());
      EXPECT_TRUE(none.is_complete());
    }
}

TEST(Univariate, EndsOfTheDomain)
{
  const Rational third = fraction(1, 3), tiny = power_of_ten(-30);
  expect_solutions(on(third, 1, {3 * x - 1}), {{third}});
  expect_solutions(on(third, 1, {(3 * x - 1) * (x - third - tiny)}), {{third}, {Rational(third + tiny)}});
  expect_solutions(on(third, 1, {(x - third + tiny) * (x - third - tiny)}), {{Rational(third + tiny)}});
  expect_solutions(on(0, third, {(x - third + tiny) * (x - third - tiny) * (x - 1)}), {{Rational(third - tiny)}});
  expect_solutions(on(-1, 1, {square(x * x - 1) * x}), {{-1, 2}, {0}, {1, 2}});
  // domains that are points, or nearly
  expect_solutions(on(third, third, {3 * x - 1}), {{third}});
  expect_solutions(on(third, third, {square(3 * x - 1)}), {{third, 2}});
  expect_solutions(on(third, third, {Polynomial()}), {{third, 0}});
  expect_solutions(on(third, third, {3 * x - 2}), {});
  expect_solutions(on(third, third + tiny, {2 * x - fraction(2, 3) - tiny}), {{Rational(third + tiny / 2)}});
  // and no others
  for (const Polynomial& f : {Polynomial(1), Polynomial(-3), x * x + 1, pow(x, 8) + tiny})
    expect_solutions(on(-1, 1, {f}), {});
  const Rational huge = Rational(1e308), small = Rational(1e-308);
  expect_solutions(on(-huge, huge, {x * x - 2}), {{root_of_two(-1)}, {root_of_two(1)}});
  expect_solutions(on(-small, small, {2 * x - small}), {{Rational(small / 2)}});
  EXPECT_THROW(solve(on(-huge * 10, huge * 10, {x * x - 2})), SC::Invalid_input);
}

TEST(Univariate, Breaks)
{
  const Rational third = fraction(1, 3);
  // a root on a break: with one slope, with two, touching, and of higher order
  const auto joined = [&](const Polynomial& left, const Polynomial& right) {
    return on(-1, 2, {piecewise(0, {-1, third, 2}, {left, right})});
  };
  expect_solutions(joined(3 * x - 1, 3 * x - 1), {{third}});
  expect_solutions(joined(3 * x - 1, 6 * x - 2), {{third}});
  expect_solutions(joined((3 * x - 1) * (x + 2), (3 * x - 1) * (x - 1) * -1), {{third}, {1}});
  expect_solutions(joined(1 - 3 * x, 6 * x - 2), {{third, 0}});
  expect_solutions(joined(3 * x - 1, square(3 * x - 1)), {{third, 0}});
  expect_solutions(joined(pow(3 * x - 1, 3), pow(3 * x - 1, 3) * 2), {{third, 0}});
  expect_solutions(joined(pow(3 * x - 1, 3), pow(3 * x - 1, 3)), {{third, 3}});   // no break at all
  // near a break, and on both sides of it
  const Rational tiny = power_of_ten(-25);
  expect_solutions(joined((x - third) * (x - third + tiny), (third - x) * (x - third - tiny)),
                   {{Rational(third - tiny)}, {third}, {Rational(third + tiny)}});
  // the extension of one piece has a root just beyond the break, where the spline has none
  expect_solutions(joined(x - third - tiny, -tiny + square(x - third) * 0), {});
  expect_solutions(joined(x - third - tiny, 2 * (x - third) - tiny), {{Rational(third + tiny / 2)}});
  // the domain ends on a break, behind which the spline is another one
  for (const Polynomial& beyond : {Polynomial(), Polynomial(1 - 3 * x)}) {
    expect_solutions(on(third, 2, {piecewise(0, {-1, third, 2}, {beyond, 3 * x - 1})}), {{third}});
    expect_solutions(on(-1, third, {piecewise(0, {-1, third, 2}, {3 * x - 1, beyond})}), {{third}});
  }
  expect_solutions(on(0, 4, {polygon(0, {2, 0, 3, fraction(1, 1000000), 1})}), {{1, 0}});
}

// Binomials beyond the range of doubles. The proof once more would take too long.
TEST(Univariate, HighDegree)
{
  const auto solutions = solve(on(fraction(63, 64), 1, {pow(x, 1200) - fraction(1, 2)}));
  ASSERT_EQ(solutions.size(), 1u);
  EXPECT_TRUE(solutions[0].is_certified());
  EXPECT_TRUE(meets(solutions[0].box(), {Coordinate::near(std::pow(0.5, 1 / 1200.0), 1e-15)}));
  EXPECT_LT(solutions[0][0].second - solutions[0][0].first, 1e-15);
}

static void expect_continua(const System& system, const std::vector<std::pair<Coordinate, Coordinate>>& continua,
                            const std::vector<Expected>& others = {})
{
  const auto solutions = solve(system);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.size(), continua.size() + others.size());
  EXPECT_EQ(solutions.count(Solution_kind::CONTINUUM), continua.size());
  std::size_t found = 0;
  for (const auto& solution : solutions) {
    EXPECT_TRUE(verify(system, solution)) << solution.kind();
    const auto range = solution.exact_box()[0];
    if (solution.kind() == Solution_kind::CONTINUUM)
      for (const auto& [lower, upper] : continua)   // exact where it is rational
        found += lower.lower <= range.first && range.first <= lower.upper && upper.lower <= range.second &&
            range.second <= upper.upper;
    else
      for (const Expected& e : others)
        found += meets(solution.exact_box(), {e.at}) && solution.multiplicity() == e.multiplicity &&
            solution.is_certified() == (e.multiplicity == 1);
  }
  EXPECT_EQ(found, solutions.size());
}

TEST(Univariate, Continua)
{
  const Polynomial zero;
  const Rational third = fraction(1, 3);
  expect_continua(on(-1, third, {zero}), {{-1, third}});
  expect_continua(on(-1, third, {zero, zero}), {{-1, third}});
  // a spline that vanishes on an interval, and at a point of its own
  const System flat = on(-2, 3, {piecewise(0, {-2, 0, third, 1, 3}, {x * (x + 1), zero, zero, (x - 1) * (x - 2)})});
  expect_continua(flat, {{0, 1}}, {{-1}, {2}});
  // cut by inequalities: strict or not, at irrational points, and into single points
  expect_continua(with(on(-3, 3, {zero}), x * x - 2, Relation::LESS), {{root_of_two(-1), root_of_two(1)}});
  expect_continua(with(on(-3, 3, {zero}), x * x - 2, Relation::GREATER_EQUAL),
                  {{-3, root_of_two(-1)}, {root_of_two(1), 3}});
  expect_continua(with(on(-3, 3, {zero}), square(x * x - 2), Relation::LESS_EQUAL), {},
                  {{root_of_two(-1), 0}, {root_of_two(1), 0}});
  expect_continua(with(on(-3, 3, {zero}), square(x - third), Relation::GREATER_EQUAL), {{-3, 3}});
  expect_continua(with(on(-3, 3, {zero}), square(x - third), Relation::GREATER), {{-3, third}, {third, 3}});
  expect_continua(with(on(-3, 3, {zero}), (x + 3) * (x - 3), Relation::GREATER_EQUAL), {}, {{-3, 0}, {3, 0}});
  expect_continua(with(on(-3, 3, {zero}), x * x + 1, Relation::LESS), {});
  expect_continua(with(flat, x - third, Relation::GREATER_EQUAL), {{third, 1}}, {{2}});
  expect_continua(with(flat, x, Relation::LESS_EQUAL), {}, {{-1}, {0, 0}});
}

TEST(Univariate, Inequalities)
{
  for (const Polynomial& f :
       {Polynomial(x * x - 2), Polynomial(pow(x, 3) - 2 * x), Polynomial((x * x - 2) * (3 * x - 7))})
    for (const Relation relation : {Relation::LESS, Relation::LESS_EQUAL, Relation::GREATER, Relation::GREATER_EQUAL}) {
      const bool is_at_zero = SC::is_satisfied(relation, CGAL::ZERO),
                 is_above = relation == Relation::GREATER || relation == Relation::GREATER_EQUAL;
      // zero at both roots, and touching there
      for (const Polynomial& g :
           {Polynomial(pow(x, 4) - 4), Polynomial(square(x * x - 2)), Polynomial((x * x - 2) * (x + 17))})
        EXPECT_EQ(expect_solutions(with(on(1, 2, {f}), g, relation),
                                   is_at_zero ? std::vector<Expected>{{root_of_two(1)}} : std::vector<Expected>{})
                      .size(),
                  is_at_zero ? 1u : 0u);
      // hardly beside it
      const Rational tiny = power_of_ten(-60);
      expect_solutions(with(on(1, 2, {f}), x * x - 2 + tiny, relation),
                       is_above ? std::vector<Expected>{{root_of_two(1)}} : std::vector<Expected>{});
      expect_solutions(with(on(1, 2, {f}), x * x - 2 - tiny, relation),
                       is_above ? std::vector<Expected>{} : std::vector<Expected>{{root_of_two(1)}});
    }
  expect_solutions(with(on(-2, 2, {square(x * x - 2) * x}), x * (x * x - 2), Relation::GREATER_EQUAL),
                   {{root_of_two(-1), 2}, {0}, {root_of_two(1), 2}});
  expect_solutions(with(on(-2, 2, {square(x * x - 2) * x}), x, Relation::GREATER), {{root_of_two(1), 2}});
  // a root that violates the inequality still bounds the region of its neighbour
  const auto solutions =
      expect_solutions(with(on(0, 1, {(x - fraction(1, 2)) * (x - fraction(9, 16))}), 2 * x - 1, Relation::GREATER),
                       {{fraction(9, 16)}});
  EXPECT_GT(solutions[0].uniqueness_region()[0].first, 0.5);
}

TEST(Univariate, MoreEqualities)
{
  expect_solutions(on(-2, 2, {x * x - 2, pow(x, 3) - 2 * x}), {{root_of_two(-1)}, {root_of_two(1)}});
  expect_solutions(on(-2, 2, {square(x * x - 2) * (x - 1), pow(x * x - 2, 3), Polynomial()}),
                   {{root_of_two(-1), 2}, {root_of_two(1), 2}});
  expect_solutions(on(-2, 2, {x * x - 2, x * x - 2 - power_of_ten(-60)}), {});
  expect_solutions(on(-2, 2, {(x - 1) * (3 * x + 1), (x - 1) * (3 * x + 2)}), {{1}});
  expect_solutions(on(-2, 2, {square(x - 1), (x - 1) * (3 * x + 2)}), {{1}});
  const Rational third = fraction(1, 3);   // regular on the break by the second one
  expect_solutions(on(-1, 1, {piecewise(0, {-1, third, 1}, {third - x, x - third}), 3 * x - 1}), {{third}});
}

TEST(Univariate, Limits)
{
  const System system = on(-1, 1, {chebyshev(30, x)});
  std::vector<Point> known;
  for (int k = 1; k <= 30; ++k)
    known.push_back({Coordinate::near(std::cos(std::acos(-1.0) * (2 * k - 1) / 60), 1e-15)});
  const std::size_t needed = solve(system).summary().nodes;
  for (std::size_t limit : {std::size_t(1), std::size_t(2), std::size_t(10), needed / 2, needed - 1}) {
    const auto solutions = solve(system, {.node_limit = limit});
    EXPECT_FALSE(solutions.is_complete());
    EXPECT_EQ(solutions.summary().why_not, SC::Undecided_reason::NODES);
    EXPECT_EQ(solutions.summary().nodes, limit);
    EXPECT_EQ(solutions.count(Solution_kind::UNDECIDED), 1u);
    expect_nothing_lost(known, solutions);
    for (const auto& solution : solutions)
      EXPECT_EQ(verify(system, solution), solution.is_certified());
  }
  EXPECT_TRUE(solve(system, {.node_limit = needed}).is_complete());
  const auto late = solve(system, {.time_limit = 1e-9});
  EXPECT_EQ(late.summary().why_not, SC::Undecided_reason::TIME);
  expect_nothing_lost(known, late);
  // within exact arithmetic, and in cells that are not reached
  const System close =
      on(0, 3, {piecewise(0, {0, 1, 3}, {square(square(x) - fraction(1, 2)) * (x - 1), (x - 1) * (x - 2) * 5})});
  const std::size_t all = solve(close).summary().nodes;
  for (std::size_t limit = 1; limit < all; ++limit) {
    const auto solutions = solve(close, {.node_limit = limit});
    EXPECT_FALSE(solutions.is_complete());
    expect_nothing_lost({{Coordinate::near(std::sqrt(0.5), 1e-15)}, {1}, {2}}, solutions);
  }
}

// Continuous splines of up to four pieces, with roots and kinks on breaks, pieces that vanish, and inequalities:
// everything is proved again, and agrees with the path for many unknowns.
TEST(Univariate, RandomSplines)
{
  using General = SC::Solver_traits<double, SC::Graph_box_test, SC::Preconditioned_reduction, SC::Widest_splitter>;
  const auto meet = [](const auto& a, const auto& b) { return a[0].first <= b[0].second && b[0].first <= a[0].second; };
  std::mt19937_64 random(17);
  const auto integer = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  std::size_t certified = 0, clusters = 0, continua = 0;
  for (int test = 0; test < 400 && !testing::Test::HasFailure(); ++test) {
    SCOPED_TRACE(test);
    std::vector<Rational> breaks{fraction(integer(-9, 9), integer(1, 5))};
    for (int cells = integer(1, 4); cells > 0; --cells)
      breaks.push_back(breaks.back() + fraction(integer(1, 9), integer(1, 9)));
    const auto spline = [&] {
      std::vector<Rational> heights;
      for (std::size_t i = 0; i < breaks.size(); ++i)
        heights.push_back(integer(0, 1) == 0 ? fraction(integer(-4, 4), integer(1, 4)) : Rational(0));
      std::vector<Polynomial> pieces;
      for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        Polynomial bubble;
        for (int k = integer(0, 3) == 0 ? -1 : integer(0, 3); k >= 0; --k)
          bubble += fraction(integer(-5, 5), integer(1, 3)) * pow(x, k);
        const Rational slope = (heights[i + 1] - heights[i]) / (breaks[i + 1] - breaks[i]);
        pieces.push_back(heights[i] + slope * (x - breaks[i]) + (x - breaks[i]) * (x - breaks[i + 1]) * bubble);
      }
      return piecewise(0, breaks, pieces);
    };
    const SC::Spline_function f = spline();
    System system = on(breaks.front(), breaks.back(), {f});
    for (int count = integer(0, 2); count > 0; --count) {
      constexpr Relation relations[] = {Relation::LESS, Relation::LESS_EQUAL, Relation::GREATER,
                                        Relation::GREATER_EQUAL};
      system.add(integer(0, 3) == 0 ? f : spline(), relations[integer(0, 3)]);
    }
    const auto solutions = solve(system);
    const auto general = solve_with<General>(system, {.node_limit = 3000, .ladder_precision = 0});
    EXPECT_TRUE(solutions.is_complete());
    for (const auto& solution : solutions) {
      EXPECT_TRUE(verify(system, solution)) << solution.kind() << ' ' << solution[0].first;
      EXPECT_TRUE(std::any_of(general.begin(), general.end(), [&](const auto& other) { return meet(solution, other); }))
          << solution[0].first;
    }
    for (const auto& other : general)
      EXPECT_TRUE(other.kind() == Solution_kind::UNDECIDED ||
                  std::any_of(solutions.begin(), solutions.end(),
                              [&](const auto& solution) {
                                return meet(solution, other) && (solution.is_certified() || !other.is_certified());
                              }))
          << other[0].first;
    certified += solutions.count(Solution_kind::CERTIFIED);
    clusters += solutions.count(Solution_kind::CLUSTER);
    continua += solutions.count(Solution_kind::CONTINUUM);
  }
  EXPECT_GT(certified, 300u);
  EXPECT_GT(clusters, 50u);
  EXPECT_GT(continua, 30u);
}

// Products of planted factors: simple and multiple roots, rational ones and pairs p +- sqrt(q), against what is known
// of them.
TEST(Univariate, PlantedRoots)
{
  std::mt19937_64 random(2026);
  const auto integer = [&](int low, int high) {
    return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
  };
  std::size_t multiple = 0, irrational = 0, at_ends = 0;
  for (int test = 0; test < 1000 && !testing::Test::HasFailure(); ++test) {
    SCOPED_TRACE(test);
    Polynomial f(fraction(integer(1, 9), integer(1, 9)));
    std::vector<std::pair<Rational, Rational>> used;   // p and q of p +- sqrt(q)
    std::vector<Expected> roots;
    for (int factors = integer(1, 4); factors > 0; --factors) {
      const Rational p = fraction(integer(-20, 20), integer(1, 9)),
                     q = integer(0, 2) == 0 ? Rational(0)
                                            : fraction(2 * integer(1, 9) * integer(1, 9) * 9 * 25 + 3, 9 * 25);
      const int multiplicity = integer(0, 1) == 0 ? 1 : integer(2, 4);
      if (std::find(used.begin(), used.end(), std::pair(p, q)) != used.end())
        continue;
      used.emplace_back(p, q);
      const double r = std::sqrt(CGAL::to_double(q)), m = CGAL::to_double(p);
      if (q == Rational(0)) {
        f *= pow(x - p, multiplicity);
        roots.push_back({p, multiplicity});
      } else {
        f *= pow(square(x - p) - q, multiplicity);
        roots.push_back({Coordinate::near(m - r, 1e-12), multiplicity});
        roots.push_back({Coordinate::near(m + r, 1e-12), multiplicity});
        ++irrational;
      }
      multiple += multiplicity > 1;
    }
    if (integer(0, 3) == 0)
      f *= square(x - fraction(integer(-9, 9), 7)) + fraction(1, integer(1, 1000));
    Rational lower = -100, upper = 100;
    if (used[0].second == Rational(0) && integer(0, 1) == 0) {
      (integer(0, 1) == 0 ? lower : upper) = used[0].first;
      ++at_ends;
    }
    std::erase_if(roots, [&](const Expected& e) { return e.at.upper < lower || upper < e.at.lower; });
    expect_solutions(on(lower, upper, {f}), roots);
  }
  EXPECT_GT(multiple, 500u);
  EXPECT_GT(irrational, 500u);
  EXPECT_GT(at_ends, 100u);
}

} // namespace univariate_test
