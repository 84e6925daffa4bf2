// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_KNOWN_FRAMES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_KNOWN_FRAMES_H

#include <CGAL/Spline_constraints_d/geometry/healing/internal/Rational_frame.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

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

// Where a primitive is, as measured: an axis, a direction at a right angle to it, and a point. It may be any point of
// the axis; then this one is taken where no other one is simpler.
struct Measured_pose
{
  Rounded_vector axis, start;   // of length one
  Rounded_point point;
  bool is_any_point_of_axis;
};

/*
Systems of coordinates in which the numbers of some primitives are simple: that of the data, and one at each primitive
whose direction or place is simple in no other one. What has been rotated or moved by numbers that are not simple is so
in exact relations again to what was rotated and moved with it.
*/
class Known_frames
{
  static constexpr std::size_t most_frames = 16;   // as all of them are tried for all primitives

  double m_distance, m_extent;
  std::vector<Rational_frame> m_frames{Rational_frame::identity()};
  std::vector<Rational_frame> m_placed;

public:
  // Numbers are changed by up to a distance, angles by so much that the places in the extent are.
  Known_frames(double distance, double extent) : m_distance(distance), m_extent(extent) {}

  const std::vector<Rational_frame>& frames() const { return m_frames; }
  double distance() const { return m_distance; }
  double angle() const { return m_distance / m_extent; }

  // Whether numbers are so much shorter than those that any double is near, that it is by no chance.
  template <std::size_t n>
  bool are_simple(const std::array<Exact_rational, n>& numbers) const
  {
    return std::all_of(numbers.begin(), numbers.end(),
                       [&](const Exact_rational& x) { return bits_of(x) <= 0.6 * std::log2(m_extent / m_distance); });
  }

  // The frame of a primitive: its axis the last one, the start the first one.
  Rational_frame placed(const Measured_pose& pose)
  {
    bool is_simple = true;
    std::size_t own = frame_of_direction(pose);
    const Exact_axes axes = axes_in(own, pose, is_simple);
    const Exact_kernel::Point_3 origin = origin_near(own, pose, is_simple);
    Rational_frame result(axes, origin);
    if (!is_simple && m_frames.size() < most_frames)
      m_frames.push_back(result);
    m_placed.push_back(result);
    return result;
  }

  // Adds a primitive that is not placed by its axis.
  void add(const Rational_frame& frame) { m_placed.push_back(frame); }

  // The frame in which the primitives have the simplest numbers.
  const Rational_frame& simplest_frame() const
  {
    if (m_frames.size() == 1)
      return m_frames.front();
    return m_frames[least([&](const Rational_frame& f) {
      double bits = 0;
      for (const Rational_frame& placed : m_placed)
        for (int i = 0; i < 3; ++i) {
          const Exact_kernel::Vector_3& axis = f.axes()[static_cast<std::size_t>(i)];
          bits += bits_of(Exact_rational((placed.origin() - f.origin()) * axis));
          for (const Exact_kernel::Vector_3& other : placed.axes())
            bits += bits_of(Exact_rational(other * axis));
        }
      return bits;
    })];
  }

  // The point with the simplest coordinates in a frame near a point, if they are simple.
  std::optional<Exact_kernel::Point_3> simple_point(const Rational_frame& frame, const Rounded_point& p) const
  {
    const auto x = near_coordinates(frame, p, m_distance);
    return are_simple(x) ? std::optional(frame.point(x)) : std::nullopt;
  }

  // The simplest coordinates of some points, which one frame has: it, and the coordinates.
  template <std::size_t n>
  std::pair<const Rational_frame*, std::array<std::array<Exact_rational, 3>, n>>
  simplest_coordinates(const std::array<Rounded_point, n>& points) const
  {
    const auto coordinates = [&](const Rational_frame& frame) {
      std::array<std::array<Exact_rational, 3>, n> result;
      for (std::size_t i = 0; i < n; ++i)
        result[i] = near_coordinates(frame, points[i], m_distance);
      return result;
    };
    const Rational_frame& frame = m_frames[least([&](const Rational_frame& f) {
      double bits = 0;
      for (const auto& x : coordinates(f))
        bits += bits_of(x);
      return bits;
    })];
    return {&frame, coordinates(frame)};
  }

private:
  // Frames are closer to what was measured than the numbers that are simple in them have to be.
  static constexpr double share_of_frames = 1.0 / 16;

  static std::array<Exact_rational, 3> near_coordinates(const Rational_frame& frame, const Rounded_point& p,
                                                        double distance)
  {
    const Rounded_vector x = frame.coordinates(p);
    return {simplest_near(x.x(), distance), simplest_near(x.y(), distance), simplest_near(x.z(), distance)};
  }

  std::size_t frame_of_direction(const Measured_pose& pose) const
  {
    return least([&](const Rational_frame& f) { return Simple_direction(f.coordinates(pose.axis), angle()).bits(); });
  }

  // The index of the first frame for which something is least.
  template <class Size>
  std::size_t least(const Size& size) const
  {
    std::vector<double> sizes;
    for (const Rational_frame& frame : m_frames)
      sizes.push_back(size(frame));
    return static_cast<std::size_t>(std::min_element(sizes.begin(), sizes.end()) - sizes.begin());
  }

  Exact_axes axes_in(std::size_t own, const Measured_pose& pose, bool& is_simple) const
  {
    const Rational_frame* frame = &m_frames[own];
    Simple_direction direction(frame->coordinates(pose.axis), angle());
    if (!are_simple(direction.projection())) {
      is_simple = false;
      frame = &m_frames.front();
      direction = Simple_direction(pose.axis, angle() * share_of_frames);
    }
    const Rational_frame local(direction.axes(), Exact_kernel::Point_3(0, 0, 0));
    const Rounded_vector start = local.coordinates(frame->coordinates(pose.start));
    const double half_angle = std::atan2(start.y(), start.x()) / 2;
    std::array<Exact_rational, 2> half = simple_half_direction(half_angle, angle());
    if (!are_simple(half)) {
      is_simple = false;
      half = simple_half_direction(half_angle, angle() * share_of_frames);
    }
    const Exact_axes axes = turned(local.axes(), half);
    return {frame->vector(axes[0]), frame->vector(axes[1]), frame->vector(axes[2])};
  }

  // In the frame of the direction, if it is simple there; else that where it is simplest comes in its place.
  Exact_kernel::Point_3 origin_near(std::size_t& own, const Measured_pose& pose, bool& is_simple) const
  {
    const auto coordinates = [&](const Rational_frame& f) {
      const double along = pose.is_any_point_of_axis ? (f.rounded_origin() - pose.point) * pose.axis : 0;
      return near_coordinates(f, pose.point + pose.axis * along, m_distance);
    };
    if (!are_simple(coordinates(m_frames[own])))
      own = least([&](const Rational_frame& f) { return bits_of(coordinates(f)); });
    const auto simplest = coordinates(m_frames[own]);
    if (are_simple(simplest))
      return m_frames[own].point(simplest);
    is_simple = false;
    return m_frames.front().point(near_coordinates(m_frames.front(), pose.point, m_distance * share_of_frames));
  }
};

} // namespace Healing
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_HEALING_INTERNAL_KNOWN_FRAMES_H
