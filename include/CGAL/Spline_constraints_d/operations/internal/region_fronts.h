// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_REGION_FRONTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_REGION_FRONTS_H

#include <CGAL/Spline_constraints_d/operations/internal/Site_graph_2.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The fronts inside or outside of a region, whose curves the graph is of: the sides of arcs there, and the fans that they lead to.
template <class Region>
std::vector<std::size_t> region_fronts(const Site_graph_2& graph, const Region& region, bool is_inside)
{
  std::vector<char> is_reversed(region.curves().size(), false);   // against the direction that has the region on the left
  for (const auto& boundary : region.boundaries())
    for (const auto& arc : boundary.arcs)
      is_reversed[arc.curve] = arc.is_reversed;
  std::vector<std::size_t> result;
  std::vector<char> is_visited(graph.fronts().size(), false);
  for (std::size_t arc = 0; arc < graph.arcs().size(); ++arc)
    for (std::size_t f = 2 * arc + (static_cast<bool>(is_reversed[graph.curve_of_arc(arc)]) == is_inside); !is_visited[f]; f = graph.fronts()[f].next) {
      is_visited[f] = true;
      result.push_back(f);
    }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_REGION_FRONTS_H
