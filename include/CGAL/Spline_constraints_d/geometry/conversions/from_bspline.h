// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_FROM_BSPLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_FROM_BSPLINE_H

#include <CGAL/Spline_constraints_d/geometry/concepts.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>

#include <CGAL/Polygon_2.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <int d, class Curve>
Bspline_curve<Exact_kernel, d> exact_curve(const Curve& curve)
{
  return Bspline_curve<Exact_kernel, d>::from_homogeneous_coordinates(curve.homogeneous_coordinates(), curve.weight());
}

template <class Surface>
Bspline_surface_3<Exact_kernel> exact_surface(const Surface& surface)
{
  return Bspline_surface_3<Exact_kernel>::from_homogeneous_coordinates(surface.homogeneous_coordinates(),
                                                                       surface.weight());
}

// A point of the exact kernel in another one, if its coordinates are numbers of that.
template <class Target, std::size_t d, class Point>
std::optional<typename Ambient_space<Target, static_cast<int>(d)>::Point> point_without_rounding(const Point& p)
{
  std::array<Exact_rational, d> x;
  for (std::size_t i = 0; i < d; ++i)
    x[i] = p.cartesian(static_cast<int>(i));
  const auto result = kernel_object<Target, typename Ambient_space<Target, static_cast<int>(d)>::Point>(x);
  if (exact_object(result) != p)
    return std::nullopt;
  return result;
}

// The vertices of a curve that is a polygonal one, with constant speed on each side: it is compared with the one
// through its points at the breaks.
template <int d, class Curve>
std::optional<std::vector<typename Ambient_space<typename Curve::Kernel, d>::Point>> polyline_points(const Curve& curve)
{
  using Exact_curve = Bspline_curve<Exact_kernel, d>;
  const Exact_curve exact = exact_curve<d>(curve);
  const std::vector<Exact_rational> breaks = exact.breaks();
  std::vector<typename Exact_curve::Point> points;
  for (const Exact_rational& t : breaks)
    points.push_back(exact(t));
  std::vector<Exact_rational> knots = breaks;
  knots.insert(knots.begin(), breaks.front());
  knots.push_back(breaks.back());
  Exact_curve polyline(1, knots, points);
  if (!(polyline == exact))
    return std::nullopt;
  for (std::size_t i = 1; i + 1 < breaks.size(); ++i)
    if (auto simpler = polyline.without_knot(breaks[i]))
      polyline = *simpler;
  std::vector<typename Ambient_space<typename Curve::Kernel, d>::Point> result;
  for (const auto& p : polyline.control_points()) {
    const auto q = point_without_rounding<typename Curve::Kernel, d>(p);
    if (!q)
      return std::nullopt;
    result.push_back(*q);
  }
  return result;
}

template <class Segment, class Points>
std::optional<Segment> segment_of(const std::optional<Points>& points)
{
  if (!points || points->size() != 2)
    return std::nullopt;
  return Segment((*points)[0], (*points)[1]);
}

template <class Triangle, class Points>
std::optional<Triangle> triangle_of(const std::optional<Points>& points)
{
  if (!points || points->size() != 4 || points->front() != points->back())
    return std::nullopt;
  return Triangle((*points)[0], (*points)[1], (*points)[2]);
}

// Whether a point is no combination of those before it: not the same, on a line or in a plane with them.
template <class Point>
bool is_independent(const std::vector<Point>& before, const Point& p)
{
  if (before.size() == 1)
    return before[0] != p;
  if (before.size() == 2)
    return !CGAL::collinear(before[0], before[1], p);
  if constexpr (std::same_as<Point, Exact_kernel::Point_3>)
    if (before.size() == 3)
      return !CGAL::coplanar(before[0], before[1], before[2], p);
  return before.empty();
}

// Parameters of an axis, degree + 1 in each cell: a linear equation that holds at them holds everywhere.
template <class Map>
std::vector<Exact_rational> deciding_parameters(const Map& map, int axis)
{
  std::vector<Exact_rational> result;
  const std::vector<Exact_rational> breaks = map.breaks(axis);
  const int degree = map.degree(axis);
  for (std::size_t c = 0; c + 1 < breaks.size(); ++c)
    for (int i = 1; i <= degree + 1; ++i)
      result.emplace_back(breaks[c] + (breaks[c + 1] - breaks[c]) * i / (degree + 2));
  return result;
}

// As many independent points of a curve or surface as there are, up to a number.
template <class Map>
std::vector<typename Map::Point> independent_points(const Map& map, std::size_t number)
{
  std::vector<typename Map::Point> result;
  const auto add = [&](const typename Map::Point& p) {
    if (result.size() < number && is_independent(result, p))
      result.push_back(p);
  };
  for (const Exact_rational& u : deciding_parameters(map, 0))
    if constexpr (Map::number_of_parameters == 1)
      add(map(u));
    else
      for (const Exact_rational& v : deciding_parameters(map, 1))
        add(map(u, v));
  return result;
}

// The line from the source of a curve to its target, if all its points are on one. Of a closed curve, through two of
// its points.
template <class Line, int d, class Curve>
std::optional<Line> line_of(const Curve& curve)
{
  using Kernel = typename Curve::Kernel;
  const auto exact = exact_curve<d>(curve);
  auto points = independent_points(exact, 3);
  if (points.size() != 2)
    return std::nullopt;
  if (exact.source() != exact.target())
    points = {exact.source(), exact.target()};
  const auto p = point_without_rounding<Kernel, d>(points[0]), q = point_without_rounding<Kernel, d>(points[1]);
  return p && q ? std::optional(Line(*p, *q)) : std::nullopt;
}

inline bool is_zero(const Scalar_function& f)
{
  const auto& coefficients = f.function().coefficients();
  return std::all_of(coefficients.begin(), coefficients.end(), [](const Exact_rational& c) { return c == 0; });
}

// The vectors from a point to a curve or surface, times its weight.
template <int d, class Map, class Point>
Vector_function<d> weighted_vectors(const Map& map, const Point& from)
{
  const Scalar_function weight(map.weight());
  return Vector_function<d>(map.homogeneous_coordinates()) -
      Vector_function<d>(weight.domain(), from - CGAL::ORIGIN) * weight;
}

// Whether the distance from a point is constant: an identity of polynomials.
template <int d, class Map, class Point>
bool has_distance(const Map& map, const Point& center, const Exact_rational& squared_distance)
{
  const Scalar_function weight(map.weight());
  const Vector_function<d> arm = weighted_vectors<d>(map, center);
  return is_zero(dot(arm, arm) - weight * weight * squared_distance);
}

template <class Map>
bool is_in_plane(const Map& map, const Exact_kernel::Point_3& p, const Exact_kernel::Vector_3& normal)
{
  const Vector_function<3> arm = weighted_vectors<3>(map, p);
  return is_zero(dot(arm, Vector_function<3>(arm.x[0].domain(), normal)));
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the vertices of the curve, if it is a polygonal one that runs along each side with constant speed, whatever its degree,
knots and weights are: if it is the same map as the curve of degree 1 through its points at the breaks. Breaks at which
neither the direction nor the speed changes are no vertices. Nothing otherwise, or if a vertex has no coordinates in the
kernel (in doubles). Decided exactly in every kernel.
*/
template <ParametricCurve_2 Curve>
std::optional<std::vector<typename Curve::Kernel::Point_2>> to_polyline(const Curve& curve)
{
  return internal::polyline_points<2>(curve);
}

//! the same in space.
template <ParametricCurve_3 Curve>
std::optional<std::vector<typename Curve::Kernel::Point_3>> to_polyline(const Curve& curve)
{
  return internal::polyline_points<3>(curve);
}

//! the segment that the curve runs along with constant speed, if it does; see `to_polyline()`.
template <ParametricCurve_2 Curve>
std::optional<typename Curve::Kernel::Segment_2> to_segment(const Curve& curve)
{
  return internal::segment_of<typename Curve::Kernel::Segment_2>(to_polyline(curve));
}

//! the same in space.
template <ParametricCurve_3 Curve>
std::optional<typename Curve::Kernel::Segment_3> to_segment(const Curve& curve)
{
  return internal::segment_of<typename Curve::Kernel::Segment_3>(to_polyline(curve));
}

//! the polygon whose boundary the curve is, if it is a closed polygonal curve; see `to_polyline()`. Whether the polygon
//! is simple is not asked.
template <ParametricCurve_2 Curve>
std::optional<CGAL::Polygon_2<typename Curve::Kernel>> to_polygon(const Curve& curve)
{
  const auto points = to_polyline(curve);
  if (!points || points->front() != points->back())
    return std::nullopt;
  return CGAL::Polygon_2<typename Curve::Kernel>(points->begin(), points->end() - 1);
}

//! the triangle whose boundary the curve is, if it is a closed polygonal curve with three vertices; see
//! `to_polyline()`.
template <ParametricCurve_2 Curve>
std::optional<typename Curve::Kernel::Triangle_2> to_triangle(const Curve& curve)
{
  return internal::triangle_of<typename Curve::Kernel::Triangle_2>(to_polyline(curve));
}

//! the same in space.
template <ParametricCurve_3 Curve>
std::optional<typename Curve::Kernel::Triangle_3> to_triangle(const Curve& curve)
{
  return internal::triangle_of<typename Curve::Kernel::Triangle_3>(to_polyline(curve));
}

//! the rectangle whose boundary the curve is, if it is a closed polygonal curve with four vertices at the corners of a
//! rectangle with sides parallel to the axes, whichever is first and in either sense; see `to_polyline()`.
template <ParametricCurve_2 Curve>
std::optional<typename Curve::Kernel::Iso_rectangle_2> to_iso_rectangle(const Curve& curve)
{
  const auto points = to_polyline(curve);
  if (!points || points->size() != 5 || points->front() != points->back())
    return std::nullopt;
  const typename Curve::Kernel::Iso_rectangle_2 rectangle((*points)[0], (*points)[2]);
  const auto has_corner = [&](const auto& p) {
    return (p.x() == rectangle.xmin() || p.x() == rectangle.xmax()) &&
        (p.y() == rectangle.ymin() || p.y() == rectangle.ymax());
  };
  const auto &p = (*points)[0], &q = (*points)[1], &r = (*points)[2], &s = (*points)[3];
  if (rectangle.is_degenerate() || q == p || q == r || s == q || !has_corner(q) || !has_corner(s) || s == p || s == r)
    return std::nullopt;
  return rectangle;
}

/*!
the line that the curve is on, if there is one, whatever its degree, knots and weights are: from its source to its
target, if these are two points. So a bounded part of a line or a ray gives its line back, and where the part begins and
ends; see also `to_segment()`. Nothing if there is no such line, or its two points have no coordinates in the kernel (in
doubles). Decided exactly in every kernel.
*/
template <ParametricCurve_2 Curve>
std::optional<typename Curve::Kernel::Line_2> to_line(const Curve& curve)
{
  return internal::line_of<typename Curve::Kernel::Line_2, 2>(curve);
}

//! the same in space.
template <ParametricCurve_3 Curve>
std::optional<typename Curve::Kernel::Line_3> to_line(const Curve& curve)
{
  return internal::line_of<typename Curve::Kernel::Line_3, 3>(curve);
}

/*!
the circle that the curve is on, if there is one, whatever its degree, knots and weights are, and how much of the circle
it covers. The circle through three of its points is the only candidate; whether all points are on it is the question
whether a polynomial is zero. The circle is counterclockwise if these points, which follow each other, make a left turn.
Nothing if there is no such circle, or its numbers are none of the kernel (in doubles). Decided exactly in every kernel.
*/
template <ParametricCurve_2 Curve>
std::optional<typename Curve::Kernel::Circle_2> to_circle(const Curve& curve)
{
  using Kernel = typename Curve::Kernel;
  const auto exact = internal::exact_curve<2>(curve);
  const auto points = internal::independent_points(exact, 3);
  if (points.size() < 3)
    return std::nullopt;
  const auto exact_center = CGAL::circumcenter(points[0], points[1], points[2]);
  const Exact_rational squared_radius = CGAL::squared_distance(exact_center, points[0]);
  const auto center = internal::point_without_rounding<Kernel, 2>(exact_center);
  const auto kernel_radius = internal::converted_number<typename Kernel::FT>(squared_radius);
  if (!center || internal::converted_number<Exact_rational>(kernel_radius) != squared_radius ||
      !internal::has_distance<2>(exact, exact_center, squared_radius))
    return std::nullopt;
  return typename Kernel::Circle_2(*center, kernel_radius, CGAL::orientation(points[0], points[1], points[2]));
}

/*!
the same in space, in exact kernels. The normal of the plane of the circle is such that the three points make a left
turn as seen against it.
*/
template <ParametricCurve_3 Curve>
  requires (!std::is_floating_point_v<typename Curve::Kernel::FT>)
std::optional<typename Curve::Kernel::Circle_3> to_circle(const Curve& curve)
{
  using Kernel = typename Curve::Kernel;
  const auto exact = internal::exact_curve<3>(curve);
  const auto points = internal::independent_points(exact, 3);
  if (points.size() < 3)
    return std::nullopt;
  const auto center = CGAL::circumcenter(points[0], points[1], points[2]);
  const auto normal = CGAL::cross_product(points[1] - points[0], points[2] - points[0]);
  const Exact_rational squared_radius = CGAL::squared_distance(center, points[0]);
  if (!internal::is_in_plane(exact, center, normal) || !internal::has_distance<3>(exact, center, squared_radius))
    return std::nullopt;
  const auto number = [](const Exact_rational& x) { return internal::converted_number<typename Kernel::FT>(x); };
  return typename Kernel::Circle_3(
      typename Kernel::Point_3(number(center.x()), number(center.y()), number(center.z())), number(squared_radius),
      typename Kernel::Vector_3(number(normal.x()), number(normal.y()), number(normal.z())));
}

//! the plane that the surface is in, if there is one, in exact kernels; decided exactly, as in `to_circle()`. Its
//! normal is that of three points of the surface.
template <ParametricSurface_3 Surface>
  requires (!std::is_floating_point_v<typename Surface::Kernel::FT>)
std::optional<typename Surface::Kernel::Plane_3> to_plane(const Surface& surface)
{
  using Kernel = typename Surface::Kernel;
  const auto points = internal::independent_points(internal::exact_surface(surface), 4);
  if (points.size() != 3)
    return std::nullopt;
  const auto point = [](const auto& p) { return *internal::point_without_rounding<Kernel, 3>(p); };
  return typename Kernel::Plane_3(point(points[0]), point(points[1]), point(points[2]));
}

//! the sphere that the surface is on, if there is one, counterclockwise, in exact kernels; decided exactly, as in
//! `to_circle()`. Nothing for surfaces in a plane.
template <ParametricSurface_3 Surface>
  requires (!std::is_floating_point_v<typename Surface::Kernel::FT>)
std::optional<typename Surface::Kernel::Sphere_3> to_sphere(const Surface& surface)
{
  using Kernel = typename Surface::Kernel;
  const auto exact = internal::exact_surface(surface);
  const auto points = internal::independent_points(exact, 4);
  if (points.size() < 4)
    return std::nullopt;
  const auto center = CGAL::circumcenter(points[0], points[1], points[2], points[3]);
  const Exact_rational squared_radius = CGAL::squared_distance(center, points[0]);
  if (!internal::has_distance<3>(exact, center, squared_radius))
    return std::nullopt;
  return typename Kernel::Sphere_3(*internal::point_without_rounding<Kernel, 3>(center),
                                   internal::converted_number<typename Kernel::FT>(squared_radius));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_FROM_BSPLINE_H
