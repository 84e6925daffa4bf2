// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_SUBDIVISION_WALK_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_SUBDIVISION_WALK_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/Root_collection.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/common_components.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Run_control.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/cell_boxes.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Cell_pyramid.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Outcome_of_task.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/Subdivision.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/clusters.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The walk over the domain, in rounds. The tasks of a round are independent of each other: each is subdivided up to a
number of nodes, and what is left are tasks of the next round. Between the rounds, in the order of the tasks, roots are
collected, each once, and open boxes counted. So the answer does not depend on the number of threads.
*/
template <class Traits, class Concurrency_tag>
class Subdivision_walk
{
  using NT = typename Traits::Number_type;
  using Walk = Subdivision<Traits>;
  using Coordinate = typename Walk::Coordinate;
  using Task = typename Walk::Task;

  using Outcome = Outcome_of_task<Coordinate>;

  // What a thread needs for itself.
  struct Worker
  {
    Run_control& control;
    Exact_source source;
    Summary summary;
    Root_collection<NT> roots;
    Walk walk;

    Worker(const Constraint_system_d& system, const System_layout& layout, const Solver_options& options,
           Run_control& control, const std::vector<Found_root<Coordinate>>* known,
           const std::vector<Multiple_root>* known_multiple_roots, Run_control* control_of_source = nullptr)
      : control(control), source(system, layout, control_of_source),
        roots(system, layout, source, options.precision, known),
        walk(system, layout, source, options, control, roots, summary)
    {
      walk.set_known_multiple_roots(known_multiple_roots);
    }

    // A task that ends in the middle of a box is left as it is, with the roots that were found.
    Outcome run(const Task& task, const Task_limits& limits)
    {
      source.set_control(&control);
      try {
        walk.run(task, limits);
      } catch (const Run_stopped&) {
        walk.pending().push_back(task);
      }
      source.set_control(nullptr);
      return {std::exchange(roots.roots(), {}),
              std::exchange(walk.open_boxes(), {}),
              std::exchange(walk.curve_boxes(), {}),
              std::exchange(walk.pending(), {}),
              std::exchange(walk.multiple_roots(), {}),
              walk.looks(),
              walk.gains()};
    }
  };

  const Constraint_system_d& m_system;
  const System_layout& m_layout;
  const Solver_options& m_options;
  Run_control& m_control;
  Found_roots<Coordinate> m_roots;
  std::vector<Multiple_root> m_multiple_roots;
  Worker m_worker;   // of this thread
  std::vector<Open_box<Coordinate>> m_open, m_curve_boxes;
  std::map<Cell, std::optional<Common_cell>> m_common;   // of the cells that were looked at
  static constexpr std::size_t m_few_looks = 32;   // at C f, formed exactly, before they have to pay
  static constexpr std::size_t m_few_open = 64;    // boxes; more are the mark of a continuum
  std::size_t m_looks = 0, m_gains = 0;
  std::vector<std::unique_ptr<Worker>> m_workers;   // per slot of the threads

public:
  Subdivision_walk(const Constraint_system_d& system, const System_layout& layout, const Solver_options& options,
                   Run_control& control)
    : m_system(system), m_layout(layout), m_options(options), m_control(control),
      m_worker(system, layout, options, control, &m_roots.roots(), &m_multiple_roots, &control)
  {}

  Exact_source& source() { return m_worker.source; }
  Found_roots<Coordinate>& roots() { return m_roots; }
  std::vector<Open_box<Coordinate>>& open_boxes() { return m_open; }

  // Boxes that look like pieces of a curve of solutions.
  const std::vector<Open_box<Coordinate>>& curve_boxes() const { return m_curve_boxes; }

  // Multiple roots that were guessed and proved; one may be there several times, with different boxes.
  const std::vector<Multiple_root>& multiple_roots() const { return m_multiple_roots; }

  // Cells that the walk has left since the equalities have a common factor there; solutions that were certified there
  // stay among the roots.
  std::vector<Common_cell> common_cells() const
  {
    std::vector<Common_cell> result;
    for (const auto& [cell, common] : m_common)
      if (common)
        result.push_back(*common);
    return result;
  }

  bool is_common(const Cell& cell) const
  {
    const auto place = m_common.find(cell);
    return place != m_common.end() && place->second.has_value();
  }

  void run()
  {
    // The first round is short: it makes the tasks of the others, and ends where boxes become small and stay undecided.
    // Later ones are long beside the exact rebuild that each task starts with.
    constexpr std::size_t first_budget = 128, last_budget = 8192;
    std::vector<Task> tasks = tasks_of_cells();
    for (std::size_t budget = first_budget; !tasks.empty() && m_control.reason() == Undecided_reason::NONE;) {
      std::vector<Task> later = postponed(tasks);
      std::vector<Task_limits> limits = limits_of(tasks.size(), budget);
      if (budget == first_budget)
        for (Task_limits& limit : limits)
          limit.depth = deep_level();
      if (limits.front().nodes > 0) {
        const std::size_t before = nodes();
        tasks = collect(tasks, run_round(tasks, limits));
        if (m_control.turns() != nullptr)
          m_control.turns()->spend(nodes() - before);
      }
      if (are_degenerate_solutions_likely() && !m_control.must_stop(true)) {
        leave_common_cells(tasks);
        guess_multiple_roots(tasks);
      }
      std::move(later.begin(), later.end(), std::back_inserter(tasks));
      if (limits.front().nodes == 0 && !has_next_turn())
        break;
      budget = (std::min)(2 * budget, last_budget);
    }
    const Undecided_reason reason =
        m_control.reason() == Undecided_reason::NONE ? Undecided_reason::NODES : m_control.reason();
    for (const Task& task : tasks)
      m_open.push_back({task.lower, task.upper, reason, task.cell});
    merge_boxes_that_meet(m_open);
  }

  /*
  Looks again, with a finer tolerance, at the open boxes that `holds_solution(box)` does not know to hold one; those
  that turn out empty are dropped. Beside a root that is not regular some boxes end at the tolerance just before they
  would be excluded.
  */
  template <class Predicate>
  void look_again(const Predicate& holds_solution)
  {
    constexpr std::size_t budget = 10000;
    if (m_open.empty() || m_open.size() > m_few_open || m_control.reason() != Undecided_reason::NONE)
      return;
    Solver_options options = m_options;
    options.tolerance /= 4096;
    Worker worker(m_system, m_layout, options, m_control, &m_roots.roots(), &m_multiple_roots);
    std::vector<Open_box<Coordinate>> kept;
    for (Open_box<Coordinate>& box : m_open) {
      if (box.reason == Undecided_reason::TOLERANCE && !m_control.must_stop(true) &&
          !worker.walk.certification().crosses_break(box.cell, box.lower, box.upper) && !holds_solution(box)) {
        Outcome outcome = worker.run(Walk::make_task(box.cell, box.lower, box.upper, 0),
                                     {.nodes = budget, .looks = m_few_looks, .attempts = m_few_open, .open_before = 0});
        const bool is_decided = outcome.open.empty() && outcome.pending.empty();
        const bool are_counted = collect_roots(outcome.roots, box.cell, kept);
        std::move(outcome.multiple_roots.begin(), outcome.multiple_roots.end(), std::back_inserter(m_multiple_roots));
        std::move(outcome.curve_boxes.begin(), outcome.curve_boxes.end(), std::back_inserter(m_curve_boxes));
        if (is_decided && are_counted)
          continue;
      }
      kept.push_back(std::move(box));
    }
    m_open = std::move(kept);
    m_worker.summary = sum(m_worker.summary, worker.summary);
  }

  // Adds what all threads have counted.
  void add_to(Summary& summary)
  {
    summary = sum(summary, m_worker.summary);
    for (const auto& worker : m_workers)
      if (worker != nullptr)
        summary = sum(summary, worker->summary);
  }

private:
  static Summary sum(Summary a, const Summary& b)
  {
    a.nodes += b.nodes;
    a.restarts += b.restarts;
    a.depth = (std::max)(a.depth, b.depth);
    a.rebuild_seconds += b.rebuild_seconds;
    return a;
  }

  std::size_t nodes()
  {
    Summary summary;
    add_to(summary);
    return summary.nodes;
  }

  // One per cell of the grid of breaks.
  std::vector<Task> tasks_of_cells()
  {
    const auto domain = [&](int v) -> const auto& { return m_system.domain(v); };
    const std::vector<Cell> cells = possible_cells();
    std::vector<Task> tasks;
    for (const Cell& cell : cells) {
      const auto [part_lower, part_upper] = part_in_cell<Coordinate>(source(), cell, domain, m_options.precision);
      tasks.push_back(Walk::make_task(cell, part_lower, part_upper, 1.0 / static_cast<double>(cells.size())));
    }
    return tasks;
  }

  // In the order of the grid.
  std::vector<Cell> possible_cells()
  {
    if (!source().has_breaks())
      return {Cell(m_layout.dimension, 0)};
    std::vector<Cell> cells;
    Cell_pyramid(m_system, source().breaks(), &m_control).visit_possible_cells([&](const Cell& cell) {
      cells.push_back(cell);
    });
    std::sort(cells.begin(), cells.end());
    return cells;
  }

  // Takes the tasks that are not for this round. Where boxes stay open, as on a continuum, rounds are small: the number
  // of open boxes tells the next ones how coarse they may be.
  std::vector<Task> postponed(std::vector<Task>& tasks) const
  {
    constexpr std::size_t few_tasks = 8;
    std::vector<Task> later;
    if (m_open.size() > m_few_open && tasks.size() > few_tasks) {
      std::move(tasks.begin() + few_tasks, tasks.end(), std::back_inserter(later));
      tasks.resize(few_tasks);
    }
    return later;
  }

  // Boxes became small and stay undecided, or there are many.
  bool are_degenerate_solutions_likely()
  {
    constexpr std::size_t many_nodes = 1000;
    Summary summary;
    add_to(summary);
    return summary.depth > deep_level() || summary.nodes >= many_nodes || !m_open.empty();
  }

  // Takes what lies in cells where the equalities have a common factor out of the tasks and of the open boxes.
  void leave_common_cells(std::vector<Task>& tasks)
  {
    const auto is_common = [&](const auto& part) {
      if (!m_common.contains(part.cell) && m_control.must_stop(true))
        return false;
      const auto [place, is_new] = m_common.try_emplace(part.cell);
      if (is_new)
        place->second = common_cell(m_system, source().breaks(), part.cell);
      return place->second.has_value();
    };
    std::erase_if(tasks, is_common);
    std::erase_if(m_open, is_common);
    std::erase_if(m_curve_boxes, is_common);
  }

  // One of the boxes that are left may hold the multiple root that keeps the others open: the smaller, the easier to
  // guess.
  void guess_multiple_roots(const std::vector<Task>& tasks)
  {
    constexpr std::size_t most_guesses = 64;
    std::vector<const Task*> order;
    for (const Task& task : tasks)
      if (task.depth > 0)
        order.push_back(&task);
    std::stable_sort(order.begin(), order.end(), [](const Task* a, const Task* b) { return a->depth > b->depth; });
    order.resize((std::min)(order.size(), most_guesses));
    for (const Task* task : order)
      if (std::none_of(m_multiple_roots.begin(), m_multiple_roots.end(),
                       [&](const Multiple_root& root) { return root.covers(task->lower, task->upper); })) {
        m_worker.walk.guess_multiple_root(task->cell, task->lower, task->upper, task->domain_widths);
        std::move(m_worker.walk.multiple_roots().begin(), m_worker.walk.multiple_roots().end(),
                  std::back_inserter(m_multiple_roots));
        m_worker.walk.multiple_roots().clear();
      }
  }

  // Splits after which most boxes around regular roots are done.
  int deep_level() const { return 8 * (m_layout.dimension + 1); }

  // Of the limit, and of the turn.
  std::size_t nodes_left()
  {
    std::size_t result = (std::numeric_limits<std::size_t>::max)();
    if (m_options.node_limit > 0)
      result = m_options.node_limit - (std::min)(nodes(), m_options.node_limit);
    if (m_control.turns() != nullptr)
      result = (std::min)(result, m_control.turns()->nodes_left());
    return result;
  }

  // Whether it was the turn that has ended, and there is another one.
  bool has_next_turn() const
  {
    Search_in_turns* turns = m_control.turns();
    return turns != nullptr && turns->nodes_left() == 0 && turns->end_turn();
  }

  // The limits of the tasks of a round, which together keep to the node limit, and to the looks at C f and the attempts
  // that are left.
  std::vector<Task_limits> limits_of(std::size_t count, std::size_t budget)
  {
    const std::size_t all_looks = m_few_looks + 4 * m_gains, looks = m_looks < all_looks ? all_looks - m_looks : 0;
    const std::size_t attempts = m_open.size() < m_few_open ? m_few_open - m_open.size() + count - 1 : 0;
    std::vector<Task_limits> limits(
        count, {.nodes = budget, .looks = looks / count, .attempts = attempts / count, .open_before = m_open.size()});
    for (std::size_t i = 0; i < looks % count; ++i)
      ++limits[i].looks;
    std::size_t left = nodes_left();
    for (Task_limits& limit : limits) {
      limit.nodes = (std::min)(limit.nodes, left);
      left -= limit.nodes;
    }
    return limits;
  }

  std::vector<Outcome> run_round(const std::vector<Task>& tasks, const std::vector<Task_limits>& limits)
  {
    std::vector<Outcome> outcomes(tasks.size());
    const auto run_task = [&](std::size_t i, Worker& worker) {
      if (limits[i].nodes == 0)
        outcomes[i].pending.push_back(tasks[i]);
      else
        outcomes[i] = worker.run(tasks[i], limits[i]);
    };
    if constexpr (std::same_as<Traits, Certified_solver_traits>)
      if (m_control.distribution() != nullptr && tasks.size() > 1) {
        run_on_all_ranks(tasks, run_task, outcomes);
        return outcomes;
      }
    if (is_parallel<Concurrency_tag> && tasks.size() > 1) {
      m_workers.resize((std::max)(m_workers.size(), slots_of<Concurrency_tag>()));
      const std::vector<std::size_t> order = largest_first(tasks);
      parallel_for<Concurrency_tag>(tasks.size(), [&](std::size_t i, std::size_t slot) {
        [[maybe_unused]] const typename Number_traits<NT>::Rounding_guard guard;
        [[maybe_unused]] const Mpfr_precision_scope precision(m_options.precision);
        std::unique_ptr<Worker>& worker = m_workers[slot];
        if (worker == nullptr)
          worker =
              std::make_unique<Worker>(m_system, m_layout, m_options, m_control, &m_roots.roots(), &m_multiple_roots);
        run_task(order[i], *worker);
      });
      return outcomes;
    }
    for (std::size_t i = 0; i < tasks.size(); ++i)
      run_task(i, m_worker);
    return outcomes;
  }

  // The same by several processes, which are in step: each gets all outcomes, and the work of all.
  template <class Run>
  void run_on_all_ranks(const std::vector<Task>& tasks, const Run& run_task, std::vector<Outcome>& outcomes)
  {
    const std::vector<std::size_t> order = largest_first(tasks);
    const Summary before = m_worker.summary;
    const auto run = [&](std::size_t k) {
      m_worker.summary = {};
      run_task(order[k], m_worker);
      return Outcome_bytes<Coordinate>::of(std::exchange(outcomes[order[k]], {}), m_worker.summary);
    };
    const std::vector<std::string> results =
        m_control.distribution()->results_of_round(tasks.size(), run, [&] { return m_control.must_stop(true); });
    m_worker.summary = before;
    for (std::size_t k = 0; k < order.size(); ++k) {
      auto [outcome, work] = Outcome_bytes<Coordinate>::outcome(results[k]);
      outcomes[order[k]] = std::move(outcome);
      m_worker.summary = sum(m_worker.summary, work);
    }
  }

  // Large parts of the domain take long as a rule; short tasks fill the gaps at the end of a round.
  static std::vector<std::size_t> largest_first(const std::vector<Task>& tasks)
  {
    std::vector<std::size_t> order(tasks.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t k) { return tasks[i].share > tasks[k].share; });
    return order;
  }

  // Puts together what the tasks found; returns the tasks of the next round.
  std::vector<Task> collect(const std::vector<Task>& tasks, std::vector<Outcome> outcomes)
  {
    std::vector<Task> pending;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
      collect_roots(outcomes[i].roots, tasks[i].cell, m_open);
      std::move(outcomes[i].multiple_roots.begin(), outcomes[i].multiple_roots.end(),
                std::back_inserter(m_multiple_roots));
      m_looks += outcomes[i].looks;
      m_gains += outcomes[i].gains;
      std::move(outcomes[i].open.begin(), outcomes[i].open.end(), std::back_inserter(m_open));
      std::move(outcomes[i].curve_boxes.begin(), outcomes[i].curve_boxes.end(), std::back_inserter(m_curve_boxes));
      std::move(outcomes[i].pending.begin(), outcomes[i].pending.end(), std::back_inserter(pending));
    }
    return pending;
  }

  // Roots that were found by tasks that did not know of each other; one that may be another one or not is left open.
  // Returns whether there is none of these.
  bool collect_roots(std::vector<Found_root<Coordinate>>& found, const Cell& cell,
                     std::vector<Open_box<Coordinate>>& open)
  {
    bool are_counted = true;
    if (m_roots.roots().empty())
      m_roots.roots().reserve(found.size());
    for (Found_root<Coordinate>& root : found) {
      if (m_roots.is_known(root))
        continue;
      const auto* known = m_roots.root_that_meets(root.enclosure);
      if (known == nullptr)
        m_roots.roots().push_back(std::move(root));
      else if (!m_worker.walk.certification().is_same_root(known->enclosure, root.enclosure)) {
        Open_box<Coordinate>& box = open.emplace_back();
        box.reason = Undecided_reason::TOLERANCE;
        box.cell = cell;
        for (const auto& [lower, upper] : root.enclosure) {
          box.lower.push_back(lower);
          box.upper.push_back(upper);
        }
        are_counted = false;
      }
    }
    return are_counted;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SUBDIVISION_SUBDIVISION_WALK_H
