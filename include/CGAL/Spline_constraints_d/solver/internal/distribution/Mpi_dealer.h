// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_DEALER_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_DEALER_H

#include <CGAL/Spline_constraints_d/solver/Mpi_options.h>
#include <CGAL/Spline_constraints_d/solver/internal/control/Round_distribution.h>
#include <CGAL/Spline_constraints_d/solver/internal/distribution/Mpi_mail.h>
#include <CGAL/Spline_constraints_d/solver/internal/distribution/Task_dealer.h>
#include <CGAL/Spline_constraints_d/solver/internal/distribution/Task_result.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What becomes of the results of tasks, which come in packets.
struct Receiver_of_results
{
  std::function<void(Task_result)> receive;
  std::function<void()> end_packet = [] {};
};

/*
Rank 0: deals out the tasks of rounds, and does what the others have not taken. It looks after the others between its
own tasks, and within them as a visitor of the solver. A rank has two packets at hand, so that it need not wait. Tasks
of a rank that has been silent for long are dealt out again; whatever it says then, it is there again.
*/
class Mpi_dealer : public Round_distribution
{
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t no_round = static_cast<std::size_t>(-1);

  struct Peer
  {
    std::deque<std::size_t> dealt; // tasks of this round, without a result
    std::size_t last_packet = 0;
    std::size_t round = no_round; // that it is ready for
    Clock::time_point heard = Clock::now();
    bool is_silent = false, has_left = false;
  };

  Mpi_mail& m_mail;
  const Mpi_options& m_options;
  Mpi_report& m_report;
  std::vector<Peer> m_peers;         // that of this rank is not used
  std::vector<std::string> m_rounds; // messages with the results of those that have ended
  std::size_t m_round = 0;
  Task_dealer* m_tasks = nullptr; // of the round in hand
  Receiver_of_results m_receiver;
  Clock::time_point m_heard = Clock::now(), m_last_look = m_heard, m_last_sign = m_heard, m_last_report = m_heard;
  bool m_is_stopped = false;

public:
  Mpi_dealer(Mpi_mail& mail, const Mpi_options& options, Mpi_report& report)
    : m_mail(mail), m_options(options), m_report(report), m_peers(static_cast<std::size_t>(mail.size()))
  {
    m_report.tasks.resize(m_peers.size());
    m_report.busy_seconds.resize(m_peers.size());
  }

  // Does the tasks; receives the first result of each, until all are there or the work is to stop.
  void run(Task_dealer& tasks, const std::function<std::string(std::size_t)>& run_task,
           const Receiver_of_results& receiver, const std::function<bool()>& must_stop)
  {
    m_tasks = &tasks;
    m_receiver = receiver;
    while (!tasks.is_finished() && !must_stop())
      if (!run_own_packet(run_task, must_stop))
        wait();
    m_tasks = nullptr;
    for (Peer& peer : m_peers)
      peer.dealt.clear();
  }

  std::vector<std::string> results_of_round(std::size_t count, const std::function<std::string(std::size_t)>& run_task,
                                            const std::function<bool()>& must_stop) override
  {
    std::vector<std::string> results(count);
    Task_dealer tasks(count, m_peers.size());
    std::string exception;
    const auto receive = [&](Task_result result) {
      if (result.kind == Outcome_kind::RESULT)
        results[result.task] = std::move(result.bytes);
      else
        exception = std::move(result.bytes);
    };
    run(tasks, run_task, {receive}, [&] { return !exception.empty() || must_stop(); });
    if (!exception.empty())
      throw std::runtime_error(exception);
    for (std::size_t i = 0; i < count; ++i)
      if (!tasks.is_done(i))
        results[i] = run_task(i);
    if (!must_stop()) {
      Byte_writer message = message_about(Subject::ROUND);
      message.add(m_round);
      message.add(results.size());
      for (const std::string& result : results)
        message.add(std::string_view(result));
      m_rounds.push_back(message.take());
      for (int rank = 1; rank < m_mail.size(); ++rank)
        if (m_peers[rank].round == m_round)
          m_mail.send(rank, m_rounds.back());
      ++m_round;
    }
    return results;
  }

  // As a visitor of the solvers of this rank: looks after the others, and asks the visitor of the options.
  bool stop()
  {
    look(false);
    m_is_stopped = m_is_stopped || m_options.solver.visitor.stop();
    return m_is_stopped;
  }
  void on_progress(double share)
  {
    if (m_tasks == nullptr)
      m_options.solver.visitor.on_progress(share);
  }

  bool is_stopped() const { return m_is_stopped; }

  // Ends the work of all ranks, waits until each has left or was silent for long, and tells them who was lost.
  void end(End_of_work reason, const std::string& message)
  {
    note_silent_ranks();
    Byte_writer bytes = message_about(Subject::END);
    bytes.add(static_cast<int>(reason));
    bytes.add(std::string_view(message));
    send_to_all(bytes.take());
    const Clock::time_point start = Clock::now();
    const auto is_awaited = [&](const Peer& peer) { return &peer != &m_peers[0] && !peer.has_left && !peer.is_silent; };
    while (std::any_of(m_peers.begin(), m_peers.end(), is_awaited) && seconds_since(start) < m_options.silence)
      wait_for_mail();
    for (int rank = 1; rank < m_mail.size(); ++rank)
      if (!m_peers[rank].has_left)
        m_report.lost.push_back(rank);
    Byte_writer closing = message_about(Subject::CLOSED);
    closing.add(m_report.lost);
    send_to_all(closing.take());
    for (int rank = 1; rank < m_mail.size(); ++rank)
      while (m_peers[rank].has_left && !m_mail.is_sent(rank) && seconds_since(start) < 2 * m_options.silence)
        wait_for_mail();
  }

private:
  static double seconds_since(Clock::time_point time)
  {
    return std::chrono::duration<double>(Clock::now() - time).count();
  }

  void send_to_all(const std::string& message)
  {
    for (int rank = 1; rank < m_mail.size(); ++rank)
      m_mail.send(rank, message);
  }

  void wait_for_mail()
  {
    receive_mail();
    wait_since(m_heard);
  }

  void wait()
  {
    wait_since(m_heard);
    look(true);
  }

  // Some tasks of this rank; false when there is none.
  bool run_own_packet(const std::function<std::string(std::size_t)>& run_task, const std::function<bool()>& must_stop)
  {
    auto task = m_tasks->next_task();
    if (!task)
      return false;
    const Task_clock clock;
    const Clock::time_point end = Clock::now() + std::chrono::milliseconds(1);
    std::size_t count = 0;
    for (; task; task = Clock::now() < end && !must_stop() ? m_tasks->next_task() : std::nullopt) {
      take(Task_result::of(*task, run_task));
      ++count;
      look(false);
    }
    end_packet(0, clock.time_of(count));
    return true;
  }

  // Now and then, or now.
  void look(bool is_now)
  {
    const Clock::time_point now = Clock::now();
    if (!is_now && now - m_last_look < std::chrono::microseconds(200))
      return;
    m_last_look = now;
    receive_mail();
    note_silent_ranks();
    if (std::chrono::duration<double>(now - m_last_sign).count() > m_options.silence / 4) {
      m_last_sign = now;
      send_to_all(message_about(Subject::ALIVE).take());
    }
    if (m_tasks == nullptr)
      return;
    for (int rank = 1; rank < m_mail.size(); ++rank)
      deal(rank);
    if (now - m_last_report > std::chrono::milliseconds(50)) {
      m_last_report = now;
      m_options.solver.visitor.on_progress(
          1 - static_cast<double>(m_tasks->left()) / static_cast<double>((std::max)(m_tasks->count(), std::size_t(1))));
    }
  }

  void receive_mail()
  {
    m_mail.receive([&](int rank, const std::string& message) { receive(rank, message); });
  }

  void receive(int rank, const std::string& message)
  {
    Peer& peer = m_peers[rank];
    m_heard = peer.heard = Clock::now();
    peer.is_silent = false;
    Byte_reader bytes(message);
    switch (static_cast<Subject>(bytes.get<int>())) {
    case Subject::READY:
      bytes.read(peer.round);
      if (peer.round < m_rounds.size())
        m_mail.send(rank, m_rounds[peer.round]);
      break;
    case Subject::RESULTS:
      if (bytes.get<std::size_t>() == m_round)
        take_packet(rank, bytes);
      break;
    case Subject::LEAVES:
      peer.has_left = true;
      break;
    default:
      break;
    }
  }

  void take_packet(int rank, Byte_reader& bytes)
  {
    std::deque<std::size_t>& dealt = m_peers[rank].dealt;
    const Time_of_tasks time = Time_of_tasks::read(bytes);
    while (!bytes.is_at_end()) {
      Task_result result = Task_result::read(bytes);
      if (!dealt.empty() && dealt.front() == result.task) // as a rule
        dealt.pop_front();
      else
        std::erase(dealt, result.task);
      take(std::move(result));
    }
    end_packet(rank, time);
  }

  void take(Task_result result)
  {
    if (m_tasks != nullptr && m_tasks->mark_as_done(result.task))
      m_receiver.receive(std::move(result));
  }

  void end_packet(int rank, const Time_of_tasks& time)
  {
    m_report.tasks[rank] += time.count;
    m_report.busy_seconds[rank] += time.busy_seconds;
    if (m_tasks == nullptr || time.count == 0)
      return;
    m_tasks->add_time(time.count, time.seconds);
    m_receiver.end_packet();
  }

  void note_silent_ranks()
  {
    for (int rank = 1; rank < m_mail.size(); ++rank) {
      Peer& peer = m_peers[rank];
      if (peer.is_silent || peer.has_left || (seconds_since(peer.heard) < m_options.silence && !m_mail.is_broken(rank)))
        continue;
      peer.is_silent = true;
      if (m_tasks != nullptr)
        for (const std::size_t task : peer.dealt)
          if (!m_tasks->is_done(task)) {
            m_tasks->give_back(task);
            ++m_report.repeated;
          }
      peer.dealt.clear();
    }
  }

  // Until it has one packet more than that it is at.
  void deal(int rank)
  {
    Peer& peer = m_peers[rank];
    while (peer.round == m_round && !peer.is_silent && peer.dealt.size() <= peer.last_packet) {
      const std::vector<std::size_t> packet = m_tasks->next_packet();
      if (packet.empty())
        return;
      Byte_writer message = message_about(Subject::TASKS);
      message.add(m_round);
      message.add(packet);
      m_mail.send(rank, message.take());
      peer.last_packet = packet.size();
      peer.dealt.insert(peer.dealt.end(), packet.begin(), packet.end());
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_DEALER_H
