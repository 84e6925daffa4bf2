// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Closest points, feet of perpendiculars, and Hausdorff distances.
// What other sources of the library have is only declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/operations/distances/internal/Critical_distances.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/Farthest_point_search.h>

namespace CGAL::Spline_constraints::internal::Distances {

template Found_distances<2> projections_of<2>(const Exact_map<2>&, const Exact_map<2>&, const Solver_options&);
template Found_distances<3> projections_of<3>(const Exact_map<3>&, const Exact_map<3>&, const Solver_options&);
template Found_distances<2> nearest_points_of<2>(const Exact_map<2>&, const Exact_map<2>&, const Solver_options&);
template Found_distances<3> nearest_points_of<3>(const Exact_map<3>&, const Exact_map<3>&, const Solver_options&);
template Found_hausdorff_distance<2> hausdorff_distance_of<2>(const Exact_map<2>&, const Exact_map<2>&, double, bool,
                                                              const Solver_options&);
template Found_hausdorff_distance<3> hausdorff_distance_of<3>(const Exact_map<3>&, const Exact_map<3>&, double, bool,
                                                              const Solver_options&);

} // namespace CGAL::Spline_constraints::internal::Distances
