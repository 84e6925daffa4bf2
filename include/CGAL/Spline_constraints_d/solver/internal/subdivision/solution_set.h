// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_SOLUTION_SET_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_SOLUTION_SET_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>

#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The answers of a run that has ended: complete if none of them is undecided.
template <class Coordinate>
Solution_set_d<Coordinate> finished_set(std::vector<Solution_d<Coordinate>> solutions, Summary summary,
                                        const Run_control& control)
{
  for (const auto& solution : solutions)
    if (solution.kind() == Solution_kind::UNDECIDED && summary.is_complete) {
      summary.is_complete = false;
      summary.why_not = solution.reason();
    }
  summary.seconds = control.seconds();
  return {std::move(solutions), summary};
}

template <class Traits, class Concurrency_tag>
Solution_set_d<Coordinate_of<Traits>> solution_set(const Constraint_system_d& system, const Solver_options& options,
                                                   Solutions_finder<Traits> finder, Round_distribution* distribution)
{
  const int n = system.dimension();
  if (static_cast<int>(system.equalities().size()) < n)
    throw Invalid_input("Subdivision_solver_d: " + std::to_string(system.equalities().size()) + " equalities for " +
                        std::to_string(n) +
                        " unknowns; see solve_curves(), with two less solve_surfaces(), and for one solution of any "
                        "number of constraints find_feasible_point()");

  [[maybe_unused]] const typename Number_traits<typename Traits::Number_type>::Rounding_guard guard;
  [[maybe_unused]] const Mpfr_precision_scope precision(options.precision);
  Summary summary;
  Run_control control(options, distribution);
  auto found = finder(system, options, control, summary);
  return finished_set(std::move(found), summary, control);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_SOLUTION_SET_H
