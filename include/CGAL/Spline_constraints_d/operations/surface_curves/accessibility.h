// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_ACCESSIBILITY_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_ACCESSIBILITY_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Surface_curves_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Access_boundaries.h>
#endif

#include <CGAL/Sphere_3.h>

#include <concepts>
#include <optional>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

The direction in which a straight tool stands on a surface.
*/
template <SplineKernel Kernel>
struct Tool_axis
{
  //! the same direction everywhere, of any length; none: the normal \f$S_u \times S_v\f$ of the surface, unless there
  //! is a field.
  std::optional<typename Kernel::Vector_3> direction{};

  //! admits only directions \f$O\f$ with \f$\langle O, V\rangle > 0\f$ for this \f$V\f$; none: all. Curves end where
  //! this is zero; where it is, is not part of the result.
  std::optional<typename Kernel::Vector_3> hemisphere{};

  //! a field of directions over the domain of the surface, points standing for the vectors from the origin to them;
  //! none: normals. Where it is tangent to the surface the tool does not stand.
  std::optional<Bspline_surface_3<Kernel>> field{};

  //! the radius of the tool: all points within this distance of the ray belong to it; not negative.
  typename Kernel::FT radius{0};
};

namespace internal {
namespace Surface_curves {

template <SplineKernel Kernel>
Exact_tool_axis exact_tool_axis(const Tool_axis<Kernel>& axis)
{
  const auto checked = [](const std::optional<typename Kernel::Vector_3>& vector) {
    const auto result = vector ? std::optional(exact_triple(*vector)) : std::nullopt;
    if (result && (*result)[0] == 0 && (*result)[1] == 0 && (*result)[2] == 0)
      throw Invalid_input("accessibility_boundaries: a direction is zero");
    return result;
  };
  if (!(axis.radius >= 0))
    throw Invalid_input("accessibility_boundaries: the radius of the tool is negative or not a number");
  return {checked(axis.direction), checked(axis.hemisphere),
          axis.field ? std::optional(exact_map<3>(*axis.field)) : std::nullopt,
          converted_number<Exact_rational>(axis.radius)};
}

} // namespace Surface_curves
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the curves on a surface between the places that a straight tool, as in 5-axis milling, can reach and those where a
check surface is in its way: where the ray from \f$S(u,v)\f$ along the axis \f$O(u,v)\f$ of the tool touches the check
surface \f$K(s,t)\f$, or meets an edge or a crease of it,
\f[ \langle K - S, O_1\rangle = \langle K - S, O_2\rangle = \langle n_K, O\rangle = 0, \quad \langle K - S, O\rangle >
0, \f] where \f$O_1\f$ and \f$O_2\f$ span the plane at a right angle to \f$O\f$; these are \f$S_u\f$ and \f$S_v\f$ for
the normal, \f$O \times S_u\f$ and \f$O \times S_v\f$ for a field. Each region of the surface between these curves is
reached as a whole or not at all. The topology of the curves is proved.

Other than in the source, the third equation has the axis in the place of \f$S - K\f$, which is parallel to it: so
points where the surfaces meet are no solutions, and the degree is lower. The inequality leaves only what is ahead of
the tool, not behind it, and edges of the check surface count, too. Of a sphere, the equation is \f$|(c - S) \times O|^2
= r^2 |O|^2\f$, with \f$c\f$ ahead, in the two parameters of the surface only.

A tool with a radius \f$r\f$ meets the offsets of the check surface on both sides, pipes around its edges and creases,
and spheres around its corners, where the distance of its axis to these is critical: with \f$D = K - S\f$,
\f[ |D \times O|^2 = r^2 |O|^2, \quad \langle D \times O, K_s \times O\rangle = \langle D \times O, K_t \times
O\rangle = 0, \quad \langle D, O\rangle > 0; \f]
and its end, half a ball, where \f$|D|^2 = r^2\f$ is critical. These, too, are candidates: some are within the offset of
another part.

Both surfaces are cut where normals or tangents jump by more than a constant factor, and each two parts have curves of
their own; cuts of the check surface count as creases. Where the axis of the tool runs along an edge of the check
surface, where the surfaces touch, and in singular points of higher order the answer is undecided.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one. Its parameters are the
first two unknowns.
\param check the check surface: such a surface as well, whose parameters, or the one along its edge, are the further
unknowns; or a `CGAL::Sphere_3`, without unknowns.
\param axis the directions of the tool.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\throws Invalid_input when a direction is zero, a radius negative, a field of directions has another domain than the
surface or comes with a direction, the sphere is degenerate, a coordinate is not finite, a weight is not proved to have
one sign, or an option makes no sense.

Complexity: that of `solve_curves()` with three equations in four unknowns, and of two in three for each edge; of a
sphere, of one in two. Source: \cgalCite{ek-gcs-01}, section 3.5.
*/
template <internal::Surface_curves::Surface_operand Surface, internal::Surface_curves::Surface_operand Check>
Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>
accessibility_boundaries(const Surface& surface, const Check& check,
                         const Tool_axis<internal::Surface_curves::Operand_kernel<Surface>>& axis = {},
                         const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal::Surface_curves;
  return Surface_curves_3<Operand_kernel<Surface>>(
      access_boundaries_of(internal::Common::Intersection_operand<Surface>::map(surface),
                           internal::Common::Intersection_operand<Check>::map(check), exact_tool_axis(axis), options));
}

//! \ingroup PkgSplineConstraintsDSurfaceCurves
//! the same with a sphere that is in the way. \throws Invalid_input as the function above.
template <internal::Surface_curves::Surface_operand Surface>
Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>
accessibility_boundaries(const Surface& surface,
                         const CGAL::Sphere_3<internal::Surface_curves::Operand_kernel<Surface>>& check,
                         const Tool_axis<internal::Surface_curves::Operand_kernel<Surface>>& axis = {},
                         const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal::Surface_curves;
  if (!(check.squared_radius() > 0))
    throw Invalid_input("accessibility_boundaries: the sphere is degenerate");
  return Surface_curves_3<Operand_kernel<Surface>>(access_boundaries_of(
      internal::Common::Intersection_operand<Surface>::map(surface), exact_triple(check.center()),
      internal::converted_number<Exact_rational>(check.squared_radius()), exact_tool_axis(axis), options));
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_ACCESSIBILITY_H
