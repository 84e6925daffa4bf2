// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SURFACES_OF_REVOLUTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SURFACES_OF_REVOLUTION_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <string>
#include <type_traits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Exact_space_curve = Bspline_curve_3<Exact_kernel>;

// The whole turn of a curve around the line through a point in a direction.
Exact_surface revolved(const Exact_space_curve& profile, const Exact_kernel::Point_3& center,
                       const Exact_kernel::Vector_3& direction, const std::string& who);

// A vector at a right angle to a given one that is not zero: rational, of any length.
inline Exact_kernel::Vector_3 perpendicular(const Exact_kernel::Vector_3& v)
{
  return v.x() == 0 && v.y() == 0 ? Exact_kernel::Vector_3(v.z(), 0, 0) : Exact_kernel::Vector_3(-v.y(), v.x(), 0);
}

// The sphere around a point through center + pole, to the pole from the opposite one along axis 1.
Exact_surface sphere(const Exact_kernel::Point_3& center, const Exact_kernel::Vector_3& pole);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_surface revolved(const Exact_space_curve& profile,
                                                      const Exact_kernel::Point_3& center,
                                                      const Exact_kernel::Vector_3& direction, const std::string& who)
{
  if (direction == CGAL::NULL_VECTOR)
    throw Invalid_input(who + ": the direction of the axis is zero");
  const Direction_path turn = Direction_path::half_round(near_inverse_root(direction.squared_length()));
  const Exact_box domain{turn.domain()[0], profile.weight().domain(0)};
  const Direction_path path = turn.on_axis(domain, 0);
  const Curve_on_axis<3> curve(profile, domain, 1);
  const Vector_function<3> axis(domain, direction);
  const Vector_function<3> from_center =
      curve.numerators - Vector_function<3>(domain, center - CGAL::ORIGIN) * curve.weight;
  return object_around<Exact_surface>(center, rotated(from_center, axis, path),
                                      rotation_weight(axis, path) * curve.weight);
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_surface sphere(const Exact_kernel::Point_3& center,
                                                    const Exact_kernel::Vector_3& pole)
{
  const Exact_kernel::Vector_3 direction = perpendicular(pole);
  const Direction_path path =
      Direction_path::half_round(near_inverse_root(direction.squared_length())).restricted(0, 2);
  const Vector_function<3> axis(path.domain(), direction), arm(path.domain(), -pole);
  const auto meridian = object_around<Exact_space_curve>(center, rotated(arm, axis, path), rotation_weight(axis, path));
  return revolved(meridian, center, pole, "sphere_surface");
}
#endif

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the surface that a curve sweeps when it is turned once around the line through `center` in a direction, counterclockwise
as seen against the direction. Axis 0 is the turn, rational quadratic over \f$[0,4]\f$ with half of it between
successive even numbers (quarters between all integers where the length of the direction is rational); axis 1 is that of
the curve. Where the curve runs in the direction, normals point away from the line. A part of the turn comes by
`restricted()`. Exact where the kernel is; the length of the direction need not be rational. Where the curve meets the
line the parametrisation is singular.
\throws Invalid_input when the direction is zero, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> surface_of_revolution(const Bspline_curve_3<Kernel>& profile,
                                                const CGAL::Point_3<Kernel>& center,
                                                const CGAL::Vector_3<Kernel>& direction)
{
  return Bspline_surface_3<Kernel>(internal::revolved(internal::Exact_space_curve(profile),
                                                      internal::exact_object(center), internal::exact_object(direction),
                                                      "surface_of_revolution"));
}

/*!
the sphere around a center through a point, its pole, as a surface of revolution of degrees (2,2): axis 0 leads once
around over \f$[0,4]\f$, axis 1 from the opposite pole to the pole over \f$[0,2]\f$. Normals point outwards; at both
poles the parametrisation is singular. The radius need not be rational. Exact where the kernel is.
\throws Invalid_input when the points are the same, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> sphere_surface(const CGAL::Point_3<Kernel>& center, const CGAL::Point_3<Kernel>& pole)
{
  const auto c = internal::exact_object(center);
  const auto radius = internal::exact_object(pole) - c;
  if (radius == CGAL::NULL_VECTOR)
    throw Invalid_input("sphere_surface: the center and the pole are the same point");
  return Bspline_surface_3<Kernel>(internal::sphere(c, radius));
}

//! the sphere of a center and radius, with its poles above and below the center in the direction of \f$z\f$. Exact
//! where the kernel is.
//! \throws Invalid_input when the radius is not positive, or a number is not finite.
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> sphere_surface(const CGAL::Point_3<Kernel>& center, const typename Kernel::FT& radius)
{
  internal::check_positive(radius, "sphere_surface: the radius");
  const internal::Exact_kernel::Vector_3 pole(0, 0, internal::converted_number<Exact_rational>(radius));
  return Bspline_surface_3<Kernel>(internal::sphere(internal::exact_object(center), pole));
}

/*!
the cylinder around the line through `center` in a direction: the segment from `source` to `source + direction`, turned
once around it. Axis 0 is the turn, axis 1, over
\f$[0,1]\f$, that of the segment; normals point outwards. Neither the radius nor the length needs to be rational. Exact
where the kernel is.
\throws Invalid_input when the direction is zero, `source` is on the line, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> cylinder_surface(const CGAL::Point_3<Kernel>& center, const CGAL::Vector_3<Kernel>& direction,
                                           const CGAL::Point_3<Kernel>& source)
{
  const auto c = internal::exact_object(center), s = internal::exact_object(source);
  const auto n = internal::exact_object(direction);
  if (internal::are_parallel(n, s - c))
    throw Invalid_input("cylinder_surface: the direction is zero or the source is on the axis");
  return Bspline_surface_3<Kernel>(internal::revolved(segment_curve(s, s + n), c, n, "cylinder_surface"));
}

//! the upright cylinder over the circle of a center and radius, of the given height. Exact where the kernel is.
//! \throws Invalid_input when radius or height is not positive, or a number is not finite.
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> cylinder_surface(const CGAL::Point_3<Kernel>& center, const typename Kernel::FT& radius,
                                           const typename Kernel::FT& height)
{
  internal::check_positive(radius, "cylinder_surface: the radius");
  internal::check_positive(height, "cylinder_surface: the height");
  return cylinder_surface<Kernel>(center, CGAL::Vector_3<Kernel>(0, 0, height),
                                  center + CGAL::Vector_3<Kernel>(radius, 0, 0));
}

/*!
the cone around the line through its apex in a direction: the segment from the apex to `source`, turned once around it.
Axis 0 is the turn, axis 1, over \f$[0,1]\f$, that of the segment; at its begin the parametrisation is singular, and
`restricted()` makes a frustum. Normals point outwards if the direction leads into the cone. Exact where the kernel is.
\throws Invalid_input when the direction is zero, `source` is on the line, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> cone_surface(const CGAL::Point_3<Kernel>& apex, const CGAL::Vector_3<Kernel>& direction,
                                       const CGAL::Point_3<Kernel>& source)
{
  const auto a = internal::exact_object(apex), s = internal::exact_object(source);
  const auto n = internal::exact_object(direction);
  if (internal::are_parallel(n, s - a))
    throw Invalid_input("cone_surface: the direction is zero or the source is on the axis");
  return Bspline_surface_3<Kernel>(internal::revolved(segment_curve(a, s), a, n, "cone_surface"));
}

/*!
the torus around the line through `center` in a direction, swept by a circle whose center starts at `spine_point`, at a
right angle to the direction, and whose radius is `ratio` times the distance of `spine_point` from `center`. Axis 0 is
the turn, over \f$[0,4]\f$, axis 1 that of the small circle, over \f$[0,4]\f$, from the outer equator towards the
direction. Normals point outwards. Neither radius needs to be rational, only their ratio; with a ratio of one or more
the torus meets itself. Exact where the kernel is.
\throws Invalid_input when the direction is zero, `spine_point` is not in the plane through the center at a right angle
to it (where numbers are exact) or is the center, the ratio is not positive, or a number is not finite.
*/
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> torus_surface(const CGAL::Point_3<Kernel>& center, const CGAL::Vector_3<Kernel>& direction,
                                        const CGAL::Point_3<Kernel>& spine_point, const typename Kernel::FT& ratio)
{
  internal::check_positive(ratio, "torus_surface: the ratio of the radii");
  const auto c = internal::exact_object(center);
  const auto n = internal::exact_object(direction);
  auto to_spine = internal::exact_object(spine_point) - c;
  if (internal::are_parallel(n, to_spine))
    throw Invalid_input("torus_surface: the direction is zero or the point of the spine is on the axis");
  if (n * to_spine != 0) {
    if constexpr (!std::is_floating_point_v<typename Kernel::FT>)
      throw Invalid_input("torus_surface: the point of the spine is not in the plane through the center");
    to_spine = to_spine - n * Exact_rational((n * to_spine) / n.squared_length());
  }
  // From the outer equator towards the direction: around the vector from the direction to the spine.
  const auto source = to_spine * internal::converted_number<Exact_rational>(ratio);
  const auto circle = circle_curve(c + to_spine, CGAL::cross_product(to_spine, n), c + to_spine + source);
  return Bspline_surface_3<Kernel>(internal::revolved(circle, c, n, "torus_surface"));
}

//! the torus of a center and two radii, its axis in the direction of \f$z\f$. Exact where the kernel is.
//! \throws Invalid_input when a radius is not positive, or a number is not finite.
template <SplineKernel Kernel>
Bspline_surface_3<Kernel> torus_surface(const CGAL::Point_3<Kernel>& center, const typename Kernel::FT& major_radius,
                                        const typename Kernel::FT& minor_radius)
{
  internal::check_positive(major_radius, "torus_surface: the major radius");
  internal::check_positive(minor_radius, "torus_surface: the minor radius");
  const auto c = internal::exact_object(center);
  const Exact_rational major = internal::converted_number<Exact_rational>(major_radius),
                       minor = internal::converted_number<Exact_rational>(minor_radius);
  const internal::Exact_kernel::Vector_3 up(0, 0, 1);
  return Bspline_surface_3<Kernel>(torus_surface<internal::Exact_kernel>(
      c, up, c + internal::Exact_kernel::Vector_3(major, 0, 0), Exact_rational(minor / major)));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SURFACES_SURFACES_OF_REVOLUTION_H
