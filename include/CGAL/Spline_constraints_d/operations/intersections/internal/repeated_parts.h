// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_REPEATED_PARTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_REPEATED_PARTS_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/proper_curves.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/finder_declarations.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

template <int d>
int times_over_itself(const Spline_patch<d>& curve)
{
  // What this explains is known without it.
  constexpr double time_limit = 0.3;
  constexpr std::size_t most_breaks = 1000;
  if (curve.number_of_parameters() != 1 || curve.numerators().front().breaks(0).size() > most_breaks)
    return 0;
  try {
    return proper_reparametrization(
               Bspline_curve<Exact_kernel, d>::from_homogeneous_coordinates(curve.numerators(), curve.weight()),
               {.time_limit = time_limit})
        .times();
  } catch (const Invalid_input&) { // a piece is a point
    return 0;
  }
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_REPEATED_PARTS_H
