// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_BISECTOR_PARTS_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_BISECTOR_PARTS_3_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Bisector_mesh_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Bisector_part_label.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/operations/surface_regions/Trimmed_surface_3.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/parts_of_bisector.h>
#endif

#include <CGAL/Sphere_3.h>

#include <optional>
#include <vector>

namespace CGAL {
namespace Spline_constraints {

namespace internal {
namespace Rational_bisectors {

template <SplineKernel Kernel>
Reach exact_reach(const CGAL::Sphere_3<Kernel>& sphere)
{
  Reach result{exact_object(sphere.center()), converted_number<Exact_rational>(sphere.squared_radius())};
  if (!(result.squared_radius > 0))
    throw Invalid_input("bisector_parts: the sphere is degenerate");
  return result;
}

} // namespace Rational_bisectors
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

the parts that the poles of a rational bisector cut it into. Where its weight is zero it goes to infinity, and comes
back from the other side; the domain is cut there, along the silhouettes of the surface from the point, or where the
tangents of two curves are in one plane. The regions of the result have the labels `WITH_POSITIVE_WEIGHT` and
`WITH_NEGATIVE_WEIGHT`, so that two parts which meet in poles alone have different ones.

\param bisector the bisector, untrimmed.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\return the parts for each part of the bisector that is continuous: one surface, unless the operands have creases or
corners. Seams where the weight changes its sign cut, too.
\throws Invalid_input when the bisector is not complete, or an option makes no sense.

Complexity: that of `solve_curves()` with one equation of the degrees of the bisector in two unknowns, for each piece.
*/
inline std::vector<Trimmed_surface_3> bisector_parts(const Rational_bisector_3& bisector,
                                                     const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Rational_bisectors::parts_of_bisector(bisector, std::nullopt, options);
}

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

the parts of a rational bisector within a sphere, with labels as above. What is outside, poles with it, is
`OUT_OF_REACH`.

\param bisector the bisector, untrimmed.
\param reach the sphere.
\param options those of `solve_curves()`; limits hold for the operation as a whole.
\return as above.
\throws Invalid_input as above, and when the sphere is degenerate or a number of it is not finite.

Complexity: that of `solve_curves()` with one equation of twice the degrees of the bisector in two unknowns, for each
piece.
*/
template <SplineKernel Kernel>
std::vector<Trimmed_surface_3> bisector_parts(const Rational_bisector_3& bisector, const CGAL::Sphere_3<Kernel>& reach,
                                              const Solver_options& options = {.tolerance = 1e-8})
{
  return internal::Rational_bisectors::parts_of_bisector(bisector, internal::Rational_bisectors::exact_reach(reach),
                                                         options);
}

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

the regions of a bisector that have a label as triangles, which are near to it by proof; see `to_surface_mesh()` of
trimmed surfaces.

\param bisector the bisector.
\param part a surface that `bisector_parts()` has made of it.
\param label the label of the regions; within a sphere, `WITH_POSITIVE_WEIGHT` and `WITH_NEGATIVE_WEIGHT` have no poles.
\param error the greatest distance between a point of a triangle and that of the bisector with the same parameters.
\param options limits of time and nodes, a visitor; the rest of the options has no effect.
\throws Invalid_input when the error is not positive, a vertex has no foot on a sphere, as its center has none, or an
option makes no sense.

Complexity: that of `to_surface_mesh()`, and one evaluation for each vertex.
*/
inline Bisector_mesh_3 to_surface_mesh(const Rational_bisector_3& bisector, const Trimmed_surface_3& part, int label,
                                       double error, const Solver_options& options = {})
{
  return internal::Rational_bisectors::mesh_of_bisector(bisector, part, label, error, options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_BISECTOR_PARTS_3_H
