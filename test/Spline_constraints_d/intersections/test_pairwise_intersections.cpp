// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Collections of curves: the answers of each pair alone, grids and chains with exact counts, splines of many pieces.

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/operations/intersections/intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/pairwise_intersections.h>
#include <CGAL/Spline_constraints_d/operations/intersections/self_intersections.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <gtest/gtest.h>

#include <random>
#include <ranges>
#include <vector>

namespace pairwise_intersections_test {

namespace SC = CGAL::Spline_constraints;
using Inexact = CGAL::Simple_cartesian<double>;
using Curve = SC::Bspline_curve_2<Inexact>;
using Point = Inexact::Point_2;
using Kind = SC::Intersection_kind;

namespace {

Curve segment(double x0, double y0, double x1, double y1)
{
  return SC::bezier_curve(std::vector<Point>{{x0, y0}, {x1, y1}});
}

std::vector<Curve> random_cubics(std::size_t count, double size, std::mt19937& generator)
{
  std::uniform_real_distribution<double> place(0, 1), step(-size, size);
  std::vector<Curve> result;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Point> points{{place(generator), place(generator)}};
    for (int k = 0; k < 3; ++k)
      points.emplace_back(points.back().x() + step(generator), points.back().y() + step(generator));
    result.push_back(SC::bezier_curve(points));
  }
  return result;
}

// In narrow ranges that meet: pairs of curves may be looked at in doubles first.
template <class Intersections>
void expect_equal(const Intersections& a, const Intersections& b)
{
  constexpr double narrow = 1e-14;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].kind(), b[i].kind());
    for (std::size_t curve : {0, 1}) {
      const auto range = a[i].parameter_range(curve), other = b[i].parameter_range(curve);
      EXPECT_LE(range.first, other.second);
      EXPECT_LE(other.first, range.second);
      EXPECT_LT(CGAL::to_double(range.second - range.first), narrow);
      EXPECT_LT(CGAL::to_double(other.second - other.first), narrow);
    }
  }
}

// A path that goes up and down between -1 and 1.
Curve zigzag(int teeth, bool is_upright)
{
  std::vector<Point> points;
  std::vector<double> knots{0};
  for (int i = 0; i <= teeth; ++i) {
    const double along = 2.0 * i / teeth - 1, across = i % 2 == 0 ? -1 : 1;
    points.emplace_back(is_upright ? across : along, is_upright ? along : across);
    knots.push_back(i);
  }
  knots.push_back(teeth);
  return Curve(1, knots, points);
}

} // namespace

TEST(Pairwise_intersections, are_those_of_each_pair)
{
  std::mt19937 generator(7);
  const std::vector<Curve> curves = random_cubics(40, 0.2, generator), others = random_cubics(30, 0.2, generator);
  const auto between = SC::pairwise_intersections(curves, others);
  const auto within = SC::pairwise_intersections(curves);
  EXPECT_TRUE(between.summary().is_complete);
  EXPECT_TRUE(within.summary().is_complete);
  std::size_t pairs_between = 0, pairs_within = 0;
  const auto expect_next = [](const auto& result, std::size_t& next, std::size_t i, std::size_t j,
                              const auto& expected) {
    if (expected.empty())
      return;
    ASSERT_LT(next, result.pairs().size());
    EXPECT_EQ(result.pairs()[next].first, i);
    EXPECT_EQ(result.pairs()[next].second, j);
    expect_equal(result.pairs()[next++].intersections, expected);
  };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (std::size_t j = 0; j < others.size(); ++j)
      expect_next(between, pairs_between, i, j, SC::intersections(curves[i], others[j]));
    for (std::size_t j = i + 1; j < curves.size(); ++j)
      expect_next(within, pairs_within, i, j, SC::intersections(curves[i], curves[j]));
  }
  EXPECT_EQ(between.pairs().size(), pairs_between);
  EXPECT_EQ(within.pairs().size(), pairs_within);
  EXPECT_GT(pairs_between, 50u);
  EXPECT_GT(pairs_within, 25u);
}

TEST(Pairwise_intersections, of_a_grid)
{
  std::vector<Curve> horizontal, vertical;
  for (int i = 0; i < 20; ++i) {
    horizontal.push_back(segment(-1, i, 20, i));
    vertical.push_back(segment(i, -1, i, 20));
  }
  const auto result = SC::pairwise_intersections(horizontal, vertical);
  EXPECT_TRUE(result.summary().is_complete);
  ASSERT_EQ(result.pairs().size(), 400u);
  for (const auto& pair : result.pairs()) {
    ASSERT_EQ(pair.intersections.size(), 1u);
    EXPECT_EQ(pair.intersections[0].kind(), Kind::TRANSVERSAL);
    EXPECT_NEAR(pair.intersections[0].point().x(), static_cast<double>(pair.second), 1e-12);
    EXPECT_NEAR(pair.intersections[0].point().y(), static_cast<double>(pair.first), 1e-12);
  }
  EXPECT_TRUE(SC::pairwise_intersections(horizontal).pairs().empty()); // parallels
}

TEST(Pairwise_intersections, of_curves_that_share_ends_or_touch)
{
  const std::vector<Curve> chain{segment(0, 0, 1, 0), segment(1, 0, 1, 1), segment(1, 1, 0, 1), segment(0, 1, 0, 0),
                                 SC::bezier_curve(std::vector<Point>{{0, 0.5}, {0.5, -0.5}, {1, 0.5}})};
  const auto result = SC::pairwise_intersections(chain);
  EXPECT_TRUE(result.summary().is_complete);
  std::size_t ends = 0, contacts = 0;
  for (const auto& pair : result.pairs()) {
    ends += pair.intersections.count(Kind::END_POINT);
    contacts += pair.intersections.count(Kind::TANGENT);
  }
  EXPECT_EQ(result.pairs().size(), 7u);
  EXPECT_EQ(ends, 6u);     // the corners, and the ends of the parabola
  EXPECT_EQ(contacts, 1u); // its apex on the lower side
}

TEST(Pairwise_intersections, of_curves_in_space)
{
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  const auto line = [](int x0, int y0, int z0, int x1, int y1, int z1) {
    return SC::bezier_curve(std::vector<Kernel::Point_3>{{x0, y0, z0}, {x1, y1, z1}});
  };
  const std::vector<SC::Bspline_curve_3<Kernel>> lines{line(-1, 0, 0, 1, 0, 0), line(0, -1, 0, 0, 1, 0),
                                                       line(0, 0, -1, 0, 0, 1), line(-1, -1, 1, 1, 1, 1)};
  const auto result = SC::pairwise_intersections(lines);
  EXPECT_TRUE(result.summary().is_complete);
  ASSERT_EQ(result.pairs().size(), 4u); // three axes through the origin, and the end of one on the diagonal above
  for (const auto& pair : result.pairs())
    EXPECT_LT(CGAL::squared_distance(pair.intersections[0].point(),
                                     pair.second == 3 ? Kernel::Point_3(0, 0, 1) : Kernel::Point_3(0, 0, 0)),
              1e-24);
}

TEST(Pairwise_intersections, with_those_of_each_curve_with_itself)
{
  const Curve loop = SC::bezier_curve(std::vector<Point>{{0, 0}, {3, 2}, {-2, 2}, {1, 0}});
  const std::vector<Curve> curves{segment(0, 5, 1, 5), loop, segment(-1, 0.25, 2, 0.25)};
  const auto result = SC::pairwise_intersections(curves, {}, SC::Self_intersections::INCLUDED);
  EXPECT_TRUE(result.summary().is_complete);
  ASSERT_EQ(result.pairs().size(), 2u);
  EXPECT_TRUE(result.pairs()[0].first == 1 && result.pairs()[0].second == 1);
  expect_equal(result.pairs()[0].intersections, SC::self_intersections(loop));
  EXPECT_EQ(result.pairs()[0].intersections.size(), 1u);
  EXPECT_TRUE(result.pairs()[1].first == 1 && result.pairs()[1].second == 2);
  EXPECT_EQ(SC::pairwise_intersections(curves).pairs().size(), 1u);
}

TEST(Pairwise_intersections, of_splines_with_many_pieces_leave_out_most_pairs_of_pieces)
{
  // Each of the 60 lines that go up and down crosses each of the 60 that go left and right once, all at points that are
  // no knots.
  const auto all = SC::intersections(zigzag(60, false), zigzag(60, true));
  EXPECT_TRUE(all.is_complete());
  EXPECT_EQ(all.count(Kind::TRANSVERSAL) + all.count(Kind::END_POINT), all.size());
  EXPECT_GE(all.size(), 58u * 58u);

  const auto apart =
      SC::intersections(zigzag(400, false), SC::bezier_curve(std::vector<Point>{{-1, -2}, {0, -1.7}, {1, -1.5}}));
  EXPECT_TRUE(apart.is_complete());
  EXPECT_TRUE(apart.empty());
  EXPECT_EQ(apart.summary().nodes, 0u);

  const auto flat = SC::intersections(zigzag(400, false),
                                      SC::bezier_curve(std::vector<Point>{{-0.0125, 0.25}, {0, 0.26}, {0.0125, 0.25}}));
  EXPECT_TRUE(flat.is_complete());
  // of the four teeth that are all in its range; the halves on both sides are below
  EXPECT_EQ(flat.count(Kind::TRANSVERSAL), 4u);
  EXPECT_LT(flat.summary().nodes, 20u);
}

TEST(Pairwise_intersections, of_views_and_empty_collections)
{
  struct Element
  {
    Curve curve;
    int color;
  };
  const std::vector<Element> drawing{{segment(0, 0, 1, 1), 3}, {segment(0, 1, 1, 0), 4}};
  const auto result = SC::pairwise_intersections(drawing | std::views::transform(&Element::curve));
  ASSERT_EQ(result.pairs().size(), 1u);
  EXPECT_EQ(result.pairs()[0].intersections.size(), 1u);
  const auto none = SC::pairwise_intersections(std::vector<Curve>());
  EXPECT_TRUE(none.pairs().empty());
  EXPECT_TRUE(none.summary().is_complete);
}

TEST(Pairwise_intersections, bad_input)
{
  const std::vector<Curve> curves{segment(0, 0, 1, 1)};
  EXPECT_THROW(SC::pairwise_intersections(curves, {.tolerance = -1}), SC::Invalid_input);
}

} // namespace pairwise_intersections_test
