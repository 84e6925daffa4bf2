// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_CIRCULAR_ARCS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_CIRCULAR_ARCS_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/from_bspline.h>
#include <CGAL/Spline_constraints_d/geometry/conversions/internal/conic_parts.h>

#include <optional>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The curve as the image of an axis sees it, without this coordinate.
inline Bspline_curve_2<Exact_kernel> without_coordinate(const Bspline_curve_3<Exact_kernel>& curve, int axis)
{
  const auto x = curve.homogeneous_coordinates();
  return Bspline_curve_2<Exact_kernel>::from_homogeneous_coordinates({x[(axis + 1) % 3], x[(axis + 2) % 3]},
                                                                     curve.weight());
}

// Whether a curve in the plane, on a conic, runs along it once at most, and in which sense.
inline std::optional<CGAL::Orientation> orientation_of_arc(const Bspline_curve_2<Exact_kernel>& curve)
{
  const auto parts = conic_parts(curve);
  if (!parts || parts->size() != 1)
    return std::nullopt;
  return parts->front().orientation;
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the arc of a circle that the curve is, if its pieces are of degree one or two, elevated or not, and it runs along the
circle once, or along a part of it, in either sense: arcs of a circular kernel are counterclockwise, so the arc of a
clockwise curve begins at its target. A whole circle begins and ends at the source. Nothing if there is no such arc.
Decided exactly.
\tparam Curve one in a circular kernel of CGAL.
*/
template <ParametricCurve_2 Curve>
  requires requires { typename Curve::Kernel::Circular_arc_2; }
std::optional<typename Curve::Kernel::Circular_arc_2> to_circular_arc(const Curve& curve)
{
  using Kernel = typename Curve::Kernel;
  const auto exact = internal::exact_curve<2>(curve);
  const auto circle = to_circle(curve);
  const auto orientation = internal::orientation_of_arc(exact);
  if (!circle || !orientation)
    return std::nullopt;
  const auto end = [](const auto& p) {
    return typename Kernel::Circular_arc_point_2(*internal::point_without_rounding<Kernel, 2>(p));
  };
  auto source = end(exact.source()), target = end(exact.target());
  if (*orientation == CGAL::CLOCKWISE)
    std::swap(source, target);
  return typename Kernel::Circular_arc_2(
      typename Kernel::Circle_2(circle->center(), circle->squared_radius(), CGAL::COUNTERCLOCKWISE), source, target);
}

/*!
the same in space. Arcs of a spherical kernel are counterclockwise as seen from the side that a lexicographically
positive normal points to.
\tparam Curve one in a spherical kernel of CGAL.
*/
template <ParametricCurve_3 Curve>
  requires requires { typename Curve::Kernel::Circular_arc_3; }
std::optional<typename Curve::Kernel::Circular_arc_3> to_circular_arc(const Curve& curve)
{
  using Kernel = typename Curve::Kernel;
  const auto circle = to_circle(curve);
  if (!circle)
    return std::nullopt;
  const auto exact = internal::exact_curve<3>(curve);
  auto normal = internal::exact_object(circle->supporting_plane().orthogonal_vector());
  if (CGAL::ORIGIN + normal < internal::Exact_kernel::Point_3(CGAL::ORIGIN))
    normal = -normal;
  // it is positive then: the view along this axis keeps the sense
  const int axis = normal.x() != 0 ? 0 : normal.y() != 0 ? 1 : 2;
  const auto orientation = internal::orientation_of_arc(internal::without_coordinate(exact, axis));
  if (!orientation)
    return std::nullopt;
  const auto end = [](const auto& p) {
    return typename Kernel::Circular_arc_point_3(*internal::point_without_rounding<Kernel, 3>(p));
  };
  auto source = end(exact.source()), target = end(exact.target());
  if (*orientation == CGAL::CLOCKWISE)
    std::swap(source, target);
  return exact.is_closed() ? typename Kernel::Circular_arc_3(*circle, source)
                           : typename Kernel::Circular_arc_3(*circle, source, target);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_CIRCULAR_ARCS_H
