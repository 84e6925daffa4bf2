// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_MAIL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_MAIL_H

#include <boost/mpi/communicator.hpp>

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Waits a little for the next message. The longer there was none, the longer: the processor is left to others, and what
// comes is seen after an eighth of the time that it took at most.
inline void wait_since(std::chrono::steady_clock::time_point last_message)
{
  using std::chrono::microseconds;
  const auto waited = std::chrono::duration_cast<microseconds>(std::chrono::steady_clock::now() - last_message);
  std::this_thread::sleep_for(std::clamp(waited / 8, microseconds(50), microseconds(1000)));
}

/*
Messages between ranks of which one may die at any time. Nothing here waits for another rank. Messages travel as a
stream of pieces so short that MPI hands each over at once: of a long one, which is handed over when the receiver asks
for it, a rank that has died would leave a part. Pieces that are on their way at the end, to or from a rank that does
not answer, keep their memory.
*/
class Mpi_mail
{
  static constexpr int tag = 0x5c;
  static constexpr std::size_t size_of_piece = 4000;

  // Its pieces are parts of one string.
  struct Message
  {
    std::string bytes;
    std::vector<MPI_Request> requests;
    std::size_t complete = 0;
  };

  struct Piece
  {
    std::vector<char> bytes;
    MPI_Request request = MPI_REQUEST_NULL;
  };

  struct Stream
  {
    std::deque<Piece> on_the_way;
    std::string bytes;     // of messages that are not complete,
    std::size_t begin = 0; // from here on
  };

  boost::mpi::communicator m_ranks;
  std::map<int, std::deque<Message>> m_sent;
  std::map<int, Stream> m_received;
  std::set<int> m_broken;

public:
  // To be called by all ranks together.
  explicit Mpi_mail(const boost::mpi::communicator& ranks) : m_ranks(copy_of(ranks), boost::mpi::comm_take_ownership)
  {
    MPI_Comm_set_errhandler(m_ranks, MPI_ERRORS_RETURN);
  }

  Mpi_mail(const Mpi_mail&) = delete;
  Mpi_mail& operator=(const Mpi_mail&) = delete;

  ~Mpi_mail()
  {
    if (m_broken.empty() &&
        std::all_of(m_sent.begin(), m_sent.end(), [](const auto& sent) { return sent.second.empty(); }) &&
        std::all_of(m_received.begin(), m_received.end(), [](const auto& s) { return s.second.on_the_way.empty(); }))
      return;
    new std::pair(std::move(m_sent), std::move(m_received));
    new boost::mpi::communicator(m_ranks);
  }

  int rank() const { return m_ranks.rank(); }
  int size() const { return m_ranks.size(); }

  // MPI has said that the rank cannot be reached.
  bool is_broken(int rank) const { return m_broken.count(rank) > 0; }

  void send(int rank, const std::string& message)
  {
    const std::uint64_t size = message.size();
    Message& sent = m_sent[rank].emplace_back();
    sent.bytes.resize(sizeof size + message.size());
    std::memcpy(sent.bytes.data(), &size, sizeof size);
    std::copy(message.begin(), message.end(), sent.bytes.begin() + sizeof size);
    for (std::size_t begin = 0; begin < sent.bytes.size() && !is_broken(rank); begin += size_of_piece) {
      const int length = static_cast<int>((std::min)(size_of_piece, sent.bytes.size() - begin));
      note(rank,
           MPI_Isend(sent.bytes.data() + begin, length, MPI_CHAR, rank, tag, m_ranks,
                     &sent.requests.emplace_back(MPI_REQUEST_NULL)));
    }
  }

  // Messages to this rank have left.
  bool is_sent(int rank)
  {
    std::deque<Message>& messages = m_sent[rank];
    while (!messages.empty()) {
      Message& first = messages.front();
      while (first.complete < first.requests.size() && is_complete(rank, first.requests[first.complete]))
        ++first.complete;
      if (first.complete < first.requests.size() || is_broken(rank))
        break;
      messages.pop_front();
    }
    return messages.empty();
  }

  // Calls receive(rank, message) for what has come.
  template <class Receiver>
  void receive(const Receiver& receive)
  {
    for (MPI_Status status; has_piece(status);) {
      int size = 0;
      MPI_Get_count(&status, MPI_CHAR, &size);
      const int rank = status.MPI_SOURCE;
      Piece& piece = m_received[rank].on_the_way.emplace_back();
      piece.bytes.resize(static_cast<std::size_t>(size));
      note(rank, MPI_Irecv(piece.bytes.data(), size, MPI_CHAR, rank, tag, m_ranks, &piece.request));
      take_messages(rank, receive);
    }
    for (auto& [rank, stream] : m_received)
      if (!stream.on_the_way.empty())
        take_messages(rank, receive);
    for (auto& [rank, messages] : m_sent)
      is_sent(rank);
  }

private:
  // Unlike MPI_Comm_dup(), it leaves the core to others while some rank is late.
  static MPI_Comm copy_of(const boost::mpi::communicator& ranks)
  {
    constexpr int tests_at_once = 100;
    const auto start = std::chrono::steady_clock::now();
    MPI_Comm copy = MPI_COMM_NULL;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Comm_idup(ranks, &copy, &request);
    int is_there = 0;
    for (int tests = 0; is_there == 0; ++tests) {
      MPI_Test(&request, &is_there, MPI_STATUS_IGNORE);
      if (is_there == 0 && tests > tests_at_once)
        wait_since(start);
    }
    return copy;
  }

  // None as well when MPI only says that a connection has broken, without the rank.
  bool has_piece(MPI_Status& status)
  {
    int is_there = 0;
    return MPI_Iprobe(MPI_ANY_SOURCE, tag, m_ranks, &is_there, &status) == MPI_SUCCESS && is_there != 0;
  }

  // What MPI has said of a rank.
  void note(int rank, int error)
  {
    if (error != MPI_SUCCESS)
      m_broken.insert(rank);
  }

  bool is_complete(int rank, MPI_Request& request)
  {
    int is_done = 0;
    note(rank, MPI_Test(&request, &is_done, MPI_STATUS_IGNORE));
    return is_done != 0 && !is_broken(rank);
  }

  template <class Receiver>
  void take_messages(int rank, const Receiver& receive)
  {
    Stream& stream = m_received[rank];
    while (!stream.on_the_way.empty() && is_complete(rank, stream.on_the_way.front().request)) {
      stream.bytes.append(stream.on_the_way.front().bytes.begin(), stream.on_the_way.front().bytes.end());
      stream.on_the_way.pop_front();
    }
    std::uint64_t size = 0;
    while (stream.bytes.size() - stream.begin >= sizeof size) {
      std::memcpy(&size, stream.bytes.data() + stream.begin, sizeof size);
      if (stream.bytes.size() - stream.begin < sizeof size + size)
        break;
      const std::string message = stream.bytes.substr(stream.begin + sizeof size, size);
      stream.begin += sizeof size + size;
      receive(rank, message);
    }
    stream.bytes.erase(0, std::exchange(stream.begin, 0));
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_MAIL_H
