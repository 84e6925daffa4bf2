// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_SWEEP_ENVELOPE_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_SWEEP_ENVELOPE_H

#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Rational_motion_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_mesh.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/sweep_envelopes.h>
#endif

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

the envelope of a moving surface, untrimmed: all points where a moved surface \f$T(\cdot,\cdot,t)\f$ has a velocity in
its tangent plane. With \f$T = (M S + c) / w\f$ they are the solutions of one equation in the parameters \f$u, v\f$ and
the time \f$t\f$, seen from the moving space: \f[ \langle B(t)\, S(u,v) + b(t),\ N(u,v)\rangle = 0,\quad B = w\,
\mathrm{adj}(M) M' - w' \det(M) I,\quad b = \mathrm{adj}(M) (w c' - w' c). \f]
What the coefficients of \f$B\f$ and \f$b\f$, and the coordinates of \f$N\f$, have in common is divided out. For a
rotation \f$B S\f$ is \f$\omega \times S\f$ with the axial vector \f$\omega = 2\, \mathrm{Im}(\bar a a')\f$ of its
quaternion: constant for a turn about an axis.

The envelope ends at creases of the surface, and where a velocity jumps. Where all of a smooth part of the surface moves
along itself, as a surface of revolution about its axis, or stands still, this is told as undecided. Poles of the
surface are boundary edges of the domain of the parameters, each of which is one point at a time.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param motion the motion.
\param options the limits, for the operation as a whole, and a visitor.
\return the surface; the unknowns are \f$u, v, t\f$.
\throws Invalid_input when a coordinate is not finite, a weight is not proved to have one sign, or an option makes no
sense.

Complexity: that of `solve_surfaces()` for a system of one equation, for each smooth part of surface and motion.
Sources: \cgalCite{ek-gcs-01}, section 3.4, with the determinant there written as this inner product;
\cgalCite{kes-gcps-05}, section 5.
*/
template <internal::Surface_curves::Surface_operand Surface>
Envelope_surface_3 sweep_envelope(const Surface& surface, const Rational_motion_3& motion,
                                  const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Envelope_surfaces::sweep_envelope_of(internal::Common::Intersection_operand<Surface>::map(surface),
                                                        motion, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_SWEEP_ENVELOPE_H
