// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Inflections, vertices and extreme points of planar curves with known answers.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/curve_features_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace curve_features_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using Kind = SC::Curve_feature_kind;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;
using Points = std::vector<K::Point_2>;
using Answers = std::vector<std::pair<Kind, double>>;

Answers answers(const SC::Curve_features_2<K>& result)
{
  EXPECT_TRUE(result.summary().is_complete);
  Answers answers;
  for (const auto& feature : result.features())
    answers.emplace_back(feature.kind(), std::round(feature.point_on_curve().parameter() * 1e12) / 1e12);
  return answers;
}

// The graph of a polynomial with the coefficients of its powers, over [-1,1] as the parameter.
Curve graph(std::vector<int> coefficients)
{
  const int degree = static_cast<int>(coefficients.size()) - 1;
  const SC::Bernstein_tensor<Exact_rational> y = SC::Bernstein_tensor<Exact_rational>::from_power_on_box(
      {degree}, {coefficients.begin(), coefficients.end()},
      std::vector<std::pair<Exact_rational, Exact_rational>>{{-1, 1}});
  Points points;
  for (int i = 0; i <= degree; ++i)
    points.emplace_back(K::FT(-1) + K::FT(2 * i) / degree, K::FT(y.coefficients()[i]));
  return SC::bezier_curve(points).with_domain(K::FT(-1), K::FT(1));
}

TEST(Curve_features_2, InflectionsOfGraphs)
{
  EXPECT_EQ(answers(SC::inflections(graph({0, 0, 0, 1}))), (Answers{{Kind::INFLECTION, 0}}));
  EXPECT_EQ(answers(SC::inflections(graph({0, 0, 0, 0, 1}))), (Answers{{Kind::STATIONARY, 0}}));
  EXPECT_TRUE(SC::inflections(graph({0, 0, 1})).features().empty());
  // y = x^4 - x^2 + x with y'' = 12 x^2 - 2.
  EXPECT_EQ(answers(SC::inflections(graph({0, 1, -1, 0, 1}))),
            (Answers{{Kind::INFLECTION, -0.408248290464}, {Kind::INFLECTION, 0.408248290464}}));
}

TEST(Curve_features_2, StraightAndSingular)
{
  const auto straight = SC::inflections(SC::segment_curve(K::Point_2(0, 0), K::Point_2(2, 1)));
  ASSERT_EQ(answers(straight), (Answers{{Kind::CONSTANT, 0.5}}));
  EXPECT_TRUE(straight.features()[0].is_family());
  EXPECT_EQ(straight.features()[0].point_on_curve().parameter_range(),
            (std::pair<Exact_rational, Exact_rational>(0, 1)));
  EXPECT_EQ(answers(SC::inflections(SC::polyline_curve(Points{{0, 0}, {1, 1}, {2, 0}}))),
            (Answers{{Kind::CONSTANT, 0.5}, {Kind::BREAK, 1}, {Kind::CONSTANT, 1.5}}));

  // Straight over a break without a corner: one piece.
  EXPECT_EQ(answers(SC::inflections(SC::polyline_curve(Points{{0, 0}, {1, 1}, {3, 3}}))),
            (Answers{{Kind::CONSTANT, 1}}));

  // The cusp of (t^2, t^3).
  const Curve cusp = SC::bezier_curve(Points{{1, -1}, {K::FT(-1) / 3, 1}, {K::FT(-1) / 3, -1}, {1, 1}});
  EXPECT_EQ(answers(SC::inflections(cusp)), (Answers{{Kind::SINGULAR, 0.5}}));
  EXPECT_EQ(SC::curvature_extremes(cusp).count(Kind::SINGULAR), 1u);
}

TEST(Curve_features_2, VerticesOfAnEllipse)
{
  const Curve ellipse = SC::ellipse_curve(K::Point_2(1, 2), K::Vector_2(3, 0), K::Vector_2(0, 2));
  const auto vertices = SC::curvature_extremes(ellipse);
  EXPECT_EQ(answers(vertices),
            (Answers{{Kind::MAXIMUM, 0}, {Kind::MINIMUM, 1}, {Kind::MAXIMUM, 2}, {Kind::MINIMUM, 3}}));
  EXPECT_EQ(vertices.features()[1].point_on_curve().point(), K::Point_2(1, 4));
  EXPECT_TRUE(SC::inflections(ellipse).features().empty());

  // Parts of it, with two and three vertices inside.
  EXPECT_EQ(answers(SC::curvature_extremes(ellipse.restricted(K::FT(1) / 2, K::FT(5) / 2))),
            (Answers{{Kind::MINIMUM, 1}, {Kind::MAXIMUM, 2}}));
  EXPECT_EQ(answers(SC::curvature_extremes(ellipse.restricted(K::FT(1), K::FT(3)))),
            (Answers{{Kind::STATIONARY, 1}, {Kind::MAXIMUM, 2}, {Kind::STATIONARY, 3}}));
}

TEST(Curve_features_2, CircleIsAFamily)
{
  const auto vertices = SC::curvature_extremes(SC::circle_curve(K::Point_2(0, 0), K::FT(5)));
  ASSERT_EQ(answers(vertices), (Answers{{Kind::CONSTANT, 2}}));
  EXPECT_TRUE(vertices.features()[0].is_family());
  EXPECT_EQ(vertices.features()[0].point_on_curve().parameter_range(),
            (std::pair<Exact_rational, Exact_rational>(0, 4)));
}

// Quadratic pieces have no inflection inside; a zigzag of control points makes the curvature change its sign at the
// knots, where it jumps.
TEST(Curve_features_2, FeaturesAtBreaks)
{
  const Curve zigzag(2, {0, 0, 0, 1, 2, 2, 2}, Points{{0, 0}, {1, 2}, {3, -2}, {4, 0}});
  const auto result = SC::inflections(zigzag);
  EXPECT_EQ(answers(result), (Answers{{Kind::INFLECTION, 1}}));
  EXPECT_TRUE(result.features()[0].is_at_break() && result.features()[0].solutions().empty());
  EXPECT_EQ(SC::curvature_extremes(zigzag).count(Kind::BREAK), 1u);

  // A corner of a closed curve at its seam.
  const auto corner = SC::inflections(SC::bezier_curve(Points{{0, 0}, {3, 3}, {-3, 3}, {0, 0}}));
  EXPECT_EQ(answers(corner), (Answers{{Kind::BREAK, 0}}));
}

// What is at the seam of a closed curve is seen from both sides.
TEST(Curve_features_2, Seams)
{
  // The seam is in the middle of the lower side of a square.
  const Curve square = SC::polyline_curve(Points{{1, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}, {1, 0}});
  const auto heights = SC::extreme_points(square, K::Vector_2(0, 1));
  EXPECT_EQ(answers(heights), (Answers{{Kind::MINIMUM, 0.5}, {Kind::MAXIMUM, 2.5}, {Kind::MINIMUM, 4.5}}));
  for (const auto& feature : heights.features())
    EXPECT_TRUE(feature.is_family() && CGAL::certainly(feature.is_global()));
  const auto turns = SC::inflections(square);
  EXPECT_TRUE(turns.count(Kind::CONSTANT) == 5 && turns.count(Kind::BREAK) == 4 && turns.features().size() == 9);
  EXPECT_EQ(answers(SC::extreme_points(square, K::Vector_2(1, 1))), (Answers{{Kind::MAXIMUM, 2}, {Kind::MINIMUM, 4}}));

  // Quadratic pieces that turn to the left and to the right: an inflection on each knot.
  std::vector<K::FT> period;
  for (int i = 0; i <= 8; ++i)
    period.push_back(K::FT(i));
  const Curve star =
      Curve::from_periodic(2, period, Points{{0, 0}, {2, 1}, {4, 0}, {3, 2}, {4, 4}, {2, 3}, {0, 4}, {1, 2}});
  const auto inflections = answers(SC::inflections(star));
  ASSERT_EQ(inflections.size(), 8u);
  for (int i = 0; i < 8; ++i)
    EXPECT_EQ(inflections[i], std::pair(Kind::INFLECTION, static_cast<double>(i)));
}

TEST(Curve_features_2, ExtremePoints)
{
  const auto circle = SC::extreme_points(SC::circle_curve(K::Point_2(0, 0), K::FT(5)), K::Vector_2(1, 0));
  EXPECT_EQ(answers(circle), (Answers{{Kind::MAXIMUM, 0}, {Kind::MINIMUM, 2}}));
  EXPECT_TRUE(CGAL::certainly(circle.features()[0].is_global()) && CGAL::certainly(circle.features()[1].is_global()));

  const auto cubic = SC::extreme_points(graph({0, 0, 0, 1}), K::Vector_2(0, 1));
  EXPECT_EQ(answers(cubic), (Answers{{Kind::MINIMUM, -1}, {Kind::STATIONARY, 0}, {Kind::MAXIMUM, 1}}));

  // A plateau between corners, and a lower peak.
  const auto plateau = SC::extreme_points(SC::polyline_curve(Points{{0, 0}, {1, 1}, {2, 1}, {3, -1}, {4, 0}, {5, -1}}),
                                          K::Vector_2(0, 2));
  EXPECT_EQ(
      answers(plateau),
      (Answers{{Kind::MINIMUM, 0}, {Kind::MAXIMUM, 1.5}, {Kind::MINIMUM, 3}, {Kind::MAXIMUM, 4}, {Kind::MINIMUM, 5}}));
  const std::vector<bool> is_global{false, true, true, false, true};
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_TRUE(CGAL::certainly(plateau.features()[i].is_global() == is_global[i])) << i;

  const auto level = SC::extreme_points(SC::segment_curve(K::Point_2(0, 0), K::Point_2(2, 0)), K::Vector_2(0, 1));
  ASSERT_EQ(level.features().size(), 1u);
  EXPECT_TRUE(level.features()[0].kind() == Kind::CONSTANT && CGAL::certainly(level.features()[0].is_global()));
  EXPECT_THROW(SC::extreme_points(graph({0, 1}), K::Vector_2(0, 0)), SC::Invalid_input);
}

// y = -x^2 (1 - 2x^2)^2 is zero, its maximum, at zero and at two irrational places; with x/10^9 added, at one of them.
TEST(Curve_features_2, Ties)
{
  const auto global = [](const SC::Curve_features_2<K>& result, Kind kind) {
    return std::count_if(result.features().begin(), result.features().end(), [=](const auto& feature) {
      EXPECT_TRUE(feature.is_global().is_certain());
      return feature.kind() == kind && CGAL::certainly(feature.is_global());
    });
  };
  const Curve tie = graph({0, 0, -1, 0, 4, 0, -4});
  EXPECT_EQ(SC::extreme_points(tie, K::Vector_2(0, 1)).count(Kind::MAXIMUM), 3u);
  EXPECT_EQ(global(SC::extreme_points(tie, K::Vector_2(0, 1)), Kind::MAXIMUM), 3);
  EXPECT_EQ(global(SC::extreme_points(tie, K::Vector_2(0, -1)), Kind::MINIMUM), 3);
  EXPECT_EQ(global(SC::extreme_points(tie, K::Vector_2(K::FT(1) / K::FT(1e9), 1)), Kind::MAXIMUM), 1);
  EXPECT_EQ(global(SC::extreme_points(tie.with_knot(K::FT(1) / 3), K::Vector_2(0, 1)), Kind::MAXIMUM), 3);

  // Two arches, mirror images of each other, with irrational maxima.
  const Curve arches(3, {0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2},
                     Points{{0, 0}, {1, 3}, {2, 1}, {4, 0}, {6, 1}, {7, 3}, {8, 0}});
  EXPECT_EQ(global(SC::extreme_points(arches, K::Vector_2(0, 1)), Kind::MAXIMUM), 2);
  const Curve ellipse = SC::ellipse_curve(K::Point_2(1, 2), K::Vector_2(3, 0), K::Vector_2(0, 2));
  EXPECT_EQ(global(SC::extreme_points(ellipse, K::Vector_2(1, 3)), Kind::MAXIMUM), 1);
}

// Between two samples there is an odd number of inflections exactly if the curvature has different signs there.
TEST(Curve_features_2, RandomCurves)
{
  std::mt19937 random(11);
  const auto number = [&](int range) { return static_cast<int>(random() % (2 * range + 1)) - range; };
  std::size_t found = 0;
  for (int round = 0; round < 12; ++round) {
    const int degree = 3 + round % 3;
    std::vector<K::FT> knots(degree + 1, K::FT(0)), weights;
    for (int k = 1; k < 3; ++k)
      knots.push_back(K::FT(k));
    knots.insert(knots.end(), degree + 1, K::FT(3));
    Points points;
    for (int i = 0; i < degree + 3; ++i) {
      points.emplace_back(number(20), number(20));
      if (round % 2 == 1)
        weights.push_back(K::FT(1 + static_cast<int>(random() % 3)));
    }
    const Curve curve(degree, knots, points, weights);
    const auto result = SC::inflections(curve);
    EXPECT_TRUE(result.summary().is_complete);
    constexpr int samples = 200;
    std::vector<int> count(samples, 0);
    for (const auto& feature : result.features())
      if (feature.kind() == Kind::INFLECTION) {
        ++found;
        ++count[static_cast<int>(std::floor(feature.point_on_curve().parameter() / 3 * samples))];
      }
    const auto turns_left = [&](int i) { return curve.curvature(K::FT(3 * i) / samples) > 0; };
    for (int i = 0; i < samples; ++i)
      EXPECT_EQ(count[i] % 2 == 1, turns_left(i) != turns_left(i + 1)) << round << ' ' << i;

    const K::Vector_2 direction(number(5), 7);
    double highest = -1e300;
    for (int i = 0; i <= samples; ++i)
      highest = std::max(highest, CGAL::to_double((curve(K::FT(3 * i) / samples) - CGAL::ORIGIN) * direction));
    std::size_t global = 0;
    for (const auto& feature : SC::extreme_points(curve, direction))
      if (feature.kind() == Kind::MAXIMUM && CGAL::certainly(feature.is_global())) {
        ++global;
        EXPECT_GE(CGAL::to_double((feature.point_on_curve().point() - CGAL::ORIGIN) * direction), highest - 1e-12);
      }
    EXPECT_EQ(global, 1u);
  }
  EXPECT_GT(found, 12u);
}

} // namespace

} // namespace curve_features_2_test
