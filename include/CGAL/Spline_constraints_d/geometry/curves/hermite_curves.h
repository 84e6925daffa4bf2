// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_HERMITE_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_HERMITE_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/geometry/curves/internal/interpolation_data.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// On knots that occur three times, each control point is the blossom at the parameter of one point, three times, and at
// two more parameters s and t: the second order of Taylor's formula there is all that it depends on.
template <SplineKernel Kernel, int d, class Point, class Vector>
Bspline_curve<Kernel, d> quintic_hermite(const std::vector<Point>& points, const std::vector<Vector>& velocities,
                                         const std::vector<Vector>& accelerations,
                                         std::vector<typename Kernel::FT> parameters)
{
  using FT = typename Kernel::FT;
  using NT = Spline_number<FT>;
  parameters = interpolation_parameters(std::move(parameters), points.size(), "hermite_curve");
  check_count(velocities.size(), points.size(), "hermite_curve: velocities");
  check_count(accelerations.size(), points.size(), "hermite_curve: accelerations");

  std::vector<Point> control_points;
  std::vector<FT> knots(3, parameters.front());
  const std::size_t last = points.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const std::array<NT, d> p = array_of_coordinates<NT, d>(points[i]), v = array_of_coordinates<NT, d>(velocities[i]),
                            a = array_of_coordinates<NT, d>(accelerations[i]);
    const auto blossom = [&](const NT& s, const NT& t) {
      const NT linear = NT(NT(s + t) / NT(5)), quadratic = NT(NT(s * t) / NT(20));
      std::array<NT, d> x;
      for (int k = 0; k < d; ++k)
        x[k] = NT(p[k] + NT(NT(linear * v[k]) + NT(quadratic * a[k])));
      return kernel_object<Kernel, Point>(x);
    };
    const NT own = converted_number<NT>(parameters[i]),
             back = NT(converted_number<NT>(parameters[i == 0 ? 0 : i - 1]) - own),
             ahead = NT(converted_number<NT>(parameters[i == last ? last : i + 1]) - own);
    control_points.insert(control_points.end(), {blossom(back, back), blossom(back, ahead), blossom(ahead, ahead)});
    knots.insert(knots.end(), 3, parameters[i]);
  }
  knots.insert(knots.end(), 3, parameters.back());
  return Bspline_curve<Kernel, d>(5, knots, control_points);
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

/*!
the quintic Hermite curve: twice continuously differentiable, with given points, first and second derivatives at
increasing parameters, and of degree 5 between these. Two points give one Bézier curve. Each piece depends on the data
at its two ends alone. Exact where the kernel is.
\param points two or more.
\param velocities the first derivatives with respect to the parameter, one for each point.
\param accelerations the second derivatives, one for each point.
\param parameters one for each point; the integers from 0 on if none are given.
\throws Invalid_input for less than two points, numbers of derivatives or parameters that differ from that of the
points, parameters that do not increase, and numbers that are not finite.

Complexity: linear. Such curves, between positions of a mechanism, are the controllers of Stewart and Cremer, Beyond
keyframing: an algorithmic approach to animation, 1991.
*/
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> hermite_curve(const std::vector<CGAL::Point_2<Kernel>>& points,
                                      const std::vector<CGAL::Vector_2<Kernel>>& velocities,
                                      const std::vector<CGAL::Vector_2<Kernel>>& accelerations,
                                      const std::vector<typename Kernel::FT>& parameters = {})
{
  return internal::quintic_hermite<Kernel, 2>(points, velocities, accelerations, parameters);
}

//! the same in space.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> hermite_curve(const std::vector<CGAL::Point_3<Kernel>>& points,
                                      const std::vector<CGAL::Vector_3<Kernel>>& velocities,
                                      const std::vector<CGAL::Vector_3<Kernel>>& accelerations,
                                      const std::vector<typename Kernel::FT>& parameters = {})
{
  return internal::quintic_hermite<Kernel, 3>(points, velocities, accelerations, parameters);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_HERMITE_CURVES_H
