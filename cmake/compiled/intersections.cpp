// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What finds the common points of two operands, where curves meet themselves, and where surfaces touch.
// What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/intersections/internal/Contact_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Self_intersection_finder.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/common_points.h>

namespace CGAL::Spline_constraints::internal::Intersections {

template std::vector<Common_point> common_points<2>(const Patch_pair<2>&, Budgeted_solver&);
template std::vector<Common_point> common_points<3>(const Patch_pair<3>&, Budgeted_solver&);
template std::vector<Common_point> self_common_points<2>(const Spline_patch<2>&, Budgeted_solver&);
template std::vector<Common_point> self_common_points<3>(const Spline_patch<3>&, Budgeted_solver&);

} // namespace CGAL::Spline_constraints::internal::Intersections
