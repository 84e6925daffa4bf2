// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_BLOSSOM_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_BLOSSOM_H

#include <CGAL/Spline_constraints_d/function/tensor_axes.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/number/Short_integer.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The argument of a blossom: a point has weight 1; weight 0 is a direction, which differentiates.
template <class NT>
struct Blossom_argument
{
  NT value;
  NT weight = NT(1);
};

/*
Exact weights of control points are integers over one denominator for all of them. With rationals, most of the time
would go into common divisors and the memory of numbers that live for one operation.
*/
struct Integer_weights
{
  std::vector<Short_integer> numerators;
  Short_integer denominator = 1;
};

/*
The weights of the control points of a span in the blossom of its polynomial, with one argument more at a time:
`Blossom_weights` without divisions. With integer knots, each level of de Boor's recurrence is multiplied by a common
multiple of the differences that it divides by.
*/
class Integer_blossom
{
  // The knots that matter, t_(q+1-d), ..., t_(q+d) of the span [t_q, t_(q+1)], as integers over a unit.
  struct Span
  {
    std::vector<Short_integer> knots;
    Short_integer unit;

    const Short_integer& right(std::size_t r) const { return knots[knots.size() / 2 + r]; }
    const Short_integer& left(std::size_t r, std::size_t level) const { return knots[knots.size() / 2 + r - level]; }
  };

  std::shared_ptr<const Span> m_span;
  Integer_weights m_weights{{Short_integer(1)}, 1};

public:
  template <class Axis>
  Integer_blossom(const Axis& axis, std::size_t span)
  {
    const auto first = axis.knots.begin() + static_cast<std::ptrdiff_t>(span + 1) - axis.degree;
    Span result;
    result.unit = over_common_denominator(std::vector<Exact_rational>(first, first + 2 * axis.degree), result.knots);
    m_span = std::make_shared<const Span>(std::move(result));
  }

  void add(const Blossom_argument<Exact_rational>& x);

  const Integer_weights& weights() const { return m_weights; }

private:
  Short_integer multiple_of_differences(std::size_t level) const;
};

// A band matrix of rationals whose rows are integers over a denominator each.
class Integer_band
{
  Row_matrix<Short_integer> m_numerators;
  std::vector<Short_integer> m_denominators;

  explicit Integer_band(Row_matrix<Short_integer> numerators) : m_numerators(std::move(numerators)) {}

public:
  static Integer_band band(std::size_t columns, std::size_t width)
  {
    return Integer_band(Row_matrix<Short_integer>::band(columns, width));
  }

  void add_row(std::size_t first_column, const Integer_weights& row)
  {
    m_numerators.add_row(first_column, row.numerators);
    m_denominators.push_back(row.denominator);
  }

  void add_row(std::size_t first_column, const std::vector<Exact_rational>& row);

  // Every line of a tensor along one axis, transformed.
  std::vector<Exact_rational> applied_to(const std::vector<Exact_rational>& data, const Axis_view& view) const;
};

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Integer_blossom::add(const Blossom_argument<Exact_rational>& x)
{
  const auto parts = parts_of_rational(x.value);
  const Short_integer &numerator = parts.first, &denominator = parts.second;
  const bool is_direction = x.weight == 0;
  std::vector<Short_integer>& weights = m_weights.numerators;
  const std::size_t level = weights.size();
  const Short_integer value = numerator * m_span->unit, multiple = multiple_of_differences(level);
  const auto distance_from = [&](const Short_integer& knot) {
    return is_direction ? value : value - knot * denominator;
  };
  weights.emplace_back(0);
  Short_integer carried(0);
  for (std::size_t r = 0; r < level; ++r) {
    if (weights[r] == 0) {   // as many are where arguments are knots
      weights[r] = std::exchange(carried, Short_integer(0));
      continue;
    }
    const Short_integer &right = m_span->right(r), &left = m_span->left(r, level);
    const Short_integer quotient = weights[r] * (multiple / (right - left));
    weights[r] = carried - distance_from(right) * quotient;
    carried = distance_from(left) * quotient;
  }
  weights[level] = std::move(carried);
  m_weights.denominator *= multiple * denominator;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Short_integer Integer_blossom::multiple_of_differences(std::size_t level) const
{
  Short_integer result(1);
  for (std::size_t r = 0; r < level; ++r)
    if (const Short_integer difference = m_span->right(r) - m_span->left(r, level); result != difference)
      result *= difference / gcd(result, difference);
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Exact_rational>
Integer_band::applied_to(const std::vector<Exact_rational>& data, const Axis_view& view) const
{
  std::vector<Short_integer> numerators;
  const Short_integer denominator = over_common_denominator(data, numerators);
  const std::vector<Short_integer> image = transform_axis(numerators, view, m_numerators);
  std::vector<Exact_rational> result(image.size());
  for (std::size_t k = 0; k < image.size(); ++k)
    set_quotient(result[k], image[k], denominator * m_denominators[k / view.inner % m_denominators.size()]);
  return result;
}
#endif

inline std::vector<Exact_rational> transform_axis(const std::vector<Exact_rational>& data, const Axis_view& view,
                                                  const Integer_band& matrix)
{
  return matrix.applied_to(data, view);
}

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE void Integer_band::add_row(std::size_t first_column,
                                                          const std::vector<Exact_rational>& row)
{
  Integer_weights weights;
  weights.denominator = over_common_denominator(row, weights.numerators);
  add_row(first_column, weights);
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_INTEGER_BLOSSOM_H
