// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLVER_TRAITS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLVER_TRAITS_H

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Number_traits.h>
#include <CGAL/Spline_constraints_d/solver/concepts.h>
#include <CGAL/Spline_constraints_d/solver/reductions.h>
#include <CGAL/Spline_constraints_d/solver/splitters.h>
#include <CGAL/Spline_constraints_d/solver/termination_tests.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSolver

What a solver is made of: the number type it subdivides with and its three policies.

\tparam tracks_rounding_ whether error bounds widen every test. Without, sign tests on rounded doubles can lose
solutions.

\cgalModels{ConstraintSolverTraits}
*/
template <SplineNumberType Number, TerminationTest Test = Graph_box_test, Reduction Reduce = Preconditioned_reduction,
          Splitter Split = Smear_splitter, bool tracks_rounding_ = true>
struct Solver_traits
{
  using Number_type = Number;
  using Termination_test = Test;
  using Reduction = Reduce;
  using Splitter = Split;
  static constexpr bool tracks_rounding = tracks_rounding_;
};

//! \ingroup PkgSplineConstraintsDSolver
//! plain doubles: the rounding of the subdivision is ignored, so solutions may be missed where it matters, and
//! `is_complete()` proves nothing. The solutions that are found are certified with all errors.
using Fast_solver_traits = Solver_traits<double, Graph_box_test, Preconditioned_reduction, Smear_splitter, false>;

//! \ingroup PkgSplineConstraintsDSolver
//! doubles with a bound on their rounding error, rebuilt from the exact functions where the bound becomes visible. The
//! default.
using Certified_solver_traits = Solver_traits<double>;

//! \ingroup PkgSplineConstraintsDSolver
//! intervals of doubles.
using Interval_solver_traits = Solver_traits<CGAL::Interval_nt<false>>;

//! \ingroup PkgSplineConstraintsDSolver
//! intervals of MPFR numbers of `Solver_options::precision` bits, boxes with rational corners.
using Multiprecision_solver_traits = Solver_traits<Mpfr_interval>;

//! \ingroup PkgSplineConstraintsDSolver
//! exact rationals, boxes with rational corners.
using Exact_solver_traits = Solver_traits<Exact_rational>;

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_SOLVER_TRAITS_H
