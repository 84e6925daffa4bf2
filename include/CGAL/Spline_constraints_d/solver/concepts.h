// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CONCEPTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CONCEPTS_H

#include <CGAL/Spline_constraints_d/number/concepts.h>
#include <CGAL/Spline_constraints_d/solver/Linear_enclosure.h>
#include <CGAL/Spline_constraints_d/solver/Local_box.h>
#include <CGAL/Spline_constraints_d/solver/Node_view.h>
#include <CGAL/Spline_constraints_d/solver/Visitor_reference.h>

#include <concepts>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

//! \ingroup PkgSplineConstraintsDConcepts
//! proves that a node holds at most one solution.
template <class T>
concept TerminationTest =
  std::default_initializable<T> && requires(T test, Node_view& node, const Linear_enclosure& linear) {
    { test.has_at_most_one_solution(node, linear) } -> std::convertible_to<bool>;
  };

//! \ingroup PkgSplineConstraintsDConcepts
//! shrinks the box of a node without losing a solution.
template <class T>
concept Reduction =
  std::default_initializable<T> && requires(T reduction, Node_view& node, Linear_enclosure& linear, Local_box& box) {
    { reduction.contract(node, linear, box) } -> std::convertible_to<bool>;
  };

//! \ingroup PkgSplineConstraintsDConcepts
//! rates the axes of a node for the next split.
  template <class T>
  concept Splitter = std::default_initializable<T> &&
      requires(T splitter, Node_view& node, const std::vector<double>& widths, std::vector<double>& rating)
  {
    splitter.rate(node, widths, rating);
  };

//! \ingroup PkgSplineConstraintsDConcepts
//! bundles the number type and the policies of a solver.
template <class T>
concept ConstraintSolverTraits =
  SplineNumberType<typename T::Number_type> && TerminationTest<typename T::Termination_test> &&
  Reduction<typename T::Reduction> && Splitter<typename T::Splitter> && requires {
    { T::tracks_rounding } -> std::convertible_to<bool>;
  };

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_CONCEPTS_H
