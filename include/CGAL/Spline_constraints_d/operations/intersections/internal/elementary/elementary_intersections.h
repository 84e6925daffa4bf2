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
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/regular_points.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

template <SplineKernel Kernel, int d>
Spline_constraints::Intersections<Kernel, d> intersections_at(Elementary_points<d> found, Summary work = {})
{
  std::vector<Intersection<Kernel, d>> result;
  result.reserve(found.points.size());
  for (Elementary_point<d>& point : found.points)
    result.emplace_back(std::move(point), found.split, found.number_of_parameters);
  work.nodes += found.nodes;
  return Spline_constraints::Intersections<Kernel, d>(std::move(result), work, {});
}

// The intersections of two objects where closed forms find them all, or a search in doubles does, in kernels of
// doubles. They take less time than a limit can be; limits of nodes are left to the solver.
template <SplineKernel Kernel, int d>
std::optional<Spline_constraints::Intersections<Kernel, d>> elementary_intersections(const Elementary_operand<d>& a,
                                                                                      const Elementary_operand<d>& b,
                                                                                      const Solver_options& options)
{
  options.check();
  if (options.visitor.stop())
    return std::nullopt;
  auto found = elementary_points<d>(a, b);
  if (!found && options.node_limit == 0)
    found = crossing_points<d>(a, b);
  return found ? std::optional(intersections_at<Kernel>(std::move(*found))) : std::nullopt;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_INTERSECTIONS_H
