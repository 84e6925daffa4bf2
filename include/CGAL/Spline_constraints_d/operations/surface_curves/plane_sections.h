// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_PLANE_SECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_PLANE_SECTIONS_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Surface_curves_3.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/surface_curve_finders.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/zeros_on_surface.h>
#endif

#include <concepts>
#include <ranges>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDSurfaceCurves

the sections of a surface with parallel planes, or its contour lines: where \f$\langle S, v\rangle\f$ has given values,
with a proof of the number of curves and of how they are connected, for each value.

The equation is \f$\langle X, v\rangle - c\,w = 0\f$ with \f$S = X/w\f$. Curves may run along an edge, a break or a seam
(`Surface_curve::line`), and through a pole. A pole where a plane touches is a singular point, or a single one on an
edge. Where a part of the surface lies in one of the planes, and at singular points of higher order with irrational
parameters, the answer is undecided.

\param surface a model of `ParametricSurface_3`, or an object of CGAL that is converted to one.
\param direction that of the normals of the planes, of any length.
\param levels the values, a range of numbers of the kernel, in any order.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\return the curves for each level, in their order.
\throws Invalid_input when the direction is zero, a number is not finite, a weight is not proved to have one sign, or an
option makes no sense.

Complexity: that of `solve_curves()` with one equation of the degrees of the surface in two unknowns, for each level.
*/
template <internal::Surface_curves::Surface_operand Surface, std::ranges::input_range Levels>
std::vector<Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>>
plane_sections(const Surface& surface,
               const CGAL::Vector_3<internal::Surface_curves::Operand_kernel<Surface>>& direction, Levels&& levels,
               const Solver_options& options = {.tolerance = 1e-8})
{
  using Kernel = internal::Surface_curves::Operand_kernel<Surface>;
  const internal::Surface_curves::Exact_triple v = internal::Surface_curves::exact_triple(direction);
  if (v[0] == 0 && v[1] == 0 && v[2] == 0)
    throw Invalid_input("plane_sections: the direction is zero");
  std::vector<Exact_rational> exact_levels;
  for (const typename Kernel::FT& level : levels)
    exact_levels.push_back(internal::converted_number<Exact_rational>(level));
  std::vector<Surface_curves_3<Kernel>> result;
  for (auto& found : internal::Surface_curves::plane_sections_of(
           internal::Common::Intersection_operand<Surface>::map(surface), v, exact_levels, options))
    result.emplace_back(std::move(found));
  return result;
}

//! \ingroup PkgSplineConstraintsDSurfaceCurves
//! the same, with the levels in a list. \throws Invalid_input as the function above.
template <internal::Surface_curves::Surface_operand Surface>
std::vector<Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>>
plane_sections(const Surface& surface,
               const CGAL::Vector_3<internal::Surface_curves::Operand_kernel<Surface>>& direction,
               const std::vector<typename internal::Surface_curves::Operand_kernel<Surface>::FT>& levels,
               const Solver_options& options = {.tolerance = 1e-8})
{
  return plane_sections<Surface, decltype(levels)>(surface, direction, levels, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_PLANE_SECTIONS_H
