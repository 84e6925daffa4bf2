// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Many curves: all intersections of 1,000 cubic segments with 1,000 others, as in a drawing, of two splines with many
// pieces, of splines and polylines with themselves, and of curves that nearly coincide; curves of solutions;
// intersection curves of surfaces; bisectors, alpha-sectors and envelopes.

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersection_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/pairwise_intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/self_intersections.h>
#include <CGAL/Spline_constraints_d/operations/loci/alpha_sectors_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/envelope_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/loci/self_bisector_curves_2.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <random>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using K = CGAL::Simple_cartesian<double>;
using Exact_kernel = CGAL::Simple_cartesian<Exact_rational>;
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
    for (const auto& pair : result.pairs())
      points += pair.intersections.size();
  }
  state.counters["intersections"] = static_cast<double>(points);
}

void spline_with_spline(benchmark::State& state)
{
  std::mt19937 generator(1);
  const Curve first = random_spline(static_cast<int>(state.range(0)), generator),
              second = random_spline(static_cast<int>(state.range(0)), generator);
  std::size_t points = 0;
  for (auto _ : state)
    points = SC::intersections(first, second).size();
  state.counters["intersections"] = static_cast<double>(points);
}

// A Bezier curve and a part of it, with its second control point moved by a power of ten.
template <class Exact_curve>
void nearly_coincident_curves(benchmark::State& state, const Exact_curve& curve)
{
  const Exact_curve part = curve.restricted(Exact_rational(1, 4), Exact_rational(5, 8));
  std::vector<Exact_rational> shift(part.size(), Exact_rational(0));
  shift[1] = 1;
  for (int i = 0; i < state.range(0); ++i)
    shift[1] /= 10;
  auto moved = part.homogeneous_coordinates();
  moved[1] = moved[1] + SC::Bspline_function<Exact_rational>({part.degree()}, {part.knots()}, shift);
  const Exact_curve other = Exact_curve::from_homogeneous_coordinates(moved, part.weight());
  std::size_t nodes = 0, size = 0;
  for (auto _ : state) {
    const auto result = SC::intersections(curve, other);
    nodes = result.summary().nodes;
    size = result.is_complete() ? result.size() : 0;
  }
  state.counters["intersections"] = static_cast<double>(size);
  state.counters["nodes"] = static_cast<double>(nodes);
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
  count_self_intersections(state,
                           SC::polyline_curve(random_walk(static_cast<std::size_t>(state.range(0)) + 1, generator)));
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
  const std::vector<SC::Constraint> constraints{
      x * x + y * y + z * z == 4, square(x - SC::Exact_rational(static_cast<int>(state.range(0)), 2)) + y * y == 1};
  const SC::Constraint_system_d system = make_system(constraints);
  for (auto _ : state)
    benchmark::DoNotOptimize(SC::solve_curves(system));
}

using Surface = SC::Bspline_surface_3<K>;

// A bicubic Bézier surface over the grid of its control points: ten times the humps, and a rough one.
Surface bicubic_surface(double humps, double roughness, double height)
{
  constexpr double hump[] = {-1, 5, -5, 1},
                   rough[4][4] = {{1, 3, 9, -2}, {2, -1, -4, 8}, {-6, -9, 6, -7}, {4, -7, 4, 8}};
  std::vector<K::Point_3> points;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      points.emplace_back(i, j, humps * 10 * (hump[i] + hump[j]) + roughness * rough[i][j] + height);
  return Surface({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, points);
}

template <class A, class B>
void surface_intersection(benchmark::State& state, const A& a, const B& b)
{
  std::size_t curves = 0, points = 0;
  for (auto _ : state) {
    const auto set = SC::intersection_curves(a, b);
    curves = set.curves().size();
    points = 0;
    if (state.range(0) == 1)
      for (const SC::Intersection_curve& curve : set.curves())
        points += set.polyline(curve, 1e-3).size();
  }
  state.counters["curves"] = static_cast<double>(curves);
  state.counters["points"] = static_cast<double>(points);
}

const Curve lower_cubic = SC::bezier_curve(std::vector<K::Point_2>{{0, 0}, {1, 2}, {2, -2}, {3, 0}}),
            upper_cubic = SC::bezier_curve(std::vector<K::Point_2>{{0, 3}, {1, 5}, {2, 2}, {3, 4}});

template <class Operation>
void locus_of_two_cubics(benchmark::State& state, const Operation& operation)
{
  std::size_t curves = 0, nodes = 0, points = 0;
  for (auto _ : state) {
    const auto locus = operation(lower_cubic, upper_cubic);
    curves = locus.curves().size();
    nodes = locus.summary().nodes;
    points = 0;
    if (state.range(0) == 1)
      for (const auto& curve : locus.curves())
        points += locus.polyline(curve, 1e-3, 10).size();
  }
  state.counters["curves"] = static_cast<double>(curves);
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["points"] = static_cast<double>(points);
}

const auto bisector = [](const Curve& a, const Curve& b) { return SC::bisector_curves(a, b); };
const auto alpha_sector = [](const Curve& a, const Curve& b) { return SC::alpha_sectors(a, b, K::FT(1) / 4); };
const auto self_bisector = [](const Curve& a, const Curve&) { return SC::self_bisector_curves(a); };
const auto envelope = [](const Curve& a, const Curve& b) { return SC::envelope_curves(a, b); };

const Surface humps = bicubic_surface(1, 0, 0), rough_humps = bicubic_surface(1, 1, 0),
              rough_plane = bicubic_surface(0, 1, 19);
const K::Aff_transformation_3 turn(1, 0, 0, 0, 0, 0.6, -0.8, 0, 0, 0.8, 0.6, 0);

} // namespace

BENCHMARK(segments_with_segments)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(spline_with_spline)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
const std::vector<Exact_rational> knots_of_cubic{0, 0, 0, 0, 1, 1, 1, 1}, weights_of_cubic{1, 2, 1, 3};
const std::vector<Exact_kernel::Point_2> points_of_cubic{{48, 84}, {100, 187}, {130, 99}, {166, 37}};
BENCHMARK_CAPTURE(nearly_coincident_curves, quadratic,
                  SC::bezier_curve(std::vector<Exact_kernel::Point_2>{{48, 84}, {100, 187}, {166, 37}}))
    ->DenseRange(3, 15, 3)
    ->Arg(100)
    ->Arg(300)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(nearly_coincident_curves, conic,
                  SC::Bspline_curve_2<Exact_kernel>(2, {0, 0, 0, 1, 1, 1}, {{48, 84}, {100, 187}, {166, 37}},
                                                    {1, 2, 3}))
    ->DenseRange(3, 15, 3)
    ->Arg(100)
    ->Arg(300)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(nearly_coincident_curves, cubic, SC::bezier_curve(points_of_cubic))
    ->DenseRange(3, 15, 3)
    ->Arg(100)
    ->Arg(300)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(nearly_coincident_curves, rational_cubic,
                  SC::Bspline_curve_2<Exact_kernel>(3, knots_of_cubic, points_of_cubic, weights_of_cubic))
    ->DenseRange(3, 15, 3)
    ->Arg(100)
    ->Arg(300)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(nearly_coincident_curves, cubic_in_space,
                  SC::bezier_curve(std::vector<Exact_kernel::Point_3>{
                      {48, 84, 0}, {100, 187, 50}, {130, 99, 10}, {166, 37, 90}}))
    ->DenseRange(3, 15, 3)
    ->Arg(100)
    ->Arg(300)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(nodal_cubic_with_itself)->Unit(benchmark::kMillisecond);
BENCHMARK(spline_with_itself)->Arg(10)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(polyline_with_itself)->Arg(100)->Arg(1000)->Unit(benchmark::kMillisecond);
BENCHMARK(chebyshev_contours)->Arg(4)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(sphere_and_cylinder)->ArgName("2c")->Arg(1)->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(locus_of_two_cubics, bisector, bisector)
    ->ArgName("polylines")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(locus_of_two_cubics, alpha_sector, alpha_sector)
    ->ArgName("polylines")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(locus_of_two_cubics, self_bisector, self_bisector)
    ->ArgName("polylines")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(locus_of_two_cubics, envelope, envelope)
    ->ArgName("polylines")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(surface_intersection, bicubic_and_plane, humps, K::Plane_3(0, 0, 1, -19))
    ->ArgName("polylines")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(surface_intersection, height_fields, rough_humps, rough_plane)
    ->ArgName("polylines")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(surface_intersection, turned, rough_humps.transformed(turn), rough_plane.transformed(turn))
    ->ArgName("polylines")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(surface_intersection, torus_and_sphere, SC::torus_surface<K>(K::Point_3(0, 0, 0), 3, 1),
                  K::Sphere_3(K::Point_3(3, 0.25, 0.5), 3))
    ->ArgName("polylines")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond);
