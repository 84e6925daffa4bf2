// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_SMOOTH_JOINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_SMOOTH_JOINTS_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/Joint_control_points.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Makes joints smooth where two sides are nearly so.
template <RationalSplineKernel Kernel>
class Joint_smoother
{
  using Point = typename Kernel::Point_2;
  using Vector = typename Kernel::Vector_2;
  using FT = typename Kernel::FT;
  using Curve = Bspline_curve_2<Kernel>;
  using Side = Joint_side;

  FT m_most_squared_sine;

public:
  Joint_control_points<Kernel> points;
  std::size_t joints = 0, left = 0;

  Joint_smoother(std::vector<Curve> curves, double most_angle)
    : m_most_squared_sine(converted_number<FT>(std::pow(std::sin(most_angle), 2))), points(std::move(curves))
  {
    std::map<std::pair<FT, FT>, std::vector<Side>> sides_at;
    for (const Side& side : points.sides())
      sides_at[{points.joint(side).x(), points.joint(side).y()}].push_back(side);
    for (const auto& [point, sides] : sides_at)
      if (sides.size() == 2)
        smooth(sides[0], sides[1]);
  }

private:
  void smooth(const Side& a, const Side& b)
  {
    const Point common = points.joint(a);
    const Vector p = points.direction(a), q = points.direction(b);
    const FT turn = CGAL::determinant(p, q);
    if (!(p * q < 0) || turn == 0 || turn * turn > m_most_squared_sine * (p * p) * (q * q))
      return;
    const std::array<bool, 2> are_fixed{points.is_fixed(a), points.is_fixed(b)};
    if (are_fixed[0] && are_fixed[1]) {
      ++left;
      return;
    }
    ++joints;
    const Vector direction = are_fixed[0] ? p : are_fixed[1] ? q : Vector(p - q);
    for (const bool second : {false, true})
      if (const Side& side = second ? b : a; !are_fixed[second])
        points.move_onto_line(side.curve, points.next(side), common, direction);
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
curves that are smooth where others are so but for rounding: the directions in which two pieces leave a common point
become exactly opposite. Control points next to joints are moved onto one line through the joint, nothing else changes.
So what rounded coordinates made of a drawing that is smooth, as a rounded rectangle that is rotated, is taken back, if
by a choice of the caller: diagrams, offsets and sums of the result have no corners there, and are proved sooner.

Joints are points in which just two ends of curves are, with the same coordinates, and those within a curve at knots
whose multiplicity is the degree. On a side that is straight up to the next joint, or has no control point for each end
that the direction there depends on alone, as one with three control points, or a cubic with two of them in an end, the
line is its tangent; where both sides can be moved, it has the direction from one of the control points to the other
one.

\tparam Kernel a kernel of rational numbers, which hold the moved points exactly, as `Simple_cartesian<Exact_rational>`;
of `curves`, any.
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
    throw Invalid_input("with_smooth_joints: the angle is " + std::to_string(most_angle) +
                        ", it has to be between 0 and pi/4");
  std::vector<Bspline_curve_2<Kernel>> exact;
  for (const auto& curve : curves)
    exact.emplace_back(curve);
  const internal::Joint_smoother<Kernel> smoother(std::move(exact), most_angle);
  return {smoother.points.curves(), smoother.joints, smoother.left, smoother.points.displacement()};
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_SMOOTH_JOINTS_H
