// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_BISECTING_CHAINS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_BISECTING_CHAINS_H

#include <CGAL/Spline_constraints_d/operations/intersections/internal/chains_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Curve_diagram.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

inline std::size_t vertex_at_end(const Curve_diagram& diagram, const Trimmed_bisector_chain_2::Arc& arc, bool is_end)
{
  return diagram.edges[arc.edge].vertices[is_end != arc.is_reversed];
}

inline void reverse(std::vector<Trimmed_bisector_chain_2::Arc>& arcs)
{
  std::reverse(arcs.begin(), arcs.end());
  for (Trimmed_bisector_chain_2::Arc& arc : arcs)
    arc.is_reversed = !arc.is_reversed;
}

// The edges between sites of different sides, as chains: each site belongs to the first operand (-1), the second one
// (1), or to both (0). Without sides, all edges.
inline std::vector<Trimmed_bisector_chain_2> bisecting_chains(const Curve_diagram& diagram,
                                                              const std::vector<int>& sides)
{
  // of edges: negative if the first operand is on the left, 0 if they are left out
  std::vector<int> directions;
  std::vector<std::size_t> kept;
  std::vector<std::vector<Curve_end>> ends_at(diagram.vertices.size());
  for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
    const Voronoi_edge_2& edge = diagram.edges[e];
    directions.push_back(sides.empty() ? 1 : sides[edge.sites[1]] - sides[edge.sites[0]]);
    if (directions.back() != 0) {
      for (const int side : {0, 1})
        ends_at[edge.vertices[static_cast<std::size_t>(side)]].push_back({kept.size(), side});
      kept.push_back(e);
    }
  }
  const auto next = [&](const Curve_end& end) -> std::optional<Curve_end> {
    const std::size_t v = diagram.edges[kept[end.curve]].vertices[static_cast<std::size_t>(end.side)];
    if (ends_at[v].size() != 2 || diagram.vertices[v].is_at_infinity || !diagram.vertices[v].is_resolved)
      return std::nullopt;
    return ends_at[v][ends_at[v][0] == end];
  };
  std::vector<Trimmed_bisector_chain_2> result;
  for (const Intersection_curve& joined : chains_of_curves(std::vector<bool>(kept.size(), false), next)) {
    Trimmed_bisector_chain_2 chain{{}, {}, joined.is_closed};
    for (const Intersection_arc& arc : joined.arcs)
      chain.arcs.push_back({kept[arc.index], arc.is_reversed});
    // then all arcs have the first operand on the left
    if ((directions[chain.arcs[0].edge] < 0) != chain.arcs[0].is_reversed)
      reverse(chain.arcs);
    chain.vertices = {vertex_at_end(diagram, chain.arcs.front(), false),
                      vertex_at_end(diagram, chain.arcs.back(), true)};
    result.push_back(std::move(chain));
  }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_BISECTING_CHAINS_H
