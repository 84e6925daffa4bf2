// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_VERTEX_ORIGIN_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_VERTEX_ORIGIN_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The curve of the lowest index that ends or has a joint in a vertex, with its lowest parameter there; none for an
// isolated point.
inline std::optional<std::pair<std::size_t, double>> vertex_origin(const Site_graph_2<>& graph, std::size_t vertex)
{
  std::optional<std::pair<std::size_t, double>> result;
  for (const Arc_end& end : graph.vertices()[vertex].ends) {
    const std::pair<std::size_t, double> place{graph.curve_of_arc(end.arc),
                                               graph.curve_parameter(end.arc, end.parameter())};
    result = result ? (std::min)(*result, place) : place;
  }
  return result;
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_VERTEX_ORIGIN_H
