// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_COMPARE_IN_TURNS_H
#define CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_COMPARE_IN_TURNS_H

#include <benchmark/benchmark.h>

#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <string>
#include <vector>

namespace solver_benchmark {

inline double seconds_on_the_wall()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// CPU time of this thread: the clock of Google Benchmark is read between iterations only.
inline double seconds_of_thread()
{
  timespec time;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

inline double median(std::vector<double> times)
{
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

inline double least(const std::vector<double>& times) { return *std::min_element(times.begin(), times.end()); }

// Both in turns, so that what else the machine does hits both alike. The ratio is that of the medians, and another one
// that of the least times: cores of virtual machines are not always there.
template <class First, class Second, class Clock>
void compare_in_turns(benchmark::State& state, const First& first, const Second& second, const std::string& first_name,
                      const std::string& second_name, const Clock& clock)
{
  std::vector<double> first_times, second_times;
  const auto run = [&](const auto& solve_all, std::vector<double>& times) {
    const double start = clock();
    solve_all();
    times.push_back(clock() - start);
  };
  for (auto _ : state) {
    run(first, first_times);
    run(second, second_times);
  }
  state.counters[first_name + "_ms"] = 1000 * median(first_times);
  state.counters[second_name + "_ms"] = 1000 * median(second_times);
  state.counters[first_name + "_to_" + second_name] = median(first_times) / median(second_times);
  state.counters["least_" + first_name + "_to_" + second_name] = least(first_times) / least(second_times);
}

} // namespace solver_benchmark

#endif // CGAL_SPLINE_CONSTRAINTS_D_BENCHMARK_COMPARE_IN_TURNS_H
