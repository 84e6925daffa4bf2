// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_PATCH_CONVEXITY_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_PATCH_CONVEXITY_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/Function_shape.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/Patch_shape.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/convexity_finders.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/curvature_forms.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/convexity_of_function.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/internal/convexity_of_patch.h>
#endif

#include <array>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

The numerators of the curvatures of the level surfaces of a function: the Gaussian curvature is
\f$E_2 / |\nabla f|^4\f$, and the sum of the principal curvatures, positive for a ball where \f$f\f$ is negative, is
\f$E_1 / |\nabla f|^3\f$.
*/
struct Curvature_polynomials
{
  Power_polynomial gaussian; ///< \f$E_2 = \nabla f^T \mathrm{adj}(H)\, \nabla f\f$
  Power_polynomial mean;     ///< \f$E_1 = |\nabla f|^2\, \mathrm{tr} H - \nabla f^T H\, \nabla f\f$
};

//! \ingroup PkgSplineConstraintsDImplicitPatches
//! these for a polynomial in the unknowns 0, 1, 2, of degrees \f$4k-6\f$ and \f$3k-4\f$.
inline Curvature_polynomials curvature_polynomials(const Power_polynomial& f)
{
  const std::array<Power_polynomial, 3> gradient{f.derivative(0), f.derivative(1), f.derivative(2)};
  const auto forms = internal::Implicit_patches::curvature_forms(
      gradient, internal::Implicit_patches::second_derivatives(gradient, [](const Power_polynomial& g, int axis) {
        return g.derivative(axis);
      }));
  return {forms.gaussian, forms.mean};
}

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

tells, by proof, whether a polynomial is a convex or a concave function on a tetrahedron. For degrees 2 and 3 that is
decided at once: the second derivatives are constant, or affine. From degree 4 on the tetrahedron is cut in parts; where
a matrix is singular within it, without being so at a vertex of a part, answers may stay indeterminate. A convex
function has convex patches; the converse is not true, see `patch_convexity()`.
\param function the polynomial on the tetrahedron.
\param options the tolerance is the length of the longest edge of parts that are not cut any more, relative to that of
the tetrahedron. Parts are counted as nodes.
\throws Invalid_input when an option makes no sense.

Complexity: an elimination of three rows for each coefficient of second derivatives, on each part. Source:
\cgalCite{g-scim-91}, section 4, where it is the criterion for patches of degree 2 and 3.
*/
inline Function_shape function_convexity(const Simplex_function_3& function,
                                         const Solver_options& options = {.tolerance = 0x1p-7})
{
  return internal::Implicit_patches::convexity_of_function(function, options);
}

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

tells, by proof, whether an implicit patch, the zeros of a polynomial in a tetrahedron, is convex, with the solid where
the polynomial is negative: whether its second derivatives along tangents are nowhere negative. Also whether it is
concave, strictly so, regular, and empty. It is a question for each point: two sheets that are convex are a convex
patch.

The tetrahedron is cut until signs of Bernstein coefficients decide on each part, exactly; parabolic patches, as of
cones and cylinders, by common factors. A no comes with a witness in rational numbers. A singular point with rational
coordinates is found, as a rule. What ends undecided: curves where the Gaussian curvature is zero without a change of
sign, inside of the tetrahedron and not on edges or faces of parts; singular points that are not rational; contacts of
the patch with the boundary of the tetrahedron that are neither.
\param function the polynomial on the tetrahedron.
\param options the tolerance is the length of the longest edge of parts that are not cut any more, relative to that of
the tetrahedron; it grows when `coarsening_step` parts have come to it. Parts are counted as nodes.
\throws Invalid_input when the function is constant, when it has a degree above 8, and when an option makes no sense.

Complexity: a subdivision of polynomials of degree \f$k\f$, \f$4k-6\f$ and \f$3k-4\f$ on each part. Source: the problem
is that of \cgalCite{g-scim-91}, Theorem 1, whose criterion is sufficient; this one is necessary, too.
*/
inline Patch_shape patch_convexity(const Simplex_function_3& function,
                                   const Solver_options& options = {.tolerance = 0x1p-7})
{
  return internal::Implicit_patches::convexity_of_patch(function, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_PATCH_CONVEXITY_H
