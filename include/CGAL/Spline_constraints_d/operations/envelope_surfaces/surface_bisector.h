// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_SURFACE_BISECTOR_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_SURFACE_BISECTOR_H

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

the bisector of two surfaces, untrimmed: the centers of all spheres up to a radius \f$r\f$ that touch both. With normals
\f$N_1\f$, \f$N_2\f$, not of unit length, these are the points
\f[ B = S_1(u,v) + x N_1(u,v) = S_2(s,t) \pm x q N_2(s,t), \qquad |N_1|^2 = q^2\, |N_2|^2,\quad q > 0,\quad
|x N_1| \leq r. \f]
Other points of the surfaces may be nearer than these two. Spheres with \f$x > 0\f$ are on the side of
\f$S_u \times S_v\f$ of the first surface. For each pair of smooth parts there are two parts of the answer: that with
spheres on such a side of both surfaces or of neither, and that with spheres on such a side of one.

Where normals divided by the weight of a surface have constant rational lengths, as those of many planes and of most
spheres, cylinders, cones and tori, they are unit vectors, and \f$|x|\f$ is the distance; of two such surfaces there is
no \f$q\f$. If only the second surface is one, \f$B = S_1 + x q N_1 = S_2 \pm x N_2\f$.

The radius keeps away from points at infinity. Where the surfaces cross, a bisector goes through their common curve from
one side of both to the other, at \f$x = 0\f$; where they touch it is undecided. It is so where all points of a curve
or surface have the same center, as at the center of a sphere that has the right distance from the other surface, and
along curves that lie in breaks of both surfaces, as for spheres that are cut by the same plane of symmetry. A bisector
ends at creases and edges of the surfaces, which are no operands. Beyond centers of curvature it has cuspidal edges,
which are not looked for.

\param first,second models of `ParametricSurface_3`, or objects of CGAL that are converted to one, of the same kernel.
\param radius the greatest radius.
\param sides the sides of the surfaces on which spheres touch them; with both given there is half the work.
\param options the limits, for the operation as a whole, and a visitor.
\return the surface; the unknowns are \f$u, v, s, t, x\f$, and \f$q\f$. Where normals are not proved to be
different from zero it is undecided.
\throws Invalid_input when surfaces are proved to overlap, a piece of one is a curve or a point, the radius is not
positive, a number is not finite, a weight is not proved to have one sign, or an option makes no sense.

Complexity: that of `solve_surfaces()` for three equations in five unknowns if the normals of both surfaces are unit
vectors, for four in six if those of one are, else with an inequality, for each pair of smooth parts and sides.
Source: \cgalCite{ek-gcs-01}, section 3.3, and \cgalCite{kes-gcps-05}, section 4; in both the center is eliminated.
*/
template <internal::Surface_curves::Surface_operand First, internal::Surface_curves::Surface_operand Second>
requires std::same_as<internal::Surface_curves::Operand_kernel<First>, internal::Surface_curves::Operand_kernel<Second>>
    Envelope_surface_3 surface_bisector(const First& first, const Second& second,
                                        const typename internal::Surface_curves::Operand_kernel<First>::FT& radius,
                                        const Touched_sides& sides = {},
                                        const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Envelope_surfaces::surface_bisector_of(internal::Common::Intersection_operand<First>::map(first),
                                                          internal::Common::Intersection_operand<Second>::map(second),
                                                          internal::converted_number<Exact_rational>(radius), sides,
                                                          options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_SURFACE_BISECTOR_H
