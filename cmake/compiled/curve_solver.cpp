// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The default solver of curves, and points on its curves; the solver of points has a source of its own.
#include <CGAL/Spline_constraints_d/solver/internal/curves/Curve_points.h>
#include <CGAL/Spline_constraints_d/solver/internal/curves/all_curves.h>

namespace CGAL::Spline_constraints::internal {

CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_POINTS(extern, Certified_solver_traits, CGAL::Sequential_tag)
CGAL_SPLINE_CONSTRAINTS_SOLVER_OF_CURVES(, Certified_solver_traits, CGAL::Sequential_tag)

} // namespace CGAL::Spline_constraints::internal
