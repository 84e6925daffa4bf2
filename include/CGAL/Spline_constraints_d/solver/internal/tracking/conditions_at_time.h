// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_CONDITIONS_AT_TIME_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_CONDITIONS_AT_TIME_H

#include <CGAL/Spline_constraints_d/function/Graph_evaluation.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/function/expression_bounds.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/internal/tracking/Tracked_formulas.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The sign of a divisor on the domain; 0 where it is not known.
inline int sign_of_divisor(const std::shared_ptr<Symbol_table>& symbols, int index)
{
  const Symbol& symbol = (*symbols)[index];
  if (symbol.kind != Symbol::Kind::FORMULA)
    return symbol.sign;
  const Expression formula(symbols->without_formulas(symbol.formula), Monomial(), symbols);
  const auto range = bounds(formula, symbols->domains());
  return !range ? 0 : range->first > 0 ? 1 : range->second < 0 ? -1 : 0;
}

/*
What tracked formulas say at one time, as polynomials compared with zero on a domain in which the time has one value:
expanded, and multiplied by their divisors. Those that may vanish must not. `check()` may end the work by an exception.
*/
inline std::vector<std::pair<Power_polynomial, Relation>> conditions_at_time(Tracked_formulas& tracked,
                                                                             const Exact_ranges& domain,
                                                                             const std::vector<Exact_rational>& splines,
                                                                             const std::function<void()>& check)
{
  std::vector<std::array<Bound, 2>> ranges;
  for (const auto& [lower, upper] : domain)
    ranges.push_back({lower, upper});
  const std::vector<Unknown> unknowns = Spline_constraints::unknowns(ranges);
  std::vector<Expression> point(unknowns.begin(), unknowns.end());
  point[tracked.time()] = domain[tracked.time()].first;
  for (const Exact_rational& spline : splines)
    point.push_back(spline);
  std::vector<Expression_graph::Node> functions;
  for (const Tracked_formula& formula : tracked.formulas())
    functions.push_back(formula.function);
  Graph_evaluation<Expression> expansion(tracked.graph(), functions);
  expansion.set_point(point);
  expansion.evaluate(0, check);

  std::vector<std::pair<Power_polynomial, Relation>> result;
  for (const auto& [function, relation] : tracked.formulas()) {
    check();
    const Expression& value = expansion[function];
    const std::shared_ptr<Symbol_table>& symbols = unknowns[0].symbols();
    Power_polynomial polynomial = symbols->without_formulas(value.numerator());
    for (const auto& [divisor, exponent] : value.denominator().powers) {
      const int sign = sign_of_divisor(symbols, divisor);
      const Power_polynomial formula = symbols->without_formulas(Power_polynomial::variable(divisor));
      if (sign == 0)
        result.emplace_back(formula, Relation::NOT_EQUAL);
      if (exponent % 2 != 0 && sign <= 0)
        polynomial *= sign < 0 ? Power_polynomial(-1) : formula;
    }
    result.emplace_back(std::move(polynomial), relation);
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_TRACKING_CONDITIONS_AT_TIME_H
