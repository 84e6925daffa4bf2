// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLVER_OPTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLVER_OPTIONS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Visitor_reference.h>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

Options of the solver, and of all operations that can take long, to be used with designated initialisers. Limits are
for the whole operation, however many systems it solves. When one is reached, or the visitor stops the run, what has
been found is the answer, and the rest is reported as undecided: `is_complete()` is false.
*/
struct Solver_options
{
  //! a box that is narrower than `tolerance * max(1, |x|)` on all axes and still undecided is not split any further.
  //! Certified solutions do not depend on it: they are refined to the full precision of their coordinates.
  double tolerance = 1e-10;

  //! seconds after which what is left is reported as undecided; 0: none.
  double time_limit = 0;

  //! number of nodes after which what is left is reported as undecided; 0: none.
  std::size_t node_limit = 0;

  //! bits after the binary point that enclosures with rational coordinates aim at, and the precision of multiprecision
  //! numbers; at most 900.
  int precision = 128;

  //! the precision up to which `Certified_solver_traits` climbs for boxes that doubles cannot decide, in bits; below
  //! 128: it does not climb; 0: nor does it look for irrational double roots. At most 900.
  int ladder_precision = 256;

  //! whenever so many boxes have ended at the tolerance, the tolerance grows: a continuum of solutions is covered, not
  //! resolved.
  std::size_t coarsening_step = 2048;

  //! is told of the progress, and can stop the run: `{.visitor = my_visitor}` refers to a model of `SolverVisitor`. It
  //! is called by one thread at a time. An operation that solves several systems tells the share of the one in hand.
  Visitor_reference visitor = {};

  //! \throws Invalid_input when a value makes no sense.
  void check() const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Solver_options::check() const
{
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw Invalid_input("Solver_options: the tolerance must be positive and finite");
  if (!(time_limit >= 0))
    throw Invalid_input("Solver_options: the time limit must not be negative");
  if (precision < 32 || precision > 900)
    throw Invalid_input("Solver_options: the precision must lie between 32 and 900 bits");
  if (ladder_precision < 0 || ladder_precision > 900)
    throw Invalid_input("Solver_options: the ladder's precision must lie between 0 and 900 bits");
  if (coarsening_step == 0)
    throw Invalid_input("Solver_options: the coarsening step must be positive");
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLVER_OPTIONS_H
