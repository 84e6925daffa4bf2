// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_INTERSECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_INTERSECTIONS_H

#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Elementary_operand.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The intersections of two objects where closed forms find them all, in kernels of doubles. They take less time than a
// limit can be.
template <SplineKernel Kernel, int d, class A, class B>
std::optional<Spline_constraints::Intersections<Kernel, d>> elementary_intersections(const A& a, const B& b,
                                                                                      const Solver_options& options)
{
  if constexpr (std::is_floating_point_v<typename Kernel::FT>) {
    options.check();
    if (options.visitor.stop())
      return std::nullopt;
    const auto found = elementary_points<d>(elementary_operand<d>(a), elementary_operand<d>(b));
    if (!found)
      return std::nullopt;
    std::vector<Intersection<Kernel, d>> result;
    result.reserve(found->points.size());
    for (const Elementary_point<d>& point : found->points)
      result.emplace_back(point, found->split, found->number_of_parameters);
    return Spline_constraints::Intersections<Kernel, d>(std::move(result), Summary(), {});
  } else
    return std::nullopt;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_INTERSECTIONS_H
