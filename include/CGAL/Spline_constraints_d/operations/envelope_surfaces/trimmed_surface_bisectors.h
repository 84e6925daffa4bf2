// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_TRIMMED_SURFACE_BISECTORS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_TRIMMED_SURFACE_BISECTORS_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Intersection_operand.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Touched_sides.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/Trimmed_envelope_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_finders.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/bisectors_of_surfaces.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/curve_surface_bisectors.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/envelope_mesh.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/trimmed_mesh.h>
#include <CGAL/Spline_constraints_d/operations/envelope_surfaces/internal/trimmed_sheets.h>
#endif

#include <concepts>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

the bisector of two surfaces, trimmed: of `surface_bisector()`, where no point of a surface is nearer than the foot on
it. All of this is on the set of points with the same distance from both surfaces; the rest of that set has a foot on an
edge or a crease, which are no operands here.

The patches of the untrimmed bisector are cut into cells, boxes of the parameters of both surfaces. In a cell some point
of a surface is certainly nearer than the foot, or none: the latter since parts of the surface are farther away, but for
a neighbourhood of the foot where the squared distance is strictly convex in a chart, or where spheres touch the surface
along lines. Or the least difference of squared distances increases with a parameter, so that there is one arc at most
between both labels. Cells narrower than 1/128 of the parameters of a piece for which nothing of this is proved are
undecided: those where two feet come together, at the ends of curves where other points are as near; where a point as
near is on an edge close to a center of curvature; where borders cross; and where the border crosses an edge of the
bisector.

\param first,second models of `ParametricSurface_3`, or objects of CGAL that are converted to one, of the same kernel.
\param radius the greatest radius.
\param sides the sides of the surfaces on which spheres touch them; with both given there is half the work.
\param options the limits, for the operation as a whole, and a visitor.
\return the cells, and with `Trimmed_envelope_surface_3::mesh()` triangles. Where polynomials of the curvatures of a
surface would be too large, all is undecided.
\throws Invalid_input as `surface_bisector()`.

Complexity: that of `surface_bisector()`, and for each cell a search among all cells of a grid on both surfaces.
Source: the sheets are those of \cgalCite{ek-gcs-01}, which does not trim them.
*/
template <internal::Surface_curves::Surface_operand First, internal::Surface_curves::Surface_operand Second>
requires std::same_as<internal::Surface_curves::Operand_kernel<First>, internal::Surface_curves::Operand_kernel<Second>>
    Trimmed_envelope_surface_3
    trimmed_surface_bisector(const First& first, const Second& second,
                             const typename internal::Surface_curves::Operand_kernel<First>::FT& radius,
                             const Touched_sides& sides = {}, const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Envelope_surfaces::trimmed_surface_bisector_of(
      internal::Common::Intersection_operand<First>::map(first),
      internal::Common::Intersection_operand<Second>::map(second), internal::converted_number<Exact_rational>(radius),
      sides, options);
}

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

the \f$\alpha\f$-sector of two surfaces, trimmed: of `alpha_sector_surface()`, where no point of a surface is nearer
than the foot on it, so that the distances from both surfaces have the ratio \f$\alpha : 1 - \alpha\f$. Labels, and what
is undecided, are as for `trimmed_surface_bisector()`.

\param first,second models of `ParametricSurface_3`, or objects of CGAL that are converted to one, of the same kernel.
\param alpha the share of the distance from the first surface, exactly; between 0 and 1, and not 1/2.
\param sides the sides of the surfaces on which spheres touch them; with both given there is half the work.
\param options the limits, for the operation as a whole, and a visitor.
\throws Invalid_input as `alpha_sector_surface()`.

Complexity: that of `trimmed_surface_bisector()`. Source: as for `alpha_sector_surface()`.
*/
template <internal::Surface_curves::Surface_operand First, internal::Surface_curves::Surface_operand Second>
requires std::same_as<internal::Surface_curves::Operand_kernel<First>, internal::Surface_curves::Operand_kernel<Second>>
    Trimmed_envelope_surface_3
    trimmed_alpha_sector_surface(const First& first, const Second& second,
                                 const typename internal::Surface_curves::Operand_kernel<First>::FT& alpha,
                                 const Touched_sides& sides = {}, const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Envelope_surfaces::trimmed_alpha_sector_surface_of(
      internal::Common::Intersection_operand<First>::map(first),
      internal::Common::Intersection_operand<Second>::map(second), internal::converted_number<Exact_rational>(alpha),
      sides, options);
}

/*!
\ingroup PkgSplineConstraintsDEnvelopeSurfaces

the bisector of a curve and a surface, trimmed: of `curve_surface_bisector()`, where no point of the curve or the
surface is nearer than the foot on it. Labels, and what is undecided, are as for `trimmed_surface_bisector()`; on the
curve the second derivative of the squared distance decides. Next to common points of both all is undecided.

\param curve a model of `ParametricCurve_3`.
\param surface a model of `ParametricSurface_3`, of the same kernel.
\param radius the greatest radius.
\param options the limits, for the operation as a whole, and a visitor.
\throws Invalid_input as `curve_surface_bisector()`.

Complexity: that of `trimmed_surface_bisector()`. Source: as for `curve_surface_bisector()`.
*/
template <ParametricCurve_3 Curve, ParametricSurface_3 Surface>
Trimmed_envelope_surface_3 trimmed_curve_surface_bisector(const Curve& curve, const Surface& surface,
                                                          const typename Surface::Kernel::FT& radius,
                                                          const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Envelope_surfaces::trimmed_curve_surface_bisector_of(
      internal::Common::exact_map<3>(curve), internal::Common::exact_map<3>(surface),
      internal::converted_number<Exact_rational>(radius), options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_ENVELOPE_SURFACES_TRIMMED_SURFACE_BISECTORS_H
