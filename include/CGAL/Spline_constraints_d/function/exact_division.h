// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXACT_DIVISION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXACT_DIVISION_H

#include <CGAL/Spline_constraints_d/function/Expression.h>
#include <CGAL/Spline_constraints_d/function/Vector_expression.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/function/internal/Formula_expansion.h>
#include <CGAL/Spline_constraints_d/function/internal/polynomial_of_powers.h>
#endif

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The coefficients of the powers of an unknown that occur.
std::map<int, Power_polynomial> coefficients_by_power(const Power_polynomial& polynomial, int unknown);

// A polynomial as a divisor: by its powers of an unknown whose highest power has a constant coefficient.
class Polynomial_divisor
{
  int m_unknown = -1;
  std::map<int, Power_polynomial> m_coefficients;

public:
  explicit Polynomial_divisor(const Power_polynomial& divisor);

  // The quotient; nothing when there is a remainder.
  std::optional<Power_polynomial> quotient(const Power_polynomial& dividend) const;
};

Power_polynomial polynomial_of_piece(const Spline_term& term, std::size_t cell);

// The spline of these unknowns with one polynomial for each cell.
Integer_spline spline_of_polynomials(const std::vector<int>& unknowns, const std::vector<Breaks_of_axis>& breaks,
                                     const std::vector<Power_polynomial>& polynomials);

// The quotient of a polynomial in splines, piece by piece, as a symbol.
Power_polynomial divided_piece_by_piece(const Power_polynomial& dividend, const Polynomial_divisor& divisor,
                                        int exponent, Symbol_table& symbols);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::map<int, Power_polynomial> coefficients_by_power(const Power_polynomial& polynomial,
                                                                                     int unknown)
{
  std::map<int, Power_polynomial> result;
  for (const auto& [monomial, coefficient] : polynomial.terms())
    result[monomial.exponent(unknown)] +=
        Power_polynomial(coefficient) * polynomial_of(monomial.with_exponent(unknown, 0));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Integer_spline spline_of_polynomials(const std::vector<int>& unknowns,
                                                                    const std::vector<Breaks_of_axis>& breaks,
                                                                    const std::vector<Power_polynomial>& polynomials)
{
  Integer_pieces<Big_integer> result{std::vector<int>(unknowns.size(), 0), breaks, {}};
  Big_integer denominator(1);
  for (const Power_polynomial& polynomial : polynomials) {
    for (std::size_t j = 0; j < unknowns.size(); ++j)
      result.degrees[j] = (std::max)(result.degrees[j], polynomial.degree(unknowns[j]));
    for (const auto& [monomial, coefficient] : polynomial.terms())
      extend_common_denominator(denominator, coefficient);
  }
  const std::vector<std::size_t> strides = tensor_strides(result.degrees);
  for (const Power_polynomial& polynomial : polynomials) {
    auto& piece = result.pieces.emplace_back(tensor_size(result.degrees), Big_integer(0));
    for (const auto& [monomial, coefficient] : polynomial.terms()) {
      std::size_t position = 0;
      for (std::size_t j = 0; j < unknowns.size(); ++j)
        position += strides[j] * static_cast<std::size_t>(monomial.exponent(unknowns[j]));
      piece[position] = numerator_over(coefficient, denominator);
    }
  }
  return Integer_spline(std::move(result), std::move(denominator));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial divided_piece_by_piece(const Power_polynomial& dividend,
                                                                       const Polynomial_divisor& divisor, int exponent,
                                                                       Symbol_table& symbols)
{
  const Formula_expansion expansion(symbols, dividend);
  const Spline_term term = expansion.scaled_term();
  std::vector<Breaks_of_axis> breaks = term.breaks;
  for (std::size_t j = 0; j < breaks.size(); ++j)
    if (breaks[j].empty()) {
      const auto& [lower, upper] = symbols.domains()[term.variables[j]];
      breaks[j] = {lower, lower < upper ? upper : Exact_rational(lower + Exact_rational(1))};
    }
  std::vector<Power_polynomial> quotients;
  for (std::size_t c = 0; c < term.pieces.size(); ++c) {
    std::optional<Power_polynomial> quotient = polynomial_of_piece(term, c);
    for (int k = 0; k < exponent && quotient; ++k)
      quotient = divisor.quotient(*quotient);
    if (!quotient)
      throw Invalid_input("divided_exactly: the factor does not divide the piece of cell " + std::to_string(c) +
                          " of " + std::to_string(term.pieces.size()));
    quotients.push_back(*quotient / Power_polynomial(scaled_rational(expansion.denominator(), 0)));
  }
  const auto spline = std::make_shared<const Integer_spline>(spline_of_polynomials(term.variables, breaks, quotients));
  spline->check_continuity("divided_exactly: the quotient");
  return symbols.spline_of_unknowns(spline, term.variables, 0);
}
#endif

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Polynomial_divisor::Polynomial_divisor(const Power_polynomial& divisor)
{
  for (int unknown : divisor.variables()) {
    m_coefficients = coefficients_by_power(divisor, unknown);
    m_unknown = unknown;
    if (m_coefficients.rbegin()->second.is_constant())
      return;
  }
  throw Invalid_input("divided_exactly: no unknown whose highest power in the factor has a constant coefficient");
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Power_polynomial>
Polynomial_divisor::quotient(const Power_polynomial& dividend) const
{
  const int degree = m_coefficients.rbegin()->first;
  const Power_polynomial x = Power_polynomial::variable(m_unknown);
  Power_polynomial result;
  std::map<int, Power_polynomial> rest = coefficients_by_power(dividend, m_unknown);
  while (!rest.empty()) {
    const auto [power, leading] = *rest.rbegin();
    rest.erase(power);
    if (leading.is_zero())
      continue;
    if (power < degree)
      return std::nullopt;
    const Power_polynomial factor = leading / m_coefficients.rbegin()->second;
    for (const auto& [k, coefficient] : m_coefficients)
      if (k < degree)
        rest[power - degree + k] -= factor * coefficient;
    result += factor * pow(x, power - degree);
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial polynomial_of_piece(const Spline_term& term, std::size_t cell)
{
  return polynomial_of_powers(term.degrees, term.pieces[cell],
                              [&](std::size_t j) { return Power_polynomial::variable(term.variables[j]); });
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

the formula divided by `pow(factor, exponent)`, where this leaves no remainder. Unlike division, it makes no condition:
the quotient is a polynomial, or a spline, wherever the formula is, and its zeros on those of the factor are found.
Factors that are known to vanish, such as \f$u - v\f$ in formulas for one curve at two parameters, are removed in this
way: `divided_exactly(c(u) - c(v), u - v)` is zero where the curve meets itself, and where it stops.

A formula with splines is multiplied out to one dense tensor, and divided piece by piece. *All* pieces have to be
divisible: on a spline with breaks inside they are not, since
\f$c_i(u) - c_j(v)\f$ has no factor \f$u - v\f$ for different pieces \f$c_i\f$ and \f$c_j\f$, and a function that is
divided in some cells only is not continuous, which no proof across a break would survive. Split the curve at its
`breaks()` instead. A pair of equal parts is divided; a pair of different parts needs no division, but parts that are
neighbours have their common end as a solution.

\throws Invalid_input when there is a remainder in some cell (the message names the cell), the quotient is not
continuous, the factor is no polynomial in unknowns or constant, none of its unknowns has a constant as coefficient of
its highest power, the exponent is negative, or an elementary function occurs in the dividend.
*/
Expression divided_exactly(const Expression& dividend, const Expression& factor, int exponent = 1);

/*!
\ingroup PkgSplineConstraintsDFunctions
a vector with every coordinate divided in this way.
*/
template <int d>
Vector_expression<d> divided_exactly(const Vector_expression<d>& dividend, const Expression& factor, int exponent = 1)
{
  return internal::vector_of<d>([&](std::size_t i) { return divided_exactly(dividend[i], factor, exponent); });
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Expression divided_exactly(const Expression& dividend, const Expression& factor,
                                                          int exponent)
{
  const internal::Polynomial_divisor divisor(factor.polynomial());
  if (exponent < 0)
    throw Invalid_input("divided_exactly: negative exponent " + std::to_string(exponent));
  const auto symbols = internal::common_symbols(dividend.symbols(), factor.symbols());
  symbols->require_no_values(dividend.numerator(), "divided_exactly");
  Power_polynomial numerator = symbols->without_formulas(dividend.numerator());
  if (!symbols->has_only_unknowns(numerator))
    return Expression(internal::divided_piece_by_piece(numerator, divisor, exponent, *symbols), dividend.denominator(),
                      symbols);
  for (int k = 0; k < exponent; ++k) {
    const std::optional<Power_polynomial> quotient = divisor.quotient(numerator);
    if (!quotient)
      throw Invalid_input("divided_exactly: the factor does not divide the formula");
    numerator = *quotient;
  }
  return Expression(std::move(numerator), dividend.denominator(), symbols);
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_EXACT_DIVISION_H
