// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_POWER_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_POWER_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/function/Monomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Expansion_budget.h>
#include <CGAL/Spline_constraints_d/function/internal/Polynomial_terms.h>
#include <CGAL/Spline_constraints_d/function/internal/expansion_limits.h>
#include <CGAL/Spline_constraints_d/function/internal/product_of_polynomials.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

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
  using Terms = internal::Polynomial_terms;

  //! most terms a polynomial may have.
  static constexpr std::size_t maximal_number_of_terms = internal::maximal_number_of_terms;

  //! largest total degree a polynomial may have.
  static constexpr int maximal_degree = internal::maximal_degree;

  //! most bits that the numerator, and the denominator, of a coefficient may have.
  static constexpr long maximal_coefficient_bits = internal::maximal_coefficient_bits;

private:
  Terms m_terms;

  static internal::Expansion_budget default_budget() { return internal::Expansion_budget(0x1p30); }

public:
  //! the zero polynomial.
  Power_polynomial() = default;

  //! a constant.
  //! \throws Invalid_input when the constant exceeds the limit on coefficients.
  Power_polynomial(const Exact_rational& constant);

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
  Power_polynomial(double constant);

  // would be rounded
  Power_polynomial(long double) = delete;

  //! the unknown of the given index.
  //! \throws Invalid_input when the index is negative.
  static Power_polynomial variable(int index);

  //! the terms with their coefficients, none of them zero.
  const Terms& terms() const & { return m_terms; }
  Terms terms() && { return std::move(m_terms); }

  //! tells whether this is the zero polynomial.
  bool is_zero() const { return m_terms.empty(); }

  //! tells whether no unknown occurs.
  bool is_constant() const { return m_terms.empty() || (m_terms.size() == 1 && m_terms.begin()->first.powers.empty()); }

  //! the coefficient of the monomial 1; the value, when this is a constant.
  Exact_rational constant_term() const;

  //! the largest exponent of an unknown; 0 when it does not occur.
  int degree(int variable) const;

  //! the largest total degree of a term; 0 for the zero polynomial.
  int total_degree() const;

  //! the unknowns that occur, increasing.
  std::vector<int> variables() const;

  //! the largest exponent of every unknown that occurs.
  std::map<int, int> degrees() const { return internal::degrees_of(m_terms); }

  //! sum; costs time proportional to the shorter operand (times a logarithm) when the longer one is a temporary or the
  //! left one.
  Power_polynomial& operator+=(Power_polynomial other);

  //! difference.
  Power_polynomial& operator-=(Power_polynomial other);

  //! product, by integer arithmetic over common denominators: one integer multiplication and one hashed addition for
  //! each pair of terms.
  Power_polynomial& operator*=(const Power_polynomial& other);

  //! division by a constant.
  //! \throws Invalid_input when the divisor is zero or not a constant.
  Power_polynomial& operator/=(const Power_polynomial& divisor);

  friend Power_polynomial operator+(Power_polynomial a, Power_polynomial b) { return std::move(a += std::move(b)); }
  friend Power_polynomial operator-(Power_polynomial a, Power_polynomial b) { return std::move(a -= std::move(b)); }
  friend Power_polynomial operator*(Power_polynomial a, const Power_polynomial& b) { return std::move(a *= b); }
  friend Power_polynomial operator/(Power_polynomial a, const Power_polynomial& b) { return std::move(a /= b); }
  friend Power_polynomial operator+(Power_polynomial a) { return a; }
  friend Power_polynomial operator-(Power_polynomial a);

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
  NT value(std::span<const NT> point) const
  {
    return internal::value_of(m_terms, point);
  }
#endif

  //! the polynomial with an unknown replaced by a polynomial.
  Power_polynomial substituted(int variable, const Power_polynomial& replacement) const;

  //! the formula with the given names of the unknowns, for example `-1/2 + 3*x^2*y - y`; it can be read back exactly.
  //! \throws Invalid_input when there are too few names.
  std::string to_string(std::span<const std::string> names) const { return internal::formula_of(m_terms, names); }

  //! the formula with the names `x0`, `x1`, ...
  std::string to_string() const;

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
};

#ifndef DOXYGEN_RUNNING

#endif // DOXYGEN_RUNNING

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial::Power_polynomial(const Exact_rational& constant)
{
  internal::Expansion_budget budget = default_budget();
  add_term(Monomial(), constant, budget);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial::Power_polynomial(double constant)
{
  if (!std::isfinite(constant))
    throw Invalid_input("Power_polynomial: a constant is not a finite number");
  if (constant != 0)
    m_terms.emplace(Monomial(), Exact_rational(constant));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Power_polynomial::variable(int index)
{
  if (index < 0)
    throw Invalid_input("Power_polynomial: negative index " + std::to_string(index) + " of an unknown");
  Power_polynomial result;
  result.m_terms.emplace(Monomial{{{index, 1}}}, Exact_rational(1));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational Power_polynomial::constant_term() const
{
  const auto position = m_terms.find(Monomial());
  return position == m_terms.end() ? Exact_rational(0) : position->second;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Power_polynomial::degree(int variable) const
{
  int result = 0;
  for (const auto& [monomial, coefficient] : m_terms)
    result = (std::max)(result, monomial.exponent(variable));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE int Power_polynomial::total_degree() const
{
  int result = 0;
  for (const auto& [monomial, coefficient] : m_terms)
    result = (std::max)(result, monomial.total_degree());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<int> Power_polynomial::variables() const
{
  std::vector<int> result;
  for (const auto& [variable, degree] : degrees())
    result.push_back(variable);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial& Power_polynomial::operator+=(Power_polynomial other)
{
  internal::Expansion_budget budget = default_budget();
  return add(std::move(other), budget);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial& Power_polynomial::operator-=(Power_polynomial other)
{
  internal::Expansion_budget budget = default_budget();
  other.negate(budget);
  return add(std::move(other), budget);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial& Power_polynomial::operator*=(const Power_polynomial& other)
{
  internal::Expansion_budget budget = default_budget();
  *this = product(*this, other, budget);
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial& Power_polynomial::operator/=(const Power_polynomial& divisor)
{
  internal::Expansion_budget budget = default_budget();
  return divide(divisor, budget);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial operator-(Power_polynomial a)
{
  internal::Expansion_budget budget = Power_polynomial::default_budget();
  a.negate(budget);
  return a;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::string Power_polynomial::to_string() const
{
  std::vector<std::string> names;
  for (int v = 0, end = m_terms.empty() ? 0 : 1 + internal::largest_variable(m_terms); v < end; ++v)
    names.push_back(std::string("x").append(std::to_string(v))); // g++ 12 warns of "x" + string
  return to_string(names);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Power_polynomial::add_term(const Monomial& monomial,
                                                               const Exact_rational& coefficient,
                                                               internal::Expansion_budget& budget)
{
  if (CGAL::is_zero(coefficient))
    return;
  const auto [position, is_new] = m_terms.try_emplace(monomial, coefficient);
  if (!is_new) {
    position->second += coefficient;
    if (CGAL::is_zero(position->second)) {
      m_terms.erase(position);
      budget.spend(1);
      return;
    }
  }
  const double words = internal::size_in_words(position->second);
  // 4: the tree's node
  budget.spend(4 + internal::arithmetic_work(words, words) + static_cast<double>(monomial.powers.size()) / 2);
  if (words > maximal_coefficient_bits / 64)
    internal::check_coefficient(position->second);
  internal::check_number_of_terms(m_terms.size());
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial& Power_polynomial::add(Power_polynomial other,
                                                                       internal::Expansion_budget& budget)
{
  if (m_terms.size() < other.m_terms.size())
    m_terms.swap(other.m_terms);
  for (const auto& [monomial, coefficient] : other.m_terms)
    add_term(monomial, coefficient, budget);
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Power_polynomial::negate(internal::Expansion_budget& budget)
{
  budget.spend(static_cast<double>(m_terms.size()));
  for (auto& [monomial, coefficient] : m_terms)
    coefficient = -coefficient;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial& Power_polynomial::divide(const Power_polynomial& divisor,
                                                                          internal::Expansion_budget& budget)
{
  if (!divisor.is_constant())
    throw Invalid_input("Power_polynomial: division by a polynomial that is not a constant");
  if (divisor.is_zero())
    throw Invalid_input("Power_polynomial: division by zero");
  *this = times_term(Monomial(), Exact_rational(Exact_rational(1) / divisor.constant_term()), budget);
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Power_polynomial::times_term(const Monomial& monomial,
                                                                             const Exact_rational& coefficient,
                                                                             internal::Expansion_budget& budget) const
{
  const long long degree = monomial.total_degree();
  const double words = internal::size_in_words(coefficient);
  Power_polynomial result;
  for (const auto& [own_monomial, own_coefficient] : m_terms) {
    internal::check_degree(degree + own_monomial.total_degree());
    budget.spend(internal::arithmetic_work(words, internal::size_in_words(own_coefficient)));
    result.add_term(own_monomial * monomial, Exact_rational(own_coefficient * coefficient), budget);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Power_polynomial::product(const Power_polynomial& a,
                                                                          const Power_polynomial& b,
                                                                          internal::Expansion_budget& budget)
{
  if (a.is_zero() || b.is_zero())
    return Power_polynomial();
  if (a.m_terms.size() == 1)
    return b.times_term(a.m_terms.begin()->first, a.m_terms.begin()->second, budget);
  if (b.m_terms.size() == 1)
    return a.times_term(b.m_terms.begin()->first, b.m_terms.begin()->second, budget);
  internal::check_degree(static_cast<long long>(a.total_degree()) + b.total_degree());
  Power_polynomial result;
  internal::visit_product(a.m_terms, b.m_terms, budget,
                          [&](const Monomial& monomial, const Exact_rational& coefficient) {
                            result.add_term(monomial, coefficient, budget);
                          });
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Power_polynomial::power(const Power_polynomial& base, int exponent,
                                                                        internal::Expansion_budget& budget)
{
  if (exponent < 0)
    throw Invalid_input("Power_polynomial: negative exponent " + std::to_string(exponent));
  if (exponent == 0)
    return Power_polynomial(1);
  internal::check_degree(static_cast<long long>(base.total_degree()) * exponent);
  Power_polynomial result;
  if (base.m_terms.size() <= 1) {
    for (const auto& [monomial, coefficient] : base.m_terms) {
      Monomial raised = monomial;
      for (auto& power_of_unknown : raised.powers)
        power_of_unknown.second *= exponent;
      result.add_term(raised, internal::power_of_number(coefficient, exponent), budget);
    }
    return result;
  }
  bool has_result = false;
  for (Power_polynomial square = base;; square = product(square, square, budget)) {
    if (exponent & 1) {
      result = has_result ? product(result, square, budget) : square;
      has_result = true;
    }
    exponent >>= 1;
    if (exponent == 0)
      return result;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Power_polynomial::derivative(int variable) const
{
  internal::Expansion_budget budget = default_budget();
  Power_polynomial result;
  for (const auto& [monomial, coefficient] : m_terms)
    if (const int exponent = monomial.exponent(variable); exponent > 0)
      result.add_term(monomial.with_exponent(variable, exponent - 1),
                      Exact_rational(coefficient * Exact_rational(exponent)), budget);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial Power_polynomial::substituted(int variable,
                                                                              const Power_polynomial& replacement) const
{
  internal::Expansion_budget budget = default_budget();
  std::map<int, Power_polynomial> by_exponent;
  for (const auto& [monomial, coefficient] : m_terms)
    by_exponent[monomial.exponent(variable)].add_term(monomial.with_exponent(variable, 0), coefficient, budget);
  // Horner's scheme over the exponents that occur.
  Power_polynomial result;
  int exponent = by_exponent.empty() ? 0 : by_exponent.rbegin()->first;
  for (auto summand = by_exponent.rbegin(); summand != by_exponent.rend(); ++summand) {
    result = product(result, power(replacement, exponent - summand->first, budget), budget);
    result.add(std::move(summand->second), budget);
    exponent = summand->first;
  }
  return product(result, power(replacement, exponent, budget), budget);
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_POWER_POLYNOMIAL_H
