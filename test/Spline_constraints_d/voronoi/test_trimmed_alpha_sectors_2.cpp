// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Trimmed alpha-sectors: of points, segments and circles in closed form; of cubics, no point of either is nearer than
// the samples tell, and the chains go around what is nearer to one of them.
#include "voronoi_checks.h"

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/trimmed_alpha_sectors_2.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

using Sites = std::array<std::vector<P>, 2>;   // points along both operands

std::vector<P> points_along(const Curve& curve)
{
  std::vector<P> result;
  const auto [first, last] = curve.domain();
  for (int i = 0; i <= 400; ++i)
    result.push_back(curve(first + i / 400.0 * (last - first)));
  return result;
}

// The chains go around the points that are nearer to one of the operands, and no others. Returns the numbers of points
// that are inside, and outside.
std::array<std::size_t, 2> check_sides(const Sector& sector, double alpha, const Sites& sites,
                                       const std::vector<P>& places)
{
  const auto distance_from = [](const P& p, const std::vector<P>& points) {
    return distance(p, *std::min_element(points.begin(), points.end(), [&](const P& q, const P& r) {
                      return distance(p, q) < distance(p, r);
                    }));
  };
  const auto chains = polygons(sector);
  std::array<std::size_t, 2> result{};
  for (const P& p : places) {
    const double difference = (1 - alpha) * distance_from(p, sites[0]) - alpha * distance_from(p, sites[1]);
    if (std::abs(difference) < 0.1)
      continue;
    const bool is_inside = (difference < 0) == (alpha < 0.5);
    EXPECT_EQ(winding_number(chains, p), !is_inside ? 0 : alpha < 0.5 ? -1 : 1);
    ++result[is_inside ? 0 : 1];
  }
  return result;
}

Curve circle(const P& center, double radius)
{
  return SC::ellipse_curve(center, K::Vector_2(radius, 0), K::Vector_2(0, radius));
}

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

// y = 0 and y = 2, both for -1 <= x <= 1: where both are nearest inside, y = 1/2 and y = -1; else circles of
// Apollonius, as both corners are on one vertical line.
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
      EXPECT_NEAR(*sample.parameters[0], (1 + sample.point.x()) / 2, 1e-9);
      EXPECT_NEAR(*sample.parameters[1], (1 + sample.point.x()) / 2, 1e-9);
    } else
      EXPECT_NEAR(std::hypot(x - 1, y + 0.25), 0.75, 1e-9);
  }
  EXPECT_GT(inner, 4U);
}

// Three times as far from the line y = 0 as from (0,3): an ellipse of eccentricity 1/3. The other way round: a
// hyperbola, and circles around the ends.
TEST(TrimmedAlphaSectors, SegmentAndPoint)
{
  const Curve segment = bezier({P(-4, 0), P(4, 0)});
  const P focus(0, 3);
  const Sector ellipse = SC::trimmed_alpha_sector(focus, segment, 0.25),
               around = SC::trimmed_alpha_sector(segment, focus, 0.25);
  EXPECT_TRUE(ellipse.is_complete());
  EXPECT_TRUE(around.is_complete());
  EXPECT_EQ(ellipse.chains().size(), 1U);
  EXPECT_EQ(around.chains().size(), 1U);
  EXPECT_GT(samples(ellipse).size(), 10U);
  for (const auto& sample : samples(ellipse)) {
    const double x = sample.point.x(), y = sample.point.y();
    EXPECT_NEAR(9 * (x * x + (y - 3) * (y - 3)), y * y, 1e-10);
    EXPECT_TRUE(!sample.parameters[0]);
    EXPECT_NEAR(*sample.parameters[1], (x + 4) / 8, 1e-9);
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

// At the corners of a square the sector with its center goes over from one side to another one: of the side from above
// and below, hyperbolas or ellipses. Three contacts or more at once are decided exactly.
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

// Samples are proved to be at their distances from both curves; the chains go around the points that are nearer to one
// of them, and no others. A rigid motion and the exchange of both change nothing.
TEST(TrimmedAlphaSectors, RandomCubics)
{
  std::mt19937 random(11);
  std::uniform_int_distribution<int> coordinate(0, 16);
  const K::Aff_transformation_2 motion(0.6, -0.8, 2, 0.8, 0.6, -1);
  std::size_t inside = 0, outside = 0;
  for (int run = 0; run < 3; ++run) {
    std::vector<Curve> curves;
    Sites all;
    for (const int shift : {0, 18}) {
      std::vector<P> control_points;
      for (int i = 0; i < 4; ++i)
        control_points.emplace_back(coordinate(random), coordinate(random) + shift);
      curves.push_back(bezier(control_points));
      all[shift > 0] = points_along(curves.back());
    }
    const double alpha = (3 + 3 * run) / 16.0;
    const Sector sector = SC::trimmed_alpha_sector(curves[0], curves[1], alpha),
                 exchanged = SC::trimmed_alpha_sector(curves[1], curves[0], 1 - alpha);
    EXPECT_TRUE(sector.is_complete());
    EXPECT_EQ(sector.chains().size(), exchanged.chains().size());
    EXPECT_EQ(sector.arcs().size(), exchanged.arcs().size());
    if (run == 0) {
      const Sector moved =
          SC::trimmed_alpha_sector(curves[0].transformed(motion), curves[1].transformed(motion), alpha);
      EXPECT_TRUE(moved.is_complete());
      EXPECT_EQ(moved.chains().size(), sector.chains().size());
      EXPECT_EQ(moved.arcs().size(), sector.arcs().size());
    }
    const Samples places = samples(sector);
    EXPECT_GT(places.size(), 20U);
    for (std::size_t i = 0; i < places.size(); i += 1 + places.size() / 4)
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(SC::distance_range(places[i].point, curves[k]).first, places[i].distances[k], 1e-8);
        if (places[i].parameters[k]) {
          EXPECT_NEAR(distance(curves[k](*places[i].parameters[k]), places[i].point), places[i].distances[k], 1e-8);
        }
      }
    std::vector<P> queries;
    for (int i = 0; i < 100; ++i)
      queries.emplace_back(coordinate(random) * 1.5 - 4, coordinate(random) * 1.75);
    const auto counts = check_sides(sector, alpha, all, queries);
    EXPECT_EQ(check_sides(exchanged, 1 - alpha, {all[1], all[0]}, queries), counts);
    inside += counts[0];
    outside += counts[1];
  }
  EXPECT_GT(inside, 50U);
  EXPECT_GT(outside, 50U);
}

// Where a segment meets another operand, chains come to that point and leave it. Around each end of the segment there
// is one.
TEST(TrimmedAlphaSectors, SegmentsThatMeet)
{
  const Curve segment = bezier({P(-1, 0), P(1, 0)});
  const auto check = [](const Sector& sector, std::size_t number_of_chains, const P& common,
                        const auto& other_distance) {
    EXPECT_TRUE(sector.is_complete());
    EXPECT_EQ(sector.chains().size(), number_of_chains);
    double nearest = 1;
    for (const Sector::Chain& chain : sector.chains())
      EXPECT_TRUE(chain.is_closed);
    for (const auto& sample : samples(sector)) {
      EXPECT_NEAR(3 * std::hypot((std::max)(std::abs(sample.point.x()) - 1, 0.0), sample.point.y()),
                  other_distance(sample.point), 1e-9);
      nearest = (std::min)(nearest, distance(sample.point, common));
    }
    EXPECT_LT(nearest, 1e-12);
  };
  const P origin(0, 0), end(1, 0), middle(0.5, 0);
  check(SC::trimmed_alpha_sector(segment, bezier({P(0, -4), P(0, 4)}), 0.25), 2, origin,
        [](const P& p) { return std::abs(p.x()); });
  check(SC::trimmed_alpha_sector(segment, bezier({P(0, 0), P(0, 4)}), 0.25), 2, origin,
        [](const P& p) { return p.y() > 0 ? std::abs(p.x()) : std::hypot(p.x(), p.y()); });
  check(SC::trimmed_alpha_sector(segment, bezier({P(1, 0), P(1, 4)}), 0.25), 1, end,
        [&](const P& p) { return p.y() > 0 ? std::abs(p.x() - 1) : distance(p, end); });
  check(SC::trimmed_alpha_sector(segment, bezier({P(0, 0), P(4, 0)}), 0.25), 1, origin,
        [&](const P& p) { return p.x() > 0 ? std::abs(p.y()) : distance(p, origin); });
  check(SC::trimmed_alpha_sector(segment, middle, 0.25), 2, middle, [&](const P& p) { return distance(p, middle); });
  const Sector none = SC::trimmed_alpha_sector(middle, segment, 0.25);   // the point itself is nowhere nearer
  EXPECT_TRUE(none.is_complete());
  EXPECT_TRUE(none.chains().empty());
}

// The two arms of a corner in one end of a segment that leaves it: for 1/8 there are curves within the corner, for 5/16
// there are none.
TEST(TrimmedAlphaSectors, CornerThatMeets)
{
  const Curve corner = SC::polyline_curve(std::vector<P>{P(3, -1), P(0, 0), P(3, 1)}),
              other = bezier({P(0, 0), P(-2, 0)});
  for (const double alpha : {0.125, 0.3125}) {
    const Sector sector = SC::trimmed_alpha_sector(corner, other, alpha);
    EXPECT_TRUE(sector.is_complete());
    EXPECT_EQ(sector.chains().size(), alpha == 0.125 ? 2U : 1U);
    EXPECT_EQ(check_sides(sector, alpha, {points_along(corner), points_along(other)},
                          {P(3, 0.875), P(3, 1.125), P(2, -0.75), P(2.5, 0), P(2, 0), P(-1, 0), P(1, 2)})[0],
              alpha == 0.125 ? 3U : 5U);
  }
}

// Curves that cross in points that are not rational.
TEST(TrimmedAlphaSectors, RandomCubicsThatCross)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> coordinate(0, 16);
  std::size_t inside = 0;
  for (const double alpha : {0.125, 0.75}) {
    std::vector<Curve> curves;
    for (int k = 0; k < 2; ++k) {
      std::vector<P> control_points;
      for (int i = 0; i < 4; ++i)
        control_points.emplace_back(coordinate(random), coordinate(random));
      curves.push_back(bezier(control_points));
    }
    const Sector sector = SC::trimmed_alpha_sector(curves[0], curves[1], alpha);
    EXPECT_TRUE(sector.is_complete());
    std::vector<P> queries;
    for (int i = 0; i < 100; ++i)
      queries.emplace_back(coordinate(random), coordinate(random));
    inside += check_sides(sector, alpha, {points_along(curves[0]), points_along(curves[1])}, queries)[0];
  }
  EXPECT_GT(inside, 20U);
}

// Samples are as far from both curves as points along these tell, chains are closed and go around what they should, and
// come to a common point. Returns how many points are inside.
std::size_t check_curves_that_meet(const Curve& a, const Curve& b, double alpha, const P& common,
                                   const std::vector<P>& places)
{
  const Sector sector = SC::trimmed_alpha_sector(a, b, alpha);
  EXPECT_TRUE(sector.is_complete());
  double nearest = 1;
  const Samples along = samples(sector);
  for (std::size_t i = 0; i < along.size(); ++i) {
    EXPECT_NEAR((1 - alpha) * along[i].distances[0], alpha * along[i].distances[1], 1e-9);
    for (const std::size_t k : {0, 1})
      if (i % 16 == 0) {   // these distances are found one by one
        EXPECT_NEAR(SC::distance_range(along[i].point, k == 0 ? a : b).first, along[i].distances[k], 1e-8);
      }
    nearest = (std::min)(nearest, distance(along[i].point, common));
  }
  EXPECT_LT(nearest, 1e-12);
  return check_sides(sector, alpha, {points_along(a), points_along(b)}, places)[0];
}

std::vector<P> random_places(std::mt19937& random, double first, double last)
{
  std::uniform_real_distribution<double> coordinate(first, last);
  std::vector<P> result;
  for (int i = 0; i < 100; ++i) {
    const double x = coordinate(random);
    result.emplace_back(x, coordinate(random));
  }
  return result;
}

// Curves that touch have chains on both sides of the first one, on both sides of the common point. Disks on axes of
// symmetry touch several things at once, as the common point.
TEST(TrimmedAlphaSectors, CurvesThatTouch)
{
  std::mt19937 random(7);
  const Curve parabola = bezier({P(-1, 1), P(0, -1), P(1, 1)}), segment = bezier({P(-1, 0), P(1, 0)}),
              line = bezier({P(-3, 0), P(4, 0)});
  const Curve square = SC::polyline_curve(std::vector<P>{P(-1, -1), P(1, -1), P(1, 1), P(-1, 1), P(-1, -1)});
  const std::vector<P> round_outline{P(1, 0), P(2, 0), P(3, 0), P(4, 0), P(4, 1), P(4, 2), P(4, 3), P(4, 4), P(3, 4),
                                     P(2, 4), P(1, 4), P(0, 4), P(0, 3), P(0, 2), P(0, 1), P(0, 0), P(1, 0)};
  const Curve rounded(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 7, 7, 8, 8, 8}, round_outline),
      rectangle = SC::polyline_curve(std::vector<P>{P(0, 0), P(4, 0), P(4, 4), P(0, 4), P(0, 0)});
  std::size_t inside = 0;
  for (const double alpha : {0.125, 0.45, 0.75}) {
    const auto check = [&](const Curve& a, const Curve& b, const P& common) {
      inside += check_curves_that_meet(a, b, alpha, common, random_places(random, -3, 4));
    };
    check(parabola, segment, P(0, 0));
    check(parabola, bezier({P(0, 0), P(1, 0)}), P(0, 0));
    check(circle(P(0, 0), 1), circle(P(3, 0), 2), P(1, 0));
    check(circle(P(0, 0), 1), circle(P(1, 0), 2), P(-1, 0));
    check(circle(P(0, 1), 1), line, P(0, 0));
    check(square, circle(P(0, 0), 1), P(0, -1));
    check(rounded, rectangle, P(1, 0));   // which have parts of their sides in common
  }
  EXPECT_GT(inside, 100U);
}

// Cubics that leave a common end in one direction.
TEST(TrimmedAlphaSectors, RandomCubicsWithACommonTangent)
{
  std::mt19937 random(3);
  std::uniform_int_distribution<int> coordinate(0, 16), length(1, 6);
  std::size_t inside = 0;
  for (int run = 0; run < 8; ++run) {
    std::vector<Curve> curves;
    for (int k = 0; k < 2; ++k) {
      const int s = length(random);
      std::vector<P> control_points{P(0, 0), P(s, 2 * s)};
      for (int i = 0; i < 2; ++i) {
        const int x = coordinate(random);
        control_points.emplace_back(x, coordinate(random));
      }
      curves.push_back(bezier(control_points));
    }
    inside += check_curves_that_meet(curves[0], curves[1], (run % 2 == 0 ? 3 : 11) / 16.0, P(0, 0),
                                     random_places(random, -4, 16));
  }
  EXPECT_GT(inside, 20U);

  // Where one begins on the other one, that goes on as before.
  const Curve through = bezier({P(1, 8), P(7, 14), P(4, 3), P(15, 14)}),
              from = bezier({P(6.125, 9.125), P(8.875, 7.875), P(7, 16), P(9, 4)});
  for (const double alpha : {0.375, 0.5625})
    EXPECT_GT(check_curves_that_meet(through, from, alpha, P(6.125, 9.125), random_places(random, -4, 16)), 0U);
}

// Sectors of a curve and a point that is not on it. Returns how many points are inside.
std::size_t check_curve_and_point(const Curve& curve, const P& point, double alpha, const std::vector<P>& places)
{
  const Sector sector = SC::trimmed_alpha_sector(curve, point, alpha);
  EXPECT_TRUE(sector.is_complete());
  const Samples along = samples(sector);
  EXPECT_GT(along.size(), 10U);
  for (std::size_t i = 0; i < along.size(); i += 16) {
    EXPECT_NEAR(SC::distance_range(along[i].point, curve).first, along[i].distances[0], 1e-8);
    EXPECT_NEAR(distance(along[i].point, point), along[i].distances[1], 1e-8);
    EXPECT_NEAR((1 - alpha) * along[i].distances[0], alpha * along[i].distances[1], 1e-9);
  }
  return check_sides(sector, alpha, {points_along(curve), {point}}, places)[0];
}

// A curve turns back, away from the point: no chains come there.
TEST(TrimmedAlphaSectors, CurveThatTurnsBack)
{
  std::mt19937 random(5);
  const Curve cusp = bezier({P(0, 0), P(4, 4), P(0, 4), P(4, 0)});
  std::size_t inside = 0;
  for (const double alpha : {0.25, 0.75})
    inside += check_curve_and_point(cusp, P(2, -2), alpha, random_places(random, -4, 8));
  EXPECT_GT(inside, 10U);

  // A straight one, which covers a part of itself twice: where it turns the derivative is zero, and disks go over from
  // its side to the point.
  const Curve straight = bezier({P(0, 0), P(12, 0), P(9, 0)});
  inside = 0;
  for (const double alpha : {0.125, 0.375, 0.75})
    inside += check_curve_and_point(straight, P(10, 4), alpha, random_places(random, -4, 14));
  EXPECT_GT(inside, 10U);
}

// Four arcs of one curve meet in a point, two in each direction: beside it, and where the other curve comes there,
// those behind others are not touched, by disks of either operand.
TEST(TrimmedAlphaSectors, CurveThatTouchesItself)
{
  std::mt19937 random(5);
  const Curve parabolas(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                        std::vector<P>{P(-1, 1), P(0, -1), P(1, 1), P(2.5, 0), P(1, -1), P(0, 1), P(-1, -1)});
  const std::vector<P> loop{P(6, 11),  P(5, 16), P(14, 2), P(8, 8),  P(4, 12), P(9, 13), P(13, 15),
                            P(17, 17), P(4, 12), P(8, 8),  P(14, 2), P(8, 7),  P(7, 11)};
  const Curve cubics(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 4}, loop);
  std::size_t inside = 0;
  for (const double alpha : {0.125, 0.25, 0.75}) {
    for (const P& point : {P(0.25, 2.5), P(-2, 0.125), P(3, 0.5)})
      inside += check_curve_and_point(parabolas, point, alpha, random_places(random, -3, 4));
    inside += check_curve_and_point(cubics, P(1, 5), alpha, random_places(random, 0, 16));
    inside +=
        check_curves_that_meet(parabolas, bezier({P(-1, -2), P(1, 2)}), alpha, P(0, 0), random_places(random, -3, 4));
    inside += check_curves_that_meet(parabolas, bezier({P(0, 0), P(1, 2), P(2, 0), P(3, 3)}), alpha, P(0, 0),
                                     random_places(random, -3, 4));
  }
  EXPECT_GT(inside, 100U);
}

TEST(TrimmedAlphaSectors, BadInput)
{
  const Curve segment = bezier({P(-1, 0), P(1, 0)});
  for (const double alpha : {-1.0, 0.0, 0.5, 1.0, 2.0})
    EXPECT_THROW(SC::trimmed_alpha_sector(segment, P(0, 1), alpha), SC::Invalid_input);
  EXPECT_THROW(SC::trimmed_alpha_sector(segment, bezier({P(1, 1), P(1, 1)}), 0.25), SC::Invalid_input);
  const Sector sector = SC::trimmed_alpha_sector(P(0, 0), P(1, 0), 0.25);
  ASSERT_EQ(sector.arcs().size(), 1U);
  EXPECT_THROW(sector.polyline(0, 0), SC::Invalid_input);
}

} // namespace trimmed_alpha_sectors
