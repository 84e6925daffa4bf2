// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CIRCULAR_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CIRCULAR_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/internal/Vector_function.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
  const Vector_function<d> numerators =
      from_a * (path.squared_sigma - path.squared_tau) + from_b * (path.sigma_tau * Exact_rational(2));
  return object_around<Bspline_curve<Exact_kernel, d>>(center, numerators, path.squared_sigma + path.squared_tau);
}

inline bool are_parallel(const Exact_kernel::Vector_2& a, const Exact_kernel::Vector_2& b)
{
  return a.x() * b.y() == a.y() * b.x();
}
inline bool are_parallel(const Exact_kernel::Vector_3& a, const Exact_kernel::Vector_3& b)
{
  return CGAL::cross_product(a, b) == CGAL::NULL_VECTOR;
}

// The nearest vector of which all coordinates are multiples of a unit.
template <class Vector>
Vector rounded_to_multiples(const Vector& v, const Exact_rational& unit)
{
  const auto rounded = [&](int i) {
    return Exact_rational(Exact_rational(std::round(to_nearest_double(Exact_rational(v.cartesian(i) / unit)))) * unit);
  };
  if constexpr (std::is_same_v<Vector, Exact_kernel::Vector_2>)
    return Vector(rounded(0), rounded(1));
  else
    return Vector(rounded(0), rounded(1), rounded(2));
}

// A parameter as the kernel has it: no piece of a curve is between two that are one for the kernel.
template <class Kernel>
Exact_rational rounded_for(const Exact_rational& x)
{
  using FT = typename Kernel::FT;
  if constexpr (std::is_floating_point_v<FT>)
    return Exact_rational(static_cast<double>(static_cast<FT>(to_nearest_double(x))));
  else
    return x;
}

/*
The ellipse for a kernel. If its numbers are rounded, and so would be control points, the center and the half axes are
rounded instead, to multiples of one unit of which all control points are multiples as well, by less than that: the
curve is an ellipse still, and a circle if it is to be one.
*/
template <class Kernel, int d, class Point, class Vector>
Bspline_curve<Exact_kernel, d> rounded_ellipse(const Point& center, const Vector& a, const Vector& b)
{
  using FT = typename Kernel::FT;
  if constexpr (std::is_floating_point_v<FT>) {
    Exact_rational greatest = 0;
    for (int i = 0; i < d; ++i)
      greatest = (std::max)(greatest, Exact_rational(CGAL::abs(center[i]) + CGAL::abs(a[i]) + CGAL::abs(b[i])));
    // control points that are not finite are refused where they are rounded
    if (greatest > Exact_rational(static_cast<double>((std::numeric_limits<FT>::max)())))
      return ellipse<d>(center, a, b);
    bool is_exact = true;
    for (int i = 0; i < d; ++i)
      for (const int m : {-1, 0, 1})
        for (const int n : {-1, 0, 1}) {
          const Exact_rational x(center[i] + m * a[i] + n * b[i]);
          is_exact = is_exact && x == rounded_for<Kernel>(x);
        }
    const double power = std::ldexp(1.0, std::ilogb(to_nearest_double(greatest)) + 2 - std::numeric_limits<FT>::digits);
    if (is_exact || !(power > 0))
      return ellipse<d>(center, a, b);
    const Exact_rational unit(power);
    const Vector c = center - CGAL::ORIGIN, x = rounded_to_multiples(a, unit), y = rounded_to_multiples(b, unit);
    if (!are_parallel(x, y))
      return ellipse<d>(CGAL::ORIGIN + rounded_to_multiples(c, unit), x, y);
  }
  return ellipse<d>(center, a, b);
}

template <class Kernel, int d, class Point, class Vector>
Bspline_curve<Exact_kernel, d> checked_ellipse(const Point& center, const Vector& a, const Vector& b)
{
  if (are_parallel(a, b))
    throw Invalid_input("ellipse_curve: the two half axes are parallel, or one is zero");
  return rounded_ellipse<Kernel, d>(center, a, b);
}

template <class FT>
void check_positive(const FT& x, const std::string& what)
{
  if (!(x > FT(0)))
    throw Invalid_input(what + " is not positive");
}

// A product of two vectors divided by their lengths: these are equal, up to rounding.
Exact_rational divided_by_lengths(const Exact_rational& product, const Exact_rational& square,
                                  const Exact_rational& other_square);

// 1 + cos, which near a half turn is more accurate from the sine, where numbers are rounded.
inline Exact_rational one_plus_cosine(const Exact_rational& cosine, const Exact_rational& squared_sine)
{
  return cosine < 0 ? Exact_rational(squared_sine / (1 - cosine)) : Exact_rational(1 + cosine);
}

// Where on the half round of height 1 the rotation by an angle is, 0 <= angle < 4 quarters, from 1 + cos and sin: its
// point is in the direction of the half angle.
Exact_rational turn_parameter(const Exact_rational& one_plus_cosine, const Exact_rational& sine);

// The circle that a point describes around an axis.
Bspline_curve_3<Exact_kernel> circle_around(const Exact_kernel::Point_3& center,
                                            const Exact_kernel::Vector_3& direction,
                                            const Exact_kernel::Point_3& source);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational divided_by_lengths(const Exact_rational& product,
                                                                 const Exact_rational& square,
                                                                 const Exact_rational& other_square)
{
  if (square == other_square)
    return Exact_rational(product / square);
  const Exact_rational root =
      to_rational(std::sqrt(to_nearest_double(Exact_rational(product * product / (square * other_square)))));
  return product < 0 ? Exact_rational(-root) : root;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational turn_parameter(const Exact_rational& one_plus_cosine,
                                                             const Exact_rational& sine)
{
  Exact_rational sigma = one_plus_cosine, tau = sine;
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

CGAL_SPLINE_CONSTRAINTS_INLINE Bspline_curve_3<Exact_kernel> circle_around(const Exact_kernel::Point_3& center,
                                                                           const Exact_kernel::Vector_3& direction,
                                                                           const Exact_kernel::Point_3& source)
{
  const auto from_center = source - center;
  if (are_parallel(direction, from_center))
    throw Invalid_input("circle_curve: the direction is zero or the source is on the axis");
  const auto path = Direction_path::half_round(near_inverse_root(direction.squared_length()));
  const Vector_function<3> axis(path.domain(), direction), arm(path.domain(), from_center);
  return object_around<Bspline_curve_3<Exact_kernel>>(center, rotated(arm, axis, path), rotation_weight(axis, path));
}
#endif

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the ellipse \f$c + a \cos\varphi + b \sin\varphi\f$ of a center and two conjugate half axes, from \f$c + a\f$ by \f$c +
b\f$ once around: a closed rational quadratic curve over \f$[0,4]\f$, with a quarter of the ellipse between successive
integers, and the weights 1, 1, 2, 1, 1, 1, 2, 1, 1. It is continuously differentiable, also at its seam. Exact where
the kernel is. In kernels of doubles the center and the half axes are rounded, so that control points need not be: the
result is exactly an ellipse, and a circle if it is to be one.
\throws Invalid_input when the half axes are parallel, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> ellipse_curve(const CGAL::Point_2<Kernel>& center, const CGAL::Vector_2<Kernel>& a,
                                      const CGAL::Vector_2<Kernel>& b)
{
  return Bspline_curve_2<Kernel>(internal::checked_ellipse<Kernel, 2>(
      internal::exact_object(center), internal::exact_object(a), internal::exact_object(b)));
}

//! the same in space; with half axes of equal length at a right angle, a circle.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> ellipse_curve(const CGAL::Point_3<Kernel>& center, const CGAL::Vector_3<Kernel>& a,
                                      const CGAL::Vector_3<Kernel>& b)
{
  return Bspline_curve_3<Kernel>(internal::checked_ellipse<Kernel, 3>(
      internal::exact_object(center), internal::exact_object(a), internal::exact_object(b)));
}

//! the circle of a center and radius, counterclockwise from its point with the largest \f$x\f$; otherwise as
//! `ellipse_curve()`.
//! \throws Invalid_input when the radius is not positive, or a number is not finite.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> circle_curve(const CGAL::Point_2<Kernel>& center, const typename Kernel::FT& radius)
{
  internal::check_positive(radius, "circle_curve: the radius");
  const Exact_rational r = internal::converted_number<Exact_rational>(radius);
  using Vector = internal::Exact_kernel::Vector_2;
  return Bspline_curve_2<Kernel>(
      internal::rounded_ellipse<Kernel, 2>(internal::exact_object(center), Vector(r, 0), Vector(0, r)));
}

//! the circle of a center through a point, counterclockwise from that point. The radius need not be rational; otherwise
//! as `ellipse_curve()`.
//! \throws Invalid_input when the points are the same, or a coordinate is not finite.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> circle_curve(const CGAL::Point_2<Kernel>& center, const CGAL::Point_2<Kernel>& source)
{
  const auto c = internal::exact_object(center);
  const auto s = internal::exact_object(source) - c;
  return Bspline_curve_2<Kernel>(internal::checked_ellipse<Kernel, 2>(c, s, s.perpendicular(CGAL::COUNTERCLOCKWISE)));
}

/*!
the arc of the circle around a center from one point to another. It is a part of the `circle_curve()` of the center
through the source (or of the one that runs the other way round, if `orientation` is `CGAL::CLOCKWISE`), with the domain
\f$[0,v]\f$, where \f$v \le 4\f$ grows with the angle. Exact where the kernel is, whether the radius is rational or not.

In kernels of doubles the target is the point of the circle in the direction of the given one, and the center and the
source are rounded as for the whole circle; arcs of quarters are exactly circular.
\throws Invalid_input when source or target is the center, they are in the same direction from it, the target is not on
the circle (where numbers are exact), `orientation` is `CGAL::COLLINEAR`, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> circular_arc_curve(const CGAL::Point_2<Kernel>& center, const CGAL::Point_2<Kernel>& source,
                                           const CGAL::Point_2<Kernel>& target,
                                           CGAL::Orientation orientation = CGAL::COUNTERCLOCKWISE)
{
  const auto c = internal::exact_object(center);
  const auto s = internal::exact_object(source) - c, t = internal::exact_object(target) - c;
  if (s == CGAL::NULL_VECTOR || t == CGAL::NULL_VECTOR || s == t)
    throw Invalid_input("circular_arc_curve: source, target and center are not three different points");
  if (orientation == CGAL::COLLINEAR)
    throw Invalid_input("circular_arc_curve: no orientation");
  const Exact_rational ss = s.squared_length(), tt = t.squared_length();
  if (!std::is_floating_point_v<typename Kernel::FT> && ss != tt)
    throw Invalid_input("circular_arc_curve: source and target have different distances from the center");
  const auto side = s.perpendicular(orientation);
  const Exact_rational cosine = internal::divided_by_lengths(s * t, ss, tt),
                       sine = internal::divided_by_lengths(side * t, ss, tt);
  const Exact_rational end = internal::rounded_for<Kernel>(
      internal::turn_parameter(internal::one_plus_cosine(cosine, Exact_rational(sine * sine)), sine));
  if (end == 0)
    throw Invalid_input("circular_arc_curve: source and target are in the same direction from the center");
  return Bspline_curve_2<Kernel>(internal::rounded_ellipse<Kernel, 2>(c, s, side).restricted(Exact_rational(0), end));
}

/*!
the circle that a point describes around the line through `center` in a direction, counterclockwise as seen against the
direction: a closed rational quadratic curve over
\f$[0,4]\f$ from that point, half of it between successive even numbers. Exact where the kernel is; neither the radius
nor the length of the direction needs to be rational.
\throws Invalid_input when the direction is zero, the point is on the line, or a coordinate is not finite.
*/
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> circle_curve(const CGAL::Point_3<Kernel>& center, const CGAL::Vector_3<Kernel>& direction,
                                     const CGAL::Point_3<Kernel>& source)
{
  return Bspline_curve_3<Kernel>(internal::circle_around(
      internal::exact_object(center), internal::exact_object(direction), internal::exact_object(source)));
}

/*!
the part of that circle from its source to another point of it, counterclockwise as seen against the direction, with the
domain \f$[0,v]\f$, where \f$v \le 4\f$ grows with the angle. Exact where the kernel is.

In kernels of doubles the target is the point of the circle in the direction of the given one.
\throws Invalid_input as `circle_curve()`; when the target is on the line, or in the direction of the source; and when
it is not on the circle (where numbers are exact).
*/
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> circular_arc_curve(const CGAL::Point_3<Kernel>& center, const CGAL::Vector_3<Kernel>& direction,
                                           const CGAL::Point_3<Kernel>& source, const CGAL::Point_3<Kernel>& target)
{
  const auto c = internal::exact_object(center), p = internal::exact_object(source), q = internal::exact_object(target);
  const auto n = internal::exact_object(direction);
  const auto circle = internal::circle_around(c, n, p);
  if (internal::are_parallel(n, q - c) || p == q)
    throw Invalid_input("circular_arc_curve: the target is on the axis, or is the source");
  const Exact_rational squared_axis = n.squared_length();
  const auto arm = [&](const internal::Exact_kernel::Point_3& x) {
    return (x - c) - n * Exact_rational((x - c) * n / squared_axis);
  };
  const auto s = arm(p), t = arm(q);
  const Exact_rational ss = s.squared_length(), tt = t.squared_length(),
                       height = internal::near_inverse_root(squared_axis);
  if (!std::is_floating_point_v<typename Kernel::FT> && (ss != tt || (q - p) * n != 0))
    throw Invalid_input("circular_arc_curve: the target is not on the circle");
  const Exact_rational cosine = internal::divided_by_lengths(s * t, ss, tt),
                       sine_over_length =
                           internal::divided_by_lengths(n * CGAL::cross_product(s, t) / squared_axis, ss, tt);
  const Exact_rational end = internal::rounded_for<Kernel>(internal::turn_parameter(
      internal::one_plus_cosine(cosine, Exact_rational(squared_axis * sine_over_length * sine_over_length)),
      Exact_rational(sine_over_length / height)));
  if (end == 0)
    throw Invalid_input("circular_arc_curve: source and target are in the same direction from the center");
  return Bspline_curve_3<Kernel>(circle.restricted(Exact_rational(0), end));
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_CIRCULAR_CURVES_H
