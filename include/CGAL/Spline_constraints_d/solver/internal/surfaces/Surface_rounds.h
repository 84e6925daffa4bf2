// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_ROUNDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_ROUNDS_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_findings.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Surface_subdivision.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Subdivides cells in rounds of tasks, which know nothing of each other but what was known before the round: so the answer
does not depend on how many of them run at the same time. Afterwards the cuts of arcs that several tasks have are put
together. Where their order along an arc is not certain, the later task is the first one of the next round.
*/
template <class Traits, class Concurrency_tag>
class Surface_rounds
{
  const Constraint_system_d& m_system;
  Exact_ranges m_domain;
  const std::vector<Exact_ranges>& m_cells;
  const std::vector<double>& m_widths;
  const Solver_options& m_options;
  Run_control& m_control;
  Surface_findings& m_found;
  std::vector<Known_cones> m_cones; // per cell
  std::vector<Surface_task> m_tasks;

  // What one thread uses again for tasks of the same cell.
  struct Slot
  {
    std::size_t cell;
    Summary summary;
    Surface_subdivision<Traits> subdivision;

    Slot(const Surface_rounds& own, std::size_t c)
      : cell(c), subdivision(own.m_system, own.m_cells[c], own.m_widths, own.m_options, own.m_control, summary)
    {}
  };
  std::vector<std::unique_ptr<Slot>> m_slots;

public:
  Surface_rounds(const Constraint_system_d& system, const std::vector<Exact_ranges>& cells,
                 const std::vector<double>& widths, const Solver_options& options, Run_control& control,
                 Surface_findings& found)
    : m_system(system), m_domain(domain_of(system)), m_cells(cells), m_widths(widths), m_options(options),
      m_control(control), m_found(found), m_cones(cells.size()), m_slots(slots_of<Concurrency_tag>())
  {}

  void operator()(std::vector<Surface_task> tasks)
  {
    m_tasks = std::move(tasks);
    for (bool is_first = true; !m_tasks.empty(); is_first = false) {
      const std::size_t left = nodes_left();
      if (left == 0 || m_control.must_stop(true))
        return give_up(left == 0 ? Undecided_reason::NODES : m_control.reason());
      run_round({splits(is_first), (std::max)(left / m_tasks.size(), std::size_t(1))});
    }
  }

private:
  // Small problems are over after the first round; the next ones make enough tasks.
  std::size_t splits(bool is_first) const
  {
    constexpr std::size_t enough_tasks = 16, first = 12, few = 4, many = 64;
    return m_tasks.size() >= enough_tasks ? many : is_first ? first : few;
  }

  std::size_t nodes_left() const
  {
    constexpr std::size_t no_limit = std::size_t(1) << 60;
    return m_options.node_limit == 0 ? no_limit
                                     : m_options.node_limit - (std::min)(m_options.node_limit, m_found.summary.nodes);
  }

  void run_round(const Task_budget& budget)
  {
    const std::vector<Surface_task> tasks = std::exchange(m_tasks, {});
    // begins with those that seem to have most of the surfaces
    std::vector<std::size_t> order(tasks.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t k) { return tasks[i].arcs.size() > tasks[k].arcs.size(); });
    const std::vector<Known_cones> before = m_cones;
    const std::size_t undecided = m_found.undecided.size();
    std::vector<std::unique_ptr<Task_findings>> found(tasks.size());
    parallel_for<Concurrency_tag>(tasks.size(), [&](std::size_t place, std::size_t slot) {
      const std::size_t i = order[place];
      [[maybe_unused]] const typename Number_traits<typename Traits::Number_type>::Rounding_guard guard;
      [[maybe_unused]] const Mpfr_precision_scope precision(m_options.precision);
      found[i] = std::make_unique<Task_findings>(Arc_part(m_found.arcs, tasks[i].arcs));
      subdivision(tasks[i].cell, slot)
          .run(tasks[i], budget,
               {m_domain, m_found.open_parts, m_found.touching, m_found.changed_faces, before[tasks[i].cell], undecided,
                i},
               *found[i]);
    });
    std::vector<Surface_task> again;
    for (std::size_t i = 0; i < tasks.size(); ++i)
      if (!m_found.take(*found[i]))
        again.push_back(tasks[i]);
      else {
        m_cones[tasks[i].cell].learn(found[i]->cones, before[tasks[i].cell]);
        std::move(found[i]->pending.begin(), found[i]->pending.end(), std::back_inserter(m_tasks));
      }
    m_tasks.insert(m_tasks.begin(), again.begin(), again.end());
    parallel_for<Concurrency_tag>(found.size(), [&](std::size_t i, std::size_t) { found[i].reset(); });
  }

  Surface_subdivision<Traits>& subdivision(std::size_t cell, std::size_t slot)
  {
    std::unique_ptr<Slot>& own = m_slots[slot];
    if (!own || own->cell != cell)
      own = std::make_unique<Slot>(*this, cell);
    return own->subdivision;
  }

  void give_up(Undecided_reason reason)
  {
    for (Surface_task& task : std::exchange(m_tasks, {}))
      m_found.undecided.push_back({std::move(task.box), std::move(task.arcs), reason});
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_SURFACE_ROUNDS_H
