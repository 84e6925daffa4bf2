// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves of solutions with their topology, and what is done with them: derivatives at a point, extremes, fitted splines
// and arrangements; there the curve is the quartic of the example curve_geometry. `sequential_to_parallel/...` find
// curves on one core and on all of them, in turns by the wall clock, which needs SPLINE_CONSTRAINTS_WITH_TBB=ON and
// cores with nothing else to do:   benchmark_solution_curves --benchmark_filter=sequential_to_parallel
// --benchmark_min_time=2

#include "compare_in_turns.h"

#include <CGAL/Spline_constraints_d/geometry/curves/spline_fitting.h>
#include <CGAL/Spline_constraints_d/operations/regions/to_arrangement_2.h>
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_extremes.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <vector>

namespace SC = CGAL::Spline_constraints;

namespace {

const std::array<SC::Unknown, 2>& xy()
{
  static const std::array<SC::Unknown, 2> result = SC::unknowns({-2, 2}, {-2, 2});
  return result;
}

std::vector<SC::Constraint> quartic()
{
  const auto& [x, y] = xy();
  return {square(x * x + y * y) - 2 * (x * x - y * y) + x * y / 2 - x / 4 == SC::Exact_rational(1, 2)};
}

SC::Constraint_system_d sphere_and_cylinder(const SC::Exact_rational& distance)
{
  auto [x, y, z] = SC::unknowns({-3, 6}, {-3, 3}, {-3, 3});
  return SC::make_system(std::array{x * x + y * y + z * z == 4, square(x - distance) + y * y == 1});
}

// T_d(x) T_d(y) = 1/2, with d a power of two.
SC::Constraint_system_d chebyshev_product(int degree)
{
  auto [x, y] = SC::unknowns({-1, 1}, {-1, 1});
  SC::Expression tx = x, ty = y;
  for (int d = 1; d < degree; d *= 2) {
    tx = 2 * square(tx) - 1;
    ty = 2 * square(ty) - 1;
  }
  return SC::make_system(std::array{tx * ty == SC::Exact_rational(1, 2)});
}

// Of radii 1 and 1/3; the second one is moved along the axis, or along the axis of the first one and turned.
SC::Constraint_system_d two_tori(const SC::Exact_rational& distance, bool is_turned)
{
  auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const auto torus = [](const auto& a, const auto& b, const auto& c) {
    return square(square(a) + square(b) + square(c) + SC::Exact_rational(8, 9)) == 4 * (square(a) + square(b));
  };
  return SC::make_system(std::array{torus(x, y, z), is_turned ? torus(y, z, x - distance) : torus(x, y, z - distance)});
}

// (u, v, f(u, v)) = (s, g(s, t), t).
SC::Constraint_system_d two_graphs()
{
  auto [u, v, s, t] = SC::unknowns({0, 1}, {0, 1}, {0, 1}, {0, 1});
  return SC::make_system(std::array{u == s,
                                    v == 3 * s * (1 - s) * t * (1 - t) + SC::Exact_rational(1, 4) + s * t * t / 5,
                                    4 * u * (1 - u) * v * (1 - v) + u * u * v / 3 == t});
}

// A torus and a plane.
SC::Constraint_system_d torus_and_plane()
{
  auto [x, y, z] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2});
  const SC::Expression ring = square(x) + square(y);
  return SC::make_system(
      std::array{square(ring + square(z) + SC::Exact_rational(8, 9)) == 4 * ring, x - 2 * y == 3 * z});
}

// A circle in three hyperplanes of space of dimension five.
SC::Constraint_system_d circle_in_hyperplanes()
{
  auto [a, b, c, d, e] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  return SC::make_system(std::array{square(a) + square(b) + square(c) + square(d) + square(e) == 1, a + 2 * b == c,
                                    d == a + b, e + c == a});
}

void eliminated_to_whole(benchmark::State& state, const SC::Constraint_system_d& system)
{
  const SC::Curve_solver_d<> whole;
  const auto eliminated = SC::solve_curves(system), as_it_is = whole(system);
  if (!eliminated.is_complete() || eliminated.curves().size() != as_it_is.curves().size())
    state.SkipWithError("the answers differ");
  solver_benchmark::compare_in_turns(
      state, [&] { benchmark::DoNotOptimize(SC::solve_curves(system)); },
      [&] { benchmark::DoNotOptimize(whole(system)); }, "eliminated", "whole", solver_benchmark::seconds_of_thread);
  state.counters["eliminated_nodes"] = static_cast<double>(eliminated.summary().nodes);
  state.counters["whole_nodes"] = static_cast<double>(as_it_is.summary().nodes);
}

void solve_curves(benchmark::State& state, const SC::Constraint_system_d& system)
{
  for (auto _ : state)
    state.counters["nodes"] = static_cast<double>(SC::solve_curves(system).summary().nodes);
}

#ifdef CGAL_LINKED_WITH_TBB
void sequential_to_parallel(benchmark::State& state, const SC::Constraint_system_d& system)
{
  const SC::Solver_options options{.tolerance = 1e-8};
  const SC::Curve_solver_d<SC::Certified_solver_traits, CGAL::Sequential_tag> sequential(options);
  const SC::Curve_solver_d<SC::Certified_solver_traits, CGAL::Parallel_tag> parallel(options);
  solver_benchmark::compare_in_turns(
      state, [&] { benchmark::DoNotOptimize(sequential(system)); }, [&] { benchmark::DoNotOptimize(parallel(system)); },
      "sequential", "parallel", solver_benchmark::seconds_on_the_wall);
}
#endif

void differentials_at_a_point(benchmark::State& state)
{
  const SC::Constraint_system_d system = make_system(quartic());
  const auto set = SC::solve_curves(system);
  const std::vector<double> point = SC::to_polyline(system, set, set.curves()[0], 1e-3)[10];
  for (auto _ : state)
    benchmark::DoNotOptimize(SC::curve_differentials(system, point)->curvature());
}

void differentials_at_a_vertex(benchmark::State& state)
{
  const SC::Constraint_system_d system = make_system(quartic());
  const auto set = SC::solve_curves(system);
  for (auto _ : state)
    benchmark::DoNotOptimize(SC::curve_differentials(system, set.vertices()[0])->curvature());
}

void turning_points(benchmark::State& state)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(SC::turning_points(quartic(), xy()[1]));
}

void curvature_extremes(benchmark::State& state)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(SC::curvature_extremes(quartic()));
}

// Within 10^-k.
void fitted_spline(benchmark::State& state)
{
  const SC::Constraint_system_d system = make_system(quartic());
  const auto set = SC::solve_curves(system);
  std::size_t pieces = 0;
  for (auto _ : state)
    pieces = SC::fit_spline(system, set, set.curves()[0], std::pow(10.0, -static_cast<double>(state.range(0))))
                 .breaks.size() -
        1;
  state.counters["pieces"] = static_cast<double>(pieces);
}

void arrangement(benchmark::State& state)
{
  const SC::Constraint_system_d system = make_system(quartic());
  const auto set = SC::solve_curves(system);
  std::size_t edges = 0;
  for (auto _ : state)
    edges = SC::to_arrangement(system, set, 1e-4).arrangement.number_of_edges();
  state.counters["edges"] = static_cast<double>(edges);
}

BENCHMARK_CAPTURE(solve_curves, two_ovals, sphere_and_cylinder(SC::Exact_rational(1, 2)))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_curves, figure_eight, sphere_and_cylinder(1))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_curves, chebyshev_4, chebyshev_product(4))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_curves, chebyshev_8, chebyshev_product(8))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_curves, chebyshev_16, chebyshev_product(16))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_curves, turned_tori, two_tori(SC::Exact_rational(1, 3), true))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_curves, tori_side_by_side, two_tori(SC::Exact_rational(1, 100), false))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_curves, two_graphs, two_graphs())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(eliminated_to_whole, torus_and_plane, torus_and_plane())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(eliminated_to_whole, circle_in_hyperplanes, circle_in_hyperplanes())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(eliminated_to_whole, two_graphs, two_graphs())->Unit(benchmark::kMillisecond);
#ifdef CGAL_LINKED_WITH_TBB
BENCHMARK_CAPTURE(sequential_to_parallel, chebyshev_16, chebyshev_product(16))->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sequential_to_parallel, turned_tori, two_tori(SC::Exact_rational(1, 3), true))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sequential_to_parallel, tori_side_by_side, two_tori(SC::Exact_rational(1, 100), false))
    ->Unit(benchmark::kMillisecond);
#endif
BENCHMARK(differentials_at_a_point)->Unit(benchmark::kMicrosecond);
BENCHMARK(differentials_at_a_vertex)->Unit(benchmark::kMicrosecond);
BENCHMARK(turning_points)->Unit(benchmark::kMillisecond);
BENCHMARK(curvature_extremes)->Unit(benchmark::kMillisecond);
BENCHMARK(fitted_spline)->Arg(3)->Arg(6)->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK(arrangement)->Unit(benchmark::kMillisecond);

} // namespace
