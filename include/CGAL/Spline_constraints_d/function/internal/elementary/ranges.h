// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_RANGES_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_RANGES_H

#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/point_values.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace elementary {

// Cuts off numbers where a function is not defined; false when nothing is left.
bool restrict_to_domain(const Operation& operation, Interval& x);

// Encloses the values on the part of a range where the function is defined; `restrict_to_domain` leaves some.
Interval range_of_values(const Operation& operation, const Interval& x);

// Encloses the derivative on a range, whose values lie in `values`; the entire line where it is not certain to exist.
Interval range_of_derivative(const Operation& operation, const Interval& x, const Interval& values);

// 1 or -1 where a function is certain to be convex or concave on a range, whose values lie in `values`; 0 elsewhere.
int convexity(const Operation& operation, const Interval& x, const Interval& values);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
inline bool restrict_to(Interval& x, double lower, double upper)
{
  if (x.sup() < lower || x.inf() > upper)
    return false;
  x = Interval((std::max)(x.inf(), lower), (std::min)(x.sup(), upper));
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool restrict_to_domain(const Operation& operation, Interval& x)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (operation.function) {
  case Elementary_function::RECIPROCAL:
    return x.inf() != 0 || x.sup() != 0;
  case Elementary_function::SQUARE_ROOT:
    return restrict_to(x, 0, infinity);
  case Elementary_function::POWER:
    return restrict_to(x, 0, infinity) && (operation.exponent.inf() > 0 || x.sup() > 0);
  case Elementary_function::LOGARITHM:
    return restrict_to(x, 0, infinity) && x.sup() > 0;
  case Elementary_function::ARC_SINE:
  case Elementary_function::ARC_COSINE:
    return restrict_to(x, -1, 1);
  default:
    return true;
  }
}

inline Interval increasing(const Operation& operation, const Interval& x)
{
  const Interval lower = value_at(operation, x.inf());
  return x.inf() == x.sup() ? lower : Interval(lower.inf(), value_at(operation, x.sup()).sup());
}

inline Interval decreasing(const Operation& operation, const Interval& x)
{
  const Interval upper = value_at(operation, x.inf());
  return x.inf() == x.sup() ? upper : Interval(value_at(operation, x.sup()).inf(), upper.sup());
}

// Of a function that decreases up to 0 and increases from there.
inline Interval range_of_even(const Operation& operation, const Interval& x)
{
  if (x.inf() >= 0)
    return increasing(operation, x);
  if (x.sup() <= 0)
    return decreasing(operation, x);
  return Interval(value_at(operation, 0).inf(),
                  (std::max)(value_at(operation, x.inf()).sup(), value_at(operation, x.sup()).sup()));
}

// Whether a range may hold an integer, when it encloses one of numbers.
inline bool may_have_integer(const Interval& x) { return std::ceil(x.inf()) <= std::floor(x.sup()); }

// Of the sine, if it is largest a quarter of a turn after the multiples of a turn, or of the cosine.
inline Interval range_of_wave(const Operation& operation, const Interval& x, double quarters_at_maximum)
{
  constexpr double largest = 0x1p40; // beyond, multiples of pi are not known well
  if (!(x.inf() > -largest && x.sup() < largest))
    return Interval(-1, 1);
  const Interval ends = hull(value_at(operation, x.inf()), value_at(operation, x.sup()));
  if (x.inf() == x.sup())
    return ends;
  const Interval turns = x / (Interval(2) * pi()) - Interval(0.25 * quarters_at_maximum);
  return Interval(may_have_integer(turns - Interval(0.5)) ? -1 : (std::max)(ends.inf(), -1.0),
                  may_have_integer(turns) ? 1 : (std::min)(ends.sup(), 1.0));
}

CGAL_SPLINE_CONSTRAINTS_INLINE Interval range_of_values(const Operation& operation, const Interval& argument)
{
  Interval x = argument;
  if (std::isnan(x.inf()) || std::isnan(x.sup()) || !restrict_to_domain(operation, x))
    return entire_line();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (operation.function) {
  case Elementary_function::RECIPROCAL:
    if (x.inf() > 0 || x.sup() < 0)
      return decreasing(operation, x);
    return x.inf() == 0 ? Interval(value_at(operation, x.sup()).inf(), infinity)
        : x.sup() == 0  ? Interval(-infinity, value_at(operation, x.inf()).sup())
                        : entire_line();
  case Elementary_function::POWER:
    if (operation.exponent.inf() > 0)
      return increasing(operation, x);
    if (operation.exponent.sup() < 0)
      return x.inf() > 0 ? decreasing(operation, x) : Interval(value_at(operation, x.sup()).inf(), infinity);
    return entire_line();
  case Elementary_function::LOGARITHM:
    return x.inf() > 0 ? increasing(operation, x) : Interval(-infinity, value_at(operation, x.sup()).sup());
  case Elementary_function::SINE:
    return range_of_wave(operation, x, 1);
  case Elementary_function::COSINE:
    return range_of_wave(operation, x, 0);
  case Elementary_function::TANGENT:
    return is_in_domain(operation, x) ? increasing(operation, x) : entire_line();
  case Elementary_function::ARC_COSINE:
    return decreasing(operation, x);
  case Elementary_function::HYPERBOLIC_COSINE:
  case Elementary_function::ABSOLUTE_VALUE:
    return range_of_even(operation, x);
  default:
    return increasing(operation, x);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Interval range_of_derivative(const Operation& operation, const Interval& x,
                                                            const Interval& values)
{
  if (!is_in_domain(operation, x, true))
    return entire_line();
  const Interval one(1);
  switch (operation.function) {
  case Elementary_function::RECIPROCAL:
    return -CGAL::square(values);
  case Elementary_function::POWER:
    return operation.exponent * range_of_values({Elementary_function::POWER, operation.exponent - one}, x);
  case Elementary_function::SQUARE_ROOT:
    return one / (Interval(2) * values);
  case Elementary_function::EXPONENTIAL:
    return values;
  case Elementary_function::LOGARITHM:
    return one / x;
  case Elementary_function::SINE:
    return range_of_values({Elementary_function::COSINE}, x);
  case Elementary_function::COSINE:
    return -range_of_values({Elementary_function::SINE}, x);
  case Elementary_function::TANGENT:
    return one + CGAL::square(values);
  case Elementary_function::ARC_SINE:
    return one / CGAL::sqrt(one - CGAL::square(x));
  case Elementary_function::ARC_COSINE:
    return -(one / CGAL::sqrt(one - CGAL::square(x)));
  case Elementary_function::ARC_TANGENT:
    return one / (one + CGAL::square(x));
  case Elementary_function::HYPERBOLIC_SINE:
    return range_of_values({Elementary_function::HYPERBOLIC_COSINE}, x);
  case Elementary_function::HYPERBOLIC_COSINE:
    return range_of_values({Elementary_function::HYPERBOLIC_SINE}, x);
  case Elementary_function::HYPERBOLIC_TANGENT:
    return one - CGAL::square(values);
  case Elementary_function::ABSOLUTE_VALUE: // of all differences
    return x.inf() > 0 ? one : x.sup() < 0 ? -one : Interval(-1, 1);
  }
  return entire_line();
}

// 1 and -1 where all numbers are positive or negative.
inline int common_sign(const Interval& x) { return x.inf() >= 0 ? 1 : x.sup() <= 0 ? -1 : 0; }

CGAL_SPLINE_CONSTRAINTS_INLINE int convexity(const Operation& operation, const Interval& x, const Interval& values)
{
  if (!is_in_domain(operation, x))
    return 0;
  switch (operation.function) {
  case Elementary_function::POWER:
    return operation.exponent.inf() >= 1 || operation.exponent.sup() <= 0 ? 1
        : operation.exponent.inf() >= 0 && operation.exponent.sup() <= 1  ? -1
                                                                          : 0;
  case Elementary_function::EXPONENTIAL:
  case Elementary_function::HYPERBOLIC_COSINE:
  case Elementary_function::ABSOLUTE_VALUE:
    return 1;
  case Elementary_function::SQUARE_ROOT:
  case Elementary_function::LOGARITHM:
    return -1;
  case Elementary_function::SINE:
  case Elementary_function::COSINE:
    return -common_sign(values);
  case Elementary_function::TANGENT:
    return common_sign(values);
  case Elementary_function::ARC_COSINE:
  case Elementary_function::ARC_TANGENT:
  case Elementary_function::HYPERBOLIC_TANGENT:
    return -common_sign(x);
  default:
    return common_sign(x);
  }
}
#endif

} // namespace elementary
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_RANGES_H
