// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams of 10, 100 and 1,000 cubic segments, each in a cell of its own, of points, of closed chains of
// cubics with decimal coordinates, whose joints are smooth but for rounding, and of random scenes of 2 to 51 cubics
// that cross themselves, or each other as well. `complete` is 1 where all of the diagram is proved; of chains and
// scenes it is the number of those.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/voronoi_diagrams_2.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Curve = SC::Bspline_curve_2<K>;

namespace {

// Control points with increasing x or y, so that no segment crosses itself.
std::vector<Curve> cubics_in_cells(std::size_t count)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> coordinate(1, 9);
  const std::size_t columns = static_cast<std::size_t>(std::ceil(std::sqrt(count)));
  std::vector<Curve> result;
  for (std::size_t i = 0; i < count; ++i) {
    const double left = 10.0 * static_cast<double>(i % columns), low = 10.0 * static_cast<double>(i / columns);
    std::vector<double> increasing(4);
    std::generate(increasing.begin(), increasing.end(), [&] { return coordinate(generator); });
    std::sort(increasing.begin(), increasing.end());
    std::vector<K::Point_2> points;
    for (const double t : increasing)
      points.push_back(i % 2 == 0 ? K::Point_2(left + t, low + coordinate(generator))
                                  : K::Point_2(left + coordinate(generator), low + t));
    result.push_back(SC::bezier_curve(points));
  }
  return result;
}

void diagram_of_cubics(benchmark::State& state)
{
  const std::vector<Curve> curves = cubics_in_cells(static_cast<std::size_t>(state.range(0)));
  for (auto _ : state) {
    const auto diagram = SC::voronoi_diagram(curves);
    state.counters["edges"] = static_cast<double>(diagram.edges().size());
    state.counters["complete"] = diagram.is_complete();
  }
}
BENCHMARK(diagram_of_cubics)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

// Four to eight cubics around the origin, with the same tangent where they meet, in coordinates that are rounded to
// three digits, and their sums and differences to doubles.
std::vector<Curve> closed_chain(unsigned seed)
{
  std::mt19937 generator(seed);
  const auto rounded = [](double x) { return std::round(1000 * x) / 1000; };
  const std::size_t n = 4 + seed % 5;
  std::vector<K::Point_2> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double direction = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n),
                 radius = std::uniform_real_distribution<double>(3, 7)(generator);
    points.emplace_back(rounded(radius * std::cos(direction)), rounded(radius * std::sin(direction)));
  }
  std::vector<K::Vector_2> tangents;
  for (std::size_t i = 0; i < n; ++i) {
    const K::Vector_2 chord = points[(i + 1) % n] - points[(i + n - 1) % n];
    const double length = std::uniform_real_distribution<double>(0.12, 0.22)(generator);
    tangents.emplace_back(rounded(length * chord.x()), rounded(length * chord.y()));
  }
  std::vector<Curve> result;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    result.push_back(SC::bezier_curve(
        std::vector<K::Point_2>{points[i], points[i] + tangents[i], points[j] - tangents[j], points[j]}));
  }
  return result;
}

void diagrams_of_closed_chains(benchmark::State& state)
{
  for (auto _ : state) {
    double complete = 0;
    for (unsigned seed = 0; seed < state.range(0); ++seed)
      complete += SC::voronoi_diagram(closed_chain(seed)).is_complete();
    state.counters["complete"] = complete;
  }
}
BENCHMARK(diagrams_of_closed_chains)->Arg(50)->Unit(benchmark::kMillisecond);

// Each has its control points within its cell, or within a square around it that is larger by half of a cell on all
// sides.
std::vector<Curve> random_scene(unsigned seed, std::size_t count, bool are_crossing)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> coordinate(are_crossing ? -0.5 : 0.1, are_crossing ? 1.5 : 0.9);
  const std::size_t columns = static_cast<std::size_t>(std::ceil(std::sqrt(count)));
  std::vector<Curve> result;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<K::Point_2> points;
    for (int k = 0; k < 4; ++k) {
      const double x = static_cast<double>(i % columns) + coordinate(generator),
                   y = static_cast<double>(i / columns) + coordinate(generator);
      points.emplace_back(x, y);
    }
    result.push_back(SC::bezier_curve(points));
  }
  return result;
}

// V - E + F = 1 + C on the sphere, where infinity is one vertex, the last one here.
bool satisfies_euler(const SC::Voronoi_diagram_of_curves_2<K>& diagram)
{
  const std::size_t infinity = diagram.vertices().size();
  const auto vertex = [&](std::size_t i) { return diagram.vertices()[i].is_at_infinity ? infinity : i; };
  std::vector<std::size_t> parents(infinity + 1);
  std::iota(parents.begin(), parents.end(), 0);
  const auto root = [&](std::size_t i) {
    while (parents[i] != i)
      i = parents[i];
    return i;
  };
  for (const auto& edge : diagram.edges())
    parents[root(vertex(edge.vertices[0]))] = root(vertex(edge.vertices[1]));
  std::set<std::size_t> vertices, components;
  for (std::size_t i = 0; i < infinity; ++i) {
    vertices.insert(vertex(i));
    components.insert(root(vertex(i)));
  }
  return vertices.size() + diagram.number_of_regions() == diagram.edges().size() + 1 + components.size();
}

// Two scenes of each number of cubics: `consistent` is the number of those that satisfy Euler's formula.
void diagrams_of_random_scenes(benchmark::State& state)
{
  for (auto _ : state) {
    double scenes = 0, complete = 0, consistent = 0;
    for (unsigned count = 2; count <= 51; ++count)
      for (const bool are_crossing : {false, true}) {
        const auto diagram = SC::voronoi_diagram(random_scene(42 + count, count, are_crossing));
        ++scenes;
        complete += diagram.is_complete();
        consistent += satisfies_euler(diagram);
      }
    state.counters["scenes"] = scenes;
    state.counters["complete"] = complete;
    state.counters["consistent"] = consistent;
    if (consistent != scenes)
      state.SkipWithError("a diagram is not consistent");
  }
}
BENCHMARK(diagrams_of_random_scenes)->Iterations(1)->Unit(benchmark::kMillisecond);

void diagram_of_points(benchmark::State& state)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> coordinate(0, 100);
  std::vector<K::Point_2> points;
  for (int i = 0; i < state.range(0); ++i)
    points.emplace_back(coordinate(generator), coordinate(generator));
  for (auto _ : state) {
    const auto diagram = SC::voronoi_diagram(std::vector<Curve>(), points);
    state.counters["edges"] = static_cast<double>(diagram.edges().size());
    state.counters["complete"] = diagram.is_complete();
  }
}
BENCHMARK(diagram_of_points)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);

// What is small beside the rest: a gap between segments of length 4, the radius of a circle in one of radius 2, or the
// distance of two points from each other beside a third one, of a negative power of ten.
void diagram_of_small_features(benchmark::State& state)
{
  const double size = std::pow(10, -static_cast<double>(state.range(1)));
  std::vector<Curve> curves;
  std::vector<K::Point_2> points;
  switch (state.range(0)) {
  case 0:
    state.SetLabel("gap");
    curves = {SC::segment_curve(K::Point_2(0, 0), K::Point_2(4, 0)),
              SC::segment_curve(K::Point_2(0, size), K::Point_2(4, size))};
    break;
  case 1:
    state.SetLabel("circle in a circle");
    curves = {SC::circle_curve(K::Point_2(0, 0), 2.), SC::circle_curve(K::Point_2(0.5, 0.25), size)};
    break;
  default:
    state.SetLabel("points");
    points = {K::Point_2(1, 2), K::Point_2(1 + size, 2), K::Point_2(3, 4)};
  }
  for (auto _ : state)
    state.counters["complete"] = SC::voronoi_diagram(curves, points).is_complete();
}
BENCHMARK(diagram_of_small_features)
    ->ArgsProduct({{0, 1, 2}, {3, 6}})
    ->Args({0, 12})
    ->Args({2, 12})
    ->Unit(benchmark::kMillisecond);

} // namespace
