// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_MPFR_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_MPFR_H

#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_precision_scope.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_fwd.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

Intervals of MPFR numbers. Conversions get `Mpfr_interval::default_precision()`, which a `Mpfr_precision_scope` sets.
Every operation rounds
for itself, so that nothing depends on the rounding mode of the thread.
*/
template <>
struct Number_traits<Mpfr_interval>
{
  static constexpr bool is_exact = false;
  static constexpr bool is_enclosure = true;
  static constexpr const char* name = "multiprecision";
  static constexpr double unit_roundoff = 0;
  static constexpr double underflow_error = 0;

  using Coordinate = Exact_rational;
  using Rounding_guard = Empty_rounding_guard;

  static Mpfr_interval from_double(double x) { return Mpfr_interval(x); }

  static Mpfr_interval from_rational(const Exact_rational& x) { return Mpfr_interval(x); }

  static CGAL::Interval_nt<false> enclosure(const Mpfr_interval& x)
  {
    return CGAL::Interval_nt<false>(x.to_double_interval());
  }

  static CGAL::Uncertain<CGAL::Sign> sign(const Mpfr_interval& x) { return x.sign(); }

  static void scale_by_power_of_two(Mpfr_interval& x, int exponent) { x.scale_by_power_of_two(exponent); }

  static Mpfr_interval half_sum(const Mpfr_interval& a, const Mpfr_interval& b)
  {
    return Mpfr_interval::half_sum(a, b);
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_MPFR_H
