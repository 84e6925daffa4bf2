// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_CONSTRAINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_CONSTRAINT_H

#include <CGAL/Spline_constraints_d/function/Relation.h>
#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/function/internal/Symbol_table.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/function/internal/expanded.h>
#endif

#include <algorithm>
#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {

// The names of the symbols of a formula: x0, x1, ... for unknowns, s5(x0,x1) for splines, f6 for formulas, and values
// of functions as they are written, or v7 where that is long.
std::vector<std::string> symbol_names(const Symbol_table& symbols);

// A function of the unknowns alone; `check()` may end the work by an exception. Defined in internal/expanded.h.
Spline_function expanded(const Symbol_table* symbols, const Power_polynomial& polynomial,
                         const std::function<void()>& check);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
inline std::string text_of_value(const Symbol& symbol, const std::vector<std::string>& names)
{
  const std::string argument = '(' + symbol.formula.to_string(names) + ')';
  return symbol.function == Elementary_function::RECIPROCAL ? "(1/" + argument + ')'
      : symbol.function == Elementary_function::POWER
      ? '(' + argument + "^(" + Power_polynomial(symbol.exponent).to_string() + "))"
      : std::string(name_of(symbol.function)) + argument;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::string> symbol_names(const Symbol_table& symbols)
{
  constexpr std::size_t longest_text = 60;
  std::vector<std::string> names;
  for (int i = 0, size = symbols.size(); i < size; ++i) {
    const Symbol& symbol = symbols[i];
    const char* letter = symbol.kind == Symbol::Kind::UNKNOWN ? "x"
        : symbol.kind == Symbol::Kind::SPLINE                 ? "s"
        : symbol.kind == Symbol::Kind::FORMULA                ? "f"
        : symbol.kind == Symbol::Kind::VALUE                  ? "v"
                                                              : "y";
    if (symbol.kind == Symbol::Kind::VALUE)
      if (std::string text = text_of_value(symbol, names); text.size() <= longest_text) {
        names.push_back(std::move(text));
        continue;
      }
    std::string& name = names.emplace_back(letter).append(std::to_string(i));
    for (std::size_t j = 0; j < symbol.unknowns.size(); ++j)
      name.append(j == 0 ? "(x" : ",x").append(std::to_string(symbol.unknowns[j]));
    if (!symbol.unknowns.empty())
      name.append(")");
  }
  return names;
}
#endif

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDFunctions

An equation or inequality in unknowns and splines of unknowns, as a user writes it: `x*x + y*y == 2` is the constraint
`function relation 0` with the function \f$x^2+y^2-2\f$ and the relation `EQUAL`.

What the sides of the formula are divided by is multiplied out: \f$f\f$ is zero where \f$f/d\f$ is, provided that \f$d
\neq 0\f$. Weights are proved to be positive and no more is said of them; every other divisor is kept as a *condition*.
In an inequality, a divisor of unknown sign is multiplied with the function, for \f$f/d > 0\f$ is \f$f d > 0\f$.
*/
struct Constraint
{
  //! left side minus right side, times the divisors: a polynomial in unknowns, which are indices into `*domains`, and,
  //! with larger indices, in splines of these and in divisors.
  Power_polynomial function;

  //! how the function compares with zero.
  Relation relation;

  //! the ranges of the unknowns, shared by all that were made together; null when no unknown occurs in the formula.
  std::shared_ptr<const Unknown_domains> domains;

  //! the divisors of the formula that may vanish. Where one of them does, the formula says nothing, whatever `function`
  //! is.
  std::vector<Power_polynomial> conditions;

#ifndef DOXYGEN_RUNNING
  std::shared_ptr<internal::Symbol_table> symbols;   // what the indices mean
#endif

  /*!
  `function` as a function of the unknowns alone, in exact arithmetic; where splines occur, times a positive number that
  makes all coefficients integers.

  Monomials on the same unknowns become one dense tensor per cell of the breaks; monomials on a part of these unknowns
  join it where the coefficients do not become more. All others stay apart. Complexity: for a formula with \f$m\f$
  different products of splines of one unknown, one multiplication of integers for each of these products and each
  coefficient of the result.
  \param check is called again and again during long work, which it may end by an exception.
  \throws Invalid_input when a tensor gets too many coefficients, or an unknown without a range is left.
  */
  Spline_function spline_function(const std::function<void()>& check = {}) const
  {
    return internal::expanded(symbols.get(), function, check);
  }

  //! tells whether values of elementary functions occur: then the constraint is no spline. See
  //! `elementary_constraints()`.
  bool has_elementary_functions() const
  {
    return symbols != nullptr &&
        (symbols->has_values(function) ||
         std::ranges::any_of(conditions, [&](const Power_polynomial& p) { return symbols->has_values(p); }));
  }

  //! the conditions as functions of the unknowns alone, each up to a positive factor. \throws Invalid_input as
  //! `spline_function()`.
  std::vector<Spline_function> condition_functions(const std::function<void()>& check = {}) const;

  //! writes, for example, `-2 + x0^2 + x1^2 = 0`.
  friend std::ostream& operator<<(std::ostream& out, const Constraint& constraint);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Spline_function>
Constraint::condition_functions(const std::function<void()>& check) const
{
  std::vector<Spline_function> result;
  for (const Power_polynomial& condition : conditions)
    result.push_back(internal::expanded(symbols.get(), condition, check));
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::ostream& operator<<(std::ostream& out, const Constraint& constraint)
{
  if (constraint.symbols == nullptr)
    return out << constraint.function << ' ' << constraint.relation << " 0";
  const std::vector<std::string> names = internal::symbol_names(*constraint.symbols);
  out << constraint.function.to_string(names) << ' ' << constraint.relation << " 0";
  for (const Power_polynomial& condition : constraint.conditions)
    out << ", " << condition.to_string(names) << " != 0";
  return out;
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_CONSTRAINT_H
