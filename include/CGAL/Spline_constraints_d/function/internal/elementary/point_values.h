// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_POINT_VALUES_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_POINT_VALUES_H

#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/function/internal/elementary/series.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_number.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/Interval_nt.h>

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace elementary {

// A function, with the exponent that a power has.
struct Operation
{
  Elementary_function function = Elementary_function::ABSOLUTE_VALUE;
  Interval exponent = Interval(1);
};

inline Interval entire_line()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return Interval(-infinity, infinity);
}

// A double, also an infinite one.
inline Interval point(double x) { return Interval(x, x); }

inline Interval hull(const Interval& a, const Interval& b)
{
  return Interval((std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup()));
}

// Whether it is certain that numbers lie where a function is defined, up to the ends of where it is, or inside.
bool is_in_domain(const Operation& operation, const Interval& x, bool is_inside = false);

// The value at a double in the domain, which may be infinite where there is a limit: by its series, or by one operation
// of MPFR, whose result is one of the two doubles around the value.
Interval value_at(const Operation& operation, double x);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE bool is_in_domain(const Operation& operation, const Interval& x, bool is_inside)
{
  switch (operation.function) {
  case Elementary_function::RECIPROCAL:
    return x.inf() > 0 || x.sup() < 0;
  case Elementary_function::SQUARE_ROOT:
    return is_inside ? x.inf() > 0 : x.inf() >= 0;
  case Elementary_function::POWER:
    return is_inside || operation.exponent.inf() <= 0 ? x.inf() > 0 : x.inf() >= 0;
  case Elementary_function::LOGARITHM:
    return x.inf() > 0;
  case Elementary_function::ARC_SINE:
  case Elementary_function::ARC_COSINE:
    return is_inside ? x.inf() > -1 && x.sup() < 1 : x.inf() >= -1 && x.sup() <= 1;
  case Elementary_function::TANGENT: {
    const Interval turns = x / pi() - Interval(0.5);
    return std::floor(turns.inf()) == std::floor(turns.sup()) && turns.inf() != std::floor(turns.inf()) &&
        std::abs(turns.inf()) < 0x1p40;
  }
  default:
    return !std::isnan(x.inf()) && !std::isnan(x.sup());
  }
}

// The two doubles around a result of MPFR that was rounded down, or to nothing else when it is exact.
inline Interval around(mpfr_srcptr rounded_down, bool is_exact)
{
  const double upper = mpfr_get_d(rounded_down, MPFR_RNDU);
  return Interval(mpfr_get_d(rounded_down, MPFR_RNDD), is_exact ? upper : next_above(upper));
}

inline Interval value_by_mpfr(int (*function)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t), double x)
{
  constexpr mpfr_prec_t bits = std::numeric_limits<double>::digits;
  Mpfr_number argument(bits), result(bits);
  mpfr_set_d(argument.get(), x, MPFR_RNDN);
  const int error = function(result.get(), argument.get(), MPFR_RNDD);
  return mpfr_nan_p(result.get()) != 0 ? entire_line() : around(result.get(), error == 0);
}

inline Interval power_by_mpfr(double x, double exponent)
{
  constexpr mpfr_prec_t bits = std::numeric_limits<double>::digits;
  Mpfr_number base(bits), power(bits), result(bits);
  mpfr_set_d(base.get(), x, MPFR_RNDN);
  mpfr_set_d(power.get(), exponent, MPFR_RNDN);
  const int error = mpfr_pow(result.get(), base.get(), power.get(), MPFR_RNDD);
  return mpfr_nan_p(result.get()) != 0 ? entire_line() : around(result.get(), error == 0);
}

inline std::optional<Interval> value_by_series(Elementary_function function, double x)
{
  switch (function) {
  case Elementary_function::EXPONENTIAL:
    return exponential_by_series(x);
  case Elementary_function::LOGARITHM:
    return logarithm_by_series(x);
  case Elementary_function::SINE:
    return wave_by_series(x, 0);
  case Elementary_function::COSINE:
    return wave_by_series(x, 1);
  case Elementary_function::TANGENT: {
    const auto sine = wave_by_series(x, 0), cosine = wave_by_series(x, 1);
    return sine && cosine && (cosine->inf() > 0 || cosine->sup() < 0) ? std::optional<Interval>(*sine / *cosine)
                                                                      : std::nullopt;
  }
  case Elementary_function::ARC_SINE:
    return arc_sine_by_series(x);
  case Elementary_function::ARC_COSINE:
    if (const auto complement = arc_sine_by_series(x))
      return pi() / Interval(2) - *complement;
    return std::nullopt;
  case Elementary_function::ARC_TANGENT:
    return std::isinf(x) ? std::nullopt : std::optional<Interval>(arc_tangent_by_series(Interval(x)));
  default:
    return std::nullopt;
  }
}

// Values that are 0 or 1 exactly stay so.
CGAL_SPLINE_CONSTRAINTS_INLINE Interval value_at(const Operation& operation, double x)
{
  if (std::isnan(x))
    return entire_line();
  if (const auto known = value_by_series(operation.function, x))
    return *known;
  switch (operation.function) {
  case Elementary_function::RECIPROCAL:
    return x == 0 ? entire_line() : std::isinf(x) ? Interval(0) : Interval(1) / Interval(x);
  case Elementary_function::POWER:
    return operation.exponent.is_point()
        ? power_by_mpfr(x, operation.exponent.inf())
        : hull(power_by_mpfr(x, operation.exponent.inf()), power_by_mpfr(x, operation.exponent.sup()));
  case Elementary_function::SQUARE_ROOT:
    return std::isinf(x) ? point(x) : CGAL::sqrt(Interval(x));
  case Elementary_function::EXPONENTIAL:
    return value_by_mpfr(mpfr_exp, x);
  case Elementary_function::LOGARITHM:
    return value_by_mpfr(mpfr_log, x);
  case Elementary_function::SINE:
    return value_by_mpfr(mpfr_sin, x);
  case Elementary_function::COSINE:
    return value_by_mpfr(mpfr_cos, x);
  case Elementary_function::TANGENT:
    return value_by_mpfr(mpfr_tan, x);
  case Elementary_function::ARC_SINE:
    return value_by_mpfr(mpfr_asin, x);
  case Elementary_function::ARC_COSINE:
    return value_by_mpfr(mpfr_acos, x);
  case Elementary_function::ARC_TANGENT:
    return value_by_mpfr(mpfr_atan, x);
  case Elementary_function::HYPERBOLIC_SINE:
    return value_by_mpfr(mpfr_sinh, x);
  case Elementary_function::HYPERBOLIC_COSINE:
    return value_by_mpfr(mpfr_cosh, x);
  case Elementary_function::HYPERBOLIC_TANGENT:
    return value_by_mpfr(mpfr_tanh, x);
  case Elementary_function::ABSOLUTE_VALUE:
    return point(std::abs(x));
  }
  return entire_line();
}
#endif

} // namespace elementary
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_ELEMENTARY_POINT_VALUES_H
