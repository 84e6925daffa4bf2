// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_DIAGRAM_SITES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_DIAGRAM_SITES_H

#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Curve_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/vertex_origin.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The sites of a diagram: the arcs of a graph, and behind them its vertices, with the region of each vertex.
inline std::vector<Curve_diagram::Site> diagram_sites(const Site_graph_2<>& graph,
                                                      const std::vector<std::size_t>& regions)
{
  std::vector<Curve_diagram::Site> result;
  for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
    const auto& [begin, end] = graph.arcs()[i].piece().domain;
    result.push_back({false,
                      graph.arcs()[i].at(0),
                      graph.curve_of_arc(i),
                      {to_nearest_double(begin), to_nearest_double(end)},
                      regions[graph.vertex_of({i, false})]});
  }
  for (std::size_t v = 0; v < regions.size(); ++v) {
    Curve_diagram::Site site{true, graph.vertices()[v].exact_point, {}, {}, regions[v]};
    if (const auto origin = vertex_origin(graph, v)) {
      site.curve = origin->first;
      site.parameters = {origin->second, origin->second};
    }
    result.push_back(site);
  }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_DIAGRAM_SITES_H
