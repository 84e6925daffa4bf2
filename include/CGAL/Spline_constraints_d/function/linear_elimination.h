// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_LINEAR_ELIMINATION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_LINEAR_ELIMINATION_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/function/exact_division.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDFunctions

The points \f$p\f$ with \f$\langle normal, p\rangle = offset\f$: a line in the plane, a plane in space.
*/
template <int dimension>
struct Hyperplane_expression
{
  Vector_expression<dimension> normal;
  Expression offset;
};

/*!
\addtogroup PkgSplineConstraintsDFunctions
@{
*/

//! the line through a point of a curve with the direction of its normal, \f$\langle p - C(u), C'(u)\rangle = 0\f$ (seed
//! 001, equation 18); in space, the normal plane.
//! \throws Invalid_input as `derivative()`.
template <int d>
Hyperplane_expression<d> normal_line(const Spline_map<1, d>& curve, const Unknown& u)
{
  Vector_expression<d> direction = derivative(curve)(u);
  Expression offset = dot(direction, curve(u));
  return {std::move(direction), std::move(offset)};
}

//! the points at equal distance from two points, \f$2\langle b - a, p\rangle = \|b\|^2 - \|a\|^2\f$
//! (\cgalCite{ek-gcs-01}, equation
//! 12).
template <int d>
Hyperplane_expression<d> equidistant_hyperplane(const Vector_expression<d>& a, const Vector_expression<d>& b)
{
  return {2 * (b - a), squared_norm(b) - squared_norm(a)};
}

/*!
the point that two lines have in common, by Cramer's rule. The determinant of their normals becomes a divisor: it is a
condition of the constraints in which the point occurs, since where it is zero there is no such point, or more than one.
\throws Invalid_input when the determinant is the zero polynomial.
*/
inline Vector_expression<2> meet(const Hyperplane_expression<2>& a, const Hyperplane_expression<2>& b)
{
  const Expression d = determinant(a.normal, b.normal);
  return {(a.offset * b.normal[1] - b.offset * a.normal[1]) / d, (a.normal[0] * b.offset - b.normal[0] * a.offset) / d};
}

//! the point that three planes have in common, in the same way.
Vector_expression<3> meet(const Hyperplane_expression<3>& a, const Hyperplane_expression<3>& b,
                          const Hyperplane_expression<3>& c);

/*!
unknowns to be eliminated by `solve_linear()`: they have no range, and no constraint on a system may use them. They
belong to the same formulas as `u`.
*/
template <int d>
Vector_expression<d> unknowns_without_range(const Unknown& u)
{
  return internal::vector_of<d>([&](std::size_t) {
    return Expression(Power_polynomial::variable(u.symbols()->enter_unknown_without_range()), Monomial(), u.symbols());
  });
}

/*!
@}
*/

namespace internal {

// The symbol that an expression consists of.
int symbol_of(const Expression& expression);

// <normal, p> = offset from an equation that is linear in the symbols.
template <int d>
Hyperplane_expression<d> hyperplane_of(const Constraint& equation, const std::array<int, d>& symbols,
                                       const std::shared_ptr<Symbol_table>& table)
{
  if (equation.relation != Relation::EQUAL)
    throw Invalid_input("solve_linear: not an equation");
  if (!equation.conditions.empty())
    throw Invalid_input("solve_linear: an equation has a divisor that may vanish, multiply by it");
  if (equation.symbols != table)
    throw Invalid_input("solve_linear: an equation does not use the unknowns that are to be eliminated");
  Power_polynomial rest = table->without_formulas(equation.function);
  std::vector<Power_polynomial> slopes;
  for (int symbol : symbols) {
    table->require_outside_of_values(symbol, rest, "solve_linear");
    slopes.push_back(rest.derivative(symbol));
  }
  for (int symbol : symbols) {
    for (const Power_polynomial& slope : slopes)
      if (slope.degree(symbol) > 0)
        throw Invalid_input("solve_linear: an equation is not linear in the unknowns that are to be eliminated");
    rest = rest.substituted(symbol, Power_polynomial());
  }
  return {vector_of<d>([&](std::size_t i) { return Expression(slopes[i], Monomial(), table); }),
          Expression(-rest, Monomial(), table)};
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE int symbol_of(const Expression& expression)
{
  const std::vector<int> symbols = expression.numerator().variables();
  if (symbols.size() != 1 || !(expression.numerator() == Power_polynomial::variable(symbols[0])) ||
      !expression.denominator().powers.empty() || expression.symbols()->has_values(expression.numerator()))
    throw Invalid_input("solve_linear, substituted: what is to be eliminated is not an unknown");
  return symbols[0];
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

what equations say of unknowns that occur linearly in them: the values of these, by Cramer's rule. The determinant is a
divisor, as in `meet()`. Put these formulas in the place of the unknowns in all other constraints. When the unknowns
have ranges, the values are not restricted to them.

\code
auto p = unknowns_without_range<2>(u);
auto center = solve_linear({squared_norm(p - c1(u)) == squared_norm(p - c2(v)), squared_norm(p - c1(u)) ==
squared_norm(p - c3(w))}, p);
\endcode

\throws Invalid_input when what is to be eliminated is no unknown, an equation is not linear in the unknowns, has one
in the argument of a function or a divisor that may vanish, or the determinant is the zero polynomial.
*/
template <int d>
Vector_expression<d> solve_linear(const std::array<Constraint, d>& equations, const Vector_expression<d>& unknowns)
{
  std::array<int, d> symbols;
  for (int i = 0; i < d; ++i)
    symbols[i] = internal::symbol_of(unknowns[i]);
  const auto hyperplane = [&](int i) {
    return internal::hyperplane_of<d>(equations[i], symbols, unknowns[0].symbols());
  };
  if constexpr (d == 2)
    return meet(hyperplane(0), hyperplane(1));
  else
    return meet(hyperplane(0), hyperplane(1), hyperplane(2));
}

/*!
\ingroup PkgSplineConstraintsDFunctions

the formula with another one in the place of an unknown.
\throws Invalid_input when `unknown` is no unknown, or the parameter of a spline or in the argument of a function in
the formula; or the value is such that something is divided by zero.
*/
Expression substituted(const Expression& formula, const Expression& unknown, const Expression& value);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Vector_expression<3>
meet(const Hyperplane_expression<3>& a, const Hyperplane_expression<3>& b, const Hyperplane_expression<3>& c)
{
  const Vector_expression<3> bc = cross(b.normal, c.normal);
  return (a.offset * bc + b.offset * cross(c.normal, a.normal) + c.offset * cross(a.normal, b.normal)) /
      dot(a.normal, bc);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Expression substituted(const Expression& formula, const Expression& unknown,
                                                      const Expression& value)
{
  const int symbol = internal::symbol_of(unknown);
  const auto table = internal::common_symbols(formula.symbols(), unknown.symbols());
  const auto in_polynomial = [&](const Power_polynomial& polynomial) {
    const Power_polynomial without_formulas = table->without_formulas(polynomial);
    table->require_outside_of_values(symbol, without_formulas, "substituted");
    for (int other : without_formulas.variables())
      if (const auto& parameters = (*table)[other].unknowns;
          std::find(parameters.begin(), parameters.end(), symbol) != parameters.end())
        throw Invalid_input("substituted: the unknown is the parameter of a spline");
    const std::map<int, Power_polynomial> coefficients = internal::coefficients_by_power(without_formulas, symbol);
    Expression result = 0; // by Horner's scheme
    int power = coefficients.empty() ? 0 : coefficients.rbegin()->first;
    for (auto summand = coefficients.rbegin(); summand != coefficients.rend(); ++summand) {
      result = result * pow(value, power - summand->first) + Expression(summand->second, Monomial(), table);
      power = summand->first;
    }
    return result * pow(value, power);
  };
  Expression result = in_polynomial(formula.numerator());
  for (const auto& [divisor, exponent] : formula.denominator().powers)
    result /= pow(in_polynomial(Power_polynomial::variable(divisor)), exponent);
  return result;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_LINEAR_ELIMINATION_H
