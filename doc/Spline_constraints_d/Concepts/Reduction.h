// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `Reduction` describes a way to shrink a box of the subdivision without losing a solution.

The solver makes one object per run and calls it once per node, after no equality and no inequality has excluded the
node by its bounds alone. What is left is used in two ways: a node that keeps at most 70 % of its volume, counting the
axes that lose at least a tenth of their width, is replaced by what is left of it; and solutions are only looked for
there. A wrong reduction loses solutions. An object may keep scratch memory between calls.

The language concept of the same name in `CGAL/Spline_constraints_d/solver/concepts.h` checks what a compiler can check.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::No_reduction}
\cgalHasModels{CGAL::Spline_constraints::Projected_polyhedron_reduction}
\cgalHasModels{CGAL::Spline_constraints::Preconditioned_reduction}
\cgalHasModelsEnd

\sa `CGAL::Spline_constraints::Solver_traits`
*/
class Reduction
{
public:
  //! default constructor.
  Reduction();

  /*!
  makes `box` smaller, such that no solution in the node is outside of it; `false` when the node is proved to hold no
  solution, and then `box` does not matter.
  \param node the functions of the system on the box, in the local coordinates \f$s \in [-1/2,1/2]^n\f$. Its bounds hold
  in exact arithmetic; what the reduction
              computes from them has to allow for its own rounding, in any rounding mode.
  \param linear the linear enclosure of the equalities on the node, after
  `CGAL::Spline_constraints::Linear_enclosure::precondition()`.
  \param box the part of the node to shrink, in local coordinates; the whole node when the solver calls.
  `CGAL::Spline_constraints::Local_box::intersect()` is made for it.
  */
  bool contract(Node_view& node, Linear_enclosure& linear, Local_box& box);
};
