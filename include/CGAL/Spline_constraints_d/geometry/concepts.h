// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONCEPTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONCEPTS_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <array>
#include <concepts>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// What curves and surfaces promise together: a rational map, exactly, and the kernel its points belong to.
template <class Map, int number_of_parameters, int ambient_dimension>
concept Rational_map =
  std::copyable<Map> && SplineKernel<typename Map::Kernel> && Map::number_of_parameters == number_of_parameters &&
  requires(const Map& map, int axis) {
    { map.homogeneous_coordinates() } -> std::same_as<std::array<Bspline_function<Exact_rational>, ambient_dimension>>;
    { map.weight() } -> std::same_as<Bspline_function<Exact_rational>>;
    { map.is_rational() } -> std::same_as<bool>;
    { map.domain(axis) } -> std::same_as<std::pair<typename Map::Kernel::FT, typename Map::Kernel::FT>>;
  };

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDConcepts

The language form of the concept documented as \link ParametricCurve_2 `ParametricCurve_2`\endlink: a rational curve in
the plane, as geometric operations need it.
*/
template <class Curve>
concept ParametricCurve_2 = internal::Rational_map<Curve, 1, 2> &&
    requires(const Curve& curve, const typename Curve::Kernel::FT& t)
{
  { curve(t) } -> std::same_as<typename Curve::Kernel::Point_2>;
};

/*!
\ingroup PkgSplineConstraintsDConcepts

The language form of the concept documented as \link ParametricCurve_3 `ParametricCurve_3`\endlink: a rational curve in
space.
*/
template <class Curve>
concept ParametricCurve_3 = internal::Rational_map<Curve, 1, 3> &&
    requires(const Curve& curve, const typename Curve::Kernel::FT& t)
{
  { curve(t) } -> std::same_as<typename Curve::Kernel::Point_3>;
};

/*!
\ingroup PkgSplineConstraintsDConcepts

The language form of the concept documented as \link ParametricSurface_3 `ParametricSurface_3`\endlink: a rational
surface in space.
*/
template <class Surface>
concept ParametricSurface_3 = internal::Rational_map<Surface, 2, 3> &&
    requires(const Surface& surface, const typename Surface::Kernel::FT& t)
{
  { surface(t, t) } -> std::same_as<typename Surface::Kernel::Point_3>;
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CONCEPTS_H
