// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUMS_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUMS_2_H

#include <CGAL/Spline_constraints_d/operations/Minkowski_sum_2.h>
#include <CGAL/Spline_constraints_d/operations/planar_regions_2.h>

namespace CGAL {
namespace Spline_constraints {

template <SplineKernel Kernel>
Minkowski_sum_2<Kernel> minkowski_sum(const Planar_region_2<Kernel>& a, const Planar_region_2<Kernel>& b)
{
  return Minkowski_sum_2<Kernel>(a, b);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_MINKOWSKI_SUMS_2_H
