// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The default solvers of points by subdivision, on one core and on all. What other sources of the library have is only
// declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposed_solutions.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/all_solutions.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/solution_set.h>

namespace CGAL::Spline_constraints::internal {

CGAL_SPLINE_CONSTRAINTS_COMPILED_SOLVERS_OF_POINTS()

} // namespace CGAL::Spline_constraints::internal
