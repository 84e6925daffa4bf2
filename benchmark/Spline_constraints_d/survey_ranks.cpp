// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*
mpirun -n 2 survey_ranks [rounds = 5] [part of a name]

What all ranks of MPI gain over one, for batches of small, of middling and of mixed systems, and for the boxes of one
hard system. Each is solved by rank 0 alone and by all in turns; prints the least times on the wall and the efficiency,
which is the time alone divided by the time together and by the number of ranks. The efficiency by processor time has
the time of the rank that worked most; it leaves waiting out, and so what other programs on the machine take. Of these
times it is the medians, as other programs make a core now faster and now slower.
*/

#include "solver_test_systems.h"

#include <CGAL/Spline_constraints_d/solver/batch.h>
#include <CGAL/Spline_constraints_d/solver/batch_mpi.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/environment.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <iomanip>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

using namespace solver_test;
namespace mpi = boost::mpi;

struct Times
{
  double on_the_wall, of_the_processor;
};

static Times times_of(const std::function<void()>& work)
{
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  work();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}

// Unlike MPI_Barrier(), it leaves the core to others.
static void wait_for_all(const mpi::communicator& world)
{
  MPI_Request request;
  MPI_Ibarrier(world, &request);
  for (int is_done = 0; is_done == 0; std::this_thread::sleep_for(std::chrono::microseconds(100)))
    MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
}

// On the wall.
static double least(const std::vector<Times>& times)
{
  return std::ranges::min(times, {}, &Times::on_the_wall).on_the_wall;
}

// Of the processor.
static double median(std::vector<Times> times)
{
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::ranges::nth_element(times, middle, {}, &Times::of_the_processor);
  return middle->of_the_processor;
}

static std::string part_of_names;

// `alone` is called by rank 0, `together` by all.
static void compare(const std::string& name, int rounds, const std::function<void()>& alone,
                    const std::function<void()>& together)
{
  if (name.find(part_of_names) == std::string::npos)
    return;
  const mpi::communicator world;
  std::vector<Times> all_alone, all_together;
  for (int round = 0; round < rounds; ++round) {
    if (world.rank() == 0)
      all_alone.push_back(times_of(alone));
    wait_for_all(world);
    Times& times = all_together.emplace_back(times_of(together));
    times.of_the_processor = mpi::all_reduce(world, times.of_the_processor, mpi::maximum<double>());
  }
  if (world.rank() != 0)
    return;
  const double least_alone = least(all_alone), least_together = least(all_together);
  std::cout << std::left << std::setw(28) << name << std::right << std::setw(9) << least_alone << " s" << std::setw(9)
            << least_together << " s, efficiency " << least_alone / least_together / world.size()
            << ", by processor time " << median(all_alone) / median(all_together) / world.size() << std::endl;
}

static void compare_batches(const std::string& name, int rounds, const std::vector<System>& systems)
{
  const mpi::communicator world;
  compare(
      name, rounds, [&] { SC::solve(systems); },
      [&] { SC::solve_batch_mpi(world, systems); });
}

static void compare_boxes(const std::string& name, int rounds, const System& system)
{
  const mpi::communicator world;
  compare(
      name, rounds, [&] { SC::solve(system); },
      [&] { SC::solve_mpi(world, system); });
}

int main(int count, char** arguments)
{
  mpi::environment environment(count, arguments);
  const int rounds = count > 1 ? std::atoi(arguments[1]) : 5;
  part_of_names = count > 2 ? arguments[2] : "";
  std::cout << std::setprecision(3);

  compare_batches("10,000 of 9 roots", rounds, std::vector<System>(10000, cyclic_chebyshev(2, 3).system));
  compare_batches("500 of 64 roots", rounds, std::vector<System>(500, cyclic_chebyshev(3, 4).system));
  std::vector<System> mixed;
  for (int i = 0; i < 60; ++i)
    for (const Problem& problem : {cyclic_chebyshev(2, 2 + i % 8), broyden_tridiagonal(2 + i % 6), circle_and_ellipse(),
                                   cyclic_chebyshev(1 + i % 4, 3), lines_tangent_to_spheres()})
      mixed.push_back(problem.system);
  compare_batches("300 of all sizes", rounds, mixed);
  compare_boxes("boxes, cyclic 8, degree 2", rounds, cyclic_chebyshev(8, 2).system);
  compare_boxes("boxes, mixed 4, degree 4", rounds, mixed_chebyshev(4, 4).system);
  compare_boxes("boxes, mixed 4, degree 5", rounds, mixed_chebyshev(4, 5).system);
  compare_boxes("boxes, mixed 5, degree 3", rounds, mixed_chebyshev(5, 3).system);
  return 0;
}
