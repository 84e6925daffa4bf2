// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_RUN_CONTROL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_RUN_CONTROL_H

#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Round_distribution.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Search_in_turns.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Is thrown where a run ends from outside and no part of an answer could be told; operations catch it and return an
// answer of which all is undecided.
struct Run_stopped
{
  Undecided_reason reason;
};

/*
What ends a run from outside, the clock and the visitor, for all threads of the run. The visitor is called by one of
them at a time. It is a model of `SolverVisitor` itself, for runs that are a part of this one.
*/
class Run_control
{
  using Clock = std::chrono::steady_clock;

  Visitor_reference m_visitor;
  Clock::time_point m_start = Clock::now(), m_last_report = m_start;
  double m_time_limit;
  std::atomic<Undecided_reason> m_reason = Undecided_reason::NONE;
  std::mutex m_mutex;
  double m_done = 0;
  Round_distribution* m_distribution = nullptr;
  Search_in_turns* m_turns = nullptr;

public:
  explicit Run_control(const Solver_options& options, Round_distribution* distribution = nullptr)
    : m_visitor(options.visitor), m_time_limit(options.time_limit), m_distribution(distribution)
  {}

  // Other processes that take part; null: none.
  Round_distribution* distribution() const { return m_distribution; }

  // The subdivision that is done now takes turns with something else; null: it does not.
  Search_in_turns* turns() const { return m_turns; }
  void set_turns(Search_in_turns* turns) { m_turns = turns; }

  // Why the run was stopped, if it was.
  Undecided_reason reason() const { return m_reason.load(std::memory_order_relaxed); }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - m_start).count(); }

  void add_progress(double share);

  // The share that is told is that of the part in hand.
  void begin_part()
  {
    const std::lock_guard lock(m_mutex);
    m_done = 0;
  }

  // `is_asked`: looks at the clock and asks the visitor, which is not done for every node.
  bool must_stop(bool is_asked);

  // Asks the visitor as often as for boxes that take as long as what comes next, so that one which counts how often it
  // is asked knows how much work is done.
  void charge(std::size_t boxes)
  {
    for (std::size_t i = 0; i < boxes && !must_stop(true); ++i) {
    }
  }

  // For work without an answer before it has ended: throws Run_stopped when the run ends here.
  void check()
  {
    if (must_stop(true))
      throw Run_stopped{reason()};
  }

  bool stop() { return must_stop(true); }
  void on_progress(double) {}

  // Options of runs that are a part of this one.
  Solver_options options_of_parts(const Solver_options& options);

private:
  // A visitor that throws ends the run, too, wherever that is caught: operations watch the systems they solve so.
  bool is_stopped_by_visitor();

  void ask();
};

// The summary of a run of so many nodes that was ended for a reason, or for none: what is undecided then is too small
// for the numbers.
Summary summary_of(const Run_control& run, std::size_t nodes, Undecided_reason reason, bool is_complete);

// What is left of the limits after some work, a little at least: zero would be no limit.
Solver_options rest_of(const Solver_options& options, const Summary& work);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Run_control::add_progress(double share)
{
  if (share > 0) {
    const std::lock_guard lock(m_mutex);
    m_done = (std::min)(m_done + share, 1.0);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Run_control::must_stop(bool is_asked)
{
  if (is_asked && reason() == Undecided_reason::NONE)
    ask();
  return reason() != Undecided_reason::NONE;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Solver_options Run_control::options_of_parts(const Solver_options& options)
{
  Solver_options result = options;
  result.time_limit = 0;
  result.visitor = *this;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Run_control::is_stopped_by_visitor()
{
  try {
    return m_visitor.stop();
  } catch (...) {
    m_reason = Undecided_reason::STOPPED;
    throw;
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Run_control::ask()
{
  const std::lock_guard lock(m_mutex);
  if (reason() != Undecided_reason::NONE) // another thread was told while this one waited
    return;
  const Clock::time_point now = Clock::now();
  if (m_time_limit > 0 && now - m_start >= std::chrono::duration<double>(m_time_limit))
    m_reason = Undecided_reason::TIME;
  else if (is_stopped_by_visitor())
    m_reason = Undecided_reason::STOPPED;
  else if (now - m_last_report > std::chrono::milliseconds(50)) {
    m_last_report = now;
    m_visitor.on_progress(m_done);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Summary summary_of(const Run_control& run, std::size_t nodes, Undecided_reason reason,
                                                  bool is_complete)
{
  Summary result;
  result.nodes = nodes;
  result.seconds = run.seconds();
  result.is_complete = is_complete;
  if (!is_complete)
    result.why_not = reason == Undecided_reason::NONE ? Undecided_reason::TOLERANCE : reason;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Solver_options rest_of(const Solver_options& options, const Summary& work)
{
  Solver_options result = options;
  if (options.time_limit > 0)
    result.time_limit = (std::max)(options.time_limit - work.seconds, 1e-9);
  if (options.node_limit > 0)
    result.node_limit = work.nodes < options.node_limit ? options.node_limit - work.nodes : 1;
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_RUN_CONTROL_H
