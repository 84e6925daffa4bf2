// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closest points and feet of perpendiculars against exact answers.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace closest_points_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Solution_kind;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Range = std::pair<Exact_rational, Exact_rational>;

Range exactly(const Exact_rational& x) { return {x, x}; }

template <class A, class B>
void expect_distance(const A& a, const B& b, const Exact_rational& squared_distance, std::size_t pairs = 1)
{
  for (const bool is_swapped : {false, true}) {
    const auto closest = is_swapped ? SC::closest_points(b, a) : SC::closest_points(a, b);
    EXPECT_TRUE(closest.is_complete()) << closest.summary();
    EXPECT_EQ(closest.size(), pairs);
    EXPECT_EQ(closest.squared_distance_range(), exactly(squared_distance));
    for (const auto& pair : closest)
      EXPECT_EQ(pair.squared_distance_range(), exactly(squared_distance));
  }
}

class Random_integers
{
  std::mt19937 m_generator;
  int m_range;

public:
  Random_integers(unsigned seed, int range) : m_generator(seed), m_range(range) {}
  int operator()() { return static_cast<int>(m_generator() % static_cast<unsigned>(2 * m_range + 1)) - m_range; }
  K::Point_2 point_2() { const int x = (*this)(), y = (*this)(); return {x, y}; }
  K::Point_3 point_3() { const int x = (*this)(), y = (*this)(), z = (*this)(); return {x, y, z}; }
};

TEST(Closest_points, PointAndCircle)
{
  const auto circle = SC::circle_curve(K::Point_2(0, 0), K::FT(2));
  const auto at_seam = SC::closest_points(K::Point_2(5, 0), circle);
  EXPECT_TRUE(at_seam.is_unique() && at_seam.is_complete());
  EXPECT_EQ(at_seam.squared_distance_range(), exactly(9));
  EXPECT_EQ(at_seam.distance_range(), (std::pair<double, double>(3, 3)));
  EXPECT_EQ(at_seam[0].parameter_range(1), exactly(0));
  EXPECT_EQ(at_seam[0].point(1), K::Point_2(2, 0));

  const auto irrational = SC::closest_points(circle, K::Point_2(5, 1));
  EXPECT_TRUE(irrational.is_unique());
  const auto [lower, upper] = irrational.distance_range();
  EXPECT_TRUE(lower <= std::sqrt(26.0) - 2 && std::sqrt(26.0) - 2 <= upper && upper - lower < 1e-14)
      << lower << ' ' << upper;

  const auto center = SC::closest_points(K::Point_2(0, 0), circle);
  ASSERT_EQ(center.size(), 1u);
  EXPECT_EQ(center[0].kind(), Solution_kind::CONTINUUM);
  EXPECT_EQ(center.squared_distance_range(), exactly(4));
  EXPECT_FALSE(center.is_unique());
}

// Four feet within the evolute, two outside.
TEST(Closest_points, FeetOnAnEllipse)
{
  const auto ellipse = SC::ellipse_curve(K::Point_2(0, 0), K::Vector_2(2, 0), K::Vector_2(0, 1));
  const auto inside = SC::projections(K::Point_2(K::FT(1) / 2, 0), ellipse);
  EXPECT_TRUE(inside.summary().is_complete);
  ASSERT_EQ(inside.feet().size(), 4u);
  std::vector<std::pair<double, double>> feet;
  for (const auto& foot : inside.feet()) {
    EXPECT_EQ(foot.kind(), Solution_kind::CERTIFIED);
    EXPECT_EQ(foot.point(0), K::Point_2(K::FT(1) / 2, 0));
    feet.emplace_back(CGAL::to_double(foot.point(1).x()), CGAL::to_double(foot.point(1).y()));
  }
  const std::vector<std::pair<double, double>> expected{
      {2.0 / 3, -std::sqrt(8.0) / 3}, {2.0 / 3, std::sqrt(8.0) / 3}, {2, 0}, {-2, 0}};
  std::sort(feet.begin(), feet.begin() + 2);
  for (int i = 0; i < 4; ++i)
    EXPECT_TRUE(std::abs(feet[i].first - expected[i].first) < 1e-14 &&
                std::abs(feet[i].second - expected[i].second) < 1e-14)
        << i;
  EXPECT_EQ(inside.feet()[3].squared_distance_range(), exactly(Exact_rational(25) / 4));
  EXPECT_EQ(SC::projections(K::Point_2(K::FT(3) / 10, K::FT(1) / 5), ellipse).feet().size(), 4u);
  EXPECT_EQ(SC::projections(K::Point_2(3, 2), ellipse).feet().size(), 2u);
  EXPECT_EQ(SC::projections(K::Point_2(7, 5), ellipse).feet().size(), 2u);
  const auto at_cusp = SC::projections(K::Point_2(K::FT(3) / 2, 0), ellipse); // of the evolute: three feet are one
  EXPECT_TRUE(at_cusp.summary().is_complete);
  ASSERT_EQ(at_cusp.feet().size(), 2u);
  EXPECT_EQ(at_cusp.feet()[0].kind(), Solution_kind::CLUSTER);
  EXPECT_NEAR(CGAL::to_double(at_cusp.feet()[0].point(1).x()), 2, 1e-9);
  EXPECT_EQ(at_cusp.feet()[1].kind(), Solution_kind::CERTIFIED);
  EXPECT_EQ(at_cusp.feet()[1].point(1), K::Point_2(-2, 0));
  expect_distance(K::Point_2(0, 0), ellipse, 1, 2); // two feet, by symmetry
}

// At a corner, a foot is perpendicular to one of the sides; ends are no feet.
TEST(Closest_points, FeetAtCorners)
{
  const auto corner = SC::polyline_curve(std::vector<K::Point_2>{{0, 0}, {4, 0}, {4, 4}});
  for (const auto& [point, count] :
       {std::pair(K::Point_2(4, 3), 2u), std::pair(K::Point_2(2, 5), 1u), std::pair(K::Point_2(1, 1), 2u),
        std::pair(K::Point_2(5, -1), 0u), std::pair(K::Point_2(1, 0), 2u)}) {
    const auto feet = SC::projections(point, corner);
    EXPECT_TRUE(feet.summary().is_complete);
    EXPECT_EQ(feet.feet().size(), count) << point;
  }
  expect_distance(K::Point_2(5, -1), corner, 2);
  expect_distance(K::Point_2(-3, -4), corner, 25);
}

TEST(Closest_points, RandomSegments)
{
  Random_integers random(11, 6);
  for (int round = 0; round < 80; ++round) {
    const K::Segment_2 a(random.point_2(), random.point_2()), b(random.point_2(), random.point_2());
    if (a.is_degenerate() || b.is_degenerate())
      continue;
    const auto closest =
        SC::closest_points(SC::segment_curve(a.source(), a.target()), SC::segment_curve(b.source(), b.target()));
    ASSERT_FALSE(closest.empty());
    EXPECT_TRUE(closest.is_complete()) << a << ' ' << b;
    EXPECT_EQ(closest.squared_distance_range(), exactly(CGAL::squared_distance(a, b).exact())) << a << ' ' << b;
  }
  for (int round = 0; round < 80; ++round) {
    const K::Segment_3 a(random.point_3(), random.point_3()), b(random.point_3(), random.point_3());
    if (a.is_degenerate() || b.is_degenerate())
      continue;
    const auto closest =
        SC::closest_points(SC::segment_curve(a.source(), a.target()), SC::segment_curve(b.source(), b.target()));
    ASSERT_FALSE(closest.empty());
    EXPECT_TRUE(closest.is_complete()) << a << ' ' << b;
    EXPECT_EQ(closest.squared_distance_range(), exactly(CGAL::squared_distance(a, b).exact())) << a << ' ' << b;
  }
}

TEST(Closest_points, RandomPolylines)
{
  Random_integers random(5, 9);
  for (int round = 0; round < 30; ++round) {
    std::vector<K::Point_2> vertices;
    for (int i = 0; i < 6; ++i)
      vertices.push_back(random.point_2());
    const K::Point_2 point = random.point_2();
    K::FT least = CGAL::squared_distance(point, vertices[0]);
    for (std::size_t i = 1; i < vertices.size(); ++i)
      least = (std::min)(least, CGAL::squared_distance(point, K::Segment_2(vertices[i - 1], vertices[i])));
    const auto closest = SC::closest_points(point, SC::polyline_curve(vertices));
    EXPECT_TRUE(closest.is_complete());
    EXPECT_EQ(closest.squared_distance_range(), exactly(least.exact()));
  }
}

TEST(Closest_points, ParallelSegments)
{
  const auto a = SC::segment_curve(K::Point_2(0, 0), K::Point_2(2, 0)),
             b = SC::segment_curve(K::Point_2(1, 1), K::Point_2(5, 1));
  expect_distance(a, b, 1);
  EXPECT_EQ(SC::closest_points(a, b)[0].kind(), Solution_kind::CONTINUUM);
}

TEST(Closest_points, Circles)
{
  const auto circle = SC::circle_curve(K::Point_2(0, 0), K::FT(2));
  expect_distance(circle, SC::circle_curve(K::Point_2(6, 8), K::FT(3)), 25);
  expect_distance(circle, SC::circle_curve(K::Point_2(1, 3), K::Point_2(1, 1)), 0, 2);   // crosses it twice
  const auto touching = SC::closest_points(circle, SC::circle_curve(K::Point_2(3, 4), K::FT(3)));
  EXPECT_EQ(touching.squared_distance_range(), exactly(0));
  ASSERT_FALSE(touching.empty());
  for (const auto& pair : touching)
    EXPECT_NEAR(CGAL::to_double(pair.point(0).x()), 1.2, 1e-6);
  const auto inside = SC::closest_points(circle, SC::circle_curve(K::Point_2(1, 1), K::Point_2(1, 5)));   // from within
  EXPECT_TRUE(inside.is_unique());
  EXPECT_NEAR(inside.distance_range().first, 2 - std::sqrt(2.0), 1e-14);
}

TEST(Closest_points, CurvesAgainstSamples)
{
  Random_integers random(3, 20);
  for (int round = 0; round < 8; ++round) {
    std::vector<K::Point_2> p, q;
    for (int i = 0; i < 4; ++i) {
      p.push_back(random.point_2());
      q.push_back(random.point_2() + K::Vector_2(25, 0));
    }
    const auto a = SC::bezier_curve(p), b = SC::bezier_curve(q);
    const auto closest = SC::closest_points(a, b), swapped = SC::closest_points(b, a);
    EXPECT_TRUE(closest.is_complete() && closest.size() == swapped.size());
    double least = 1e9;
    constexpr int steps = 64;
    std::vector<std::pair<double, double>> of_a, of_b;
    for (int i = 0; i <= steps; ++i) {
      const K::Point_2 x = a(K::FT(i) / steps), y = b(K::FT(i) / steps);
      of_a.emplace_back(CGAL::to_double(x.x()), CGAL::to_double(x.y()));
      of_b.emplace_back(CGAL::to_double(y.x()), CGAL::to_double(y.y()));
    }
    for (const auto& x : of_a)
      for (const auto& y : of_b)
        least = (std::min)(least, std::hypot(x.first - y.first, x.second - y.second));
    const auto [lower, upper] = closest.distance_range();
    EXPECT_LE(lower, least + 1e-12);
    EXPECT_GT(upper, least - 2) << round;
    EXPECT_LT(upper - lower, 1e-6);
    EXPECT_TRUE(lower <= swapped.distance_range().second && swapped.distance_range().first <= upper);
  }
}

// Knots 0, 1, ..., pieces, those inside with these multiplicities in turns; and as many control points along an axis.
std::vector<K::FT> knots_of(int degree, int pieces, const std::vector<int>& multiplicities)
{
  std::vector<K::FT> result(degree + 1, K::FT(0));
  for (int i = 1; i < pieces; ++i)
    result.insert(result.end(), multiplicities[i % multiplicities.size()], K::FT(i));
  result.insert(result.end(), degree + 1, K::FT(pieces));
  return result;
}

// Most pieces are left out, but the least distance is that of all pieces.
template <class A, class B>
void expect_distance_of_pieces(const A& a, const B& b, const Range& of_pieces)
{
  const auto closest = SC::closest_points(a, b), swapped = SC::closest_points(b, a);
  EXPECT_TRUE(closest.is_complete() && swapped.is_complete());
  EXPECT_EQ(closest.size(), swapped.size());
  EXPECT_GE(closest.size(), 1u);
  for (const Range& range : {closest.squared_distance_range(), swapped.squared_distance_range()}) {
    EXPECT_TRUE(range.first <= of_pieces.second && of_pieces.first <= range.second);
    EXPECT_LT(range.second - range.first, Exact_rational(1, 1000000000));
  }
}

template <class A, class B>
Range distance_of_pieces(const std::vector<A>& as, const std::vector<B>& bs)
{
  Range result(1000000, 1000000);
  for (const A& a : as)
    for (const B& b : bs) {
      const Range range = SC::closest_points(a, b).squared_distance_range();
      result = {(std::min)(result.first, range.first), (std::min)(result.second, range.second)};
    }
  return result;
}

TEST(Closest_points, SplinesOfManyPieces)
{
  Random_integers random(11, 9);
  const std::vector<std::vector<int>> multiplicities{{1}, {1, 3}, {2, 1}, {3}};
  const auto curve = [&](const std::vector<K::FT>& knots, int height, bool is_rational) {
    std::vector<K::Point_2> points;
    std::vector<K::FT> weights;
    for (std::size_t i = 0; i + 4 < knots.size(); ++i) {
      points.push_back(random.point_2() + K::Vector_2(6 * static_cast<int>(i), height));
      if (is_rational)
        weights.push_back(K::FT(20 + random()) / 10);
    }
    return SC::Bspline_curve_2<K>(3, knots, points, weights);
  };
  for (int round = 0; round < 4; ++round) {
    const std::vector<K::FT> knots = knots_of(3, 5, multiplicities[round]);
    const auto a = curve(knots, 0, round >= 2), b = curve(knots, 22, round % 2 == 1);
    expect_distance_of_pieces(a, b, distance_of_pieces(a.bezier_pieces(), b.bezier_pieces()));
  }
  std::vector<K::Point_3> net;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < 6; ++j)
      net.emplace_back(4 * i, 4 * j, random());
  const SC::Bspline_surface_3<K> surface({3, 2}, knots_of(3, 4, {1}), knots_of(2, 4, {1}), net);
  for (const K::Point_3& point : {K::Point_3(9, 11, 8), K::Point_3(-3, 4, 1), K::Point_3(12, 12, -20)})
    expect_distance_of_pieces(point, surface,
                              distance_of_pieces(std::vector<K::Point_3>{point}, surface.bezier_pieces()));
}

// Two nearest points in pieces that are far from each other; and a closed curve, whose seam is nearest.
TEST(Closest_points, NearestPointsInDistantPieces)
{
  const std::vector<K::Point_2> points{{-7, 0}, {-6, 3}, {-4, 6}, {-2, 3}, {0, 0}, {2, 3}, {4, 6}, {6, 3}, {7, 0}};
  const SC::Bspline_curve_2<K> wave(2, knots_of(2, 7, {1}), points);
  const auto both = SC::closest_points(K::Point_2(0, 20), wave);
  EXPECT_TRUE(both.is_complete());
  ASSERT_EQ(both.size(), 2u);
  EXPECT_TRUE(both[0].kind() == Solution_kind::CERTIFIED && both[1].kind() == Solution_kind::CERTIFIED);
  const auto [first, second] = std::minmax({both[0].parameter(1), both[1].parameter(1)});
  EXPECT_LT(first, 3);
  EXPECT_NEAR(first + second, 7, 1e-12);

  std::vector<K::FT> period;
  for (int i = 0; i <= 8; ++i)
    period.emplace_back(i);
  const std::vector<K::Point_2> around{{3, -1}, {3, 1}, {1, 3}, {-1, 3}, {-3, 1}, {-3, -1}, {-1, -3}, {1, -3}};
  const auto closed = SC::Bspline_curve_2<K>::from_periodic(2, period, around);
  for (int i = 0; i < 8; ++i) {   // breaks are the middles of sides
    const K::Point_2 middle = CGAL::midpoint(around[i], around[(i + 1) % 8]);
    const K::Vector_2 normal = (around[(i + 1) % 8] - around[i]).perpendicular(CGAL::CLOCKWISE);
    expect_distance(middle + normal, closed, CGAL::exact(normal.squared_length()));
  }
}

// The nearest point of a rectangle has clamped coordinates: in the interior, on a side, or a corner.
TEST(Closest_points, PointAndRectangle)
{
  const auto rectangle =
      SC::bilinear_surface(K::Point_3(0, 0, 0), K::Point_3(0, 3, 0), K::Point_3(2, 0, 0), K::Point_3(2, 3, 0));
  Random_integers random(17, 5);
  for (int round = 0; round < 25; ++round) {
    const K::Point_3 p = random.point_3();
    const auto beyond = [](const K::FT& x, int end) { return x < 0 ? K::FT(-x) : x > end ? K::FT(x - end) : K::FT(0); };
    const K::FT dx = beyond(p.x(), 2), dy = beyond(p.y(), 3), expected = dx * dx + dy * dy + p.z() * p.z();
    const auto closest = SC::closest_points(p, rectangle);
    EXPECT_TRUE(closest.is_unique() && closest.is_complete()) << p;
    EXPECT_EQ(closest.squared_distance_range(), exactly(expected.exact())) << p;
  }
  const auto other =
      SC::bilinear_surface(K::Point_3(3, 4, 5), K::Point_3(3, 6, 5), K::Point_3(5, 4, 5), K::Point_3(5, 6, 5));
  const auto corners = SC::closest_points(rectangle, other);
  EXPECT_TRUE(corners.is_unique());
  EXPECT_EQ(corners.squared_distance_range(), exactly(1 + 1 + 25));
  EXPECT_FALSE(corners[0].solution());
  expect_distance(rectangle, SC::segment_curve(K::Point_3(-1, 1, 1), K::Point_3(1, 1, -1)), 0);
}

// An edge of one patch passes through the other one at irrational parameters.
TEST(Closest_points, IntersectingPatches)
{
  const auto a =
      SC::bilinear_surface(K::Point_3(0, 0, 0), K::Point_3(0, 3, 1), K::Point_3(2, 0, 0), K::Point_3(2, 3, 0));
  const auto b =
      SC::bilinear_surface(K::Point_3(1, 1, -1), K::Point_3(1, 1, 2), K::Point_3(2, 2, -1), K::Point_3(1, 3, 2));
  const auto closest = SC::closest_points(a, b);
  ASSERT_FALSE(closest.empty());
  EXPECT_EQ(closest.squared_distance_range(), exactly(0));
  EXPECT_FALSE(closest.is_unique());
}

TEST(Closest_points, Sphere)
{
  const auto sphere = SC::sphere_surface(K::Point_3(0, 0, 0), K::FT(2));
  const auto outside = SC::closest_points(K::Point_3(5, 3, 1), sphere);
  EXPECT_TRUE(outside.is_unique());
  EXPECT_NEAR(outside.distance_range().first, std::sqrt(35.0) - 2, 1e-14);
  EXPECT_LT(outside.distance_range().second - outside.distance_range().first, 1e-14);
  expect_distance(K::Point_3(4, 0, 0), sphere, 4);
  expect_distance(K::Point_3(0, 0, 0), sphere, 4);
  const auto pole = SC::closest_points(K::Point_3(0, 0, 3), sphere);
  EXPECT_EQ(pole.squared_distance_range(), exactly(1));
  // besides the poles, where a derivative is zero
  const auto feet = SC::projections(K::Point_3(5, 3, 1), sphere).feet();
  EXPECT_EQ(std::count_if(feet.begin(), feet.end(), [](const auto& foot) { return CGAL::abs(foot.point(1).z()) < 1; }),
            2);

  expect_distance(SC::segment_curve(K::Point_3(3, -2, -1), K::Point_3(3, 4, 2)), sphere, 1);
  expect_distance(SC::segment_curve(K::Point_3(-5, -3, 1), K::Point_3(4, 6, 0)), sphere, 0, 2);
  // 7x - z = 25, at the distance 25/sqrt(50) - 2
  const auto patch =
      SC::bilinear_surface(K::Point_3(3, -5, -4), K::Point_3(3, 5, -4), K::Point_3(4, -5, 3), K::Point_3(4, 5, 3));
  const auto plane = SC::closest_points(patch, sphere);
  EXPECT_TRUE(plane.is_unique()) << plane.summary();
  EXPECT_NEAR(plane.distance_range().first, std::sqrt(12.5) - 2, 1e-12);
  EXPECT_NEAR(plane.distance_range().second, std::sqrt(12.5) - 2, 1e-12);
}

// What a limit leaves undecided stays in the answer.
TEST(Closest_points, NothingIsLostAtALimit)
{
  SC::Solver_options options;
  options.node_limit = 1;
  const auto a = SC::bezier_curve(std::vector<K::Point_2>{{0, 0}, {1, 9}, {2, -7}, {3, 1}}),
             b = SC::bezier_curve(std::vector<K::Point_2>{{0, 4}, {1, -2}, {2, 9}, {3, 2}, {4, 8}});
  const auto limited = SC::closest_points(a, b, options), full = SC::closest_points(a, b);
  EXPECT_TRUE(full.is_complete());
  EXPECT_LE(limited.squared_distance_range().first, full.squared_distance_range().first);
  EXPECT_GE(limited.squared_distance_range().second, full.squared_distance_range().second);
  for (const auto& nearest : full)
    EXPECT_TRUE(std::any_of(limited.begin(), limited.end(), [&](const auto& pair) {
      return pair.parameter_range(0).first <= nearest.parameter_range(0).first &&
          nearest.parameter_range(0).second <= pair.parameter_range(0).second &&
          pair.parameter_range(1).first <= nearest.parameter_range(1).first &&
          nearest.parameter_range(1).second <= pair.parameter_range(1).second;
    }));
}

TEST(Closest_points, DoublesAndBadInput)
{
  using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto curve = SC::bezier_curve(std::vector<Epick::Point_2>{{0, 0}, {0.5, 1}, {1, 0}});
  EXPECT_EQ(SC::closest_points(Epick::Point_2(0.5, 3), curve).squared_distance_range(),
            exactly(Exact_rational(25) / 4));
  EXPECT_THROW(SC::closest_points(Epick::Point_2(0, std::nan("")), curve), SC::Invalid_input);
  SC::Solver_options options;
  options.tolerance = -1;
  EXPECT_THROW(SC::distance_range(Epick::Point_2(0, 0), curve, options), SC::Invalid_input);
}

} // namespace

} // namespace closest_points_test
