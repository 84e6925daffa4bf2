// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_FWD_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_FWD_H

namespace CGAL {
namespace Spline_constraints {

/*!
\ingroup PkgSplineConstraintsDNumbers

What the solver asks of a number type beyond its operators. There are specialisations for `double`,
`CGAL::Interval_nt<false>`,
`Mpfr_interval` and `Exact_rational`; a user's own number type becomes a model of `SplineNumberType` by a
specialisation with these members.

\tparam NT a model of `SplineNumberType`
*/
#ifdef DOXYGEN_RUNNING
template <typename NT>
struct Number_traits
{
  //! whether the operations make no error at all.
  static constexpr bool is_exact;

  //! whether a value is an interval that contains the number it stands for.
  static constexpr bool is_enclosure;

  //! what answers call this number type: "double", "interval", "multiprecision", "exact".
  static constexpr const char* name;

  //! a bound on the relative error of one operation in any rounding mode, barring overflow and underflow; 0 for exact
  //! types and enclosures.
  static constexpr double unit_roundoff;

  //! a bound on the absolute error that underflow adds to one product, quotient or scaling (sums have none); 0 for
  //! exact types and enclosures.
  static constexpr double underflow_error;

  //! the type of the coordinates of boxes: `double`, or `Exact_rational` for number types that are to go on where
  //! doubles end.
  using Coordinate = unspecified_type;

  //! sets up what the operations need of the thread, for its lifetime; default constructible. All functions below
  //! work with or without it, unless noted.
  using Rounding_guard = unspecified_type;

  //! the number `x`, exactly. \throws Invalid_input if `x` is infinite or NaN.
  static NT from_double(double x);

  //! the number `x`: exactly, or as the tightest enclosure, or as a double next to it (infinite if it is beyond all
  //! of them).
  static NT from_rational(const Exact_rational& x);

  //! an interval that contains `x`, infinite where doubles end; for a `double` that is infinite, the largest in
  //! absolute value
  //! (which overflow leaves behind in some rounding modes) or NaN, the entire line.
  static CGAL::Interval_nt<false> enclosure(const NT& x);

  //! the sign of `x` as far as it is certain, of `double` the sign of the double itself; of NaN indeterminate.
  static CGAL::Uncertain<CGAL::Sign> sign(const NT& x);

  //! `x` \f$ \gets 2^e x\f$, `e` = `exponent`, without error where doubles do not underflow or overflow. Enclosures
  //! need their guard.
  static void scale_by_power_of_two(NT& x, int exponent);

  //! \f$ (a + b) / 2 \f$, with the error of one addition. Enclosures need their guard.
  static NT half_sum(const NT& a, const NT& b);
};
#else
template <typename NT>
struct Number_traits;
#endif

} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_NUMBER_TRAITS_FWD_H
