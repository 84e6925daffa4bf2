// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_IMPLICIT_FEET_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_IMPLICIT_FEET_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Rational_interval.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#include <CGAL/Spline_constraints_d/solver/Undecided_part.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

// Points of f = 0, or of f = g = 0 in space, in a box where the distance to a point is critical, there or on a face.
struct Found_implicit_feet
{
  struct Foot
  {
    std::vector<std::pair<Exact_rational, Exact_rational>> box;
    Rational_interval squared_distance;
    Solution_kind kind;
    bool is_inside;
  };
  std::vector<Foot> feet = {};
  std::vector<Undecided_part> undecided = {};
  std::vector<Rational_interval> undecided_distances = {};
  Summary summary = {};
};

// Defined in Implicit_foot_finder.h.
Found_implicit_feet implicit_feet_of(const std::vector<Power_polynomial>& polynomials,
                                     const std::vector<std::pair<Exact_rational, Exact_rational>>& box,
                                     const std::vector<Exact_rational>& point, const Solver_options& options);

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_FOUND_IMPLICIT_FEET_H
