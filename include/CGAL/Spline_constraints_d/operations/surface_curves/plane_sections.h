// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_PLANE_SECTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_PLANE_SECTIONS_H

#include <CGAL/Spline_constraints_d/operations/surface_curves/internal/Surface_zeros.h>

#include <array>
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
\param levels the values, in any order.
\param options those of `solve_curves()`; limits hold for each level and part.
\return the curves for each level, in their order.
\throws Invalid_input when the direction is zero, a number is not finite, a weight is not proved to have one sign, or an
option makes no sense.

Complexity: that of `solve_curves()` with one equation of the degrees of the surface in two unknowns, for each level.
*/
template <internal::Surface_curves::Surface_operand Surface>
std::vector<Surface_curves_3<internal::Surface_curves::Operand_kernel<Surface>>>
plane_sections(const Surface& surface,
               const CGAL::Vector_3<internal::Surface_curves::Operand_kernel<Surface>>& direction,
               const std::vector<typename internal::Surface_curves::Operand_kernel<Surface>::FT>& levels,
               const Solver_options& options = {.tolerance = 1e-8})
{
  using namespace internal;
  using namespace internal::Surface_curves;
  const auto v = exact_object(direction);
  if (v == CGAL::NULL_VECTOR)
    throw Invalid_input("plane_sections: the direction is zero");
  const Spline_patch<3> patch = Intersection_operand<Surface>::patch(surface);
  const Cell_functions<4> coordinates(patch, [](const Spline_patch<3>& cell) {
    const auto& [x, y, z] = cell.numerators();
    return std::array<Exact_function, 4>{x, y, z, cell.weight()};
  });
  std::vector<Surface_curves_3<Operand_kernel<Surface>>> result;
  for (const auto& level : levels) {
    Surface_zeros<Operand_kernel<Surface>> zeros(patch, options);
    zeros.add(combined<4>(coordinates, {v.x(), v.y(), v.z(), Exact_rational(-converted_number<Exact_rational>(level))}),
              false);
    result.push_back(zeros.curves());
  }
  return result;
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_SURFACE_CURVES_PLANE_SECTIONS_H
