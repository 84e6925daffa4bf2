// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The solvers of points with doubles alone and with intervals of doubles.
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/all_solutions.h>

namespace CGAL::Spline_constraints::internal {

CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(, Fast_solver_traits, CGAL::Sequential_tag)
CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(, Interval_solver_traits, CGAL::Sequential_tag)

} // namespace CGAL::Spline_constraints::internal
