// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_TASKS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_TASKS_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/solver/Mpi_options.h>
#include <CGAL/Spline_constraints_d/solver/Visitor_reference.h>
#include <CGAL/Spline_constraints_d/solver/internal/distribution/Journal.h>
#include <CGAL/Spline_constraints_d/solver/internal/distribution/Mpi_dealer.h>
#include <CGAL/Spline_constraints_d/solver/internal/distribution/Mpi_worker.h>

#include <chrono>
#include <cstddef>
#include <exception>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A task with its index, which asks the visitor now and then; it returns bytes.
using Mpi_task = std::function<std::string(std::size_t, const Visitor_reference&)>;

// All ranks throw what ended the work.
inline void throw_if_failed(End_of_work reason, const std::string& message)
{
  if (reason == End_of_work::INVALID_INPUT)
    throw Invalid_input(message);
  if (reason == End_of_work::OTHER_EXCEPTION)
    throw std::runtime_error(message);
}

// Ends the work of all ranks when rank 0 ends it by an exception, or in the good way.
template <class Work>
void run_as_dealer(Mpi_dealer& dealer, const Work& work)
{
  std::pair<End_of_work, std::string> end;
  try {
    end = work();
  } catch (const Invalid_input& error) {
    dealer.end(End_of_work::INVALID_INPUT, error.what());
    throw;
  } catch (const std::exception& error) {
    dealer.end(End_of_work::OTHER_EXCEPTION, error.what());
    throw;
  } catch (...) {
    dealer.end(End_of_work::OTHER_EXCEPTION, "Spline_constraints_d: rank 0 has failed");
    throw;
  }
  dealer.end(end.first, end.second);
  throw_if_failed(end.first, end.second);
}

/*
Rank 0 gives the results of all tasks to receive(task, bytes), as they come, those of the journal first; a stop of the
visitor ends the work before. The smallest task with an exception is named by it, as `name` and its index.
*/
inline void deal_out(Mpi_mail& mail, std::size_t count, const std::string& name, const Mpi_task& task,
                     const std::function<void(std::size_t, std::string)>& receive, const std::string& work,
                     const Mpi_options& options, Mpi_report& report)
{
  Mpi_dealer dealer(mail, options, report);
  run_as_dealer(dealer, [&] {
    Task_dealer tasks(count, static_cast<std::size_t>(mail.size()));
    std::optional<Journal> journal;
    if (!options.journal.empty())
      journal.emplace(options.journal, work, [&](std::size_t i, const std::string& bytes) {
        if (i < count && tasks.mark_as_done(i)) {
          ++report.from_journal;
          receive(i, bytes);
        }
      });
    Task_result failed;
    failed.task = (std::numeric_limits<std::size_t>::max)();
    const Receiver_of_results receiver{[&](Task_result result) {
                                         if (result.kind != Outcome_kind::RESULT) {
                                           tasks.drop_from(result.task); // the others have smaller indices
                                           failed = std::move(result);
                                           return;
                                         }
                                         if (journal && !dealer.is_stopped())
                                           journal->add(result.task, result.bytes);
                                         receive(result.task, std::move(result.bytes));
                                       },
                                       [&] {
                                         if (journal)
                                           journal->flush();
                                       }};
    dealer.run(
        tasks, [&](std::size_t i) { return task(i, dealer); }, receiver, [&] { return dealer.stop(); });
    if (failed.kind == Outcome_kind::RESULT)
      return std::pair(tasks.is_finished() ? End_of_work::DONE : End_of_work::STOPPED, std::string());
    return std::pair(failed.kind == Outcome_kind::INVALID_INPUT ? End_of_work::INVALID_INPUT
                                                                : End_of_work::OTHER_EXCEPTION,
                     name + " " + std::to_string(failed.task) + " of a batch: " + failed.bytes);
  });
}

// Does what rank 0 deals out.
inline void work_off(Mpi_mail& mail, const Mpi_task& task, const Mpi_options& options, Mpi_report& report)
{
  Mpi_worker worker(mail, options, report);
  try {
    worker.run([&](std::size_t i) { return task(i, worker); });
  } catch (const Work_has_ended&) {
  }
  const auto [reason, message] = worker.leave();
  throw_if_failed(reason, message);
}

// Both, as the rank is.
inline void run_tasks(const boost::mpi::communicator& ranks, std::size_t count, const std::string& name,
                      const Mpi_task& task, const std::function<void(std::size_t, std::string)>& receive,
                      const std::string& work, const Mpi_options& options, Mpi_report& report)
{
  const auto start = std::chrono::steady_clock::now();
  report = {};
  Mpi_mail mail(ranks);
  if (mail.rank() == 0)
    deal_out(mail, count, name, task, receive, work, options, report);
  else
    work_off(mail, task, options, report);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_TASKS_H
