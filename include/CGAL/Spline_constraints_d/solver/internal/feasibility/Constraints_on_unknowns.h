// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_CONSTRAINTS_ON_UNKNOWNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_CONSTRAINTS_ON_UNKNOWNS_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>

#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The same constraints with numbers in place of all unknowns but some, which are numbered anew.
struct Constraints_on_unknowns
{
  std::vector<Polynomial_constraint> constraints;
  Elementary_values values;

  // Throws where a function is not defined for a number.
  Constraints_on_unknowns(const std::vector<Polynomial_constraint>& given, const Elementary_values& given_values,
                          const std::vector<double>& point, const std::vector<int>& unknowns);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE
Constraints_on_unknowns::Constraints_on_unknowns(const std::vector<Polynomial_constraint>& given,
                                                 const Elementary_values& given_values,
                                                 const std::vector<double>& point, const std::vector<int>& unknowns)
{
  std::map<int, Power_polynomial> replacements;
  for (std::size_t j = 0; j < point.size(); ++j)
    replacements.emplace(static_cast<int>(j), Power_polynomial(point[j]));
  for (std::size_t k = 0; k < unknowns.size(); ++k)
    replacements[unknowns[k]] = Power_polynomial::variable(static_cast<int>(k));
  const auto replaced = [&](const Power_polynomial& polynomial) {
    Power_polynomial result;
    for (const auto& [monomial, coefficient] : polynomial.terms()) {
      Power_polynomial term(coefficient);
      for (const auto& [symbol, exponent] : monomial.powers)
        term *= pow(replacements.at(symbol), exponent);
      result += term;
    }
    return result;
  };
  int index = Elementary_values::first_index;
  for (const auto& [function, exponent, argument] : given_values.all())
    replacements.emplace(index++,
                         function == Elementary_function::POWER ? values.power(replaced(argument), exponent)
                                                                : values.value(function, replaced(argument)));
  for (const auto& [polynomial, relation] : given)
    constraints.emplace_back(replaced(polynomial), relation);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_CONSTRAINTS_ON_UNKNOWNS_H
