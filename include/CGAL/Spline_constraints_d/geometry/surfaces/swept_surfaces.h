// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SWEPT_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SWEPT_SURFACES_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Exact_surface = Bspline_surface_3<Exact_kernel>;

// A curve as a part of a formula: its numerators and weight, as functions of the parameters of a surface.
template <int d>
struct Curve_on_axis
{
  Vector_function<d> numerators;
  Scalar_function weight;

  template <class Curve>
  Curve_on_axis(const Curve& curve, const Exact_box& domain, int axis)
    : numerators(Vector_function<d>(curve.homogeneous_coordinates()).on_axis(domain, axis)),
      weight(Scalar_function(curve.weight()).on_axis(domain, axis))
  {}
};

inline Exact_surface quotient_surface(const Vector_function<3>& numerators, const Scalar_function& weight)
{
  return Exact_surface::from_homogeneous_coordinates(numerators.functions(), weight.function());
}

template <class Curve_u, class Curve_v>
Exact_box product_domain(const Curve_u& a, const Curve_v& b)
{
  return {a.weight().domain(0), b.weight().domain(0)};
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

//! the surface \f$(1-u)(1-v) P_{00} + (1-u) v P_{01} + u (1-v) P_{10} + u v P_{11}\f$ over \f$[0,1]^2\f$. Exact in
//! every kernel.
//! \throws Invalid_input for coordinates that are not finite.
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> bilinear_surface(const CGAL::Point_3<Kernel>& p00, const CGAL::Point_3<Kernel>& p01,
                                           const CGAL::Point_3<Kernel>& p10, const CGAL::Point_3<Kernel>& p11)
{
  return Bspline_surface_3<Kernel>({1, 1}, {0, 0, 1, 1}, {0, 0, 1, 1}, {p00, p01, p10, p11});
}

//! the parallelogram \f$p + u a + v b\f$ over \f$[0,1]^2\f$. Exact where the kernel is.
//! \throws Invalid_input for coordinates that are not finite.
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> plane_patch(const CGAL::Point_3<Kernel>& p, const CGAL::Vector_3<Kernel>& a,
                                      const CGAL::Vector_3<Kernel>& b)
{
  return bilinear_surface<Kernel>(p, p + b, p + a, p + a + b);
}

/*!
the surface of the segments between points of two curves at the same parameter: it runs through the first at \f$v = 0\f$
and through the second at \f$v = 1\f$. Homogeneous coordinates are interpolated linearly, as control points are: where
the weights differ, \f$v\f$ does not measure the segments evenly. Exact where the kernel is.
\throws Invalid_input when the curves have different domains.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> ruled_surface(const Bspline_curve_3<Kernel>& first, const Bspline_curve_3<Kernel>& second)
{
  if (first.domain() != second.domain())
    throw Invalid_input("ruled_surface: the curves have different domains");
  const internal::Exact_function rising({1}, {{0, 0, 1, 1}}, {0, 1});
  const internal::Exact_box domain{first.weight().domain(0), rising.domain(0)};
  const internal::Curve_on_axis<3> a(first, domain, 0), b(second, domain, 0);
  const internal::Scalar_function v = internal::Scalar_function(rising).on_axis(domain, 1),
                                  rest = internal::Scalar_function(domain, 1) - v;
  return Bspline_surface_3<Kernel>(
      internal::quotient_surface(a.numerators * rest + b.numerators * v, a.weight * rest + b.weight * v));
}

/*!
the surface \f$C(u) + D(v) - \mathit{origin}\f$: the profile \f$C\f$ moved without turning, by the vectors from the
origin to the points of the path \f$D\f$. Exact where the kernel is.
\throws Invalid_input when the origin is not finite.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel>
translational_surface(const Bspline_curve_3<Kernel>& profile, const Bspline_curve_3<Kernel>& path,
                      const CGAL::Point_3<Kernel>& origin = CGAL::Point_3<Kernel>(CGAL::ORIGIN))
{
  const internal::Exact_box domain = internal::product_domain(profile, path);
  const internal::Curve_on_axis<3> c(profile, domain, 0), d(path, domain, 1);
  const internal::Scalar_function weight = c.weight * d.weight;
  const internal::Vector_function<3> shift(domain, CGAL::ORIGIN - internal::exact_object(origin));
  return Bspline_surface_3<Kernel>(
      internal::quotient_surface(c.numerators * d.weight + d.numerators * c.weight + shift * weight, weight));
}

//! the surface \f$C(u) + v\,d\f$, \f$v \in [0,1]\f$: a general cylinder. Exact where the kernel is.
//! \throws Invalid_input when the direction is zero or not finite.
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> extruded_surface(const Bspline_curve_3<Kernel>& profile,
                                           const CGAL::Vector_3<Kernel>& direction)
{
  if (direction == CGAL::NULL_VECTOR)
    throw Invalid_input("extruded_surface: the direction is zero");
  const typename Kernel::FT zero(0), one(1);
  const CGAL::Point_3<Kernel> origin(CGAL::ORIGIN);
  return translational_surface(profile,
                               Bspline_curve_3<Kernel>(1, {zero, zero, one, one}, {origin, origin + direction}));
}

/*!
the surface \f$S(u,v) = O(v) + x(u)\,a(v) + y(u)\,b(v)\f$: the planar profile \f$(x,y)\f$ moved with a frame that has
its origin on the spine \f$O\f$. The frame vectors are given as curves, points standing for the vectors from the origin
to them. A moving frame of unit vectors at right angles is rational along special spines only (Pythagorean-hodograph
curves); any rational frame, also one that shears or scales, is swept exactly where the kernel is.
\throws Invalid_input when spine and frame have different domains.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> swept_surface(const Bspline_curve_2<Kernel>& profile, const Bspline_curve_3<Kernel>& spine,
                                        const Bspline_curve_3<Kernel>& first_axis,
                                        const Bspline_curve_3<Kernel>& second_axis)
{
  if (spine.domain() != first_axis.domain() || spine.domain() != second_axis.domain())
    throw Invalid_input("swept_surface: the spine and the frame have different domains");
  const internal::Exact_box domain = internal::product_domain(profile, spine);
  const internal::Curve_on_axis<2> p(profile, domain, 0);
  internal::Curve_on_axis<3> o(spine, domain, 1), a(first_axis, domain, 1), b(second_axis, domain, 1);
  internal::Scalar_function weight = o.weight;
  // Frames are often made of quotients by one weight.
  if (!(a.weight == o.weight && b.weight == o.weight)) {
    weight = o.weight * a.weight * b.weight;
    o.numerators = o.numerators * (a.weight * b.weight);
    a.numerators = a.numerators * (o.weight * b.weight);
    b.numerators = b.numerators * (o.weight * a.weight);
  }
  const internal::Vector_function<3> numerators =
      o.numerators * p.weight + a.numerators * p.numerators.x[0] + b.numerators * p.numerators.x[1];
  return Bspline_surface_3<Kernel>(internal::quotient_surface(numerators, weight * p.weight));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SWEPT_SURFACES_H
