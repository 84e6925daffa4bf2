// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_DOUBLE_RANGES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_DOUBLE_RANGES_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

inline Undecided_part::Range double_range(const Rational_interval& range)
{
  return to_double_range(std::pair(range.lower, range.upper));
}

inline Undecided_part::Range double_range(const std::pair<Exact_rational, Exact_rational>& range)
{
  return to_double_range(range);
}

// The least ranges of doubles around ranges of exact numbers, for parts that are undecided.
template <class Ranges>
std::vector<Undecided_part::Range> double_ranges(const Ranges& ranges)
{
  std::vector<Undecided_part::Range> result;
  for (const auto& range : ranges)
    result.push_back(double_range(range));
  return result;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_DOUBLE_RANGES_H
