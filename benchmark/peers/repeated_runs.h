// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_REPEATED_RUNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_REPEATED_RUNS_H

#include "curve_intersection.h"

#include <functional>
#include <vector>

// Runs in a process of their own: a program that crashes or does not end costs its cell of the table, not the table.
namespace peers {

struct Run_limits
{
  int least_runs = 5;
  double seconds = 0.1;          // after which no run is added to these
  double longest_seconds = 2;    // after which none is added at all
  double kill_seconds = 20;      // after which the process is killed
};

struct Runs
{
  enum class End { FINISHED, TIMED_OUT, CRASHED };

  std::vector<Run> runs;   // that came to their end, with the CPU time of the process
  End end = End::FINISHED;
};

//! runs `body` in a child process again and again, once more before the first run that counts, unless one run takes too
//! long for that.
Runs repeated_runs(const std::function<Run()>& body, const Run_limits& limits);

} // namespace peers

#endif // CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_PEERS_REPEATED_RUNS_H
