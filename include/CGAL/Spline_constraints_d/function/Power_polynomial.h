// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_POWER_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_POWER_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <locale>
#include <map>
#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {

/*
How much work expansions may still cost, in units of about one small product of two terms. Exact arithmetic on data from
outside needs such a limit: `((x+y)^99)^99` is short to write.
*/
class Expansion_budget
{
  double m_left;

public:
  explicit Expansion_budget(double amount) : m_left(amount) {}

  void spend(double amount)
  {
    m_left -= amount;
    if (m_left < 0)
      throw Invalid_input("Power_polynomial: the expression takes too much work to expand");
  }
};

// The size of a coefficient in machine words, numerator and denominator together.
inline double size_in_words(const Exact_rational& value)
{
  return static_cast<double>(bit_length(numerator_of(value)) + bit_length(denominator_of(value))) / 64;
}

// The work of an operation on coefficients of these sizes (in words), as schoolbook arithmetic costs it.
inline double arithmetic_work(double words_a, double words_b) { return 1 + words_a * words_b / 64; }

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

A sparse polynomial in any number of unknowns, in power form, with exact rational coefficients.

Unknowns are non-negative integers: their indices in the system the polynomial belongs to. All arithmetic is exact.
Doubles convert implicitly and exactly: `Power_polynomial(0.1)` is the rational number that the double `0.1` is.

So that expressions from outside cannot exhaust memory or time, every operation throws `Invalid_input` rather than make
a polynomial with more than `maximal_number_of_terms` terms, a total degree above `maximal_degree`, or a coefficient
whose numerator or denominator has more than `maximal_coefficient_bits` bits, or when one expansion would take more than
about a minute.

Equality of polynomials is `==`; the formulas that make constraints are `Expression`s.
*/
class Power_polynomial
{
public:
  //! the terms: no coefficient is zero. The order is that of `Monomial`.
  using Terms = std::map<Monomial, Exact_rational>;

  //! most terms a polynomial may have.
  static constexpr std::size_t maximal_number_of_terms = std::size_t(1) << 20;

  //! largest total degree a polynomial may have.
  static constexpr int maximal_degree = 10000;

  //! most bits that the numerator, and the denominator, of a coefficient may have.
  static constexpr long maximal_coefficient_bits = 1L << 16;

private:
  Terms m_terms;

  static internal::Expansion_budget default_budget() { return internal::Expansion_budget(0x1p30); }

public:
  //! the zero polynomial.
  Power_polynomial() = default;

  //! a constant.
  //! \throws Invalid_input when the constant exceeds the limit on coefficients.
  Power_polynomial(const Exact_rational& constant)
  {
    internal::Expansion_budget budget = default_budget();
    add_term(Monomial(), constant, budget);
  }

  //! a constant, from anything else that converts to an exact rational, such as the expression `Exact_rational(1) / 3`.
  template <class T>
  requires(!std::is_arithmetic_v<T> && !std::same_as<T, Exact_rational> &&
           std::convertible_to<const T&, Exact_rational>) Power_polynomial(const T& constant)
    : Power_polynomial(Exact_rational(constant))
  {}

  //! a constant.
  template <std::integral T>
    requires (!std::same_as<T, bool>)
  Power_polynomial(T constant) : Power_polynomial(internal::scaled_rational(internal::Big_integer(constant), 0)) {}

  //! a constant, exactly.
  //! \throws Invalid_input when the constant is not a finite number.
  Power_polynomial(double constant)
  {
    if (!std::isfinite(constant))
      throw Invalid_input("Power_polynomial: a constant is not a finite number");
    if (constant != 0)
      m_terms.emplace(Monomial(), Exact_rational(constant));
  }

  // would be rounded
  Power_polynomial(long double) = delete;

  //! the unknown of the given index.
  //! \throws Invalid_input when the index is negative.
  static Power_polynomial variable(int index)
  {
    if (index < 0)
      throw Invalid_input("Power_polynomial: negative index " + std::to_string(index) + " of an unknown");
    Power_polynomial result;
    result.m_terms.emplace(Monomial{{{index, 1}}}, Exact_rational(1));
    return result;
  }

  //! the terms with their coefficients, none of them zero.
  const Terms& terms() const & { return m_terms; }
  Terms terms() && { return std::move(m_terms); }

  //! tells whether this is the zero polynomial.
  bool is_zero() const { return m_terms.empty(); }

  //! tells whether no unknown occurs.
  bool is_constant() const { return m_terms.empty() || (m_terms.size() == 1 && m_terms.begin()->first.powers.empty()); }

  //! the coefficient of the monomial 1; the value, when this is a constant.
  Exact_rational constant_term() const
  {
    const auto position = m_terms.find(Monomial());
    return position == m_terms.end() ? Exact_rational(0) : position->second;
  }

  //! the largest exponent of an unknown; 0 when it does not occur.
  int degree(int variable) const
  {
    int result = 0;
    for (const auto& [monomial, coefficient] : m_terms)
      result = (std::max)(result, monomial.exponent(variable));
    return result;
  }

  //! the largest total degree of a term; 0 for the zero polynomial.
  int total_degree() const
  {
    int result = 0;
    for (const auto& [monomial, coefficient] : m_terms)
      result = (std::max)(result, monomial.total_degree());
    return result;
  }

  //! the unknowns that occur, increasing.
  std::vector<int> variables() const
  {
    std::vector<int> result;
    for (const auto& [variable, degree] : degrees())
      result.push_back(variable);
    return result;
  }

  //! the largest exponent of every unknown that occurs.
  std::map<int, int> degrees() const
  {
    std::map<int, int> result;
    for (const auto& [monomial, coefficient] : m_terms)
      for (const auto& [variable, exponent] : monomial.powers) {
        int& largest = result[variable];
        largest = (std::max)(largest, exponent);
      }
    return result;
  }

  //! sum; costs time proportional to the shorter operand (times a logarithm) when the longer one is a temporary or the
  //! left one.
  Power_polynomial& operator+=(Power_polynomial other)
  {
    internal::Expansion_budget budget = default_budget();
    return add(std::move(other), budget);
  }

  //! difference.
  Power_polynomial& operator-=(Power_polynomial other)
  {
    internal::Expansion_budget budget = default_budget();
    other.negate(budget);
    return add(std::move(other), budget);
  }

  //! product, by integer arithmetic over common denominators: one integer multiplication and one hashed addition for
  //! each pair of terms.
  Power_polynomial& operator*=(const Power_polynomial& other)
  {
    internal::Expansion_budget budget = default_budget();
    *this = product(*this, other, budget);
    return *this;
  }

  //! division by a constant.
  //! \throws Invalid_input when the divisor is zero or not a constant.
  Power_polynomial& operator/=(const Power_polynomial& divisor)
  {
    internal::Expansion_budget budget = default_budget();
    return divide(divisor, budget);
  }

  friend Power_polynomial operator+(Power_polynomial a, Power_polynomial b) { return std::move(a += std::move(b)); }
  friend Power_polynomial operator-(Power_polynomial a, Power_polynomial b) { return std::move(a -= std::move(b)); }
  friend Power_polynomial operator*(Power_polynomial a, const Power_polynomial& b) { return std::move(a *= b); }
  friend Power_polynomial operator/(Power_polynomial a, const Power_polynomial& b) { return std::move(a /= b); }
  friend Power_polynomial operator+(Power_polynomial a) { return a; }
  friend Power_polynomial operator-(Power_polynomial a)
  {
    internal::Expansion_budget budget = default_budget();
    a.negate(budget);
    return a;
  }

  //! equality of polynomials.
  friend bool operator==(const Power_polynomial& a, const Power_polynomial& b) { return a.m_terms == b.m_terms; }

  //! power by repeated squaring; the power zero of anything is one.
  //! \throws Invalid_input when the exponent is negative.
  friend Power_polynomial pow(const Power_polynomial& base, int exponent)
  {
    internal::Expansion_budget budget = default_budget();
    return power(base, exponent, budget);
  }

  //! the derivative with respect to an unknown.
  Power_polynomial derivative(int variable) const;

  //! the exact value at a point, whose coordinates are indexed by unknown.
  //! \throws Invalid_input when the point has too few coordinates.
  Exact_rational operator()(std::span<const Exact_rational> point) const { return value(point); }

#ifndef DOXYGEN_RUNNING
  // The same with the numbers of a ring that rationals convert to.
  template <class NT>
  NT value(std::span<const NT> point) const;
#endif

  //! the polynomial with an unknown replaced by a polynomial.
  Power_polynomial substituted(int variable, const Power_polynomial& replacement) const;

  //! the formula with the given names of the unknowns, for example `-1/2 + 3*x^2*y - y`; it can be read back exactly.
  //! \throws Invalid_input when there are too few names.
  std::string to_string(std::span<const std::string> names) const;

  //! the formula with the names `x0`, `x1`, ...
  std::string to_string() const
  {
    std::vector<std::string> names;
    for (int v = 0, end = m_terms.empty() ? 0 : 1 + largest_variable(); v < end; ++v)
      names.push_back(std::string("x").append(std::to_string(v)));   // g++ 12 warns of "x" + string
    return to_string(names);
  }

  //! writes `p.to_string()`.
  friend std::ostream& operator<<(std::ostream& out, const Power_polynomial& p) { return out << p.to_string(); }

#ifndef DOXYGEN_RUNNING
  // The same operations at the cost of a budget that the caller keeps over many of them.
  Power_polynomial& add(Power_polynomial other, internal::Expansion_budget& budget);
  void negate(internal::Expansion_budget& budget);
  Power_polynomial& divide(const Power_polynomial& divisor, internal::Expansion_budget& budget);
  static Power_polynomial product(const Power_polynomial& a, const Power_polynomial& b,
                                  internal::Expansion_budget& budget);
  static Power_polynomial power(const Power_polynomial& base, int exponent, internal::Expansion_budget& budget);
#endif

private:
  void add_term(const Monomial& monomial, const Exact_rational& coefficient, internal::Expansion_budget& budget);
  Power_polynomial times_term(const Monomial& monomial, const Exact_rational& coefficient,
                              internal::Expansion_budget& budget) const;

  int largest_variable() const
  {
    int result = -1;
    for (const auto& [monomial, coefficient] : m_terms)
      if (!monomial.powers.empty())
        result = (std::max)(result, monomial.powers.back().first);
    return result;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#include <CGAL/Spline_constraints_d/function/internal/Power_polynomial_impl.h>

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_POWER_POLYNOMIAL_H
