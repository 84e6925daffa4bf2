// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Intersections of curves in the plane and in space against exact answers.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/solver/verify.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace curve_intersections_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Intersection_kind;

using Doubles = CGAL::Simple_cartesian<double>;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;
using Points = std::vector<Doubles::Point_2>;
using Pairs = std::vector<std::pair<double, double>>;

// Answers of one kind, by their points rounded to multiples of 1e-9.
template <class Intersections>
Pairs points_of(const Intersections& intersections, Intersection_kind kind)
{
  Pairs result;
  for (const auto& intersection : intersections)
    if (intersection.kind() == kind) {
      const auto rounded = [](const auto& x) { return std::nearbyint(CGAL::to_double(x) * 1e9) / 1e9 + 0.0; };
      result.emplace_back(rounded(intersection.point().x()), rounded(intersection.point().y()));
    }
  std::sort(result.begin(), result.end());
  return result;
}

TEST(Curve_intersections, CirclesCross)
{
  const auto intersections = SC::intersections(SC::circle_curve(Epeck::Point_2(0, 0), Epeck::FT(5)),
                                               SC::circle_curve(Epeck::Point_2(6, 0), Epeck::FT(5)));
  EXPECT_TRUE(intersections.is_complete());
  EXPECT_EQ(points_of(intersections, Intersection_kind::TRANSVERSAL), (Pairs{{3, -4}, {3, 4}}));
  EXPECT_EQ(intersections.size(), 2u);
  for (const auto& intersection : intersections)
    EXPECT_TRUE(intersection.multiplicity() == 1 && !intersection.is_at_end(0) && !intersection.is_at_end(1));
}

// (5,0) is the seam of the circle: found from both sides of it, and reported once, with its first parameter.
TEST(Curve_intersections, SeamOfACircle)
{
  const auto circle = SC::circle_curve(Epeck::Point_2(0, 0), Epeck::FT(5));
  const auto line = SC::segment_curve(Epeck::Point_2(-7, 3), Epeck::Point_2(9, -1));   // (5,0) at 3/4
  for (const bool is_first : {true, false}) {
    const auto intersections = is_first ? SC::intersections(circle, line) : SC::intersections(line, circle);
    EXPECT_TRUE(intersections.is_complete());
    EXPECT_EQ(intersections.size(), 2u);
    ASSERT_EQ(intersections.count(Intersection_kind::END_POINT), 1u);
    const auto& seam = *std::find_if(intersections.begin(), intersections.end(),
                                     [](const auto& x) { return x.kind() == Intersection_kind::END_POINT; });
    const std::size_t i = is_first ? 0 : 1;
    EXPECT_EQ(seam.parameter_range(i), (std::pair<Exact_rational, Exact_rational>(0, 0)));
    EXPECT_TRUE(seam.is_at_end(i) && !seam.is_at_end(1 - i));
    EXPECT_DOUBLE_EQ(seam.parameter(1 - i), 0.75);
    EXPECT_DOUBLE_EQ(CGAL::to_double(seam.point().x()), 5);
  }
  // Both circles have their seams there and cross.
  const auto other = SC::circle_curve(Epeck::Point_2(2, 4), Epeck::Point_2(5, 0));
  const auto intersections = SC::intersections(circle, other);
  EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
  EXPECT_EQ(intersections.size(), 2u);
  ASSERT_EQ(intersections.count(Intersection_kind::END_POINT), 1u);
}

// The parabola (v^2, v^4) ends nowhere near, and (2,4) has the irrational parameter sqrt(2) on it.
TEST(Curve_intersections, EndsOnACurve)
{
  // over [0,1], with v = 2t
  const auto quartic =
      SC::bezier_curve(std::vector<Epeck::Point_2>{{0, 0}, {0, 0}, {Epeck::FT(2) / 3, 0}, {2, 0}, {4, 16}});
  const auto from = SC::segment_curve(Epeck::Point_2(2, 4), Epeck::Point_2(3, 0));
  const auto ends = SC::intersections(from, quartic);
  EXPECT_TRUE(ends.is_complete()) << ends.summary();
  ASSERT_EQ(ends.size(), 1u);
  EXPECT_EQ(ends[0].kind(), Intersection_kind::END_POINT);
  EXPECT_EQ(ends[0].parameter_range(0), (std::pair<Exact_rational, Exact_rational>(0, 0)));
  EXPECT_EQ(ends[0].point(), Epeck::Point_2(2, 4));
  EXPECT_NEAR(ends[0].parameter(1), std::sqrt(0.5), 1e-15);
  EXPECT_TRUE(ends[0].is_at_end(0) && !ends[0].is_at_end(1));

  // Just beyond it and just before it.
  const Epeck::FT little = Epeck::FT(1) / Epeck::FT(1e18);
  EXPECT_TRUE(
      SC::intersections(SC::segment_curve(Epeck::Point_2(2, 4 - little), Epeck::Point_2(3, 0)), quartic).empty());
  const auto crossing =
      SC::intersections(SC::segment_curve(Epeck::Point_2(2, 4 + little), Epeck::Point_2(3, 0)), quartic);
  ASSERT_EQ(crossing.size(), 1u);
  EXPECT_EQ(crossing[0].kind(), Intersection_kind::TRANSVERSAL);
  EXPECT_FALSE(crossing[0].is_at_end(0));
}

TEST(Curve_intersections, SharedEndsAndCorners)
{
  const auto a = SC::polyline_curve(Points{{0, 0}, {1, 1}, {2, 0}}),
             b = SC::polyline_curve(Points{{2, 0}, {1, 1}, {0, 2}});
  const auto intersections = SC::intersections(SC::segment_curve(Doubles::Point_2(0, 0), Doubles::Point_2(2, 1)),
                                               SC::segment_curve(Doubles::Point_2(2, 1), Doubles::Point_2(3, -5)));
  EXPECT_TRUE(intersections.is_complete());
  ASSERT_EQ(intersections.size(), 1u);
  EXPECT_EQ(intersections[0].kind(), Intersection_kind::END_POINT);
  EXPECT_TRUE(intersections[0].is_at_end(0) && intersections[0].is_at_end(1));
  EXPECT_EQ(intersections[0].point(), Doubles::Point_2(2, 1));

  // The second half of `a` is the first half of `b`.
  const auto common = SC::intersections(a, b);
  EXPECT_TRUE(common.is_complete()) << common.summary();
  ASSERT_EQ(common.size(), 1u);
  const auto& overlap = common[0];
  EXPECT_EQ(overlap.kind(), Intersection_kind::OVERLAP);
  EXPECT_EQ(overlap.parameter_range(0), (std::pair<Exact_rational, Exact_rational>(1, 2)));
  EXPECT_EQ(overlap.parameter_range(1), (std::pair<Exact_rational, Exact_rational>(0, 1)));
}

// An end of an overlap is a common point of other pieces too, and of both sides of a seam: it belongs to the overlap. A
// crossing elsewhere does not.
TEST(Curve_intersections, EndsOfOverlapsAreNoOtherAnswers)
{
  const auto is_only_overlap = [](const auto& intersections) {
    return intersections.is_complete() && intersections.size() == 1 &&
        intersections[0].kind() == Intersection_kind::OVERLAP;
  };
  EXPECT_TRUE(is_only_overlap(SC::intersections(SC::polyline_curve(Points{{0, 0}, {4, 0}, {4, 4}}),
                                                SC::polyline_curve(Points{{1, -1}, {1, 0}, {3, 0}, {3, 2}}))));
  const auto circle = SC::circle_curve(Epeck::Point_2(0, 0), Epeck::FT(2));
  EXPECT_TRUE(is_only_overlap(SC::intersections(circle, circle)));
  EXPECT_TRUE(is_only_overlap(SC::intersections(circle, circle.restricted(Epeck::FT(7) / 2, Epeck::FT(4)))));

  // A parabola, and a part of it with a second piece that crosses it later, or goes on in its direction and touches it
  // in the end of the overlap.
  const auto parabola = SC::bezier_curve(std::vector<Epeck::Point_2>{{0, 0}, {1, 2}, {2, 0}});
  const auto part = parabola.restricted(Epeck::FT(1) / 4, Epeck::FT(3) / 4).control_points();
  const auto with_tail = [&](const Epeck::Point_2& p, const Epeck::Point_2& q) {
    return SC::Bspline_curve_2<Epeck>(2, {0, 0, 0, 1, 1, 2, 2, 2}, {part[0], part[1], part[2], p, q});
  };
  const auto crossing = SC::intersections(parabola, with_tail(Epeck::Point_2(3, 3), Epeck::Point_2(0, -4)));
  EXPECT_TRUE(crossing.is_complete()) << crossing.summary();
  EXPECT_EQ(crossing.count(Intersection_kind::OVERLAP), 1u);
  EXPECT_EQ(crossing.count(Intersection_kind::TRANSVERSAL), 1u);
  EXPECT_EQ(crossing.size(), 2u);
  const auto touching = SC::intersections(parabola, with_tail(part[2] + (part[2] - part[1]), Epeck::Point_2(0, 4)));
  EXPECT_TRUE(touching.is_complete()) << touching.summary();
  EXPECT_EQ(touching.count(Intersection_kind::OVERLAP), 1u);
}

// As in rounded rectangles on each other: an edge overlaps a part of another one, and then bends away in the same
// direction. The ends have too long denominators to be guessed.
TEST(Curve_intersections, OverlapThatBendsAway)
{
  using K = CGAL::Simple_cartesian<Exact_rational>;
  const Exact_rational begin = Exact_rational(9992188) / 10000000, end = Exact_rational(10007812) / 10000000,
                       middle = (begin + end) / 2;
  const auto edges = SC::polyline_curve(std::vector<K::Point_2>{{0, -5}, {0, Exact_rational(504) / 10}, {9, 60}});
  for (const int side : {-1, 1}) {
    const SC::Bspline_curve_2<K> round(
        2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
        {{2 * side, begin - 1}, {0, begin - 1}, {0, begin}, {0, middle}, {0, end}, {0, end + 1}, {side, end + 2}});
    const auto intersections = SC::intersections(edges, round);
    EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
    ASSERT_EQ(intersections.size(), 1u);
    EXPECT_EQ(intersections[0].kind(), Intersection_kind::OVERLAP);
    const auto parameter = [](const Exact_rational& y) { return Exact_rational((y + 5) * 10 / 554); };
    EXPECT_EQ(intersections[0].parameter_range(0), (std::pair(parameter(begin), parameter(end))));
    EXPECT_EQ(intersections[0].parameter_range(1), (std::pair<Exact_rational, Exact_rational>(1, 2)));
  }
}

// The curve bends into a straight piece of the other one, at an irrational parameter of it: an end of the overlap, no
// other answer. Beside it, they do not meet.
TEST(Curve_intersections, OverlapFromAnIrrationalParameter)
{
  using K = CGAL::Simple_cartesian<Exact_rational>;
  const auto bend = [](const Exact_rational& x) {
    return SC::Bspline_curve_2<K>(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2},
                                  {{x - 2, 2}, {x - 1, 2}, {x, 1}, {x, 0}, {x, -1}, {x, -2}, {x, -3}});
  };
  const auto straight = SC::bezier_curve(
      std::vector<K::Point_2>{{0, 1}, {0, Exact_rational(-1, 10)}, {0, Exact_rational(-3, 2)}, {0, -2}});
  for (const bool is_first : {true, false}) {
    const auto intersections = is_first ? SC::intersections(bend(0), straight) : SC::intersections(straight, bend(0));
    EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
    ASSERT_EQ(intersections.size(), 1u);
    EXPECT_EQ(intersections[0].kind(), Intersection_kind::OVERLAP);
  }
  const auto beside = SC::intersections(bend(Exact_rational(-1, 1000000)), straight);
  EXPECT_TRUE(beside.is_complete() && beside.empty());
}

// A corner, or a joint of two pieces without one, touches a curve at an irrational parameter of it, sqrt(1/2) or the
// zero of a cubic polynomial. Moved by a little, it misses the curve, or crosses it twice.
TEST(Curve_intersections, BreaksThatTouchAtIrrationalParameters)
{
  using K = CGAL::Simple_cartesian<Exact_rational>;
  using Curve = SC::Bspline_curve_2<K>;
  const Curve parabola = SC::bezier_curve(std::vector<K::Point_2>{{0, 0}, {0, 0}, {4, 8}}),
              line = SC::bezier_curve(std::vector<K::Point_2>{{-1, 2}, {Exact_rational(1, 2), 2}, {1, 2}, {5, 2}});
  const auto corner = [](const Exact_rational& y) {
    return SC::polyline_curve(std::vector<K::Point_2>{{1, 9 + y}, {2, 4 + y}, {0, 7 + y}});
  };
  const auto joint = [](const Exact_rational& y) {
    return Curve(2, {0, 0, 0, 1, 1, 2, 2, 2}, {{0, 5 + y}, {0, 2 + y}, {1, 2 + y}, {2, 2 + y}, {3, 4 + y}});
  };
  const Exact_rational little = Exact_rational(1) / 100000;
  for (const auto& [touching, beside, other] :
       {std::array{corner(0), corner(little), parabola}, std::array{joint(0), joint(little), line}})
    for (const std::size_t k : {0, 1}) {
      const auto found = k == 0 ? SC::intersections(touching, other) : SC::intersections(other, touching);
      EXPECT_TRUE(found.is_complete()) << found.summary();
      ASSERT_EQ(found.size(), 1u);
      EXPECT_EQ(found[0].kind(), Intersection_kind::TANGENT);
      EXPECT_EQ(found[0].parameter_range(k), (std::pair<Exact_rational, Exact_rational>(1, 1)));
      EXPECT_LT(found[0].parameter_range(1 - k).first, found[0].parameter_range(1 - k).second);
      EXPECT_FALSE(found[0].is_at_end(0) || found[0].is_at_end(1));
      const auto apart = k == 0 ? SC::intersections(beside, other) : SC::intersections(other, beside);
      EXPECT_TRUE(apart.is_complete() && apart.empty());
    }
  EXPECT_EQ(SC::intersections(joint(-little), line).count(Intersection_kind::TRANSVERSAL), 2u);
  for (int cell : {0, 1}) {   // one that begins or ends there
    const auto found = SC::intersections(joint(0).restricted(cell, cell + 1), line);
    EXPECT_TRUE(found.is_complete()) << found.summary();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].parameter_range(0), (std::pair<Exact_rational, Exact_rational>(1, 1)));
    EXPECT_TRUE(found[0].is_at_end(0) && !found[0].is_at_end(1));
  }
}

// Sides that nearly run along each other, from corners that are nearly the same, counted by CGAL.
TEST(Curve_intersections, CrossingsNextToCorners)
{
  std::mt19937 generator(1);
  const auto integer = [&](int lower, int upper) {
    return lower + static_cast<int>(generator() % static_cast<unsigned>(upper - lower + 1));
  };
  std::size_t crossings = 0;
  for (int i = 0; i < 150; ++i) {
    Epeck::FT tiny(1);
    for (int digits = integer(3, 7); digits-- > 0;)
      tiny /= 10;
    const auto near_to = [&](int x, int y) {
      return Epeck::Point_2(x + tiny * integer(-3, 3), y + tiny * integer(-3, 3));
    };
    const int x = integer(-9, 9), y = integer(1, 9);
    const std::vector<Epeck::Point_2> a{{0, 0}, Epeck::Point_2(x, y), Epeck::Point_2(integer(-9, 9), integer(-9, 9))},
        b{Epeck::Point_2(integer(-3, 3), integer(-3, 3)), near_to(0, 0), near_to(x, y)};
    const auto sides = [](const std::vector<Epeck::Point_2>& p) {
      return std::vector<Epeck::Segment_2>{{p[0], p[1]}, {p[1], p[2]}};
    };
    const auto has_corner_on = [&](const std::vector<Epeck::Point_2>& p, const std::vector<Epeck::Point_2>& q) {
      return std::any_of(p.begin(), p.end(), [&](const Epeck::Point_2& corner) {
        return std::ranges::any_of(sides(q), [&](const Epeck::Segment_2& side) { return side.has_on(corner); });
      });
    };
    if (a[1] == a[2] || b[0] == b[1] || has_corner_on(a, b) || has_corner_on(b, a))
      continue;
    std::size_t expected = 0;
    for (const Epeck::Segment_2& p : sides(a))
      for (const Epeck::Segment_2& q : sides(b))
        expected += CGAL::do_intersect(p, q) ? 1 : 0;
    const auto intersections = SC::intersections(SC::polyline_curve(a), SC::polyline_curve(b));
    EXPECT_TRUE(intersections.is_complete()) << i << ": " << intersections.summary();
    EXPECT_EQ(intersections.count(Intersection_kind::TRANSVERSAL), expected) << i;
    crossings += intersections.size();
  }
  EXPECT_GT(crossings, 100u);
}

// Copies with other digits, that meet at breaks only. The solver would have to cut them into very small boxes, and
// stops early; elimination settles what it leaves, also where one of the two is moved away.
TEST(Curve_intersections, NearlyTheSameCurves)
{
  using K = CGAL::Simple_cartesian<Exact_rational>;
  const auto copy = [](const Exact_rational& shift) {
    return SC::Bspline_curve_2<K>(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2},
                                  {{0, 0}, {shift, 6}, {7, 11}, {16, 11}, {21, 11}, {25, 8 + shift}, {30, 5}});
  };
  const Exact_rational tiny = Exact_rational(1) / 1000000;
  const auto intersections = SC::intersections(copy(0), copy(tiny), {.node_limit = 500});
  EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
  ASSERT_EQ(intersections.size(), 3u);
  for (int i : {0, 1, 2}) {
    EXPECT_TRUE(intersections[i].kind() == Intersection_kind::TANGENT ||
                intersections[i].kind() == Intersection_kind::END_POINT);
    for (int k : {0, 1}) {
      EXPECT_LE(intersections[i].parameter_range(k).first, i);
      EXPECT_GE(intersections[i].parameter_range(k).second, i);
      EXPECT_EQ(intersections[i].is_at_end(k), i != 1);
    }
  }
  const CGAL::Aff_transformation_2<K> move(CGAL::TRANSLATION, K::Vector_2(tiny, -2 * tiny));
  const auto moved =
      SC::intersections(copy(0).restricted(0, 1), copy(tiny).restricted(0, 1).transformed(move), {.node_limit = 500});
  EXPECT_TRUE(moved.is_complete()) << moved.summary();
  EXPECT_TRUE(moved.empty());
}

// y = x^2 and y = x^2 + tiny x (2 x^2 - 1) begin together in nearly the same direction and cross soon after at a very
// small angle; the whole box that the solver leaves is settled by elimination.
TEST(Curve_intersections, CrossingsAtSmallAngles)
{
  const Epeck::FT third = Epeck::FT(1) / 3;
  const auto graph = [&](const Epeck::FT& tiny) {
    return SC::bezier_curve(std::vector<Epeck::Point_2>{
        {0, 0}, {third, -tiny * third}, {2 * third, third - 2 * third * tiny}, {1, 1 + tiny}});
  };
  for (int digits : {3, 9, 40}) {
    Exact_rational tiny(1);
    for (int i = 0; i < digits; ++i)
      tiny /= 10;
    const auto intersections = SC::intersections(graph(0), graph(tiny), {.node_limit = 10});
    EXPECT_TRUE(intersections.is_complete()) << digits << ' ' << intersections.summary();
    ASSERT_EQ(intersections.size(), 2u);
    EXPECT_TRUE(intersections[0].is_at_end(0) && intersections[0].is_at_end(1));
    EXPECT_EQ(intersections[1].kind(), Intersection_kind::TRANSVERSAL);
    EXPECT_EQ(intersections[1].multiplicity(), 1);
    for (std::size_t k : {0, 1}) {
      const auto [lower, upper] = intersections[1].parameter_range(k);
      EXPECT_TRUE(lower < upper && 2 * lower * lower < 1 && 1 < 2 * upper * upper);
      EXPECT_NEAR(intersections[1].parameter(k), std::sqrt(0.5), 1e-9);
    }
  }
}

// Quarters of a disk, one turned by an angle with the cosine 3/5: their arcs overlap up to the corner of the first one,
// where its straight side begins.
TEST(Curve_intersections, OverlapOfArcsUpToACorner)
{
  const Epeck::FT half = Epeck::FT(1) / 2;
  const SC::Bspline_curve_2<Epeck> quarter(2, {0, 0, 0, 1, 1, 2, 2, 2}, {{1, 0}, {1, 1}, {0, 1}, {0, half}, {0, 0}},
                                           {1, 1, 2, 2, 2});
  const auto turned = quarter.transformed(CGAL::Aff_transformation_2<Epeck>(3, -4, 4, 3, 5));
  const auto intersections = SC::intersections(quarter, turned);
  EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
  EXPECT_EQ(intersections.count(Intersection_kind::OVERLAP), 1u);
  EXPECT_EQ(intersections.size(), 2u);
  for (const auto& x : intersections)
    EXPECT_TRUE(x.kind() == Intersection_kind::OVERLAP ||
                (x.is_at_end(0) && x.is_at_end(1) && x.point() == Epeck::Point_2(0, 0)));
}

// Pieces of one circle: where two of them meet on both curves, a common factor has a zero of its own that belongs to
// the overlap.
TEST(Curve_intersections, OverlapAcrossABreak)
{
  const auto circle = SC::circle_curve(Epeck::Point_2(0, 0), Epeck::FT(2));
  const auto intersections = SC::intersections(circle, circle.restricted(Epeck::FT(5) / 2, Epeck::FT(7) / 2));
  EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
  ASSERT_EQ(intersections.size(), 1u);
  EXPECT_EQ(intersections[0].kind(), Intersection_kind::OVERLAP);
  for (int i : {0, 1})
    EXPECT_EQ(intersections[0].parameter_range(i),
              (std::pair<Exact_rational, Exact_rational>(Exact_rational(5) / 2, Exact_rational(7) / 2)));
}

TEST(Curve_intersections, Tangents)
{
  const auto parabola = SC::bezier_curve(Points{{-1, 1}, {0, -1}, {1, 1}});
  const auto tangent =
      SC::intersections(parabola, SC::segment_curve(Doubles::Point_2(-1.5, 0), Doubles::Point_2(1.25, 0)));
  EXPECT_TRUE(tangent.is_complete());
  ASSERT_EQ(tangent.size(), 1u);
  EXPECT_EQ(tangent[0].kind(), Intersection_kind::TANGENT);
  EXPECT_EQ(tangent[0].multiplicity(), 2);

  // A line 1e-10 above, and below.
  const auto above =
      SC::intersections(parabola, SC::segment_curve(Doubles::Point_2(-1.5, 1e-10), Doubles::Point_2(1.25, 1e-10)));
  EXPECT_TRUE(above.is_complete() && above.count(Intersection_kind::TRANSVERSAL) == 2 && above.size() == 2);
  const auto below =
      SC::intersections(parabola, SC::segment_curve(Doubles::Point_2(-1.5, -1e-10), Doubles::Point_2(1.25, -1e-10)));
  EXPECT_TRUE(below.is_complete() && below.empty());
}

// y = x^2 and y = x^4 / 4 + 1 touch where x^2 = 2.
TEST(Curve_intersections, TangentsAtIrrationalParameters)
{
  using K = Epeck;
  const auto parabola = SC::bezier_curve(std::vector<K::Point_2>{{-2, 4}, {0, -4}, {2, 4}});
  const auto quartic = SC::bezier_curve(std::vector<K::Point_2>{{-2, 5}, {-1, -3}, {0, 5}, {1, -3}, {2, 5}});
  const auto touching = SC::intersections(parabola, quartic);
  EXPECT_TRUE(touching.is_complete());
  EXPECT_EQ(points_of(touching, Intersection_kind::TANGENT), (Pairs{{-1.414213562, 2}, {1.414213562, 2}}));
  EXPECT_EQ(touching.size(), 2u);
  for (const auto& x : touching)
    EXPECT_EQ(x.multiplicity(), 2);
  const K::FT gap = K::FT(1e-50) * K::FT(1e-50);
  const auto apart = SC::intersections(
      parabola, quartic.transformed(CGAL::Aff_transformation_2<K>(CGAL::TRANSLATION, K::Vector_2(0, gap))));
  EXPECT_TRUE(apart.is_complete() && apart.empty());
  const auto crossing = SC::intersections(
      parabola, quartic.transformed(CGAL::Aff_transformation_2<K>(CGAL::TRANSLATION, K::Vector_2(0, -gap))));
  EXPECT_TRUE(crossing.is_complete() && crossing.count(Intersection_kind::TRANSVERSAL) == 4 && crossing.size() == 4);
}

// The Bernstein coefficients of a polynomial with these coefficients, over an interval.
template <class FT>
std::vector<FT> bernstein_coefficients(const std::vector<FT>& polynomial, const FT& begin, const FT& end)
{
  const int n = static_cast<int>(polynomial.size()) - 1;
  std::vector<FT> local(polynomial.size(), FT(0));   // in powers of (t - begin) / (end - begin), by Horner's scheme
  for (int i = n; i >= 0; --i) {
    for (int j = n; j > 0; --j)
      local[j] = local[j] * begin + local[j - 1] * (end - begin);
    local[0] = local[0] * begin + polynomial[i];
  }
  for (int k = 1; k <= n; ++k) {   // divided by the binomial coefficients, then summed
    FT binomial(1);
    for (int i = 0; i < k; ++i)
      binomial = binomial * (n - i) / (i + 1);
    local[k] = local[k] / binomial;
  }
  for (int round = 0; round < n; ++round)
    for (int j = n; j > round; --j)
      local[j] = local[j] + local[j - 1];
  return local;
}

// y = x^2 + (x^r - 2)^k, in exact coordinates, for -2 <= x <= 2.
template <class K>
SC::Bspline_curve_2<K> curve_of_contact(int r, int k)
{
  using FT = typename K::FT;
  std::vector<FT> y{FT(1)};
  for (int i = 0; i < k; ++i) {
    std::vector<FT> next(y.size() + r, FT(0));
    for (std::size_t j = 0; j < y.size(); ++j) {
      next[j] = next[j] - 2 * y[j];
      next[j + r] = next[j + r] + y[j];
    }
    y = next;
  }
  y[2] = y[2] + 1;
  std::vector<FT> x(y.size(), FT(0));
  x[1] = FT(1);
  x = bernstein_coefficients(x, FT(-2), FT(2));
  y = bernstein_coefficients(y, FT(-2), FT(2));
  std::vector<typename K::Point_2> points;
  for (std::size_t i = 0; i < x.size(); ++i)
    points.emplace_back(x[i], y[i]);
  return SC::bezier_curve(points);
}

// Contacts of a parabola with those curves where x is a root of 2, in other coordinates and with other parameters.
TEST(Curve_intersections, ContactsOfHighOrderAtIrrationalParameters)
{
  using K = CGAL::Simple_cartesian<Exact_rational>;
  const std::vector<K::Point_2> points{{-3, 9}, {0, -9}, {3, 9}};
  const CGAL::Aff_transformation_2<K> map(3, -1, 7, 1, 2, 5, 3);
  const SC::Bspline_curve_2<K> parabola = SC::bezier_curve(points),
                               other_speed(2, {0, 0, 0, 1, 1, 1}, {{-3, 9}, {0, -9}, {3, 9}}, {1, 2, 4});
  for (const int r : {2, 3})
    for (int k = 2; k <= (r == 2 ? 4 : 3); ++k)
      for (const bool is_other : {false, true}) {
        if (k + r > 5 && is_other)
          continue;
        const auto curve = is_other ? curve_of_contact<K>(r, k).transformed(map) : curve_of_contact<K>(r, k);
        const auto contacts = SC::intersections(curve, is_other ? other_speed.transformed(map) : parabola);
        EXPECT_TRUE(contacts.is_complete()) << r << ' ' << k;
        ASSERT_EQ(contacts.size(), r == 2 ? 2u : 1u);
        for (const auto& x : contacts) {
          EXPECT_EQ(x.kind(), Intersection_kind::TANGENT);
          EXPECT_EQ(x.multiplicity(), k);
          EXPECT_NEAR(std::abs(4 * x.parameter(0) - 2), std::pow(2, 1. / r), 1e-12);
        }
      }
  // No contact: two crossings and one beside them, or none, not a multiple root.
  const auto curve = curve_of_contact<K>(2, 3);
  for (const double gap : {-1e-9, 1e-9}) {
    const auto near = SC::intersections(
        curve.transformed(CGAL::Aff_transformation_2<K>(CGAL::TRANSLATION, K::Vector_2(0, gap))), parabola);
    for (const auto& x : near)
      EXPECT_NE(x.kind(), Intersection_kind::TANGENT);
  }
}

// y = x^2 + c max(x, 0)^3 touches y = -x^2 and y = 0 at a knot where its third derivative jumps; with the second one,
// the two sides count differently.
TEST(Curve_intersections, TangentsOnKnots)
{
  using K = CGAL::Simple_cartesian<Exact_rational>;
  const auto bent = [](const SC::Bspline_curve_2<K>& curve) {   // at its last knot, the last point moved
    auto points = curve.control_points();
    points.back() = K::Point_2(1, 5);
    return SC::Bspline_curve_2<K>(curve.degree(), curve.knots(), points);
  };
  const SC::Bspline_curve_2<K> upwards =
      SC::bezier_curve(std::vector<K::Point_2>{{-1, 1}, {0, -1}, {1, 1}}).with_domain(-1, 1);
  const SC::Bspline_curve_2<K> downwards = SC::bezier_curve(std::vector<K::Point_2>{{-1, -1}, {0, 1}, {1, -1}});
  const SC::Bspline_curve_2<K> line = SC::segment_curve(K::Point_2(-2, 0), K::Point_2(2, 0));
  for (const int smoothness : {2, 1})
    for (const auto& other : {downwards, line}) {
      const SC::Bspline_curve_2<K> curve =
          bent(smoothness == 2 ? upwards.elevated(3).with_knot(0) : upwards.with_knot(0));
      const auto contacts = SC::intersections(curve, other);
      EXPECT_TRUE(contacts.is_complete());
      ASSERT_EQ(contacts.size(), 1u);
      EXPECT_EQ(contacts[0].kind(), Intersection_kind::TANGENT);
      EXPECT_EQ(contacts[0].multiplicity(), smoothness == 2 ? 2 : 0);
      EXPECT_NEAR(contacts[0].parameter(0), 0, 1e-12);
    }
}

// The speed of one curve jumps in the knot where it touches the other one, which is closed and smooth, at its seam.
TEST(Curve_intersections, ContactAtASeamAndAKnot)
{
  using K = CGAL::Simple_cartesian<Exact_rational>;
  using Point = K::Point_2;
  using Curve = SC::Bspline_curve_2<K>;
  const std::vector<Exact_rational> knots{0, 0, 0, 1, 1, 2, 2, 2};
  const Curve closed(2, knots, {Point(0, 0), Point(2, 0), Point(0, 2), Point(-2, 0), Point(0, 0)});
  const Curve other(2, knots, {Point(-2, -2), Point(-1, 0), Point(0, 0), Point(2, 0), Point(4, -8)});
  for (const bool is_first : {true, false}) {
    const auto found = is_first ? SC::intersections(closed, other) : SC::intersections(other, closed);
    EXPECT_TRUE(found.is_complete());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].kind(), Intersection_kind::TANGENT);
    EXPECT_EQ(found[0].parameter_range(is_first ? 0 : 1), std::pair(Exact_rational(0), Exact_rational(0)));
    const auto [lower, upper] = found[0].parameter_range(is_first ? 1 : 0);
    EXPECT_TRUE(lower <= 1 && 1 <= upper && upper - lower < Exact_rational(1e-12));
  }
}

// Curves on the surface z = x^2 + y, which cross where x^2 = 3/2; then moved, so that no coordinate is simple.
TEST(Curve_intersections, InSpace)
{
  using K = Epeck;
  const CGAL::Aff_transformation_3<K> map(3, -1, 2, 7, 1, 4, K::FT(1) / 3, 5, -2, 1, 1, 6);
  const auto first = SC::bezier_curve(std::vector<K::Point_3>{{-2, 3, 7}, {0, -5, -9}, {2, 3, 7}});
  const auto second = SC::bezier_curve(std::vector<K::Point_3>{{-2, -2, 2}, {0, 6, 2}, {2, -2, 2}});
  for (const bool is_moved : {false, true}) {
    const auto a = is_moved ? first.transformed(map) : first, b = is_moved ? second.transformed(map) : second;
    const auto crossings = SC::intersections(a, b);
    EXPECT_TRUE(crossings.is_complete());
    ASSERT_EQ(crossings.count(Intersection_kind::TRANSVERSAL), 2u);
    EXPECT_EQ(crossings.size(), 2u);
    for (const auto& x : crossings)
      EXPECT_NEAR(std::abs(4 * x.parameter(0) - 2), std::sqrt(1.5), 1e-12);
    const auto near_miss =
        SC::intersections(a, b.transformed(CGAL::Aff_transformation_3<K>(CGAL::TRANSLATION, K::Vector_3(0, 0, 1e-60))));
    EXPECT_TRUE(near_miss.is_complete() && near_miss.empty());
  }
  const auto overlap = SC::intersections(first.transformed(map).restricted(0, K::FT(1) / 2),
                                         first.transformed(map).restricted(K::FT(1) / 3, 1));
  EXPECT_TRUE(overlap.is_complete());
  ASSERT_EQ(overlap.size(), 1u);
  EXPECT_EQ(overlap[0].kind(), Intersection_kind::OVERLAP);
  EXPECT_EQ(overlap[0].parameter_range(0),
            (std::pair<Exact_rational, Exact_rational>(Exact_rational(1) / 3, Exact_rational(1) / 2)));
}

// Segments from a common corner, and skew ones.
TEST(Curve_intersections, SegmentsInSpace)
{
  using K = Epeck;
  const K::Point_3 corner(1, 2, 3);
  const auto shared = SC::intersections(SC::segment_curve(corner, K::Point_3(4, 5, 7)),
                                        SC::segment_curve(K::Point_3(-2, 3, 1), corner));
  EXPECT_TRUE(shared.is_complete());
  ASSERT_EQ(shared.size(), 1u);
  EXPECT_EQ(shared[0].kind(), Intersection_kind::END_POINT);
  EXPECT_TRUE(shared[0].is_at_end(0) && shared[0].is_at_end(1));
  EXPECT_EQ(shared[0].point(), corner);
  const auto skew = SC::intersections(SC::segment_curve(K::Point_3(0, 0, 0), K::Point_3(2, 2, 0)),
                                      SC::segment_curve(K::Point_3(2, 0, 1), K::Point_3(0, 2, 1)));
  EXPECT_TRUE(skew.is_complete() && skew.empty());
  // in a plane z = 1
  const auto crossing = SC::intersections(SC::segment_curve(K::Point_3(0, 0, 1), K::Point_3(2, 2, 1)),
                                          SC::segment_curve(K::Point_3(2, 0, 1), K::Point_3(0, 2, 1)));
  EXPECT_TRUE(crossing.is_complete());
  ASSERT_EQ(crossing.size(), 1u);
  EXPECT_LT(CGAL::to_double(CGAL::squared_distance(crossing[0].point(), K::Point_3(1, 1, 1))), 1e-28);
}

// Curves and their transposes: 4, 9 and 81 points.
TEST(Curve_intersections, Transposed)
{
  const auto transposed = [](Points points) {
    for (auto& p : points)
      p = {p.y(), p.x()};
    return SC::bezier_curve(points);
  };
  Points wiggly, chebyshev;
  for (int i = 0; i <= 10; ++i)
    wiggly.emplace_back(i / 10.0, i % 2 == 0 ? 1.0 : -1.0);
  const double binomials[] = {1, 9, 36, 84, 126, 126, 84, 36, 9, 1},
               even[] = {1, 153, 3060, 18564, 43758, 43758, 18564, 3060, 153, 1};
  for (int i = 0; i <= 9; ++i)
    chebyshev.emplace_back(-1 + 2.0 * i / 9, (i % 2 == 1 ? 1 : -1) * even[i] / binomials[i]);
  const Points cubic{{-3, -3}, {-1, 15}, {1, -15}, {3, 3}};
  for (const auto& [points, count] : {std::pair(wiggly, 4u), std::pair(cubic, 9u), std::pair(chebyshev, 81u)}) {
    const auto intersections = SC::intersections(SC::bezier_curve(points), transposed(points));
    EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
    EXPECT_EQ(intersections.size(), count);
  }
}

// Curves through a common point, planted at random parameters: it is found once, and an affine map changes no count.
TEST(Curve_intersections, PlantedPoints)
{
  using K = CGAL::Simple_cartesian<Exact_rational>;
  std::mt19937 random(7);
  const auto number = [&](int range) { return Exact_rational(static_cast<int>(random() % (2 * range + 1)) - range); };
  for (int round = 0; round < 60; ++round) {
    std::vector<K::Point_2> a, b;
    for (int i = 0; i < 4 + round % 3; ++i)
      a.emplace_back(number(20), number(20));
    for (int i = 0; i < 4; ++i)
      b.emplace_back(number(20), number(20));
    const auto first = SC::bezier_curve(a);
    const Exact_rational s = Exact_rational(static_cast<int>(1 + random() % 9)) / 10,
                         t = round % 5 == 0 ? Exact_rational(1)
                                            : Exact_rational(static_cast<int>(1 + random() % 9)) / 10;
    auto second = SC::bezier_curve(b);
    second = second.transformed(CGAL::Aff_transformation_2<K>(CGAL::TRANSLATION, first(s) - second(t)));
    const auto intersections = SC::intersections(first, second);
    ASSERT_TRUE(intersections.is_complete()) << round << ' ' << intersections.summary();
    EXPECT_EQ(std::count_if(intersections.begin(), intersections.end(),
                            [&](const auto& x) {
                              return x.parameter_range(0).first <= s && s <= x.parameter_range(0).second &&
                                  x.parameter_range(1).first <= t && t <= x.parameter_range(1).second &&
                                  x.is_at_end(1) == (t == 1);
                            }),
              1)
        << round;
    const CGAL::Aff_transformation_2<K> map(Exact_rational(3), Exact_rational(-1), Exact_rational(7), Exact_rational(2),
                                            Exact_rational(5), Exact_rational(1) / 3);
    const auto images = SC::intersections(first.transformed(map), second.transformed(map));
    EXPECT_EQ(images.size(), intersections.size());
    for (const Intersection_kind kind :
         {Intersection_kind::TRANSVERSAL, Intersection_kind::END_POINT, Intersection_kind::TANGENT})
      EXPECT_EQ(images.count(kind), intersections.count(kind));
  }
}

} // namespace

} // namespace curve_intersections_test
