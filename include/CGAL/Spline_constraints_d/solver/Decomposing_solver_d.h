// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_DECOMPOSING_SOLVER_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_DECOMPOSING_SOLVER_D_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Propagation_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Subdivision_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#if !defined(CGAL_SPLINE_CONSTRAINTS_COMPILED) && !defined(CGAL_SPLINE_CONSTRAINTS_BUILDS_LIBRARY)
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposed_solutions.h>
#endif
#include <CGAL/Spline_constraints_d/solver/solver_traits.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <span>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

Finds all solutions of a system, as `Subdivision_solver_d` does, after it has made the system smaller
(\cgalCite{ek-gcs-01}, Section 4):

- Equalities without breaks are replaced by linear combinations of them with fewer coefficients, found by exact row
  reduction. The differences of equations of circles are linear, for example.
- An equality of degree one is solved for one of its unknowns, which is replaced everywhere, where that does not make
  more coefficients. The domain of the unknown narrows that of another one, or becomes inequalities.
- Groups of unknowns that no constraint connects are solved each on its own; the answers are all combinations.

The answers are those of `Subdivision_solver_d`, in the coordinates of the system that is given. The range of an unknown
that was eliminated is computed from the others'; where that makes it wide, the whole system is solved in a box around
the answer. What takes few nodes, or nothing makes smaller, is solved as it is.
\ref Spline_constraints_d_decomposition_proofs "Proofs"

Complexity: for \f$m\f$ equalities with \f$N\f$ different monomials, \f$O(m^2 N)\f$ rational operations before the
subdivision, of which at most some hundred thousand are made, and work in proportion to the number of answers after it.

\tparam Traits, Concurrency_tag as for `Subdivision_solver_d`.
*/
template <ConstraintSolverTraits Traits = Certified_solver_traits, class Concurrency_tag = CGAL::Sequential_tag>
class Decomposing_solver_d
{
public:
  using Number_type = typename Traits::Number_type;
  using Coordinate = typename Number_traits<Number_type>::Coordinate;
  using Solution_set = Solution_set_d<Coordinate>;

private:
  Solver_options m_options;

public:
  //! \throws Invalid_input when an option makes no sense.
  explicit Decomposing_solver_d(const Solver_options& options = {}) : m_options(options) { m_options.check(); }

  //! all solutions of the system.
  //! \param system the constraints; at least as many equalities as unknowns.
  //! \throws Invalid_input when there are fewer equalities than unknowns.
  Solution_set operator()(const Constraint_system_d& system) const
  {
    internal::check_definitions<Traits, internal::are_points_compiled<Traits, Concurrency_tag>>();
    return internal::solution_set<Traits, Concurrency_tag>(system, m_options,
                                                           &internal::decomposed_solutions<Traits, Concurrency_tag>);
  }

  //! the same, watched by this visitor and not by that of the options.
  template <SolverVisitor Visitor>
  Solution_set operator()(const Constraint_system_d& system, Visitor& visitor) const
  {
    Solver_options options = m_options;
    options.visitor = visitor;
    return Decomposing_solver_d(options)(system);
  }
};

/*!
\ingroup PkgSplineConstraintsDSolver
all solutions of a system, with the default solver, decomposed: `Subdivision_solver_d` does without.
\tparam Concurrency_tag as for `Decomposing_solver_d`.
*/
template <class Concurrency_tag = CGAL::Sequential_tag>
Solution_set_d<double> solve(const Constraint_system_d& system, const Solver_options& options = {})
{
  return Decomposing_solver_d<Certified_solver_traits, Concurrency_tag>(options)(system);
}

/*!
\ingroup PkgSplineConstraintsDSolver
all solutions of constraints written as formulas. With elementary functions, by `Propagation_solver_d`.
\param constraints between the unknowns of one call of `unknowns()`.
\param options limits and the rest.
\throws Invalid_input as `make_system()` and `Decomposing_solver_d`, or as `Propagation_solver_d`.
*/
inline Solution_set_d<double> solve(std::span<const Constraint> constraints, const Solver_options& options = {})
{
  return std::ranges::any_of(constraints, &Constraint::has_elementary_functions)
      ? Propagation_solver_d(options)(constraints)
      : solve(make_system(constraints), options);
}

/*!
\ingroup PkgSplineConstraintsDSolver
the same: `solve(x*x + y*y == 2, exp(x) == y)`.
*/
template <std::same_as<Constraint>... Constraints>
Solution_set_d<double> solve(const Constraint& first, const Constraints&... others)
{
  const std::array<Constraint, 1 + sizeof...(others)> constraints{first, others...};
  return solve(std::span<const Constraint>(constraints));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_DECOMPOSING_SOLVER_D_H
