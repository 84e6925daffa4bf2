// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CRITICAL_DISTANCE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CRITICAL_DISTANCE_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Parameters of two operands where the derivatives of their distance are as a `Joint_rule` asks.
struct Critical_distance
{
  Solution_kind kind;
  std::array<std::vector<std::pair<Exact_rational, Exact_rational>>, 2> ranges;
  std::array<std::vector<Exact_rational>, 2> sample; // in these ranges
  Rational_interval squared_distance;
  std::optional<Solution_d<double>> solution;
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_CRITICAL_DISTANCE_H
