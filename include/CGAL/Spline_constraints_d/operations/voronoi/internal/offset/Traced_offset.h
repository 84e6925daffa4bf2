// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_TRACED_OFFSET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_TRACED_OFFSET_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Curve_offset.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/Offset_cycles.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/offset/arcs_of_chain.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/vertex_origin.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

/*
The chains of an offset, as its arcs and boundaries, and what is asked of these later.
*/
class Traced_offset
{
  Offset_cycles m_cycles;
  bool m_is_reversed;                                      // the set is on the right of the chains
  std::vector<std::vector<std::size_t>> m_pieces_of_arc;   // which are the offsets of parts of elements
  std::vector<Trimmed_offset_boundary_2> m_boundaries;

public:
  Traced_offset(Offset_cycles cycles, bool is_reversed) : m_cycles(std::move(cycles)), m_is_reversed(is_reversed)
  {
    for (const Offset_cycles::Chain& chain : m_cycles.chains())
      append_boundary(chain);
  }

  const Offset_cycles& cycles() const { return m_cycles; }

  // All that there is of it, but for what is not decided.
  void describe(Curve_offset& result) const
  {
    for (const std::vector<std::size_t>& pieces : m_pieces_of_arc) {
      result.arcs.push_back(arc_of(pieces.front()));
      result.arcs.back().parameters[1] = arc_of(pieces.back()).parameters[1];
    }
    result.boundaries = m_boundaries;
  }

  std::vector<std::array<double, 2>> points(std::size_t arc, double error) const
  {
    const Upward_rounding_guard guard;
    std::vector<std::array<double, 2>> result;
    for (const std::size_t p : m_pieces_of_arc[arc]) {
      const Offset_cycles::Piece& piece = m_cycles.pieces()[p];
      const Element_offset offset = m_cycles.offset(piece);
      const auto [begin, end] = parameters(piece);
      const std::vector<double> stops = offset.stops(begin, end, error);
      for (std::size_t i = result.empty() ? 0 : 1; i < stops.size(); ++i)
        result.push_back(middle(offset.point({stops[i], stops[i]})));
    }
    return result;
  }

private:
  static std::array<double, 2> middle(const Interval_pair& p)
  {
    return {p[0].inf() / 2 + p[0].sup() / 2, p[1].inf() / 2 + p[1].sup() / 2};
  }

  std::array<double, 2> parameters(const Offset_cycles::Piece& piece) const
  {
    const auto [from, to] = m_cycles.parameters(piece);
    return m_is_reversed ? std::array{to, from} : std::array{from, to};
  }

  Curve_offset::Arc arc_of(std::size_t p) const
  {
    const Offset_cycles::Piece& piece = m_cycles.pieces()[p];
    const Oriented_element<>& element = m_cycles.element(piece);
    const Site_graph_2<>& graph = m_cycles.graph();
    if (!element.is_normal_cone) {
      const auto [begin, end] = parameters(piece);
      return {std::nullopt,
              graph.curve_of_arc(element.object),
              {graph.curve_parameter(element.object, begin), graph.curve_parameter(element.object, end)}};
    }
    Curve_offset::Arc result{graph.vertices()[element.object].exact_point, {}, {}};
    if (const auto origin = vertex_origin(graph, element.object)) {
      result.curve = origin->first;
      result.parameters = {origin->second, origin->second};
    }
    return result;
  }

  // Whether a piece goes on where another one ends, around the same point, or with the same curve on the same side.
  bool goes_on(std::size_t before, std::size_t after) const
  {
    const Oriented_element<> &a = m_cycles.element(m_cycles.pieces()[before]),
                             &b = m_cycles.element(m_cycles.pieces()[after]);
    if (a.is_normal_cone || b.is_normal_cone)
      return before != after && a.is_normal_cone && b.is_normal_cone && a.object == b.object;
    return a.is_reversed == b.is_reversed && arc_of(before).curve == arc_of(after).curve &&
        arc_of(before).parameters[1] == arc_of(after).parameters[0];
  }

  void append_boundary(const Offset_cycles::Chain& chain)
  {
    std::vector<std::size_t> pieces = chain.pieces;
    if (m_is_reversed)
      std::reverse(pieces.begin(), pieces.end());
    const bool is_nested = chain.outer != no_boundary;
    Trimmed_offset_boundary_2 boundary{
        {}, chain.is_closed, chain.is_hole, is_nested ? std::optional(chain.outer) : std::nullopt};
    for (std::vector<std::size_t>& arc : arcs_of_chain(
             pieces, chain.is_closed, [&](std::size_t before, std::size_t after) { return goes_on(before, after); })) {
      boundary.arcs.push_back(m_pieces_of_arc.size());
      m_pieces_of_arc.push_back(std::move(arc));
    }
    m_boundaries.push_back(std::move(boundary));
  }
};

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<std::array<double, 2>> points_of_arc(const Curve_offset& offset,
                                                                                std::size_t arc, double error)
{
  check_error(error, "Trimmed_offset_2");
  if (arc >= offset.arcs.size())
    throw Invalid_input("Trimmed_offset_2: there is no arc " + std::to_string(arc));
  return offset.traced->points(arc, error);
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_OFFSET_TRACED_OFFSET_H
