// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SOLVED_PART_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SOLVED_PART_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_curve.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Operation_budget.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Found_intersection.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Surface_equations.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solution_set_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// Equations of common points of two surfaces, and their solutions.
struct Solved_part
{
  Surface_equations surfaces;
  Curve_solution_set_d solutions;
  // faces of the domain, by an unknown and its value, that are one point in space: there curves may go on
  std::vector<std::pair<std::size_t, Exact_rational>> poles = {};
  bool is_overlap = false;   // the surfaces are proved to have an open part in common, and nothing else is known
};

// The curves of several parts, and their points.
struct Joined_curves
{
  std::vector<Intersection_curve> curves;
  std::vector<Part_vertex> points, singular_points;   // single points, and singular ones
  std::vector<Part_vertex> equal_pairs;               // pairs of equal points, where curves end
  std::vector<Part_vertex> unmatched;                 // where it is not known how a curve goes on
};

// Joins the curves of parts that have a system each; defined in Joined_parts.h.
Joined_curves joined_curves(const std::vector<Solved_part>& parts);

// The common curves of two surfaces; by the equations in all parameters alone, or in those that tell most. Defined in
// common_curves.h.
Solved_part curves_in_all_parameters(const Surface_equations& surfaces, Operation_budget& budget);
Solved_part common_curves(const Surface_equations& surfaces, Operation_budget& budget);

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_SOLVED_PART_H
