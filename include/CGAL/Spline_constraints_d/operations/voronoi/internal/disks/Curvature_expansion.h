// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_CURVATURE_EXPANSION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_CURVATURE_EXPANSION_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/operations/voronoi/internal/disks/Curvature_bounds.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// The curvature of the disk that touches a footpoint, and its derivative, in the middle of a part; and its derivatives
// over the part.
template <Enclosing_number Interval = Common::Interval>
struct Curvature_expansion
{
  Interval at_middle = any_number<Interval>(), slope_at_middle = any_number<Interval>(), slope = any_number<Interval>(),
           second_derivative = any_number<Interval>();

  Curvature_expansion<Interval> operator-(const Curvature_expansion<Interval>& other) const
  {
    return {at_middle - other.at_middle, slope_at_middle - other.slope_at_middle, slope - other.slope,
            second_derivative - other.second_derivative};
  }

  // Over the part, where the parameter is shifted from the middle.
  Interval value(const Interval& shift) const
  {
    return common_part(at_middle + slope * shift,
                       at_middle + slope_at_middle * shift + second_derivative * CGAL::square(shift) / Interval(2));
  }
  int sign(const Interval& shift) const { return certain_sign(value(shift)); }
  Interval derivative(const Interval& shift) const
  {
    return common_part(slope, slope_at_middle + second_derivative * shift);
  }
};

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DISKS_CURVATURE_EXPANSION_H
