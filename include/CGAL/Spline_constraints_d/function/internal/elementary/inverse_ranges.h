// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_INVERSE_RANGES_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_INVERSE_RANGES_H

#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/point_values.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/ranges.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace elementary {

// Narrows a range to numbers where the function is defined and its value lies in `values`; false when none is left.
bool narrow_argument(const Operation& operation, const Interval& values, Interval& x);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
// To the common part.
inline bool narrow_to(Interval& x, const Interval& to) { return restrict_to(x, to.inf(), to.sup()); }

// To the hull of the common parts with two ranges.
inline bool narrow_to_either(Interval& x, const Interval& a, const Interval& b)
{
  Interval in_a = x, in_b = x;
  const bool has_a = narrow_to(in_a, a), has_b = narrow_to(in_b, b);
  if (!has_a && !has_b)
    return false;
  x = !has_a ? in_b : !has_b ? in_a : hull(in_a, in_b);
  return true;
}

/*
To numbers that some multiple of a period carries into one of some ranges [a, b]. A number of x that k periods carry to
is at most b + k period, so k is at least (x - b) / period at the lower end of x, and it is at least a + k period; the
same at the upper end.
*/
inline bool narrow_periodically(Interval& x, const Interval& period, std::initializer_list<Interval> ranges)
{
  constexpr double largest = 0x1p40, infinity = std::numeric_limits<double>::infinity();
  if (!(x.inf() > -largest && x.sup() < largest))
    return true;
  double lower = infinity, upper = -infinity;
  for (const Interval& range : ranges) {
    const double first = std::ceil(((Interval(x.inf()) - Interval(range.sup())) / period).inf());
    const double last = std::floor(((Interval(x.sup()) - Interval(range.inf())) / period).sup());
    lower = (std::min)(lower, (Interval(range.inf()) + Interval(first) * period).inf());
    upper = (std::max)(upper, (Interval(range.sup()) + Interval(last) * period).sup());
  }
  return lower <= upper && restrict_to(x, lower, upper);
}

// The inverse of a function that increases up to a value that it does not reach.
inline Interval increasing_inverse(const Operation& inverse, const Interval& values, double least, double most)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return Interval(values.inf() > least ? value_at(inverse, values.inf()).inf() : -infinity,
                  values.sup() < most ? value_at(inverse, values.sup()).sup() : infinity);
}

inline bool narrow_reciprocal(Interval& x, const Interval& values)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Operation reciprocal{Elementary_function::RECIPROCAL};
  if (values.inf() == 0 && values.sup() == 0)
    return false;
  if (values.inf() >= 0 || values.sup() <= 0)
    return narrow_to(x, range_of_values(reciprocal, values));
  return narrow_to_either(x, Interval(-infinity, value_at(reciprocal, values.inf()).sup()),
                          Interval(value_at(reciprocal, values.sup()).inf(), infinity));
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool narrow_argument(const Operation& operation, const Interval& values, Interval& x)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Interval half_turn = pi(), turn = Interval(2) * half_turn;
  const double quarter = 0.5 * half_turn.sup();
  Interval y = values;
  if (std::isnan(y.inf()) || std::isnan(y.sup()))
    return restrict_to_domain(operation, x);
  switch (operation.function) {
  case Elementary_function::RECIPROCAL:
    return restrict_to_domain(operation, x) && narrow_reciprocal(x, y);
  case Elementary_function::SQUARE_ROOT:
    return restrict_to(y, 0, infinity) && narrow_to(x, std::isinf(y.sup()) ? Interval(0, infinity) : CGAL::square(y));
  case Elementary_function::POWER:
    return restrict_to_domain(operation, x) && restrict_to(y, 0, infinity) &&
        (operation.exponent.inf() <= 0 && operation.exponent.sup() >= 0
             ? true
             : narrow_to(x, range_of_values({Elementary_function::POWER, Interval(1) / operation.exponent}, y)));
  case Elementary_function::EXPONENTIAL:
    return y.sup() > 0 && narrow_to(x, increasing_inverse({Elementary_function::LOGARITHM}, y, 0, infinity));
  case Elementary_function::LOGARITHM:
    return restrict_to_domain(operation, x) && narrow_to(x, range_of_values({Elementary_function::EXPONENTIAL}, y));
  case Elementary_function::SINE: {
    if (!restrict_to(y, -1, 1))
      return false;
    const Interval angles = range_of_values({Elementary_function::ARC_SINE}, y);
    return narrow_periodically(x, turn, {angles, half_turn - angles});
  }
  case Elementary_function::COSINE: {
    if (!restrict_to(y, -1, 1))
      return false;
    const Interval angles = range_of_values({Elementary_function::ARC_COSINE}, y);
    return narrow_periodically(x, turn, {angles, -angles});
  }
  case Elementary_function::TANGENT:
    return narrow_periodically(x, half_turn, {range_of_values({Elementary_function::ARC_TANGENT}, y)});
  case Elementary_function::ARC_SINE:
    return restrict_to_domain(operation, x) && restrict_to(y, -quarter, quarter) &&
        narrow_to(x, range_of_values({Elementary_function::SINE}, y));
  case Elementary_function::ARC_COSINE:
    return restrict_to_domain(operation, x) && restrict_to(y, 0, half_turn.sup()) &&
        narrow_to(x, range_of_values({Elementary_function::COSINE}, y));
  case Elementary_function::ARC_TANGENT:
    return restrict_to(y, -quarter, quarter) &&
        narrow_to(x,
                  increasing_inverse({Elementary_function::TANGENT}, y, -0.5 * half_turn.inf(), 0.5 * half_turn.inf()));
  case Elementary_function::HYPERBOLIC_SINE:
    return narrow_to(x, Interval(value_by_mpfr(mpfr_asinh, y.inf()).inf(), value_by_mpfr(mpfr_asinh, y.sup()).sup()));
  case Elementary_function::HYPERBOLIC_COSINE: {
    if (!restrict_to(y, 1, infinity))
      return false;
    const Interval size(value_by_mpfr(mpfr_acosh, y.inf()).inf(), value_by_mpfr(mpfr_acosh, y.sup()).sup());
    return narrow_to_either(x, size, -size);
  }
  case Elementary_function::HYPERBOLIC_TANGENT:
    return y.inf() < 1 && y.sup() > -1 &&
        narrow_to(x,
                  Interval(y.inf() > -1 ? value_by_mpfr(mpfr_atanh, y.inf()).inf() : -infinity,
                           y.sup() < 1 ? value_by_mpfr(mpfr_atanh, y.sup()).sup() : infinity));
  case Elementary_function::ABSOLUTE_VALUE:
    return restrict_to(y, 0, infinity) && narrow_to_either(x, y, -y);
  }
  return true;
}
#endif

} // namespace elementary
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_INVERSE_RANGES_H
