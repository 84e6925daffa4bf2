// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `TerminationTest` describes a proof that a box of the subdivision holds at most one solution of the
equalities, so that the solver can stop subdividing it and look for that solution.

The solver makes one object per run and asks it about a node when the node's linear enclosure has an inverse and its
Newton image lies within the node but is too wide to try a certification without being asked. Whatever the answer, a
solution is reported as certified only after the contraction test on its own box: the test decides how early the solver
tries, not what counts as proved. An object may keep scratch memory between calls.

The language concept of the same name in `CGAL/Spline_constraints_d/solver/concepts.h` checks what a compiler can check.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::Graph_box_test}
\cgalHasModels{CGAL::Spline_constraints::Normal_cone_test}
\cgalHasModelsEnd

\sa `CGAL::Spline_constraints::Solver_traits`
*/
class TerminationTest
{
public:
  //! default constructor.
  TerminationTest();

  /*!
  whether the node is proved to hold at most one solution of the equalities; `false` says nothing.
  \param node the functions of the system on the box, in the local coordinates \f$s \in [-1/2,1/2]^n\f$. Its bounds hold
  in exact arithmetic; what the test computes
              from them has to allow for its own rounding, in any rounding mode.
  \param linear the linear enclosure of the equalities on the box, after
  `CGAL::Spline_constraints::Linear_enclosure::precondition()`.
  */
  bool has_at_most_one_solution(Node_view& node, const Linear_enclosure& linear);
};
