// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "repeated_runs.h"

#include <chrono>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <type_traits>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace peers {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

double cpu_seconds()
{
  timespec time;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Runs travel through the pipe byte for byte.
static_assert(std::is_trivially_copyable_v<Run>);

void send(int pipe, const Run& run)
{
  const char* bytes = reinterpret_cast<const char*>(&run);
  for (std::size_t sent = 0; sent < sizeof(Run);) {
    const ssize_t count = write(pipe, bytes + sent, sizeof(Run) - sent);
    if (count <= 0)
      _exit(1);
    sent += static_cast<std::size_t>(count);
  }
}

// What a program prints is no part of the table.
void silence()
{
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
}

[[noreturn]] void run_as_child(int pipe, const std::function<Run()>& body, const Run_limits& limits)
{
  silence();
  try {
    const auto start = Clock::now();
    for (int i = 0; i == 0 ||
         (seconds_since(start) < limits.longest_seconds &&
          (i <= limits.least_runs || seconds_since(start) < limits.seconds));
         ++i) {
      const double before = cpu_seconds();
      Run run = body();
      run.phases.total = cpu_seconds() - before;
      if (i > 0 || seconds_since(start) > limits.longest_seconds / 2)   // the first is for the caches
        send(pipe, run);
    }
  } catch (const std::exception&) {
    _exit(1);
  }
  _exit(0);   // without the destructors of objects that the parent owns too
}

} // namespace

Runs repeated_runs(const std::function<Run()>& body, const Run_limits& limits)
{
  std::fflush(nullptr);
  int ends[2];
  if (pipe(ends) != 0)
    throw std::runtime_error("no pipe to a child process");
  const pid_t child = fork();
  if (child < 0)
    throw std::runtime_error("no child process");
  if (child == 0) {
    close(ends[0]);
    run_as_child(ends[1], body, limits);
  }
  close(ends[1]);

  Runs result;
  Run run;
  std::size_t received = 0;
  for (const auto start = Clock::now();;) {
    const double left = limits.kill_seconds - seconds_since(start);
    pollfd source{ends[0], POLLIN, 0};
    if (left <= 0 || poll(&source, 1, static_cast<int>(1000 * left) + 1) == 0) {
      kill(child, SIGKILL);
      result.end = Runs::End::TIMED_OUT;
      break;
    }
    const ssize_t count = read(ends[0], reinterpret_cast<char*>(&run) + received, sizeof(Run) - received);
    if (count <= 0)
      break;
    received += static_cast<std::size_t>(count);
    if (received == sizeof(Run)) {
      result.runs.push_back(run);
      received = 0;
    }
  }
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (result.end == Runs::End::FINISHED && !(WIFEXITED(status) && WEXITSTATUS(status) == 0))
    result.end = Runs::End::CRASHED;
  return result;
}

} // namespace peers
