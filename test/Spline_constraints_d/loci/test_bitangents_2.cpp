// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Lines tangent to two curves, or twice to one, with known answers.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/bitangents_2.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/curve_features_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace bitangents_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;
using Points = std::vector<K::Point_2>;
using Pairs = std::vector<std::pair<double, double>>;

bool all_certified(const SC::Bitangents_2<K>& result)
{
  return result.summary().is_complete &&
      std::all_of(result.bitangents().begin(), result.bitangents().end(),
                  [](const auto& b) { return b.solution().is_certified(); });
}

double rounded(const K::FT& x) { return std::round(CGAL::to_double(x) * 1e10) / 1e10 + 0.0; }

TEST(Bitangents_2, TwoCircles)
{
  const auto result =
      SC::bitangents(SC::circle_curve(K::Point_2(0, 0), K::FT(2)), SC::circle_curve(K::Point_2(5, 0), K::FT(1)));
  EXPECT_TRUE(all_certified(result)) << result.summary();
  Pairs contacts;
  for (const auto& bitangent : result.bitangents()) {
    const K::Point_2 p = bitangent.contact(0).point();
    contacts.emplace_back(rounded(p.x()), rounded(p.y()));
  }
  std::sort(contacts.begin(), contacts.end());
  const double outer = rounded(2 * std::sqrt(24.0) / 5);
  EXPECT_EQ(contacts, (Pairs{{0.4, -outer}, {0.4, outer}, {1.2, -1.6}, {1.2, 1.6}}));
}

// One inside of the other; and crossing, without the inner ones.
TEST(Bitangents_2, FewerOfCircles)
{
  const auto count = [](int x, int radius) {
    const auto result = SC::bitangents(SC::circle_curve(K::Point_2(0, 0), K::FT(2)),
                                       SC::circle_curve(K::Point_2(x, K::FT(1) / 3), K::FT(radius)));
    EXPECT_TRUE(all_certified(result));
    return result.bitangents().size();
  };
  EXPECT_EQ(count(1, 6), 0u);
  EXPECT_EQ(count(2, 1), 2u);
  EXPECT_EQ(count(9, 3), 4u);
}

// A common tangent where two curves touch is none, at a rational point.
TEST(Bitangents_2, TouchingCurves)
{
  // y = x^2 and y = -x^2/2
  const Curve first = SC::bezier_curve(Points{{-2, 4}, {0, -4}, {2, 4}}),
              second = SC::bezier_curve(Points{{-2, -2}, {0, 2}, {2, -2}});
  const auto result = SC::bitangents(first, second);
  EXPECT_TRUE(result.summary().is_complete) << result.summary();
  EXPECT_TRUE(result.bitangents().empty());
  EXPECT_EQ(
      SC::bitangents(
          first, second.transformed(CGAL::Aff_transformation_2<K>(CGAL::TRANSLATION, K::Vector_2(1, K::FT(-1) / 9))))
          .bitangents()
          .size(),
      2u);
}

// y = x^4 - x^2 + x, which y = x - 1/4 touches twice.
TEST(Bitangents_2, Quartic)
{
  const auto y = SC::Bernstein_tensor<SC::Exact_rational>::from_power_on_box(
      {4}, {0, 1, -1, 0, 1}, std::vector<std::pair<SC::Exact_rational, SC::Exact_rational>>{{-1, 1}});
  Points points;
  for (int i = 0; i < 5; ++i)
    points.emplace_back(K::FT(i) / 2 - 1, K::FT(y.coefficients()[i]));
  const Curve quartic = SC::bezier_curve(points);
  const auto result = SC::bitangents(quartic);
  EXPECT_TRUE(all_certified(result)) << result.summary();
  ASSERT_EQ(result.bitangents().size(), 1u);
  EXPECT_NEAR(result.bitangents()[0].contact(0).parameter(), 0.5 - std::sqrt(0.125), 1e-14);
  EXPECT_NEAR(result.bitangents()[0].contact(1).parameter(), 0.5 + std::sqrt(0.125), 1e-14);

  // The same curve with breaks.
  const auto pieces = SC::bitangents(quartic.with_knot(K::FT(1) / 3).elevated(5));
  EXPECT_EQ(pieces.bitangents().size(), 1u);
}

// The curvature of a quadratic B-spline curve changes its sign at knots. Its first and third piece have their highest
// points at the same height.
TEST(Bitangents_2, InflectionsOnBreaks)
{
  const Curve curve(2, {0, 0, 0, 1, 2, 3, 3, 3}, Points{{0, 0}, {1, 2}, {3, -2}, {5, 2}, {6, 0}});
  const auto result = SC::bitangents(curve);
  EXPECT_TRUE(all_certified(result)) << result.summary();
  ASSERT_EQ(result.bitangents().size(), 1u);
  EXPECT_DOUBLE_EQ(result.bitangents()[0].contact(0).parameter(), 0.5);
  EXPECT_DOUBLE_EQ(result.bitangents()[0].contact(1).parameter(), 2.5);
}

// No line touches a corner.
TEST(Bitangents_2, CornersAndStraightPieces)
{
  const Curve roof = SC::polyline_curve(Points{{-3, 0}, {0, 3}, {3, 0}});
  EXPECT_TRUE(SC::bitangents(roof).bitangents().empty());
  // neither line touches the circle
  const auto tangents = SC::bitangents(SC::circle_curve(K::Point_2(0, 0), K::FT(1)), roof);
  EXPECT_TRUE(tangents.summary().is_complete && tangents.bitangents().empty());

  // A drop with its tip at the seam, and a circle beside it: of the four lines that support both, two go through the
  // tip.
  const Curve drop = SC::bezier_curve(Points{{0, 0}, {3, 3}, {-3, 3}, {0, 0}});
  const auto around = SC::bitangents(drop, SC::circle_curve(K::Point_2(6, 2), K::FT(1)));
  EXPECT_TRUE(all_certified(around)) << around.summary();
  EXPECT_EQ(around.bitangents().size(), 2u);
}

// Fabricius-Bjerre: of a closed curve without double points, the bitangents with the curve on one side of both contacts
// are more than the others by half of the number of inflections. The curve meets each line through the center at most
// twice, as its control polygon does.
TEST(Bitangents_2, ClosedCurves)
{
  std::mt19937 random(5);
  std::size_t inflections = 0;
  for (int round = 0; round < 3; ++round) {
    const Points directions{{4, 0}, {3, 3}, {0, 4}, {-3, 3}, {-4, 0}, {-3, -3}, {0, -4}, {3, -3}};
    Points points;
    std::vector<K::FT> period;
    for (std::size_t i = 0; i < directions.size(); ++i) {
      points.push_back(CGAL::ORIGIN +
                       (directions[i] - CGAL::ORIGIN) * K::FT(i % 2 == 0 ? 3 + random() % 4 : 9 + random() % 8));
      period.push_back(K::FT(static_cast<int>(i)));
    }
    period.push_back(K::FT(8));
    const Curve curve = Curve::from_periodic(3, period, points);
    const auto result = SC::bitangents(curve);
    EXPECT_TRUE(all_certified(result)) << result.summary();
    int difference = 0;
    for (const auto& bitangent : result.bitangents()) {
      const K::Vector_2 normal =
          (bitangent.contact(1).point() - bitangent.contact(0).point()).perpendicular(CGAL::COUNTERCLOCKWISE);
      const auto side = [&](std::size_t i) {
        return CGAL::sign(normal * curve.derivative(K::FT(bitangent.contact(i).parameter()), 2));
      };
      difference += side(0) == side(1) ? 1 : -1;
    }
    const auto turns = SC::inflections(curve);
    inflections += turns.features().size();
    EXPECT_EQ(2 * difference, static_cast<int>(turns.count(SC::Curve_feature_kind::INFLECTION)));
    EXPECT_GE(result.bitangents().size(), turns.features().size() / 2);
  }
  EXPECT_GT(inflections, 6u);
}

} // namespace

} // namespace bitangents_2_test
