// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formula_test_curves.h"

#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/function/expression_derivative.h>
#include <CGAL/Spline_constraints_d/function/linear_elimination.h>

#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace expressions_test {

namespace {

using namespace formula_test;
using SC::Constraint;
using SC::Expression;
using SC::Invalid_input;
using SC::Relation;
using SC::Spline_map;
using SC::Vector_expression;

using Point_2 = std::array<Rational, 2>;

std::vector<std::vector<Rational>> knots(std::initializer_list<std::initializer_list<int>> values)
{
  std::vector<std::vector<Rational>> result;
  for (const auto& axis : values) {
    auto& knots = result.emplace_back();
    for (int t : axis)
      knots.push_back(Rational(t));
  }
  return result;
}

Rational inner(const Point_2& a, const Point_2& b) { return a[0] * b[0] + a[1] * b[1]; }
Point_2 minus(const Point_2& a, const Point_2& b) { return {a[0] - b[0], a[1] - b[1]}; }

Point_2 at(const Spline_map<1, 2>& map, const Rational& t) { return map(std::vector<Rational>{t}); }

// f(a) / f(b) = g(a) / g(b) for an expanded function and the value it should have up to a positive factor.
class Proportional
{
  Rational m_expanded = Rational(0), m_expected = Rational(0);
  int m_compared = 0;

public:
  void compare(const Rational& expanded, const Rational& expected)
  {
    EXPECT_EQ(CGAL::sign(expanded), CGAL::sign(expected));
    if (m_compared != 0) {
      EXPECT_EQ(expanded * m_expected, expected * m_expanded);
    }
    if (expected != Rational(0)) {
      m_expanded = expanded;
      m_expected = expected;
      ++m_compared;
    }
  }

  int compared() const { return m_compared; }
};

TEST(Expression, quotients_keep_equal_divisors_once)
{
  auto [x, y] = SC::unknowns({-2, 2}, {1, 3});
  const Expression d = x + y;
  const Expression sum = 1 / d + x / d;
  EXPECT_EQ((sum == 0).function, (1 + x).polynomial());
  EXPECT_EQ((sum == 0).conditions, std::vector<SC::Power_polynomial>{d.polynomial()});
  EXPECT_EQ((1 / d + 1 / (3 * d) == 0).conditions.size(), 1u);
  EXPECT_TRUE((x * x / x).is_polynomial());
  EXPECT_EQ((x * x / x).polynomial(), x.polynomial());
  EXPECT_THROW((1 / x).polynomial(), Invalid_input);
  EXPECT_EQ((x / y == 1).conditions.size(), 0u);   // y is at least 1
  EXPECT_EQ((x / y > 1).function, (x - y).polynomial());
  EXPECT_EQ((1 / x > 2).function, ((1 - 2 * x) * x).polynomial());
  EXPECT_EQ((1 / x > 2).conditions.size(), 1u);
  EXPECT_EQ((1 / (x * x) > 2).function, (1 - 2 * x * x).polynomial());
  EXPECT_EQ((x != y).relation, Relation::NOT_EQUAL);
  EXPECT_THROW(x / (y - y), Invalid_input);
  EXPECT_EQ((x / y / y)(std::vector<Rational>{Rational(1), Rational(3)}), ratio(1, 9));
  EXPECT_THROW((1 / x)(std::vector<Rational>{Rational(0), Rational(3)}), Invalid_input);
  EXPECT_THROW(x(std::vector<Rational>{Rational(0)}), Invalid_input);
  std::ostringstream out;
  out << (1 / x == y);
  EXPECT_EQ(out.str(), "1 - x0*x1 = 0, x0 != 0");
}

TEST(Expression, points_of_curves_are_exact)
{
  std::mt19937 random(1);
  const Circle circle{ratio(1, 3), Rational(2), ratio(5, 2)};
  const Spline_map<1, 2> c = circle.map();
  EXPECT_EQ(SC::parameters(circle, c)[1].domain(), SC::parameters(c)[0].domain());
  const auto coordinates = circle.homogeneous_coordinates();
  auto [u] = SC::parameters(c);
  const Vector_expression<2> p = c(u), tangent = derivative(c)(u);
  for (int i = 0; i < 50; ++i) {
    const std::vector<Rational> t = random_point(random, *u.domains());
    const Rational w = circle.weight()(t);
    const Point_2 expected{coordinates[0](t) / w, coordinates[1](t) / w};
    EXPECT_EQ(p(t), expected);
    EXPECT_EQ(c(t), expected);
    const Point_2 radius = minus(p(t), {circle.x, circle.y});
    EXPECT_EQ(inner(radius, radius), circle.radius * circle.radius);
    EXPECT_EQ(inner(radius, tangent(t)), Rational(0));
    EXPECT_GT(inner(tangent(t), tangent(t)), Rational(0));
  }
  // The identity holds for the expanded function as well, whose terms are all zero.
  const SC::Spline_function zero =
      (squared_norm(p - Vector_expression(circle.x, circle.y)) == circle.radius * circle.radius).spline_function();
  ASSERT_EQ(zero.terms().size(), 1u);
  EXPECT_EQ(zero.terms()[0].pieces, std::vector<std::vector<Rational>>{{Rational(0)}});
}

TEST(Expression, derivatives_are_those_of_the_splines)
{
  std::mt19937 random(2);
  const auto t = knots({{0, 0, 0, 0, 1, 2, 2, 3, 3, 3, 3}});
  const Spline x = random_spline(random, {3}, t), y = random_spline(random, {3}, t),
               w = random_spline(random, {3}, t, true);
  const Spline_map<1, 2> c({x, y}, w), first = derivative(c);
  for (int i = 0; i < 20; ++i) {
    const std::vector<Rational> at{ratio(static_cast<int>(random() % 300), 100)};
    const auto X = x.value_and_gradient(at), W = w.value_and_gradient(at);
    const Rational x1 = (X.gradient[0] * W.value - X.value * W.gradient[0]) / (W.value * W.value);
    EXPECT_EQ(first(at)[0], x1);
    // x'' = (X'' - 2 x' W' - x W'') / W
    const Rational x2 = (x.hessian(at)[0] - 2 * x1 * W.gradient[0] - X.value / W.value * w.hessian(at)[0]) / W.value;
    if (at[0] < 1) {   // beyond, the second derivative jumps at the double knot
      EXPECT_EQ(derivative(derivative(
                    Spline_map<1, 2>({x.restricted(0, 0, 1), y.restricted(0, 0, 1)}, w.restricted(0, 0, 1))))(at)[0],
                x2);
    }
  }
}

TEST(Expression, kinks_are_refused)
{
  std::mt19937 random(3);
  const auto t = knots({{0, 0, 0, 1, 1, 2, 2, 2}});
  const Spline x({2}, t, {Rational(0), Rational(1), Rational(2), Rational(2), Rational(3)}),
      y({2}, t, {Rational(0), Rational(0), Rational(0), Rational(5), Rational(1)});
  const Spline_map<1, 2> kinked({x, y});
  try {
    derivative(kinked);
    ADD_FAILURE();
  } catch (const Invalid_input& error) {
    EXPECT_NE(std::string(error.what()).find("at the parameter 1 of axis 0"), std::string::npos) << error.what();
  }
  EXPECT_EQ(kinked.breaks(0), (std::vector<Rational>{Rational(0), Rational(1), Rational(2)}));
  for (int i = 0; i < 2; ++i) {
    const Spline_map<1, 2> part = kinked.restricted(0, i, i + 1);
    EXPECT_EQ(part.domain(0), (std::pair{Rational(i), Rational(i + 1)}));
    EXPECT_EQ(at(derivative(part), Rational(1)), (Point_2{Rational(2 - 2 * i), Rational(10 * i)}));
    EXPECT_THROW(part(std::vector<Rational>{ratio(3, 2 + 8 * i)}), Invalid_input);
  }
  EXPECT_THROW(kinked.restricted(0, 1, 3), Invalid_input);
  EXPECT_THROW(kinked.restricted(0, 1, 1), Invalid_input);
  EXPECT_NO_THROW(derivative(Circle{Rational(0), Rational(0), Rational(1)}.map()));
}

TEST(Expression, expansion_agrees_with_evaluation)
{
  std::mt19937 random(4);
  const auto a_knots = knots({{0, 0, 0, 0, 1, 2, 2, 2, 2}}), b_knots = knots({{0, 0, 0, 1, 3, 3, 3}}),
             c_knots = knots({{0, 0, 0, 1, 1, 1}, {0, 0, 0, 0, 2, 2, 2, 2}});
  for (int repeat = 0; repeat < 4; ++repeat) {
    const Spline_map<1, 2> a({random_spline(random, {3}, a_knots), random_spline(random, {3}, a_knots)},
                             random_spline(random, {3}, a_knots, true));
    const Spline_map<1, 2> b({random_spline(random, {2}, b_knots), random_spline(random, {2}, b_knots)});
    const Spline_map<2, 2> s({random_spline(random, {2, 3}, c_knots), random_spline(random, {2, 3}, c_knots)},
                             random_spline(random, {2, 3}, c_knots, true));
    auto [q, u, p, v, x] = SC::unknowns({0, 2}, {0, 2}, {0, 1}, {0, 3}, {-1, 1});
    // the axes of s in the other order
    const Vector_expression<2> A = a(u), B = b(v), S = s(p, q), moving(x, 1 - x * x);
    const std::vector<Expression> formulas{
        dot(A - B, derivative(a)(u)),       squared_norm(A - B) - squared_norm(A - moving),
        cross(S - A, derivative(b)(v)) + x, dot(S - B, derivative(s, 1)(p, q)),
        A[0] + 3 * B[1] + S[0] - x * x * x, pow(A[0] - B[0], 3),
        midpoint(A, S)[1] * x - B[0]};
    for (const Expression& formula : formulas) {
      const SC::Spline_function equation = (formula == 0).spline_function(),
                                inequality = (formula > ratio(1, 7)).spline_function();
      const Expression times_denominator = Expression((formula == 0).function, {}, u.symbols());
      Proportional expanded, scaled;
      for (int i = 0; i < 12; ++i) {
        const std::vector<Rational> point = random_point(random, *u.domains());
        EXPECT_EQ(CGAL::sign(value(equation, point)), CGAL::sign(formula(point)));
        EXPECT_EQ(CGAL::sign(value(inequality, point)), CGAL::sign(formula(point) - ratio(1, 7)));
        expanded.compare(value(equation, point), times_denominator(point));
      }
      EXPECT_GE(expanded.compared(), 6);
    }
  }
}

// A formula of some leaves, and its value at a point by the operations it is made of; nothing where something is
// divided by zero.
class Random_formula
{
  std::mt19937& m_random;
  const std::vector<Expression>& m_leaves;
  const std::vector<std::vector<Rational>>& m_values;   // of the leaves, for each point

public:
  Random_formula(std::mt19937& random, const std::vector<Expression>& leaves,
                 const std::vector<std::vector<Rational>>& values)
    : m_random(random), m_leaves(leaves), m_values(values)
  {}

  std::pair<Expression, std::vector<std::optional<Rational>>> operator()(int depth)
  {
    std::vector<std::optional<Rational>> values;
    if (depth == 0 || m_random() % 5 == 0) {
      const std::size_t leaf = m_random() % m_leaves.size();
      for (const auto& at_point : m_values)
        values.push_back(at_point[leaf]);
      return {m_leaves[leaf], values};
    }
    const auto [a, a_values] = (*this)(depth - 1);
    const auto [b, b_values] = (*this)(depth - 1);
    const unsigned operation = m_random() % 7;
    const bool is_quotient = operation == 6 && !b.numerator().is_zero();
    for (std::size_t i = 0; i < a_values.size(); ++i)
      if (!a_values[i] || !b_values[i] || (is_quotient && *b_values[i] == Rational(0)))
        values.push_back(std::nullopt);
      else {
        const Rational &x = *a_values[i], &y = *b_values[i];
        values.push_back(operation < 2       ? Rational(x + y)
                             : operation < 4 ? Rational(x - y)
                             : is_quotient   ? Rational(x / y)
                                             : Rational(x * y));
      }
    return {operation < 2 ? a + b : operation < 4 ? a - b : is_quotient ? a / b : a * b, values};
  }
};

TEST(Expression, random_formulas)
{
  std::mt19937 random(13);
  const auto a_knots = knots({{0, 0, 0, 1, 2, 2, 2}}), b_knots = knots({{0, 0, 1, 1}, {0, 0, 1, 2, 2}});
  const Spline_map<1, 2> a({random_spline(random, {2}, a_knots), random_spline(random, {2}, a_knots)},
                           random_spline(random, {2}, a_knots, true)),
      b = bezier_curve({{1, 0}, {0, 2}, {3, 3}});
  const Spline_map<2, 2> s({random_spline(random, {1, 1}, b_knots), random_spline(random, {1, 1}, b_knots)},
                           random_spline(random, {1, 1}, b_knots, true));
  auto [u, v, w, x] = SC::unknowns({0, 2}, {0, 1}, {0, 2}, {-1, 1});
  const std::vector<Expression> leaves{a(u)[0], a(u)[1], b(v)[0], b(v)[1], s(v, w)[0], s(v, w)[1],
                                       a(w)[0], x,       u,       x + 1,   3,          Expression(ratio(-1, 2))};
  std::vector<std::vector<Rational>> points, values;
  for (int i = 0; i < 8; ++i) {
    points.push_back(random_point(random, *u.domains()));
    auto& at_point = values.emplace_back();
    for (const Expression& leaf : leaves)
      at_point.push_back(leaf(points.back()));
  }
  Random_formula formulas(random, leaves, values);
  int compared = 0;
  for (int repeat = 0; repeat < 150; ++repeat) {
    const auto [formula, expected] = formulas(3);
    if (formula.symbols() == nullptr)
      continue;
    const SC::Spline_function equation = (formula == 0).spline_function(), inequality = (formula > 0).spline_function();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (expected[i]) {
        EXPECT_EQ(formula(points[i]), *expected[i]);
        EXPECT_EQ(value(equation, points[i]) == Rational(0), *expected[i] == Rational(0));
        EXPECT_EQ(CGAL::sign(value(inequality, points[i])), CGAL::sign(*expected[i]));
        ++compared;
      }
  }
  EXPECT_GE(compared, 800);
}

TEST(Expression, sums_stay_apart_and_parts_join)
{
  const Spline_map<1, 2> a = bezier_curve({{0, 0}, {1, 3}, {4, 1}, {2, 2}}), b = bezier_curve({{1, 0}, {0, 2}, {3, 3}});
  auto [u, v, w] = SC::parameters(a, b, a);
  const SC::Spline_function difference = (a(u)[0] == b(v)[0] + a(w)[1]).spline_function();
  EXPECT_EQ(difference.terms().size(), 3u);
  EXPECT_EQ(number_of_coefficients(difference), 4u + 3u + 4u);
  // <A, B> + A_x + B_x + 1: everything joins the tensor of the product.
  const SC::Spline_function product = (dot(a(u), b(v)) + a(u)[0] + b(v)[0] == 1).spline_function();
  ASSERT_EQ(product.terms().size(), 1u);
  EXPECT_EQ(product.terms()[0].degrees, (std::vector<int>{3, 2}));
  // A square of A stays beside the product: joining it would make more coefficients.
  EXPECT_EQ((dot(a(u), b(v)) + squared_norm(squared_norm(a(u)) * a(u)) == 1).spline_function().terms().size(), 2u);
  // Two products share an unknown.
  EXPECT_EQ((dot(a(u), b(v)) == dot(a(u), a(w))).spline_function().terms().size(), 2u);
}

TEST(Expression, common_weights_cancel)
{
  const Spline_map<1, 2> c = Circle{Rational(0), Rational(0), Rational(2)}.map(),
                         d = Circle{Rational(5), Rational(1), Rational(1)}.map();
  auto [u, v] = SC::parameters(c, d);
  // (x1 w2 - x2 w1) / (w1 w2): the weights are not squared.
  const SC::Spline_function difference = (c(u)[0] == d(v)[0]).spline_function();
  ASSERT_EQ(difference.terms().size(), 1u);
  EXPECT_EQ(difference.terms()[0].degrees, (std::vector<int>{2, 2}));
  EXPECT_EQ((c(u)[0] * c(u)[1] == c(u)[0]).spline_function().terms()[0].degrees, std::vector<int>{4});
  EXPECT_TRUE((c(u) - c(u))[0].is_polynomial());
  EXPECT_TRUE((c(u)[0] == d(v)[0]).conditions.empty());
}

TEST(Expression, numbers_beyond_native_integers)
{
  std::mt19937 random(5);
  const Rational huge = SC::internal::power_of_two(200);
  const Spline_map<1, 2> a = bezier_curve({{0, 0}, {1, 3}, {4, 1}, {2, 2}});
  auto [u, v] = SC::parameters(a, a);
  const Expression formula = huge * a(u)[0] * a(v)[1] + a(v)[0] / huge - 1;
  const SC::Spline_function function = (formula == 0).spline_function();
  Proportional expanded;
  for (int i = 0; i < 10; ++i) {
    const std::vector<Rational> point = random_point(random, *u.domains());
    expanded.compare(value(function, point), formula(point));
  }
  EXPECT_GE(expanded.compared(), 5);
}

TEST(Expression, wide_integers_convert)
{
#ifdef CGAL_SPLINE_CONSTRAINTS_D_HAS_WIDE_INTEGER
  for (int bits : {0, 1, 31, 62, 63, 64, 65, 100, 126})
    for (int sign : {-1, 1})
      for (int offset : {-1, 0, 1}) {
        SC::internal::Big_integer value(1);
        SC::internal::shift_left(value, static_cast<unsigned long>(bits));
        value = sign * (value + offset);
        SC::internal::Wide_integer wide;
        SC::internal::convert(value, wide);
        SC::internal::Big_integer back(5);
        SC::internal::assign(back.backend().data(), wide);
        EXPECT_EQ(back, value);
        EXPECT_EQ(SC::internal::to_rationals<Rational>(std::vector{wide})[0], SC::internal::scaled_rational(value, 0));
      }
#endif
}

TEST(Expression, formulas_are_differentiated)
{
  std::mt19937 random(12);
  const auto t = knots({{0, 0, 0, 0, 1, 2, 2, 2, 2}});
  const Spline_map<1, 2> c({random_spline(random, {3}, t), random_spline(random, {3}, t)},
                           random_spline(random, {3}, t, true));
  const Spline_map<2, 2> s({random_spline(random, {2, 1}, knots({{0, 0, 0, 2, 2, 2}, {0, 0, 1, 1}})),
                            random_spline(random, {2, 1}, knots({{0, 0, 0, 2, 2, 2}, {0, 0, 1, 1}}))});
  auto [u, v, x] = SC::unknowns({0, 2}, {0, 1}, {1, 2});
  const auto domains = u.domains();
  const auto vanishes = [&](const Expression& formula) {
    int defined = 0;
    for (int i = 0; i < 10; ++i)
      try {
        EXPECT_EQ(formula(random_point(random, *domains)), Rational(0));
        ++defined;
      } catch (const Invalid_input&) {   // a divisor is zero there
      }
    EXPECT_GE(defined, 5);
  };
  vanishes(derivative(c(u), u)[0] - derivative(c)(u)[0]);
  vanishes(derivative(c(u), u)[1] - derivative(c)(u)[1]);
  vanishes(derivative(s(u, v), v)[0] - derivative(s, 1)(u, v)[0]);
  EXPECT_TRUE((derivative(c(u)[0], v) == 0).function.is_zero());
  const Expression a = c(u)[0] * x / (x + c(u)[1]), b = s(u, v)[1] / x;   // Leibniz
  vanishes(derivative(a * b, u) - derivative(a, u) * b - a * derivative(b, u));
  vanishes(derivative(a / b, x) * b * b - derivative(a, x) * b + a * derivative(b, x));
  vanishes(derivative(derivative(a, u), x) - derivative(derivative(a, x), u));
  EXPECT_EQ(derivative(pow(x, 3) * u, x).polynomial(), (3 * x * x * u).polynomial());
  auto [w] = SC::unknowns({0, 4});
  EXPECT_THROW(derivative(x, w), Invalid_input);
  // x' and w' jump
  EXPECT_THROW(derivative(Circle{Rational(0), Rational(0), Rational(1)}.map()(w)[0], w), Invalid_input);
}

TEST(Expression, unknowns_with_one_value)
{
  const Circle circle{Rational(0), Rational(0), Rational(5)};
  auto [u, v, x] = SC::unknowns({1, 1}, {ratio(7, 2), ratio(7, 2)}, {-9, 9});
  const Spline_map<1, 2> c = circle.map();
  const SC::Spline_function function = (c(u)[1] * c(v)[0] + x == 0).spline_function();
  EXPECT_EQ(value(function, std::vector<Rational>{Rational(1), ratio(7, 2), Rational(-15)}), Rational(0));
  EXPECT_NE(value(function, std::vector<Rational>{Rational(1), ratio(7, 2), Rational(-14)}), Rational(0));
}

TEST(Linear_elimination, lines_meet_in_their_point)
{
  std::mt19937 random(6);
  const Spline_map<1, 2> c = Circle{Rational(0), Rational(0), Rational(2)}.map(),
                         d = bezier_curve({{5, 0}, {4, 2}, {7, 3}});
  auto [u, v] = SC::parameters(c, d);
  const Vector_expression<2> p = meet(normal_line(c, u), normal_line(d, v));
  const Constraint constraint = p[0] == 1;
  ASSERT_EQ(constraint.conditions.size(), 1u);
  EXPECT_EQ((p[1] + p[0] == 1).conditions, constraint.conditions);   // one determinant, known once
  int met = 0;
  for (int i = 0; i < 30; ++i) {
    const std::vector<Rational> point = random_point(random, *u.domains());
    const Point_2 C = at(c, point[0]), D = at(d, point[1]), dC = at(derivative(c), point[0]),
                  dD = at(derivative(d), point[1]);
    if (dC[0] * dD[1] == dC[1] * dD[0])
      continue;
    EXPECT_EQ(inner(minus(p(point), C), dC), Rational(0));
    EXPECT_EQ(inner(minus(p(point), D), dD), Rational(0));
    ++met;
  }
  EXPECT_GE(met, 20);
}

TEST(Linear_elimination, equations_are_solved)
{
  std::mt19937 random(7);
  const Spline_map<1, 2> c1 = Circle{Rational(0), Rational(0), Rational(1)}.map(),
                         c2 = Circle{Rational(5), Rational(0), Rational(2)}.map(),
                         c3 = Circle{Rational(1), Rational(6), Rational(1)}.map();
  auto [u, v, w] = SC::parameters(c1, c2, c3);
  const auto p = SC::unknowns_without_range<2>(u);
  const auto center = SC::solve_linear(
      {squared_norm(p - c1(u)) == squared_norm(p - c2(v)), squared_norm(p - c1(u)) == squared_norm(p - c3(w))}, p);
  const auto same = meet(equidistant_hyperplane(c1(u), c2(v)), equidistant_hyperplane(c1(u), c3(w)));
  for (int i = 0; i < 20; ++i) {
    const std::vector<Rational> point = random_point(random, *u.domains());
    const Point_2 P = center(point), a = minus(P, at(c1, point[0])), b = minus(P, at(c2, point[1])),
                  c = minus(P, at(c3, point[2]));
    EXPECT_EQ(inner(a, a), inner(b, b));
    EXPECT_EQ(inner(a, a), inner(c, c));
    EXPECT_EQ(same(point), P);
  }
  // The weights that numerators and determinant share are gone: the determinant of the homogeneous coordinates is
  // trilinear in the circles.
  const Constraint constraint = center[0] == 0;
  ASSERT_EQ(constraint.conditions.size(), 1u);
  EXPECT_EQ(constraint.condition_functions()[0].terms()[0].degrees, (std::vector<int>{2, 2, 2}));
  EXPECT_EQ(constraint.spline_function().terms()[0].degrees, (std::vector<int>{4, 4, 4}));

  EXPECT_THROW((p[0] == 1).spline_function(), Invalid_input);
  EXPECT_THROW(p[0](std::vector<Rational>(3, Rational(1))), Invalid_input);
  EXPECT_THROW(SC::solve_linear({p[0] * p[1] == 1, p[0] == u}, p), Invalid_input);
  EXPECT_THROW(SC::solve_linear({p[0] + p[1] == 1, p[0] + p[1] == u}, p), Invalid_input);
  EXPECT_THROW(SC::solve_linear({p[0] + p[1] == 1, p[0] > u}, p), Invalid_input);
  EXPECT_THROW(SC::solve_linear({p[0] / (u - v) == 1, p[0] == p[1]}, p), Invalid_input);
  EXPECT_THROW(SC::solve_linear({p[0] == 1, p[1] == 1}, 2 * p), Invalid_input);
}

TEST(Linear_elimination, planes_meet_in_their_point)
{
  auto [x, y, z, t] = SC::unknowns({-9, 9}, {-9, 9}, {-9, 9}, {1, 2});
  const auto p = SC::solve_linear({x + y + z == 6, x - y + t * z == 2, 2 * x + y - z == t}, Vector_expression(x, y, z));
  for (const Rational& value : {Rational(1), ratio(3, 2), ratio(7, 4), Rational(2)}) {
    const auto P = p(std::vector<Rational>{Rational(0), Rational(0), Rational(0), value});
    EXPECT_EQ(P[0] + P[1] + P[2], Rational(6));
    EXPECT_EQ(P[0] - P[1] + value * P[2], Rational(2));
    EXPECT_EQ(2 * P[0] + P[1] - P[2], value);
  }
}

TEST(Linear_elimination, values_take_the_place_of_unknowns)
{
  std::mt19937 random(9);
  const Spline_map<1, 2> c = Circle{Rational(0), Rational(0), Rational(2)}.map();
  auto [x, y, u] = SC::unknowns({2, 3}, {-1, 1}, {0, 4});
  const Vector_expression<2> p = c(u);
  const Expression formula = (x * x * p[0] - y) / (x + y) / x + p[1] * x, value = (y + p[1]) / p[0];
  const Expression result = SC::substituted(formula, x, value);
  int defined = 0;
  for (int i = 0; i < 20; ++i) {
    std::vector<Rational> point = random_point(random, *u.domains());
    if (p[0](point) == Rational(0))
      continue;
    const Rational expected = value(point);
    if (expected == Rational(0) || expected == -point[1])
      continue;
    const Rational actual = result(point);
    point[0] = expected;
    EXPECT_EQ(actual, formula(point));
    ++defined;
  }
  EXPECT_GE(defined, 10);
  EXPECT_EQ(SC::substituted(x * x + y, x, y - 1).polynomial(), (square(y - 1) + y).polynomial());
  EXPECT_THROW(SC::substituted(p[0] + u, u, y), Invalid_input);
  EXPECT_THROW(SC::substituted(x, x + y, y), Invalid_input);
  EXPECT_THROW(SC::substituted(1 / x, x, y - y), Invalid_input);
}

TEST(Exact_division, factors_are_removed)
{
  std::mt19937 random(10);
  const Spline_map<1, 2> c = bezier_curve({{0, 0}, {5, 3}, {-4, 3}, {2, -1}});
  auto [u, v] = SC::parameters(c, c);
  const Vector_expression<2> chord = c(u) - c(v), quotient = SC::divided_exactly(chord, u - v);
  const Expression area = cross(chord, chord + derivative(c)(u)), reduced = SC::divided_exactly(area, u - v, 2);
  EXPECT_EQ((quotient[0] == 0).spline_function().terms()[0].degrees, (std::vector<int>{2, 2}));
  for (int i = 0; i < 20; ++i) {
    std::vector<Rational> point = random_point(random, *u.domains());
    const Rational difference = point[0] - point[1];
    EXPECT_EQ(quotient[0](point) * difference, chord[0](point));
    EXPECT_EQ(quotient[1](point) * difference, chord[1](point));
    EXPECT_EQ(reduced(point) * difference * difference, area(point));
    point[1] = point[0];   // the limit on the diagonal is the derivative
    EXPECT_EQ(quotient(point), derivative(c)(u)(point));
  }
  EXPECT_EQ(SC::divided_exactly(pow(u, 3) - pow(v, 3), 2 * v - 2 * u).polynomial(),
            (-(u * u + u * v + v * v) / 2).polynomial());
  EXPECT_EQ(SC::divided_exactly((u * u - v * v) / (u + 3), u - v)(std::vector<Rational>{ratio(1, 2), ratio(1, 4)}),
            ratio(3, 14));
  EXPECT_THROW(SC::divided_exactly(chord[0], u - v, 2), Invalid_input);
  EXPECT_THROW(SC::divided_exactly(chord[0] + 1, u - v), Invalid_input);
  EXPECT_THROW(SC::divided_exactly(u * u + v, u - v), Invalid_input);
  EXPECT_THROW(SC::divided_exactly(chord[0], chord[0]), Invalid_input);
  EXPECT_THROW(SC::divided_exactly(chord[0], 2 + 0 * u), Invalid_input);
  EXPECT_THROW(SC::divided_exactly(u * v * u, u * v), Invalid_input);
  EXPECT_THROW(SC::divided_exactly(u, v, -1), Invalid_input);
}

TEST(Exact_division, breaks_are_respected)
{
  const Spline_map<1, 2> circle = Circle{Rational(0), Rational(0), Rational(1)}.map();
  auto [u, v] = SC::parameters(circle, circle);
  const Expression chord = circle(u)[0] - circle(v)[0];
  EXPECT_THROW(SC::divided_exactly(chord, u - v), Invalid_input);
  EXPECT_EQ(circle.breaks(0), (std::vector<Rational>{Rational(0), Rational(1), Rational(3), Rational(4)}));
  const Spline_map<1, 2> half = circle.restricted(0, 1, 3);
  auto [p, q] = SC::parameters(half, half);
  const std::vector<Rational> ends{Rational(1), Rational(3)};
  EXPECT_EQ(SC::divided_exactly(half(p) - half(q), p - q)(ends), (Point_2{Rational(0), Rational(-1)}));
  // A factor of every piece, on both sides of a break: (t - 1)(2 - t) for t < 1, and t - 1 beyond.
  const Spline_map<1, 2> kinked({Spline({2}, knots({{0, 0, 0, 1, 1, 2, 2, 2}}),
                                        {Rational(-2), ratio(-1, 2), Rational(0), ratio(1, 2), Rational(1)}),
                                 Spline({2}, knots({{0, 0, 0, 1, 1, 2, 2, 2}}),
                                        {Rational(1), Rational(0), Rational(0), Rational(0), Rational(1)})});
  auto [t] = SC::parameters(kinked);
  const Expression slope = SC::divided_exactly(kinked(t)[0], t - 1);
  EXPECT_EQ(slope(std::vector<Rational>{ratio(1, 2)}), ratio(3, 2));
  EXPECT_EQ(slope(std::vector<Rational>{ratio(3, 2)}), Rational(1));
  EXPECT_EQ(SC::divided_exactly(kinked(t)[1], t - 1)(std::vector<Rational>{Rational(0)}), Rational(-1));
  // Dividing |t - 1| would leave a jump.
  const Spline_map<1, 2> folded({Spline({1}, knots({{0, 0, 1, 2, 2}}), {Rational(1), Rational(0), Rational(1)}),
                                 Spline({1}, knots({{0, 0, 1, 2, 2}}), {Rational(0), Rational(0), Rational(1)})});
  auto [s] = SC::parameters(folded);
  EXPECT_THROW(SC::divided_exactly(folded(s)[0], s - 1), Invalid_input);
}

TEST(Spline_map, surfaces_and_their_normals)
{
  std::mt19937 random(8);
  const auto t = knots({{0, 0, 0, 1, 2, 2, 2}, {0, 0, 1, 1}});
  const Spline x = random_spline(random, {2, 1}, t), y = random_spline(random, {2, 1}, t),
               z = random_spline(random, {2, 1}, t), w = random_spline(random, {2, 1}, t, true);
  const Spline_map<2, 3> s({x, y, z}, w);
  auto [u, v] = SC::parameters(s);
  const Vector_expression<3> n = normal(s, u, v);
  for (int i = 0; i < 10; ++i) {
    const auto point = random_point(random, *u.domains());
    const auto N = n(point), S_u = derivative(s, 0)(point), S_v = derivative(s, 1)(point);
    EXPECT_EQ(N[0], S_u[1] * S_v[2] - S_u[2] * S_v[1]);
    EXPECT_EQ(N[0] * S_u[0] + N[1] * S_u[1] + N[2] * S_u[2], Rational(0));
    EXPECT_EQ(N[0] * S_v[0] + N[1] * S_v[1] + N[2] * S_v[2], Rational(0));
  }
  EXPECT_EQ((determinant(derivative(s, 0)(u, v), n, derivative(s, 1)(u, v)) == dot(n, n)).function.total_degree(),
            (dot(n, n) == 0).function.total_degree());
}

TEST(Spline_map, bad_input_is_refused)
{
  const Circle circle{Rational(0), Rational(0), Rational(1)};
  const Spline_map<1, 2> c = circle.map();
  const auto [x, y] = circle.homogeneous_coordinates();
  EXPECT_THROW((Spline_map<1, 2>({x, y.restricted(0, 0, 2)})), Invalid_input);
  EXPECT_THROW((Spline_map<1, 2>({x, y}, x)), Invalid_input);
  EXPECT_THROW((Spline_map<2, 2>({x, y})), Invalid_input);
  EXPECT_NO_THROW((Spline_map<1, 2>({x, y}, -circle.weight())));
  EXPECT_EQ((Spline_map<1, 2>({-x, -y}, -circle.weight())(std::vector<Rational>{ratio(1, 2)})), at(c, ratio(1, 2)));
  auto [u, v] = SC::unknowns({0, 5}, {0, 1});
  EXPECT_THROW(c(u), Invalid_input);
  EXPECT_THROW(c(std::vector<Rational>{Rational(5)}), Invalid_input);
  EXPECT_THROW(c(std::vector<Rational>{}), Invalid_input);
  EXPECT_THROW(derivative(c, 1), Invalid_input);
  const Spline_map<2, 2> s({x.embedded({{0, 4}, {0, 1}}, {0}), y.embedded({{0, 4}, {0, 1}}, {0})});
  EXPECT_THROW(s(v, v), Invalid_input);
  auto [other] = SC::unknowns({0, 1});
  EXPECT_THROW(c(v)[0] + c(other)[0], Invalid_input);
  EXPECT_THROW(s(v, other), Invalid_input);
  // On a part of the curve only the pieces that are needed are looked at.
  EXPECT_EQ((c(v)[0] == 1).spline_function().terms()[0].pieces.size(), 1u);
  // The surface does not depend on its second parameter.
  auto [p, q] = SC::parameters(s);
  EXPECT_EQ((s(p, q)[0] == 1).spline_function().terms()[0].variables, std::vector<int>{0});
}

} // namespace

} // namespace expressions_test
