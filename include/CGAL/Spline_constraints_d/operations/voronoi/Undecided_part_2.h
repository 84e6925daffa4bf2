// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_UNDECIDED_PART_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_UNDECIDED_PART_2_H

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDVoronoi

a part of a curve beside which not everything could be decided: its index and the range of its parameter; a point of the
curve, if both ends are equal.
*/
struct Undecided_part_2
{
  std::size_t curve;
  double from, to;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_UNDECIDED_PART_2_H
