// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_PARAMETER_BOUNDS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_PARAMETER_BOUNDS_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Site_arc_2.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Voronoi {

// Bounds of the parameters of a range of an arc, of its curve; of an arc with ends that are not known exactly, with all
// errors.
inline std::array<double, 2> parameter_bounds(const Site_arc_2<>& arc, const Range& range)
{
  const auto& [first, last] = arc.piece().domain;
  const Interval error = interval_of<Interval>(arc.error()), begin = interval_of<Interval>(first),
                 end = interval_of<Interval>(last),
                 all = begin + (end - begin) * (interval_of<Interval>(range) + Interval(-error.sup(), error.sup()));
  const Interval result = error.sup() > 0 ? all : common_part(all, hull(begin, end));
  return {result.inf(), result.sup()};
}

} // namespace Voronoi
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_VORONOI_INTERNAL_DIAGRAM_PARAMETER_BOUNDS_H
