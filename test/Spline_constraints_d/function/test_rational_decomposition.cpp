// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Spline_constraints_d/function/rational_decomposition.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

namespace rational_decomposition_test {

using namespace CGAL::Spline_constraints;

namespace {

const Power_polynomial x = Power_polynomial::variable(0);

Polynomial_quotient quotient_of(const Power_polynomial& numerator, const Power_polynomial& denominator)
{
  return Polynomial_quotient(numerator, denominator);
}

Polynomial_quotient polynomial(const Power_polynomial& f) { return Polynomial_quotient(f); }

Polynomial_quotient chebyshev(int n)
{
  Power_polynomial previous(1), own = x;
  for (int k = 1; k < n; ++k)
    previous = std::exchange(own, 2 * x * own - previous);
  return polynomial(own);
}

// All of them, checked.
std::vector<Functional_decomposition> checked(const Polynomial_quotient& f)
{
  const std::vector<Functional_decomposition> result = decompositions(f);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const auto& [g, h] = result[i];
    EXPECT_EQ(composed(g, h), f);
    EXPECT_GT(g.degree(), 1);
    EXPECT_GT(h.degree(), 1);
    for (std::size_t j = 0; j < i; ++j) // not the same up to a fractional linear function
      EXPECT_FALSE(h.degree() == result[j].h.degree() && left_component(h, result[j].h));
  }
  return result;
}

// Whether one of them is equivalent to h.
bool has_right_component(const std::vector<Functional_decomposition>& found, const Polynomial_quotient& h)
{
  return std::any_of(found.begin(), found.end(), [&](const Functional_decomposition& one) {
    return one.h.degree() == h.degree() && left_component(h, one.h).has_value();
  });
}

std::vector<int> degrees_of_chain(const Polynomial_quotient& f)
{
  const std::vector<Polynomial_quotient> chain = decompose(f);
  Polynomial_quotient product = chain.back();
  for (std::size_t k = chain.size() - 1; k-- > 0;)
    product = composed(chain[k], product);
  EXPECT_EQ(product, f);
  std::vector<int> result;
  for (const Polynomial_quotient& one : chain)
    result.push_back(one.degree());
  return result;
}

class Decomposition_test : public testing::Test
{
protected:
  std::mt19937 m_random{91};

  int number(int least, int greatest) { return std::uniform_int_distribution<int>(least, greatest)(m_random); }

  Power_polynomial random_polynomial(int degree)
  {
    Power_polynomial result = Power_polynomial(number(1, 4)) * pow(x, degree);
    for (int k = 0; k < degree; ++k)
      result += Power_polynomial(number(-5, 5)) * pow(x, k);
    return result;
  }

  Polynomial_quotient random_function(int degree)
  {
    for (;;) {
      const int lower = number(1, degree);
      const Polynomial_quotient result = number(0, 1) == 0
          ? quotient_of(random_polynomial(degree), random_polynomial(lower))
          : quotient_of(random_polynomial(lower), random_polynomial(degree));
      if (result.degree() == degree)
        return result;
    }
  }
};

TEST(Polynomial_quotient, is_in_lowest_terms)
{
  const Polynomial_quotient f = quotient_of((x - 1) * (x + 2) / 3, (1 - x) * x / 2);
  EXPECT_EQ(f, quotient_of(-2 * x - 4, 3 * x));
  EXPECT_EQ(f.degree(), 1);
  EXPECT_EQ(f(Exact_rational(1)), Exact_rational(-2));
  EXPECT_FALSE(f(Exact_rational(0)).has_value());
  EXPECT_EQ(composed(quotient_of(x + 1, x), f), quotient_of(x - 4, -2 * x - 4));
  EXPECT_EQ(Polynomial_quotient(), quotient_of(Power_polynomial(), x));
  EXPECT_THROW(quotient_of(x, Power_polynomial()), Invalid_input);
  EXPECT_THROW(quotient_of(x, Power_polynomial::variable(1)), Invalid_input);
  EXPECT_THROW(polynomial(x + Power_polynomial::variable(1)), Invalid_input);
}

// The example of Zippel's report, with the sign that is lost in print.
TEST(Rational_decomposition, of_the_published_example)
{
  const Polynomial_quotient g = quotient_of(x * x + 1, x * x - 2), h = quotient_of(x * x + 1, x * x + 2),
                            f = composed(g, h);
  EXPECT_EQ(f, quotient_of(-(2 * pow(x, 4) + 6 * x * x + 5), pow(x, 4) + 6 * x * x + 7));
  const std::vector<Functional_decomposition> found = checked(f);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].h, polynomial(x * x));
  EXPECT_EQ(left_component(f, h), g);
  EXPECT_EQ(composed(quotient_of(2 * x * x + 6 * x + 5, -x * x - 6 * x - 7), quotient_of(-2 * x + 1, x - 1)), g);
  EXPECT_FALSE(left_component(f, quotient_of(x * x + x, x + 3)).has_value());
  EXPECT_FALSE(left_component(f, polynomial(x * x * x)).has_value());
}

// Formulas of the same report, as the manual has them.
TEST(Rational_decomposition, published_identities)
{
  const Power_polynomial z = Power_polynomial::variable(1), numerator = -(2 * pow(x, 4) + 6 * x * x + 5),
                         denominator = pow(x, 4) + 6 * x * x + 7;
  // (t + 2) z^2 + (6 t + 6) z + 7 t + 5 at the value t of the function
  EXPECT_EQ((numerator + 2 * denominator) * z * z + 6 * (numerator + denominator) * z + 7 * numerator + 5 * denominator,
            3 * (z - x * x) * ((2 * x * x + 3) * z + 3 * x * x + 4));
  for (const int p : {2, 3, 5}) { // Dorey and Whaples, modulo p
    const Power_polynomial expanded =
                               pow(x, p * p * (p + 1)) - pow(x, p * p * p + 1) - pow(x, p * p + p) + pow(x, p + 1),
                           inner = pow(x, p) - x, middle = pow(inner, p) + inner;
    EXPECT_EQ(composed(polynomial(pow(x, p * p) - pow(x, p * p - p + 1) - pow(x, p) + x), polynomial(pow(x, p + 1))),
              polynomial(expanded));
    const Power_polynomial difference = (pow(middle, p + 1) - expanded) / p;
    for (const auto& [monomial, coefficient] : difference.terms())
      EXPECT_EQ(internal::denominator_of(coefficient), 1);
  }
}

TEST(Rational_decomposition, of_powers_and_chebyshev_polynomials)
{
  for (const int n : {6, 8, 12, 30}) {
    std::size_t divisors = 0;
    for (int k = 2; k < n; ++k)
      divisors += n % k == 0 ? 1 : 0;
    EXPECT_EQ(checked(polynomial(pow(x, n))).size(), divisors);
    EXPECT_EQ(checked(chebyshev(n)).size(), divisors);
    // the same function without a pole at infinity alone
    const Polynomial_quotient outer = quotient_of(2 * x + 1, x - 3), inner = quotient_of(x + 2, 3 * x - 1);
    EXPECT_EQ(checked(composed(outer, composed(chebyshev(n), inner))).size(), divisors);
  }
  EXPECT_EQ(composed(chebyshev(2), chebyshev(3)), composed(chebyshev(3), chebyshev(2)));
  EXPECT_EQ(degrees_of_chain(chebyshev(12)), (std::vector<int>{3, 2, 2}));
  EXPECT_EQ(degrees_of_chain(polynomial(pow(x, 7))), std::vector<int>{7});
}

// Its components are the invariants of the groups between the trivial one and that of x^6 + x^-6, of order 12, that
// conjugation does not change: x^2, x^3, x^6, x +- 1/x, x^2 + 1/x^2, x^3 +- 1/x^3.
TEST(Rational_decomposition, of_an_invariant_of_a_dihedral_group)
{
  const std::vector<Functional_decomposition> found = checked(quotient_of(pow(x, 12) + 1, pow(x, 6)));
  EXPECT_EQ(found.size(), 8u);
  for (const int k : {2, 3, 6})
    EXPECT_TRUE(has_right_component(found, polynomial(pow(x, k))));
  for (const int k : {1, 3})
    for (const int sign : {1, -1})
      EXPECT_TRUE(has_right_component(found, quotient_of(pow(x, 2 * k) + sign, pow(x, k))));
  EXPECT_TRUE(has_right_component(found, quotient_of(pow(x, 4) + 1, x * x)));
}

TEST(Rational_decomposition, of_functions_without_any)
{
  EXPECT_TRUE(checked(quotient_of(pow(x, 5) + x + 1, pow(x, 3) + 2)).empty());
  EXPECT_TRUE(checked(quotient_of(pow(x, 6) + x + 1, pow(x, 3) + 2 * x + 3)).empty());
  EXPECT_TRUE(checked(polynomial(pow(x, 6) + x)).empty());
  EXPECT_TRUE(checked(quotient_of(x + 1, x)).empty());
  EXPECT_EQ(decompose(quotient_of(x + 1, x)).size(), 1u);
}

TEST_F(Decomposition_test, none_is_lost)
{
  for (int i = 0; i < 200; ++i) {
    const Polynomial_quotient g = random_function(number(2, 4)), h = random_function(number(2, 4)), f = composed(g, h);
    ASSERT_EQ(f.degree(), g.degree() * h.degree());
    EXPECT_TRUE(has_right_component(checked(f), h)) << f;
    EXPECT_EQ(left_component(f, h), g);
  }
}

TEST_F(Decomposition_test, none_is_lost_in_longer_chains)
{
  for (int i = 0; i < 30; ++i) {
    const Polynomial_quotient first = random_function(number(2, 3)), second = random_function(2),
                              third = random_function(number(2, 3)), inner = composed(second, third),
                              f = composed(first, inner);
    const std::vector<Functional_decomposition> found = checked(f);
    EXPECT_TRUE(has_right_component(found, third)) << f;
    EXPECT_TRUE(has_right_component(found, inner)) << f;
    EXPECT_GE(degrees_of_chain(f).size(), 3u);
  }
}

TEST_F(Decomposition_test, none_is_lost_of_polynomials)
{
  for (int i = 0; i < 200; ++i) {
    const Polynomial_quotient g = polynomial(random_polynomial(number(2, 6))),
                              h = polynomial(random_polynomial(number(2, 6)));
    EXPECT_TRUE(has_right_component(checked(composed(g, h)), h)) << g << ' ' << h;
  }
}

TEST_F(Decomposition_test, random_functions_have_none)
{
  for (int i = 0; i < 100; ++i)
    EXPECT_TRUE(checked(random_function(2 * number(2, 6))).empty());
}

TEST(Rational_decomposition, of_bad_input)
{
  EXPECT_THROW(decompositions(Polynomial_quotient()), Invalid_input);
  EXPECT_THROW(decompose(polynomial(Power_polynomial(3))), Invalid_input);
  EXPECT_THROW(left_component(polynomial(x), Polynomial_quotient()), Invalid_input);
  const auto stop = [] { throw std::runtime_error("stop"); };
  EXPECT_THROW(decompositions(quotient_of(pow(x, 40) + x + 3, pow(x, 39) + 7), stop), std::runtime_error);
}

} // namespace

} // namespace rational_decomposition_test
