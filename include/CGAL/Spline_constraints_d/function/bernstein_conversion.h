// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_CONVERSION_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_CONVERSION_H

#include <CGAL/Spline_constraints_d/function/tensor_axes.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// Row n of Pascal's triangle, by additions alone: exact where NT is exact, and in double as long as the numbers are
// below 2^53.
template <class NT>
std::vector<NT> binomials(int n)
{
  std::vector<NT> row(static_cast<std::size_t>(n) + 1, NT(0));
  row[0] = NT(1);
  for (int m = 1; m <= n; ++m)
    for (int k = m; k >= 1; --k)
      row[k] += row[k - 1];
  if (!is_finite_number(row[n / 2]))
    throw Invalid_input("binomial coefficients of degree " + std::to_string(n) + " overflow the number type");
  return row;
}

// Multiplies a polynomial by (constant + slope x), in place; its leading coefficient must have room.
template <class NT>
void multiply_by_linear(NT* polynomial, std::size_t degree, const NT& constant, const NT& slope)
{
  polynomial[degree + 1] = slope * polynomial[degree];
  for (std::size_t i = degree; i >= 1; --i)
    polynomial[i] = NT(constant * polynomial[i]) + NT(slope * polynomial[i - 1]);
  polynomial[0] = constant * polynomial[0];
}

/*
Row k holds the coefficients of (a + b x)^(d-k) (p + q x)^k. This is the polar form: with (1-s, s) and (1-t, t) row k
gives the weights of the Bernstein coefficients in the blossom at (s,...,s,t,...,t), which is coefficient k on the
interval [s,t]; with (1,s) and (1,t) it holds the elementary symmetric functions of the same arguments, the blossoms of
the monomials up to a binomial (Ramshaw, Blossoming, 1987).
*/
template <class NT>
Row_matrix<NT> linear_powers(int degree, const NT& a, const NT& b, const NT& p, const NT& q)
{
  Row_matrix<NT> result(static_cast<std::size_t>(degree) + 1, static_cast<std::size_t>(degree) + 1);
  for (int k = 0; k <= degree; ++k) {
    NT* row = &result(k, 0);
    row[0] = NT(1);
    for (int m = 0; m < degree; ++m) {
      if (m < degree - k)
        multiply_by_linear(row, m, a, b);
      else
        multiply_by_linear(row, m, p, q);
    }
  }
  return result;
}

// Coefficients on [0,1] to coefficients on [begin,end].
template <class NT>
Row_matrix<NT> restriction_matrix(int degree, const NT& begin, const NT& end)
{
  return linear_powers<NT>(degree, NT(1) - begin, begin, NT(1) - end, end);
}

// Coefficients of degree `from` to those of degree `to`.
template <class NT>
Row_matrix<NT> elevation_matrix(int from, int to)
{
  Row_matrix<NT> result(static_cast<std::size_t>(to) + 1, static_cast<std::size_t>(from) + 1);
  const std::vector<NT> old_binomials = binomials<NT>(from), added = binomials<NT>(to - from),
                        new_binomials = binomials<NT>(to);
  for (int k = 0; k <= to; ++k)
    for (int i = (std::max)(0, k - (to - from)); i <= (std::min)(k, from); ++i)
      result(k, i) = NT(old_binomials[i] * added[k - i]) / new_binomials[k];
  return result;
}

// Coefficients of the powers of x to Bernstein coefficients on [begin,end].
template <class NT>
Row_matrix<NT> from_power_matrix(int degree, const NT& begin, const NT& end)
{
  Row_matrix<NT> result = linear_powers<NT>(degree, NT(1), begin, NT(1), end);
  const std::vector<NT> binomial = binomials<NT>(degree);
  for (int k = 0; k <= degree; ++k)
    for (int i = 1; i < degree; ++i)
      result(k, i) = NT(result(k, i)) / binomial[i];
  return result;
}

// Bernstein coefficients on [0,1] to coefficients of powers: C(d,i) times the i-th forward difference.
template <class NT>
Row_matrix<NT> to_power_matrix(int degree)
{
  Row_matrix<NT> result(static_cast<std::size_t>(degree) + 1, static_cast<std::size_t>(degree) + 1);
  const std::vector<NT> binomial = binomials<NT>(degree);
  for (int i = 0; i <= degree; ++i) {
    const std::vector<NT> row = binomials<NT>(i);
    for (int k = 0; k <= i; ++k) {
      const NT entry = binomial[i] * row[k];
      result(i, k) = (i - k) % 2 == 0 ? entry : NT(-entry);
    }
  }
  return result;
}

// The d + 1 Bernstein polynomials at a parameter.
template <class NT>
std::vector<NT> bernstein_values(int degree, const NT& u)
{
  std::vector<NT> values(static_cast<std::size_t>(degree) + 1, NT(0));
  values[0] = NT(1);
  const NT v = NT(1) - u;
  for (int d = 0; d < degree; ++d)
    multiply_by_linear(values.data(), d, v, u);
  return values;
}

// Values and derivatives up to an order of the Bernstein polynomials: result[r][k].
template <class NT>
std::vector<std::vector<NT>> bernstein_derivatives(int degree, const NT& u, int order)
{
  std::vector<std::vector<NT>> result;
  for (int r = 0; r <= order; ++r) {
    if (r > degree) {
      result.emplace_back(static_cast<std::size_t>(degree) + 1, NT(0));
      continue;
    }
    // Differentiating raises the degree by one and turns values into differences, r times.
    std::vector<NT> values = bernstein_values(degree - r, u);
    for (int d = degree - r + 1; d <= degree; ++d) {
      values.push_back(values.back());
      for (std::size_t k = values.size() - 2; k >= 1; --k)
        values[k] = NT(d) * NT(values[k - 1] - values[k]);
      values[0] = NT(-d) * values[0];
      values.back() = NT(d) * values.back();
    }
    result.push_back(std::move(values));
  }
  return result;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_BERNSTEIN_CONVERSION_H
