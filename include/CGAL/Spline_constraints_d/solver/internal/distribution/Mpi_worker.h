// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_WORKER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_WORKER_H

#include <CGAL/Spline_constraints_d/solver/Mpi_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Round_distribution.h>
#include <CGAL/Spline_constraints_d/solver/internal/distribution/Mpi_mail.h>
#include <CGAL/Spline_constraints_d/solver/internal/distribution/Task_result.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Is thrown on the other ranks where rank 0 has ended the work of all.
struct Work_has_ended
{};

/*
Another rank than 0: does the tasks of the rounds that it is given, in packets. The results of a packet are sent
together, and those that are there in any case before rank 0 waits for long. It looks for messages between tasks, and
within them as a visitor of the solver.
*/
class Mpi_worker : public Round_distribution
{
  using Clock = std::chrono::steady_clock;
  static constexpr double seconds_of_results = 0.05; // after which they are sent before the packet is done
  static constexpr double silence_of_rank_0 = 100;   // times that of others: nobody does its work

  Mpi_mail& m_mail;
  const Mpi_options& m_options;
  Mpi_report& m_report;
  std::size_t m_round = 0;
  std::deque<std::vector<std::size_t>> m_packets; // the first one is in hand
  std::size_t m_done = 0;                         // tasks of that one
  std::vector<std::string> m_results_of_round;
  bool m_has_results_of_round = false, m_has_ended = false, m_is_closed = false;
  End_of_work m_reason = End_of_work::DONE;
  std::string m_message;
  Byte_writer m_results; // that are not sent
  std::size_t m_waiting_results = 0;
  Task_clock m_clock; // of the tasks that they are of
  Clock::time_point m_heard = Clock::now(), m_last_look = m_heard, m_last_sign = m_heard;

public:
  Mpi_worker(Mpi_mail& mail, const Mpi_options& options, Mpi_report& report)
    : m_mail(mail), m_options(options), m_report(report)
  {
    m_report.tasks.resize(static_cast<std::size_t>(mail.size()));
    m_report.busy_seconds.resize(static_cast<std::size_t>(mail.size()));
  }

  // Does tasks until all ranks have the results of the round; throws when the work has ended.
  void run(const std::function<std::string(std::size_t)>& run_task)
  {
    Byte_writer message = message_about(Subject::READY);
    message.add(m_round);
    send(message.take());
    while (!m_has_results_of_round) {
      if (m_packets.empty())
        wait();
      else
        look(false);
      if (m_has_ended)
        throw Work_has_ended();
      if (!m_packets.empty())
        run_next(run_task);
    }
  }

  std::vector<std::string> results_of_round(std::size_t, const std::function<std::string(std::size_t)>& run_task,
                                            const std::function<bool()>&) override
  {
    run(run_task);
    m_packets.clear();
    m_done = 0;
    m_results.clear();
    m_waiting_results = 0;
    m_has_results_of_round = false;
    ++m_round;
    return std::move(m_results_of_round);
  }

  // As a visitor of the solvers of this rank.
  bool stop()
  {
    look(false);
    return m_has_ended;
  }
  void on_progress(double) {}

  // Waits for the end of the work, if it has not been, and leaves. A rank that is not told who was lost has come too
  // late, and is lost itself.
  std::pair<End_of_work, std::string> leave()
  {
    while (!m_has_ended)
      wait();
    send(message_about(Subject::LEAVES).take());
    const Clock::time_point start = Clock::now();
    while ((!m_is_closed || !m_mail.is_sent(0)) && seconds_since(start) < 2 * m_options.silence)
      wait();
    if (!m_is_closed)
      m_report.lost.push_back(m_mail.rank());
    return {m_reason, m_message};
  }

private:
  static double seconds_since(Clock::time_point time)
  {
    return std::chrono::duration<double>(Clock::now() - time).count();
  }

  void wait()
  {
    wait_since(m_heard);
    look(true);
  }

  void send(const std::string& message)
  {
    m_last_sign = Clock::now();
    m_mail.send(0, message);
    if (m_mail.is_broken(0))
      throw std::runtime_error("Spline_constraints_d: rank 0 cannot be reached");
  }

  // The next task of the packet in hand.
  void run_next(const std::function<std::string(std::size_t)>& run_task)
  {
    if (m_waiting_results == 0)
      m_clock = {};
    Task_result::of(m_packets.front()[m_done], run_task).write(m_results);
    if (m_has_ended)
      throw Work_has_ended();
    ++m_waiting_results;
    if (++m_done < m_packets.front().size())
      return;
    m_packets.pop_front();
    m_done = 0;
    send_results();
  }

  void send_results()
  {
    if (m_waiting_results == 0)
      return;
    const Time_of_tasks time = m_clock.time_of(std::exchange(m_waiting_results, 0));
    m_report.tasks[m_mail.rank()] += time.count;
    m_report.busy_seconds[m_mail.rank()] += time.busy_seconds;
    Byte_writer message = message_about(Subject::RESULTS);
    message.add(m_round);
    time.write(message);
    message.append(m_results.bytes());
    m_results.clear();
    send(message.take());
    m_clock = {};
  }

  // Now and then, or now.
  void look(bool is_now)
  {
    const Clock::time_point now = Clock::now();
    if (!is_now && now - m_last_look < std::chrono::microseconds(200))
      return;
    m_last_look = now;
    m_mail.receive([&](int, const std::string& message) { receive(message); });
    if (m_has_ended)
      return;
    const double since_sign = std::chrono::duration<double>(now - m_last_sign).count();
    if (since_sign > seconds_of_results)
      send_results();
    if (since_sign > m_options.silence / 4)
      send(message_about(Subject::ALIVE).take());
    if (seconds_since(m_heard) > silence_of_rank_0 * m_options.silence)
      throw std::runtime_error("Spline_constraints_d: rank 0 is silent");
  }

  void receive(const std::string& message)
  {
    m_heard = Clock::now();
    Byte_reader bytes(message);
    switch (static_cast<Subject>(bytes.get<int>())) {
    case Subject::TASKS:
      if (bytes.get<std::size_t>() == m_round)
        bytes.read(m_packets.emplace_back());
      break;
    case Subject::ROUND:
      if (bytes.get<std::size_t>() == m_round) {
        bytes.read(m_results_of_round);
        m_has_results_of_round = true;
      }
      break;
    case Subject::END:
      m_reason = static_cast<End_of_work>(bytes.get<int>());
      bytes.read(m_message);
      m_has_ended = true;
      break;
    case Subject::CLOSED:
      bytes.read(m_report.lost);
      m_is_closed = true;
      break;
    default:
      break;
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_WORKER_H
