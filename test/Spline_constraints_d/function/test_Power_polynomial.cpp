// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <random>

namespace Power_polynomial_test {

namespace SC = CGAL::Spline_constraints;
using SC::Exact_rational;
using SC::Invalid_input;
using SC::Monomial;
using SC::Power_polynomial;

namespace {

Power_polynomial unknown(int index) { return Power_polynomial::variable(index); }

Exact_rational ratio(int numerator, int denominator) { return Exact_rational(numerator) / Exact_rational(denominator); }

// Random terms, with repetitions, in the unknowns 0..3 except 1.
Power_polynomial random_polynomial(std::mt19937_64& random, int terms, int degree)
{
  std::uniform_int_distribution<int> coefficient(-9, 9), divisor(1, 12), exponent(0, degree);
  Power_polynomial result;
  for (int i = 0; i < terms; ++i) {
    Power_polynomial term = ratio(coefficient(random), divisor(random));
    for (int v : {0, 2, 3})
      term *= pow(unknown(v), exponent(random));
    result += term;
  }
  return result;
}

std::vector<Exact_rational> random_point(std::mt19937_64& random)
{
  std::uniform_int_distribution<int> numerator(-20, 20), denominator(1, 9);
  std::vector<Exact_rational> point;
  for (int v = 0; v < 4; ++v)
    point.push_back(ratio(numerator(random), denominator(random)));
  return point;
}

TEST(Power_polynomial, constants)
{
  EXPECT_TRUE(Power_polynomial().is_zero());
  EXPECT_TRUE(Power_polynomial(0).is_zero());
  EXPECT_TRUE(Power_polynomial(0.0).is_zero());
  EXPECT_TRUE(Power_polynomial(Exact_rational(0)).is_constant());
  EXPECT_EQ(Power_polynomial(0.1).constant_term(), Exact_rational(0.1));
  EXPECT_NE(Power_polynomial(0.1).constant_term(), ratio(1, 10));
  EXPECT_EQ(Power_polynomial(std::size_t(1) << 63).constant_term(), Exact_rational(0x1p63));
  EXPECT_EQ(Power_polynomial(-5L).constant_term(), Exact_rational(-5));
  EXPECT_EQ(Power_polynomial(Exact_rational(1) / 3) * 3, Power_polynomial(1));
  EXPECT_THROW(Power_polynomial{std::numeric_limits<double>::quiet_NaN()}, Invalid_input);
  EXPECT_THROW(Power_polynomial{-std::numeric_limits<double>::infinity()}, Invalid_input);
  EXPECT_THROW(Power_polynomial::variable(-1), Invalid_input);
}

TEST(Power_polynomial, structure)
{
  const Power_polynomial x = unknown(0), y = unknown(3);
  const Power_polynomial p = 3 * x * x * y - y / 2 + 1;
  ASSERT_EQ(p.terms().size(), 3u);
  EXPECT_EQ(p.terms().at(Monomial{{{0, 2}, {3, 1}}}), Exact_rational(3));
  EXPECT_EQ(p.terms().at(Monomial{{{3, 1}}}), ratio(-1, 2));
  EXPECT_EQ(p.terms().at(Monomial{}), Exact_rational(1));
  EXPECT_EQ(p.degree(0), 2);
  EXPECT_EQ(p.degree(1), 0);
  EXPECT_EQ(p.degree(3), 1);
  EXPECT_EQ(p.total_degree(), 3);
  EXPECT_EQ(p.variables(), (std::vector<int>{0, 3}));
  EXPECT_FALSE(p.is_constant());
  EXPECT_EQ(Power_polynomial().total_degree(), 0);
  EXPECT_TRUE((p - p).is_zero());
  EXPECT_TRUE((p - p).terms().empty());
}

TEST(Power_polynomial, ring_laws_and_values_on_random_input)
{
  std::mt19937_64 random(20260101);
  for (int round = 0; round < 60; ++round) {
    const Power_polynomial p = random_polynomial(random, 7, 3), q = random_polynomial(random, 5, 2),
                           r = random_polynomial(random, 4, 2);
    EXPECT_EQ(p * q, q * p);
    EXPECT_EQ((p + q) * r, p * r + q * r);
    EXPECT_EQ((p * q) * r, p * (q * r));
    EXPECT_EQ(p - q, p + (-q));
    const std::vector<Exact_rational> point = random_point(random);
    EXPECT_EQ((p * q)(point), p(point) * q(point));
    EXPECT_EQ((p + q)(point), p(point) + q(point));
    EXPECT_EQ(pow(q, 3), q * q * q);
    EXPECT_EQ((p * q).derivative(2), p.derivative(2) * q + p * q.derivative(2));
    for (const auto& [monomial, coefficient] : (p * q).terms())
      EXPECT_NE(coefficient, Exact_rational(0));
    // Substitution and evaluation commute.
    std::vector<Exact_rational> moved(point);
    moved[2] = r(point);
    EXPECT_EQ(p.substituted(2, r)(point), p(moved));
  }
}

TEST(Power_polynomial, products_that_cancel)
{
  const Power_polynomial x = unknown(0), y = unknown(1);
  EXPECT_EQ((x - y) * (x + y), x * x - y * y);
  EXPECT_EQ((x - 1) * (x * x + x + 1), pow(x, 3) - 1);
  EXPECT_EQ((x / 2 - y / 3) * (x / 2 + y / 3), x * x / 4 - y * y / 9);
  EXPECT_EQ(pow(x + y, 0), Power_polynomial(1));
  EXPECT_EQ(pow(Power_polynomial(), 0), Power_polynomial(1));
  EXPECT_TRUE(pow(Power_polynomial(), 5).is_zero());
  EXPECT_EQ(pow(x / 2, 5), pow(x, 5) / 32);
}

TEST(Power_polynomial, monomials_in_too_many_unknowns_to_pack)
{
  // 100 unknowns of degree 2: exponents of the product do not fit in one machine word.
  Power_polynomial sum;
  for (int v = 0; v < 100; ++v)
    sum += (v + 1) * unknown(7 * v);
  const Power_polynomial square = sum * sum;
  EXPECT_EQ(square.terms().size(), 100u * 101u / 2u);
  EXPECT_EQ(square.terms().at(Monomial{{{0, 2}}}), Exact_rational(1));
  EXPECT_EQ(square.terms().at(Monomial{{{7, 1}, {693, 1}}}), Exact_rational(2 * 2 * 100));
  std::vector<Exact_rational> ones(694, Exact_rational(1));
  EXPECT_EQ(square(ones), Exact_rational(5050 * 5050));
}

TEST(Power_polynomial, large_expansion)
{
  const auto start = std::chrono::steady_clock::now();
  const Power_polynomial p = pow(unknown(0) + unknown(1) + unknown(2) + 1, 24);
  EXPECT_EQ(p.terms().size(), 2925u);   // 27 over 3
  std::vector<Exact_rational> point{Exact_rational(1), Exact_rational(2), ratio(-7, 2)};
  EXPECT_EQ(p(point), Exact_rational(1) / Exact_rational(1 << 24));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(Power_polynomial, evaluation_and_derivative)
{
  const Power_polynomial x = unknown(0), y = unknown(1);
  const Power_polynomial p = 29 * pow(x, 3) / 16 - 2 * x * y;
  EXPECT_EQ(p(std::vector<Exact_rational>{Exact_rational(2), Exact_rational(-1)}), ratio(37, 2));
  EXPECT_EQ(p.derivative(0), 87 * x * x / 16 - 2 * y);
  EXPECT_EQ(p.derivative(1), -2 * x);
  EXPECT_TRUE(p.derivative(5).is_zero());
  EXPECT_THROW(p(std::vector<Exact_rational>{Exact_rational(1)}), Invalid_input);
  EXPECT_EQ(Power_polynomial(7)({}), Exact_rational(7));
}

TEST(Power_polynomial, substitution)
{
  const Power_polynomial x = unknown(0), y = unknown(1);
  const Power_polynomial p = pow(x, 4) - 3 * x * y + 2;
  EXPECT_EQ(p.substituted(0, y + 1), pow(y + 1, 4) - 3 * y * (y + 1) + 2);
  EXPECT_EQ(p.substituted(0, 2), 18 - 6 * y);
  EXPECT_EQ(p.substituted(9, y), p);
  EXPECT_TRUE(Power_polynomial().substituted(0, y).is_zero());
}

TEST(Power_polynomial, written_form)
{
  const Power_polynomial x = unknown(0), y = unknown(1);
  const std::vector<std::string> names{"u", "v(1)"};
  EXPECT_EQ((3 * x * x * y - y + ratio(-1, 2)).to_string(names), "-1/2 + 3*u^2*v(1) - v(1)");
  EXPECT_EQ((-x / 3).to_string(), "-1/3*x0");
  EXPECT_EQ((x / 3).to_string(), "1/3*x0");
  EXPECT_EQ(Power_polynomial().to_string(names), "0");
  EXPECT_EQ(Power_polynomial(-1).to_string(names), "-1");
  EXPECT_THROW((x * unknown(2)).to_string(names), Invalid_input);
}

TEST(Power_polynomial, limits_are_reached_quickly)
{
  const auto start = std::chrono::steady_clock::now();
  const Power_polynomial x = unknown(0), y = unknown(1);
  EXPECT_THROW(pow(x, Power_polynomial::maximal_degree + 1), Invalid_input);
  EXPECT_NO_THROW(pow(x, Power_polynomial::maximal_degree));
  EXPECT_THROW(pow(x, std::numeric_limits<int>::max()), Invalid_input);
  EXPECT_THROW(pow(x, Power_polynomial::maximal_degree) * y, Invalid_input);
  EXPECT_THROW(pow(Power_polynomial(2), std::numeric_limits<int>::max()), Invalid_input);
  EXPECT_EQ(pow(Power_polynomial(-1), std::numeric_limits<int>::max()), Power_polynomial(-1));
  EXPECT_THROW(pow(x, -1), Invalid_input);
  EXPECT_THROW(x / y, Invalid_input);
  EXPECT_THROW(x / 0, Invalid_input);
  Power_polynomial sum(1);
  for (int v = 0; v < 40; ++v)
    sum += unknown(v);
  EXPECT_THROW(pow(sum, 200), Invalid_input);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

} // namespace

} // namespace Power_polynomial_test
