// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors
#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_RATIONAL_BISECTORS_3_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_RATIONAL_BISECTORS_3_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Exact_map.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/Rational_bisector_3.h>
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisectors_of_maps.h>
#include <CGAL/Spline_constraints_d/solver/Solver_options.h>
#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
#include <CGAL/Spline_constraints_d/operations/rational_bisectors/internal/rational_bisector_pieces.h>
#endif

#include <array>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Rational_bisectors {

template <class Kernel>
Exact_map<3> exact_map_of_point(const CGAL::Point_3<Kernel>& point)
{
  const Exact_kernel::Point_3 q = exact_object(point);
  return Common::exact_map<3>(std::array<Exact_rational, 3>{q.x(), q.y(), q.z()});
}

} // namespace Rational_bisectors
} // namespace internal

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

the bisector of a point \f$Q\f$ and a surface, untrimmed: the centers of all spheres through the point that touch the
surface. It is a rational surface with the parameters of the given one, \f$S\f$, whose normal is \f$N\f$:
\f[ P = S - \frac{|S-Q|^2}{2\,\langle S-Q, N\rangle}\, N. \f]
Its coefficients are exact. Factors that all homogeneous coordinates, or all coordinates of the normal, have in common
are divided out, as far as `common_factor()` finds them; so poles of spheres and tips of cones are no exception. The
degree is (2,2) for planes, and for spheres, cylinders, cones, tori and Dupin cyclides as this package makes them. It is
at most \f$4p-1\f$ in each parameter for a polynomial surface of degree \f$p\f$, and as a rule so, as (11,11) for a
bicubic one; and \f$5p-2\f$ for a rational one.

Poles are where the tangent plane passes through the point: the silhouettes of the surface from there. Points of the
surface that are the point itself are treated as poles. The feet are the point, operand 0, and the surface, operand 1.

\tparam S a model of `ParametricSurface_3`.
\param point the point.
\param surface the surface.
\param options the limits and the visitor count, which are asked before each polynomial piece.
\throws Invalid_input when all tangent planes of a polynomial piece pass through the point, as those of a plane or cone
through it do; when a piece is a curve or a point; when a coordinate is not finite; and when
an option makes no sense.

Complexity: products and greatest common divisors of polynomials of about five times the degrees, for each polynomial
piece. Source: \cgalCite{ek-crb-99}, eq. 6-9.
*/
template <ParametricSurface_3 S>
Rational_bisector_3 point_surface_bisector(const typename S::Kernel::Point_3& point, const S& surface,
                                           const Solver_options& options = {})
{
  return internal::Rational_bisectors::point_surface_bisector(internal::Rational_bisectors::exact_map_of_point(point),
                                                              internal::Common::exact_map<3>(surface), options);
}

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

a sheet of the bisector of a sphere and a surface that has a rational unit normal, untrimmed. With the center \f$Q\f$,
the radius \f$r\f$, the surface \f$S\f$ and its unit normal \f$n\f$ it is \f$P = S + x\,n\f$ where
\f$|P-Q| = |x+r|\f$: the bisector of the center and the offset of the surface at the distance \f$-r\f$,
\f[ x + r = -\frac{|E|^2}{2\,\langle E, n\rangle}, \quad E = S - r\,n - Q. \f]
Where \f$x \ge 0\f$ it has the same distance from the surface, on the side of its normal, and from the sphere, which it
is outside of. For \f$-r \le x \le 0\f$ it has so inside of the sphere, on the other side of the surface. For
\f$x < -r\f$ its distance from the surface is that from the farthest point of the sphere. The other sheet belongs to
the radius \f$-r\f$: there are the points outside of the sphere on the other side of the surface, and those inside on
the side of the normal. All radii around one center are a family of surfaces with the same parameters; that of radius 0
is `point_surface_bisector()`.

The degree is (2,2) for planes, and for spheres, cylinders, cones, tori and Dupin cyclides as this package makes them.
The feet are on the sphere, operand 0, in the direction from its center to the point (from the point to its center,
where \f$x < -r\f$), and on the surface, operand 1. Poles and coefficients are those of `point_surface_bisector()`.

\tparam S a model of `ParametricSurface_3`.
\param center the center of the sphere.
\param radius the radius, with its sign.
\param surface the surface.
\param options as for `point_surface_bisector()`.
\throws Invalid_input when a piece has no rational unit normal, see `rational_unit_normal()` (the message names it);
when the offset of a piece has tangent planes through the center only, as for a sphere that touches a cylinder from
inside all along a circle around its center; when a number is not finite; and when an option makes no sense.

Complexity: that of `point_surface_bisector()` for the offset. Source: \cgalCite{ek-crb-99}, section "Bisector of a
sphere and a surface with rational offsets".
*/
template <ParametricSurface_3 S>
Rational_bisector_3 sphere_surface_bisector(const typename S::Kernel::Point_3& center,
                                            const typename S::Kernel::FT& radius, const S& surface,
                                            const Solver_options& options = {})
{
  return internal::Rational_bisectors::sphere_surface_bisector(internal::Rational_bisectors::exact_map_of_point(center),
                                                               internal::converted_number<Exact_rational>(radius),
                                                               internal::Common::exact_map<3>(surface), options);
}

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

the bisector of a point \f$Q\f$ and a curve in space, untrimmed: the centers of all spheres through the point that touch
the curve. It is a ruled surface: for each parameter \f$t\f$ of the curve \f$C = X/w\f$, the line in which its normal
plane meets the plane in the middle of \f$Q\f$ and \f$C(t)\f$. With \f$E = C - Q\f$ and \f$D = C' \times E\f$,
\f[ P(t,\lambda) = Q + \frac{\langle E,C'\rangle\, |E|^2\, C' + (|C'|^2 |E|^2 - 2 \langle E,C'\rangle^2)\, E}{2\, |D|^2}
    + \lambda\, w^3 D. \f]
Its coefficients are exact; common factors are divided out as by `point_surface_bisector()`. For a polynomial curve of
degree \f$p \ge 1\f$ the degree is at most \f$(\max(5p-3,\, 6p-6),\, 1)\f$: (2,1) for a line, (7,1) for a parabola,
(12,1) for a cubic. Its poles are where the tangent of the curve passes through the point. The feet are the point,
operand 0, and the curve, operand 1.

\tparam C a model of `ParametricCurve_3`.
\param point the point.
\param curve the curve.
\param range the range of \f$\lambda\f$.
\param options as for `point_surface_bisector()`.
\throws Invalid_input when the range is empty, a polynomial piece of the curve is on a line through the point, or a
number is not finite, or an option makes no sense.

Complexity: products and greatest common divisors of polynomials, for each polynomial piece. Source:
\cgalCite{ek-crb-99}.
*/
template <ParametricCurve_3 C>
Rational_bisector_3 point_curve_bisector_surface(const typename C::Kernel::Point_3& point, const C& curve,
                                                 const std::pair<typename C::Kernel::FT, typename C::Kernel::FT>& range,
                                                 const Solver_options& options = {})
{
  const Rational_bisector_3::Range lambda{internal::converted_number<Exact_rational>(range.first),
                                          internal::converted_number<Exact_rational>(range.second)};
  if (!(lambda.first < lambda.second))
    throw Invalid_input("point_curve_bisector_surface: the range of lambda is empty");
  return internal::Rational_bisectors::point_curve_bisector(internal::Rational_bisectors::exact_map_of_point(point),
                                                            internal::Common::exact_map<3>(curve), lambda, options);
}

/*!
\ingroup PkgSplineConstraintsDRationalBisectors

the bisector of two curves in space, untrimmed: the centers of all spheres that touch both. It is a rational surface
whose parameters are those of the curves: the point in which both normal planes meet the plane in the middle of
\f$C_1(u)\f$ and \f$C_2(v)\f$. With \f$a_1 = C_1'\f$, \f$a_2 = C_2'\f$, \f$a_3 = C_1-C_2\f$,
\f$b_1 = \langle C_1,a_1\rangle\f$, \f$b_2 = \langle C_2,a_2\rangle\f$ and \f$b_3 = (|C_1|^2-|C_2|^2)/2\f$,
\f[ P = \frac{b_1\, a_2 \times a_3 + b_2\, a_3 \times a_1 + b_3\, a_1 \times a_2}{\det(a_1,a_2,a_3)}. \f]
Its coefficients are exact; common factors are divided out as by `point_surface_bisector()`. For polynomial curves of
degrees \f$p\f$ and \f$q\f$ the degree is at most \f$(3p-1,\,3q-1)\f$: (2,2) for two lines, whose bisector is a
hyperbolic paraboloid, (5,5) for two parabolas. Poles are where the tangents are in one plane. The feet are on the first
curve, operand 0, and on the second, operand 1.

\tparam C1 a model of `ParametricCurve_3`.
\tparam C2 a model of `ParametricCurve_3`.
\param first the first curve.
\param second the second curve.
\param options as for `point_surface_bisector()`.
\throws Invalid_input when a polynomial piece of one curve and one of the other are in one plane, where the bisector is
a curve, or rather its cylinder: see `bisector_curves()`; and when an option makes no sense.

Complexity: products and greatest common divisors of polynomials of about three times the degrees, five times for
rational curves, for each pair of polynomial pieces. Source: \cgalCite{ek-crb-99}.
*/
template <ParametricCurve_3 C1, ParametricCurve_3 C2>
Rational_bisector_3 curve_bisector_surface(const C1& first, const C2& second, const Solver_options& options = {})
{
  return internal::Rational_bisectors::curve_bisector(internal::Common::exact_map<3>(first),
                                                      internal::Common::exact_map<3>(second), options);
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_RATIONAL_BISECTORS_RATIONAL_BISECTORS_3_H
