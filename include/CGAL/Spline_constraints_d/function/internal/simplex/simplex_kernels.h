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
#include <CGAL/Spline_constraints_d/function/internal/simplex/Simplex_index.h>

#include <array>
#include <cstddef>
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

// From Bernstein coefficients to those of the powers of barycentric coordinates.
template <int d, class NT>
std::vector<NT> scaled_simplex(const std::vector<NT>& coefficients, int degree)
{
  std::vector<NT> result = multinomials<NT, d>(degree);
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] *= coefficients[i];
  return result;
}

template <int d, class NT>
std::vector<NT> simplex_product(const std::vector<NT>& first, int first_degree, const std::vector<NT>& second,
                                int second_degree)
{
  const std::vector<NT> a = scaled_simplex<d>(first, first_degree), b = scaled_simplex<d>(second, second_degree);
  std::vector<NT> sums(simplex_size(first_degree + second_degree, d), NT(0));
  for (Simplex_index<d> i(first_degree); i.is_valid(); ++i) {
    if (is_known_zero(a[i.position()]))
      continue;
    for (Simplex_index<d> j(second_degree); j.is_valid(); ++j) {
      std::array<int, d + 1> tails = i.tails();
      for (int l = 0; l <= d; ++l)
        tails[l] += j.tails()[l];
      sums[Simplex_index<d>::position_of_tails(tails)] += NT(a[i.position()] * b[j.position()]);
    }
  }
  const std::vector<NT> numbers = multinomials<NT, d>(first_degree + second_degree);
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] = NT(sums[i]) / numbers[i];
  return sums;
}

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_FUNCTION_INTERNAL_SIMPLEX_SIMPLEX_KERNELS_H
