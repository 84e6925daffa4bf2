// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_OF_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_OF_CURVES_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Run_of_steps.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/Boundary_loop_2.h>
#include <CGAL/Spline_constraints_d/operations/regions/internal/meetings_of_curves.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Sight_of_curves_2.h>
#include <CGAL/Spline_constraints_d/operations/visibility/internal/Sight_sweep_2.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Visibility {

// Where curves meet each other and themselves.
// \throws Run_stopped
inline std::vector<Sight_crossing> crossings_of(const std::vector<Spline_patch<2>>& curves, Run_of_steps& run)
{
  std::vector<Sight_crossing> result;
  for (const auto& [first, second, points] : meetings_of_curves(curves, run))
    for (const Common_point& point : points)
      result.push_back({point.kind, {first, second}, {point.parameters[0], point.parameters[1]}});
  return result;
}

// The part of the plane in which what is not decided may be, and the parts of curves beside it.
inline std::vector<Undecided_part> undecided_parts(const std::vector<Visible_edge_2>& edges,
                                                   const std::vector<Undecided_part::Range>& box,
                                                   const std::string& reason)
{
  const auto parameters = [](const Boundary_vertex_2& vertex) {
    return Undecided_part::Parameters{
        vertex.curve,
        {{to_double_interval(vertex.parameters.first).first, to_double_interval(vertex.parameters.second).second}}};
  };
  std::vector<Undecided_part> result;
  for (const Visible_edge_2& edge : edges)
    if (edge.kind == Visible_edge_kind::UNDECIDED)
      result.push_back({box, {parameters(edge.source), parameters(edge.target)}, reason});
  if (result.empty())   // no curve is known to be seen
    result.push_back({box, {}, reason});
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Sight_of_curves_2 sight_of_curves(const Exact_pair& viewpoint,
                                                                 const std::vector<Spline_patch<2>>& curves,
                                                                 const std::vector<std::vector<Boundary_piece>>& pieces,
                                                                 const Solver_options& options)
{
  Run_of_steps run(options);
  const Upward_rounding_guard guard;
  Sight_of_curves_2 result{viewpoint, {}, {}, {}, {}};
  bool is_complete = false;
  try {
    std::vector<Sight_crossing> crossings = crossings_of(curves, run);
    result.parts = Curve_parts_2(pieces, run);
    const Sight_sweep_2 sweep(result.parts, viewpoint, std::move(crossings), run);
    result.edges = sweep.edges();
    is_complete = sweep.is_complete();
  } catch (const Run_stopped&) {   // without edges, all is undecided
  }
  if (!is_complete)
    result.undecided = undecided_parts(
        result.edges,
        united_box(box_of_pieces(pieces), {to_double_interval(viewpoint[0]), to_double_interval(viewpoint[1])}),
        run.is_stopped() ? in_words(run.reason()) : "directions are not told apart");
  result.summary = run.summary(is_complete);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::pair<Exact_rational, Exact_rational> area_of_sight(const Sight_of_curves_2& sight,
                                                                                       double error)
{
  Rational_interval result(Exact_rational(0), Exact_rational(0));
  std::vector<Boundary_piece> arcs;
  for (const Visible_edge_2& edge : sight.edges)
    if (edge.kind == Visible_edge_kind::ARC)
      sight.parts.append_sector(edge.source.curve, edge.source.parameters, edge.target.parameters, sight.viewpoint,
                                arcs, result);
  if (!arcs.empty())
    result = result + Boundary_loop_2(arcs).signed_area(to_rational(error) / 2);
  return {result.lower, result.upper};
}

} // namespace Visibility
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VISIBILITY_INTERNAL_SIGHT_OF_CURVES_H
