// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Bad input, budgets, visitors, inequalities and user-defined policies of the solver.

#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/solver/own_traits.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <limits>
#include <span>
#include <thread>

namespace solver_input_test {

using namespace solver_test;

static const Polynomial x = Polynomial::variable(0);
static const Polynomial y = Polynomial::variable(1);
static const double infinity = std::numeric_limits<double>::infinity();
static const double nan_value = std::numeric_limits<double>::quiet_NaN();

// The call throws Invalid_input with a message that holds all the words.
template <class Call>
static void expect_invalid(const Call& call, const std::vector<std::string>& words)
{
  try {
    call();
  } catch (const SC::Invalid_input& error) {
    for (const std::string& word : words)
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos)
          << '"' << error.what() << "\" without " << word;
    return;
  }
  ADD_FAILURE() << "nothing was thrown";
}

TEST(Solver_input, Domain)
{
  expect_invalid([] { System({}); }, {"no unknowns"});
  expect_invalid([] { System({{0, 1}, {1, 0}}); }, {"unknown 1", "empty"});
  expect_invalid([] { System::on_box({{0, 1}, {-1, 1}, {1, 0.5}}); }, {"unknown 2", "empty"});
  for (double bad : {infinity, -infinity, nan_value}) {
    expect_invalid([=] { System::on_box({{0, 1}, {bad, 1}}); }, {"unknown 1", "not finite"});
    expect_invalid([=] { System::on_box({{0, bad}}); }, {"unknown 0", "not finite"});
  }
  expect_invalid([] { System::on_box({}); }, {"no unknowns"});
}

TEST(Solver_input, DomainBeyondDoubles)
{
  Rational huge(1e300);
  huge *= huge;
  System system({{-huge, huge}});
  system.add(x, Relation::EQUAL);
  expect_invalid([&] { solve(system); }, {"range of doubles"});
}

TEST(Solver_input, Constraints)
{
  System system = cube(2, -1, 1);
  expect_invalid([&] { system.add(Polynomial::variable(2) + x, Relation::EQUAL); }, {"unknown 2", "not in the system"});
  expect_invalid([&] { system.add(Polynomial::variable(7), Relation::LESS); }, {"unknown 7"});
  const std::vector<Rational> breaks{-1, 0, fraction(3, 4)};
  expect_invalid([&] { system.add(in_pieces(y, 1, breaks), Relation::EQUAL); }, {"unknown 1", "beyond the domain"});
  expect_invalid(
      [&] {
        system.add(in_pieces(x, 0, {fraction(-1, 2), 1}), Relation::GREATER);
      },
      {"unknown 0", "beyond the domain"});
  EXPECT_TRUE(system.equalities().empty());
  EXPECT_TRUE(system.inequalities().empty());
  system.add(in_pieces(x, 0, {-1, 0, 1}), Relation::EQUAL);
  EXPECT_EQ(system.equalities().size(), 1u);
}

TEST(Solver_input, Terms)
{
  using Term = SC::Spline_term;
  const auto invalid = [](Term term, const std::string& word) {
    expect_invalid([&] { SC::Spline_function{term}; }, {word});
  };
  const std::vector<Rational> zero{0};
  invalid({{0}, {}, {{}}, {zero}}, "differ in number");
  invalid({{0}, {0}, {}, {zero}}, "differ in number");
  invalid({{-1}, {0}, {{}}, {zero}}, "axis 0");
  invalid({{1, 1}, {0, 0}, {{}, {}}, {zero}}, "axis 1");
  invalid({{0}, {-1}, {{}}, {{}}}, "negative degree");
  invalid({{0}, {0}, {{1}}, {zero}}, "single break");
  invalid({{0}, {0}, {{0, 2, 1}}, {zero, zero}}, "break 2");
  invalid({{0}, {0}, {{0, 1, 1}}, {zero, zero}}, "break 2");
  invalid({{0}, {0}, {{0, 1, 2}}, {zero}}, "1 pieces for 2 cells");
  invalid({{0}, {1}, {{0, 1}}, {zero}}, "piece 0");
}

TEST(Solver_input, NotEnoughEqualities)
{
  expect_invalid([] { solve(cube(1, 0, 1)); }, {"0 equalities for 1 unknowns"});
  System system = cube(3, 0, 1);
  system.add(x + y, Relation::EQUAL);
  system.add(x - y, Relation::EQUAL);
  system.add(x, Relation::GREATER_EQUAL);
  expect_invalid([&] { solve(system); }, {"2 equalities for 3 unknowns"});
  expect_invalid([&] { solve_with<SC::Exact_solver_traits>(system); }, {"2 equalities for 3 unknowns"});
}

TEST(Solver_input, Options)
{
  using Options = SC::Solver_options;
  const auto invalid = [](const Options& options, const std::string& word) {
    expect_invalid([&] { SC::Subdivision_solver_d<> solver(options); }, {word});
  };
  for (double bad : {0.0, -1e-3, infinity, nan_value})
    invalid({.tolerance = bad}, "tolerance");
  for (double bad : {-1.0, nan_value})
    invalid({.time_limit = bad}, "time limit");
  for (int bad : {-1, 0, 31, 901})
    invalid({.precision = bad}, "precision");
  for (int bad : {-1, 901})
    invalid({.ladder_precision = bad}, "ladder");
  invalid({.coarsening_step = 0}, "coarsening step");
  SC::Subdivision_solver_d<> solver(
      {.tolerance = 1e-300, .time_limit = 1e300, .node_limit = 1000000, .precision = 900, .coarsening_step = 1});
  EXPECT_EQ(solver(bitangents().system).count(Solution_kind::CERTIFIED), 4u);
}

TEST(Solver_input, DegenerateSystems)
{
  // domains that are points
  System point = with_equalities(System({{fraction(1, 3), fraction(1, 3)}, {0, 1}}), {3 * x - 1, x - 2 * y});
  EXPECT_EQ(solve(point).count(Solution_kind::CERTIFIED), 1u);
  EXPECT_TRUE(verify(point, solve(point)[0]));
  EXPECT_TRUE(solve(with_equalities(System({{fraction(1, 3), fraction(1, 3)}, {0, 1}}),
                                    {3 * x - 1 - Rational(1e-20), x - 2 * y}))
                  .empty());
  // constants
  EXPECT_TRUE(solve(with_equalities(cube(1, 0, 1), {Polynomial(1)})).empty());
  EXPECT_TRUE(solve(with_equalities(cube(2, 0, 1), {x - y, Polynomial(-3)})).is_complete());
  // everything is a solution
  const auto all = solve(with_equalities(cube(1, 0, 1), {Polynomial()}), {.tolerance = 1e-2});
  expect_nothing_lost({{0}, {fraction(1, 3)}, {1}}, all);
  EXPECT_EQ(all.count(Solution_kind::CERTIFIED), 0u);
  EXPECT_FALSE(all.is_complete() && all.count(Solution_kind::CONTINUUM) == 0);
  // the same equality twice
  const auto line = solve(with_equalities(cube(2, 0, 1), {x - y, 2 * x - 2 * y}), {.tolerance = 1e-2});
  expect_nothing_lost({{0, 0}, {fraction(1, 3), fraction(1, 3)}, {1, 1}}, line);
  EXPECT_EQ(line.count(Solution_kind::CERTIFIED), 0u);
}

TEST(Solver_input, LargeAndSmallCoefficients)
{
  for (const Rational& factor : {Rational(1e-300), Rational(1e300), Rational(Rational(1e300) * Rational(1e300))})
    EXPECT_EQ(solve(with_equalities(cube(1, -2, 2), {factor * (x * x - 2)})).count(Solution_kind::CERTIFIED), 2u);
  const Rational tiny(1e-200);
  const auto solutions = solve(with_equalities(cube(1, -tiny, tiny), {x - tiny / 3}));
  ASSERT_EQ(solutions.count(Solution_kind::CERTIFIED), 1u);
  EXPECT_TRUE(meets(solutions[0].box(), {Rational(tiny / 3)}));
}

// What was not finished is undecided for the given reason, and holds what was not found.
template <class Solutions>
static void expect_cut_off(const Problem& problem, const Solutions& solutions, SC::Undecided_reason reason)
{
  EXPECT_FALSE(solutions.is_complete());
  EXPECT_EQ(solutions.summary().why_not, reason);
  expect_nothing_lost(problem.known, solutions);
  EXPECT_GT(solutions.count(Solution_kind::UNDECIDED), 0u);
  for (const auto& solution : solutions) {
    EXPECT_TRUE(solution.kind() != Solution_kind::UNDECIDED || solution.reason() == reason) << solution.reason();
    EXPECT_TRUE(!solution.is_certified() || verify(problem.system, solution));
  }
}

TEST(Solver_budget, Nodes)
{
  const Problem problem = cyclic_chebyshev(3, 4);
  const std::size_t needed = solve(problem.system).summary().nodes;
  ASSERT_GT(needed, 50u);
  for (std::size_t limit : {std::size_t(1), std::size_t(2), std::size_t(10), needed / 2, needed - 10}) {
    const auto solutions = solve(problem.system, {.node_limit = limit});
    expect_cut_off(problem, solutions, SC::Undecided_reason::NODES);
    EXPECT_LT(solutions.summary().nodes, limit + 100);
  }
  expect_solved(problem, solve(problem.system, {.node_limit = needed + 1}));
}

TEST(Solver_budget, NodesOfSplines)
{
  const Problem problem = cyclic_chebyshev_in_pieces(3);
  for (std::size_t limit : {1, 3, 20})
    expect_cut_off(problem, solve(problem.system, {.node_limit = limit}), SC::Undecided_reason::NODES);
}

TEST(Solver_budget, Time)
{
  const Problem problem = cyclic_chebyshev(8, 2);
  const auto start = std::chrono::steady_clock::now();
  expect_cut_off(problem, solve(problem.system, {.time_limit = 1e-6}), SC::Undecided_reason::TIME);
  const Problem endless = cyclic_chebyshev(14, 2);   // 16,384 solutions
  EXPECT_EQ(solve(endless.system, {.time_limit = 0.05}).summary().why_not, SC::Undecided_reason::TIME);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 20.0);
}

// Says stop the n-th time it is asked.
struct Stop_after
{
  int left;

  void on_progress(double) {}
  bool stop() { return left-- <= 0; }
};

// In the subdivision, before the search for a common factor, on the way to an irrational double root: nothing is lost,
// and what is missing is seen.
TEST(Solver_budget, StoppedAtAnyMoment)
{
  const Coordinate root = Coordinate::near(std::sqrt(2.0));
  const std::vector<Problem> problems{
      {"irrational double root", with_equalities(cube(2, 0, 2), {square(x * x - 2), y - x}), 1, {{root, root}}},
      {"common factor",
       with_equalities(cube(2, 0, 2), {(x - y) * (x + 3 * y - 2), (x - y) * (x - y + 1)}),
       2,
       {{1, 1}, {fraction(1, 3), fraction(1, 3)}}}};
  for (const Problem& problem : problems) {
    bool is_stopped = true;
    for (int questions = 0; is_stopped; ++questions) {
      ASSERT_LT(questions, 1000);
      Stop_after visitor{questions};
      const auto solutions = SC::Subdivision_solver_d<>()(problem.system, visitor);
      expect_nothing_lost(problem.known, solutions);
      is_stopped = visitor.left < 0;
      EXPECT_TRUE(is_stopped ? questions > 0 || !solutions.is_complete() : solutions.is_complete())
          << problem.name << ", " << questions;
    }
  }
}

TEST(Solver_budget, Tolerance)
{
  const System circle = with_equalities(cube(2, -2, 2), {x * x + y * y - 1, square(x * x + y * y) - 1});
  const auto solutions = solve(circle, {.tolerance = 1e-2});
  EXPECT_FALSE(solutions.is_complete() && solutions.count(Solution_kind::CONTINUUM) == 0);
  std::vector<Point> known{{0, 1}, {0, -1}, {1, 0}, {-1, 0}};
  for (int i = 1; i < 50; ++i) {   // Pythagorean triples
    const Rational t = fraction(i, 50), s = 1 + t * t;
    known.push_back({Rational((1 - t * t) / s), Rational(2 * t / s)});
  }
  expect_nothing_lost(known, solutions);
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), 0u);
}

// Sleeps now and then where it is asked, so that progress is due.
struct Slow_visitor
{
  int asked = 0, limit = std::numeric_limits<int>::max();
  std::vector<double> progress = {};

  void on_progress(double fraction) { progress.push_back(fraction); }
  bool stop()
  {
    if (std::has_single_bit(static_cast<unsigned>(asked)) && asked < 2000)
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
    return ++asked > limit;
  }
};

TEST(Solver_visitor, Progress)
{
  const Problem problem = cyclic_chebyshev(8, 2);
  Slow_visitor visitor;
  expect_solved(problem, SC::Subdivision_solver_d<>()(problem.system, visitor));
  ASSERT_GE(visitor.progress.size(), 3u);
  EXPECT_GT(visitor.progress.back(), 0.0);
  for (std::size_t i = 0; i < visitor.progress.size(); ++i) {
    EXPECT_GE(visitor.progress[i], i > 0 ? visitor.progress[i - 1] : 0.0);
    EXPECT_LE(visitor.progress[i], 1.0 + 1e-9);
  }
}

TEST(Solver_visitor, Stop)
{
  const Problem problem = cyclic_chebyshev(8, 2);
  Slow_visitor visitor;
  visitor.limit = 2;
  const auto solutions = SC::Subdivision_solver_d<>()(problem.system, visitor);
  expect_cut_off(problem, solutions, SC::Undecided_reason::STOPPED);
  EXPECT_GE(visitor.asked, 3);
}

// Ends the run as operations do that watch the systems they solve.
struct Throwing_visitor
{
  int asked = 0;

  void on_progress(double) {}
  bool stop()
  {
    ++asked;
    throw SC::internal::Run_stopped{SC::Undecided_reason::STOPPED};
  }
};

TEST(Solver_visitor, Throws)
{
  const Problem problem = cyclic_chebyshev(8, 2);
  Throwing_visitor visitor;
  const auto solutions = solve(problem.system, {.visitor = visitor});
  EXPECT_FALSE(solutions.is_complete());
  EXPECT_GT(solutions.count(Solution_kind::UNDECIDED), 0u);
  EXPECT_EQ(visitor.asked, 1);
}

// The options hold it as well; what is undecided says why, and where.
TEST(Solver_visitor, InOptions)
{
  const Problem problem = cyclic_chebyshev(8, 2);
  Slow_visitor visitor;
  visitor.limit = 2;
  const auto solutions = solve(problem.system, {.visitor = visitor});
  expect_cut_off(problem, solutions, SC::Undecided_reason::STOPPED);
  EXPECT_GE(visitor.asked, 3);
  const std::vector<SC::Undecided_part> undecided = solutions.undecided();
  ASSERT_EQ(undecided.size(), solutions.count(Solution_kind::UNDECIDED));
  EXPECT_EQ(undecided.front().reason, "stopped");
  EXPECT_EQ(undecided.front().place.size(), 8u);

  Slow_visitor patient;
  expect_solved(problem, solve(problem.system, {.visitor = patient}));
  EXPECT_FALSE(patient.progress.empty());
}

// All solutions of x y = 1/9 and x + y = 10/9, which are (1,1/9) and (1/9,1), that satisfy an inequality.
static std::size_t count_with(const Polynomial& function, Relation relation)
{
  System system = with_equalities(cube(2, -2, 2), {9 * x * y - 1, 9 * x + 9 * y - 10});
  system.add(function, relation);
  const auto solutions = solve(system);
  EXPECT_TRUE(solutions.is_complete()) << solutions.summary();
  EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), solutions.size());
  for (const auto& solution : solutions)
    EXPECT_TRUE(verify(system, solution));
  return solutions.size();
}

TEST(Solver_inequalities, SelectSolutions)
{
  EXPECT_EQ(count_with(x - y, Relation::GREATER), 1u);
  EXPECT_EQ(count_with(x + y, Relation::GREATER), 2u);
  EXPECT_EQ(count_with(x + y, Relation::LESS), 0u);
  EXPECT_EQ(count_with(x * x + y * y - 2, Relation::LESS_EQUAL), 2u);
}

TEST(Solver_inequalities, DecideExactlyOnTheBoundary)
{
  // zero at (1/9,1), positive at (1,1/9)
  for (const Polynomial& g : {Polynomial(9 * x - 1), Polynomial(9 * x * x - x), Polynomial(x - y + fraction(8, 9))}) {
    EXPECT_EQ(count_with(g, Relation::GREATER), 1u);
    EXPECT_EQ(count_with(g, Relation::GREATER_EQUAL), 2u);
    EXPECT_EQ(count_with(g, Relation::LESS), 0u);
    EXPECT_EQ(count_with(g, Relation::LESS_EQUAL), 1u);
  }
  const Rational tiny(1e-40);   // far below what doubles see
  EXPECT_EQ(count_with(9 * x - 1 - tiny, Relation::LESS), 1u);
  EXPECT_EQ(count_with(9 * x - 1 + tiny, Relation::LESS_EQUAL), 0u);
  EXPECT_EQ(count_with(9 * x - 1 - tiny, Relation::GREATER_EQUAL), 1u);
}

TEST(Solver_inequalities, IrrationalSolutions)
{
  const auto solutions_with = [](const Polynomial& g, Relation relation) {
    System system = with_equalities(cube(1, 0, 2), {x * x - 2});
    system.add(g, relation);
    return solve(system);
  };
  // 2 - 1e-30 < x^2 < 2 + 1e-30
  const Rational tiny(1e-30);
  EXPECT_EQ(solutions_with(x * x - 2 + tiny, Relation::GREATER).count(Solution_kind::CERTIFIED), 1u);
  EXPECT_EQ(solutions_with(x * x - 2 - tiny, Relation::LESS).count(Solution_kind::CERTIFIED), 1u);
  EXPECT_TRUE(solutions_with(x * x - 2 - tiny, Relation::GREATER).empty());
  // exactly on the boundary: decided, or said not to be
  for (const Relation relation : {Relation::LESS, Relation::LESS_EQUAL, Relation::GREATER, Relation::GREATER_EQUAL}) {
    const auto solutions = solutions_with(pow(x, 4) - 4, relation);
    const bool is_solution = SC::is_satisfied(relation, CGAL::ZERO);
    if (solutions.is_complete())
      EXPECT_EQ(solutions.count(Solution_kind::CERTIFIED), is_solution ? 1u : 0u);
    else {
      ASSERT_EQ(solutions.size(), 1u);
      EXPECT_EQ(solutions[0].reason(), SC::Undecided_reason::INEQUALITY);
      EXPECT_TRUE(meets(solutions[0].box(), {Coordinate::near(std::sqrt(2.0))}));
    }
  }
}

TEST(Solver_inequalities, Prune)
{
  Problem problem = cyclic_chebyshev(3, 4);
  const std::size_t nodes = solve(problem.system).summary().nodes;
  problem.system.add(10 * x - 9, Relation::GREATER);
  std::erase_if(problem.known, [](const Point& point) { return point[0].lower < fraction(9, 10); });
  problem.count = problem.known.size();
  ASSERT_GE(problem.count, 5u);
  const auto solutions = solve(problem.system);
  expect_solved(problem, solutions);
  EXPECT_LT(3 * solutions.summary().nodes, nodes);
}

// The least that the concepts ask for.
struct Test_that_never_decides
{
  bool has_at_most_one_solution(SC::Node_view&, const SC::Linear_enclosure&) { return false; }
};

struct Reduction_that_does_nothing
{
  bool contract(SC::Node_view&, SC::Linear_enclosure&, SC::Local_box&) { return true; }
};

// Drops a box when an equality has no zero in it.
struct Excluding_reduction
{
  bool contract(SC::Node_view& node, SC::Linear_enclosure&, SC::Local_box&)
  {
    for (int i = 0; i < node.equalities(); ++i)
      if (node.lower(i) > 0 || node.upper(i) < 0)
        return false;
    return true;
  }
};

class Splitter_in_turn
{
  int m_turn = 0;

public:
  void rate(SC::Node_view& node, const std::vector<double>& widths, std::vector<double>& rating)
  {
    rating.assign(node.dimension(), 0.0);
    for (int k = 0; k < node.dimension(); ++k)
      rating[(m_turn + k) % node.dimension()] = widths[(m_turn + k) % node.dimension()] > 0 ? node.dimension() - k : 0;
    ++m_turn;
  }
};

struct Stub_traits
{
  using Number_type = double;
  using Termination_test = Test_that_never_decides;
  using Reduction = Reduction_that_does_nothing;
  using Splitter = Splitter_in_turn;
  static constexpr bool tracks_rounding = true;
};

struct Stub_visitor
{
  void on_progress(double) {}
  bool stop() { return false; }
};

static_assert(SC::TerminationTest<Test_that_never_decides> && SC::Reduction<Reduction_that_does_nothing> &&
              SC::Splitter<Splitter_in_turn> && SC::ConstraintSolverTraits<Stub_traits> &&
              SC::SolverVisitor<Stub_visitor>);
static_assert(!SC::TerminationTest<Stub_visitor> && !SC::Reduction<Stub_visitor> && !SC::Splitter<Stub_visitor> &&
              !SC::ConstraintSolverTraits<Stub_visitor> && !SC::SolverVisitor<Stub_traits>);

struct Traits_with_int : Stub_traits
{
  using Number_type = int;
};
static_assert(!SC::ConstraintSolverTraits<Traits_with_int>);

template <class Traits>
static void expect_right_with_stubs()
{
  for (const Problem& problem :
       {cyclic_chebyshev(2, 3), cyclic_chebyshev(3, 2), circle_and_ellipse(), bitangents(), katsura_2(), zigzag()}) {
    SCOPED_TRACE(problem.name);
    Stub_visitor visitor;
    const auto solutions = SC::Subdivision_solver_d<Traits>({.node_limit = 100000})(problem.system, visitor);
    expect_nothing_lost(problem.known, solutions);
    EXPECT_LE(solutions.count(Solution_kind::CERTIFIED), problem.count);
    for (const auto& solution : solutions)
      EXPECT_TRUE(!solution.is_certified() || verify(problem.system, solution));
    if (solutions.count(Solution_kind::UNDECIDED) == 0)
      expect_solved(problem, solutions);
    else
      EXPECT_FALSE(solutions.is_complete());
  }
}

TEST(Solver_policies, Stubs)
{
  expect_right_with_stubs<Stub_traits>();
  expect_right_with_stubs<SC::Solver_traits<double, Test_that_never_decides>>();
  expect_right_with_stubs<SC::Solver_traits<double, SC::Graph_box_test, Excluding_reduction>>();
  expect_right_with_stubs<
      SC::Solver_traits<double, SC::Normal_cone_test, Reduction_that_does_nothing, Splitter_in_turn>>();
}

// The binomials of such degrees leave the range of double.
TEST(Solver_input, HighDegree)
{
  const int degree = 800;
  const System system = with_equalities(cube(1, 0, 1), {2 * pow(x, degree) - 1});
  const SC::internal::System_layout layout(system);
  SC::internal::Exact_source source(system, layout);
  std::vector<double> coefficients(layout.size), errors(layout.errors);
  std::vector<long> scale;
  const std::vector<double> lower{0}, upper{1};
  source.bernstein_coefficients(SC::internal::Cell{0}, std::span<const double>(lower), std::span<const double>(upper),
                                coefficients.data(), errors.data(), scale);
  ASSERT_EQ(coefficients.size(), degree + 1u);
  for (int k = 0; k <= degree; ++k)   // -1, but for the last
    EXPECT_NEAR(std::ldexp(coefficients[k], static_cast<int>(scale[0])), k < degree ? -1 : 1, 1e-12) << k;
  const auto solutions = SC::solve(system);
  ASSERT_EQ(solutions.count(Solution_kind::CERTIFIED), 1u);
  EXPECT_NEAR(solutions[0].point()[0], std::pow(0.5, 1.0 / degree), 1e-12);
}

} // namespace solver_input_test
