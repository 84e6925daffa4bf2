// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_RATIONAL_ROOTS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_RATIONAL_ROOTS_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <array>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The root of an integer that is a square.
std::optional<Big_integer> integer_square_root(const Big_integer& n);

// The root of a rational number that is the square of one.
std::optional<Exact_rational> rational_square_root(const Exact_rational& x);

/*
Rational numbers whose squares add up to x, where there are any, ascending: n/d is a sum of m rational squares exactly
if the integer n d is one of m integer squares, for m = 2 and 3 (Davenport and Cassels). These are searched for in
order, up to a limit; `is_complete` tells whether the search says something about all numbers.
*/
template <int number_of_squares>
struct Sum_of_squares
{
  std::optional<std::array<Exact_rational, number_of_squares>> roots;
  bool is_complete;
};

// The least integer a >= 0 with a^2 <= n / 2 and n - a^2 a square, up to a limit; -1 if there is none. `is_complete`
// becomes false where the limit ends the search.
int least_of_two_squares(const Big_integer& n, int limit, bool& is_complete);

Sum_of_squares<2> sum_of_two_squares(const Exact_rational& x);

Sum_of_squares<3> sum_of_three_squares(const Exact_rational& x);

/*
Rational numbers x, y with a x^2 + 2 b x y + c y^2 = value: a rational point of a conic around the origin. It is
searched for in the directions of small integers; for multiples of x^2 + y^2 the search is that for two squares.
*/
Sum_of_squares<2> rational_point_of_form(const Exact_rational& a, const Exact_rational& b, const Exact_rational& c,
                                         const Exact_rational& value);

// A positive number near 1 / sqrt(x), of few digits unless it is the root exactly.
Exact_rational near_inverse_root(const Exact_rational& x);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Big_integer> integer_square_root(const Big_integer& n)
{
  if (n < 0 || !mpz_perfect_square_p(n.backend().data()))
    return std::nullopt;
  return Big_integer(boost::multiprecision::sqrt(n));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::optional<Exact_rational> rational_square_root(const Exact_rational& x)
{
  const Big_integer denominator = denominator_of(x);
  const std::optional<Big_integer> root = integer_square_root(Big_integer(numerator_of(x) * denominator));
  if (!root)
    return std::nullopt;
  return quotient(*root, denominator);
}

CGAL_SPLINE_CONSTRAINTS_INLINE int least_of_two_squares(const Big_integer& n, int limit, bool& is_complete)
{
  for (int a = 0; a < limit; ++a) {
    const Big_integer square = Big_integer(a) * a;
    if (square + square > n)
      return -1;
    if (integer_square_root(Big_integer(n - square)))
      return a;
  }
  is_complete = false;
  return -1;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Sum_of_squares<2> sum_of_two_squares(const Exact_rational& x)
{
  constexpr int limit = 1 << 17;
  const Big_integer denominator = denominator_of(x), n = numerator_of(x) * denominator;
  Sum_of_squares<2> result{std::nullopt, true};
  if (const int a = least_of_two_squares(n, limit, result.is_complete); a >= 0) {
    const Big_integer b = boost::multiprecision::sqrt(Big_integer(n - Big_integer(a) * a));
    result.roots = {quotient(Big_integer(a), denominator), quotient(b, denominator)};
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Sum_of_squares<3> sum_of_three_squares(const Exact_rational& x)
{
  constexpr int limit = 1 << 10;
  const Big_integer denominator = denominator_of(x), n = numerator_of(x) * denominator;
  Sum_of_squares<3> result{std::nullopt, true};
  for (int c = 0; Big_integer(c) * c <= n; ++c) {
    if (c == limit) {
      result.is_complete = false;
      break;
    }
    const Big_integer rest = n - Big_integer(c) * c;
    if (const int a = least_of_two_squares(rest, limit, result.is_complete); a >= 0) {
      const Big_integer b = boost::multiprecision::sqrt(Big_integer(rest - Big_integer(a) * a));
      result.roots = {quotient(Big_integer(c), denominator), quotient(Big_integer(a), denominator),
                      quotient(b, denominator)};
      return result;
    }
  }
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Sum_of_squares<2> rational_point_of_form(const Exact_rational& a,
                                                                        const Exact_rational& b,
                                                                        const Exact_rational& c,
                                                                        const Exact_rational& value)
{
  if (b == 0 && a == c)
    return sum_of_two_squares(Exact_rational(value / a));
  constexpr int limit = 100;
  Sum_of_squares<2> result{std::nullopt, false};
  const auto is_found_along = [&](int i, int j) {
    const Exact_rational form = a * (i * i) + b * (2 * i * j) + c * (j * j);
    if (form == 0)
      return false;
    if (const std::optional<Exact_rational> root = rational_square_root(Exact_rational(value / form)))
      result.roots = {Exact_rational(*root * i), Exact_rational(*root * j)};
    return result.roots.has_value();
  };
  for (int i = 1; i <= limit; ++i)
    for (int j = -i; j <= i; ++j)
      if (is_found_along(i, j) || is_found_along(j, i))
        return result;
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational near_inverse_root(const Exact_rational& x)
{
  if (const std::optional<Exact_rational> root = rational_square_root(x))
    return Exact_rational(Exact_rational(1) / *root);
  const double approximation = 1 / std::sqrt(to_nearest_double(x));
  if (!std::isfinite(approximation) || approximation < 0x1p-500)
    return Exact_rational(1);
  return simplest_rational_between(to_rational(0.875 * approximation), to_rational(1.125 * approximation));
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_RATIONAL_ROOTS_H
