// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_MEASURED_SHAPES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_MEASURED_SHAPES_H

#include <CGAL/Spline_constraints_d/geometry/healing/Primitive_kind.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/Arcs.h>
#include <CGAL/Spline_constraints_d/geometry/healing/internal/Known_frames.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Bspline_surface_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Healing {

/*
What curves and surfaces look like when samples of them are looked at in doubles. Nothing is decided here: the exact
shape that is made of it is compared with all of what was given.
*/

// The breaks, and some parameters between them.
inline std::vector<double> sample_parameters(const std::vector<double>& breaks)
{
  constexpr int steps = 4;
  std::vector<double> result;
  for (std::size_t c = 0; c + 1 < breaks.size(); ++c)
    for (int i = 0; i < steps; ++i)
      result.push_back(breaks[c] + (breaks[c + 1] - breaks[c]) * i / steps);
  result.push_back(breaks.back());
  return result;
}

// The circle through three points of a curve over a range, far apart where it is closed, too.
template <class Curve>
std::optional<Measured_circle> circle_along(const Curve& curve, double begin, double end, double distance)
{
  const auto at = [&](double share) { return curve(begin + (end - begin) * share); };
  const Rounded_point p = at(0), q = curve(end);
  const bool is_closed = (q - p).squared_length() <= distance * distance;
  return is_closed ? circle_through(p, at(1.0 / 3), at(2.0 / 3)) : circle_through(p, at(0.5), q);
}

// The part of a vector at a right angle to an axis.
inline Rounded_vector across(const Rounded_vector& v, const Rounded_vector& axis) { return v - axis * (v * axis); }

struct Measured_arc
{
  Measured_pose pose;
  double radius;
  Arcs arcs;
};

// A curve that is, or nearly is, an arc of a circle.
template <class Curve>
std::optional<Measured_arc> measured_arc(const Curve& curve, const std::vector<double>& breaks, double distance)
{
  const auto circle = circle_along(curve, breaks.front(), breaks.back(), distance);
  if (!circle || !(circle->radius > 16 * distance))
    return std::nullopt;
  for (const double u : sample_parameters(breaks)) {
    const Rounded_vector v = curve(u) - circle->center;
    const double height = v * circle->normal, radius = std::sqrt(across(v, circle->normal).squared_length());
    if (!(std::abs(height) <= distance && std::abs(radius - circle->radius) <= distance))
      return std::nullopt;
  }
  const Rounded_vector start = normalised(across(curve(breaks.front()) - circle->center, circle->normal));
  Rounded_vector axis = circle->normal;
  const auto measured = [&] {
    const Rounded_vector side = CGAL::cross_product(axis, start);
    return Arcs::measured(breaks, [&](double u) {
      const Rounded_vector v = curve(u) - circle->center;
      return std::atan2(v * side, v * start);
    });
  };
  auto arcs = measured();
  if (arcs && arcs->turn() < 0) {
    axis = -axis;
    arcs = measured();
  }
  if (!arcs)
    return std::nullopt;
  return Measured_arc{{axis, start, circle->center, false}, circle->radius, *arcs};
}

// The coordinates of a point of a profile: the distance from the axis, and the height.
using Profile_point = std::array<double, 2>;

// A surface that is, or nearly is, turned around an axis.
struct Measured_revolution
{
  int turn;           // the axis of its parameter that goes around
  Measured_pose pose;   // the point is on the axis, at the height of the begin of the profile
  Arcs arcs;
  Primitive_kind kind;
  double size;   // greatest distance from the axis

  // of the circle that is turned, if it is one
  double distance_of_center = 0, radius = 0;
  std::optional<Arcs> profile_arcs = {};
};

namespace measuring {

inline bool are_on_line(const std::vector<Profile_point>& points, double distance)
{
  const auto squared = [](const Profile_point& a, const Profile_point& b) {
    return (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
  };
  const auto farthest = [&](const Profile_point& from) {
    return *std::max_element(points.begin(), points.end(), [&](const Profile_point& a, const Profile_point& b) {
      return squared(from, a) < squared(from, b);
    });
  };
  const Profile_point a = farthest(points.front()), b = farthest(a);
  const double length = std::sqrt(squared(a, b));
  return length > distance && std::all_of(points.begin(), points.end(), [&](const Profile_point& p) {
           return std::abs((p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])) <= distance * length;
         });
}

inline Primitive_kind kind_of_line(const std::vector<Profile_point>& points, double distance)
{
  const auto is_constant = [&](int i) {
    return std::all_of(points.begin(), points.end(), [&](const Profile_point& p) {
      return std::abs(p[static_cast<std::size_t>(i)] - points.front()[static_cast<std::size_t>(i)]) <= distance;
    });
  };
  return is_constant(0) ? Primitive_kind::CYLINDER : is_constant(1) ? Primitive_kind::PLANE : Primitive_kind::CONE;
}

} // namespace measuring

// The surface as turned along an axis of its parameters, if it is.
inline std::optional<Measured_revolution> measured_revolution(const Bspline_surface_3<Rounded_kernel>& surface,
                                                              int turn, double distance)
{
  const auto at = [&](double u, double v) { return turn == 0 ? surface(u, v) : surface(v, u); };
  const std::vector<double> breaks = surface.breaks(turn), other_breaks = surface.breaks(1 - turn);
  const auto row = [&](double v) { return [&at, v](double u) { return at(u, v); }; };
  const double begin = other_breaks.front(), end = other_breaks.back();

  // The circle that is farthest from the axis shows it best.
  double widest = begin;
  std::optional<Measured_circle> circle;
  for (int i = 0; i <= 8; ++i) {
    const double v = i == 8 ? end : begin + (end - begin) * i / 8;
    const auto next = circle_along(row(v), breaks.front(), breaks.back(), distance);
    if (next && (!circle || circle->radius < next->radius)) {
      circle = next;
      widest = v;
    }
  }
  if (!circle)
    return std::nullopt;
  const auto arc = measured_arc(row(widest), breaks, distance);
  if (!arc)
    return std::nullopt;

  const auto& [axis, start, center, is_any] = arc->pose;
  const auto height = [&](const Rounded_point& p) { return (p - arc->pose.point) * arc->pose.axis; };
  const auto squared_radius = [&](const Rounded_point& p) {
    return across(p - arc->pose.point, arc->pose.axis).squared_length();
  };
  std::vector<Profile_point> profile;
  const std::vector<double> samples = sample_parameters(breaks);
  for (const double v : sample_parameters(other_breaks)) {
    const Rounded_point first = at(breaks.front(), v);
    const double radius = (first - center) * start;
    profile.push_back({radius, height(first)});
    for (const double u : samples) {
      const Rounded_point p = at(u, v);
      if (!(std::abs(height(p) - height(first)) <= distance &&
            std::abs(std::sqrt(squared_radius(p)) - std::abs(radius)) <= distance))
        return std::nullopt;
    }
  }

  Measured_revolution result{turn, arc->pose, arc->arcs, Primitive_kind::GENERAL, arc->radius};
  for (const Profile_point& p : profile)
    result.size = (std::max)(result.size, std::abs(p[0]));
  if (measuring::are_on_line(profile, distance)) {
    result.kind = measuring::kind_of_line(profile, distance);
    result.pose.point = center + axis * profile.front()[1];
    result.pose.is_any_point_of_axis = true;
    return result;
  }
  const auto in_plane = [&](double v) {
    const Rounded_point p = at(breaks.front(), v);
    return Rounded_point((p - arc->pose.point) * arc->pose.start, height(p), 0);
  };
  const auto meridian = measured_arc(in_plane, other_breaks, distance);
  if (!meridian)
    return std::nullopt;
  const Rounded_point middle = meridian->pose.point;
  const bool is_sphere = std::abs(middle.x()) <= distance;
  result.kind = is_sphere ? Primitive_kind::SPHERE : Primitive_kind::TORUS;
  result.distance_of_center = is_sphere ? 0 : middle.x();
  result.radius = meridian->radius;
  result.pose.point = center + axis * middle.y();
  result.profile_arcs = Arcs::measured(other_breaks, [&](double v) {
    const Rounded_point p = in_plane(v);
    return std::atan2(p.y() - middle.y(), p.x() - middle.x());
  });
  return result.profile_arcs ? std::optional(result) : std::nullopt;
}

// A plane that points are on, or nearly: its normal the axis, an edge the start. None where they are on a line.
inline std::optional<Measured_pose> measured_plane(const std::vector<Rounded_point>& points, double distance)
{
  const Rounded_point& p = points.front();
  const auto greatest = [&](const auto& size) {
    return *std::max_element(points.begin(), points.end(),
                             [&](const Rounded_point& a, const Rounded_point& b) { return size(a) < size(b); });
  };
  const Rounded_vector u = greatest([&](const Rounded_point& q) { return (q - p).squared_length(); }) - p;
  const auto normal_with = [&](const Rounded_point& q) { return CGAL::cross_product(u, q - p); };
  const Rounded_vector n =
      normal_with(greatest([&](const Rounded_point& q) { return normal_with(q).squared_length(); }));
  const double length = std::sqrt(u.squared_length());
  if (!(n.squared_length() > 16 * distance * distance * length * length))
    return std::nullopt;
  const Rounded_vector axis = normalised(n);
  for (const Rounded_point& q : points)
    if (!(std::abs((q - p) * axis) <= distance))
      return std::nullopt;
  const auto edge = std::find_if(points.begin(), points.end(), [&](const Rounded_point& q) {
    return (q - p).squared_length() > 256 * distance * distance;
  });
  return Measured_pose{axis, edge == points.end() ? normalised(u) : normalised(across(*edge - p, axis)), p, false};
}

} // namespace Healing
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_MEASURED_SHAPES_H
