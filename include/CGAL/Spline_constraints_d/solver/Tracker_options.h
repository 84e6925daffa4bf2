// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_TRACKER_OPTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_TRACKER_OPTIONS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver
Options of a `Constraint_tracker`.
*/
struct Tracker_options
{
  //! \f$\rho \in (0,2]\f$: how far a step of the relaxation goes, 1 to where the tangent of the constraint is zero.
  double relaxation = 1;

  //! \f$\delta > 0\f$: how much farther it goes, relative to half of the widest range of the unknowns. At one time,
  //! four steps each go by \f$\delta\f$, \f$\delta/4\f$, \f$\delta/16\f$ and \f$\delta/64\f$, again and again: small
  //! regions are jumped over by large ones, and narrow corners are not left by small ones.
  double offset = 0x1p-8;

  //! steps of the relaxation at one time.
  std::size_t most_steps = 64;

  //! of `Feasibility_solver_d`, which is asked where relaxation does not help. Its limits, and its visitor, are for one
  //! time.
  Solver_options search = {.tolerance = 1e-6, .node_limit = 2000};

  //! whether it is asked.
  bool is_search_allowed = true;

  //! \throws Invalid_input when a value makes no sense.
  void check() const
  {
    if (!(relaxation > 0 && relaxation <= 2))
      throw Invalid_input("Tracker_options: the relaxation must lie between 0, excluded, and 2");
    if (!(offset > 0) || !std::isfinite(offset))
      throw Invalid_input("Tracker_options: the offset must be positive and finite");
    search.check();
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_TRACKER_OPTIONS_H
