// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Derivatives, tangents and curvatures of curves of solutions: exact values on circles, Viviani's curve and great
// circles, Taylor's theorem on random curves, breaks of splines.

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/curve_polyline.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

namespace curve_differentials_test {

namespace SC = CGAL::Spline_constraints;
using Rational = SC::Exact_rational;
using SC::Power_polynomial;

namespace {

const auto x = [](int i) { return Power_polynomial::variable(i); };

SC::Constraint_system_d system_of(const std::vector<Power_polynomial>& equations, int dimension, int size = 3)
{
  SC::Constraint_system_d result(
      std::vector<SC::Constraint_system_d::Domain>(dimension, {Rational(-size), Rational(size)}));
  for (const Power_polynomial& equation : equations)
    result.add(equation, SC::Relation::EQUAL);
  return result;
}

SC::Curve_vertex::Exact_box box_of(const std::vector<Rational>& point)
{
  SC::Curve_vertex::Exact_box result;
  for (const Rational& c : point)
    result.emplace_back(c, c);
  return result;
}

void expect_in(double value, const CGAL::Interval_nt<false>& range, double width)
{
  EXPECT_LE(range.inf(), value + 1e-14);
  EXPECT_GE(range.sup(), value - 1e-14);
  EXPECT_LT(range.sup() - range.inf(), width);
}

} // namespace

TEST(Curve_differentials, exact_on_a_circle)
{
  const auto circle = system_of({x(0) * x(0) + x(1) * x(1) - 4}, 2);
  const auto at = SC::curve_differentials<Rational>(circle, box_of({Rational(6, 5), Rational(8, 5)}), 0);
  ASSERT_TRUE(at);
  EXPECT_EQ(at->parameter(), 0);
  EXPECT_EQ(at->point(), (std::vector<Rational>{Rational(6, 5), Rational(8, 5)}));
  EXPECT_EQ(at->first_derivative(), (std::vector<Rational>{1, Rational(-3, 4)}));
  EXPECT_EQ(at->second_derivative(), (std::vector<Rational>{0, Rational(-125, 128)}));
  EXPECT_EQ(at->squared_curvature(), Rational(1, 4));
  EXPECT_EQ(at->curvature_vector(), (std::vector<Rational>{Rational(-3, 10), Rational(-2, 5)}));   // towards the center
  EXPECT_DOUBLE_EQ(at->curvature(), 0.5);
  EXPECT_DOUBLE_EQ(at->signed_curvature(), -0.5);
  EXPECT_DOUBLE_EQ(at->unit_tangent()[0], 0.8);
  EXPECT_DOUBLE_EQ(at->unit_tangent()[1], -0.6);

  EXPECT_FALSE(SC::curve_differentials(circle, std::vector<double>{2, 0}, 0));
  const auto steep = SC::curve_differentials(circle, std::vector<double>{2, 0});
  ASSERT_TRUE(steep);
  EXPECT_EQ(steep->parameter(), 1);
  EXPECT_DOUBLE_EQ(steep->signed_curvature(), 0.5);

  const auto in_doubles = SC::curve_differentials<double>(circle, box_of({Rational(6, 5), Rational(8, 5)}), 0);
  ASSERT_TRUE(in_doubles);
  EXPECT_NEAR(in_doubles->squared_curvature(), 0.25, 1e-15);
  const auto in_intervals =
      SC::curve_differentials<CGAL::Interval_nt<false>>(circle, box_of({Rational(6, 5), Rational(8, 5)}), 0);
  ASSERT_TRUE(in_intervals);
  expect_in(-0.5, in_intervals->signed_curvature(), 1e-13);
}

// y = x^2, z = x^3: the torsion 12 / (36 x^4 + 36 x^2 + 4). A plane section has none, and a line no torsion at all.
TEST(Curve_differentials, torsion)
{
  const auto cubic = system_of({x(1) - x(0) * x(0), x(2) - x(0) * x(1)}, 3);
  for (const Rational& t : {Rational(0), Rational(1, 2), Rational(-6, 5)}) {
    const auto at = SC::curve_differentials<Rational>(cubic, box_of({t, t * t, t * t * t}), 0);
    ASSERT_TRUE(at);
    EXPECT_EQ(at->third_derivative(), (std::vector<Rational>{0, 0, 6}));
    EXPECT_EQ(at->torsion(), Rational(12 / (36 * t * t * t * t + 36 * t * t + 4)));
    const auto by_height = SC::curve_differentials<Rational>(cubic, box_of({t, t * t, t * t * t}), 2);
    EXPECT_EQ(by_height.has_value(), t != 0);
    if (by_height) {
      EXPECT_EQ(by_height->torsion(), at->torsion());
    }
    const auto u = SC::unknowns(3, {SC::Bound(-3), SC::Bound(3)});
    // the same after a reflection, but for the sign
    EXPECT_EQ(at->image(SC::Vector_expression<3>{u[1] / 1, u[0] / 1, u[2] / 1}).torsion(), Rational(-*at->torsion()));
  }
  const auto circle = system_of({x(0) * x(0) + x(1) * x(1) + x(2) * x(2) - 9, x(0) + x(1) - x(2) - 1}, 3);
  EXPECT_EQ(SC::curve_differentials<Rational>(circle, box_of({2, 1, 2}))->torsion(), 0);
  const auto line = system_of({x(1) - x(0), x(2) - x(0)}, 3);
  EXPECT_FALSE(SC::curve_differentials<Rational>(line, box_of({1, 1, 1}))->torsion());
  EXPECT_THROW(SC::curve_differentials<Rational>(system_of({x(0) - x(1)}, 2), box_of({1, 1}))->torsion(),
               SC::Invalid_input);
}

TEST(Curve_differentials, curvature_of_Viviani)
{
  // (1 + cos t, sin t, 2 sin(t/2)) with the curvature sqrt(13 + 3 cos t) / (3 + cos t)^(3/2)
  const auto curvature = [](double cosine) { return std::sqrt(13 + 3 * cosine) / std::pow(3 + cosine, 1.5); };
  const auto viviani =
      system_of({x(0) * x(0) + x(1) * x(1) + x(2) * x(2) - 4, x(0) * x(0) - 2 * x(0) + x(1) * x(1)}, 3);
  const auto set = SC::solve_curves(viviani);
  std::size_t regular = 0;
  for (const SC::Curve_vertex& vertex : set.vertices()) {
    const auto at = SC::curve_differentials(viviani, vertex);
    EXPECT_EQ(at.has_value(), !vertex.is_singular);
    if (!at)
      continue;
    ++regular;
    expect_in(curvature(vertex.point()[0] - 1), at->curvature(), 1e-8);
    const auto tangent = at->unit_tangent();
    double length = 0;
    for (const auto& t : tangent)
      length += 0.25 * (t.inf() + t.sup()) * (t.inf() + t.sup());
    EXPECT_NEAR(length, 1, 1e-9);
  }
  EXPECT_GE(regular, 4u);
  for (const SC::Solution_curve& curve : set.curves())
    for (const std::vector<double>& p : SC::to_polyline(viviani, set, curve, 1e-2))
      if (p[0] < 1.999) {
        EXPECT_NEAR(SC::curve_differentials(viviani, p)->curvature(), curvature(p[0] - 1), 1e-9);
      }
}

TEST(Curve_differentials, great_circles_in_space)
{
  auto [u, v] = SC::unknowns({-4, 4}, {-4, 4});
  const SC::Expression size = 1 + u * u + v * v;
  const SC::Vector_expression<3> sphere{2 * u / size, 2 * v / size, (1 - u * u - v * v) / size};
  const std::vector<SC::Constraint> constraints{sphere.x() + 2 * sphere.y() + 3 * sphere.z() == 0};
  const auto system = make_system(constraints);
  const auto set = SC::solve_curves(system);
  ASSERT_EQ(set.curves().size(), 1u);
  for (const SC::Curve_vertex& vertex : set.vertices()) {
    const auto at = SC::curve_differentials(system, vertex);
    ASSERT_TRUE(at);
    const auto circle = at->image(sphere);
    EXPECT_EQ(circle.dimension(), 3);
    expect_in(1, circle.curvature(), 1e-8);
  }
  for (const std::vector<double>& p : SC::to_polyline(system, set, set.curves()[0], 1e-2)) {
    const auto circle = SC::curve_differentials(system, p)->image(sphere);
    EXPECT_NEAR(circle.curvature(), 1, 1e-12);
    Rational squared(0), slope(0);
    for (std::size_t i = 0; i < 3; ++i) {
      squared += circle.point()[i] * circle.point()[i];
      slope += circle.point()[i] * circle.first_derivative()[i];
    }
    EXPECT_EQ(squared, 1);
    EXPECT_EQ(slope, 0);
  }

  const std::vector<SC::Constraint> diagonal{u == v};
  const auto parabola = SC::curve_differentials(make_system(diagonal), std::vector<double>{0, 0})
                            ->image(SC::Vector_expression<3>{u, v, u * v});
  EXPECT_EQ(parabola.squared_curvature(), 1);   // (t, t, t^2)
}

TEST(Curve_differentials, random_curves_agree_with_their_second_order_expansion)
{
  std::mt19937 generator(5);
  std::uniform_int_distribution<int> coefficient(-9, 9);
  const Rational h = SC::to_rational(0x1p-40);
  std::size_t regular = 0;
  for (int n = 2; n <= 5; ++n)
    for (int round = 0; round < 10; ++round) {
      std::vector<Rational> p;
      for (int j = 0; j < n; ++j)
        p.emplace_back(coefficient(generator), 7);
      std::vector<Power_polynomial> equations;
      for (int i = 0; i + 1 < n; ++i) {
        Power_polynomial f;
        for (int j = 0; j < n; ++j) {
          f += coefficient(generator) * x(j);
          for (int k = 0; k <= j; ++k)
            f += coefficient(generator) * x(j) * x(k) + coefficient(generator) * x(j) * x(k) * x((j + k) % n);
        }
        equations.push_back(f - f(p));
      }
      const auto at = SC::curve_differentials<Rational>(system_of(equations, n), box_of(p),
                                            round % 2 == 0 ? std::nullopt : std::optional(round % n));
      if (!at)
        continue;
      ++regular;
      std::vector<Rational> near;
      for (int j = 0; j < n; ++j)
        near.push_back(p[j] + h * at->first_derivative()[j] + h * h / 2 * at->second_derivative()[j]);
      EXPECT_EQ(at->first_derivative()[at->parameter()], 1);
      EXPECT_EQ(at->second_derivative()[at->parameter()], 0);
      Rational size(1);
      for (int j = 0; j < n; ++j)
        size += abs(at->first_derivative()[j]) + abs(at->second_derivative()[j]);
      for (const Power_polynomial& f : equations)
        EXPECT_LT(Rational(abs(f(near))), Rational(1000 * size * size * size * h * h * h));
    }
  EXPECT_GE(regular, 35u);
}

TEST(Curve_differentials, breaks_of_splines)
{
  // x^2 up to 1, then its tangent
  auto system = SC::Constraint_system_d::on_box({{0, 2}, {-1, 3}});
  system.add(SC::Spline_function(
                 SC::Spline_term{{0}, {2}, {{Rational(0), Rational(1), Rational(2)}}, {{0, 0, 1}, {-1, 2, 0}}}) -
                 SC::Spline_function(x(1)),
             SC::Relation::EQUAL);
  const auto bend = [&](const Rational& at) {
    return SC::curve_differentials<Rational>(system, box_of({at, at * at}), 0)->second_derivative()[1];
  };
  EXPECT_EQ(bend(Rational(99, 100)), 2);
  EXPECT_EQ(bend(1), 0);
  EXPECT_THROW(SC::curve_differentials<SC::Mpfr_interval>(
                   system, {{Rational(9, 10), Rational(11, 10)}, {Rational(1), Rational(1)}}),
               SC::Invalid_input);
}

TEST(Curve_differentials, images_on_splines)
{
  using K = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  // (u, v, uv), with a crease in u = 1, beyond which z = 2uv - v
  const SC::Bspline_surface_3<K> surface({1, 1}, {0, 0, 1, 2, 2}, {0, 0, 1, 1},
                                         {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 1}, {2, 0, 0}, {2, 1, 3}});
  auto [u, v] = SC::unknowns({0, 2}, {0, 1});
  const auto on_surface = SC::Spline_map<2, 3>(surface)(u, v);
  const std::vector<SC::Constraint> diagonal{u == v}, half{u == 2 * v};
  const auto before =
      SC::curve_differentials(make_system(diagonal), std::vector<double>{0.5, 0.5}, 0)->image(on_surface);
  EXPECT_EQ(before.squared_curvature(), Rational(8, 27));   // of (t, t, t^2)
  const auto behind = SC::curve_differentials(make_system(half), std::vector<double>{1, 0.5}, 1)->image(on_surface);
  EXPECT_EQ(behind.first_derivative(), (std::vector<Rational>{2, 1, 3}));   // of (2t, t, 4t^2 - t)
  EXPECT_EQ(behind.second_derivative(), (std::vector<Rational>{0, 0, 8}));

  const SC::Spline_map<1, 2> circle(SC::circle_curve(K::Point_2(1, 0), K::FT(2)));
  const auto [begin, end] = circle.domain(0);
  auto [t, s] = SC::unknowns({begin, end}, {begin, end});
  const std::vector<SC::Constraint> equal{t == s};
  const auto system = make_system(equal);
  for (int i = 0; i <= 10; ++i) {
    const Rational at = begin + (end - begin) * i / 10;
    EXPECT_EQ(SC::curve_differentials<Rational>(system, box_of({at, at}))->image(circle(t)).squared_curvature(),
              Rational(1, 4));
  }
}

TEST(Curve_differentials, bad_input)
{
  const auto circle = system_of({x(0) * x(0) + x(1) * x(1) - 4}, 2);
  EXPECT_THROW(SC::curve_differentials(circle, std::vector<double>{2, 0, 0}), SC::Invalid_input);
  EXPECT_THROW(SC::curve_differentials(circle, std::vector<double>{2, 0}, 2), SC::Invalid_input);
  EXPECT_THROW(SC::curve_differentials(circle, std::vector<double>{2, NAN}), SC::Invalid_input);
  EXPECT_THROW(SC::curve_differentials(system_of({x(0)}, 3), std::vector<double>{0, 0, 0}), SC::Invalid_input);
  const auto line = SC::curve_differentials(system_of({x(0), x(1)}, 3), std::vector<double>{0, 0, 0});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->squared_curvature(), 0);
  EXPECT_THROW(line->signed_curvature(), SC::Invalid_input);
}

} // namespace curve_differentials_test
