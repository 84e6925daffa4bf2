// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_UNDECIDED_SOLUTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_UNDECIDED_SOLUTION_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// What stands for all solutions with unknowns in a box, where none were looked for.
inline Solution_d<double> undecided_solution(const std::vector<std::pair<Exact_rational, Exact_rational>>& box,
                                             Undecided_reason reason)
{
  Solution_d<double>::Box ranges;
  for (const auto& range : box)
    ranges.push_back(to_double_range(range));
  return Solution_d<double>(Solution_kind::UNDECIDED, std::move(ranges), {}, "none", reason, 0);
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_UNDECIDED_SOLUTION_H
