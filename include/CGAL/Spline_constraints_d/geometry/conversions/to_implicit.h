// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_TO_IMPLICIT_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_TO_IMPLICIT_H

#include <CGAL/Spline_constraints_d/geometry/curves/Implicit_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/geometry/surfaces/Implicit_surface_3.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <CGAL/Circle_2.h>
#include <CGAL/Iso_cuboid_3.h>
#include <CGAL/Iso_rectangle_2.h>
#include <CGAL/Line_2.h>
#include <CGAL/Plane_3.h>
#include <CGAL/Sphere_3.h>

#include <array>
#include <cstddef>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// A number whose square is not less, and that is not more than twice the root.
inline Exact_rational bound_of_root(const Exact_rational& square)
{
  Exact_rational result(1);
  while (result * result < square)
    result *= 2;
  while (result * result > 4 * square && square > 0)
    result /= 2;
  return result;
}

// |x - center|^2 = squared radius, in a cube around it.
template <int d>
Implicit_hypersurface<d> implicit_sphere(const std::array<Exact_rational, d>& center,
                                         const Exact_rational& squared_radius)
{
  if (!(squared_radius > 0))
    throw Invalid_input("to_implicit: the radius is zero");
  const Exact_rational bound = bound_of_root(squared_radius);
  typename Implicit_hypersurface<d>::Box box;
  Power_polynomial f = -Power_polynomial(squared_radius);
  for (int i = 0; i < d; ++i) {
    f += pow(Power_polynomial::variable(i) - Power_polynomial(center[i]), 2);
    box[i] = {Exact_rational(center[i] - 2 * bound), Exact_rational(center[i] + 2 * bound)};
  }
  return Implicit_hypersurface<d>(f, box);
}

// The sum of coefficients times coordinates, and a constant as the last coefficient.
template <std::size_t n>
Power_polynomial linear_polynomial(const std::array<Exact_rational, n>& coefficients)
{
  Power_polynomial result(coefficients[n - 1]);
  for (std::size_t i = 0; i + 1 < n; ++i)
    result += Power_polynomial(coefficients[i]) * Power_polynomial::variable(static_cast<int>(i));
  return result;
}

template <int d, class Iso_box>
typename Implicit_hypersurface<d>::Box box_of(const Iso_box& iso_box)
{
  typename Implicit_hypersurface<d>::Box result;
  for (int i = 0; i < d; ++i)
    result[i] = {converted_number<Exact_rational>(iso_box.min_coord(i)),
                 converted_number<Exact_rational>(iso_box.max_coord(i))};
  return result;
}

} // namespace internal

/*!
\addtogroup PkgSplineConstraintsDConstructions
@{
*/

//! a circle by its equation, in a box around it. \throws Invalid_input when the radius is zero, or something is not
//! finite.
template <SplineKernel Kernel>
Implicit_curve_2 to_implicit(const CGAL::Circle_2<Kernel>& circle)
{
  const auto center = internal::exact_object(circle.center());
  return internal::implicit_sphere<2>({center.x(), center.y()},
                                      internal::converted_number<Exact_rational>(circle.squared_radius()));
}

//! a sphere by its equation, in a box around it. \throws Invalid_input when the radius is zero, or something is not
//! finite.
template <SplineKernel Kernel>
Implicit_surface_3 to_implicit(const CGAL::Sphere_3<Kernel>& sphere)
{
  const auto center = internal::exact_object(sphere.center());
  return internal::implicit_sphere<3>({center.x(), center.y(), center.z()},
                                      internal::converted_number<Exact_rational>(sphere.squared_radius()));
}

//! a line by its equation, in a box. \throws Invalid_input when the line or the box is degenerate, or something is not
//! finite.
template <SplineKernel Kernel>
Implicit_curve_2 to_implicit(const CGAL::Line_2<Kernel>& line, const CGAL::Iso_rectangle_2<Kernel>& box)
{
  const auto exact = [](const auto& x) { return internal::converted_number<Exact_rational>(x); };
  return Implicit_curve_2(internal::linear_polynomial<3>({exact(line.a()), exact(line.b()), exact(line.c())}),
                          internal::box_of<2>(box));
}

//! a plane by its equation, in a box. \throws Invalid_input when the plane or the box is degenerate, or something is
//! not finite.
template <SplineKernel Kernel>
Implicit_surface_3 to_implicit(const CGAL::Plane_3<Kernel>& plane, const CGAL::Iso_cuboid_3<Kernel>& box)
{
  const auto exact = [](const auto& x) { return internal::converted_number<Exact_rational>(x); };
  return Implicit_surface_3(
      internal::linear_polynomial<4>({exact(plane.a()), exact(plane.b()), exact(plane.c()), exact(plane.d())}),
      internal::box_of<3>(box));
}

/*!
@}
*/

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONVERSIONS_TO_IMPLICIT_H
