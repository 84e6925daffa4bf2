// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_BATCH_MPI_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_BATCH_MPI_H

#include <CGAL/Spline_constraints_d/solver/Decomposing_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Mpi_options.h>
#include <CGAL/Spline_constraints_d/solver/Parameter_grid.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Answer_bytes.h>
#include <CGAL/Spline_constraints_d/solver/internal/distribution/mpi_tasks.h>

#include <boost/mpi/communicator.hpp>

#include <concepts>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {

// Stops at once.
struct Stopping_visitor
{
  bool stop() const { return true; }
  void on_progress(double) {}
};

// What tells the journals of batches apart.
inline std::string name_of_work(std::size_t count, const Solver_options& options)
{
  Byte_writer bytes;
  bytes.add(count);
  bytes.add(options.tolerance);
  bytes.add(options.time_limit);
  bytes.add(options.node_limit);
  bytes.add(options.precision);
  bytes.add(options.ladder_precision);
  bytes.add(options.coarsening_step);
  return bytes.take();
}

// Solves the system of an index.
using Solver_at = std::function<Solution_set_d<double>(std::size_t, const Solver_options&)>;

inline std::vector<Solution_set_d<double>> solutions_of_batch(const boost::mpi::communicator& ranks, std::size_t count,
                                                              const Solver_at& solve_at, const Mpi_options& options,
                                                              Mpi_report& report)
{
  options.check();
  std::vector<Solution_set_d<double>> results;
  std::vector<char> is_known(count, 0);
  if (ranks.rank() == 0)
    results.resize(count);
  const auto solve_watched = [&](std::size_t i, const Visitor_reference& visitor) {
    Solver_options watched = options.solver;
    watched.visitor = visitor;
    return solve_at(i, watched);
  };
  run_tasks(
      ranks, count, "system",
      [&](std::size_t i, const Visitor_reference& visitor) -> std::string {
        Solution_set_d<double> answers = solve_watched(i, visitor);
        if (results.empty() || !options.journal.empty())
          return Answer_bytes::of(answers);
        if (!is_known[i])
          results[i] = std::move(answers); // those of rank 0 need not travel
        return {};
      },
      [&](std::size_t i, const std::string& bytes) {
        if (!bytes.empty())
          results[i] = Answer_bytes::answers<double>(bytes);
        is_known[i] = 1;
      },
      name_of_work(count, options.solver), options, report);
  Stopping_visitor at_once;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!is_known[i]) // the visitor has stopped the work
      results[i] = solve_watched(i, at_once);
  return results;
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSolver

all solutions of each of many systems, by all ranks of MPI: the answers of `solve()` for one system at a time, bit by
bit but for the seconds they took, in the order of the systems. All ranks call this with the same arguments. Rank 0
returns the answers, the others nothing.

Systems are dealt out in packets, large ones first and small ones at the end, to ranks as they are done with what they
have; rank 0 solves some, too. Nothing is sent of a system but its index. The answers of a packet travel together, as
the bits of their doubles and of the numerators and denominators of their rationals.

Link `CGAL::Spline_constraints_d_MPI`, which CMake makes where Boost.MPI is found: with
`find_package(Spline_constraints_d COMPONENTS MPI)`, or in the source tree with `SPLINE_CONSTRAINTS_WITH_MPI`.

A rank that dies costs its systems' repetition, if the rest of the job goes on: Open MPI ends it unless it was started
as `mpirun --enable-recovery`. MPI cannot be ended in the usual way then; see `exit_after_mpi()`. In any case, a run
with a `Mpi_options::journal` that was ended, whatever ended it, is started again for what is missing. It is for the
caller to take another file for other systems.

\param ranks the processes that take part.
\param count how many systems there are.
\param system_at gives the system of an index, each time the same one, on all ranks.
\param options of the systems and of the ranks.
\param report if it is not null, is told how the work was shared.
\throws Invalid_input when that is thrown for a system, or an option makes no sense, on all ranks; the message names the
index of the system, the smallest one if there are several. `std::runtime_error` with that index for other exceptions
of `system_at`, and when rank 0 does not answer any more.
*/
template <class System_at>
requires std::is_invocable_r_v<Constraint_system_d, const System_at&, std::size_t> std::vector<Solution_set_d<double>>
solve_batch_mpi(const boost::mpi::communicator& ranks, std::size_t count, const System_at& system_at,
                const Mpi_options& options = {}, Mpi_report* report = nullptr)
{
  Mpi_report own;
  return internal::solutions_of_batch(
      ranks, count, [&](std::size_t i, const Solver_options& limits) { return solve(system_at(i), limits); }, options,
      report != nullptr ? *report : own);
}

/*!
\ingroup PkgSplineConstraintsDSolver
the same of the systems of a range, which all ranks have.
\param ranks, options, report as for the other function.
\param systems a random access range of `Constraint_system_d`.
*/
template <std::ranges::random_access_range Range>
requires std::ranges::sized_range<Range> && std::same_as<std::ranges::range_value_t<Range>, Constraint_system_d>
    std::vector<Solution_set_d<double>> solve_batch_mpi(const boost::mpi::communicator& ranks, const Range& systems,
                                                        const Mpi_options& options = {}, Mpi_report* report = nullptr)
{
  Mpi_report own;
  const auto first = std::ranges::begin(systems);
  return internal::solutions_of_batch(
      ranks, static_cast<std::size_t>(std::ranges::size(systems)),
      [&](std::size_t i, const Solver_options& limits) {
        const Constraint_system_d& system = first[static_cast<std::ranges::range_difference_t<const Range>>(i)];
        return solve(system, limits);
      },
      options, report != nullptr ? *report : own);
}

/*!
\ingroup PkgSplineConstraintsDSolver
the same of the systems of a family, one for each point of a grid of parameters, in the order of the points.
\param ranks, options, report as for the other function.
\param parameters the grid.
\param system_of gives the system for a vector of values of the parameters, on all ranks.
*/
template <class System_of>
requires std::is_invocable_r_v < Constraint_system_d, const System_of&, const std::vector<Exact_rational>
& > std::vector<Solution_set_d<double>> solve_batch_mpi(const boost::mpi::communicator& ranks,
                                                        const Parameter_grid& parameters, const System_of& system_of,
                                                        const Mpi_options& options = {}, Mpi_report* report = nullptr)
{
  return solve_batch_mpi(
      ranks, parameters.size(), [&](std::size_t i) { return system_of(parameters[i]); }, options, report);
}

/*!
\ingroup PkgSplineConstraintsDSolver

all solutions of one system, by all ranks of MPI: those of `solve()`, bit by bit, unless a time limit or the visitor
stops the run. All ranks call this with the same arguments. Rank 0 returns the answer, the others an empty set.

The walk over the domain goes in rounds, and the boxes of a round are the tasks that are dealt out, as threads take them
(\ref Spline_constraints_d_parallel_proofs); between rounds all ranks put together what was found, each for itself. So a
rank that dies costs the repetition of its tasks in one round. For systems that take seconds: those that one rank solves
in less than a twentieth of a second are not faster with two, as rounds are short. There is no journal.

\param ranks the processes that take part.
\param system the constraints; at least as many equalities as unknowns.
\param options of the system and of the ranks; limits count at rank 0.
\param report if it is not null, is told how the work was shared.
\throws Invalid_input when there are fewer equalities than unknowns, an option makes no sense, or there is a journal.
`std::runtime_error` when rank 0 does not answer any more.
*/
inline Solution_set_d<double> solve_mpi(const boost::mpi::communicator& ranks, const Constraint_system_d& system,
                                        const Mpi_options& options = {}, Mpi_report* report = nullptr);

/*!
\ingroup PkgSplineConstraintsDSolver

runs tasks of any kind on all ranks of MPI, as `solve_batch_mpi()` does with systems.

\param ranks the processes that take part.
\param count how many tasks there are.
\param task is called as `task(i, visitor)` and returns a `std::string`, each time the same one. It asks the visitor, a
`Visitor_reference`, now and then, and ends early when it says so; solvers do.
\param receive is called as `receive(i, text)` on rank 0 for the result of each task, as they come.
\param options of the ranks; of the solver only the visitor is used.
\param work names the tasks in a journal.
\param report if it is not null, is told how the work was shared.
\throws Invalid_input as `solve_batch_mpi()`, and so `std::runtime_error`.
*/
template <class Task, class Receiver>
requires std::is_invocable_r_v<std::string, const Task&, std::size_t, const Visitor_reference&> &&
    std::invocable<const Receiver&, std::size_t, std::string>
void run_tasks_mpi(const boost::mpi::communicator& ranks, std::size_t count, const Task& task, const Receiver& receive,
                   const Mpi_options& options = {}, const std::string& work = {}, Mpi_report* report = nullptr)
{
  options.check();
  Mpi_report own;
  internal::run_tasks(ranks, count, "task", std::cref(task), std::cref(receive), std::to_string(count) + " " + work,
                      options, report != nullptr ? *report : own);
}

/*!
\ingroup PkgSplineConstraintsDSolver

ends the program where a rank was lost, and returns otherwise: `MPI_Finalize()` would wait for it. To be called by all
ranks after the answers have been written, before what ends MPI. A function of this header that is called after a rank
was lost would wait for it, too.
\param report what the work has told.
\param status the exit status.
*/
inline void exit_after_mpi(const Mpi_report& report, int status = EXIT_SUCCESS)
{
  if (report.lost.empty())
    return;
  std::cout.flush();
  std::cerr.flush();
  std::_Exit(status);
}

inline Solution_set_d<double> solve_mpi(const boost::mpi::communicator& ranks, const Constraint_system_d& system,
                                        const Mpi_options& options, Mpi_report* report)
{
  options.check();
  if (!options.journal.empty())
    throw Invalid_input("solve_mpi: there is no journal of one system");
  Mpi_report own;
  Mpi_report& told = report != nullptr ? *report : own;
  told = {};
  Solution_set_d<double> result;
  internal::Mpi_mail mail(ranks);
  const auto solve_with = [&](auto& rank, const Solver_options& limits) {
    Solver_options watched = limits;
    watched.visitor = rank;
    return internal::solution_set<Certified_solver_traits, CGAL::Sequential_tag>(
        system, watched, &internal::decomposed_solutions<Certified_solver_traits, CGAL::Sequential_tag>, &rank);
  };
  if (mail.rank() == 0) {
    internal::Mpi_dealer dealer(mail, options, told);
    internal::run_as_dealer(dealer, [&] {
      result = solve_with(dealer, options.solver);
      return std::pair(internal::End_of_work::DONE, std::string());
    });
  } else {
    internal::Mpi_worker worker(mail, options, told);
    Solver_options no_limits = options.solver;
    no_limits.time_limit = 0;
    try {
      solve_with(worker, no_limits);
    } catch (const internal::Work_has_ended&) {
    } catch (const std::exception&) { // rank 0 throws the same
    }
    const auto [reason, message] = worker.leave();
    internal::throw_if_failed(reason, message);
  }
  told.seconds = result.summary().seconds;
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_BATCH_MPI_H
