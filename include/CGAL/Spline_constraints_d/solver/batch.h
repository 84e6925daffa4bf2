// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_BATCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_BATCH_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>

#include <CGAL/tags.h>

#include <atomic>
#include <concepts>
#include <cstddef>
#include <iterator>
#include <limits>
#include <mutex>
#include <ranges>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {

// Calls task(i) for i = 0, ..., count - 1, each once, in order or in parallel. An `Invalid_input` is thrown on with the
// index in front: that of the smallest index, whatever the order in time, so that tasks of larger ones may be left out
// then.
template <class Concurrency_tag, class Task>
void for_each_of_batch(std::size_t count, const Task& task)
{
  std::atomic<std::size_t> failed = (std::numeric_limits<std::size_t>::max)();
  std::mutex mutex;
  std::string message;
  const auto run = [&](std::size_t i) {
    if (i > failed.load(std::memory_order_acquire))
      return;
    try {
      task(i);
    } catch (const Invalid_input& error) {
      const std::lock_guard lock(mutex);
      if (i < failed) {
        failed = i;
        message = error.what();
      }
    }
  };
  parallel_for<Concurrency_tag>(count, [&](std::size_t i, std::size_t) { run(i); });
  if (failed != (std::numeric_limits<std::size_t>::max)())
    throw Invalid_input("system " + std::to_string(failed) + " of a batch: " + message);
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

all solutions of each of many systems, with the default solver: the answers of `solve()` for one system at a time, in
the order of the systems.

The systems may differ in everything. They are independent of each other, so with `CGAL::Parallel_tag` whole systems are
handed to the threads; the answers are the same. This is faster than solving each with all threads when systems are
small. A time limit or a node limit counts for each system alone, not for the batch.

\tparam Concurrency_tag `CGAL::Sequential_tag`; or `CGAL::Parallel_tag` or `CGAL::Parallel_if_available_tag`, to use all
cores through TBB.
\tparam Range a random access range of `Constraint_system_d`. With more than one thread, several elements are accessed
at the same time.
\throws Invalid_input when that is thrown for a system, or an option makes no sense; the message names the index of the
system, the smallest one if there are several. There are no answers then.
*/
template <class Concurrency_tag = CGAL::Sequential_tag, std::ranges::random_access_range Range>
  requires std::ranges::sized_range<Range> && std::same_as<std::ranges::range_value_t<Range>, Constraint_system_d>
std::vector<Solution_set_d<double>> solve(Range&& systems, const Solver_options& options = {})
{
  const Decomposing_solver_d<Certified_solver_traits> solver(options);
  std::vector<Solution_set_d<double>> results(static_cast<std::size_t>(std::ranges::size(systems)));
  const auto first = std::ranges::begin(systems);
  internal::for_each_of_batch<Concurrency_tag>(results.size(), [&](std::size_t i) {
    results[i] = solver(first[static_cast<std::ranges::range_difference_t<Range>>(i)]);
  });
  return results;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_BATCH_H
