// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_BERNSTEIN_INTERVAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_BERNSTEIN_INTERVAL_H

#include <CGAL/Spline_constraints_d/function/internal/Integer_polynomial.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A node of the subdivision in one unknown: an interval with the Bernstein coefficients of a polynomial times 2^-scale, in
double, and a bound on their errors. The signs at the ends are exact and not zero.
*/
struct Bernstein_interval
{
  double lower = 0, upper = 0;
  int lower_sign = 0, upper_sign = 0;
  std::vector<double> values;
  double error = 0;
  long scale = 0;
  int cuts = 0; // since the values were computed from the integers

  // Computes the values anew. The largest lies in [1/4, 1]; truncation, a rounded denominator and a division are 3 x
  // 2^-52, and 2^-1000 covers what underflows.
  void rebuild(const Integer_polynomial& polynomial)
  {
    const auto exact = polynomial.bernstein(lower, upper);
    long most = 0;
    for (const Big_integer& value : exact.values)
      most = (std::max)(most, bit_length(value));
    const long shift = -most - 1, denominator_shift = -bit_length(polynomial.denominator());
    const double denominator = to_scaled_double(polynomial.denominator(), denominator_shift);
    scale = exact.exponent + denominator_shift - shift;
    values.resize(exact.values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = to_scaled_double(exact.values[i], shift) / denominator;
    error = 0x1p-50 * largest() + 0x1p-1000;
    cuts = 0;
  }

  double largest() const
  {
    double result = 0;
    for (double value : values)
      result = (std::max)(result, std::abs(value));
    return result;
  }

  // The largest number of sign variations that the exact coefficients can have: each that is not certain may have
  // either sign.
  int most_variations() const { return variations(error); }

  // That of the coefficients as they are.
  int apparent_variations() const { return variations(0); }

  // Becomes the part above a point and gives the one below, except the sign at the point. A cut enlarges the error as
  // proved in the manual ("Doubles with an Error Bound").
  void split(double at, Bernstein_interval& below)
  {
    const std::size_t d = values.size() - 1;
    below.lower = lower;
    below.upper = at;
    below.lower_sign = lower_sign;
    below.scale = scale;
    below.values.resize(values.size());
    error += 10 * static_cast<double>(d) * 0x1p-52 * (largest() + 2 * error);
    const double t = place_of(at), s = 1 - t;
    below.values[0] = values[0];
    for (std::size_t r = 1; r <= d; ++r) {
      for (std::size_t k = 0; k + r <= d; ++k)
        values[k] = s * values[k] + t * values[k + 1];
      below.values[r] = values[0];
    }
    lower = at;
    below.error = error;
    below.cuts = ++cuts;
  }

  // A point of the interval in units of its width.
  double place_of(double x) const
  {
    const double width = upper - lower;
    return std::isfinite(width) ? (x - lower) / width : (x / 2 - lower / 2) / (upper / 2 - lower / 2);
  }

  double point_at(double t) const
  {
    return std::isfinite(upper - lower) ? lower + t * (upper - lower) : (1 - t) * lower + t * upper;
  }

  // Where the control polygon leaves the sign of the lower end.
  double crossing_of_polygon() const
  {
    const std::size_t d = values.size() - 1;
    for (std::size_t k = 1; k <= d; ++k)
      if (values[k] * lower_sign < 0)
        return (static_cast<double>(k - 1) + values[k - 1] / (values[k - 1] - values[k])) / static_cast<double>(d);
    return 0.5;
  }

  // The value and the derivative by t, nearly. \pre degree at least 1
  std::pair<double, double> value_and_slope(double t, std::vector<double>& work) const
  {
    work = values;
    const std::size_t d = values.size() - 1;
    for (std::size_t r = 1; r < d; ++r)
      for (std::size_t k = 0; k + r <= d; ++k)
        work[k] = (1 - t) * work[k] + t * work[k + 1];
    return {(1 - t) * work[0] + t * work[1], static_cast<double>(d) * (work[1] - work[0])};
  }

private:
  int variations(double tolerance) const
  {
    // The most variations up to here if the last sign is plus, and if it is minus.
    constexpr int impossible = (std::numeric_limits<int>::min)() / 2;
    int plus = lower_sign > 0 ? 0 : impossible, minus = lower_sign > 0 ? impossible : 0;
    for (std::size_t k = 1; k + 1 < values.size(); ++k) {
      const int to_plus = (std::max)(plus, minus + 1), to_minus = (std::max)(minus, plus + 1);
      if (values[k] > tolerance) {
        plus = to_plus;
        minus = impossible;
      } else if (values[k] < -tolerance) {
        minus = to_minus;
        plus = impossible;
      } else if (tolerance > 0) {
        plus = to_plus;
        minus = to_minus;
      }
    }
    return upper_sign > 0 ? (std::max)(plus, minus + 1) : (std::max)(minus, plus + 1);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_BERNSTEIN_INTERVAL_H
