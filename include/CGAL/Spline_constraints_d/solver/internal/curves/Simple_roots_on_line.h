// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SIMPLE_ROOTS_ON_LINE_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SIMPLE_ROOTS_ON_LINE_H

#include <CGAL/Spline_constraints_d/number/Rounding_guard.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>
#include <CGAL/Spline_constraints_d/solver/internal/exact/Bernstein_interval.h>
#include <CGAL/Spline_constraints_d/solver/internal/node/plane_restriction.h>

#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The roots of one polynomial in one unknown on its domain, where doubles tell that all are simple and inside: that costs
a small part of what exact arithmetic does. Each with a region that has no other root.

The Bernstein coefficients over the domain are bounded by intervals; from there on they are doubles with a bound on
their errors. Where at most one change of signs is possible and the signs at the ends differ, there is one root.
*/
class Simple_roots_on_line
{
  using Interval = CGAL::Interval_nt<false>; // within an Upward_rounding_guard
  using Range = std::pair<double, double>;

  Interval m_begin, m_width; // of the domain, which is 0 <= t <= 1
  std::vector<double> m_work;

public:
  struct Root
  {
    Exact_ranges box, region;
  };

  // None if it is not certain.
  std::optional<std::vector<Root>> operator()(const Constraint_system_d& line)
  {
    constexpr int most_parts = 64;
    const auto& [lower, upper] = line.domain(0);
    std::optional<Bernstein_interval> whole = on_domain(line);
    if (!whole)
      return std::nullopt;
    std::vector<Root> result;
    std::vector<Bernstein_interval> parts;
    parts.push_back(*std::move(whole));
    for (int looked_at = 0; !parts.empty(); ++looked_at) {
      const int variations = parts.back().most_variations();
      if (variations > 1) {
        if (looked_at == most_parts || !split(parts))
          return std::nullopt;
        continue;
      }
      if (variations == 1) {
        const std::optional<Range> root = enclosed(parts.back());
        if (!root)
          return std::nullopt;
        const Range box = place(root->first, root->second), region = region_of(parts.back(), box);
        if (Exact_rational(box.first) <= lower || upper <= Exact_rational(box.second))
          return std::nullopt;
        result.push_back({{{Exact_rational(box.first), Exact_rational(box.second)}},
                          {{Exact_rational(region.first), Exact_rational(region.second)}}});
      }
      parts.pop_back();
    }
    return result;
  }

private:
  static Interval interval(const Exact_rational& x)
  {
    const auto [lower, upper] = to_double_interval(x);
    return {lower, upper};
  }

  // The coefficients of the only equality, if it is a polynomial with certain signs at both ends.
  std::optional<Bernstein_interval> on_domain(const Constraint_system_d& line)
  {
    const auto& [lower, upper] = line.domain(0);
    if (line.equalities().size() != 1 || !line.inequalities().empty() || !(lower < upper))
      return std::nullopt;
    std::vector<Interval> powers;
    const Upward_rounding_guard guard;
    for (const Spline_term& term : line.equalities().front().terms()) {
      if (term.pieces.size() != 1)
        return std::nullopt;
      if (powers.size() < term.pieces[0].size())
        powers.resize(term.pieces[0].size(), Interval(0));
      for (std::size_t k = 0; k < term.pieces[0].size(); ++k)
        powers[k] += interval(term.pieces[0][k]);
    }
    constexpr std::size_t largest_degree = 32;
    if (powers.empty() || powers.size() > largest_degree + 1)
      return std::nullopt;
    m_begin = interval(lower);
    m_width = interval(Exact_rational(upper - lower));
    make_local(powers);
    return with_signs(bernstein(powers));
  }

  // From powers of the unknown to those of t.
  void make_local(std::vector<Interval>& powers) const
  {
    const std::size_t degree = powers.size() - 1;
    for (std::size_t k = 0; k < degree; ++k)
      for (std::size_t i = degree; i > k; --i)
        powers[i - 1] += m_begin * powers[i];
    Interval factor(1);
    for (Interval& power : powers) {
      power *= factor;
      factor *= m_width;
    }
  }

  // From powers of t: the k-th is divided by a binomial coefficient, and then the sums of neighbours are taken.
  static std::vector<Interval> bernstein(std::vector<Interval> powers)
  {
    const std::size_t degree = powers.size() - 1;
    double binomial = 1;
    for (std::size_t k = 1; k <= degree; ++k) {
      binomial = binomial * static_cast<double>(degree - k + 1) / static_cast<double>(k); // exactly, both times
      powers[k] /= Interval(binomial);
    }
    for (std::size_t r = 1; r <= degree; ++r)
      for (std::size_t k = degree; k >= r; --k)
        powers[k] += powers[k - 1];
    return powers;
  }

  static std::optional<Bernstein_interval> with_signs(const std::vector<Interval>& coefficients)
  {
    Bernstein_interval result;
    result.upper = 1;
    for (const Interval& x : coefficients) {
      const double middle = 0.5 * x.inf() + 0.5 * x.sup();
      result.values.push_back(middle);
      result.error = (std::max)(
          {result.error, (Interval(x.sup()) - Interval(middle)).sup(), (Interval(middle) - Interval(x.inf())).sup()});
    }
    const auto sign = [&](double value) { return value > result.error ? 1 : value < -result.error ? -1 : 0; };
    result.lower_sign = sign(result.values.front());
    result.upper_sign = sign(result.values.back());
    return result.lower_sign == 0 || result.upper_sign == 0 ? std::nullopt : std::optional(std::move(result));
  }

  // The lower part is put on top of the upper one; false where the sign between is not certain.
  static bool split(std::vector<Bernstein_interval>& parts)
  {
    constexpr double place = 125.0 / 256;
    Bernstein_interval below, &above = parts.back();
    above.split(above.point_at(place), below);
    const double value = below.values.back();
    if (!(std::abs(value) > below.error))
      return false;
    below.upper_sign = above.lower_sign = value > 0 ? 1 : -1;
    parts.push_back(std::move(below));
    return true;
  }

  // The root of a part that has one, between values of t where the signs are certain.
  std::optional<Range> enclosed(const Bernstein_interval& part)
  {
    constexpr double least_width = 0x1p-50, largest_width = 0x1p-40;
    double t = part.crossing_of_polygon(), slope = 0;
    for (int step = 0; step < 12; ++step) {
      const auto [value, own_slope] = part.value_and_slope(t, m_work);
      slope = own_slope;
      const double next = (std::min)((std::max)(t - value / slope, 0.5 * t), 0.5 + 0.5 * t),
                   distance = std::abs(next - t);
      t = next;
      if (distance < least_width)
        break;
    }
    const double rounding = 10 * static_cast<double>(part.values.size()) * 0x1p-52 * part.largest(),
                 error = part.error + rounding, width = 4 * error / std::abs(slope) + least_width;
    if (!(width < largest_width) || !(width < t && t < 1 - width))
      return std::nullopt;
    const auto has_sign = [&](double at, int sign) { return sign * part.value_and_slope(at, m_work).first > error; };
    if (!has_sign(t - width, part.lower_sign) || !has_sign(t + width, part.upper_sign))
      return std::nullopt;
    return Range(part.point_at(t - width) - least_width, part.point_at(t + width) + least_width);
  }

  // What the unknown may be, between two values of t.
  Range place(double from, double to) const
  {
    const Upward_rounding_guard guard;
    return {(m_begin + m_width * Interval(from)).inf(), (m_begin + m_width * Interval(to)).sup()};
  }

  // Within the part.
  Range region_of(const Bernstein_interval& part, const Range& box) const
  {
    const Upward_rounding_guard guard;
    return {(std::min)((m_begin + m_width * Interval(part.lower)).sup(), box.first),
            (std::max)((m_begin + m_width * Interval(part.upper)).inf(), box.second)};
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CURVES_SIMPLE_ROOTS_ON_LINE_H
