// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CHECK_CONSTRAINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CHECK_CONSTRAINTS_H

#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/tensor_size.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Throws where an unknown has no range, or a value is missing.
void check_unknowns_of(const std::vector<Constraint_system_d::Domain>& domain,
                       const std::vector<Polynomial_constraint>& constraints, const Elementary_values& values,
                       const std::string& where);

// Throws where they do not fit each other.
void check_polynomials(const std::vector<Constraint_system_d::Domain>& domain,
                       const std::vector<Polynomial_constraint>& constraints,
                       const Elementary_values& values = Elementary_values());

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void check_unknowns_of(const std::vector<Constraint_system_d::Domain>& domain,
                                                      const std::vector<Polynomial_constraint>& constraints,
                                                      const Elementary_values& values, const std::string& where)
{
  const Constraint_system_d checked(domain); // throws when a range is empty
  const auto check_unknowns = [&](const Power_polynomial& polynomial, std::size_t known_values) {
    constexpr int first = Elementary_values::first_index;
    for (const int unknown : polynomial.variables()) {
      if (unknown < first ? unknown >= static_cast<int>(domain.size()) : values.all().empty())
        throw Invalid_input(where + ": unknown " + std::to_string(unknown) + " of a polynomial has no range");
      if (unknown >= first && unknown - first >= static_cast<int>(known_values))
        throw Invalid_input(where + ": there is no value " + std::to_string(unknown - first));
    }
  };
  for (const auto& [polynomial, relation] : constraints)
    check_unknowns(polynomial, values.all().size());
  for (std::size_t k = 0; k < values.all().size(); ++k)
    check_unknowns(values.all()[k].argument, k);
}

CGAL_SPLINE_CONSTRAINTS_INLINE void check_polynomials(const std::vector<Constraint_system_d::Domain>& domain,
                                                      const std::vector<Polynomial_constraint>& constraints,
                                                      const Elementary_values& values)
{
  check_unknowns_of(domain, constraints, values, "Propagation_solver_d");
  std::size_t equalities = 0;
  for (const auto& [polynomial, relation] : constraints)
    equalities += relation == Relation::EQUAL;
  if (equalities != domain.size())
    throw Invalid_input("Propagation_solver_d: " + std::to_string(equalities) + " equalities for " +
                        std::to_string(domain.size()) +
                        " unknowns, where it takes as many; see solve(), solve_curves(), solve_surfaces() and "
                        "find_feasible_point()");
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_CHECK_CONSTRAINTS_H
