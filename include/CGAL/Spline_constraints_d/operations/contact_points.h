// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONTACT_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONTACT_POINTS_H

#include <CGAL/Spline_constraints_d/operations/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/internal/Contact_finder.h>
#include <CGAL/Spline_constraints_d/operations/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/internal/Summing_solver.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

template <class A, class B>
  requires internal::Surface_operands<A, B>
auto contact_points(const A& a, const B& b, const Solver_options& options = {})
{
  using Kernel = typename internal::Intersection_operand<A>::Kernel;
  internal::Summing_solver solve(options);
  std::vector<Intersection<Kernel, 3>> result;
  if (const auto pair = internal::patch_pair(a, b))
    for (internal::Common_point& point : internal::Contact_finder(*pair, solve)())
      result.emplace_back(std::move(point), *pair);
  return Intersections<Kernel, 3>(std::move(result), solve.total());
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_CONTACT_POINTS_H
