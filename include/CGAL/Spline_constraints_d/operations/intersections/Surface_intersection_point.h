// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_POINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_POINT_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection_kind.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/Found_intersection.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDIntersections

A point that two surfaces have in common and that is not just one of many along a curve: where a curve ends, a singular
point, or a single point. Its parameters lie in ranges that are proved to hold them.

\tparam Kernel a `SplineKernel`.
*/
template <SplineKernel Kernel>
class Surface_intersection_point
{
public:
  //! a closed range of a parameter.
  using Range = std::pair<Exact_rational, Exact_rational>;
  //! the points of the kernel.
  using Point = typename Kernel::Point_3;

private:
  internal::Intersections::Common_surface_point m_common;
  Point m_point;

public:
  //! a point of the intersection of two surfaces; for `Surface_intersection`, whose points are of this type.
  explicit Surface_intersection_point(internal::Intersections::Common_surface_point common)
    : m_common(std::move(common)), m_point(internal::kernel_object<Kernel, Point>(m_common.point))
  {}

  //! `END_POINT` on an edge of a surface, or of the box of an implicit one; `TANGENT` where the surfaces have a common
  //! tangent plane, or one is singular; `UNDECIDED` where nothing is proved.
  Intersection_kind kind() const { return m_common.kind; }

  //! whether a surface, 0 or 1, has parameters: planes, spheres and implicit surfaces have none.
  bool has_parameters(std::size_t surface) const { return !m_common.ranges[surface].empty(); }

  //! the range that the parameter of a surface along an axis, 0 or 1, lies in; near the seam of a surface that is given
  //! by its equation the range begins before the seam. \pre It has parameters.
  const Range& parameter_range(std::size_t surface, std::size_t axis) const { return m_common.ranges[surface][axis]; }

  //! the parameter in the middle of the ranges, rounded to double. \pre It has parameters.
  double parameter(std::size_t surface, std::size_t axis) const { return m_common.parameters[surface][axis]; }

  //! whether it is at an end of the range of a parameter: on an edge or a seam, by proof. Not known of a surface that
  //! is given by its equation.
  bool is_at_end(std::size_t surface, std::size_t axis) const { return m_common.is_at_end[surface][axis]; }

  //! the point in the middle of the ranges.
  const Point& point() const { return m_point; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_SURFACE_INTERSECTION_POINT_H
