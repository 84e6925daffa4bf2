// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SMOOTH_JOINTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_SMOOTH_JOINTS_H

#include <CGAL/Spline_constraints_d/geometry/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A kernel in which a point can be moved onto a line.
template <class Kernel>
concept RationalSplineKernel = SplineKernel<Kernel> && !std::is_floating_point_v<typename Kernel::FT>;

// The control points of curves, of which those next to ends can be moved.
template <RationalSplineKernel Kernel>
class Joint_smoother
{
  using Point = typename Kernel::Point_2;
  using Vector = typename Kernel::Vector_2;
  using FT = typename Kernel::FT;
  using Curve = Bspline_curve_2<Kernel>;

  // One of a curve. Of a curve of less than four control points, the tangents in both ends depend on the same points: nothing is moved.
  struct End
  {
    std::size_t curve;
    bool is_end;
  };

  std::vector<Curve> m_curves;
  std::vector<std::vector<Point>> m_points;
  FT m_most_squared_sine;

public:
  std::size_t joints = 0, left = 0;
  double displacement = 0;

  Joint_smoother(std::vector<Curve> curves, double most_angle) : m_curves(std::move(curves)), m_most_squared_sine(converted_number<FT>(std::pow(std::sin(most_angle), 2)))
  {
    for (const Curve& curve : m_curves)
      m_points.push_back(curve.control_points());
    std::map<std::pair<FT, FT>, std::vector<End>> ends_at;
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      for (const bool is_end : {false, true})
        if (is_clamped(m_curves[i], is_end))
          ends_at[{end_point({i, is_end}).x(), end_point({i, is_end}).y()}].push_back({i, is_end});
    for (const auto& [point, ends] : ends_at)
      if (ends.size() == 2)
        smooth(ends[0], ends[1]);
  }

  std::vector<Curve> curves() const
  {
    std::vector<Curve> result;
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      result.emplace_back(m_curves[i].degree(), m_curves[i].knots(), m_points[i], m_curves[i].is_rational() ? m_curves[i].control_weights() : std::vector<FT>());
    return result;
  }

private:
  static bool is_clamped(const Curve& curve, bool is_end)
  {
    const std::vector<FT> knots = curve.knots();
    const auto n = static_cast<std::ptrdiff_t>(curve.degree());
    const auto is_one = [](auto first, auto last) { return std::adjacent_find(first, last, std::not_equal_to<>()) == last; };
    return is_end ? is_one(knots.end() - n, knots.end()) : is_one(knots.begin(), knots.begin() + n);
  }

  const Point& end_point(const End& e) const { return e.is_end ? m_points[e.curve].back() : m_points[e.curve].front(); }
  Point& next_point(const End& e) { return e.is_end ? m_points[e.curve][m_points[e.curve].size() - 2] : m_points[e.curve][1]; }
  bool is_fixed(const End& e) const { return m_points[e.curve].size() < 4; }

  void smooth(const End& a, const End& b)
  {
    const Point joint = end_point(a);
    const Vector p = next_point(a) - joint, q = next_point(b) - joint;
    const FT turn = CGAL::determinant(p, q);
    if (!(p * q < 0) || turn == 0 || turn * turn > m_most_squared_sine * (p * p) * (q * q))
      return;
    if (is_fixed(a) && is_fixed(b)) {
      ++left;
      return;
    }
    ++joints;
    const Vector direction = is_fixed(a) ? p : is_fixed(b) ? q : Vector(p - q);
    for (const End& end : {a, b})
      if (!is_fixed(end))
        move_onto_line(next_point(end), joint, direction);
  }

  void move_onto_line(Point& point, const Point& on_line, const Vector& direction)
  {
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
  std::size_t left;                              ///< how many have not, as the curves on both sides have less than four control points
  double displacement;                           ///< the greatest distance by which a control point was moved, rounded
};

/*!
curves that are smooth where others are so but for rounding: the directions in which two curves leave a common end become exactly opposite. Control points next to ends are moved onto one line through the joint, nothing else changes. So what rounded coordinates made of a drawing that is smooth, as a rounded rectangle that is rotated, is taken back, if by a choice
of the caller: diagrams, offsets and sums of the result have no corners there, and are proved sooner.

Joints are points in which just two ends of curves are, with the same coordinates. On the side of a curve of less than four control points, as a segment, the line is its tangent; with four or more on both sides, it has the direction from one of the control points to the other one.

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
