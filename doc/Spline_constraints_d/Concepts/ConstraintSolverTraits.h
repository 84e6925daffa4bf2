// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgSplineConstraintsDConcepts
\cgalConcept

The concept `ConstraintSolverTraits` bundles what `CGAL::Spline_constraints::Subdivision_solver_d` is made of: the
number type it subdivides with and its three policies.

`CGAL::Spline_constraints::Solver_traits` is a model for any choice of the four. The models with a name of their own are
`CGAL::Spline_constraints::Fast_solver_traits`, `CGAL::Spline_constraints::Certified_solver_traits` (the default),
`CGAL::Spline_constraints::Interval_solver_traits`, `CGAL::Spline_constraints::Multiprecision_solver_traits` and
`CGAL::Spline_constraints::Exact_solver_traits`. The user manual says what each of them proves.

The language concept of the same name in `CGAL/Spline_constraints_d/solver/concepts.h` checks all that is below.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_constraints::Solver_traits<Number\, Test\, Reduce\, Split\, tracks_rounding>}
\cgalHasModelsEnd
*/
class ConstraintSolverTraits
{
public:
  //! the number type of the Bernstein coefficients, a model of `SplineNumberType`. Its traits also decide the type of
  //! the coordinates of boxes.
  typedef unspecified_type Number_type;

  //! a model of `TerminationTest`.
  typedef unspecified_type Termination_test;

  //! a model of `Reduction`.
  typedef unspecified_type Reduction;

  //! a model of `Splitter`.
  typedef unspecified_type Splitter;

  //! whether the policies see the error bounds of the coefficients. With `false` they see coefficients that pass for
  //! exact, and nothing is proved where rounding matters.
  static constexpr bool tracks_rounding = true;
};
