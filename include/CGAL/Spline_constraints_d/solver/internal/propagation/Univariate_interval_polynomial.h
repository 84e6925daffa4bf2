// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_UNIVARIATE_INTERVAL_POLYNOMIAL_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_UNIVARIATE_INTERVAL_POLYNOMIAL_H

#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Encloses while the rounding mode of the thread is upward.
using Interval = CGAL::Interval_nt<false>;

inline double width(const Interval& x) { return x.sup() - x.inf(); }
inline double magnitude(const Interval& x) { return (std::max)(-x.inf(), x.sup()); }
inline bool is_finite(const Interval& x) { return std::isfinite(x.inf()) && std::isfinite(x.sup()); }
inline bool has_zero(const Interval& x) { return x.inf() <= 0 && x.sup() >= 0; }

// A number of the interval, about its middle.
inline double middle(const Interval& x) { return (std::clamp)(0.5 * x.inf() + 0.5 * x.sup(), x.inf(), x.sup()); }

inline Interval enclosure_of(const Exact_rational& x)
{
  const auto [lower, upper] = to_double_interval(x);
  return Interval(lower, upper);
}

// The least enclosure of what is left when a summand of a sum of intervals is taken out, but for rounding.
inline Interval without_summand(const Interval& sum, const Interval& summand)
{
  return Interval(-(summand.inf() - sum.inf()), sum.sup() - summand.sup());
}

// The common part of two intervals that meet.
inline Interval common_part(const Interval& a, const Interval& b)
{
  return Interval((std::max)(a.inf(), b.inf()), (std::min)(a.sup(), b.sup()));
}

// Even powers are not negative, odd ones increase.
inline Interval power(const Interval& x, int exponent)
{
  if (exponent == 0)
    return Interval(1);
  if (exponent == 1)
    return x;
  if (exponent % 2 == 0)
    return CGAL::square(power(x, exponent / 2));
  if (x.inf() == x.sup())
    return x * power(x, exponent - 1);
  return Interval(power(Interval(x.inf()), exponent).inf(), power(Interval(x.sup()), exponent).sup());
}

// With infinite ends, and 0 times these is 0.
inline Interval extended_product(const Interval& a, const Interval& b)
{
  const auto product = [](double x, double y) { return x == 0 || y == 0 ? 0 : x * y; };
  const auto largest = [&](double x, double y) {
    return (std::max)((std::max)(product(x, b.inf()), product(x, b.sup())),
                      (std::max)(product(y, b.inf()), product(y, b.sup())));
  };
  return Interval(-largest(-a.inf(), -a.sup()), largest(a.inf(), a.sup()));
}

inline Interval extended_power(const Interval& x, int exponent)
{
  Interval result = x;
  for (int e = 1; e < exponent; ++e)
    result = extended_product(result, x);
  return exponent % 2 == 0 ? Interval((std::max)(result.inf(), 0.0), result.sup()) : result;
}

/*
A polynomial in one unknown with interval coefficients: its values, and where in a range it can be zero. The space that
it needs is kept from one polynomial to the next.
*/
class Univariate_interval_polynomial
{
  std::vector<Interval> m_coefficients, m_shifted, m_derivative;

public:
  // All coefficients zero.
  void reset(int degree) { m_coefficients.assign(degree + 1, Interval(0)); }

  int degree() const { return static_cast<int>(m_coefficients.size()) - 1; }
  Interval& operator[](int exponent) { return m_coefficients[exponent]; }

  // Encloses the values on a range: by the coefficients with respect to its Bernstein basis.
  Interval range(const Interval& x) { return range_of(m_coefficients, x); }

  // The same, tighter: the range is cut into some parts.
  Interval range_by_parts(const Interval& x)
  {
    constexpr int parts = 4;
    const double step = width(x) / parts;
    double lower = x.inf();
    Interval hull = value(lower);
    for (int k = 1; k <= parts; ++k) {
      const double upper = k == parts ? x.sup() : (std::min)(x.inf() + k * step, x.sup());
      const Interval part = range(Interval(lower, upper));
      hull = Interval((std::min)(hull.inf(), part.inf()), (std::max)(hull.sup(), part.sup()));
      lower = upper;
    }
    return hull;
  }

  // The same of the derivative.
  Interval range_of_derivative(const Interval& x)
  {
    m_derivative.clear();
    for (int e = 1; e <= degree(); ++e)
      m_derivative.push_back(Interval(e) * m_coefficients[e]);
    return m_derivative.empty() ? Interval(0) : range_of(m_derivative, x);
  }

  Interval value(double x) const { return value_of(m_coefficients, Interval(x)); }

  /*
  Cuts off parts at the ends of a range where there is no zero; false when nothing is left. With a value of at least v
  at an end, and a slope that leads towards zero by at most s, the next zero is v/s away. The constant coefficient may
  be infinite on one side.
  */
  bool cut(Interval& x);

private:
  static Interval value_of(std::span<const Interval> coefficients, const Interval& x)
  {
    Interval result = coefficients.back();
    for (std::size_t e = coefficients.size() - 1; e-- > 0;)
      result = result * x + coefficients[e];
    return result;
  }

  Interval range_of(std::span<const Interval> coefficients, const Interval& x);
  bool cut_linear(Interval& x) const;
  bool cut_end(Interval& x, bool is_lower_end);
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Interval Univariate_interval_polynomial::range_of(std::span<const Interval> coefficients,
                                                                                 const Interval& x)
{
  if (coefficients.size() <= 2 || x.inf() == x.sup())
    return value_of(coefficients, x);
  // in the distance from the lower end, by repeated division
  m_shifted.assign(coefficients.begin(), coefficients.end());
  const std::size_t degree = coefficients.size() - 1;
  const Interval lower(x.inf()), reach = Interval(x.sup()) - lower;
  for (std::size_t k = 0; k < degree; ++k)
    for (std::size_t e = degree; e-- > k;)
      m_shifted[e] += lower * m_shifted[e + 1];
  // m_shifted[k] reach^k / binomial(degree, k), and of these all sums with binomial coefficients
  Interval scale(1);
  for (std::size_t k = 1; k <= degree; ++k) {
    scale = scale * reach * Interval(static_cast<double>(k)) / Interval(static_cast<double>(degree + 1 - k));
    m_shifted[k] *= scale;
  }
  Interval hull = m_shifted[0];
  for (std::size_t k = 1; k <= degree; ++k) {
    for (std::size_t e = degree; e >= k; --e)
      m_shifted[e] += m_shifted[e - 1];
    hull = Interval((std::min)(hull.inf(), m_shifted[k].inf()), (std::max)(hull.sup(), m_shifted[k].sup()));
  }
  // the last one has all of them in it, also what is no number any more, which no comparison finds
  if (is_finite(m_shifted[degree]))
    return hull;
  hull = Interval(0);
  for (std::size_t e = 0; e <= degree; ++e)
    hull += extended_product(coefficients[e], e == 0 ? Interval(1) : extended_power(x, static_cast<int>(e)));
  return hull;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Univariate_interval_polynomial::cut(Interval& x)
{
  for (int e = 1; e <= degree(); ++e)
    if (!is_finite(m_coefficients[e]))
      return true;
  if (std::isnan(m_coefficients[0].inf()) || std::isnan(m_coefficients[0].sup()))
    return true;
  return degree() == 1 ? cut_linear(x) : cut_end(x, true) && cut_end(x, false);
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Univariate_interval_polynomial::cut_linear(Interval& x) const
{
  const Interval &constant = m_coefficients[0], &slope = m_coefficients[1];
  if (!has_zero(slope)) {
    const Interval quotient = -constant / slope;
    if (quotient.inf() > x.sup() || quotient.sup() < x.inf())
      return false;
    x = common_part(quotient, x);
    return true;
  }
  if (has_zero(constant))
    return true;
  // the zeros lie below and above a gap around 0
  const bool is_positive = constant.inf() > 0;
  const Interval size(is_positive ? constant.inf() : -constant.sup());
  const double up = is_positive ? -slope.inf() : slope.sup(), down = is_positive ? slope.sup() : -slope.inf();
  const double above = up > 0 ? (size / Interval(up)).inf() : std::numeric_limits<double>::infinity();
  const double below = down > 0 ? -(size / Interval(down)).inf() : -std::numeric_limits<double>::infinity();
  const bool has_upper = x.sup() >= above, has_lower = x.inf() <= below;
  if (!has_upper && !has_lower)
    return false;
  if (!has_lower)
    x = Interval((std::max)(x.inf(), above), x.sup());
  else if (!has_upper)
    x = Interval(x.inf(), (std::min)(x.sup(), below));
  return true;
}

CGAL_SPLINE_CONSTRAINTS_INLINE bool Univariate_interval_polynomial::cut_end(Interval& x, bool is_lower_end)
{
  constexpr int most_steps = 60;
  constexpr double least_gain = 0.1; // of the width: the rest is better left to other constraints
  for (int step = 0; step < most_steps; ++step) {
    const double end = is_lower_end ? x.inf() : x.sup();
    const Interval at_end = value(end);
    if (!(at_end.inf() > 0 || at_end.sup() < 0))
      return true;
    const Interval slope = range_of_derivative(x);
    if (!is_finite(slope))
      return true;
    const bool is_positive = at_end.inf() > 0;
    const double towards_zero = is_positive == is_lower_end ? -slope.inf() : slope.sup();
    if (towards_zero <= 0)
      return false;
    const double reach = (Interval(is_positive ? at_end.inf() : -at_end.sup()) / Interval(towards_zero)).inf();
    const double old_width = width(x);
    if (is_lower_end) {
      const double lower = (Interval(end) + Interval(reach)).inf();
      if (lower > x.sup())
        return false;
      x = Interval((std::max)(lower, x.inf()), x.sup());
    } else {
      const double upper = (Interval(end) - Interval(reach)).sup();
      if (upper < x.inf())
        return false;
      x = Interval(x.inf(), (std::min)(upper, x.sup()));
    }
    if (!(width(x) < (1 - least_gain) * old_width))
      return true;
  }
  return true;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_PROPAGATION_UNIVARIATE_INTERVAL_POLYNOMIAL_H
