// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_POLYNOMIAL_JETS_H
#define CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_POLYNOMIAL_JETS_H

#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Mpfr_interval.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Values and derivatives of polynomials on a box of intervals, at its precision.
class Polynomial_jets
{
  using Number = Mpfr_interval;

  std::size_t m_dimension;
  std::vector<Number> m_values, m_gradients, m_hessians;   // of one polynomial after the other

public:
  // Derivatives up to an order, 0, 1 or 2.
  Polynomial_jets(std::span<const Power_polynomial> polynomials, const std::vector<Number>& box, int order)
    : m_dimension(box.size()), m_values(polynomials.size(), Number(0)),
      m_gradients(order < 1 ? 0 : m_dimension * polynomials.size(), Number(0)),
      m_hessians(order < 2 ? 0 : m_dimension * m_gradients.size(), Number(0))
  {
    const std::vector<std::vector<Number>> powers = powers_of(box, polynomials);
    std::vector<int> exponents(m_dimension);
    // The monomial differentiated by some unknowns, times the coefficient.
    const auto derivative = [&](Number value, std::initializer_list<std::size_t> axes) {
      std::vector<int> left = exponents;
      for (std::size_t j : axes)
        value *= Number(left[j]--);
      for (std::size_t j = 0; j < m_dimension; ++j)
        if (left[j] > 0)
          value *= powers[j][left[j]];
      return value;
    };
    for (std::size_t i = 0; i < polynomials.size(); ++i)
      for (const auto& [monomial, coefficient] : polynomials[i].terms()) {
        std::fill(exponents.begin(), exponents.end(), 0);
        for (const auto& [v, e] : monomial.powers)
          exponents[v] = e;
        const Number c(coefficient);
        m_values[i] += derivative(c, {});
        for (std::size_t j = 0; j < m_dimension && order > 0; ++j)
          if (exponents[j] > 0) {
            m_gradients[i * m_dimension + j] += derivative(c, {j});
            for (std::size_t l = 0; l <= j && order > 1; ++l)
              if (exponents[l] > (l == j ? 1 : 0)) {
                const Number second = derivative(c, {j, l});
                m_hessians[(i * m_dimension + j) * m_dimension + l] += second;
                if (l != j)
                  m_hessians[(i * m_dimension + l) * m_dimension + j] += second;
              }
          }
      }
  }

  std::size_t dimension() const { return m_dimension; }
  const Number& value(std::size_t i) const { return m_values[i]; }
  const Number& gradient(std::size_t i, std::size_t j) const { return m_gradients[i * m_dimension + j]; }
  const Number& hessian(std::size_t i, std::size_t j, std::size_t l) const
  {
    return m_hessians[(i * m_dimension + j) * m_dimension + l];
  }

private:
  static std::vector<std::vector<Number>> powers_of(const std::vector<Number>& box,
                                                    std::span<const Power_polynomial> polynomials)
  {
    std::vector<std::vector<Number>> result;
    for (std::size_t j = 0; j < box.size(); ++j) {
      int degree = 0;
      for (const Power_polynomial& f : polynomials)
        degree = (std::max)(degree, f.degree(static_cast<int>(j)));
      auto& powers = result.emplace_back(1, Number(1));
      for (int e = 1; e <= degree; ++e)
        powers.push_back(powers.back() * box[j]);
    }
    return result;
  }
};

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_SOLVER_INTERNAL_EXACT_POLYNOMIAL_JETS_H
