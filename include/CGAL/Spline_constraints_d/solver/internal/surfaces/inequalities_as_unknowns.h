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
#include <CGAL/Spline_constraints_d/function/expression_bounds.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Bounds on a function on the domain of a system, by Bernstein coefficients.
inline Exact_range bounds_in_domain(const Spline_function& function, const Constraint_system_d& system)
{
  Exact_range result(0, 0);
  for (const Spline_term& term : function.terms()) {
    const auto [least, most] = bounds_of_term(term, domain_of(system));
    result.first += least;
    result.second += most;
  }
  return result;
}

/*
A system of equalities with one unknown more for each inequality: g >= 0 is g = s with s in [0, S]. Where g is zero a
face of the new domain cuts the surfaces, as faces do; the other one lies beyond the greatest value of g, so that
surfaces do not reach it together with a face of the old domain. Inequalities that hold everywhere are left out; strict
ones give the closure of what they allow.

A feature, a function along whose zeros surfaces are to be cut, is an unknown likewise, positive or negative, with a
break at zero: planes of breaks cut surfaces, and both sides share the arcs.
*/
inline Constraint_system_d inequalities_as_unknowns(const Constraint_system_d& system,
                                                    const std::vector<Spline_function>& features = {})
{
  Exact_ranges domain = domain_of(system);
  std::vector<Spline_function> equalities = system.equalities();
  for (const auto& [function, relation] : system.inequalities()) {
    Spline_function value = function;
    if (relation == Relation::LESS || relation == Relation::LESS_EQUAL)
      value *= Exact_rational(-1);
    const auto [least, most] = bounds_in_domain(value, system);
    if (least > 0 || (least == 0 && relation != Relation::NOT_EQUAL))
      continue;
    if (relation == Relation::NOT_EQUAL) {
      if (most < 0)
        continue;
      throw Invalid_input("solve_surfaces: an inequation f != 0 whose function may be zero in the domain");
    }
    const int unknown = static_cast<int>(domain.size());
    domain.emplace_back(Exact_rational(0), most > 0 ? Exact_rational(2 * most) : Exact_rational(1));
    value += Spline_function(Power_polynomial::variable(unknown) * Power_polynomial(Exact_rational(-1)));
    equalities.push_back(std::move(value));
  }
  for (const Spline_function& feature : features) {
    Constraint_system_d(domain_of(system)).add(feature, Relation::EQUAL); // throws where it has other unknowns
    const auto [least, most] = bounds_in_domain(feature, system);
    if (least > 0 || most < 0)
      continue;
    const int unknown = static_cast<int>(domain.size());
    const Exact_rational bound = 1 + 2 * (std::max)(Exact_rational(-least), most);
    domain.emplace_back(Exact_rational(-bound), bound);
    const Spline_function own(
        Spline_term{{unknown}, {1}, {{Exact_rational(-bound), Exact_rational(0), bound}}, {{0, 1}, {0, 1}}});
    equalities.push_back(feature - own);
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
