// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_JOINT_CONTROL_POINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_JOINT_CONTROL_POINTS_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A kernel in which a point can be moved onto a line.
template <class Kernel>
concept RationalSplineKernel = SplineKernel<Kernel> && !std::is_floating_point_v<typename Kernel::FT>;

// A joint, as the control point of a curve, and the way from there along the curve.
struct Joint_side
{
  std::size_t curve, joint;
  bool is_forward;

  bool operator==(const Joint_side&) const = default;
};

// The control points of curves, to be moved. Joints are those that a curve passes through, as all knots they depend on
// are one: its ends, and others between two pieces.
template <RationalSplineKernel Kernel>
class Joint_control_points
{
  using Point = typename Kernel::Point_2;
  using Vector = typename Kernel::Vector_2;
  using FT = typename Kernel::FT;
  using Curve = Bspline_curve_2<Kernel>;

  std::vector<Curve> m_curves;
  std::vector<std::vector<Point>> m_points;
  std::vector<std::vector<std::size_t>> m_joints;   // of each curve: indices of control points

public:
  explicit Joint_control_points(std::vector<Curve> curves) : m_curves(std::move(curves))
  {
    for (const Curve& curve : m_curves) {
      m_points.push_back(curve.control_points());
      m_joints.push_back(joints_of(curve));
    }
  }

  std::size_t number_of_curves() const { return m_curves.size(); }
  const std::vector<Point>& points(std::size_t curve) const { return m_points[curve]; }
  Point& point(std::size_t curve, std::size_t index) { return m_points[curve][index]; }
  const std::vector<std::size_t>& joints(std::size_t curve) const { return m_joints[curve]; }

  // A curve with the control points where they are now.
  Curve curve(std::size_t i) const
  {
    return Curve(m_curves[i].degree(), m_curves[i].knots(), m_points[i],
                 m_curves[i].is_rational() ? m_curves[i].control_weights() : std::vector<FT>());
  }

  std::vector<Curve> curves() const
  {
    std::vector<Curve> result;
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      result.push_back(curve(i));
    return result;
  }

  // The parameter of a joint.
  FT parameter(std::size_t curve, std::size_t joint) const { return m_curves[curve].knots()[joint + 1]; }

  // The part of a curve between two joints, with the control points where they are now.
  Curve between(std::size_t curve, std::size_t first, std::size_t last) const
  {
    const auto at = [](const auto& list, std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::vector<FT> all = m_curves[curve].knots(),
                          all_weights =
                              m_curves[curve].is_rational() ? m_curves[curve].control_weights() : std::vector<FT>();
    std::vector<FT> knots{all[first + 1]};
    knots.insert(knots.end(), at(all, first + 1),
                 at(all, last + static_cast<std::size_t>(m_curves[curve].degree()) + 1));
    knots.push_back(knots.back());
    return Curve(
        m_curves[curve].degree(), knots, std::vector<Point>(at(m_points[curve], first), at(m_points[curve], last + 1)),
        all_weights.empty() ? all_weights : std::vector<FT>(at(all_weights, first), at(all_weights, last + 1)));
  }

  // The greatest distance by which a control point has been moved, rounded.
  double displacement() const
  {
    double result = 0;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
      const std::vector<Point> before = m_curves[i].control_points();
      for (std::size_t k = 0; k < before.size(); ++k)
        result = (std::max)(result, std::sqrt(CGAL::to_double(CGAL::squared_distance(before[k], m_points[i][k]))));
    }
    return result;
  }

  // The sides of all joints, two of one that is no end.
  std::vector<Joint_side> sides() const
  {
    std::vector<Joint_side> result;
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      for (const std::size_t joint : m_joints[i])
        for (const bool is_forward : {false, true})
          if (is_forward ? joint + 1 < m_points[i].size() : joint > 0)
            result.push_back({i, joint, is_forward});
    return result;
  }

  const Point& joint(const Joint_side& side) const { return m_points[side.curve][side.joint]; }

  // The direction of the curve there.
  Vector direction(const Joint_side& side) const { return m_points[side.curve][next(side)] - joint(side); }

  // The other end of the piece.
  Joint_side opposite(const Joint_side& side) const
  {
    const std::vector<std::size_t>& joints = m_joints[side.curve];
    const auto here = std::find(joints.begin(), joints.end(), side.joint);
    if (side.is_forward)
      return {side.curve, here + 1 == joints.end() ? m_points[side.curve].size() - 1 : *(here + 1), false};
    return {side.curve, here == joints.begin() ? 0 : *(here - 1), true};
  }

  // The first control point of the piece that is not the joint: the one that the direction there depends on.
  std::size_t next(const Joint_side& side) const
  {
    const std::size_t last = opposite(side).joint;
    std::size_t i = side.joint;
    do
      i = side.is_forward ? i + 1 : i - 1;
    while (i != last && m_points[side.curve][i] == joint(side));
    return i;
  }

  // Whether the piece up to the next joint is straight.
  bool is_straight(const Joint_side& side) const
  {
    const auto [first, last] = std::minmax(side.joint, opposite(side).joint);
    const auto is_on_line = [&](const Point& p) {
      return CGAL::collinear(joint(side), m_points[side.curve][next(side)], p);
    };
    const auto begin = m_points[side.curve].begin();
    return std::all_of(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last + 1),
                       is_on_line);
  }

  // Whether that piece is straight, or the directions at both of its ends depend on the same control points.
  bool is_fixed(const Joint_side& side) const
  {
    const Joint_side other = opposite(side);
    const bool are_separate = side.is_forward ? next(side) < next(other) : next(other) < next(side);
    return !are_separate || is_straight(side);
  }

  // Moves a control point to the nearest point of a line.
  void move_onto_line(std::size_t curve, std::size_t index, const Point& on_line, const Vector& direction)
  {
    Point& point = m_points[curve][index];
    point = on_line + direction * FT(((point - on_line) * direction) / (direction * direction));
  }

private:
  static std::vector<std::size_t> joints_of(const Curve& curve)
  {
    const std::vector<FT> knots = curve.knots();
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const auto first = knots.begin() + static_cast<std::ptrdiff_t>(i + 1),
                 last = first + static_cast<std::ptrdiff_t>(curve.degree());
      if (std::adjacent_find(first, last, std::not_equal_to<>()) == last)
        result.push_back(i);
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_INTERNAL_JOINT_CONTROL_POINTS_H
