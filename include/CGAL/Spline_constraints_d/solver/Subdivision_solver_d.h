// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SUBDIVISION_SOLVER_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SUBDIVISION_SOLVER_D_H

#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#if !defined(CGAL_SPLINE_CONSTRAINTS_COMPILED) && !defined(CGAL_SPLINE_CONSTRAINTS_BUILDS_LIBRARY)
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/all_solutions.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/solution_set.h>
#endif
#include <CGAL/Spline_constraints_d/solver/solver_traits.h>

#include <array>
#include <concepts>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

Finds all solutions of a system of at least as many spline equations as unknowns, with inequalities, on a box.

The box is subdivided; a part is dropped only on a proof that it holds no solution, and a solution is certified by a
proof that a box around it holds exactly one (\cgalCite{ek-gcs-01}, Algorithm 2.1, with the tests of the traits). What
can be neither is reported as a cluster or as undecided. With one unknown and `Certified_solver_traits` nothing is
undecided unless a limit is reached.

\tparam Traits bundles number type and policies, a model of `ConstraintSolverTraits`.
\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`, to use all
cores through TBB. The answers are the same, in the same order, except where a time limit or the visitor ends the run.
*/
template <ConstraintSolverTraits Traits = Certified_solver_traits, class Concurrency_tag = CGAL::Sequential_tag>
class Subdivision_solver_d
{
public:
  using Number_type = typename Traits::Number_type;
  using Coordinate = typename Number_traits<Number_type>::Coordinate;
  using Solution_set = Solution_set_d<Coordinate>;

private:
  Solver_options m_options;

public:
  //! \throws Invalid_input when an option makes no sense.
  explicit Subdivision_solver_d(const Solver_options& options = {}) : m_options(options) { m_options.check(); }

  //! all solutions of the system.
  //! \param system the constraints; at least as many equalities as unknowns.
  //! \throws Invalid_input when there are fewer equalities than unknowns.
  Solution_set operator()(const Constraint_system_d& system) const
  {
    internal::check_definitions<Traits, internal::are_points_compiled<Traits, Concurrency_tag>>();
    return internal::solution_set<Traits, Concurrency_tag>(system, m_options,
                                                           &internal::all_solutions<Traits, Concurrency_tag>);
  }

  //! the same, watched by this visitor and not by that of the options. It is called by one thread at a time, not always
  //! by the same one.
  template <SolverVisitor Visitor>
  Solution_set operator()(const Constraint_system_d& system, Visitor& visitor) const
  {
    Solver_options options = m_options;
    options.visitor = visitor;
    return Subdivision_solver_d(options)(system);
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver
the system of constraints between the unknowns of one call of `unknowns()`, with their conditions.
\throws Invalid_input when the constraints use unknowns of different calls, or none; and as
`Constraint::spline_function()`, which `check` is for.
*/
inline Constraint_system_d make_system(std::span<const Constraint> constraints, const std::function<void()>& check = {})
{
  Constraint_system_d system(common_domains(constraints));
  for (const Constraint& constraint : constraints)
    system.add(constraint, check);
  return system;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SUBDIVISION_SOLVER_D_H
