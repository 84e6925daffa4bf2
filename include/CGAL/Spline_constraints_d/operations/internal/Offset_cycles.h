// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_OFFSET_CYCLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_OFFSET_CYCLES_H

#include <CGAL/Spline_constraints_d/internal/parallel_for.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/internal/Free_disks.h>
#include <CGAL/Spline_constraints_d/operations/internal/Front_offset.h>
#include <CGAL/Spline_constraints_d/operations/internal/Touched_front.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The points at one distance from all curves of a graph, as chains of offsets of fronts.

They consist of the centers of the free disks of all fronts. Where a front ends, the next one goes on. Where a disk has a second contact, the chain goes over to the front of that: there, the contact with the first front bounds a range of free disks, too. It is the only boundary in the range of the parameter that holds the contact, so
the two are connected by proof, and nothing is compared by coordinates. As fronts are traversed with the free side on the left, so are chains.

A chain is an outer boundary of a set, the side that is free or the other one, or one of its holes. Let X be a point of the curves that is nearest to a point O of the chain. The segment between does not meet any chain elsewhere, and X is at least the radius away from all of them. So all questions are answered by the numbers of times chains
go around such X.
*/
class Offset_cycles
{
public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  // A range of free disks of a front.
  struct Piece
  {
    std::size_t front;
    Free_range range;
  };

  struct Chain
  {
    std::vector<std::size_t> pieces;
    bool is_closed;
    bool is_hole = false;       // of the set
    std::size_t outer = none;   // the chain around the same component of the set
  };

private:
  std::shared_ptr<const Site_graph_2> m_graph;
  Interval m_radius;
  std::vector<Free_ranges> m_ranges;                   // of each front
  std::vector<std::size_t> m_first_piece_of;           // of each front, and the number of pieces
  std::vector<Piece> m_pieces;
  std::vector<Chain> m_chains;
  bool m_is_nested = true;

public:
  Offset_cycles(std::shared_ptr<const Site_graph_2> graph, const Interval& radius, std::vector<Free_ranges> ranges, bool is_set_free) : m_graph(std::move(graph)), m_radius(radius), m_ranges(std::move(ranges))
  {
    const Upward_rounding_guard guard;
    for (std::size_t f = 0; f < m_ranges.size(); ++f) {
      m_first_piece_of.push_back(m_pieces.size());
      for (const Free_range& range : m_ranges[f].free)
        m_pieces.push_back({f, range});
    }
    m_first_piece_of.push_back(m_pieces.size());
    connect_pieces();
    nest_chains(is_set_free);
  }

  const Site_graph_2& graph() const { return *m_graph; }
  const std::vector<Piece>& pieces() const { return m_pieces; }
  const std::vector<Chain>& chains() const { return m_chains; }
  const Front& front(const Piece& piece) const { return m_graph->fronts()[piece.front]; }
  Front_offset offset(const Piece& piece) const { return {*m_graph, piece.front, m_radius}; }

  // Whether all fronts are decided, and all chains closed and nested.
  bool is_complete() const
  {
    return m_graph->is_proved() && m_is_nested && std::all_of(m_ranges.begin(), m_ranges.end(), [](const Free_ranges& ranges) { return ranges.undecided.empty(); }) && std::all_of(m_chains.begin(), m_chains.end(), [](const Chain& chain) { return chain.is_closed; });
  }

  // The parameters where a piece begins and ends in the order of traversal; disks between them are free.
  std::array<double, 2> parameters(const Piece& piece) const
  {
    const double begin = piece.range[0].location.end, end = piece.range[1].location.begin;
    return front(piece).is_reversed ? std::array{end, begin} : std::array{begin, end};
  }

private:
  const Free_end& end(const Piece& piece, bool is_end) const { return piece.range[is_end != front(piece).is_reversed]; }

  void connect_pieces()
  {
    std::vector<std::size_t> next(m_pieces.size(), none), previous(m_pieces.size(), none);
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
      if (const std::size_t j = piece_behind(m_pieces[i]); j != none && previous[j] == none) {
        next[i] = j;
        previous[j] = i;
      }
    std::vector<char> is_visited(m_pieces.size(), false);
    const auto append_chain = [&](std::size_t first) {
      Chain chain{{}, previous[first] != none};
      for (std::size_t i = first; i != none && !is_visited[i]; i = next[i]) {
        is_visited[i] = true;
        chain.pieces.push_back(i);
      }
      m_chains.push_back(std::move(chain));
    };
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
      if (previous[i] == none)
        append_chain(i);
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
      if (!is_visited[i])
        append_chain(i);
  }

  std::size_t piece_behind(const Piece& piece) const
  {
    switch (end(piece, true).kind) {
    case Free_end::Kind::FRONT_END: return first_piece(front(piece).next);
    case Free_end::Kind::CONTACT: return piece_across(piece);
    default: return none;
    }
  }

  std::size_t first_piece(std::size_t f) const
  {
    const std::size_t first = m_first_piece_of[f], last = m_first_piece_of[f + 1];
    if (first == last)
      return none;
    const std::size_t i = m_graph->fronts()[f].is_reversed ? last - 1 : first;
    return end(m_pieces[i], false).kind == Free_end::Kind::FRONT_END ? i : none;
  }

  // The piece that begins where another one ends in a second contact.
  std::size_t piece_across(const Piece& piece) const
  {
    const Free_end& contact = end(piece, true);
    const auto touched = touched_front(*m_graph, contact.contact, contact.contact_location, offset(piece).point(contact.location));
    if (!touched || std::any_of(m_ranges[touched->front].undecided.begin(), m_ranges[touched->front].undecided.end(), [&](const Range& range) { return range.meets(touched->range); }))
      return none;
    std::vector<std::pair<std::size_t, bool>> ends;   // there
    for (std::size_t i = m_first_piece_of[touched->front]; i < m_first_piece_of[touched->front + 1]; ++i)
      for (const bool is_end : {false, true})
        if (const Free_end& e = end(m_pieces[i], is_end); e.kind == Free_end::Kind::CONTACT && e.location.meets(touched->range))
          ends.emplace_back(i, is_end);
    const bool is_certain = ends.size() == 1 && !ends[0].second && is_contact_with(end(m_pieces[ends[0].first], false).contact, front(piece));
    return is_certain ? ends[0].first : none;
  }

  // A point of the curves that is nearest to a point of a chain.
  Interval_pair foot(const Chain& chain) const
  {
    const Piece& piece = m_pieces[chain.pieces.front()];
    const auto [from, to] = parameters(piece);
    const double u = from / 2 + to / 2;
    return m_graph->front_jet(front(piece), {u, u}).point;
  }

  // How often a closed chain goes around a point, counterclockwise; if that is not certain, 0, and the result is not complete.
  int winding_number(const Chain& chain, const Interval_pair& p)
  {
    constexpr double most_error = 0.01;
    double turns = 0;
    for (const std::size_t i : chain.pieces) {
      const auto [from, to] = parameters(m_pieces[i]);
      const auto angle = offset(m_pieces[i]).turn_around(p, from, to);
      m_is_nested = m_is_nested && angle;
      turns += angle.value_or(0) / (2 * CGAL_PI);
    }
    const double result = std::round(turns);
    m_is_nested = m_is_nested && std::abs(turns - result) < most_error;
    return static_cast<int>(result);
  }

  void nest_chains(bool is_set_free)
  {
    std::vector<std::size_t> outer;
    for (std::size_t c = 0; c < m_chains.size(); ++c)
      if (Chain& chain = m_chains[c]; chain.is_closed) {
        chain.is_hole = (winding_number(chain, foot(chain)) == 0) != is_set_free;
        if (!chain.is_hole)
          outer.push_back(c);
      }
    const auto around = [&](std::size_t c) {   // the outer chains around the foot of a chain
      const Interval_pair p = foot(m_chains[c]);
      std::vector<std::size_t> result;
      for (const std::size_t o : outer)
        if (o != c && winding_number(m_chains[o], p) != 0)
          result.push_back(o);
      return result;
    };
    std::vector<std::size_t> depth(m_chains.size(), 0);
    for (const std::size_t o : outer) {
      m_chains[o].outer = o;
      depth[o] = around(o).size();
    }
    for (std::size_t c = 0; c < m_chains.size(); ++c)
      if (m_chains[c].is_hole) {
        const std::vector<std::size_t> candidates = around(c);
        if (candidates.empty())
          m_is_nested = false;
        else
          m_chains[c].outer = *std::max_element(candidates.begin(), candidates.end(), [&](std::size_t a, std::size_t b) { return depth[a] < depth[b]; });
      }
  }
};

// The offset on some of the fronts of a graph: of the set that is free, or of the other one. With a tag for parallel work, fronts are handed to all cores.
template <class Concurrency_tag>
Offset_cycles offset_cycles(std::shared_ptr<const Site_graph_2> graph, const Exact_rational& radius, const std::vector<std::size_t>& fronts, bool is_set_free)
{
  const Site_tree_2 tree(*graph);
  std::vector<Free_ranges> ranges(graph->fronts().size());
  parallel_for<Concurrency_tag>(fronts.size(), [&](std::size_t i, std::size_t) {
    const Upward_rounding_guard guard;
    ranges[fronts[i]] = Free_disks(*graph, tree, radius)(fronts[i]);
  });
  return Offset_cycles(std::move(graph), interval_of(radius), std::move(ranges), is_set_free);
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_OFFSET_CYCLES_H
