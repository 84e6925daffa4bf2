// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Parallel_tag finds what Sequential_tag finds, in the same order, digit for digit.

#ifndef CGAL_LINKED_WITH_TBB
#define CGAL_LINKED_WITH_TBB
#endif

#include "counterflow_system.h"
#include "planted_simple_roots.h"
#include "solver_test_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Propagation_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/batch.h>
#include <CGAL/Spline_constraints_d/solver/own_traits.h>

#include <CGAL/Simple_cartesian.h>

#include <tbb/global_control.h>

#include <atomic>
#include <thread>

using namespace solver_test;

template <class Solutions>
static void expect_equal(const Solutions& a, const Solutions& b)
{
  EXPECT_EQ(a.summary().nodes, b.summary().nodes);
  EXPECT_EQ(a.summary().restarts, b.summary().restarts);
  EXPECT_EQ(a.summary().depth, b.summary().depth);
  EXPECT_EQ(a.summary().is_complete, b.summary().is_complete);
  EXPECT_EQ(a.summary().why_not, b.summary().why_not);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].kind(), b[i].kind());
    EXPECT_EQ(a[i].reason(), b[i].reason());
    EXPECT_EQ(a[i].multiplicity(), b[i].multiplicity());
    EXPECT_EQ(a[i].precision(), b[i].precision());
    EXPECT_EQ(a[i].exact_box(), b[i].exact_box());
    EXPECT_EQ(a[i].exact_uniqueness_region(), b[i].exact_uniqueness_region());
  }
}

// Three threads, however many cores there are.
template <class Traits>
static void check_both(const Problem& problem, const SC::Solver_options& options = {})
{
  SCOPED_TRACE(problem.name);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
  const auto sequential = SC::Subdivision_solver_d<Traits>(options)(problem.system);
  for (int run = 0; run < 2; ++run)
    expect_equal(sequential, SC::Subdivision_solver_d<Traits, CGAL::Parallel_tag>(options)(problem.system));
}

TEST(Parallel, SameAnswers)
{
  for (const Problem& problem : {cyclic_chebyshev(3, 4), cyclic_chebyshev(8, 2), mixed_chebyshev(4, 3),
                                 lines_tangent_to_spheres(), zigzag(), cyclic_chebyshev_in_pieces(5)}) {
    check_both<SC::Certified_solver_traits>(problem);
    expect_solved(problem, solve<CGAL::Parallel_tag>(problem.system));
  }
  EXPECT_GT(solve(cyclic_chebyshev(8, 2).system).summary().nodes, 1000u);
}

// Through sums of monomials.
static void check_propagation(const std::vector<SC::Constraint_system_d::Domain>& domain,
                              const std::vector<std::pair<SC::Power_polynomial, SC::Relation>>& constraints,
                              const SC::Solver_options& options = {})
{
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
  expect_equal(SC::Propagation_solver_d(options)(domain, constraints),
               SC::Propagation_solver_d<CGAL::Parallel_tag>(options)(domain, constraints));
}

// In this way, and through turns with tensors.
static void check_polynomials(const std::vector<SC::Constraint_system_d::Domain>& domain,
                              const std::vector<std::pair<SC::Power_polynomial, SC::Relation>>& constraints,
                              const SC::Solver_options& options = {})
{
  check_propagation(domain, constraints, options);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
  expect_equal(SC::solve_polynomials(domain, constraints, options),
               SC::solve_polynomials<CGAL::Parallel_tag>(domain, constraints, options));
}

// A hundred times as slow under ThreadSanitizer.
TEST(Parallel, Propagation)
{
  // random quadrics, also where a limit is reached
  Random_numbers random(56);
  for (int round = 0; round < 18; ++round) {
    SCOPED_TRACE(round);
    const int n = 2 + round % 3;
    std::vector<std::pair<SC::Power_polynomial, SC::Relation>> constraints;
    for (int i = 0; i < n; ++i) {
      SC::Power_polynomial f(random.integer(-9, 9));
      for (int j = 0; j < n; ++j) {
        f += random.integer(-5, 5) * SC::Power_polynomial::variable(j);
        for (int k = j; k < n; ++k)
          f += random.integer(-5, 5) * SC::Power_polynomial::variable(j) * SC::Power_polynomial::variable(k);
      }
      constraints.emplace_back(f, SC::Relation::EQUAL);
    }
    const std::vector<SC::Constraint_system_d::Domain> domain(n, {Rational(-20), Rational(20)});
    check_polynomials(domain, constraints);
    check_polynomials(domain, constraints, {.node_limit = static_cast<std::size_t>(random.integer(1, 200))});
  }
  // close pairs and roots on faces; a few would take many nodes
  Planted_simple_roots planted(5605);
  for (int round = 0; round < 30; ++round) {
    SCOPED_TRACE(round);
    const auto [problem, polynomials] = planted.make_polynomials(1 + round % 3);
    std::vector<SC::Constraint_system_d::Domain> domain;
    std::vector<std::pair<SC::Power_polynomial, SC::Relation>> constraints;
    for (int j = 0; j < problem.system.dimension(); ++j)
      domain.push_back(problem.system.domain(j));
    for (const SC::Power_polynomial& polynomial : polynomials)
      constraints.emplace_back(polynomial, SC::Relation::EQUAL);
    check_polynomials(domain, constraints, {.node_limit = 1000});
  }
  // chains with windows
  const SC::Constraint_system_d::Domain wide{Rational(-1000), Rational(1000)};
  check_polynomials(std::vector<SC::Constraint_system_d::Domain>(8, wide), counterflow(4));
  check_propagation(std::vector<SC::Constraint_system_d::Domain>(10, wide), counterflow(5));
}

TEST(Parallel, PropagationWithFunctions)
{
  auto [x, y, z] = SC::unknowns({-9, 9}, {-9, 9}, {-9, 9});
  const std::array constraints{sin(x * y) + z == Rational(1, 3), cos(y - z) == x / 7,
                               exp(-x * x / 9) + sin(z) == y / 5};
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
  const auto solutions = SC::Propagation_solver_d()(constraints);
  EXPECT_GT(solutions.size(), 20u);
  expect_equal(solutions, SC::Propagation_solver_d<CGAL::Parallel_tag>()(constraints));
}

TEST(Parallel, Curves)
{
  auto [x, y] = SC::unknowns({-1, 1}, {-1, 1});
  const auto t8 = [](const auto& t) { return 2 * square(8 * t * t * t * t - 8 * t * t + 1) - 1; };
  // at irrational points
  const SC::Constraint_system_d closed_curves = SC::make_system(std::array{t8(x) * t8(y) == SC::Exact_rational(1, 2)}),
                                cusps = SC::make_system(std::array{square(y) ==
                                                                   (square(x) - SC::Exact_rational(1, 2)) *
                                                                       square(square(x) - SC::Exact_rational(1, 2))});
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
  const auto expect_same = [](const SC::Constraint_system_d& system, const SC::Solver_options& options,
                              std::size_t closed, bool is_complete) {
    const SC::Curve_solution_set_d a = SC::Curve_solver_d<>(options)(system),
                                   b = SC::Curve_solver_d<SC::Certified_solver_traits, CGAL::Parallel_tag>(options)(
                                       system);
    EXPECT_EQ(a.summary().nodes, b.summary().nodes);
    EXPECT_EQ(a.number_of_closed_curves(), closed);
    EXPECT_EQ(a.is_complete(), is_complete);
    ASSERT_EQ(a.undecided_regions().size(), b.undecided_regions().size());
    for (std::size_t i = 0; i < a.undecided_regions().size(); ++i) {
      EXPECT_EQ(a.undecided_regions()[i].boxes, b.undecided_regions()[i].boxes);
      EXPECT_EQ(a.undecided_regions()[i].vertices, b.undecided_regions()[i].vertices);
    }
    ASSERT_EQ(a.curves().size(), b.curves().size());
    for (std::size_t i = 0; i < a.curves().size(); ++i)
      EXPECT_EQ(a.curves()[i].vertices(), b.curves()[i].vertices());
    ASSERT_EQ(a.vertices().size(), b.vertices().size());
    for (std::size_t i = 0; i < a.vertices().size(); ++i)
      EXPECT_EQ(a.vertices()[i].box, b.vertices()[i].box);
  };
  expect_same(closed_curves, {.tolerance = 1e-8}, 25, true);
  expect_same(cusps, {.tolerance = 1e-4}, 0, false);
  const SC::Curve_solution_set_d limited = SC::Curve_solver_d<SC::Certified_solver_traits, CGAL::Parallel_tag>(
      {.tolerance = 1e-8, .node_limit = 300})(closed_curves);
  EXPECT_FALSE(limited.is_complete());
  EXPECT_EQ(limited.summary().why_not, SC::Undecided_reason::NODES);
}

// All cells, digit for digit.
static void expect_equal(const SC::Surface_solution_set_d& a, const SC::Surface_solution_set_d& b)
{
  EXPECT_EQ(a.summary().nodes, b.summary().nodes);
  EXPECT_EQ(a.summary().depth, b.summary().depth);
  EXPECT_EQ(a.is_complete(), b.is_complete());
  ASSERT_EQ(a.vertices().size(), b.vertices().size());
  for (std::size_t i = 0; i < a.vertices().size(); ++i) {
    EXPECT_EQ(a.vertices()[i].box, b.vertices()[i].box);
    EXPECT_EQ(a.vertices()[i].is_singular, b.vertices()[i].is_singular);
  }
  ASSERT_EQ(a.arcs().size(), b.arcs().size());
  for (std::size_t i = 0; i < a.arcs().size(); ++i) {
    EXPECT_EQ(a.arcs()[i].box, b.arcs()[i].box);
    EXPECT_EQ(a.arcs()[i].ends, b.arcs()[i].ends);
  }
  ASSERT_EQ(a.patches().size(), b.patches().size());
  for (std::size_t i = 0; i < a.patches().size(); ++i) {
    const SC::Surface_patch &own = a.patches()[i], &other = b.patches()[i];
    EXPECT_EQ(own.box, other.box);
    EXPECT_EQ(own.parameters, other.parameters);
    EXPECT_EQ(own.orientation, other.orientation);
    EXPECT_EQ(own.surface, other.surface);
    EXPECT_EQ(own.apex, other.apex);
    ASSERT_EQ(own.boundary.size(), other.boundary.size());
    for (std::size_t k = 0; k < own.boundary.size(); ++k) {
      EXPECT_EQ(own.boundary[k].arc, other.boundary[k].arc);
      EXPECT_EQ(own.boundary[k].is_reversed, other.boundary[k].is_reversed);
    }
  }
  ASSERT_EQ(a.surfaces().size(), b.surfaces().size());
  for (std::size_t i = 0; i < a.surfaces().size(); ++i) {
    EXPECT_EQ(a.surfaces()[i].euler_characteristic, b.surfaces()[i].euler_characteristic);
    EXPECT_EQ(a.surfaces()[i].boundary, b.surfaces()[i].boundary);
  }
  EXPECT_EQ(a.points(), b.points());
  EXPECT_EQ(a.singular_points(), b.singular_points());
  EXPECT_EQ(a.lone_curves().size(), b.lone_curves().size());
  ASSERT_EQ(a.undecided_regions().size(), b.undecided_regions().size());
  for (std::size_t i = 0; i < a.undecided_regions().size(); ++i) {
    EXPECT_EQ(a.undecided_regions()[i].boxes, b.undecided_regions()[i].boxes);
    EXPECT_EQ(a.undecided_regions()[i].arcs, b.undecided_regions()[i].arcs);
    EXPECT_EQ(a.undecided_regions()[i].reason, b.undecided_regions()[i].reason);
  }
}

// Tasks on both sides of a plane cut the same arcs.
TEST(Parallel, Surfaces)
{
  auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const SC::Expression ring = square(x) + square(y);
  const SC::Constraint torus = square(ring + square(z) + SC::Exact_rational(91, 100)) == 4 * ring;
  const auto t4 = [](const auto& t) { return 8 * square(square(t)) - 8 * square(t) + 1; };
  const auto part = [](int unknown) { // a function with a break: cells have common faces
    return SC::Spline_function(SC::Spline_term{{unknown}, {1}, {{-3, 0, 3}}, {{0, -1}, {0, 1}}});
  };
  SC::Constraint_system_d octahedron({{-3, 3}, {-3, 3}, {-3, 3}});
  octahedron.add(part(0) + part(1) + part(2) + SC::Spline_function(SC::Power_polynomial(SC::Exact_rational(-1))),
                 SC::Relation::EQUAL);
  const auto expect_same = [](const SC::Constraint_system_d& system, const SC::Solver_options& options,
                              int euler_characteristic, std::size_t loops) {
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
    const SC::Surface_solution_set_d a = SC::solve_surfaces(system, options);
    EXPECT_EQ(a.is_complete(), options.node_limit == 0) << a;
    if (options.node_limit == 0) {
      EXPECT_EQ(a.euler_characteristic(), euler_characteristic);
      EXPECT_EQ(a.number_of_boundary_loops(), loops);
    } else {
      EXPECT_EQ(a.summary().why_not, SC::Undecided_reason::NODES);
    }
    for (int run = 0; run < 2; ++run)
      expect_equal(a, SC::solve_surfaces<CGAL::Parallel_tag>(system, options));
  };
  expect_same(SC::make_system(std::array{torus}), {.tolerance = 1e-8}, 0, 0);
  expect_same(SC::make_system(std::array{torus, x >= 0}), {.tolerance = 1e-8}, 0, 2);
  expect_same(SC::make_system(std::array{t4(x) + t4(y) + t4(z) == 0}), {.tolerance = 1e-8}, -8, 0);
  expect_same(SC::make_system(std::array{square(x) + square(y) == square(z)}), {.tolerance = 1e-8}, 2, 2);
  expect_same(octahedron, {.tolerance = 1e-8}, 2, 0);
  for (const std::size_t limit : {40, 400, 1000})
    expect_same(SC::make_system(std::array{torus}), {.tolerance = 1e-8, .node_limit = limit}, 0, 0);
}

TEST(Parallel, OtherNumberTypes)
{
  check_both<SC::Interval_solver_traits>(mixed_chebyshev(4, 2));
  check_both<SC::Multiprecision_solver_traits>(cyclic_chebyshev(3, 3));
  check_both<SC::Exact_solver_traits>(cyclic_chebyshev(2, 4));
}

// What stays open, and where limits end a run.
TEST(Parallel, SameUndecidedBoxes)
{
  const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1);
  const Problem circle{
      "circle twice", with_equalities(cube(2, -2, 2), {x * x + y * y - 1, square(x * x + y * y) - 1}), 0, {}};
  check_both<SC::Certified_solver_traits>(circle, {.tolerance = 1e-6});
  for (std::size_t limit : {100, 500, 1500})
    check_both<SC::Certified_solver_traits>(cyclic_chebyshev(8, 2), {.node_limit = limit});
}

TEST(Parallel, OneUnknown)
{
  const Polynomial x = Polynomial::variable(0);
  check_both<SC::Certified_solver_traits>(
      all_known("one unknown", with_equalities(cube(1, -1, 1), {square(2 * x * x - 1) * chebyshev(9, x)}), {}));
}

// Many systems of different size; some take multiprecision numbers, one has only one unknown.
static std::vector<System> many_systems()
{
  const Polynomial x = Polynomial::variable(0), y = Polynomial::variable(1);
  const Rational tiny = Rational(1e-30);
  const std::vector<System> some{cyclic_chebyshev(2, 4).system,
                                 with_equalities(cube(2, -2, 2), {y - x * x, y - tiny}),
                                 broyden_tridiagonal(4).system,
                                 cyclic_chebyshev(3, 3).system,
                                 with_equalities(cube(1, -2, 2), {square(x * x - 2)}),
                                 zigzag().system};
  std::vector<System> systems;
  for (int i = 0; i < 10; ++i)
    systems.insert(systems.end(), some.begin(), some.end());
  return systems;
}

TEST(Parallel, Batch)
{
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
  const std::vector<System> systems = many_systems();
  const auto sequential = solve(systems), parallel = solve<CGAL::Parallel_tag>(systems);
  ASSERT_EQ(sequential.size(), systems.size());
  ASSERT_EQ(parallel.size(), systems.size());
  for (std::size_t i = 0; i < systems.size(); ++i) {
    EXPECT_GT(parallel[i].size(), 0u);
    expect_equal(sequential[i], parallel[i]);
  }
}

TEST(Parallel, BatchWithInvalidSystems)
{
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
  std::vector<System> systems = many_systems();
  for (std::size_t i : {55, 31, 17})
    systems[i] = cube(3, 0, 1);
  for (int run = 0; run < 5; ++run)
    try {
      solve<CGAL::Parallel_tag>(systems);
      ADD_FAILURE() << "no exception";
    } catch (const SC::Invalid_input& error) {
      EXPECT_NE(std::string(error.what()).find("system 17 "), std::string::npos) << error.what();
    }
}

struct Counting_visitor
{
  std::atomic<int> inside = 0;
  int asked = 0, limit;
  bool is_alone = true;

  explicit Counting_visitor(int limit) : limit(limit) {}
  void on_progress(double fraction) { is_alone = is_alone && fraction >= 0 && fraction <= 1 && inside == 0; }
  bool stop()
  {
    is_alone = is_alone && ++inside == 1;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    --inside;
    return ++asked > limit;
  }
};

// One thread at a time calls the visitor, and the answer of a stopped run loses nothing.
TEST(Parallel, Visitor)
{
  const Problem problem = cyclic_chebyshev(8, 2);
  const SC::Subdivision_solver_d<SC::Certified_solver_traits, CGAL::Parallel_tag> solver;
  Counting_visitor patient(1000000), impatient(10);
  expect_solved(problem, solver(problem.system, patient));
  EXPECT_GT(patient.asked, 20);
  EXPECT_TRUE(patient.is_alone);
  const auto stopped = solver(problem.system, impatient);
  EXPECT_EQ(stopped.summary().why_not, SC::Undecided_reason::STOPPED);
  EXPECT_TRUE(impatient.is_alone);
  expect_nothing_lost(problem.known, stopped);
}

TEST(Parallel, LimitsOfPropagation)
{
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 3);
  const std::vector<SC::Constraint_system_d::Domain> domain(18, {Rational(-1000), Rational(1000)});
  for (const int limit : {3, 30, 3000}) {
    Counting_visitor impatient(limit);
    const SC::Propagation_solver_d<CGAL::Parallel_tag> solver({.visitor = impatient});
    const auto stopped = solver(domain, counterflow(9));
    EXPECT_FALSE(stopped.is_complete());
    EXPECT_EQ(stopped.summary().why_not, SC::Undecided_reason::STOPPED);
    EXPECT_TRUE(impatient.is_alone);
    Counting_visitor other(limit);
    const auto turns = SC::solve_polynomials<CGAL::Parallel_tag>(domain, counterflow(9), {.visitor = other});
    EXPECT_FALSE(turns.is_complete());
    EXPECT_EQ(turns.summary().why_not, SC::Undecided_reason::STOPPED);
    EXPECT_TRUE(other.is_alone);
  }
  const auto late = SC::solve_polynomials<CGAL::Parallel_tag>(domain, counterflow(9), {.time_limit = 1e-3});
  EXPECT_FALSE(late.is_complete());
  EXPECT_EQ(late.summary().why_not, SC::Undecided_reason::TIME);
}

TEST(Parallel, VoronoiDiagram)
{
  using K = CGAL::Simple_cartesian<double>;
  using P = K::Point_2;
  std::vector<SC::Bspline_curve_2<K>> curves;
  for (const P& p : {P(0, 0), P(4.3, 0.7), P(9.1, -0.4), P(0.9, 3.8), P(5.2, 4.9), P(10.4, 3.6)})
    curves.push_back(SC::bezier_curve(
        std::vector<P>{p, P(p.x() + 1, p.y() + 2), P(p.x() + 2, p.y() - 2 + p.x() / 8), P(p.x() + 3, p.y() + 1)}));
  const auto one_by_one = SC::voronoi_diagram(curves), parallel = SC::voronoi_diagram<CGAL::Parallel_tag>(curves);
  EXPECT_TRUE(parallel.is_complete());
  ASSERT_EQ(parallel.vertices().size(), one_by_one.vertices().size());
  ASSERT_EQ(parallel.edges().size(), one_by_one.edges().size());
  EXPECT_GT(parallel.edges().size(), 30U);
  for (std::size_t i = 0; i < parallel.vertices().size(); ++i) {
    EXPECT_EQ(parallel.vertices()[i].point, one_by_one.vertices()[i].point);
    EXPECT_EQ(parallel.vertices()[i].edges, one_by_one.vertices()[i].edges);
  }
  Counting_visitor impatient(100);
  const auto stopped = SC::voronoi_diagram<CGAL::Parallel_tag>(curves, {}, {.visitor = impatient});
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_EQ(stopped.summary().why_not, SC::Undecided_reason::STOPPED);
  EXPECT_EQ(impatient.asked, 101);
  EXPECT_TRUE(impatient.is_alone);
  const auto limited = SC::voronoi_diagram<CGAL::Parallel_tag>(curves, {}, {.node_limit = 100});
  EXPECT_EQ(limited.summary().why_not, SC::Undecided_reason::NODES);
}
