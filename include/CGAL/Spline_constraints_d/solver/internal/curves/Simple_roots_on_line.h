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
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

/*
The roots of one polynomial in one unknown on its domain, where doubles tell that all are simple and inside: that costs
a small part of what exact arithmetic does. Each with a region that has no other root. The polynomial is exact, or given
by Bernstein coefficients with a bound on their errors.

The Bernstein coefficients over the domain are bounded by intervals; from there on they are doubles with a bound on
their errors. Where at most one change of signs is possible and the signs at the ends differ, there is one root.
*/
class Simple_roots_on_line
{
  using Interval = CGAL::Interval_nt<false>; // within an Upward_rounding_guard

  Interval m_begin, m_width; // of the domain, which is 0 <= t <= 1
  double m_largest_width;    // of what encloses a root, in units of a part of the domain
  std::vector<double> m_work;

public:
  explicit Simple_roots_on_line(double largest_width = 0x1p-40) : m_largest_width(largest_width) {}

  using Range = std::pair<double, double>;

  struct Root
  {
    Range box, region;
  };

  // None if it is not certain.
  std::optional<std::vector<Root>> operator()(const Constraint_system_d& line)
  {
    const std::optional<Bernstein_interval> whole = on_domain(line);
    if (!whole)
      return std::nullopt;
    const auto& [lower, upper] = line.domain(0);
    std::optional<std::vector<Root>> result = roots_of(*whole);
    const auto is_inside = [&, &least = lower, &most = upper](const Root& root) {
      return least < Exact_rational(root.box.first) && Exact_rational(root.box.second) < most;
    };
    return result && std::all_of(result->begin(), result->end(), is_inside) ? std::move(result) : std::nullopt;
  }

  // The same for Bernstein coefficients on a domain, and a bound on their errors.
  std::optional<std::vector<Root>> operator()(std::span<const double> coefficients, double error, double lower,
                                              double upper)
  {
    Bernstein_interval whole;
    whole.values.assign(coefficients.begin(), coefficients.end());
    whole.error = error;
    if (!has_signs(whole))
      return std::nullopt;
    {
      const Upward_rounding_guard guard;
      m_begin = Interval(lower);
      m_width = Interval(upper) - m_begin;
    }
    std::optional<std::vector<Root>> result = roots_of(whole);
    const auto is_inside = [&](const Root& root) { return lower < root.box.first && root.box.second < upper; };
    return result && std::all_of(result->begin(), result->end(), is_inside) ? std::move(result) : std::nullopt;
  }

private:
  std::optional<std::vector<Root>> roots_of(const Bernstein_interval& whole)
  {
    constexpr int most_parts = 64;
    std::vector<Root> result;
    std::vector<Bernstein_interval> parts{whole};
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
        const Range box = place(root->first, root->second);
        result.push_back({box, region_of(parts.back(), box)});
      }
      parts.pop_back();
    }
    return result;
  }

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
    for (const Interval& x : coefficients) {
      const double middle = 0.5 * x.inf() + 0.5 * x.sup();
      result.values.push_back(middle);
      result.error = (std::max)(
          {result.error, (Interval(x.sup()) - Interval(middle)).sup(), (Interval(middle) - Interval(x.inf())).sup()});
    }
    return has_signs(result) ? std::optional(std::move(result)) : std::nullopt;
  }

  // Sets the whole of the domain, and the signs at its ends, if they are certain.
  static bool has_signs(Bernstein_interval& whole)
  {
    const auto sign = [&](double value) { return value > whole.error ? 1 : value < -whole.error ? -1 : 0; };
    whole.lower = 0;
    whole.upper = 1;
    whole.lower_sign = sign(whole.values.front());
    whole.upper_sign = sign(whole.values.back());
    return whole.lower_sign != 0 && whole.upper_sign != 0;
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
    constexpr double least_width = 0x1p-50;
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
    if (!(width < m_largest_width) || !(width < t && t < 1 - width))
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
