// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_WEIGHTED_CONE_TEST_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_WEIGHTED_CONE_TEST_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Adapted_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/surfaces/Cone_point.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
Proves that a rational singular point of f = 0 is a cone or isolated, whatever the rank of the second derivative.

Unknowns u = L (x - p) get weights w. With u_j = t^w_j v_j, where one of the v_j is 1 or -1 and the others are between,
every point but p has one t > 0; f, and the minors of its gradient and that of phi, are powers of t times polynomials in
t and v. These are bounded in parts of the six faces of the cube of the v and for 0 <= t <= T: if one of them is not
zero in each part, p is the only point with t <= T where all are zero.

At t = 0 only the terms F of least weight are left. By Euler's formula the derivative of F along (w_j u_j) is zero where
F is, that of phi is positive: the gradients are dependent only where that of F is zero. So the test succeeds for small
T if F has no real singular point but 0, as for surfaces that touch, where there are complex ones.
*/
class Weighted_cone_test
{
  using Weights = std::array<int, 3>;
  using Chart = std::vector<Interval_polynomial>; // in t and two of the v

  // A part of a face of the cube.
  struct Part
  {
    std::array<double, 2> lower, upper;
    double width() const { return (std::max)(upper[0] - lower[0], upper[1] - lower[1]); }
  };

  static constexpr double largest_reach = 0x1p-1, least_reach = 0x1p-12;

  Weights m_weights;
  double m_reach = largest_reach;

public:
  // `equation`: in the u.
  Weighted_cone_test(const Power_polynomial& equation, const Weights& weights) : m_weights(weights)
  {
    const Upward_rounding_guard guard;
    const std::vector<Power_polynomial> polynomials = equation_and_minors(equation);
    for (int face = 0; face < 6 && m_reach > 0; ++face)
      m_reach = reach_on(chart(polynomials, static_cast<std::size_t>(face / 2), face % 2 == 0 ? 1 : -1));
  }

  // T, a power of two; 0 without a proof.
  double reach() const { return m_reach; }

  // Those of the u_j in phi.
  static std::array<int, 3> exponents(const Weights& weights)
  {
    const int common = std::lcm(std::lcm(weights[0], weights[1]), weights[2]);
    return {2 * common / weights[0], 2 * common / weights[1], 2 * common / weights[2]};
  }

private:
  std::vector<Power_polynomial> equation_and_minors(const Power_polynomial& equation) const
  {
    std::vector<Power_polynomial> result{equation};
    const auto slope_of_phi = [&](int j) {
      const int exponent = exponents(m_weights)[static_cast<std::size_t>(j)];
      Power_polynomial power{Exact_rational(exponent)};
      for (int e = 1; e < exponent; ++e)
        power *= Power_polynomial::variable(j);
      return power;
    };
    for (const auto& [j, k] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)})
      result.push_back(equation.derivative(j) * slope_of_phi(k) - equation.derivative(k) * slope_of_phi(j));
    return result;
  }

  int weight(const Monomial& monomial) const
  {
    int result = 0;
    for (const auto& [v, e] : monomial.powers)
      result += m_weights[static_cast<std::size_t>(v)] * e;
    return result;
  }

  // Where v_j = sign: t is unknown 0, the other v are 1 and 2.
  Chart chart(const std::vector<Power_polynomial>& polynomials, std::size_t j, int sign) const
  {
    Chart result;
    for (const Power_polynomial& polynomial : polynomials) {
      int least = std::numeric_limits<int>::max();
      for (const auto& [monomial, coefficient] : polynomial.terms())
        least = (std::min)(least, weight(monomial));
      Power_polynomial own;
      for (const auto& [monomial, coefficient] : polynomial.terms()) {
        Monomial changed = Monomial().with_exponent(0, weight(monomial) - least);
        for (int k = 0, place = 1; k < 3; ++k)
          if (k != static_cast<int>(j))
            changed = changed.with_exponent(place++, monomial.exponent(k));
        const bool is_negative = sign < 0 && monomial.exponent(static_cast<int>(j)) % 2 == 1;
        own += monomial_polynomial(changed, is_negative ? Exact_rational(-coefficient) : coefficient);
      }
      if (!own.is_zero())
        result.emplace_back(own);
    }
    return result;
  }

  static Power_polynomial monomial_polynomial(const Monomial& monomial, const Exact_rational& coefficient)
  {
    Power_polynomial result(coefficient);
    for (const auto& [v, e] : monomial.powers)
      for (int k = 0; k < e; ++k)
        result *= Power_polynomial::variable(v);
    return result;
  }

  // The largest power of two up to the reach for which this chart is proved.
  double reach_on(const Chart& chart) const
  {
    constexpr double coarse = 0x1p-3, finest = 0x1p-7;
    constexpr int most_parts = 20000;
    double reach = m_reach;
    std::vector<Part> parts{{{-1, -1}, {1, 1}}};
    for (int looked_at = 0; !parts.empty(); ++looked_at) {
      if (looked_at == most_parts)
        return 0;
      const Part part = parts.back();
      parts.pop_back();
      if (is_excluded(chart, part, reach))
        continue;
      if (part.width() <= coarse) {
        double smaller = reach;
        while (smaller >= least_reach && !is_excluded(chart, part, smaller))
          smaller /= 2;
        if (smaller >= least_reach) {
          reach = smaller;
          continue;
        }
        if (part.width() <= finest)
          return 0;
      }
      split(part, parts);
    }
    return reach;
  }

  static bool is_excluded(const Chart& chart, const Part& part, double reach)
  {
    const Interval_box box{Interval(0, reach), Interval(part.lower[0], part.upper[0]),
                           Interval(part.lower[1], part.upper[1])};
    return std::any_of(chart.begin(), chart.end(),
                       [&](const Interval_polynomial& p) { return !contains_zero(p(box).value); });
  }

  static void split(const Part& part, std::vector<Part>& parts)
  {
    const std::size_t axis = part.upper[0] - part.lower[0] < part.upper[1] - part.lower[1] ? 1 : 0;
    Part lower = part, upper = part;
    lower.upper[axis] = upper.lower[axis] = 0.5 * (part.lower[axis] + part.upper[axis]);
    parts.push_back(lower);
    parts.push_back(upper);
  }
};

// Looks for a proof that a rational point where f and its gradient are zero is a cone or isolated.
inline std::optional<Cone_point> weighted_cone_point(const Power_polynomial& equation, const Exact_point& point,
                                                     const std::vector<double>& lengths)
{
  const Power_polynomial in_differences = centred(equation, point);
  const Adapted_coordinates coordinates(in_differences, lengths);
  const Power_polynomial in_u = coordinates.changed(in_differences);
  for (const std::array<int, 3>& weights : coordinates.weights())
    if (const double reach = Weighted_cone_test(in_u, weights).reach(); reach > 0) {
      std::array<Exact_rational, 3> sizes; // |u_j| <= T^w_j
      for (std::size_t j = 0; j < 3; ++j)
        sizes[j] = power_of_two(std::ilogb(reach) * weights[j]);
      Cone_point result{box_around(point, Exact_point(3, Exact_rational(0))),
                        point,
                        Interval_polynomial(in_differences),
                        {},
                        Weighted_cone_test::exponents(weights),
                        box_around(point, coordinates.distances_for(sizes))};
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k)
          result.rows[j][k] = interval_of(coordinates.rows()[j][k]);
      return result;
    }
  return std::nullopt;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_SURFACES_WEIGHTED_CONE_TEST_H
