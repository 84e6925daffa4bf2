// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Formulas as functions of their unknowns, and splines with rational coefficients.
#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/internal/Local_weights.h>
#include <CGAL/Spline_constraints_d/function/internal/expanded.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Homogeneous_spline.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Patch_pair.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Spline_patch.h>

namespace CGAL::Spline_constraints {

template class Bernstein_tensor<Exact_rational>;
template class Bspline_function<Exact_rational>;

namespace internal {

template class Local_weights<Exact_rational>;
template class Homogeneous_spline<Exact_rational, 2>;
template class Homogeneous_spline<Exact_rational, 3>;

namespace Common {

template class Spline_patch<2>;
template class Spline_patch<3>;
template class Patch_pair<2>;
template class Patch_pair<3>;

} // namespace Common
} // namespace internal
} // namespace CGAL::Spline_constraints
