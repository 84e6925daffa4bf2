// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_POINT_LOCUS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_POINT_LOCUS_H

#include <CGAL/Spline_constraints_d/geometry/Locus_piece.h>
#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>

#include <CGAL/Point_2.h>
#include <CGAL/Point_3.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

template <int d>
std::vector<Constraint> equality(const Vector_expression<d>& p, const Vector_expression<d>& q)
{
  std::vector<Constraint> result;
  for (int i = 0; i < d; ++i)
    result.push_back(p[i] == q[i]);
  return result;
}

} // namespace internal

/*!
\ingroup PkgSplineConstraintsDGeometry

A point, as constraints see it. `to_locus()` makes it where one is needed.

\tparam d 2 or 3.

\cgalModels{Locus}
*/
template <int d>
class Point_locus
{
  std::array<Exact_rational, d> m_coordinates;

public:
  //! number of coordinates.
  static constexpr int dimension = d;
  //! a point has no parameters.
  static constexpr int number_of_parameters = 0;
  //! number of equations that an implicit description has.
  static constexpr int codimension = d;

  //! the point with these coordinates.
  explicit Point_locus(const std::array<Exact_rational, d>& coordinates) : m_coordinates(coordinates) {}

  //! the point.
  std::vector<Locus_piece<d>> locus_pieces() const
  {
    const Vector_expression<d> point =
        internal::vector_of<d>([&](std::size_t i) { return Expression(m_coordinates[i]); });
    Locus_piece<d> piece;
    piece.point = [point](std::span<const Unknown>) { return point; };
    piece.incidence = [point](const Vector_expression<d>& p, std::span<const Unknown>) {
      return internal::equality<d>(p, point);
    };
    return {piece};
  }

  //! there are none.
  std::vector<Locus_end<d>> locus_ends() const { return {}; }
};

//! \relates Point_locus
//! a `Locus` of a point. \throws Invalid_input when a coordinate is not finite.
template <SplineKernel Kernel>
Point_locus<2> to_locus(const CGAL::Point_2<Kernel>& point)
{
  const auto exact = internal::exact_object(point);
  return Point_locus<2>({exact.x(), exact.y()});
}

//! \relates Point_locus
//! a `Locus` of a point. \throws Invalid_input when a coordinate is not finite.
template <SplineKernel Kernel>
Point_locus<3> to_locus(const CGAL::Point_3<Kernel>& point)
{
  const auto exact = internal::exact_object(point);
  return Point_locus<3>({exact.x(), exact.y(), exact.z()});
}

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_POINT_LOCUS_H
