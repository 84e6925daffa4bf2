// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_OPERANDS_OF_SITES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_OPERANDS_OF_SITES_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Planar_operands.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Whether an operand passes through a vertex or ends there.
inline bool is_at_vertex(const Ordered_operands& operands, std::size_t operand, const Site_graph_2<>& graph,
                         const Site_graph_2<>::Vertex& vertex)
{
  const auto& [is_point, index] = operands.places[operand];
  if (is_point)
    return vertex.is_exact && vertex.exact_point == operands.points[index];
  return std::any_of(vertex.ends.begin(), vertex.ends.end(),
                     [&graph, i = index](const Arc_end& end) { return graph.is_part_of(end.arc, i); });
}

// Whether an operand has an arc.
inline bool is_on_arc(const Ordered_operands& operands, std::size_t operand, const Site_graph_2<>& graph,
                      std::size_t arc)
{
  const auto& [is_point, index] = operands.places[operand];
  return !is_point && graph.is_part_of(arc, index);
}

// Of each site, the arcs and behind them the vertices: whether it belongs to the first one of two operands (-1), the
// second one (1), or to both (0). Nothing, if there is one operand.
inline std::vector<int> sides_of_sites(const Ordered_operands& operands, const Site_graph_2<>& graph)
{
  std::vector<int> result;
  if (operands.places.size() < 2)
    return result;
  for (std::size_t i = 0; i < graph.arcs().size(); ++i)
    result.push_back(is_on_arc(operands, 1, graph, i) - is_on_arc(operands, 0, graph, i));
  for (const Site_graph_2<>::Vertex& vertex : graph.vertices())
    result.push_back(is_at_vertex(operands, 1, graph, vertex) - is_at_vertex(operands, 0, graph, vertex));
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_OPERANDS_OF_SITES_H
