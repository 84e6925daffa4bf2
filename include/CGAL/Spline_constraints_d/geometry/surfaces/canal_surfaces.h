// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_CANAL_SURFACES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_CANAL_SURFACES_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/geometry/internal/spline_axes.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/surfaces_of_revolution.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A multiple of the first derivative of a curve that is a piecewise polynomial: the derivative itself, of rational
// curves times the square of the weight.
Vector_function<3> direction_function(const Exact_space_curve& curve, const std::string& who);

// The arm, a vector from the spine to the surface, turned once around the tangent of the spine.
Exact_surface canal(const Exact_space_curve& spine, const Exact_space_curve& arm, const std::string& who);

Exact_surface pipe(const Exact_space_curve& spine, const Exact_space_curve& normal);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Vector_function<3> direction_function(const Exact_space_curve& curve,
                                                                     const std::string& who)
{
  const auto coordinates = curve.homogeneous_coordinates();
  const std::vector<Exact_rational> breaks = curve.breaks();
  const auto weights = curve.weight().bezier_pieces();
  return Vector_function<3>::by_coordinate([&](int i) {
    auto pieces = coordinates[i].bezier_pieces();
    for (std::size_t c = 0; c < pieces.size(); ++c) {
      const Exact_rational width = breaks[c + 1] - breaks[c];
      const auto derivative = pieces[c].derivative(0) * Exact_rational(1 / width);
      pieces[c] = curve.is_rational()
          ? derivative * weights[c] - pieces[c] * (weights[c].derivative(0) * Exact_rational(1 / width))
          : derivative;
    }
    return joined(pieces, breaks, who + " is not continuously differentiable");
  });
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_surface canal(const Exact_space_curve& spine, const Exact_space_curve& arm,
                                                   const std::string& who)
{
  if (spine.domain() != arm.domain())
    throw Invalid_input(who + ": the spine and the arm have different domains");
  const Vector_function<3> along_spine = direction_function(spine, who + ": the spine"),
                           m(arm.homogeneous_coordinates());
  const Scalar_function spine_weight(spine.weight()), arm_weight(arm.weight());
  const Vector_function<3> contact =
      Vector_function<3>(spine.homogeneous_coordinates()) * arm_weight + m * spine_weight;
  const auto contact_curve =
      Exact_space_curve::from_homogeneous_coordinates(contact.functions(), (spine_weight * arm_weight).function());
  const Scalar_function cosine = dot(m, direction_function(contact_curve, who + ": the curve that the arm leads to"));
  if (cosine.function().bounds() != std::pair(Exact_rational(0), Exact_rational(0)))
    throw Invalid_input(who + ": the arm is not at a right angle to the curve it leads to");

  const std::vector<Exact_rational> middle(1, Exact_rational((spine.domain().first + spine.domain().second) / 2));
  const Exact_rational squared_speed = dot(along_spine, along_spine).function()(middle);
  const Direction_path turn =
      Direction_path::half_round(squared_speed == 0 ? Exact_rational(1) : near_inverse_root(squared_speed));
  const Exact_box domain{turn.domain()[0], spine.weight().domain(0)};
  const Direction_path path = turn.on_axis(domain, 0);
  const Curve_on_axis<3> center(spine, domain, 1), source(arm, domain, 1);
  const Vector_function<3> axis = along_spine.on_axis(domain, 1);
  const Scalar_function weight = rotation_weight(axis, path) * source.weight;
  return quotient_surface(center.numerators * weight + rotated(source.numerators, axis, path) * center.weight,
                          center.weight * weight);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_surface pipe(const Exact_space_curve& spine, const Exact_space_curve& normal)
{
  const Vector_function<3> m(normal.homogeneous_coordinates());
  const Scalar_function weight(normal.weight());
  const Exact_rational squared_radius = (normal.source() - CGAL::ORIGIN).squared_length();
  if (squared_radius == 0 || !(dot(m, m) == weight * weight * squared_radius))
    throw Invalid_input("pipe_surface: the normal is zero or its length is not constant");
  return canal(spine, normal, "pipe_surface");
}
#endif

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the canal surface around a spine: the envelope of spheres whose centers run along the spine and whose radius may vary
with them. It is swept by turning a rational arm once around the tangent of the spine. Points of the curve `arm` stand
for the vectors from the origin to them: from a center to a point where its sphere touches the envelope. So the length
of the arm is the radius, and the arm is at a right angle to the curve that it leads to, the spine plus the arm. Axis 0
is the turn, over
\f$[0,4]\f$; axis 1 is that of the spine.

All canal surfaces of rational spines and radii are rational \cgalCite{pp-crpcs-97}, but over the rational numbers only
where such an arm can be given. It is all that is needed, since the turn is rational in the derivative of the spine,
whatever its length. Exact where the kernel is. The surface may meet itself.
\throws Invalid_input when the domains differ, the spine or its sum with the arm is not continuously differentiable, the
derivative of the spine vanishes, or the arm is not at a right angle to the curve it leads to (decided exactly).
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> canal_surface(const Bspline_curve_3<Kernel>& spine, const Bspline_curve_3<Kernel>& arm)
{
  return Bspline_surface_3<Kernel>(
      internal::canal(internal::Exact_space_curve(spine), internal::Exact_space_curve(arm), "canal_surface"));
}

/*!
the pipe around a spine: the canal surface of a constant radius. The arm is a normal of the spine, of one length, the
radius.
\throws Invalid_input as `canal_surface()`, and when the length of the normal is zero or not constant.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> pipe_surface(const Bspline_curve_3<Kernel>& spine, const Bspline_curve_3<Kernel>& normal)
{
  return Bspline_surface_3<Kernel>(
      internal::pipe(internal::Exact_space_curve(spine), internal::Exact_space_curve(normal)));
}

//! the pipe around a spine in a plane; the radius is the length of the given vector, which is at a right angle to the
//! plane. \throws Invalid_input as above.
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> pipe_surface(const Bspline_curve_3<Kernel>& spine, const CGAL::Vector_3<Kernel>& normal)
{
  const auto arm = CGAL::ORIGIN + internal::exact_object(normal);
  const internal::Exact_space_curve curve(spine);
  const auto [begin, end] = curve.domain();
  return Bspline_surface_3<Kernel>(
      internal::pipe(curve, internal::Exact_space_curve(1, {begin, begin, end, end}, {arm, arm})));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_CANAL_SURFACES_H
