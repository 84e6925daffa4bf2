// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VISITOR_REFERENCE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VISITOR_REFERENCE_H

#include <concepts>
#include <type_traits>

namespace CGAL {
namespace Spline_constraints {

//! \ingroup PkgSplineConstraintsDConcepts
//! watches a run of the solver and may stop it.
template <class T>
concept SolverVisitor = requires(T visitor, double fraction) {
  visitor.on_progress(fraction);
  { visitor.stop() } -> std::convertible_to<bool>;
};

/*!
\ingroup PkgSplineConstraintsDSolver

The visitor that watches nothing and never stops the solver.
*/
struct Default_solver_visitor
{
  //! is called about every 50 ms with the share of the domain that is done, in [0,1].
  void on_progress(double) {}

  //! is asked often; the solver stops when it returns `true`.
  bool stop() const { return false; }
};

/*!
\ingroup PkgSplineConstraintsDSolver

Refers to a visitor, which has to outlive it, or to none; so options hold visitors of all types.

\cgalModels{SolverVisitor}
*/
class Visitor_reference
{
  void* m_visitor = nullptr;
  void (*m_on_progress)(void*, double) = nullptr;
  bool (*m_stop)(void*) = nullptr;

public:
  //! refers to no visitor: nothing is watched, and nothing stops the run.
  Visitor_reference() = default;

  //! refers to this visitor.
  template <SolverVisitor Visitor>
  requires(!std::same_as<Visitor, Visitor_reference> && !std::is_const_v<Visitor>)
  Visitor_reference(Visitor& visitor)
    : m_visitor(&visitor),
      m_on_progress([](void* v, double fraction) { static_cast<Visitor*>(v)->on_progress(fraction); }),
      m_stop([](void* v) { return static_cast<bool>(static_cast<Visitor*>(v)->stop()); })
  {}

  //! tells the visitor of the progress.
  void on_progress(double fraction) const
  {
    if (m_visitor != nullptr)
      m_on_progress(m_visitor, fraction);
  }

  //! asks the visitor whether to stop.
  bool stop() const { return m_visitor != nullptr && m_stop(m_visitor); }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_VISITOR_REFERENCE_H
