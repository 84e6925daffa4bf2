// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CONVEXITY_FINDERS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CONVEXITY_FINDERS_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/Function_shape.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/Patch_shape.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Implicit_patches {

// Defined in convexity_of_patch.h, convexity_of_function.h and dominant_coefficients.h; the compiled library has them.
Patch_shape convexity_of_patch(const Simplex_function_3& function, const Solver_options& options);
Function_shape convexity_of_function(const Simplex_function_3& function, const Solver_options& options);
std::optional<Simplex_function_3>
nearest_dominant_function(const Simplex_function_3& function,
                          const std::vector<Simplex_function_3::Form::Exponents>& fixed);

} // namespace Implicit_patches
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_INTERNAL_CONVEXITY_FINDERS_H
