// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Symbol_table.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <concepts>
#include <memory>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {

Monomial least_common_multiple(const Monomial& a, const Monomial& b);

// \pre b divides a
Monomial quotient(const Monomial& a, const Monomial& b);

// The largest monomial that divides all terms; 1 for the zero polynomial.
Monomial monomial_content(const Power_polynomial& polynomial);

Power_polynomial polynomial_of(const Monomial& monomial);

// \pre the monomial divides all terms
Power_polynomial divided(const Power_polynomial& polynomial, const Monomial& monomial);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Monomial least_common_multiple(const Monomial& a, const Monomial& b)
{
  Monomial result = a;
  for (const auto& [symbol, exponent] : b.powers)
    result = result.with_exponent(symbol, (std::max)(exponent, result.exponent(symbol)));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Monomial quotient(const Monomial& a, const Monomial& b)
{
  Monomial result = a;
  for (const auto& [symbol, exponent] : b.powers)
    result = result.with_exponent(symbol, result.exponent(symbol) - exponent);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Monomial monomial_content(const Power_polynomial& polynomial)
{
  Monomial result;
  bool is_first = true;
  for (const auto& [monomial, coefficient] : polynomial.terms()) {
    if (is_first)
      result = monomial;
    is_first = false;
    Monomial common;
    for (const auto& [symbol, exponent] : result.powers)
      if (const int least = (std::min)(exponent, monomial.exponent(symbol)); least > 0)
        common.powers.emplace_back(symbol, least);
    result = std::move(common);
    if (result.powers.empty())
      break;
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial polynomial_of(const Monomial& monomial)
{
  Power_polynomial result(1);
  for (const auto& [symbol, exponent] : monomial.powers)
    result *= pow(Power_polynomial::variable(symbol), exponent);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial divided(const Power_polynomial& polynomial, const Monomial& monomial)
{
  if (monomial.powers.empty())
    return polynomial;
  Power_polynomial result;
  for (const auto& [own, coefficient] : polynomial.terms())
    result += Power_polynomial(coefficient) * polynomial_of(quotient(own, monomial));
  return result;
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

A formula in unknowns: what `+`, `-`, `*`, `/` and `pow` make of `Unknown`s, numbers, and coordinates of curves and
surfaces (`Spline_map`). Comparing two expressions makes a `Constraint`.

A formula is a quotient \f$n/d\f$. The numerator is a polynomial, expanded and exact, in the unknowns and in the splines
that occur in the formula: not in their coefficients, so that \f$x_1(u)\, y_2(v)\f$ is one term whatever the degrees
are. The denominator is a product of weights, which are proved to be positive, and of other divisors. Equal ones are
recognized, get a common denominator that holds them once, and cancel as in the field of rational functions: `x*x/x` is
`x`. Splines are multiplied out only in `Constraint::spline_function()`.

\throws Invalid_input from every operation on two expressions whose unknowns come from different calls of `unknowns()`;
and see `Power_polynomial`.
*/
class Expression
{
  Power_polynomial m_numerator;
  Monomial m_denominator;   // of symbols
  std::shared_ptr<internal::Symbol_table> m_symbols;

public:
  //! a constant: a built-in number or an `Exact_rational`, exactly.
  //! \throws Invalid_input when the value is not a finite number.
  template <class T>
    requires std::convertible_to<const T&, Power_polynomial> && (!std::derived_from<T, Power_polynomial>)
  Expression(const T& constant) : m_numerator(constant) {}

  //! a quotient in symbols that the package keeps in a table.
  Expression(Power_polynomial numerator, Monomial denominator, std::shared_ptr<internal::Symbol_table> symbols)
    : m_numerator(std::move(numerator)), m_denominator(std::move(denominator)), m_symbols(std::move(symbols))
  {
    cancel();
  }

#ifndef DOXYGEN_RUNNING
  const Power_polynomial& numerator() const { return m_numerator; }
  const Monomial& denominator() const { return m_denominator; }
  const std::shared_ptr<internal::Symbol_table>& symbols() const { return m_symbols; }
#endif

  //! tells whether the formula is a polynomial in unknowns: no spline occurs, and nothing but constants is divided by.
  bool is_polynomial() const
  {
    return m_denominator.powers.empty() && (m_symbols == nullptr || m_symbols->has_only_unknowns(m_numerator));
  }

  //! the expanded formula.
  //! \throws Invalid_input when it is not a polynomial in the unknowns.
  const Power_polynomial& polynomial() const;

  //! the ranges of the unknowns that were made together with those in the formula; null when none occurs.
  std::shared_ptr<const Unknown_domains> domains() const
  {
    return m_symbols == nullptr ? nullptr : std::shared_ptr<const Unknown_domains>(m_symbols, &m_symbols->domains());
  }

  /*!
  the exact value at a point with one coordinate for each unknown that was made together with those in the formula.
  \throws Invalid_input when the point has a wrong number of coordinates, a divisor is zero there, or an unknown without
  a range occurs.
  */
  Exact_rational operator()(std::span<const Exact_rational> point) const;

  Expression& operator+=(const Expression& other) { return add(other, 1); }
  Expression& operator-=(const Expression& other) { return add(other, -1); }

  Expression& operator*=(const Expression& other);

  //! division. A divisor that may vanish becomes a condition of the constraints that the formula occurs in.
  //! \throws Invalid_input when the divisor is zero.
  Expression& operator/=(const Expression& other);

  friend Expression operator+(Expression a, const Expression& b) { return std::move(a += b); }
  friend Expression operator-(Expression a, const Expression& b) { return std::move(a -= b); }
  friend Expression operator*(Expression a, const Expression& b) { return std::move(a *= b); }
  friend Expression operator/(Expression a, const Expression& b) { return std::move(a /= b); }
  friend Expression operator+(Expression a) { return a; }
  friend Expression operator-(Expression a)
  {
    a.m_numerator = -std::move(a.m_numerator);
    return a;
  }

  //! a power with a non-negative exponent.
  //! \throws Invalid_input when the exponent is negative.
  friend Expression pow(const Expression& base, int exponent);

  //! the square.
  friend Expression square(const Expression& a) { return pow(a, 2); }

  friend Constraint operator==(Expression a, const Expression& b) { return compare(std::move(a), Relation::EQUAL, b); }
  friend Constraint operator<(Expression a, const Expression& b) { return compare(std::move(a), Relation::LESS, b); }
  friend Constraint operator<=(Expression a, const Expression& b)
  {
    return compare(std::move(a), Relation::LESS_EQUAL, b);
  }
  friend Constraint operator>=(Expression a, const Expression& b)
  {
    return compare(std::move(a), Relation::GREATER_EQUAL, b);
  }
  friend Constraint operator>(Expression a, const Expression& b) { return compare(std::move(a), Relation::GREATER, b); }
  friend Constraint operator!=(Expression a, const Expression& b)
  {
    return compare(std::move(a), Relation::NOT_EQUAL, b);
  }

  //! writes the formula: unknowns as `x0`, `x1`, ..., splines as `s5(x0)`, divisors as `f6`.
  friend std::ostream& operator<<(std::ostream& out, const Expression& a);

private:
  void join(const Expression& other) { m_symbols = internal::common_symbols(m_symbols, other.m_symbols); }

  Expression& add(const Expression& other, int sign);

  // Removes what the denominator and all terms of the numerator have in common.
  void cancel();

  // The numerator as a constant times a product of symbols. What is no such product becomes a symbol, divided by its
  // leading coefficient so that multiples become the same one.
  std::pair<Exact_rational, Monomial> numerator_as_divisor() const;

  /*
  The divisors are multiplied out. Of those with a sign, this counts in an inequality; those that may vanish are
  conditions, and count in an inequality as often as their exponent is odd. Weights that all terms have in common are
  left out: they are positive.
  */
  static Constraint compare(Expression a, Relation relation, const Expression& b);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE const Power_polynomial& Expression::polynomial() const
{
  if (!is_polynomial())
    throw Invalid_input("Expression: the formula is not a polynomial in the unknowns");
  return m_numerator;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational Expression::operator()(std::span<const Exact_rational> point) const
{
  if (m_symbols == nullptr)
    return m_numerator.constant_term();
  const Exact_rational below = m_symbols->value(internal::polynomial_of(m_denominator), point);
  if (below == Exact_rational(0))
    throw Invalid_input("Expression: a divisor is zero at the point of evaluation");
  return m_symbols->value(m_numerator, point) / below;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression& Expression::operator*=(const Expression& other)
{
  join(other);
  m_numerator *= other.m_numerator;
  m_denominator = m_denominator * other.m_denominator;
  cancel();
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression& Expression::operator/=(const Expression& other)
{
  join(other);
  if (other.m_numerator.is_constant()) {
    m_numerator /= other.m_numerator;
    m_numerator *= internal::polynomial_of(other.m_denominator);
  } else {
    const auto [constant, divisor] = other.numerator_as_divisor();
    m_numerator *= internal::polynomial_of(other.m_denominator) / Power_polynomial(constant);
    m_denominator = m_denominator * divisor;
  }
  cancel();
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression pow(const Expression& base, int exponent)
{
  Expression result(base);
  result.m_numerator = pow(base.m_numerator, exponent);
  for (auto& power : result.m_denominator.powers)
    power.second *= exponent;
  if (exponent == 0)
    result.m_denominator = Monomial();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, const Expression& a)
{
  if (a.m_symbols == nullptr)
    return out << a.m_numerator;
  const std::vector<std::string> names = internal::symbol_names(*a.m_symbols);
  if (a.m_denominator.powers.empty())
    return out << a.m_numerator.to_string(names);
  return out << '(' << a.m_numerator.to_string(names) << ") / ("
             << internal::polynomial_of(a.m_denominator).to_string(names) << ')';
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression& Expression::add(const Expression& other, int sign)
{
  join(other);
  const Monomial common = m_denominator == other.m_denominator
      ? m_denominator
      : internal::least_common_multiple(m_denominator, other.m_denominator);
  if (common != m_denominator)
    m_numerator *= internal::polynomial_of(internal::quotient(common, m_denominator));
  Power_polynomial summand = common == other.m_denominator
      ? other.m_numerator
      : other.m_numerator * internal::polynomial_of(internal::quotient(common, other.m_denominator));
  if (sign > 0)
    m_numerator += std::move(summand);
  else
    m_numerator -= std::move(summand);
  m_denominator = common;
  cancel();
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Expression::cancel()
{
  if (m_numerator.is_zero())
    m_denominator = Monomial();
  if (m_denominator.powers.empty())
    return;
  const Monomial content = internal::monomial_content(m_numerator);
  Monomial common;
  for (const auto& [symbol, exponent] : m_denominator.powers)
    if (const int least = (std::min)(exponent, content.exponent(symbol)); least > 0)
      common.powers.emplace_back(symbol, least);
  m_numerator = internal::divided(m_numerator, common);
  m_denominator = internal::quotient(m_denominator, common);
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<Exact_rational, Monomial> Expression::numerator_as_divisor() const
{
  Monomial product = internal::monomial_content(m_numerator);
  Power_polynomial rest = internal::divided(m_numerator, product);
  const Exact_rational leading = rest.terms().rbegin()->second;
  if (!rest.is_constant()) {
    rest /= Power_polynomial(leading);
    product = product * Monomial{{{m_symbols->enter_formula(rest), 1}}};
  }
  return {leading, product};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Constraint Expression::compare(Expression a, Relation relation, const Expression& b)
{
  a -= b;
  Constraint result{std::move(a.m_numerator), relation, a.domains(), {}, a.m_symbols};
  if (a.m_symbols == nullptr)
    return result;
  const internal::Symbol_table& symbols = *a.m_symbols;
  const bool is_inequality = relation != Relation::EQUAL && relation != Relation::NOT_EQUAL;
  for (const auto& [index, exponent] : a.m_denominator.powers) {
    const internal::Symbol& symbol = symbols[index];
    if (symbol.sign == 0)
      result.conditions.push_back(symbols.without_formulas(Power_polynomial::variable(index)));
    if (is_inequality && exponent % 2 != 0 && symbol.sign <= 0)
      result.function *= symbol.sign < 0 ? Power_polynomial(-1) : Power_polynomial::variable(index);
  }
  if (!symbols.has_only_unknowns(result.function)) {
    Monomial weights;
    for (const auto& power : internal::monomial_content(result.function).powers)
      if (!symbols.is_unknown(power.first) && symbols[power.first].sign > 0)
        weights.powers.push_back(power);
    result.function = internal::divided(result.function, weights);
  }
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_H
