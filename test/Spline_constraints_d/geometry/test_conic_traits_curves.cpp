// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "arrangement_test_tools.h"
#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/conversions/conic_traits_curves.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>

#include <CGAL/Arr_conic_traits_2.h>
#include <CGAL/CORE_algebraic_number_traits.h>
#include <CGAL/Cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace conic_traits_curves_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using Nt_traits = CGAL::CORE_algebraic_number_traits;
using Rational = Nt_traits::Rational;
using Algebraic = Nt_traits::Algebraic;
using R = CGAL::Cartesian<Rational>;
using Traits = CGAL::Arr_conic_traits_2<R, CGAL::Cartesian<Algebraic>, Nt_traits>;
using Arc = Traits::Curve_2;
using Point = Traits::Point_2;

// It runs between these points, turning this way, on the conic.
template <class Curve, class Any_arc>
void expect_arc(const Curve& curve, const R::Point_2& source, const R::Point_2& target, CGAL::Orientation orientation,
                const Any_arc& arc)
{
  EXPECT_EQ(curve.source(), source);
  EXPECT_EQ(curve.target(), target);
  const SC::internal::Conic_equation conic = SC::internal::conic_equation(arc);
  const auto [begin, end] = curve.domain();
  const auto at = [&](int i) { return curve(begin + (end - begin) * Rational(i, 6)); };
  for (int i = 0; i <= 6; ++i)
    EXPECT_EQ(conic(SC::internal::exact_object(at(i))), 0);
  for (int i = 0; i <= 4; ++i)
    EXPECT_EQ(CGAL::orientation(at(i), at(i + 1), at(i + 2)), orientation);
}

TEST(Conic_traits_curves, arcs_of_ellipses_are_converted)
{
  // x^2 + 4 y^2 = 25
  for (const auto orientation : {CGAL::COUNTERCLOCKWISE, CGAL::CLOCKWISE}) {
    const Arc arc(1, 4, 0, 0, 0, -25, orientation, Point(5, 0), Point(-3, 2));
    ASSERT_TRUE(arc.is_valid());
    const auto curve = SC::to_bspline_curve(arc);
    expect_arc(curve, {5, 0}, {-3, 2}, orientation, arc);
    const auto [begin, end] = curve.domain();
    EXPECT_EQ(curve((begin + end) / 2).y() > 0, orientation == CGAL::COUNTERCLOCKWISE);
  }
  const Arc through(R::Point_2(0, 5), R::Point_2(3, 4), R::Point_2(5, 0));
  expect_arc(SC::to_bspline_curve(through), {0, 5}, {5, 0}, CGAL::CLOCKWISE, through);
  const Arc irrational(1, 1, 0, 0, 0, -2, CGAL::COUNTERCLOCKWISE, Point(CGAL::sqrt(Algebraic(2)), 0),
                       Point(0, CGAL::sqrt(Algebraic(2))));
  expect_invalid([&] { SC::to_bspline_curve(irrational); }, "no rational coordinates");
}

TEST(Conic_traits_curves, both_arcs_between_two_points_make_an_ellipse)
{
  // Points of x^2 + 4 y^2 = 25 with rational slopes from (-5, 0).
  Random_source random(5);
  const auto point = [&] {
    const Rational t(random.integer(-20, 20), random.integer(1, 7)), norm = 1 + t * t;
    return R::Point_2(5 * (1 - t * t) / norm, 5 * t / norm);
  };
  for (int i = 0; i < 20; ++i) {
    const R::Point_2 p = point(), q = point();
    if (p == q)
      continue;
    Exact_rational length(0);
    for (const auto orientation : {CGAL::COUNTERCLOCKWISE, CGAL::CLOCKWISE}) {
      const Arc arc(1, 4, 0, 0, 0, -25, orientation, Point(p.x(), p.y()), Point(q.x(), q.y()));
      const auto curve = SC::to_bspline_curve(arc);
      expect_arc(curve, p, q, orientation, arc);
      const auto exact = SC::internal::exact_curve<2>(curve);
      length += exact.domain().second - exact.domain().first;
    }
    EXPECT_EQ(length, 4);
  }
}

TEST(Conic_traits_curves, x_monotone_arcs_are_converted)
{
  const Traits traits;
  std::vector<Variant<Traits::Point_2, Traits::X_monotone_curve_2>> parts;
  traits.make_x_monotone_2_object()(Arc(1, 4, 0, 0, 0, -25), std::back_inserter(parts));
  EXPECT_EQ(parts.size(), 2u);
  for (const auto& part : parts) {
    const auto* arc = get_if<Traits::X_monotone_curve_2>(&part);
    ASSERT_NE(arc, nullptr);
    const auto curve = SC::to_bspline_curve(*arc);
    const bool is_from_left = curve.source() == R::Point_2(-5, 0);
    expect_arc(curve, {is_from_left ? -5 : 5, 0}, {is_from_left ? 5 : -5, 0}, arc->orientation(), *arc);
  }
}

TEST(Conic_traits_curves, whole_ellipses_are_converted)
{
  const Arc circle(R::Circle_2(R::Point_2(1, 2), Rational(5)));
  const auto curve = SC::to_bspline_curve(circle);
  EXPECT_TRUE(curve.is_closed());
  EXPECT_EQ(CGAL::squared_distance(curve(Rational(1, 3)), R::Point_2(1, 2)), 5);
  // x^2 + x y + y^2 = 7 around (1, -1)
  const Arc ellipse(1, 1, 1, -1, 1, -6);
  const auto slanted = SC::to_bspline_curve(ellipse);
  EXPECT_TRUE(slanted.is_closed());
  const SC::internal::Conic_equation conic = SC::internal::conic_equation(ellipse);
  for (int i = 0; i <= 8; ++i)
    EXPECT_EQ(conic(SC::internal::exact_object(slanted(Rational(i, 2)))), 0);
  EXPECT_EQ(CGAL::orientation(slanted(0), slanted(1), slanted(2)), ellipse.orientation());
  // x^2 + y^2 = 3 has no rational point.
  expect_invalid([] { SC::to_bspline_curve(Arc(1, 1, 0, 0, 0, -3)); }, "there is no point");
}

TEST(Conic_traits_curves, parabolas_hyperbolas_and_segments_are_converted)
{
  // y = x^2, and x y = 1
  const Arc parabola(1, 0, 0, 0, -1, 0, CGAL::COUNTERCLOCKWISE, Point(-1, 1), Point(2, 4));
  ASSERT_TRUE(parabola.is_valid());
  expect_arc(SC::to_bspline_curve(parabola), {-1, 1}, {2, 4}, CGAL::COUNTERCLOCKWISE, parabola);
  const Arc backwards(1, 0, 0, 0, -1, 0, CGAL::CLOCKWISE, Point(2, 4), Point(-1, 1));
  expect_arc(SC::to_bspline_curve(backwards), {2, 4}, {-1, 1}, CGAL::CLOCKWISE, backwards);
  const Arc hyperbola(0, 0, 1, 0, 0, -1, CGAL::COUNTERCLOCKWISE, Point(Algebraic(1) / Algebraic(2), 2),
                      Point(3, Algebraic(1) / Algebraic(3)));
  ASSERT_TRUE(hyperbola.is_valid());
  expect_arc(SC::to_bspline_curve(hyperbola), {Rational(1, 2), 2}, {3, Rational(1, 3)}, CGAL::COUNTERCLOCKWISE,
             hyperbola);

  const auto segment = SC::to_bspline_curve(Arc(R::Segment_2(R::Point_2(1, 2), R::Point_2(4, 6))));
  EXPECT_EQ(segment.degree(), 1);
  EXPECT_EQ(segment.source(), R::Point_2(1, 2));
  EXPECT_EQ(segment.target(), R::Point_2(4, 6));
  expect_invalid([] { SC::to_bspline_curve(Arc()); }, "not valid");
}

// It is the same arc: on the same conic, which has one equation with coprime integers, up to the sign.
void expect_same_arc(const Arc& back, const Arc& arc)
{
  ASSERT_TRUE(back.is_valid());
  EXPECT_EQ(back.orientation(), arc.orientation());
  EXPECT_EQ(back.is_full_conic(), arc.is_full_conic());
  if (!arc.is_full_conic()) {
    EXPECT_TRUE(back.source() == arc.source());
    EXPECT_TRUE(back.target() == arc.target());
  }
  if (arc.orientation() == CGAL::COLLINEAR)
    return;
  const std::vector<CORE::BigInt> a{arc.r(), arc.s(), arc.t(), arc.u(), arc.v(), arc.w()},
      b{back.r(), back.s(), back.t(), back.u(), back.v(), back.w()};
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_EQ(a[i] * b[j], a[j] * b[i]);
}

TEST(Conic_traits_curves, are_given_back)
{
  const std::vector<Arc> arcs{
      Arc(1, 4, 0, 0, 0, -25, CGAL::COUNTERCLOCKWISE, Point(5, 0), Point(-3, 2)),
      Arc(1, 4, 0, 0, 0, -25, CGAL::CLOCKWISE, Point(5, 0), Point(-3, 2)),
      Arc(1, 4, 0, 0, 0, -25, CGAL::COUNTERCLOCKWISE, Point(-3, 2), Point(-4, Algebraic(3) / Algebraic(2))),
      Arc(1, 4, 0, 0, 0, -25, CGAL::CLOCKWISE, Point(-3, 2), Point(-4, Algebraic(3) / Algebraic(2))),
      Arc(1, 0, 0, 0, -1, 0, CGAL::COUNTERCLOCKWISE, Point(-1, 1), Point(2, 4)),
      Arc(0, 0, 1, 0, 0, -1, CGAL::COUNTERCLOCKWISE, Point(Algebraic(1) / Algebraic(2), 2),
          Point(3, Algebraic(1) / Algebraic(3))),
      Arc(R::Segment_2(R::Point_2(1, 2), R::Point_2(4, 6))),
      Arc(R::Circle_2(R::Point_2(1, 2), Rational(5))),
      Arc(1, 1, 1, -1, 1, -6),
      Arc(-1, -1, -1, 1, -1, 6)};
  for (const Arc& arc : arcs) {
    ASSERT_TRUE(arc.is_valid());
    const auto curve = SC::to_bspline_curve(arc);
    for (const auto& same : {curve, curve.elevated(curve.degree() + 2)}) {
      const auto back = SC::to_conic_traits_curves<Traits>(same);
      ASSERT_TRUE(back);
      ASSERT_EQ(back->size(), 1u);
      expect_same_arc(back->front(), arc);
    }
  }
}

// Times 1 + t^2, a parabola is of degree four; with another coordinate it is none.
TEST(Conic_traits_curves, of_curves_with_a_common_factor)
{
  const auto function = [](const std::vector<SC::Exact_rational>& powers) {
    return SC::Bspline_function<SC::Exact_rational>(
        {4}, {{0, 0, 0, 0, 0, 1, 1, 1, 1, 1}},
        SC::Bernstein_tensor<SC::Exact_rational>::from_power({4}, powers).coefficients());
  };
  const auto curve = [&](int cubic) {
    return SC::Bspline_curve_2<R>::from_homogeneous_coordinates(
        {function({0, 1, 0, 1, 0}), function({0, 0, 1, cubic, 1})}, function({1, 0, 1, 0, 0}));
  };
  const auto parts = SC::to_conic_traits_curves<Traits>(curve(0));
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->size(), 1u);
  expect_same_arc(parts->front(), Arc(1, 0, 0, 0, -1, 0, CGAL::COUNTERCLOCKWISE, Point(0, 0), Point(1, 1)));
  EXPECT_FALSE(SC::to_conic_traits_curves<Traits>(curve(1)));
}

TEST(Conic_traits_curves, of_curves_join_what_is_on_one_conic)
{
  using Points = std::vector<R::Point_2>;
  // A circle without a part, and two parabolas and a segment.
  const auto circle = SC::circle_curve<R>(R::Point_2(0, 0), Rational(5));
  const auto parts = SC::to_conic_traits_curves<Traits>(circle.restricted(Rational(1, 3), Rational(7, 2)));
  ASSERT_TRUE(parts);
  ASSERT_EQ(parts->size(), 1u);
  EXPECT_FALSE(parts->front().is_full_conic());
  EXPECT_EQ(parts->front().orientation(), CGAL::COUNTERCLOCKWISE);
  const SC::Bspline_curve_2<R> corner(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 3},
                                      {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {3, 3}, {4, 4}});
  const auto pieces = SC::to_conic_traits_curves<Traits>(corner);
  ASSERT_TRUE(pieces);
  ASSERT_EQ(pieces->size(), 3u);
  EXPECT_EQ((*pieces)[2].orientation(), CGAL::COLLINEAR);
  EXPECT_TRUE((*pieces)[2].source() == Point(2, 2) && (*pieces)[2].target() == Point(4, 4));

  // A cubic, a quadratic that runs back on a line, one that is slow at an end, and a point.
  EXPECT_FALSE(SC::to_conic_traits_curves<Traits>(SC::bezier_curve<R>(Points{{0, 0}, {1, 0}, {1, 1}, {0, 2}})));
  EXPECT_FALSE(SC::to_conic_traits_curves<Traits>(SC::bezier_curve<R>(Points{{0, 0}, {3, 3}, {2, 2}})));
  EXPECT_TRUE(SC::to_conic_traits_curves<Traits>(SC::bezier_curve<R>(Points{{0, 0}, {2, 2}, {2, 2}})));
  EXPECT_FALSE(SC::to_conic_traits_curves<Traits>(SC::bezier_curve<R>(Points{{1, 1}, {1, 1}, {1, 1}})));
}

// Random rational quadratic curves are arcs through their points: of ellipses and parabolas, where CGAL 5.5 is right
// about all of them.
TEST(Conic_traits_curves, of_random_curves_hold_their_points)
{
  Random_geometry random(17);
  std::size_t arcs = 0;
  for (int i = 0; i < 20; ++i) {
    const auto points = random.points<R, 2>(3);
    auto weights = Random_geometry::kernel_numbers<R>(random.weights(3));
    weights[1] = i == 0 ? weights[0] : (std::min)(weights[0], weights[2]) * Rational(random.integer(1, 9), 9);
    weights[2] = i == 0 ? weights[0] : weights[2];
    const SC::Bspline_curve_2<R> curve(2, {0, 0, 0, 1, 1, 1}, points, weights);
    if (CGAL::collinear(points[0], points[1], points[2]))
      continue;
    const auto parts = SC::to_conic_traits_curves<Traits>(curve);
    ASSERT_TRUE(parts);
    ASSERT_EQ(parts->size(), 1u);
    expect_arc(curve, points[0], points[2], CGAL::orientation(points[0], points[1], points[2]), parts->front());
    ++arcs;
  }
  EXPECT_GT(arcs, 15u);
}

} // namespace

} // namespace conic_traits_curves_test
