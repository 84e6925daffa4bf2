// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_INTERVAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_INTERVAL_H

#include <CGAL/Spline_constraints_d/number/Number_traits_fwd.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

Intervals of doubles without a guard of their own: operators, `scale_by_power_of_two()` and `half_sum()` enclose while
a `Rounding_guard` is alive.
The other members do so in every rounding mode.
*/
template <>
struct Number_traits<CGAL::Interval_nt<false>>
{
  static constexpr bool is_exact = false;
  static constexpr bool is_enclosure = true;
  static constexpr const char* name = "interval";
  static constexpr double unit_roundoff = 0;
  static constexpr double underflow_error = 0;

  using Coordinate = double;
  using Rounding_guard = Upward_rounding_guard;

  static CGAL::Interval_nt<false> from_double(double x)
  {
    internal::require_finite(x);
    return CGAL::Interval_nt<false>(x, x);
  }

  static CGAL::Interval_nt<false> from_rational(const Exact_rational& x)
  {
    return CGAL::Interval_nt<false>(to_double_interval(x));
  }

  static CGAL::Interval_nt<false> enclosure(const CGAL::Interval_nt<false>& x)
  {
    // An end that is NaN bounds nothing.
    return x.inf() <= x.sup() ? x : CGAL::Interval_nt<false>::largest();
  }

  static CGAL::Uncertain<CGAL::Sign> sign(const CGAL::Interval_nt<false>& x)
  {
    if (!(x.inf() <= x.sup()))
      return CGAL::Uncertain<CGAL::Sign>::indeterminate();
    return {sign_of(x.inf()), sign_of(x.sup())};
  }

  static void scale_by_power_of_two(CGAL::Interval_nt<false>& x, int exponent)
  {
    internal::for_each_double_factor(exponent, internal::double_scaling_limit, [&x](double factor) { x = factor * x; });
  }

  static CGAL::Interval_nt<false> half_sum(const CGAL::Interval_nt<false>& a, const CGAL::Interval_nt<false>& b)
  {
    return 0.5 * (a + b); // a double factor costs a third of an interval one
  }

private:
  static CGAL::Sign sign_of(double x) { return x > 0 ? CGAL::POSITIVE : x < 0 ? CGAL::NEGATIVE : CGAL::ZERO; }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_INTERVAL_H
