// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `Splitter` describes the choice of the axis along which a box of the subdivision is split.

The solver splits the axis with the largest rating among those that are wider than the tolerance and have a coordinate
between their ends; of axes that are rated alike up to
\f$10^{-9}\f$, the one that is wider relative to the domain. A splitter cannot make an answer wrong. It makes the solver
slow, or stops it at the tolerance with more boxes than necessary, when it neglects the axes that matter.

The language concept of the same name in `CGAL/Spline_constraints_d/solver/concepts.h` checks what a compiler can check.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::Smear_splitter}
\cgalHasModels{CGAL::Spline_constraints::Widest_splitter}
\cgalHasModelsEnd

\sa `CGAL::Spline_constraints::Solver_traits`
*/
class Splitter
{
public:
  //! default constructor.
  Splitter();

  /*!
  writes a rating of every axis.
  \param node the functions of the system on the box, in the local coordinates \f$s \in [-1/2,1/2]^n\f$.
  \param widths the width of the box per axis, divided by that of the part of the domain the subdivision began with (the
  domain, or the cell between the breaks of the splines).
  \param rating receives one number per axis, none of them NaN; it may have any size and content before.
  */
  void rate(Node_view& node, const std::vector<double>& widths, std::vector<double>& rating);
};
