// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_VALUES_AT_POINT_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_VALUES_AT_POINT_H

#include <CGAL/Spline_constraints_d/function/Bspline_function.h>
#include <CGAL/Spline_constraints_d/function/internal/Local_weights.h>

#include <span>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The values of several functions at one point, such as the coordinates of a surface: those on the same knots share the
// weights of their control points.
template <class NT>
class Values_at_point
{
  const Bspline_function<NT>& m_first;
  std::span<const NT> m_point;
  Local_weights<NT> m_weights;

public:
  //! \throws Invalid_input when the point is of the wrong dimension or outside of the domain of the first function.
  Values_at_point(const Bspline_function<NT>& first, std::span<const NT> point)
    : m_first(first), m_point(point), m_weights(first.axes(), point, 0, "Bspline_function: ")
  {}

  NT operator()(const Bspline_function<NT>& f) const
  {
    return f.axes() == m_first.axes() ? m_weights.value(f.coefficients()) : f(m_point);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_VALUES_AT_POINT_H
