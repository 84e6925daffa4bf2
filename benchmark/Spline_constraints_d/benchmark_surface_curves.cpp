// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves on one surface: silhouettes, plane sections, boundaries of what a tool reaches, silhouettes of sweeps.

#include <CGAL/Spline_constraints_d/geometry/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/accessibility.h>
#include <CGAL/Spline_constraints_d/operations/plane_sections.h>
#include <CGAL/Spline_constraints_d/operations/silhouettes.h>
#include <CGAL/Spline_constraints_d/operations/sweep_silhouettes.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Surface = SC::Bspline_surface_3<K>;
using Point = K::Point_3;
using Vector = K::Vector_3;

namespace {

// With random heights, over a grid of n x n pieces of degree p.
Surface landscape(int degree, int pieces, double height)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> random_height(0, height);
  const int n = degree + pieces;
  std::vector<Point> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      points.emplace_back(8. * i / (n - 1) - 4, 8. * j / (n - 1) - 4, random_height(generator));
  std::vector<double> knots(static_cast<std::size_t>(degree), 0);
  for (int i = 0; i <= pieces; ++i)
    knots.push_back(i);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), pieces);
  return Surface({degree, degree}, knots, knots, points);
}

template <class Operation>
void curves(benchmark::State& state, const Operation& operation)
{
  std::size_t count = 0, nodes = 0;
  bool is_complete = true;
  for (auto _ : state) {
    const auto set = operation();
    count = set.curves().size();
    nodes = set.summary().nodes;
    is_complete = set.is_complete();
  }
  state.counters["curves"] = static_cast<double>(count);
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["complete"] = is_complete;
}

const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1), ball = SC::sphere_surface<K>(Point(1, 0.25, 4), Point(1.5, 0.75, 4.75));
const auto torus_silhouettes = [] { return SC::silhouettes(torus, Vector(1, 2, 3)); };
const auto torus_seen_from_near = [] { return SC::silhouettes(torus, Point(10, 3, 2)); };
const auto bicubic_silhouettes = [] { return SC::silhouettes(landscape(3, 1, 3), Vector(1, 2, 0.5)); };
const auto many_pieces_silhouettes = [] { return SC::silhouettes(landscape(3, 10, 3), Vector(1, 2, 0.5)); };
const auto many_pieces_section = [] { return SC::plane_sections(landscape(3, 10, 3), Vector(0, 0, 1), {1.5}).front(); };
const auto sphere_along_normals = [] { return SC::accessibility_boundaries(landscape(2, 1, 2), K::Sphere_3(Point(1, 0.25, 4), 1)); };
const auto surface_along_normals = [] { return SC::accessibility_boundaries(landscape(2, 1, 2), ball); };
const auto surface_along_direction = [] { return SC::accessibility_boundaries(landscape(2, 1, 2), ball, {.direction = Vector(0, 0, 1)}); };
const auto swept_sphere = [] {
  const SC::Bspline_curve_3<K> path(3, {0, 0, 0, 0, 1, 1, 1, 1}, {{-4, -2, 0}, {-1, 4, 1}, {1, -5, 2}, {4, 2, 0}});
  return SC::sweep_silhouettes(SC::sphere_surface<K>(Point(0, 0, 0), 1), {path, {}}, {Point(1, -2, 9)}).front();
};

} // namespace

BENCHMARK_CAPTURE(curves, torus_silhouettes, torus_silhouettes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, torus_seen_from_near, torus_seen_from_near)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, bicubic_silhouettes, bicubic_silhouettes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, many_pieces_silhouettes, many_pieces_silhouettes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, many_pieces_section, many_pieces_section)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, sphere_along_normals, sphere_along_normals)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, surface_along_normals, surface_along_normals)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, surface_along_direction, surface_along_direction)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, swept_sphere, swept_sphere)->Unit(benchmark::kMillisecond);
