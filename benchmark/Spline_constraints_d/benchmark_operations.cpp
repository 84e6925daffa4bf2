// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Many curves: all intersections of 1,000 cubic segments with 1,000 others, as in a drawing, of two splines with many pieces, and of splines and polylines with themselves; curves of
// solutions.

#include <CGAL/Spline_constraints_d/geometry/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/pairwise_intersections.h>
#include <CGAL/Spline_constraints_d/operations/self_intersections.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Curve = SC::Bspline_curve_2<K>;

namespace {

// A walk in the unit square with steps of up to 0.02.
std::vector<K::Point_2> random_walk(std::size_t count, std::mt19937& generator)
{
  std::uniform_real_distribution<double> place(0, 1), step(-0.02, 0.02);
  std::vector<K::Point_2> result{{place(generator), place(generator)}};
  while (result.size() < count)
    result.emplace_back(result.back().x() + step(generator), result.back().y() + step(generator));
  return result;
}

std::vector<Curve> random_segments(std::size_t count, std::mt19937& generator)
{
  std::vector<Curve> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(SC::bezier_curve(random_walk(4, generator)));
  return result;
}

Curve random_spline(int pieces, std::mt19937& generator)
{
  std::vector<double> knots(3, 0);
  for (int i = 0; i <= pieces; ++i)
    knots.push_back(i);
  knots.insert(knots.end(), 3, pieces);
  return Curve(3, knots, random_walk(static_cast<std::size_t>(pieces) + 3, generator));
}

void segments_with_segments(benchmark::State& state)
{
  std::mt19937 generator(1);
  const std::size_t count = static_cast<std::size_t>(state.range(0));
  const std::vector<Curve> first = random_segments(count, generator), second = random_segments(count, generator);
  std::size_t points = 0;
  for (auto _ : state) {
    const auto result = SC::pairwise_intersections(first, second);
    points = 0;
    for (const auto& pair : result.pairs)
      points += pair.intersections.size();
  }
  state.counters["intersections"] = static_cast<double>(points);
}

void spline_with_spline(benchmark::State& state)
{
  std::mt19937 generator(1);
  const Curve first = random_spline(static_cast<int>(state.range(0)), generator), second = random_spline(static_cast<int>(state.range(0)), generator);
  std::size_t points = 0;
  for (auto _ : state)
    points = SC::intersections(first, second).size();
  state.counters["intersections"] = static_cast<double>(points);
}

void count_self_intersections(benchmark::State& state, const Curve& curve)
{
  std::size_t points = 0, nodes = 0;
  for (auto _ : state) {
    const auto result = SC::self_intersections(curve);
    points = result.size();
    nodes = result.summary().nodes;
  }
  state.counters["intersections"] = static_cast<double>(points);
  state.counters["nodes"] = static_cast<double>(nodes);
}

// Three times x = t^2 - 1, y = t (t^2 - 1) for t in [-2,2].
void nodal_cubic_with_itself(benchmark::State& state)
{
  count_self_intersections(state, SC::bezier_curve(std::vector<K::Point_2>{{9, -18}, {-7, 26}, {-7, -26}, {9, 18}}));
}

void spline_with_itself(benchmark::State& state)
{
  std::mt19937 generator(1);
  count_self_intersections(state, random_spline(static_cast<int>(state.range(0)), generator));
}

void polyline_with_itself(benchmark::State& state)
{
  std::mt19937 generator(1);
  count_self_intersections(state, SC::polyline_curve(random_walk(static_cast<std::size_t>(state.range(0)) + 1, generator)));
}

// T_d(x) T_d(y) = 1/2.
void chebyshev_contours(benchmark::State& state)
{
  auto [x, y] = SC::unknowns({-1, 1}, {-1, 1});
  const auto chebyshev = [&](const SC::Expression& t) {
    SC::Expression previous(1), current = t;
    for (int d = 1; d < state.range(0); ++d) {
      const SC::Expression next = 2 * t * current - previous;
      previous = current;
      current = next;
    }
    return current;
  };
  const std::vector<SC::Constraint> constraints{chebyshev(x) * chebyshev(y) == SC::Exact_rational(1, 2)};
  const SC::Constraint_system_d system = make_system(constraints);
  std::size_t closed = 0, open = 0;
  for (auto _ : state) {
    const auto curves = SC::solve_curves(system);
    closed = curves.number_of_closed_curves();
    open = curves.number_of_open_curves();
  }
  state.counters["closed"] = static_cast<double>(closed);
  state.counters["open"] = static_cast<double>(open);
}

void sphere_and_cylinder(benchmark::State& state)
{
  auto [x, y, z] = SC::unknowns({-3, 3}, {-3, 3}, {-3, 3});
  const std::vector<SC::Constraint> constraints{x * x + y * y + z * z == 4, square(x - SC::Exact_rational(static_cast<int>(state.range(0)), 2)) + y * y == 1};
  const SC::Constraint_system_d system = make_system(constraints);
  for (auto _ : state)
    benchmark::DoNotOptimize(SC::solve_curves(system));
}

} // namespace

BENCHMARK(segments_with_segments)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(spline_with_spline)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(nodal_cubic_with_itself)->Unit(benchmark::kMillisecond);
BENCHMARK(spline_with_itself)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(polyline_with_itself)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(chebyshev_contours)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(sphere_and_cylinder)->ArgName("2c")->Arg(1)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);
