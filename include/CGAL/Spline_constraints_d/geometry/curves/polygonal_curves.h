// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_POLYGONAL_CURVES_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_POLYGONAL_CURVES_H

#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_2.h>
#include <CGAL/Spline_constraints_d/geometry/curves/Bspline_curve_3.h>
#include <CGAL/Spline_constraints_d/number/Invalid_input.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The knots of a curve that is clamped at both ends, with `size` control points and simple knots at the integers
// between.
template <class FT>
std::vector<FT> integer_knots(int degree, std::size_t size)
{
  const int spans = static_cast<int>(size) - degree;
  std::vector<FT> knots(static_cast<std::size_t>(degree), FT(0));
  for (int i = 0; i <= spans; ++i)
    knots.push_back(FT(i));
  knots.insert(knots.end(), static_cast<std::size_t>(degree), FT(spans));
  return knots;
}

template <SplineKernel Kernel, int d>
Bspline_curve<Kernel, d> polyline(const std::vector<typename Bspline_curve<Kernel, d>::Point>& points)
{
  if (points.size() < 2)
    throw Invalid_input("polyline_curve: " + std::to_string(points.size()) + " points, at least 2 are needed");
  return Bspline_curve<Kernel, d>(1, integer_knots<typename Kernel::FT>(1, points.size()), points);
}

template <SplineKernel Kernel, int d>
Bspline_curve<Kernel, d> bezier(const std::vector<typename Bspline_curve<Kernel, d>::Point>& points,
                                const std::vector<typename Kernel::FT>& weights)
{
  if (points.size() < 2)
    throw Invalid_input("bezier_curve: " + std::to_string(points.size()) + " points, at least 2 are needed");
  const int degree = static_cast<int>(points.size()) - 1;
  return Bspline_curve<Kernel, d>(degree, integer_knots<typename Kernel::FT>(degree, points.size()), points, weights);
}

} // namespace internal

/// \addtogroup PkgSplineConstraintsDConstructions
/// @{

//! the polygonal curve through two or more points, of degree 1, with point \f$i\f$ at the parameter \f$i\f$. Exact in
//! every kernel.
//! \throws Invalid_input for less than two points, and coordinates that are not finite.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> polyline_curve(const std::vector<CGAL::Point_2<Kernel>>& points)
{
  return internal::polyline<Kernel, 2>(points);
}

//! the same in space.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> polyline_curve(const std::vector<CGAL::Point_3<Kernel>>& points)
{
  return internal::polyline<Kernel, 3>(points);
}

//! the segment from \f$p\f$ to \f$q\f$ over \f$[0,1]\f$, of degree 1. Exact in every kernel.
//! \throws Invalid_input for coordinates that are not finite.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> segment_curve(const CGAL::Point_2<Kernel>& p, const CGAL::Point_2<Kernel>& q)
{
  return internal::polyline<Kernel, 2>({p, q});
}

//! the same in space.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> segment_curve(const CGAL::Point_3<Kernel>& p, const CGAL::Point_3<Kernel>& q)
{
  return internal::polyline<Kernel, 3>({p, q});
}

//! the Bézier curve over \f$[0,1]\f$ of two or more control points, rational if there are weights. Its degree is one
//! less than their number. Exact for polynomial curves in every kernel.
//! \throws Invalid_input for less than two points, and as the constructor of `Bspline_curve`.
template <SplineKernel Kernel>
Bspline_curve_2<Kernel> bezier_curve(const std::vector<CGAL::Point_2<Kernel>>& points,
                                     const std::vector<typename Kernel::FT>& weights = {})
{
  return internal::bezier<Kernel, 2>(points, weights);
}

//! the same in space.
template <SplineKernel Kernel>
Bspline_curve_3<Kernel> bezier_curve(const std::vector<CGAL::Point_3<Kernel>>& points,
                                     const std::vector<typename Kernel::FT>& weights = {})
{
  return internal::bezier<Kernel, 3>(points, weights);
}

/// @}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_POLYGONAL_CURVES_H
