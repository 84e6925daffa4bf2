// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CHECK_MAGNITUDE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CHECK_MAGNITUDE_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Site_graph_2.h>

#include <algorithm>
#include <string>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Refuses sites whose greatest coordinate is too great, or too small, for bounds in doubles.
inline void check_magnitude(const Site_graph_2<>& graph, const std::string& operation)
{
  const Upward_rounding_guard guard;
  double greatest = 0;
  const auto add = [&](const Interval_pair& points) {
    for (const Interval& x : points)
      greatest = (std::max)({greatest, x.sup(), -x.inf()});
  };
  for (const Site_arc_2<>& arc : graph.arcs())
    add(arc.point(Range()));
  for (const Site_graph_2<>::Vertex& vertex : graph.vertices())
    add(vertex.point);
  check_greatest_coordinate(greatest, operation);
}

// Refuses a point that is so far away that its squared distances from such sites are not bounded.
inline void check_magnitude(const Exact_pair& point, const std::string& operation)
{
  const Exact_rational most(most_magnitude);
  for (const Exact_rational& x : point)
    if (x > most || x < -most)
      throw Invalid_input(operation + ": a coordinate is not between -2^250 and 2^250");
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_SITES_CHECK_MAGNITUDE_H
