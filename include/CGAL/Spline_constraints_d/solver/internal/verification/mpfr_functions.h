// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_MPFR_FUNCTIONS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_MPFR_FUNCTIONS_H

#include <CGAL/Spline_constraints_d/function/Elementary_function.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_number.h>

#include <mpfr.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace verification {

// What a function has on a range: an enclosure of its values, and of its derivative where it has one everywhere.
struct Mpfr_function
{
  Mpfr_interval value;
  std::optional<Mpfr_interval> derivative;
};

// Nothing where it is not certain that the function is defined on all of the range. Meant for short ranges: waves are
// enclosed by their values in the middle.
std::optional<Mpfr_function> mpfr_function(Elementary_function function, const Exact_rational& exponent,
                                           const Mpfr_interval& x);

inline std::optional<Mpfr_interval> common_part(const Mpfr_interval& a, const Mpfr_interval& b)
{
  const mpfr_srcptr lower = mpfr_cmp(a.lower_mpfr(), b.lower_mpfr()) < 0 ? b.lower_mpfr() : a.lower_mpfr();
  const mpfr_srcptr upper = mpfr_cmp(a.upper_mpfr(), b.upper_mpfr()) < 0 ? a.upper_mpfr() : b.upper_mpfr();
  if (mpfr_cmp(lower, upper) > 0)
    return std::nullopt;
  return Mpfr_interval::of_ends(lower, upper);
}

// A square matrix of intervals, row-major.
struct Mpfr_matrix
{
  std::size_t size;
  std::vector<Mpfr_interval> entries;

  explicit Mpfr_matrix(std::size_t size) : size(size), entries(size * size, Mpfr_interval(0)) {}
  Mpfr_interval& operator()(std::size_t i, std::size_t j) { return entries[i * size + j]; }
  const Mpfr_interval& operator()(std::size_t i, std::size_t j) const { return entries[i * size + j]; }
};

// A matrix of numbers near the inverse of one of numbers; nothing when a pivot is zero. `check()` may end the work by
// an exception.
std::optional<Mpfr_matrix> approximate_inverse(Mpfr_matrix matrix, const std::function<void()>& check);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
using Function_of_mpfr = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

// Of a function that increases from `lower` to `upper`.
inline Mpfr_interval of_ends(Function_of_mpfr function, mpfr_srcptr lower, mpfr_srcptr upper)
{
  Mpfr_number below(mpfr_get_prec(lower)), above(mpfr_get_prec(lower));
  function(below.get(), lower, MPFR_RNDD);
  function(above.get(), upper, MPFR_RNDU);
  return Mpfr_interval::of_ends(below.get(), above.get());
}

inline Mpfr_interval increasing(Function_of_mpfr function, const Mpfr_interval& x)
{
  return of_ends(function, x.lower_mpfr(), x.upper_mpfr());
}

inline Mpfr_interval square_of(const Mpfr_interval& x)
{
  const Mpfr_interval result = x * x;
  return mpfr_sgn(result.lower_mpfr()) < 0
      ? Mpfr_interval(Exact_rational(0), Exact_rational((std::max)(Exact_rational(0), result.upper())))
      : result;
}

// Sine or cosine: |f(x) - f(m)| <= |x - m|.
inline Mpfr_interval wave(Function_of_mpfr function, const Mpfr_interval& x)
{
  const Mpfr_interval near_middle(x.midpoint());
  const mpfr_srcptr middle = near_middle.lower_mpfr();
  const Mpfr_interval offset = x - Mpfr_interval::of_ends(middle, middle);
  const Exact_rational distance = (std::max)(Exact_rational(-offset.lower()), offset.upper());
  const Mpfr_interval at_middle = of_ends(function, middle, middle), rest(Exact_rational(-distance), distance);
  const auto cut = common_part(at_middle + rest, Mpfr_interval(Exact_rational(-1), Exact_rational(1)));
  return cut ? *cut : Mpfr_interval(Exact_rational(-1), Exact_rational(1));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Mpfr_function>
mpfr_function(Elementary_function function, const Exact_rational& exponent, const Mpfr_interval& x)
{
  if (!x.is_bounded())
    return std::nullopt;
  const Mpfr_interval one(1);
  const int lower_sign = mpfr_sgn(x.lower_mpfr()), upper_sign = mpfr_sgn(x.upper_mpfr());
  const auto arc = [&](bool is_sine) -> std::optional<Mpfr_function> {
    if (x.lower() < -1 || x.upper() > 1)
      return std::nullopt;
    const Mpfr_interval value = is_sine ? increasing(mpfr_asin, x) : of_ends(mpfr_acos, x.upper_mpfr(), x.lower_mpfr());
    if (x.lower() == -1 || x.upper() == 1)
      return Mpfr_function{value, std::nullopt};
    const Mpfr_interval slope = one / increasing(mpfr_sqrt, one - square_of(x));
    return Mpfr_function{value, is_sine ? slope : -slope};
  };
  switch (function) {
  case Elementary_function::RECIPROCAL: {
    if (lower_sign <= 0 && upper_sign >= 0)
      return std::nullopt;
    const Mpfr_interval value = one / x;
    return Mpfr_function{value, -square_of(value)};
  }
  case Elementary_function::POWER: {
    if (lower_sign <= 0)
      return std::nullopt;
    const Mpfr_interval value = increasing(mpfr_exp, Mpfr_interval(exponent) * increasing(mpfr_log, x));
    return Mpfr_function{value, Mpfr_interval(exponent) * value / x};
  }
  case Elementary_function::SQUARE_ROOT: {
    if (lower_sign < 0)
      return std::nullopt;
    const Mpfr_interval value = increasing(mpfr_sqrt, x);
    if (lower_sign == 0)
      return Mpfr_function{value, std::nullopt};
    return Mpfr_function{value, one / (value + value)};
  }
  case Elementary_function::EXPONENTIAL: {
    const Mpfr_interval value = increasing(mpfr_exp, x);
    return Mpfr_function{value, value};
  }
  case Elementary_function::LOGARITHM:
    if (lower_sign <= 0)
      return std::nullopt;
    return Mpfr_function{increasing(mpfr_log, x), one / x};
  case Elementary_function::SINE:
    return Mpfr_function{wave(mpfr_sin, x), wave(mpfr_cos, x)};
  case Elementary_function::COSINE:
    return Mpfr_function{wave(mpfr_cos, x), -wave(mpfr_sin, x)};
  case Elementary_function::TANGENT: {
    const Mpfr_interval cosine = wave(mpfr_cos, x);
    if (mpfr_sgn(cosine.lower_mpfr()) <= 0 && mpfr_sgn(cosine.upper_mpfr()) >= 0)
      return std::nullopt;
    const Mpfr_interval value = wave(mpfr_sin, x) / cosine;
    return Mpfr_function{value, one + square_of(value)};
  }
  case Elementary_function::ARC_SINE:
    return arc(true);
  case Elementary_function::ARC_COSINE:
    return arc(false);
  case Elementary_function::ARC_TANGENT:
    return Mpfr_function{increasing(mpfr_atan, x), one / (one + square_of(x))};
  case Elementary_function::HYPERBOLIC_SINE:
  case Elementary_function::HYPERBOLIC_COSINE: {
    const Mpfr_interval growing = increasing(mpfr_exp, x), falling = one / growing;
    const Mpfr_interval sine = increasing(mpfr_sinh, x), cosine = Mpfr_interval::half_sum(growing, falling);
    return function == Elementary_function::HYPERBOLIC_SINE ? Mpfr_function{sine, cosine} : Mpfr_function{cosine, sine};
  }
  case Elementary_function::HYPERBOLIC_TANGENT: {
    const Mpfr_interval value = increasing(mpfr_tanh, x);
    return Mpfr_function{value, one - square_of(value)};
  }
  case Elementary_function::ABSOLUTE_VALUE:
    if (lower_sign > 0 || upper_sign < 0)
      return Mpfr_function{lower_sign > 0 ? x : -x, lower_sign > 0 ? one : -one};
    return Mpfr_function{
        Mpfr_interval(Exact_rational(0), Exact_rational((std::max)(Exact_rational(-x.lower()), x.upper()))),
        std::nullopt};
  }
  return std::nullopt;
}

// Gauss and Jordan with the largest pivot; after each operation the middle is taken.
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Mpfr_matrix> approximate_inverse(Mpfr_matrix matrix,
                                                                              const std::function<void()>& check)
{
  const std::size_t n = matrix.size;
  const Mpfr_interval zero(0);
  Mpfr_matrix inverse(n);
  for (std::size_t i = 0; i < n; ++i)
    inverse(i, i) = Mpfr_interval(1);
  const auto rounded = [](const Mpfr_interval& x) { return Mpfr_interval::of_ends(x.lower_mpfr(), x.lower_mpfr()); };
  for (std::size_t c = 0; c < n; ++c) {
    if (check)
      check();
    std::size_t pivot = c;
    for (std::size_t i = c + 1; i < n; ++i)
      if (mpfr_cmpabs(matrix(i, c).lower_mpfr(), matrix(pivot, c).lower_mpfr()) > 0)
        pivot = i;
    if (mpfr_zero_p(matrix(pivot, c).lower_mpfr()) != 0)
      return std::nullopt;
    const Mpfr_interval factor = Mpfr_interval(1) / matrix(pivot, c);
    for (Mpfr_matrix* side : {&matrix, &inverse})
      for (std::size_t k = 0; k < n; ++k) {
        (*side)(c, k).swap((*side)(pivot, k));
        if (!(*side)(c, k).is_same(zero))
          (*side)(c, k) = rounded((*side)(c, k) * factor);
      }
    for (std::size_t i = 0; i < n; ++i)
      if (const Mpfr_interval multiple = matrix(i, c); i != c && !multiple.is_same(zero))
        for (Mpfr_matrix* side : {&matrix, &inverse})
          for (std::size_t k = 0; k < n; ++k)
            if (!(*side)(c, k).is_same(zero))
              (*side)(i, k) = rounded((*side)(i, k) - multiple * (*side)(c, k));
  }
  return inverse;
}
#endif

} // namespace verification
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_VERIFICATION_MPFR_FUNCTIONS_H
