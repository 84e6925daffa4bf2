// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_NEARBY_CONVEX_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_NEARBY_CONVEX_FUNCTION_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/convexity_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/dominant_coefficients.h>
#endif

#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

the function of the same degree, 2 or 3, with the coefficients nearest to given ones, in the sense of least squares, for
which the matrices of second derivatives by the coordinates are diagonally dominant at the vertices, with diagonals that
are not negative. So it is convex on the tetrahedron, by proof. All of it is exact. Some convex functions, without that
property, may be nearer.
\param function the function.
\param fixed the exponents of coefficients that are not changed.
\returns nothing if there is no such function with these fixed coefficients, by proof.
\throws Invalid_input when the degree is above 3, or exponents are negative or do not have it as sum.

Complexity: a quadratic program with 20 unknowns and 48 constraints for cubics, solved exactly by `CGAL::QP_solver`: as
a rule less than 0.1 seconds. It cannot be stopped.
*/
inline std::optional<Simplex_function_3>
nearby_convex_function(const Simplex_function_3& function,
                       const std::vector<Simplex_function_3::Form::Exponents>& fixed = {})
{
  return internal::Implicit_patches::nearest_dominant_function(function, fixed);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_NEARBY_CONVEX_FUNCTION_H
