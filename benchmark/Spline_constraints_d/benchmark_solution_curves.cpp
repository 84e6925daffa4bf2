// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What is done with a curve of solutions: derivatives at a point, extremes, fitted splines and arrangements. The curve is the quartic of the example curve_geometry.

#include <CGAL/Spline_constraints_d/geometry/spline_fitting.h>
#include <CGAL/Spline_constraints_d/operations/to_arrangement_2.h>
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
  return {square(x*x + y*y) - 2*(x*x - y*y) + x*y/2 - x/4 == SC::Exact_rational(1, 2)};
}

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
    pieces = SC::fit_spline(system, set, set.curves()[0], std::pow(10.0, -static_cast<double>(state.range(0)))).breaks.size() - 1;
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

BENCHMARK(differentials_at_a_point)->Unit(benchmark::kMicrosecond);
BENCHMARK(differentials_at_a_vertex)->Unit(benchmark::kMicrosecond);
BENCHMARK(turning_points)->Unit(benchmark::kMillisecond);
BENCHMARK(curvature_extremes)->Unit(benchmark::kMillisecond);
BENCHMARK(fitted_spline)->Arg(3)->Arg(6)->Arg(9)->Unit(benchmark::kMillisecond);
BENCHMARK(arrangement)->Unit(benchmark::kMillisecond);

} // namespace
