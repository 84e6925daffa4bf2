// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_POINT_ON_SPLINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_POINT_ON_SPLINE_H

#include <CGAL/Spline_constraints_d/function/Spline_map.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <algorithm>
#include <array>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDGeometry

A point of a curve or surface, known by ranges of its parameters: what operations find. Within the ranges lies the point
that was asked for; `point()` is one beside it.

\tparam Kernel a `SplineKernel`.
\tparam number_of_parameters 1 for a point of a curve, 2 for one of a surface.
\tparam d the dimension of the space, 2 or 3.
*/
template <SplineKernel Kernel, int number_of_parameters, int d>
class Point_on_spline
{
public:
  //! a closed range of a parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! the points of the kernel in dimension `d`.
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

private:
  std::array<Range, number_of_parameters> m_ranges;
  Point m_point;

public:
  /*!
  the point with parameters in these ranges, which are cut at the ends of the domain: enclosures of solutions may reach
  over it.
  \pre The ranges meet the domain.
  */
  Point_on_spline(const Spline_map<number_of_parameters, d>& map, std::array<Range, number_of_parameters> ranges)
    : m_ranges(std::move(ranges))
  {
    std::array<Exact_rational, number_of_parameters> middle;
    for (int axis = 0; axis < number_of_parameters; ++axis) {
      auto& [begin, end] = m_ranges[axis];
      begin = (std::max)(begin, map.domain(axis).first);
      end = (std::min)(end, map.domain(axis).second);
      middle[axis] = Exact_rational((begin + end) / 2);
    }
    m_point = internal::kernel_object<Kernel, Point>(map(middle));
  }

  //! the range of a parameter.
  const Range& parameter_range(int axis = 0) const { return m_ranges[axis]; }

  //! the middle of the range of a parameter, rounded to the nearest double.
  double parameter(int axis = 0) const
  {
    return to_nearest_double(Exact_rational((m_ranges[axis].first + m_ranges[axis].second) / 2));
  }

  //! the point in the middle of the ranges, rounded where the kernel is not exact. Where the ranges are numbers and the
  //! kernel is exact, it is the point itself.
  const Point& point() const { return m_point; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_CURVES_POINT_ON_SPLINE_H
