// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_INTERVAL_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_INTERVAL_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Interval = CGAL::Interval_nt<false>; // within an Upward_rounding_guard
using Interval_box = std::array<Interval, 3>;

inline Interval interval_of(const Exact_rational& x)
{
  const auto [lower, upper] = to_double_interval(x);
  return {lower, upper};
}

inline bool contains_zero(const Interval& x) { return x.inf() <= 0 && 0 <= x.sup(); }
inline double middle_of(const Interval& x) { return 0.5 * x.inf() + 0.5 * x.sup(); }

// A polynomial in three unknowns that is bounded on boxes, together with its gradient.
class Interval_polynomial
{
  struct Term
  {
    Interval coefficient;
    std::array<int, 3> exponents;
  };
  std::vector<Term> m_terms;
  std::array<std::size_t, 3> m_first{}; // power of an unknown among those of all
  std::size_t m_powers = 0;

public:
  struct Value
  {
    Interval value = Interval(0);
    Interval_box gradient = {Interval(0), Interval(0), Interval(0)};
  };

  explicit Interval_polynomial(const Power_polynomial& polynomial)
  {
    for (const auto& [monomial, coefficient] : polynomial.terms())
      m_terms.push_back({interval_of(coefficient), {monomial.exponent(0), monomial.exponent(1), monomial.exponent(2)}});
    for (std::size_t j = 0; j < 3; ++j) {
      m_first[j] = m_powers;
      m_powers += static_cast<std::size_t>(polynomial.degree(static_cast<int>(j))) + 1;
    }
  }

  // The value is bounded by that of all terms, and by that in the middle with the gradient.
  Value operator()(const Interval_box& box) const
  {
    Value result = of_terms(box);
    Interval_box middle;
    for (std::size_t j = 0; j < 3; ++j)
      middle[j] = Interval(middle_of(box[j]));
    Interval sum = of_terms(middle).value;
    for (std::size_t j = 0; j < 3; ++j)
      sum += result.gradient[j] * (box[j] - middle[j]);
    result.value = Interval((std::max)(sum.inf(), result.value.inf()), (std::min)(sum.sup(), result.value.sup()));
    return result;
  }

private:
  Value of_terms(const Interval_box& box) const
  {
    std::vector<Interval> powers(m_powers, Interval(1));
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t e = 1, end = (j < 2 ? m_first[j + 1] : m_powers) - m_first[j]; e < end; ++e)
        powers[m_first[j] + e] =
            e % 2 == 0 ? CGAL::square(powers[m_first[j] + e / 2]) : powers[m_first[j] + e - 1] * box[j];
    const auto power = [&](std::size_t j, int e) { return powers[m_first[j] + static_cast<std::size_t>(e)]; };
    Value result;
    for (const auto& [c, e] : m_terms) {
      const Interval_box factors{power(0, e[0]), power(1, e[1]), power(2, e[2])};
      const Interval first = c * factors[0], rest = factors[1] * factors[2];
      result.value += first * rest;
      if (e[0] > 0)
        result.gradient[0] += c * Interval(e[0]) * power(0, e[0] - 1) * rest;
      if (e[1] > 0)
        result.gradient[1] += first * Interval(e[1]) * power(1, e[1] - 1) * factors[2];
      if (e[2] > 0)
        result.gradient[2] += first * factors[1] * Interval(e[2]) * power(2, e[2] - 1);
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_INTERVAL_POLYNOMIAL_H
