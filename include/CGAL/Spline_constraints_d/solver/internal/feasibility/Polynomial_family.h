// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_POLYNOMIAL_FAMILY_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_POLYNOMIAL_FAMILY_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/enclosure.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Encloses while the rounding mode of the thread is upward.
using Interval = CGAL::Interval_nt<false>;

template <class NT>
NT rounded_to(const Exact_rational& x)
{
  if constexpr (std::is_same_v<NT, double>)
    return CGAL::to_double(x);
  else {
    const auto [lower, upper] = to_double_interval(x);
    return NT(lower, upper);
  }
}

/*
Polynomials over the monomials that occur in any of them: values and derivatives of the monomials are computed once for
all. Never a tensor: quadrics in twelve unknowns have 91 monomials, and 531,441 coefficients as tensors.
*/
template <class NT>
class Polynomial_family
{
  struct Factor
  {
    int unknown, exponent;
  };

  int m_dimension;
  std::vector<Factor> m_factors;               // of all monomials
  std::vector<std::size_t> m_first;            // factor of a monomial, and the end
  std::vector<std::vector<NT>> m_coefficients; // of a polynomial, per monomial
  std::vector<int> m_degrees;                  // per unknown
  std::vector<std::vector<NT>> m_powers;       // per unknown, of the point at hand
  std::vector<NT> m_values, m_derivatives;     // of monomials; of these by their factors

public:
  // `check()` may end the work by an exception.
  Polynomial_family(
      const std::vector<Power_polynomial>& polynomials, int dimension, const std::function<void()>& check = [] {})
    : m_dimension(dimension), m_degrees(dimension, 0), m_powers(dimension)
  {
    std::map<Monomial, std::size_t> index;
    for (const Power_polynomial& polynomial : polynomials) {
      check();
      for (const auto& [monomial, coefficient] : polynomial.terms())
        index.emplace(monomial, 0);
    }
    for (auto& [monomial, place] : index) {
      place = m_first.size();
      m_first.push_back(m_factors.size());
      for (const auto& [unknown, exponent] : monomial.powers) {
        m_factors.push_back({unknown, exponent});
        m_degrees[unknown] = (std::max)(m_degrees[unknown], exponent);
      }
    }
    m_first.push_back(m_factors.size());
    for (const Power_polynomial& polynomial : polynomials) {
      check();
      std::vector<NT>& row = m_coefficients.emplace_back(index.size(), NT(0));
      for (const auto& [monomial, coefficient] : polynomial.terms())
        row[index[monomial]] = rounded_to<NT>(coefficient);
    }
    m_values.resize(index.size());
    m_derivatives.resize(m_factors.size());
  }

  int dimension() const { return m_dimension; }
  std::size_t size() const { return m_coefficients.size(); }

  // Coefficients of one of the polynomials, or of a sum of multiples of them.
  const std::vector<NT>& coefficients(std::size_t polynomial) const { return m_coefficients[polynomial]; }
  std::vector<NT> combination(const std::vector<double>& multipliers) const
  {
    std::vector<NT> result(m_values.size(), NT(0));
    for (std::size_t i = 0; i < multipliers.size(); ++i)
      if (multipliers[i] != 0)
        for (std::size_t k = 0; k < result.size(); ++k)
          result[k] += NT(multipliers[i]) * m_coefficients[i][k];
    return result;
  }

  // What follows is at this point, or on this box.
  void set_point(std::span<const NT> point)
  {
    set_powers(point);
    for (std::size_t k = 0; k < m_values.size(); ++k) {
      m_values[k] = NT(1);
      for (std::size_t f = m_first[k]; f < m_first[k + 1]; ++f) {
        m_values[k] *= power(f);
        m_derivatives[f] = product_without(k, f, f) * derivative_of_power(f);
      }
    }
  }

  NT value(const std::vector<NT>& coefficients) const
  {
    NT sum(0);
    for (std::size_t k = 0; k < m_values.size(); ++k)
      sum += coefficients[k] * m_values[k];
    return sum;
  }

  std::vector<NT> gradient(const std::vector<NT>& coefficients) const
  {
    std::vector<NT> sum(m_dimension, NT(0));
    for (std::size_t k = 0; k < m_values.size(); ++k)
      for (std::size_t f = m_first[k]; f < m_first[k + 1]; ++f)
        sum[m_factors[f].unknown] += coefficients[k] * m_derivatives[f];
    return sum;
  }

  // Row by row.
  std::vector<NT> hessian(const std::vector<NT>& coefficients) const
  {
    std::vector<NT> sum(static_cast<std::size_t>(m_dimension) * m_dimension, NT(0));
    for (std::size_t k = 0; k < m_values.size(); ++k)
      for (std::size_t f = m_first[k]; f < m_first[k + 1]; ++f) {
        const int i = m_factors[f].unknown;
        if (m_factors[f].exponent > 1)
          sum[i * m_dimension + i] += coefficients[k] * product_without(k, f, f) * second_derivative_of_power(f);
        for (std::size_t g = f + 1; g < m_first[k + 1]; ++g) {
          const NT mixed = coefficients[k] * product_without(k, f, g) * derivative_of_power(f) * derivative_of_power(g);
          const int j = m_factors[g].unknown;
          sum[i * m_dimension + j] += mixed;
          sum[j * m_dimension + i] += mixed;
        }
      }
    return sum;
  }

private:
  // Even powers as squares: those of an interval around zero are not negative.
  void set_powers(std::span<const NT> point)
  {
    for (int j = 0; j < m_dimension; ++j) {
      std::vector<NT>& powers = m_powers[j];
      powers.assign(1, NT(1));
      for (int e = 1; e <= m_degrees[j]; ++e)
        powers.push_back(e % 2 == 0 ? CGAL::square(powers[e / 2]) : powers[e - 1] * point[j]);
    }
  }

  const NT& power(std::size_t f) const { return m_powers[m_factors[f].unknown][m_factors[f].exponent]; }
  NT derivative_of_power(std::size_t f) const
  {
    const auto [unknown, exponent] = m_factors[f];
    return NT(exponent) * m_powers[unknown][exponent - 1];
  }
  NT second_derivative_of_power(std::size_t f) const
  {
    const auto [unknown, exponent] = m_factors[f];
    return NT(exponent * (exponent - 1)) * m_powers[unknown][exponent - 2];
  }
  NT product_without(std::size_t monomial, std::size_t f, std::size_t g) const
  {
    NT product(1);
    for (std::size_t h = m_first[monomial]; h < m_first[monomial + 1]; ++h)
      if (h != f && h != g)
        product *= power(h);
    return product;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_FEASIBILITY_POLYNOMIAL_FAMILY_H
