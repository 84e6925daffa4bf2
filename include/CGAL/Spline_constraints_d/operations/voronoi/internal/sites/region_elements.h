// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_REGION_ELEMENTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_REGION_ELEMENTS_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Planar_operands.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Search_control.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_curve_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The graph of the boundaries of a region.
inline std::shared_ptr<const Site_graph_2<>> region_graph(const Region_operand& region,
                                                          Search_control* control = nullptr)
{
  if (region.undecided != Undecided_reason::NONE)
    throw Run_stopped{region.undecided};
  const Upward_rounding_guard guard;
  Regular_check check(control, 1);
  auto graph = std::make_shared<Site_graph_2<>>();
  for (std::size_t c = 0; c < region.curves.size(); ++c)
    for (const Homogeneous_piece& piece : pieces_between_stops(region.curves[c])) {
      check();
      for (const Region_operand::Arc& arc : region.arcs[c])
        if (const auto& [begin, end] = arc.parameters; begin < piece.domain.second && end > piece.domain.first)
          graph->add_arc(piece.within({begin, end}), c);
    }
  graph->close(true, true, control);
  return graph;
}

// The elements inside or outside of a region, of which this is the graph: the sides of arcs there, and the normal cones
// that they lead to.
inline std::vector<std::size_t> region_elements(const Site_graph_2<>& graph, const Region_operand& region,
                                                bool is_inside)
{
  const auto is_reversed = [&](std::size_t arc) {   // against the direction that has the region on the left
    const std::vector<Region_operand::Arc>& arcs = region.arcs[graph.curve_of_arc(arc)];
    return std::find_if(arcs.begin(), arcs.end(),
                        [&](const Region_operand::Arc& own) {
                          return own.parameters[1] >= graph.arcs()[arc].piece().domain.second;
                        })
        ->is_reversed;
  };
  std::vector<std::size_t> result;
  std::vector<char> is_visited(graph.elements().size(), false);
  for (std::size_t arc = 0; arc < graph.arcs().size(); ++arc)
    for (std::size_t f = 2 * arc + (is_reversed(arc) == is_inside); !is_visited[f]; f = graph.elements()[f].next) {
      is_visited[f] = true;
      result.push_back(f);
    }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_REGION_ELEMENTS_H
