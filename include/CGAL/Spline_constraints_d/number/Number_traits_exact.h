// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_EXACT_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_EXACT_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Number_traits_fwd.h>
#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/Uncertain.h>
#include <CGAL/enum.h>
#include <CGAL/number_utils.h>

#include <concepts>

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

The exact rationals, whichever type `CGAL::Exact_rational` is. Nothing rounds, so nothing depends on the rounding mode
of the thread.
*/
template <std::same_as<Exact_rational> Rational>
struct Number_traits<Rational>
{
  static constexpr bool is_exact = true;
  static constexpr bool is_enclosure = false;
  static constexpr const char* name = "exact";
  static constexpr double unit_roundoff = 0;
  static constexpr double underflow_error = 0;

  using Coordinate = Exact_rational;
  using Rounding_guard = Empty_rounding_guard;

  static Exact_rational from_double(double x) { return to_rational(x); }

  static Exact_rational from_rational(const Exact_rational& x) { return x; }

  static CGAL::Interval_nt<false> enclosure(const Exact_rational& x)
  {
    return CGAL::Interval_nt<false>(to_double_interval(x));
  }

  static CGAL::Uncertain<CGAL::Sign> sign(const Exact_rational& x) { return CGAL::sign(x); }

  static void scale_by_power_of_two(Exact_rational& x, int exponent) { internal::scale_rational(x, exponent); }

  static Exact_rational half_sum(const Exact_rational& a, const Exact_rational& b)
  {
    Exact_rational sum = a + b;
    internal::scale_rational(sum, -1);
    return sum;
  }
};

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_EXACT_H
