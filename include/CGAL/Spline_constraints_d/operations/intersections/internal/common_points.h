// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COMMON_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COMMON_POINTS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/curves_along_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/curves_on_implicit_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finder_declarations.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The common points of two operands. Where a curve and a surface take many nodes, the curve may run along the surface.
template <int d>
std::vector<Common_point> common_points(const Patch_pair<d>& pair, Budgeted_solver& solve,
                                        const Known_solutions& known)
{
  if (solve.must_stop())
    return {undecided_common_point(pair.domain(), solve.reason())};
  constexpr std::size_t many_nodes = 250;
  if constexpr (d == 3)
    if (pair.number_of_parameters() == 3) {
      Budgeted_solver limited = solve.limited(many_nodes);
      std::vector<Common_point> points = Intersection_finder<3>(pair, limited, known)();
      solve.add_work_of(limited);
      const bool is_complete = std::none_of(
          points.begin(), points.end(), [](const Common_point& x) { return x.kind == Intersection_kind::UNDECIDED; });
      if (is_complete || solve.must_stop())
        return points;
      if (auto others = common_points_of_curve_along_surface(pair, points, solve))
        return std::move(*others);
      if (auto others = Curve_on_implicit_surface(pair, solve)())
        return std::move(*others);
      if (!limited.has_reached_node_limit() || solve.has_reached_node_limit())
        return points;
    }
  return Intersection_finder<d>(pair, solve, d == 2 ? known : std::nullopt)();
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_COMMON_POINTS_H
