// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_SEARCH_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What an operation knows of its curves.
struct Curve_search
{
  // curves in faces of the domain, since each point is on several faces, or in several places of one
  bool are_faces_undecided = false;
  // both ends of their ranges are the same: curves in these faces are found at the lower one
  std::vector<std::size_t> closed_unknowns = {};
  // faces, by an unknown and its value, that stand for one point: there are no curves in them
  std::vector<std::pair<std::size_t, Exact_rational>> points = {};
  // asked when curves seem to be singular, and no equality has repeated factors: whether there are better equations
  std::function<bool()> gives_up = [] { return false; };
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_CURVE_SEARCH_H
