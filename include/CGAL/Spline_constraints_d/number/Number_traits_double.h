// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_DOUBLE_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_DOUBLE_H

#include <CGAL/Spline_constraints_d/number/Number_traits_fwd.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

#include <cmath>
#include <limits>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

Plain doubles. A value says nothing about its own error: the function layer keeps one bound per tensor, made from
`unit_roundoff` (and
`underflow_error`), which hold in every rounding mode as long as nothing overflows. Overflow cannot be told from the
results alone: rounding toward zero
leaves the largest finite double behind, and so do upward rounding for negative and downward rounding for positive
numbers. Whoever keeps the bound has
to keep the magnitudes away from there.
*/
template <>
struct Number_traits<double>
{
  static constexpr bool is_exact = false;
  static constexpr bool is_enclosure = false;
  static constexpr const char* name = "double";
  static constexpr double unit_roundoff = 0x1p-52;
  static constexpr double underflow_error = 0x1p-1074;

  using Coordinate = double;
  using Rounding_guard = Empty_rounding_guard;

  static double from_double(double x)
  {
    internal::require_finite(x);
    return x;
  }

  static double from_rational(const Exact_rational& x) { return to_nearest_double(x); }

  static CGAL::Interval_nt<false> enclosure(double x)
  {
    // What an overflow left behind stands for a number that can be anywhere. Depending on the rounding mode that is
    // an infinite double
    // or the largest finite one.
    return std::abs(x) < (std::numeric_limits<double>::max)() ? CGAL::Interval_nt<false>(x, x)
                                                              : CGAL::Interval_nt<false>::largest();
  }

  static CGAL::Uncertain<CGAL::Sign> sign(double x)
  {
    if (x > 0)
      return CGAL::POSITIVE;
    if (x < 0)
      return CGAL::NEGATIVE;
    if (x == 0)
      return CGAL::ZERO;
    return CGAL::Uncertain<CGAL::Sign>::indeterminate();
  }

  static void scale_by_power_of_two(double& x, int exponent)
  {
    internal::for_each_double_factor(exponent, internal::double_scaling_limit, [&x](double factor) { x *= factor; });
  }

  static double half_sum(double a, double b) { return (a + b) * 0.5; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_DOUBLE_H
