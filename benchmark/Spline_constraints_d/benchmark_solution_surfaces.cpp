// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces of solutions with their topology.

#include "compare_in_turns.h"

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surface_fitting.h>
#include <CGAL/Spline_constraints_d/solver/Surface_solver_d.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;

namespace {

const auto unknowns = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
const SC::Expression x = std::get<0>(unknowns), y = std::get<1>(unknowns), z = std::get<2>(unknowns);

SC::Constraint torus(const SC::Expression& a, const SC::Expression& b, const SC::Expression& c)
{
  const SC::Expression ring = square(a) + square(b);
  return square(ring + square(c) + Rational(91) / 100) - 4 * ring == 0;
}

SC::Constraint tangle_cube()
{
  const auto quartic = [](const SC::Expression& t) { return square(square(t)) - 5 * square(t); };
  return quartic(x) + quartic(y) + quartic(z) + Rational(59) / 5 == 0;
}

// The sum of three Chebyshev polynomials: of genus 28.
SC::Constraint chebyshev_surface()
{
  auto [a, b, c] = SC::unknowns({Rational(-6) / 5, Rational(6) / 5}, {Rational(-6) / 5, Rational(6) / 5},
                                {Rational(-6) / 5, Rational(6) / 5});
  const auto t6 = [](const SC::Expression& t) {
    return 32 * square(t * t * t) - 48 * square(square(t)) + 18 * square(t) - 1;
  };
  return t6(a) + t6(b) + t6(c) == 0;
}

SC::Constraint_system_d clifford_torus()
{
  auto [a, b, c, d] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  return SC::make_system(std::array{square(a) + square(b) == 1, square(c) + square(d) == 1});
}

// A sphere that two others of one dimension more have in common.
SC::Constraint_system_d common_sphere()
{
  auto [a, b, c, d] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  const SC::Expression rest = square(b) + square(c) + square(d);
  return SC::make_system(std::array{square(a) + rest == 1, square(a - 1) + rest == 1});
}

// A sphere in two hyperplanes of space of dimension five.
SC::Constraint_system_d sphere_in_hyperplanes()
{
  auto [a, b, c, d, e] = SC::unknowns({-2, 2}, {-2, 2}, {-2, 2}, {-2, 2}, {-2, 2});
  return SC::make_system(std::array{square(a) + square(b) + square(c) + square(d) + square(e) == 1,
                                    a - b + d == Rational(1) / 4, 2 * a - e + d - c == Rational(-1) / 8});
}

// A torus with a function of degree one on it.
SC::Constraint_system_d torus_and_height()
{
  auto [a, b, c, height] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3}, {-3, 3});
  return SC::make_system(std::array{torus(a, b, c), height == a - c});
}

void eliminated_to_whole(benchmark::State& state, const SC::Constraint_system_d& system)
{
  const SC::Surface_solver_d<> whole;
  const auto eliminated = SC::solve_surfaces(system), as_it_is = whole(system);
  if (!eliminated.is_complete() || eliminated.euler_characteristic() != as_it_is.euler_characteristic())
    state.SkipWithError("the answers differ");
  solver_benchmark::compare_in_turns(
      state, [&] { benchmark::DoNotOptimize(SC::solve_surfaces(system)); },
      [&] { benchmark::DoNotOptimize(whole(system)); }, "eliminated", "whole", solver_benchmark::seconds_of_thread);
  state.counters["eliminated_nodes"] = static_cast<double>(eliminated.summary().nodes);
  state.counters["whole_nodes"] = static_cast<double>(as_it_is.summary().nodes);
}

void solve_surfaces(benchmark::State& state, const SC::Constraint_system_d& system)
{
  std::size_t patches = 0, nodes = 0;
  bool is_complete = false;
  for (auto _ : state) {
    const SC::Surface_solution_set_d set = SC::solve_surfaces(system);
    patches = set.patches().size();
    nodes = set.summary().nodes;
    is_complete = set.is_complete();
  }
  state.counters["patches"] = static_cast<double>(patches);
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["complete"] = is_complete;
}

// An atlas of B-spline surfaces, with the tolerance 10^-e.
void fit_surfaces(benchmark::State& state, const SC::Constraint_system_d& system)
{
  const SC::Surface_solution_set_d set = SC::solve_surfaces(system);
  SC::Surface_atlas_d atlas;
  for (auto _ : state)
    atlas = SC::fit_bspline_surfaces(set, {.tolerance = std::pow(10.0, -static_cast<double>(state.range(0)))});
  std::size_t pieces = 0;
  for (const SC::Fitted_surface_d& chart : atlas.charts)
    pieces += chart.number_of_pieces();
  state.counters["charts"] = static_cast<double>(atlas.charts.size());
  state.counters["pieces"] = static_cast<double>(pieces);
  state.counters["error"] = atlas.error;
  state.counters["complete"] = atlas.is_complete();
}

// The part above a plane.
SC::Constraint_system_d
half(const std::function<SC::Constraint(const SC::Expression&, const SC::Expression&, const SC::Expression&)>& surface)
{
  auto [a, b, c] = SC::unknowns({-2, 2}, {-2, 2}, {0, 2});
  return SC::make_system(std::array{surface(a, b, c)});
}

SC::Constraint sphere(const SC::Expression& a, const SC::Expression& b, const SC::Expression& c)
{
  return square(a) + square(b) + square(c) == 1;
}

#define SURFACES(name, system) BENCHMARK_CAPTURE(solve_surfaces, name, system)->Unit(benchmark::kMillisecond)

SURFACES(sphere, SC::make_system(std::array{square(x) + square(y) + square(z) == 1}));
SURFACES(torus, SC::make_system(std::array{torus(x, y, z)}));
SURFACES(half_torus, SC::make_system(std::array{torus(x, y, z), x >= 0}));
SURFACES(tangle_cube, SC::make_system(std::array{tangle_cube()}));
SURFACES(genus_28, SC::make_system(std::array{chebyshev_surface()}));
SURFACES(clifford_torus, clifford_torus());
BENCHMARK_CAPTURE(eliminated_to_whole, common_sphere, common_sphere())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(eliminated_to_whole, sphere_in_hyperplanes, sphere_in_hyperplanes())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(eliminated_to_whole, torus_and_height, torus_and_height())->Unit(benchmark::kMillisecond);
SURFACES(cone, SC::make_system(std::array{square(x) + square(y) == square(z)}));
SURFACES(cubic_with_four_nodes,
         SC::make_system(std::array{square(x) + square(y) - square(x) * z + square(y) * z + square(z) == 1}));
SURFACES(touching_spheres,
         SC::make_system(std::array{
             (square(x - 1) + square(y) + square(z) - 1) * (square(x + 1) + square(y) + square(z) - 1) == 0}));

} // namespace

#define FITTED(name, system)                                                                                           \
  BENCHMARK_CAPTURE(fit_surfaces, name, system)->DenseRange(2, 5)->Unit(benchmark::kMillisecond)

FITTED(half_sphere, half(sphere));
FITTED(half_torus, half(torus));
FITTED(sphere, SC::make_system(std::array{sphere(x, y, z)}));
FITTED(torus, SC::make_system(std::array{torus(x, y, z)}));
FITTED(tangle_cube, SC::make_system(std::array{tangle_cube()}));
