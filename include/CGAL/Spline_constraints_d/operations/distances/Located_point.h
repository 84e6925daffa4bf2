// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_LOCATED_POINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_LOCATED_POINT_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/distances/closest_points.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/distance_bounds.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Prepared_spline.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

What a `Curve_locator` or `Surface_locator_3` knows of the point of its spline that is nearest to another point: numbers
in doubles, with certified bounds. Nothing is allocated for it with a kernel of doubles.

\tparam Kernel a `SplineKernel`.
\tparam d the dimension of the space, 2 or 3.
*/
template <SplineKernel Kernel, int d>
class Located_point
{
public:
  //! a closed range of numbers.
  using Range = std::pair<double, double>;
  //! the points of the kernel in dimension `d`.
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

private:
  internal::Distances::Nearest_location<d> m_location;
  Point m_point;

public:
  //! what a locator has found.
  explicit Located_point(const internal::Distances::Nearest_location<d>& location)
    : m_location(location), m_point(internal::kernel_object<Kernel, Point>(location.point))
  {}

  //! the same, of an answer in exact numbers.
  explicit Located_point(const Closest_points<Kernel, d>& closest, int number_of_parameters)
  {
    const Point_pair<Kernel, d>& pair = closest[0];
    m_point = pair.point(1);
    m_location.is_unique = closest.is_unique() && closest.is_complete();
    m_location.squared_distance = {to_double_interval(closest.squared_distance_range().first).first,
                                   to_double_interval(closest.squared_distance_range().second).second};
    for (int axis = 0; axis < number_of_parameters; ++axis) {
      const auto& [lower, upper] = pair.parameter_range(1, static_cast<std::size_t>(axis));
      m_location.parameters[axis] = pair.parameter(1, static_cast<std::size_t>(axis));
      m_location.ranges[axis] = {to_double_interval(lower).first, to_double_interval(upper).second};
    }
  }

  //! whether this is the only nearest point, by proof. Otherwise others are as near, or as near as can be told.
  bool is_unique() const { return m_location.is_unique; }

  //! the parameters of the only nearest point lie in these ranges; without `is_unique()` that is not known.
  const Range& parameter_range(std::size_t axis = 0) const { return m_location.ranges[axis]; }

  //! a number in that range: the parameter of a nearest point, nearly.
  double parameter(std::size_t axis = 0) const { return m_location.parameters[axis]; }

  //! the point of the spline there, rounded.
  const Point& point() const { return m_point; }

  //! the square of the distance of the point from the spline lies between these doubles.
  const Range& squared_distance_range() const { return m_location.squared_distance; }

  //! and the distance between these.
  Range distance_range() const { return internal::Distances::root_range(m_location.squared_distance); }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_LOCATED_POINT_H
