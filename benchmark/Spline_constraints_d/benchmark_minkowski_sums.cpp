// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Minkowski sums: of random polygons, in turns with those of CGAL, by the time of the processor; `difference` is that
// of both areas; and of regions bounded by periodic cubic splines. `complete` is 1 where all of the sum is proved.

#include "compare_in_turns.h"
#include "polygon_area.h"

#include <CGAL/Spline_constraints_d/operations/minkowski_sum/minkowski_sums_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/minkowski_sum_2.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <ctime>
#include <random>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Exact_kernel = CGAL::Exact_predicates_exact_constructions_kernel;

namespace {

template <class Kernel>
CGAL::Polygon_2<Kernel> star(unsigned seed, std::size_t corners)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0, 0.5), length(2, 4);
  CGAL::Polygon_2<Kernel> result;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * CGAL_PI * (static_cast<double>(i) + part(random)) / static_cast<double>(corners),
                 radius = length(random);
    result.push_back(typename Kernel::Point_2(radius * std::cos(angle), radius * std::sin(angle)));
  }
  return result;
}

void sum_of_polygons(benchmark::State& state)
{
  const std::size_t m = static_cast<std::size_t>(state.range(0)), n = static_cast<std::size_t>(state.range(1));
  const auto a = SC::planar_region(star<K>(1, m)), b = SC::planar_region(star<K>(2, n));
  const auto exact_a = star<Exact_kernel>(1, m), exact_b = star<Exact_kernel>(2, n);
  double own = 0, expected = 0;
  bool is_complete = false;
  const auto sum = [&] {
    const auto result = SC::minkowski_sum(a, b);
    is_complete = result.is_complete();
    own = area(result.polygons_with_holes(1).front());
  };
  const auto sum_of_CGAL = [&] { expected = area(CGAL::minkowski_sum_2(exact_a, exact_b)); };
  solver_benchmark::compare_in_turns(state, sum, sum_of_CGAL, "own", "CGAL",
                                     [] { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; });
  state.counters["complete"] = is_complete;
  state.counters["difference"] = std::abs(own - expected);
}
BENCHMARK(sum_of_polygons)
    ->Args({10, 4})
    ->Args({10, 10})
    ->Args({30, 10})
    ->Args({30, 30})
    ->Args({100, 4})
    ->Args({100, 10})
    ->Args({100, 30})
    ->Unit(benchmark::kMillisecond);

SC::Planar_region_2<K> smooth_region(const std::vector<K::Point_2>& points)
{
  std::vector<double> period;
  for (std::size_t i = 0; i <= points.size(); ++i)
    period.push_back(static_cast<double>(i));
  return SC::planar_region(SC::Bspline_curve_2<K>::from_periodic(3, period, points));
}

SC::Planar_region_2<K> kidney() { return smooth_region({{0, 0}, {4, 0}, {4, 3}, {2, 1}, {2, 4}, {0, 5}, {-1, 2}}); }
SC::Planar_region_2<K> moon() { return smooth_region({{0, 0}, {2, 0}, {0.75, 0.75}, {2.25, 2}, {0, 1.5}}); }
SC::Planar_region_2<K> egg() { return smooth_region({{0, 0}, {2, 0}, {2.5, 1}, {1.5, 3}, {0, 2}}); }

void sum_of_regions(benchmark::State& state, const SC::Planar_region_2<K>& a, const SC::Planar_region_2<K>& b)
{
  for (auto _ : state) {
    const auto sum = SC::minkowski_sum(a, b);
    state.counters["boundaries"] = static_cast<double>(sum.boundaries().size());
    state.counters["complete"] = sum.is_complete();
  }
}
BENCHMARK_CAPTURE(sum_of_regions, two_convex, egg(), egg())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sum_of_regions, kidney_and_egg, kidney(), egg())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sum_of_regions, kidney_and_moon, kidney(), moon())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sum_of_regions, kidney_and_star, kidney(), SC::planar_region(star<K>(1, 10)))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sum_of_regions, two_kidneys, kidney(), kidney())->Unit(benchmark::kMillisecond);

} // namespace
