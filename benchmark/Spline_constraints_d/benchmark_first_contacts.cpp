// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// First contacts of regions and of solids that miss or hit each other by a given gap, beside conservative advancement
// in doubles: it goes on by the distance divided by a bound of the speed, until the distance is less than 1e-10. `meet`
// is 1 for a contact, 0 for none; `time_error` that of the time, of contacts that exist; `steps` those of the
// advancement. The distances that it needs have closed forms here, which are the same in the plane and in space.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/first_contacts_2.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/first_contacts_3.h>
#include <CGAL/Spline_constraints_d/operations/regions/planar_regions_2.h>

#include <CGAL/Simple_cartesian.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace SC = CGAL::Spline_constraints;
using Number = SC::Exact_rational;
using K = CGAL::Simple_cartesian<Number>;
using Point = K::Point_2;
using Region = SC::Planar_region_2<K>;
using Motion = SC::Rational_motion_2;
using Surface = SC::Bspline_surface_3<K>;
using Solid = std::vector<Surface>;
using Motion_3 = SC::Rational_motion_3;

namespace {

struct Advancement
{
  std::optional<double> time;
  std::size_t steps = 0;
};

template <class Distance>
Advancement advance(const Distance& distance, double speed)
{
  constexpr double tolerance = 1e-10;
  Advancement result;
  for (double t = 0; t <= 1; ++result.steps) {
    const double d = distance(t);
    if (d < tolerance) {
      result.time = t;
      break;
    }
    t += d / speed;
  }
  return result;
}

Region rectangle(const Number& x0, const Number& y0, const Number& x1, const Number& y1)
{
  const std::vector<Point> corners{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}, {x0, y0}};
  return SC::planar_region(SC::polyline_curve(corners));
}

// Two regions or solids, and what advancement needs of them.
template <class Operand, class Motion_of_operand>
struct Scene
{
  Operand moving;
  Motion_of_operand motion;
  Operand fixed;
  double (*distance)(double time, double gap);
  double speed;
  double (*time)(double depth); // of the contact where the gap is negative
};
using Scene_2 = Scene<Region, Motion>;
using Scene_3 = Scene<Solid, Motion_3>;

double distance_of_discs(double t, double g) { return std::hypot(11 * t - 5, 2 + g) - 2; }
double time_of_discs(double depth) { return (5 - std::sqrt(4 * depth - depth * depth)) / 11; }

// Discs of radius 1, one of which passes the other one on a line.
Scene_2 discs(double gap)
{
  const K::Vector_2 way(Number(3) / 5, Number(4) / 5), side(Number(-4) / 5, Number(3) / 5);
  const Point middle = CGAL::ORIGIN + side * Number(2 + Number(gap));
  const Region disc = SC::planar_region(SC::circle_curve<K>(Point(0, 0), Number(1)));
  return {disc, Motion::along(SC::segment_curve<K>(middle - way * Number(5), middle + way * Number(6))),
          disc, distance_of_discs,
          11.0, time_of_discs};
}

// Balls in the same way, in a plane apart from their seams.
Scene_3 balls(double gap)
{
  const K::Vector_3 way(Number(2) / 7, Number(3) / 7, Number(6) / 7),
      side(Number(3) / 7, Number(-6) / 7, Number(2) / 7);
  const K::Point_3 middle = CGAL::ORIGIN + side * Number(2 + Number(gap)), origin(0, 0, 0);
  const Solid ball{SC::sphere_surface<K>(origin, Number(1))};
  const SC::Bspline_curve_3<K> path(1, {0, 0, 1, 1}, {middle - way * Number(5), middle + way * Number(6)});
  return {ball, Motion_3::along(path), ball, distance_of_discs, 11.0, time_of_discs};
}

// A rectangle of 4 x 3 that turns by a quarter beside a wall at x = 5/2: a corner is nearest to it at the time 1/3.
double distance_of_corner(double t, double g)
{
  const double c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
  return 2.5 + g - std::max(2 * c + 1.5 * s, -2 * c + 1.5 * s);
}

// The corner is at the angle 2 arctan(t) - arctan(3/4) from the normal of the wall.
double time_of_corner(double depth)
{
  return std::tan((std::atan2(3.0, 4.0) - 2 * std::asin(std::sqrt(depth / 5))) / 2);
}

Scene_2 corner_at_wall(double gap)
{
  const Motion::Function one({0}, {{0, 1}}, {1}), time({1}, {{0, 0, 1, 1}}, {0, 1});
  return {rectangle(-2, Number(-3) / 2, 2, Number(3) / 2),
          Motion::rotation(Point(0, 0), one, time),
          rectangle(Number(5) / 2 + Number(gap), -5, 4, 5),
          distance_of_corner,
          5.0,
          time_of_corner};
}

// The six faces.
Solid cuboid(const K::Point_3& low, const K::Point_3& high)
{
  Solid result;
  for (int axis = 0; axis < 3; ++axis)
    for (const int end : {0, 1}) {
      const int u = (axis + (end == 1 ? 1 : 2)) % 3;
      std::vector<K::Point_3> points;
      for (const int i : {0, 1})
        for (const int j : {0, 1}) {
          const auto coordinate = [&](int k) { return (k == axis ? end : k == u ? i : j) == 1 ? high[k] : low[k]; };
          points.emplace_back(coordinate(0), coordinate(1), coordinate(2));
        }
      result.push_back(Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, points));
    }
  return result;
}

// A cuboid over the rectangle.
Scene_3 cuboid_at_wall(double gap)
{
  const Motion_3::Function one({0}, {{0, 1}}, {1}), time({1}, {{0, 0, 1, 1}}, {0, 1});
  return {cuboid({-2, Number(-3) / 2, -1}, {2, Number(3) / 2, 1}),
          Motion_3::rotation(K::Point_3(0, 0, 0), K::Vector_3(0, 0, 1), one, time),
          cuboid({Number(5) / 2 + Number(gap), -5, -5}, {4, 5, 5}),
          distance_of_corner,
          5.0,
          time_of_corner};
}

double gap_of(const benchmark::State& state)
{
  return static_cast<double>(state.range(1)) * std::pow(10.0, -static_cast<double>(state.range(0)));
}

template <class Scene>
void certified(benchmark::State& state, Scene (*make)(double))
{
  const double gap = gap_of(state);
  const Scene scene = make(gap);
  std::optional<decltype(SC::first_contact(scene.moving, scene.motion, scene.fixed))> contact;
  for (auto _ : state)
    contact = SC::first_contact(scene.moving, scene.motion, scene.fixed);
  state.counters["meet"] = CGAL::certainly(contact->do_meet());
  state.counters["complete"] = contact->is_complete();
  if (gap < 0)
    state.counters["time_error"] = std::abs(CGAL::to_double(contact->time_range()->first) - scene.time(-gap));
}

template <class Scene>
void advancement(benchmark::State& state, Scene (*make)(double))
{
  const double gap = gap_of(state);
  const Scene scene = make(gap);
  Advancement result;
  for (auto _ : state)
    benchmark::DoNotOptimize(result = advance([&](double t) { return scene.distance(t, gap); }, scene.speed));
  state.counters["meet"] = result.time.has_value();
  state.counters["steps"] = static_cast<double>(result.steps);
  if (gap < 0 && result.time)
    state.counters["time_error"] = std::abs(*result.time - scene.time(-gap));
}

// The number of digits, and the sign of the gap.
void gaps(benchmark::internal::Benchmark* run)
{
  for (const int sign : {1, -1})
    for (const int digits : {3, 6, 9, 12})
      run->Args({digits, sign});
  run->Unit(benchmark::kMillisecond);
}

} // namespace

BENCHMARK_CAPTURE(certified, discs, discs)->Apply(gaps);
BENCHMARK_CAPTURE(advancement, discs, discs)->Apply(gaps);
BENCHMARK_CAPTURE(certified, corner_at_wall, corner_at_wall)->Apply(gaps);
BENCHMARK_CAPTURE(advancement, corner_at_wall, corner_at_wall)->Apply(gaps);
BENCHMARK_CAPTURE(certified, balls, balls)->Apply(gaps);
BENCHMARK_CAPTURE(certified, cuboid_at_wall, cuboid_at_wall)->Apply(gaps);
