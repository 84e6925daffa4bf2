// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace Bspline_curve_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using FT = Exact_rational;
using Curve_2 = SC::Bspline_curve_2<Exact_cartesian>;
using Curve_3 = SC::Bspline_curve_3<Exact_cartesian>;
using Double_curve_2 = SC::Bspline_curve_2<Double_cartesian>;
using Point_2 = Exact_cartesian::Point_2;
using Vector_2 = Exact_cartesian::Vector_2;
using Vector_3 = Exact_cartesian::Vector_3;

constexpr int rounds = 25;

// The quarter of the unit circle.
Curve_2 quarter() { return Curve_2(2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2}); }

template <class Kernel>
class Curve_in_kernel
  : public testing::Test
{
};

using Kernels = testing::Types<Double_cartesian, CGAL::Epick, CGAL::Epeck, Exact_cartesian>;
TYPED_TEST_SUITE(Curve_in_kernel, Kernels, );

// All numbers are short dyadic ones, so that these answers are exact in every kernel.
TYPED_TEST(Curve_in_kernel, evaluates_and_operates)
{
  using Kernel = TypeParam;
  using Curve = SC::Bspline_curve_2<Kernel>;
  using Point = typename Kernel::Point_2;
  const Curve curve(2, {0, 0, 0, 1, 2, 2, 2}, {{0, 0}, {2, 4}, {4, -4}, {6, 0}});
  EXPECT_EQ(curve.degree(), 2);
  EXPECT_EQ(curve.size(), 4u);
  EXPECT_FALSE(curve.is_rational());
  EXPECT_EQ(curve(1), Point(3, 0));
  EXPECT_EQ(curve(0.5), Point(1.75, 2));
  EXPECT_EQ(curve.source(), Point(0, 0));
  EXPECT_EQ(curve.target(), Point(6, 0));
  EXPECT_EQ(curve.derivative(1), typename Kernel::Vector_2(2, -8));
  EXPECT_EQ(curve.derivative(0, 2), typename Kernel::Vector_2(-2, -16));
  EXPECT_EQ(curve.domain(), (std::pair<typename Kernel::FT, typename Kernel::FT>(0, 2)));
  EXPECT_EQ(curve.breaks().size(), 3u);
  EXPECT_EQ(curve.control_points()[2], Point(4, -4));
  EXPECT_EQ(curve.control_weights(), (std::vector<typename Kernel::FT>{1, 1, 1, 1}));
  EXPECT_EQ(curve.bbox(), CGAL::Bbox_2(0, -4, 6, 4));

  const Curve finer = curve.with_knot(1.5);
  EXPECT_EQ(finer.size(), 5u);
  EXPECT_TRUE(finer == curve);
  ASSERT_TRUE(finer.without_knot(1.5));
  EXPECT_EQ(finer.without_knot(1.5)->control_points(), curve.control_points());
  EXPECT_FALSE(curve.without_knot(1));
  EXPECT_EQ(curve.reversed()(0.5), curve(1.5));
  EXPECT_TRUE(curve.reversed().reversed() == curve);
  EXPECT_EQ(curve.with_domain(-1, 3)(0), curve(0.5));
  EXPECT_EQ(curve.split(1).second(1.5), curve(1.5));
  EXPECT_EQ(curve.bezier_pieces().size(), 2u);
  EXPECT_FALSE(curve == curve.reversed());

  const typename Kernel::Aff_transformation_2 map(0, -2, 10, 1, 0, 20);
  EXPECT_EQ(curve.transformed(map)(0.5), Point(6, 21.75));

  // The quarter circle, whose curvature is one.
  const Curve arc(2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, 1, 2});
  EXPECT_TRUE(arc.is_rational());
  EXPECT_EQ(arc.squared_curvature(0), 1);
  EXPECT_EQ(arc.squared_curvature(1), 1);
  EXPECT_EQ(arc.curvature(0), 1.0);
  EXPECT_EQ(arc.reversed().curvature(0), -1.0);
  EXPECT_EQ(arc.tangent(0), typename Kernel::Vector_2(0, 2));
  EXPECT_EQ(arc.normal(0), typename Kernel::Vector_2(-2, 0));
  EXPECT_FALSE(arc.is_closed());

  const Curve closed = Curve::from_periodic(2, {0, 1, 2, 3, 4}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  EXPECT_TRUE(closed.is_closed());
  EXPECT_EQ(closed(1), Point(2, 1));
  EXPECT_EQ(closed.tangent(0), closed.bezier_pieces()[3].tangent(4));

  // To exact numbers nothing is lost.
  const SC::Bspline_curve_2<Exact_cartesian> exact(arc);
  EXPECT_TRUE(exact == quarter());
  EXPECT_TRUE(SC::Bspline_curve_2<Kernel>(exact) == arc);
  EXPECT_EQ(arc.weight(), quarter().weight());
  EXPECT_EQ(arc.homogeneous_coordinates()[1], quarter().homogeneous_coordinates()[1]);
}

TEST(Bspline_curve, points_are_quotients_of_its_homogeneous_coordinates)
{
  Random_geometry random(1);
  int rational = 0;
  for (int i = 0; i < rounds; ++i) {
    const Curve_3 curve = random.curve<Exact_cartesian, 3>();
    rational += curve.is_rational();
    const std::vector<FT> t = random.point(1);
    const auto numerators = curve.homogeneous_coordinates();
    const FT weight = curve.weight()(t);
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(curve(t[0]).cartesian(k), FT(numerators[k](t) / weight));
  }
  EXPECT_GT(rational, rounds / 4);
  EXPECT_LT(rational, rounds);
}

TEST(Bspline_curve, operations_keep_the_points)
{
  Random_geometry random(2);
  for (int i = 0; i < rounds; ++i) {
    const Curve_2 curve = random.curve<Exact_cartesian, 2>();
    const FT t = random.fraction(), knot = FT(random.integer(1, 40)) / FT(41);
    const Point_2 p = curve(t);

    const Curve_2 elevated = curve.elevated(curve.degree() + random.integer(0, 2));
    EXPECT_EQ(elevated(t), p);
    EXPECT_TRUE(elevated == curve);

    const Curve_2 finer = curve.with_knot(knot);
    EXPECT_EQ(finer(t), p);
    EXPECT_TRUE(finer == curve);
    const auto coarser = finer.without_knot(knot);
    ASSERT_TRUE(coarser);
    EXPECT_EQ(coarser->knots(), curve.knots());
    EXPECT_EQ(coarser->control_points(), curve.control_points());

    const auto [before, after] = curve.split(knot);
    EXPECT_EQ((t <= knot ? before : after)(t), p);
    EXPECT_EQ(before.target(), after.source());

    EXPECT_EQ(curve.reversed()(FT(1) - t), p);
    EXPECT_EQ(curve.with_domain(FT(3), FT(5))(FT(3) + FT(2) * t), p);
    EXPECT_TRUE(curve.reversed().reversed() == curve);

    const Exact_cartesian::Aff_transformation_2 map(2, FT(1) / FT(3), -5, 7, 1, FT(2) / FT(7));
    EXPECT_EQ(curve.transformed(map)(t), map.transform(p));

    const std::vector<Curve_2> pieces = curve.bezier_pieces();
    ASSERT_EQ(pieces.size() + 1, curve.breaks().size());
    for (std::size_t c = 0; c < pieces.size(); ++c) {
      EXPECT_EQ(pieces[c].size(), curve.degree() + 1u);
      const FT inside = (pieces[c].domain().first + pieces[c].domain().second) / FT(2);
      EXPECT_EQ(pieces[c](inside), curve(inside));
    }

    // Other weights for the same points: a common factor, and one that varies.
    const auto x = curve.homogeneous_coordinates();
    const SC::Bspline_function<FT> factor({1}, {{0, 0, 1, 1}}, {-2, -5});
    EXPECT_TRUE(Curve_2::from_homogeneous_coordinates({x[0] * factor, x[1] * factor}, curve.weight() * factor) ==
                curve);
  }
}

TEST(Bspline_curve, removes_a_knot_only_where_the_curve_is_smooth)
{
  Random_geometry random(3);
  int kept = 0;
  for (int i = 0; i < rounds; ++i) {
    const Curve_2 curve = random.curve<Exact_cartesian, 2>();
    for (const FT& t : curve.breaks())
      if (curve.domain().first < t && t < curve.domain().second) {
        EXPECT_FALSE(curve.without_knot(t));
        ++kept;
      }
  }
  EXPECT_GT(kept, rounds / 2);
  // Two pieces of one parabola.
  const Curve_2 parabola(2, {0, 0, 0, 1, 1, 3, 3, 3}, {{0, 0}, {FT(1) / 2, 0}, {1, 1}, {2, 3}, {3, 9}});
  ASSERT_TRUE(parabola.without_knot(1));
  ASSERT_TRUE(parabola.without_knot(1)->without_knot(1));
  EXPECT_TRUE(*parabola.without_knot(1)->without_knot(1) == parabola);
}

// For a polynomial f of degree at most p: sum_k (-1)^(m-k) binom(m,k) f(a + k h) = h^m f^(m) when m = p.
TEST(Bspline_curve, derivatives_follow_the_quotient_rule)
{
  Random_geometry random(4);
  for (int i = 0; i < rounds; ++i) {
    const Curve_2 curve = random.curve<Exact_cartesian, 2>();
    const FT t = random.fraction();
    const auto numerators = curve.homogeneous_coordinates();
    const Curve_2 numerator =
        Curve_2::from_homogeneous_coordinates(numerators, SC::Bspline_function<FT>({0}, {{0, 1}}, {1}));
    const auto w = curve.weight();
    const Curve_2 weight = Curve_2::from_homogeneous_coordinates({w, w}, SC::Bspline_function<FT>({0}, {{0, 1}}, {1}));
    const std::vector<Vector_2> c = curve.derivatives(t, 3), n = numerator.derivatives(t, 3),
                                v = weight.derivatives(t, 3);
    ASSERT_EQ(c.size(), 4u);
    EXPECT_EQ(c[0], curve(t) - CGAL::ORIGIN);
    // Leibniz' rule for n = w c.
    EXPECT_EQ(c[0] * v[0].x(), n[0]);
    EXPECT_EQ(c[1] * v[0].x() + c[0] * v[1].x(), n[1]);
    EXPECT_EQ(c[2] * v[0].x() + c[1] * FT(2 * v[1].x()) + c[0] * v[2].x(), n[2]);
    EXPECT_EQ(c[3] * v[0].x() + c[2] * FT(3 * v[1].x()) + c[1] * FT(3 * v[2].x()) + c[0] * v[3].x(), n[3]);
  }
}

TEST(Bspline_curve, derivatives_of_polynomials_are_divided_differences)
{
  Random_geometry random(5);
  for (int i = 0; i < rounds; ++i) {
    const int degree = random.integer(1, 4);
    const std::vector<FT> knots = Curve_2(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}).elevated(degree).knots();
    const Curve_2 curve(degree, knots, random.points<Exact_cartesian, 2>(degree + 1));
    const FT h = FT(1) / FT(degree);
    Vector_2 difference(0, 0);
    FT binomial(degree % 2 == 0 ? 1 : -1), factor(1);
    for (int k = 0; k <= degree; ++k) {
      difference = difference + (curve(FT(k) * h) - CGAL::ORIGIN) * binomial;
      binomial *= FT(k - degree) / FT(k + 1);
      if (k > 0)
        factor *= h;
    }
    EXPECT_EQ(curve.derivative(random.fraction(), degree) * factor, difference);
    EXPECT_EQ(curve.derivative(random.fraction(), degree + 1), CGAL::NULL_VECTOR);
  }
}

TEST(Bspline_curve, curvature_of_circles_and_of_a_twisted_cubic)
{
  Random_geometry random(6);
  const Curve_2 circle = quarter().transformed(Exact_cartesian::Aff_transformation_2(CGAL::SCALING, FT(3)));
  for (int i = 0; i < rounds; ++i) {
    const FT t = random.fraction();
    EXPECT_EQ(circle.squared_curvature(t), FT(1) / FT(9));
    EXPECT_EQ(circle.curvature(t), std::sqrt(1.0 / 9));
    EXPECT_EQ(circle.tangent(t) * circle.normal(t), 0);
    EXPECT_EQ(CGAL::orientation(circle.tangent(t), circle.normal(t)), CGAL::LEFT_TURN);
  }
  // (t, t^2, t^3) at 0: binormal along z, curvature 2; at 1 from the formula.
  const Curve_3 cubic(3, {0, 0, 0, 0, 1, 1, 1, 1},
                      {{0, 0, 0}, {FT(1) / 3, 0, 0}, {FT(2) / 3, FT(1) / 3, 0}, {1, 1, 1}});
  EXPECT_EQ(cubic.squared_curvature(0), 4);
  EXPECT_EQ(cubic.curvature(0), 2.0);
  EXPECT_EQ(cubic.binormal(0), Vector_3(0, 0, 2));
  EXPECT_EQ(cubic.principal_normal(0), Vector_3(0, 2, 0));
  EXPECT_EQ(cubic.squared_curvature(1), FT(76) / FT(14 * 14 * 14));
}

TEST(Bspline_curve, boxes_contain_the_curve)
{
  Random_geometry random(7);
  for (int i = 0; i < rounds; ++i) {
    const Curve_3 curve = random.curve<Exact_cartesian, 3>();
    const CGAL::Bbox_3 box = curve.bbox();
    for (int k = 0; k < 20; ++k) {
      const auto p = curve(random.fraction());
      for (int j = 0; j < 3; ++j) {
        EXPECT_LE(FT((box.min)(j)), p.cartesian(j));
        EXPECT_LE(p.cartesian(j), FT((box.max)(j)));
      }
    }
  }
  // One third is rounded to both sides.
  const CGAL::Bbox_2 third = Curve_2(1, {0, 0, 1, 1}, {{FT(1) / 3, 0}, {FT(1) / 3, 1}}).bbox();
  EXPECT_LT(FT(third.xmin()), FT(1) / 3);
  EXPECT_LT(FT(1) / 3, FT(third.xmax()));
  // The half circle (1 - t^2, 2 t) / (1 + t^2) on [-1, 1] has a control point at infinity.
  const SC::Bspline_function<FT> x({2}, {{-1, -1, -1, 1, 1, 1}}, {0, 2, 0}),
      y({2}, {{-1, -1, -1, 1, 1, 1}}, {-2, 0, 2}), w({2}, {{-1, -1, -1, 1, 1, 1}}, {2, 0, 2});
  const Curve_2 half = Curve_2::from_homogeneous_coordinates({x, y}, w);
  expect_invalid([&] { half.control_points(); }, "control point 1 has weight 0");
  const CGAL::Bbox_2 box = half.bbox();
  EXPECT_EQ(half(0), Point_2(1, 0));
  EXPECT_EQ(half.squared_curvature(FT(1) / 3), 1);
  EXPECT_TRUE(half.elevated(4) == half);
  EXPECT_TRUE(half.with_knot(FT(1) / 3) == half);
  EXPECT_TRUE(half.restricted(0, 1) == quarter());
  EXPECT_TRUE(Curve_2(Double_curve_2(half)) == half);
  EXPECT_LE(box.xmin(), 0);
  EXPECT_GE(box.xmax(), 1);
  EXPECT_LE(box.ymin(), -1);
  EXPECT_GE(box.ymax(), 1);
  EXPECT_LE(box.xmax(), 3);
}

TEST(Bspline_curve, periodic_input_is_unwrapped)
{
  Random_geometry random(8);
  for (int degree = 1; degree <= 4; ++degree)
    for (int n = 2; n <= 6; ++n) {
      std::vector<FT> period{0};
      for (int i = 0; i < n; ++i)
        period.push_back(period.back() + FT(random.integer(1, 5)) / FT(3));
      const std::vector<Point_2> points = random.points<Exact_cartesian, 2>(n);
      const std::vector<FT> weights = random.weights(n);
      const Curve_2 curve = Curve_2::from_periodic(degree, period, points, weights);
      EXPECT_EQ(curve.domain(), (std::pair<FT, FT>(period.front(), period.back())));
      EXPECT_EQ(curve.breaks(), period);
      EXPECT_EQ(curve.size(), std::size_t(n + degree));
      EXPECT_TRUE(curve.is_closed());
      // Smooth across the seam, but for the last derivative.
      const auto end = curve.bezier_pieces().back();
      for (int r = 1; r < degree; ++r)
        EXPECT_EQ(curve.derivative(period.front(), r), end.derivative(period.back(), r));
    }
  // The uniform quadratic spline of a square runs through the middles of its sides.
  const Curve_2 square = Curve_2::from_periodic(2, {0, 1, 2, 3, 4}, {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  EXPECT_EQ(square(0), Point_2(1, 0));
  EXPECT_EQ(square(1), Point_2(2, 1));
  EXPECT_EQ(square(FT(1) / 2), Point_2(FT(7) / 4, FT(1) / 4));
  EXPECT_FALSE(square.restricted(0, 3).is_closed());
}

TEST(Bspline_curve, doubles_stay_close_and_decide_exactly)
{
  Random_geometry random(9);
  for (int i = 0; i < rounds; ++i) {
    const Double_curve_2 curve = random.curve<Double_cartesian, 2>();
    const Curve_2 exact(curve);
    const double t = CGAL::to_double(random.fraction());
    const auto p = curve(t);
    const auto q = exact(FT(t));
    // Weights between 1/6 and 30, control points up to 60; some 60 roundings of numbers up to 1800.
    for (int k = 0; k < 2; ++k) {
      EXPECT_LE(FT(p.cartesian(k)) - q.cartesian(k), FT(1e-9));
      EXPECT_LE(q.cartesian(k) - FT(p.cartesian(k)), FT(1e-9));
    }
    EXPECT_TRUE(exact == Curve_2(Double_curve_2(exact)));
    const CGAL::Bbox_2 box = curve.bbox();
    EXPECT_TRUE(FT(box.xmin()) <= q.x() && q.x() <= FT(box.xmax()) && FT(box.ymin()) <= q.y() &&
                q.y() <= FT(box.ymax()));
  }
  const double above = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(Double_curve_2(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}) ==
               Double_curve_2(1, {0, 0, 1, 1}, {{0, 0}, {1, above}}));
  EXPECT_FALSE(Double_curve_2(1, {0, 0, 1, 2, 2}, {{1, 0}, {3, 1}, {above, 0}}).is_closed());
}

TEST(Bspline_curve, rounded_knots_keep_their_order_and_their_pieces)
{
  std::mt19937_64 engine(10);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int made = 0, refused = 0;
  for (int i = 0; i < 200; ++i) {
    const double begin = uniform(engine), end = begin + 1 + uniform(engine);
    // Knots next to the ends, where images are rounded to and across them most easily.
    const Double_curve_2 curve(
        1, {begin - 1, begin, std::nextafter(begin, 9.0), (begin + end) / 2, std::nextafter(end, -9.0), end, end + 0.3},
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}});
    const double new_begin = uniform(engine), new_end = new_begin + 3 * (1 + uniform(engine));
    const auto check = [&](const auto& operation, const Double_cartesian::Point_2& source, double first, double last) {
      try {
        const Double_curve_2 image = operation();
        ++made;
        EXPECT_TRUE(std::ranges::is_sorted(image.knots()));
        EXPECT_EQ(image.breaks().size(), 5u);
        EXPECT_EQ(image.domain(), std::pair(first, last));
        EXPECT_EQ(image.source(), source);
      } catch (const SC::Invalid_input& error) {
        ++refused;
        EXPECT_NE(std::string(error.what()).find("fall together"), std::string::npos) << error.what();
      }
    };
    check([&] { return curve.with_domain(new_begin, new_end); }, curve.source(), new_begin, new_end);
    check([&] { return curve.reversed(); }, curve.target(), begin, end);
  }
  EXPECT_GT(made, 20);
  EXPECT_GT(refused, 20);
  const FT third = FT(1) / FT(3);
  const Curve_2 close(2, {0, 0, 0, third, third + FT(1e-30), 1, 1, 1}, {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}});
  expect_invalid([&] { Double_curve_2 rounded(close); }, "fall together");
}

TEST(Bspline_curve, rejects_bad_input)
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  using C = Double_curve_2;
  expect_invalid([] { C(2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, 1}}); }, "2 where 3");
  expect_invalid([] { C(2, {0, 0, 0, 2, 1, 1, 1}, {{0, 0}, {1, 1}, {1, 1}, {1, 1}}); }, "knot 4 is smaller");
  expect_invalid([] { C(-1, {0, 1}, {{0, 0}}); }, "negative");
  expect_invalid([&] { C(1, {0, 0, 1, 1}, {{0, 0}, {1, nan}}); }, "control point 1");
  expect_invalid([&] { C(1, {0, 0, infinity, 1}, {{0, 0}, {1, 1}}); }, "knot 2");
  expect_invalid([&] { C(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {1, nan}); }, "weight 1 is not a finite");
  expect_invalid([&] { C(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {1, 0}); }, "weight 1 is zero");
  expect_invalid([&] { C(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {1}); }, "weights: 1 where 2");
  expect_invalid([&] { C(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {1, -1}); }, "control weight 1");
  expect_invalid([&] { C(2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, 1}, {2, 0}}, {1, -1, 1}); }, "control weight 1");
  expect_invalid([&] { C(2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, 1}, {2, 0}}, {1, -3, 1}); }, "not positive everywhere");
  // Negative throughout, or in a control point only, is a positive weight.
  EXPECT_EQ(C(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {-1, -3}).control_weights(), (std::vector<double>{1, 3}));
  EXPECT_TRUE(C(2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {1, 1}, {2, 0}}, {1, -0.5, 1}).is_rational());
  // Equal weights are no weights.
  EXPECT_FALSE(C(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {1, 1}).is_rational());
  EXPECT_EQ(C(1, {0, 0, 1, 1}, {{0, 0}, {1, 0.1}}, {0.3, 0.3}).control_points()[1].y(), 0.1);
  EXPECT_FALSE(Curve_2(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}, {-3, -3}).is_rational());

  const C line(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}}), point(1, {0, 0, 1, 1}, {{2, 2}, {2, 2}});
  expect_invalid([&] { line(1.5); }, "outside of the domain");
  expect_invalid([&] { line(nan); }, "outside of the domain");
  expect_invalid([&] { line.derivative(0, -1); }, "negative");
  expect_invalid([&] { point.curvature(0); }, "first derivative is zero");
  expect_invalid([&] { line.split(0); }, "empty");
  expect_invalid([&] { line.restricted(0, 2); }, "not within");
  expect_invalid([&] { line.without_knot(0.5); }, "is not there");
  expect_invalid([&] { line.without_knot(0); }, "not inside");
  expect_invalid([&] { line.with_domain(1, 1); }, "empty");
  expect_invalid([&] { line.with_domain(0, infinity); }, "not finite");
  expect_invalid([&] { line.elevated(0); }, "cannot be elevated");
  expect_invalid([] { C::from_periodic(2, {0, 1, 2}, {{0, 0}}); }, "1 where 2");
  expect_invalid([] { C::from_periodic(2, {0, 0}, {{0, 0}}); }, "period is empty");
  expect_invalid([] { C::from_periodic(0, {0, 1}, {{0, 0}}); }, "too low");
  expect_invalid([] { C::from_periodic(2, {0, 0, 1, 1}, {{0, 0}, {1, 0}, {1, 1}}); }, "torn");
  expect_invalid([] { C::from_periodic(2, {0, 2, 1, 3}, {{0, 0}, {1, 0}, {1, 1}}); }, "smaller");
  const SC::Bspline_function<double> f({1}, {{0, 0, 1, 1}}, {1, 2}), g({1}, {{0, 0, 2, 2}}, {1, 2});
  expect_invalid([&] { C::from_homogeneous_coordinates({f, f}, g); }, "different domains");
  expect_invalid([&] { C::from_homogeneous_coordinates({f, f.embedded({{0, 1}, {0, 1}}, {0})}, f); }, "2 where 1");
  expect_invalid([&] { C::from_homogeneous_coordinates({f, f}, SC::Bspline_function<double>()); }, "0 where 1");
}

} // namespace

} // namespace Bspline_curve_test
