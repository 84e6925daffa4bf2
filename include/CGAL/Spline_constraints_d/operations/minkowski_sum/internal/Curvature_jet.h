// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CURVATURE_JET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CURVATURE_JET_H

#include <CGAL/Spline_constraints_d/operations/minkowski_sum/internal/Region_elements_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Minkowski_sum {

// The curvature of an arc, its derivative, and that of the angle of the tangent, by the parameter of the arc, whose
// derivative is not zero.
template <Enclosing_number Number>
struct Curvature_jet
{
  Number curvature, change, turn;
};

template <Enclosing_number Number>
Curvature_jet<Number> curvature_jet(const Site_arc_2<Number>& arc, const Range& range)
{
  const auto x = arc.jet(range, 3);
  const Number square = squared_norm(x[1]), cube = square * CGAL::sqrt(square), cross_product = cross(x[1], x[2]),
               curvature = cross_product / cube;
  return {curvature, cross(x[1], x[3]) / cube - Number(3) * dot(x[1], x[2]) / square * curvature,
          cross_product / square};
}

} // namespace Minkowski_sum
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUM_INTERNAL_CURVATURE_JET_H
