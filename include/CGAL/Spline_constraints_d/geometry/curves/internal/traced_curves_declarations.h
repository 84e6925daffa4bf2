// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_TRACED_CURVES_DECLARATIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_TRACED_CURVES_DECLARATIONS_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Proper_reparametrization.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Proper {

// Defined in traced_curves.h.
int tracing_index(const Bspline_curve<Exact_kernel, 2>& curve);
int tracing_index(const Bspline_curve<Exact_kernel, 3>& curve);
bool have_same_support(const Bspline_curve<Exact_kernel, 2>& first, const Bspline_curve<Exact_kernel, 2>& second);
bool have_same_support(const Bspline_curve<Exact_kernel, 3>& first, const Bspline_curve<Exact_kernel, 3>& second);
Proper_reparametrization<2> proper_reparametrization(const Bspline_curve<Exact_kernel, 2>& curve,
                                                     const Solver_options& options);
Proper_reparametrization<3> proper_reparametrization(const Bspline_curve<Exact_kernel, 3>& curve,
                                                     const Solver_options& options);

} // namespace Proper
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_TRACED_CURVES_DECLARATIONS_H
