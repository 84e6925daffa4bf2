// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_AFFINE_OVERLAP_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_AFFINE_OVERLAP_H

#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Short_integer.h>
#include <CGAL/Spline_constraints_d/number/near_fraction.h>
#include <CGAL/Spline_constraints_d/operations/common/internal/Elementary_points.h>
#include <CGAL/Spline_constraints_d/operations/intersections/internal/elementary/closed_forms.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Intersections {

/*
The common piece of two curves A(t) = B(at + b) of the same degree, one of which is the other one with another
parameter. Candidates of a and b are those that the two highest coefficients leave, as fractions with small
denominators; that the curves are the same is proved by their control points, in integers. Where both run forward in one
direction, all of the curve that they are parts of does between their ends, so it does not meet itself and there are no
other common points.
*/
template <int d>
class Affine_overlap
{
  using Operand = Elementary_operand<d>;
  using Range = std::pair<Exact_rational, Exact_rational>;

  // Those of a fraction with a positive denominator.
  struct Integers
  {
    std::int64_t numerator, denominator;
  };

  const Operand &m_first, &m_second;
  std::size_t m_degree;

public:
  Affine_overlap(const Operand& first, const Operand& second)
    : m_first(first), m_second(second), m_degree(first.coefficients[0].size() - 1)
  {}

  // Nothing where there is no common piece, or it is not seen in this way.
  std::optional<Elementary_point<d>> operator()() const
  {
    if (!m_first.is_one_piece() || !m_second.is_one_piece() || m_second.degrees != m_first.degrees || m_degree == 0)
      return std::nullopt;
    const std::optional<double> factor = factor_of_leading_coefficients();
    if (!factor || (*factor < 0 && m_degree % 2 == 0))
      return std::nullopt;
    const double size = std::pow(std::abs(*factor), 1 / static_cast<double>(m_degree));
    if (m_degree % 2 != 0)
      return overlap(*factor < 0 ? -size : size);
    auto forward = overlap(size);
    return forward ? forward : overlap(-size);
  }

private:
  // a^n, where the leading coefficients are nearly multiples of each other.
  std::optional<double> factor_of_leading_coefficients() const
  {
    constexpr double most = 1e-9;
    const std::array<double, d> a = coefficient(m_first, 0), b = coefficient(m_second, 0);
    const std::size_t i = largest(a), k = largest(b);
    if (a[i] == 0 || b[k] == 0)
      return std::nullopt;
    for (std::size_t j = 0; j < d; ++j)
      if (std::abs(a[j] * b[k] - a[k] * b[j]) > most * std::abs(a[i] * b[k]))
        return std::nullopt;
    return a[k] / b[k];
  }

  // The coefficient of the power n or n - 1, by differences of control points, rounded.
  std::array<double, d> coefficient(const Operand& curve, std::size_t k) const
  {
    const std::size_t power = m_degree - k;
    std::array<double, d> result{};
    double weight = (power % 2 == 0 ? 1 : -1) * (k == 0 ? 1 : static_cast<double>(m_degree));
    for (std::size_t j = 0; j <= power; ++j) {
      for (std::size_t i = 0; i < d; ++i)
        result[i] += weight * curve.coefficients[i][j];
      weight *= -static_cast<double>(power - j) / static_cast<double>(j + 1);
    }
    return result;
  }

  static std::size_t largest(const std::array<double, d>& x)
  {
    std::size_t result = 0;
    for (std::size_t i = 1; i < d; ++i)
      if (std::abs(x[result]) < std::abs(x[i]))
        result = i;
    return result;
  }

  // Whether the control polygons of both run forward or backward in the same direction.
  bool run_forward() const
  {
    Coordinates<Interval, d> chord;
    for (std::size_t i = 0; i < d; ++i)
      chord[i] = Interval(m_first.coefficients[i].back()) - Interval(m_first.coefficients[i].front());
    if (runs_along(m_first, chord) && runs_along(m_second, chord))
      return true;
    for (std::size_t i = 0; i < d; ++i) {
      Coordinates<Interval, d> axis;
      axis.fill(Interval(0));
      axis[i] = Interval(1);
      if (runs_along(m_first, axis) && runs_along(m_second, axis))
        return true;
    }
    return false;
  }

  bool runs_along(const Operand& curve, const Coordinates<Interval, d>& direction) const
  {
    int sign = 0;
    for (std::size_t j = 0; j < m_degree; ++j) {
      Interval step(0);
      for (std::size_t i = 0; i < d; ++i)
        step += direction[i] * (Interval(curve.coefficients[i][j + 1]) - Interval(curve.coefficients[i][j]));
      const int own = known_sign(step);
      if ((own == 0 && !step.is_same(Interval(0))) || (own != 0 && own == -sign))
        return false;
      sign = own != 0 ? own : sign;
    }
    return sign != 0;
  }

  std::optional<Elementary_point<d>> overlap(double a) const
  {
    const std::array<double, d> leading = coefficient(m_second, 0);
    const std::size_t i = largest(leading);
    const double next = coefficient(m_first, 1)[i], other = coefficient(m_second, 1)[i],
                 n = static_cast<double>(m_degree);
    const double b = (next / std::pow(a, n - 1) - other) / (n * leading[i]);
    if (!begins_near(b) || !run_forward())
      return std::nullopt;
    const auto factor = small_fraction(a), begin = small_fraction(b);
    if (!factor || !begin || factor->numerator == 0)
      return std::nullopt;
    // the range of the second curve that the first one is, over one denominator
    const std::int64_t q = std::lcm(factor->denominator, begin->denominator),
                       first = begin->numerator * (q / begin->denominator),
                       last = first + factor->numerator * (q / factor->denominator);
    if (!is_restriction(q, first, last))
      return std::nullopt;
    return common_piece(exact(factor->numerator, factor->denominator), exact(begin->numerator, begin->denominator));
  }

  // Whether the first curve may begin at a parameter of the second one.
  bool begins_near(double t) const
  {
    constexpr double most = 1e-6;
    for (std::size_t i = 0; i < d; ++i) {
      const double value = m_first.coefficients[i].front(),
                   error = std::abs(rounded_value(m_second.coefficients[i], t) - value);
      double size = std::abs(value);
      for (const double x : m_second.coefficients[i])
        size = (std::max)(size, std::abs(x));
      if (error > most * size)
        return false;
    }
    return true;
  }

  // Every type behind Exact_rational has a constructor from double, but not from every integer.
  static Exact_rational exact(std::int64_t numerator, std::int64_t denominator)
  {
    return Exact_rational(Exact_rational(static_cast<double>(numerator)) /
                          Exact_rational(static_cast<double>(denominator)));
  }

  // Up to the accuracy that coefficients leave.
  static std::optional<Integers> small_fraction(double x)
  {
    const std::optional<Fraction> found = near_fraction(x, 1e-11 * (std::max)(1.0, std::abs(x)), 0x1p20);
    if (!found)
      return std::nullopt;
    return Integers{static_cast<std::int64_t>(found->numerator), static_cast<std::int64_t>(found->denominator)};
  }

  // Whether the first curve is the second one over [first/q, last/q]: its control points are the values there of the
  // polar form of the second one, all of them times q^n.
  bool is_restriction(std::int64_t q, std::int64_t first, std::int64_t last) const
  {
    const Short_integer begin = integer(first), rest_of_begin = integer(q - first), end = integer(last),
                        rest_of_end = integer(q - last);
    for (std::size_t i = 0; i < d; ++i) {
      std::vector<double> numbers(m_first.coefficients[i].begin(), m_first.coefficients[i].end());
      numbers.insert(numbers.end(), m_second.coefficients[i].begin(), m_second.coefficients[i].end());
      std::vector<Short_integer> values;
      over_common_denominator(numbers, values);
      std::vector<Short_integer> row(values.begin() + static_cast<std::ptrdiff_t>(m_degree) + 1, values.end());
      Short_integer power(1);
      for (std::size_t k = 0; k < m_degree; ++k)
        power *= integer(q);
      // row k has the values with the begin k times
      for (std::size_t k = 0;; ++k) {
        std::vector<Short_integer> other = row;
        while (other.size() > 1)
          step(other, rest_of_end, end);
        if (!(other[0] == values[m_degree - k] * power))
          return false;
        if (k == m_degree)
          break;
        step(row, rest_of_begin, begin);
      }
    }
    return true;
  }

  static Short_integer integer(std::int64_t x) { return Short_integer(x); }

  // A step of de Casteljau's scheme, times the denominator.
  static void step(std::vector<Short_integer>& row, const Short_integer& rest, const Short_integer& t)
  {
    for (std::size_t j = 0; j + 1 < row.size(); ++j) {
      row[j] *= rest;
      add_product(row[j], t, row[j + 1]);
    }
    row.pop_back();
  }

  // Where both parameters are in the unit interval: nothing if that is a point at most.
  std::optional<Elementary_point<d>> common_piece(const Exact_rational& a, const Exact_rational& b) const
  {
    Exact_rational enter(-b / a), leave((1 - b) / a);
    if (a < 0)
      std::swap(enter, leave);
    const Exact_rational first = (std::max)(enter, Exact_rational(0)), last = (std::min)(leave, Exact_rational(1));
    if (!(first < last))
      return std::nullopt;
    Exact_rational other_first(a * first + b), other_last(a * last + b);
    if (a < 0)
      std::swap(other_first, other_last);
    Elementary_point<d> result{Intersection_kind::OVERLAP, {}, {}, 0, std::nullopt, {}};
    result.exact_parameters = {on_domain(m_first, first, last), on_domain(m_second, other_first, other_last)};
    const Interval middle(to_double_interval(Exact_rational((first + last) / 2)));
    const Coordinates<Interval, d> point = point_of_curve(piece_of<Interval>(m_first, m_degree), middle);
    for (std::size_t i = 0; i < d; ++i)
      result.point[i] = point[i].inf() + (point[i].sup() - point[i].inf()) / 2;
    return result;
  }

  static Range on_domain(const Operand& curve, const Exact_rational& first, const Exact_rational& last)
  {
    const Exact_rational begin(curve.domain[0][0]), width(Exact_rational(curve.domain[0][1]) - begin);
    return {Exact_rational(begin + width * first), Exact_rational(begin + width * last)};
  }
};

} // namespace Intersections
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_INTERSECTIONS_INTERNAL_ELEMENTARY_AFFINE_OVERLAP_H
