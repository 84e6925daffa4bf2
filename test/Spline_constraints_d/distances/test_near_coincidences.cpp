// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Special points that nearly coincide: all pairs, with their exact distances, beside what the exact answers are.

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/distances/near_coincidences.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>
#include <vector>

namespace near_coincidences_test {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Simple_cartesian<double>;
using Kind = SC::Special_point_kind;
using SC::Exact_rational;
using Points_2 = std::vector<K::Point_2>;
using Points_3 = std::vector<K::Point_3>;

constexpr double digit = std::numeric_limits<double>::epsilon(); // at 1

SC::Bspline_surface_3<K> bilinear(const Points_3& points, std::vector<double> knots = {0, 0, 1, 1})
{
  return {{1, 1}, std::move(knots), {0, 0, 1, 1}, points};
}

TEST(Near_coincidences, CornersOfOutlines)
{
  const auto first = SC::polyline_curve(Points_2{{0, 0}, {1, 1}, {2, 0}, {0, 0}}),
             second = SC::polyline_curve(Points_2{{0, 2}, {1, 1 + digit}, {2, 2}, {0, 2}});
  EXPECT_TRUE(SC::intersections(first, second).empty());
  const auto near = SC::near_coincidences(first, second);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_TRUE(near.is_complete());
  for (const std::size_t i : {0, 1}) {
    EXPECT_EQ(near[0].object(i), i);
    EXPECT_EQ(near[0].kind(i), Kind::BREAK);
    EXPECT_EQ(near[0].parameter_range(i).first, near[0].parameter_range(i).second);
  }
  EXPECT_EQ(near[0].point(0), K::Point_2(1, 1));
  EXPECT_EQ(near[0].point(1), K::Point_2(1, 1 + digit));
  EXPECT_EQ(near[0].squared_distance(), SC::to_rational(digit * digit));
  EXPECT_EQ(near[0].distance_range(), std::pair(digit, digit));
  EXPECT_TRUE(SC::near_coincidences(first, second, digit / 2).empty());
  EXPECT_TRUE(SC::near_coincidences(first, first).empty()); // they are exactly the same
}

TEST(Near_coincidences, DecimalsNeedATolerance)
{
  const auto first = SC::polyline_curve(Points_2{{0, 0}, {33.333, 66.667}}),
             second = SC::polyline_curve(Points_2{{100.0 / 3, 200.0 / 3}, {90, 0}});
  EXPECT_TRUE(SC::near_coincidences(first, second).empty());
  const auto near = SC::near_coincidences(first, second, 1e-3);
  ASSERT_EQ(near.size(), 1u);
  EXPECT_EQ(near[0].kind(0), Kind::END);
  EXPECT_LT(0, near[0].distance_range().first);
  EXPECT_LT(near[0].distance_range().second, 1e-3);
}

TEST(Near_coincidences, OneObject)
{
  const auto nearly_closed = SC::polyline_curve(Points_2{{1, 0}, {2, 1}, {0, 1}, {1 - digit / 2, 0}}),
             closed = SC::polyline_curve(Points_2{{5, 0}, {6, 1}, {4, 1}, {5, 0}}),
             near = SC::polyline_curve(Points_2{{5 + 4 * digit, 0}, {5, -3}});
  const auto all = SC::near_coincidences(std::vector{nearly_closed, closed, near});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].object(0), 0u);
  EXPECT_EQ(all[0].object(1), 0u);
  EXPECT_EQ(all[0].kind(0), Kind::END);
  EXPECT_EQ(all[1].object(0), 1u);
  EXPECT_EQ(all[1].object(1), 2u);
  EXPECT_EQ(all[1].kind(0), Kind::SEAM);
  EXPECT_EQ(all[1].kind(1), Kind::END);
}

TEST(Near_coincidences, CornersSeamsAndPoles)
{
  const auto square = bilinear({{0, 0, 1}, {0, 1, 1}, {1, 0, 1}, {1, 1, 1}}),
             neighbour = bilinear({{1, 0, 1 + digit}, {1, 1, 1}, {2, 0, 1}, {2, 1, 1}});
  const auto corners = SC::near_coincidences(square, neighbour);
  ASSERT_EQ(corners.size(), 1u);
  EXPECT_EQ(corners[0].kind(0), Kind::CORNER);
  EXPECT_EQ(corners[0].parameter_range(0, 0).first, 1);
  EXPECT_EQ(corners[0].parameter_range(0, 1).first, 0);
  EXPECT_EQ(corners[0].parameter_range(1, 0).first, 0);

  // A pyramid: closed along the first axis, with a pole at the end of the second one.
  const K::Point_3 tip(1, 1, 4);
  const auto pyramid = bilinear({{0, 0, 0}, tip, {2, 0, 0}, tip, {1, 3, 0}, tip, {0, 0, 0}, tip}, {0, 0, 1, 2, 3, 3});
  const auto axis = SC::polyline_curve(Points_3{{1, 1, 0}, {1, 1, 4 - 4 * digit}}),
             side = SC::polyline_curve(Points_3{{digit, 0, 0}, {-1, 0, 0}}),
             edge = SC::polyline_curve(Points_3{{2, digit, 0}, {4, 0, 0}});
  const auto pole = SC::near_coincidences(pyramid, axis), seam = SC::near_coincidences(pyramid, side),
             kink = SC::near_coincidences(edge, pyramid);
  ASSERT_EQ(pole.size(), 1u);
  EXPECT_EQ(pole[0].kind(0), Kind::POLE);
  EXPECT_EQ(pole[0].parameter_range(0, 0), std::pair(Exact_rational(0), Exact_rational(3)));
  EXPECT_EQ(pole[0].parameter_range(0, 1), std::pair(Exact_rational(1), Exact_rational(1)));
  EXPECT_EQ(pole[0].distance_range().second, 4 * digit);
  ASSERT_EQ(seam.size(), 1u);
  EXPECT_EQ(seam[0].kind(0), Kind::SEAM);
  EXPECT_EQ(seam[0].parameter_range(0, 0).second, 0);
  ASSERT_EQ(kink.size(), 1u);
  EXPECT_EQ(kink[0].kind(1), Kind::BREAK);
  EXPECT_EQ(kink[0].parameter_range(1, 0).first, 1);
}

// Against all pairs of control points of polylines, which are their special points.
TEST(Near_coincidences, AreAllPairs)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<> cell(-4, 4), digits(-3, 3);
  const auto coordinate = [&] { return cell(random) + digits(random) * 2 * digit; };
  std::vector<SC::Bspline_curve_2<K>> curves;
  std::vector<Points_2> points;
  for (int i = 0; i < 60; ++i) {
    Points_2& own = points.emplace_back();
    for (int k = 0; k < 4; ++k) {
      const double x = coordinate(), y = coordinate();
      own.emplace_back(x, y);
    }
    curves.push_back(SC::polyline_curve(own));
  }
  using Place = std::tuple<std::size_t, std::size_t, Exact_rational, Exact_rational>;
  const double tolerance = 4 * digit;
  std::set<Place> expected, found;
  const auto exact = [](double x) { return SC::to_rational(x); };
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i; j < points.size(); ++j)
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = i == j ? k + 1 : 0; l < 4; ++l) {
          const K::Point_2 &p = points[i][k], &q = points[j][l];
          const Exact_rational x = exact(p.x()) - exact(q.x()), y = exact(p.y()) - exact(q.y()), square(x * x + y * y);
          const auto ends = curves[i].domain();
          const Exact_rational first = exact(ends.first), step((exact(ends.second) - first) / 3);
          if (square > 0 && square <= exact(tolerance * tolerance))
            expected.emplace(i, j, Exact_rational(first + step * static_cast<double>(k)),
                             Exact_rational(first + step * static_cast<double>(l)));
        }
  for (const auto& pair : SC::near_coincidences(curves, tolerance))
    found.emplace(pair.object(0), pair.object(1), pair.parameter_range(0).first, pair.parameter_range(1).first);
  EXPECT_GT(expected.size(), 50u);
  EXPECT_EQ(found, expected);
}

TEST(Near_coincidences, LimitsAndBadInput)
{
  const auto first = SC::polyline_curve(Points_2{{0, 0}, {1, 1}, {2, 0}}),
             second = SC::polyline_curve(Points_2{{0, 2}, {1, 1 + digit}, {2, 2}});
  SC::Solver_options options;
  options.node_limit = 2;
  const auto stopped = SC::near_coincidences(first, second, {}, options);
  EXPECT_TRUE(stopped.empty());
  EXPECT_FALSE(stopped.is_complete());
  ASSERT_EQ(stopped.undecided().size(), 2u);
  EXPECT_EQ(stopped.undecided()[1].parameters[0].operand, 1u);
  EXPECT_EQ(stopped.undecided()[0].place.size(), 2u);
  EXPECT_THROW(SC::near_coincidences(first, second, -1.0), SC::Invalid_input);
  EXPECT_THROW(SC::near_coincidences(first, second, std::nan("")), SC::Invalid_input);
}

} // namespace near_coincidences_test
