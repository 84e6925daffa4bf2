// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SMOOTH_JOINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SMOOTH_JOINTS_H

#include <CGAL/Spline_constraints_d/geometry/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <ranges>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A kernel in which a point can be moved onto a line.
template <class Kernel>
concept RationalSplineKernel = SplineKernel<Kernel> && !std::is_floating_point_v<typename Kernel::FT>;

// The control points of curves, of which those next to joints can be moved.
template <RationalSplineKernel Kernel>
class Joint_smoother
{
  using Point = typename Kernel::Point_2;
  using Vector = typename Kernel::Vector_2;
  using FT = typename Kernel::FT;
  using Curve = Bspline_curve_2<Kernel>;

  // A joint as a control point, and the way from there.
  struct Side
  {
    std::size_t curve, joint;
    bool is_forward;
  };

  std::vector<Curve> m_curves;
  std::vector<std::vector<Point>> m_points;
  std::vector<std::vector<std::size_t>> m_joints;   // of each curve: indices of control points that the curve passes through, as all knots it depends on are one
  FT m_most_squared_sine;

public:
  std::size_t joints = 0, left = 0;
  double displacement = 0;

  Joint_smoother(std::vector<Curve> curves, double most_angle) : m_curves(std::move(curves)), m_most_squared_sine(converted_number<FT>(std::pow(std::sin(most_angle), 2)))
  {
    std::map<std::pair<FT, FT>, std::vector<Side>> sides_at;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
      m_points.push_back(m_curves[i].control_points());
      m_joints.push_back(joints_of(m_curves[i]));
      for (const std::size_t joint : m_joints[i])
        for (const bool is_forward : {false, true})
          if (is_forward ? joint + 1 < m_points[i].size() : joint > 0)
            sides_at[{m_points[i][joint].x(), m_points[i][joint].y()}].push_back({i, joint, is_forward});
    }
    for (const auto& [point, sides] : sides_at)
      if (sides.size() == 2)
        smooth(sides[0], sides[1]);
  }

  std::vector<Curve> curves() const
  {
    std::vector<Curve> result;
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      result.emplace_back(m_curves[i].degree(), m_curves[i].knots(), m_points[i], m_curves[i].is_rational() ? m_curves[i].control_weights() : std::vector<FT>());
    return result;
  }

private:
  static std::vector<std::size_t> joints_of(const Curve& curve)
  {
    const std::vector<FT> knots = curve.knots();
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const auto first = knots.begin() + static_cast<std::ptrdiff_t>(i + 1), last = first + static_cast<std::ptrdiff_t>(curve.degree());
      if (std::adjacent_find(first, last, std::not_equal_to<>()) == last)
        result.push_back(i);
    }
    return result;
  }

  const Point& joint(const Side& side) const { return m_points[side.curve][side.joint]; }
  const Point& next_point(const Side& side) const { return m_points[side.curve][next(side)]; }

  // The other end of the piece.
  Side opposite(const Side& side) const
  {
    const std::vector<std::size_t>& joints = m_joints[side.curve];
    const auto here = std::find(joints.begin(), joints.end(), side.joint);
    if (side.is_forward)
      return {side.curve, here + 1 == joints.end() ? m_points[side.curve].size() - 1 : *(here + 1), false};
    return {side.curve, here == joints.begin() ? 0 : *(here - 1), true};
  }

  // The first control point of the piece that is not the joint: the one that the direction there depends on.
  std::size_t next(const Side& side) const
  {
    const std::size_t last = opposite(side).joint;
    std::size_t i = side.joint;
    do
      i = side.is_forward ? i + 1 : i - 1;
    while (i != last && m_points[side.curve][i] == joint(side));
    return i;
  }

  // Whether the piece up to the next joint is straight, or the directions at both of its ends depend on the same control points.
  bool is_fixed(const Side& side) const
  {
    const Side other = opposite(side);
    const auto [first, last] = std::minmax(side.joint, other.joint);
    const auto is_on_line = [&](const Point& p) { return CGAL::collinear(joint(side), next_point(side), p); };
    const auto begin = m_points[side.curve].begin();
    const bool are_separate = side.is_forward ? next(side) < next(other) : next(other) < next(side);
    return !are_separate || std::all_of(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last + 1), is_on_line);
  }

  void smooth(const Side& a, const Side& b)
  {
    const Point common = joint(a);
    const Vector p = next_point(a) - common, q = next_point(b) - common;
    const FT turn = CGAL::determinant(p, q);
    if (!(p * q < 0) || turn == 0 || turn * turn > m_most_squared_sine * (p * p) * (q * q))
      return;
    const std::array<bool, 2> are_fixed{is_fixed(a), is_fixed(b)};
    if (are_fixed[0] && are_fixed[1]) {
      ++left;
      return;
    }
    ++joints;
    const Vector direction = are_fixed[0] ? p : are_fixed[1] ? q : Vector(p - q);
    for (const bool second : {false, true})
      if (!are_fixed[second])
        move_onto_line(second ? b : a, common, direction);
  }

  void move_onto_line(const Side& side, const Point& on_line, const Vector& direction)
  {
    Point& point = m_points[side.curve][next(side)];
    const Point foot = on_line + direction * FT(((point - on_line) * direction) / (direction * direction));
    displacement = (std::max)(displacement, std::sqrt(CGAL::to_double(CGAL::squared_distance(point, foot))));
    point = foot;
  }
};

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

//! curves whose nearly smooth joints have been made smooth, and what that took.
template <SplineKernel Kernel>
struct Smooth_joints_2
{
  std::vector<Bspline_curve_2<Kernel>> curves;   ///< in the order of those that were given
  std::size_t joints;                            ///< how many joints have been made smooth
  std::size_t left;                              ///< how many have not, as nothing can be moved on both sides
  double displacement;                           ///< the greatest distance by which a control point was moved, rounded
};

/*!
curves that are smooth where others are so but for rounding: the directions in which two pieces leave a common point become exactly opposite. Control points next to joints are moved onto one line through the joint, nothing else changes. So what rounded coordinates made of a drawing that is smooth, as a rounded rectangle that is rotated, is taken back, if by a
choice of the caller: diagrams, offsets and sums of the result have no corners there, and are proved sooner.

Joints are points in which just two ends of curves are, with the same coordinates, and those within a curve at knots whose multiplicity is the degree. On a side that is straight up to the next joint, or has no control point for each end that the direction there depends on alone, as one with three control points, or a cubic with two of them in an end, the line is its tangent; where both sides can be moved, it has the direction from one of the control points to the other one.

\tparam Kernel a kernel of rational numbers, which hold the moved points exactly, as `Simple_cartesian<Exact_rational>`; of `curves`, any.
\param curves a range of `Bspline_curve_2`.
\param most_angle the greatest angle at which curves join nearly smoothly, in radians: between 0 and \f$\pi/4\f$.
\throws Invalid_input when the angle is not one of these.

Complexity: \f$O(n \log n)\f$.
*/
template <SplineKernel Kernel, std::ranges::input_range Curves>
  requires internal::RationalSplineKernel<Kernel>
Smooth_joints_2<Kernel> with_smooth_joints(const Curves& curves, double most_angle)
{
  if (!(0 <= most_angle && most_angle <= CGAL_PI / 4))
    throw Invalid_input("with_smooth_joints: the angle is " + std::to_string(most_angle) + ", it has to be between 0 and pi/4");
  std::vector<Bspline_curve_2<Kernel>> exact;
  for (const auto& curve : curves)
    exact.emplace_back(curve);
  const internal::Joint_smoother<Kernel> smoother(std::move(exact), most_angle);
  return {smoother.curves(), smoother.joints, smoother.left, smoother.displacement};
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SMOOTH_JOINTS_H
