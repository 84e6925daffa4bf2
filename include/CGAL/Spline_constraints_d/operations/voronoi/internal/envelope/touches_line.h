// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_TOUCHES_LINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_TOUCHES_LINE_H

#include <CGAL/Spline_constraints_d/operations/common/internal/inner_roots.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/sites/Arc_parameter.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Whether an arc is proved to be tangent to the line through a point inside of a range, whose ends are no such points:
// the polynomial of the distance from the line, times the weight and a constant, has a multiple root there.
template <Enclosing_number Interval>
bool touches_line(const Site_graph_2<Interval>& graph, std::size_t arc, const Range& range, const Exact_pair& point,
                  const Exact_pair& direction)
{
  const auto inside = Arc_parameter(graph, arc).range_of_piece_within(range);
  const auto& [x, y, w] = graph.arcs()[arc].piece().coordinates;
  const Integer_polynomial distance =
      integer_polynomial(direction[0] * (y - point[1] * w) - direction[1] * (x - point[0] * w));
  if (!inside || distance.is_zero())
    return false;
  const auto factors = distance.square_free_factors();
  return std::any_of(factors.begin(), factors.end(), [&](const auto& factor) {
    return factor.second > 1 && factor.first.sign_at(inside->begin) * factor.first.sign_at(inside->end) < 0;
  });
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_ENVELOPE_TOUCHES_LINE_H
