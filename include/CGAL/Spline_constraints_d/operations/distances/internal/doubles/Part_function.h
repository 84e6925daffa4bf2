// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PART_FUNCTION_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PART_FUNCTION_H

#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/Part_stack.h>
#include <CGAL/Spline_constraints_d/operations/distances/internal/doubles/bernstein_doubles.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Distances {

/*
The squared distance f = |c|^2 + q/w on a part, by its Bernstein coefficients; derivatives are those by the place in the
part, from 0 to 1. Rounding has to be upward.
*/
class Part_function
{
  const Bernstein_part& m_part;
  const double *m_values, *m_weights; // no weights: they are 1

public:
  Part_function(const Bernstein_part& part, const double* values, const double* weights)
    : m_part(part), m_values(values), m_weights(weights)
  {}

  // Bounds of a derivative times w, where f - |c|^2 is within bounds.
  Interval weighted_slope(int axis, const Interval& value) const
  {
    const Interval slope = ranges_of_values().first(axis);
    return is_rational() ? slope - value * ranges_of_weights().first(axis) : slope;
  }

  // The value of f - |c|^2 at a corner, which is a coefficient.
  Interval corner(int i, int j) const
  {
    const std::size_t width = static_cast<std::size_t>(m_part.degrees[1] + 1), size = size_of(m_part.degrees),
                      k = (i == 0 ? 0 : size - width) + (j == 0 ? 0 : width - 1);
    const Interval value = Interval(m_values[k]) + Interval(-m_part.errors[0], m_part.errors[0]);
    return is_rational() ? value / (Interval(m_weights[k]) + Interval(-m_part.errors[1], m_part.errors[1])) : value;
  }

  // The axis along which f is least linear, nearly.
  int most_curved_axis() const
  {
    if (m_part.sides[0] >= 0 || m_part.sides[1] >= 0)
      return m_part.sides[0] >= 0 ? 1 : 0;
    const auto magnitude = [](const Interval& x) { return (std::max)(-x.inf(), x.sup()); };
    return magnitude(ranges_of_values().second(0)) >= magnitude(ranges_of_values().second(1)) ? 0 : 1;
  }

  // Bounds of f - |c|^2.
  Interval value() const
  {
    const double *q = m_values, *w = m_weights;
    const std::size_t size = size_of(m_part.degrees);
    Double_range range{q[0], q[0]};
    if (!is_rational()) {
      for (std::size_t k = 1; k < size; ++k)
        range.add(q[k]);
      return Interval(range.lower) + Interval(-m_part.errors[0], m_part.errors[0]) +
          Interval(0, range.upper - range.lower);
    }
    double least_weight = w[0], quotient = q[0] / w[0];
    range = {quotient, quotient};
    for (std::size_t k = 1; k < size; ++k) {
      range.add(q[k] / w[k]);
      least_weight = (std::min)(least_weight, w[k]);
    }
    if (!(least_weight > 2 * m_part.errors[1]))
      return Interval(-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity());
    // With errors e and e' of q and w: |(q + e)/(w + e') - q/w| <= (|e| + |e' q/w|) / (w - |e'|).
    const double greatest = (std::max)(std::abs(range.lower), std::abs(range.upper)),
                 error = 2 * (m_part.errors[0] + m_part.errors[1] * greatest) / least_weight + 2 * unit * greatest;
    return Interval(range.lower) + Interval(-error, error) + Interval(0, range.upper - range.lower);
  }

  // A lower bound of the eigenvalues of the second derivative by the place in the part, 0 or less if it may not be
  // positive definite. With bounds of the value and the weighted slopes.
  double least_eigenvalue(const Interval& value, const std::array<Interval, 2>& weighted_slopes) const
  {
    const Slopes slopes = slopes_of(weighted_slopes);
    std::array<Interval, 2> second;
    for (const int axis : {0, 1})
      if (m_part.sides[axis] < 0 && !((second[axis] = second_derivative(axis, value, slopes)).inf() > 0))
        return 0;
    if (m_part.sides[0] >= 0 || m_part.sides[1] >= 0)
      return second[m_part.sides[0] >= 0 ? 1 : 0].inf();
    // The least eigenvalue is the determinant by the other one, which is less than the trace.
    const Interval mixed = mixed_derivative(value, slopes), a(second[0].inf()), c(second[1].inf()),
                   b((std::max)(-mixed.inf(), mixed.sup()));
    return ((a * c - CGAL::square(b)) / (a + c)).inf();
  }

  // Bounds of the second derivatives; of a parameter that is fixed, they are zero.
  Second_jet<Interval> second_derivatives(const Interval& value, const std::array<Interval, 2>& weighted_slopes) const
  {
    const Slopes slopes = slopes_of(weighted_slopes);
    const Interval zero(0);
    Second_jet<Interval> result{value, {zero, zero}, {zero, zero}, zero};
    for (const int axis : {0, 1})
      if (m_part.sides[axis] < 0)
        result.second[axis] = second_derivative(axis, value, slopes);
    if (m_part.sides[0] < 0 && m_part.sides[1] < 0)
      result.mixed = mixed_derivative(value, slopes);
    return result;
  }

  // The values of f - |c|^2 and its derivatives at a place: nearly, or in intervals.
  template <class Number>
  Second_jet<Number> jet(const std::array<Number, 2>& place) const
  {
    const double *q = m_values, *w = m_weights;
    const auto number = [](double x, double error) {
      if constexpr (std::is_same_v<Number, double>)
        return x;
      else
        return Interval(x) + Interval(-error, error);
    };
    Second_jet<Number> f = jet_at<Number>(
        m_part.degrees, [&](std::size_t k) { return number(q[k], m_part.errors[0]); }, place);
    if (!is_rational())
      return f;
    const Second_jet<Number> g = jet_at<Number>(
        m_part.degrees, [&](std::size_t k) { return number(w[k], m_part.errors[1]); }, place);
    f.value /= g.value;
    for (const int axis : {0, 1})
      f.first[axis] = (f.first[axis] - f.value * g.first[axis]) / g.value;
    for (const int axis : {0, 1})
      f.second[axis] =
          (f.second[axis] - f.value * g.second[axis] - Number(2) * f.first[axis] * g.first[axis]) / g.value;
    f.mixed = (f.mixed - f.value * g.mixed - f.first[0] * g.first[1] - f.first[1] * g.first[0]) / g.value;
    return f;
  }

private:
  // Bounds of f' and w', and of w.
  struct Slopes
  {
    std::array<Interval, 2> of_function{Interval(0), Interval(0)}, of_weight{Interval(0), Interval(0)};
    Interval weight{1};
  };

  bool is_rational() const { return m_weights != nullptr; }

  Slopes slopes_of(const std::array<Interval, 2>& weighted_slopes) const
  {
    Slopes result;
    if (!is_rational())
      return result; // they are not needed
    const auto [least, greatest] = std::minmax_element(m_weights, m_weights + size_of(m_part.degrees));
    result.weight = Interval(*least) + Interval(0, *greatest - *least) + Interval(-m_part.errors[1], m_part.errors[1]);
    for (const int axis : {0, 1})
      if (m_part.sides[axis] < 0) {
        result.of_function[axis] = weighted_slopes[axis] / result.weight;
        result.of_weight[axis] = ranges_of_weights().first(axis);
      }
    return result;
  }

  // From f = q/w: w f' = q' - f w', w f'' = q'' - f w'' - 2 f' w'.
  Interval second_derivative(int axis, const Interval& value, const Slopes& slopes) const
  {
    const Interval second = ranges_of_values().second(axis);
    return is_rational() ? (second - value * ranges_of_weights().second(axis) -
                            Interval(2) * slopes.of_function[axis] * slopes.of_weight[axis]) /
            slopes.weight
                         : second;
  }

  Interval mixed_derivative(const Interval& value, const Slopes& slopes) const
  {
    const Interval mixed = ranges_of_values().mixed();
    return is_rational() ? (mixed - value * ranges_of_weights().mixed() - slopes.of_function[0] * slopes.of_weight[1] -
                            slopes.of_function[1] * slopes.of_weight[0]) /
            slopes.weight
                         : mixed;
  }

  Coefficient_ranges ranges_of_values() const { return {m_part.degrees, m_values, m_part.errors[0]}; }
  Coefficient_ranges ranges_of_weights() const { return {m_part.degrees, m_weights, m_part.errors[1]}; }
};

} // namespace Distances
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_DISTANCES_INTERNAL_DOUBLES_PART_FUNCTION_H
