// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_TO_BSPLINE_CURVE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_TO_BSPLINE_CURVE_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/geometry/internal/rational_roots.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL {

// Of the circular kernels, which not every user of this header has a use for.
template <class CircularKernel>
class Circular_arc_2;
template <class SphericalKernel>
class Circular_arc_3;

namespace Spline_constraints {
namespace internal {

// What an exact search for a rational point came to nothing with.
[[noreturn]] inline void throw_without_rational_point(const std::string& who, bool is_complete)
{
  throw Invalid_input(
      who +
      (is_complete ? ": there is no point with rational coordinates, so it is no rational curve or surface over the "
                     "rational numbers"
                   : ": no point with rational coordinates was found; give one to the constructor that takes a point"));
}

// A vector of this squared length with rational coordinates. For floating point numbers, one along an axis whose length
// is rounded.
template <class FT>
Exact_kernel::Vector_2 vector_of_squared_length_2(const FT& squared_length, const std::string& who)
{
  check_positive(squared_length, who + ": the squared radius");
  if constexpr (std::is_floating_point_v<FT>)
    return {to_rational(std::sqrt(static_cast<double>(squared_length))), Exact_rational(0)};
  else {
    const auto sum = sum_of_two_squares(converted_number<Exact_rational>(squared_length));
    if (!sum.roots)
      throw_without_rational_point(who, sum.is_complete);
    return {(*sum.roots)[1], (*sum.roots)[0]};
  }
}

// Of a circle or sphere; where these are lazy, that of the exact one: they are made exact anyway.
template <class Object>
CGAL::Orientation orientation_of(const Object& object)
{
  if constexpr (requires { object.exact().orientation(); })
    return object.exact().orientation();
  else
    return object.orientation();
}

// The value of a + b sqrt(c), the form of the coordinates of the ends of a circular arc, if it is rational.
template <class Root>
Exact_rational rational_value(const Root& x)
{
  const Exact_rational a = converted_number<Exact_rational>(x.a0());
  if (!x.is_extended())
    return a;
  const Exact_rational b = converted_number<Exact_rational>(x.a1());
  const std::optional<Exact_rational> root = rational_square_root(converted_number<Exact_rational>(x.root()));
  if (!root && b != 0)
    throw Invalid_input("to_bspline_curve: an end of the arc has no rational coordinates");
  return root ? Exact_rational(a + b * *root) : a;
}

// A vector at a right angle to another one with this squared length and rational coordinates. For floating point
// numbers, one whose length is rounded.
template <class FT>
Exact_kernel::Vector_3 perpendicular_vector_of_squared_length(const Exact_kernel::Vector_3& normal,
                                                              const FT& squared_length, const std::string& who)
{
  using Vector = Exact_kernel::Vector_3;
  check_positive(squared_length, who + ": the squared radius");
  int k = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (CGAL::abs(normal.cartesian(k)) < CGAL::abs(normal.cartesian(axis)))
      k = axis;
  if (normal.cartesian(k) == 0)
    throw Invalid_input(who + ": its plane is degenerate");
  const std::array<Vector, 3> unit{Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)};
  const Vector a = CGAL::cross_product(normal, unit[(k + 1) % 3]), b = CGAL::cross_product(normal, unit[(k + 2) % 3]);
  const Exact_rational squared_radius = converted_number<Exact_rational>(squared_length),
                       squared_a = a.squared_length();
  if constexpr (std::is_floating_point_v<FT>)
    return a * to_rational(std::sqrt(to_nearest_double(Exact_rational(squared_radius / squared_a))));
  else {
    const auto point =
        rational_point_of_form(squared_a, Exact_rational(a * b), Exact_rational(b.squared_length()), squared_radius);
    if (!point.roots)
      throw_without_rational_point(who, point.is_complete);
    return a * (*point.roots)[0] + b * (*point.roots)[1];
  }
}

template <class Vertices>
auto closed_polyline(const Vertices& object, std::size_t size)
{
  std::vector<std::decay_t<decltype(object.vertex(0))>> points;
  for (std::size_t i = 0; i <= size; ++i)
    points.push_back(object.vertex(static_cast<int>(i % size)));
  return polyline_curve(points);
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

//! the segment from its source to its target, over \f$[0,1]\f$. Exact in every kernel.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> to_bspline_curve(const CGAL::Segment_2<Kernel>& segment)
{
  return segment_curve<Kernel>(segment.source(), segment.target());
}

//! the same in space.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> to_bspline_curve(const CGAL::Segment_3<Kernel>& segment)
{
  return segment_curve<Kernel>(segment.source(), segment.target());
}

/*!
the circle, in its own orientation, over \f$[0,4]\f$; see `circle_curve()`. A circle with rational center and squared
radius is a rational curve over the rational numbers exactly if it has a rational point. One is looked for; kernels of
doubles round the radius instead.
\throws Invalid_input when the squared radius is not positive, or there is no rational point, or none is found: the
message says which.
*/
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> to_bspline_curve(const CGAL::Circle_2<Kernel>& circle)
{
  const auto center = internal::exact_object(circle.center());
  const auto radius = internal::vector_of_squared_length_2(circle.squared_radius(), "to_bspline_curve: the circle");
  const auto side = radius.perpendicular(internal::orientation_of(circle));
  return Bspline_curve_2<Kernel>(internal::rounded_ellipse<Kernel, 2>(center, radius, side));
}

/*!
the arc of a circular kernel, counterclockwise as arcs are there, see `circular_arc_curve()`; the circle if its ends are
the same point. The coordinates of its ends are square roots in general; arcs between rational points are converted,
exactly.
\throws Invalid_input when an end has no rational coordinates.
*/
template <SplineKernel CircularKernel>
Bspline_curve_2<CircularKernel> to_bspline_curve(const CGAL::Circular_arc_2<CircularKernel>& arc)
{
  const auto point = [](const auto& p) {
    return internal::Exact_kernel::Point_2(internal::rational_value(p.x()), internal::rational_value(p.y()));
  };
  const auto center = internal::exact_object(arc.center()), source = point(arc.source()), target = point(arc.target());
  return Bspline_curve_2<CircularKernel>(source == target ? circle_curve(center, source)
                                                          : circular_arc_curve(center, source, target));
}

/*!
the circle in space, counterclockwise as seen against the normal of its plane, over \f$[0,4]\f$; see `circle_curve()`. A
point of it with rational coordinates is looked for, in the directions of small integers within its plane; kernels of
doubles round the radius instead.
\throws Invalid_input when the squared radius is not positive, the plane is degenerate, or there is no rational point,
or none is found: the message says which.
*/
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> to_bspline_curve(const CGAL::Circle_3<Kernel>& circle)
{
  const auto center = internal::exact_object(circle.center());
  const auto normal = internal::exact_object(circle.supporting_plane().orthogonal_vector());
  const auto radius =
      internal::perpendicular_vector_of_squared_length(normal, circle.squared_radius(), "to_bspline_curve: the circle");
  return Bspline_curve_3<Kernel>(internal::circle_around(center, normal, center + radius));
}

/*!
the arc of a spherical kernel, in the orientation that arcs have there: counterclockwise as seen from the side that a
lexicographically positive normal points to; see `circular_arc_curve()`. If its ends are the same point, the circle.
Arcs between rational points are converted, exactly.
\throws Invalid_input when an end has no rational coordinates.
*/
template <SplineKernel SphericalKernel>
Bspline_curve_3<SphericalKernel> to_bspline_curve(const CGAL::Circular_arc_3<SphericalKernel>& arc)
{
  const auto point = [](const auto& p) {
    return internal::Exact_kernel::Point_3(internal::rational_value(p.x()), internal::rational_value(p.y()),
                                           internal::rational_value(p.z()));
  };
  const auto center = internal::exact_object(arc.center()), source = point(arc.source()), target = point(arc.target());
  auto normal = internal::exact_object(arc.supporting_plane().orthogonal_vector());
  if (center + normal < center)
    normal = -normal;
  return Bspline_curve_3<SphericalKernel>(source == target ? internal::circle_around(center, normal, source)
                                                           : circular_arc_curve(center, normal, source, target));
}

//! the boundary of the triangle, a closed polygonal curve with vertex \f$i\f$ at the parameter \f$i\f$. Exact in every
//! kernel.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> to_bspline_curve(const CGAL::Triangle_2<Kernel>& triangle)
{
  return internal::closed_polyline(triangle, 3);
}

//! the same in space.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> to_bspline_curve(const CGAL::Triangle_3<Kernel>& triangle)
{
  return internal::closed_polyline(triangle, 3);
}

//! the boundary of the rectangle, a closed polygonal curve with vertex \f$i\f$ at the parameter \f$i\f$. Exact in every
//! kernel.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> to_bspline_curve(const CGAL::Iso_rectangle_2<Kernel>& rectangle)
{
  return internal::closed_polyline(rectangle, 4);
}

//! the boundary of the polygon, a closed polygonal curve with vertex \f$i\f$ at the parameter \f$i\f$. Exact in every
//! kernel.
//! \throws Invalid_input when the polygon is empty.
template <SplineKernel Kernel, class Container>
Bspline_curve_2<Kernel> to_bspline_curve(const CGAL::Polygon_2<Kernel, Container>& polygon)
{
  if (polygon.is_empty())
    throw Invalid_input("to_bspline_curve: the polygon has no vertices");
  return internal::closed_polyline(polygon, polygon.size());
}

//! the boundaries of the polygon: first the outer one, unless the polygon is unbounded, then those of its holes. Exact
//! in every kernel.
//! \throws Invalid_input when a hole is empty.
template <SplineKernel Kernel, class Container>
std::vector<Bspline_curve_2<Kernel>> to_bspline_curves(const CGAL::Polygon_with_holes_2<Kernel, Container>& polygon)
{
  std::vector<Bspline_curve_2<Kernel>> result;
  if (!polygon.is_unbounded())
    result.push_back(to_bspline_curve(polygon.outer_boundary()));
  for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole)
    result.push_back(to_bspline_curve(*hole));
  return result;
}

//! the B-spline form of another model of the concept, in its kernel. Exact where the kernel is.
template <ParametricCurve_2 Curve>
Bspline_curve_2<typename Curve::Kernel> to_bspline_curve(const Curve& curve)
{
  using Exact_curve = Bspline_curve_2<internal::Exact_kernel>;
  return Bspline_curve_2<typename Curve::Kernel>(
      Exact_curve::from_homogeneous_coordinates(curve.homogeneous_coordinates(), curve.weight()));
}

//! the same in space.
template <ParametricCurve_3 Curve>
Bspline_curve_3<typename Curve::Kernel> to_bspline_curve(const Curve& curve)
{
  using Exact_curve = Bspline_curve_3<internal::Exact_kernel>;
  return Bspline_curve_3<typename Curve::Kernel>(
      Exact_curve::from_homogeneous_coordinates(curve.homogeneous_coordinates(), curve.weight()));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_TO_BSPLINE_CURVE_H
