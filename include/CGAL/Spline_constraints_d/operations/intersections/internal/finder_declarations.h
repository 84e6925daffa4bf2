// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FINDER_DECLARATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FINDER_DECLARATIONS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Budgeted_solver.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solution_set_d.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

// The solutions of the equations of two operands, where they have been looked for.
using Known_solutions = std::optional<Solution_set_d<double>>;

// The common points of two operands; defined in common_points.h.
template <int d>
std::vector<Common_point> common_points(const Patch_pair<d>& pair, Budgeted_solver& solve,
                                        const Known_solutions& known = std::nullopt);

// Where a curve meets itself; defined in Self_intersection_finder.h.
template <int d>
std::vector<Common_point> self_common_points(const Spline_patch<d>& curve, Budgeted_solver& solve);

// How often a curve runs over the part of itself that it runs over most often; 0 if that is not found in 0.3 s, or it
// is no curve. Defined in repeated_parts.h.
template <int d>
int times_over_itself(const Spline_patch<d>& curve);

// Where two surfaces touch; defined in Contact_finder.h.
std::vector<Common_point> contacts_of_surfaces(const Patch_pair<3>& pair, Budgeted_solver& solve);

#ifdef CGAL_SPLINE_CONSTRAINTS_COMPILED
extern template std::vector<Common_point> common_points<2>(const Patch_pair<2>&, Budgeted_solver&,
                                                           const Known_solutions&);
extern template std::vector<Common_point> common_points<3>(const Patch_pair<3>&, Budgeted_solver&,
                                                           const Known_solutions&);
extern template std::vector<Common_point> self_common_points<2>(const Spline_patch<2>&, Budgeted_solver&);
extern template std::vector<Common_point> self_common_points<3>(const Spline_patch<3>&, Budgeted_solver&);
extern template int times_over_itself<2>(const Spline_patch<2>&);
extern template int times_over_itself<3>(const Spline_patch<3>&);
#endif

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_FINDER_DECLARATIONS_H
