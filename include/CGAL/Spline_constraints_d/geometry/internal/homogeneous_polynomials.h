// Copyright (c) 2026 The Spline_constraints_d authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Spline_constraints_d authors

#ifndef CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_HOMOGENEOUS_POLYNOMIALS_H
#define CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_HOMOGENEOUS_POLYNOMIALS_H

#include <CGAL/Spline_constraints_d/function/Bernstein_tensor.h>
#include <CGAL/Spline_constraints_d/function/Power_polynomial.h>
#include <CGAL/Spline_constraints_d/function/common_factor.h>
#include <CGAL/Spline_constraints_d/function/internal/polynomial_of_powers.h>
#include <CGAL/Spline_constraints_d/internal/compatibility.h>
#include <CGAL/Spline_constraints_d/number/Exact_rational.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spline_constraints {
namespace internal {

// The numerators and the weight of a piece of a surface, in two parameters that run from 0 to 1.
using Homogeneous_polynomials = std::vector<Power_polynomial>;

// In parameters that are numbered from `first` on.
Power_polynomial polynomial_of(const Bernstein_tensor<Exact_rational>& piece, int first = 0);

Bernstein_tensor<Exact_rational> tensor_of(const Power_polynomial& f, const std::vector<int>& degrees);

inline Exact_rational value_at(const Power_polynomial& f, const Exact_rational& u, const Exact_rational& v)
{
  return f(std::array<Exact_rational, 2>{u, v});
}

std::vector<Power_polynomial> without_common_factors(std::vector<Power_polynomial> polynomials);

// The cross product of the derivatives of P / w, times w^3.
std::vector<Power_polynomial> normal_of(const Homogeneous_polynomials& p);

#ifndef CGAL_SPLINE_CONSTRAINTS_COMPILED
CGAL_SPLINE_CONSTRAINTS_INLINE Power_polynomial polynomial_of(const Bernstein_tensor<Exact_rational>& piece, int first)
{
  return polynomial_of_powers(piece.degrees(), piece.power_coefficients(), [&](std::size_t axis) {
    return Power_polynomial::variable(first + static_cast<int>(axis));
  });
}

CGAL_SPLINE_CONSTRAINTS_INLINE Bernstein_tensor<Exact_rational> tensor_of(const Power_polynomial& f,
                                                                          const std::vector<int>& degrees)
{
  const std::size_t columns = static_cast<std::size_t>(degrees[1]) + 1;
  std::vector<Exact_rational> coefficients((static_cast<std::size_t>(degrees[0]) + 1) * columns, Exact_rational(0));
  for (const auto& [monomial, coefficient] : f.terms())
    coefficients[static_cast<std::size_t>(monomial.exponent(0)) * columns +
                 static_cast<std::size_t>(monomial.exponent(1))] = coefficient;
  return Bernstein_tensor<Exact_rational>::from_power(degrees, std::move(coefficients));
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Power_polynomial>
without_common_factors(std::vector<Power_polynomial> polynomials)
{
  while (auto common = common_factor(polynomials))
    polynomials = std::move(common->cofactors);
  return polynomials;
}

CGAL_SPLINE_CONSTRAINTS_INLINE std::vector<Power_polynomial> normal_of(const Homogeneous_polynomials& p)
{
  const auto derivative = [&](int axis) {
    Homogeneous_polynomials result;
    for (const Power_polynomial& f : p)
      result.push_back(f.derivative(axis));
    return result;
  };
  const Homogeneous_polynomials pu = derivative(0), pv = derivative(1);
  std::vector<Power_polynomial> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const auto minor = [&](const auto& a, const auto& b) { return a[j] * b[k] - a[k] * b[j]; };
    result.push_back(p[3] * minor(pu, pv) - pu[3] * minor(p, pv) - pv[3] * minor(pu, p));
  }
  return result;
}
#endif

} // namespace internal
} // namespace Spline_constraints
} // namespace CGAL

#endif // CGAL_SPLINE_CONSTRAINTS_D_GEOMETRY_INTERNAL_HOMOGENEOUS_POLYNOMIALS_H
