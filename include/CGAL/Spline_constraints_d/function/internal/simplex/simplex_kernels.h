// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_SIMPLEX_KERNELS_H
#define CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_SIMPLEX_KERNELS_H

#include <CGAL/Spline_constraints_d/function/bernstein_conversion.h>
#include <CGAL/Spline_constraints_d/function/bernstein_product.h>
#include <CGAL/Spline_constraints_d/function/internal/simplex/Simplex_index.h>

#include <CGAL/Fraction_traits.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// k! / (e_0! ... e_d!) for all exponents of degree k.
template <class NT, int d>
std::vector<NT> multinomials(int degree)
{
  std::vector<std::vector<NT>> rows;
  for (int n = 0; n <= degree; ++n)
    rows.push_back(binomials<NT>(n));
  std::vector<NT> result;
  result.reserve(simplex_size(degree, d));
  for (Simplex_index<d> index(degree); index.is_valid(); ++index) {
    NT& number = result.emplace_back(1);
    for (int j = 1; j <= d; ++j)
      number *= rows[index.tails()[j - 1]][index.tails()[j]];
  }
  return result;
}

// One step of de Casteljau's algorithm, in place: the polar form with this point as one more argument.
template <int d, class NT>
void contract_simplex(std::vector<NT>& coefficients, int degree, const std::array<NT, d + 1>& point)
{
  for (Simplex_index<d> index(degree - 1); index.is_valid(); ++index) {
    NT sum(0);
    const auto raised = index.raised();
    for (int i = 0; i <= d; ++i)
      if (!is_known_zero(point[i]))
        sum += NT(point[i] * coefficients[raised[i]]);
    coefficients[index.position()] = sum;
  }
  coefficients.resize(simplex_size(degree - 1, d));
}

// Coefficients in one degree more.
template <int d, class NT>
std::vector<NT> elevated_simplex(const std::vector<NT>& coefficients, int degree)
{
  std::vector<NT> sums(simplex_size(degree + 1, d), NT(0));
  for (Simplex_index<d> index(degree); index.is_valid(); ++index) {
    const auto raised = index.raised();
    for (int i = 0; i <= d; ++i)
      sums[raised[i]] += NT(NT(index.exponent(i) + 1) * coefficients[index.position()]);
  }
  for (NT& x : sums)
    x = NT(x) / NT(degree + 1);
  return sums;
}

// The product of homogeneous polynomials in barycentric coordinates, by the coefficients of powers.
template <int d, class Ring>
std::vector<Ring> product_by_powers(const std::vector<Ring>& a, int a_degree, const std::vector<Ring>& b, int b_degree)
{
  std::vector<Ring> result(simplex_size(a_degree + b_degree, d), Ring(0));
  for (Simplex_index<d> i(a_degree); i.is_valid(); ++i) {
    if (is_known_zero(a[i.position()]))
      continue;
    for (Simplex_index<d> j(b_degree); j.is_valid(); ++j) {
      std::array<int, d + 1> tails = i.tails();
      for (int l = 0; l <= d; ++l)
        tails[l] += j.tails()[l];
      result[Simplex_index<d>::position_of_tails(tails)] += Ring(a[i.position()] * b[j.position()]);
    }
  }
  return result;
}

// Through integers. False when the denominators have too little in common for that to pay.
template <int d, class NT>
bool multiply_fractions_on_simplex(const std::vector<NT>& a, int a_degree, const std::vector<NT>& b, int b_degree,
                                   std::vector<NT>& c)
{
  using Traits = CGAL::Fraction_traits<NT>;
  using Integer = typename Traits::Numerator_type;
  Integer_tensor<Integer> first, second;
  if (!clear_denominators(a, first) || !clear_denominators(b, second))
    return false;
  const std::vector<Integer> product =
      product_by_powers<d>(scaled(std::move(first.numerators), multinomials<Integer, d>(a_degree)), a_degree,
                           scaled(std::move(second.numerators), multinomials<Integer, d>(b_degree)), b_degree);
  const std::vector<Integer> weights = multinomials<Integer, d>(a_degree + b_degree);
  const Integer denominator = first.denominator * second.denominator;
  typename Traits::Compose compose;
  c.reserve(product.size());
  for (std::size_t i = 0; i < product.size(); ++i) {
    const Integer below = denominator * weights[i];
    c.push_back(compose(product[i], below));
  }
  return true;
}

template <int d, class NT>
std::vector<NT> simplex_product(const std::vector<NT>& a, int a_degree, const std::vector<NT>& b, int b_degree)
{
  if constexpr (is_fraction_v<NT>) {
    std::vector<NT> c;
    if (multiply_fractions_on_simplex<d>(a, a_degree, b, b_degree, c))
      return c;
  }
  std::vector<NT> c = product_by_powers<d>(scaled(a, multinomials<NT, d>(a_degree)), a_degree,
                                           scaled(b, multinomials<NT, d>(b_degree)), b_degree);
  const std::vector<NT> weights = multinomials<NT, d>(a_degree + b_degree);
  for (std::size_t i = 0; i < c.size(); ++i)
    c[i] /= weights[i];
  return c;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_SIMPLEX_KERNELS_H
