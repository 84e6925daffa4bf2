// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Intersections with implicit curves and surfaces against exact answers.

#include <CGAL/Spline_constraints_d/geometry/conversions/to_implicit.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Offset_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/intersections/locus_intersections.h>

#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace locus_intersections_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Power_polynomial;
using Kind = SC::Intersection_kind;
using K = CGAL::Simple_cartesian<Exact_rational>;
using Range = std::pair<Exact_rational, Exact_rational>;

const Power_polynomial x = Power_polynomial::variable(0), y = Power_polynomial::variable(1),
                       z = Power_polynomial::variable(2);
const SC::Implicit_curve_2::Box wide{{{-9, 9}, {-9, 9}}};
const SC::Implicit_surface_3::Box wide_in_space{{{-9, 9}, {-9, 9}, {-9, 9}}};

// Answers of one kind by their coordinates rounded to multiples of 1e-9.
template <int d>
std::vector<std::array<double, d>> points_of(const SC::Locus_intersections<d>& intersections, Kind kind)
{
  std::vector<std::array<double, d>> result;
  for (const auto& intersection : intersections)
    if (intersection.kind() == kind) {
      auto& point = result.emplace_back();
      for (std::size_t i = 0; i < d; ++i) {
        EXPECT_LT(intersection.coordinate_range(i).second - intersection.coordinate_range(i).first, 1e-12);
        point[i] = std::nearbyint(intersection.coordinate(i).value() * 1e9) / 1e9 + 0.0;
      }
    }
  std::sort(result.begin(), result.end());
  return result;
}

using Points = std::vector<std::array<double, 2>>;
using Points_3 = std::vector<std::array<double, 3>>;

template <int d>
void expect_complete(const SC::Locus_intersections<d>& intersections, std::size_t size)
{
  EXPECT_TRUE(intersections.is_complete()) << intersections.summary();
  EXPECT_EQ(intersections.size(), size);
}

TEST(Locus_intersections, ImplicitCurves)
{
  const SC::Implicit_curve_2 ellipse(x * x / 4 + y * y - 1, wide), circle(x * x - 2 * x + y * y, wide);
  const auto both = SC::intersections(ellipse, circle);
  expect_complete(both, 3);
  EXPECT_EQ(points_of(both, Kind::TRANSVERSAL), (Points{{0.666666667, -0.942809042}, {0.666666667, 0.942809042}}));
  EXPECT_EQ(points_of(both, Kind::TANGENT), (Points{{2, 0}}));
  EXPECT_EQ(both[2].multiplicity(), 2);
  // In boxes that meet in x <= 2/3: what is on the boundary belongs to them. In boxes that do not meet there is
  // nothing.
  const SC::Implicit_curve_2 part(circle.polynomial(), {{{-1, Exact_rational(2) / 3}, {0, 9}}}),
      apart(circle.polynomial(), {{{10, 11}, {0, 9}}});
  EXPECT_EQ(points_of(SC::intersections(ellipse, part), Kind::TRANSVERSAL), (Points{{0.666666667, 0.942809042}}));
  expect_complete(SC::intersections(ellipse, apart), 0);
}

TEST(Locus_intersections, CommonComponent)
{
  const SC::Implicit_curve_2 a((x - y) * (x * x + y * y - 1), wide), b((x - y) * (x + y - 1), wide);
  const auto both = SC::intersections(a, b);
  expect_complete(both, 3);
  EXPECT_EQ(points_of(both, Kind::TRANSVERSAL), (Points{{0, 1}, {1, 0}}));
  ASSERT_EQ(both.count(Kind::OVERLAP), 1u);
  EXPECT_EQ(both[2].coordinate_range(0), (std::pair<double, double>(-9, 9)));
}

// The curve begins, and ends, where it touches the ellipse: once, with the first parameter.
TEST(Locus_intersections, CurveAndImplicitCurve)
{
  const auto circle = SC::circle_curve(K::Point_2(1, 0), K::FT(1));
  const SC::Implicit_curve_2 ellipse(x * x / 4 + y * y - 1, wide);
  const auto both = SC::intersections(circle, ellipse);
  expect_complete(both, 3);
  EXPECT_EQ(points_of(both, Kind::TRANSVERSAL), (Points{{0.666666667, -0.942809042}, {0.666666667, 0.942809042}}));
  ASSERT_EQ(both.count(Kind::TANGENT), 1u);
  EXPECT_EQ(both[2].parameter_range(0), Range(0, 0));
  EXPECT_TRUE(both[2].is_at_end(0) && !both[2].is_at_end(1));
  EXPECT_EQ(both[2].multiplicity(), 2);
  EXPECT_EQ(points_of(SC::intersections(ellipse, circle), Kind::TRANSVERSAL), points_of(both, Kind::TRANSVERSAL));

  const SC::Implicit_curve_2 same(x * x - 2 * x + y * y, {{{-9, 9}, {0, 9}}});   // its upper half
  const auto overlap = SC::intersections(circle, same);
  EXPECT_TRUE(overlap.is_complete());
  ASSERT_EQ(overlap.count(Kind::OVERLAP), 1u);
  const auto& upper =
      *std::find_if(overlap.begin(), overlap.end(), [](const auto& answer) { return answer.kind() == Kind::OVERLAP; });
  EXPECT_EQ(upper.parameter_range(0), Range(0, 2));
}

TEST(Locus_intersections, EndsOfCurves)
{
  const SC::Implicit_curve_2 hyperbola(x * y - 1, {{{0, 9}, {0, 9}}});
  const auto at_end =
      SC::intersections(SC::segment_curve(K::Point_2(0, 0), K::Point_2(2, Exact_rational(1) / 2)), hyperbola);
  expect_complete(at_end, 1);
  EXPECT_EQ(at_end[0].kind(), Kind::END_POINT);
  EXPECT_EQ(at_end[0].parameter_range(0), Range(1, 1));
  const Exact_rational little = Exact_rational(1) / Exact_rational(1e40);
  expect_complete(
      SC::intersections(SC::segment_curve(K::Point_2(0, 0), K::Point_2(2, Exact_rational(1) / 2 - little)), hyperbola),
      0);
  const auto beyond =
      SC::intersections(SC::segment_curve(K::Point_2(0, 0), K::Point_2(2, Exact_rational(1) / 2 + little)), hyperbola);
  expect_complete(beyond, 1);
  EXPECT_EQ(beyond[0].kind(), Kind::TRANSVERSAL);
}

// On the torus with radii 2 and 1.
TEST(Locus_intersections, LinesAndTorus)
{
  const SC::Implicit_surface_3 torus(pow(x * x + y * y + z * z + 3, 2) - 16 * (x * x + y * y), wide_in_space);
  const auto along = [&](int px, int py, int pz, int vx, int vy, int vz) {
    return SC::intersections(SC::segment_curve(K::Point_3(px - 8 * vx, py - 8 * vy, pz - 8 * vz),
                                               K::Point_3(px + 7 * vx, py + 7 * vy, pz + 7 * vz)),
                             torus);
  };
  const auto through = along(0, 0, 0, 1, 0, 0);
  expect_complete(through, 4);
  EXPECT_EQ(points_of(through, Kind::TRANSVERSAL), (Points_3{{-3, 0, 0}, {-1, 0, 0}, {1, 0, 0}, {3, 0, 0}}));
  const auto two = along(2, 0, 0, 0, 1, 0);
  expect_complete(two, 2);
  EXPECT_EQ(points_of(two, Kind::TRANSVERSAL), (Points_3{{2, -2.236067977, 0}, {2, 2.236067977, 0}}));
  const auto touching = along(0, 0, 1, 1, 0, 0);
  expect_complete(touching, 2);
  EXPECT_EQ(points_of(touching, Kind::TANGENT), (Points_3{{-2, 0, 1}, {2, 0, 1}}));
  expect_complete(along(0, 0, 2, 1, 0, 0), 0);
  expect_complete(along(0, 0, 0, 0, 0, 1), 0);

  // A line in a hyperboloid, and one that leaves the box within it.
  const SC::Implicit_surface_3 hyperboloid(x * x + y * y - z * z - 1, {{{-9, 9}, {-9, 9}, {-9, 1}}});
  const auto within = SC::intersections(SC::segment_curve(K::Point_3(1, -4, -4), K::Point_3(1, 4, 4)), hyperboloid);
  expect_complete(within, 1);
  EXPECT_EQ(within[0].kind(), Kind::OVERLAP);
  EXPECT_EQ(within[0].parameter_range(0), Range(0, Exact_rational(5) / 8));
}

TEST(Locus_intersections, ThreeImplicitSurfaces)
{
  // Viviani's curve
  const SC::Implicit_surface_3 sphere = SC::to_implicit(K::Sphere_3(K::Point_3(0, 0, 0), 4)),
                               cylinder(x * x - 2 * x + y * y, wide_in_space);
  const K::Iso_cuboid_3 box(-9, -9, -9, 9, 9, 9);
  const auto at_height_1 = SC::intersections(sphere, cylinder, SC::to_implicit(K::Plane_3(0, 0, 1, -1), box));
  expect_complete(at_height_1, 2);
  EXPECT_EQ(points_of(at_height_1, Kind::TRANSVERSAL), (Points_3{{1.5, -0.866025404, 1}, {1.5, 0.866025404, 1}}));
  const auto at_zero = SC::intersections(sphere, SC::to_implicit(K::Plane_3(1, 0, 0, -1), box), cylinder);
  expect_complete(at_zero, 4);
  EXPECT_EQ(points_of(at_zero, Kind::TRANSVERSAL),
            (Points_3{{1, -1, -1.414213562}, {1, -1, 1.414213562}, {1, 1, -1.414213562}, {1, 1, 1.414213562}}));
  // The node of Viviani's curve, where its two branches cross at rational coordinates.
  const auto node = SC::intersections(cylinder, sphere, SC::to_implicit(K::Plane_3(1, 0, 0, -2), box));
  expect_complete(node, 1);
  EXPECT_EQ(points_of(node, Kind::TANGENT), (Points_3{{2, 0, 0}}));
  // A parametric curve on two of them.
  const auto corner = SC::intersections(SC::segment_curve(K::Point_3(1, 1, -3), K::Point_3(1, 1, 3)), sphere, cylinder);
  expect_complete(corner, 2);
  EXPECT_EQ(points_of(corner, Kind::TRANSVERSAL), (Points_3{{1, 1, -1.414213562}, {1, 1, 1.414213562}}));
}

// More equations than unknowns: decided exactly, also where coordinates are irrational.
TEST(Locus_intersections, FourImplicitSurfaces)
{
  const SC::Implicit_surface_3 sphere(x * x + y * y + z * z - Power_polynomial(2), wide_in_space),
      cylinder(x * x + y * y - Power_polynomial(Exact_rational(4) / 3), wide_in_space), first(x - y, wide_in_space),
      second(y - z, wide_in_space);
  // irrational: the roots of 2/3
  const auto both = SC::intersections(first, second, sphere, cylinder);
  expect_complete(both, 2);
  const Exact_rational little = Exact_rational(1) / Exact_rational(1e40);
  for (const auto& point : both)
    EXPECT_NEAR(std::abs(point.coordinate(2).value()), std::sqrt(2. / 3), 1e-12);
  const SC::Implicit_surface_3 wider(x * x + y * y - Power_polynomial(Exact_rational(4) / 3 + little), wide_in_space);
  expect_complete(SC::intersections(first, second, sphere, wider), 0);
  // rational, two curves of intersection that meet in one point
  const SC::Implicit_surface_3 paraboloid(x * x + y * y - z, wide_in_space), saddle(x * y - z, wide_in_space),
      cubic(x * x * x + y - z, wide_in_space), plane(x + y + z, wide_in_space);
  const auto origin = SC::intersections(paraboloid, saddle, cubic, plane);
  EXPECT_TRUE(origin.is_complete());
  ASSERT_EQ(origin.size(), 1);
  EXPECT_NEAR(origin[0].coordinate(0).value(), 0, 1e-12);
  EXPECT_THROW(SC::intersections(paraboloid, saddle, cubic, plane, {.tolerance = -1}), SC::Invalid_input);
  EXPECT_THROW(SC::intersections(paraboloid, saddle, cubic, plane, {.time_limit = -1}), SC::Invalid_input);
  const auto cut_off = SC::intersections(first, second, sphere, cylinder, {.node_limit = 1});
  EXPECT_FALSE(cut_off.is_complete());
  EXPECT_GT(cut_off.count(Kind::UNDECIDED), 0u);
}

// The curve in which two spline surfaces meet, and a third one.
TEST(Locus_intersections, CurvesOfIntersectionAsOperands)
{
  using Surface = SC::Bspline_surface_3<K>;
  const auto bilinear = [](K::Point_3 a, K::Point_3 b, K::Point_3 c, K::Point_3 d) {
    return Surface({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {a, b, c, d});
  };
  // z = x y, z = x / 4 + y / 4 and x = y, all over the unit square: x^2 = x / 2
  const Surface saddle = bilinear({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}),
                slope = bilinear({-1, -1, -Exact_rational(1) / 2}, {-1, 2, Exact_rational(1) / 4},
                                 {2, -1, Exact_rational(1) / 4}, {2, 2, 1}),
                wall = bilinear({Exact_rational(1) / 4, Exact_rational(1) / 4, -1},
                                {Exact_rational(1) / 4, Exact_rational(1) / 4, 2}, {2, 2, -1}, {2, 2, 2});
  const auto found = SC::intersections(saddle, slope, wall);
  expect_complete(found, 1);
  EXPECT_EQ(points_of(found, Kind::TRANSVERSAL), (Points_3{{0.5, 0.5, 0.25}}));
  EXPECT_NEAR(found[0].parameter(0, 0), 0.5, 1e-12);
  EXPECT_NEAR(found[0].parameter(2, 0), 1. / 7, 1e-12);
  // with an offset or an implicit surface instead
  expect_complete(
      SC::intersections(saddle, slope, SC::Implicit_surface_3(x - y, {{{Exact_rational(1) / 4, 2}, {-9, 9}, {-9, 9}}})),
      1);
  // two curves of intersection
  const SC::Implicit_surface_3 ceiling(z - Power_polynomial(Exact_rational(1) / 4), wide_in_space);
  const auto meeting = SC::intersections(saddle, slope, wall, ceiling);
  EXPECT_TRUE(meeting.is_complete());
  EXPECT_EQ(meeting.size(), 1);
  EXPECT_EQ(SC::intersections(saddle, slope, wall,
                              SC::Implicit_surface_3(z - Power_polynomial(Exact_rational(1) / 3), wide_in_space))
                .size(),
            0);
}

// A sign, and nothing beyond the box; a point that misses by little is not on it.
TEST(Locus_intersections, PointsAndImplicit)
{
  const SC::Implicit_curve_2 upper_half(x * x + y * y - 1, {{{-9, 9}, {0, 9}}});
  const K::FT little = K::FT(1) / K::FT(1e40);
  const auto on = SC::intersections(K::Point_2(Exact_rational(3) / 5, Exact_rational(4) / 5), upper_half);
  expect_complete(on, 1);
  EXPECT_EQ(points_of(on, Kind::TRANSVERSAL), (Points{{0.6, 0.8}}));
  EXPECT_EQ(on[0].multiplicity(), 1);
  EXPECT_FALSE(on[0].is_at_end(0));
  expect_complete(SC::intersections(upper_half, K::Point_2(0, 1)), 1);
  expect_complete(SC::intersections(upper_half, K::Point_2(1, 0)), 1);
  expect_complete(SC::intersections(upper_half, K::Point_2(0, -1)), 0);
  expect_complete(SC::intersections(K::Point_2(little, 1), upper_half), 0);
  const auto sphere = SC::to_implicit(K::Sphere_3(K::Point_3(0, 0, 0), 9));
  expect_complete(SC::intersections(K::Point_3(2, -1, 2), sphere), 1);
  expect_complete(SC::intersections(K::Point_3(2, -1, 2 + little), sphere), 0);
}

// The offset of a circle of radius 2 by 1 to the left, which is inwards.
TEST(Locus_intersections, PointsAndOffset)
{
  const SC::Offset_curve_2 offset(SC::circle_curve(K::Point_2(0, 0), K::FT(2)), 1);
  const auto on = SC::intersections(K::Point_2(Exact_rational(3) / 5, Exact_rational(4) / 5), offset);
  expect_complete(on, 1);
  EXPECT_EQ(points_of(on, Kind::TRANSVERSAL), (Points{{0.6, 0.8}}));
  EXPECT_NEAR(on[0].parameter(1), 0.5, 1e-12);   // of ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2))
  expect_complete(SC::intersections(K::Point_2(Exact_rational(3) / 5, Exact_rational(3) / 5), offset), 0);
  expect_complete(SC::intersections(K::Point_2(1, 0), offset), 1);   // its seam
}

// A limit is one for all pieces together: when it is used up, what remains is undecided.
TEST(Locus_intersections, LimitsOfTheWhole)
{
  std::vector<K::Point_2> points;
  for (int i = 0; i < 9; ++i)
    points.emplace_back(2 * i - 8, i % 2 == 0 ? 5 : -5);
  const SC::Offset_curve_2 offset(SC::Bspline_curve_2<K>(3, {0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6}, points),
                                  Exact_rational(1) / 4);
  const SC::Implicit_curve_2 line(y - x / 9, wide);
  const auto all = SC::intersections(offset, line);
  EXPECT_TRUE(all.is_complete());
  EXPECT_EQ(all.count(Kind::TRANSVERSAL), 8u);   // once between each two of the nine control points
  const std::size_t nodes = all.summary().nodes, pieces = 6;
  for (const std::size_t limit : {std::size_t(1), nodes / 4, nodes / 2}) {
    const auto cut_off = SC::intersections(offset, line, {.node_limit = limit});
    EXPECT_FALSE(cut_off.is_complete());
    EXPECT_GT(cut_off.count(Kind::UNDECIDED), 0u);
    EXPECT_LE(cut_off.summary().nodes, limit + pieces);
  }
  EXPECT_TRUE(SC::intersections(offset, line, {.time_limit = 1000, .node_limit = nodes + 1}).is_complete());
}

// Random curves of degree three through a random rational point, and random polynomials that vanish there: the point is
// found once, at its parameter.
TEST(Locus_intersections, PlantedPoints)
{
  std::mt19937 random(3);
  const auto number = [&](int range) { return Exact_rational(static_cast<int>(random() % (2 * range + 1)) - range); };
  for (int round = 0; round < 40; ++round) {
    std::vector<K::Point_2> points;
    for (int i = 0; i < 4; ++i)
      points.emplace_back(number(20), number(20));
    std::vector<K::FT> weights;
    for (int i = 0; i < 4 && round % 2 == 0; ++i)
      weights.push_back(1 + static_cast<int>(random() % 5));
    const auto curve = SC::bezier_curve(points, weights);
    const Exact_rational t =
        round % 5 == 0 ? Exact_rational(1) : Exact_rational(static_cast<int>(1 + random() % 9)) / 10;
    const K::Point_2 p = curve(t);
    Power_polynomial f;
    for (int i = 0; i < 6; ++i)
      f +=
          Power_polynomial(number(9)) * pow(x, static_cast<int>(random() % 4)) * pow(y, static_cast<int>(random() % 3));
    f += x * x * x + Power_polynomial(number(9)) * y;
    const SC::Implicit_curve_2::Box box{{{-20, 20}, {-20, 20}}};
    const SC::Implicit_curve_2 implicit(f - Power_polynomial(f(std::array<Exact_rational, 2>{p.x(), p.y()})), box);
    const auto intersections = SC::intersections(curve, implicit);
    ASSERT_TRUE(intersections.is_complete()) << round;
    EXPECT_EQ(std::count_if(intersections.begin(), intersections.end(),
                            [&](const auto& answer) {
                              return answer.parameter_range(0).first <= t && t <= answer.parameter_range(0).second &&
                                  answer.is_at_end(0) == (t == 1);
                            }),
              1)
        << round;
    for (const auto& answer : intersections)
      EXPECT_NEAR(CGAL::to_double(curve(Exact_rational(answer.parameter(0))).x()), answer.coordinate(0).value(), 1e-12);
  }
}

} // namespace

} // namespace locus_intersections_test
