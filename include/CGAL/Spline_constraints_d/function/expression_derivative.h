// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_DERIVATIVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_DERIVATIVE_H

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/function/internal/Symbol_table.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The derivatives of polynomials and of their symbols by one unknown.
class Derivation
{
  const std::shared_ptr<Symbol_table>& m_symbols;
  int m_unknown;

public:
  Derivation(const std::shared_ptr<Symbol_table>& symbols, int unknown) : m_symbols(symbols), m_unknown(unknown) {}

  Expression formula_of(const Power_polynomial& p) const { return Expression(p, Monomial(), m_symbols); }

  // By the chain rule.
  Expression of_polynomial(const Power_polynomial& polynomial) const
  {
    Expression result = formula_of(0);
    for (int symbol : polynomial.variables())
      if (const Expression inner = of_symbol(symbol); !inner.numerator().is_zero())
        result += formula_of(polynomial.derivative(symbol)) * inner;
    return result;
  }

  Expression of_symbol(int index) const
  {
    const Symbol& symbol = (*m_symbols)[index];
    switch (symbol.kind) {
    case Symbol::Kind::FORMULA: return of_polynomial(symbol.formula);
    case Symbol::Kind::SPLINE:
      return formula_of(of_spline(symbol));
    case Symbol::Kind::VALUE:
      return of_value(symbol, formula_of(Power_polynomial::variable(index)));
    case Symbol::Kind::UNKNOWN:
    case Symbol::Kind::WITHOUT_RANGE: break;
    }
    return formula_of(index == m_unknown ? 1 : 0);
  }

private:
  Power_polynomial of_spline(const Symbol& symbol) const
  {
    const auto position = std::find(symbol.unknowns.begin(), symbol.unknowns.end(), m_unknown);
    if (position == symbol.unknowns.end())
      return 0;
    const auto result = std::make_shared<const Integer_spline>(
        symbol.spline->piecewise_derivative(static_cast<int>(position - symbol.unknowns.begin())));
    result->check_continuity("derivative: that of a spline in the formula");
    return m_symbols->spline_of_unknowns(result, symbol.unknowns, 0);
  }

  Expression of_value(const Symbol& symbol, const Expression& value) const
  {
    const Expression inner = of_polynomial(symbol.formula);
    return inner.numerator().is_zero() ? inner : outer(symbol, formula_of(symbol.formula), value) * inner;
  }

  // The derivative of a function at x, where it has a value.
  static Expression outer(const Symbol& symbol, const Expression& x, const Expression& value)
  {
    switch (symbol.function) {
    case Elementary_function::RECIPROCAL:
      return -square(value);
    case Elementary_function::POWER:
      return symbol.exponent * value / x;
    case Elementary_function::SQUARE_ROOT:
      return 1 / (2 * value);
    case Elementary_function::EXPONENTIAL:
      return value;
    case Elementary_function::LOGARITHM:
      return 1 / x;
    case Elementary_function::SINE:
      return cos(x);
    case Elementary_function::COSINE:
      return -sin(x);
    case Elementary_function::TANGENT:
      return 1 + square(value);
    case Elementary_function::ARC_SINE:
      return 1 / sqrt(1 - square(x));
    case Elementary_function::ARC_COSINE:
      return -1 / sqrt(1 - square(x));
    case Elementary_function::ARC_TANGENT:
      return 1 / (1 + square(x));
    case Elementary_function::HYPERBOLIC_SINE:
      return cosh(x);
    case Elementary_function::HYPERBOLIC_COSINE:
      return sinh(x);
    case Elementary_function::HYPERBOLIC_TANGENT:
      return 1 - square(value);
    case Elementary_function::ABSOLUTE_VALUE:
      return value / x;
    }
    return value;
  }
};

} // namespace internal

/*!
\addtogroup PkgSplineConstraintsDFunctions
@{
*/

/*!
the partial derivative of a formula by an unknown.

The splines in the formula are differentiated one by one, so all of their derivatives have to be continuous; for a point
of a rational curve `derivative(map)` asks for less. Those of \f$|x|\f$ and \f$x^r\f$ are \f$|x|/x\f$ and
\f$r x^r/x\f$, which are not defined at zero.
\throws Invalid_input when the derivative of a spline jumps (the message names the parameter), or the unknown comes from
another call of `unknowns()`.
*/
inline Expression derivative(const Expression& f, const Unknown& u)
{
  const Expression formula = f + (u - u); // functions of numbers get the symbols of the unknown
  const auto& symbols = formula.symbols();
  const internal::Derivation derivation(symbols, u.index());
  // (n/d)' = (n' - n sum_i e_i f_i'/f_i) / d for d = prod_i f_i^(e_i)
  Expression result = derivation.of_polynomial(formula.numerator());
  for (const auto& [factor, exponent] : formula.denominator().powers)
    if (const Expression inner = derivation.of_symbol(factor); !inner.numerator().is_zero())
      result -= derivation.formula_of(formula.numerator()) * inner * exponent /
          derivation.formula_of(Power_polynomial::variable(factor));
  return result * Expression(1, formula.denominator(), symbols);
}

//! the partial derivatives of the coordinates. \throws Invalid_input in the same way.
template <int d>
Vector_expression<d> derivative(const Vector_expression<d>& vector, const Unknown& u)
{
  return internal::vector_of<d>([&](std::size_t i) { return derivative(vector[i], u); });
}

/*!
@}
*/

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXPRESSION_DERIVATIVE_H
