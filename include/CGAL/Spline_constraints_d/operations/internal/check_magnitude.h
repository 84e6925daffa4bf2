// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CHECK_MAGNITUDE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CHECK_MAGNITUDE_H

#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/operations/internal/Site_graph_2.h>

#include <algorithm>
#include <string>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Refuses sites whose greatest coordinate is so great, or so small, that bounds of products of four lengths are not bounded by doubles other than zero and infinity: nothing would be decided, after all has been tried.
inline void check_magnitude(const Site_graph_2& graph, const std::string& operation)
{
  constexpr double most = 0x1p250, least = 0x1p-250;
  const Upward_rounding_guard guard;
  double greatest = 0;
  const auto add = [&](const Interval_pair& points) {
    for (const Interval& x : points)
      greatest = (std::max)({greatest, x.sup(), -x.inf()});
  };
  for (const Site_arc_2& arc : graph.arcs())
    add(arc.point(Range()));
  for (const Site_graph_2::Vertex& vertex : graph.vertices())
    add(vertex.point);
  if (greatest > most || (greatest > 0 && greatest < least))
    throw Invalid_input(operation + ": the greatest coordinate is not between 2^-250 and 2^250");
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_CHECK_MAGNITUDE_H
