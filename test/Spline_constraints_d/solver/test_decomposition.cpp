// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Systems solved after decomposition have the answers that they have as a whole. Runs in its own folder.

#include "random_systems.h"
#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/IO/read_minibex.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposed_solutions.h>
#include <CGAL/Spline_constraints_d/solver/multiplicity.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace decomposition_test {

using namespace solver_test;
using Solutions = SC::Solution_set_d<double>;

static std::vector<SC::Solution_d<double>> solutions_of_parts(const System& system, const SC::Solver_options& options,
                                                             SC::internal::Run_control& control, SC::Summary& summary)
{
  return SC::internal::solutions_of_parts<SC::Certified_solver_traits, CGAL::Sequential_tag>(
      system, SC::internal::decomposition_of(system), options, control, summary);
}

// Decomposed, however small the system is.
static Solutions by_parts(const System& system, const SC::Solver_options& options = {})
{
  return SC::internal::solution_set<SC::Certified_solver_traits, CGAL::Sequential_tag>(system, options,
                                                                                       &solutions_of_parts);
}

// The answers belong together one by one.
static void expect_equal(const System& system, const Solutions& whole, const Solutions& parts)
{
  ASSERT_TRUE(whole.is_complete());
  EXPECT_TRUE(parts.is_complete()) << parts.summary();
  ASSERT_EQ(whole.size(), parts.size());
  for (const auto& answer : parts) {
    const auto box = answer.exact_box();
    std::size_t partners = 0;
    for (const auto& other : whole)
      if (SC::internal::touch(box, other.exact_box())) {
        ++partners;
        EXPECT_EQ(answer.kind(), other.kind());
        EXPECT_TRUE(other.multiplicity() == 0 || answer.multiplicity() == other.multiplicity())
            << answer.multiplicity() << " instead of " << other.multiplicity();
      }
    EXPECT_EQ(partners, 1u);
    EXPECT_TRUE(verify(system, answer)) << answer.kind();
  }
  expect_consistent_regions(parts);
}

static System satellites(const std::vector<std::vector<Rational>>& places, const std::vector<Rational>& receiver)
{
  System system = cube(4, -1000, 1000);
  const auto x = variables(4);
  for (const auto& place : places) {
    Polynomial distance;
    double squared = 0;
    for (int j = 0; j < 3; ++j) {
      distance += square(x[j] - place[j]);
      squared += std::pow(CGAL::to_double(Rational(place[j] - receiver[j])), 2);
    }
    system.add(distance - square(x[3] + Rational(std::sqrt(squared)) - receiver[3]), Relation::EQUAL);
  }
  return system;
}

// Four distances with a common unknown error, from points one apart, in a box of 2000: the differences are linear.
TEST(Decomposition, Multilateration)
{
  Random_numbers random(1);
  for (int test = 0; test < 20; ++test) {
    std::vector<Rational> receiver;
    for (int j = 0; j < 4; ++j)
      receiver.push_back(random.ratio(-90, 90, 9));
    const System system = satellites({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, receiver);
    const Solutions solutions = SC::solve(system);
    EXPECT_TRUE(solutions.is_complete());
    EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), solutions.size());
    EXPECT_LT(solutions.summary().nodes, 500u);
    std::size_t near = 0;
    for (const auto& solution : solutions) {
      EXPECT_TRUE(verify(system, solution));
      double distance = 0;
      for (int j = 0; j < 4; ++j)
        distance = (std::max)(distance, std::abs(solution.point()[j] - CGAL::to_double(receiver[j])));
      near += distance < 1e-6;
    }
    EXPECT_EQ(near, 1u);
  }
}

TEST(Decomposition, MultilaterationWithAllNumberTypes)
{
  const System system = satellites({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {3, 4, 12, -5});
  const auto check = [&](const auto& solutions) {
    EXPECT_TRUE(solutions.is_complete());
    EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 2u);
    for (const auto& solution : solutions)
      EXPECT_TRUE(verify(system, solution));
  };
  check(SC::Decomposing_solver_d<SC::Fast_solver_traits>()(system));
  check(SC::Decomposing_solver_d<SC::Interval_solver_traits>()(system));
  check(SC::Decomposing_solver_d<SC::Multiprecision_solver_traits>()(system));
  check(SC::Decomposing_solver_d<SC::Exact_solver_traits>()(system));
  check(SC::solve<CGAL::Parallel_if_available_tag>(system));
}

// Five equations with one common solution, and five without: all unknowns are eliminated but one.
TEST(Decomposition, TooManyEquations)
{
  const std::vector<std::vector<Rational>> places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  System system = satellites(places, {3, 4, 12, -5}); // squares of distances: 169, 164, 162, 146
  const auto x = variables(4);
  System exact = cube(4, -1000, 1000);
  const std::vector<Polynomial> r{x[0] - 3, x[1] - 4, x[2] - 12};
  const std::vector<std::vector<int>> far{{0, 0, 0}, {3, 4, 0}, {3, 0, 9}, {0, 4, 8}, {7, 4, 9}};
  const std::vector<int> distances{13, 12, 5, 5, 5};
  for (int wrong : {0, 1}) {
    System five = exact;
    for (std::size_t i = 0; i < far.size(); ++i)
      five.add(square(x[0] - far[i][0]) + square(x[1] - far[i][1]) + square(x[2] - far[i][2]) -
                   square(x[3] + distances[i] - 5 + (i == 4 ? wrong : 0)),
               Relation::EQUAL);
    const Solutions solutions = by_parts(five);
    EXPECT_TRUE(solutions.is_complete());
    ASSERT_EQ(solutions.size(), wrong ? 0u : 1u);
    if (!wrong) {
      EXPECT_TRUE(meets(solutions[0].exact_box(), Point{3, 4, 12, 5}));
      EXPECT_TRUE(verify(five, solutions[0]));
    }
  }
}

// Sparse quadratic equations, mixed, with equations of degree one, inequalities, and domains that end at solutions.
TEST(Decomposition, RandomSystems)
{
  Random_numbers random(2);
  int decomposed = 0, eliminated = 0, several_parts = 0, answers = 0;
  for (int test = 0; test < 400; ++test) {
    SCOPED_TRACE(test);
    const int n = random.integer(2, 4);
    const auto x = variables(n);
    std::vector<Rational> root;
    for (int j = 0; j < n; ++j)
      root.push_back(random.ratio(-4, 4, 2));
    std::vector<SC::Spline_function> rows;
    for (int i = 0; i < n; ++i) {
      const int a = random.integer(0, n - 1), b = random.integer(0, n - 1), kind = random.integer(0, 3);
      Polynomial row = (x[i] - root[i]) * random.integer(1, 3);
      if (kind == 0)
        row = row * (x[i] - random.integer(-3, 3)) + (x[a] - root[a]) * random.integer(-1, 1);
      else if (kind == 1)
        row += (x[a] - root[a]) * (x[b] + random.integer(-2, 2)) * random.integer(1, 2);
      else if (kind == 2)
        row += (x[a] - root[a]) * random.integer(0, 2) + (x[b] - root[b]) * random.integer(0, 2);
      else
        row = square(x[i]) - square(root[i]) + (x[a] - root[a]) * random.integer(0, 1);
      rows.emplace_back(row);
    }
    std::vector<System::Domain> domain;
    for (int j = 0; j < n; ++j) {
      domain.emplace_back(random.chance(20) ? root[j] : Rational(root[j] - random.integer(1, 4)),
                          root[j] + random.integer(1, 5));
    }
    System system = mixed_system(random, domain, rows);
    if (random.chance(30))
      system.add(x[0] + x[n - 1] - root[0] - root[n - 1] + random.integer(0, 1), Relation::GREATER_EQUAL);
    const Solutions whole = SC::Subdivision_solver_d<>({.node_limit = 20000})(system);
    if (!whole.is_complete() || whole.count(Solution_kind::CONTINUUM) > 0)
      continue;
    const auto decomposition = SC::internal::decomposition_of(system);
    decomposed += decomposition.parts.empty() ? 0 : 1;
    eliminated += decomposition.eliminated.empty() ? 0 : 1;
    several_parts += decomposition.parts.size() > 1 ? 1 : 0;
    answers += static_cast<int>(whole.size());
    expect_equal(system, whole, by_parts(system));
    expect_equal(system, whole, SC::solve(system));
    if (testing::Test::HasFailure())
      break;
  }
  EXPECT_GT(decomposed, 150);
  EXPECT_GT(eliminated, 100);
  EXPECT_GT(several_parts, 10);
  EXPECT_GT(answers, 300);
}

// Parts that are systems with multiple roots: multiplicities are products.
TEST(Decomposition, ProductsOfMultipleRoots)
{
  const auto x = variables(4);
  const System system =
      with_equalities(cube(4, -2, 3),
                      {square(x[0]) + square(x[2]) - 1, square(x[0] - 2) + square(x[2]) - 1, // touch at (1, 0)
                       square(x[1]) * x[1] - x[3], x[3]});
  const Solutions parts = by_parts(system);
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].kind(), Solution_kind::CLUSTER);
  EXPECT_EQ(parts[0].multiplicity(), 6);
  EXPECT_TRUE(meets(parts[0].exact_box(), Point{1, 0, 0, 0}));
  EXPECT_TRUE(verify(system, parts[0]));
}

// What is a curve in one part is one of the whole for every solution of the others.
TEST(Decomposition, CurvesTimesPoints)
{
  const auto x = variables(4);
  const System system = with_equalities(
      cube(4, -2, 2),
      {(x[0] - x[1]) * (x[0] + 3), (x[0] - x[1]) * (x[1] * x[0] + 5), square(x[2]) + x[3] - 2, x[2] * x[3] - 1});
  const Solutions parts = by_parts(system);
  EXPECT_TRUE(parts.is_complete());
  EXPECT_EQ(parts.size(), 3u); // x2 = 1 and those of x2^2 + x2 - 1 = 0
  EXPECT_EQ(parts.count(Solution_kind::CONTINUUM), parts.size());
  for (const auto& answer : parts) {
    EXPECT_EQ(answer.dimension(), 1);
    for (const auto& end : answer.ends())
      EXPECT_TRUE(SC::satisfies(system, end));
  }
}

static System read(const std::string& name)
{
  const SC::Minibex_system input = SC::read_minibex("../../examples/Spline_constraints_d/data/" + name);
  System system(input.domains);
  for (const auto& constraint : input.constraints)
    system.add(constraint.function, constraint.relation);
  return system;
}

// Circles in two unknowns and a linkage in others: the nodes are those of both, not their product.
TEST(Decomposition, IndependentBlocksAddUp)
{
  const System linkage = read("stephenson_six_bar_linkage.bch");
  std::vector<System::Domain> domain{{-30, 30}, {-30, 30}};
  for (int j = 0; j < linkage.dimension(); ++j)
    domain.push_back(linkage.domain(j));
  const auto x = variables(2);
  const System circles =
      with_equalities(cube(2, -30, 30), {square(x[0]) * x[0] + square(x[1]) - 4, square(x[0] - 1) + x[1] * x[0] - 2});
  System system(domain);
  for (const auto& f : circles.equalities())
    system.add(f, Relation::EQUAL);
  for (const auto& f : linkage.equalities()) {
    SC::Spline_function moved;
    for (SC::Spline_term term : f.terms()) {
      for (int& variable : term.variables)
        variable += 2;
      moved += SC::Spline_function(std::move(term));
    }
    system.add(std::move(moved), Relation::EQUAL);
  }
  const Solutions whole = SC::Subdivision_solver_d<>()(system), parts = by_parts(system);
  expect_equal(system, whole, parts);
  EXPECT_EQ(parts.size(), by_parts(circles).size() * by_parts(linkage).size());
  EXPECT_LE(parts.summary().nodes, by_parts(circles).summary().nodes + by_parts(linkage).summary().nodes);
  EXPECT_LT(2 * parts.summary().nodes, whole.summary().nodes);
}

// A cycle of equations has no parts, and the same nodes.
TEST(Decomposition, CyclicChebyshevStaysWhole)
{
  const Problem problem = cyclic_chebyshev(3, 3);
  EXPECT_TRUE(SC::internal::decomposition_of(problem.system).parts.empty());
  const Solutions whole = SC::Subdivision_solver_d<>()(problem.system), parts = SC::solve(problem.system);
  expect_equal(problem.system, whole, parts);
  EXPECT_EQ(parts.summary().nodes, whole.summary().nodes);
}

TEST(Decomposition, SplinesKeepTheirUnknowns)
{
  const auto x = variables(3);
  const SC::Bspline_function<Rational> spline({2}, {{0, 0, 0, fraction(1, 2), 1, 1, 1}}, {-1, 2, -1, 3});
  System system(std::vector<System::Domain>{{0, 1}, {-9, 9}, {-9, 9}});
  system.add(SC::Spline_function::from_bezier_pieces({0}, {spline.breaks(0)}, spline.bezier_pieces()), Relation::EQUAL);
  system.add(x[1] - x[0] * 2 + 1, Relation::EQUAL);
  system.add(x[2] * x[2] - 2, Relation::EQUAL);
  const auto decomposition = SC::internal::decomposition_of(system);
  EXPECT_EQ(decomposition.parts.size(), 2u);
  EXPECT_EQ(decomposition.eliminated.size(), 1u);
  expect_equal(system, SC::Subdivision_solver_d<>()(system), by_parts(system));
}

struct Stopping_visitor
{
  int left;
  void on_progress(double) {}
  bool stop() { return --left < 0; }
};

// Nothing is lost at a limit.
TEST(Decomposition, Limits)
{
  const auto x = variables(4);
  std::vector<Polynomial> functions;
  for (int i : {0, 2}) {
    const Polynomial &a = x[i], &b = x[i + 1];
    functions.push_back(chebyshev(7, a) - b);
    functions.push_back(chebyshev(7, b) - a);
  }
  const System system = with_equalities(cube(4, -1, 1), functions);
  EXPECT_EQ(SC::internal::decomposition_of(system).parts.size(), 2u);
  const std::vector<Point> known = cyclic_chebyshev(2, 7).known;
  std::vector<Point> all;
  for (const Point& a : known)
    for (const Point& b : known)
      all.push_back({a[0], a[1], b[0], b[1]});
  const auto check = [&](const SC::Solver_options& options, bool is_complete) {
    const Solutions solutions = SC::solve(system, options);
    EXPECT_EQ(solutions.is_complete(), is_complete);
    expect_nothing_lost(all, solutions);
    return solutions;
  };
  EXPECT_EQ(check({}, true).size(), 49u * 49u);
  for (const std::size_t limit : {10u, 300u, 500u})
    EXPECT_LE(check({.node_limit = limit}, false).summary().nodes, limit + 2);
  for (const int left : {0, 3, 6}) {
    Stopping_visitor visitor{left};
    check({.visitor = visitor}, false);
  }
  check({.time_limit = 1e-9}, false);
}

// Equalities that say the same twice take no solution away, and those that contradict each other leave none.
TEST(Decomposition, DependentAndContradictingEquations)
{
  const auto x = variables(3);
  const Polynomial circle = square(x[0]) + square(x[1]) - 5, line = x[0] - x[1] - 1, last = x[2] - x[0] * 2;
  for (const auto& functions : {std::vector<Polynomial>{circle, line, line * 2, last},
                                {circle, circle * 3, line, last, last},
                                {circle, line, last + line, last - line * 2},
                                {circle + line, circle - line, line, last, last + circle}}) {
    const System system = with_equalities(cube(3, -5, 5), functions);
    const auto decomposition = SC::internal::decomposition_of(system);
    EXPECT_EQ(decomposition.parts.size(), 1u);
    EXPECT_EQ(decomposition.eliminated.size(), 2u);
    const Solutions parts = by_parts(system);
    EXPECT_TRUE(parts.is_complete());
    EXPECT_EQ(parts.size(), 2u);
    expect_nothing_lost({{2, 1, 4}, {-1, -2, -2}}, parts);
    for (const auto& answer : parts) {
      EXPECT_TRUE(answer.kind() < Solution_kind::CONTINUUM);
      EXPECT_TRUE(verify(system, answer));
    }
  }
  for (const auto& functions : {std::vector<Polynomial>{circle, line, line * 2 - 1, last},
                                {circle, circle - 1, line, last},
                                {circle, line, last, last - line * 3 + 1}}) {
    const System system = with_equalities(cube(3, -5, 5), functions);
    EXPECT_TRUE(SC::internal::decomposition_of(system).is_without_solutions);
    const Solutions parts = by_parts(system);
    EXPECT_TRUE(parts.is_complete());
    EXPECT_TRUE(parts.empty());
  }
}

// An unknown that nothing determines makes a curve, whatever else is determined twice.
TEST(Decomposition, FreeUnknowns)
{
  const auto x = variables(4);
  const Polynomial circle = square(x[0]) + square(x[1]) - 5, line = x[0] - x[1] - 1;
  for (const auto& functions :
       {std::vector<Polynomial>{circle, line, line * 2, x[2] - 1}, {circle, line, x[2] - x[3], x[2] * 2 - x[3] * 2}}) {
    const System system = with_equalities(cube(4, -5, 5), functions);
    EXPECT_TRUE(SC::internal::decomposition_of(system).parts.empty());
    const Solutions solutions = by_parts(system);
    int points = 0;
    for (const int t : {-5, 0, 1, 4})
      for (const std::vector<Rational>& point :
           std::vector<std::vector<Rational>>{{2, 1, 1, t}, {-1, -2, 1, t}, {2, 1, t, t}, {-1, -2, t, t}}) {
        if (!SC::satisfies(system, point))
          continue;
        ++points;
        EXPECT_TRUE(std::any_of(solutions.begin(), solutions.end(), [&](const auto& answer) {
          return meets(answer.exact_box(), Point(point.begin(), point.end()));
        }));
      }
    EXPECT_GE(points, 8);
    EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 0u);
  }
}

// Domains that end at the values of eliminated unknowns, or before.
TEST(Decomposition, DomainsOfEliminatedUnknowns)
{
  const auto x = variables(3);
  const Polynomial last = x[2] - x[0] * 3 - x[1] + 1;
  const std::vector<Polynomial> functions{x[0] * (x[0] - 1) * (x[0] + 1), square(x[1]) + x[1] - x[0] - 2 + x[1] * last,
                                          last};
  const System wide = with_equalities(cube(3, -8, 8), functions);
  const Solutions all = by_parts(wide);
  EXPECT_EQ(all.size(), 6u);
  EXPECT_EQ(SC::internal::decomposition_of(wide).eliminated.size(), 1u);
  for (const auto& [lower, upper, count] : {std::tuple(0, 8, 2), {-3, 8, 4}, {-3, 0, 3}, {1, 2, 0}, {-8, -4, 1}}) {
    const System narrow = with_equalities(System({{-8, 8}, {-8, 8}, {Rational(lower), Rational(upper)}}), functions);
    const Solutions whole = SC::Subdivision_solver_d<>()(narrow);
    const auto decomposition = SC::internal::decomposition_of(narrow);
    EXPECT_TRUE(decomposition.is_without_solutions || decomposition.eliminated.size() == 1);
    expect_equal(narrow, whole, by_parts(narrow));
    std::size_t inside = 0;
    for (const auto& answer : all)
      inside += answer[2].second > lower && answer[2].first < upper;
    EXPECT_EQ(whole.size(), inside);
    EXPECT_EQ(static_cast<int>(inside), count);
  }
}

// An unknown that is a difference of others, a million times: its range is as narrow as those of other unknowns, and
// that of a cluster not wide.
TEST(Decomposition, SteepSlopes)
{
  const auto x = variables(3);
  const Polynomial last = x[2] * fraction(1, 1000000) - x[0] + x[1];
  const std::vector<Polynomial> simple{square(x[0]) - 2, square(x[1]) * x[1] - fraction(2828427, 1000000), last},
      twice{square(x[0]) - 2 + x[2] * last, square(square(x[1]) - 2), last};
  for (const auto* functions : {&simple, &twice}) {
    const System system = with_equalities(System({{-9, 9}, {-9, 9}, {-20000000, 20000000}}), *functions);
    EXPECT_EQ(SC::internal::decomposition_of(system).eliminated.size(), 1u);
    const Solutions parts = by_parts(system);
    EXPECT_TRUE(parts.is_complete());
    EXPECT_EQ(parts.size(), functions == &simple ? 2u : 4u);
    for (const auto& answer : parts) {
      EXPECT_EQ(answer.kind(), functions == &simple ? Solution_kind::CERTIFIED : Solution_kind::CLUSTER);
      const double size = (std::max)({std::abs(answer[2].first), std::abs(answer[2].second), 1.0});
      EXPECT_LE(answer[2].second - answer[2].first, size * (answer.is_certified() ? 0x1p-44 : 1e-4));
      EXPECT_TRUE(verify(system, answer));
    }
    expect_consistent_regions(parts);
  }
}

// Two million combinations of a few hundred nodes: the run ends in time, and what it does not tell is undecided.
TEST(Decomposition, ManyCombinations)
{
  const auto x = variables(7);
  std::vector<Polynomial> functions;
  for (int j = 0; j < 7; ++j)
    functions.push_back(chebyshev(8, x[j]));
  const System system = with_equalities(cube(7, -1, 1), functions);
  Stopping_visitor visitor{100};
  for (const SC::Solver_options& options : {SC::Solver_options{.time_limit = 0.2}, {.visitor = visitor}}) {
    const Solutions solutions = by_parts(system, options);
    EXPECT_FALSE(solutions.is_complete());
    EXPECT_EQ(solutions.summary().why_not,
              options.time_limit > 0 ? SC::Undecided_reason::TIME : SC::Undecided_reason::STOPPED);
    EXPECT_LT(solutions.summary().seconds, 2);
    EXPECT_EQ(solutions.count(Solution_kind::UNDECIDED), 1u);
    EXPECT_GE(solutions.count(Solution_kind::CERTIFIED), 1000u);
    Random_numbers random(3);
    std::vector<Point> some;
    for (int i = 0; i < 20; ++i) {
      Point point;
      for (int j = 0; j < 7; ++j)
        point.emplace_back(std::cos((2 * random.integer(0, 7) + 1) * std::acos(-1.0) / 16));
      some.push_back(point);
    }
    for (const Point& point : some)
      EXPECT_TRUE(meets(solutions[solutions.size() - 1].exact_box(), point));
  }
}

// The work before the subdivision is bounded, and ends where it is told to.
TEST(Decomposition, WorkIsBounded)
{
  constexpr int n = 40;
  Random_numbers random(4);
  const auto x = variables(n);
  std::vector<Polynomial> functions;
  for (int i = 0; i < n; ++i) {
    Polynomial sum = square(x[i]) * (i % 8 == 0 ? 1 : 0) - 1;
    for (int k = 0; k < 20; ++k)
      sum += x[random.integer(0, n - 1)] * random.ratio(-99, 99, 97);
    functions.push_back(sum);
  }
  const System system = with_equalities(cube(n, -1, 1), functions);
  int checks = 0;
  const auto decomposition = SC::internal::decomposition_of(system, [&] { ++checks; });
  EXPECT_GT(checks, 100);
  const SC::internal::Run_stopped stopped{SC::Undecided_reason::STOPPED};
  for (const int last : {0, 1, checks / 2}) {
    int left = last;
    EXPECT_THROW(SC::internal::decomposition_of(system,
                                                [&] {
                                                  if (--left < 0)
                                                    throw stopped;
                                                }),
                 SC::internal::Run_stopped);
  }
}

// A limit is told by its name, also when it is reached between the trial and the parts.
TEST(Decomposition, ReasonsOfLimits)
{
  const System system = with_equalities(cube(4, -1, 1), [] {
    const auto x = variables(4);
    return std::vector<Polynomial>{chebyshev(7, x[0]) - x[1], chebyshev(7, x[1]) - x[0], chebyshev(7, x[2]) - x[3],
                                   chebyshev(7, x[3]) - x[2]};
  }());
  for (int left = 0; left < 40; ++left) {
    Stopping_visitor visitor{left};
    const Solutions solutions = SC::solve(system, {.visitor = visitor});
    EXPECT_TRUE(std::none_of(solutions.begin(), solutions.end(), [](const auto& answer) {
      return answer.kind() == Solution_kind::UNDECIDED && answer.reason() != SC::Undecided_reason::STOPPED;
    })) << left;
  }
  struct Failing_visitor
  {
    int left;
    void on_progress(double) {}
    bool stop()
    {
      if (--left < 0)
        throw std::runtime_error("visitor");
      return false;
    }
  };
  for (int left = 0; left < 10; ++left) {
    Failing_visitor visitor{left};
    EXPECT_THROW(SC::solve(system, {.visitor = visitor}), std::runtime_error) << left;
  }
}

} // namespace decomposition_test
