// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Where curves meet themselves: exact answers, polylines against all pairs of segments, splines against all pairs of
// their pieces.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/self_intersections.h>

#include <CGAL/intersections.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace self_intersections_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using Kind = SC::Intersection_kind;
using R = Exact_rational;
using Curve = SC::Bspline_curve_2<Exact_cartesian>;
using Space_curve = SC::Bspline_curve_3<Exact_cartesian>;
using Point = Exact_cartesian::Point_2;
using Powers = std::vector<R>;   // coefficients, that of 1 first
using Pairs = std::vector<std::pair<double, double>>;

// The polynomial with these coefficients on [a,b]: control points are values of its blossom.
SC::Bspline_function<R> polynomial(const Powers& coefficients, int degree, const R& a, const R& b)
{
  std::vector<R> control;
  for (int i = 0; i <= degree; ++i) {
    std::vector<R> symmetric(degree + 1, R(0));   // elementary symmetric functions of i times b and degree - i times a
    symmetric[0] = R(1);
    for (int j = 0; j < degree; ++j)
      for (int k = degree; k > 0; --k)
        symmetric[k] += R((j < i ? b : a) * symmetric[k - 1]);
    R value(0), binomial(1);
    for (int k = 0; k < static_cast<int>(coefficients.size()); ++k) {
      value += R(coefficients[k] * symmetric[k] / binomial);
      binomial *= R(degree - k) / R(k + 1);
    }
    control.push_back(value);
  }
  std::vector<R> knots(degree + 1, a);
  knots.insert(knots.end(), degree + 1, b);
  return {{degree}, {knots}, control};
}

Curve polynomial_curve(const Powers& x, const Powers& y, const R& a, const R& b, const Powers& weight = {R(1)})
{
  const int degree = static_cast<int>((std::max)({x.size(), y.size(), weight.size()})) - 1;
  return Curve::from_homogeneous_coordinates({polynomial(x, degree, a, b), polynomial(y, degree, a, b)},
                                             polynomial(weight, degree, a, b));
}

Space_curve polynomial_curve(const Powers& x, const Powers& y, const Powers& z, const R& a, const R& b)
{
  return Space_curve::from_homogeneous_coordinates(
      {polynomial(x, 4, a, b), polynomial(y, 4, a, b), polynomial(z, 4, a, b)}, polynomial({R(1)}, 4, a, b));
}

Powers chebyshev(int n)
{
  Powers before{R(1)}, result{R(0), R(1)};
  for (int k = 1; k < n; ++k) {
    Powers next(result.size() + 1, R(0));
    for (std::size_t i = 0; i < result.size(); ++i)
      next[i + 1] = R(2 * result[i]);
    for (std::size_t i = 0; i < before.size(); ++i)
      next[i] -= before[i];
    before = std::exchange(result, next);
  }
  return result;
}

Curve polyline(const std::vector<Point>& points) { return SC::polyline_curve<Exact_cartesian>(points); }

// Complete answers, all of one kind, with these parameters.
template <class Curve_d>
void expect_pairs(const Curve_d& curve, const Pairs& expected, Kind kind = Kind::TRANSVERSAL)
{
  const auto found = SC::self_intersections(curve);
  EXPECT_TRUE(found.is_complete());
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(found[i].kind(), kind);
    EXPECT_NEAR(found[i].parameter(0), expected[i].first, 1e-13);
    EXPECT_NEAR(found[i].parameter(1), expected[i].second, 1e-13);
    EXPECT_LT(found[i].parameter_range(0).second, found[i].parameter_range(1).first);
  }
}

const Curve nodal_cubic = polynomial_curve({R(-1), R(0), R(1)}, {R(0), R(-1), R(0), R(1)}, R(-2), R(2));

TEST(Self_intersections, NodalCubic)
{
  expect_pairs(nodal_cubic, {{-1, 1}});
  expect_pairs(nodal_cubic.reversed(), {{-1, 1}});
  expect_pairs(nodal_cubic.with_knot(R(-1)).with_knot(R(1)), {{-1, 1}});   // cut in the node, on both branches
  expect_pairs(nodal_cubic.with_knot(R(1)).with_knot(R(1)).with_knot(R(1)), {{-1, 1}});
  expect_pairs(nodal_cubic.restricted(R(-1) / R(2), R(2)), {});
  const auto at_end = SC::self_intersections(nodal_cubic.restricted(R(-2), R(1)));
  ASSERT_EQ(at_end.size(), 1u);
  EXPECT_EQ(at_end[0].kind(), Kind::END_POINT);
  EXPECT_TRUE(!at_end[0].is_at_end(0) && at_end[0].is_at_end(1));
  // a closed loop: the node is its seam
  EXPECT_TRUE(SC::self_intersections(nodal_cubic.restricted(R(-1), R(1))).empty());
}

// x = T_a(t), y = T_b(t) has a node at each t = cos(pi (i/a + j/b)), cos(pi (i/a - j/b)).
TEST(Self_intersections, ChebyshevCurves)
{
  for (const auto& [a, b] : std::vector<std::pair<int, int>>{{2, 3}, {3, 4}, {3, 5}, {4, 5}, {5, 6}}) {
    Pairs expected;
    for (int i = 1; i < a; ++i)
      for (int j = 1; j < b; ++j)
        if (i * b + j * a < a * b) {
          const double pi = std::acos(-1.0), sum = pi * i / a + pi * j / b, difference = pi * i / a - pi * j / b;
          expected.emplace_back(std::cos(sum), std::cos(difference));
        }
    ASSERT_EQ(static_cast<int>(expected.size()), (a - 1) * (b - 1) / 2);
    std::sort(expected.begin(), expected.end());
    expect_pairs(polynomial_curve(chebyshev(a), chebyshev(b), R(-1), R(1)), expected);
  }
}

// The loop of r = 1 + 2 cos(phi), with the tangent of phi / 2 as parameter.
TEST(Self_intersections, Limacon)
{
  const Powers x{R(3), R(0), R(-4), R(0), R(1)}, y{R(0), R(6), R(0), R(-2)}, weight{R(1), R(0), R(2), R(0), R(1)};
  expect_pairs(polynomial_curve(x, y, R(-3), R(3), weight), {{-std::sqrt(3.0), std::sqrt(3.0)}});
  expect_pairs(polynomial_curve(x, y, R(-3), R(1), weight), {});
}

TEST(Self_intersections, OfACurveInSpace)
{
  const Powers x{R(-1), R(0), R(1)}, y{R(0), R(-1), R(0), R(1)};
  expect_pairs(polynomial_curve(x, y, {R(-3), R(-1), R(3), R(1)}, R(-2), R(2)), {{-1, 1}});   // z = (t + 3) (t^2 - 1)
  expect_pairs(polynomial_curve(x, y, {R(0), R(1)}, R(-2), R(2)), {});
  // z differs by 2e-6 in the node
  expect_pairs(polynomial_curve(x, y, {R(0), R(1) / R(1000000), R(1)}, R(-2), R(2)), {});
  Random_geometry random(5);
  for (int k = 0; k < 5; ++k)
    expect_pairs(random.curve<Exact_cartesian, 3>(4, 1), {});
}

// The common end of a closed curve is none, but a branch that passes through it is one.
TEST(Self_intersections, ClosedCurves)
{
  expect_pairs(polyline({{0, 0}, {1, 0}, {0, 1}, {0, 0}}), {});
  expect_pairs(polyline({{0, 0}, {1, 1}, {-1, 1}, {0, 0}, {1, -1}, {-1, -1}, {0, 0}}), {{0, 3}}, Kind::END_POINT);
  std::vector<R> period;
  for (int i = 0; i <= 8; ++i)
    period.push_back(R(i));
  expect_pairs(Curve::from_periodic(3, period, {{1, 0}, {2, 1}, {1, 2}, {0, 1}, {-1, 0}, {-2, 1}, {-1, 2}, {0, 1}}),
               {{2, 6}});
  expect_pairs(Curve::from_periodic(3, period, {{1, 2}, {0, 1}, {-1, 0}, {-2, 1}, {-1, 2}, {0, 1}, {1, 0}, {2, 1}}),
               {{0, 4}}, Kind::END_POINT);
  expect_pairs(Curve::from_periodic(3, period, {{3, 0}, {2, 2}, {0, 3}, {-2, 2}, {-3, 0}, {-2, -2}, {0, -3}, {2, -2}}),
               {});
}

TEST(Self_intersections, CuspsAreNone)
{
  const Powers t2{R(0), R(0), R(1)}, t3{R(0), R(0), R(0), R(1)};
  expect_pairs(polynomial_curve(t2, t3, R(-1), R(1)), {});
  expect_pairs(polynomial_curve(t2, t3, R(-1), R(1)).with_knot(R(0)), {});
  expect_pairs(polynomial_curve({R(0), R(0), R(1), R(3)}, {R(0), R(0), R(2), R(1)}, R(-1), R(1) / R(3)), {});
  expect_pairs(polynomial_curve({R(0), R(0), R(1), R(3)}, {R(0), R(0), R(2), R(1)}, R(-1), R(1) / R(3)).with_knot(R(0)),
               {});
  // it stops and goes on
  expect_pairs(polynomial_curve(t3, {R(0), R(0), R(0), R(1), R(0), R(1)}, R(-1), R(1) / R(3)), {});
  // C' = (t^2 - 2) (1, t): a cusp at the square root of 2.
  expect_pairs(polynomial_curve({R(0), R(-2), R(0), R(1) / R(3)}, {R(0), R(0), R(-1), R(0), R(1) / R(4)}, R(1), R(2)),
               {});
}

// The projective image of that cusp is not decided, and reported.
TEST(Self_intersections, AnIrrationalCuspOfARationalCurveIsUndecided)
{
  const Powers x{R(0), R(-2), R(0), R(1) / R(3)}, y{R(0), R(0), R(-1), R(0), R(1) / R(4)},
      weight{R(5), R(-2), R(-1), R(1) / R(3), R(1) / R(4)};
  const auto found = SC::self_intersections(polynomial_curve(x, y, R(1), R(2), weight));
  EXPECT_GE(found.size(), 1u);
  EXPECT_EQ(found.size(), found.count(Kind::UNDECIDED));
  for (const auto& answer : found)
    EXPECT_LT(answer.parameter(1) - answer.parameter(0), 1e-3);
}

// Two parabolas that touch in the common end of two pieces, where the curve turns back.
TEST(Self_intersections, TurningBackAtABreak)
{
  expect_pairs(Curve(2, {R(0), R(0), R(0), R(1), R(1), R(2), R(2), R(2)}, {{4, 16}, {2, 0}, {0, 0}, {2, 0}, {4, -16}}),
               {});
}

TEST(Self_intersections, Overlaps)
{
  for (const Curve& curve : {polyline({{0, 0}, {1, 1}, {0, 0}}), polyline({{0, 0}, {2, 2}, {1, 1}}),
                             polyline({{0, 0}, {4, 0}, {4, 1}, {2, 0}, {-1, 0}})}) {
    const auto found = SC::self_intersections(curve);
    EXPECT_EQ(found.count(Kind::OVERLAP), 1u);
    EXPECT_TRUE(found.is_complete());
  }
  // The unit circle twice.
  std::vector<Point> points;
  std::vector<R> weights;
  const int x[] = {1, 1, 0, -1, -1, -1, 0, 1};
  for (int i = 0; i <= 16; ++i) {
    points.emplace_back(x[i % 8], x[(i + 6) % 8]);
    weights.push_back(R(i % 4 == 2 ? 2 : 1));
  }
  std::vector<R> knots{R(0)};
  for (int i = 0; i <= 8; ++i)
    knots.insert(knots.end(), 2, R(i));
  knots.push_back(R(8));
  const auto twice = SC::self_intersections(Curve(2, knots, points, weights));
  EXPECT_EQ(twice.count(Kind::OVERLAP), twice.size());
  ASSERT_EQ(twice.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const int begin = static_cast<int>(i);
    EXPECT_EQ(twice[i].parameter_range(0), std::make_pair(R(begin), R(begin + 1)));
    EXPECT_EQ(twice[i].parameter_range(1), std::make_pair(R(begin + 4), R(begin + 5)));
  }
  // A parabola there and back, turning inside of a piece.
  const auto back =
      SC::self_intersections(polynomial_curve({R(0), R(0), R(1)}, {R(0), R(0), R(0), R(0), R(1)}, R(-1), R(1) / R(3)));
  EXPECT_GT(back.count(Kind::OVERLAP), 0u);
  EXPECT_EQ(back.count(Kind::OVERLAP) + back.count(Kind::UNDECIDED), back.size());
}

TEST(Self_intersections, RestingInAPoint)
{
  const auto found = SC::self_intersections(polyline({{0, 0}, {2, 2}, {2, 2}, {2, 0}, {0, 2}}));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].kind(), Kind::TRANSVERSAL);
  EXPECT_EQ(found[1].kind(), Kind::OVERLAP);
  EXPECT_EQ(found[1].parameter_range(0), std::make_pair(R(1), R(2)));
  EXPECT_EQ(found[1].parameter_range(1), std::make_pair(R(1), R(2)));
}

TEST(Self_intersections, ContactsAndCorners)
{
  const Curve arcs(2, {R(0), R(0), R(0), R(1), R(1), R(2), R(2), R(3), R(3), R(3)},
                   {{-1, 1}, {0, -1}, {1, 1}, {5, 0}, {-1, -1}, {0, 1}, {1, -1}});
  const auto contact = SC::self_intersections(arcs);   // two parabolas, and a way between
  EXPECT_TRUE(contact.is_complete());
  ASSERT_EQ(contact.count(Kind::TANGENT), 1u);
  const auto& answer =
      *std::find_if(contact.begin(), contact.end(), [](const auto& x) { return x.kind() == Kind::TANGENT; });
  EXPECT_NEAR(answer.parameter(0), 0.5, 1e-13);
  EXPECT_NEAR(answer.parameter(1), 2.5, 1e-13);
  EXPECT_EQ(answer.multiplicity(), 2);

  // a corner on a segment
  expect_pairs(polyline({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}}), {{0.5, 3}}, Kind::TANGENT);
  // a knot on a segment, no corner
  expect_pairs(polyline({{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, -2}}), {{0.5, 3}});
  expect_pairs(polyline({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 0}}), {{0.5, 4}}, Kind::END_POINT);
}

TEST(Self_intersections, ATriplePointIsThreePairs)
{
  expect_pairs(polyline({{-2, 0}, {2, 0}, {2, 2}, {-2, -2}, {0, -2}, {0, 2}}), {{0.5, 2.5}, {0.5, 4.5}, {2.5, 4.5}});
}

// All common points of each two segments, in exact parameters; those of successive ones but their common end.
struct Segment_pairs
{
  std::vector<std::pair<R, R>> points;
  std::size_t overlaps = 0;
};

Segment_pairs all_pairs_of_segments(const std::vector<Point>& points)
{
  Segment_pairs result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (std::size_t j = i + 1; j + 1 < points.size(); ++j) {
      if (!CGAL::do_intersect(Exact_cartesian::Segment_2(points[i], points[i + 1]),
                              Exact_cartesian::Segment_2(points[j], points[j + 1])))
        continue;
      const Exact_cartesian::Vector_2 a = points[i + 1] - points[i], b = points[j + 1] - points[j],
                                      c = points[j] - points[i];
      R determinant = CGAL::determinant(a, b), u, v;
      if (determinant != 0) {
        u = R(CGAL::determinant(c, b) / determinant);
        v = R(CGAL::determinant(c, a) / determinant);
      } else {   // on one line: from and to where on the first one
        const R from(c * a / (a * a)), to((c + b) * a / (a * a)), begin((std::max)(R(0), (std::min)(from, to))),
            end((std::min)(R(1), (std::max)(from, to)));
        if (begin < end) {
          ++result.overlaps;
          continue;
        }
        u = begin;
        v = R((begin - from) / (to - from));
      }
      if (const std::pair<R, R> pair(u + R(static_cast<int>(i)), v + R(static_cast<int>(j))); pair.first != pair.second)
        result.points.push_back(pair);
    }
  std::sort(result.points.begin(), result.points.end());
  result.points.erase(std::unique(result.points.begin(), result.points.end()), result.points.end());
  return result;
}

// On a small grid corners lie on segments and on corners, and segments on each other.
TEST(Self_intersections, OfRandomPolylinesAreThoseOfAllPairsOfSegments)
{
  std::mt19937 generator(11);
  std::size_t points_found = 0, overlaps_found = 0;
  for (const int size : {4, 4, 6, 6, 10, 10, 1000, 1000}) {
    std::uniform_int_distribution<int> coordinate(0, size);
    std::vector<Point> points{{0, 0}};
    while (points.size() < 16)
      if (const Point p(coordinate(generator), coordinate(generator)); p != points.back())
        points.push_back(p);
    if (points.back() == points.front())
      continue;
    const Segment_pairs expected = all_pairs_of_segments(points);
    const auto found = SC::self_intersections(polyline(points));
    EXPECT_TRUE(found.is_complete());
    EXPECT_EQ(found.count(Kind::OVERLAP), expected.overlaps);
    const auto holds = [](const auto& answer, const std::pair<R, R>& pair) {
      const auto is_in = [](const R& x, const auto& range) { return range.first <= x && x <= range.second; };
      return is_in(pair.first, answer.parameter_range(0)) && is_in(pair.second, answer.parameter_range(1));
    };
    for (const auto& pair : expected.points) {
      const auto number = std::count_if(found.begin(), found.end(), [&](const auto& answer) {
        return answer.kind() != Kind::OVERLAP && holds(answer, pair);
      });
      const bool is_on_overlap = std::any_of(found.begin(), found.end(), [&](const auto& answer) {
        return answer.kind() == Kind::OVERLAP && holds(answer, pair);
      });
      EXPECT_TRUE(number == 1 || (number == 0 && is_on_overlap));
    }
    for (const auto& answer : found)
      if (answer.kind() != Kind::OVERLAP) {
        ++points_found;
        EXPECT_TRUE(std::any_of(expected.points.begin(), expected.points.end(),
                                [&](const auto& pair) { return holds(answer, pair); }));
      }
    overlaps_found += expected.overlaps;
  }
  EXPECT_GT(points_found, 100u);
  EXPECT_GT(overlaps_found, 3u);
}

// Against each two Bezier pieces, and each piece alone.
TEST(Self_intersections, OfRandomSplinesAreThoseOfAllPairsOfPieces)
{
  std::mt19937 generator(3);
  std::uniform_int_distribution<int> coordinate(0, 100);
  std::size_t all = 0;
  for (int k = 0; k < 6; ++k) {
    std::vector<Point> points;
    std::vector<R> knots{R(0), R(0), R(0)}, weights;
    for (int i = 0; i < 8; ++i) {
      points.emplace_back(coordinate(generator), coordinate(generator));
      weights.push_back(R(k % 2 == 0 ? 1 : 1 + coordinate(generator) % 4));
    }
    for (int i = 0; i <= 5; ++i)
      knots.push_back(R(i));
    knots.insert(knots.end(), 3, R(5));
    const Curve curve(3, knots, points, weights);
    std::size_t expected = 0;
    for (int i = 0; i < 5; ++i) {
      const Curve piece = curve.restricted(R(i), R(i + 1));
      expected += SC::self_intersections(piece).size();
      for (int j = i + 1; j < 5; ++j)
        for (const auto& answer : SC::intersections(piece, curve.restricted(R(j), R(j + 1))))
          expected += answer.is_at_end(0) && answer.is_at_end(1) && j == i + 1 ? 0 : 1;
    }
    const auto found = SC::self_intersections(curve);
    EXPECT_TRUE(found.is_complete());
    EXPECT_EQ(found.count(Kind::TRANSVERSAL), expected);
    EXPECT_EQ(found.size(), expected);
    all += expected;

    // Turned, sheared and run through backwards.
    std::vector<Point> images;
    for (const Point& p : points)
      images.emplace_back(R(3 * p.x() - 4 * p.y() + 7), R(4 * p.x() + 5 * p.y() - 2));
    const auto of_image = SC::self_intersections(Curve(3, knots, images, weights).reversed());
    ASSERT_EQ(of_image.size(), found.size());
    for (const auto& answer : found)
      EXPECT_EQ(std::count_if(of_image.begin(), of_image.end(),
                              [&](const auto& other) {
                                return std::abs(other.parameter(0) + answer.parameter(1) - 5) < 1e-12 &&
                                    std::abs(other.parameter(1) + answer.parameter(0) - 5) < 1e-12;
                              }),
                1);
  }
  EXPECT_GT(all, 6u);
}

// Curves that run over themselves are named, where that explains an answer, and not elsewhere.
TEST(Self_intersections, RemarksOnRepeatedParts)
{
  const std::string twice = "traces itself 2 times: use proper_reparametrization()";
  const std::vector<std::string> of_curve{"the curve " + twice}, of_operands{"operand 0 " + twice};
  const Curve parabola = polynomial_curve({0, 0, 1}, {0, 0, 0, 0, 1}, R(-1), R(1));
  EXPECT_EQ(SC::self_intersections(parabola).remarks(), of_curve);
  EXPECT_EQ(SC::intersections(parabola, polynomial_curve({0, 1}, {0, 0, 1}, R(0), R(1))).remarks(), of_operands);
  // a segment that crosses it: two common points at one place, and nothing to explain
  EXPECT_TRUE(SC::intersections(parabola, polynomial_curve({0, 1}, {1, -1}, R(0), R(1))).remarks().empty());
  // folds at irrational parameters: x is t^3 - 2 t and y its square
  const auto folded = SC::self_intersections(polynomial_curve({0, -2, 0, 1}, {0, 0, 4, 0, -4, 0, 1}, R(-1), R(1)));
  EXPECT_EQ(folded.remarks(), of_curve);
  ASSERT_FALSE(folded.undecided().empty());
  for (const SC::Undecided_part& part : folded.undecided())
    EXPECT_TRUE(part.reason.ends_with("; the curve " + twice)) << part;
  // a run that was ended explains itself
  const auto stopped = SC::self_intersections(parabola, {.time_limit = 1e-9});
  EXPECT_FALSE(stopped.is_complete());
  EXPECT_TRUE(stopped.remarks().empty());
  // edges that overlap, and are not one curve twice
  const Curve edge = polynomial_curve({0, 1}, {0}, R(0), R(2)), longer = polynomial_curve({1, 1}, {0}, R(0), R(2));
  EXPECT_EQ(SC::intersections(edge, longer).count(Kind::OVERLAP), 1u);
  EXPECT_TRUE(SC::intersections(edge, longer).remarks().empty());
  EXPECT_TRUE(SC::self_intersections(nodal_cubic).remarks().empty());
}

TEST(Self_intersections, BadInput)
{
  EXPECT_THROW(SC::self_intersections(nodal_cubic, {.tolerance = -1}), SC::Invalid_input);
}

} // namespace

} // namespace self_intersections_test
