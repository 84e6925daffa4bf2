// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_INEQUALITIES_AS_UNKNOWNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_INEQUALITIES_AS_UNKNOWNS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The range of x^exponent.
inline Exact_ranges::value_type power_of(const Exact_ranges::value_type& range, int exponent)
{
  Exact_rational lower(1), upper(1);
  for (int k = 0; k < exponent; ++k) {
    lower *= range.first;
    upper *= range.second;
  }
  if (exponent % 2 == 1 || range.first >= 0)
    return {lower, upper};
  if (range.second <= 0)
    return {upper, lower};
  return {exponent == 0 ? Exact_rational(1) : Exact_rational(0), (std::max)(lower, upper)};
}

inline Exact_ranges::value_type product_of(const Exact_ranges::value_type& a, const Exact_ranges::value_type& b)
{
  const std::array<Exact_rational, 4> all{Exact_rational(a.first * b.first), Exact_rational(a.first * b.second),
                                          Exact_rational(a.second * b.first), Exact_rational(a.second * b.second)};
  return {*std::min_element(all.begin(), all.end()), *std::max_element(all.begin(), all.end())};
}

// Bounds on a function on a box, by the ranges of its monomials.
inline Exact_ranges::value_type bounds_of_monomials(const Spline_function& function, const Exact_ranges& box)
{
  Exact_ranges::value_type result(0, 0);
  for (const Spline_term& term : function.terms()) {
    std::optional<Exact_ranges::value_type> of_term;
    for (const std::vector<Exact_rational>& piece : term.pieces) {
      Exact_ranges::value_type sum(0, 0);
      for (std::size_t i = 0; i < piece.size(); ++i) {
        Exact_ranges::value_type monomial(piece[i], piece[i]);
        for (std::size_t j = term.degrees.size(), rest = i; j-- > 0;) {
          const std::size_t count = static_cast<std::size_t>(term.degrees[j]) + 1;
          monomial = product_of(monomial, power_of(box[term.variables[j]], static_cast<int>(rest % count)));
          rest /= count;
        }
        sum.first += monomial.first;
        sum.second += monomial.second;
      }
      of_term = of_term
          ? Exact_ranges::value_type{(std::min)(of_term->first, sum.first), (std::max)(of_term->second, sum.second)}
          : sum;
    }
    result.first += of_term->first;
    result.second += of_term->second;
  }
  return result;
}

/*
A system of equalities with one unknown more for each inequality: g >= 0 is g = s with s in [0, max g]. Where g is zero
a face of the new domain cuts the surfaces, as faces do. Inequalities that hold everywhere are left out; strict ones
give the closure of what they allow.
*/
inline Constraint_system_d inequalities_as_unknowns(const Constraint_system_d& system)
{
  Exact_ranges domain = domain_of(system);
  std::vector<Spline_function> equalities = system.equalities();
  for (const auto& [function, relation] : system.inequalities()) {
    Spline_function value = function;
    if (relation == Relation::LESS || relation == Relation::LESS_EQUAL)
      value *= Exact_rational(-1);
    const auto [least, most] = bounds_of_monomials(value, domain_of(system));
    if (least > 0 || (least == 0 && relation != Relation::NOT_EQUAL))
      continue;
    if (relation == Relation::NOT_EQUAL) {
      if (most < 0)
        continue;
      throw Invalid_input("solve_surfaces: an inequation f != 0 whose function may be zero in the domain");
    }
    const int unknown = static_cast<int>(domain.size());
    domain.emplace_back(Exact_rational(0), (std::max)(most, Exact_rational(1)));
    value += Spline_function(Power_polynomial::variable(unknown) * Power_polynomial(Exact_rational(-1)));
    equalities.push_back(std::move(value));
  }
  Constraint_system_d result(std::move(domain));
  for (Spline_function& equality : equalities)
    result.add(std::move(equality), Relation::EQUAL);
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_INEQUALITIES_AS_UNKNOWNS_H
