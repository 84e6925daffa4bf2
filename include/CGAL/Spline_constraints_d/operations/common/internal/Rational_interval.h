// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_RATIONAL_INTERVAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_RATIONAL_INTERVAL_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// A closed interval with rational ends; results of operations are the exact ranges.
struct Rational_interval
{
  Exact_rational lower, upper;

  Rational_interval(Exact_rational a, Exact_rational b) : lower(std::move(a)), upper(std::move(b)) {}
  explicit Rational_interval(const std::pair<Exact_rational, Exact_rational>& range)
    : Rational_interval(range.first, range.second)
  {}
  explicit Rational_interval(const Exact_rational& value) : Rational_interval(value, value) {}
  Rational_interval() = default;

  friend Rational_interval operator+(const Rational_interval& a, const Rational_interval& b)
  {
    return {Exact_rational(a.lower + b.lower), Exact_rational(a.upper + b.upper)};
  }
  friend Rational_interval operator-(const Rational_interval& a, const Rational_interval& b)
  {
    return {Exact_rational(a.lower - b.upper), Exact_rational(a.upper - b.lower)};
  }

  friend Rational_interval operator*(const Rational_interval& a, const Rational_interval& b)
  {
    const std::array<Exact_rational, 4> products{Exact_rational(a.lower * b.lower), Exact_rational(a.lower * b.upper),
                                                 Exact_rational(a.upper * b.lower), Exact_rational(a.upper * b.upper)};
    const auto [least, greatest] = std::minmax_element(products.begin(), products.end());
    return {*least, *greatest};
  }

  //! \pre `positive.lower > 0`
  friend Rational_interval operator/(const Rational_interval& a, const Rational_interval& positive)
  {
    return a * Rational_interval(Exact_rational(1 / positive.upper), Exact_rational(1 / positive.lower));
  }

  friend Rational_interval square(const Rational_interval& a)
  {
    const Exact_rational low(a.lower * a.lower), high(a.upper * a.upper);
    const bool has_zero = a.lower <= 0 && a.upper >= 0;
    return {has_zero ? Exact_rational(0) : Exact_rational((std::min)(low, high)),
            Exact_rational((std::max)(low, high))};
  }

  friend Rational_interval hull(const Rational_interval& a, const Rational_interval& b)
  {
    return {(std::min)(a.lower, b.lower), (std::max)(a.upper, b.upper)};
  }

  //! \pre they meet
  friend Rational_interval intersection(const Rational_interval& a, const Rational_interval& b)
  {
    return {(std::max)(a.lower, b.lower), (std::min)(a.upper, b.upper)};
  }
};

// Bounds of the coordinates of a vector.
template <int d>
using Vector_bounds = std::array<Rational_interval, d>;

// Whether two boxes have no common points.
template <std::size_t d>
bool are_apart(const std::array<Rational_interval, d>& a, const std::array<Rational_interval, d>& b)
{
  for (std::size_t i = 0; i < d; ++i)
    if (a[i].upper < b[i].lower || b[i].upper < a[i].lower)
      return true;
  return false;
}

// Vectors of intervals, rational or of doubles.
template <class Interval, std::size_t d>
std::array<Interval, d> operator-(const std::array<Interval, d>& a, const std::array<Interval, d>& b)
{
  std::array<Interval, d> result;
  for (std::size_t i = 0; i < d; ++i)
    result[i] = a[i] - b[i];
  return result;
}

template <class Interval, std::size_t d>
Interval dot(const std::array<Interval, d>& a, const std::array<Interval, d>& b)
{
  Interval result = a[0] * b[0];
  for (std::size_t i = 1; i < d; ++i)
    result = result + a[i] * b[i];
  return result;
}

template <class Interval, std::size_t d>
Interval squared_norm(const std::array<Interval, d>& a)
{
  Interval result = square(a[0]);
  for (std::size_t i = 1; i < d; ++i)
    result = result + square(a[i]);
  return result;
}

inline bool has_zero(const Rational_interval& x) { return x.lower <= 0 && x.upper >= 0; }

// Whether bounds do not tell that no two vectors within them are parallel.
template <std::size_t d>
bool may_be_parallel(const Vector_bounds<d>& a, const Vector_bounds<d>& b)
{
  for (std::size_t i = 0; i < d; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (!has_zero(a[i] * b[k] - a[k] * b[i]))
        return false;
  return true;
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_RATIONAL_INTERVAL_H
