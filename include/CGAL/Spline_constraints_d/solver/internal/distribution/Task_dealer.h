// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_TASK_DEALER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_TASK_DEALER_H

#include <algorithm>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Which of the tasks 0, ..., count - 1 are next. They are dealt out in order, in packets that are a share of what is left,
so that they are large first and small at the end, by the mean time of the tasks so far as long as a second at most, and
at least as many tasks as take longer than to send their results. What was given back is dealt out again, before the
others; a task that several have done counts once.
*/
class Task_dealer
{
  static constexpr std::size_t packets_of_rest = 8; // for each rank
  static constexpr std::size_t first_packet = 16;   // at most, before it is known how long tasks take
  static constexpr double most_seconds = 1, least_seconds = 2e-4;

  std::vector<char> m_is_done;
  std::deque<std::size_t> m_given_back;
  std::size_t m_next = 0, m_end, m_left;
  std::size_t m_ranks, m_timed = 0;
  double m_seconds = 0;

public:
  Task_dealer(std::size_t count, std::size_t ranks) : m_is_done(count, 0), m_end(count), m_left(count), m_ranks(ranks)
  {}

  std::size_t count() const { return m_is_done.size(); }
  std::size_t left() const { return m_left; }
  bool is_done(std::size_t task) const { return m_is_done[task] != 0; }

  // None of the tasks before `end` is left.
  bool is_finished() const { return m_left == 0; }

  std::vector<std::size_t> next_packet()
  {
    std::vector<std::size_t> packet;
    for (std::size_t size = size_of_packet(); size > 0; --size)
      if (const auto task = next_task())
        packet.push_back(*task);
    return packet;
  }

  std::optional<std::size_t> next_task()
  {
    while (!m_given_back.empty()) {
      const std::size_t task = m_given_back.front();
      m_given_back.pop_front();
      if (task < m_end && !is_done(task))
        return task;
    }
    while (m_next < m_end && is_done(m_next))
      ++m_next;
    return m_next < m_end ? std::optional(m_next++) : std::nullopt;
  }

  // So long did some of the tasks take.
  void add_time(std::size_t count, double seconds)
  {
    m_timed += count;
    m_seconds += seconds;
  }

  // False for a task that was done before, or is not wanted any more.
  bool mark_as_done(std::size_t task)
  {
    if (task >= m_end || is_done(task))
      return false;
    m_is_done[task] = 1;
    --m_left;
    return true;
  }

  void give_back(std::size_t task) { m_given_back.push_back(task); }

  // Tasks from `end` on are not wanted any more.
  void drop_from(std::size_t end)
  {
    m_left -=
        static_cast<std::size_t>(std::count(m_is_done.begin() + static_cast<std::ptrdiff_t>((std::min)(end, m_end)),
                                            m_is_done.begin() + static_cast<std::ptrdiff_t>(m_end), char(0)));
    m_end = (std::min)(m_end, end);
  }

private:
  std::size_t size_of_packet() const
  {
    const std::size_t left = (m_next < m_end ? m_end - m_next : 0) + m_given_back.size(),
                      share = left / (packets_of_rest * m_ranks);
    if (m_timed == 0)
      return std::clamp(share, std::size_t(1), first_packet);
    const auto count_in = [&](double seconds) {
      const double count = seconds * static_cast<double>(m_timed) / (std::max)(m_seconds, 1e-9);
      return (std::max)(std::size_t(1), static_cast<std::size_t>((std::min)(count, static_cast<double>(left))));
    };
    return std::clamp(share, count_in(least_seconds), count_in(most_seconds));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_TASK_DEALER_H
