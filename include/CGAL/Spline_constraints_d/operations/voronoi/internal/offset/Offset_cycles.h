// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_OFFSET_CYCLES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_OFFSET_CYCLES_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/turn_around.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/parts_of_boundaries.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/candidates/Cusp_finder_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Element_offset.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Free_chains.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Free_disks.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/check_magnitude.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/for_each_element.h>

#include <CGAL/Uncertain.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The points at one distance from all curves of a graph, as chains of offsets of elements.

A chain is an outer boundary of a set, the side that is free or the other one, or one of its holes. Let X be a point of
the curves that is nearest to a point O of the chain. The segment between does not meet any chain elsewhere, and X is at
least the radius away from all of them. So all questions are answered by the numbers of times chains go around such X.
*/
class Offset_cycles
{
public:
  static constexpr std::size_t none = Free_chains::none;

  using Piece = Free_chains::Piece;

  struct Chain : Free_chains::Chain
  {
    bool is_hole = false;              // of the set
    std::size_t outer = no_boundary;   // the chain around the same component of the set
  };

private:
  std::shared_ptr<const Site_graph_2<>> m_graph;
  Interval m_radius;
  Free_chains m_free;
  std::vector<Chain> m_chains;
  std::vector<Undecided_range> m_not_nested;   // points of curves that are nearest to chains that are not
  Rest_of_search m_rest;

public:
  Offset_cycles(std::shared_ptr<const Site_graph_2<>> graph, const Interval& radius, std::vector<Free_ranges> ranges,
                bool is_set_free, Rest_of_search rest, Search_control& control)
    : m_graph(std::move(graph)), m_radius(radius), m_free(free_chains(std::move(ranges))), m_rest(std::move(rest))
  {
    const Upward_rounding_guard guard;
    for (const Free_chains::Chain& chain : m_free.chains())
      m_chains.push_back({chain});
    nest_chains(is_set_free, control);
    m_rest.why_not = control.reason();
  }

  const Site_graph_2<>& graph() const { return *m_graph; }
  const std::vector<Piece>& pieces() const { return m_free.pieces(); }
  const std::vector<Chain>& chains() const { return m_chains; }
  const Oriented_element<>& element(const Piece& piece) const { return m_free.element(piece); }
  Element_offset offset(const Piece& piece) const { return {*m_graph, piece.element, m_radius}; }

  // Where elements are not decided, or chains not closed or nested.
  std::vector<Undecided_range> undecided() const
  {
    std::vector<Undecided_range> ranges = m_free.undecided(m_rest);
    ranges.insert(ranges.end(), m_not_nested.begin(), m_not_nested.end());
    return ranges;
  }

  // A box that holds the offset of a part of an element.
  std::vector<Undecided_part::Range> place(const Undecided_range& range) const
  {
    const Upward_rounding_guard guard;
    const Oriented_element<>& element = m_graph->elements()[range.element];
    const Interval_pair points = element.is_normal_cone ? m_graph->vertices()[element.object].point
                                                        : m_graph->arcs()[element.object].point(range.range);
    const Interval way(-m_radius.sup(), m_radius.sup());
    const Interval x = points[0] + way, y = points[1] + way;
    return {{x.inf(), x.sup()}, {y.inf(), y.sup()}};
  }

  // The parameters where a piece begins and ends in the order of traversal; disks between them are free.
  std::array<double, 2> parameters(const Piece& piece) const { return m_free.parameters(piece); }

private:
  Free_chains free_chains(std::vector<Free_ranges> ranges) const
  {
    const Upward_rounding_guard guard;
    return {*m_graph, std::move(ranges), [&](std::size_t element, const Free_end& end) {
              return Element_offset(*m_graph, element, m_radius).point(end.location);
            }};
  }

  // A point of the curves that is nearest to a point of a chain.
  Undecided_range foot(const Chain& chain, Undecided_reason reason = Undecided_reason::TOLERANCE) const
  {
    const Piece& piece = pieces()[chain.pieces.front()];
    const auto [from, to] = parameters(piece);
    const double u = from / 2 + to / 2;
    return {piece.element, {u, u}, reason};
  }

  // Whether a closed chain goes around the foot of a chain, if that is certain. It goes on from one piece to the next
  // one in a point that is within the ranges of both ends.
  CGAL::Uncertain<bool> is_around(const Chain& chain, const Chain& other) const
  {
    const Undecided_range place = foot(other);
    const Interval_pair p = m_graph->element_jet(m_graph->elements()[place.element], place.range).point;
    double turn = 0;
    for (std::size_t k = 0; k < chain.pieces.size(); ++k) {
      const Piece &piece = pieces()[chain.pieces[k]], &next = pieces()[chain.pieces[(k + 1) % chain.pieces.size()]];
      const auto [from, to] = parameters(piece);
      const double begin = parameters(next)[0];
      const auto path = [&](const Range& range) { return offset(piece).point(range); };
      const auto way = [&](const Piece& of, const Range& range) { return offset(of).point(range) - p; };
      const auto angle = turn_around(p, path, from, to);
      const auto angle_at_end =
          angle_within(hull(way(piece, m_free.end(piece, true).location), way(next, m_free.end(next, false).location)),
                       way(piece, {to, to}), way(next, {begin, begin}));
      if (!angle || !angle_at_end)
        return CGAL::Uncertain<bool>::indeterminate();
      turn += *angle + *angle_at_end;
    }
    return full_turns(turn) != 0;
  }

  // A chain of which it is not certain whether it is a hole is neither that nor an outer one. Nothing is certain that
  // there is no time for; nor is which chain is around a hole, if the search was ended: there may be others between.
  void nest_chains(bool is_set_free, Search_control& control)
  {
    const auto encloses = [&](const Chain& chain, const Chain& other) {
      return control.is_overdue() ? CGAL::Uncertain<bool>::indeterminate() : is_around(chain, other);
    };
    const auto why_not = [&] { return control.has_ended() ? control.reason() : Undecided_reason::TOLERANCE; };
    for (std::size_t c = 0; c < m_chains.size(); ++c)
      if (Chain& chain = m_chains[c]; chain.is_closed) {
        const CGAL::Uncertain<bool> is_hole = encloses(chain, chain) == is_set_free;
        chain.is_hole = CGAL::certainly(is_hole);
        if (CGAL::certainly_not(is_hole))
          chain.outer = c;
        else if (!chain.is_hole)
          m_not_nested.push_back(foot(chain, why_not()));
      }
    const bool is_searched = m_rest.why_not == Undecided_reason::NONE;
    const auto is_certainly_around = [&](std::size_t c, std::size_t other) {
      return is_searched ? encloses(m_chains[c], m_chains[other]) : CGAL::Uncertain<bool>::indeterminate();
    };
    for (const std::size_t hole : find_outer_boundaries(m_chains, is_certainly_around))
      m_not_nested.push_back(foot(m_chains[hole], why_not()));
  }
};

// The offset on some of the elements of a graph: of the set that is free, or of the other one. With a tag for parallel
// work, elements are handed to all cores.
template <class Concurrency_tag>
Offset_cycles offset_cycles(std::shared_ptr<const Site_graph_2<>> graph, const Exact_rational& radius,
                            const std::vector<std::size_t>& elements, bool is_set_free, Search_control& control)
{
  check_magnitude(*graph, "trimmed_offset");
  const Site_tree_2 tree(*graph);
  const Cusps_2 cusps = Cusp_finder_2(*graph, tree, &control)();
  const Fine_level fine_level(*graph);
  std::vector<Free_ranges> ranges(graph->elements().size());
  Rest_of_search rest(graph->elements().size());
  for (const std::size_t element : elements)
    ranges[element].undecided.push_back(Range());   // until it is swept
  for_each_element<Concurrency_tag>(elements, control, [&](std::size_t element) {
    Free_disks<> disks(*graph, tree, cusps, radius, control.has_fine_level() ? &fine_level : nullptr, &control);
    ranges[element] = disks(element);
    rest.begins[element] = disks.begin_of_rest();
  });
  rest.why_not = control.reason();
  return Offset_cycles(std::move(graph), interval_of(radius), std::move(ranges), is_set_free, std::move(rest), control);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_OFFSET_CYCLES_H
