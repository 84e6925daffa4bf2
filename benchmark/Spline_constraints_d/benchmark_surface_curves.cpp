// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Curves on one surface: silhouettes, parabolic lines, umbilics, plane sections, boundaries of what a tool reaches,
// silhouettes of sweeps, self-intersections, and curves along which two surfaces touch.

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/accessibility.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/parabolic_lines.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/plane_sections.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/self_intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouettes.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/sweep_silhouettes.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/umbilics.h>

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

void umbilics_of_landscape(benchmark::State& state)
{
  const Surface surface = landscape(3, static_cast<int>(state.range(0)), 3);
  std::size_t count = 0;
  bool is_complete = true;
  for (auto _ : state) {
    const auto found = SC::umbilics(surface);
    count = found.points().size();
    is_complete = found.is_complete();
  }
  state.counters["points"] = static_cast<double>(count);
  state.counters["complete"] = is_complete;
}

const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1),
              ball = SC::sphere_surface<K>(Point(1, 0.25, 4), Point(1.5, 0.75, 4.75));
const auto torus_silhouettes = [] { return SC::silhouettes(torus, Vector(1, 2, 3)); };
const auto torus_seen_from_near = [] { return SC::silhouettes(torus, Point(10, 3, 2)); };
const auto bicubic_silhouettes = [] { return SC::silhouettes(landscape(3, 1, 3), Vector(1, 2, 0.5)); };
const auto many_pieces_silhouettes = [] { return SC::silhouettes(landscape(3, 10, 3), Vector(1, 2, 0.5)); };
const auto bicubic_parabolic_lines = [] { return SC::parabolic_lines(landscape(3, 1, 3)); };
const auto many_pieces_parabolic_lines = [] { return SC::parabolic_lines(landscape(3, 10, 3)); };
const auto many_pieces_section = [] { return SC::plane_sections(landscape(3, 10, 3), Vector(0, 0, 1), {1.5}).front(); };
const auto sphere_along_normals = [] {
  return SC::accessibility_boundaries(landscape(2, 1, 2), K::Sphere_3(Point(1, 0.25, 4), 1));
};
const auto surface_along_normals = [] { return SC::accessibility_boundaries(landscape(2, 1, 2), ball); };
const auto surface_along_direction = [] {
  return SC::accessibility_boundaries(landscape(2, 1, 2), ball, {.direction = Vector(0, 0, 1)});
};
const auto swept_sphere = [] {
  const SC::Bspline_curve_3<K> path(3, {0, 0, 0, 0, 1, 1, 1, 1}, {{-4, -2, 0}, {-1, 4, 1}, {1, -5, 2}, {4, 2, 0}});
  return SC::sweep_silhouettes(SC::sphere_surface<K>(Point(0, 0, 0), 1), {path, {}}, {Point(1, -2, 9)}).front();
};

// (v (u^2 + v^2 - 1), u, v^2) over [-3/2,3/2]^2.
Surface pocket()
{
  const double w = 1.5, squares[] = {w * w, -w * w, w * w}, v[] = {-w, -w / 3, w / 3, w},
               v_squares[] = {w * w, -w * w / 3, -w * w / 3, w * w},
               v_cubes[] = {-w * w * w, w * w * w, -w * w * w, w * w * w};
  std::vector<Point> points;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(v_cubes[j] + (squares[i] - 1) * v[j], (i - 1) * w, v_squares[j]);
  return Surface({2, 3}, {-w, -w, -w, w, w, w}, {-w, -w, -w, -w, w, w, w, w}, points);
}

// A profile with a loop goes around an axis.
Surface turned_loop()
{
  const SC::Bspline_curve_3<K> profile(
      3, {-1.5, -1.5, -1.5, -1.5, 1.5, 1.5, 1.5, 1.5},
      {Point(3.25, 0, -1.875), Point(0.25, 0, 3.875), Point(0.25, 0, -3.875), Point(3.25, 0, 1.875)});
  return SC::surface_of_revolution<K>(profile, Point(0, 0, 0), Vector(0, 0, 1));
}

const auto pocket_with_itself = [] { return SC::self_intersection_curves(pocket()); };
const auto pocket_of_four_pieces_with_itself = [] {
  return SC::self_intersection_curves(pocket().with_knot(0, 0.25).with_knot(1, 0.5));
};
const auto turned_loop_with_itself = [] { return SC::self_intersection_curves(turned_loop()); };
const auto torus_with_itself = [] { return SC::self_intersection_curves(torus); };

const auto torus_on_plane = [] { return SC::intersection_curves(torus, K::Plane_3(0, 0, 1, -1)); };
const auto ball_in_tube = [] {
  return SC::intersection_curves(SC::cylinder_surface<K>(Point(0, 0, -3), Vector(0, 0, 6), Point(1, 0, -3)),
                                 SC::sphere_surface<K>(Point(0, 0, 0.25), 1));
};
const auto torus_on_board = [] {
  return SC::intersection_curves(
      torus, SC::bilinear_surface<K>(Point(-5, -1, 1), Point(-5, 5, 1), Point(6, -1, 1), Point(6, 5, 1)));
};

// x^2 + y^2 = 1 with a sphere, and x^2 + y^2 = 4 with a torus; turned by rational cosines.
auto implicit_contact(bool with_torus, bool is_turned)
{
  auto [x, y, z] = SC::unknowns({-5, 5.125}, {-5, 5.25}, {-5, 5.5});
  const SC::Expression u = is_turned ? (5 * x + 12 * y) / 13 : SC::Expression(x),
                       v = is_turned ? (5 * y - 12 * x) / 13 : SC::Expression(y),
                       w = is_turned ? (4 * z - 3 * v) / 5 : SC::Expression(z);
  const SC::Expression square_of_distance = u * u + (is_turned ? square((4 * v + 3 * z) / 5) : v * v),
                       all = square_of_distance + w * w;
  return with_torus
      ? SC::intersection_curves(SC::Implicit_surface_3(square(all + 8) == 36 * square_of_distance),
                                SC::Implicit_surface_3(square_of_distance == 4))
      : SC::intersection_curves(SC::Implicit_surface_3(all == 1), SC::Implicit_surface_3(square_of_distance == 1));
}

const auto implicit_ball_in_tube = [] { return implicit_contact(false, false); };
const auto turned_implicit_ball_in_tube = [] { return implicit_contact(false, true); };
const auto implicit_torus_around_tube = [] { return implicit_contact(true, false); };
const auto turned_implicit_torus_around_tube = [] { return implicit_contact(true, true); };

} // namespace

BENCHMARK_CAPTURE(curves, torus_silhouettes, torus_silhouettes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, torus_seen_from_near, torus_seen_from_near)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, bicubic_silhouettes, bicubic_silhouettes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, many_pieces_silhouettes, many_pieces_silhouettes)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, bicubic_parabolic_lines, bicubic_parabolic_lines)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, many_pieces_parabolic_lines, many_pieces_parabolic_lines)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, many_pieces_section, many_pieces_section)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, sphere_along_normals, sphere_along_normals)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, surface_along_normals, surface_along_normals)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, surface_along_direction, surface_along_direction)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, swept_sphere, swept_sphere)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, pocket_with_itself, pocket_with_itself)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, pocket_of_four_pieces_with_itself, pocket_of_four_pieces_with_itself)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, turned_loop_with_itself, turned_loop_with_itself)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, torus_with_itself, torus_with_itself)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, torus_on_plane, torus_on_plane)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, ball_in_tube, ball_in_tube)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, torus_on_board, torus_on_board)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, implicit_ball_in_tube, implicit_ball_in_tube)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, turned_implicit_ball_in_tube, turned_implicit_ball_in_tube)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, implicit_torus_around_tube, implicit_torus_around_tube)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(curves, turned_implicit_torus_around_tube, turned_implicit_torus_around_tube)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(umbilics_of_landscape)->ArgName("pieces")->Arg(1)->Arg(3)->Unit(benchmark::kMillisecond);
