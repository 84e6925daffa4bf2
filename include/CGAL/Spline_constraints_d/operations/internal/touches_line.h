// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_TOUCHES_LINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_TOUCHES_LINE_H

#include <CGAL/Spline_constraints_d/operations/internal/Site_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/internal/inner_roots.h>

#include <algorithm>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Whether an arc is proved to be tangent to the line through a point inside of a range, whose ends are no such points: the polynomial of the distance from the line, times the weight and a constant, has a multiple root there.
inline bool touches_line(const Exact_arc_2& arc, const Range& range, const Exact_pair& point, const Exact_pair& direction)
{
  const auto& [x, y, w] = arc.piece().coordinates;
  const Integer_polynomial distance = integer_polynomial(direction[0] * (y - point[1] * w) - direction[1] * (x - point[0] * w));
  if (distance.is_zero())
    return false;
  const auto factors = distance.square_free_factors();
  return std::any_of(factors.begin(), factors.end(), [&](const auto& factor) { return factor.second > 1 && factor.first.sign_at(range.begin) * factor.first.sign_at(range.end) < 0; });
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERNAL_TOUCHES_LINE_H
