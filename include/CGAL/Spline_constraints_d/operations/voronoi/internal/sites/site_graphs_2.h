// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_GRAPHS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_GRAPHS_2_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Planar_operands.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

template <ParametricCurve_2 Curve>
void add_sites(Site_graph_2<>& graph, const Curve& curve, std::size_t index)
{
  for (Homogeneous_piece& piece : homogeneous_pieces(curve, Planar_map(curve)))
    graph.add_arc(std::move(piece), index);
}

template <SplineKernel Kernel>
void add_sites(Site_graph_2<>& graph, const CGAL::Point_2<Kernel>& point, std::size_t)
{
  graph.add_point(exact_coordinates(point));
}

// The graph of curves and isolated points.
template <class Curves, class Points>
std::shared_ptr<const Site_graph_2<>> site_graph(const Curves& curves, const Points& points)
{
  const Upward_rounding_guard guard;
  auto graph = std::make_shared<Site_graph_2<>>();
  std::size_t index = 0;
  for (const auto& curve : curves)
    add_sites(*graph, curve, index++);
  for (const auto& point : points)
    add_sites(*graph, point, index);
  graph->close();
  return graph;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_SITE_GRAPHS_2_H
