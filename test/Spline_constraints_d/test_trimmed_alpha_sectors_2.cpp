// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed alpha-sectors: of points, segments and circles in closed form; of cubics, no point of either is nearer than the samples tell, and the chains go around what is nearer to one of them.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/trimmed_alpha_sectors_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace trimmed_alpha_sectors {

using Sector = SC::Trimmed_alpha_sector_2<K>;
using Samples = std::vector<Sector::Sample>;

Samples samples(const Sector& sector, double error = 0.01)
{
  Samples result;
  for (std::size_t i = 0; i < sector.arcs().size(); ++i)
    for (const auto& sample : sector.polyline(i, error))
      result.push_back(sample);
  return result;
}

// All points of one chain, which is closed.
std::vector<P> points(const Sector& sector, const Sector::Chain& chain, double error = 0.01)
{
  EXPECT_TRUE(chain.is_closed);
  std::vector<P> result;
  for (const std::size_t i : chain.arcs)
    for (const auto& sample : sector.polyline(i, error))
      result.push_back(sample.point);
  return result;
}

// How often polygons go around a point, counterclockwise.
int winding_number(const std::vector<std::vector<P>>& polygons, const P& p)
{
  double angle = 0;
  for (const std::vector<P>& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const K::Vector_2 a = polygon[i] - p, b = polygon[(i + 1) % polygon.size()] - p;
      angle += std::atan2(CGAL::determinant(a, b), a * b);
    }
  return static_cast<int>(std::lround(angle / (2 * CGAL_PI)));
}

std::vector<std::vector<P>> polygons(const Sector& sector, double error = 0.01)
{
  std::vector<std::vector<P>> result;
  for (const Sector::Chain& chain : sector.chains())
    result.push_back(points(sector, chain, error));
  return result;
}

Curve circle(const P& center, double radius) { return SC::ellipse_curve(center, K::Vector_2(radius, 0), K::Vector_2(0, radius)); }

// The circle of Apollonius 3 |P - a| = |P - b|, with the first point on its right.
TEST(TrimmedAlphaSectors, TwoPoints)
{
  const P a(0, 0), b(4, 0);
  const Sector near_a = SC::trimmed_alpha_sector(a, b, 0.25), near_b = SC::trimmed_alpha_sector(a, b, 0.75);
  for (const Sector* sector : {&near_a, &near_b}) {
    EXPECT_TRUE(sector->is_complete());
    EXPECT_EQ(sector->chains().size(), 1U);
    EXPECT_EQ(sector->arcs().size(), 1U);
    const double center = sector == &near_a ? -0.5 : 4.5;
    EXPECT_GT(samples(*sector).size(), 10U);
    for (const auto& sample : samples(*sector)) {
      EXPECT_NEAR(distance(sample.point, P(center, 0)), 1.5, 1e-12);
      EXPECT_NEAR(sample.distances[0], distance(sample.point, a), 1e-12);
      EXPECT_NEAR(sample.distances[1], distance(sample.point, b), 1e-12);
    }
  }
  EXPECT_EQ(winding_number(polygons(near_a), a), -1);
  EXPECT_EQ(winding_number(polygons(near_b), b), 1);
}

// y = 0 and y = 2, both for -1 <= x <= 1: where both are nearest inside, y = 1/2 and y = -1; else circles of Apollonius, as both corners are on one vertical line.
TEST(TrimmedAlphaSectors, ParallelSegments)
{
  const Sector sector = SC::trimmed_alpha_sector(bezier({P(-1, 0), P(1, 0)}), bezier({P(-1, 2), P(1, 2)}), 0.25);
  EXPECT_TRUE(sector.is_complete());
  EXPECT_EQ(sector.chains().size(), 1U);
  EXPECT_EQ(sector.arcs().size(), 4U);
  std::size_t inner = 0;
  for (const auto& sample : samples(sector)) {
    const double x = std::abs(sample.point.x()), y = sample.point.y();
    if (x < 1) {
      ++inner;
      EXPECT_NEAR((y - 0.5) * (y + 1), 0, 1e-12);
      EXPECT_NEAR(sample.parameters[0], (1 + sample.point.x()) / 2, 1e-9);
      EXPECT_NEAR(sample.parameters[1], (1 + sample.point.x()) / 2, 1e-9);
    } else
      EXPECT_NEAR(std::hypot(x - 1, y + 0.25), 0.75, 1e-9);
  }
  EXPECT_GT(inner, 4U);
}

// Three times as far from the line y = 0 as from (0,3): an ellipse of eccentricity 1/3. The other way round: a hyperbola, and circles around the ends.
TEST(TrimmedAlphaSectors, SegmentAndPoint)
{
  const Curve segment = bezier({P(-4, 0), P(4, 0)});
  const P focus(0, 3);
  const Sector ellipse = SC::trimmed_alpha_sector(focus, segment, 0.25), around = SC::trimmed_alpha_sector(segment, focus, 0.25);
  EXPECT_TRUE(ellipse.is_complete());
  EXPECT_TRUE(around.is_complete());
  EXPECT_EQ(ellipse.chains().size(), 1U);
  EXPECT_EQ(around.chains().size(), 1U);
  EXPECT_GT(samples(ellipse).size(), 10U);
  for (const auto& sample : samples(ellipse)) {
    const double x = sample.point.x(), y = sample.point.y();
    EXPECT_NEAR(9 * (x * x + (y - 3) * (y - 3)), y * y, 1e-10);
    EXPECT_TRUE(std::isnan(sample.parameters[0]));
    EXPECT_NEAR(sample.parameters[1], (x + 4) / 8, 1e-9);
  }
  EXPECT_EQ(winding_number(polygons(ellipse), focus), -1);
  EXPECT_EQ(winding_number(polygons(around), P(2, 0)), -1);
  std::size_t inner = 0;
  for (const auto& sample : samples(around)) {
    const double x = sample.point.x(), y = sample.point.y(), outside = (std::max)(0.0, std::abs(x) - 4);
    EXPECT_NEAR(9 * (y * y + outside * outside), x * x + (y - 3) * (y - 3), 1e-9);
    inner += outside == 0;
  }
  EXPECT_GT(inner, 10U);
}

// Cartesian ovals: outside of the large circle and inside.
TEST(TrimmedAlphaSectors, Circles)
{
  const P c(0, 0), d(4.25, 5.5);
  const Sector sector = SC::trimmed_alpha_sector(circle(c, 4), circle(d, 1), 0.25);
  EXPECT_TRUE(sector.is_complete());
  EXPECT_EQ(sector.chains().size(), 2U);
  std::size_t outside = 0, inside = 0;
  for (const auto& sample : samples(sector)) {
    const double r = distance(sample.point, c), s = distance(sample.point, d);
    EXPECT_NEAR(3 * std::abs(r - 4), s - 1, 1e-9);
    ++(r > 4 ? outside : inside);
  }
  EXPECT_GT(outside, 10U);
  EXPECT_GT(inside, 10U);
}

// At the corners of a square the sector with its center goes over from one side to another one: of the side from above and below, hyperbolas or ellipses. Three contacts or more at once are decided exactly.
TEST(TrimmedAlphaSectors, SquareAndItsCenter)
{
  const Curve square = SC::polyline_curve(std::vector<P>{P(-2, -2), P(2, -2), P(2, 2), P(-2, 2), P(-2, -2)});
  for (const double alpha : {0.25, 0.75}) {
    const Sector sector = SC::trimmed_alpha_sector(square, P(0, 0), alpha);
    EXPECT_TRUE(sector.is_complete());
    EXPECT_EQ(sector.chains().size(), alpha < 0.5 ? 2U : 1U);
    for (const auto& sample : samples(sector)) {
      const double x = std::abs(sample.point.x()), y = std::abs(sample.point.y()), far = (std::max)(x, y);
      const double from_square = far <= 2 ? 2 - far : std::hypot((std::max)(x - 2, 0.0), (std::max)(y - 2, 0.0));
      EXPECT_NEAR((1 - alpha) * from_square, alpha * std::hypot(x, y), 1e-9);
    }
  }
}

// Samples are proved to be at their distances from both curves; the chains go around the points that are nearer to one of them, and no others. A rigid motion and the exchange of both change nothing.
TEST(TrimmedAlphaSectors, RandomCubics)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<int> coordinate(0, 16);
  const K::Aff_transformation_2 motion(0.6, -0.8, 2, 0.8, 0.6, -1);
  std::size_t inside = 0, outside = 0;
  for (int run = 0; run < 3; ++run) {
    std::vector<Curve> curves;
    std::vector<P> all[2];
    for (const int shift : {0, 18}) {
      std::vector<P> control_points;
      for (int i = 0; i < 4; ++i)
        control_points.emplace_back(coordinate(random), coordinate(random) + shift);
      curves.push_back(bezier(control_points));
      for (int i = 0; i <= 400; ++i)
        all[shift > 0].push_back(curves.back()(i / 400.0));
    }
    const double alpha = (3 + 3 * run) / 16.0;
    const Sector sector = SC::trimmed_alpha_sector(curves[0], curves[1], alpha), exchanged = SC::trimmed_alpha_sector(curves[1], curves[0], 1 - alpha);
    EXPECT_TRUE(sector.is_complete());
    EXPECT_EQ(sector.chains().size(), exchanged.chains().size());
    EXPECT_EQ(sector.arcs().size(), exchanged.arcs().size());
    if (run == 0) {
      const Sector moved = SC::trimmed_alpha_sector(curves[0].transformed(motion), curves[1].transformed(motion), alpha);
      EXPECT_TRUE(moved.is_complete());
      EXPECT_EQ(moved.chains().size(), sector.chains().size());
      EXPECT_EQ(moved.arcs().size(), sector.arcs().size());
    }
    const Samples places = samples(sector);
    EXPECT_GT(places.size(), 20U);
    for (std::size_t i = 0; i < places.size(); i += 1 + places.size() / 4)
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(SC::distance_range(places[i].point, curves[k]).first, places[i].distances[k], 1e-8);
        if (!std::isnan(places[i].parameters[k])) {
          EXPECT_NEAR(distance(curves[k](places[i].parameters[k]), places[i].point), places[i].distances[k], 1e-8);
        }
      }
    const auto boundary = polygons(sector), other_boundary = polygons(exchanged);
    for (int i = 0; i < 100; ++i) {
      const P p(coordinate(random) * 1.5 - 4, coordinate(random) * 1.75);
      double least[2];
      for (std::size_t k = 0; k < 2; ++k)
        least[k] = distance(p, *std::min_element(all[k].begin(), all[k].end(), [&](const P& q, const P& r) { return distance(p, q) < distance(p, r); }));
      const double difference = (1 - alpha) * least[0] - alpha * least[1];
      if (std::abs(difference) < 0.1)
        continue;
      const bool is_inside = (difference < 0) == (alpha < 0.5);
      const int turns = !is_inside ? 0 : alpha < 0.5 ? -1 : 1;
      EXPECT_EQ(winding_number(boundary, p), turns);
      EXPECT_EQ(winding_number(other_boundary, p), -turns);
      ++(is_inside ? inside : outside);
    }
  }
  EXPECT_GT(inside, 50U);
  EXPECT_GT(outside, 50U);
}

TEST(TrimmedAlphaSectors, CurvesThatMeetAndBadInput)
{
  const Curve segment = bezier({P(-1, 0), P(1, 0)});
  for (const Sector& sector : {SC::trimmed_alpha_sector(segment, bezier({P(0, -1), P(0, 1)}), 0.25), SC::trimmed_alpha_sector(segment, P(0.5, 0), 0.25)}) {
    EXPECT_FALSE(sector.is_complete());
    EXPECT_TRUE(sector.chains().empty());
  }
  for (const double alpha : {-1.0, 0.0, 0.5, 1.0, 2.0})
    EXPECT_THROW(SC::trimmed_alpha_sector(segment, P(0, 1), alpha), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_alpha_sector(segment, bezier({P(1, 1), P(1, 1)}), 0.25), SC::Invalid_input);
  const Sector sector = SC::trimmed_alpha_sector(P(0, 0), P(1, 0), 0.25);
  ASSERT_EQ(sector.arcs().size(), 1U);
  EXPECT_THROW(sector.polyline(0, 0), SC::Invalid_input);
}

} // namespace trimmed_alpha_sectors
