// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_POINT_VALUES_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_POINT_VALUES_H

#include <CGAL/Spline_constraints_d/function/Spline_function.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/solver/internal/certification/rational_coordinates.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The value of a piece of a term at a point, by Horner's scheme along the last axis that is left.
template <class NT>
NT horner(const Spline_term& term, std::vector<NT> values, const std::vector<NT>& point)
{
  for (std::size_t j = term.variables.size(); j-- > 0;) {
    const std::size_t line = static_cast<std::size_t>(term.degrees[j]) + 1, lines = values.size() / line;
    for (std::size_t i = 0; i < lines; ++i) {
      NT value = values[i * line + line - 1];
      for (std::size_t k = line - 1; k-- > 0;)
        value = value * point[term.variables[j]] + values[i * line + k];
      values[i] = value;
    }
    values.resize(lines);
  }
  return values[0];
}

// The value of a spline at any rational point, in exact arithmetic.
inline Exact_rational evaluate_exactly(const Spline_function& function, const std::vector<Exact_rational>& point)
{
  Exact_rational sum(0);
  for (const Spline_term& term : function.terms())
    sum += horner(term, piece_at(term, point), point);
  return sum;
}

// A double, and how far it may be from the number that it stands for.
struct Rounded_number
{
  double value = 0, error = 0;

  bool is_certainly_not_zero() const { return std::abs(value) > error; }
};

/*
Values and derivatives of splines at a rational point in doubles, in any rounding mode: fast, and exact enough to tell
most numbers from zero. On a break they are those of one of the pieces that meet there. The error is infinite where
numbers are too large.
*/
class Rounded_values
{
  const std::vector<Exact_rational>& m_point;
  std::vector<double> m_place, m_distance;
  bool m_is_normal = true;   // no coordinate but zero is lost in underflow

public:
  explicit Rounded_values(const std::vector<Exact_rational>& point) : m_point(point)
  {
    for (const Exact_rational& x : point) {
      m_place.push_back(CGAL::to_double(x));
      m_distance.push_back(std::abs(m_place.back()));
      m_is_normal = m_is_normal && (m_distance.back() > 0x1p-900 || CGAL::is_zero(x));
    }
  }

  Rounded_number value(const Spline_function& function) const
  {
    Sum sum;
    for (const Spline_term& term : function.terms())
      add(term, rounded_piece(term), sum);
    return sum.rounded();
  }

  // One number per unknown.
  std::vector<Rounded_number> gradient(const Spline_function& function) const
  {
    std::vector<Sum> sums(m_point.size());
    for (const Spline_term& term : function.terms()) {
      const std::vector<double> coefficients = rounded_piece(term);
      for (std::size_t j = 0; j < term.variables.size(); ++j)
        add(term, derivative(term, coefficients, j), sums[term.variables[j]]);
    }
    std::vector<Rounded_number> result;
    for (const Sum& sum : sums)
      result.push_back(sum.rounded());
    return result;
  }

private:
  // What decides the error: the sum of absolute values, a bound on what a unit is multiplied by on its way, and the
  // number of roundings.
  struct Sum
  {
    double value = 0, size = 0, reach = 0, operations = 0;

    Rounded_number rounded() const
    {
      const double error = (3 + operations) * (0x1p-51 * size + 0x1p-990 * reach);   // the second part: of underflow
      return {value, error < HUGE_VAL ? error : HUGE_VAL};
    }
  };

  std::vector<double> rounded_piece(const Spline_term& term) const
  {
    std::vector<double> result;
    for (const Exact_rational& coefficient : piece_at(term, m_point))
      result.push_back(CGAL::to_double(coefficient));
    return result;
  }

  // Along an axis: k c_k takes the place of c_(k-1).
  static std::vector<double> derivative(const Spline_term& term, const std::vector<double>& coefficients,
                                        std::size_t axis)
  {
    std::size_t inner = 1;
    for (std::size_t j = axis + 1; j < term.degrees.size(); ++j)
      inner *= static_cast<std::size_t>(term.degrees[j]) + 1;
    const std::size_t line = static_cast<std::size_t>(term.degrees[axis]) + 1;
    std::vector<double> result(coefficients.size(), 0.0);
    for (std::size_t i = inner; i < coefficients.size(); ++i)
      if (const std::size_t k = i / inner % line; k > 0)
        result[i - inner] = static_cast<double>(k) * coefficients[i];
    return result;
  }

  void add(const Spline_term& term, std::vector<double> coefficients, Sum& sum) const
  {
    sum.value += horner(term, coefficients, m_place);
    for (double& coefficient : coefficients)
      coefficient = std::abs(coefficient);
    sum.size += horner(term, std::move(coefficients), m_distance);
    double reach = m_is_normal ? 1 : HUGE_VAL;
    for (std::size_t j = 0; j < term.variables.size(); ++j) {
      reach *= std::pow((std::max)(1.0, m_distance[term.variables[j]]), term.degrees[j]);
      // on the way of a coefficient: two per step, and the coordinate is rounded as well
      sum.operations += 4.0 * (term.degrees[j] + 1);
    }
    sum.reach += reach;
    ++sum.operations;
  }
};

// Whether a spline is zero at a rational point: exact arithmetic is for what doubles do not tell from zero.
inline bool vanishes_at(const Spline_function& function, const std::vector<Exact_rational>& point)
{
  return !Rounded_values(point).value(function).is_certainly_not_zero() &&
      CGAL::is_zero(evaluate_exactly(function, point));
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_CERTIFICATION_POINT_VALUES_H
