// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CRITICAL_VALUES_H
#define CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CRITICAL_VALUES_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>
#include <CGAL/Spline_constraints_d/operations/subjects.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {
namespace Common {

// Coefficients of powers, without zeros at the end; empty: zero.
using Coefficients = std::vector<Exact_rational>;

Coefficients power_coefficients(const Bernstein_tensor<Exact_rational>& tensor);

// b is not zero.
Coefficients remainder(Coefficients a, const Coefficients& b);

// The product of g over all complex zeros of f, with multiplicity, by Euclid's algorithm: product of g over f is that
// of f over g but for leading coefficients. f is not zero.
Exact_rational product_over_zeros(Coefficients f, Coefficients g);

/*
A polynomial in `x` that vanishes at all values that n/w has where its derivative is zero: the product of n - x w over
the zeros of n'w - nw', which are as many as its degree, interpolated at 0, 1, ... It is zero where n and w have a
common zero.
*/
Power_polynomial critical_value_polynomial(const Bernstein_tensor<Exact_rational>& n,
                                           const Bernstein_tensor<Exact_rational>& w, const Power_polynomial& x);

#ifdef CGAL_SPLINE_CONSTRAINTS_DEFINES_OPERATIONS
CGAL_SPLINE_CONSTRAINTS_INLINE Coefficients power_coefficients(const Bernstein_tensor<Exact_rational>& tensor)
{
  Coefficients result = tensor.power_coefficients();
  while (!result.empty() && result.back() == 0)
    result.pop_back();
  return result;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Coefficients remainder(Coefficients a, const Coefficients& b)
{
  while (a.size() >= b.size()) {
    const Exact_rational factor(a.back() / b.back());
    for (std::size_t i = 0; i < b.size(); ++i)
      a[a.size() - b.size() + i] -= Exact_rational(factor * b[i]);
    while (!a.empty() && a.back() == 0)
      a.pop_back();
  }
  return a;
}

CGAL_SPLINE_CONSTRAINTS_INLINE Exact_rational product_over_zeros(Coefficients f, Coefficients g)
{
  Exact_rational result(1);
  for (;;) {
    g = remainder(std::move(g), f);
    if (f.size() == 1)
      return result;
    if (g.empty())
      return Exact_rational(0);
    // prod_{f=0} g = (-1)^(deg f deg g) lc(g)^(deg f) / lc(f)^(deg g) prod_{g=0} f
    const std::size_t f_degree = f.size() - 1, g_degree = g.size() - 1;
    if (f_degree * g_degree % 2 != 0)
      result = -result;
    for (std::size_t i = 0; i < f_degree; ++i)
      result *= g.back();
    for (std::size_t i = 0; i < g_degree; ++i)
      result /= f.back();
    std::swap(f, g);
  }
}

CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial critical_value_polynomial(const Bernstein_tensor<Exact_rational>& n,
                                                                          const Bernstein_tensor<Exact_rational>& w,
                                                                          const Power_polynomial& x)
{
  const Coefficients slope = power_coefficients(n.derivative(0) * w - n * w.derivative(0));
  if (slope.empty())
    return Power_polynomial();
  const int degree = static_cast<int>(slope.size()) - 1;
  Power_polynomial result;
  for (int i = 0; i <= degree; ++i) {
    Power_polynomial summand(product_over_zeros(slope, power_coefficients(n - w * Exact_rational(i))));
    for (int j = 0; j <= degree; ++j)
      if (j != i)
        summand *= (x - Power_polynomial(j)) / Power_polynomial(i - j);
    result += summand;
  }
  return result;
}
#endif

} // namespace Common
} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_OPERATIONS_COMMON_INTERNAL_CRITICAL_VALUES_H
