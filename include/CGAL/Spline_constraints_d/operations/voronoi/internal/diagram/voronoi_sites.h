// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_VORONOI_SITES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_VORONOI_SITES_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/Voronoi_site_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/diagram/Disk_diagram.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/vertex_origin.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The sites of a diagram: the arcs of a graph, and behind them its vertices, with the region of each vertex.
template <SplineKernel Kernel>
std::vector<Voronoi_site_2<Kernel>> voronoi_sites(const Site_graph_2<>& graph, const std::vector<std::size_t>& regions)
{
  using Point = typename Kernel::Point_2;
  std::vector<Voronoi_site_2<Kernel>> result;
  for (std::size_t i = 0; i < graph.arcs().size(); ++i) {
    const auto& [begin, end] = graph.arcs()[i].piece().domain;
    result.push_back({false,
                      kernel_object<Kernel, Point>(graph.arcs()[i].at(0)),
                      graph.curve_of_arc(i),
                      {to_nearest_double(begin), to_nearest_double(end)},
                      regions[graph.vertex_of({i, false})]});
  }
  for (std::size_t v = 0; v < regions.size(); ++v) {
    const auto [curve, parameter] = vertex_origin(graph, v).value_or(std::pair(Disk_diagram::none, 0.));
    result.push_back({true,
                      kernel_object<Kernel, Point>(graph.vertices()[v].exact_point),
                      curve,
                      {parameter, parameter},
                      regions[v]});
  }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_VORONOI_SITES_H
