// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Surfaces that geometry makes: bisectors and sectors of two surfaces, also trimmed, and the envelope of an ellipsoid
// that turns about an axis, each with its topology; and triangles of the envelope.

#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/alpha_sector_surface.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/surface_bisector.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/sweep_envelope.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/trimmed_surface_bisectors.h>

#include <benchmark/benchmark.h>

#include <cstddef>
#include <random>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Surface = SC::Bspline_surface_3<Kernel>;

namespace {

// Over the unit square, with random heights of control points up to a number.
Surface random_surface(int degree, double z, double height, unsigned seed)
{
  std::mt19937 random(seed);
  std::vector<Point> points;
  for (int i = 0; i <= degree; ++i)
    for (int j = 0; j <= degree; ++j)
      points.emplace_back(static_cast<double>(i) / degree, static_cast<double>(j) / degree,
                          z + height * (static_cast<int>(random() % 201) - 100) / 100);
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0);
  knots.resize(2 * knots.size(), 1);
  return Surface({degree, degree}, knots, knots, points);
}

Surface plane(double z)
{
  return Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {{-1, -1, z}, {-1, 2, z}, {2, -1, z}, {2, 2, z}});
}

void count(benchmark::State& state, const SC::Envelope_surface_3& surface)
{
  state.counters["nodes"] = static_cast<double>(surface.summary().nodes);
  state.counters["characteristic"] = surface.euler_characteristic();
  state.counters["complete"] = surface.is_complete();
}

void bisector(benchmark::State& state, const Surface& first, const Surface& second)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(SC::surface_bisector(first, second, 2));
  count(state, SC::surface_bisector(first, second, 2));
}

// z = 1 - 2 x^2
Surface trough()
{
  return Surface(
      {2, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1},
      {{-0.5, -0.5, 0.5}, {-0.5, 0.5, 0.5}, {0, -0.5, 1.5}, {0, 0.5, 1.5}, {0.5, -0.5, 0.5}, {0.5, 0.5, 0.5}});
}

// Between both surfaces.
void trimmed_bisector(benchmark::State& state, const Surface& first, const Surface& second)
{
  const auto run = [&] {
    return SC::trimmed_surface_bisector(first, second, 2, {SC::Touched_side::POSITIVE, SC::Touched_side::NEGATIVE});
  };
  for (auto _ : state)
    benchmark::DoNotOptimize(run());
  const SC::Trimmed_envelope_surface_3 trimmed = run();
  using SC::Nearest_feet_label;
  const auto count_label = [&](const char* name, Nearest_feet_label label) {
    state.counters[name] = static_cast<double>(trimmed.number_of_cells(label));
  };
  count_label("kept", Nearest_feet_label::NEAREST);
  count_label("removed", Nearest_feet_label::NOT_NEAREST);
  count_label("divided", Nearest_feet_label::BOTH);
  count_label("undecided", Nearest_feet_label::UNDECIDED);
}

void sector(benchmark::State& state, const Surface& first, const Surface& second)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(SC::alpha_sector_surface(first, second, 0.25));
  count(state, SC::alpha_sector_surface(first, second, 0.25));
}

SC::Envelope_surface_3 ring()
{
  const auto ellipsoid =
      SC::sphere_surface<Kernel>(Point(0, 0, 0), 1).transformed({1, 0, 0, 2, 0, 0.5, 0, 0, 0, 0, 0.625, 0});
  return SC::sweep_envelope(ellipsoid, SC::Rational_motion_3::full_turn(Point(0, 0, 0), Kernel::Vector_3(0, 0, 1)));
}

void ellipsoid_on_circle(benchmark::State& state)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(ring());
  count(state, ring());
}

void triangles_of_ellipsoid_on_circle(benchmark::State& state)
{
  const SC::Envelope_surface_3 envelope = ring();
  std::size_t vertices = 0;
  for (auto _ : state)
    vertices = envelope.mesh({.chord_error = 0.005, .angle = 10}).mesh.number_of_vertices();
  state.counters["vertices"] = static_cast<double>(vertices);
}

BENCHMARK_CAPTURE(bisector, plane_and_biquadratic, plane(0), random_surface(2, 1, 0.2, 1))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bisector, biquadratics, random_surface(2, 0, 0.1, 1), random_surface(2, 1, 0.1, 2))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bisector, bicubics_of_height_0_01, random_surface(3, 0, 0.01, 1), random_surface(3, 1, 0.01, 2))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(bisector, bicubics_of_height_0_1, random_surface(3, 0, 0.1, 1), random_surface(3, 1, 0.1, 2))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sector, bicubics_of_height_0_1, random_surface(3, 0, 0.1, 1), random_surface(3, 1, 0.1, 2))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trimmed_bisector, plane_and_trough, plane(0), trough())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trimmed_bisector, bicubics_of_height_0_01, random_surface(3, 0, 0.01, 1),
                  random_surface(3, 1, 0.01, 2))
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(trimmed_bisector, bicubics_of_height_0_1, random_surface(3, 0, 0.1, 1), random_surface(3, 1, 0.1, 2))
    ->Unit(benchmark::kMillisecond);
BENCHMARK(ellipsoid_on_circle)->Unit(benchmark::kMillisecond);
BENCHMARK(triangles_of_ellipsoid_on_circle)->Unit(benchmark::kMillisecond);

} // namespace
