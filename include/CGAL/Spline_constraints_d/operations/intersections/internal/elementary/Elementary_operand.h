// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_OPERAND_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_OPERAND_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Circle_2.h>
#include <CGAL/Line_2.h>
#include <CGAL/Line_3.h>
#include <CGAL/Plane_3.h>
#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>
#include <CGAL/Ray_2.h>
#include <CGAL/Ray_3.h>
#include <CGAL/Segment_2.h>
#include <CGAL/Segment_3.h>
#include <CGAL/Sphere_3.h>
#include <CGAL/Triangle_3.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

enum class Elementary_kind {
  POINT,
  EQUATION_LINE,   // of the plane, a x + b y + c = 0
  VECTOR_LINE,     // of space, by a point and a vector
  RAY,             // from the first point through the second one
  SEGMENT,         // from the first point to the second one
  SPHERE,          // or circle: center and squared radius
  TRIANGLE,        // in space: three points
  PLANE,           // a x + b y + c z + d = 0
  CURVE,           // a polynomial spline
  PATCH,           // a polynomial surface in one piece
  TURNED_SEGMENT,  // a rational surface on the knots that cylinders and cones have
  OTHER
};

/*
An operand of which there are closed forms, in the doubles that it consists of: nothing is converted, and nothing is
copied of a curve, which has to outlive it.
*/
template <int d>
struct Elementary_operand
{
  Elementary_kind kind = Elementary_kind::OTHER;
  std::array<double, 3 * d> numbers = {};
  bool is_clockwise = false;                                  // of a circle or sphere
  std::array<std::span<const double>, d> coefficients = {};   // of a spline, by coordinate
  std::span<const double> weights = {};                       // of a rational spline
  std::array<int, 2> degrees = {0, 0};                        // of a spline, by parameter
  std::span<const double> knots = {};                         // of a curve
  std::array<std::array<double, 2>, 2> domain = {std::array<double, 2>{0, 1}, std::array<double, 2>{0, 1}};

  // Whether control points are those of a single Bezier piece.
  bool is_one_piece() const
  {
    std::size_t size = 1;
    for (const int degree : degrees)
      size *= static_cast<std::size_t>(degree) + 1;
    return coefficients[0].size() == size &&
        (knots.empty() || (knots.front() == domain[0][0] && knots.back() == domain[0][1]));
  }
};

template <int d, class... FT>
Elementary_operand<d> elementary_operand_of(Elementary_kind kind, const FT&... x)
{
  return {kind, {static_cast<double>(x)...}};
}

// What there are no closed forms for.
template <int d, class Object>
Elementary_operand<d> elementary_operand(const Object&)
{
  return {};
}

template <int d, class K>
Elementary_operand<2> elementary_operand(const CGAL::Point_2<K>& p)
{
  return elementary_operand_of<2>(Elementary_kind::POINT, p.x(), p.y());
}

template <int d, class K>
Elementary_operand<3> elementary_operand(const CGAL::Point_3<K>& p)
{
  return elementary_operand_of<3>(Elementary_kind::POINT, p.x(), p.y(), p.z());
}

template <int d, class K>
Elementary_operand<2> elementary_operand(const CGAL::Line_2<K>& line)
{
  return elementary_operand_of<2>(Elementary_kind::EQUATION_LINE, line.a(), line.b(), line.c());
}

template <int d, class K>
Elementary_operand<3> elementary_operand(const CGAL::Line_3<K>& line)
{
  const auto& p = line.point();
  const auto& v = line.to_vector();
  return elementary_operand_of<3>(Elementary_kind::VECTOR_LINE, p.x(), p.y(), p.z(), v.x(), v.y(), v.z());
}

template <class Point>
auto elementary_operand_of_points(Elementary_kind kind, const Point& p, const Point& q)
{
  if constexpr (requires { p.z(); })
    return elementary_operand_of<3>(kind, p.x(), p.y(), p.z(), q.x(), q.y(), q.z());
  else
    return elementary_operand_of<2>(kind, p.x(), p.y(), q.x(), q.y());
}

template <int d, class K>
Elementary_operand<2> elementary_operand(const CGAL::Ray_2<K>& ray)
{
  return elementary_operand_of_points(Elementary_kind::RAY, ray.source(), ray.second_point());
}

template <int d, class K>
Elementary_operand<3> elementary_operand(const CGAL::Ray_3<K>& ray)
{
  return elementary_operand_of_points(Elementary_kind::RAY, ray.source(), ray.second_point());
}

template <int d, class K>
Elementary_operand<2> elementary_operand(const CGAL::Segment_2<K>& segment)
{
  return elementary_operand_of_points(Elementary_kind::SEGMENT, segment.source(), segment.target());
}

template <int d, class K>
Elementary_operand<3> elementary_operand(const CGAL::Segment_3<K>& segment)
{
  return elementary_operand_of_points(Elementary_kind::SEGMENT, segment.source(), segment.target());
}

template <int d, class K>
Elementary_operand<2> elementary_operand(const CGAL::Circle_2<K>& circle)
{
  const auto& c = circle.center();
  auto result = elementary_operand_of<2>(Elementary_kind::SPHERE, c.x(), c.y(), circle.squared_radius());
  result.is_clockwise = circle.orientation() == CGAL::CLOCKWISE;
  return result;
}

template <int d, class K>
Elementary_operand<3> elementary_operand(const CGAL::Sphere_3<K>& sphere)
{
  const auto& c = sphere.center();
  auto result = elementary_operand_of<3>(Elementary_kind::SPHERE, c.x(), c.y(), c.z(), sphere.squared_radius());
  result.is_clockwise = sphere.orientation() == CGAL::CLOCKWISE;
  return result;
}

template <int d, class K>
Elementary_operand<3> elementary_operand(const CGAL::Plane_3<K>& plane)
{
  return elementary_operand_of<3>(Elementary_kind::PLANE, plane.a(), plane.b(), plane.c(), plane.d());
}

template <int d, class K>
Elementary_operand<3> elementary_operand(const CGAL::Triangle_3<K>& triangle)
{
  const auto &p = triangle.vertex(0), &q = triangle.vertex(1), &r = triangle.vertex(2);
  return elementary_operand_of<3>(Elementary_kind::TRIANGLE, p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), r.x(), r.y(),
                                  r.z());
}

template <int d, class Map>
Elementary_operand<d> elementary_operand_of_map(Elementary_kind kind, const Map& map)
{
  Elementary_operand<d> result{kind};
  for (int axis = 0; axis < map.dimension(); ++axis) {
    const auto [begin, end] = map.numerator(0).domain(axis);
    result.degrees[axis] = map.numerator(0).degree(axis);
    result.domain[axis] = {begin, end};
  }
  for (int i = 0; i < d; ++i)
    result.coefficients[i] = map.numerator(i).coefficients();
  return result;
}

template <int d, class K>
Elementary_operand<d> elementary_operand(const Bspline_curve<K, d>& curve)
{
  const auto& map = curve.representation();
  if (map.is_rational())
    return {};
  auto result = elementary_operand_of_map<d>(Elementary_kind::CURVE, map);
  const auto& knots = map.numerator(0).axes()[0].knots;
  result.knots = {&knots.front(), knots.size()};
  return result;
}

// Four quarters of a turn along axis 0, and degree one along axis 1, as `surface_of_revolution()` has them.
template <class Map>
bool has_knots_of_turned_segment(const Map& map)
{
  constexpr std::array<double, 12> quarters{0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4};
  constexpr std::array<double, 4> unit{0, 0, 1, 1};
  const auto &turn = map.numerator(0).axes()[0], &segment = map.numerator(0).axes()[1];
  return turn.degree == 2 && segment.degree == 1 && std::ranges::equal(turn.knots, quarters) &&
      std::ranges::equal(segment.knots, unit);
}

template <int d, class K>
Elementary_operand<3> elementary_operand(const Bspline_surface_3<K>& surface)
{
  const auto& map = surface.representation();
  if (!map.is_rational()) {
    const auto is_clamped = [](const auto& axis) { return axis.is_clamped(); };
    const auto result = elementary_operand_of_map<3>(Elementary_kind::PATCH, map);
    return result.is_one_piece() && std::ranges::all_of(map.numerator(0).axes(), is_clamped) ? result
                                                                                              : Elementary_operand<3>();
  }
  if (!has_knots_of_turned_segment(map))
    return {};
  auto result = elementary_operand_of_map<3>(Elementary_kind::TURNED_SEGMENT, map);
  result.weights = map.functions()[3].coefficients();
  return result;
}

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_ELEMENTARY_OPERAND_H
