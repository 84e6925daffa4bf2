// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_FREE_CHAINS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_FREE_CHAINS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/envelope/Touched_element.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Free_ranges.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Touching_disk.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/for_each_element.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/undecided_parts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The centers of the free disks of all elements, as chains.

Where an element ends, the next one goes on. Where a disk has a second footpoint, the chain goes over to the element of
that: there, the footpoint with the first element bounds a range of free disks, too. It is the only boundary in the
range of the parameter that holds the footpoint, so the two are connected by proof, and nothing is compared by
coordinates. As elements are traversed with the free side on the left, so are chains.
*/
class Free_chains
{
public:
  static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

  // A range of free disks of an element.
  struct Piece
  {
    std::size_t element;
    Free_range range;
  };

  struct Chain
  {
    std::vector<std::size_t> pieces;
    bool is_closed;
  };

private:
  const Site_graph_2<>& m_graph;
  std::vector<Free_ranges> m_ranges;             // of each element
  std::vector<std::size_t> m_first_piece_of;     // of each element, and the number of pieces
  std::vector<Piece> m_pieces;
  std::vector<Chain> m_chains;

public:
  // An enclosure of the disk where a piece has a second footpoint has the center `center(element, end)`.
  template <class Center>
  Free_chains(const Site_graph_2<>& graph, std::vector<Free_ranges> ranges, const Center& center)
    : m_graph(graph), m_ranges(std::move(ranges))
  {
    for (std::size_t f = 0; f < m_ranges.size(); ++f) {
      m_first_piece_of.push_back(m_pieces.size());
      for (const Free_range& range : m_ranges[f].free)
        m_pieces.push_back({f, range});
    }
    m_first_piece_of.push_back(m_pieces.size());
    connect_pieces(center);
  }

  const std::vector<Piece>& pieces() const { return m_pieces; }
  const std::vector<Chain>& chains() const { return m_chains; }
  const Oriented_element<>& element(const Piece& piece) const { return m_graph.elements()[piece.element]; }

  // The parts of elements that are not decided, and those with the ends of chains that are not closed.
  std::vector<Undecided_range> undecided(const Rest_of_search& rest) const
  {
    std::vector<Undecided_range> result;
    for (std::size_t f = 0; f < m_ranges.size(); ++f)
      for (const Range& range : m_ranges[f].undecided)
        result.push_back({f, range, rest.why_not_decided(f, range)});
    for (const Chain& chain : m_chains)
      if (!chain.is_closed)
        for (const bool is_end : {false, true}) {
          const Piece& piece = m_pieces[is_end ? chain.pieces.back() : chain.pieces.front()];
          result.push_back({piece.element, end(piece, is_end).location, rest.why_not_connected()});
        }
    return result;
  }

  // Where a piece begins or ends.
  const Free_end& end(const Piece& piece, bool is_end) const
  {
    return piece.range[is_end != element(piece).is_reversed];
  }

  // The parameters where a piece begins and ends in the order of traversal; disks between them are free.
  std::array<double, 2> parameters(const Piece& piece) const
  {
    const double begin = piece.range[0].location.end, end = piece.range[1].location.begin;
    return element(piece).is_reversed ? std::array{end, begin} : std::array{begin, end};
  }

private:
  template <class Center>
  void connect_pieces(const Center& center)
  {
    std::vector<std::size_t> next(m_pieces.size(), none), previous(m_pieces.size(), none);
    for (std::size_t i = 0; i < m_pieces.size(); ++i)
      if (const std::size_t j = piece_behind(m_pieces[i], center); j != none && previous[j] == none) {
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

  template <class Center>
  std::size_t piece_behind(const Piece& piece, const Center& center) const
  {
    const Free_end& last = end(piece, true);
    switch (last.kind) {
    case Free_end::Kind::FRONT_END: return first_piece(next_curve(piece.element), last.kind);
    case Free_end::Kind::POINT: return piece_around_point(piece.element);
    case Free_end::Kind::FOOTPOINT: {
      const std::size_t across = piece_across(piece, center(piece.element, last));
      return across != none ? across : piece_with_disk_of_footpoint(piece);
    }
    case Free_end::Kind::TIE: {
      const std::size_t next = piece_with_disk(*last.disk, false);
      return next != none ? next : piece_with_disk(*last.disk, true);
    }
    default: return none;
    }
  }

  // The next element of which the centers are not one point.
  std::size_t next_curve(std::size_t f) const
  {
    std::size_t result = m_graph.elements()[f].next;
    while (m_ranges[result].is_point)
      result = m_graph.elements()[result].next;
    return result;
  }

  std::size_t first_piece(std::size_t f, Free_end::Kind kind) const
  {
    const std::size_t first = m_first_piece_of[f], last = m_first_piece_of[f + 1];
    if (first == last)
      return none;
    const std::size_t i = m_graph.elements()[f].is_reversed ? last - 1 : first;
    return end(m_pieces[i], false).kind == kind ? i : none;
  }

  // Where disks shrink to a vertex, the chain goes on along the other side of the arc; or, where disks there touch a
  // next arc instead, along the other side of that.
  std::size_t piece_around_point(std::size_t f) const
  {
    const Oriented_element<>& last = m_graph.elements()[f];
    Arc_end end{last.object, !last.is_reversed};
    for (std::size_t k = 0; k < m_graph.vertices()[m_graph.vertex_of(end)].ends.size(); ++k) {
      const Oriented_element<> other{false, end.arc, end.is_end};   // departs from the vertex
      const std::size_t index = 2 * end.arc + end.is_end;
      if (const std::size_t piece = first_piece(index, Free_end::Kind::POINT);
          piece != none || !m_ranges[index].undecided.empty())
        return piece;
      end = m_graph.next_around_vertex(other, end);
    }
    return none;
  }

  // The piece that begins where another one ends with an exact disk: with the same disk; of two pieces, as where points
  // are opposite to each other, with the other normal. On the other side, the disk may be known as one of a second
  // footpoint only.
  std::size_t piece_with_disk(const Exact_disk& disk, bool is_footpoint_allowed) const
  {
    const auto has_disk = [&](const Piece& piece, bool is_end) {
      const Free_end& e = end(piece, is_end);
      return e.kind == Free_end::Kind::TIE ? e.disk->center == disk.center
                                           : is_footpoint_allowed && e.kind == Free_end::Kind::FOOTPOINT &&
              touches_elsewhere(disk, piece.element, e.location);
    };
    std::vector<std::size_t> first, opposite;
    std::size_t last = 0;
    for (std::size_t i = 0; i < m_pieces.size(); ++i) {
      last += has_disk(m_pieces[i], true);
      if (has_disk(m_pieces[i], false)) {
        first.push_back(i);
        if (const auto& other = end(m_pieces[i], false).disk;
            other && other->way == Exact_pair{Exact_rational(-disk.way[0]), Exact_rational(-disk.way[1])})
          opposite.push_back(i);
      }
    }
    return first.size() == 1 && last == 1 ? first[0] : opposite.size() == 1 ? opposite[0] : none;
  }

  // The piece that begins with an exact disk that is the one where another one ends in a second footpoint.
  std::size_t piece_with_disk_of_footpoint(const Piece& piece) const
  {
    for (const Piece& other : m_pieces)
      if (const auto& disk = end(other, false).disk;
          disk && touches_elsewhere(*disk, piece.element, end(piece, true).location))
        return piece_with_disk(*disk, true);
    return none;
  }

  // Whether a disk that touches one element touches a range of another one in another point, where the parameter is the
  // simplest number.
  bool touches_elsewhere(const Exact_disk& disk, std::size_t element, const Range& range) const
  {
    const Oriented_element<>& f = m_graph.elements()[element];
    const auto jet = m_graph.element_jet(f, range);
    const Interval_pair center{interval_of(disk.center[0]), interval_of(disk.center[1])};
    if (!Touching_disk<>::is_defined(m_graph, element) ||
        certain_sign(dot(turned_left(jet.normal), center - jet.point)) != 0)
      return false;
    const Exact_rational u = simplest_rational_between(Exact_rational(range.begin), Exact_rational(range.end));
    const Exact_pair point = m_graph.exact_point_at(f, u), way = exact_difference(disk.center, point),
                     normal = m_graph.exact_normal(f, u);
    return way != disk.way && disk.touches(point) && exact_cross(normal, way) == 0 && exact_dot(normal, way) > 0;
  }

  // The piece that begins where another one ends in a second footpoint.
  std::size_t piece_across(const Piece& piece, const Interval_pair& center) const
  {
    const Free_end& footpoint = end(piece, true);
    const auto touched = touched_element(m_graph, footpoint.footpoint, footpoint.footpoint_location, center);
    if (!touched ||
        std::any_of(m_ranges[touched->element].undecided.begin(), m_ranges[touched->element].undecided.end(),
                    [&](const Range& range) { return range.meets(touched->range); }))
      return none;
    std::vector<std::pair<std::size_t, bool>> ends;   // there
    for (std::size_t i = m_first_piece_of[touched->element]; i < m_first_piece_of[touched->element + 1]; ++i)
      for (const bool is_end : {false, true})
        if (const Free_end& e = end(m_pieces[i], is_end);
            e.kind == Free_end::Kind::FOOTPOINT && e.location.meets(touched->range))
          ends.emplace_back(i, is_end);
    const bool is_certain = ends.size() == 1 && !ends[0].second &&
        is_footpoint_with(end(m_pieces[ends[0].first], false).footpoint, element(piece));
    return is_certain ? ends[0].first : none;
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_FREE_CHAINS_H
