// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// All signatures of approximate polygons, and where the points of one signature are. The argument is the number of
// edges: of a convex polygon, and of a star, with corners that are rounded to integers, and bands for an error of one.
#include <CGAL/Spline_constraints_d/operations/approximate_polygons/approximate_polygons_2.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>
#include <string>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;

namespace {

// Every other corner is nearer to the center by a factor.
SC::Approximate_polygon_2 polygon_of(int edges, double factor)
{
  CGAL::Polygon_2<K> result;
  for (int i = 0; i < edges; ++i) {
    const double angle = 2 * std::numbers::pi * i / edges, radius = i % 2 == 0 ? 1000 : 1000 * factor;
    result.push_back(K::Point_2(std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))));
  }
  return SC::approximate_polygon(result, 1.0);
}

void make(benchmark::State& state, double factor)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(polygon_of(static_cast<int>(state.range(0)), factor));
}

void all_signatures(benchmark::State& state, double factor)
{
  const SC::Approximate_polygon_2 polygon = polygon_of(static_cast<int>(state.range(0)), factor);
  std::size_t signatures = 0, nodes = 0;
  for (auto _ : state) {
    const SC::Signature_cells_2 cells = SC::signature_cells(polygon);
    signatures = cells.cells().size();
    nodes = cells.summary().nodes;
  }
  state.counters["signatures"] = static_cast<double>(signatures);
  state.counters["nodes"] = static_cast<double>(nodes);
}

// All on the inner side, in turns with all on the outer side, of which there is no model.
void one_signature(benchmark::State& state, double factor)
{
  const SC::Approximate_polygon_2 polygon = polygon_of(static_cast<int>(state.range(0)), factor);
  char side = 'L';
  for (auto _ : state) {
    side = side == 'L' ? 'R' : 'L';
    benchmark::DoNotOptimize(polygon.locate(std::string(polygon.size(), side)));
  }
}

} // namespace

BENCHMARK_CAPTURE(make, convex, 1.0)->Arg(4)->Arg(8)->Arg(16)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(make, star, 0.6)->Arg(8)->Arg(16)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_signature, convex, 1.0)->Arg(4)->Arg(8)->Arg(16)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(one_signature, star, 0.6)->Arg(8)->Arg(16)->Arg(32)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(all_signatures, convex, 1.0)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(all_signatures, star, 0.6)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
