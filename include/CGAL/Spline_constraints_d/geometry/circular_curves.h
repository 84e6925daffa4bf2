// Copyright (c) 2026 The Spline_constraints_d authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CIRCULAR_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CIRCULAR_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/enum.h>

#include <cmath>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// (numerators of vectors from the center) / weight, as a curve or surface around the center.
template <class Object, int d, class Point>
Object object_around(const Point& center, const Vector_function<d>& numerators, const Scalar_function& weight)
{
  const Vector_function<d> moved = numerators + Vector_function<d>(weight.domain(), center - CGAL::ORIGIN) * weight;
  return Object::from_homogeneous_coordinates(moved.functions(), weight.function());
}

// Center + a cos + b sin, in quarters.
template <int d, class Point, class Vector>
Bspline_curve<Exact_kernel, d> ellipse(const Point& center, const Vector& a, const Vector& b)
{
  const Direction_path path = Direction_path::half_round(Exact_rational(1));
  const Vector_function<d> from_a(path.domain(), a), from_b(path.domain(), b);
  const Vector_function<d> numerators = from_a * (path.squared_sigma - path.squared_tau) + from_b * (path.sigma_tau * Exact_rational(2));
  return object_around<Bspline_curve<Exact_kernel, d>>(center, numerators, path.squared_sigma + path.squared_tau);
}

inline bool are_parallel(const Exact_kernel::Vector_2& a, const Exact_kernel::Vector_2& b) { return a.x() * b.y() == a.y() * b.x(); }
inline bool are_parallel(const Exact_kernel::Vector_3& a, const Exact_kernel::Vector_3& b) { return CGAL::cross_product(a, b) == CGAL::NULL_VECTOR; }

template <int d, class Point, class Vector>
Bspline_curve<Exact_kernel, d> checked_ellipse(const Point& center, const Vector& a, const Vector& b)
{
  if (are_parallel(a, b))
    throw Invalid_input("ellipse_curve: the two half axes are parallel, or one is zero");
  return ellipse<d>(center, a, b);
}

template <class FT>
void check_positive(const FT& x, const std::string& what)
{
  if (!(x > FT(0)))
    throw Invalid_input(what + " is not positive");
}

// Where on the half round of height 1 the rotation by an angle is, 0 <= angle < 4 quarters: its point is in the direction of the half angle.
inline Exact_rational turn_parameter(const Exact_rational& cosine, const Exact_rational& sine)
{
  Exact_rational sigma = 1 + cosine, tau = sine;
  if (sigma == 0)
    return Exact_rational(2);
  if (tau < 0) {
    sigma = -sigma;
    tau = -tau;
  }
  if (sigma > 0)
    return Exact_rational(tau <= sigma ? Exact_rational(tau / sigma) : Exact_rational(2 - sigma / tau));
  return Exact_rational(tau >= -sigma ? Exact_rational(2 - sigma / tau) : Exact_rational(4 + tau / sigma));
}

// The circle that a point describes around an axis.
inline Bspline_curve_3<Exact_kernel> circle_around(const Exact_kernel::Point_3& center, const Exact_kernel::Vector_3& direction, const Exact_kernel::Point_3& source)
{
  const auto from_center = source - center;
  if (are_parallel(direction, from_center))
    throw Invalid_input("circle_curve: the direction is zero or the source is on the axis");
  const auto path = Direction_path::half_round(near_inverse_root(direction.squared_length()));
  const Vector_function<3> axis(path.domain(), direction), arm(path.domain(), from_center);
  return object_around<Bspline_curve_3<Exact_kernel>>(center, rotated(arm, axis, path), rotation_weight(axis, path));
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the ellipse \f$c + a \cos\varphi + b \sin\varphi\f$ of a center and two conjugate half axes, from \f$c + a\f$ by \f$c + b\f$ once around: a closed rational quadratic
curve over \f$[0,4]\f$, with a quarter of the ellipse between successive integers, and the weights 1, 1, 2, 1, 1, 1, 2, 1, 1. It is continuously differentiable, also at
its seam. Exact where the kernel is.
\throws Invalid_input when the half axes are parallel, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> ellipse_curve(const CGAL::Point_2<Kernel>& center, const CGAL::Vector_2<Kernel>& a, const CGAL::Vector_2<Kernel>& b)
{
  return Bspline_curve_2<Kernel>(internal::checked_ellipse<2>(internal::exact_object(center), internal::exact_object(a), internal::exact_object(b)));
}

//! the same in space; with half axes of equal length at a right angle, a circle.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> ellipse_curve(const CGAL::Point_3<Kernel>& center, const CGAL::Vector_3<Kernel>& a, const CGAL::Vector_3<Kernel>& b)
{
  return Bspline_curve_3<Kernel>(internal::checked_ellipse<3>(internal::exact_object(center), internal::exact_object(a), internal::exact_object(b)));
}

//! the circle of a center and radius, counterclockwise from its point with the largest \f$x\f$; otherwise as `ellipse_curve()`.
//! \throws Invalid_input when the radius is not positive, or a number is not finite.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> circle_curve(const CGAL::Point_2<Kernel>& center, const typename Kernel::FT& radius)
{
  internal::check_positive(radius, "circle_curve: the radius");
  const Exact_rational r = internal::converted_number<Exact_rational>(radius);
  using Vector = internal::Exact_kernel::Vector_2;
  return Bspline_curve_2<Kernel>(internal::ellipse<2>(internal::exact_object(center), Vector(r, 0), Vector(0, r)));
}

//! the circle of a center through a point, counterclockwise from that point. The radius need not be rational; otherwise as `ellipse_curve()`.
//! \throws Invalid_input when the points are the same, or a coordinate is not finite.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> circle_curve(const CGAL::Point_2<Kernel>& center, const CGAL::Point_2<Kernel>& source)
{
  const auto c = internal::exact_object(center);
  const auto s = internal::exact_object(source) - c;
  return Bspline_curve_2<Kernel>(internal::checked_ellipse<2>(c, s, s.perpendicular(CGAL::COUNTERCLOCKWISE)));
}

/*!
the arc of the circle around a center from one point to another. It is a part of the `circle_curve()` of the center through the source (or of the one that runs the other way round,
if `orientation` is `CGAL::CLOCKWISE`), with the domain \f$[0,v]\f$, where \f$v \le 4\f$ grows with the angle. Exact where the kernel is, whether the radius is rational or not.

In kernels of doubles the target is the point of the circle in the direction of the given one.
\throws Invalid_input when source or target is the center, they are the same point, the target is not on the circle (where numbers are exact), `orientation` is
`CGAL::COLLINEAR`, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> circular_arc_curve(const CGAL::Point_2<Kernel>& center, const CGAL::Point_2<Kernel>& source, const CGAL::Point_2<Kernel>& target,
                                           CGAL::Orientation orientation = CGAL::COUNTERCLOCKWISE)
{
  const auto c = internal::exact_object(center);
  const auto s = internal::exact_object(source) - c;
  auto t = internal::exact_object(target) - c;
  if (s == CGAL::NULL_VECTOR || t == CGAL::NULL_VECTOR || s == t)
    throw Invalid_input("circular_arc_curve: source, target and center are not three different points");
  if (orientation == CGAL::COLLINEAR)
    throw Invalid_input("circular_arc_curve: no orientation");
  if (s.squared_length() != t.squared_length()) {
    if constexpr (!std::is_floating_point_v<typename Kernel::FT>)
      throw Invalid_input("circular_arc_curve: source and target have different distances from the center");
    t = t * to_rational(std::sqrt(to_nearest_double(Exact_rational(s.squared_length() / t.squared_length()))));
  }
  const auto side = s.perpendicular(orientation);
  const Exact_rational squared_radius = s.squared_length();
  const Exact_rational end = internal::turn_parameter(Exact_rational(s * t / squared_radius), Exact_rational(side * t / squared_radius));
  return Bspline_curve_2<Kernel>(internal::ellipse<2>(c, s, side).restricted(Exact_rational(0), end));
}

/*!
the circle that a point describes around the line through `center` in a direction, counterclockwise as seen against the direction: a closed rational quadratic curve over
\f$[0,4]\f$ from that point, half of it between successive even numbers. Exact where the kernel is; neither the radius nor the length of the direction needs to be rational.
\throws Invalid_input when the direction is zero, the point is on the line, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> circle_curve(const CGAL::Point_3<Kernel>& center, const CGAL::Vector_3<Kernel>& direction, const CGAL::Point_3<Kernel>& source)
{
  return Bspline_curve_3<Kernel>(internal::circle_around(internal::exact_object(center), internal::exact_object(direction), internal::exact_object(source)));
}

/*!
the part of that circle from its source to another point of it, counterclockwise as seen against the direction, with the domain \f$[0,v]\f$, where \f$v \le 4\f$ grows with
the angle. Exact where the kernel is.

In kernels of doubles the target is the point of the circle in the direction of the given one.
\throws Invalid_input as `circle_curve()`; when the target is on the line, or is the source; and when it is not on the circle (where numbers are exact).
*/
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> circular_arc_curve(const CGAL::Point_3<Kernel>& center, const CGAL::Vector_3<Kernel>& direction, const CGAL::Point_3<Kernel>& source,
                                           const CGAL::Point_3<Kernel>& target)
{
  const auto c = internal::exact_object(center), p = internal::exact_object(source), q = internal::exact_object(target);
  const auto n = internal::exact_object(direction);
  const auto circle = internal::circle_around(c, n, p);
  if (internal::are_parallel(n, q - c) || p == q)
    throw Invalid_input("circular_arc_curve: the target is on the axis, or is the source");
  const Exact_rational squared_axis = n.squared_length();
  const auto arm = [&](const internal::Exact_kernel::Point_3& x) { return (x - c) - n * Exact_rational((x - c) * n / squared_axis); };
  const auto s = arm(p);
  auto t = arm(q);
  if constexpr (std::is_floating_point_v<typename Kernel::FT>)
    t = t * to_rational(std::sqrt(to_nearest_double(Exact_rational(s.squared_length() / t.squared_length()))));
  else if (s.squared_length() != t.squared_length() || (q - p) * n != 0)
    throw Invalid_input("circular_arc_curve: the target is not on the circle");
  const Exact_rational squared_radius = s.squared_length(), height = internal::near_inverse_root(squared_axis);
  const Exact_rational sine_over_length = n * CGAL::cross_product(s, t) / (squared_axis * squared_radius);
  const Exact_rational end = internal::turn_parameter(Exact_rational(s * t / squared_radius), Exact_rational(sine_over_length / height));
  return Bspline_curve_3<Kernel>(circle.restricted(Exact_rational(0), end));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CIRCULAR_CURVES_H
