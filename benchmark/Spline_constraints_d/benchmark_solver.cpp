// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The solver over problems, policies and number types.
//
// Names are problem/policy or problem/number type. Counters: certified roots, clusters, continua and undecided boxes,
// nodes, time per node (of the whole run), whether the answer is complete (1) or not (0), exact rebuilds of nodes, and
// the shares of setup and rebuilding in the time. A run ends after 20 s or 3 million nodes. The benchmarks `ratio/...`
// solve one system with Certified_solver_traits and Fast_solver_traits in turns, `univariate/...` one with the path for
// one unknown and the one for many. `degenerate/touch_to_cross` solves a parabola with a line that touches it and one
// that crosses it. `batch/...` solve 1,000 small systems in one call and one by one, by the wall clock, and
// `.../sequential_to_parallel` one system on one core and on all, which needs SPLINE_CONSTRAINTS_WITH_TBB=ON and cores
// with nothing else to do:   benchmark_solver --benchmark_filter=sequential_to_parallel --benchmark_min_time=2
//
// Times on a shared machine: --benchmark_repetitions=5 --benchmark_report_aggregates_only --benchmark_min_time=0.05

#include "benchmark_systems.h"
#include "compare_in_turns.h"

#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/batch.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace solver_benchmark;
using SC::Solution_kind;

using Cone = SC::Solver_traits<double, SC::Normal_cone_test>;
using Bisection = SC::Solver_traits<double, SC::Graph_box_test, SC::No_reduction>;
using Bisection_and_cone = SC::Solver_traits<double, SC::Normal_cone_test, SC::No_reduction>;
using Projected = SC::Solver_traits<double, SC::Graph_box_test, SC::Projected_polyhedron_reduction>;
using Widest = SC::Solver_traits<double, SC::Graph_box_test, SC::Preconditioned_reduction, SC::Widest_splitter>;

SC::Solver_options limits()
{
  SC::Solver_options options;
  options.time_limit = 20;
  options.node_limit = 3000000;
  return options;
}

template <class Traits>
void solve(benchmark::State& state, const System& system)
{
  const SC::Subdivision_solver_d<Traits> solver(limits());
  typename SC::Subdivision_solver_d<Traits>::Solution_set solutions;
  double total = 0, setup = 0, rebuilding = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solutions = solver(system));
    total += solutions.summary().seconds;
    setup += solutions.summary().setup_seconds;
    rebuilding += solutions.summary().rebuild_seconds;
  }
  using benchmark::Counter;
  const SC::Summary& summary = solutions.summary();
  const double nodes = static_cast<double>(summary.nodes);
  state.counters["roots"] = static_cast<double>(solutions.count(Solution_kind::CERTIFIED));
  state.counters["clusters"] = static_cast<double>(solutions.count(Solution_kind::CLUSTER));
  state.counters["continua"] = static_cast<double>(solutions.count(Solution_kind::CONTINUUM));
  state.counters["undecided"] = static_cast<double>(solutions.count(Solution_kind::UNDECIDED));
  state.counters["nodes"] = nodes;
  state.counters["time_per_node"] = Counter(nodes, Counter::kIsIterationInvariantRate | Counter::kInvert);
  state.counters["complete"] = solutions.is_complete();
  state.counters["rebuilds"] = static_cast<double>(summary.restarts);
  state.counters["setup"] = setup / total;
  state.counters["rebuilding"] = rebuilding / total;
}

template <class First, class Second>
void compare_traits(benchmark::State& state, const System& system, const std::string& first_name,
                    const std::string& second_name)
{
  const SC::Subdivision_solver_d<First> first(limits());
  const SC::Subdivision_solver_d<Second> second(limits());
  compare_in_turns(
      state, [&] { benchmark::DoNotOptimize(first(system)); }, [&] { benchmark::DoNotOptimize(second(system)); },
      first_name, second_name, seconds_of_thread);
}

void certified_to_fast(benchmark::State& state, const System& system)
{
  compare_traits<SC::Certified_solver_traits, SC::Fast_solver_traits>(state, system, "certified", "fast");
}

// The splitter does not matter where there is one axis, but other traits than the default take the path for many
// unknowns.
void univariate_to_general(benchmark::State& state, const System& system)
{
  compare_traits<SC::Certified_solver_traits, Widest>(state, system, "univariate", "general");
}

void decomposed_to_whole(benchmark::State& state, const System& system)
{
  const SC::Subdivision_solver_d<> whole(limits());
  const auto by_parts = SC::solve(system), as_a_whole = whole(system);
  if (!by_parts.is_complete() || !as_a_whole.is_complete() || by_parts.size() != as_a_whole.size())
    state.SkipWithError("the answers differ");
  compare_in_turns(
      state, [&] { benchmark::DoNotOptimize(SC::solve(system)); }, [&] { benchmark::DoNotOptimize(whole(system)); },
      "decomposed", "whole", seconds_of_thread);
  state.counters["decomposed_nodes"] = static_cast<double>(by_parts.summary().nodes);
  state.counters["whole_nodes"] = static_cast<double>(as_a_whole.summary().nodes);
  state.counters["solutions"] = static_cast<double>(by_parts.size());
}

void touch_to_cross(benchmark::State& state)
{
  const System touch = parabola_and_line("", 0).system,
               cross = parabola_and_line("", solver_test::fraction(1, 4)).system;
  compare_in_turns(
      state, [&] { benchmark::DoNotOptimize(SC::solve(touch)); }, [&] { benchmark::DoNotOptimize(SC::solve(cross)); },
      "touch", "cross", seconds_of_thread);
}

template <class Concurrency_tag>
void batch_to_loop(benchmark::State& state)
{
  const std::vector<System> systems = quadratic_systems(1000);
  const auto loop = [&] {
    for (const System& system : systems)
      benchmark::DoNotOptimize(SC::solve(system));
  };
  compare_in_turns(
      state, [&] { benchmark::DoNotOptimize(SC::solve<Concurrency_tag>(systems)); }, loop, "batch", "loop",
      seconds_on_the_wall);
}

#ifdef CGAL_LINKED_WITH_TBB
void sequential_to_parallel(benchmark::State& state, const System& system)
{
  compare_in_turns(
      state, [&] { benchmark::DoNotOptimize(SC::solve<CGAL::Sequential_tag>(system)); },
      [&] { benchmark::DoNotOptimize(SC::solve<CGAL::Parallel_tag>(system)); }, "sequential", "parallel",
      seconds_on_the_wall);
}
#endif

using Run = void (*)(benchmark::State&, const System&);

using Variants = std::vector<std::pair<std::string, Run>>;

void add(const Named_system& problem, const Variants& variants)
{
  for (const auto& [variant, run] : variants)
    benchmark::RegisterBenchmark((problem.name + '/' + variant).c_str(), run, problem.system)
        ->Unit(benchmark::kMillisecond);
}

const Variants standard{{"certified", solve<SC::Certified_solver_traits>}};

const Variants policies{{"default", solve<SC::Certified_solver_traits>},
                        {"normal_cone", solve<Cone>},
                        {"no_reduction", solve<Bisection>},
                        {"no_reduction_normal_cone", solve<Bisection_and_cone>},
                        {"projected_polyhedron", solve<Projected>},
                        {"widest", solve<Widest>}};

const Variants number_types{{"fast", solve<SC::Fast_solver_traits>},
                            {"certified", solve<SC::Certified_solver_traits>},
                            {"interval", solve<SC::Interval_solver_traits>}};

const Variants exact_number_types{{"multiprecision", solve<SC::Multiprecision_solver_traits>},
                                  {"exact", solve<SC::Exact_solver_traits>}};

const Variants ratio{{"certified_to_fast", certified_to_fast}};

const Variants paths{{"univariate_to_general", univariate_to_general}};

bool add_all()
{
  for (int n : {4, 6, 8, 20})
    add(broyden(n), standard);
  for (int n : {4, 5})
    add(katsura(n), standard);
  for (int degree : {9, 16, 20, 24, 30})
    add(chebyshev_curves(degree), standard);
  for (const auto& [n, degree] : {std::pair(4, 3), std::pair(6, 2), std::pair(8, 2)})
    add(cyclic(n, degree), standard);
  for (const auto& [n, degree] : {std::pair(2, 8), std::pair(3, 3), std::pair(4, 2), std::pair(4, 3), std::pair(5, 2)})
    add(mixed(n, degree), standard);
  for (const Named_system& problem :
       {brown(5), circle_and_hyperbola(), griewank_osborne(), two_pairs_of_lines(), wiggly_splines(), random_splines()})
    add(problem, standard);

  for (Named_system problem : {cyclic(2, 8), cyclic(4, 3), mixed(4, 2), mixed(5, 2), broyden(6), katsura(4)}) {
    problem.name = "policies/" + problem.name;
    add(problem, policies);
  }
  for (Named_system problem : {mixed(2, 8), mixed(3, 3), mixed(4, 2), mixed(4, 3)}) {
    problem.name = "numbers/" + problem.name;
    add(problem, number_types);
  }
  for (Named_system problem : {mixed(2, 8), mixed(3, 3), broyden(4), circle_and_hyperbola()}) {
    problem.name = "numbers/" + problem.name;
    add(problem, exact_number_types);
  }
  for (Named_system problem : {mixed(2, 8), mixed(3, 3), mixed(4, 2), mixed(4, 3)}) {
    problem.name = "ratio/" + problem.name;
    add(problem, ratio);
  }
  for (Named_system problem : {multilateration(), independent_chebyshev_curves(5, 6), hyperplanes_and_quadrics(8),
                               katsura(4), mixed(4, 2), mixed(5, 2), cyclic(4, 3), circle_and_hyperbola()}) {
    problem.name = "decomposition/" + problem.name;
    add(problem, {{"decomposed_to_whole", decomposed_to_whole}});
  }
  for (int degree : {2, 10, 20, 40})
    add(univariate_chebyshev(degree), paths);
  for (int degree : {5, 6, 7, 8, 9, 10})
    add(random_polynomial(degree), paths);
  add(wilkinson(20), paths);
  add(multiple_roots(), paths);
  for (const Named_system& problem :
       {parabola_and_line("cross", solver_test::fraction(1, 4)), parabola_and_line("touch", 0), overlap(),
        common_line(), pencil_of_quadrics(), irrational_double_roots()})
    add(problem, standard);
  benchmark::RegisterBenchmark("degenerate/touch_to_cross", touch_to_cross)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("batch/quadratic/sequential", batch_to_loop<CGAL::Sequential_tag>)
      ->Unit(benchmark::kMillisecond);
#ifdef CGAL_LINKED_WITH_TBB
  benchmark::RegisterBenchmark("batch/quadratic/parallel", batch_to_loop<CGAL::Parallel_tag>)
      ->Unit(benchmark::kMillisecond);
  for (const Named_system& problem : {katsura(4), katsura(5), mixed(4, 3), chebyshev_curves(30)})
    add(problem, {{"sequential_to_parallel", sequential_to_parallel}});
#endif
  return true;
}

[[maybe_unused]] const bool is_added = add_all();

} // namespace
