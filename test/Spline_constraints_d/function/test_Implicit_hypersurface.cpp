// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Implicit curves and surfaces: where they come from, and exact values.

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_cgal_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/to_implicit.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpz.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <random>
#include <vector>

namespace Implicit_hypersurface_test {

namespace {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Invalid_input;
using SC::Power_polynomial;
using K = CGAL::Simple_cartesian<Exact_rational>;
using Epeck = CGAL::Exact_predicates_exact_constructions_kernel;

const Power_polynomial x = Power_polynomial::variable(0), y = Power_polynomial::variable(1),
                       z = Power_polynomial::variable(2);
const SC::Implicit_curve_2::Box square_box{{{-3, 3}, {-3, 3}}};

TEST(Implicit_hypersurface, ValuesAndGradients)
{
  const auto [u, v] = SC::unknowns({-3, 3}, {-2, 2});
  const SC::Implicit_curve_2 ellipse(u*u/4 + v*v == 1);
  EXPECT_EQ(ellipse.polynomial(), x * x / 4 + y * y - 1);
  EXPECT_EQ(ellipse.box()[1], (SC::Implicit_curve_2::Range(-2, 2)));
  EXPECT_EQ(SC::Implicit_curve_2(u*u/4 + v*v - 1).polynomial(), ellipse.polynomial());
  EXPECT_EQ(ellipse(std::array<Exact_rational, 2>{1, Exact_rational(1) / 2}), Exact_rational(-1) / 2);
  EXPECT_EQ(ellipse.gradient(std::array<Exact_rational, 2>{1, Exact_rational(1) / 2}),
            (std::array<Exact_rational, 2>{Exact_rational(1) / 2, 1}));
  EXPECT_EQ(ellipse.sign_at(K::Point_2(Exact_rational(6) / 5, Exact_rational(4) / 5)), CGAL::ZERO);
  EXPECT_EQ(ellipse.sign_at(Epeck::Point_2(1.2, 0.8)), CGAL::POSITIVE);   // the doubles are beside it
  EXPECT_TRUE(ellipse.has_on(K::Point_2(-2, 0)));
  EXPECT_FALSE(ellipse.has_on(K::Point_2(0, 0)));

  const SC::Implicit_surface_3 cylinder(x * x + y * y - 1, {{{-2, 2}, {-2, 2}, {0, 1}}});
  EXPECT_TRUE(cylinder.has_on(K::Point_3(1, 0, 1)));
  EXPECT_FALSE(cylinder.has_on(K::Point_3(1, 0, 2)));   // outside of the box
  EXPECT_EQ(cylinder.sign_at(K::Point_3(1, 0, 2)), CGAL::ZERO);
}

// Formulas of a point of a rational curve: f(C(u)) is what values say.
TEST(Implicit_hypersurface, PointsOfCurves)
{
  const SC::Spline_map<1, 2> c(SC::circle_curve(K::Point_2(1, 0), K::FT(2)));
  const auto [u] = SC::parameters(c);
  const SC::Implicit_curve_2 cubic(x * x * y - 2 * y + 5, square_box);
  const SC::Expression value = cubic(c(u));
  const SC::Vector_expression<2> gradient = cubic.gradient(c(u));
  for (const Exact_rational& t : std::vector<Exact_rational>{0, Exact_rational(1) / 3, Exact_rational(5) / 2}) {
    const std::array<Exact_rational, 1> at{t};
    EXPECT_EQ(value(at), cubic(c(at)));
    EXPECT_EQ(gradient(at), cubic.gradient(c(at)));
  }
  const SC::Implicit_curve_2 circle(x * x - 2 * x + y * y - 3, square_box);
  const SC::Spline_function on_circle = (circle(c(u)) == 0).spline_function();
  for (const SC::Spline_term& term : on_circle.terms())
    for (const auto& piece : term.pieces)
      for (const Exact_rational& coefficient : piece)
        EXPECT_EQ(coefficient, 0);
}

TEST(Implicit_hypersurface, ObjectsOfCGAL)
{
  const K::Point_2 p(4, 6);
  const SC::Implicit_curve_2 circle = SC::to_implicit(K::Circle_2(K::Point_2(1, 2), 25));
  EXPECT_TRUE(circle.has_on(p) && circle.has_on(K::Point_2(-4, 2)) &&
              circle.sign_at(K::Point_2(1, 2)) == CGAL::NEGATIVE);
  const SC::Implicit_surface_3 sphere = SC::to_implicit(Epeck::Sphere_3(Epeck::Point_3(1, 2, 3), 3));
  EXPECT_TRUE(sphere.has_on(K::Point_3(2, 3, 4)) && sphere.has_on(K::Point_3(0, 1, 2)) &&
              !sphere.has_on(K::Point_3(1, 2, 3)));
  const SC::Implicit_curve_2 line = SC::to_implicit(K::Line_2(K::Point_2(0, 1), p), K::Iso_rectangle_2(-9, -9, 9, 9));
  EXPECT_TRUE(line.has_on(p) && line.has_on(K::Point_2(-4, -4)) && !line.has_on(K::Point_2(12, 16)));
  const SC::Implicit_surface_3 plane = SC::to_implicit(K::Plane_3(1, 2, 3, -6), K::Iso_cuboid_3(0, 0, 0, 9, 9, 9));
  EXPECT_TRUE(plane.has_on(K::Point_3(1, 1, 1)) && !plane.has_on(K::Point_3(-1, 2, 1)));
  EXPECT_THROW(SC::to_implicit(K::Circle_2(p, 0)), Invalid_input);
  EXPECT_THROW(SC::to_implicit(K::Line_2(0, 0, 1), K::Iso_rectangle_2(0, 0, 1, 1)), Invalid_input);
}

// Seeded random polynomials in CGAL's form and back.
template <class Polynomial>
void expect_round_trips(int denominator)
{
  constexpr int d = CGAL::Polynomial_traits_d<Polynomial>::d;
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    Power_polynomial f(Exact_rational(round - 20) / denominator);
    for (int term = 0; term < 8; ++term) {
      Power_polynomial product(Exact_rational(static_cast<int>(random() % 2001) - 1000) / denominator * 1000003);
      for (int i = 0; i < d; ++i)
        product *= pow(Power_polynomial::variable(i), static_cast<int>(random() % 4));
      f += product;
    }
    const auto polynomial = SC::to_cgal_polynomial<Polynomial>(f);
    EXPECT_EQ(SC::from_cgal_polynomial(polynomial), f);
    EXPECT_EQ(SC::to_cgal_polynomial<Polynomial>(SC::from_cgal_polynomial(polynomial)), polynomial);
  }
}

TEST(Implicit_hypersurface, PolynomialsOfCGAL)
{
  using Integers = CGAL::Polynomial<CGAL::Polynomial<CGAL::Gmpz>>;
  using Rationals = CGAL::Polynomial<CGAL::Polynomial<CGAL::Polynomial<Exact_rational>>>;
  expect_round_trips<Integers>(1);
  expect_round_trips<Rationals>(7);
  const Integers s = CGAL::shift(Integers(1), 1, 0), t = CGAL::shift(Integers(1), 1, 1);
  EXPECT_EQ(SC::from_cgal_polynomial(s * s * s - 3 * t + 1), x * x * x - 3 * y + 1);
  EXPECT_EQ(SC::from_cgal_polynomial(CGAL::Polynomial<CGAL::Polynomial<double>>(CGAL::Polynomial<double>(0.1, 2.0))),
            Power_polynomial(0.1) + 2 * x);
  EXPECT_TRUE(SC::Implicit_curve_2(SC::from_cgal_polynomial(s * s + t * t - 2), square_box).has_on(K::Point_2(-1, 1)));
  EXPECT_TRUE(SC::from_cgal_polynomial(Integers(0)).is_zero());
  EXPECT_THROW(SC::to_cgal_polynomial<Integers>(x / 2), Invalid_input);
  EXPECT_THROW(SC::to_cgal_polynomial<Integers>(z), Invalid_input);
}

TEST(Implicit_hypersurface, BadInput)
{
  EXPECT_THROW(SC::Implicit_curve_2(Power_polynomial(), square_box), Invalid_input);
  EXPECT_THROW(SC::Implicit_curve_2(Power_polynomial(3), square_box), Invalid_input);
  EXPECT_THROW(SC::Implicit_curve_2(x + z, square_box), Invalid_input);
  EXPECT_THROW(SC::Implicit_curve_2(x + y, {{{0, 1}, {1, 1}}}), Invalid_input);
  const auto [u, v, w] = SC::unknowns({-1, 1}, {-1, 1}, {-1, 1});
  EXPECT_THROW(SC::Implicit_curve_2(u*v == 1), Invalid_input);
  EXPECT_THROW(SC::Implicit_surface_3(u*v*w < 1), Invalid_input);
  EXPECT_THROW(SC::Implicit_surface_3(u/v == w), Invalid_input);
  EXPECT_THROW(SC::Implicit_surface_3(SC::Expression(1)), Invalid_input);
  const SC::Implicit_curve_2 line(x + y, square_box);
  EXPECT_THROW(line.has_on(CGAL::Simple_cartesian<double>::Point_2(std::numeric_limits<double>::infinity(), 0)),
               Invalid_input);
}

} // namespace

} // namespace Implicit_hypersurface_test
