// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEWTON_IMPROVEMENT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEWTON_IMPROVEMENT_H

#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Newton_result.h>
#include <CGAL/Spline_constraints_d/solver/internal/compiled_solvers.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/solver/internal/Newton_iteration.h>
#endif

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

Improves an approximate solution of the equalities of a system to the full precision of doubles by Newton-Raphson
iteration (\cgalCite{ek-gcs-01}, Section 2.2). With fewer equalities than unknowns each step is the shortest one to the
zero set of the linearised functions, by a rank-revealing complete orthogonal decomposition: the result is, up to second
order in the distance, the point of the solution set closest to the start.

This is a tool of approximation: *nothing is certified*, neither that a solution is near the result nor that the result
belongs to the start. It converges quadratically to regular solutions and linearly to others, as far as these are
reached at all; steps are halved until they lower the residual. Values and derivatives are exact and rounded once, so
that the last place of the result does not suffer from cancellation.

*Domain.* The point never leaves the domain: a start outside of it is moved to the nearest point of it, a step ends
coordinate by coordinate at the faces, and an unknown that is on a face from which the step points outward is held there
while the others make a shortest step of their own. Inequalities are not looked at. At a break of a spline the
derivative is the one from the right.

\param system its equalities, at most as many as unknowns, are to vanish.
\param start one finite number per unknown.
\param options when to stop.
\return the last point and what it is worth. Without equalities this is the start, moved into the domain.
\throws Invalid_input when there are more equalities than unknowns, the start has the wrong size or an entry that is not
finite, an option makes no sense, or there is no double in the domain of an unknown.

Complexity per step: an exact evaluation of each function with its derivatives, linear in its number of coefficients,
and \f$O(m^2 n)\f$ for \f$m\f$ equalities in \f$n\f$ unknowns.
*/
inline Newton_result improve_point(const Constraint_system_d& system, std::vector<double> start,
                                   const Newton_options& options = {})
{
  return internal::improved_point(system, std::move(start), options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_NEWTON_IMPROVEMENT_H
