// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_SOLUTIONS_OF_SYSTEMS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_SOLUTIONS_OF_SYSTEMS_H

#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_problem.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Feasibility_run.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Rational_points.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// All solutions of a square system that is a part of a run.
inline Solution_set_d<double> solutions_of(const Constraint_system_d& system, std::size_t nodes, Feasibility_run& run)
{
  Solution_set_d<double> result = solve(system, run.options_of_system(nodes));
  run.add_nodes(result.summary().nodes);
  return result;
}

/*
What the solutions of a system say of a problem: there are none; one of them is a solution of the problem; or it is not
known of one. The first unknowns of the system are some of the problem, the others of which have one value.
*/
inline Feasibility_outcome outcome_of(const Solution_set_d<double>& solutions, const Feasibility_problem& problem,
                                      const std::vector<int>& unknowns, Rational_points& points,
                                      const std::string& certificate)
{
  Feasibility_outcome result{Feasibility::INFEASIBLE, {}, {}, {}};
  const auto leave_undecided = [&](const std::string& reason) {
    if (result.undecided.empty())
      result.undecided.push_back({place_of(problem.domain()), {}, reason});
    result.status = Feasibility::UNDECIDED;
  };
  for (const auto& solution : solutions) {
    Exact_ranges box = problem.domain();
    const auto part = solution.exact_box();
    for (std::size_t k = 0; k < unknowns.size(); ++k)
      box[unknowns[k]] = part[k];
    if (const auto point = points.simplest_in(box))
      return feasible_in(box_of_point(*point), "exact signs at a rational point");
    if (solution.is_certified())
      return feasible_in(std::move(box), certificate);
    leave_undecided(solution.kind() == Solution_kind::UNDECIDED
                        ? "points that may be solutions are undecided (" + in_words(solution.reason()) + ")"
                        : "points that may be solutions are not regular");
  }
  if (solutions.empty() && !solutions.is_complete())
    leave_undecided("points that may be solutions are undecided (" + in_words(solutions.summary().why_not) + ")");
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_SOLUTIONS_OF_SYSTEMS_H
