// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_INTERSECTIONS_AT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_INTERSECTIONS_AT_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The answers of an operation that has found the common points of two operands, with its work.
template <SplineKernel Kernel, int d>
Spline_constraints::Intersections<Kernel, d> intersections_at(std::vector<Common_point> points,
                                                              const Patch_pair<d>& operands, const Summary& work)
{
  std::vector<Intersection<Kernel, d>> result;
  for (Common_point& point : points)
    result.emplace_back(std::move(point), operands);
  return Spline_constraints::Intersections<Kernel, d>(std::move(result), work);
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_INTERSECTIONS_AT_H
