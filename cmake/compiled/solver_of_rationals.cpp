// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The solvers of points whose answers are rational numbers.
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/all_solutions.h>

namespace CGAL::Spline_constraints::internal {

CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(, Multiprecision_solver_traits, CGAL::Sequential_tag)
CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(, Exact_solver_traits, CGAL::Sequential_tag)

} // namespace CGAL::Spline_constraints::internal
