// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PROPAGATION_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PROPAGATION_SEARCH_H

#include <CGAL/Spline_constraints_d/internal/Parallel_loop.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Block_order.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Depth_first_propagation.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Determining_unknowns.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Krawczyk_test.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Sparse_system.h>
#include <CGAL/Spline_constraints_d/solver/internal/propagation/Waiting_boxes.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
All solutions in a box, in rounds: some of the boxes that wait, the smallest ones, are looked at independently of each
other, each with its parts up to a number of nodes. Between the rounds, in the order of the boxes, roots are collected,
each once, and what is left waits for later rounds. So the answer does not depend on the number of threads.

Slices make boxes narrower, and each takes many times as long: whether that pays is tried out now and then, by looking
at some boxes both ways for as long, counted in nodes.
*/
class Propagation_search
{
  const Sparse_system& m_system;
  Block_order m_blocks;
  Determining_unknowns m_determining;
  const Solver_options& m_options;
  Run_control& m_control;
  Parallel_loop m_loop;
  std::vector<std::unique_ptr<Depth_first_propagation>> m_workers; // per slot of the threads
  Waiting_boxes m_waiting;
  double m_tolerance;
  bool m_uses_slices = false;
  std::size_t m_next_trial = 8192; // when so many nodes were looked at
  std::vector<Proved_root> m_roots;
  std::vector<Box_of_ranges> m_undecided, m_rest;
  std::size_t m_nodes = 0;
  Undecided_reason m_reason = Undecided_reason::NONE;

public:
  Propagation_search(const Sparse_system& system, const Solver_options& options, Run_control& control,
                     const Parallel_loop& loop)
    : m_system(system), m_blocks(system), m_determining(system, m_blocks), m_options(options), m_control(control),
      m_loop(loop), m_tolerance(options.tolerance)
  {}

  // Looks at all of a box.
  void run(const Box_of_ranges& domain)
  {
    begin(domain);
    if (!advance(m_options.node_limit))
      end(Undecided_reason::NODES);
  }

  // The box is to be looked at.
  void begin(const Box_of_ranges& domain) { m_waiting.push(domain, {-1, 0}); }

  // These boxes are to be looked at, and nothing else any more.
  void replace_waiting(const std::vector<Box_of_ranges>& boxes)
  {
    m_waiting = Waiting_boxes();
    const int depth = static_cast<int>(std::ceil(std::log2((std::max)(boxes.size(), std::size_t(1)))));
    for (const Box_of_ranges& box : boxes)
      m_waiting.push(box, {-1, depth});
  }

  // Until no box waits, or so many were looked at in all (0: any number); whether it has ended, by a limit of the run,
  // too.
  bool advance(std::size_t most_nodes)
  {
    while (!m_waiting.is_empty()) {
      if (most_nodes > 0 && m_nodes >= most_nodes)
        return false;
      collect(outcomes_of_round(tasks_of_round(most_nodes > 0 ? most_nodes - m_nodes : 0)));
      if (m_control.must_stop(true)) {
        end(m_control.reason());
        return true;
      }
    }
    return true;
  }

  // Leaves all that waits.
  void end(Undecided_reason reason)
  {
    m_reason = reason;
    while (!m_waiting.is_empty())
      m_waiting.pop(m_rest.emplace_back());
  }

  const Block_order& blocks() const { return m_blocks; }
  // Different ones, each the only one in its region; not all of them need lie in the box.
  std::vector<Proved_root>& roots() { return m_roots; }
  // Boxes at the tolerance.
  const std::vector<Box_of_ranges>& undecided() const { return m_undecided; }
  // Boxes that were not looked at, because of a limit.
  const std::vector<Box_of_ranges>& rest() const { return m_rest; }
  Undecided_reason reason() const { return m_reason; }
  std::size_t nodes() const { return m_nodes; }

private:
  // A box, and how it is looked at.
  struct Task
  {
    Waiting_boxes box;
    double share; // of the domain
    Propagation_limits limits;
  };

  std::vector<Task> tasks_of_round(std::size_t most_nodes);
  std::vector<Propagation_outcome> outcomes_of_round(const std::vector<Task>& tasks);
  static double expected_work(const Task& task, const Propagation_outcome& outcome);
  void collect(const std::vector<Propagation_outcome>& outcomes);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
// The boxes that wait last. As long as they are few, each is looked at only until there are more.
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Propagation_search::Task>
Propagation_search::tasks_of_round(std::size_t most_nodes)
{
  constexpr std::size_t most_tasks = 16, nodes_of_task = 64, nodes_of_few = 4;
  const std::size_t count = (std::min)(m_waiting.size(), most_tasks);
  std::vector<Task> result;
  Box_of_ranges box;
  for (std::size_t left = most_nodes; result.size() < count && (most_nodes == 0 || left > 0);) {
    std::size_t nodes = count == most_tasks ? nodes_of_task : nodes_of_few;
    if (most_nodes > 0) {
      nodes = (std::min)(nodes, left);
      left -= nodes;
    }
    const Waiting_boxes::Origin origin = m_waiting.pop(box);
    result.push_back({{}, Waiting_boxes::share_of(origin), {nodes, m_tolerance, m_uses_slices}});
    result.back().box.push(box, origin);
  }
  return result;
}

// What a task would take as a whole, if what is left of it is like what is done.
CGAL_SPLINE_CONSTRAINTS_INLINE double Propagation_search::expected_work(const Task& task,
                                                                        const Propagation_outcome& outcome)
{
  constexpr double least_share = 0x1p-20; // where nothing is done
  return static_cast<double>(outcome.nodes) / (std::max)(outcome.share / task.share, least_share);
}

// The first tasks of some rounds are done with slices and without; the better outcomes stay.
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Propagation_outcome>
Propagation_search::outcomes_of_round(const std::vector<Task>& tasks)
{
  constexpr std::size_t share_of_trials = 1024; // tasks that are done twice are few beside all that was done
  constexpr int largest_dimension = 64;
  constexpr double much = 0.25; // of the work: what few tasks take varies
  const bool is_trial = m_nodes >= m_next_trial && m_system.dimension() <= largest_dimension;
  const std::size_t trials = is_trial ? (std::min)(tasks.size(), m_nodes / share_of_trials) : 0;
  std::vector<Propagation_outcome> result(tasks.size()), others(trials);
  m_workers.resize((std::max)(m_workers.size(), m_loop.slots()));
  m_loop(tasks.size() + trials, [&](std::size_t i, std::size_t slot) {
    const Upward_rounding_guard guard;
    const Mpfr_precision_scope precision(m_options.precision);
    std::unique_ptr<Depth_first_propagation>& worker = m_workers[slot];
    if (worker == nullptr)
      worker = std::make_unique<Depth_first_propagation>(m_system, m_blocks, m_determining, m_control);
    const Task& task = tasks[i < trials ? i : i - trials];
    Propagation_limits limits = task.limits;
    limits.uses_slices = limits.uses_slices != (i < trials);
    (i < trials ? others[i] : result[i - trials]) = (*worker)(task.box, limits);
  });
  if (!is_trial)
    return result;
  double work = 0, other_work = 0;
  for (std::size_t i = 0; i < trials; ++i) {
    const double own = expected_work(tasks[i], result[i]), other = expected_work(tasks[i], others[i]);
    work += own;
    other_work += other;
    if (other < own)
      std::swap(result[i], others[i]);
    m_nodes += others[i].nodes;
  }
  if (other_work < much * work)
    m_uses_slices = !m_uses_slices;
  m_next_trial = 4 * m_nodes;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Propagation_search::collect(const std::vector<Propagation_outcome>& outcomes)
{
  for (const Propagation_outcome& outcome : outcomes) {
    m_nodes += outcome.nodes;
    m_control.add_progress(outcome.share);
    for (const Proved_root& root : outcome.roots)
      add_unless_known(root, m_roots);
    for (const Box_of_ranges& box : outcome.undecided) {
      m_undecided.push_back(box);
      if (m_undecided.size() % m_options.coarsening_step == 0)
        m_tolerance *= 2;
    }
  }
  for (auto outcome = outcomes.rbegin(); outcome != outcomes.rend(); ++outcome)
    m_waiting.push(outcome->waiting);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_PROPAGATION_SEARCH_H
