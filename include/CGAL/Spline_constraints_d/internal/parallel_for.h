// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_PARALLEL_FOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_PARALLEL_FOR_H

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

#ifdef CGAL_LINKED_WITH_TBB

// The library of TBB is not built for the thread sanitizer, which takes the order that it keeps between threads for
// missing: plain threads do the same there.
#if defined(__SANITIZE_THREAD__)
#define CGAL_SPLINE_CONSTRAINTS_PLAIN_THREADS
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CGAL_SPLINE_CONSTRAINTS_PLAIN_THREADS
#endif
#endif

#include <atomic>

#ifdef CGAL_SPLINE_CONSTRAINTS_PLAIN_THREADS
#include <exception>
#include <mutex>
#include <thread>
#include <vector>
#else
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>
#endif

#endif // CGAL_LINKED_WITH_TBB

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <class Concurrency_tag>
constexpr bool is_parallel = std::is_convertible_v<Concurrency_tag, Parallel_tag>;

#ifdef CGAL_LINKED_WITH_TBB

// What is left of 0, ..., count - 1: handed out one by one and in order, since a large piece at the end would leave the
// other threads with nothing to do.
class Shared_indices
{
  std::atomic<std::size_t> m_next = 0;
  const std::size_t m_count;

public:
  explicit Shared_indices(std::size_t count) : m_count(count) {}

  // Calls body(i, slot) until there are none left; an exception ends it for all threads.
  template <class Body>
  void run(const Body& body, std::size_t slot)
  {
    try {
      for (std::size_t i = m_next++; i < m_count; i = m_next++)
        body(i, slot);
    } catch (...) {
      m_next = m_count;
      throw;
    }
  }
};

#ifdef CGAL_SPLINE_CONSTRAINTS_PLAIN_THREADS

inline std::size_t number_of_slots() { return 4; }

template <class Body>
void run_on_all_threads(std::size_t count, const Body& body)
{
  Shared_indices indices(count);
  std::mutex mutex;
  std::exception_ptr exception;
  const auto work = [&](std::size_t slot) {
    try {
      indices.run(body, slot);
    } catch (...) {
      const std::lock_guard lock(mutex);
      exception = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t slot = 0; slot < (std::min)(count, number_of_slots()); ++slot)
    threads.emplace_back(work, slot);
  for (std::thread& thread : threads)
    thread.join();
  if (exception)
    std::rethrow_exception(exception);
}

#else

inline std::size_t number_of_slots() { return static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()); }

template <class Body>
void run_on_all_threads(std::size_t count, const Body& body)
{
  Shared_indices indices(count);
  const auto work = [&](std::size_t) {
    indices.run(body, static_cast<std::size_t>(tbb::this_task_arena::current_thread_index()));
  };
  // All threads round as the calling one does: TBB would take the mode of when its threads were made.
  tbb::task_group_context context(tbb::task_group_context::bound,
                                  tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings);
  tbb::parallel_for(std::size_t(0), (std::min)(count, number_of_slots()), work, tbb::simple_partitioner(), context);
}

#endif

#endif // CGAL_LINKED_WITH_TBB

// How many different slots parallel_for() uses at most.
template <class Concurrency_tag>
std::size_t slots_of()
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<Concurrency_tag>)
    return number_of_slots();
#endif
  return 1;
}

// Calls body(i, slot) for i = 0, ..., count - 1, each once: in order and with slot 0, or in parallel, begun in order.
// Calls with the same slot do not run at the same time. All round as the caller does.
template <class Concurrency_tag, class Body>
void parallel_for(std::size_t count, const Body& body)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr (is_parallel<Concurrency_tag>)
    return run_on_all_threads(count, body);
#else
  static_assert(!is_parallel<Concurrency_tag>,
                "Parallel_tag needs TBB: link CGAL::Spline_constraints_d with SPLINE_CONSTRAINTS_WITH_TBB");
#endif
  for (std::size_t i = 0; i < count; ++i)
    body(i, std::size_t(0));
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_INTERNAL_PARALLEL_FOR_H
