// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_REGULAR_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_REGULAR_POINTS_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/Elementary_operand.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The common points of two operands, where all of them are seen to be regular, or else the solutions of their
// equations.
template <int d>
struct Regular_points
{
  std::optional<Solution_set_d<double>> solutions = std::nullopt;
  std::optional<Elementary_points<d>> points = std::nullopt;
};

// Of two planar polynomial curves in one piece each that cross in all common points, if doubles prove that.
template <int d>
std::optional<Elementary_points<d>> crossing_points(const Elementary_operand<d>& first,
                                                    const Elementary_operand<d>& second);

// Of two polynomial curves, or of a curve and a surface, in one piece each; nothing where they take many nodes. Both
// are defined in Regular_finder.h.
template <int d>
Regular_points<d> regular_points(const Elementary_operand<d>& first, const Elementary_operand<d>& second,
                                 Budgeted_solver& solve);

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template std::optional<Elementary_points<2>> crossing_points<2>(const Elementary_operand<2>&,
                                                                       const Elementary_operand<2>&);
extern template std::optional<Elementary_points<3>> crossing_points<3>(const Elementary_operand<3>&,
                                                                       const Elementary_operand<3>&);
extern template Regular_points<2> regular_points<2>(const Elementary_operand<2>&, const Elementary_operand<2>&,
                                                    Budgeted_solver&);
extern template Regular_points<3> regular_points<3>(const Elementary_operand<3>&, const Elementary_operand<3>&,
                                                    Budgeted_solver&);
#endif

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_REGULAR_POINTS_H
