// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CLIPPED_LINES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CLIPPED_LINES_H

#include <CGAL/Spline_constraints_d/geometry/curves/polygonal_curves.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The points origin + t direction with t >= `begin`, of all t if there is none.
template <class Point, class Vector>
struct Exact_line
{
  Point origin;
  Vector direction;
  std::optional<Exact_rational> begin;
};

template <class Kernel>
Exact_line<Exact_kernel::Point_2, Exact_kernel::Vector_2> exact_line(const CGAL::Line_2<Kernel>& line)
{
  const Exact_rational a = converted_number<Exact_rational>(line.a()), b = converted_number<Exact_rational>(line.b()),
                       c = converted_number<Exact_rational>(line.c());
  const Exact_kernel::Vector_2 normal(a, b);
  if (normal == CGAL::NULL_VECTOR)
    throw Invalid_input("to_bspline_curve: the line is degenerate");
  return {CGAL::ORIGIN - normal * Exact_rational(c / normal.squared_length()), {b, Exact_rational(-a)}, std::nullopt};
}

template <class Kernel>
Exact_line<Exact_kernel::Point_3, Exact_kernel::Vector_3> exact_line(const CGAL::Line_3<Kernel>& line)
{
  return {exact_object(line.point()), exact_object(line.to_vector()), std::nullopt};
}

template <class Ray>
auto exact_ray(const Ray& ray)
{
  const auto source = exact_object(ray.source());
  const auto direction = exact_object(ray.second_point()) - source;
  return Exact_line<std::decay_t<decltype(source)>, std::decay_t<decltype(direction)>>{source, direction,
                                                                                       Exact_rational(0)};
}

// The range of t in the box: that of one coordinate after the other is taken away (Liang and Barsky).
template <class Point, class Vector>
std::optional<std::pair<Exact_rational, Exact_rational>> range_in_box(const Exact_line<Point, Vector>& line,
                                                                      const Point& low, const Point& high)
{
  if (line.direction == CGAL::NULL_VECTOR)
    throw Invalid_input("to_bspline_curve: the line or ray is degenerate");
  std::optional<Exact_rational> begin = line.begin, end;
  for (int i = 0; i < line.origin.dimension(); ++i) {
    const Exact_rational position = line.origin.cartesian(i), speed = line.direction.cartesian(i);
    if (speed == 0) {
      if (position < low.cartesian(i) || high.cartesian(i) < position)
        return std::nullopt;
      continue;
    }
    Exact_rational enter = (low.cartesian(i) - position) / speed, leave = (high.cartesian(i) - position) / speed;
    if (speed < 0)
      std::swap(enter, leave);
    if (!begin || *begin < enter)
      begin = enter;
    if (!end || leave < *end)
      end = leave;
  }
  if (*end < *begin)
    return std::nullopt;
  return std::pair(*begin, *end);
}

template <class Curve, class Line, class Box>
std::optional<Curve> clipped_line(const Line& line, const Box& box)
{
  const auto range = range_in_box(line, exact_object((box.min)()), exact_object((box.max)()));
  if (!range)
    return std::nullopt;
  return Curve(segment_curve<Exact_kernel>(line.origin + line.direction * range->first,
                                           line.origin + line.direction * range->second));
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the part of the line in the rectangle, its boundary included, as a segment over \f$[0,1]\f$ in the direction of the
line; nothing if they have no point in common. If they have one only, both ends are that point. Whether the rectangle is
met is decided exactly in every kernel, about the numbers that are stored; the ends are exact where the kernel is.
\throws Invalid_input when the line is degenerate, or a number is not finite.
*/
template <SplineKernel Kernel>
std::optional<Bspline_curve_2<Kernel>> to_bspline_curve(const CGAL::Line_2<Kernel>& line,
                                                        const CGAL::Iso_rectangle_2<Kernel>& rectangle)
{
  return internal::clipped_line<Bspline_curve_2<Kernel>>(internal::exact_line(line), rectangle);
}

//! the same of a line in space and a cuboid.
template <SplineKernel Kernel>
std::optional<Bspline_curve_3<Kernel>> to_bspline_curve(const CGAL::Line_3<Kernel>& line,
                                                        const CGAL::Iso_cuboid_3<Kernel>& cuboid)
{
  return internal::clipped_line<Bspline_curve_3<Kernel>>(internal::exact_line(line), cuboid);
}

//! the same of a ray: its part in the rectangle.
template <SplineKernel Kernel>
std::optional<Bspline_curve_2<Kernel>> to_bspline_curve(const CGAL::Ray_2<Kernel>& ray,
                                                        const CGAL::Iso_rectangle_2<Kernel>& rectangle)
{
  return internal::clipped_line<Bspline_curve_2<Kernel>>(internal::exact_ray(ray), rectangle);
}

//! the same of a ray in space and a cuboid.
template <SplineKernel Kernel>
std::optional<Bspline_curve_3<Kernel>> to_bspline_curve(const CGAL::Ray_3<Kernel>& ray,
                                                        const CGAL::Iso_cuboid_3<Kernel>& cuboid)
{
  return internal::clipped_line<Bspline_curve_3<Kernel>>(internal::exact_ray(ray), cuboid);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CLIPPED_LINES_H
