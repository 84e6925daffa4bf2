// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_TASK_RESULT_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_TASK_RESULT_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Bytes.h>

#include <chrono>
#include <cstddef>
#include <ctime>
#include <exception>
#include <string>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

enum class Outcome_kind
{
  RESULT,
  INVALID_INPUT,
  OTHER_EXCEPTION
};

// What came of one task: its bytes, or the message of the exception that it has thrown.
struct Task_result
{
  std::size_t task = 0;
  Outcome_kind kind = Outcome_kind::RESULT;
  std::string bytes = {};

  // Runs a task.
  template <class Run>
  static Task_result of(std::size_t task, const Run& run)
  {
    Task_result result;
    result.task = task;
    try {
      result.bytes = run(task);
    } catch (const Invalid_input& error) {
      result.kind = Outcome_kind::INVALID_INPUT;
      result.bytes = error.what();
    } catch (const std::exception& error) {
      result.kind = Outcome_kind::OTHER_EXCEPTION;
      result.bytes = error.what();
    }
    return result;
  }

  void write(Byte_writer& bytes_to) const
  {
    bytes_to.add(task);
    bytes_to.add(static_cast<int>(kind));
    bytes_to.add(std::string_view(bytes));
  }

  static Task_result read(Byte_reader& from)
  {
    Task_result result;
    from.read(result.task);
    result.kind = static_cast<Outcome_kind>(from.get<int>());
    from.read(result.bytes);
    return result;
  }
};

// How long some tasks took. To ask for the time of the processor takes as long as a tenth of a small task: it is asked
// once for a packet of them.
struct Time_of_tasks
{
  std::size_t count = 0;
  double seconds = 0, busy_seconds = 0; // on the wall, and of the processor

  void write(Byte_writer& to) const
  {
    to.add(count);
    to.add(seconds);
    to.add(busy_seconds);
  }

  static Time_of_tasks read(Byte_reader& from)
  {
    Time_of_tasks result;
    from.read(result.count);
    from.read(result.seconds);
    from.read(result.busy_seconds);
    return result;
  }
};

// Takes the time of tasks, from when it is made.
class Task_clock
{
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
  std::clock_t m_processor = std::clock();

public:
  Time_of_tasks time_of(std::size_t count) const
  {
    return {count, std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(),
            static_cast<double>(std::clock() - m_processor) / CLOCKS_PER_SEC};
  }
};

// What rank 0 and the others say to each other; each message begins with one of these.
enum class Subject
{
  READY,   // for the tasks of a round, which follows
  RESULTS, // the round, the time of the tasks, and their results
  ALIVE,   // nothing else
  LEAVES,  // the last message of a rank
  TASKS,   // the round, and indices
  ROUND,   // the round, and the results of all of its tasks in their order
  END,     // why
  CLOSED   // the last message to a rank: what ranks were lost
};

enum class End_of_work
{
  DONE,
  STOPPED,
  INVALID_INPUT,
  OTHER_EXCEPTION
};

// Begins a message.
inline Byte_writer message_about(Subject subject)
{
  Byte_writer message;
  message.add(static_cast<int>(subject));
  return message;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_TASK_RESULT_H
