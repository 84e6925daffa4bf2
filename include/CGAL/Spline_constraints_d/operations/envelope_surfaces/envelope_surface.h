// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_ENVELOPE_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_ENVELOPE_SURFACE_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_mesh.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelopes_of_two_surfaces.h>
#endif

#include <concepts>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

the envelope of two surfaces, untrimmed: the sums of points of both in which they have the same normal direction. It is
the envelope of one surface when its origin is taken along the other one, the convolution of both, and holds the
boundary of the Minkowski sum of what they bound: \f[ S_1(u,v) + S_2(s,t), \qquad \langle N_1, \partial_s S_2\rangle =
\langle N_1, \partial_t S_2\rangle = 0,\quad \langle N_1, N_2\rangle > 0. \f] Of the solutions of the two equations a
connected surface is kept as a whole or not at all, as the last product has one sign there.

Edges and corners of the surfaces take no part. Where poles of both surfaces have the same normal direction the answer
is undecided: such a sphere can be given another pole. So it is where both surfaces are flat with the same normal.

\param first,second models of `ParametricSurface_3`, or objects of CGAL that are converted to one, of the same kernel.
\param options the limits, for the operation as a whole, and a visitor.
\return the surface; the unknowns are \f$u, v, s, t\f$.
\throws Invalid_input when a piece of a surface is a curve or a point, a number is not finite, a weight is not proved
to have one sign, or an option makes no sense.

Complexity: that of `solve_surfaces()` for a system of two equations in four unknowns, for each pair of smooth parts.
Source: \cgalCite{kes-gcps-05}, section 2.2, equations (4)-(8).
*/
template <internal::Surface_curves::Surface_operand First, internal::Surface_curves::Surface_operand Second>
requires std::same_as<internal::Surface_curves::Operand_kernel<First>, internal::Surface_curves::Operand_kernel<Second>>
    Envelope_surface_3 envelope_surface(const First& first, const Second& second,
                                        const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Envelope_surfaces::envelope_surface_of(internal::Common::Intersection_operand<First>::map(first),
                                                          internal::Common::Intersection_operand<Second>::map(second),
                                                          options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_ENVELOPE_SURFACE_H
