// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// First contacts of regions that miss or hit each other by a given gap, beside conservative advancement in doubles: it
// goes on by the distance divided by a bound of the speed, until the distance is less than 1e-10. `meet` is 1 for a
// contact, 0 for none; `time_error` that of the time, of contacts that exist; `steps` those of the advancement. The
// distances that it needs have closed forms here.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/first_contacts/first_contacts_2.h>
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

// Two regions, and what advancement needs of them.
struct Scene
{
  Region moving;
  Motion motion;
  Region fixed;
  double (*distance)(double time, double gap);
  double speed;
  double (*time)(double depth); // of the contact where the gap is negative
};

// Discs of radius 1, one of which passes the other one on a line.
Scene discs(double gap)
{
  const K::Vector_2 way(Number(3) / 5, Number(4) / 5), side(Number(-4) / 5, Number(3) / 5);
  const Point middle = CGAL::ORIGIN + side * Number(2 + Number(gap));
  const Region disc = SC::planar_region(SC::circle_curve<K>(Point(0, 0), Number(1)));
  return {disc, Motion::along(SC::segment_curve<K>(middle - way * Number(5), middle + way * Number(6))),
          disc, [](double t, double g) { return std::hypot(11 * t - 5, 2 + g) - 2; },
          11.0, [](double depth) { return (5 - std::sqrt(4 * depth - depth * depth)) / 11; }};
}

// A rectangle of 4 x 3 that turns by a quarter beside a wall: a corner is nearest to it at the time 1/3.
Scene corner_at_wall(double gap)
{
  const Motion::Function one({0}, {{0, 1}}, {1}), time({1}, {{0, 0, 1, 1}}, {0, 1});
  const auto distance = [](double t, double g) {
    const double c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    return 2.5 + g - std::max(2 * c + 1.5 * s, -2 * c + 1.5 * s);
  };
  // The corner is at the angle 2 arctan(t) - arctan(3/4) from the normal of the wall.
  const auto time_of_contact = [](double depth) {
    return std::tan((std::atan2(3.0, 4.0) - 2 * std::asin(std::sqrt(depth / 5))) / 2);
  };
  return {rectangle(-2, Number(-3) / 2, 2, Number(3) / 2),
          Motion::rotation(Point(0, 0), one, time),
          rectangle(Number(5) / 2 + Number(gap), -5, 4, 5),
          distance,
          5.0,
          time_of_contact};
}

double gap_of(const benchmark::State& state)
{
  return static_cast<double>(state.range(1)) * std::pow(10.0, -static_cast<double>(state.range(0)));
}

void certified(benchmark::State& state, Scene (*make)(double))
{
  const double gap = gap_of(state);
  const Scene scene = make(gap);
  std::optional<SC::First_contact_2> contact;
  for (auto _ : state)
    contact = SC::first_contact(scene.moving, scene.motion, scene.fixed);
  state.counters["meet"] = CGAL::certainly(contact->do_meet());
  state.counters["complete"] = contact->is_complete();
  if (gap < 0)
    state.counters["time_error"] = std::abs(CGAL::to_double(contact->time_range()->first) - scene.time(-gap));
}

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
