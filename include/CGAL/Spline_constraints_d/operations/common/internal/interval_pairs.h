// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INTERVAL_PAIRS_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INTERVAL_PAIRS_H

#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <limits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

using Interval = CGAL::Interval_nt<false>;
using Interval_pair = std::array<Interval, 2>;

// Intervals of any precision: their ends, rounded outward to doubles, decide.
template <class Number>
concept Enclosing_number = std::constructible_from<Number, double, double> && std::convertible_to<Interval, Number> &&
    requires(const Number& x)
{
  { x.inf() } -> std::same_as<double>;
  { x.sup() } -> std::same_as<double>;
  { x * x - x / x + x } -> std::convertible_to<Number>;
  { CGAL::square(x) } -> std::convertible_to<Number>;
  { CGAL::sqrt(x) } -> std::convertible_to<Number>;
};

template <Enclosing_number Number>
Number dot(const std::array<Number, 2>& a, const std::array<Number, 2>& b)
{
  return a[0] * b[0] + a[1] * b[1];
}

template <Enclosing_number Number>
Number squared_norm(const std::array<Number, 2>& a)
{
  return CGAL::square(a[0]) + CGAL::square(a[1]);
}

template <Enclosing_number Number>
std::array<Number, 2> turned_left(const std::array<Number, 2>& a)
{
  return {-a[1], a[0]};
}

template <Enclosing_number Number>
std::array<Number, 2> operator+(const std::array<Number, 2>& a, const std::array<Number, 2>& b)
{
  return {a[0] + b[0], a[1] + b[1]};
}

template <Enclosing_number Number>
std::array<Number, 2> operator-(const std::array<Number, 2>& a, const std::array<Number, 2>& b)
{
  return {a[0] - b[0], a[1] - b[1]};
}

template <Enclosing_number Number>
std::array<Number, 2> operator*(const Number& s, const std::array<Number, 2>& a)
{
  return {s * a[0], s * a[1]};
}

inline Interval hull(const Interval& a, const Interval& b)
{
  return Interval((std::min)(a.inf(), b.inf()), (std::max)(a.sup(), b.sup()));
}

// What two enclosures of the same number have in common; they always meet.
inline Interval common_part(const Interval& a, const Interval& b)
{
  return Interval((std::max)(a.inf(), b.inf()), (std::min)(a.sup(), b.sup()));
}

template <Enclosing_number Number>
std::array<Number, 2> hull(const std::array<Number, 2>& a, const std::array<Number, 2>& b)
{
  return {hull(a[0], b[0]), hull(a[1], b[1])};
}

template <Enclosing_number Number>
std::array<Number, 2> common_part(const std::array<Number, 2>& a, const std::array<Number, 2>& b)
{
  return {common_part(a[0], b[0]), common_part(a[1], b[1])};
}

template <Enclosing_number Number = Interval>
Number any_number()
{
  return Number(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
}

// The sign of all numbers of an interval, or 0 where they differ or are zero.
template <Enclosing_number Number>
int certain_sign(const Number& x)
{
  return x.inf() > 0 ? 1 : x.sup() < 0 ? -1 : 0;
}

// Enclosures in doubles.
inline const Interval& in_doubles(const Interval& x) { return x; }
inline const Interval_pair& in_doubles(const Interval_pair& a) { return a; }

template <Enclosing_number Number>
Interval in_doubles(const Number& x)
{
  return Interval(x.inf(), x.sup());
}

template <Enclosing_number Number>
Interval_pair in_doubles(const std::array<Number, 2>& a)
{
  return {in_doubles(a[0]), in_doubles(a[1])};
}

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_INTERVAL_PAIRS_H
