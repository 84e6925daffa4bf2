// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/function/rational_factors.h>

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <stdexcept>
#include <string>

namespace rational_factors_test {

using namespace CGAL::Spline_constraints;

namespace {

const Power_polynomial x = Power_polynomial::variable(0);

Power_polynomial product_of_factors(const Rational_factors& factors)
{
  Power_polynomial result(factors.constant);
  for (const auto& [polynomial, multiplicity] : factors.factors)
    result *= pow(polynomial, multiplicity);
  return result;
}

// Each factor as a formula, with its exponent.
std::map<std::string, int> by_formula(const Rational_factors& factors)
{
  std::map<std::string, int> result;
  for (const auto& [polynomial, multiplicity] : factors.factors)
    EXPECT_TRUE(result.emplace(polynomial.to_string(), multiplicity).second);
  return result;
}

std::size_t checked_count(const Power_polynomial& f)
{
  const Rational_factors factors = rational_factors(f);
  EXPECT_EQ(product_of_factors(factors), f);
  return factors.factors.size();
}

class Rational_factors_test : public testing::Test
{
protected:
  std::mt19937 m_random{55};

  int number(int least, int greatest) { return std::uniform_int_distribution<int>(least, greatest)(m_random); }

  // Irreducible by the criterion of Eisenstein, in the unknown or shifted; primitive.
  Power_polynomial irreducible()
  {
    const int prime = number(0, 1) == 0 ? 2 : 3, degree = number(1, 6), shift = number(-3, 3);
    const auto unit = [&] { return prime * number(-3, 3) + 1; };
    Power_polynomial result(prime * unit());
    for (int k = 1; k < degree; ++k)
      result += Power_polynomial(prime * number(-5, 5)) * pow(x, k);
    result = (result + pow(x, degree)).substituted(0, x + Power_polynomial(shift));
    return result;
  }
};

TEST(Rational_factors, of_known_polynomials)
{
  EXPECT_EQ(by_formula(rational_factors(pow(x, 4) + 4)),
            (std::map<std::string, int>{{(x * x + 2 * x + 2).to_string(), 1}, {(x * x - 2 * x + 2).to_string(), 1}}));
  EXPECT_EQ(checked_count(pow(x, 4) + 1), 1u);   // reducible modulo all primes
  EXPECT_EQ(checked_count(pow(x, 105) - 1), 8u); // cyclotomic ones
  EXPECT_EQ(checked_count(pow(x, 24) - 1), 8u);
  EXPECT_EQ(checked_count(pow(x, 12) - pow(x, 6) + 1), 1u);
  EXPECT_EQ(checked_count(pow(x, 7)), 1u);
  const Power_polynomial f = Power_polynomial(Exact_rational(-3) / 7) * pow(2 * x - 1, 3) * pow(x * x + 1, 2) * x;
  const Rational_factors factors = rational_factors(f);
  EXPECT_EQ(factors.constant, Exact_rational(-3) / 7);
  EXPECT_EQ(
      by_formula(factors),
      (std::map<std::string, int>{{(2 * x - 1).to_string(), 3}, {(x * x + 1).to_string(), 2}, {x.to_string(), 1}}));
  // another unknown, a constant
  const Power_polynomial y = Power_polynomial::variable(3);
  EXPECT_EQ(rational_factors(y * y - 4).factors[0].polynomial, y - 2);
  EXPECT_TRUE(rational_factors(Power_polynomial(5)).factors.empty());
  EXPECT_EQ(rational_factors(Power_polynomial(5)).constant, 5);
}

// With the zeros +- sqrt 2 +- sqrt 3 +- sqrt 5 +- sqrt 7: irreducible, with eight factors or more modulo each prime.
TEST(Rational_factors, of_polynomials_of_Swinnerton_Dyer)
{
  Power_polynomial f = x;
  for (const int root : {2, 3, 5, 7}) {
    // f(x + r) f(x - r) with r^2 = root: r is the unknown 1
    const Power_polynomial r = Power_polynomial::variable(1);
    const Power_polynomial product = f.substituted(0, x + r) * f.substituted(0, x - r);
    f = Power_polynomial();
    for (const auto& [monomial, coefficient] : product.terms()) {
      ASSERT_EQ(monomial.exponent(1) % 2, 0);
      f += Power_polynomial(coefficient) * pow(Power_polynomial(root), monomial.exponent(1) / 2) *
          pow(x, monomial.exponent(0));
    }
    EXPECT_EQ(checked_count(f), 1u);
  }
  EXPECT_EQ(f.degree(0), 16);
  EXPECT_EQ(checked_count(f * f.substituted(0, x + 1)), 2u);
}

TEST_F(Rational_factors_test, none_is_lost_and_none_is_a_product)
{
  for (int i = 0; i < 300; ++i) {
    std::map<std::string, int> expected;
    Power_polynomial f(Exact_rational(number(1, 9)) / number(1, 9));
    for (int k = number(1, 5); k > 0; --k) {
      const Power_polynomial factor = irreducible();
      const int multiplicity = number(1, 3) == 3 ? 2 : 1;
      expected[factor.to_string()] += multiplicity;
      f *= pow(factor, multiplicity);
    }
    const Rational_factors factors = rational_factors(f);
    EXPECT_EQ(product_of_factors(factors), f);
    EXPECT_EQ(by_formula(factors), expected) << f;
  }
}

TEST_F(Rational_factors_test, of_long_coefficients)
{
  Power_polynomial f(1);
  for (int k = 0; k < 4; ++k)
    f *= pow(x, 5) * number(1, 1 << 30) + x * x * number(1, 1 << 30) + Power_polynomial(0x1p-70);
  EXPECT_GE(checked_count(f), 4u);
  EXPECT_EQ(checked_count(pow(x, 40) * Power_polynomial(Exact_rational("123456789012345678901234567890")) - 2), 1u);
}

TEST(Rational_factors, of_bad_input)
{
  EXPECT_THROW(rational_factors(Power_polynomial()), Invalid_input);
  EXPECT_THROW(rational_factors(x + Power_polynomial::variable(1)), Invalid_input);
}

TEST(Rational_factors, end_when_told_to)
{
  int calls = 0;
  const auto check = [&] {
    if (++calls == 3)
      throw std::runtime_error("stop");
  };
  EXPECT_THROW(rational_factors(pow(x, 105) - 1, check), std::runtime_error);
  EXPECT_EQ(calls, 3);
}

} // namespace

} // namespace rational_factors_test
