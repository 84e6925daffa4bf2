// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_OPERATION_BUDGET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_OPERATION_BUDGET_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// The limits of an operation that solves several systems: those of time and nodes are for all systems together, that of
// time also for what is done between them. Copies share clock and visitor.
class Operation_budget
{
  Solver_options m_options;
  std::shared_ptr<Run_control> m_control;
  Summary m_total;

public:
  //! \throws Invalid_input when an option makes no sense.
  explicit Operation_budget(const Solver_options& options)
    : m_options(options), m_control(std::make_shared<Run_control>(options))
  {
    m_options.check();
  }

  // The options of the next system, with what is left of the limits.
  Solver_options remaining() const
  {
    Summary work = m_total;
    work.seconds = m_control->seconds();
    return rest_of(m_options, work);
  }

  // The same for a part of the operation that begins when others have taken so many nodes.
  Operation_budget after(std::size_t nodes) const
  {
    Summary work;
    work.nodes = nodes;
    Operation_budget result(*this);
    result.m_options.node_limit = rest_of(m_options, work).node_limit;
    return result;
  }

  void add(const Summary& work) { m_total += work; }
  const Summary& total() const { return m_total; }

  bool has_node_limit() const { return m_options.node_limit > 0; }
  bool has_reached_node_limit() const { return m_options.node_limit > 0 && m_total.nodes >= m_options.node_limit; }

  // For a few more nodes at most.
  void limit_nodes(std::size_t more)
  {
    const std::size_t limit = m_total.nodes + more;
    if (m_options.node_limit == 0 || limit < m_options.node_limit)
      m_options.node_limit = limit;
  }

  // Whether there is no time left or the visitor stops the run, so that systems need not be made.
  bool must_stop() const { return m_control->must_stop(true); }

  // Whether there are no nodes left, either.
  bool has_ended() const { return must_stop() || has_reached_node_limit(); }

  // Why the run has ended, if it has.
  Undecided_reason reason() const
  {
    return m_control->reason() == Undecided_reason::NONE && has_reached_node_limit() ? Undecided_reason::NODES
                                                                                     : m_control->reason();
  }

  // Since the operation began.
  double seconds() const { return m_control->seconds(); }

  // For work without an answer before it has ended: throws Run_stopped when the run ends here.
  void check() const { m_control->check(); }
};

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_OPERATION_BUDGET_H
