// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_OF_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_OF_CURVES_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_area_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_boundary_2.h>
#include <CGAL/Spline_constraints_d/operations/convex_hull/internal/Hull_of_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/joined_edges.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Convex_hull {

// One edge for successive arcs of one curve; the first one does not go on from the last one.
inline std::vector<Hull_edge_2> with_joined_arcs(std::vector<Hull_edge_2> edges)
{
  const auto goes_on = [](const Hull_edge_2& edge, const Hull_edge_2& next) {
    return edge.kind == Hull_edge_kind::ARC && next.kind == Hull_edge_kind::ARC &&
        edge.target.curve == next.source.curve && edge.target.parameters == next.source.parameters &&
        edge.is_reversed() == next.is_reversed();
  };
  return joined_edges(
      std::move(edges), goes_on, [](Hull_edge_2& edge, const Hull_edge_2& next) { edge.target = next.target; });
}

// All is undecided: the hull is in the box around all.
inline Undecided_part undecided_hull(const std::vector<std::vector<Boundary_piece>>& curves,
                                     const std::vector<Exact_pair>& points, Undecided_reason reason)
{
  std::vector<Undecided_part::Range> box = box_of_pieces(curves);
  for (const auto& [x, y] : points)
    box = united_box(std::move(box), {to_double_interval(x), to_double_interval(y)});
  return {std::move(box), {}, in_words(reason)};
}

CGAL_SPLINE_CONSTRAINTS_INLINE Hull_of_curves_2 hull_of_curves(const std::vector<std::vector<Boundary_piece>>& curves,
                                                               std::vector<Exact_pair> points,
                                                               const Solver_options& options)
{
  Run_of_steps run(options);
  const Upward_rounding_guard guard;
  Hull_of_curves_2 result;
  std::map<Exact_pair, Boundary_vertex_2> isolated;
  for (std::size_t i = 0; i < points.size(); ++i)
    isolated.try_emplace(points[i], Boundary_vertex_2{curves.size() + i, {}});
  result.points = std::move(points);
  try {
    result.parts = Curve_parts_2(curves, run);
    const Hull_boundary_2 boundary(result.parts.pieces(), std::move(isolated), run);
    result.edges = with_joined_arcs(boundary.edges());
    result.undecided = boundary.undecided();
  } catch (const Run_stopped& stop) {
    result.undecided.push_back(undecided_hull(curves, result.points, stop.reason));
  }
  result.summary = run.summary(result.undecided.empty());
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<Exact_rational, Exact_rational> area_of_hull(const Hull_of_curves_2& hull,
                                                                                      double error)
{
  return Hull_area_2(hull)(error);
}

} // namespace Convex_hull
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONVEX_HULL_INTERNAL_HULL_OF_CURVES_H
