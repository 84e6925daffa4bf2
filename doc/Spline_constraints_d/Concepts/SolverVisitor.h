// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `SolverVisitor` describes who watches a run of the solver and may stop it. The solver calls it from one
thread at a time, about once every 32 nodes, and before what may take long. Both functions may throw; the exception
leaves the solver.

The language concept of the same name in `CGAL/Spline_constraints_d/solver/concepts.h` checks what a compiler can check.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::Default_solver_visitor}
\cgalHasModelsEnd
*/
class SolverVisitor
{
public:
  //! is told about every 50 ms which share of the domain is done, in [0,1]: the volume in halves of halves, which says
  //! little about the time that is left.
  void on_progress(double fraction);

  //! `true` stops the solver. The boxes that have not been looked at are reported as undecided, for the reason
  //! `CGAL::Spline_constraints::Undecided_reason::STOPPED`.
  bool stop();
};
