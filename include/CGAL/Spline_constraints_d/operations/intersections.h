// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_H

#include <CGAL/Spline_constraints_d/operations/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/internal/Intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/internal/Summing_solver.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDOperations

all common points of two operands, each a point, a curve or a surface: the solutions of \f$A(u) = B(v)\f$, each common point once for each pair of its parameters.

*/
template <class A, class B>
  requires internal::Intersection_operands<A, B>
auto intersections(const A& a, const B& b, const Solver_options& options = {})
{
  using Operand = internal::Intersection_operand<A>;
  constexpr int d = Operand::dimension;
  using Kernel = typename Operand::Kernel;
  internal::Summing_solver solve(options);
  std::vector<Intersection<Kernel, d>> result;
  if (const auto pair = internal::patch_pair(a, b))
    for (internal::Common_point& point : internal::Intersection_finder<d>(*pair, solve)())
      result.emplace_back(std::move(point), *pair);
  return Intersections<Kernel, d>(std::move(result), solve.total());
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_H
