// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_UNDECIDED_REGION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_UNDECIDED_REGION_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <CGAL/number_utils.h>

#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Regions {

// What is undecided of an answer about a region that is not complete: where this may be, and all of its curves, which
// are counted from a number on.
template <class Region>
Undecided_part undecided_region(const Region& region, std::size_t first_curve)
{
  Undecided_part result = region.undecided().front();
  for (std::size_t c = 0; c < region.curves().size(); ++c) {
    const auto [begin, end] = region.curves()[c].domain();
    result.parameters.push_back({first_curve + c, {{CGAL::to_interval(begin).first, CGAL::to_interval(end).second}}});
  }
  return result;
}

// The summary of such an answer, for which nothing was done.
inline Summary undecided_summary(Undecided_reason reason)
{
  Summary result;
  result.is_complete = false;
  result.why_not = reason;
  return result;
}

} // namespace Regions
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_REGIONS_INTERNAL_UNDECIDED_REGION_H
