// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Events of silhouettes of sweeps while the eye moves: the numbers of curves before and after them on random input,
// none on a tube seen from outside, a birth on it by formula.

#include "surface_test_names.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/sweep_silhouette_events.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <vector>

namespace sweep_silhouette_events_test {

using Curve = SC::Bspline_curve_3<K>;
using Events = SC::Silhouette_events_3<K>;
using Event = Events::Event;
using Kind = SC::Silhouette_event_kind;

namespace {

Curve bezier(const std::vector<Point>& points)
{
  std::vector<Rational> knots(points.size(), 0);
  knots.insert(knots.end(), points.size(), 1);
  return Curve(static_cast<int>(points.size()) - 1, knots, points);
}

// The numbers of curves at all times, if all is proved.
std::vector<std::array<int, 2>> counts(const Surface& surface, const SC::Affine_motion<K>& motion, const Curve& path,
                                       const std::vector<Rational>& times)
{
  std::vector<Point> eyes;
  for (const Rational& time : times)
    eyes.push_back(path(time));
  std::vector<std::array<int, 2>> result;
  for (const auto& set : SC::sweep_silhouettes(surface, motion, eyes)) {
    EXPECT_TRUE(set.is_complete());
    EXPECT_TRUE(set.singular_points().empty());
    result.push_back({static_cast<int>(set.number_of_closed_curves()), static_cast<int>(set.number_of_open_curves())});
  }
  return result;
}

int sum(const std::array<int, 2>& count) { return count[0] + count[1]; }

} // namespace

TEST(Sweep_silhouette_events, random_sweeps)
{
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> offset(-20, 20);
  std::array<int, 5> of_kind{};
  for (int round = 0; round < 8; ++round) {
    std::vector<Point> points;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        points.emplace_back(i - 1 + Rational(offset(generator), 80), j - 1 + Rational(offset(generator), 80),
                            Rational(offset(generator), 12));
    const std::vector<Rational> knots{0, 0, 0, 1, 1, 1};
    const Surface surface({2, 2}, knots, knots, points);
    const auto near = [&](int x, int y, int z, int n) {
      return Point(x + Rational(offset(generator), n), y + Rational(offset(generator), n),
                   z + Rational(offset(generator), n));
    };
    SC::Affine_motion<K> motion{bezier({near(-2, 0, 0, 20), near(0, 2, 1, 20), near(2, 0, 0, 20)}), {}};
    if (round % 2 == 1)
      motion.axes = {bezier({Point(1, 0, 0), near(1, 0, 0, 50)}), bezier({Point(0, 1, 0), near(0, 1, 0, 50)}),
                     bezier({Point(0, 0, 1), near(0, 0, 1, 50)})};
    const Curve path = bezier({near(10, 1, 3, 4), near(-4, -9, 5, 4)});
    const Events found = SC::sweep_silhouette_events(surface, motion, path);
    ASSERT_TRUE(found.is_complete()) << round;
    const std::vector<Rational> times = found.times_between();
    const std::vector<std::array<int, 2>> seen = counts(surface, motion, path, times);
    std::size_t next = 0;
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
      std::array<int, 5> between{};
      for (; next < found.events().size() && found.events()[next].time.first < times[i + 1]; ++next)
        ++between[static_cast<std::size_t>(found.events()[next].kind)];
      for (std::size_t k = 0; k < 5; ++k)
        of_kind[k] += between[k];
      const auto number = [&](Kind kind) { return between[static_cast<std::size_t>(kind)]; };
      EXPECT_EQ(number(Kind::DEGENERATE), 0) << round;
      EXPECT_LE(std::abs(sum(seen[i + 1]) - sum(seen[i]) - number(Kind::BIRTH) + number(Kind::DEATH)),
                number(Kind::RECONNECTION))
          << round;
      if (number(Kind::RECONNECTION) + number(Kind::BIRTH) + number(Kind::DEATH) == 0) {
        EXPECT_EQ(seen[i + 1], seen[i]) << round;
      }
    }
    std::vector<Rational> others; // a second time in each interval
    for (std::size_t i = 0; i < times.size(); ++i) {
      Rational begin(0), end(1);
      for (const Event& event : found.events())
        (event.time.second < times[i] ? begin : end) =
            event.time.second < times[i] ? (std::max)(begin, event.time.second) : (std::min)(end, event.time.first);
      others.push_back(
          SC::simplest_rational_between(Rational((9 * begin + end) / 10), Rational((8 * begin + end) / 9)));
    }
    EXPECT_EQ(counts(surface, motion, path, others), seen) << round;
  }
  for (const Kind kind : {Kind::BIRTH, Kind::DEATH, Kind::RECONNECTION, Kind::PASSAGE})
    EXPECT_GT(of_kind[static_cast<std::size_t>(kind)], 0) << kind;
}

// A sphere along a parabola: no event as the eye passes the tube at a distance, in spite of poles; on the way out of
// it, where it is curved like an egg, a curve is born as the eye passes the tube.
TEST(Sweep_silhouette_events, tube)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), Point(Rational(2, 7), Rational(3, 7), Rational(6, 7)));
  const SC::Affine_motion<K> motion{bezier({Point(-4, 0, 4), Point(0, 0, -4), Point(4, 0, 4)}), {}};
  const Events outside = SC::sweep_silhouette_events(sphere, motion, bezier({Point(3, -10, 2), Point(-2, -9, 5)}));
  EXPECT_TRUE(outside.is_complete());
  EXPECT_TRUE(outside.events().empty()) << outside;
  const Curve path = bezier({Point(0, 0, 0), Point(Rational(1, 5), Rational(1, 3), -3)});
  const Events out = SC::sweep_silhouette_events(sphere, motion, path);
  EXPECT_TRUE(out.is_complete());
  std::size_t births = 0;
  for (const Event& event : out.events())
    if (event.kind == Kind::BIRTH) {
      ++births;
      EXPECT_LT(length(event.point - path(event.time.first)), 1e-9);
      ASSERT_EQ(event.parameters.size(), 3u);
      EXPECT_NEAR(CGAL::to_double(event.parameters[2].first), 0.5, 0.1);
    }
  EXPECT_EQ(births, 1u) << out;
}

TEST(Sweep_silhouette_events, limits_and_bad_input)
{
  const Surface sphere = SC::sphere_surface<K>(Point(0, 0, 0), 1);
  const Curve path = bezier({Point(0, 0, 9), Point(1, 9, 0)});
  const SC::Affine_motion<K> motion{bezier({Point(-4, 0, 4), Point(0, 0, -4), Point(4, 0, 4)}), {}};
  const Events stopped = SC::sweep_silhouette_events(sphere, motion, path, {.node_limit = 1});
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_FALSE(stopped.undecided().empty());
  const Events still = SC::sweep_silhouette_events(sphere, {bezier({Point(0, 0, 0), Point(0, 0, 0)}), {}}, path);
  EXPECT_FALSE(still.is_complete());
  EXPECT_THROW(SC::sweep_silhouette_events(sphere, {path, {path}}, path), SC::Invalid_input);
}

} // namespace sweep_silhouette_events_test
