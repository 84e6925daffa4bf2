// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The default solvers of points and of curves, on one core and on all, and of surfaces, feasibility, Newton's method, and
// the proof of answers.
#include <CGAL/Spline_constraints_d/solver/Curve_differentials_d.h>
#include <CGAL/Spline_constraints_d/solver/internal/Newton_iteration.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/all_curves.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/decomposition_of.h>
#include <CGAL/Spline_constraints_d/solver/internal/decomposition/proof_by_parts.h>
#include <CGAL/Spline_constraints_d/solver/internal/feasibility/feasibility_of.h>
#include <CGAL/Spline_constraints_d/solver/internal/subdivision/all_solutions.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/all_surfaces.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/proof_of_answer.h>
#include <CGAL/Spline_constraints_d/solver/internal/verification/surface_proof.h>

namespace CGAL::Spline_constraints {

CGAL_SPLINE_CONSTRAINTS_CURVE_DIFFERENTIALS(, Mpfr_interval)
CGAL_SPLINE_CONSTRAINTS_CURVE_DIFFERENTIALS(, Exact_rational)

namespace internal {

CGAL_SPLINE_CONSTRAINTS_COMPILED_SOLVERS()

} // namespace internal
} // namespace CGAL::Spline_constraints
