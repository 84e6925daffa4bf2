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
#include <boost/mpi/exception.hpp>
#include <boost/mpi/request.hpp>
#include <boost/mpi/status.hpp>
#include <boost/optional.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Messages between ranks of which one may die at any time. Nothing here waits for another rank. Messages travel as a
stream of packets so short that MPI hands each over at once: of a long one, which is handed over when the receiver asks
for it, a rank that has died would leave a part. Packets that are on their way at the end, to or from a rank that does
not answer, keep their memory.
*/
class Mpi_mail
{
  static constexpr int tag = 0x5c;
  static constexpr std::size_t size_of_packet = 2000;

  struct Packet
  {
    std::vector<char> bytes;
    boost::mpi::request request;
  };

  struct Stream
  {
    std::deque<Packet> on_the_way;
    std::string bytes; // of messages that are not complete
  };

  boost::mpi::communicator m_ranks;
  std::map<int, std::deque<Packet>> m_sent;
  std::map<int, Stream> m_received;
  std::set<int> m_broken;

public:
  // To be called by all ranks together.
  explicit Mpi_mail(const boost::mpi::communicator& ranks) : m_ranks(ranks, boost::mpi::comm_duplicate)
  {
    MPI_Comm_set_errhandler(m_ranks, MPI_ERRORS_RETURN);
  }

  Mpi_mail(const Mpi_mail&) = delete;
  Mpi_mail& operator=(const Mpi_mail&) = delete;

  ~Mpi_mail()
  {
    const auto is_open = [](const auto& of_rank) { return !packets(of_rank.second).empty(); };
    if (m_broken.empty() && std::none_of(m_sent.begin(), m_sent.end(), is_open) &&
        std::none_of(m_received.begin(), m_received.end(), is_open))
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
    std::vector<char> bytes(sizeof size);
    std::memcpy(bytes.data(), &size, sizeof size);
    bytes.insert(bytes.end(), message.begin(), message.end());
    for (std::size_t begin = 0; begin < bytes.size() && !is_broken(rank); begin += size_of_packet) {
      const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
      Packet& packet = m_sent[rank].emplace_back();
      packet.bytes.assign(first, first + static_cast<std::ptrdiff_t>((std::min)(size_of_packet, bytes.size() - begin)));
      guarded(rank, [&] {
        packet.request = m_ranks.isend(rank, tag, packet.bytes.data(), static_cast<int>(packet.bytes.size()));
      });
    }
  }

  // Packets to this rank have left.
  bool is_sent(int rank)
  {
    std::deque<Packet>& packets = m_sent[rank];
    while (!packets.empty() && !is_broken(rank) && is_complete(rank, packets.front()))
      packets.pop_front();
    return packets.empty();
  }

  // Calls receive(rank, message) for what has come.
  template <class Receiver>
  void receive(const Receiver& receive)
  {
    while (const auto status = next_packet()) {
      const int size = *status->template count<char>();
      Packet& packet = m_received[status->source()].on_the_way.emplace_back();
      packet.bytes.resize(static_cast<std::size_t>(size));
      guarded(status->source(),
              [&] { packet.request = m_ranks.irecv(status->source(), tag, packet.bytes.data(), size); });
      take_messages(status->source(), receive);
    }
    for (auto& [rank, stream] : m_received)
      if (!stream.on_the_way.empty())
        take_messages(rank, receive);
    for (auto& [rank, packets] : m_sent)
      is_sent(rank);
  }

private:
  static const std::deque<Packet>& packets(const std::deque<Packet>& sent) { return sent; }
  static const std::deque<Packet>& packets(const Stream& received) { return received.on_the_way; }

  // None as well when MPI only says that a connection has broken, without the rank.
  boost::optional<boost::mpi::status> next_packet()
  {
    try {
      return m_ranks.iprobe(boost::mpi::any_source, tag);
    } catch (const boost::mpi::exception&) {
      return {};
    }
  }

  template <class Call>
  void guarded(int rank, const Call& call)
  {
    try {
      call();
    } catch (const boost::mpi::exception&) {
      m_broken.insert(rank);
    }
  }

  bool is_complete(int rank, Packet& packet)
  {
    bool result = false;
    guarded(rank, [&] { result = packet.request.test().has_value(); });
    return result;
  }

  template <class Receiver>
  void take_messages(int rank, const Receiver& receive)
  {
    Stream& stream = m_received[rank];
    while (!stream.on_the_way.empty() && is_complete(rank, stream.on_the_way.front())) {
      stream.bytes.append(stream.on_the_way.front().bytes.begin(), stream.on_the_way.front().bytes.end());
      stream.on_the_way.pop_front();
    }
    std::uint64_t size = 0;
    while (stream.bytes.size() >= sizeof size) {
      std::memcpy(&size, stream.bytes.data(), sizeof size);
      if (stream.bytes.size() < sizeof size + size)
        break;
      const std::string message = stream.bytes.substr(sizeof size, size);
      stream.bytes.erase(0, sizeof size + size);
      receive(rank, message);
    }
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_DISTRIBUTION_MPI_MAIL_H
