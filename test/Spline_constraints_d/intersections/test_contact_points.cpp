// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points where two surfaces touch, against exact answers.

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/operations/intersections/contact_points.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace contact_points_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Intersection_kind;
using K = Exact_cartesian;
using FT = Exact_rational;
using Surface = SC::Bspline_surface_3<K>;
using Point = K::Point_3;
using Vector = K::Vector_3;
using Plane = K::Plane_3;
using Range = std::pair<FT, FT>;

FT ratio(int a, int b) { return FT(a) / FT(b); }

template <class Contacts>
void expect_one_contact(const Contacts& found, const std::array<double, 3>& at)
{
  EXPECT_TRUE(found.is_complete()) << found.summary();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kind(), Intersection_kind::TANGENT);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(CGAL::to_double(found[0].point().cartesian(i)), at[i], 1e-9);
}

const Surface unit_sphere = SC::sphere_surface(Point(0, 0, 0), FT(1));

TEST(Contact_points, SphereAndPlane)
{
  // At irrational parameters, at the seam, at the pole.
  expect_one_contact(SC::contact_points(unit_sphere, Plane(2, 1, 2, -3)), {2. / 3, 1. / 3, 2. / 3});
  expect_one_contact(SC::contact_points(unit_sphere, Plane(1, 0, 0, -1)), {1, 0, 0});
  const auto pole = SC::contact_points(unit_sphere, Plane(0, 0, 1, 1));
  expect_one_contact(pole, {0, 0, -1});
  EXPECT_TRUE(pole[0].is_at_end(0, 1) && !pole[0].is_at_end(0, 0));
  EXPECT_EQ(pole[0].parameter_range(0, 0), Range(0, 4));
  // Apart, crossing, and crossing at both poles.
  for (const Plane& plane :
       {Plane(2, 1, 2, -3 - FT(1e-40)), Plane(2, 1, 2, -3 + FT(1e-40)), Plane(1, 1, 0, 0), Plane(3, 1, 0, 0)}) {
    const auto none = SC::contact_points(plane, unit_sphere);
    EXPECT_TRUE(none.is_complete() && none.empty()) << none.summary();
  }
}

TEST(Contact_points, TorusAndPlane)
{
  const Surface torus = SC::torus_surface(Point(0, 0, 0), FT(3), FT(1));
  expect_one_contact(SC::contact_points(torus, Plane(3, 4, 0, -20)), {2.4, 3.2, 0});   // outside
  expect_one_contact(SC::contact_points(torus, Plane(3, 4, 0, -10)), {1.2, 1.6, 0});   // a saddle
  const auto none = SC::contact_points(torus, Plane(0, 0, 1, 0));
  EXPECT_TRUE(none.is_complete() && none.empty());
  const auto circle = SC::contact_points(torus, Plane(0, 0, 1, -1));
  EXPECT_TRUE(circle.is_complete());
  EXPECT_EQ(circle.count(Intersection_kind::OVERLAP), circle.size());
  FT length(0);   // of the pieces of the circle
  for (const auto& x : circle) {
    EXPECT_EQ(x.parameter_range(0, 1), Range(1, 1));
    length += x.parameter_range(0, 0).second - x.parameter_range(0, 0).first;
  }
  EXPECT_EQ(length, 4);
}

// The tangent plane at a planted point; others may touch it elsewhere. Counts do not change under affine maps.
TEST(Contact_points, TangentPlanesOfABicubic)
{
  Random_geometry random(5);
  for (int round = 0; round < 8; ++round) {
    const Surface surface({3, 3}, {0, 0, 0, 0, 1, 1, 1, 1}, {0, 0, 0, 0, 1, 1, 1, 1}, random.points<K, 3>(16),
                          round % 2 == 0 ? std::vector<FT>() : random.weights(16));
    const FT u = ratio(random.integer(1, 9), 10), v = ratio(random.integer(1, 9), 10);
    const Plane plane(surface(u, v), surface.normal(u, v));
    const auto found = SC::contact_points(surface, plane);
    ASSERT_TRUE(found.is_complete()) << round << ' ' << found.summary();
    EXPECT_EQ(std::count_if(found.begin(), found.end(), [&](const auto& x) {
      const auto holds = [](const Range& range, const FT& t) { return range.first <= t && t <= range.second; };
      return x.kind() == Intersection_kind::TANGENT && holds(x.parameter_range(0, 0), u) &&
          holds(x.parameter_range(0, 1), v);
    }), 1) << round;
    const CGAL::Aff_transformation_3<K> map(FT(3), FT(-1), FT(2), FT(7), FT(1), FT(4), ratio(1, 3), FT(5), FT(-2),
                                            FT(1), FT(1), FT(6));
    const Surface moved = surface.transformed(map);
    const auto images = SC::contact_points(Plane(moved(u, v), moved.normal(u, v)), moved);
    EXPECT_EQ(images.size(), found.size());
  }
}

using Function = SC::Bspline_function<FT>;

Function polynomial(const std::vector<int>& degrees, const std::vector<FT>& power)
{
  return Function::from_tensor(SC::Bernstein_tensor<FT>::from_power(degrees, power),
                               std::vector<Range>(2, Range(0, 1)));
}

const Function u = polynomial({1, 0}, {0, 1}), v = polynomial({0, 1}, {0, 1}), one = polynomial({0, 0}, {1});

Surface graph(const Function& height)
{
  return Surface::from_homogeneous_coordinates({u + v * FT(0), u * FT(0) + v, height}, one);
}

// Graphs over the unit square that touch in one point.
TEST(Contact_points, CurvedSurfaces)
{
  const Surface lower = graph(u * u - v * v),
                upper = graph(u * u - v * v + (u - ratio(1, 3)) * (u - ratio(1, 3)) +
                              (v - ratio(2, 5)) * (v - ratio(2, 5)));
  expect_one_contact(SC::contact_points(lower, upper), {1. / 3, 2. / 5, 1. / 9 - 4. / 25});
  const auto apart = SC::contact_points(
      lower, upper.transformed(CGAL::Aff_transformation_3<K>(CGAL::TRANSLATION, Vector(0, 0, FT(1e-30)))));
  EXPECT_TRUE(apart.is_complete() && apart.empty()) << apart.summary();
  const auto crossing = SC::contact_points(
      lower, upper.transformed(CGAL::Aff_transformation_3<K>(CGAL::TRANSLATION, Vector(0, 0, -FT(1e-3)))));
  EXPECT_TRUE(crossing.is_complete() && crossing.empty()) << crossing.summary();
}

// Two surfaces of straight lines touch where x^2 = 1/2: their intersection is the line y = 1/2 and a curve that crosses
// it there.
TEST(Contact_points, RuledSurfacesAtIrrationalParameters)
{
  const Function w = v - one * ratio(1, 2);
  const Surface a = graph((u * u - one * ratio(1, 2)) * w), b = graph(w * w * (u + one));
  expect_one_contact(SC::contact_points(a, b), {std::sqrt(0.5), 0.5, 0});
  const auto apart =
      SC::contact_points(a, b.transformed(CGAL::Aff_transformation_3<K>(CGAL::TRANSLATION, Vector(0, 0, FT(1e-20)))));
  EXPECT_TRUE(apart.is_complete() && apart.empty()) << apart.summary();
}

// Patches that end at each other, on both sides of the edge (u, 0, u^2): parts of one surface touch along it, others
// where their directions across, (0, 1, 0) and (0, 1, 2 u^2 - 1), are the same.
TEST(Contact_points, SharedEdges)
{
  const auto patch = [](int side, bool is_bent, bool is_reversed) {
    const FT y(side), bend(is_bent ? side : 0);
    std::vector<Point> edge{{0, 0, 0}, Point(ratio(1, 2), 0, 0), {1, 0, 1}},
        end{Point(0, y, -bend), Point(ratio(1, 2), y, -bend), Point(1, y, 1 + bend)};
    if (is_reversed) {
      std::reverse(edge.begin(), edge.end());
      std::reverse(end.begin(), end.end());
    }
    std::vector<Point> points;
    for (std::size_t i = 0; i < 3; ++i)
      points.insert(points.end(), {edge[i], end[i]});
    return Surface({2, 1}, {0, 0, 0, 1, 1, 1}, {0, 0, 1, 1}, points);
  };
  for (bool is_reversed : {false, true}) {
    const auto smooth = SC::contact_points(patch(-1, false, false), patch(1, false, is_reversed));
    EXPECT_TRUE(smooth.is_complete()) << smooth.summary();
    ASSERT_EQ(smooth.size(), 1u);
    EXPECT_EQ(smooth[0].kind(), Intersection_kind::OVERLAP);
    for (std::size_t k : {0, 1}) {
      EXPECT_EQ(smooth[0].parameter_range(k, 0), Range(0, 1));
      EXPECT_EQ(smooth[0].parameter_range(k, 1), Range(0, 0));
    }
    const auto touching = SC::contact_points(patch(-1, false, false), patch(1, true, is_reversed));
    expect_one_contact(touching, {std::sqrt(0.5), 0, 0.5});
    const auto [lower, upper] = touching[0].parameter_range(0, 0);
    EXPECT_TRUE(2 * lower * lower < 1 && 1 < 2 * upper * upper);
    EXPECT_EQ(touching[0].parameter_range(1, 1), Range(0, 0));
  }
}

// Spheres that touch at poles of both: the contact is proved, but that there is no other one near is not.
TEST(Contact_points, PolesOfBothSurfaces)
{
  const auto found = SC::contact_points(unit_sphere, SC::sphere_surface(Point(0, 0, 3), FT(2)));
  EXPECT_EQ(found.count(Intersection_kind::TANGENT), 1u);
  EXPECT_FALSE(found.is_complete());
  for (const auto& x : found)
    if (x.kind() == Intersection_kind::TANGENT) {
      EXPECT_TRUE(x.is_at_end(0, 1) && x.is_at_end(1, 1) && x.point() == Point(0, 0, 1));
    }
}

// Nothing is dropped when there is no time: a surface touches itself everywhere, and all parameters are in an answer.
TEST(Contact_points, OutOfTime)
{
  const auto found = SC::contact_points(unit_sphere, unit_sphere, {.time_limit = 1e-9});
  EXPECT_FALSE(found.is_complete());
  for (const FT& u : {ratio(1, 3), ratio(5, 2)})
    for (const FT& v : {ratio(1, 2), ratio(3, 2)}) {
      const auto has = [](const Range& range, const FT& x) { return range.first <= x && x <= range.second; };
      EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const auto& x) {
        return x.kind() == Intersection_kind::UNDECIDED && has(x.parameter_range(0, 0), u) &&
            has(x.parameter_range(1, 0), u) && has(x.parameter_range(0, 1), v) && has(x.parameter_range(1, 1), v);
      }));
    }
}

TEST(Contact_points, BadInput)
{
  expect_invalid([&] { SC::contact_points(unit_sphere, Plane(0, 0, 0, 1)); }, "degenerate");
  expect_invalid([&] { SC::contact_points(unit_sphere, unit_sphere, {.tolerance = 0}); }, "tolerance");
}

} // namespace

} // namespace contact_points_test
