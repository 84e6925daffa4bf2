// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_SEARCH_IN_TURNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_SEARCH_IN_TURNS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A search that is interrupted and goes on where it was: it has a thread of its own, which waits unless it is the turn of
the search, while the one that gives turns waits in its place. So the two never run at the same time. The search says
how many nodes it looks at, and where its turn may end.
*/
class Search_in_turns
{
  struct Abandoned
  {};

  std::mutex m_mutex;
  std::condition_variable m_changed;
  bool m_is_its_turn = false, m_has_ended = false, m_is_abandoned = false, m_is_last_turn = false;
  std::size_t m_nodes = 0, m_nodes_left = 0;
  std::exception_ptr m_exception;
  std::thread m_thread; // last: it uses the others

public:
  // Nothing is done before the first turn.
  explicit Search_in_turns(std::function<void()> search);
  // Wherever it is, the search ends by an exception.
  ~Search_in_turns();

  Search_in_turns(const Search_in_turns&) = delete;
  Search_in_turns& operator=(const Search_in_turns&) = delete;

  // Gives a turn of so many nodes; the last one: then the search is to end by the limit of nodes. Whether it has ended.
  // What it throws is thrown on.
  bool advance(std::size_t nodes, bool is_last);
  // In all turns.
  std::size_t nodes() const { return m_nodes; }

  // For the search: what is left of its turn, what it uses of that, and that it can use no more; this returns in its
  // next turn, or false when there is none.
  std::size_t nodes_left() const { return m_nodes_left; }
  void spend(std::size_t nodes);
  bool end_turn();

private:
  void wait_for_turn(std::unique_lock<std::mutex>& lock)
  {
    m_changed.wait(lock, [this] { return m_is_its_turn; });
    if (m_is_abandoned)
      throw Abandoned();
  }
  void give_back()
  {
    m_is_its_turn = false;
    m_changed.notify_all();
  }
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Search_in_turns::Search_in_turns(std::function<void()> search)
  : m_thread([this, search = std::move(search)] {
      std::exception_ptr exception;
      try {
        {
          std::unique_lock lock(m_mutex);
          wait_for_turn(lock);
        }
        search();
      } catch (const Abandoned&) {
      } catch (...) {
        exception = std::current_exception();
      }
      const std::lock_guard lock(m_mutex);
      m_exception = exception;
      m_has_ended = true;
      give_back();
    })
{}

CGAL_SPLINE_CONSTRAINTS_INLINE Search_in_turns::~Search_in_turns()
{
  {
    const std::lock_guard lock(m_mutex);
    m_is_abandoned = m_is_its_turn = true;
    m_changed.notify_all();
  }
  m_thread.join();
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Search_in_turns::advance(std::size_t nodes, bool is_last)
{
  std::unique_lock lock(m_mutex);
  if (!m_has_ended) {
    m_nodes_left = nodes;
    m_is_last_turn = is_last;
    m_is_its_turn = true;
    m_changed.notify_all();
    m_changed.wait(lock, [this] { return !m_is_its_turn; });
  }
  if (m_exception)
    std::rethrow_exception(std::exchange(m_exception, nullptr));
  return m_has_ended;
}

CGAL_SPLINE_CONSTRAINTS_INLINE void Search_in_turns::spend(std::size_t nodes)
{
  m_nodes += nodes;
  m_nodes_left -= nodes < m_nodes_left ? nodes : m_nodes_left;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Search_in_turns::end_turn()
{
  std::unique_lock lock(m_mutex);
  if (m_is_last_turn)
    return false;
  give_back();
  wait_for_turn(lock);
  return true;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CONTROL_SEARCH_IN_TURNS_H
