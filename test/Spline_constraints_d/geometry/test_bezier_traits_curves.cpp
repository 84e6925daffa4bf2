// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "arrangement_test_tools.h"
#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/conversions/bezier_traits_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>

#include <CGAL/Arr_Bezier_curve_traits_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace bezier_traits_curves_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using FT = Exact_rational;
using Nt_traits = CGAL::CORE_algebraic_number_traits;
using Rat_kernel = CGAL::Cartesian<Nt_traits::Rational>;
using Traits = CGAL::Arr_Bezier_curve_traits_2<Rat_kernel, CGAL::Cartesian<Nt_traits::Algebraic>, Nt_traits>;
using Bezier_curve = Traits::Curve_2;

Bezier_curve bezier(const std::vector<Rat_kernel::Point_2>& points) { return {points.begin(), points.end()}; }

TEST(Rational_value, of_algebraic_numbers_is_decided)
{
  using SC::internal::rational_value_of;
  using Expr = Nt_traits::Algebraic;
  EXPECT_EQ(rational_value_of(Expr(0)), FT(0));
  EXPECT_EQ(rational_value_of(Expr(-22) / Expr(7)), FT(-22) / FT(7));
  EXPECT_EQ(rational_value_of(CGAL::sqrt(Expr(2)) * CGAL::sqrt(Expr(8))), FT(4));
  EXPECT_EQ(rational_value_of(CGAL::sqrt(Expr(2)) - CGAL::sqrt(Expr(2))), FT(0));
  EXPECT_FALSE(rational_value_of(CGAL::sqrt(Expr(2))));
}

TEST(Bezier_traits_curves, are_converted_both_ways)
{
  const Bezier_curve curve = bezier({{0, 0}, {1, 2}, {3, 3}, {5, 1}});
  const auto spline = SC::to_bspline_curve(curve);
  EXPECT_EQ(spline.degree(), 3);
  const Nt_traits::Rational third(1, 3);
  EXPECT_EQ(spline(third), curve(third));
  const auto back = SC::to_bezier_traits_curves<Bezier_curve>(spline);
  ASSERT_TRUE(back);
  ASSERT_EQ(back->size(), 1u);
  EXPECT_TRUE(
      std::equal(curve.control_points_begin(), curve.control_points_end(), back->front().control_points_begin()));
}

TEST(Bezier_traits_curves, are_made_of_polynomial_pieces_only)
{
  using E = Exact_cartesian;
  const SC::Bspline_curve_2<E> curve(2, {0, 0, 0, 1, 3, 3, 3}, {{0, 0}, {1, 2}, {3, 1}, {4, 4}});
  const auto pieces = SC::to_bezier_traits_curves<Bezier_curve>(curve);
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 2u);
  const auto second = SC::to_bspline_curve(pieces->back());
  for (const int i : {0, 1, 2, 3}) {
    const auto p = second(Nt_traits::Rational(i, 3));
    EXPECT_EQ(SC::internal::exact_object(p), curve(FT(1) + FT(2 * i) / 3));
  }
  EXPECT_FALSE(SC::to_bezier_traits_curves<Bezier_curve>(SC::circle_curve(E::Point_2(0, 0), FT(2))));
  // (t^2 + t, 1 + t) / (1 + t) is a segment in fact.
  const SC::Bspline_function<FT> x({2}, {{0, 0, 0, 1, 1, 1}}, {0, FT(1) / 2, 2}), w({1}, {{0, 0, 1, 1}}, {1, 2});
  const auto cancelled = SC::Bspline_curve_2<E>::from_homogeneous_coordinates({x, w}, w);
  EXPECT_TRUE(cancelled.is_rational());
  EXPECT_TRUE(SC::to_bezier_traits_curves<Bezier_curve>(cancelled));
}

TEST(Bezier_traits_curves, x_monotone_parts_with_rational_parameters_are_converted)
{
  const Traits traits;
  // Its x-coordinate turns at 1/2: 4 t (1 - t).
  const auto parts_of = [&](const Bezier_curve& curve) {
    std::vector<Traits::X_monotone_curve_2> parts;
    std::vector<Variant<Traits::Point_2, Traits::X_monotone_curve_2>> found;
    traits.make_x_monotone_2_object()(curve, std::back_inserter(found));
    for (const auto& part : found)
      if (const auto* x_monotone = get_if<Traits::X_monotone_curve_2>(&part))
        parts.push_back(*x_monotone);
    return parts;
  };
  const auto whole = parts_of(bezier({{0, 0}, {1, 2}, {3, 1}}));
  ASSERT_EQ(whole.size(), 1u);
  const auto same = SC::to_bspline_curve(whole[0]);
  EXPECT_EQ(same.source(), Rat_kernel::Point_2(0, 0));
  EXPECT_EQ(same.target(), Rat_kernel::Point_2(3, 1));

  const auto halves = parts_of(bezier({{0, 0}, {2, 1}, {0, 2}}));
  ASSERT_EQ(halves.size(), 2u);
  const auto first = SC::to_bspline_curve(halves[0]), last = SC::to_bspline_curve(halves[1]);
  EXPECT_EQ(first.target(), Rat_kernel::Point_2(1, 1));
  EXPECT_EQ(last.source(), Rat_kernel::Point_2(1, 1));

  // It turns where 3 t^2 = 1.
  const auto irrational =
      parts_of(bezier({{0, 0}, {Nt_traits::Rational(1, 3), 1}, {Nt_traits::Rational(2, 3), 2}, {0, 3}}));
  ASSERT_EQ(irrational.size(), 2u);
  expect_invalid([&] { SC::to_bspline_curve(irrational[0]); }, "no rational parameter");
}

} // namespace

} // namespace bezier_traits_curves_test
