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

  // By the chain rule.
  Power_polynomial of_polynomial(const Power_polynomial& polynomial) const
  {
    Power_polynomial result;
    for (int symbol : polynomial.variables())
      if (const Power_polynomial inner = of_symbol(symbol); !inner.is_zero())
        result += polynomial.derivative(symbol) * inner;
    return result;
  }

  Power_polynomial of_symbol(int index) const
  {
    const Symbol& symbol = (*m_symbols)[index];
    switch (symbol.kind) {
    case Symbol::Kind::FORMULA: return of_polynomial(symbol.formula);
    case Symbol::Kind::SPLINE: return of_spline(symbol);
    case Symbol::Kind::UNKNOWN:
    case Symbol::Kind::WITHOUT_RANGE: break;
    }
    return index == m_unknown ? 1 : 0;
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
};

} // namespace internal

/*!
\addtogroup PkgSplineConstraintsDFunctions
@{
*/

/*!
the partial derivative of a formula by an unknown.

The splines in the formula are differentiated one by one, so all of their derivatives have to be continuous; for a point
of a rational curve `derivative(map)` asks for less.
\throws Invalid_input when the derivative of a spline jumps (the message names the parameter), or the unknown comes from
another call of `unknowns()`.
*/
inline Expression derivative(const Expression& formula, const Unknown& u)
{
  const auto& symbols = internal::common_symbols(formula.symbols(), u.symbols());
  const internal::Derivation derivation(symbols, u.index());
  const auto polynomial = [&](const Power_polynomial& p) { return Expression(p, Monomial(), symbols); };
  // (n/d)' = (n' - n sum_i e_i f_i'/f_i) / d for d = prod_i f_i^(e_i)
  Expression result = polynomial(derivation.of_polynomial(formula.numerator()));
  for (const auto& [factor, exponent] : formula.denominator().powers)
    if (const Power_polynomial inner = derivation.of_symbol(factor); !inner.is_zero())
      result -= polynomial(formula.numerator() * inner) * exponent / polynomial(Power_polynomial::variable(factor));
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
