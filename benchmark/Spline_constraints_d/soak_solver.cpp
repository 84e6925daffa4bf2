// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*
soak_solver [count = 10000] [first seed = 1] [nodes of an exact run = 50] [of a certified one = 2000] [journal]

Solves random and adversarial systems, one per seed, with Certified_solver_traits and with Exact_solver_traits, and
compares the answers with each other and with the solutions that were planted. Prints a table with a line for each kind
of systems, as soak_systems.h names them, with the counts of soak_comparison.h, and the seeds of systems with lost or
extra roots. The exit status is 0 when there are none, else 1.

Where Boost.MPI is found, `mpirun -n 2 soak_solver ...` shares the systems; with a journal, a run that was ended goes
on.
*/

#include "soak_comparison.h"

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <string>

#ifdef SPLINE_CONSTRAINTS_SOAKS_WITH_MPI
#include <CGAL/Spline_constraints_d/solver/batch_mpi.h>

#include <boost/mpi/environment.hpp>
#endif

using namespace solver_test;

static void print_row(const std::string& kind, const Soak_counts& counts)
{
  std::cout << std::left << std::setw(16) << kind << std::right;
  for (const std::uint64_t value : counts.values)
    std::cout << std::setw(9) << value;
  std::cout << '\n';
}

static void print(const Soak_report& report, double seconds)
{
  std::cout << report.findings << std::setw(16) << ' ';
  for (int line = 0; line < 2; ++line, std::cout << '\n' << std::setw(line < 2 ? 16 : 0) << (line < 2 ? " " : ""))
    for (const std::string name : Soak_counts::names) {
      const std::size_t space = name.rfind(' ') == std::string::npos ? 0 : name.rfind(' ') + 1;
      std::cout << std::setw(9) << (line == 0 ? name.substr(0, space).substr(0, 8) : name.substr(space).substr(0, 8));
    }
  std::cout << '\n';
  for (const auto& [kind, counts] : report.kinds)
    print_row(kind, counts);
  print_row("all", report.sum());
  std::cout << seconds << " s" << std::endl;
}

int main(int count_of_arguments, char** arguments)
{
#ifdef SPLINE_CONSTRAINTS_SOAKS_WITH_MPI
  boost::mpi::environment environment(count_of_arguments, arguments);
#endif
  const auto number = [&](int i, std::uint64_t otherwise) {
    return count_of_arguments > i ? std::strtoull(arguments[i], nullptr, 10) : otherwise;
  };
  const std::uint64_t count = number(1, 10000), first = number(2, 1);
  const Soak_limits limits{.exact = number(3, Soak_limits().exact), .certified = number(4, Soak_limits().certified)};
  const auto start = std::chrono::steady_clock::now();
  Soak_report all;
  std::uint64_t received = 0;
  const auto receive = [&](std::size_t, const std::string& text) {
    all.add(Soak_report::read(text));
    if (++received % 10000 == 0 || received == count)
      print(all, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  };
  const auto text_of = [&](std::size_t i, const SC::Visitor_reference& visitor) {
    Soak_report report;
    report.add(first + i, Soak_comparison(first + i, limits, visitor));
    return report.text();
  };
#ifdef SPLINE_CONSTRAINTS_SOAKS_WITH_MPI
  const boost::mpi::communicator world;
  SC::Mpi_report report;
  SC::run_tasks_mpi(world, count, text_of, receive,
                    {.silence = 120, .journal = count_of_arguments > 5 ? arguments[5] : ""},
                    "soak from " + std::to_string(first) + ", " + std::to_string(limits.exact) + " and " +
                        std::to_string(limits.certified) + " nodes",
                    &report);
  if (world.rank() != 0)
    return 0;
  for (int rank = 0; rank < world.size(); ++rank)
    std::cout << "rank " << rank << ": " << report.tasks[rank] << " systems in " << report.busy_seconds[rank]
              << " s of the processor\n";
#else
  for (std::uint64_t i = 0; i < count; ++i)
    receive(i, text_of(i, {}));
#endif
  const Soak_counts sum = all.sum();
  return sum[Soak_counts::SYSTEMS] == count && sum[Soak_counts::LOST] == 0 && sum[Soak_counts::EXTRA] == 0 ? 0 : 1;
}
