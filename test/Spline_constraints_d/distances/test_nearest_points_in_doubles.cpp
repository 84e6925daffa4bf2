// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closest points that are found in doubles with error bounds, beside those of the exact way.

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace nearest_points_in_doubles_test {

namespace SC = CGAL::Spline_constraints;
using namespace SC::internal::Distances;
using K = CGAL::Simple_cartesian<double>;

template <int d>
using Point = typename SC::internal::Ambient_space<K, d>::Point;

// Random operands, with coordinates that are small integers or any doubles.
class Inputs
{
  std::mt19937 m_random;
  double m_scale, m_offset;
  bool m_are_integers;

public:
  Inputs(unsigned seed, bool are_integers, double scale = 1, double offset = 0)
    : m_random(seed), m_scale(scale), m_offset(offset), m_are_integers(are_integers)
  {}

  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_random); }
  double coordinate()
  {
    return m_offset + m_scale * (m_are_integers ? integer(-6, 6) : std::uniform_real_distribution<>(-6, 6)(m_random));
  }

  template <int d>
  Point<d> point()
  {
    if constexpr (d == 2) {
      const double x = coordinate(), y = coordinate();
      return Point<2>(x, y);
    } else {
      const double x = coordinate(), y = coordinate(), z = coordinate();
      return Point<3>(x, y, z);
    }
  }

  // Clamped, with knots of any multiplicity inside.
  std::vector<double> knots(int degree, int pieces)
  {
    std::vector<double> result(degree + 1, 0.0);
    double at = 0;
    for (int piece = 1; piece < pieces; ++piece) {
      at += m_are_integers ? integer(1, 2) : 0.1 * integer(1, 9);
      result.insert(result.end(), integer(1, degree), at);
    }
    result.insert(result.end(), degree + 1, at + 1);
    return result;
  }

  std::vector<double> weights(std::size_t size, bool is_rational)
  {
    std::vector<double> result;
    for (std::size_t i = 0; is_rational && i < size; ++i)
      result.push_back(integer(1, 4));
    return result;
  }

  template <int d>
  SC::Bspline_curve<K, d> curve(int degree, int pieces, bool is_rational, bool is_closed = false)
  {
    const std::vector<double> all = knots(degree, pieces);
    std::vector<Point<d>> points;
    while (points.size() + degree + 1 < all.size())
      points.push_back(point<d>());
    std::vector<double> weight = weights(points.size(), is_rational);
    if (is_closed) {
      points.back() = points.front();
      if (is_rational)
        weight.back() = weight.front();
    }
    return {degree, all, points, weight};
  }

  SC::Bspline_surface_3<K> surface(int degree, int pieces, bool is_rational)
  {
    const std::vector<double> first = knots(degree, pieces), second = knots(degree, pieces);
    const std::size_t size = (first.size() - degree - 1) * (second.size() - degree - 1);
    std::vector<Point<3>> points;
    while (points.size() < size)
      points.push_back(point<3>());
    return {{degree, degree}, first, second, points, weights(size, is_rational)};
  }
};

struct Counts
{
  int inputs = 0, decided = 0;
};

// Both points of a pair are those of the operands at its parameters, but for rounding, and as far from each other as it
// says.
template <int d>
void expect_points(const Located_distance<d>& pair, const SC::internal::Common::Exact_map<d>& a,
                   const SC::internal::Common::Exact_map<d>& b, const std::string& what)
{
  std::array<std::array<double, d>, 2> points{};
  std::visit(
      [&](const auto& known) {
        for (const std::size_t operand : {0, 1})
          for (int i = 0; i < d; ++i)
            points[operand][i] = CGAL::to_double(known[operand][i]);
      },
      pair.points);
  const std::array maps{&a, &b};
  double square = 0;
  for (int i = 0; i < d; ++i)
    square += (points[0][i] - points[1][i]) * (points[0][i] - points[1][i]);
  double size = 0;
  for (const std::size_t operand : {0, 1}) {
    std::vector<SC::Exact_rational> sample;
    for (const Located_parameter& parameter : pair.parameters[operand])
      sample.push_back(parameter.sample.exact());
    const auto exact = SC::internal::Common::Spline_patch<d>(*maps[operand])(sample);
    for (int i = 0; i < d; ++i) {
      size = std::max({size, std::abs(points[0][i]), std::abs(points[1][i])});
      EXPECT_NEAR(points[operand][i], CGAL::to_double(exact[i]), 1e-10 * (size + 1)) << what;
    }
  }
  EXPECT_NEAR(square, pair.squared_distance.second.nearest(), 1e-10 * (size + 1) * (size + 1)) << what;
}

using Range = std::pair<SC::internal::Deferred_rational, SC::internal::Deferred_rational>;

bool meet(const Range& a, const Range& b)
{
  return a.first.exact() <= b.second.exact() && b.first.exact() <= a.second.exact();
}

template <int d>
bool is_same(const Located_distance<d>& a, const Located_distance<d>& b)
{
  const auto do_meet = [](const Located_parameter& x, const Located_parameter& y) {
    return meet({x.lower, x.upper}, {y.lower, y.upper});
  };
  for (const std::size_t operand : {0, 1})
    if (!std::equal(a.parameters[operand].begin(), a.parameters[operand].end(), b.parameters[operand].begin(),
                    b.parameters[operand].end(), do_meet))
      return false;
  return true;
}

// Where doubles decide, the answers are those of the exact way: none is lost, none is more.
template <int d, class A, class B>
void compare(const A& a, const B& b, Counts& counts, const std::string& what)
{
  ++counts.inputs;
  const auto found = nearest_points_in_doubles(Distance_operand_of<A>::get(a), Distance_operand_of<B>::get(b), {});
  if (!found)
    return;
  ++counts.decided;
  using namespace SC::internal::Common;
  const auto exact = nearest_points_of<d>(Spline_operand<A>::map(a), Spline_operand<B>::map(b), {});
  ASSERT_FALSE(found->pairs.empty()) << what;
  EXPECT_LE(found->squared_distance.first.exact(), found->squared_distance.second.exact()) << what;
  EXPECT_TRUE(meet(found->squared_distance, exact.squared_distance)) << what;
  if (!exact.summary.is_complete)
    return;
  EXPECT_EQ(found->pairs.size(), exact.pairs.size()) << what;
  for (const auto& pair : exact.pairs)
    EXPECT_TRUE(std::any_of(found->pairs.begin(), found->pairs.end(), [&](const auto& x) {
      return is_same<d>(x, pair);
    })) << what;
  for (const auto& pair : found->pairs) {
    expect_points<d>(pair, Spline_operand<A>::map(a), Spline_operand<B>::map(b), what);
    EXPECT_EQ(pair.kind, SC::Solution_kind::CERTIFIED);
    for (const std::size_t operand : {0, 1})
      for (const Located_parameter& x : pair.parameters[operand])
        EXPECT_TRUE(x.lower.exact() <= x.sample.exact() && x.sample.exact() <= x.upper.exact()) << what;
  }
}

// The same of all feet of perpendiculars.
template <int d, class A>
void compare_feet(const Point<d>& p, const A& a, Counts& counts, const std::string& what)
{
  ++counts.inputs;
  const auto found = projections_in_doubles(Distance_operand_of<Point<d>>::get(p), Distance_operand_of<A>::get(a), {});
  if (!found)
    return;
  ++counts.decided;
  using namespace SC::internal::Common;
  const auto exact = projections_of<d>(Spline_operand<Point<d>>::map(p), Spline_operand<A>::map(a), {});
  if (!exact.summary.is_complete)
    return;
  ASSERT_EQ(found->pairs.size(), exact.pairs.size()) << what;
  for (const auto& pair : found->pairs)
    expect_points<d>(pair, Spline_operand<Point<d>>::map(p), Spline_operand<A>::map(a), what);
  for (const auto& pair : exact.pairs)
    EXPECT_TRUE(std::any_of(found->pairs.begin(), found->pairs.end(), [&](const auto& x) {
      return is_same<d>(x, pair) && meet(x.squared_distance, pair.squared_distance);
    })) << what;
}

template <int d>
void compare_all(Inputs inputs, int rounds, Counts& counts)
{
  for (int round = 0; round < rounds; ++round) {
    const std::string what = " in round " + std::to_string(round);
    const int degree = inputs.integer(1, 4), pieces = inputs.integer(1, 3);
    const bool is_rational = round % 3 == 1, is_closed = round % 4 == 2;
    const auto curve = inputs.curve<d>(degree, pieces, is_rational, is_closed),
               other = inputs.curve<d>(inputs.integer(1, 3), inputs.integer(1, 2), round % 5 == 1);
    compare<d>(inputs.point<d>(), curve, counts, "point and curve" + what);
    compare<d>(curve, inputs.point<d>(), counts, "curve and point" + what);
    compare<d>(curve, other, counts, "curves" + what);
    if constexpr (d == 3)
      if (round % 4 == 0)
        compare<d>(inputs.point<d>(), inputs.surface(inputs.integer(1, 2), inputs.integer(1, 2), is_rational), counts,
                   "point and surface" + what);
  }
}

TEST(Nearest_points_in_doubles, AreThoseOfTheExactWay)
{
  Counts plane, space;
  compare_all<2>(Inputs(1, true), 60, plane);
  compare_all<2>(Inputs(2, false), 40, plane);
  compare_all<3>(Inputs(3, true), 40, space);
  compare_all<3>(Inputs(4, false), 40, space);
  // Many curves in the plane cross, which is for exact numbers to decide.
  EXPECT_GT(plane.decided, plane.inputs / 2);
  EXPECT_GT(space.decided, space.inputs * 9 / 10);
}

template <int d>
void compare_all_feet(Inputs inputs, int rounds, Counts& counts)
{
  for (int round = 0; round < rounds; ++round) {
    const std::string what = "round " + std::to_string(round);
    const bool is_rational = round % 3 == 1;
    compare_feet<d>(inputs.point<d>(), inputs.curve<d>(inputs.integer(1, 5), inputs.integer(1, 3), is_rational), counts,
                    what);
    if constexpr (d == 3)
      if (round % 2 == 0)
        compare_feet<d>(inputs.point<d>(), inputs.surface(inputs.integer(1, 2), inputs.integer(1, 2), is_rational),
                        counts, what);
  }
}

TEST(Nearest_points_in_doubles, FeetAreThoseOfTheExactWay)
{
  Counts plane, space;
  compare_all_feet<2>(Inputs(9, true), 60, plane);
  compare_all_feet<2>(Inputs(10, false), 40, plane);
  compare_all_feet<3>(Inputs(11, true), 20, space);
  compare_all_feet<3>(Inputs(12, false), 30, space);
  EXPECT_GT(plane.decided, plane.inputs * 7 / 10);
  EXPECT_GT(space.decided, space.inputs * 7 / 10);
}

TEST(Nearest_points_in_doubles, FarFromTheOriginAndSmall)
{
  Counts counts;
  compare_all<3>(Inputs(5, false, 1e-6), 12, counts);
  compare_all<3>(Inputs(6, false, 1e6), 12, counts);
  compare_all<3>(Inputs(7, false, 1, 1e5), 12, counts);
  EXPECT_GT(counts.decided, counts.inputs * 8 / 10);
}

// A point that is a thousand times as far away as the curve is long.
TEST(Nearest_points_in_doubles, FarFromTheCurve)
{
  Inputs inputs(8, false);
  Counts counts;
  for (int round = 0; round < 20; ++round) {
    const auto p = inputs.point<3>();
    compare<3>(Point<3>(1e4 * p.x(), 1e4 * p.y(), 1e4 * p.z()), inputs.curve<3>(3, 2, round % 2 == 0), counts,
               "round " + std::to_string(round));
  }
  EXPECT_GT(counts.decided, counts.inputs / 2);
}

// Nearest points on a break where the curve is smooth, at a corner, and at the seam of a closed curve.
TEST(Nearest_points_in_doubles, AtBreaks)
{
  const SC::Bspline_curve_2<K> corner(1, {0, 0, 1, 2, 2}, {{-1, 1}, {0, 0}, {1, 1}});
  Counts counts;
  compare<2>(Point<2>(0, -1), corner, counts, "a corner");
  const SC::Bspline_curve_2<K> square(1, {0, 0, 1, 2, 3, 4, 4}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}});
  compare<2>(Point<2>(-1, -1), square, counts, "the seam");
  compare<2>(Point<2>(2, 2), square, counts, "another corner");
  EXPECT_EQ(counts.decided, 3);
  const auto found = nearest_points_in_doubles(Distance_operand_of<Point<2>>::get(Point<2>(-1, -1)),
                                               Distance_operand_of<SC::Bspline_curve_2<K>>::get(square), {});
  ASSERT_TRUE(found);
  ASSERT_EQ(found->pairs.size(), 1u);
  EXPECT_EQ(found->pairs[0].parameters[1][0].upper.exact(), 0);
  EXPECT_EQ(found->squared_distance.first.exact(), 2);
  EXPECT_EQ(found->squared_distance.second.exact(), 2);
}

// The centre of a circle is as far from all of its points: nothing is decided, in a short time.
TEST(Nearest_points_in_doubles, NothingIsDecidedOfAContinuum)
{
  const SC::Bspline_curve_2<K> quarter(2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2});
  EXPECT_FALSE(nearest_points_in_doubles(Distance_operand_of<Point<2>>::get(Point<2>(0, 0)),
                                         Distance_operand_of<SC::Bspline_curve_2<K>>::get(quarter), {}));
}

} // namespace nearest_points_in_doubles_test
