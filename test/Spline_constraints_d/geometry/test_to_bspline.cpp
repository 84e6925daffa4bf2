// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "geometry_test_tools.h"

#include <CGAL/Spline_constraints_d/geometry/conversions/circular_arcs.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_bspline_surface.h>

#include <CGAL/Exact_circular_kernel_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_spherical_kernel_3.h>

#include <CGAL/Gmpq.h>

#include <gtest/gtest.h>

#include <limits>
#include <utility>
#include <vector>

namespace to_bspline_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using FT = Exact_rational;
using K = CGAL::Epeck;
using E = Exact_cartesian;

TEST(Rational_roots, are_found_where_there_are_any)
{
  using namespace SC::internal;
  EXPECT_EQ(rational_square_root(FT(49) / FT(4)), FT(7) / FT(2));
  EXPECT_EQ(rational_square_root(FT(0)), FT(0));
  EXPECT_FALSE(rational_square_root(FT(2)));
  EXPECT_FALSE(rational_square_root(FT(-4)));
  for (int n = 1; n <= 200; ++n)
    for (int d = 1; d <= 5; ++d) {
      const auto two = sum_of_two_squares(FT(n) / FT(d));
      const auto three = sum_of_three_squares(FT(n) / FT(d));
      ASSERT_TRUE(two.is_complete && three.is_complete);
      // Fermat and Legendre, for the integer n d.
      int rest = n * d;
      bool is_sum_of_two = true;
      for (int p = 2; p * p <= rest; ++p) {
        int power = 0;
        for (; rest % p == 0; rest /= p)
          ++power;
        is_sum_of_two = is_sum_of_two && (p % 4 != 3 || power % 2 == 0);
      }
      is_sum_of_two = is_sum_of_two && rest % 4 != 3;
      int odd = n * d;
      while (odd % 4 == 0)
        odd /= 4;
      EXPECT_EQ(two.roots.has_value(), is_sum_of_two) << n << '/' << d;
      EXPECT_EQ(three.roots.has_value(), odd % 8 != 7) << n << '/' << d;
      if (two.roots) {
        const auto& [a, b] = *two.roots;
        EXPECT_EQ(a * a + b * b, FT(n) / FT(d));
      }
      if (three.roots) {
        const auto& [a, b, c] = *three.roots;
        EXPECT_EQ(a * a + b * b + c * c, FT(n) / FT(d));
      }
    }
  const FT x = FT(12345678) / FT(997), near = near_inverse_root(x);
  EXPECT_TRUE(FT(3) / 4 < near * near * x && near * near * x < FT(4) / 3);
  EXPECT_EQ(near_inverse_root(FT(9) / FT(4)), FT(2) / FT(3));
}

TEST(To_bspline_curve, converts_objects_of_kernels)
{
  const auto circle = SC::to_bspline_curve(K::Circle_2({0, 0}, 4));
  EXPECT_EQ(circle(1), K::Point_2(0, 2));
  EXPECT_EQ(CGAL::squared_distance(circle(0.3), K::Point_2(0, 0)), 4);
  const auto backwards = SC::to_bspline_curve(E::Circle_2({1, 1}, 5, CGAL::CLOCKWISE));
  EXPECT_EQ(backwards.squared_curvature(FT(1) / 3), FT(1) / 5);
  EXPECT_LT(backwards.curvature(FT(1) / 3), 0);
  const auto rounded = SC::to_bspline_curve(CGAL::Epick::Circle_2({0, 0}, 3));
  EXPECT_NEAR(CGAL::squared_distance(rounded(0.3), CGAL::Epick::Point_2(0, 0)), 3, 1e-14);
  expect_invalid([] { SC::to_bspline_curve(K::Circle_2({0, 0}, 3)); }, "there is no point");
  expect_invalid([] { SC::to_bspline_curve(K::Circle_2({0, 0}, 0)); }, "not positive");
  expect_invalid([] { SC::to_bspline_curve(E::Circle_2({0, 0}, FT(3) * FT(0x1p80))); }, "was found");

  EXPECT_EQ(SC::to_bspline_curve(K::Segment_2({0, 0}, {1, 2}))(0.5), K::Point_2(0.5, 1));
  EXPECT_EQ(SC::to_bspline_curve(CGAL::Epick::Segment_3({0, 0, 0}, {1, 2, 4}))(0.5), CGAL::Epick::Point_3(0.5, 1, 2));
  const auto triangle = SC::to_bspline_curve(K::Triangle_2({0, 0}, {1, 0}, {0, 1}));
  EXPECT_TRUE(triangle.is_closed());
  EXPECT_EQ(triangle(1.5), K::Point_2(0.5, 0.5));
  const auto rectangle = SC::to_bspline_curve(K::Iso_rectangle_2({0, 0}, {2, 1}));
  EXPECT_TRUE(rectangle.is_closed());
  EXPECT_EQ(rectangle(2), K::Point_2(2, 1));
  CGAL::Polygon_2<CGAL::Epick> polygon;
  expect_invalid([&] { SC::to_bspline_curve(polygon); }, "no vertices");
  for (const CGAL::Epick::Point_2& p : {CGAL::Epick::Point_2(0, 0), {4, 0}, {4, 4}, {1, 5}, {0, 2}})
    polygon.push_back(p);
  const auto boundary = SC::to_bspline_curve(polygon);
  EXPECT_TRUE(boundary.is_closed());
  EXPECT_EQ(boundary.domain().second, 5);
  EXPECT_EQ(boundary(3.5), CGAL::Epick::Point_2(0.5, 3.5));
}

// A segment as a user's own curve.
struct Own_segment
{
  using Kernel = K;
  static constexpr int number_of_parameters = 1;

  std::array<SC::Bspline_function<FT>, 3> homogeneous_coordinates() const
  {
    const SC::Bspline_function<FT> t({1}, {{1, 1, 2, 2}}, {1, 2});
    return {t, t * FT(3), t - FT(1)};
  }
  SC::Bspline_function<FT> weight() const { return SC::Bspline_function<FT>({1}, {{1, 1, 2, 2}}, {-1, -2}); }
  bool is_rational() const { return true; }
  std::pair<K::FT, K::FT> domain(int) const { return {1, 2}; }
  K::Point_3 operator()(const K::FT& t) const { return {-1, -3, (1 - t) / t}; }
};

TEST(Kernel_numbers, are_converted_without_error)
{
  using SC::internal::converted_number;
  Random_source random(1);
  for (int i = 0; i < 50; ++i) {
    FT x = random.rational();
    for (int k = random.integer(0, 9); k > 0; --k)
      x *= FT(random.integer(1, 1 << 30)) / FT(random.integer(1, 1 << 30));
    EXPECT_EQ(converted_number<FT>(converted_number<CGAL::Gmpq>(x)), x);
    EXPECT_EQ(converted_number<FT>(converted_number<K::FT>(x)), x);
    const double rounded = converted_number<double>(x);
    EXPECT_EQ(converted_number<double>(converted_number<FT>(rounded)), rounded);
    EXPECT_EQ(converted_number<CGAL::Gmpq>(rounded), CGAL::Gmpq(rounded));
  }
  expect_invalid([] { converted_number<FT>(std::numeric_limits<double>::infinity()); }, "infinity");
}

TEST(To_bspline_curve, converts_arcs_of_circular_kernels)
{
  using C = CGAL::Exact_circular_kernel_2;
  static_assert(SC::SplineKernel<C>);
  const C::Circle_2 circle(C::Point_2(1, 2), 25);
  const C::Circular_arc_point_2 p(C::Point_2(6, 2)), q(C::Point_2(4, -2));
  const auto arc = SC::to_bspline_curve(C::Circular_arc_2(circle, p, q));
  EXPECT_EQ(arc.source(), C::Point_2(6, 2));
  EXPECT_EQ(arc.target(), C::Point_2(4, -2));
  EXPECT_EQ(CGAL::squared_distance(arc(2), C::Point_2(1, 2)), 25);
  EXPECT_GT(arc.domain().second, 2);
  // From the lower to the upper end of the chord x = 2, whose coordinates are 2 +- sqrt(24); and where the root is 4.
  const C::Circular_arc_2 irrational(circle, C::Line_2(1, 0, -2), true, C::Line_2(1, 0, -2), false);
  expect_invalid([&] { SC::to_bspline_curve(irrational); }, "no rational coordinates");
  const auto upright =
      SC::to_bspline_curve(C::Circular_arc_2(circle, C::Line_2(1, 0, -4), true, C::Line_2(1, 0, -4), false));
  EXPECT_EQ(CGAL::midpoint(upright.source(), upright.target()), C::Point_2(4, 2));
  EXPECT_EQ(CGAL::squared_distance(upright.source(), upright.target()), 64);

  const auto back = SC::to_circular_arc(arc);
  ASSERT_TRUE(back);
  EXPECT_TRUE(*back == C::Circular_arc_2(circle, p, q));
  EXPECT_TRUE(*SC::to_circular_arc(arc.reversed()) == *back);   // arcs are counterclockwise
  const auto whole = SC::to_circular_arc(SC::to_bspline_curve(circle));
  ASSERT_TRUE(whole);
  EXPECT_TRUE(whole->source() == whole->target());
  EXPECT_TRUE(*SC::to_circular_arc(arc.elevated(3)) == *back);
  EXPECT_FALSE(SC::to_circular_arc(SC::bezier_curve<C>(std::vector<C::Point_2>{{0, 0}, {1, 0}, {1, 1}})));
  EXPECT_FALSE(SC::to_circular_arc(SC::segment_curve<C>(C::Point_2(0, 0), C::Point_2(1, 1))));
}

TEST(To_bspline_curve, converts_circles_and_arcs_in_space)
{
  const K::Point_3 center(1, 2, 3);
  const E::Vector_3 diagonal(1, 1, 1), slanted(2, 3, 6), upright(0, 0, -5);
  for (const auto& [normal, squared_radius] : std::vector<std::pair<E::Vector_3, int>>{{diagonal, 6},
                                                                                       {diagonal, 8},
                                                                                       {diagonal, 26},
                                                                                       {slanted, 5},
                                                                                       {slanted, 8},
                                                                                       {slanted, 26},
                                                                                       {upright, 5},
                                                                                       {upright, 8},
                                                                                       {upright, 26}}) {
    const E::Circle_3 circle(E::Point_3(1, 2, 3), squared_radius, normal);
    const auto curve = SC::to_bspline_curve(circle);
    EXPECT_TRUE(curve.is_closed());
    for (const int tenths : {0, 3, 17, 20, 39})
      EXPECT_TRUE(circle.has_on(curve(FT(tenths) / 10)));
    EXPECT_GT(curve.binormal(FT(1) / 2) * normal, 0);
  }
  expect_invalid([&] { SC::to_bspline_curve(E::Circle_3(E::Point_3(1, 2, 3), 5, diagonal)); },
                 "no point with rational coordinates was found");
  expect_invalid([&] { SC::to_bspline_curve(K::Circle_3(center, 3, K::Vector_3(0, 0, 1))); }, "there is no point");
  const auto rounded = SC::to_bspline_curve(CGAL::Epick::Circle_3({0, 0, 0}, 3, CGAL::Epick::Vector_3(0, 0, 1)));
  EXPECT_NEAR(CGAL::squared_distance(rounded(0.3), CGAL::Epick::Point_3(0, 0, 0)), 3, 1e-14);

  const auto triangle = SC::to_bspline_curve(K::Triangle_3({0, 0, 0}, {1, 0, 0}, {0, 1, 1}));
  EXPECT_TRUE(triangle.is_closed());
  EXPECT_EQ(triangle(1.5), K::Point_3(0.5, 0.5, 0.5));

  const K::Point_3 source(4, 2, 3), target(1, 5, 3);
  const auto quarter = SC::circular_arc_curve(center, K::Vector_3(0, 0, 7), source, target);
  EXPECT_EQ(quarter.target(), target);
  EXPECT_EQ(quarter.domain().second, 1);
  EXPECT_EQ(SC::circular_arc_curve(center, K::Vector_3(0, 0, -7), source, target).domain().second, 3);
  expect_invalid([&] { SC::circular_arc_curve(center, K::Vector_3(0, 0, 7), source, K::Point_3(1, 6, 3)); },
                 "not on the circle");

  using S = CGAL::Exact_spherical_kernel_3;
  const S::Circle_3 circle(S::Point_3(1, 2, 3), 9, S::Vector_3(0, 0, -1));
  const auto arc = SC::to_bspline_curve(S::Circular_arc_3(circle, S::Circular_arc_point_3(S::Point_3(4, 2, 3)),
                                                          S::Circular_arc_point_3(S::Point_3(1, 5, 3))));
  EXPECT_EQ(arc.source(), S::Point_3(4, 2, 3));
  EXPECT_EQ(arc.target(), S::Point_3(1, 5, 3));
  EXPECT_EQ(arc.domain().second, 1);

  const S::Circle_3 tilted(S::Point_3(1, 2, 3), 6, S::Vector_3(-1, -1, -1));
  const S::Circular_arc_point_3 begin(S::Point_3(2, 3, 1)), middle(S::Point_3(3, 1, 2));
  for (const auto& original : {S::Circular_arc_3(circle, S::Circular_arc_point_3(S::Point_3(4, 2, 3)),
                                                 S::Circular_arc_point_3(S::Point_3(1, 5, 3))),
                               S::Circular_arc_3(tilted, begin, middle), S::Circular_arc_3(tilted, middle, begin),
                               S::Circular_arc_3(tilted, begin)}) {
    const auto curve = SC::to_bspline_curve(original);
    for (const auto& one : {curve, curve.reversed()}) {
      const auto back = SC::to_circular_arc(one);
      ASSERT_TRUE(back);
      EXPECT_TRUE(back->source() == original.source() && back->target() == original.target());
      EXPECT_TRUE(*back == original);
    }
  }
  EXPECT_FALSE(SC::to_circular_arc(SC::segment_curve<S>(S::Point_3(0, 0, 0), S::Point_3(1, 1, 1))));
}

TEST(To_bspline_curve, converts_polygons_with_holes)
{
  CGAL::Polygon_2<K> outer, hole;
  for (const K::Point_2& p : {K::Point_2(0, 0), {4, 0}, {4, 4}, {0, 4}})
    outer.push_back(p);
  for (const K::Point_2& p : {K::Point_2(1, 1), {1, 2}, {2, 1}})
    hole.push_back(p);
  const CGAL::Polygon_with_holes_2<K> polygon(outer, &hole, &hole + 1);
  const auto curves = SC::to_bspline_curves(polygon);
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_EQ(curves[0](2), K::Point_2(4, 4));
  EXPECT_EQ(curves[1](2), K::Point_2(2, 1));
}

TEST(To_bspline_curve, takes_any_model_of_the_concept)
{
  const Own_segment segment;
  const SC::Bspline_curve_3<K> curve = SC::to_bspline_curve(segment);
  EXPECT_EQ(curve(1.25), segment(1.25));
  EXPECT_EQ(curve.control_weights(), (std::vector<K::FT>{1, 2}));
  EXPECT_TRUE(SC::to_bspline_curve(curve) == curve);
}

TEST(To_bspline_surface, cuts_a_plane_to_a_cuboid)
{
  const E::Iso_cuboid_3 cuboid({0, 0, 0}, {1, 2, 3});
  for (int a = -2; a <= 2; ++a)
    for (int b = -2; b <= 2; ++b)
      for (int c = -2; c <= 2; ++c) {
        const E::Plane_3 plane(a, b, c, 1);
        if (a == 0 && b == 0 && c == 0) {
          expect_invalid([&] { SC::to_bspline_surface(plane, cuboid); }, "degenerate");
          continue;
        }
        const auto patch = SC::to_bspline_surface(plane, cuboid);
        EXPECT_TRUE(plane.has_on(patch(FT(1) / 3, FT(3) / 4)));
        EXPECT_EQ(CGAL::cross_product(patch.normal(0, 0), plane.orthogonal_vector()), CGAL::NULL_VECTOR);
        EXPECT_GT(patch.normal(0, 0) * plane.orthogonal_vector(), 0);
        // Two of the coordinates run through the range of the cuboid.
        const CGAL::Bbox_3 box = patch.bbox(), all = cuboid.bbox();
        int complete = 0;
        for (int i = 0; i < 3; ++i)
          complete += (box.min)(i) <= (all.min)(i) && (all.max)(i) <= (box.max)(i);
        EXPECT_GE(complete, 2);
      }
}

TEST(To_bspline_surface, converts_objects_of_kernels)
{
  for (const CGAL::Orientation orientation : {CGAL::COUNTERCLOCKWISE, CGAL::CLOCKWISE}) {
    const auto sphere = SC::to_bspline_surface(E::Sphere_3({1, 2, 3}, 3, orientation));
    EXPECT_EQ(CGAL::squared_distance(sphere(FT(1) / 3, FT(2) / 7), E::Point_3(1, 2, 3)), 3);
    const FT side = sphere.normal(FT(1) / 3, FT(2) / 7) * (sphere(FT(1) / 3, FT(2) / 7) - E::Point_3(1, 2, 3));
    EXPECT_EQ(side > 0, orientation == CGAL::COUNTERCLOCKWISE);
  }
  expect_invalid([] { SC::to_bspline_surface(K::Sphere_3({0, 0, 0}, 7)); }, "there is no point");
  const auto rounded = SC::to_bspline_surface(CGAL::Epick::Sphere_3({0, 0, 0}, 7));
  EXPECT_NEAR(CGAL::squared_distance(rounded(0.3, 0.4), CGAL::Epick::Point_3(0, 0, 0)), 7, 1e-13);

  const auto triangle = SC::to_bspline_surface(K::Triangle_3({0, 0, 0}, {1, 0, 0}, {0, 1, 1}));
  EXPECT_EQ(triangle(1, 0.5), K::Point_3(0.5, 0.5, 0.5));
  EXPECT_EQ(triangle(0, 0.5), K::Point_3(0, 0, 0));

  const auto faces = SC::to_bspline_surfaces(CGAL::Epick::Iso_cuboid_3({0, 0, 0}, {1, 2, 3}));
  const CGAL::Epick::Point_3 middle(0.5, 1, 1.5);
  std::vector<CGAL::Epick::Point_3> centers;
  for (const auto& face : faces) {
    centers.push_back(face(0.5, 0.5));
    EXPECT_GT(face.normal(0.5, 0.5) * (centers.back() - middle), 0);
  }
  EXPECT_EQ(centers,
            (std::vector<CGAL::Epick::Point_3>{
                {0, 1, 1.5}, {1, 1, 1.5}, {0.5, 0, 1.5}, {0.5, 2, 1.5}, {0.5, 1, 0}, {0.5, 1, 3}}));
}

} // namespace

} // namespace to_bspline_test
