// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_LINE_FUNCTION_2_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_LINE_FUNCTION_2_H

#include <CGAL/Spline_constraints_d/geometry/kernel_numbers.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Approximate_polygons {

using Point = Exact_kernel::Point_2;

// A linear function a x + b y + c, whose zeros are a line.
struct Line_function_2
{
  Exact_rational a, b, c;

  // Zero in two points, positive in a third one.
  static Line_function_2 through(const Point& p, const Point& q, const Point& positive)
  {
    const Exact_rational dx = q.x() - p.x(), dy = q.y() - p.y();
    const Line_function_2 result{-dy, dx, Exact_rational(dy * p.x() - dx * p.y())};
    return CGAL::is_negative(result(positive)) ? -result : result;
  }

  Line_function_2 operator-() const { return {Exact_rational(-a), Exact_rational(-b), Exact_rational(-c)}; }

  Exact_rational operator()(const Point& p) const { return Exact_rational(a * p.x() + b * p.y() + c); }

  // The same, but for a constant, with a zero in a point.
  Line_function_2 parallel_through(const Point& p) const { return {a, b, Exact_rational(-(a * p.x() + b * p.y()))}; }
};

inline Exact_rational determinant(const Line_function_2& f, const Line_function_2& g)
{
  return Exact_rational(f.a * g.b - f.b * g.a);
}

// The common zero of two functions that are not parallel.
inline Point common_zero(const Line_function_2& f, const Line_function_2& g)
{
  const Exact_rational d = determinant(f, g);
  return {Exact_rational((f.b * g.c - f.c * g.b) / d), Exact_rational((f.c * g.a - f.a * g.c) / d)};
}

} // namespace Approximate_polygons
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_APPROXIMATE_POLYGONS_INTERNAL_LINE_FUNCTION_2_H
