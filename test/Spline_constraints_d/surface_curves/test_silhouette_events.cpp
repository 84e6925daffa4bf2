// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Events of silhouettes while the eye moves: by formula on graphs and tori, none on ellipsoids, edges and corners; and
// the numbers of curves before and after those of random surfaces.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouette_events.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/silhouettes.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace silhouette_events_test {

using Function = SC::Bspline_function<Rational>;
using Path = SC::Bspline_curve_3<K>;
using Events = SC::Silhouette_events_3<K>;
using Event = Events::Event;
using Kind = SC::Silhouette_event_kind;

namespace {

// (x, y, f(x,y)) over [-1,1]^2.
Surface graph(const std::function<Function(const Function&, const Function&)>& f)
{
  const std::vector<Rational> knots{-1, -1, 1, 1};
  const Function x({1, 1}, {knots, knots}, {-1, -1, 1, 1}), y({1, 1}, {knots, knots}, {-1, 1, -1, 1});
  return Surface::from_homogeneous_coordinates({x, y, f(x, y)}, x * Rational(0) + Rational(1));
}

Path segment(const Point& from, const Point& to) { return Path(1, {0, 0, 1, 1}, {from, to}); }

// From the direction (1,0,-1) at the time -1 to (1,0,1) at the time 1.
Path nodding() { return Path(1, {-1, -1, 1, 1}, {Point(1, 0, -1), Point(1, 0, 1)}); }

bool holds(const Event::Range& range, const Rational& x) { return range.first <= x && x <= range.second; }

double width(const Event::Range& range) { return CGAL::to_double(Rational(range.second - range.first)); }

// Events of these kinds at these times.
void expect_events(const Events& found, const std::vector<std::pair<Kind, Rational>>& events)
{
  EXPECT_TRUE(found.is_complete());
  EXPECT_TRUE(found.undecided().empty());
  ASSERT_EQ(found.events().size(), events.size()) << found;
  for (std::size_t i = 0; i < events.size(); ++i) {
    EXPECT_EQ(found.events()[i].kind, events[i].first) << found;
    EXPECT_TRUE(holds(found.events()[i].time, events[i].second)) << found;
    EXPECT_LT(width(found.events()[i].time), 1e-9);
  }
}

std::pair<int, int> counts(const SC::Surface_curves_3<K>& curves)
{
  EXPECT_TRUE(curves.is_complete());
  EXPECT_TRUE(curves.singular_points().empty());
  return {static_cast<int>(curves.number_of_closed_curves()), static_cast<int>(curves.number_of_open_curves())};
}

} // namespace

// 3x^2 + y^2 = c, seen along (1,0,c).
TEST(Silhouette_events, closed_curve_is_born)
{
  const Surface surface = graph([](const Function& x, const Function& y) { return x * x * x + x * y * y; });
  const Events found = SC::parallel_silhouette_events(surface, nodding());
  // at c = 1 the ellipse touches the edges y = 1 and y = -1 in its tops
  ASSERT_FALSE(found.events().empty());
  const Event& birth = found.events().front();
  EXPECT_EQ(birth.kind, Kind::BIRTH);
  EXPECT_TRUE(holds(birth.time, 0) && holds(birth.parameters[0], 0) && holds(birth.parameters[1], 0));
  EXPECT_LT(length(birth.point - Point(0, 0, 0)), 1e-12);
  EXPECT_EQ(counts(SC::silhouettes(surface, Vector(1, 0, Rational(-1, 10)))), std::pair(0, 0));
  EXPECT_EQ(counts(SC::silhouettes(surface, Vector(1, 0, Rational(1, 10)))), std::pair(1, 0));
  // backwards, curves die
  const Events back =
      SC::parallel_silhouette_events(surface, Path(1, {-1, -1, 1, 1}, {Point(1, 0, 1), Point(1, 0, -1)}));
  ASSERT_FALSE(back.events().empty());
  EXPECT_EQ(back.events().back().kind, Kind::DEATH);
  EXPECT_TRUE(holds(back.events().back().time, 0));
}

// x^2 + y^2 = c, and beside it what happens at the edges: it touches them at c = 1, and ends in the corners at c = 2.
TEST(Silhouette_events, edges_and_corners)
{
  const Surface surface =
      graph([](const Function& x, const Function& y) { return x * x * x * Rational(1, 3) + x * y * y; });
  expect_events(SC::parallel_silhouette_events(surface, Path(1, {-1, -1, 3, 3}, {Point(1, 0, -1), Point(1, 0, 3)})),
                {{Kind::BIRTH, 0},
                 {Kind::RECONNECTION, 1},
                 {Kind::RECONNECTION, 1},
                 {Kind::RECONNECTION, 1},
                 {Kind::RECONNECTION, 1},
                 {Kind::DEATH, 2},
                 {Kind::DEATH, 2},
                 {Kind::DEATH, 2},
                 {Kind::DEATH, 2}});
  // 2x + 3y = c: born in one corner, dies in the opposite one, and its ends pass the two others
  const Surface bilinear = graph([](const Function& x, const Function& y) { return x * x + x * y * Rational(3); });
  expect_events(SC::parallel_silhouette_events(bilinear, Path(1, {-6, -6, 6, 6}, {Point(1, 0, -6), Point(1, 0, 6)})),
                {{Kind::BIRTH, -5}, {Kind::PASSAGE, -1}, {Kind::PASSAGE, 1}, {Kind::DEATH, 5}});
}

// 3x^2 - y^2 = c.
TEST(Silhouette_events, branches_reconnect)
{
  const Surface surface = graph([](const Function& x, const Function& y) { return x * x * x - x * y * y; });
  const Events found = SC::parallel_silhouette_events(
      surface, Path(1, {-1, -1, 1, 1}, {Point(1, 0, Rational(-1, 2)), Point(1, 0, Rational(1, 2))}));
  expect_events(found, {{Kind::RECONNECTION, 0}});
  EXPECT_EQ(found.times_between().size(), 2u);
  // with more breaks, some through the point: the same
  for (const Surface& refined : {surface.with_knot(0, 0), surface.with_knot(1, 0).with_knot(0, Rational(1, 3))})
    expect_events(SC::parallel_silhouette_events(
                      refined, Path(1, {-1, -1, 1, 1}, {Point(1, 0, Rational(-1, 2)), Point(1, 0, Rational(1, 2))})),
                  {{Kind::RECONNECTION, 0}});
}

TEST(Silhouette_events, torus)
{
  // The planes z = 1 and z = -1 touch the torus along circles. From the eye two lines touch each of them.
  const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1);
  expect_events(SC::silhouette_events(torus, segment(Point(10, 3, 2), Point(10, 3, -2))),
                {{Kind::RECONNECTION, Rational(1, 4)},
                 {Kind::RECONNECTION, Rational(1, 4)},
                 {Kind::RECONNECTION, Rational(3, 4)},
                 {Kind::RECONNECTION, Rational(3, 4)}});
  const Events parallel = SC::parallel_silhouette_events(torus, segment(Point(3, 1, 1), Point(3, 1, -1)));
  expect_events(parallel, std::vector<std::pair<Kind, Rational>>(4, {Kind::RECONNECTION, Rational(1, 2)}));
  for (const Event& event : parallel.events()) { // where the direction is tangent to one of both circles
    EXPECT_NEAR(CGAL::to_double(3 * event.point.x() + event.point.y()), 0, 1e-9);
    EXPECT_NEAR(std::abs(CGAL::to_double(event.point.z())), 1, 1e-9);
  }
  // in the hole and above it there is no asymptotic direction
  expect_events(SC::silhouette_events(torus, segment(Point(0, Rational(1, 3), 3), Point(1, 0, -3))), {});
  // through the tube: a curve is born or dies where the eye passes the surface
  const Events through = SC::silhouette_events(torus, segment(Point(2, 2, 0), Point(5, 5, Rational(1, 3))));
  EXPECT_TRUE(through.is_complete());
  ASSERT_FALSE(through.events().empty());
  EXPECT_EQ(through.events().back().kind, Kind::BIRTH);
}

// The eye passes the planes z = 1 and z = -1 at most once each, and there are two closed curves wherever it is outside.
TEST(Silhouette_events, torus_and_random_paths)
{
  std::mt19937 generator(11);
  std::uniform_int_distribution<int> tenths(-30, 30);
  const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1)
                            .transformed(K::Aff_transformation_3(Rational(3, 5), Rational(-4, 5), 0, 0, Rational(4, 5),
                                                                 Rational(3, 5), 0, 0, 0, 0, 1, 0));
  std::size_t number_of_events = 0;
  for (int round = 0; round < 10; ++round) {
    const auto eye = [&] {
      return Point(8 + Rational(tenths(generator), 10), tenths(generator), Rational(2 * tenths(generator) + 1, 20));
    };
    const Path path = segment(eye(), eye());
    const Events found = SC::silhouette_events(torus, path);
    ASSERT_TRUE(found.is_complete());
    const auto is_above = [&](const Rational& t, int z) { return path(t).z() > z; };
    std::size_t expected = 0;
    for (const int z : {1, -1})
      expected += is_above(0, z) != is_above(1, z) ? 2 : 0;
    EXPECT_EQ(found.events().size(), expected) << found;
    for (const Event& event : found.events())
      EXPECT_EQ(event.kind, Kind::RECONNECTION) << found;
    for (const Rational& time : found.times_between())
      EXPECT_EQ(counts(SC::silhouettes(torus, path(time))), std::pair(2, 0));
    number_of_events += found.events().size();
  }
  EXPECT_GT(number_of_events, 5u);
}

TEST(Silhouette_events, ellipsoids)
{
  const Surface ellipsoid =
      SC::sphere_surface<K>(Point(0, 0, 0), 1).transformed(K::Aff_transformation_3(3, 0, 0, 1, 0, 2, 0, 0, 0, 0, 1, 0));
  expect_events(SC::silhouette_events(ellipsoid, segment(Point(9, -5, 3), Point(7, 9, -2))), {});
  expect_events(SC::silhouette_events(ellipsoid, segment(Point(9, 0, 3), Point(9, 0, -2))), {}); // in symmetry
  expect_events(SC::parallel_silhouette_events(ellipsoid, segment(Point(1, 2, -3), Point(-2, 1, 4))), {});
  // from inside
  const Events left = SC::silhouette_events(ellipsoid, segment(Point(1, 0, 0), Point(7, 5, 2)));
  EXPECT_TRUE(left.is_complete());
  ASSERT_EQ(left.events().size(), 1u) << left;
  EXPECT_EQ(left.events()[0].kind, Kind::BIRTH);
  const double t = CGAL::to_double(left.events()[0].time.first); // (6t/3)^2 + (5t/2)^2 + (2t)^2 = 1
  EXPECT_NEAR(t * t * (4 + 6.25 + 4), 1, 1e-9);
}

// Between events nothing changes; one event alone changes the number of curves as its kind says.
TEST(Silhouette_events, random_surfaces)
{
  std::mt19937 generator(7);
  std::uniform_int_distribution<int> offset(-40, 40);
  std::array<int, 5> of_kind{};
  for (int round = 0; round < 12; ++round) {
    const bool has_creases = round % 6 == 5;
    const int degree = round % 3 == 2 ? 2 : 3, pieces = round % 3 == 2 ? 2 : 1,
              size = has_creases ? degree * pieces + 1 : degree + pieces;
    std::vector<Point> points;
    std::vector<Rational> knots(static_cast<std::size_t>(degree), 0);
    for (int i = 0; i < size; ++i)
      for (int j = 0; j < size; ++j)
        points.emplace_back(3 * i + Rational(offset(generator), 40), 3 * j + Rational(offset(generator), 40),
                            Rational(offset(generator), 8));
    for (int i = 0; i <= pieces; ++i)
      knots.insert(knots.end(), has_creases && 0 < i && i < pieces ? static_cast<std::size_t>(degree) : 1, i);
    knots.insert(knots.end(), static_cast<std::size_t>(degree), pieces);
    const Surface surface({degree, degree}, knots, knots, points);
    const auto eye = [&] { return Point(20 + offset(generator) / 4, offset(generator) / 3, offset(generator) / 4); };
    const Path path(2, {0, 0, 0, 1, 1, 1}, {eye(), eye(), eye()});
    const Events found = SC::silhouette_events(surface, path);
    ASSERT_TRUE(found.is_complete()) << round;
    const std::vector<Rational> times = found.times_between();
    std::vector<std::pair<int, int>> seen;
    for (const Rational& time : times)
      seen.push_back(counts(SC::silhouettes(surface, path(time))));
    std::size_t next = 0; // the first event after a time
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      std::vector<Kind> between;
      for (; next < found.events().size() && found.events()[next].time.first < times[i + 1]; ++next)
        between.push_back(found.events()[next].kind);
      ASSERT_EQ(between.size(), 1u) << round;
      const int more = seen[i + 1].first + seen[i + 1].second - seen[i].first - seen[i].second;
      ++of_kind[static_cast<std::size_t>(between[0])];
      switch (between[0]) {
      case Kind::BIRTH:
        EXPECT_EQ(more, 1) << round;
        break;
      case Kind::DEATH:
        EXPECT_EQ(more, -1) << round;
        break;
      case Kind::PASSAGE:
        EXPECT_EQ(seen[i + 1], seen[i]) << round;
        break;
      case Kind::RECONNECTION:
        EXPECT_LE(std::abs(more), 1) << round;
        break;
      case Kind::DEGENERATE:
        ADD_FAILURE() << round;
        break;
      }
    }
    // at random times as at those between the events
    for (int k = 0; k < 6; ++k) {
      const Rational time(offset(generator) + 41, 82);
      std::size_t interval = 0;
      while (interval + 1 < times.size() && found.events()[interval].time.second < time)
        ++interval;
      EXPECT_EQ(counts(SC::silhouettes(surface, path(time))), seen[interval]) << round << ' ' << time;
    }
  }
  for (const Kind kind : {Kind::BIRTH, Kind::DEATH, Kind::RECONNECTION, Kind::PASSAGE})
    EXPECT_GT(of_kind[static_cast<std::size_t>(kind)], 0) << kind;
}

TEST(Silhouette_events, limits_and_bad_input)
{
  const Surface torus = SC::torus_surface<K>(Point(0, 0, 0), 3, 1);
  const Events stopped = SC::silhouette_events(torus, segment(Point(10, 3, 2), Point(10, 3, -2)), {.node_limit = 1});
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_FALSE(stopped.undecided().empty());
  // a plane through which the eye passes
  const Surface plane = graph([](const Function& x, const Function& y) { return x + y; });
  EXPECT_FALSE(SC::silhouette_events(plane, segment(Point(0, 0, 2), Point(0, 0, -2))).is_complete());
  expect_events(SC::silhouette_events(plane, segment(Point(0, 0, 2), Point(0, 1, 3))), {});
  EXPECT_THROW(SC::silhouette_events(torus, segment(Point(10, 3, 2), Point(10, 3, -2)), {.tolerance = -1}),
               SC::Invalid_input);
}

} // namespace silhouette_events_test
