// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_EXACT_SHAPES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_EXACT_SHAPES_H

#include <CGAL/Spline_constraints_d/geometry/curves/circular_curves.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/Known_frames.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/measured_shapes.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/swept_surfaces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Healing {

// Exact curves and surfaces of the shapes that were measured, on the domains of the given ones.

// A curve in the half-plane beside an axis, in homogeneous coordinates: the distance from the axis, and the height.
struct Profile
{
  Scalar_function distance, height, weight;

  Profile on_axis(const Exact_box& domain, int axis) const
  {
    return {distance.on_axis(domain, axis), height.on_axis(domain, axis), weight.on_axis(domain, axis)};
  }
};

// A control point in doubles; in the plane, of the plane z = 0.
template <int d>
Rounded_point rounded_point(const std::array<Exact_rational, d>& x)
{
  return Rounded_point(to_nearest_double(x[0]), to_nearest_double(x[1]), d == 3 ? to_nearest_double(x[d - 1]) : 0);
}

template <int d>
std::vector<Rounded_point> rounded_control_points(const Homogeneous_spline<Exact_rational, d>& spline)
{
  std::vector<Rounded_point> result;
  for (std::size_t k = 0; k < spline.numerator(0).coefficients().size(); ++k)
    result.push_back(rounded_point<d>(spline.control_point(k)));
  return result;
}

// The circle of a radius around a point of the axis, or beside it.
inline Profile circular_profile(const std::vector<Exact_rational>& breaks, const Measured_revolution& shape,
                                const Known_frames& frames, bool has_kept_parameters)
{
  // from its begin on, so that numbers are as simple there as possible
  const double angle = frames.distance() / (std::max)(shape.size, shape.radius),
               begin = shape.profile_arcs->half_angles.front();
  const Circle_functions circle(shape.profile_arcs->path(breaks, angle, has_kept_parameters));
  const auto [sigma, tau] = simple_half_direction(begin, angle);
  const Exact_rational square = sigma * sigma + tau * tau, cosine = Exact_rational(sigma * sigma - tau * tau) / square,
                       sine = Exact_rational(2 * sigma * tau) / square,
                       radius = simplest_near(shape.radius, frames.distance()),
                       to_center = simplest_near(shape.distance_of_center, frames.distance());
  const auto turned = [&](const Exact_rational& c, const Exact_rational& s) {
    return circle.cosine * Exact_rational(radius * c) + circle.sine * Exact_rational(radius * s);
  };
  return {circle.weight * to_center + turned(cosine, -sine), turned(sine, cosine), circle.weight};
}

// A curve on a line, with the knots and degree of the given one.
inline Profile straight_profile(const Bspline_curve_3<Exact_kernel>& curve, const Rational_frame& frame,
                                const Measured_revolution& shape, const Known_frames& frames)
{
  const Homogeneous_spline<Exact_rational, 3>& map = curve.representation();
  std::vector<Exact_rational> distances, heights, weights;
  std::vector<Rounded_vector> measured;
  for (const Rounded_point& p : rounded_control_points(map))
    measured.push_back(frame.coordinates(p));
  for (std::size_t k = 0; k < measured.size(); ++k) {
    distances.push_back(simplest_near(measured[k].x(), frames.distance()));
    heights.push_back(simplest_near(measured[k].z(), frames.distance()));
    const double weight = to_nearest_double(Exact_rational(map.control_weight(k) / map.control_weight(0)));
    weights.push_back(simplest_near(weight, weight * frames.angle()));
  }
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  const std::size_t a = static_cast<std::size_t>(lowest - heights.begin()),
                    b = static_cast<std::size_t>(highest - heights.begin());
  const Exact_rational first_distance = distances[a], first_height = heights[a];
  if (shape.kind == Primitive_kind::CYLINDER)
    std::fill(distances.begin(), distances.end(), Exact_rational(first_distance));
  else if (shape.kind == Primitive_kind::PLANE)
    std::fill(heights.begin(), heights.end(), Exact_rational(heights.front()));
  else if (heights[a] != heights[b]) {
    const Exact_rational slope =
        Exact_rational(distances[b] - first_distance) / Exact_rational(heights[b] - first_height);
    for (std::size_t k = 0; k < heights.size(); ++k)
      distances[k] = first_distance + slope * Exact_rational(heights[k] - first_height);
  }
  for (std::size_t k = 0; k < weights.size(); ++k) {
    distances[k] *= weights[k];
    heights[k] *= weights[k];
  }
  const Exact_function& f = map.numerator(0);
  return {with_coefficients(f, std::move(distances)), with_coefficients(f, std::move(heights)),
          with_coefficients(f, std::move(weights))};
}

inline Exact_surface exact_revolution(const Exact_surface& surface, const Measured_revolution& shape,
                                      const Rational_frame& frame, const Known_frames& frames, bool has_kept_parameters)
{
  const int turn = shape.turn;
  const Exact_box domain{surface.domain(0), surface.domain(1)};
  const Profile profile =
      (shape.profile_arcs ? circular_profile(surface.breaks(1 - turn), shape, frames, has_kept_parameters)
                          : straight_profile(surface.iso_curve(turn, surface.domain(turn).first), frame, shape, frames))
          .on_axis(domain, 1 - turn);
  const Circle_functions circle(
      shape.arcs.path(surface.breaks(turn), frames.distance() / shape.size, has_kept_parameters).on_axis(domain, turn));
  const auto along = [&](int i, const Scalar_function& f) {
    return Vector_function<3>(domain, frame.axes()[static_cast<std::size_t>(i)]) * f;
  };
  return object_around<Exact_surface>(frame.origin(),
                                      along(0, circle.cosine * profile.distance) +
                                          along(1, circle.sine * profile.distance) +
                                          along(2, circle.weight * profile.height),
                                      circle.weight * profile.weight);
}

template <int d>
Bspline_curve<Exact_kernel, d> exact_arc(const Bspline_curve<Exact_kernel, d>& curve, const Measured_arc& shape,
                                         const Rational_frame& frame, const Known_frames& frames,
                                         bool has_kept_parameters)
{
  const Exact_box domain{curve.domain()};
  const Circle_functions circle(shape.arcs.path(curve.breaks(), frames.distance() / shape.radius, has_kept_parameters));
  const Exact_rational radius = simplest_near(shape.radius, frames.distance());
  const auto along = [&](std::size_t i) {
    return Vector_function<d>(domain, Exact_kernel::Vector_3(frame.axes()[i] * radius));
  };
  return object_around<Bspline_curve<Exact_kernel, d>>(
      frame.origin(), along(0) * circle.cosine + along(1) * circle.sine, circle.weight);
}

// The spline with other control points and its weights.
template <int d, class Point>
Homogeneous_spline<Exact_rational, d> with_control_points(const Homogeneous_spline<Exact_rational, d>& spline,
                                                          const std::vector<Point>& points)
{
  std::vector<Exact_function> functions;
  for (int i = 0; i < d; ++i) {
    std::vector<Exact_rational> numerators;
    for (std::size_t k = 0; k < points.size(); ++k)
      numerators.emplace_back(points[k][i] * spline.control_weight(k));
    functions.push_back(with_coefficients(spline.numerator(i), std::move(numerators)));
  }
  if (spline.is_rational())
    functions.push_back(spline.functions()[d]);
  return Homogeneous_spline<Exact_rational, d>(std::move(functions), "with_exact_primitives");
}

// The plane where a coordinate of a frame is a linear function of the other two, all of its numbers simple.
struct Simple_plane
{
  const Rational_frame* frame;
  int k;                                 // the coordinate along which the normal is longest
  std::array<Exact_rational, 3> numbers;   // the normal over that coordinate for the other two, and the offset

  double bits() const { return bits_of(numbers); }

  Simple_plane(const Rational_frame& coordinates, const Measured_pose& pose, const Known_frames& frames)
    : frame(&coordinates), k(0)
  {
    const Rounded_vector n = coordinates.coordinates(pose.axis), p = coordinates.coordinates(pose.point);
    for (int i = 1; i < 3; ++i)
      if (std::abs(n[k]) < std::abs(n[i]))
        k = i;
    double offset = p[k];
    for (std::size_t i = 0; i < 2; ++i) {
      const int j = (k + 1 + static_cast<int>(i)) % 3;
      numbers[i] = simplest_near(n[j] / n[k], frames.angle());
      offset += to_nearest_double(numbers[i]) * p[j];
    }
    numbers[2] = simplest_near(offset, frames.distance());
  }

  // The point on it with simple coordinates.
  Exact_kernel::Point_3 near(const Rounded_point& p, double distance) const
  {
    const Rounded_vector x = frame->coordinates(p);
    std::array<Exact_rational, 3> result;
    result[static_cast<std::size_t>(k)] = numbers[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const int j = (k + 1 + static_cast<int>(i)) % 3;
      const Exact_rational coordinate = simplest_near(x[j], distance);
      result[static_cast<std::size_t>(j)] = coordinate;
      result[static_cast<std::size_t>(k)] -= numbers[i] * coordinate;
    }
    return frame->point(result);
  }
};

inline Exact_surface exact_plane(const Exact_surface& surface, const std::vector<Rounded_point>& control_points,
                                 const Measured_pose& pose, Known_frames& frames)
{
  std::optional<Simple_plane> plane;
  for (const Rational_frame& frame : frames.frames())
    if (const Simple_plane next(frame, pose, frames);
        frames.are_simple(next.numbers) && (!plane || next.bits() < plane->bits()))
      plane = next;
  const Rational_frame own = plane ? *plane->frame : frames.placed(pose);
  if (!plane)
    plane = Simple_plane(own, pose, frames);
  plane->frame = &own;
  std::vector<Exact_kernel::Point_3> points;
  for (const Rounded_point& p : control_points)
    points.push_back(plane->near(p, frames.distance()));
  frames.add(Rational_frame(own.axes(), points.front()));
  return Exact_surface(with_control_points(surface.representation(), points));
}

// A curve whose control points are on a line, or nearly, as it is there; none of another curve.
template <int d>
std::optional<Bspline_curve<Exact_kernel, d>> exact_line(const Bspline_curve<Exact_kernel, d>& curve,
                                                         const std::vector<Rounded_point>& control_points,
                                                         const Known_frames& frames)
{
  const auto farthest_from = [&](const Rounded_point& p) {
    return *std::max_element(control_points.begin(), control_points.end(),
                             [&](const Rounded_point& a, const Rounded_point& b) {
                               return (a - p).squared_length() < (b - p).squared_length();
                             });
  };
  const Rounded_point a = farthest_from(farthest_from(control_points.front())), b = farthest_from(a);
  const double length = std::sqrt((b - a).squared_length());
  if (!(length > 16 * frames.distance()))
    return std::nullopt;
  const auto [frame, ends] = frames.simplest_coordinates(std::array<Rounded_point, 2>{a, b});
  const Exact_kernel::Point_3 begin = frame->point(ends[0]), end = frame->point(ends[1]);
  std::vector<Exact_kernel::Point_3> points;
  for (const Rounded_point& p : control_points) {
    const double share = (p - a) * (b - a) / (length * length);
    if (!(std::sqrt(across(p - a, (b - a) / length).squared_length()) <= 16 * frames.distance()))
      return std::nullopt;
    points.push_back(begin + (end - begin) * simplest_near(share, frames.distance() / length));
  }
  return Bspline_curve<Exact_kernel, d>(with_control_points(curve.representation(), points));
}

} // namespace Healing
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_EXACT_SHAPES_H
