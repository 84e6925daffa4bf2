// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_DOUBLE_WORD_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_DOUBLE_WORD_H

#include <CGAL/Spline_constraints_d/number/Deferred_rational.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Unevaluated sums of two doubles, with 106 bits, and a bound of their error. The algorithms of the sum, product and
quotient have a relative error of 3, 5 and 15 times 2^-106 at most, and a little more (Joldes, Muller, Popescu 2017,
Tight and rigorous error bounds for basic building blocks of double-word arithmetic, algorithms 6, 12 and 17); here each
is counted with 32 times that. Rounding has to be to nearest.
*/
class Double_word
{
  double m_high, m_low = 0, m_error = 0;

  static constexpr double relative_error = 0x1p-101;

  // With the error of the operation, besides that of its arguments. Parts of a product may be rounded to zero.
  Double_word(double high, double low, double error)
    : m_high(high), m_low(low),
      m_error(1.0000001 * error + relative_error * std::abs(high) + 16 * (std::numeric_limits<double>::min)())
  {}

  static std::pair<double, double> sum(double a, double b)
  {
    const double s = a + b, from_b = s - a, from_a = s - from_b;
    return {s, (a - from_a) + (b - from_b)};
  }

  static std::pair<double, double> ordered_sum(double a, double b) // |a| >= |b|
  {
    const double s = a + b;
    return {s, b - (s - a)};
  }

  double magnitude() const { return std::abs(m_high) * (1 + 0x1p-50); }

public:
  explicit Double_word(double x) : m_high(x) {}
  explicit Double_word(std::int64_t x)
    : m_high(static_cast<double>(x)), m_low(static_cast<double>(x - static_cast<std::int64_t>(m_high)))
  {}

  friend Double_word operator+(const Double_word& a, const Double_word& b)
  {
    const auto [high, high_error] = sum(a.m_high, b.m_high);
    const auto [low, low_error] = sum(a.m_low, b.m_low);
    const auto [first, rest] = ordered_sum(high, high_error + low);
    const auto [result, result_low] = ordered_sum(first, low_error + rest);
    return {result, result_low, a.m_error + b.m_error};
  }
  friend Double_word operator-(const Double_word& a)
  {
    Double_word result(a);
    result.m_high = -a.m_high;
    result.m_low = -a.m_low;
    return result;
  }
  friend Double_word operator-(const Double_word& a, const Double_word& b) { return a + (-b); }
  friend Double_word operator*(const Double_word& a, const Double_word& b)
  {
    const double high = a.m_high * b.m_high, error = std::fma(a.m_high, b.m_high, -high);
    const double low = std::fma(a.m_high, b.m_low, std::fma(a.m_low, b.m_high, a.m_low * b.m_low));
    const auto [result, result_low] = ordered_sum(high, error + low);
    return {result, result_low, a.magnitude() * b.m_error + b.magnitude() * a.m_error + a.m_error * b.m_error};
  }
  friend Double_word operator/(const Double_word& a, const Double_word& b)
  {
    const double first = a.m_high / b.m_high;
    const Double_word rest = a - b * Double_word(first);
    const auto [result, result_low] = ordered_sum(first, rest.m_high / b.m_high);
    const double divisor = b.magnitude() * (1 - 0x1p-40) - b.m_error;
    return {result, result_low,
            divisor > 0 ? (a.m_error + std::abs(result) * b.m_error) * 1.0000001 / divisor
                        : std::numeric_limits<double>::infinity()};
  }

  // Bounds of the number, with a tolerance on both sides. \pre finite
  std::pair<Deferred_rational, Deferred_rational> range(double tolerance = 0) const
  {
    const double error = error_with(tolerance);
    return {Deferred_rational::sum(m_high, m_low, -error), Deferred_rational::sum(m_high, m_low, error)};
  }

  // Half the width of that range.
  double error_with(double tolerance = 0) const { return tolerance == 0 ? m_error : (m_error + tolerance) * 1.0000001; }

  bool is_finite() const { return std::isfinite(m_high) && std::isfinite(m_low) && std::isfinite(m_error); }

  // The double that is nearest to it.
  double nearest() const { return m_high; }

  // An upper bound of the absolute value.
  double greatest() const { return magnitude() + m_error; }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_DOUBLE_WORD_H
