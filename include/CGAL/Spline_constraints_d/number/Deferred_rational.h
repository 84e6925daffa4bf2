// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_NUMBER_DEFERRED_RATIONAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_NUMBER_DEFERRED_RATIONAL_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
A rational number that a few doubles define: their sum, or the number at a fraction of the way between two. It is made
when somebody asks for it; compared and rounded without being made, where doubles decide, in every rounding mode.
Nothing is kept of what was made, so that threads may share it.
*/
class Deferred_rational
{
  using Sum = std::array<double, 3>;
  struct Between
  {
    double begin, end, numerator, denominator;
  };

  std::variant<Sum, Between, Exact_rational> m_number;

  static constexpr double relative_error = 0x1p-49; // of a few sums, by the magnitudes of the terms

  explicit Deferred_rational(const Sum& terms) : m_number(terms) {}
  explicit Deferred_rational(const Between& between) : m_number(between) {}

public:
  Deferred_rational() : Deferred_rational(0.0) {}
  explicit Deferred_rational(double x) : Deferred_rational(Sum{x, 0, 0}) {}
  explicit Deferred_rational(Exact_rational x) : m_number(std::move(x)) {}

  // The doubles have to be finite.
  static Deferred_rational sum(double a, double b, double c) { return Deferred_rational(Sum{a, b, c}); }

  // begin + numerator / denominator (end - begin)
  static Deferred_rational between(double begin, double end, double numerator, double denominator)
  {
    if (denominator != 1)
      return Deferred_rational(Between{begin, end, numerator, denominator});
    if (numerator == 0 || numerator == 1)
      return Deferred_rational(numerator == 0 ? begin : end);
    return begin == 0 && end == 1 ? Deferred_rational(numerator)
                                  : Deferred_rational(Between{begin, end, numerator, denominator});
  }

  Exact_rational exact() const
  {
    if (const Sum* terms = std::get_if<Sum>(&m_number)) {
      Exact_rational result = to_rational((*terms)[0]);
      for (const double term : {(*terms)[1], (*terms)[2]})
        if (term != 0)
          result += to_rational(term);
      return result;
    }
    if (const Between* x = std::get_if<Between>(&m_number)) {
      const Exact_rational begin = to_rational(x->begin), numerator = to_rational(x->numerator);
      const Exact_rational place =
          x->denominator == 1 ? numerator : Exact_rational(numerator / to_rational(x->denominator));
      return Exact_rational(begin + place * (to_rational(x->end) - begin));
    }
    return std::get<Exact_rational>(m_number);
  }

  // As `to_double_interval()` of the exact number.
  std::pair<double, double> double_interval() const
  {
    const std::optional<std::pair<double, double>> found = interval_of_sum();
    return found ? *found : to_double_interval(exact());
  }

  // As `to_nearest_double()` of the exact number.
  double nearest() const
  {
    const Sum* terms = std::get_if<Sum>(&m_number);
    return terms != nullptr && (*terms)[1] == 0 && (*terms)[2] == 0 ? (*terms)[0] + 0.0 : to_nearest_double(exact());
  }

  friend bool operator<(const Deferred_rational& a, const Deferred_rational& b)
  {
    const Sum *x = std::get_if<Sum>(&a.m_number), *y = std::get_if<Sum>(&b.m_number);
    if (x != nullptr && y != nullptr) {
      Sum difference;
      for (int i = 0; i < 3; ++i)
        difference[i] = (*x)[i] - (*y)[i];
      if (difference == Sum{})
        return false;
      const double value = difference[0] + difference[1] + difference[2];
      if (std::abs(value) > relative_error * magnitude(difference))
        return value < 0;
    }
    return a.exact() < b.exact();
  }

private:
  static double magnitude(const Sum& terms) { return std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]); }

  // With the rest behind the sum in doubles, if its sign and that it is less than a digit are certain.
  std::optional<std::pair<double, double>> interval_of_sum() const
  {
    const Sum* terms = std::get_if<Sum>(&m_number);
    if (terms == nullptr)
      return std::nullopt;
    const double sum = (*terms)[0] + ((*terms)[1] + (*terms)[2]);
    if (!(std::abs((*terms)[0] - sum) <= std::abs(sum) / 4)) // otherwise the difference is exact
      return std::nullopt;
    const Sum parts{(*terms)[0] - sum, (*terms)[1], (*terms)[2]};
    if (parts == Sum{})
      return std::pair(sum, sum);
    const double rest = parts[0] + parts[1] + parts[2], error = relative_error * magnitude(parts),
                 neighbour = rest > 0 ? next_above(sum) : next_below(sum);
    if (!(std::abs(rest) > error && std::abs(neighbour - sum) - std::abs(rest) > error))
      return std::nullopt;
    return rest > 0 ? std::pair(sum, neighbour) : std::pair(neighbour, sum);
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_NUMBER_DEFERRED_RATIONAL_H
