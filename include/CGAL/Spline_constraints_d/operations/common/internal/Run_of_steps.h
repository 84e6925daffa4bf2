// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_RUN_OF_STEPS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_RUN_OF_STEPS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

/*
The limits, and the visitor, of an operation that does not solve systems, or not only. What it does between two
questions whether it is to go on is a step, and counts as a node. For one thread.
*/
class Run_of_steps
{
  Solver_options m_options;
  Run_control m_control;
  std::size_t m_steps = 0;

public:
  //! \throws Invalid_input when an option makes no sense.
  explicit Run_of_steps(const Solver_options& options) : m_options(options), m_control(options) { m_options.check(); }

  // Why the run has ended, if it has.
  Undecided_reason reason() const
  {
    const bool is_out_of_steps = m_options.node_limit > 0 && m_steps > m_options.node_limit;
    return is_out_of_steps && m_control.reason() == Undecided_reason::NONE ? Undecided_reason::NODES
                                                                           : m_control.reason();
  }

  bool is_stopped() const { return reason() != Undecided_reason::NONE; }

  // Whether no further step is to be done; the visitor is asked no more once it is so.
  bool must_stop()
  {
    if (is_stopped())
      return true;
    ++m_steps;
    return m_control.must_stop(true) || is_stopped();
  }

  // \throws Run_stopped when no further step is to be done.
  void check()
  {
    if (must_stop())
      throw Run_stopped{reason()};
  }

  void add_progress(double share) { m_control.add_progress(share); }

  // Options for systems that are solved on the way, of which this is the visitor.
  Solver_options options_of_systems()
  {
    Summary work;
    work.nodes = m_steps;
    Solver_options result = rest_of(m_options, work);
    result.time_limit = 0;
    result.visitor = *this;
    return result;
  }

  void add_nodes(std::size_t nodes) { m_steps += nodes; }

  // As a visitor, of systems.
  void on_progress(double) {}
  bool stop() { return m_control.must_stop(true) || is_stopped(); }

  Summary summary(bool is_complete) const { return summary_of(m_control, m_steps, reason(), is_complete); }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_RUN_OF_STEPS_H
