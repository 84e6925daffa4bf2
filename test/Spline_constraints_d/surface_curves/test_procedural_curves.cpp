// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offsets, evolutes and a locus of the test's own as operands of intersections, against exact answers.

#include <CGAL/Spline_constraints_d/geometry/curves/Evolute_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Implicit_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Offset_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/curve_features/offset_features_2.h>
#include <CGAL/Spline_constraints_d/operations/intersections/locus_intersections.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace procedural_curves_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Invalid_input;
using SC::Power_polynomial;
using Kind = SC::Intersection_kind;
using K = CGAL::Simple_cartesian<Exact_rational>;
using Points = std::vector<K::Point_2>;
using Range = std::pair<Exact_rational, Exact_rational>;

const Power_polynomial x = Power_polynomial::variable(0), y = Power_polynomial::variable(1);
const SC::Implicit_curve_2::Box wide{{{-9, 9}, {-9, 9}}};
const auto parabola = SC::bezier_curve(Points{{-2, 4}, {0, -4}, {2, 4}}).with_domain(-2, 2);   // (u, u^2)

Exact_rational ratio(int a, int b) { return Exact_rational(a) / b; }

template <int d>
void expect_complete(const SC::Locus_intersections<d>& intersections, std::size_t size)
{
  EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
  EXPECT_EQ(intersections.size(), size);
}

// The parameters on an operand, in increasing order.
template <int d>
std::vector<double> parameters_of(const SC::Locus_intersections<d>& intersections, std::size_t operand)
{
  std::vector<double> result;
  for (const auto& answer : intersections)
    result.push_back(std::nearbyint(answer.parameter(operand) * 1e9) / 1e9 + 0.0);
  std::sort(result.begin(), result.end());
  return result;
}

// At the distance 1 inside of the parabola. Its offset meets the axis where it begins to turn, and twice in (0, 5/4),
// where it meets itself.
TEST(Procedural_curves, OffsetOfParabola)
{
  const SC::Offset_curve_2 offset(parabola, 1);
  const auto axis = SC::segment_curve(K::Point_2(0, -3), K::Point_2(0, 3));
  const SC::Implicit_curve_2 implicit_axis(x, wide);
  for (const auto& answers : {SC::intersections(offset, axis), SC::intersections(offset, implicit_axis)}) {
    expect_complete(answers, 3);
    EXPECT_EQ(answers.count(Kind::TRANSVERSAL), 3u);
    EXPECT_EQ(parameters_of(answers, 0), (std::vector<double>{-0.866025404, 0, 0.866025404}));
    for (const auto& answer : answers) {
      EXPECT_NEAR(answer.coordinate(0).value(), 0, 1e-12);
      EXPECT_NEAR(answer.coordinate(1).value(), std::abs(answer.parameter(0)) < 0.5 ? 1 : 1.25, 1e-12);
    }
  }
  const auto across =
      SC::intersections(SC::segment_curve(K::Point_2(-4, ratio(5, 4)), K::Point_2(4, ratio(5, 4))), offset);
  EXPECT_EQ(parameters_of(across, 1), (std::vector<double>{-0.866025404, 0.866025404}));
  // On the other side there is one point.
  const auto below = SC::intersections(SC::Offset_curve_2(parabola, -1), axis);
  expect_complete(below, 1);
  EXPECT_NEAR(below[0].coordinate(1).value(), -1, 1e-14);

  const auto itself = SC::self_intersections(offset);
  expect_complete(itself, 1);
  EXPECT_EQ(itself[0].kind(), Kind::TRANSVERSAL);
  EXPECT_NEAR(itself[0].parameter(0), -std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(itself[0].parameter(1), std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(itself[0].coordinate(0).value(), 0, 1e-12);
  EXPECT_NEAR(itself[0].coordinate(1).value(), 1.25, 1e-12);
  const auto cusps = SC::cusps(offset);
  expect_complete(cusps, 2);
  EXPECT_EQ(cusps.count(Kind::TRANSVERSAL), 2u);
  EXPECT_NEAR(std::abs(cusps[0].parameter(0)), std::sqrt(std::cbrt(4.0) - 1) / 2, 1e-14);
  for (const auto& cusp : cusps) {
    const std::array<double, 2> p = offset(cusp.parameter_range(0).first);
    EXPECT_NEAR(cusp.coordinate(0).value(), p[0], 1e-7);
    EXPECT_NEAR(cusp.coordinate(1).value(), p[1], 1e-7);
  }
  // Up to the distance 1/2 there are none; then the first cusp is the center of curvature at the vertex: the offset
  // goes on.
  for (const Exact_rational& r : std::vector<Exact_rational>{ratio(1, 2), ratio(1, 3), -1})
    expect_complete(SC::self_intersections(SC::Offset_curve_2(parabola, r)), 0);
  expect_complete(SC::cusps(SC::Offset_curve_2(parabola, -1)), 0);
  const auto vertex = SC::cusps(SC::Offset_curve_2(parabola, ratio(1, 2)));
  expect_complete(vertex, 1);
  EXPECT_EQ(vertex[0].kind(), Kind::TANGENT);
  EXPECT_EQ(vertex[0].multiplicity(), 2);
  EXPECT_EQ(vertex[0].parameter_range(0), Range(0, 0));
}

// The parabola above in two pieces of different speed, an ellipse with its seam on the axis, and a closed spline:
// breaks of the curve are no self-intersections.
TEST(Procedural_curves, SelfIntersectionsAcrossBreaks)
{
  const SC::Bspline_curve_2<K> two(2, {0, 0, 0, 1, 1, 3, 3, 3}, {{-2, 4}, {-1, 0}, {0, 0}, {1, 0}, {2, 4}});
  const auto at_vertex = SC::self_intersections(SC::Offset_curve_2(two, 1));
  expect_complete(at_vertex, 1);
  EXPECT_NEAR(at_vertex[0].parameter(0), 1 - std::sqrt(3.0) / 4, 1e-12);
  EXPECT_NEAR(at_vertex[0].parameter(1), 1 + std::sqrt(0.75), 1e-12);
  EXPECT_NEAR(at_vertex[0].coordinate(1).value(), 1.25, 1e-12);

  // The normal from (x,y) on the ellipse meets the axis at 3x/4, at the distance 3/4 if x^2/16 + y^2 = 9/16: so x^2 =
  // 7/3.
  const auto ellipse = SC::ellipse_curve(K::Point_2(0, 0), K::Vector_2(2, 0), K::Vector_2(0, 1));
  const auto at_seam = SC::self_intersections(SC::Offset_curve_2(ellipse, ratio(3, 4)));
  expect_complete(at_seam, 2);
  for (const auto& answer : at_seam) {
    EXPECT_NEAR(answer.coordinate(1).value(), 0, 1e-12);
    EXPECT_NEAR(std::abs(answer.coordinate(0).value()), std::sqrt(21.0) / 4, 1e-12);
  }
  expect_complete(SC::self_intersections(SC::Offset_curve_2(ellipse, ratio(1, 3))), 0);
  expect_complete(SC::self_intersections(SC::Offset_curve_2(ellipse, -1)), 0);

  const auto corner =
      SC::self_intersections(SC::Offset_curve_2(SC::polyline_curve(Points{{0, 0}, {2, 0}, {2, 2}}), ratio(1, 2)));
  expect_complete(corner, 1);
  EXPECT_EQ(parameters_of(corner, 0), (std::vector<double>{0.75}));
  EXPECT_EQ(parameters_of(corner, 1), (std::vector<double>{1.25}));
}

TEST(Procedural_curves, OffsetsOfCircles)
{
  const auto circle = SC::circle_curve(K::Point_2(0, 0), K::FT(1));
  const SC::Offset_curve_2 outside(circle, -1);   // the radius is 2
  // The seam is found once, with the first parameter, and is an end.
  const auto seam = SC::intersections(outside, SC::segment_curve(K::Point_2(0, 0), K::Point_2(5, 0)));
  expect_complete(seam, 1);
  EXPECT_EQ(seam[0].kind(), Kind::END_POINT);
  EXPECT_EQ(seam[0].parameter_range(0), Range(0, 0));
  EXPECT_TRUE(seam[0].is_at_end(0) && !seam[0].is_at_end(1));
  EXPECT_NEAR(seam[0].parameter(1), 0.4, 1e-15);
  const auto knot = SC::intersections(SC::segment_curve(K::Point_2(0, 0), K::Point_2(0, 5)), outside);
  expect_complete(knot, 1);
  EXPECT_EQ(knot[0].kind(), Kind::TRANSVERSAL);
  EXPECT_NEAR(knot[0].parameter(1), 1, 1e-12);

  for (int slope = -5; slope <= 5; ++slope) {   // through the seam (2,0) and another point
    const auto chord =
        SC::intersections(outside, SC::segment_curve(K::Point_2(-10, -12 * slope), K::Point_2(10, 8 * slope)));
    expect_complete(chord, 2);
    EXPECT_EQ(chord.count(Kind::END_POINT), 1u);
    EXPECT_EQ(chord.count(Kind::TRANSVERSAL), 1u);
  }

  // Circles of radius 2 around (0,0) and (3,0), as offset of a curve, equation and curve.
  const auto other = SC::circle_curve(K::Point_2(3, 0), K::FT(1));
  const SC::Implicit_curve_2 equation(pow(x - 3, 2) + y * y - 4, wide);
  for (const auto& answers :
       {SC::intersections(outside, SC::Offset_curve_2(other, -1)), SC::intersections(outside, equation),
        SC::intersections(outside, SC::circle_curve(K::Point_2(3, 0), K::FT(2)))}) {
    expect_complete(answers, 2);
    EXPECT_EQ(answers.count(Kind::TRANSVERSAL), 2u);
    for (const auto& answer : answers) {
      EXPECT_NEAR(answer.coordinate(0).value(), 1.5, 1e-12);
      EXPECT_NEAR(std::abs(answer.coordinate(1).value()), std::sqrt(1.75), 1e-12);
    }
  }
  const auto touching = SC::intersections(outside, SC::Implicit_curve_2(y - 2, wide));
  expect_complete(touching, 1);
  EXPECT_EQ(touching[0].kind(), Kind::TANGENT);

  // The offset of an arc is an arc; the offset at the distance of the radius is the center.
  const auto arc = circle.restricted(ratio(1, 4), ratio(3, 4));
  const auto overlap = SC::intersections(SC::Offset_curve_2(arc, -1), SC::Implicit_curve_2(x * x + y * y - 4, wide));
  expect_complete(overlap, 1);
  EXPECT_EQ(overlap[0].kind(), Kind::OVERLAP);
  EXPECT_EQ(overlap[0].parameter_range(0), Range(ratio(1, 4), ratio(3, 4)));
  const auto center = SC::cusps(SC::Offset_curve_2(arc, 1));
  expect_complete(center, 1);
  EXPECT_EQ(center[0].kind(), Kind::OVERLAP);
}

TEST(Procedural_curves, EndsAndCorners)
{
  // y = 1/2 up to (2,1/2), and x = 3/2 from (3/2,0) on
  const SC::Offset_curve_2 offset(SC::polyline_curve(Points{{0, 0}, {2, 0}, {2, 2}}), ratio(1, 2));
  const auto at = [&](const K::Point_2& p, const K::Point_2& q) {
    return SC::intersections(offset, SC::segment_curve(p, q));
  };
  const auto end = at({0, -1}, {0, 2});
  expect_complete(end, 1);
  EXPECT_TRUE(end[0].kind() == Kind::END_POINT && end[0].is_at_end(0));
  const auto corner = at({2, -1}, {2, 3});
  expect_complete(corner, 1);
  EXPECT_FALSE(corner[0].is_at_end(0));
  EXPECT_NEAR(corner[0].parameter(0), 1, 1e-15);
  expect_complete(at({ratio(9, 4), -1}, {ratio(9, 4), 3}), 0);   // no arc around the corner
  expect_complete(at({1, 0}, {2, 1}), 2);                        // the two parts cross in (3/2, 1/2)

  // The end (-3,4) on a circle: decided although the auxiliary unknown is there.
  const SC::Offset_curve_2 ray(SC::segment_curve(K::Point_2(0, 0), K::Point_2(4, 3)), 5);
  const auto on_circle = SC::intersections(ray, SC::Implicit_curve_2(pow(x + 3, 2) + y * y - 16, wide));
  expect_complete(on_circle, 1);
  EXPECT_EQ(on_circle[0].kind(), Kind::END_POINT);
  EXPECT_EQ(on_circle[0].parameter_range(0), Range(0, 0));
}

TEST(Procedural_curves, Evolutes)
{
  const SC::Evolute_2 evolute(parabola);
  for (const Exact_rational& t : std::vector<Exact_rational>{-2, 0, ratio(1, 3), 1})
    EXPECT_EQ(evolute(t),
              (std::array<Exact_rational, 2>{Exact_rational(-4 * t * t * t), Exact_rational(3 * t * t + ratio(1, 2))}));
  const SC::Implicit_curve_2 semicubical(27 * x * x - 16 * pow(y - ratio(1, 2), 3), {{{-40, 40}, {0, 20}}});
  const auto same = SC::intersections(evolute, semicubical);
  expect_complete(same, 1);
  EXPECT_EQ(same[0].kind(), Kind::OVERLAP);
  EXPECT_EQ(same[0].parameter_range(0), Range(-2, 2));

  const auto across = SC::intersections(evolute, SC::segment_curve(K::Point_2(-4, 2), K::Point_2(4, 2)));
  expect_complete(across, 2);
  EXPECT_EQ(parameters_of(across, 0), (std::vector<double>{-0.707106781, 0.707106781}));
  const auto cusp = SC::intersections(evolute, SC::Implicit_curve_2(x, wide));
  expect_complete(cusp, 1);
  EXPECT_TRUE(cusp[0].kind() == Kind::TANGENT && cusp[0].multiplicity() == 3);
  const auto two =
      SC::intersections(evolute, SC::Evolute_2(parabola.transformed(K::Aff_transformation_2(0, 1, 0, 1, 0, 0))));
  expect_complete(two, 1);
  EXPECT_NEAR(two[0].coordinate(0).value(), two[0].coordinate(1).value(), 1e-12);

  // An evolute with a pole, at the inflection of a cubic; and straight curves, which have none.
  // y = x^3
  const SC::Evolute_2 of_cubic(SC::bezier_curve(Points{{-1, -1}, {ratio(-1, 3), 1}, {ratio(1, 3), -1}, {1, 1}}));
  EXPECT_FALSE(of_cubic(ratio(1, 2)));
  const auto far = SC::intersections(of_cubic, SC::segment_curve(K::Point_2(-100, 100), K::Point_2(100, 100)));
  EXPECT_TRUE(far.is_complete());
  for (const auto& answer : far)
    EXPECT_NEAR(CGAL::to_double((*of_cubic(answer.parameter_range(0).first))[1]), 100, 1e-6);
  EXPECT_EQ(far.size(), 1u);
  expect_complete(SC::intersections(SC::Evolute_2(SC::segment_curve(K::Point_2(0, 0), K::Point_2(1, 1))), semicubical),
                  0);
}

// (2x)^(2/3) + y^(2/3) = 3^(2/3), piece by piece.
TEST(Procedural_curves, EvoluteOfEllipse)
{
  const SC::Evolute_2 evolute(SC::ellipse_curve(K::Point_2(0, 0), K::Vector_2(2, 0), K::Vector_2(0, 1)));
  const SC::Implicit_curve_2 astroid(pow(4 * x * x + y * y - 9, 3) + 972 * x * x * y * y, wide);
  const auto same = SC::intersections(evolute, astroid);
  EXPECT_TRUE(same.is_complete());
  Exact_rational length = 0;
  for (const auto& answer : same)
    if (answer.kind() == Kind::OVERLAP)
      length += answer.parameter_range(0).second - answer.parameter_range(0).first;
  EXPECT_EQ(length, 4);
  for (const Exact_rational& t : std::vector<Exact_rational>{0, ratio(2, 3), ratio(7, 2)})
    EXPECT_EQ(astroid(*evolute(t)), 0);
  // A circle around the center crosses it in eight points; the line through two cusps meets it in these only.
  expect_complete(SC::intersections(evolute, SC::circle_curve(K::Point_2(0, 0), K::FT(ratio(5, 4)))), 8);
  const auto cusps = SC::intersections(evolute, SC::Implicit_curve_2(y, wide));
  expect_complete(cusps, 2);
  EXPECT_EQ(parameters_of(cusps, 0), (std::vector<double>{0, 2}));
}

// A normal of a random curve meets its offset at its foot.
TEST(Procedural_curves, PlantedNormals)
{
  std::mt19937 random(11);
  const auto number = [&](int range) { return Exact_rational(static_cast<int>(random() % (2 * range + 1)) - range); };
  int found = 0;
  for (int round = 0; round < 30; ++round) {
    const auto curve = SC::bezier_curve(
        Points{{0, number(9)}, {5 + number(3), number(9)}, {12 + number(3), number(9)}, {20, number(9)}});
    const Exact_rational t = ratio(static_cast<int>(1 + random() % 9), 10);
    const K::Vector_2 normal = curve.normal(t);
    const SC::Offset_curve_2 offset(curve, 1);
    const auto answers = SC::intersections(offset, SC::segment_curve(curve(t), curve(t) + 3 * normal));
    ASSERT_TRUE(answers.is_complete()) << round << ' ' << answers.summary();
    EXPECT_EQ(std::count_if(answers.begin(), answers.end(),
                            [&](const auto& answer) {
                              return answer.parameter_range(0).first <= t && t <= answer.parameter_range(0).second;
                            }),
              1)
        << round;
    for (const auto& answer : answers) {
      const std::array<double, 2> p = offset(answer.parameter_range(0).first);
      EXPECT_NEAR(p[0], answer.coordinate(0).value(), 1e-9);
      EXPECT_NEAR(p[1], answer.coordinate(1).value(), 1e-9);
    }
    found += static_cast<int>(answers.size());
  }
  EXPECT_GE(found, 30);
}

// A line as a curve and as an equation, and all of it turned by the angle of a 3-4-5 triangle: the same answers of both
// descriptions of offsets and evolutes.
TEST(Procedural_curves, TwoDescriptions)
{
  std::mt19937 random(23);
  const auto number = [&](int range) { return Exact_rational(static_cast<int>(random() % (2 * range + 1)) - range); };
  const K::Aff_transformation_2 turn(ratio(3, 5), ratio(-4, 5), ratio(4, 5), ratio(3, 5));
  std::size_t found = 0;
  for (int round = 0; round < 30; ++round) {
    const auto curve = SC::bezier_curve(Points{{0, number(9)}, {4, number(9)}, {12, number(9)}, {20, number(9)}},
                                        round % 3 == 0 ? std::vector<K::FT>{1, 2, 2, 1} : std::vector<K::FT>{});
    const K::Point_2 p(0, number(8)), q(20, number(8));
    const auto segment = SC::segment_curve(p - 3 * (q - p), q + 3 * (q - p));
    const K::Line_2 line(p, q);
    const SC::Implicit_curve_2 equation(Power_polynomial(line.a()) * x + Power_polynomial(line.b()) * y +
                                            Power_polynomial(line.c()),
                                        {{{-60, 80}, {-4000, 4000}}});
    const Exact_rational r = round % 2 == 0 ? ratio(3, 2) : ratio(-5, 7);
    const SC::Offset_curve_2 offset(curve, r), turned(curve.transformed(turn), r);
    const auto by_curve = SC::intersections(offset, segment), by_equation = SC::intersections(offset, equation),
               of_turned = SC::intersections(segment.transformed(turn), turned);
    EXPECT_TRUE(by_curve.is_complete() && by_equation.is_complete() && of_turned.is_complete()) << round;
    EXPECT_EQ(parameters_of(by_curve, 0), parameters_of(by_equation, 0)) << round;
    EXPECT_EQ(parameters_of(by_curve, 0), parameters_of(of_turned, 1)) << round;
    found += by_curve.size();
    const SC::Evolute_2 evolute(curve);
    const auto on_segment = SC::intersections(evolute, segment), on_equation = SC::intersections(evolute, equation);
    EXPECT_TRUE(on_segment.is_complete() && on_equation.is_complete()) << round;
    for (const auto& answer : on_segment)   // the segment ends, the box is wider
      EXPECT_EQ(
          std::count_if(on_equation.begin(), on_equation.end(),
                        [&](const auto& other) { return std::abs(other.parameter(0) - answer.parameter(0)) < 1e-9; }),
          1)
          << round;
    found += on_segment.size();
  }
  EXPECT_GE(found, 25u);
}

// Above the paraboloid z = x^2 + y^2, from the feet (3/8, 0) and another one on the same vertical line.
TEST(Procedural_curves, OffsetSurface)
{
  using Surface = SC::Bspline_surface_3<K>;
  std::vector<K::Point_3> points;
  for (const int u : {-1, 0, 1})
    for (const int v : {-1, 0, 1})
      points.emplace_back(u, v, (u == 0 ? -1 : 1) + (v == 0 ? -1 : 1));
  const Surface paraboloid =
      Surface({2, 2}, {0, 0, 0, 1, 1, 1}, {0, 0, 0, 1, 1, 1}, points).with_domain(0, -1, 1).with_domain(1, -1, 1);
  const SC::Offset_surface_3 offset(paraboloid, 1);
  const auto line = SC::segment_curve(K::Point_3(ratio(-9, 40), 0, 0), K::Point_3(ratio(-9, 40), 0, 3));
  const auto answers = SC::intersections(line, offset);
  expect_complete(answers, 2);
  EXPECT_EQ(answers.count(Kind::TRANSVERSAL), 2u);
  EXPECT_TRUE(std::any_of(answers.begin(), answers.end(), [](const auto& answer) {
    return std::abs(answer.parameter(1, 0) - 0.375) < 1e-12 && std::abs(answer.parameter(1, 1)) < 1e-12 &&
        std::abs(answer.coordinate(2).value() - 301.0 / 320) < 1e-12;
  }));
  EXPECT_THROW(SC::Offset_surface_3(SC::sphere_surface(K::Point_3(0, 0, 0), K::FT(1)), 1), Invalid_input);
}

TEST(Procedural_curves, BadInput)
{
  EXPECT_THROW(SC::Offset_curve_2(parabola, 0), Invalid_input);
  // (u^2, u^3) on [-1,1]
  const auto cusp = SC::bezier_curve(Points{{1, -1}, {ratio(-1, 3), 1}, {ratio(-1, 3), -1}, {1, 1}});
  EXPECT_THROW(SC::Offset_curve_2(cusp, 1), Invalid_input);
  EXPECT_THROW(SC::Evolute_2{cusp}, Invalid_input);
  EXPECT_THROW(SC::Offset_curve_2(parabola, 1)(3), Invalid_input);
  EXPECT_THROW(SC::intersections(SC::Offset_curve_2(parabola, 1), SC::Implicit_curve_2(x, wide), {.tolerance = -1}),
               Invalid_input);
}

// The midpoints between the origin and the points of a curve: a locus that the package does not know.
class Halved_parabola
{
public:
  static constexpr int dimension = 2, number_of_parameters = 1, codimension = 1;

  Range domain(int) const { return {-2, 2}; }

  std::vector<SC::Locus_piece<2>> locus_pieces() const
  {
    SC::Locus_piece<2> piece;
    piece.parameters = {domain(0)};
    piece.is_without_end = {false};
    piece.point = [](std::span<const SC::Unknown> u) { return SC::Vector_expression<2>(u[0] / 2, u[0] * u[0] / 2); };
    piece.incidence = [point = piece.point](const SC::Vector_expression<2>& p, std::span<const SC::Unknown> u) {
      return std::vector<SC::Constraint>{p.x() == point(u).x(), p.y() == point(u).y()};
    };
    return {piece};
  }

  std::vector<SC::Locus_end<2>> locus_ends() const { return {}; }
};

static_assert(SC::Locus<Halved_parabola> && SC::Locus<SC::Offset_curve_2> && SC::Locus<SC::Offset_surface_3> &&
              SC::Locus<SC::Evolute_2> && SC::Locus<SC::Implicit_curve_2> && SC::Locus<SC::Parametric_locus<2, 3>> &&
              !SC::Locus<decltype(parabola)> && !SC::Locus<int>);

TEST(Procedural_curves, StubOfLocus)
{
  const auto implicit = SC::intersections(Halved_parabola(), SC::Implicit_curve_2(y - 1, wide));
  expect_complete(implicit, 2);
  EXPECT_EQ(parameters_of(implicit, 0), (std::vector<double>{-1.414213562, 1.414213562}));
  const auto offset = SC::intersections(SC::Offset_curve_2(SC::segment_curve(K::Point_2(-3, 0), K::Point_2(3, 0)), 1),
                                        Halved_parabola());
  expect_complete(offset, 2);
  EXPECT_EQ(parameters_of(offset, 1), (std::vector<double>{-1.414213562, 1.414213562}));
}

} // namespace

} // namespace procedural_curves_test
