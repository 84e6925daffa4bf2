// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_GAUSS_NEWTON_SEARCH_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_GAUSS_NEWTON_SEARCH_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Big_integer.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/number/power_of_two.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/gauss_jordan.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

using Exact_point = std::vector<Exact_rational>;

// Polynomials that are evaluated together with their gradients at many points, exactly or in doubles.
template <class NT>
class Polynomials_with_gradients
{
  struct Term
  {
    NT coefficient;
    std::vector<std::pair<std::size_t, std::size_t>> powers;   // unknowns and exponents
  };
  std::vector<std::vector<Term>> m_polynomials;
  std::vector<std::size_t> m_degrees;   // per unknown

public:
  struct Value
  {
    NT value = NT(0), size = NT(0);   // the latter is the sum of the sizes of all terms
    std::vector<NT> gradient;
  };

  void add(const Power_polynomial& polynomial)
  {
    std::vector<Term>& terms = m_polynomials.emplace_back();
    for (const auto& [monomial, coefficient] : polynomial.terms()) {
      Term term{converted(coefficient), {}};
      for (const auto& [v, e] : monomial.powers) {
        const std::size_t unknown = static_cast<std::size_t>(v), exponent = static_cast<std::size_t>(e);
        term.powers.emplace_back(unknown, exponent);
        m_degrees.resize((std::max)(m_degrees.size(), unknown + 1), 0);
        m_degrees[unknown] = (std::max)(m_degrees[unknown], exponent);
      }
      terms.push_back(std::move(term));
    }
  }

  // One after the other.
  std::vector<Value> operator()(const std::vector<NT>& point) const
  {
    std::vector<std::vector<NT>> powers;
    for (std::size_t j = 0; j < m_degrees.size(); ++j) {
      powers.push_back({NT(1)});
      for (std::size_t e = 0; e < m_degrees[j]; ++e)
        powers[j].push_back(NT(powers[j].back() * point[j]));
    }
    std::vector<Value> result;
    for (const std::vector<Term>& terms : m_polynomials) {
      Value& sum = result.emplace_back();
      sum.gradient.assign(point.size(), NT(0));
      for (const Term& term : terms)
        add_term(sum, term, powers);
    }
    return result;
  }

private:
  static NT converted(const Exact_rational& x)
  {
    if constexpr (std::same_as<NT, double>)
      return to_nearest_double(x);
    else
      return x;
  }

  static void add_term(Value& sum, const Term& term, const std::vector<std::vector<NT>>& powers)
  {
    NT value = term.coefficient;
    for (const auto& [j, e] : term.powers)
      value *= powers[j][e];
    sum.value += value;
    sum.size += value < 0 ? NT(-value) : value;
    for (const auto& [j, e] : term.powers) {
      NT derivative = term.coefficient * NT(static_cast<int>(e));
      for (const auto& [k, f] : term.powers)
        derivative *= powers[k][k == j ? f - 1 : f];
      sum.gradient[j] += derivative;
    }
  }
};

// The point that a search found, if there is one; or that the numbers do not have the digits to tell.
struct Search_result
{
  std::optional<Exact_point> point;
  bool is_unclear = false;
};

/*
Looks in a box for a common zero of more polynomials than unknowns, with rational coordinates: the Gauss-Newton method,
with the simplest rationals near its iterates, in doubles or rational numbers of some hundred bits. At points of high
multiplicity steps become shorter by a constant factor, so that two of them tell how far all others will go. Every other
one only leads back to a curve, wherever this is bent.
*/
template <class NT>
class Gauss_newton_search
{
  using Point = std::vector<NT>;

  static constexpr bool is_rounded = std::same_as<NT, double>;
  static constexpr double noise = 0x1p-40;   // well above rounding errors, relative to the sizes of terms

  const Polynomials_with_gradients<NT>& m_polynomials;
  const Exact_ranges& m_box;
  std::function<bool(const Exact_point&)> m_is_zero;
  std::vector<std::pair<NT, NT>> m_ranges;
  Point m_place;
  std::size_t m_steps = 0;

public:
  // `is_zero(point)` decides exactly.
  Gauss_newton_search(const Polynomials_with_gradients<NT>& polynomials, const Exact_ranges& box,
                      std::function<bool(const Exact_point&)> is_zero)
    : m_polynomials(polynomials), m_box(box), m_is_zero(std::move(is_zero))
  {
    for (const auto& [lower, upper] : box) {
      m_ranges.emplace_back(number(lower), number(upper));
      m_place.push_back(NT((m_ranges.back().first + m_ranges.back().second) / 2));
    }
  }

  std::size_t steps() const { return m_steps; }

  Search_result operator()()
  {
    constexpr int most_rounds = 12, most_exits = 3;
    for (int round = 0, exits = 0; round < most_rounds; ++round) {
      std::vector<Point> steps;   // each of two
      NT first_residual(0);
      for (int i = 0; i < 4; ++i) {
        const Step step = next_step();
        if (is_rounded && (step.is_uncertain || step.offset.empty()))
          return {std::nullopt, true};
        if (step.offset.empty())
          return checked(exact(m_place));
        if (i == 0)
          first_residual = step.residual;
        else if (i == 2 && 2 * step.residual > first_residual)
          return {};   // there seems to be a minimum
        if (i % 2 == 0)
          steps.emplace_back(m_place.size(), NT(0));
        add(steps.back(), step.offset);
        add(m_place, step.offset);
        if (!move_into_box() && ++exits == most_exits)
          return {};
        if (Search_result result = simplest_zero(length(step.offset)); result.point)
          return result;
      }
      if (is_short(steps[1]))
        return {};
      const NT square = product(steps[0], steps[0]),
               ratio = square == 0 ? NT(0) : NT(product(steps[0], steps[1]) / square);
      if (ratio > 0 && ratio < NT(63) / 64) {
        for (NT& x : steps[1])
          x *= ratio / (1 - ratio);
        add(m_place, steps[1]);
        if (Search_result result = simplest_zero(length(steps[1])); result.point)
          return result;
      }
    }
    return {};
  }

private:
  struct Step
  {
    Point offset;        // empty where it is not unique
    NT residual = NT(0);   // the sum of the squares of the values
    bool is_uncertain = true;   // in doubles: all values may be zero but for rounding, or numbers are too large
  };

  static NT number(const Exact_rational& x)
  {
    if constexpr (is_rounded)
      return to_nearest_double(x);
    else
      return x;
  }

  static Exact_point exact(const Point& place) { return Exact_point(place.begin(), place.end()); }

  // The least squares solution of the linearized equations.
  Step next_step()
  {
    ++m_steps;
    Step result;
    const std::size_t n = m_place.size(), length = n + 1;
    std::vector<NT> rows(n * length, NT(0));   // the normal equations
    for (const auto& [value, size, gradient] : m_polynomials(m_place)) {
      result.residual += value * value;
      if constexpr (is_rounded)
        result.is_uncertain = result.is_uncertain && !(std::abs(value) > noise * size);
      for (std::size_t j = 0; j < n; ++j) {
        for (std::size_t k = 0; k < n; ++k)
          rows[j * length + k] += gradient[j] * gradient[k];
        rows[j * length + n] -= gradient[j] * value;
      }
    }
    const std::vector<int> row_of = gauss_jordan(rows, length, n, n, [](const NT& x) {
      return x == 0 ? 0.0 : (std::max)(std::abs(CGAL::to_double(x)), 1e-300);
    });
    for (std::size_t j = 0; j < row_of.size(); ++j) {
      result.offset.push_back(rows[static_cast<std::size_t>(row_of[j]) * length + n]);
      result.is_uncertain = result.is_uncertain || !CGAL::is_finite(result.offset.back());
    }
    return result;
  }

  // Rational numbers are rounded to a fixed number of bits.
  static void add(Point& place, const Point& step)
  {
    for (std::size_t j = 0; j < place.size(); ++j) {
      place[j] += step[j];
      if constexpr (!is_rounded) {
        constexpr int bits = 256;
        const Exact_rational scaled = place[j] * power_of_two(bits);
        place[j] = scaled_rational(Big_integer(numerator_of(scaled) / denominator_of(scaled)), -bits);
      }
    }
  }

  // False if the place is not in the box: then it is moved to its boundary.
  bool move_into_box()
  {
    const Point before = m_place;
    for (std::size_t j = 0; j < m_place.size(); ++j)
      m_place[j] = (std::min)((std::max)(m_place[j], m_ranges[j].first), m_ranges[j].second);
    return m_place == before;
  }

  // Whether a rational with small numbers would have been found already.
  bool is_short(const Point& step) const
  {
    NT shortest(0);
    for (const auto& [lower, upper] : m_ranges)
      shortest = (std::max)(shortest, NT(0x1p-80 * (upper - lower)));
    return length(step) < shortest;
  }

  Search_result simplest_zero(const NT& margin) const
  {
    if (!may_be_zero_near(margin))
      return {};
    Exact_point point;
    for (std::size_t j = 0; j < m_place.size(); ++j) {
      if (!CGAL::is_finite(m_place[j]) || !CGAL::is_finite(margin))
        return {};
      const Exact_rational lower = (std::max)(Exact_rational(m_place[j] - margin), m_box[j].first),
                           upper = (std::min)(Exact_rational(m_place[j] + margin), m_box[j].second);
      if (upper < lower)
        return {};
      point.push_back(simplest_rational_between(lower, upper));
    }
    return may_be_zero(point) ? checked(std::move(point)) : Search_result();
  }

  // Whether gradients are large enough for a zero nearby: four times as large at one of multiplicity m, if the margin
  // is 1/m of the distance. In rational numbers to look at it costs more than to try.
  bool may_be_zero_near(const NT& margin) const
  {
    if constexpr (is_rounded) {
      const auto values = m_polynomials(m_place);
      return std::all_of(values.begin(), values.end(), [&](const auto& x) {
        const double slope = std::accumulate(x.gradient.begin(), x.gradient.end(), 0.0,
                                             [](double sum, double derivative) { return sum + std::abs(derivative); });
        return !(std::abs(x.value) > noise * x.size + 4 * margin * slope);
      });
    }
    return true;
  }

  // In doubles nearly all points that are none are told by their values.
  bool may_be_zero(const Exact_point& point) const
  {
    if constexpr (is_rounded) {
      Point rounded;
      for (const Exact_rational& x : point)
        rounded.push_back(to_nearest_double(x));
      const auto values = m_polynomials(rounded);
      return std::all_of(values.begin(), values.end(),
                         [](const auto& x) { return !(std::abs(x.value) > noise * x.size); });
    }
    return true;
  }

  Search_result checked(Exact_point point) const
  {
    return m_is_zero(point) ? Search_result{std::move(point), false} : Search_result();
  }

  static NT product(const Point& a, const Point& b)
  {
    NT result(0);
    for (std::size_t j = 0; j < a.size(); ++j)
      result += a[j] * b[j];
    return result;
  }

  static NT length(const Point& step)
  {
    NT result(0);
    for (const NT& x : step)
      result = (std::max)(result, x < 0 ? NT(-x) : x);
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_GAUSS_NEWTON_SEARCH_H
