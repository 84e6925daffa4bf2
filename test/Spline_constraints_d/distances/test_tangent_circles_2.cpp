// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Circles that touch three curves, with known answers.

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/tangent_circles_2.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace tangent_circles_2_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Emptiness;
using SC::Exact_rational;
using K = CGAL::Exact_predicates_exact_constructions_kernel;
using Curve = SC::Bspline_curve_2<K>;
using Points = std::vector<K::Point_2>;
using Circle = SC::Tangent_circle_2<K>;

bool holds(const std::pair<double, double>& range, const Exact_rational& x)
{
  return Exact_rational(range.first) <= x && x <= Exact_rational(range.second);
}
bool holds(const std::pair<Exact_rational, Exact_rational>& range, const Exact_rational& x)
{
  return range.first <= x && x <= range.second;
}

// Which circles the answer touches from outside; fails if one is not touched.
std::vector<bool> touched_from_outside(const Circle& circle, const std::vector<K::Point_2>& centers,
                                       const std::vector<int>& radii)
{
  std::vector<bool> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const double distance = std::hypot(circle.center(0).value() - CGAL::to_double(centers[i].x()),
                                       circle.center(1).value() - CGAL::to_double(centers[i].y()));
    result.push_back(std::abs(distance - circle.radius().value() - radii[i]) < 1e-9 * circle.radius().value());
    EXPECT_TRUE(result.back() ||
                std::abs(distance - std::abs(circle.radius().value() - radii[i])) < 1e-9 * circle.radius().value());
  }
  return result;
}

void check_apollonius(const std::vector<K::Point_2>& centers, const std::vector<int>& radii)
{
  std::vector<Curve> circles;
  for (std::size_t i = 0; i < 3; ++i)
    circles.push_back(SC::circle_curve(centers[i], K::FT(radii[i])));
  const auto result = SC::tangent_circles(circles[0], circles[1], circles[2]);
  EXPECT_TRUE(result.summary().is_complete) << result.summary();
  EXPECT_EQ(result.circles().size(), 8u);
  std::vector<std::vector<bool>> sides;
  for (const auto& circle : result) {
    EXPECT_TRUE(circle.solution().is_certified());
    sides.push_back(touched_from_outside(circle, centers, radii));
    const bool is_outside = sides.back() == std::vector<bool>{true, true, true};
    EXPECT_EQ(circle.emptiness(), is_outside ? Emptiness::EMPTY : Emptiness::NOT_EMPTY)
        << circle.center(0).value() << ' ' << circle.center(1).value() << ' ' << circle.radius().value();
  }
  std::sort(sides.begin(), sides.end());
  EXPECT_EQ(std::unique(sides.begin(), sides.end()), sides.end());   // each of the eight ways once
}

TEST(Tangent_circles_2, Apollonius) { check_apollonius({{0, 0}, {5, 0}, {1, 6}}, {1, 2, 1}); }

// The circle around (5,0) of radius 4 touches all of them on breaks, the first one on its seam.
TEST(Tangent_circles_2, ContactsOnBreaks) { check_apollonius({{0, 0}, {10, 0}, {5, 5}}, {1, 1, 1}); }

// The segments meet in the corners, and only one of the four circles that touch the lines touches the segments.
TEST(Tangent_circles_2, Triangle)
{
  const Points corners{{0, 0}, {14, 0}, {5, 12}};
  std::vector<Curve> sides;
  for (int i = 0; i < 3; ++i)
    sides.push_back(SC::segment_curve(corners[i], corners[(i + 1) % 3]));
  const auto result = SC::tangent_circles(sides[0], sides[1], sides[2]);
  EXPECT_TRUE(result.summary().is_complete) << result.summary();
  ASSERT_EQ(result.circles().size(), 1u);
  const auto& circle = result.circles()[0];
  EXPECT_TRUE(circle.solution().is_certified());
  EXPECT_EQ(circle.emptiness(), Emptiness::EMPTY);
  EXPECT_TRUE(holds(circle.center_range(0), 6) && holds(circle.center_range(1), 4) &&
              holds(circle.squared_radius_range(), 16));
  EXPECT_NEAR(circle.radius().value(), 4, 1e-13);
}

// A polygonal curve has a corner and an end that is no contact: inside of the circle, or outside.
TEST(Tangent_circles_2, CornersAndEnds)
{
  const Curve first = SC::segment_curve(K::Point_2(0, 0), K::Point_2(14, 0)),
              second = SC::segment_curve(K::Point_2(14, 0), K::Point_2(5, 12));
  const auto emptiness_of_incircle = [&](const Points& third) {
    const auto result = SC::tangent_circles(first, second, SC::polyline_curve(third));
    EXPECT_TRUE(result.summary().is_complete) << result.summary();
    std::vector<Emptiness> found;
    for (const auto& circle : result.circles())
      if (holds(circle.center_range(0), 6) && holds(circle.center_range(1), 4) &&
          holds(circle.squared_radius_range(), 16))
        found.push_back(circle.emptiness());
    return found;
  };
  EXPECT_EQ(emptiness_of_incircle({{5, 12}, {0, 0}, {6, -4}}), std::vector<Emptiness>{Emptiness::EMPTY});
  EXPECT_EQ(emptiness_of_incircle({{5, 12}, {0, 0}, {6, 3}}), std::vector<Emptiness>{Emptiness::NOT_EMPTY});
  // Once more touched by the same curve: found with both contacts.
  EXPECT_EQ(emptiness_of_incircle({{5, 12}, {0, 0}, {0, 8}, {12, 8}}),
            (std::vector<Emptiness>{Emptiness::UNDECIDED, Emptiness::UNDECIDED}));
}

// Doubles: the segments touch a circle of radius 5 around the origin at (3,4), (-4,3) and (0,-5).
TEST(Tangent_circles_2, Doubles)
{
  using Point = CGAL::Simple_cartesian<double>::Point_2;
  const auto result =
      SC::tangent_circles(SC::segment_curve(Point(-1, 7), Point(7, 1)), SC::segment_curve(Point(-7, -1), Point(-1, 7)),
                          SC::segment_curve(Point(-7, -5), Point(7, -5)));
  ASSERT_EQ(result.circles().size(), 1u);
  EXPECT_EQ(result.circles()[0].emptiness(), Emptiness::EMPTY);
  EXPECT_TRUE(holds(result.circles()[0].center_range(0), 0) && holds(result.circles()[0].center_range(1), 0) &&
              holds(result.circles()[0].squared_radius_range(), 25));
}

// A random curve of degree 3, moved such that it touches a circle at a point with a given parameter.
Curve touching(const K::Point_2& point, const K::Vector_2& tangent, const K::FT& t, std::mt19937& random)
{
  const auto number = [&] { return static_cast<int>(random() % 41) - 20; };
  const Curve curve =
      SC::bezier_curve(Points{{number(), number()}, {number(), number()}, {number(), number()}, {number(), number()}});
  const K::Vector_2 own = curve.tangent(t);
  const K::FT cosine = own * tangent / own.squared_length(),
              sine = CGAL::determinant(own, tangent) / own.squared_length();
  const CGAL::Aff_transformation_2<K> rotation(cosine, -sine, sine, cosine);
  const Curve rotated = curve.transformed(rotation);
  return rotated.transformed(CGAL::Aff_transformation_2<K>(CGAL::TRANSLATION, point - rotated(t)));
}

TEST(Tangent_circles_2, PlantedCircles)
{
  std::mt19937 random(3);
  for (int round = 0; round < 5; ++round) {
    const K::Point_2 center(static_cast<int>(random() % 9), static_cast<int>(random() % 9));
    const int radius = round == 3 ? 1000 : 2 + static_cast<int>(random() % 3);
    std::vector<Curve> curves;
    std::array<Exact_rational, 3> parameters;
    const std::array<K::Vector_2, 3> directions{K::Vector_2(K::FT(3) / 5, K::FT(4) / 5),
                                                K::Vector_2(K::FT(-12) / 13, K::FT(5) / 13),
                                                K::Vector_2(K::FT(8) / 17, K::FT(-15) / 17)};
    for (std::size_t i = 0; i < 3; ++i) {
      parameters[i] = Exact_rational(static_cast<int>(1 + random() % 9)) / 10;
      // the derivative: in round 2 the two forms of the equations meet
      const K::FT size = round == 2 ? K::FT(radius) : K::FT(static_cast<int>(4 + random() % 8));
      curves.push_back(touching(center + directions[i] * K::FT(radius),
                                directions[i].perpendicular(CGAL::COUNTERCLOCKWISE) * size, K::FT(parameters[i]),
                                random));
    }
    const auto result = SC::tangent_circles(curves[0], curves[1], curves[2]);
    EXPECT_TRUE(result.summary().is_complete) << result.summary();
    std::size_t planted = 0;
    for (const auto& circle : result) {
      if (holds(circle.contact(0).parameter_range(), parameters[0]) &&
          holds(circle.contact(1).parameter_range(), parameters[1]) &&
          holds(circle.contact(2).parameter_range(), parameters[2])) {
        ++planted;
        EXPECT_TRUE(holds(circle.center_range(0), Exact_rational(center.x().exact())) &&
                    holds(circle.center_range(1), Exact_rational(center.y().exact())));
        EXPECT_TRUE(holds(circle.squared_radius_range(), radius * radius));
      }
      EXPECT_NE(circle.emptiness(), Emptiness::UNDECIDED);
      double nearest = 1e300;
      for (const Curve& curve : curves)
        for (int i = 0; i <= 300; ++i) {
          const K::Point_2 p = curve(K::FT(i) / 300);
          nearest = std::min(nearest,
                             std::hypot(CGAL::to_double(p.x()) - circle.center(0).value(),
                                        CGAL::to_double(p.y()) - circle.center(1).value()));
        }
      if (nearest < circle.radius().value() * (1 - 1e-9)) {
        EXPECT_EQ(circle.emptiness(), Emptiness::NOT_EMPTY);
      }
    }
    EXPECT_EQ(planted, 1u);
  }
}

// The equations start from the first curve; the circles do not depend on that. Curves cross each other, and every other
// one is rational.
TEST(Tangent_circles_2, AnyOrder)
{
  std::mt19937 random(8);
  const auto number = [&] { return static_cast<int>(random() % 21) - 10; };
  std::size_t found = 0, empty = 0;
  for (int round = 0; round < 5; ++round) {
    std::vector<Curve> curves;
    for (int i = 0; i < 3; ++i)
      curves.push_back(SC::bezier_curve(
          Points{{number(), number()}, {number(), number()}, {number(), number()}, {number(), number()}},
          i == 1 ? std::vector<K::FT>{1, 2, 1, 3} : std::vector<K::FT>{}));
    std::vector<std::vector<std::pair<double, Emptiness>>> answers(3);
    for (std::size_t first = 0; first < 3; ++first) {
      const auto result = SC::tangent_circles(curves[first], curves[(first + 1) % 3], curves[(first + 2) % 3]);
      EXPECT_TRUE(result.summary().is_complete) << round << ' ' << result.summary();
      for (const auto& circle : result) {
        answers[first].emplace_back(circle.radius().value(), circle.emptiness());
        double nearest = 1e300;
        for (const Curve& curve : curves)
          for (int i = 0; first == 0 && i <= 400; ++i) {
            const K::Point_2 p = curve(K::FT(i) / 400);
            nearest = std::min(nearest,
                               std::hypot(CGAL::to_double(p.x()) - circle.center(0).value(),
                                          CGAL::to_double(p.y()) - circle.center(1).value()));
          }
        EXPECT_TRUE(circle.emptiness() == Emptiness::NOT_EMPTY || nearest > circle.radius().value() * (1 - 1e-9));
        empty += circle.emptiness() == Emptiness::EMPTY;
      }
      std::sort(answers[first].begin(), answers[first].end());
      ASSERT_EQ(answers[first].size(), answers[0].size()) << round;
      for (std::size_t i = 0; i < answers[0].size(); ++i) {
        EXPECT_NEAR(answers[first][i].first, answers[0][i].first, 1e-7 * answers[0][i].first);
        EXPECT_EQ(answers[first][i].second, answers[0][i].second);
        EXPECT_NE(answers[first][i].second, Emptiness::UNDECIDED);
      }
    }
    found += answers[0].size();
  }
  EXPECT_GT(found, 10u);
  EXPECT_GT(empty, 5u);
}

} // namespace

} // namespace tangent_circles_2_test
