// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_LOCATED_HIT_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_LOCATED_HIT_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/operations/common/Intersection.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Prepared_spline.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDDistances

Where a ray meets the spline of a `Curve_locator` or `Surface_locator_3` first: doubles, with certified bounds.

\tparam Kernel a `SplineKernel`.
\tparam d the dimension of the space, 2 or 3.
*/
template <SplineKernel Kernel, int d>
class Located_hit
{
public:
  //! a closed range of numbers.
  using Range = std::pair<double, double>;
  //! the points of the kernel in dimension `d`.
  using Point = typename internal::Ambient_space<Kernel, d>::Point;

private:
  internal::Distances::First_hit<d> m_hit;
  Intersection_kind m_kind = Intersection_kind::TRANSVERSAL;
  Point m_point;

public:
  //! what a locator has found.
  explicit Located_hit(const internal::Distances::First_hit<d>& hit)
    : m_hit(hit), m_point(internal::kernel_object<Kernel, Point>(hit.point))
  {}

  //! the same, of an answer in exact numbers, whose first operand is the ray.
  explicit Located_hit(const Intersection<Kernel, d>& intersection)
    : m_kind(intersection.kind()), m_point(intersection.point())
  {
    const auto doubles = [](const auto& range) {
      return Range(to_double_interval(range.first).first, to_double_interval(range.second).second);
    };
    m_hit.along = doubles(intersection.parameter_range(0));
    for (std::size_t axis = 0; axis + 1 < d; ++axis)
      m_hit.ranges[axis] = doubles(intersection.parameter_range(1, axis));
  }

  //! what is proved: the ranges hold one common point, or an `OVERLAP` begins there, or it is `UNDECIDED` whether there
  //! is one.
  Intersection_kind kind() const { return m_kind; }

  //! the parameter \f$t\f$ of the ray lies in this range, where the point is \f$p + t\,(q - p)\f$ with its source
  //! \f$p\f$ and `second_point()` \f$q\f$.
  const Range& ray_range() const { return m_hit.along; }

  //! the parameters of the point on the spline lie in these ranges.
  const Range& parameter_range(std::size_t axis = 0) const { return m_hit.ranges[axis]; }

  //! the point, rounded.
  const Point& point() const { return m_point; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_LOCATED_HIT_H
