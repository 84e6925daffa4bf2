// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVES_WITHIN_BUDGET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVES_WITHIN_BUDGET_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// A box where nothing is proved.
inline Curve_solution_set_d undecided_curves(Curve_vertex::Exact_box box, Undecided_reason reason)
{
  Summary summary;
  summary.is_complete = false;
  summary.why_not = reason;
  return Curve_solution_set_d({}, {}, {}, {}, {{{std::move(box)}, {}, reason}}, summary);
}

// The curves of one of the systems of an operation; not even laid out where the run has ended.
inline Curve_solution_set_d curves_within_budget(const Constraint_system_d& system, Operation_budget& budget,
                                                 const Curve_search& search = {.are_faces_undecided = true})
{
  if (budget.must_stop())
    return undecided_curves(domain_of(system), budget.reason());
  Curve_solution_set_d result = all_curves(system, budget.remaining(), search);
  budget.add(result.summary());
  return result;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CURVES_WITHIN_BUDGET_H
