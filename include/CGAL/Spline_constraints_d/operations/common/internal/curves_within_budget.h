// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVES_WITHIN_BUDGET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVES_WITHIN_BUDGET_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>

#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// The curves of one of the systems of an operation.
inline Curve_solution_set_d curves_within_budget(const Constraint_system_d& system, Operation_budget& budget,
                                                 const Curve_search& search = {.are_faces_undecided = true})
{
  Curve_solution_set_d result = all_curves(system, budget.remaining(), search);
  budget.add(result.summary());
  return result;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVES_WITHIN_BUDGET_H
