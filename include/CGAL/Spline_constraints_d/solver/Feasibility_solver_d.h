// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_FEASIBILITY_SOLVER_D_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_FEASIBILITY_SOLVER_D_H

#include <CGAL/Spline_constraints_d/function/Constraint.h>
#include <CGAL/Spline_constraints_d/function/Elementary_values.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/Unknown_expression.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Feasibility_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/Elementary_feasibility.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/feasibility_of.h>
#endif

#include <algorithm>
#include <array>
#include <concepts>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {

// Defined in feasibility/feasibility_of.h.
Feasibility_d feasibility_of(const Constraint_system_d& system,
                             const std::vector<std::pair<Power_polynomial, Relation>>& polynomials,
                             const Solver_options& options);

// Defined in feasibility/Elementary_feasibility.h.
Feasibility_d feasibility_with_values(const std::vector<Constraint_system_d::Domain>& domain,
                                      const std::vector<std::pair<Power_polynomial, Relation>>& constraints,
                                      const Elementary_values& values, const Solver_options& options);

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

Decides whether inequalities, and fewer equalities than unknowns, can be satisfied on a box.

The answer is a rational point whose signs are checked exactly; or, where there are equalities without such a point, a
box with a certified solution and the values of the unknowns that were chosen; or a proof that there is no solution; or
the boxes that are undecided, each with a reason.

A box is dropped where a constraint is violated on all of it, or a combination of them with multipliers that are not
negative: these come from a local minimum of the largest function, found by relaxation and Newton steps. The lower bound
of the combination is that of a convex function below it, so that for convex inequalities in general one box is enough,
for any number of unknowns. Others are split. Sets that only touch are decided by critical points, see
\ref Spline_constraints_d_feasibility_proofs "Proofs". Splines are taken as continuous, and cell by cell.

Complexity: per box, with \f$m\f$ constraints with \f$N\f$ different monomials in \f$n\f$ unknowns, \f$O(m N + n^3 +
(m+n)^2 n)\f$ times some hundreds; the number of boxes may grow exponentially with \f$n\f$ where constraints are not
convex.

Source: relaxation of S. Agmon and T. Motzkin and I. Schoenberg; the convex function is \f$\alpha\f$BB of Adjiman et al.
*/
class Feasibility_solver_d
{
  Solver_options m_options;

public:
  //! \param options the tolerance is the width, relative to \f$\max(1, |x|)\f$, below which an undecided box is not
  //! split any further.
  //! \throws Invalid_input when an option makes no sense.
  explicit Feasibility_solver_d(const Solver_options& options = {.tolerance = 1e-6}) : m_options(options)
  {
    m_options.check();
  }

  //! whether the constraints of a system can be satisfied.
  //! \throws Invalid_input when there is no constraint, or there are as many equalities as unknowns: see `solve()`.
  Feasibility_d operator()(const Constraint_system_d& system) const
  {
    return internal::feasibility_of(system, {}, m_options);
  }

  //! the same, watched by this visitor and not by that of the options. Of the progress it is told only that the run
  //! goes on.
  template <SolverVisitor Visitor>
  Feasibility_d operator()(const Constraint_system_d& system, Visitor& visitor) const
  {
    Solver_options options = m_options;
    options.visitor = visitor;
    return Feasibility_solver_d(options)(system);
  }

  /*!
  the same of polynomials compared with zero, which are never made tensors: in many unknowns they take less time.
  \param domain a range for each unknown.
  \param constraints polynomials, and how they compare with zero.
  \throws Invalid_input also when a range is empty, or an unknown has none.
  */
  Feasibility_d operator()(const std::vector<Constraint_system_d::Domain>& domain,
                           const std::vector<std::pair<Power_polynomial, Relation>>& constraints) const
  {
    return internal::feasibility_of(Constraint_system_d(domain), constraints, m_options);
  }

  /*!
  the same of constraints with values of elementary functions, by constraint propagation, and Newton's method for
  points. There are no critical points here: sets that only touch stay undecided, and more equalities than unknowns,
  too, unless there is no solution or it is rational by the laws of the functions. `Feasibility_d::excluded()` has no
  multipliers, `Feasibility_d::path()` no points.
  \param domain a range for each unknown.
  \param constraints polynomials in unknowns and values, and how they compare with zero.
  \param values what the values are.
  \throws Invalid_input also when a value is missing.
  */
  Feasibility_d operator()(const std::vector<Constraint_system_d::Domain>& domain,
                           const std::vector<std::pair<Power_polynomial, Relation>>& constraints,
                           const Elementary_values& values) const
  {
    return values.all().empty() ? (*this)(domain, constraints)
                                : internal::feasibility_with_values(domain, constraints, values, m_options);
  }

  //! the same of formulas in the unknowns of one call of `unknowns()`.
  //! \throws Invalid_input as `make_system()`, or with functions as `elementary_constraints()`.
  Feasibility_d operator()(std::span<const Constraint> constraints) const;
};

//! \ingroup PkgSplineConstraintsDSolver
//! whether the constraints of a system can be satisfied, see `Feasibility_solver_d`.
inline Feasibility_d find_feasible_point(const Constraint_system_d& system,
                                         const Solver_options& options = {.tolerance = 1e-6})
{
  return Feasibility_solver_d(options)(system);
}

/*!
\ingroup PkgSplineConstraintsDSolver
whether constraints written as formulas can be satisfied: `find_feasible_point(x*x + y*y <= 1, x + y > 1)`.
\throws Invalid_input as `Feasibility_solver_d`.
*/
template <std::same_as<Constraint>... Constraints>
Feasibility_d find_feasible_point(const Constraint& first, const Constraints&... others)
{
  const std::array<Constraint, 1 + sizeof...(others)> constraints{first, others...};
  return Feasibility_solver_d()(std::span<const Constraint>(constraints));
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Feasibility_d
Feasibility_solver_d::operator()(std::span<const Constraint> constraints) const
{
  if (std::ranges::any_of(constraints, &Constraint::has_elementary_functions)) {
    const Elementary_constraints all = elementary_constraints(constraints);
    return (*this)(all.domain, all.constraints, all.values);
  }
  const Unknown_domains domain = common_domains(constraints);
  Constraint_system_d splines(domain);
  std::vector<std::pair<Power_polynomial, Relation>> polynomials;
  for (const Constraint& constraint : constraints) {
    bool is_polynomial = constraint.conditions.empty();
    for (const int v : constraint.function.variables())
      is_polynomial = is_polynomial && v < splines.dimension();
    if (is_polynomial)
      polynomials.emplace_back(constraint.function, constraint.relation);
    else
      splines.add(constraint);
  }
  return internal::feasibility_of(splines, polynomials, m_options);
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_FEASIBILITY_SOLVER_D_H
