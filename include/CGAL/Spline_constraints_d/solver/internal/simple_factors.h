// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SIMPLE_FACTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SIMPLE_FACTORS_H

#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/solver/internal/plane_restriction.h>
#include <CGAL/Spline_constraints_d/solver/rational_coordinates.h>

#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A system with the same solutions, in which polynomials have no repeated factors, so that no curve is singular everywhere. Nothing if none is found.
inline std::optional<Constraint_system_d> with_simple_factors(const Constraint_system_d& system)
{
  Constraint_system_d result(domain_of(system));
  bool is_simpler = false;
  for (const Spline_function& function : system.equalities()) {
    const std::optional<Power_polynomial> polynomial = restricted(function, Partial_point(static_cast<std::size_t>(system.dimension())));
    const Power_polynomial simple = polynomial ? square_free_part(*polynomial) : Power_polynomial();
    const bool has_repeated = polynomial && simple.total_degree() < polynomial->total_degree();
    is_simpler = is_simpler || has_repeated;
    result.add(has_repeated ? Spline_function(simple) : function, Relation::EQUAL);
  }
  for (const auto& [function, relation] : system.inequalities())
    result.add(function, relation);
  return is_simpler ? std::optional(std::move(result)) : std::nullopt;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SIMPLE_FACTORS_H
