// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_PARABOLIC_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_PARABOLIC_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/surfaces/Simplex_function_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/implicit_patches/patch_convexity.h>
#include <CGAL/Spline_constraints_d/solver/Constraint_system_d.h>
#include <CGAL/Spline_constraints_d/solver/Curve_solver_d.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDImplicitPatches

the curves of an implicit patch where its Gaussian curvature is zero, with their topology by proof: between its convex
or concave parts and its saddles, as a rule. The unknowns are the coordinates, and the domain the bounding box of the
tetrahedron, with an inequality for each of its faces.
\param function the polynomial on the tetrahedron.
\param options as for `solve_curves()`. Where the Gaussian curvature is zero on all of a sheet, as on a cylinder, the
answer stays undecided.
\throws Invalid_input when the function is constant, or an option makes no sense.
*/
inline Curve_solution_set_d parabolic_curves(const Simplex_function_3& function,
                                             const Solver_options& options = {.tolerance = 1e-8})
{
  const Power_polynomial f = function.polynomial();
  if (f.is_constant())
    throw Invalid_input("parabolic_curves: the function is constant");
  std::vector<Constraint_system_d::Domain> domain;
  for (int axis = 0; axis < 3; ++axis) {
    Constraint_system_d::Domain range(function.vertices()[0][axis], function.vertices()[0][axis]);
    for (const auto& vertex : function.vertices())
      range = {(std::min)(range.first, vertex[axis]), (std::max)(range.second, vertex[axis])};
    domain.push_back(range);
  }
  Constraint_system_d system(domain);
  system.add(f, Relation::EQUAL);
  system.add(curvature_polynomials(f).gaussian, Relation::EQUAL);
  for (int i = 0; i < 4; ++i) {
    std::array<Exact_rational, 4> height{};
    height[i] = Exact_rational(1);
    system.add(Simplex_function_3(function.vertices(), Simplex_function_3::Form::affine(height)).polynomial(),
               Relation::GREATER_EQUAL);
  }
  return solve_curves(system, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_IMPLICIT_PATCHES_PARABOLIC_CURVES_H
