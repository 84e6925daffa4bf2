// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_CURVES_ON_BISECTORS_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_CURVES_ON_BISECTORS_3_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/functions_on_bisector.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/operations/surface_curves/Surface_curves_3.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/zeros_on_bisector.h>
#endif

#include <CGAL/Sphere_3.h>

#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

std::vector<Surface_curves_3<Rational_bisector_3::Kernel>> curves_on_bisector(const Rational_bisector_3& bisector,
                                                                              const Function_of_piece& function,
                                                                              const Solver_options& options);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Surface_curves_3<Rational_bisector_3::Kernel>>
curves_on_bisector(const Rational_bisector_3& bisector, const Function_of_piece& function,
                   const Solver_options& options)
{
  if (!bisector.is_complete())
    throw Invalid_input("curves on bisectors: pieces of the bisector were not computed");
  std::vector<Surface_curves_3<Rational_bisector_3::Kernel>> result;
  for (Found_surface_curves& found : zeros_on_bisector(bisector, function, options))
    result.emplace_back(std::move(found));
  return result;
}
#endif

} // namespace Rational_bisectors
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

the level curves of the distance on a bisector: where both feet are at a given distance. On the bisector of a sphere it
is that from the sphere.

With a point and a foot in homogeneous coordinates, \f$P = X/w\f$ and \f$F = Y/v\f$, the equation is
\f$|v X - w Y|^2 = r^2 w^2 v^2\f$, so that poles are no solutions. The topology of the curves is proved.

\param bisector the bisector, untrimmed.
\param distance the distance; positive.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\return the curves for each part of the bisector that is continuous: one, unless the operands have creases or corners.
Their unknowns are the parameters of the bisector. Boxes in space of what is undecided are unbounded.
\throws Invalid_input when the distance is not positive, the bisector is not complete, or an option makes no sense.

Complexity: that of `solve_curves()` with one equation of twice the degrees of the bisector and of a foot in two
unknowns.
*/
std::vector<Surface_curves_3<Rational_bisector_3::Kernel>>
distance_curves(const Rational_bisector_3& bisector, const Exact_rational& distance,
                const Solver_options& options = {.tolerance = 1e-8});

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

where a bisector meets a sphere. If a moving point is to keep as far as it can from two objects, it stays on their
bisector; on a sphere around one of the centers, these are its paths: of an airplane between two radars, say, which has
to stay within reach of a third station.

\param bisector the bisector, untrimmed.
\param sphere the sphere.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\return as for `distance_curves()`.
\throws Invalid_input when the sphere is degenerate, a number is not finite, the bisector is not complete, or an option
makes no sense.

Complexity: that of `solve_curves()` with one equation of twice the degrees of the bisector in two unknowns. Source: the
path of an airplane is a problem of \cgalCite{ek-crb-99}.
*/
template <SplineKernel Kernel>
std::vector<Surface_curves_3<Rational_bisector_3::Kernel>>
sphere_sections(const Rational_bisector_3& bisector, const CGAL::Sphere_3<Kernel>& sphere,
                const Solver_options& options = {.tolerance = 1e-8})
{
  const auto squared_radius = internal::converted_number<Exact_rational>(sphere.squared_radius());
  if (!(squared_radius > 0))
    throw Invalid_input("sphere_sections: the sphere is degenerate");
  const Rational_bisector_piece_3::Coordinates point =
      internal::Rational_bisectors::constant_coordinates(internal::exact_object(sphere.center()));
  const auto function = [&](const Rational_bisector_piece_3& piece) {
    return internal::Rational_bisectors::power_of_distance(piece.coordinates(), point, squared_radius);
  };
  return internal::Rational_bisectors::curves_on_bisector(bisector, function, options);
}

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Surface_curves_3<Rational_bisector_3::Kernel>>
distance_curves(const Rational_bisector_3& bisector, const Exact_rational& distance, const Solver_options& options)
{
  if (!(distance > 0))
    throw Invalid_input("distance_curves: the distance is not positive");
  const auto function = [&](const Rational_bisector_piece_3& piece) {
    // both feet are as far away
    const auto degrees = [&](int operand) {
      const auto& weight = piece.foot_coordinates(operand)[3];
      return weight.degree(0) + weight.degree(1);
    };
    return internal::Rational_bisectors::power_of_distance(piece.coordinates(),
                                                           piece.foot_coordinates(degrees(0) <= degrees(1) ? 0 : 1),
                                                           Exact_rational(distance * distance));
  };
  return internal::Rational_bisectors::curves_on_bisector(bisector, function, options);
}
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_CURVES_ON_BISECTORS_3_H
