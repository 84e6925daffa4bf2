// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_ALPHA_SECTOR_SURFACE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_ALPHA_SECTOR_SURFACE_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Touched_sides.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/bisectors_of_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_mesh.h>
#endif

#include <concepts>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

the \f$\alpha\f$-sector of two surfaces, untrimmed: all points \f$P\f$ on normals of both surfaces whose distances from
the two points there have the ratio \f$\alpha : 1 - \alpha\f$. With normals \f$N_1\f$, \f$N_2\f$, not of unit length,
and \f$c = (1-\alpha)/\alpha\f$, these are
\f[ P = S_1(u,v) + x N_1(u,v) = S_2(s,t) \pm c\,x q N_2(s,t), \qquad |N_1|^2 = q^2\, |N_2|^2,\quad q > 0. \f]
Other points of the surfaces may be nearer. Parts, unit normals, crossings, ends and what is undecided are as for
`surface_bisector()`. But nothing is at infinity, and there is no greatest radius: with \f$d = S_1 - S_2\f$,
\f$|x N_1| \leq |d|/|1-c|\f$.

\param first,second models of `ParametricSurface_3`, or objects of CGAL that are converted to one, of the same kernel.
\param alpha the share of the distance from the first surface, exactly; between 0 and 1, where the first and the second
surface would be the answer, and not 1/2.
\param sides the sides of the surfaces on which spheres touch them; with both given there is half the work.
\param options the limits, for the operation as a whole, and a visitor.
\return the surface; the unknowns are \f$u, v, s, t, x\f$, and \f$q\f$. Where normals are not proved to be
different from zero it is undecided.
\throws Invalid_input when surfaces are proved to overlap, a piece of one is a curve or a point, \f$\alpha\f$ is not
inside of (0,1) or is 1/2, a number is not finite, a weight is not proved to have one sign, or an option makes no sense.

Complexity: that of `solve_surfaces()` for three equations in five unknowns, or four in six, for each pair of smooth
parts and sides.
Source: \cgalCite{kes-gcps-05}, where alpha-sectors of curves are in section 3.2.
*/
template <internal::Surface_curves::Surface_operand First, internal::Surface_curves::Surface_operand Second>
requires std::same_as<internal::Surface_curves::Operand_kernel<First>, internal::Surface_curves::Operand_kernel<Second>>
    Envelope_surface_3 alpha_sector_surface(const First& first, const Second& second,
                                            const typename internal::Surface_curves::Operand_kernel<First>::FT& alpha,
                                            const Touched_sides& sides = {},
                                            const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Envelope_surfaces::alpha_sector_surface_of(
      internal::Common::Intersection_operand<First>::map(first),
      internal::Common::Intersection_operand<Second>::map(second), internal::converted_number<Exact_rational>(alpha),
      sides, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_ALPHA_SECTOR_SURFACE_H
