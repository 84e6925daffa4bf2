// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closest points of splines with many pieces: a point and a curve, two curves, a point and a surface, a curve and a
// surface; and queries of prepared ones: a million nearest points, and first hits of rays. The argument is the number
// of pieces along each parameter.

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/distances/Curve_locator.h>
#include <CGAL/Spline_constraints_d/operations/distances/Surface_locator_3.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Curve = SC::Bspline_curve_3<K>;
using Surface = SC::Bspline_surface_3<K>;

namespace {

constexpr double extent = 10;

std::vector<double> knots(int pieces)
{
  std::vector<double> result(3, 0);
  for (int i = 0; i <= pieces; ++i)
    result.push_back(i);
  result.insert(result.end(), 3, pieces);
  return result;
}

// A cubic spline along the first axis, with waves of height 1 around a height.
Curve random_curve(int pieces, double height, std::mt19937& generator)
{
  std::uniform_real_distribution<double> wave(-1, 1);
  std::vector<K::Point_3> points;
  for (int i = 0; i < pieces + 3; ++i)
    points.emplace_back(extent * i / pieces, wave(generator), height + wave(generator));
  return Curve(3, knots(pieces), points);
}

// A bicubic one over a square, in the height 0.
Surface random_surface(int pieces, std::mt19937& generator)
{
  std::uniform_real_distribution<double> wave(-1, 1);
  std::vector<K::Point_3> points;
  for (int i = 0; i < pieces + 3; ++i)
    for (int j = 0; j < pieces + 3; ++j)
      points.emplace_back(extent * i / pieces, extent * j / pieces, wave(generator));
  return Surface({3, 3}, knots(pieces), knots(pieces), points);
}

template <class A, class B>
void measure(benchmark::State& state, const A& a, const B& b)
{
  for (auto _ : state) {
    const auto closest = SC::closest_points(a, b);
    if (!closest.is_complete())
      state.SkipWithError("undecided");
    state.counters["nodes"] = static_cast<double>(closest.summary().nodes);
  }
}

const K::Point_3 point(4.3, 0.4, 5);

void point_and_curve(benchmark::State& state)
{
  std::mt19937 generator(1);
  measure(state, point, random_curve(static_cast<int>(state.range(0)), 0, generator));
}

void curve_and_curve(benchmark::State& state)
{
  std::mt19937 generator(2);
  const Curve first = random_curve(static_cast<int>(state.range(0)), 0, generator);
  measure(state, first, random_curve(static_cast<int>(state.range(0)), 6, generator));
}

void point_and_surface(benchmark::State& state)
{
  std::mt19937 generator(3);
  measure(state, point, random_surface(static_cast<int>(state.range(0)), generator));
}

void curve_and_surface(benchmark::State& state)
{
  std::mt19937 generator(4);
  const Surface surface = random_surface(static_cast<int>(state.range(0)), generator);
  measure(state, random_curve(static_cast<int>(state.range(0)), 6, generator), surface);
}

// Nearest points of a prepared curve or surface, for points around it; `items_per_second` is their number.
template <class Locator>
void locate(benchmark::State& state, const Locator& locator, double width)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> along(0, extent), across(0, width), height(-3, 3);
  std::size_t unique = 0;
  for (auto _ : state) {
    const double x = along(generator), y = across(generator), z = height(generator);
    unique += locator.closest_point(K::Point_3(x, y, z)).is_unique();
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["not unique"] = static_cast<double>(static_cast<std::size_t>(state.iterations()) - unique);
}

void nearest_on_curve(benchmark::State& state)
{
  std::mt19937 generator(1);
  locate(state, SC::Curve_locator(random_curve(static_cast<int>(state.range(0)), 0, generator)), 3);
}

void nearest_on_surface(benchmark::State& state)
{
  std::mt19937 generator(3);
  locate(state, SC::Surface_locator_3(random_surface(static_cast<int>(state.range(0)), generator)), extent);
}

void first_hit_of_ray(benchmark::State& state)
{
  std::mt19937 generator(3);
  const SC::Surface_locator_3 locator(random_surface(static_cast<int>(state.range(0)), generator));
  std::uniform_real_distribution<double> along(0, extent), height(-3, 3);
  std::size_t hits = 0;
  for (auto _ : state) {
    const double x = along(generator), y = along(generator), z = height(generator), to_x = along(generator),
                 to_y = along(generator), to_z = height(generator);
    hits += locator.first_intersection(K::Ray_3(K::Point_3(x, y, z), K::Point_3(to_x, to_y, to_z))).has_value();
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(state.iterations());
}

} // namespace

BENCHMARK(nearest_on_curve)->Arg(1)->Arg(100)->Arg(1000)->Iterations(1000000)->Unit(benchmark::kMicrosecond);
BENCHMARK(nearest_on_surface)->Arg(1)->Arg(20)->Iterations(1000000)->Unit(benchmark::kMicrosecond);
BENCHMARK(first_hit_of_ray)->Arg(1)->Arg(20)->Iterations(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(point_and_curve)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(curve_and_curve)->Arg(1)->Arg(10)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(point_and_surface)->Arg(1)->Arg(10)->Arg(30)->Unit(benchmark::kMillisecond);
BENCHMARK(curve_and_surface)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);
