// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_HULL_OF_REGION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_HULL_OF_REGION_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// The box around the boxes of a region.
inline Curve_vertex::Exact_box hull_of(const Undecided_region& region)
{
  Curve_vertex::Exact_box result = region.boxes.front();
  for (const Curve_vertex::Exact_box& box : region.boxes)
    for (std::size_t j = 0; j < box.size(); ++j)
      result[j] = {(std::min)(result[j].first, box[j].first), (std::max)(result[j].second, box[j].second)};
  return result;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_HULL_OF_REGION_H
