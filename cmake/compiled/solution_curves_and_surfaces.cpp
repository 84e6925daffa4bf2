// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The default solvers of curves and of surfaces, on one core and on all. What other sources of the library have is only
// declared.
#define CGAL_SPLINE_CONSTRAINTS_COMPILED

#include <CGAL/Spline_constraints_d/solver/internal/curves/all_curves.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/curves_after_elimination.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/surfaces_after_elimination.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/all_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/united_surfaces.h>

namespace CGAL::Spline_constraints::internal {

CGAL_SPLINE_CONSTRAINTS_COMPILED_SOLVERS_OF_CURVES_AND_SURFACES()

} // namespace CGAL::Spline_constraints::internal
