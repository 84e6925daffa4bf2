// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SEARCH_CONTROL_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SEARCH_CONTROL_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>

#include <atomic>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
What ends an operation from outside, for all of its threads: the clock, the visitor, and the number of nodes, which are
the ranges of elements that are looked at. Where it ends, Run_stopped is thrown: by the search along an element, which
keeps what it has found, or before it, where nothing has been.
*/
class Search_control
{
  static constexpr int fine_precision = 128;   // of the level above doubles
  static constexpr double grace = 0.1;         // seconds

  Run_control m_run;
  Solver_options m_options;
  std::atomic<std::size_t> m_nodes = 0;
  std::atomic<bool> m_are_nodes_used_up = false;
  double m_end = 0;   // of the time for the search, in seconds, once that is known

public:
  explicit Search_control(const Solver_options& options) : m_run(options), m_options(options) { options.check(); }

  // Whether what doubles do not decide is tried on the level above.
  bool has_fine_level() const { return m_options.ladder_precision >= fine_precision; }

  // Why the operation was ended, if it was.
  Undecided_reason reason() const { return m_are_nodes_used_up ? Undecided_reason::NODES : m_run.reason(); }
  bool has_ended() const { return reason() != Undecided_reason::NONE; }

  // Asks the clock and the visitor.
  bool must_end() { return m_are_nodes_used_up || m_run.must_stop(true); }

  void check()
  {
    if (must_end())
      throw Run_stopped{reason()};
  }

  void add_node()
  {
    if (m_options.node_limit > 0 && m_nodes >= m_options.node_limit)
      m_are_nodes_used_up = true;
    if (has_ended())
      throw Run_stopped{reason()};
    ++m_nodes;
  }

  // Whether the time for the search has ended some while ago: then what has been found is not worked out any more. For
  // one thread, behind the search.
  bool is_overdue()
  {
    if (!m_run.must_stop(true))
      return false;
    if (m_end == 0)
      m_end = m_run.reason() == Undecided_reason::TIME ? m_options.time_limit : m_run.seconds();
    return m_run.seconds() > m_end + grace;
  }

  void add_progress(double share) { m_run.add_progress(share); }

  // Of an answer.
  Summary summary(bool is_complete) const { return summary_of(m_run, m_nodes, reason(), is_complete); }

  // Options for solvers of systems: these end with the operation, and have no limits of their own.
  class Watch
  {
    Search_control* m_control;

  public:
    explicit Watch(Search_control* control) : m_control(control) {}

    void on_progress(double) {}
    bool stop()
    {
      if (m_control != nullptr)
        m_control->check();
      return false;
    }

    Solver_options options() { return {.visitor = *this}; }
  };
};

// Asks a control every so often, where there is one: what is done between is small beside that.
class Regular_check
{
  Search_control* m_control;
  unsigned m_period, m_count = 0;

public:
  Regular_check(Search_control* control, unsigned period) : m_control(control), m_period(period) {}

  void operator()()
  {
    if (m_control != nullptr && ++m_count % m_period == 0)
      m_control->check();
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SEARCH_CONTROL_H
