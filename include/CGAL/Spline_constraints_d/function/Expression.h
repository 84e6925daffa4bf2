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
#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/internal/Symbol_table.h>
#include <CGAL/Spline_constraints_d/function/internal/renumbered.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <concepts>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

A formula in unknowns: what `+`, `-`, `*`, `/`, `pow` and elementary functions make of `Unknown`s, numbers, and
coordinates of curves and surfaces (`Spline_map`). Comparing two expressions makes a `Constraint`.

A formula is a quotient \f$n/d\f$. The numerator is a polynomial, expanded and exact, in the unknowns and in the splines
that occur in the formula: not in their coefficients, so that \f$x_1(u)\, y_2(v)\f$ is one term whatever the degrees
are. The denominator is a product of weights, which are proved to be positive, and of other divisors. Equal ones are
recognized, get a common denominator that holds them once, and cancel as in the field of rational functions: `x*x/x` is
`x`. Splines are multiplied out only in `Constraint::spline_function()`.

`exp`, `log`, `sqrt`, `sin`, `cos`, `tan`, `asin`, `acos`, `atan`, `sinh`, `cosh`, `tanh`, `abs` and powers with
exponents that are no integers are defined as `Elementary_function` says; of numbers, too: `sqrt(Expression(3))` and
`Expression::pi()` are exact. Their values are symbols like splines: equal ones are one, and no law of the functions is
applied but what is rational, as `exp(Expression(0))`. A constraint holds only where all values that occur in it, and in
its divisors, are defined; what cancels, as in `log(x) - log(x)`, does not occur. Where only polynomials and splines are
possible, such formulas are refused.

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
    return m_symbols == nullptr || m_symbols->domains().empty()
        ? nullptr
        : std::shared_ptr<const Unknown_domains>(m_symbols, &m_symbols->domains());
  }

  /*!
  the exact value at a point with one coordinate for each unknown that was made together with those in the formula.
  \throws Invalid_input when the point has a wrong number of coordinates, a divisor is zero there, an unknown without
  a range occurs, or the value of an elementary function is not rational or not defined.
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

  //! a power; one with a negative exponent is divided by.
  //! \throws Invalid_input when a divisor is zero.
  friend Expression pow(const Expression& base, int exponent);

  //! a power with any constant exponent, see `Elementary_values::power()`.
  //! \throws Invalid_input when the exponent is not finite, or an integer that is too large, or the base is a number of
  //! which there is no such power.
  template <class T>
  requires std::convertible_to<const T&, Power_polynomial> &&
      (!std::derived_from<T, Power_polynomial>)&&(!std::integral<T>)friend Expression
      pow(const Expression& base, const T& exponent)
  {
    return power_of(base, Power_polynomial(exponent).constant_term());
  }

  //! \name Elementary functions
  //! \throws Invalid_input when the argument is a rational number for which the function is not defined.
  //! @{
  friend Expression exp(const Expression& x) { return function_of(Elementary_function::EXPONENTIAL, x); }
  friend Expression log(const Expression& x) { return function_of(Elementary_function::LOGARITHM, x); }
  friend Expression sqrt(const Expression& x) { return function_of(Elementary_function::SQUARE_ROOT, x); }
  friend Expression sin(const Expression& x) { return function_of(Elementary_function::SINE, x); }
  friend Expression cos(const Expression& x) { return function_of(Elementary_function::COSINE, x); }
  friend Expression tan(const Expression& x) { return function_of(Elementary_function::TANGENT, x); }
  friend Expression asin(const Expression& x) { return function_of(Elementary_function::ARC_SINE, x); }
  friend Expression acos(const Expression& x) { return function_of(Elementary_function::ARC_COSINE, x); }
  friend Expression atan(const Expression& x) { return function_of(Elementary_function::ARC_TANGENT, x); }
  friend Expression sinh(const Expression& x) { return function_of(Elementary_function::HYPERBOLIC_SINE, x); }
  friend Expression cosh(const Expression& x) { return function_of(Elementary_function::HYPERBOLIC_COSINE, x); }
  friend Expression tanh(const Expression& x) { return function_of(Elementary_function::HYPERBOLIC_TANGENT, x); }
  friend Expression abs(const Expression& x) { return function_of(Elementary_function::ABSOLUTE_VALUE, x); }
  //! @}

  //! the number \f$\pi\f$: four times `atan(1)`.
  static Expression pi() { return 4 * function_of(Elementary_function::ARC_TANGENT, Expression(1)); }

  //! a function of a formula; `POWER` and `RECIPROCAL` are written as `pow` and `/`.
  //! \param function which one.
  //! \param argument what it is taken of.
  //! \throws Invalid_input when it is one of these, or the argument a number for which it is not defined.
  static Expression function_of(Elementary_function function, const Expression& argument);

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

  //! writes the formula: unknowns as `x0`, `x1`, ..., splines as `s5(x0)`, divisors as `f6`, values of functions as
  //! `sin(x0)`, or as `v7` where that is long.
  friend std::ostream& operator<<(std::ostream& out, const Expression& a);

private:
  // Gives both formulas the same symbols: functions of numbers get those of the other one, which is returned then.
  std::optional<Expression> join(const Expression& other);

  Expression in_symbols(const std::shared_ptr<internal::Symbol_table>& symbols) const;

  // Without a test whether the function is one that is written so.
  static Expression value_of(Elementary_function function, const Exact_rational& exponent, const Expression& argument);

  static Expression power_of(const Expression& base, const Exact_rational& exponent);

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
  if (m_symbols->domains().empty())
    point = {};
  const Exact_rational below = m_symbols->value(internal::polynomial_of(m_denominator), point);
  if (below == Exact_rational(0))
    throw Invalid_input("Expression: a divisor is zero at the point of evaluation");
  return m_symbols->value(m_numerator, point) / below;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression& Expression::operator*=(const Expression& other)
{
  if (const auto translated = join(other))
    return *this *= *translated;
  m_numerator *= other.m_numerator;
  m_denominator = m_denominator * other.m_denominator;
  cancel();
  return *this;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression& Expression::operator/=(const Expression& other)
{
  if (const auto translated = join(other))
    return *this /= *translated;
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
  if (exponent < 0)
    return 1 / pow(base, -exponent);
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

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Expression> Expression::join(const Expression& other)
{
  const auto is_of_numbers = [](const Expression& a) {
    return a.m_symbols != nullptr && a.m_symbols->domains().empty();
  };
  if (m_symbols != nullptr && other.m_symbols != nullptr && m_symbols != other.m_symbols) {
    if (is_of_numbers(other))
      return other.in_symbols(m_symbols);
    if (is_of_numbers(*this))
      *this = in_symbols(other.m_symbols);
  }
  m_symbols = internal::common_symbols(m_symbols, other.m_symbols);
  return std::nullopt;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression
Expression::in_symbols(const std::shared_ptr<internal::Symbol_table>& symbols) const
{
  const Power_polynomial below = symbols->imported(internal::polynomial_of(m_denominator), *m_symbols);
  return Expression(symbols->imported(m_numerator, *m_symbols), below.terms().begin()->first, symbols);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression Expression::function_of(Elementary_function function,
                                                                  const Expression& argument)
{
  if (function == Elementary_function::RECIPROCAL || function == Elementary_function::POWER)
    throw Invalid_input("Expression: " + internal::in_words(function) + " is made by / or pow");
  return value_of(function, Exact_rational(), argument);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression Expression::value_of(Elementary_function function,
                                                               const Exact_rational& exponent, const Expression& x)
{
  if (x.m_numerator.is_constant() && x.m_denominator.powers.empty()) {
    const Exact_rational number = x.m_numerator.constant_term();
    if (!internal::is_defined_at(function, exponent, number))
      throw Invalid_input("Expression: " + internal::in_words(function) + " is not defined for " +
                          Power_polynomial(number).to_string());
    if (const auto known = internal::rational_value_of(function, exponent, number))
      return *known;
  }
  const auto symbols =
      x.m_symbols != nullptr ? x.m_symbols : std::make_shared<internal::Symbol_table>(Unknown_domains());
  const auto enter = [&](Elementary_function f, const Exact_rational& e, const Power_polynomial& argument) {
    return Power_polynomial::variable(symbols->enter_value(f, e, argument));
  };
  Power_polynomial argument = symbols->without_formulas(x.m_numerator);
  for (const auto& [divisor, multiplicity] : x.m_denominator.powers)
    argument *= pow(enter(Elementary_function::RECIPROCAL, Exact_rational(),
                          symbols->without_formulas(Power_polynomial::variable(divisor))),
                    multiplicity);
  return Expression(enter(function, exponent, argument), Monomial(), symbols);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression Expression::power_of(const Expression& base, const Exact_rational& exponent)
{
  const auto integer_power = [&](const Expression& root, const internal::Big_integer& times) {
    if (times < -Power_polynomial::maximal_degree || times > Power_polynomial::maximal_degree)
      throw Invalid_input("Expression: an exponent that is too large");
    return pow(root, static_cast<int>(times.convert_to<long>()));
  };
  const internal::Big_integer numerator = internal::numerator_of(exponent);
  const internal::Big_integer denominator = internal::denominator_of(exponent);
  if (denominator == 1)
    return integer_power(base, numerator);
  if (denominator == 2)
    return integer_power(function_of(Elementary_function::SQUARE_ROOT, base), numerator);
  return value_of(Elementary_function::POWER, exponent, base);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression& Expression::add(const Expression& other, int sign)
{
  if (const auto translated = join(other))
    return add(*translated, sign);
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
    // of values, also to ask that they are defined
    if (symbol.sign == 0 || symbols.has_values(Power_polynomial::variable(index)))
      result.conditions.push_back(symbols.without_formulas(Power_polynomial::variable(index)));
    if (is_inequality && exponent % 2 != 0 && symbol.sign <= 0)
      result.function *= symbol.sign < 0 ? Power_polynomial(-1) : Power_polynomial::variable(index);
  }
  if (!symbols.has_only_unknowns(result.function)) {
    Monomial weights;
    for (const auto& power : internal::monomial_content(result.function).powers)
      if (symbols[power.first].kind == internal::Symbol::Kind::SPLINE && symbols[power.first].sign > 0)
        weights.powers.push_back(power);
    result.function = internal::divided(result.function, weights);
  }
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_H
